-- Made by hotrail 0.1.0 from pump_pressure.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity pump_pressure_expect is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    pump         : in  std_logic;
    low_pressure : in  std_logic;
    tripped      : in  std_logic;
    expect_0_0   : out std_logic;
    expect_0_1   : out std_logic;
    expect_1_0   : out std_logic;
    expect_1_1   : out std_logic;
    expect_2_0   : out std_logic;
    expect_2_1   : out std_logic;
    expect_3_0   : out std_logic;
    expect_3_1   : out std_logic;
    expect_4_0   : out std_logic;
    expect_4_1   : out std_logic;
    expect_5_0   : out std_logic;
    expect_5_1   : out std_logic;
    expect_5_2   : out std_logic;
    expect_6_0   : out std_logic;
    expect_6_1   : out std_logic;
    expect_7_0   : out std_logic;
    expect_7_1   : out std_logic;
    expect_8_0   : out std_logic;
    expect_9_0   : out std_logic;
    expect_9_1   : out std_logic;
    expect_10_0  : out std_logic;
    expect_10_1  : out std_logic;
    expect_11_0  : out std_logic;
    expect_12_0  : out std_logic;
    expect_13_0  : out std_logic;
    expect_14_0  : out std_logic;
    expect_15_0  : out std_logic;
    expect_16_0  : out std_logic;
    expect_16_1  : out std_logic;
    expect_17_0  : out std_logic;
    expect_17_1  : out std_logic;
    expect_18_0  : out std_logic;
    expect_18_1  : out std_logic;
    expect_19_0  : out std_logic;
    expect_19_1  : out std_logic
  );
end entity pump_pressure_expect;

architecture rtl of pump_pressure_expect is
begin

  expect_0_0 <= pump;
  expect_0_1 <= low_pressure;
  expect_1_0 <= pump;
  expect_1_1 <= not low_pressure;
  expect_2_0 <= pump;
  expect_2_1 <= not tripped;
  expect_3_0 <= pump;
  expect_3_1 <= not tripped;
  expect_4_0 <= pump;
  expect_4_1 <= tripped;
  expect_5_0 <= not pump;
  expect_5_1 <= tripped;
  expect_5_2 <= not low_pressure;
  expect_6_0 <= not pump;
  expect_6_1 <= tripped;
  expect_7_0 <= pump;
  expect_7_1 <= low_pressure;
  expect_8_0 <= pump;
  expect_9_0 <= not pump;
  expect_9_1 <= tripped;
  expect_10_0 <= pump;
  expect_10_1 <= not tripped;
  expect_11_0 <= pump;
  expect_12_0 <= not pump;
  expect_13_0 <= not pump;
  expect_14_0 <= not pump;
  expect_15_0 <= pump;
  expect_16_0 <= not pump;
  expect_16_1 <= not low_pressure;
  expect_17_0 <= not pump;
  expect_17_1 <= tripped;
  expect_18_0 <= not pump;
  expect_18_1 <= tripped;
  expect_19_0 <= pump;
  expect_19_1 <= not tripped;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity pump_pressure_tb is
end entity;

architecture tests of pump_pressure_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal stop : std_logic := '0';
  signal pressure : std_logic := '0';
  signal pump : std_logic;
  signal low_pressure : std_logic;
  signal tripped : std_logic;
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
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_16_1 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_17_1 : std_logic;
  signal expect_18_0 : std_logic;
  signal expect_18_1 : std_logic;
  signal expect_19_0 : std_logic;
  signal expect_19_1 : std_logic;

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
  core : entity work.pump_pressure
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      stop => stop,
      pressure => pressure,
      pump => pump,
      low_pressure => low_pressure,
      tripped => tripped
    );

  expectations : entity work.pump_pressure_expect
    port map (
      clk => clk,
      rst => rst,
      pump => pump,
      low_pressure => low_pressure,
      tripped => tripped,
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
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_16_0 => expect_16_0,
      expect_16_1 => expect_16_1,
      expect_17_0 => expect_17_0,
      expect_17_1 => expect_17_1,
      expect_18_0 => expect_18_0,
      expect_18_1 => expect_18_1,
      expect_19_0 => expect_19_0,
      expect_19_1 => expect_19_1
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
      pressure <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..6");

    -- pressure in time
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:26
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " pump=" & image(pump)
          & " low_pressure=" & image(low_pressure));
    end if;
    scan(49, '1');
    pressure <= '1';
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:29
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " pump=" & image(pump)
          & " low_pressure=" & image(low_pressure));
    end if;
    scan(100, '1');
    wait for 1 ns; -- pump_pressure.ladder:31
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - pressure in time");
    else
      print("ok 1 - pressure in time");
    end if;

    -- no pressure: the pump stops 5 s after the start
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(49, '1');
    wait for 1 ns; -- pump_pressure.ladder:37
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped));
    end if;
    scan(1, '1');
    wait for 1 ns; -- pump_pressure.ladder:39
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped));
    end if;
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:41
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped)
          & " low_pressure=" & image(low_pressure));
    end if;
    scan(50, '1');
    wait for 1 ns; -- pump_pressure.ladder:43
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - no pressure: the pump stops 5 s after the start");
    else
      print("ok 2 - no pressure: the pump stops 5 s after the start");
    end if;

    -- pressure lost later: again 5 s
    failed := false;
    reset;
    stop <= '1';
    pressure <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(200, '1');
    pressure <= '0';
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:50
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " pump=" & image(pump)
          & " low_pressure=" & image(low_pressure));
    end if;
    scan(49, '1');
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:53
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " pump=" & image(pump));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:56
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - pressure lost later: again 5 s");
    else
      print("ok 3 - pressure lost later: again 5 s");
    end if;

    -- pressure that flutters does not add up
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    for round in 1 to 3 loop
      scan(49, '1');
      pressure <= '1';
      scan(1, '0');
      pressure <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- pump_pressure.ladder:66
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped));
    end if;
    scan(49, '1');
    wait for 1 ns; -- pump_pressure.ladder:68
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " pump=" & image(pump));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:71
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " pump=" & image(pump));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - pressure that flutters does not add up");
    else
      print("ok 4 - pressure that flutters does not add up");
    end if;

    -- stop wins over start and needs no pressure
    failed := false;
    reset;
    start <= '1';
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:75
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " pump=" & image(pump));
    end if;
    stop <= '1';
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:77
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " pump=" & image(pump));
    end if;
    start <= '0';
    scan(1, '0');
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:80
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " pump=" & image(pump));
    end if;
    stop <= '0';
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:82
    if not failed and (expect_16_0 and expect_16_1) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0) & image(expect_16_1)
          & " pump=" & image(pump)
          & " low_pressure=" & image(low_pressure));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - stop wins over start and needs no pressure");
    else
      print("ok 5 - stop wins over start and needs no pressure");
    end if;

    -- a start button that got stuck does not start the pump again and again
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    scan(50, '1');
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:89
    if not failed and (expect_17_0 and expect_17_1) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0) & image(expect_17_1)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped));
    end if;
    scan(100, '1');
    wait for 1 ns; -- pump_pressure.ladder:91
    if not failed and (expect_18_0 and expect_18_1) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0) & image(expect_18_1)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped));
    end if;
    start <= '0';
    scan(1, '0');
    start <= '1';
    scan(1, '0');
    wait for 1 ns; -- pump_pressure.ladder:94
    if not failed and (expect_19_0 and expect_19_1) /= '1' then
      failed := true;
      print("# failed expectation 19 conducts " & image(expect_19_0) & image(expect_19_1)
          & " pump=" & image(pump)
          & " tripped=" & image(tripped));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - a start button that got stuck does not start the pump again and again");
    else
      print("ok 6 - a start button that got stuck does not start the pump again and again");
    end if;

    assert failures = 0 report integer'image(failures) & " of 6 tests failed" severity failure;
    wait;
  end process;
end architecture;
