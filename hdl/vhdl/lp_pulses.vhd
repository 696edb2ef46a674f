-- A pulse in the scan of every tenth of a second, and of every second, counted in ticks from reset.
library ieee;
use ieee.std_logic_1164.all;

entity lp_pulses is
  generic (
    TICKS_PER_TENTH  : natural := 100;  -- 0: a tick does not divide it, there are no pulses
    TICKS_PER_SECOND : natural := 1000
  );
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    start_scan : in  std_logic;
    tick       : in  std_logic;         -- this scan has the tick; read with start_scan
    tenth      : out std_logic;         -- for the whole scan
    second     : out std_logic
  );
end entity;

architecture rtl of lp_pulses is
begin
  tenths : entity work.lp_divider
    generic map (TICKS => TICKS_PER_TENTH)
    port map (clk => clk, rst => rst, start_scan => start_scan, tick => tick, pulse => tenth);

  seconds : entity work.lp_divider
    generic map (TICKS => TICKS_PER_SECOND)
    port map (clk => clk, rst => rst, start_scan => start_scan, tick => tick, pulse => second);
end architecture;
