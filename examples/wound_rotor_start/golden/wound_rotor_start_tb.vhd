-- Made by hotrail 0.1.0 from wound_rotor_start.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity wound_rotor_start_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    K1          : in  std_logic;
    K2          : in  std_logic;
    K3          : in  std_logic;
    K4          : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_0_3  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_1_2  : out std_logic;
    expect_1_3  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_2_2  : out std_logic;
    expect_2_3  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_3_2  : out std_logic;
    expect_3_3  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_4_2  : out std_logic;
    expect_4_3  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_5_2  : out std_logic;
    expect_5_3  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_6_2  : out std_logic;
    expect_6_3  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_7_2  : out std_logic;
    expect_7_3  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_8_2  : out std_logic;
    expect_8_3  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_9_2  : out std_logic;
    expect_9_3  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_10_2 : out std_logic;
    expect_10_3 : out std_logic;
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic;
    expect_12_1 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_14_1 : out std_logic;
    expect_14_2 : out std_logic;
    expect_14_3 : out std_logic;
    expect_15_0 : out std_logic;
    expect_15_1 : out std_logic;
    expect_15_2 : out std_logic;
    expect_15_3 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic;
    expect_18_0 : out std_logic;
    expect_19_0 : out std_logic;
    expect_19_1 : out std_logic
  );
end entity wound_rotor_start_expect;

architecture rtl of wound_rotor_start_expect is
begin

  expect_0_0 <= K1;
  expect_0_1 <= not K2;
  expect_0_2 <= not K3;
  expect_0_3 <= not K4;
  expect_1_0 <= K1;
  expect_1_1 <= not K2;
  expect_1_2 <= not K3;
  expect_1_3 <= not K4;
  expect_2_0 <= K1;
  expect_2_1 <= K2;
  expect_2_2 <= not K3;
  expect_2_3 <= not K4;
  expect_3_0 <= K1;
  expect_3_1 <= K2;
  expect_3_2 <= not K3;
  expect_3_3 <= not K4;
  expect_4_0 <= K1;
  expect_4_1 <= K2;
  expect_4_2 <= K3;
  expect_4_3 <= not K4;
  expect_5_0 <= K1;
  expect_5_1 <= K2;
  expect_5_2 <= K3;
  expect_5_3 <= not K4;
  expect_6_0 <= K1;
  expect_6_1 <= K2;
  expect_6_2 <= K3;
  expect_6_3 <= K4;
  expect_7_0 <= K1;
  expect_7_1 <= K2;
  expect_7_2 <= K3;
  expect_7_3 <= K4;
  expect_8_0 <= K1;
  expect_8_1 <= K2;
  expect_8_2 <= K3;
  expect_8_3 <= not K4;
  expect_9_0 <= not K1;
  expect_9_1 <= not K2;
  expect_9_2 <= not K3;
  expect_9_3 <= not K4;
  expect_10_0 <= K1;
  expect_10_1 <= not K2;
  expect_10_2 <= not K3;
  expect_10_3 <= not K4;
  expect_11_0 <= not K2;
  expect_12_0 <= K2;
  expect_12_1 <= not K3;
  expect_13_0 <= K4;
  expect_14_0 <= not K1;
  expect_14_1 <= not K2;
  expect_14_2 <= not K3;
  expect_14_3 <= not K4;
  expect_15_0 <= not K1;
  expect_15_1 <= not K2;
  expect_15_2 <= not K3;
  expect_15_3 <= not K4;
  expect_16_0 <= not K2;
  expect_17_0 <= K2;
  expect_18_0 <= not K1;
  expect_19_0 <= not K1;
  expect_19_1 <= not K2;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity wound_rotor_start_tb is
end entity;

architecture tests of wound_rotor_start_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal S0 : std_logic := '0';
  signal S1 : std_logic := '0';
  signal F1 : std_logic := '0';
  signal K1 : std_logic;
  signal K2 : std_logic;
  signal K3 : std_logic;
  signal K4 : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_0_3 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_1_3 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_2_2 : std_logic;
  signal expect_2_3 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_3_3 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_4_3 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_5_3 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_6_2 : std_logic;
  signal expect_6_3 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_7_2 : std_logic;
  signal expect_7_3 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_8_2 : std_logic;
  signal expect_8_3 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_9_2 : std_logic;
  signal expect_9_3 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_10_2 : std_logic;
  signal expect_10_3 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_14_1 : std_logic;
  signal expect_14_2 : std_logic;
  signal expect_14_3 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_15_1 : std_logic;
  signal expect_15_2 : std_logic;
  signal expect_15_3 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_18_0 : std_logic;
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
  core : entity work.wound_rotor_start
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      S0 => S0,
      S1 => S1,
      F1 => F1,
      K1 => K1,
      K2 => K2,
      K3 => K3,
      K4 => K4
    );

  expectations : entity work.wound_rotor_start_expect
    port map (
      clk => clk,
      rst => rst,
      K1 => K1,
      K2 => K2,
      K3 => K3,
      K4 => K4,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_0_3 => expect_0_3,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_1_3 => expect_1_3,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_2_2 => expect_2_2,
      expect_2_3 => expect_2_3,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_3_3 => expect_3_3,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_4_3 => expect_4_3,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_5_3 => expect_5_3,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_6_2 => expect_6_2,
      expect_6_3 => expect_6_3,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_7_2 => expect_7_2,
      expect_7_3 => expect_7_3,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_8_2 => expect_8_2,
      expect_8_3 => expect_8_3,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_9_2 => expect_9_2,
      expect_9_3 => expect_9_3,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_10_2 => expect_10_2,
      expect_10_3 => expect_10_3,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_14_1 => expect_14_1,
      expect_14_2 => expect_14_2,
      expect_14_3 => expect_14_3,
      expect_15_0 => expect_15_0,
      expect_15_1 => expect_15_1,
      expect_15_2 => expect_15_2,
      expect_15_3 => expect_15_3,
      expect_16_0 => expect_16_0,
      expect_17_0 => expect_17_0,
      expect_18_0 => expect_18_0,
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
      S0 <= '0';
      S1 <= '0';
      F1 <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..5");

    -- K2, K3 and K4 follow, each after 5 s
    failed := false;
    reset;
    S0 <= '1';
    F1 <= '1';
    S1 <= '1';
    scan(1, '0');
    S1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- wound_rotor_start.ladder:22
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2 and expect_0_3) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2) & image(expect_0_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    scan(49, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:24
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2 and expect_1_3) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2) & image(expect_1_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    scan(1, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:26
    if not failed and (expect_2_0 and expect_2_1 and expect_2_2 and expect_2_3) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2) & image(expect_2_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    scan(49, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:28
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2 and expect_3_3) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2) & image(expect_3_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    scan(1, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:30
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2 and expect_4_3) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2) & image(expect_4_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    scan(49, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:32
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2 and expect_5_3) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2) & image(expect_5_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    scan(1, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:34
    if not failed and (expect_6_0 and expect_6_1 and expect_6_2 and expect_6_3) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2) & image(expect_6_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    scan(600, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:36
    if not failed and (expect_7_0 and expect_7_1 and expect_7_2 and expect_7_3) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2) & image(expect_7_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - K2, K3 and K4 follow, each after 5 s");
    else
      print("ok 1 - K2, K3 and K4 follow, each after 5 s");
    end if;

    -- stop in the middle opens all, and a new start has all its steps
    failed := false;
    reset;
    S0 <= '1';
    F1 <= '1';
    S1 <= '1';
    scan(1, '0');
    S1 <= '0';
    scan(1, '0');
    scan(120, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:42
    if not failed and (expect_8_0 and expect_8_1 and expect_8_2 and expect_8_3) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2) & image(expect_8_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    S0 <= '0';
    scan(1, '0');
    wait for 1 ns; -- wound_rotor_start.ladder:44
    if not failed and (expect_9_0 and expect_9_1 and expect_9_2 and expect_9_3) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2) & image(expect_9_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    S0 <= '1';
    scan(1, '0');
    S1 <= '1';
    scan(1, '0');
    S1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- wound_rotor_start.ladder:47
    if not failed and (expect_10_0 and expect_10_1 and expect_10_2 and expect_10_3) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1) & image(expect_10_2) & image(expect_10_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    scan(49, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:49
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " K2=" & image(K2));
    end if;
    scan(1, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:51
    if not failed and (expect_12_0 and expect_12_1) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
          & " K2=" & image(K2)
          & " K3=" & image(K3));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - stop in the middle opens all, and a new start has all its steps");
    else
      print("ok 2 - stop in the middle opens all, and a new start has all its steps");
    end if;

    -- the overload relay opens all, and its return starts nothing
    failed := false;
    reset;
    S0 <= '1';
    F1 <= '1';
    S1 <= '1';
    scan(1, '0');
    S1 <= '0';
    scan(1, '0');
    scan(150, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:57
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " K4=" & image(K4));
    end if;
    F1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- wound_rotor_start.ladder:59
    if not failed and (expect_14_0 and expect_14_1 and expect_14_2 and expect_14_3) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0) & image(expect_14_1) & image(expect_14_2) & image(expect_14_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    F1 <= '1';
    scan(200, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:61
    if not failed and (expect_15_0 and expect_15_1 and expect_15_2 and expect_15_3) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0) & image(expect_15_1) & image(expect_15_2) & image(expect_15_3)
          & " K1=" & image(K1)
          & " K2=" & image(K2)
          & " K3=" & image(K3)
          & " K4=" & image(K4));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - the overload relay opens all, and its return starts nothing");
    else
      print("ok 3 - the overload relay opens all, and its return starts nothing");
    end if;

    -- the start button once more changes nothing
    failed := false;
    reset;
    S0 <= '1';
    F1 <= '1';
    S1 <= '1';
    scan(1, '0');
    S1 <= '0';
    scan(1, '0');
    scan(40, '1');
    S1 <= '1';
    scan(1, '0');
    S1 <= '0';
    scan(1, '0');
    scan(9, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:69
    if not failed and (expect_16_0) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0)
          & " K2=" & image(K2));
    end if;
    scan(1, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:71
    if not failed and (expect_17_0) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0)
          & " K2=" & image(K2));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - the start button once more changes nothing");
    else
      print("ok 4 - the start button once more changes nothing");
    end if;

    -- stop wins over start
    failed := false;
    reset;
    F1 <= '1';
    S1 <= '1';
    scan(1, '0');
    wait for 1 ns; -- wound_rotor_start.ladder:75
    if not failed and (expect_18_0) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0)
          & " K1=" & image(K1));
    end if;
    scan(60, '1');
    wait for 1 ns; -- wound_rotor_start.ladder:77
    if not failed and (expect_19_0 and expect_19_1) /= '1' then
      failed := true;
      print("# failed expectation 19 conducts " & image(expect_19_0) & image(expect_19_1)
          & " K1=" & image(K1)
          & " K2=" & image(K2));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - stop wins over start");
    else
      print("ok 5 - stop wins over start");
    end if;

    assert failures = 0 report integer'image(failures) & " of 5 tests failed" severity failure;
    wait;
  end process;
end architecture;
