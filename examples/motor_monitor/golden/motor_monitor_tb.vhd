-- Made by hotrail 0.1.0 from motor_monitor.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity motor_monitor_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    fault       : in  std_logic;
    expect_0_0  : out std_logic;
    expect_1_0  : out std_logic;
    expect_2_0  : out std_logic;
    expect_3_0  : out std_logic;
    expect_4_0  : out std_logic;
    expect_5_0  : out std_logic;
    expect_6_0  : out std_logic;
    expect_7_0  : out std_logic;
    expect_8_0  : out std_logic;
    expect_9_0  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic;
    expect_18_0 : out std_logic;
    expect_19_0 : out std_logic;
    expect_20_0 : out std_logic;
    expect_21_0 : out std_logic;
    expect_22_0 : out std_logic;
    expect_23_0 : out std_logic;
    expect_24_0 : out std_logic;
    expect_25_0 : out std_logic
  );
end entity motor_monitor_expect;

architecture rtl of motor_monitor_expect is
begin

  expect_0_0 <= not fault;
  expect_1_0 <= not fault;
  expect_2_0 <= not fault;
  expect_3_0 <= not fault;
  expect_4_0 <= fault;
  expect_5_0 <= not fault;
  expect_6_0 <= fault;
  expect_7_0 <= not fault;
  expect_8_0 <= fault;
  expect_9_0 <= not fault;
  expect_10_0 <= fault;
  expect_11_0 <= not fault;
  expect_12_0 <= fault;
  expect_13_0 <= fault;
  expect_14_0 <= not fault;
  expect_15_0 <= fault;
  expect_16_0 <= fault;
  expect_17_0 <= fault;
  expect_18_0 <= fault;
  expect_19_0 <= not fault;
  expect_20_0 <= fault;
  expect_21_0 <= not fault;
  expect_22_0 <= fault;
  expect_23_0 <= not fault;
  expect_24_0 <= not fault;
  expect_25_0 <= fault;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity motor_monitor_tb is
end entity;

architecture tests of motor_monitor_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal S1 : std_logic := '0';
  signal turns_1 : std_logic := '0';
  signal turns_2 : std_logic := '0';
  signal turns_3 : std_logic := '0';
  signal acknowledge : std_logic := '0';
  signal fault : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_18_0 : std_logic;
  signal expect_19_0 : std_logic;
  signal expect_20_0 : std_logic;
  signal expect_21_0 : std_logic;
  signal expect_22_0 : std_logic;
  signal expect_23_0 : std_logic;
  signal expect_24_0 : std_logic;
  signal expect_25_0 : std_logic;

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
  core : entity work.motor_monitor
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      S1 => S1,
      turns_1 => turns_1,
      turns_2 => turns_2,
      turns_3 => turns_3,
      acknowledge => acknowledge,
      fault => fault
    );

  expectations : entity work.motor_monitor_expect
    port map (
      clk => clk,
      rst => rst,
      fault => fault,
      expect_0_0 => expect_0_0,
      expect_1_0 => expect_1_0,
      expect_2_0 => expect_2_0,
      expect_3_0 => expect_3_0,
      expect_4_0 => expect_4_0,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_7_0 => expect_7_0,
      expect_8_0 => expect_8_0,
      expect_9_0 => expect_9_0,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_16_0 => expect_16_0,
      expect_17_0 => expect_17_0,
      expect_18_0 => expect_18_0,
      expect_19_0 => expect_19_0,
      expect_20_0 => expect_20_0,
      expect_21_0 => expect_21_0,
      expect_22_0 => expect_22_0,
      expect_23_0 => expect_23_0,
      expect_24_0 => expect_24_0,
      expect_25_0 => expect_25_0
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
      S1 <= '0';
      turns_1 <= '0';
      turns_2 <= '0';
      turns_3 <= '0';
      acknowledge <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..9");

    -- one motor that stands is no fault
    failed := false;
    reset;
    turns_1 <= '1';
    turns_2 <= '1';
    turns_3 <= '1';
    S1 <= '1';
    scan(1, '0');
    turns_1 <= '0';
    scan(600, '1');
    wait for 1 ns; -- motor_monitor.ladder:24
    if not failed and (expect_0_0) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0)
          & " fault=" & image(fault));
    end if;
    turns_1 <= '1';
    turns_2 <= '0';
    scan(600, '1');
    wait for 1 ns; -- motor_monitor.ladder:26
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " fault=" & image(fault));
    end if;
    turns_2 <= '1';
    turns_3 <= '0';
    scan(600, '1');
    wait for 1 ns; -- motor_monitor.ladder:28
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - one motor that stands is no fault");
    else
      print("ok 1 - one motor that stands is no fault");
    end if;

    -- two for ten seconds, any two
    failed := false;
    reset;
    turns_3 <= '1';
    S1 <= '1';
    scan(1, '0');
    scan(99, '1');
    wait for 1 ns; -- motor_monitor.ladder:33
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " fault=" & image(fault));
    end if;
    scan(1, '1');
    wait for 1 ns; -- motor_monitor.ladder:35
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " fault=" & image(fault));
    end if;
    reset;
    turns_2 <= '1';
    S1 <= '1';
    scan(1, '0');
    scan(99, '1');
    wait for 1 ns; -- motor_monitor.ladder:39
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " fault=" & image(fault));
    end if;
    scan(1, '1');
    wait for 1 ns; -- motor_monitor.ladder:41
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " fault=" & image(fault));
    end if;
    reset;
    turns_1 <= '1';
    S1 <= '1';
    scan(1, '0');
    scan(99, '1');
    wait for 1 ns; -- motor_monitor.ladder:45
    if not failed and (expect_7_0) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0)
          & " fault=" & image(fault));
    end if;
    scan(1, '1');
    wait for 1 ns; -- motor_monitor.ladder:47
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - two for ten seconds, any two");
    else
      print("ok 2 - two for ten seconds, any two");
    end if;

    -- the pair may change in between
    failed := false;
    reset;
    turns_3 <= '1';
    S1 <= '1';
    scan(1, '0');
    scan(50, '1');
    turns_1 <= '1';
    turns_3 <= '0';
    scan(1, '0');
    scan(49, '1');
    wait for 1 ns; -- motor_monitor.ladder:54
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " fault=" & image(fault));
    end if;
    scan(1, '1');
    wait for 1 ns; -- motor_monitor.ladder:56
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - the pair may change in between");
    else
      print("ok 3 - the pair may change in between");
    end if;

    -- a motor that comes back for a moment starts the time anew
    failed := false;
    reset;
    turns_3 <= '1';
    S1 <= '1';
    scan(1, '0');
    scan(99, '1');
    turns_1 <= '1';
    scan(1, '0');
    turns_1 <= '0';
    scan(1, '0');
    scan(99, '1');
    wait for 1 ns; -- motor_monitor.ladder:64
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " fault=" & image(fault));
    end if;
    scan(1, '1');
    wait for 1 ns; -- motor_monitor.ladder:66
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a motor that comes back for a moment starts the time anew");
    else
      print("ok 4 - a motor that comes back for a moment starts the time anew");
    end if;

    -- all three at once
    failed := false;
    reset;
    turns_1 <= '1';
    turns_2 <= '1';
    turns_3 <= '1';
    S1 <= '1';
    scan(1, '0');
    turns_1 <= '0';
    turns_2 <= '0';
    turns_3 <= '0';
    scan(1, '0');
    wait for 1 ns; -- motor_monitor.ladder:71
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - all three at once");
    else
      print("ok 5 - all three at once");
    end if;

    -- the third one soon after the second
    failed := false;
    reset;
    turns_3 <= '1';
    S1 <= '1';
    scan(1, '0');
    scan(20, '1');
    wait for 1 ns; -- motor_monitor.ladder:76
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " fault=" & image(fault));
    end if;
    turns_3 <= '0';
    scan(1, '0');
    wait for 1 ns; -- motor_monitor.ladder:78
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - the third one soon after the second");
    else
      print("ok 6 - the third one soon after the second");
    end if;

    -- lit until it is acknowledged
    failed := false;
    reset;
    S1 <= '1';
    scan(1, '0');
    wait for 1 ns; -- motor_monitor.ladder:82
    if not failed and (expect_16_0) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0)
          & " fault=" & image(fault));
    end if;
    turns_1 <= '1';
    turns_2 <= '1';
    turns_3 <= '1';
    scan(600, '1');
    wait for 1 ns; -- motor_monitor.ladder:84
    if not failed and (expect_17_0) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0)
          & " fault=" & image(fault));
    end if;
    S1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- motor_monitor.ladder:86
    if not failed and (expect_18_0) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0)
          & " fault=" & image(fault));
    end if;
    acknowledge <= '1';
    scan(1, '0');
    acknowledge <= '0';
    scan(1, '0');
    wait for 1 ns; -- motor_monitor.ladder:88
    if not failed and (expect_19_0) /= '1' then
      failed := true;
      print("# failed expectation 19 conducts " & image(expect_19_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - lit until it is acknowledged");
    else
      print("ok 7 - lit until it is acknowledged");
    end if;

    -- a fault that is still there cannot be acknowledged, and a held button hides none
    failed := false;
    reset;
    S1 <= '1';
    scan(1, '0');
    acknowledge <= '1';
    scan(1, '0');
    wait for 1 ns; -- motor_monitor.ladder:93
    if not failed and (expect_20_0) /= '1' then
      failed := true;
      print("# failed expectation 20 conducts " & image(expect_20_0)
          & " fault=" & image(fault));
    end if;
    turns_1 <= '1';
    turns_2 <= '1';
    turns_3 <= '1';
    scan(1, '0');
    acknowledge <= '0';
    scan(1, '0');
    acknowledge <= '1';
    scan(1, '0');
    wait for 1 ns; -- motor_monitor.ladder:97
    if not failed and (expect_21_0) /= '1' then
      failed := true;
      print("# failed expectation 21 conducts " & image(expect_21_0)
          & " fault=" & image(fault));
    end if;
    turns_1 <= '0';
    turns_2 <= '0';
    turns_3 <= '0';
    scan(1, '0');
    wait for 1 ns; -- motor_monitor.ladder:99
    if not failed and (expect_22_0) /= '1' then
      failed := true;
      print("# failed expectation 22 conducts " & image(expect_22_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 8 - a fault that is still there cannot be acknowledged, and a held button hides none");
    else
      print("ok 8 - a fault that is still there cannot be acknowledged, and a held button hides none");
    end if;

    -- nothing without monitoring
    failed := false;
    reset;
    scan(200, '1');
    wait for 1 ns; -- motor_monitor.ladder:103
    if not failed and (expect_23_0) /= '1' then
      failed := true;
      print("# failed expectation 23 conducts " & image(expect_23_0)
          & " fault=" & image(fault));
    end if;
    S1 <= '1';
    turns_1 <= '1';
    scan(1, '0');
    scan(99, '1');
    wait for 1 ns; -- motor_monitor.ladder:106
    if not failed and (expect_24_0) /= '1' then
      failed := true;
      print("# failed expectation 24 conducts " & image(expect_24_0)
          & " fault=" & image(fault));
    end if;
    scan(1, '1');
    wait for 1 ns; -- motor_monitor.ladder:108
    if not failed and (expect_25_0) /= '1' then
      failed := true;
      print("# failed expectation 25 conducts " & image(expect_25_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 9 - nothing without monitoring");
    else
      print("ok 9 - nothing without monitoring");
    end if;

    assert failures = 0 report integer'image(failures) & " of 9 tests failed" severity failure;
    wait;
  end process;
end architecture;
