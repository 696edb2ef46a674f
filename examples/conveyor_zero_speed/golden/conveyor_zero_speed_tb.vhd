-- Made by hotrail 0.1.0 from conveyor_zero_speed.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_zero_speed_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    motor       : in  std_logic;
    fault       : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_5_0  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_8_0  : out std_logic;
    expect_9_0  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_12_0 : out std_logic;
    expect_12_1 : out std_logic;
    expect_13_0 : out std_logic;
    expect_13_1 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic
  );
end entity conveyor_zero_speed_expect;

architecture rtl of conveyor_zero_speed_expect is
begin

  expect_0_0 <= motor;
  expect_0_1 <= not fault;
  expect_1_0 <= motor;
  expect_1_1 <= not fault;
  expect_2_0 <= not motor;
  expect_2_1 <= fault;
  expect_3_0 <= motor;
  expect_3_1 <= not fault;
  expect_4_0 <= not motor;
  expect_4_1 <= fault;
  expect_5_0 <= motor;
  expect_6_0 <= not motor;
  expect_6_1 <= fault;
  expect_7_0 <= motor;
  expect_7_1 <= not fault;
  expect_8_0 <= not fault;
  expect_9_0 <= not motor;
  expect_10_0 <= not fault;
  expect_11_0 <= not motor;
  expect_11_1 <= fault;
  expect_12_0 <= not motor;
  expect_12_1 <= fault;
  expect_13_0 <= motor;
  expect_13_1 <= not fault;
  expect_14_0 <= motor;
  expect_15_0 <= not motor;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity conveyor_zero_speed_tb is
end entity;

architecture tests of conveyor_zero_speed_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal stop : std_logic := '0';
  signal bolt : std_logic := '0';
  signal motor : std_logic;
  signal fault : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_13_1 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;

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
  core : entity work.conveyor_zero_speed
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      stop => stop,
      bolt => bolt,
      motor => motor,
      fault => fault
    );

  expectations : entity work.conveyor_zero_speed_expect
    port map (
      clk => clk,
      rst => rst,
      motor => motor,
      fault => fault,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_9_0 => expect_9_0,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_13_0 => expect_13_0,
      expect_13_1 => expect_13_1,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0
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
      start <= '0';
      stop <= '0';
      bolt <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..8");

    -- a shaft that turns
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    for round in 1 to 10 loop
      bolt <= '1';
      scan(2, '1');
      bolt <= '0';
      scan(13, '1');
    end loop;
    wait for 1 ns; -- conveyor_zero_speed.ladder:35
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - a shaft that turns");
    else
      print("ok 1 - a shaft that turns");
    end if;

    -- it stops with the bolt away from the switch
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    bolt <= '1';
    scan(2, '1');
    bolt <= '0';
    scan(1, '0');
    scan(24, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:44
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:47
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - it stops with the bolt away from the switch");
    else
      print("ok 2 - it stops with the bolt away from the switch");
    end if;

    -- it stops with the bolt in front of the switch
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    bolt <= '1';
    scan(1, '0');
    scan(24, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:55
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:58
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - it stops with the bolt in front of the switch");
    else
      print("ok 3 - it stops with the bolt in front of the switch");
    end if;

    -- it never starts to turn
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(24, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:65
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " motor=" & image(motor));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:68
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - it never starts to turn");
    else
      print("ok 4 - it never starts to turn");
    end if;

    -- a slow start is allowed
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(24, '1');
    bolt <= '1';
    scan(1, '0');
    scan(24, '1');
    bolt <= '0';
    scan(1, '0');
    scan(24, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:79
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a slow start is allowed");
    else
      print("ok 5 - a slow start is allowed");
    end if;

    -- a shaft that stands with the motor is no fault
    failed := false;
    reset;
    stop <= '1';
    scan(100, '1');
    wait for 1 ns; -- conveyor_zero_speed.ladder:84
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " fault=" & image(fault));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(10, '1');
    stop <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:88
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " motor=" & image(motor));
    end if;
    scan(100, '1');
    wait for 1 ns; -- conveyor_zero_speed.ladder:90
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - a shaft that stands with the motor is no fault");
    else
      print("ok 6 - a shaft that stands with the motor is no fault");
    end if;

    -- a fault is kept until the next start, and a stuck button is none
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    scan(25, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:96
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    scan(100, '1');
    wait for 1 ns; -- conveyor_zero_speed.ladder:98
    if not failed and (expect_12_0 and expect_12_1) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    start <= '0';
    scan(1, '0');
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:101
    if not failed and (expect_13_0 and expect_13_1) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0) & image(expect_13_1)
          & " motor=" & image(motor)
          & " fault=" & image(fault));
    end if;
    scan(24, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:104
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " motor=" & image(motor));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - a fault is kept until the next start, and a stuck button is none");
    else
      print("ok 7 - a fault is kept until the next start, and a stuck button is none");
    end if;

    -- stop wins over start
    failed := false;
    reset;
    start <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_zero_speed.ladder:108
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " motor=" & image(motor));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 8 - stop wins over start");
    else
      print("ok 8 - stop wins over start");
    end if;

    assert failures = 0 report integer'image(failures) & " of 8 tests failed" severity failure;
    wait;
  end process;
end architecture;
