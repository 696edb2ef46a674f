-- Made by hotrail 0.1.0 from spray_machine.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity spray_machine_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    forward     : in  std_logic;
    reverse     : in  std_logic;
    spray       : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_1_0  : out std_logic;
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
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_13_1 : out std_logic;
    expect_14_0 : out std_logic;
    expect_14_1 : out std_logic;
    expect_14_2 : out std_logic;
    expect_15_0 : out std_logic;
    expect_15_1 : out std_logic;
    expect_15_2 : out std_logic;
    expect_16_0 : out std_logic;
    expect_16_1 : out std_logic;
    expect_16_2 : out std_logic;
    expect_17_0 : out std_logic;
    expect_17_1 : out std_logic;
    expect_17_2 : out std_logic;
    expect_18_0 : out std_logic;
    expect_18_1 : out std_logic;
    expect_19_0 : out std_logic;
    expect_20_0 : out std_logic;
    expect_21_0 : out std_logic;
    expect_22_0 : out std_logic;
    expect_22_1 : out std_logic;
    expect_23_0 : out std_logic;
    expect_23_1 : out std_logic;
    expect_24_0 : out std_logic;
    expect_24_1 : out std_logic;
    expect_25_0 : out std_logic;
    expect_25_1 : out std_logic;
    expect_26_0 : out std_logic;
    expect_27_0 : out std_logic;
    expect_27_1 : out std_logic;
    expect_28_0 : out std_logic;
    expect_28_1 : out std_logic;
    expect_29_0 : out std_logic;
    expect_30_0 : out std_logic;
    expect_30_1 : out std_logic;
    expect_31_0 : out std_logic;
    expect_31_1 : out std_logic;
    expect_32_0 : out std_logic;
    expect_32_1 : out std_logic;
    expect_33_0 : out std_logic;
    expect_34_0 : out std_logic;
    expect_34_1 : out std_logic;
    expect_35_0 : out std_logic;
    expect_36_0 : out std_logic;
    expect_36_1 : out std_logic;
    expect_37_0 : out std_logic;
    expect_37_1 : out std_logic;
    expect_38_0 : out std_logic
  );
end entity spray_machine_expect;

architecture rtl of spray_machine_expect is
begin

  expect_0_0 <= forward;
  expect_0_1 <= not reverse;
  expect_0_2 <= not spray;
  expect_1_0 <= forward;
  expect_2_0 <= forward;
  expect_2_1 <= spray;
  expect_3_0 <= spray;
  expect_4_0 <= forward;
  expect_4_1 <= not spray;
  expect_5_0 <= not forward;
  expect_5_1 <= not reverse;
  expect_6_0 <= not forward;
  expect_6_1 <= not reverse;
  expect_7_0 <= reverse;
  expect_7_1 <= not forward;
  expect_8_0 <= reverse;
  expect_8_1 <= not spray;
  expect_9_0 <= reverse;
  expect_10_0 <= not reverse;
  expect_10_1 <= not forward;
  expect_11_0 <= not reverse;
  expect_11_1 <= not forward;
  expect_12_0 <= forward;
  expect_13_0 <= forward;
  expect_13_1 <= spray;
  expect_14_0 <= not forward;
  expect_14_1 <= not spray;
  expect_14_2 <= not reverse;
  expect_15_0 <= not forward;
  expect_15_1 <= not spray;
  expect_15_2 <= not reverse;
  expect_16_0 <= not reverse;
  expect_16_1 <= not forward;
  expect_16_2 <= not spray;
  expect_17_0 <= reverse;
  expect_17_1 <= not forward;
  expect_17_2 <= not spray;
  expect_18_0 <= not reverse;
  expect_18_1 <= not forward;
  expect_19_0 <= not reverse;
  expect_20_0 <= not reverse;
  expect_21_0 <= reverse;
  expect_22_0 <= not forward;
  expect_22_1 <= not reverse;
  expect_23_0 <= not forward;
  expect_23_1 <= not reverse;
  expect_24_0 <= not forward;
  expect_24_1 <= not reverse;
  expect_25_0 <= not forward;
  expect_25_1 <= reverse;
  expect_26_0 <= reverse;
  expect_27_0 <= not reverse;
  expect_27_1 <= not forward;
  expect_28_0 <= not reverse;
  expect_28_1 <= not forward;
  expect_29_0 <= spray;
  expect_30_0 <= not spray;
  expect_30_1 <= not forward;
  expect_31_0 <= not spray;
  expect_31_1 <= not forward;
  expect_32_0 <= forward;
  expect_32_1 <= not reverse;
  expect_33_0 <= reverse;
  expect_34_0 <= reverse;
  expect_34_1 <= not forward;
  expect_35_0 <= reverse;
  expect_36_0 <= not forward;
  expect_36_1 <= not reverse;
  expect_37_0 <= not forward;
  expect_37_1 <= not reverse;
  expect_38_0 <= not forward;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity spray_machine_tb is
end entity;

architecture tests of spray_machine_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal stop : std_logic := '0';
  signal home : std_logic := '0';
  signal at_end : std_logic := '0';
  signal middle : std_logic := '0';
  signal forward : std_logic;
  signal reverse : std_logic;
  signal spray : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
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
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_13_1 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_14_1 : std_logic;
  signal expect_14_2 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_15_1 : std_logic;
  signal expect_15_2 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_16_1 : std_logic;
  signal expect_16_2 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_17_1 : std_logic;
  signal expect_17_2 : std_logic;
  signal expect_18_0 : std_logic;
  signal expect_18_1 : std_logic;
  signal expect_19_0 : std_logic;
  signal expect_20_0 : std_logic;
  signal expect_21_0 : std_logic;
  signal expect_22_0 : std_logic;
  signal expect_22_1 : std_logic;
  signal expect_23_0 : std_logic;
  signal expect_23_1 : std_logic;
  signal expect_24_0 : std_logic;
  signal expect_24_1 : std_logic;
  signal expect_25_0 : std_logic;
  signal expect_25_1 : std_logic;
  signal expect_26_0 : std_logic;
  signal expect_27_0 : std_logic;
  signal expect_27_1 : std_logic;
  signal expect_28_0 : std_logic;
  signal expect_28_1 : std_logic;
  signal expect_29_0 : std_logic;
  signal expect_30_0 : std_logic;
  signal expect_30_1 : std_logic;
  signal expect_31_0 : std_logic;
  signal expect_31_1 : std_logic;
  signal expect_32_0 : std_logic;
  signal expect_32_1 : std_logic;
  signal expect_33_0 : std_logic;
  signal expect_34_0 : std_logic;
  signal expect_34_1 : std_logic;
  signal expect_35_0 : std_logic;
  signal expect_36_0 : std_logic;
  signal expect_36_1 : std_logic;
  signal expect_37_0 : std_logic;
  signal expect_37_1 : std_logic;
  signal expect_38_0 : std_logic;

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
  core : entity work.spray_machine
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      stop => stop,
      home => home,
      at_end => at_end,
      middle => middle,
      forward => forward,
      reverse => reverse,
      spray => spray
    );

  expectations : entity work.spray_machine_expect
    port map (
      clk => clk,
      rst => rst,
      forward => forward,
      reverse => reverse,
      spray => spray,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
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
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_13_1 => expect_13_1,
      expect_14_0 => expect_14_0,
      expect_14_1 => expect_14_1,
      expect_14_2 => expect_14_2,
      expect_15_0 => expect_15_0,
      expect_15_1 => expect_15_1,
      expect_15_2 => expect_15_2,
      expect_16_0 => expect_16_0,
      expect_16_1 => expect_16_1,
      expect_16_2 => expect_16_2,
      expect_17_0 => expect_17_0,
      expect_17_1 => expect_17_1,
      expect_17_2 => expect_17_2,
      expect_18_0 => expect_18_0,
      expect_18_1 => expect_18_1,
      expect_19_0 => expect_19_0,
      expect_20_0 => expect_20_0,
      expect_21_0 => expect_21_0,
      expect_22_0 => expect_22_0,
      expect_22_1 => expect_22_1,
      expect_23_0 => expect_23_0,
      expect_23_1 => expect_23_1,
      expect_24_0 => expect_24_0,
      expect_24_1 => expect_24_1,
      expect_25_0 => expect_25_0,
      expect_25_1 => expect_25_1,
      expect_26_0 => expect_26_0,
      expect_27_0 => expect_27_0,
      expect_27_1 => expect_27_1,
      expect_28_0 => expect_28_0,
      expect_28_1 => expect_28_1,
      expect_29_0 => expect_29_0,
      expect_30_0 => expect_30_0,
      expect_30_1 => expect_30_1,
      expect_31_0 => expect_31_0,
      expect_31_1 => expect_31_1,
      expect_32_0 => expect_32_0,
      expect_32_1 => expect_32_1,
      expect_33_0 => expect_33_0,
      expect_34_0 => expect_34_0,
      expect_34_1 => expect_34_1,
      expect_35_0 => expect_35_0,
      expect_36_0 => expect_36_0,
      expect_36_1 => expect_36_1,
      expect_37_0 => expect_37_0,
      expect_37_1 => expect_37_1,
      expect_38_0 => expect_38_0
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
      home <= '0';
      at_end <= '0';
      middle <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..9");

    -- a part there and back
    failed := false;
    reset;
    stop <= '1';
    home <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:30
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " forward=" & image(forward)
          & " reverse=" & image(reverse)
          & " spray=" & image(spray));
    end if;
    scan(10, '1');
    home <= '0';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:33
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " forward=" & image(forward));
    end if;
    scan(30, '1');
    middle <= '1';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:36
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " forward=" & image(forward)
          & " spray=" & image(spray));
    end if;
    scan(5, '1');
    middle <= '0';
    scan(1, '0');
    scan(14, '1');
    wait for 1 ns; -- spray_machine.ladder:40
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " spray=" & image(spray));
    end if;
    scan(1, '1');
    wait for 1 ns; -- spray_machine.ladder:42
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " forward=" & image(forward)
          & " spray=" & image(spray));
    end if;
    scan(10, '1');
    at_end <= '1';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:45
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " forward=" & image(forward)
          & " reverse=" & image(reverse));
    end if;
    scan(14, '1');
    wait for 1 ns; -- spray_machine.ladder:47
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " forward=" & image(forward)
          & " reverse=" & image(reverse));
    end if;
    scan(1, '1');
    wait for 1 ns; -- spray_machine.ladder:49
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " reverse=" & image(reverse)
          & " forward=" & image(forward));
    end if;
    at_end <= '0';
    scan(20, '1');
    middle <= '1';
    scan(10, '1');
    wait for 1 ns; -- spray_machine.ladder:52
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " reverse=" & image(reverse)
          & " spray=" & image(spray));
    end if;
    middle <= '0';
    scan(20, '1');
    wait for 1 ns; -- spray_machine.ladder:54
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " reverse=" & image(reverse));
    end if;
    home <= '1';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:56
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " reverse=" & image(reverse)
          & " forward=" & image(forward));
    end if;
    scan(100, '1');
    wait for 1 ns; -- spray_machine.ladder:58
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " reverse=" & image(reverse)
          & " forward=" & image(forward));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:60
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " forward=" & image(forward));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - a part there and back");
    else
      print("ok 1 - a part there and back");
    end if;

    -- stop in the middle: the next start brings the part home
    failed := false;
    reset;
    stop <= '1';
    home <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    home <= '0';
    scan(10, '1');
    middle <= '1';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:67
    if not failed and (expect_13_0 and expect_13_1) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0) & image(expect_13_1)
          & " forward=" & image(forward)
          & " spray=" & image(spray));
    end if;
    stop <= '0';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:69
    if not failed and (expect_14_0 and expect_14_1 and expect_14_2) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0) & image(expect_14_1) & image(expect_14_2)
          & " forward=" & image(forward)
          & " spray=" & image(spray)
          & " reverse=" & image(reverse));
    end if;
    stop <= '1';
    scan(100, '1');
    wait for 1 ns; -- spray_machine.ladder:71
    if not failed and (expect_15_0 and expect_15_1 and expect_15_2) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0) & image(expect_15_1) & image(expect_15_2)
          & " forward=" & image(forward)
          & " spray=" & image(spray)
          & " reverse=" & image(reverse));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(14, '1');
    wait for 1 ns; -- spray_machine.ladder:74
    if not failed and (expect_16_0 and expect_16_1 and expect_16_2) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0) & image(expect_16_1) & image(expect_16_2)
          & " reverse=" & image(reverse)
          & " forward=" & image(forward)
          & " spray=" & image(spray));
    end if;
    scan(1, '1');
    wait for 1 ns; -- spray_machine.ladder:76
    if not failed and (expect_17_0 and expect_17_1 and expect_17_2) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0) & image(expect_17_1) & image(expect_17_2)
          & " reverse=" & image(reverse)
          & " forward=" & image(forward)
          & " spray=" & image(spray));
    end if;
    middle <= '0';
    home <= '1';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:78
    if not failed and (expect_18_0 and expect_18_1) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0) & image(expect_18_1)
          & " reverse=" & image(reverse)
          & " forward=" & image(forward));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - stop in the middle: the next start brings the part home");
    else
      print("ok 2 - stop in the middle: the next start brings the part home");
    end if;

    -- stop at the end: the rest begins anew
    failed := false;
    reset;
    stop <= '1';
    at_end <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(14, '1');
    stop <= '0';
    scan(1, '0');
    stop <= '1';
    scan(50, '1');
    wait for 1 ns; -- spray_machine.ladder:86
    if not failed and (expect_19_0) /= '1' then
      failed := true;
      print("# failed expectation 19 conducts " & image(expect_19_0)
          & " reverse=" & image(reverse));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(14, '1');
    wait for 1 ns; -- spray_machine.ladder:89
    if not failed and (expect_20_0) /= '1' then
      failed := true;
      print("# failed expectation 20 conducts " & image(expect_20_0)
          & " reverse=" & image(reverse));
    end if;
    scan(1, '1');
    wait for 1 ns; -- spray_machine.ladder:91
    if not failed and (expect_21_0) /= '1' then
      failed := true;
      print("# failed expectation 21 conducts " & image(expect_21_0)
          & " reverse=" & image(reverse));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - stop at the end: the rest begins anew");
    else
      print("ok 3 - stop at the end: the rest begins anew");
    end if;

    -- an end switch that bounces shortens no rest and turns nothing round
    failed := false;
    reset;
    stop <= '1';
    home <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    home <= '0';
    scan(50, '1');
    at_end <= '1';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:98
    if not failed and (expect_22_0 and expect_22_1) /= '1' then
      failed := true;
      print("# failed expectation 22 conducts " & image(expect_22_0) & image(expect_22_1)
          & " forward=" & image(forward)
          & " reverse=" & image(reverse));
    end if;
    for round in 1 to 7 loop
      at_end <= '0';
      scan(1, '1');
      wait for 1 ns; -- spray_machine.ladder:101
      if not failed and (expect_23_0 and expect_23_1) /= '1' then
        failed := true;
        print("# failed expectation 23 conducts " & image(expect_23_0) & image(expect_23_1)
            & " forward=" & image(forward)
            & " reverse=" & image(reverse));
      end if;
      at_end <= '1';
      scan(1, '1');
      wait for 1 ns; -- spray_machine.ladder:103
      if not failed and (expect_24_0 and expect_24_1) /= '1' then
        failed := true;
        print("# failed expectation 24 conducts " & image(expect_24_0) & image(expect_24_1)
            & " forward=" & image(forward)
            & " reverse=" & image(reverse));
      end if;
    end loop;
    scan(1, '1');
    wait for 1 ns; -- spray_machine.ladder:106
    if not failed and (expect_25_0 and expect_25_1) /= '1' then
      failed := true;
      print("# failed expectation 25 conducts " & image(expect_25_0) & image(expect_25_1)
          & " forward=" & image(forward)
          & " reverse=" & image(reverse));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - an end switch that bounces shortens no rest and turns nothing round");
    else
      print("ok 4 - an end switch that bounces shortens no rest and turns nothing round");
    end if;

    -- a home switch that bounces ends the cycle once
    failed := false;
    reset;
    stop <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(15, '1');
    wait for 1 ns; -- spray_machine.ladder:112
    if not failed and (expect_26_0) /= '1' then
      failed := true;
      print("# failed expectation 26 conducts " & image(expect_26_0)
          & " reverse=" & image(reverse));
    end if;
    for round in 1 to 3 loop
      home <= '1';
      scan(1, '0');
      wait for 1 ns; -- spray_machine.ladder:115
      if not failed and (expect_27_0 and expect_27_1) /= '1' then
        failed := true;
        print("# failed expectation 27 conducts " & image(expect_27_0) & image(expect_27_1)
            & " reverse=" & image(reverse)
            & " forward=" & image(forward));
      end if;
      home <= '0';
      scan(1, '0');
      wait for 1 ns; -- spray_machine.ladder:117
      if not failed and (expect_28_0 and expect_28_1) /= '1' then
        failed := true;
        print("# failed expectation 28 conducts " & image(expect_28_0) & image(expect_28_1)
            & " reverse=" & image(reverse)
            & " forward=" & image(forward));
      end if;
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a home switch that bounces ends the cycle once");
    else
      print("ok 5 - a home switch that bounces ends the cycle once");
    end if;

    -- spraying ends with the forward motion
    failed := false;
    reset;
    stop <= '1';
    home <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    home <= '0';
    middle <= '1';
    scan(10, '1');
    wait for 1 ns; -- spray_machine.ladder:124
    if not failed and (expect_29_0) /= '1' then
      failed := true;
      print("# failed expectation 29 conducts " & image(expect_29_0)
          & " spray=" & image(spray));
    end if;
    at_end <= '1';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:126
    if not failed and (expect_30_0 and expect_30_1) /= '1' then
      failed := true;
      print("# failed expectation 30 conducts " & image(expect_30_0) & image(expect_30_1)
          & " spray=" & image(spray)
          & " forward=" & image(forward));
    end if;
    at_end <= '0';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:128
    if not failed and (expect_31_0 and expect_31_1) /= '1' then
      failed := true;
      print("# failed expectation 31 conducts " & image(expect_31_0) & image(expect_31_1)
          & " spray=" & image(spray)
          & " forward=" & image(forward));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - spraying ends with the forward motion");
    else
      print("ok 6 - spraying ends with the forward motion");
    end if;

    -- start once more during the motion changes nothing
    failed := false;
    reset;
    stop <= '1';
    home <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    home <= '0';
    scan(10, '1');
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:135
    if not failed and (expect_32_0 and expect_32_1) /= '1' then
      failed := true;
      print("# failed expectation 32 conducts " & image(expect_32_0) & image(expect_32_1)
          & " forward=" & image(forward)
          & " reverse=" & image(reverse));
    end if;
    at_end <= '1';
    scan(20, '1');
    wait for 1 ns; -- spray_machine.ladder:137
    if not failed and (expect_33_0) /= '1' then
      failed := true;
      print("# failed expectation 33 conducts " & image(expect_33_0)
          & " reverse=" & image(reverse));
    end if;
    at_end <= '0';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:139
    if not failed and (expect_34_0 and expect_34_1) /= '1' then
      failed := true;
      print("# failed expectation 34 conducts " & image(expect_34_0) & image(expect_34_1)
          & " reverse=" & image(reverse)
          & " forward=" & image(forward));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - start once more during the motion changes nothing");
    else
      print("ok 7 - start once more during the motion changes nothing");
    end if;

    -- a held start button makes one cycle
    failed := false;
    reset;
    stop <= '1';
    home <= '1';
    start <= '1';
    scan(1, '0');
    home <= '0';
    scan(10, '1');
    at_end <= '1';
    scan(20, '1');
    at_end <= '0';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:146
    if not failed and (expect_35_0) /= '1' then
      failed := true;
      print("# failed expectation 35 conducts " & image(expect_35_0)
          & " reverse=" & image(reverse));
    end if;
    home <= '1';
    scan(1, '0');
    scan(50, '1');
    wait for 1 ns; -- spray_machine.ladder:149
    if not failed and (expect_36_0 and expect_36_1) /= '1' then
      failed := true;
      print("# failed expectation 36 conducts " & image(expect_36_0) & image(expect_36_1)
          & " forward=" & image(forward)
          & " reverse=" & image(reverse));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 8 - a held start button makes one cycle");
    else
      print("ok 8 - a held start button makes one cycle");
    end if;

    -- stop wins over start
    failed := false;
    reset;
    home <= '1';
    start <= '1';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:153
    if not failed and (expect_37_0 and expect_37_1) /= '1' then
      failed := true;
      print("# failed expectation 37 conducts " & image(expect_37_0) & image(expect_37_1)
          & " forward=" & image(forward)
          & " reverse=" & image(reverse));
    end if;
    stop <= '1';
    scan(1, '0');
    wait for 1 ns; -- spray_machine.ladder:155
    if not failed and (expect_38_0) /= '1' then
      failed := true;
      print("# failed expectation 38 conducts " & image(expect_38_0)
          & " forward=" & image(forward));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 9 - stop wins over start");
    else
      print("ok 9 - stop wins over start");
    end if;

    assert failures = 0 report integer'image(failures) & " of 9 tests failed" severity failure;
    wait;
  end process;
end architecture;
