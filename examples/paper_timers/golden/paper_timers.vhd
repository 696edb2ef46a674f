-- Made by hotrail 0.1.0 from paper_timers.ladder. Do not edit: change the ladder and build again.

-- DIVIDER: divider of the tick, N = 10 ticks
-- Example, with N = 3:
-- tick ####_#__##
-- IN   ##########
-- Q    __#_____#_
-- CV   1201122201
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_timers_DIVIDER_N10 is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity paper_timers_DIVIDER_N10;

architecture rtl of paper_timers_DIVIDER_N10 is
  signal CV : unsigned(3 downto 0) := (others => '0');
  signal equal : std_logic;
  signal Q_value : std_logic;
  signal sum : unsigned(3 downto 0);
  signal CV_next : unsigned(3 downto 0);
begin
  equal <= '1' when CV = 9 else '0';
  Q_value <= tick and equal;
  sum <= CV + (to_unsigned(0, 3) & tick);
  CV_next <= to_unsigned(0, 4) when Q_value = '1' else sum;

  Q <= Q_value;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
      else
        CV <= CV_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- DIVIDER: divider of the tick, N = 1 tick
-- Example, with N = 3:
-- tick ####_#__##
-- IN   ##########
-- Q    __#_____#_
-- CV   1201122201
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_timers_DIVIDER_N1 is
  port (
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity paper_timers_DIVIDER_N1;

architecture rtl of paper_timers_DIVIDER_N1 is
begin

  Q <= tick;
end architecture rtl;

-- TS: timer of seconds in three modes, MODE = OFF
-- Fitted to PV = 3.
-- Example, with PV = 3:
-- IN  _##_____#__#_____
-- Q   _#####__#######__
-- QN  #_____##_______##
-- ACC 00001233001001233
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_timers_TS_OFF_PV3 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    EN    : in  std_logic;
    unit  : in  std_logic;
    Q     : out std_logic
  );
end entity paper_timers_TS_OFF_PV3;

architecture rtl of paper_timers_TS_OFF_PV3 is
  signal ACC : unsigned(1 downto 0) := (others => '0');
  signal run : std_logic := '0';
  signal was : std_logic := '0';
  signal equal : std_logic;
  signal sum : unsigned(1 downto 0);
  signal condition : std_logic;
  signal equal_2 : std_logic;
  signal condition_2 : std_logic;
  signal choice : unsigned(1 downto 0);
  signal ACC_next : unsigned(1 downto 0);
  signal run_next : std_logic;
begin
  equal <= '1' when ACC = 3 else '0';
  sum <= ACC + (to_unsigned(0, 1) & (run and unit and not equal));
  condition <= run and was;
  equal_2 <= '1' when ACC = 2 else '0';
  condition_2 <=
      power
      or (run and not (not power and not condition and ((run and unit and equal_2) or equal)));
  choice <= to_unsigned(0, 2) when condition = '1' else sum;
  ACC_next <= to_unsigned(0, 2) when power = '1' else choice;
  run_next <= EN and condition_2;

  Q <= EN and condition_2;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        run <= '0';
        was <= '0';
      else
        ACC <= ACC_next;
        run <= run_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TT: timer of tenths of a second in three modes
-- Fitted to PV = 5.
-- Example, with PV = 3:
-- IN  _#######__##__
-- EN  ###########_##
-- Q   ____#######___
-- QN  ####_______###
-- ACC 00123333333000
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_timers_TT_PV5 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    EN    : in  std_logic;
    unit  : in  std_logic;
    Q     : out std_logic
  );
end entity paper_timers_TT_PV5;

architecture rtl of paper_timers_TT_PV5 is
  signal ACC : unsigned(2 downto 0) := (others => '0');
  signal ran : std_logic := '0';
  signal ran_next : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(2 downto 0);
  signal ACC_next : unsigned(2 downto 0);
  signal equal_2 : std_logic;
begin
  ran_next <= power and EN;
  equal <= '1' when ACC = 5 else '0';
  sum <= ACC + (to_unsigned(0, 2) & (ran_next and ran and unit and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 3);
  equal_2 <= '1' when ACC = 4 else '0';

  Q <= EN and ((ran_next and ran and unit and equal_2) or equal);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        ran <= '0';
      else
        ACC <= ACC_next;
        ran <= ran_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TT: timer of tenths of a second in three modes, MODE = INTERVAL
-- Fitted to PV = 4.
-- Example, with PV = 3:
-- IN  _#####_#_#__
-- Q   _###___###__
-- QN  #___###___##
-- ACC 001233001200
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_timers_TT_INTERVAL_PV4 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    EN    : in  std_logic;
    unit  : in  std_logic;
    Q     : out std_logic
  );
end entity paper_timers_TT_INTERVAL_PV4;

architecture rtl of paper_timers_TT_INTERVAL_PV4 is
  signal ACC : unsigned(2 downto 0) := (others => '0');
  signal run : std_logic := '0';
  signal was : std_logic := '0';
  signal sum : unsigned(2 downto 0);
  signal equal : std_logic;
  signal choice : std_logic;
  signal ACC_next : unsigned(2 downto 0);
  signal run_next : std_logic;
begin
  sum <= ACC + (to_unsigned(0, 2) & unit);
  equal <= '1' when ACC = 3 else '0';
  choice <= not (unit and equal) when run = '1' else power and not was;
  ACC_next <= sum when run = '1' else to_unsigned(0, 3);
  run_next <= EN and choice;

  Q <= EN and choice;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        run <= '0';
        was <= '0';
      else
        ACC <= ACC_next;
        run <= run_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_timers is
  port (
    clk                 : in  std_logic;
    rst                 : in  std_logic;
    tick                : in  std_logic;
    c1                  : in  std_logic;
    c2                  : in  std_logic;
    c3                  : in  std_logic;
    c4                  : in  std_logic;
    c5                  : in  std_logic;
    c6                  : in  std_logic;
    c7                  : in  std_logic;
    c8                  : in  std_logic;
    c9                  : in  std_logic;
    enable_ckt          : in  std_logic;
    timer_off_coil      : out std_logic;
    timer_on_coil       : out std_logic;
    timer_interval_coil : out std_logic
  );
end entity paper_timers;

architecture rtl of paper_timers is
  signal timer_off_coil_reg : std_logic := '0';
  signal timer_on_coil_reg : std_logic := '0';
  signal timer_interval_coil_reg : std_logic := '0';
  signal every_1s_Q : std_logic;
  signal every_100ms_Q : std_logic;
  signal rung1_power : std_logic;
  signal timing_ckt : std_logic;
  signal actual_ts_Q : std_logic;
  signal timer_off_coil_next : std_logic;
  signal actual_tt_Q : std_logic;
  signal timer_on_coil_next : std_logic;
  signal interval_tt_Q : std_logic;
  signal timer_interval_coil_next : std_logic;
begin

  -- units of time, each a pulse that all blocks share
  every_1s: entity work.paper_timers_DIVIDER_N10
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      Q => every_1s_Q
    );
  every_100ms: entity work.paper_timers_DIVIDER_N1
    port map (
      tick => tick,
      Q => every_100ms_Q
    );

  -- rung 1 "the paper's Figure 14", paper_timers.ladder:11
  rung1_power <= c9 or (c2 and c3 and c4);
  timing_ckt <=
      (rung1_power and c1) or ((c5 or (rung1_power and c6)) and ((c7 and c8) or (c6 and c1)));

  -- rung 2 "timer_type 00: off-delay, 3 s", paper_timers.ladder:20
  actual_ts: entity work.paper_timers_TS_OFF_PV3
    port map (
      clk => clk,
      rst => rst,
      power => timing_ckt,
      EN => enable_ckt,
      unit => every_1s_Q,
      Q => actual_ts_Q
    );
  timer_off_coil_next <= actual_ts_Q;

  -- rung 3 "timer_type 01: on-delay, 5 tenths", paper_timers.ladder:23
  actual_tt: entity work.paper_timers_TT_PV5
    port map (
      clk => clk,
      rst => rst,
      power => timing_ckt,
      EN => enable_ckt,
      unit => every_100ms_Q,
      Q => actual_tt_Q
    );
  timer_on_coil_next <= actual_tt_Q;

  -- rung 4 "timer_type 1x: interval-delay, 4 tenths", paper_timers.ladder:26
  interval_tt: entity work.paper_timers_TT_INTERVAL_PV4
    port map (
      clk => clk,
      rst => rst,
      power => timing_ckt,
      EN => enable_ckt,
      unit => every_100ms_Q,
      Q => interval_tt_Q
    );
  timer_interval_coil_next <= interval_tt_Q;

  timer_off_coil <= timer_off_coil_reg;
  timer_on_coil <= timer_on_coil_reg;
  timer_interval_coil <= timer_interval_coil_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        timer_off_coil_reg <= '0';
        timer_on_coil_reg <= '0';
        timer_interval_coil_reg <= '0';
      else
        timer_off_coil_reg <= timer_off_coil_next;
        timer_on_coil_reg <= timer_on_coil_next;
        timer_interval_coil_reg <= timer_interval_coil_next;
      end if;
    end if;
  end process;
end architecture rtl;
