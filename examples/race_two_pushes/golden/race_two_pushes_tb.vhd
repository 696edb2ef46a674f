-- Made by hotrail 0.1.0 from race_two_pushes.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- CTU: up counter
-- Fitted to PV = 2.
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- R   _________##____
-- Q   ___######____##
-- CV  011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity race_two_pushes_test_CTU_PV2 is
  port (
    clk           : in  std_logic;
    rst           : in  std_logic;
    power         : in  std_logic;
    clear_after   : in  std_logic;
    Q             : out std_logic;
    CV_last       : out unsigned(14 downto 0);
    CV_at_least_1 : out std_logic
  );
end entity race_two_pushes_test_CTU_PV2;

architecture rtl of race_two_pushes_test_CTU_PV2 is
  signal CV : unsigned(14 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal unequal : std_logic;
  signal sum : unsigned(14 downto 0);
  signal CV_next : unsigned(14 downto 0);
  signal equal : std_logic;
begin
  condition <= not was;
  unequal <= '1' when CV /= 32767 else '0';
  sum <= CV + (to_unsigned(0, 14) & (power and condition and unequal));
  CV_next <= to_unsigned(0, 15) when clear_after = '1' else sum;
  equal <= '1' when CV = 0 else '0';

  Q <= '1' when sum >= 2 else '0';
  CV_last <= CV;
  CV_at_least_1 <= not (not (power and condition) and equal);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
        was <= '0';
      else
        CV <= CV_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 20 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity race_two_pushes_test_TON_PT20 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    power       : in  std_logic;
    clear_after : in  std_logic;
    Q           : out std_logic
  );
end entity race_two_pushes_test_TON_PT20;

architecture rtl of race_two_pushes_test_TON_PT20 is
  signal ET : unsigned(4 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(4 downto 0);
  signal choice : unsigned(4 downto 0);
  signal equal_2 : std_logic;
  signal ET_next : unsigned(4 downto 0);
begin
  condition <= power and was;
  equal <= '1' when ET = 20 else '0';
  sum <= ET + (to_unsigned(0, 4) & (tick and not equal));
  choice <= sum when condition = '1' else to_unsigned(0, 5);
  equal_2 <= '1' when ET = 19 else '0';
  ET_next <= to_unsigned(0, 5) when clear_after = '1' else choice;

  Q <= condition and ((tick and equal_2) or equal);

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

entity race_two_pushes_test is
  port (
    clk       : in  std_logic;
    rst       : in  std_logic;
    tick      : in  std_logic;
    button    : in  std_logic;
    clear     : in  std_logic;
    won       : out std_logic;
    pushes_CV : out std_logic_vector(15 downto 0)
  );
end entity race_two_pushes_test;

architecture rtl of race_two_pushes_test is
  signal won_reg : std_logic := '0';
  signal pushes_Q : std_logic;
  signal pushes_CV_last : unsigned(14 downto 0);
  signal pushes_CV_at_least_1 : std_logic;
  signal time_Q : std_logic;
  signal won_rung3 : std_logic;
  signal rung4_power : std_logic;
  signal won_next : std_logic;
  signal pushes_CV_value : unsigned(15 downto 0);
  signal pushes_clear_after : std_logic;
  signal time_clear_after : std_logic;
begin

  -- rung 1 "count the pushes", race_two_pushes.ladder:10

  -- rung 2 "the time runs from the first push on", race_two_pushes.ladder:13

  -- rung 3 "two pushes before the time is up", race_two_pushes.ladder:16
  won_rung3 <= (pushes_Q and not time_Q) or won_reg;

  -- rung 4 "won or lost, the next push is a first one", race_two_pushes.ladder:19
  rung4_power <= pushes_Q or time_Q;

  -- rung 5 "clear", race_two_pushes.ladder:22
  won_next <= won_rung3 and not clear;
  pushes_CV_value <= resize(pushes_CV_last, 16);
  pushes_clear_after <= rung4_power or clear;
  pushes: entity work.race_two_pushes_test_CTU_PV2
    port map (
      clk => clk,
      rst => rst,
      power => button,
      clear_after => pushes_clear_after,
      Q => pushes_Q,
      CV_last => pushes_CV_last,
      CV_at_least_1 => pushes_CV_at_least_1
    );
  time_clear_after <= rung4_power or clear;
  time_u: entity work.race_two_pushes_test_TON_PT20
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pushes_CV_at_least_1,
      clear_after => time_clear_after,
      Q => time_Q
    );

  won <= won_reg;
  pushes_CV <= std_logic_vector(pushes_CV_value);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        won_reg <= '0';
      else
        won_reg <= won_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity race_two_pushes_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    won         : in  std_logic;
    pushes_CV   : in  std_logic_vector(15 downto 0);
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_1_0  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_4_0  : out std_logic;
    expect_5_0  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_14_1 : out std_logic;
    expect_15_0 : out std_logic;
    expect_16_0 : out std_logic;
    expect_16_1 : out std_logic
  );
end entity race_two_pushes_expect;

architecture rtl of race_two_pushes_expect is
begin

  expect_0_0 <= not won;
  expect_0_1 <= '1' when unsigned(pushes_CV) = 1 else '0';
  expect_1_0 <= won;
  expect_2_0 <= '1' when unsigned(pushes_CV) = 0 else '0';
  expect_2_1 <= not won;
  expect_3_0 <= '1' when unsigned(pushes_CV) = 1 else '0';
  expect_3_1 <= not won;
  expect_4_0 <= '1' when unsigned(pushes_CV) = 1 else '0';
  expect_5_0 <= won;
  expect_6_0 <= not won;
  expect_6_1 <= '1' when unsigned(pushes_CV) = 0 else '0';
  expect_7_0 <= not won;
  expect_7_1 <= '1' when unsigned(pushes_CV) = 1 else '0';
  expect_8_0 <= not won;
  expect_8_1 <= '1' when unsigned(pushes_CV) = 0 else '0';
  expect_9_0 <= not won;
  expect_9_1 <= '1' when unsigned(pushes_CV) = 0 else '0';
  expect_10_0 <= won;
  expect_10_1 <= '1' when unsigned(pushes_CV) = 0 else '0';
  expect_11_0 <= won;
  expect_12_0 <= won;
  expect_13_0 <= not won;
  expect_14_0 <= not won;
  expect_14_1 <= '1' when unsigned(pushes_CV) = 1 else '0';
  expect_15_0 <= won;
  expect_16_0 <= not won;
  expect_16_1 <= '1' when unsigned(pushes_CV) = 0 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity race_two_pushes_tb is
end entity;

architecture tests of race_two_pushes_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal button : std_logic := '0';
  signal clear : std_logic := '0';
  signal won : std_logic;
  signal pushes_CV : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_14_1 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_16_1 : std_logic;

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
  core : entity work.race_two_pushes_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      button => button,
      clear => clear,
      won => won,
      pushes_CV => pushes_CV
    );

  expectations : entity work.race_two_pushes_expect
    port map (
      clk => clk,
      rst => rst,
      won => won,
      pushes_CV => pushes_CV,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_14_1 => expect_14_1,
      expect_15_0 => expect_15_0,
      expect_16_0 => expect_16_0,
      expect_16_1 => expect_16_1
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
      button <= '0';
      clear <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..7");

    -- the second push in the last moment
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(19, '1');
    wait for 1 ns; -- race_two_pushes.ladder:28
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " won=" & image(won)
          & " pushes_CV=" & image(pushes_CV));
    end if;
    button <= '1';
    scan(1, '0');
    wait for 1 ns; -- race_two_pushes.ladder:30
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - the second push in the last moment");
    else
      print("ok 1 - the second push in the last moment");
    end if;

    -- the second push a moment too late is a first one
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(20, '1');
    wait for 1 ns; -- race_two_pushes.ladder:35
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " pushes_CV=" & image(pushes_CV)
          & " won=" & image(won));
    end if;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_two_pushes.ladder:37
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " pushes_CV=" & image(pushes_CV)
          & " won=" & image(won));
    end if;
    scan(19, '1');
    wait for 1 ns; -- race_two_pushes.ladder:39
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " pushes_CV=" & image(pushes_CV));
    end if;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_two_pushes.ladder:41
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - the second push a moment too late is a first one");
    else
      print("ok 2 - the second push a moment too late is a first one");
    end if;

    -- a push with the tick that ends the time is too late
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(19, '1');
    button <= '1';
    scan(1, '1');
    wait for 1 ns; -- race_two_pushes.ladder:47
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " won=" & image(won)
          & " pushes_CV=" & image(pushes_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a push with the tick that ends the time is too late");
    else
      print("ok 3 - a push with the tick that ends the time is too late");
    end if;

    -- a button that is held is pushed once
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    scan(19, '1');
    wait for 1 ns; -- race_two_pushes.ladder:52
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " won=" & image(won)
          & " pushes_CV=" & image(pushes_CV));
    end if;
    scan(1, '1');
    wait for 1 ns; -- race_two_pushes.ladder:54
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " won=" & image(won)
          & " pushes_CV=" & image(pushes_CV));
    end if;
    scan(100, '1');
    wait for 1 ns; -- race_two_pushes.ladder:56
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " won=" & image(won)
          & " pushes_CV=" & image(pushes_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a button that is held is pushed once");
    else
      print("ok 4 - a button that is held is pushed once");
    end if;

    -- a race that is won stays won
    failed := false;
    reset;
    for round in 1 to 2 loop
      button <= '1';
      scan(1, '0');
      button <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- race_two_pushes.ladder:60
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " won=" & image(won)
          & " pushes_CV=" & image(pushes_CV));
    end if;
    scan(100, '1');
    wait for 1 ns; -- race_two_pushes.ladder:62
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " won=" & image(won));
    end if;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(100, '1');
    wait for 1 ns; -- race_two_pushes.ladder:65
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " won=" & image(won));
    end if;
    clear <= '1';
    scan(1, '0');
    clear <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_two_pushes.ladder:67
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a race that is won stays won");
    else
      print("ok 5 - a race that is won stays won");
    end if;

    -- clear in the middle of a race ends it
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(10, '1');
    clear <= '1';
    scan(1, '0');
    clear <= '0';
    scan(1, '0');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_two_pushes.ladder:74
    if not failed and (expect_14_0 and expect_14_1) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0) & image(expect_14_1)
          & " won=" & image(won)
          & " pushes_CV=" & image(pushes_CV));
    end if;
    scan(19, '1');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_two_pushes.ladder:77
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - clear in the middle of a race ends it");
    else
      print("ok 6 - clear in the middle of a race ends it");
    end if;

    -- clear wins over a push
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    button <= '1';
    clear <= '1';
    scan(1, '0');
    wait for 1 ns; -- race_two_pushes.ladder:82
    if not failed and (expect_16_0 and expect_16_1) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0) & image(expect_16_1)
          & " won=" & image(won)
          & " pushes_CV=" & image(pushes_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - clear wins over a push");
    else
      print("ok 7 - clear wins over a push");
    end if;

    assert failures = 0 report integer'image(failures) & " of 7 tests failed" severity failure;
    wait;
  end process;
end architecture;
