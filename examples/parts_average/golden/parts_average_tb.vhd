-- Made by hotrail 0.1.0 from parts_average.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity parts_average_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    last_minute : in  std_logic_vector(15 downto 0);
    average_10  : in  std_logic_vector(15 downto 0);
    average_60  : in  std_logic_vector(15 downto 0);
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_1_2  : out std_logic;
    expect_2_0  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_3_2  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_4_2  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_6_0  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_12_0 : out std_logic;
    expect_12_1 : out std_logic;
    expect_12_2 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_14_1 : out std_logic;
    expect_15_0 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic
  );
end entity parts_average_expect;

architecture rtl of parts_average_expect is
begin

  expect_0_0 <= '1' when unsigned(last_minute) = 0 else '0';
  expect_0_1 <= '1' when unsigned(average_10) = 0 else '0';
  expect_0_2 <= '1' when unsigned(average_60) = 0 else '0';
  expect_1_0 <= '1' when unsigned(last_minute) = 7 else '0';
  expect_1_1 <= '1' when unsigned(average_10) = 7 else '0';
  expect_1_2 <= '1' when unsigned(average_60) = 7 else '0';
  expect_2_0 <= '1' when unsigned(last_minute) = 7 else '0';
  expect_3_0 <= '1' when unsigned(last_minute) = 0 else '0';
  expect_3_1 <= '1' when unsigned(average_10) = 4 else '0';
  expect_3_2 <= '1' when unsigned(average_60) = 4 else '0';
  expect_4_0 <= '1' when unsigned(last_minute) = 0 else '0';
  expect_4_1 <= '1' when unsigned(average_10) = 6 else '0';
  expect_4_2 <= '1' when unsigned(average_60) = 6 else '0';
  expect_5_0 <= '1' when unsigned(average_10) = 3 else '0';
  expect_5_1 <= '1' when unsigned(average_60) = 3 else '0';
  expect_6_0 <= '1' when unsigned(average_10) = 3 else '0';
  expect_7_0 <= '1' when unsigned(average_10) = 2 else '0';
  expect_7_1 <= '1' when unsigned(average_60) = 3 else '0';
  expect_8_0 <= '1' when unsigned(average_10) = 1 else '0';
  expect_8_1 <= '1' when unsigned(average_60) = 3 else '0';
  expect_9_0 <= '1' when unsigned(average_10) = 0 else '0';
  expect_9_1 <= '1' when unsigned(average_60) = 2 else '0';
  expect_10_0 <= '1' when unsigned(average_60) = 60 else '0';
  expect_11_0 <= '1' when unsigned(average_10) = 0 else '0';
  expect_11_1 <= '1' when unsigned(average_60) = 1 else '0';
  expect_12_0 <= '1' when unsigned(last_minute) = 30 else '0';
  expect_12_1 <= '1' when unsigned(average_10) = 3 else '0';
  expect_12_2 <= '1' when unsigned(average_60) = 1 else '0';
  expect_13_0 <= '1' when unsigned(average_60) = 1 else '0';
  expect_14_0 <= '1' when unsigned(average_60) = 0 else '0';
  expect_14_1 <= '1' when unsigned(average_10) = 0 else '0';
  expect_15_0 <= '1' when unsigned(last_minute) = 1 else '0';
  expect_16_0 <= '1' when unsigned(last_minute) = 0 else '0';
  expect_17_0 <= '1' when unsigned(last_minute) = 1 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity parts_average_tb is
end entity;

architecture tests of parts_average_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal sensor : std_logic := '0';
  signal last_minute : std_logic_vector(15 downto 0);
  signal average_10 : std_logic_vector(15 downto 0);
  signal average_60 : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_12_2 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_14_1 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_17_0 : std_logic;

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
  core : entity work.parts_average
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      sensor => sensor,
      last_minute => last_minute,
      average_10 => average_10,
      average_60 => average_60
    );

  expectations : entity work.parts_average_expect
    port map (
      clk => clk,
      rst => rst,
      last_minute => last_minute,
      average_10 => average_10,
      average_60 => average_60,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_2_0 => expect_2_0,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_12_2 => expect_12_2,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_14_1 => expect_14_1,
      expect_15_0 => expect_15_0,
      expect_16_0 => expect_16_0,
      expect_17_0 => expect_17_0
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
      sensor <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..4");

    -- the first minute
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 7 loop
      sensor <= '1';
      scan(1, '0');
      sensor <= '0';
      scan(1, '0');
    end loop;
    scan(59, '1');
    wait for 1 ns; -- parts_average.ladder:50
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " last_minute=" & image(last_minute)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    scan(1, '1');
    wait for 1 ns; -- parts_average.ladder:52
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2)
          & " last_minute=" & image(last_minute)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    scan(59, '1');
    wait for 1 ns; -- parts_average.ladder:54
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " last_minute=" & image(last_minute));
    end if;
    scan(1, '1');
    wait for 1 ns; -- parts_average.ladder:56
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
          & " last_minute=" & image(last_minute)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - the first minute");
    else
      print("ok 1 - the first minute");
    end if;

    -- averages of the minutes that there are
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 3 loop
      for round_2 in 1 to 10 loop
        sensor <= '1';
        scan(1, '0');
        sensor <= '0';
        scan(1, '0');
      end loop;
      scan(60, '1');
    end loop;
    for round in 1 to 2 loop
      scan(60, '1');
    end loop;
    wait for 1 ns; -- parts_average.ladder:65
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2)
          & " last_minute=" & image(last_minute)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    for round in 1 to 4 loop
      scan(60, '1');
    end loop;
    wait for 1 ns; -- parts_average.ladder:67
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    scan(60, '1');
    wait for 1 ns; -- parts_average.ladder:69
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " average_10=" & image(average_10));
    end if;
    scan(60, '1');
    wait for 1 ns; -- parts_average.ladder:71
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    scan(60, '1');
    wait for 1 ns; -- parts_average.ladder:73
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    scan(60, '1');
    wait for 1 ns; -- parts_average.ladder:75
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - averages of the minutes that there are");
    else
      print("ok 2 - averages of the minutes that there are");
    end if;

    -- an hour and more
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 60 loop
      sensor <= '1';
      scan(1, '0');
      sensor <= '0';
      scan(1, '0');
    end loop;
    scan(60, '1');
    wait for 1 ns; -- parts_average.ladder:81
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " average_60=" & image(average_60));
    end if;
    scan(3540, '1');
    wait for 1 ns; -- parts_average.ladder:83
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    for round in 1 to 30 loop
      sensor <= '1';
      scan(1, '0');
      sensor <= '0';
      scan(1, '0');
    end loop;
    scan(60, '1');
    wait for 1 ns; -- parts_average.ladder:86
    if not failed and (expect_12_0 and expect_12_1 and expect_12_2) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1) & image(expect_12_2)
          & " last_minute=" & image(last_minute)
          & " average_10=" & image(average_10)
          & " average_60=" & image(average_60));
    end if;
    scan(3540, '1');
    wait for 1 ns; -- parts_average.ladder:88
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " average_60=" & image(average_60));
    end if;
    scan(60, '1');
    wait for 1 ns; -- parts_average.ladder:90
    if not failed and (expect_14_0 and expect_14_1) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0) & image(expect_14_1)
          & " average_60=" & image(average_60)
          & " average_10=" & image(average_10));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - an hour and more");
    else
      print("ok 3 - an hour and more");
    end if;

    -- a part in front of the sensor at the end of the minute is counted once, in its minute
    failed := false;
    reset;
    scan(1, '0');
    scan(59, '1');
    sensor <= '1';
    scan(1, '1');
    wait for 1 ns; -- parts_average.ladder:96
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " last_minute=" & image(last_minute));
    end if;
    scan(60, '1');
    wait for 1 ns; -- parts_average.ladder:98
    if not failed and (expect_16_0) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0)
          & " last_minute=" & image(last_minute));
    end if;
    sensor <= '0';
    scan(1, '0');
    sensor <= '1';
    scan(1, '0');
    sensor <= '0';
    scan(1, '0');
    scan(60, '1');
    wait for 1 ns; -- parts_average.ladder:102
    if not failed and (expect_17_0) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0)
          & " last_minute=" & image(last_minute));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a part in front of the sensor at the end of the minute is counted once, in its minute");
    else
      print("ok 4 - a part in front of the sensor at the end of the minute is counted once, in its minute");
    end if;

    assert failures = 0 report integer'image(failures) & " of 4 tests failed" severity failure;
    wait;
  end process;
end architecture;
