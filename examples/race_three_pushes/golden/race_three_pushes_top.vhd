-- Made by hotrail 0.1.0 from race_three_pushes.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects race_three_pushes to the pins of a board.
entity race_three_pushes_top is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    button : in  std_logic;
    clear  : in  std_logic;
    won    : out std_logic
  );
end entity race_three_pushes_top;

architecture rtl of race_three_pushes_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(20 downto 0) := (others => '0');
  signal tick : std_logic;
  signal button_meta : std_logic := '0';
  signal button_sync : std_logic := '0';
  attribute async_reg of button_meta : signal is "TRUE";
  attribute async_reg of button_sync : signal is "TRUE";
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

  -- Tick: every 1200000 clocks of 12 MHz, wanted every 100 ms, error 0 ppm.
  tick <= '1' when prescaler = 1199999 else '0';
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
      button_meta <= button;
      button_sync <= button_meta;
      clear_meta <= clear;
      clear_sync <= clear_meta;
    end if;
  end process;

  core: entity work.race_three_pushes
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      button => button_sync,
      clear => clear_sync,
      won => won
    );
end architecture rtl;
