-- Made by hotrail 0.1.0 from fan_pressure.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity fan_pressure_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    fan         : in  std_logic;
    tripped     : in  std_logic;
    expect_0_0  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_3_0  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_8_0  : out std_logic;
    expect_9_0  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_12_0 : out std_logic;
    expect_12_1 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
    expect_16_0 : out std_logic;
    expect_16_1 : out std_logic;
    expect_17_0 : out std_logic;
    expect_17_1 : out std_logic
  );
end entity fan_pressure_expect;

architecture rtl of fan_pressure_expect is
begin

  expect_0_0 <= fan;
  expect_1_0 <= fan;
  expect_1_1 <= not tripped;
  expect_2_0 <= fan;
  expect_2_1 <= not tripped;
  expect_3_0 <= fan;
  expect_4_0 <= not fan;
  expect_4_1 <= tripped;
  expect_5_0 <= not fan;
  expect_5_1 <= tripped;
  expect_6_0 <= not fan;
  expect_6_1 <= tripped;
  expect_7_0 <= fan;
  expect_7_1 <= not tripped;
  expect_8_0 <= not fan;
  expect_9_0 <= not tripped;
  expect_10_0 <= not fan;
  expect_10_1 <= not tripped;
  expect_11_0 <= fan;
  expect_11_1 <= not tripped;
  expect_12_0 <= not fan;
  expect_12_1 <= tripped;
  expect_13_0 <= not fan;
  expect_14_0 <= not fan;
  expect_15_0 <= fan;
  expect_16_0 <= not fan;
  expect_16_1 <= tripped;
  expect_17_0 <= not fan;
  expect_17_1 <= tripped;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity fan_pressure_tb is
end entity;

architecture tests of fan_pressure_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal stop : std_logic := '0';
  signal low_pressure : std_logic := '0';
  signal fan : std_logic;
  signal tripped : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_16_1 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_17_1 : std_logic;

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
  core : entity work.fan_pressure
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      stop => stop,
      low_pressure => low_pressure,
      fan => fan,
      tripped => tripped
    );

  expectations : entity work.fan_pressure_expect
    port map (
      clk => clk,
      rst => rst,
      fan => fan,
      tripped => tripped,
      expect_0_0 => expect_0_0,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_9_0 => expect_9_0,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_16_0 => expect_16_0,
      expect_16_1 => expect_16_1,
      expect_17_0 => expect_17_0,
      expect_17_1 => expect_17_1
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
      low_pressure <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..6");

    -- the pressure comes while the fan runs up
    failed := false;
    reset;
    stop <= '1';
    low_pressure <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:25
    if not failed and (expect_0_0) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0)
          & " fan=" & image(fan));
    end if;
    scan(79, '1');
    low_pressure <= '0';
    scan(1, '0');
    scan(600, '1');
    wait for 1 ns; -- fan_pressure.ladder:29
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - the pressure comes while the fan runs up");
    else
      print("ok 1 - the pressure comes while the fan runs up");
    end if;

    -- no pressure after 8 s
    failed := false;
    reset;
    stop <= '1';
    low_pressure <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(79, '1');
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:36
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    scan(1, '1');
    wait for 1 ns; -- fan_pressure.ladder:38
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " fan=" & image(fan));
    end if;
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:40
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - no pressure after 8 s");
    else
      print("ok 2 - no pressure after 8 s");
    end if;

    -- pressure lost later stops the fan at once
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(300, '1');
    low_pressure <= '1';
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:47
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    low_pressure <= '0';
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:49
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:51
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - pressure lost later stops the fan at once");
    else
      print("ok 3 - pressure lost later stops the fan at once");
    end if;

    -- after a stop the low pressure is no fault
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(300, '1');
    stop <= '0';
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:58
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " fan=" & image(fan));
    end if;
    low_pressure <= '1';
    stop <= '1';
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:60
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " tripped=" & image(tripped));
    end if;
    scan(100, '1');
    wait for 1 ns; -- fan_pressure.ladder:62
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - after a stop the low pressure is no fault");
    else
      print("ok 4 - after a stop the low pressure is no fault");
    end if;

    -- the run-up begins anew with each start
    failed := false;
    reset;
    stop <= '1';
    low_pressure <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(79, '1');
    stop <= '0';
    scan(1, '0');
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(79, '1');
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:73
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:76
    if not failed and (expect_12_0 and expect_12_1) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - the run-up begins anew with each start");
    else
      print("ok 5 - the run-up begins anew with each start");
    end if;

    -- both buttons at once, and a start button that is stuck
    failed := false;
    reset;
    start <= '1';
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:80
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " fan=" & image(fan));
    end if;
    stop <= '1';
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:82
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " fan=" & image(fan));
    end if;
    start <= '0';
    scan(1, '0');
    start <= '1';
    low_pressure <= '1';
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:85
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " fan=" & image(fan));
    end if;
    scan(80, '1');
    scan(1, '0');
    wait for 1 ns; -- fan_pressure.ladder:88
    if not failed and (expect_16_0 and expect_16_1) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0) & image(expect_16_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    scan(200, '1');
    wait for 1 ns; -- fan_pressure.ladder:90
    if not failed and (expect_17_0 and expect_17_1) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0) & image(expect_17_1)
          & " fan=" & image(fan)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - both buttons at once, and a start button that is stuck");
    else
      print("ok 6 - both buttons at once, and a start button that is stuck");
    end if;

    assert failures = 0 report integer'image(failures) & " of 6 tests failed" severity failure;
    wait;
  end process;
end architecture;
