-- Made by hotrail 0.1.0 from step_sequence.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects step_sequence to the pins of a board.
entity step_sequence_top is
  port (
    clk       : in  std_logic;
    rst       : in  std_logic;
    start     : in  std_logic;
    clamped   : in  std_logic;
    deep      : in  std_logic;
    free      : in  std_logic;
    emergency : in  std_logic;
    clamp     : out std_logic;
    drill     : out std_logic;
    lift      : out std_logic;
    busy      : out std_logic
  );
end entity step_sequence_top;

architecture rtl of step_sequence_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal start_meta : std_logic := '0';
  signal start_sync : std_logic := '0';
  attribute async_reg of start_meta : signal is "TRUE";
  attribute async_reg of start_sync : signal is "TRUE";
  signal clamped_meta : std_logic := '0';
  signal clamped_sync : std_logic := '0';
  attribute async_reg of clamped_meta : signal is "TRUE";
  attribute async_reg of clamped_sync : signal is "TRUE";
  signal deep_meta : std_logic := '0';
  signal deep_sync : std_logic := '0';
  attribute async_reg of deep_meta : signal is "TRUE";
  attribute async_reg of deep_sync : signal is "TRUE";
  signal free_meta : std_logic := '0';
  signal free_sync : std_logic := '0';
  attribute async_reg of free_meta : signal is "TRUE";
  attribute async_reg of free_sync : signal is "TRUE";
  signal emergency_meta : std_logic := '0';
  signal emergency_sync : std_logic := '0';
  attribute async_reg of emergency_meta : signal is "TRUE";
  attribute async_reg of emergency_sync : signal is "TRUE";
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
      start_meta <= start;
      start_sync <= start_meta;
      clamped_meta <= clamped;
      clamped_sync <= clamped_meta;
      deep_meta <= deep;
      deep_sync <= deep_meta;
      free_meta <= free;
      free_sync <= free_meta;
      emergency_meta <= emergency;
      emergency_sync <= emergency_meta;
    end if;
  end process;

  core: entity work.step_sequence
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      start => start_sync,
      clamped => clamped_sync,
      deep => deep_sync,
      free => free_sync,
      emergency => emergency_sync,
      clamp => clamp,
      drill => drill,
      lift => lift,
      busy => busy
    );
end architecture rtl;
