-- Made by hotrail 0.1.0 from paper_timers.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- DIVIDER: divider of the tick, N = 10 ticks
-- Example, with N = 3:
-- tick ####_#__##
-- IN   ##########
-- Q    __#_____#_
-- CV   1201122201
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_timers_test_DIVIDER_N10 is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity paper_timers_test_DIVIDER_N10;

architecture rtl of paper_timers_test_DIVIDER_N10 is
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

entity paper_timers_test_DIVIDER_N1 is
  port (
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity paper_timers_test_DIVIDER_N1;

architecture rtl of paper_timers_test_DIVIDER_N1 is
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

entity paper_timers_test_TS_OFF_PV3 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    power    : in  std_logic;
    EN       : in  std_logic;
    unit     : in  std_logic;
    Q        : out std_logic;
    ACC_last : out unsigned(1 downto 0)
  );
end entity paper_timers_test_TS_OFF_PV3;

architecture rtl of paper_timers_test_TS_OFF_PV3 is
  signal ACC : unsigned(1 downto 0) := (others => '0');
  signal run : std_logic := '0';
  signal was : std_logic := '0';
  signal equal : std_logic;
  signal sum : unsigned(1 downto 0);
  signal condition : std_logic;
  signal choice : unsigned(1 downto 0);
  signal choice_2 : unsigned(1 downto 0);
  signal equal_2 : std_logic;
  signal condition_2 : std_logic;
  signal ACC_next : unsigned(1 downto 0);
  signal run_next : std_logic;
begin
  equal <= '1' when ACC = 3 else '0';
  sum <= ACC + (to_unsigned(0, 1) & (run and unit and not equal));
  condition <= run and was;
  choice <= to_unsigned(0, 2) when condition = '1' else sum;
  choice_2 <= to_unsigned(0, 2) when power = '1' else choice;
  equal_2 <= '1' when ACC = 2 else '0';
  condition_2 <=
      power
      or (run and not (not power and not condition and ((run and unit and equal_2) or equal)));
  ACC_next <= choice_2 when EN = '1' else to_unsigned(0, 2);
  run_next <= EN and condition_2;

  Q <= EN and condition_2;
  ACC_last <= ACC;

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

entity paper_timers_test_TT_PV5 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    power    : in  std_logic;
    EN       : in  std_logic;
    unit     : in  std_logic;
    Q        : out std_logic;
    ACC_last : out unsigned(2 downto 0)
  );
end entity paper_timers_test_TT_PV5;

architecture rtl of paper_timers_test_TT_PV5 is
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

entity paper_timers_test_TT_INTERVAL_PV4 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    power    : in  std_logic;
    EN       : in  std_logic;
    unit     : in  std_logic;
    Q        : out std_logic;
    ACC_last : out unsigned(2 downto 0)
  );
end entity paper_timers_test_TT_INTERVAL_PV4;

architecture rtl of paper_timers_test_TT_INTERVAL_PV4 is
  signal ACC : unsigned(2 downto 0) := (others => '0');
  signal run : std_logic := '0';
  signal was : std_logic := '0';
  signal equal : std_logic;
  signal sum : unsigned(2 downto 0);
  signal equal_2 : std_logic;
  signal condition : std_logic;
  signal choice : unsigned(2 downto 0);
  signal choice_2 : unsigned(2 downto 0);
  signal choice_3 : std_logic;
  signal choice_4 : unsigned(2 downto 0);
  signal ACC_next : unsigned(2 downto 0);
  signal run_next : std_logic;
begin
  equal <= '1' when ACC = 4 else '0';
  sum <= ACC + (to_unsigned(0, 2) & (unit and not equal));
  equal_2 <= '1' when ACC = 3 else '0';
  condition <= power and not was;
  choice <= to_unsigned(0, 3) when condition = '1' else ACC;
  choice_2 <= sum when run = '1' else choice;
  choice_3 <= not ((unit and equal_2) or equal) when run = '1' else condition;
  choice_4 <= choice_2 when (choice_3 or power) = '1' else to_unsigned(0, 3);
  ACC_next <= choice_4 when EN = '1' else to_unsigned(0, 3);
  run_next <= EN and choice_3;

  Q <= EN and choice_3;
  ACC_last <= ACC;

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

entity paper_timers_test is
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
    timer_interval_coil : out std_logic;
    actual_tt_ACC       : out std_logic_vector(15 downto 0);
    interval_tt_ACC     : out std_logic_vector(15 downto 0);
    actual_ts_ACC       : out std_logic_vector(15 downto 0)
  );
end entity paper_timers_test;

architecture rtl of paper_timers_test is
  signal timer_off_coil_reg : std_logic := '0';
  signal timer_on_coil_reg : std_logic := '0';
  signal timer_interval_coil_reg : std_logic := '0';
  signal every_1s_Q : std_logic;
  signal every_100ms_Q : std_logic;
  signal rung1_power : std_logic;
  signal timing_ckt : std_logic;
  signal actual_ts_Q : std_logic;
  signal actual_ts_ACC_last : unsigned(1 downto 0);
  signal timer_off_coil_next : std_logic;
  signal actual_tt_Q : std_logic;
  signal actual_tt_ACC_last : unsigned(2 downto 0);
  signal timer_on_coil_next : std_logic;
  signal interval_tt_Q : std_logic;
  signal interval_tt_ACC_last : unsigned(2 downto 0);
  signal actual_tt_ACC_value : unsigned(15 downto 0);
  signal interval_tt_ACC_value : unsigned(15 downto 0);
  signal actual_ts_ACC_value : unsigned(15 downto 0);
  signal timer_interval_coil_next : std_logic;
begin

  -- units of time, each a pulse that all blocks share
  every_1s: entity work.paper_timers_test_DIVIDER_N10
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      Q => every_1s_Q
    );
  every_100ms: entity work.paper_timers_test_DIVIDER_N1
    port map (
      tick => tick,
      Q => every_100ms_Q
    );

  -- rung 1 "the paper's Figure 14", paper_timers.ladder:11
  rung1_power <= c9 or (c2 and c3 and c4);
  timing_ckt <=
      (rung1_power and c1) or ((c5 or (rung1_power and c6)) and ((c7 and c8) or (c6 and c1)));

  -- rung 2 "timer_type 00: off-delay, 3 s", paper_timers.ladder:20
  actual_ts: entity work.paper_timers_test_TS_OFF_PV3
    port map (
      clk => clk,
      rst => rst,
      power => timing_ckt,
      EN => enable_ckt,
      unit => every_1s_Q,
      Q => actual_ts_Q,
      ACC_last => actual_ts_ACC_last
    );
  timer_off_coil_next <= actual_ts_Q;

  -- rung 3 "timer_type 01: on-delay, 5 tenths", paper_timers.ladder:23
  actual_tt: entity work.paper_timers_test_TT_PV5
    port map (
      clk => clk,
      rst => rst,
      power => timing_ckt,
      EN => enable_ckt,
      unit => every_100ms_Q,
      Q => actual_tt_Q,
      ACC_last => actual_tt_ACC_last
    );
  timer_on_coil_next <= actual_tt_Q;

  -- rung 4 "timer_type 1x: interval-delay, 4 tenths", paper_timers.ladder:26
  interval_tt: entity work.paper_timers_test_TT_INTERVAL_PV4
    port map (
      clk => clk,
      rst => rst,
      power => timing_ckt,
      EN => enable_ckt,
      unit => every_100ms_Q,
      Q => interval_tt_Q,
      ACC_last => interval_tt_ACC_last
    );
  actual_tt_ACC_value <= resize(actual_tt_ACC_last, 16);
  interval_tt_ACC_value <= resize(interval_tt_ACC_last, 16);
  actual_ts_ACC_value <= resize(actual_ts_ACC_last, 16);
  timer_interval_coil_next <= interval_tt_Q;

  timer_off_coil <= timer_off_coil_reg;
  timer_on_coil <= timer_on_coil_reg;
  timer_interval_coil <= timer_interval_coil_reg;
  actual_tt_ACC <= std_logic_vector(actual_tt_ACC_value);
  interval_tt_ACC <= std_logic_vector(interval_tt_ACC_value);
  actual_ts_ACC <= std_logic_vector(actual_ts_ACC_value);

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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_timers_expect is
  port (
    clk                 : in  std_logic;
    rst                 : in  std_logic;
    timer_on_coil       : in  std_logic;
    actual_tt_ACC       : in  std_logic_vector(15 downto 0);
    timer_interval_coil : in  std_logic;
    interval_tt_ACC     : in  std_logic_vector(15 downto 0);
    timer_off_coil      : in  std_logic;
    actual_ts_ACC       : in  std_logic_vector(15 downto 0);
    expect_0_0          : out std_logic;
    expect_0_1          : out std_logic;
    expect_1_0          : out std_logic;
    expect_1_1          : out std_logic;
    expect_2_0          : out std_logic;
    expect_2_1          : out std_logic;
    expect_3_0          : out std_logic;
    expect_3_1          : out std_logic;
    expect_4_0          : out std_logic;
    expect_5_0          : out std_logic;
    expect_5_1          : out std_logic;
    expect_6_0          : out std_logic;
    expect_7_0          : out std_logic;
    expect_8_0          : out std_logic;
    expect_8_1          : out std_logic;
    expect_9_0          : out std_logic;
    expect_9_1          : out std_logic;
    expect_10_0         : out std_logic;
    expect_10_1         : out std_logic;
    expect_10_2         : out std_logic;
    expect_11_0         : out std_logic;
    expect_11_1         : out std_logic;
    expect_11_2         : out std_logic
  );
end entity paper_timers_expect;

architecture rtl of paper_timers_expect is
begin

  expect_0_0 <= not timer_on_coil;
  expect_0_1 <= '1' when unsigned(actual_tt_ACC) = 4 else '0';
  expect_1_0 <= timer_on_coil;
  expect_1_1 <= '1' when unsigned(actual_tt_ACC) = 5 else '0';
  expect_2_0 <= timer_on_coil;
  expect_2_1 <= '1' when unsigned(actual_tt_ACC) = 5 else '0';
  expect_3_0 <= not timer_on_coil;
  expect_3_1 <= '1' when unsigned(actual_tt_ACC) = 0 else '0';
  expect_4_0 <= timer_interval_coil;
  expect_5_0 <= timer_interval_coil;
  expect_5_1 <= '1' when unsigned(interval_tt_ACC) = 3 else '0';
  expect_6_0 <= not timer_interval_coil;
  expect_7_0 <= timer_off_coil;
  expect_8_0 <= timer_off_coil;
  expect_8_1 <= '1' when unsigned(actual_ts_ACC) = 2 else '0';
  expect_9_0 <= not timer_off_coil;
  expect_9_1 <= '1' when unsigned(actual_ts_ACC) = 3 else '0';
  expect_10_0 <= not timer_off_coil;
  expect_10_1 <= not timer_on_coil;
  expect_10_2 <= not timer_interval_coil;
  expect_11_0 <= timer_off_coil;
  expect_11_1 <= not timer_on_coil;
  expect_11_2 <= not timer_interval_coil;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity paper_timers_tb is
end entity;

architecture tests of paper_timers_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal c1 : std_logic := '0';
  signal c2 : std_logic := '0';
  signal c3 : std_logic := '0';
  signal c4 : std_logic := '0';
  signal c5 : std_logic := '0';
  signal c6 : std_logic := '0';
  signal c7 : std_logic := '0';
  signal c8 : std_logic := '0';
  signal c9 : std_logic := '0';
  signal enable_ckt : std_logic := '0';
  signal timer_off_coil : std_logic;
  signal timer_on_coil : std_logic;
  signal timer_interval_coil : std_logic;
  signal actual_tt_ACC : std_logic_vector(15 downto 0);
  signal interval_tt_ACC : std_logic_vector(15 downto 0);
  signal actual_ts_ACC : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_10_2 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_11_2 : std_logic;

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
  core : entity work.paper_timers_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      c1 => c1,
      c2 => c2,
      c3 => c3,
      c4 => c4,
      c5 => c5,
      c6 => c6,
      c7 => c7,
      c8 => c8,
      c9 => c9,
      enable_ckt => enable_ckt,
      timer_off_coil => timer_off_coil,
      timer_on_coil => timer_on_coil,
      timer_interval_coil => timer_interval_coil,
      actual_tt_ACC => actual_tt_ACC,
      interval_tt_ACC => interval_tt_ACC,
      actual_ts_ACC => actual_ts_ACC
    );

  expectations : entity work.paper_timers_expect
    port map (
      clk => clk,
      rst => rst,
      timer_on_coil => timer_on_coil,
      actual_tt_ACC => actual_tt_ACC,
      timer_interval_coil => timer_interval_coil,
      interval_tt_ACC => interval_tt_ACC,
      timer_off_coil => timer_off_coil,
      actual_ts_ACC => actual_ts_ACC,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_7_0 => expect_7_0,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_10_2 => expect_10_2,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_11_2 => expect_11_2
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
      c1 <= '0';
      c2 <= '0';
      c3 <= '0';
      c4 <= '0';
      c5 <= '0';
      c6 <= '0';
      c7 <= '0';
      c8 <= '0';
      c9 <= '0';
      enable_ckt <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..4");

    -- on-delay: 0.5 s of power, kept while the enable circuit conducts
    failed := false;
    reset;
    enable_ckt <= '1';
    c9 <= '1';
    c1 <= '1';
    scan(1, '0');
    scan(4, '1');
    wait for 1 ns; -- paper_timers.ladder:32
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " timer_on_coil=" & image(timer_on_coil)
          & " actual_tt_ACC=" & image(actual_tt_ACC));
    end if;
    scan(1, '1');
    wait for 1 ns; -- paper_timers.ladder:34
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " timer_on_coil=" & image(timer_on_coil)
          & " actual_tt_ACC=" & image(actual_tt_ACC));
    end if;
    c1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_timers.ladder:36
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " timer_on_coil=" & image(timer_on_coil)
          & " actual_tt_ACC=" & image(actual_tt_ACC));
    end if;
    enable_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_timers.ladder:38
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " timer_on_coil=" & image(timer_on_coil)
          & " actual_tt_ACC=" & image(actual_tt_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - on-delay: 0.5 s of power, kept while the enable circuit conducts");
    else
      print("ok 1 - on-delay: 0.5 s of power, kept while the enable circuit conducts");
    end if;

    -- interval-delay: 0.4 s from the rise, whatever the power does then
    failed := false;
    reset;
    enable_ckt <= '1';
    c5 <= '1';
    c7 <= '1';
    c8 <= '1';
    scan(1, '0');
    wait for 1 ns; -- paper_timers.ladder:42
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " timer_interval_coil=" & image(timer_interval_coil));
    end if;
    c5 <= '0';
    scan(1, '0');
    scan(3, '1');
    wait for 1 ns; -- paper_timers.ladder:45
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " timer_interval_coil=" & image(timer_interval_coil)
          & " interval_tt_ACC=" & image(interval_tt_ACC));
    end if;
    scan(1, '1');
    wait for 1 ns; -- paper_timers.ladder:47
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " timer_interval_coil=" & image(timer_interval_coil));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - interval-delay: 0.4 s from the rise, whatever the power does then");
    else
      print("ok 2 - interval-delay: 0.4 s from the rise, whatever the power does then");
    end if;

    -- off-delay: with the power, and 3 s longer
    failed := false;
    reset;
    enable_ckt <= '1';
    c5 <= '1';
    c6 <= '1';
    c1 <= '1';
    scan(1, '0');
    wait for 1 ns; -- paper_timers.ladder:51
    if not failed and (expect_7_0) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0)
          & " timer_off_coil=" & image(timer_off_coil));
    end if;
    scan(9, '1');
    c6 <= '0';
    scan(1, '0');
    scan(20, '1');
    wait for 1 ns; -- paper_timers.ladder:55
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " timer_off_coil=" & image(timer_off_coil)
          & " actual_ts_ACC=" & image(actual_ts_ACC));
    end if;
    scan(1, '1');
    wait for 1 ns; -- paper_timers.ladder:57
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " timer_off_coil=" & image(timer_off_coil)
          & " actual_ts_ACC=" & image(actual_ts_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - off-delay: with the power, and 3 s longer");
    else
      print("ok 3 - off-delay: with the power, and 3 s longer");
    end if;

    -- the enable circuit holds all three in their reset state
    failed := false;
    reset;
    c9 <= '1';
    c1 <= '1';
    scan(10, '1');
    wait for 1 ns; -- paper_timers.ladder:61
    if not failed and (expect_10_0 and expect_10_1 and expect_10_2) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1) & image(expect_10_2)
          & " timer_off_coil=" & image(timer_off_coil)
          & " timer_on_coil=" & image(timer_on_coil)
          & " timer_interval_coil=" & image(timer_interval_coil));
    end if;
    enable_ckt <= '1';
    scan(1, '0');
    wait for 1 ns; -- paper_timers.ladder:63
    if not failed and (expect_11_0 and expect_11_1 and expect_11_2) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1) & image(expect_11_2)
          & " timer_off_coil=" & image(timer_off_coil)
          & " timer_on_coil=" & image(timer_on_coil)
          & " timer_interval_coil=" & image(timer_interval_coil));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - the enable circuit holds all three in their reset state");
    else
      print("ok 4 - the enable circuit holds all three in their reset state");
    end if;

    assert failures = 0 report integer'image(failures) & " of 4 tests failed" severity failure;
    wait;
  end process;
end architecture;
