-- What a timer does: TS and TT, in three types. Combinational: with the old count compared it says
-- what becomes of the count, with the new one compared what becomes of the rest.
library ieee;
use ieee.std_logic_1164.all;
use work.lp.all;

entity lp_timer is
  port (
    timer_type  : in  std_logic_vector(1 downto 0);   -- 00 off-delay, 01 on-delay, 1x interval
    enable      : in  std_logic;
    power       : in  std_logic;
    pulse       : in  std_logic;        -- one unit of time has gone by
    was         : in  std_logic;        -- the power at the call before
    was_enabled : in  std_logic;        -- power and enable at the call before
    runs        : in  std_logic;        -- a delay or an interval runs
    reached     : in  std_logic;        -- the count is the preset or more
    -- Of the old count.
    clears      : out std_logic;        -- it goes back to 0
    counts      : out std_logic;        -- else it grows by one
    -- Of the new count.
    coil        : out std_logic;
    runs_on     : out std_logic;
    ends        : out std_logic         -- the count goes back to 0 after all
  );
end entity;

architecture rtl of lp_timer is
  signal on_delay, off_delay, interval, starts, timing, goes_on : std_logic;
begin
  on_delay  <= bit_of(timer_type = "01");
  off_delay <= bit_of(timer_type = "00");
  interval  <= timer_type(1);
  starts    <= interval and not runs and power and not was;

  clears <= not enable or starts or (off_delay and (power or (runs and was)));
  timing <= (power and was_enabled) when on_delay = '1' else runs;
  counts <= pulse and not reached and timing;

  goes_on <= enable and not on_delay
             and ((off_delay and power) or ((runs or starts) and not reached));
  runs_on <= goes_on;
  coil    <= reached when on_delay = '1' else goes_on;
  ends    <= interval and not goes_on and not power;
end architecture;
