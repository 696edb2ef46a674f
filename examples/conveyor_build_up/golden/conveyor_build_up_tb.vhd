-- Made by hotrail 0.1.0 from conveyor_build_up.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_build_up_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    conveyor_2  : in  std_logic;
    conveyor_1  : in  std_logic;
    build_up    : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_1_0  : out std_logic;
    expect_2_0  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_6_2  : out std_logic;
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
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_14_1 : out std_logic;
    expect_15_0 : out std_logic;
    expect_15_1 : out std_logic;
    expect_16_0 : out std_logic;
    expect_16_1 : out std_logic
  );
end entity conveyor_build_up_expect;

architecture rtl of conveyor_build_up_expect is
begin

  expect_0_0 <= conveyor_2;
  expect_0_1 <= not conveyor_1;
  expect_1_0 <= not conveyor_1;
  expect_2_0 <= conveyor_1;
  expect_3_0 <= not conveyor_1;
  expect_3_1 <= conveyor_2;
  expect_4_0 <= conveyor_1;
  expect_4_1 <= not build_up;
  expect_5_0 <= conveyor_1;
  expect_5_1 <= not build_up;
  expect_6_0 <= build_up;
  expect_6_1 <= not conveyor_1;
  expect_6_2 <= conveyor_2;
  expect_7_0 <= build_up;
  expect_7_1 <= not conveyor_1;
  expect_8_0 <= build_up;
  expect_8_1 <= not conveyor_1;
  expect_9_0 <= not build_up;
  expect_9_1 <= conveyor_1;
  expect_10_0 <= build_up;
  expect_11_0 <= build_up;
  expect_11_1 <= not conveyor_1;
  expect_12_0 <= conveyor_1;
  expect_13_0 <= not conveyor_1;
  expect_14_0 <= conveyor_1;
  expect_14_1 <= conveyor_2;
  expect_15_0 <= not conveyor_1;
  expect_15_1 <= not conveyor_2;
  expect_16_0 <= not conveyor_1;
  expect_16_1 <= not conveyor_2;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity conveyor_build_up_tb is
end entity;

architecture tests of conveyor_build_up_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal stop : std_logic := '0';
  signal eye : std_logic := '0';
  signal turning_2 : std_logic := '0';
  signal conveyor_1 : std_logic;
  signal conveyor_2 : std_logic;
  signal build_up : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_6_2 : std_logic;
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
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_14_1 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_15_1 : std_logic;
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
  core : entity work.conveyor_build_up
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      stop => stop,
      eye => eye,
      turning_2 => turning_2,
      conveyor_1 => conveyor_1,
      conveyor_2 => conveyor_2,
      build_up => build_up
    );

  expectations : entity work.conveyor_build_up_expect
    port map (
      clk => clk,
      rst => rst,
      conveyor_2 => conveyor_2,
      conveyor_1 => conveyor_1,
      build_up => build_up,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_2_0 => expect_2_0,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_6_2 => expect_6_2,
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
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_14_1 => expect_14_1,
      expect_15_0 => expect_15_0,
      expect_15_1 => expect_15_1,
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
      start <= '0';
      stop <= '0';
      eye <= '0';
      turning_2 <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..6");

    -- conveyor 1 waits until conveyor 2 turns
    failed := false;
    reset;
    stop <= '1';
    eye <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_build_up.ladder:29
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " conveyor_2=" & image(conveyor_2)
          & " conveyor_1=" & image(conveyor_1));
    end if;
    scan(20, '1');
    wait for 1 ns; -- conveyor_build_up.ladder:31
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " conveyor_1=" & image(conveyor_1));
    end if;
    turning_2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_build_up.ladder:33
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " conveyor_1=" & image(conveyor_1));
    end if;
    turning_2 <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_build_up.ladder:35
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " conveyor_1=" & image(conveyor_1)
          & " conveyor_2=" & image(conveyor_2));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - conveyor 1 waits until conveyor 2 turns");
    else
      print("ok 1 - conveyor 1 waits until conveyor 2 turns");
    end if;

    -- pieces that pass
    failed := false;
    reset;
    stop <= '1';
    eye <= '1';
    turning_2 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    for round in 1 to 5 loop
      eye <= '0';
      scan(1, '0');
      scan(29, '1');
      wait for 1 ns; -- conveyor_build_up.ladder:43
      if not failed and (expect_4_0 and expect_4_1) /= '1' then
        failed := true;
        print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
            & " conveyor_1=" & image(conveyor_1)
            & " build_up=" & image(build_up));
      end if;
      eye <= '1';
      scan(1, '0');
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 2 - pieces that pass");
    else
      print("ok 2 - pieces that pass");
    end if;

    -- a pile, and its end
    failed := false;
    reset;
    stop <= '1';
    eye <= '1';
    turning_2 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    eye <= '0';
    scan(1, '0');
    scan(29, '1');
    wait for 1 ns; -- conveyor_build_up.ladder:52
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " conveyor_1=" & image(conveyor_1)
          & " build_up=" & image(build_up));
    end if;
    scan(1, '1');
    wait for 1 ns; -- conveyor_build_up.ladder:54
    if not failed and (expect_6_0 and expect_6_1 and expect_6_2) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2)
          & " build_up=" & image(build_up)
          & " conveyor_1=" & image(conveyor_1)
          & " conveyor_2=" & image(conveyor_2));
    end if;
    scan(200, '1');
    wait for 1 ns; -- conveyor_build_up.ladder:56
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " build_up=" & image(build_up)
          & " conveyor_1=" & image(conveyor_1));
    end if;
    eye <= '1';
    scan(1, '0');
    scan(49, '1');
    wait for 1 ns; -- conveyor_build_up.ladder:59
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " build_up=" & image(build_up)
          & " conveyor_1=" & image(conveyor_1));
    end if;
    scan(1, '1');
    wait for 1 ns; -- conveyor_build_up.ladder:61
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " build_up=" & image(build_up)
          & " conveyor_1=" & image(conveyor_1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a pile, and its end");
    else
      print("ok 3 - a pile, and its end");
    end if;

    -- a pile that lets light through for moments is still a pile
    failed := false;
    reset;
    stop <= '1';
    turning_2 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(30, '1');
    wait for 1 ns; -- conveyor_build_up.ladder:67
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " build_up=" & image(build_up));
    end if;
    for round in 1 to 4 loop
      eye <= '1';
      scan(1, '0');
      scan(49, '1');
      eye <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- conveyor_build_up.ladder:73
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " build_up=" & image(build_up)
          & " conveyor_1=" & image(conveyor_1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a pile that lets light through for moments is still a pile");
    else
      print("ok 4 - a pile that lets light through for moments is still a pile");
    end if;

    -- a dead photo-eye stops conveyor 1
    failed := false;
    reset;
    stop <= '1';
    eye <= '1';
    turning_2 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(100, '1');
    wait for 1 ns; -- conveyor_build_up.ladder:79
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " conveyor_1=" & image(conveyor_1));
    end if;
    eye <= '0';
    scan(31, '1');
    wait for 1 ns; -- conveyor_build_up.ladder:82
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " conveyor_1=" & image(conveyor_1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a dead photo-eye stops conveyor 1");
    else
      print("ok 5 - a dead photo-eye stops conveyor 1");
    end if;

    -- stop ends both, and wins over start
    failed := false;
    reset;
    stop <= '1';
    eye <= '1';
    turning_2 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_build_up.ladder:87
    if not failed and (expect_14_0 and expect_14_1) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0) & image(expect_14_1)
          & " conveyor_1=" & image(conveyor_1)
          & " conveyor_2=" & image(conveyor_2));
    end if;
    start <= '1';
    stop <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_build_up.ladder:89
    if not failed and (expect_15_0 and expect_15_1) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0) & image(expect_15_1)
          & " conveyor_1=" & image(conveyor_1)
          & " conveyor_2=" & image(conveyor_2));
    end if;
    stop <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_build_up.ladder:91
    if not failed and (expect_16_0 and expect_16_1) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0) & image(expect_16_1)
          & " conveyor_1=" & image(conveyor_1)
          & " conveyor_2=" & image(conveyor_2));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - stop ends both, and wins over start");
    else
      print("ok 6 - stop ends both, and wins over start");
    end if;

    assert failures = 0 report integer'image(failures) & " of 6 tests failed" severity failure;
    wait;
  end process;
end architecture;
