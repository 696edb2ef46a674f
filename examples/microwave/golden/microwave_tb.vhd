-- Made by hotrail 0.1.0 from microwave.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity microwave_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    magnetron   : in  std_logic;
    turntable   : in  std_logic;
    ready       : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_2_0  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_3_2  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
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
    expect_10_1 : out std_logic;
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic;
    expect_12_1 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic;
    expect_17_1 : out std_logic;
    expect_18_0 : out std_logic;
    expect_19_0 : out std_logic;
    expect_20_0 : out std_logic;
    expect_20_1 : out std_logic;
    expect_21_0 : out std_logic;
    expect_21_1 : out std_logic;
    expect_22_0 : out std_logic;
    expect_23_0 : out std_logic;
    expect_23_1 : out std_logic;
    expect_24_0 : out std_logic;
    expect_25_0 : out std_logic;
    expect_26_0 : out std_logic;
    expect_27_0 : out std_logic;
    expect_28_0 : out std_logic;
    expect_28_1 : out std_logic;
    expect_29_0 : out std_logic;
    expect_29_1 : out std_logic;
    expect_30_0 : out std_logic;
    expect_31_0 : out std_logic;
    expect_31_1 : out std_logic;
    expect_32_0 : out std_logic;
    expect_33_0 : out std_logic
  );
end entity microwave_expect;

architecture rtl of microwave_expect is
begin

  expect_0_0 <= magnetron;
  expect_0_1 <= turntable;
  expect_0_2 <= not ready;
  expect_1_0 <= magnetron;
  expect_1_1 <= not ready;
  expect_2_0 <= ready;
  expect_3_0 <= ready;
  expect_3_1 <= not magnetron;
  expect_3_2 <= not turntable;
  expect_4_0 <= ready;
  expect_4_1 <= not magnetron;
  expect_5_0 <= not magnetron;
  expect_5_1 <= turntable;
  expect_6_0 <= not magnetron;
  expect_7_0 <= not magnetron;
  expect_7_1 <= turntable;
  expect_8_0 <= magnetron;
  expect_8_1 <= turntable;
  expect_9_0 <= magnetron;
  expect_9_1 <= not ready;
  expect_10_0 <= not magnetron;
  expect_10_1 <= ready;
  expect_11_0 <= not magnetron;
  expect_12_0 <= magnetron;
  expect_12_1 <= not ready;
  expect_13_0 <= not ready;
  expect_14_0 <= ready;
  expect_15_0 <= not magnetron;
  expect_16_0 <= magnetron;
  expect_17_0 <= not magnetron;
  expect_17_1 <= not turntable;
  expect_18_0 <= not magnetron;
  expect_19_0 <= magnetron;
  expect_20_0 <= magnetron;
  expect_20_1 <= not ready;
  expect_21_0 <= not magnetron;
  expect_21_1 <= ready;
  expect_22_0 <= ready;
  expect_23_0 <= ready;
  expect_23_1 <= not magnetron;
  expect_24_0 <= not ready;
  expect_25_0 <= magnetron;
  expect_26_0 <= not ready;
  expect_27_0 <= ready;
  expect_28_0 <= not magnetron;
  expect_28_1 <= not turntable;
  expect_29_0 <= not ready;
  expect_29_1 <= magnetron;
  expect_30_0 <= ready;
  expect_31_0 <= not magnetron;
  expect_31_1 <= not turntable;
  expect_32_0 <= not magnetron;
  expect_33_0 <= not magnetron;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity microwave_tb is
end entity;

architecture tests of microwave_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal cancel : std_logic := '0';
  signal door : std_logic := '0';
  signal foam : std_logic := '0';
  signal magnetron : std_logic;
  signal turntable : std_logic;
  signal ready : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
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
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_17_1 : std_logic;
  signal expect_18_0 : std_logic;
  signal expect_19_0 : std_logic;
  signal expect_20_0 : std_logic;
  signal expect_20_1 : std_logic;
  signal expect_21_0 : std_logic;
  signal expect_21_1 : std_logic;
  signal expect_22_0 : std_logic;
  signal expect_23_0 : std_logic;
  signal expect_23_1 : std_logic;
  signal expect_24_0 : std_logic;
  signal expect_25_0 : std_logic;
  signal expect_26_0 : std_logic;
  signal expect_27_0 : std_logic;
  signal expect_28_0 : std_logic;
  signal expect_28_1 : std_logic;
  signal expect_29_0 : std_logic;
  signal expect_29_1 : std_logic;
  signal expect_30_0 : std_logic;
  signal expect_31_0 : std_logic;
  signal expect_31_1 : std_logic;
  signal expect_32_0 : std_logic;
  signal expect_33_0 : std_logic;

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
  core : entity work.microwave
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      cancel => cancel,
      door => door,
      foam => foam,
      magnetron => magnetron,
      turntable => turntable,
      ready => ready
    );

  expectations : entity work.microwave_expect
    port map (
      clk => clk,
      rst => rst,
      magnetron => magnetron,
      turntable => turntable,
      ready => ready,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
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
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_16_0 => expect_16_0,
      expect_17_0 => expect_17_0,
      expect_17_1 => expect_17_1,
      expect_18_0 => expect_18_0,
      expect_19_0 => expect_19_0,
      expect_20_0 => expect_20_0,
      expect_20_1 => expect_20_1,
      expect_21_0 => expect_21_0,
      expect_21_1 => expect_21_1,
      expect_22_0 => expect_22_0,
      expect_23_0 => expect_23_0,
      expect_23_1 => expect_23_1,
      expect_24_0 => expect_24_0,
      expect_25_0 => expect_25_0,
      expect_26_0 => expect_26_0,
      expect_27_0 => expect_27_0,
      expect_28_0 => expect_28_0,
      expect_28_1 => expect_28_1,
      expect_29_0 => expect_29_0,
      expect_29_1 => expect_29_1,
      expect_30_0 => expect_30_0,
      expect_31_0 => expect_31_0,
      expect_31_1 => expect_31_1,
      expect_32_0 => expect_32_0,
      expect_33_0 => expect_33_0
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
      cancel <= '0';
      door <= '0';
      foam <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..8");

    -- a bowl that does not boil
    failed := false;
    reset;
    door <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:25
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " magnetron=" & image(magnetron)
          & " turntable=" & image(turntable)
          & " ready=" & image(ready));
    end if;
    scan(899, '1');
    wait for 1 ns; -- microwave.ladder:27
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " magnetron=" & image(magnetron)
          & " ready=" & image(ready));
    end if;
    scan(1, '1');
    wait for 1 ns; -- microwave.ladder:29
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " ready=" & image(ready));
    end if;
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:31
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
          & " ready=" & image(ready)
          & " magnetron=" & image(magnetron)
          & " turntable=" & image(turntable));
    end if;
    scan(600, '1');
    wait for 1 ns; -- microwave.ladder:33
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " ready=" & image(ready)
          & " magnetron=" & image(magnetron));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - a bowl that does not boil");
    else
      print("ok 1 - a bowl that does not boil");
    end if;

    -- foam: the power pauses until three seconds after it has sunk
    failed := false;
    reset;
    door <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(500, '1');
    foam <= '1';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:40
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " magnetron=" & image(magnetron)
          & " turntable=" & image(turntable));
    end if;
    scan(40, '1');
    wait for 1 ns; -- microwave.ladder:42
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " magnetron=" & image(magnetron));
    end if;
    foam <= '0';
    scan(1, '0');
    scan(29, '1');
    wait for 1 ns; -- microwave.ladder:45
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " magnetron=" & image(magnetron)
          & " turntable=" & image(turntable));
    end if;
    scan(1, '1');
    wait for 1 ns; -- microwave.ladder:47
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " magnetron=" & image(magnetron)
          & " turntable=" & image(turntable));
    end if;
    scan(399, '1');
    wait for 1 ns; -- microwave.ladder:49
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " magnetron=" & image(magnetron)
          & " ready=" & image(ready));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:52
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " magnetron=" & image(magnetron)
          & " ready=" & image(ready));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - foam: the power pauses until three seconds after it has sunk");
    else
      print("ok 2 - foam: the power pauses until three seconds after it has sunk");
    end if;

    -- it boils again and again, and gets 90 s of power all the same
    failed := false;
    reset;
    door <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(450, '1');
    for round in 1 to 9 loop
      scan(40, '1');
      foam <= '1';
      scan(1, '0');
      wait for 1 ns; -- microwave.ladder:61
      if not failed and (expect_11_0) /= '1' then
        failed := true;
        print("# failed expectation 11 conducts " & image(expect_11_0)
            & " magnetron=" & image(magnetron));
      end if;
      scan(10, '1');
      foam <= '0';
      scan(1, '0');
      scan(30, '1');
      wait for 1 ns; -- microwave.ladder:65
      if not failed and (expect_12_0 and expect_12_1) /= '1' then
        failed := true;
        print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
            & " magnetron=" & image(magnetron)
            & " ready=" & image(ready));
      end if;
    end loop;
    scan(89, '1');
    wait for 1 ns; -- microwave.ladder:68
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " ready=" & image(ready));
    end if;
    scan(1, '1');
    wait for 1 ns; -- microwave.ladder:70
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " ready=" & image(ready));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - it boils again and again, and gets 90 s of power all the same");
    else
      print("ok 3 - it boils again and again, and gets 90 s of power all the same");
    end if;

    -- foam that flickers
    failed := false;
    reset;
    door <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    for round in 1 to 5 loop
      foam <= '1';
      scan(1, '0');
      foam <= '0';
      scan(1, '0');
      scan(29, '1');
      wait for 1 ns; -- microwave.ladder:79
      if not failed and (expect_15_0) /= '1' then
        failed := true;
        print("# failed expectation 15 conducts " & image(expect_15_0)
            & " magnetron=" & image(magnetron));
      end if;
    end loop;
    scan(1, '1');
    wait for 1 ns; -- microwave.ladder:82
    if not failed and (expect_16_0) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0)
          & " magnetron=" & image(magnetron));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - foam that flickers");
    else
      print("ok 4 - foam that flickers");
    end if;

    -- an open door stops it, start goes on where it was
    failed := false;
    reset;
    door <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(600, '1');
    door <= '0';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:89
    if not failed and (expect_17_0 and expect_17_1) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0) & image(expect_17_1)
          & " magnetron=" & image(magnetron)
          & " turntable=" & image(turntable));
    end if;
    scan(100, '1');
    door <= '1';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:92
    if not failed and (expect_18_0) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0)
          & " magnetron=" & image(magnetron));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:94
    if not failed and (expect_19_0) /= '1' then
      failed := true;
      print("# failed expectation 19 conducts " & image(expect_19_0)
          & " magnetron=" & image(magnetron));
    end if;
    scan(299, '1');
    wait for 1 ns; -- microwave.ladder:96
    if not failed and (expect_20_0 and expect_20_1) /= '1' then
      failed := true;
      print("# failed expectation 20 conducts " & image(expect_20_0) & image(expect_20_1)
          & " magnetron=" & image(magnetron)
          & " ready=" & image(ready));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:99
    if not failed and (expect_21_0 and expect_21_1) /= '1' then
      failed := true;
      print("# failed expectation 21 conducts " & image(expect_21_0) & image(expect_21_1)
          & " magnetron=" & image(magnetron)
          & " ready=" & image(ready));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - an open door stops it, start goes on where it was");
    else
      print("ok 5 - an open door stops it, start goes on where it was");
    end if;

    -- the next bowl: open the door, close it, start
    failed := false;
    reset;
    door <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(900, '1');
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:106
    if not failed and (expect_22_0) /= '1' then
      failed := true;
      print("# failed expectation 22 conducts " & image(expect_22_0)
          & " ready=" & image(ready));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:108
    if not failed and (expect_23_0 and expect_23_1) /= '1' then
      failed := true;
      print("# failed expectation 23 conducts " & image(expect_23_0) & image(expect_23_1)
          & " ready=" & image(ready)
          & " magnetron=" & image(magnetron));
    end if;
    door <= '0';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:110
    if not failed and (expect_24_0) /= '1' then
      failed := true;
      print("# failed expectation 24 conducts " & image(expect_24_0)
          & " ready=" & image(ready));
    end if;
    door <= '1';
    scan(1, '0');
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:113
    if not failed and (expect_25_0) /= '1' then
      failed := true;
      print("# failed expectation 25 conducts " & image(expect_25_0)
          & " magnetron=" & image(magnetron));
    end if;
    scan(899, '1');
    wait for 1 ns; -- microwave.ladder:115
    if not failed and (expect_26_0) /= '1' then
      failed := true;
      print("# failed expectation 26 conducts " & image(expect_26_0)
          & " ready=" & image(ready));
    end if;
    scan(1, '1');
    wait for 1 ns; -- microwave.ladder:117
    if not failed and (expect_27_0) /= '1' then
      failed := true;
      print("# failed expectation 27 conducts " & image(expect_27_0)
          & " ready=" & image(ready));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - the next bowl: open the door, close it, start");
    else
      print("ok 6 - the next bowl: open the door, close it, start");
    end if;

    -- cancel forgets the time
    failed := false;
    reset;
    door <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(600, '1');
    cancel <= '1';
    scan(1, '0');
    cancel <= '0';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:124
    if not failed and (expect_28_0 and expect_28_1) /= '1' then
      failed := true;
      print("# failed expectation 28 conducts " & image(expect_28_0) & image(expect_28_1)
          & " magnetron=" & image(magnetron)
          & " turntable=" & image(turntable));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(899, '1');
    wait for 1 ns; -- microwave.ladder:127
    if not failed and (expect_29_0 and expect_29_1) /= '1' then
      failed := true;
      print("# failed expectation 29 conducts " & image(expect_29_0) & image(expect_29_1)
          & " ready=" & image(ready)
          & " magnetron=" & image(magnetron));
    end if;
    scan(1, '1');
    wait for 1 ns; -- microwave.ladder:129
    if not failed and (expect_30_0) /= '1' then
      failed := true;
      print("# failed expectation 30 conducts " & image(expect_30_0)
          & " ready=" & image(ready));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - cancel forgets the time");
    else
      print("ok 7 - cancel forgets the time");
    end if;

    -- no power with the door open, and a held button does not wait for it
    failed := false;
    reset;
    start <= '1';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:133
    if not failed and (expect_31_0 and expect_31_1) /= '1' then
      failed := true;
      print("# failed expectation 31 conducts " & image(expect_31_0) & image(expect_31_1)
          & " magnetron=" & image(magnetron)
          & " turntable=" & image(turntable));
    end if;
    door <= '1';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:135
    if not failed and (expect_32_0) /= '1' then
      failed := true;
      print("# failed expectation 32 conducts " & image(expect_32_0)
          & " magnetron=" & image(magnetron));
    end if;
    cancel <= '1';
    start <= '0';
    scan(1, '0');
    start <= '1';
    scan(1, '0');
    wait for 1 ns; -- microwave.ladder:138
    if not failed and (expect_33_0) /= '1' then
      failed := true;
      print("# failed expectation 33 conducts " & image(expect_33_0)
          & " magnetron=" & image(magnetron));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 8 - no power with the door open, and a held button does not wait for it");
    else
      print("ok 8 - no power with the door open, and a held button does not wait for it");
    end if;

    assert failures = 0 report integer'image(failures) & " of 8 tests failed" severity failure;
    wait;
  end process;
end architecture;
