-- Made by hotrail 0.1.0 from modicon_timer.ladder. Do not edit: change the ladder and build again.

-- DIVIDER: divider of the tick, N = 100 ticks
-- Example, with N = 3:
-- tick ####_#__##
-- IN   ##########
-- Q    __#_____#_
-- CV   1201122201
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity modicon_timer_DIVIDER_N100 is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity modicon_timer_DIVIDER_N100;

architecture rtl of modicon_timer_DIVIDER_N100 is
  signal CV : unsigned(6 downto 0) := (others => '0');
  signal equal : std_logic;
  signal Q_value : std_logic;
  signal sum : unsigned(6 downto 0);
  signal CV_next : unsigned(6 downto 0);
begin
  equal <= '1' when CV = 99 else '0';
  Q_value <= tick and equal;
  sum <= CV + (to_unsigned(0, 6) & tick);
  CV_next <= to_unsigned(0, 7) when Q_value = '1' else sum;

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

-- DIVIDER: divider of the tick, N = 10 ticks
-- Example, with N = 3:
-- tick ####_#__##
-- IN   ##########
-- Q    __#_____#_
-- CV   1201122201
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity modicon_timer_DIVIDER_N10 is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity modicon_timer_DIVIDER_N10;

architecture rtl of modicon_timer_DIVIDER_N10 is
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

-- T1_0: timer of seconds
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

entity modicon_timer_T1_0_PV5 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    EN    : in  std_logic;
    unit  : in  std_logic;
    Q     : out std_logic;
    QN    : out std_logic
  );
end entity modicon_timer_T1_0_PV5;

architecture rtl of modicon_timer_T1_0_PV5 is
  signal ACC : unsigned(2 downto 0) := (others => '0');
  signal ran : std_logic := '0';
  signal ran_next : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(2 downto 0);
  signal ACC_next : unsigned(2 downto 0);
  signal equal_2 : std_logic;
  signal Q_value : std_logic;
begin
  ran_next <= power and EN;
  equal <= '1' when ACC = 5 else '0';
  sum <= ACC + (to_unsigned(0, 2) & (ran_next and ran and unit and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 3);
  equal_2 <= '1' when ACC = 4 else '0';
  Q_value <= EN and ((ran_next and ran and unit and equal_2) or equal);

  Q <= Q_value;
  QN <= not Q_value;

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

-- T1_0: timer of seconds
-- Fitted to PV = 1.
-- Example, with PV = 3:
-- IN  _#######__##__
-- EN  ###########_##
-- Q   ____#######___
-- QN  ####_______###
-- ACC 00123333333000
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity modicon_timer_T1_0_PV1 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    EN    : in  std_logic;
    unit  : in  std_logic;
    Q     : out std_logic
  );
end entity modicon_timer_T1_0_PV1;

architecture rtl of modicon_timer_T1_0_PV1 is
  signal ACC : std_logic := '0';
  signal ran : std_logic := '0';
  signal ran_next : std_logic;
  signal ACC_next : std_logic;
begin
  ran_next <= power and EN;
  ACC_next <= EN and (ACC xor (ran_next and ran and unit and not ACC));

  Q <= ACC_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= '0';
        ran <= '0';
      else
        ACC <= ACC_next;
        ran <= ran_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- T0_1: timer of tenths of a second
-- Fitted to PV = 10.
-- Example, with PV = 3:
-- IN  _#######__##__
-- EN  ###########_##
-- Q   ____#######___
-- QN  ####_______###
-- ACC 00123333333000
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity modicon_timer_T0_1_PV10 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    EN    : in  std_logic;
    unit  : in  std_logic;
    Q     : out std_logic
  );
end entity modicon_timer_T0_1_PV10;

architecture rtl of modicon_timer_T0_1_PV10 is
  signal ACC : unsigned(3 downto 0) := (others => '0');
  signal ran : std_logic := '0';
  signal ran_next : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(3 downto 0);
  signal ACC_next : unsigned(3 downto 0);
  signal equal_2 : std_logic;
begin
  ran_next <= power and EN;
  equal <= '1' when ACC = 10 else '0';
  sum <= ACC + (to_unsigned(0, 3) & (ran_next and ran and unit and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 4);
  equal_2 <= '1' when ACC = 9 else '0';

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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity modicon_timer is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    tick            : in  std_logic;
    in_10001        : in  std_logic;
    in_10002        : in  std_logic;
    coil_00107      : out std_logic;
    coil_00108      : out std_logic;
    cascade_tenths  : out std_logic;
    cascade_seconds : out std_logic
  );
end entity modicon_timer;

architecture rtl of modicon_timer is
  signal coil_00107_reg : std_logic := '0';
  signal coil_00108_reg : std_logic := '0';
  signal cascade_tenths_reg : std_logic := '0';
  signal cascade_seconds_reg : std_logic := '0';
  signal every_1s_Q : std_logic;
  signal every_100ms_Q : std_logic;
  signal t40040_Q : std_logic;
  signal t40040_QN : std_logic;
  signal coil_00107_next : std_logic;
  signal coil_00108_next : std_logic;
  signal s1_Q : std_logic;
  signal s2_Q : std_logic;
  signal cascade_seconds_next : std_logic;
  signal d1_Q : std_logic;
  signal d2_Q : std_logic;
  signal cascade_tenths_next : std_logic;
begin

  -- units of time, each a pulse that all blocks share
  every_1s: entity work.modicon_timer_DIVIDER_N100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      Q => every_1s_Q
    );
  every_100ms: entity work.modicon_timer_DIVIDER_N10
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      Q => every_100ms_Q
    );

  -- rung 1 "T1.0 with a preset of 5; its time is in 40040", modicon_timer.ladder:10
  t40040: entity work.modicon_timer_T1_0_PV5
    port map (
      clk => clk,
      rst => rst,
      power => in_10001,
      EN => in_10002,
      unit => every_1s_Q,
      Q => t40040_Q,
      QN => t40040_QN
    );
  coil_00107_next <= t40040_Q;

  -- rung 2, modicon_timer.ladder:13
  coil_00108_next <= t40040_QN;

  -- rung 3 "two seconds of two timers with presets of 1", modicon_timer.ladder:15
  s1: entity work.modicon_timer_T1_0_PV1
    port map (
      clk => clk,
      rst => rst,
      power => in_10001,
      EN => in_10002,
      unit => every_1s_Q,
      Q => s1_Q
    );
  s2: entity work.modicon_timer_T1_0_PV1
    port map (
      clk => clk,
      rst => rst,
      power => s1_Q,
      EN => in_10002,
      unit => every_1s_Q,
      Q => s2_Q
    );
  cascade_seconds_next <= s2_Q;

  -- rung 4 "and of two with presets of 10, as the manual advises", modicon_timer.ladder:18
  d1: entity work.modicon_timer_T0_1_PV10
    port map (
      clk => clk,
      rst => rst,
      power => in_10001,
      EN => in_10002,
      unit => every_100ms_Q,
      Q => d1_Q
    );
  d2: entity work.modicon_timer_T0_1_PV10
    port map (
      clk => clk,
      rst => rst,
      power => d1_Q,
      EN => in_10002,
      unit => every_100ms_Q,
      Q => d2_Q
    );
  cascade_tenths_next <= d2_Q;

  coil_00107 <= coil_00107_reg;
  coil_00108 <= coil_00108_reg;
  cascade_tenths <= cascade_tenths_reg;
  cascade_seconds <= cascade_seconds_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        coil_00107_reg <= '0';
        coil_00108_reg <= '0';
        cascade_tenths_reg <= '0';
        cascade_seconds_reg <= '0';
      else
        coil_00107_reg <= coil_00107_next;
        coil_00108_reg <= coil_00108_next;
        cascade_tenths_reg <= cascade_tenths_next;
        cascade_seconds_reg <= cascade_seconds_next;
      end if;
    end if;
  end process;
end architecture rtl;
