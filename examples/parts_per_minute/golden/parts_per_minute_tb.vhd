-- Made by hotrail 0.1.0 from parts_per_minute.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity parts_per_minute_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    parts       : in  std_logic_vector(15 downto 0);
    done        : in  std_logic;
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
    expect_8_1  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_14_1 : out std_logic
  );
end entity parts_per_minute_expect;

architecture rtl of parts_per_minute_expect is
begin

  expect_0_0 <= '1' when unsigned(parts) = 0 else '0';
  expect_1_0 <= not done;
  expect_1_1 <= '1' when unsigned(parts) = 5 else '0';
  expect_2_0 <= not done;
  expect_2_1 <= '1' when unsigned(parts) = 6 else '0';
  expect_3_0 <= done;
  expect_4_0 <= done;
  expect_4_1 <= '1' when unsigned(parts) = 6 else '0';
  expect_5_0 <= done;
  expect_5_1 <= '1' when unsigned(parts) = 5 else '0';
  expect_6_0 <= not done;
  expect_6_1 <= '1' when unsigned(parts) = 0 else '0';
  expect_7_0 <= not done;
  expect_7_1 <= '1' when unsigned(parts) = 1 else '0';
  expect_8_0 <= done;
  expect_8_1 <= '1' when unsigned(parts) = 1 else '0';
  expect_9_0 <= '1' when unsigned(parts) = 0 else '0';
  expect_9_1 <= not done;
  expect_10_0 <= not done;
  expect_11_0 <= done;
  expect_12_0 <= '1' when unsigned(parts) = 0 else '0';
  expect_13_0 <= '1' when unsigned(parts) = 1 else '0';
  expect_14_0 <= done;
  expect_14_1 <= '1' when unsigned(parts) = 1 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity parts_per_minute_tb is
end entity;

architecture tests of parts_per_minute_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal sensor : std_logic := '0';
  signal S : std_logic := '0';
  signal parts : std_logic_vector(15 downto 0);
  signal done : std_logic;
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
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;
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
  core : entity work.parts_per_minute
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      sensor => sensor,
      S => S,
      parts => parts,
      done => done
    );

  expectations : entity work.parts_per_minute_expect
    port map (
      clk => clk,
      rst => rst,
      parts => parts,
      done => done,
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
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0,
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
      sensor <= '0';
      S <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..5");

    -- parts of one minute and no others
    failed := false;
    reset;
    for round in 1 to 3 loop
      sensor <= '1';
      scan(1, '0');
      sensor <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- parts_per_minute.ladder:22
    if not failed and (expect_0_0) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0)
          & " parts=" & image(parts));
    end if;
    S <= '1';
    scan(1, '0');
    for round in 1 to 5 loop
      sensor <= '1';
      scan(1, '0');
      sensor <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- parts_per_minute.ladder:25
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " done=" & image(done)
          & " parts=" & image(parts));
    end if;
    scan(59, '1');
    sensor <= '1';
    scan(1, '0');
    sensor <= '0';
    scan(1, '0');
    wait for 1 ns; -- parts_per_minute.ladder:28
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " done=" & image(done)
          & " parts=" & image(parts));
    end if;
    scan(1, '1');
    wait for 1 ns; -- parts_per_minute.ladder:30
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " done=" & image(done));
    end if;
    for round in 1 to 7 loop
      sensor <= '1';
      scan(1, '0');
      sensor <= '0';
      scan(1, '0');
    end loop;
    scan(600, '1');
    wait for 1 ns; -- parts_per_minute.ladder:33
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " done=" & image(done)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - parts of one minute and no others");
    else
      print("ok 1 - parts of one minute and no others");
    end if;

    -- open and closed again: another minute
    failed := false;
    reset;
    S <= '1';
    scan(1, '0');
    for round in 1 to 5 loop
      sensor <= '1';
      scan(1, '0');
      sensor <= '0';
      scan(1, '0');
    end loop;
    scan(60, '1');
    wait for 1 ns; -- parts_per_minute.ladder:39
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " done=" & image(done)
          & " parts=" & image(parts));
    end if;
    S <= '0';
    scan(1, '0');
    wait for 1 ns; -- parts_per_minute.ladder:41
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " done=" & image(done)
          & " parts=" & image(parts));
    end if;
    for round in 1 to 2 loop
      sensor <= '1';
      scan(1, '0');
      sensor <= '0';
      scan(1, '0');
    end loop;
    S <= '1';
    scan(1, '0');
    sensor <= '1';
    scan(1, '0');
    sensor <= '0';
    scan(1, '0');
    scan(59, '1');
    wait for 1 ns; -- parts_per_minute.ladder:46
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " done=" & image(done)
          & " parts=" & image(parts));
    end if;
    scan(1, '1');
    wait for 1 ns; -- parts_per_minute.ladder:48
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " done=" & image(done)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - open and closed again: another minute");
    else
      print("ok 2 - open and closed again: another minute");
    end if;

    -- opened before the minute is over
    failed := false;
    reset;
    S <= '1';
    scan(1, '0');
    for round in 1 to 5 loop
      sensor <= '1';
      scan(1, '0');
      sensor <= '0';
      scan(1, '0');
    end loop;
    scan(59, '1');
    S <= '0';
    scan(1, '0');
    wait for 1 ns; -- parts_per_minute.ladder:55
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " parts=" & image(parts)
          & " done=" & image(done));
    end if;
    S <= '1';
    scan(1, '0');
    scan(59, '1');
    wait for 1 ns; -- parts_per_minute.ladder:58
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " done=" & image(done));
    end if;
    scan(1, '1');
    wait for 1 ns; -- parts_per_minute.ladder:60
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " done=" & image(done));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - opened before the minute is over");
    else
      print("ok 3 - opened before the minute is over");
    end if;

    -- a part in front of the sensor when S closes is not counted
    failed := false;
    reset;
    sensor <= '1';
    scan(1, '0');
    S <= '1';
    scan(1, '0');
    scan(1, '1');
    wait for 1 ns; -- parts_per_minute.ladder:66
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a part in front of the sensor when S closes is not counted");
    else
      print("ok 4 - a part in front of the sensor when S closes is not counted");
    end if;

    -- a part that comes with S is, one that comes with the last tick is not
    failed := false;
    reset;
    sensor <= '1';
    S <= '1';
    scan(1, '0');
    wait for 1 ns; -- parts_per_minute.ladder:70
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " parts=" & image(parts));
    end if;
    sensor <= '0';
    scan(59, '1');
    sensor <= '1';
    scan(1, '1');
    wait for 1 ns; -- parts_per_minute.ladder:74
    if not failed and (expect_14_0 and expect_14_1) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0) & image(expect_14_1)
          & " done=" & image(done)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a part that comes with S is, one that comes with the last tick is not");
    else
      print("ok 5 - a part that comes with S is, one that comes with the last tick is not");
    end if;

    assert failures = 0 report integer'image(failures) & " of 5 tests failed" severity failure;
    wait;
  end process;
end architecture;
