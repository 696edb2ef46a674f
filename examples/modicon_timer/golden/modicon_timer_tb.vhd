-- Made by hotrail 0.1.0 from modicon_timer.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- DIVIDER: divider of the tick, N = 100 ticks
-- Example, with N = 3:
-- tick ####_#__##
-- IN   ##########
-- Q    __#_____#_
-- CV   1201122201
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity modicon_timer_test_DIVIDER_N100 is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity modicon_timer_test_DIVIDER_N100;

architecture rtl of modicon_timer_test_DIVIDER_N100 is
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

entity modicon_timer_test_DIVIDER_N10 is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity modicon_timer_test_DIVIDER_N10;

architecture rtl of modicon_timer_test_DIVIDER_N10 is
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

entity modicon_timer_test_T1_0_PV5 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    power    : in  std_logic;
    EN       : in  std_logic;
    unit     : in  std_logic;
    Q        : out std_logic;
    QN       : out std_logic;
    ACC_last : out unsigned(2 downto 0)
  );
end entity modicon_timer_test_T1_0_PV5;

architecture rtl of modicon_timer_test_T1_0_PV5 is
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
  ACC_last <= ACC;

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

entity modicon_timer_test_T1_0_PV1 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    power  : in  std_logic;
    EN     : in  std_logic;
    unit   : in  std_logic;
    Q      : out std_logic;
    Q_last : out std_logic
  );
end entity modicon_timer_test_T1_0_PV1;

architecture rtl of modicon_timer_test_T1_0_PV1 is
  signal Q_reg : std_logic := '0';
  signal ran : std_logic := '0';
  signal ran_next : std_logic;
  signal Q_next : std_logic;
begin
  ran_next <= power and EN;
  Q_next <= EN and (Q_reg xor (ran_next and ran and unit and not Q_reg));

  Q <= Q_next;
  Q_last <= Q_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        ran <= '0';
      else
        Q_reg <= Q_next;
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

entity modicon_timer_test_T0_1_PV10 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    power    : in  std_logic;
    EN       : in  std_logic;
    unit     : in  std_logic;
    Q        : out std_logic;
    Q_last   : out std_logic;
    ACC_last : out unsigned(3 downto 0)
  );
end entity modicon_timer_test_T0_1_PV10;

architecture rtl of modicon_timer_test_T0_1_PV10 is
  signal Q_reg : std_logic := '0';
  signal ACC : unsigned(3 downto 0) := (others => '0');
  signal ran : std_logic := '0';
  signal ran_next : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(3 downto 0);
  signal ACC_next : unsigned(3 downto 0);
  signal equal_2 : std_logic;
  signal Q_next : std_logic;
begin
  ran_next <= power and EN;
  equal <= '1' when ACC = 10 else '0';
  sum <= ACC + (to_unsigned(0, 3) & (ran_next and ran and unit and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 4);
  equal_2 <= '1' when ACC = 9 else '0';
  Q_next <= EN and ((ran_next and ran and unit and equal_2) or equal);

  Q <= Q_next;
  Q_last <= Q_reg;
  ACC_last <= ACC;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        ACC <= (others => '0');
        ran <= '0';
      else
        Q_reg <= Q_next;
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

entity modicon_timer_test_T0_1_PV10_2 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    power  : in  std_logic;
    EN     : in  std_logic;
    unit   : in  std_logic;
    Q      : out std_logic;
    Q_last : out std_logic
  );
end entity modicon_timer_test_T0_1_PV10_2;

architecture rtl of modicon_timer_test_T0_1_PV10_2 is
  signal Q_reg : std_logic := '0';
  signal ACC : unsigned(3 downto 0) := (others => '0');
  signal ran : std_logic := '0';
  signal ran_next : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(3 downto 0);
  signal ACC_next : unsigned(3 downto 0);
  signal equal_2 : std_logic;
  signal Q_next : std_logic;
begin
  ran_next <= power and EN;
  equal <= '1' when ACC = 10 else '0';
  sum <= ACC + (to_unsigned(0, 3) & (ran_next and ran and unit and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 4);
  equal_2 <= '1' when ACC = 9 else '0';
  Q_next <= EN and ((ran_next and ran and unit and equal_2) or equal);

  Q <= Q_next;
  Q_last <= Q_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        ACC <= (others => '0');
        ran <= '0';
      else
        Q_reg <= Q_next;
        ACC <= ACC_next;
        ran <= ran_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity modicon_timer_test is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    tick            : in  std_logic;
    in_10001        : in  std_logic;
    in_10002        : in  std_logic;
    coil_00107      : out std_logic;
    coil_00108      : out std_logic;
    cascade_tenths  : out std_logic;
    cascade_seconds : out std_logic;
    t40040_ACC      : out std_logic_vector(15 downto 0);
    s1_Q            : out std_logic;
    s2_Q            : out std_logic;
    d1_Q            : out std_logic;
    d2_Q            : out std_logic;
    d1_ACC          : out std_logic_vector(15 downto 0)
  );
end entity modicon_timer_test;

architecture rtl of modicon_timer_test is
  signal coil_00107_reg : std_logic := '0';
  signal coil_00108_reg : std_logic := '0';
  signal cascade_tenths_reg : std_logic := '0';
  signal cascade_seconds_reg : std_logic := '0';
  signal every_1s_Q : std_logic;
  signal every_100ms_Q : std_logic;
  signal t40040_Q : std_logic;
  signal t40040_QN : std_logic;
  signal t40040_ACC_last : unsigned(2 downto 0);
  signal coil_00107_next : std_logic;
  signal coil_00108_next : std_logic;
  signal s1_Q_2 : std_logic;
  signal s1_Q_last : std_logic;
  signal s2_Q_2 : std_logic;
  signal s2_Q_last : std_logic;
  signal cascade_seconds_next : std_logic;
  signal d1_Q_2 : std_logic;
  signal d1_Q_last : std_logic;
  signal d1_ACC_last : unsigned(3 downto 0);
  signal d2_Q_2 : std_logic;
  signal d2_Q_last : std_logic;
  signal t40040_ACC_value : unsigned(15 downto 0);
  signal d1_ACC_value : unsigned(15 downto 0);
  signal cascade_tenths_next : std_logic;
begin

  -- units of time, each a pulse that all blocks share
  every_1s: entity work.modicon_timer_test_DIVIDER_N100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      Q => every_1s_Q
    );
  every_100ms: entity work.modicon_timer_test_DIVIDER_N10
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      Q => every_100ms_Q
    );

  -- rung 1 "T1.0 with a preset of 5; its time is in 40040", modicon_timer.ladder:10
  t40040: entity work.modicon_timer_test_T1_0_PV5
    port map (
      clk => clk,
      rst => rst,
      power => in_10001,
      EN => in_10002,
      unit => every_1s_Q,
      Q => t40040_Q,
      QN => t40040_QN,
      ACC_last => t40040_ACC_last
    );
  coil_00107_next <= t40040_Q;

  -- rung 2, modicon_timer.ladder:13
  coil_00108_next <= t40040_QN;

  -- rung 3 "two seconds of two timers with presets of 1", modicon_timer.ladder:15
  s1: entity work.modicon_timer_test_T1_0_PV1
    port map (
      clk => clk,
      rst => rst,
      power => in_10001,
      EN => in_10002,
      unit => every_1s_Q,
      Q => s1_Q_2,
      Q_last => s1_Q_last
    );
  s2: entity work.modicon_timer_test_T1_0_PV1
    port map (
      clk => clk,
      rst => rst,
      power => s1_Q_2,
      EN => in_10002,
      unit => every_1s_Q,
      Q => s2_Q_2,
      Q_last => s2_Q_last
    );
  cascade_seconds_next <= s2_Q_2;

  -- rung 4 "and of two with presets of 10, as the manual advises", modicon_timer.ladder:18
  d1: entity work.modicon_timer_test_T0_1_PV10
    port map (
      clk => clk,
      rst => rst,
      power => in_10001,
      EN => in_10002,
      unit => every_100ms_Q,
      Q => d1_Q_2,
      Q_last => d1_Q_last,
      ACC_last => d1_ACC_last
    );
  d2: entity work.modicon_timer_test_T0_1_PV10_2
    port map (
      clk => clk,
      rst => rst,
      power => d1_Q_2,
      EN => in_10002,
      unit => every_100ms_Q,
      Q => d2_Q_2,
      Q_last => d2_Q_last
    );
  t40040_ACC_value <= resize(t40040_ACC_last, 16);
  d1_ACC_value <= resize(d1_ACC_last, 16);
  cascade_tenths_next <= d2_Q_2;

  coil_00107 <= coil_00107_reg;
  coil_00108 <= coil_00108_reg;
  cascade_tenths <= cascade_tenths_reg;
  cascade_seconds <= cascade_seconds_reg;
  t40040_ACC <= std_logic_vector(t40040_ACC_value);
  s1_Q <= s1_Q_last;
  s2_Q <= s2_Q_last;
  d1_Q <= d1_Q_last;
  d2_Q <= d2_Q_last;
  d1_ACC <= std_logic_vector(d1_ACC_value);

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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity modicon_timer_expect is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    coil_00107      : in  std_logic;
    coil_00108      : in  std_logic;
    t40040_ACC      : in  std_logic_vector(15 downto 0);
    s1_Q            : in  std_logic;
    s2_Q            : in  std_logic;
    d1_Q            : in  std_logic;
    d2_Q            : in  std_logic;
    cascade_seconds : in  std_logic;
    cascade_tenths  : in  std_logic;
    d1_ACC          : in  std_logic_vector(15 downto 0);
    expect_0_0      : out std_logic;
    expect_0_1      : out std_logic;
    expect_0_2      : out std_logic;
    expect_1_0      : out std_logic;
    expect_1_1      : out std_logic;
    expect_2_0      : out std_logic;
    expect_2_1      : out std_logic;
    expect_2_2      : out std_logic;
    expect_3_0      : out std_logic;
    expect_3_1      : out std_logic;
    expect_3_2      : out std_logic;
    expect_4_0      : out std_logic;
    expect_4_1      : out std_logic;
    expect_5_0      : out std_logic;
    expect_6_0      : out std_logic;
    expect_6_1      : out std_logic;
    expect_7_0      : out std_logic;
    expect_7_1      : out std_logic;
    expect_7_2      : out std_logic;
    expect_8_0      : out std_logic;
    expect_9_0      : out std_logic;
    expect_10_0     : out std_logic;
    expect_10_1     : out std_logic;
    expect_10_2     : out std_logic;
    expect_10_3     : out std_logic;
    expect_11_0     : out std_logic;
    expect_11_1     : out std_logic;
    expect_12_0     : out std_logic;
    expect_12_1     : out std_logic;
    expect_13_0     : out std_logic;
    expect_14_0     : out std_logic;
    expect_14_1     : out std_logic
  );
end entity modicon_timer_expect;

architecture rtl of modicon_timer_expect is
begin

  expect_0_0 <= not coil_00107;
  expect_0_1 <= coil_00108;
  expect_0_2 <= '1' when unsigned(t40040_ACC) = 0 else '0';
  expect_1_0 <= not coil_00107;
  expect_1_1 <= coil_00108;
  expect_2_0 <= not coil_00107;
  expect_2_1 <= coil_00108;
  expect_2_2 <= '1' when unsigned(t40040_ACC) = 4 else '0';
  expect_3_0 <= coil_00107;
  expect_3_1 <= not coil_00108;
  expect_3_2 <= '1' when unsigned(t40040_ACC) = 5 else '0';
  expect_4_0 <= coil_00107;
  expect_4_1 <= '1' when unsigned(t40040_ACC) = 5 else '0';
  expect_5_0 <= coil_00107;
  expect_6_0 <= coil_00107;
  expect_6_1 <= '1' when unsigned(t40040_ACC) = 5 else '0';
  expect_7_0 <= not coil_00107;
  expect_7_1 <= coil_00108;
  expect_7_2 <= '1' when unsigned(t40040_ACC) = 0 else '0';
  expect_8_0 <= '1' when unsigned(t40040_ACC) = 3 else '0';
  expect_9_0 <= coil_00107;
  expect_10_0 <= s1_Q;
  expect_10_1 <= not s2_Q;
  expect_10_2 <= d1_Q;
  expect_10_3 <= not d2_Q;
  expect_11_0 <= not cascade_seconds;
  expect_11_1 <= not cascade_tenths;
  expect_12_0 <= cascade_seconds;
  expect_12_1 <= cascade_tenths;
  expect_13_0 <= '1' when unsigned(t40040_ACC) = 0 else '0';
  expect_14_0 <= '1' when unsigned(t40040_ACC) = 1 else '0';
  expect_14_1 <= '1' when unsigned(d1_ACC) = 1 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity modicon_timer_tb is
end entity;

architecture tests of modicon_timer_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal in_10001 : std_logic := '0';
  signal in_10002 : std_logic := '0';
  signal coil_00107 : std_logic;
  signal coil_00108 : std_logic;
  signal cascade_tenths : std_logic;
  signal cascade_seconds : std_logic;
  signal t40040_ACC : std_logic_vector(15 downto 0);
  signal s1_Q : std_logic;
  signal s2_Q : std_logic;
  signal d1_Q : std_logic;
  signal d2_Q : std_logic;
  signal d1_ACC : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_2_2 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_7_2 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_10_2 : std_logic;
  signal expect_10_3 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_14_1 : std_logic;

  function image(bit : std_logic) return string is
    constant quoted : string := std_logic'image(bit);
  begin
    return quoted(2 to 2);
  end function;

  function image(bits : std_logic_vector) return string is
    alias from_left : std_logic_vector(1 to bits'length) is bits;
    variable text : string(1 to bits'length);
  begin
    for index in text'range loop
      text(index to index) := image(from_left(index));
    end loop;
    return text;
  end function;

  procedure print(text : string) is
    variable buf : line;
  begin
    write(buf, text);
    writeline(output, buf);
  end procedure;
begin
  core : entity work.modicon_timer_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      in_10001 => in_10001,
      in_10002 => in_10002,
      coil_00107 => coil_00107,
      coil_00108 => coil_00108,
      cascade_tenths => cascade_tenths,
      cascade_seconds => cascade_seconds,
      t40040_ACC => t40040_ACC,
      s1_Q => s1_Q,
      s2_Q => s2_Q,
      d1_Q => d1_Q,
      d2_Q => d2_Q,
      d1_ACC => d1_ACC
    );

  expectations : entity work.modicon_timer_expect
    port map (
      clk => clk,
      rst => rst,
      coil_00107 => coil_00107,
      coil_00108 => coil_00108,
      t40040_ACC => t40040_ACC,
      s1_Q => s1_Q,
      s2_Q => s2_Q,
      d1_Q => d1_Q,
      d2_Q => d2_Q,
      cascade_seconds => cascade_seconds,
      cascade_tenths => cascade_tenths,
      d1_ACC => d1_ACC,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_2_2 => expect_2_2,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_7_2 => expect_7_2,
      expect_8_0 => expect_8_0,
      expect_9_0 => expect_9_0,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_10_2 => expect_10_2,
      expect_10_3 => expect_10_3,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_14_1 => expect_14_1
    );

  process
    variable failed : boolean;
    variable failures : natural := 0;

    -- One clock is one scan.
    procedure scan(times : natural; with_tick : std_logic) is
    begin
      tick <= with_tick;
      for count in 1 to times loop
        wait for 5 ns;
        clk <= '1';
        wait for 5 ns;
        clk <= '0';
      end loop;
    end procedure;

    procedure reset is
    begin
      tick <= '0';
      in_10001 <= '0';
      in_10002 <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..6");

    -- without any power the bottom output conducts
    failed := false;
    reset;
    scan(1, '0');
    wait for 1 ns; -- modicon_timer.ladder:23
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " coil_00107=" & image(coil_00107)
          & " coil_00108=" & image(coil_00108)
          & " t40040_ACC=" & image(t40040_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - without any power the bottom output conducts");
    else
      print("ok 1 - without any power the bottom output conducts");
    end if;

    -- five seconds
    failed := false;
    reset;
    in_10002 <= '1';
    scan(1, '0');
    wait for 1 ns; -- modicon_timer.ladder:27
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " coil_00107=" & image(coil_00107)
          & " coil_00108=" & image(coil_00108));
    end if;
    in_10001 <= '1';
    scan(1, '0');
    scan(499, '1');
    wait for 1 ns; -- modicon_timer.ladder:30
    if not failed and (expect_2_0 and expect_2_1 and expect_2_2) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2)
          & " coil_00107=" & image(coil_00107)
          & " coil_00108=" & image(coil_00108)
          & " t40040_ACC=" & image(t40040_ACC));
    end if;
    scan(1, '1');
    wait for 1 ns; -- modicon_timer.ladder:32
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
          & " coil_00107=" & image(coil_00107)
          & " coil_00108=" & image(coil_00108)
          & " t40040_ACC=" & image(t40040_ACC));
    end if;
    scan(300, '1');
    wait for 1 ns; -- modicon_timer.ladder:34
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " coil_00107=" & image(coil_00107)
          & " t40040_ACC=" & image(t40040_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - five seconds");
    else
      print("ok 2 - five seconds");
    end if;

    -- the enable circuit puts it back, the timing circuit does not
    failed := false;
    reset;
    in_10001 <= '1';
    in_10002 <= '1';
    scan(1, '0');
    scan(500, '1');
    wait for 1 ns; -- modicon_timer.ladder:39
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " coil_00107=" & image(coil_00107));
    end if;
    in_10001 <= '0';
    scan(1, '0');
    wait for 1 ns; -- modicon_timer.ladder:41
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " coil_00107=" & image(coil_00107)
          & " t40040_ACC=" & image(t40040_ACC));
    end if;
    in_10002 <= '0';
    scan(1, '0');
    wait for 1 ns; -- modicon_timer.ladder:43
    if not failed and (expect_7_0 and expect_7_1 and expect_7_2) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2)
          & " coil_00107=" & image(coil_00107)
          & " coil_00108=" & image(coil_00108)
          & " t40040_ACC=" & image(t40040_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - the enable circuit puts it back, the timing circuit does not");
    else
      print("ok 3 - the enable circuit puts it back, the timing circuit does not");
    end if;

    -- retentive: the time with the timing circuit closed adds up
    failed := false;
    reset;
    in_10001 <= '1';
    in_10002 <= '1';
    scan(1, '0');
    scan(300, '1');
    in_10001 <= '0';
    scan(1000, '1');
    wait for 1 ns; -- modicon_timer.ladder:49
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " t40040_ACC=" & image(t40040_ACC));
    end if;
    in_10001 <= '1';
    scan(1, '0');
    scan(200, '1');
    wait for 1 ns; -- modicon_timer.ladder:52
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " coil_00107=" & image(coil_00107));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - retentive: the time with the timing circuit closed adds up");
    else
      print("ok 4 - retentive: the time with the timing circuit closed adds up");
    end if;

    -- cascades: the second timer starts with the pulse after the one that ends the first
    failed := false;
    reset;
    in_10001 <= '1';
    in_10002 <= '1';
    scan(1, '0');
    scan(100, '1');
    wait for 1 ns; -- modicon_timer.ladder:57
    if not failed and (expect_10_0 and expect_10_1 and expect_10_2 and expect_10_3) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1) & image(expect_10_2) & image(expect_10_3)
          & " s1_Q=" & image(s1_Q)
          & " s2_Q=" & image(s2_Q)
          & " d1_Q=" & image(d1_Q)
          & " d2_Q=" & image(d2_Q));
    end if;
    scan(99, '1');
    wait for 1 ns; -- modicon_timer.ladder:59
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " cascade_seconds=" & image(cascade_seconds)
          & " cascade_tenths=" & image(cascade_tenths));
    end if;
    scan(1, '1');
    wait for 1 ns; -- modicon_timer.ladder:61
    if not failed and (expect_12_0 and expect_12_1) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
          & " cascade_seconds=" & image(cascade_seconds)
          & " cascade_tenths=" & image(cascade_tenths));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - cascades: the second timer starts with the pulse after the one that ends the first");
    else
      print("ok 5 - cascades: the second timer starts with the pulse after the one that ends the first");
    end if;

    -- the first unit may be short: the pulses run free
    failed := false;
    reset;
    in_10002 <= '1';
    scan(90, '1');
    in_10001 <= '1';
    scan(1, '0');
    scan(9, '1');
    wait for 1 ns; -- modicon_timer.ladder:67
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " t40040_ACC=" & image(t40040_ACC));
    end if;
    scan(1, '1');
    wait for 1 ns; -- modicon_timer.ladder:69
    if not failed and (expect_14_0 and expect_14_1) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0) & image(expect_14_1)
          & " t40040_ACC=" & image(t40040_ACC)
          & " d1_ACC=" & image(d1_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - the first unit may be short: the pulses run free");
    else
      print("ok 6 - the first unit may be short: the pulses run free");
    end if;

    assert failures = 0 report integer'image(failures) & " of 6 tests failed" severity failure;
    wait;
  end process;
end architecture;
