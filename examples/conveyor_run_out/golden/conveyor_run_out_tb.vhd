-- Made by hotrail 0.1.0 from conveyor_run_out.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_run_out_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    conveyor    : in  std_logic;
    empty       : in  std_logic;
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
    expect_9_1  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
    expect_15_1 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic;
    expect_18_0 : out std_logic;
    expect_19_0 : out std_logic;
    expect_19_1 : out std_logic;
    expect_20_0 : out std_logic
  );
end entity conveyor_run_out_expect;

architecture rtl of conveyor_run_out_expect is
begin

  expect_0_0 <= conveyor;
  expect_0_1 <= not empty;
  expect_1_0 <= conveyor;
  expect_1_1 <= not empty;
  expect_2_0 <= conveyor;
  expect_2_1 <= empty;
  expect_3_0 <= not conveyor;
  expect_3_1 <= empty;
  expect_4_0 <= conveyor;
  expect_4_1 <= empty;
  expect_5_0 <= not conveyor;
  expect_6_0 <= conveyor;
  expect_6_1 <= not empty;
  expect_7_0 <= not conveyor;
  expect_7_1 <= empty;
  expect_8_0 <= not conveyor;
  expect_9_0 <= conveyor;
  expect_9_1 <= not empty;
  expect_10_0 <= conveyor;
  expect_10_1 <= not empty;
  expect_11_0 <= not conveyor;
  expect_11_1 <= empty;
  expect_12_0 <= conveyor;
  expect_13_0 <= not conveyor;
  expect_14_0 <= not conveyor;
  expect_15_0 <= not conveyor;
  expect_15_1 <= not empty;
  expect_16_0 <= conveyor;
  expect_17_0 <= conveyor;
  expect_18_0 <= not conveyor;
  expect_19_0 <= conveyor;
  expect_19_1 <= empty;
  expect_20_0 <= not conveyor;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity conveyor_run_out_tb is
end entity;

architecture tests of conveyor_run_out_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal finish : std_logic := '0';
  signal emergency : std_logic := '0';
  signal product : std_logic := '0';
  signal wait_for_next : std_logic := '0';
  signal conveyor : std_logic;
  signal empty : std_logic;
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
  signal expect_9_1 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_15_1 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_18_0 : std_logic;
  signal expect_19_0 : std_logic;
  signal expect_19_1 : std_logic;
  signal expect_20_0 : std_logic;

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
  core : entity work.conveyor_run_out
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      finish => finish,
      emergency => emergency,
      product => product,
      wait_for_next => wait_for_next,
      conveyor => conveyor,
      empty => empty
    );

  expectations : entity work.conveyor_run_out_expect
    port map (
      clk => clk,
      rst => rst,
      conveyor => conveyor,
      empty => empty,
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
      expect_9_1 => expect_9_1,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_15_1 => expect_15_1,
      expect_16_0 => expect_16_0,
      expect_17_0 => expect_17_0,
      expect_18_0 => expect_18_0,
      expect_19_0 => expect_19_0,
      expect_19_1 => expect_19_1,
      expect_20_0 => expect_20_0
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
      finish <= '0';
      emergency <= '0';
      product <= '0';
      wait_for_next <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..7");

    -- the belt empties before it stops
    failed := false;
    reset;
    emergency <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:36
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    scan(50, '1');
    product <= '1';
    scan(10, '1');
    product <= '0';
    scan(1, '0');
    finish <= '1';
    scan(1, '0');
    finish <= '0';
    scan(1, '0');
    scan(119, '1');
    wait for 1 ns; -- conveyor_run_out.ladder:42
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    scan(1, '1');
    wait for 1 ns; -- conveyor_run_out.ladder:44
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:46
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - the belt empties before it stops");
    else
      print("ok 1 - the belt empties before it stops");
    end if;

    -- finish on an empty belt stops at once
    failed := false;
    reset;
    emergency <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(120, '1');
    wait for 1 ns; -- conveyor_run_out.ladder:52
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    finish <= '1';
    scan(1, '0');
    finish <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:54
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " conveyor=" & image(conveyor));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - finish on an empty belt stops at once");
    else
      print("ok 2 - finish on an empty belt stops at once");
    end if;

    -- after power-up nobody knows what lies on the belt
    failed := false;
    reset;
    emergency <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    finish <= '1';
    scan(1, '0');
    finish <= '0';
    scan(1, '0');
    scan(119, '1');
    wait for 1 ns; -- conveyor_run_out.ladder:61
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:64
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - after power-up nobody knows what lies on the belt");
    else
      print("ok 3 - after power-up nobody knows what lies on the belt");
    end if;

    -- the time in which the belt waits does not count
    failed := false;
    reset;
    emergency <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    product <= '1';
    scan(1, '0');
    product <= '0';
    scan(1, '0');
    finish <= '1';
    scan(1, '0');
    finish <= '0';
    scan(1, '0');
    scan(60, '1');
    for round in 1 to 3 loop
      wait_for_next <= '1';
      scan(1, '0');
      wait for 1 ns; -- conveyor_run_out.ladder:75
      if not failed and (expect_8_0) /= '1' then
        failed := true;
        print("# failed expectation 8 conducts " & image(expect_8_0)
            & " conveyor=" & image(conveyor));
      end if;
      scan(200, '1');
      wait_for_next <= '0';
      scan(1, '0');
      wait for 1 ns; -- conveyor_run_out.ladder:78
      if not failed and (expect_9_0 and expect_9_1) /= '1' then
        failed := true;
        print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
            & " conveyor=" & image(conveyor)
            & " empty=" & image(empty));
      end if;
      scan(10, '1');
    end loop;
    scan(29, '1');
    wait for 1 ns; -- conveyor_run_out.ladder:82
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:85
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - the time in which the belt waits does not count");
    else
      print("ok 4 - the time in which the belt waits does not count");
    end if;

    -- a product that comes while the belt empties has its whole time
    failed := false;
    reset;
    emergency <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    finish <= '1';
    scan(1, '0');
    finish <= '0';
    scan(1, '0');
    scan(110, '1');
    product <= '1';
    scan(1, '0');
    product <= '0';
    scan(1, '0');
    scan(119, '1');
    wait for 1 ns; -- conveyor_run_out.ladder:94
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " conveyor=" & image(conveyor));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:97
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " conveyor=" & image(conveyor));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a product that comes while the belt empties has its whole time");
    else
      print("ok 5 - a product that comes while the belt empties has its whole time");
    end if;

    -- emergency keeps what the timer knows
    failed := false;
    reset;
    emergency <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    product <= '1';
    scan(1, '0');
    product <= '0';
    scan(1, '0');
    scan(100, '1');
    emergency <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:105
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " conveyor=" & image(conveyor));
    end if;
    scan(600, '1');
    emergency <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:108
    if not failed and (expect_15_0 and expect_15_1) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0) & image(expect_15_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:110
    if not failed and (expect_16_0) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0)
          & " conveyor=" & image(conveyor));
    end if;
    finish <= '1';
    scan(1, '0');
    finish <= '0';
    scan(1, '0');
    scan(19, '1');
    wait for 1 ns; -- conveyor_run_out.ladder:113
    if not failed and (expect_17_0) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0)
          & " conveyor=" & image(conveyor));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:116
    if not failed and (expect_18_0) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0)
          & " conveyor=" & image(conveyor));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - emergency keeps what the timer knows");
    else
      print("ok 6 - emergency keeps what the timer knows");
    end if;

    -- start takes a finish back; both at once finish
    failed := false;
    reset;
    emergency <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    finish <= '1';
    scan(1, '0');
    finish <= '0';
    scan(1, '0');
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(200, '1');
    wait for 1 ns; -- conveyor_run_out.ladder:124
    if not failed and (expect_19_0 and expect_19_1) /= '1' then
      failed := true;
      print("# failed expectation 19 conducts " & image(expect_19_0) & image(expect_19_1)
          & " conveyor=" & image(conveyor)
          & " empty=" & image(empty));
    end if;
    start <= '1';
    finish <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_run_out.ladder:126
    if not failed and (expect_20_0) /= '1' then
      failed := true;
      print("# failed expectation 20 conducts " & image(expect_20_0)
          & " conveyor=" & image(conveyor));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - start takes a finish back; both at once finish");
    else
      print("ok 7 - start takes a finish back; both at once finish");
    end if;

    assert failures = 0 report integer'image(failures) & " of 7 tests failed" severity failure;
    wait;
  end process;
end architecture;
