-- Made by hotrail 0.1.0 from ab_retentive.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- AB_RTO: retentive timer of Allen-Bradley, BASE = 100 ticks
-- Example, with PRE = 3, BASE = 1:
-- IN  _##_###____#_##
-- (R) ____________#__
-- EN  _##_###____#_##
-- TT  _##_##_______##
-- DN  ______######___
-- ACC 001112333333001
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_retentive_test_AB_RTO_BASE100 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    power       : in  std_logic;
    PRE         : in  unsigned(15 downto 0);
    clear_after : in  std_logic;
    ACC_last    : out unsigned(14 downto 0);
    EN_last     : out std_logic;
    TT_last     : out std_logic;
    DN          : out std_logic
  );
end entity ab_retentive_test_AB_RTO_BASE100;

architecture rtl of ab_retentive_test_AB_RTO_BASE100 is
  signal ACC : unsigned(14 downto 0) := (others => '0');
  signal EN : std_logic := '0';
  signal TT : std_logic := '0';
  signal DN_reg : std_logic := '0';
  signal fraction : unsigned(6 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal choice : unsigned(14 downto 0);
  signal condition : std_logic;
  signal equal : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(6 downto 0);
  signal choice_2 : unsigned(6 downto 0);
  signal unequal : std_logic;
  signal sum_2 : unsigned(14 downto 0);
  signal at_least : std_logic;
  signal DN_value : std_logic;
  signal ACC_next : unsigned(14 downto 0);
  signal EN_next : std_logic;
  signal TT_next : std_logic;
  signal DN_next : std_logic;
  signal fraction_next : unsigned(6 downto 0);
begin
  less <= '1' when signed(PRE) < 0 else '0';
  choice <= to_unsigned(0, 15) when less = '1' else PRE(14 downto 0);
  condition <= power and was and not DN_reg and tick;
  equal <= '1' when fraction = 99 else '0';
  condition_2 <= condition and equal;
  sum <= fraction + (to_unsigned(0, 6) & condition);
  choice_2 <= to_unsigned(0, 7) when condition_2 = '1' else sum;
  unequal <= '1' when ACC /= 32767 else '0';
  sum_2 <= ACC + (to_unsigned(0, 14) & (condition_2 and unequal));
  at_least <= '1' when sum_2 >= choice else '0';
  DN_value <= DN_reg or (power and at_least);
  ACC_next <= to_unsigned(0, 15) when clear_after = '1' else sum_2;
  EN_next <= '0' when clear_after = '1' else power;
  TT_next <= '0' when clear_after = '1' else power and not DN_value;
  DN_next <= '0' when clear_after = '1' else DN_value;
  fraction_next <= to_unsigned(0, 7) when clear_after = '1' else choice_2;

  ACC_last <= ACC;
  EN_last <= EN;
  TT_last <= TT;
  DN <= DN_value;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        EN <= '0';
        TT <= '0';
        DN_reg <= '0';
        fraction <= (others => '0');
        was <= '0';
      else
        ACC <= ACC_next;
        EN <= EN_next;
        TT <= TT_next;
        DN_reg <= DN_next;
        fraction <= fraction_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TONR: retentive on-delay timer
-- Example, with PT = 3:
-- IN  _##_###____######
-- R   _________#___#___
-- Q   ______###_______#
-- ET  00111233300010123
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_retentive_test_TONR is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    tick    : in  std_logic;
    power   : in  std_logic;
    PT      : in  unsigned(31 downto 0);
    R       : in  std_logic;
    Q       : out std_logic;
    ET_last : out unsigned(31 downto 0)
  );
end entity ab_retentive_test_TONR;

architecture rtl of ab_retentive_test_TONR is
  signal ET : unsigned(31 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal sum : unsigned(31 downto 0);
  signal ET_next : unsigned(31 downto 0);
  signal at_least : std_logic;
begin
  less <= '1' when signed(ET) < signed(PT) else '0';
  sum <= ET + (to_unsigned(0, 31) & (power and was and tick and less));
  ET_next <= to_unsigned(0, 32) when R = '1' else sum;
  at_least <= '1' when signed(ET_next) >= signed(PT) else '0';

  Q <= not R and at_least;
  ET_last <= ET;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
      else
        ET <= ET_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_retentive_test is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    tick            : in  std_logic;
    pump            : in  std_logic;
    reset_button    : in  std_logic;
    longer          : in  std_logic;
    service         : out std_logic;
    siemens_service : out std_logic;
    t4_2_ACC        : out std_logic_vector(15 downto 0);
    t3_ET           : out std_logic_vector(31 downto 0);
    t4_2_EN         : out std_logic;
    t4_2_TT         : out std_logic
  );
end entity ab_retentive_test;

architecture rtl of ab_retentive_test is
  signal t4_2_PRE : unsigned(3 downto 0) := to_unsigned(5, 4);
  signal limit : unsigned(9 downto 0) := to_unsigned(500, 10);
  signal service_reg : std_logic := '0';
  signal siemens_service_reg : std_logic := '0';
  signal t4_2_PRE_2 : unsigned(15 downto 0);
  signal t4_2_ACC_last : unsigned(14 downto 0);
  signal t4_2_EN_last : std_logic;
  signal t4_2_TT_last : std_logic;
  signal t4_2_DN : std_logic;
  signal service_next : std_logic;
  signal t3_PT : unsigned(31 downto 0);
  signal t3_Q : std_logic;
  signal t3_ET_last : unsigned(31 downto 0);
  signal siemens_service_next : std_logic;
  signal t4_2_PRE_next : unsigned(3 downto 0);
  signal limit_next : unsigned(9 downto 0);
  signal t4_2_ACC_value : unsigned(15 downto 0);
begin

  -- rung 1 "T4:2, five units of a second", ab_retentive.ladder:12
  t4_2_PRE_2 <= resize(t4_2_PRE, 16);
  t4_2: entity work.ab_retentive_test_AB_RTO_BASE100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pump,
      PRE => t4_2_PRE_2,
      clear_after => reset_button,
      ACC_last => t4_2_ACC_last,
      EN_last => t4_2_EN_last,
      TT_last => t4_2_TT_last,
      DN => t4_2_DN
    );

  -- rung 2, ab_retentive.ladder:15
  service_next <= t4_2_DN;

  -- rung 3 "RES", ab_retentive.ladder:17

  -- rung 4 "the same with Siemens' timer", ab_retentive.ladder:20
  t3_PT <= resize(limit, 32);
  t3: entity work.ab_retentive_test_TONR
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pump,
      PT => t3_PT,
      R => reset_button,
      Q => t3_Q,
      ET_last => t3_ET_last
    );
  siemens_service_next <= t3_Q;

  -- rung 5, ab_retentive.ladder:23
  t4_2_PRE_next <= to_unsigned(8, 4) when longer = '1' else t4_2_PRE;
  limit_next <= to_unsigned(800, 10) when longer = '1' else limit;
  t4_2_ACC_value <= resize(t4_2_ACC_last, 16);

  service <= service_reg;
  siemens_service <= siemens_service_reg;
  t4_2_ACC <= std_logic_vector(t4_2_ACC_value);
  t3_ET <= std_logic_vector(t3_ET_last);
  t4_2_EN <= t4_2_EN_last;
  t4_2_TT <= t4_2_TT_last;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        t4_2_PRE <= to_unsigned(5, 4);
        limit <= to_unsigned(500, 10);
        service_reg <= '0';
        siemens_service_reg <= '0';
      else
        t4_2_PRE <= t4_2_PRE_next;
        limit <= limit_next;
        service_reg <= service_next;
        siemens_service_reg <= siemens_service_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_retentive_expect is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    t4_2_ACC        : in  std_logic_vector(15 downto 0);
    t3_ET           : in  std_logic_vector(31 downto 0);
    service         : in  std_logic;
    siemens_service : in  std_logic;
    t4_2_EN         : in  std_logic;
    t4_2_TT         : in  std_logic;
    expect_0_0      : out std_logic;
    expect_0_1      : out std_logic;
    expect_1_0      : out std_logic;
    expect_1_1      : out std_logic;
    expect_2_0      : out std_logic;
    expect_2_1      : out std_logic;
    expect_2_2      : out std_logic;
    expect_3_0      : out std_logic;
    expect_3_1      : out std_logic;
    expect_4_0      : out std_logic;
    expect_4_1      : out std_logic;
    expect_4_2      : out std_logic;
    expect_5_0      : out std_logic;
    expect_5_1      : out std_logic;
    expect_5_2      : out std_logic;
    expect_6_0      : out std_logic;
    expect_6_1      : out std_logic;
    expect_7_0      : out std_logic;
    expect_7_1      : out std_logic;
    expect_8_0      : out std_logic;
    expect_8_1      : out std_logic;
    expect_8_2      : out std_logic;
    expect_9_0      : out std_logic;
    expect_9_1      : out std_logic;
    expect_9_2      : out std_logic;
    expect_10_0     : out std_logic;
    expect_10_1     : out std_logic;
    expect_11_0     : out std_logic;
    expect_11_1     : out std_logic;
    expect_12_0     : out std_logic;
    expect_12_1     : out std_logic
  );
end entity ab_retentive_expect;

architecture rtl of ab_retentive_expect is
begin

  expect_0_0 <= '1' when unsigned(t4_2_ACC) = 2 else '0';
  expect_0_1 <= '1' when unsigned(t3_ET) = 250 else '0';
  expect_1_0 <= not service;
  expect_1_1 <= not siemens_service;
  expect_2_0 <= service;
  expect_2_1 <= siemens_service;
  expect_2_2 <= '1' when unsigned(t4_2_ACC) = 5 else '0';
  expect_3_0 <= service;
  expect_3_1 <= siemens_service;
  expect_4_0 <= service;
  expect_4_1 <= siemens_service;
  expect_4_2 <= t4_2_EN;
  expect_5_0 <= not service;
  expect_5_1 <= not siemens_service;
  expect_5_2 <= '1' when unsigned(t3_ET) = 0 else '0';
  expect_6_0 <= not service;
  expect_6_1 <= not siemens_service;
  expect_7_0 <= service;
  expect_7_1 <= siemens_service;
  expect_8_0 <= not siemens_service;
  expect_8_1 <= '1' when unsigned(t4_2_ACC) = 0 else '0';
  expect_8_2 <= '1' when unsigned(t3_ET) = 0 else '0';
  expect_9_0 <= not t4_2_EN;
  expect_9_1 <= not t4_2_TT;
  expect_9_2 <= '1' when unsigned(t4_2_ACC) = 0 else '0';
  expect_10_0 <= t4_2_EN;
  expect_10_1 <= t4_2_TT;
  expect_11_0 <= service;
  expect_11_1 <= not siemens_service;
  expect_12_0 <= siemens_service;
  expect_12_1 <= '1' when unsigned(t4_2_ACC) = 5 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity ab_retentive_tb is
end entity;

architecture tests of ab_retentive_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal pump : std_logic := '0';
  signal reset_button : std_logic := '0';
  signal longer : std_logic := '0';
  signal service : std_logic;
  signal siemens_service : std_logic;
  signal t4_2_ACC : std_logic_vector(15 downto 0);
  signal t3_ET : std_logic_vector(31 downto 0);
  signal t4_2_EN : std_logic;
  signal t4_2_TT : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_2_2 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_8_2 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_9_2 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;

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
  core : entity work.ab_retentive_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      pump => pump,
      reset_button => reset_button,
      longer => longer,
      service => service,
      siemens_service => siemens_service,
      t4_2_ACC => t4_2_ACC,
      t3_ET => t3_ET,
      t4_2_EN => t4_2_EN,
      t4_2_TT => t4_2_TT
    );

  expectations : entity work.ab_retentive_expect
    port map (
      clk => clk,
      rst => rst,
      t4_2_ACC => t4_2_ACC,
      t3_ET => t3_ET,
      service => service,
      siemens_service => siemens_service,
      t4_2_EN => t4_2_EN,
      t4_2_TT => t4_2_TT,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_2_2 => expect_2_2,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_8_2 => expect_8_2,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_9_2 => expect_9_2,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1
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
      pump <= '0';
      reset_button <= '0';
      longer <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..5");

    -- time adds up over rests, to the hundredth
    failed := false;
    reset;
    pump <= '1';
    scan(1, '0');
    scan(250, '1');
    pump <= '0';
    scan(1000, '1');
    wait for 1 ns; -- ab_retentive.ladder:29
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " t4_2_ACC=" & image(t4_2_ACC)
          & " t3_ET=" & image(t3_ET));
    end if;
    pump <= '1';
    scan(1, '0');
    scan(249, '1');
    wait for 1 ns; -- ab_retentive.ladder:32
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " service=" & image(service)
          & " siemens_service=" & image(siemens_service));
    end if;
    scan(1, '1');
    wait for 1 ns; -- ab_retentive.ladder:34
    if not failed and (expect_2_0 and expect_2_1 and expect_2_2) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2)
          & " service=" & image(service)
          & " siemens_service=" & image(siemens_service)
          & " t4_2_ACC=" & image(t4_2_ACC));
    end if;
    pump <= '0';
    scan(100, '1');
    wait for 1 ns; -- ab_retentive.ladder:36
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " service=" & image(service)
          & " siemens_service=" & image(siemens_service));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - time adds up over rests, to the hundredth");
    else
      print("ok 1 - time adds up over rests, to the hundredth");
    end if;

    -- RES puts it back, and a pump that runs goes on from 0
    failed := false;
    reset;
    pump <= '1';
    scan(1, '0');
    scan(500, '1');
    wait for 1 ns; -- ab_retentive.ladder:41
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2)
          & " service=" & image(service)
          & " siemens_service=" & image(siemens_service)
          & " t4_2_EN=" & image(t4_2_EN));
    end if;
    reset_button <= '1';
    scan(1, '0');
    reset_button <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_retentive.ladder:43
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2)
          & " service=" & image(service)
          & " siemens_service=" & image(siemens_service)
          & " t3_ET=" & image(t3_ET));
    end if;
    scan(499, '1');
    wait for 1 ns; -- ab_retentive.ladder:45
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " service=" & image(service)
          & " siemens_service=" & image(siemens_service));
    end if;
    scan(1, '1');
    wait for 1 ns; -- ab_retentive.ladder:47
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " service=" & image(service)
          & " siemens_service=" & image(siemens_service));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - RES puts it back, and a pump that runs goes on from 0");
    else
      print("ok 2 - RES puts it back, and a pump that runs goes on from 0");
    end if;

    -- while the button is held neither counts
    failed := false;
    reset;
    pump <= '1';
    scan(1, '0');
    reset_button <= '1';
    scan(600, '1');
    wait for 1 ns; -- ab_retentive.ladder:52
    if not failed and (expect_8_0 and expect_8_1 and expect_8_2) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2)
          & " siemens_service=" & image(siemens_service)
          & " t4_2_ACC=" & image(t4_2_ACC)
          & " t3_ET=" & image(t3_ET));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - while the button is held neither counts");
    else
      print("ok 3 - while the button is held neither counts");
    end if;

    -- RES is a coil: the bits are off until the timer's own rung is executed again
    failed := false;
    reset;
    pump <= '1';
    scan(1, '0');
    scan(100, '1');
    reset_button <= '1';
    scan(1, '0');
    wait for 1 ns; -- ab_retentive.ladder:58
    if not failed and (expect_9_0 and expect_9_1 and expect_9_2) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2)
          & " t4_2_EN=" & image(t4_2_EN)
          & " t4_2_TT=" & image(t4_2_TT)
          & " t4_2_ACC=" & image(t4_2_ACC));
    end if;
    reset_button <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_retentive.ladder:60
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " t4_2_EN=" & image(t4_2_EN)
          & " t4_2_TT=" & image(t4_2_TT));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - RES is a coil: the bits are off until the timer's own rung is executed again");
    else
      print("ok 4 - RES is a coil: the bits are off until the timer's own rung is executed again");
    end if;

    -- a preset that grows: DN stays on, Siemens' Q goes off and the time goes on
    failed := false;
    reset;
    pump <= '1';
    scan(1, '0');
    scan(500, '1');
    longer <= '1';
    scan(1, '0');
    longer <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_retentive.ladder:66
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " service=" & image(service)
          & " siemens_service=" & image(siemens_service));
    end if;
    scan(300, '1');
    wait for 1 ns; -- ab_retentive.ladder:68
    if not failed and (expect_12_0 and expect_12_1) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
          & " siemens_service=" & image(siemens_service)
          & " t4_2_ACC=" & image(t4_2_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a preset that grows: DN stays on, Siemens' Q goes off and the time goes on");
    else
      print("ok 5 - a preset that grows: DN stays on, Siemens' Q goes off and the time goes on");
    end if;

    assert failures = 0 report integer'image(failures) & " of 5 tests failed" severity failure;
    wait;
  end process;
end architecture;
