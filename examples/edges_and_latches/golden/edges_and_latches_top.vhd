-- Made by hotrail 0.1.0 from edges_and_latches.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects edges_and_latches to the pins of a board.
entity edges_and_latches_top is
  port (
    clk       : in  std_logic;
    rst       : in  std_logic;
    a         : in  std_logic;
    b         : in  std_logic;
    clear     : in  std_logic;
    on_rise   : out std_logic;
    on_fall   : out std_logic;
    shot_up   : out std_logic;
    shot_down : out std_logic;
    coil_up   : out std_logic;
    coil_down : out std_logic;
    latched   : out std_logic;
    inverted  : out std_logic;
    started   : out std_logic
  );
end entity edges_and_latches_top;

architecture rtl of edges_and_latches_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal a_meta : std_logic := '0';
  signal a_sync : std_logic := '0';
  attribute async_reg of a_meta : signal is "TRUE";
  attribute async_reg of a_sync : signal is "TRUE";
  signal b_meta : std_logic := '0';
  signal b_sync : std_logic := '0';
  attribute async_reg of b_meta : signal is "TRUE";
  attribute async_reg of b_sync : signal is "TRUE";
  signal clear_meta : std_logic := '0';
  signal clear_sync : std_logic := '0';
  attribute async_reg of clear_meta : signal is "TRUE";
  attribute async_reg of clear_sync : signal is "TRUE";
begin

  -- Reset: comes at once, goes in step with the clock.
  process (clk, rst)
  begin
    if rst = '1' then
      reset_pipe <= "11";
    elsif rising_edge(clk) then
      reset_pipe <= reset_pipe(0) & '0';
    end if;
  end process;
  core_rst <= reset_pipe(1);

  -- Tick: every 12000 clocks of 12 MHz, wanted every 1 ms, error 0 ppm.
  tick <= '1' when prescaler = 11999 else '0';
  process (clk)
  begin
    if rising_edge(clk) then
      if tick = '1' then
        prescaler <= (others => '0');
      else
        prescaler <= prescaler + 1;
      end if;
      if core_rst = '1' then
        prescaler <= (others => '0');
      end if;
    end if;
  end process;

  -- Inputs: two flip-flops for each bit.
  process (clk)
  begin
    if rising_edge(clk) then
      a_meta <= a;
      a_sync <= a_meta;
      b_meta <= b;
      b_sync <= b_meta;
      clear_meta <= clear;
      clear_sync <= clear_meta;
    end if;
  end process;

  core: entity work.edges_and_latches
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      a => a_sync,
      b => b_sync,
      clear => clear_sync,
      on_rise => on_rise,
      on_fall => on_fall,
      shot_up => shot_up,
      shot_down => shot_down,
      coil_up => coil_up,
      coil_down => coil_down,
      latched => latched,
      inverted => inverted,
      started => started
    );
end architecture rtl;
