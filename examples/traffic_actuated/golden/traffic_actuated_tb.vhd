-- Made by hotrail 0.1.0 from traffic_actuated.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_actuated_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    ns_red      : in  std_logic;
    turn_red    : in  std_logic;
    ew_red      : in  std_logic;
    walk        : in  std_logic;
    ns_green    : in  std_logic;
    ns_yellow   : in  std_logic;
    ew_green    : in  std_logic;
    ew_yellow   : in  std_logic;
    turn_green  : in  std_logic;
    turn_yellow : in  std_logic;
    walk_soon   : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_1_2  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_2_2  : out std_logic;
    expect_2_3  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_3_2  : out std_logic;
    expect_4_0  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_5_2  : out std_logic;
    expect_6_0  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_7_2  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_8_2  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_9_2  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_11_2 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_13_1 : out std_logic;
    expect_13_2 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic;
    expect_17_1 : out std_logic;
    expect_17_2 : out std_logic;
    expect_18_0 : out std_logic;
    expect_19_0 : out std_logic;
    expect_20_0 : out std_logic;
    expect_20_1 : out std_logic;
    expect_21_0 : out std_logic;
    expect_22_0 : out std_logic;
    expect_23_0 : out std_logic;
    expect_23_1 : out std_logic;
    expect_23_2 : out std_logic;
    expect_24_0 : out std_logic;
    expect_25_0 : out std_logic;
    expect_26_0 : out std_logic;
    expect_27_0 : out std_logic;
    expect_28_0 : out std_logic;
    expect_29_0 : out std_logic;
    expect_30_0 : out std_logic;
    expect_31_0 : out std_logic;
    expect_32_0 : out std_logic;
    expect_33_0 : out std_logic;
    expect_34_0 : out std_logic;
    expect_34_1 : out std_logic;
    expect_34_2 : out std_logic;
    expect_35_0 : out std_logic;
    expect_36_0 : out std_logic;
    expect_37_0 : out std_logic;
    expect_38_0 : out std_logic;
    expect_39_0 : out std_logic;
    expect_40_0 : out std_logic;
    expect_40_1 : out std_logic;
    expect_41_0 : out std_logic;
    expect_42_0 : out std_logic;
    expect_42_1 : out std_logic;
    expect_42_2 : out std_logic;
    expect_42_3 : out std_logic;
    expect_42_4 : out std_logic;
    expect_43_0 : out std_logic;
    expect_44_0 : out std_logic;
    expect_44_1 : out std_logic;
    expect_44_2 : out std_logic;
    expect_44_3 : out std_logic;
    expect_45_0 : out std_logic;
    expect_45_1 : out std_logic;
    expect_45_2 : out std_logic;
    expect_46_0 : out std_logic;
    expect_47_0 : out std_logic;
    expect_47_1 : out std_logic;
    expect_48_0 : out std_logic;
    expect_48_1 : out std_logic;
    expect_49_0 : out std_logic;
    expect_49_1 : out std_logic;
    expect_50_0 : out std_logic;
    expect_51_0 : out std_logic;
    expect_52_0 : out std_logic;
    expect_53_0 : out std_logic;
    expect_54_0 : out std_logic;
    expect_55_0 : out std_logic
  );
end entity traffic_actuated_expect;

architecture rtl of traffic_actuated_expect is
begin

  expect_0_0 <= ns_red;
  expect_0_1 <= turn_red;
  expect_0_2 <= ew_red;
  expect_1_0 <= ns_red;
  expect_1_1 <= turn_red;
  expect_1_2 <= ew_red;
  expect_2_0 <= ns_red;
  expect_2_1 <= turn_red;
  expect_2_2 <= ew_red;
  expect_2_3 <= not walk;
  expect_3_0 <= ns_green;
  expect_3_1 <= turn_red;
  expect_3_2 <= ew_red;
  expect_4_0 <= ns_green;
  expect_5_0 <= ns_yellow;
  expect_5_1 <= turn_red;
  expect_5_2 <= ew_red;
  expect_6_0 <= ns_yellow;
  expect_7_0 <= ns_red;
  expect_7_1 <= turn_red;
  expect_7_2 <= ew_red;
  expect_8_0 <= ns_red;
  expect_8_1 <= turn_red;
  expect_8_2 <= ew_red;
  expect_9_0 <= ns_red;
  expect_9_1 <= turn_red;
  expect_9_2 <= ew_green;
  expect_10_0 <= ew_green;
  expect_11_0 <= ns_red;
  expect_11_1 <= turn_red;
  expect_11_2 <= ew_yellow;
  expect_12_0 <= ew_yellow;
  expect_13_0 <= turn_green;
  expect_13_1 <= ns_red;
  expect_13_2 <= ew_red;
  expect_14_0 <= turn_green;
  expect_15_0 <= turn_yellow;
  expect_16_0 <= turn_yellow;
  expect_17_0 <= ns_red;
  expect_17_1 <= turn_red;
  expect_17_2 <= ew_red;
  expect_18_0 <= ew_green;
  expect_19_0 <= ns_green;
  expect_20_0 <= ew_green;
  expect_20_1 <= turn_red;
  expect_21_0 <= turn_green;
  expect_22_0 <= ew_green;
  expect_23_0 <= ns_red;
  expect_23_1 <= turn_red;
  expect_23_2 <= ew_red;
  expect_24_0 <= turn_green;
  expect_25_0 <= turn_green;
  expect_26_0 <= turn_yellow;
  expect_27_0 <= turn_green;
  expect_28_0 <= turn_green;
  expect_29_0 <= turn_green;
  expect_30_0 <= turn_yellow;
  expect_31_0 <= turn_green;
  expect_32_0 <= turn_green;
  expect_33_0 <= turn_yellow;
  expect_34_0 <= ns_red;
  expect_34_1 <= turn_red;
  expect_34_2 <= ew_red;
  expect_35_0 <= turn_green;
  expect_36_0 <= turn_yellow;
  expect_37_0 <= turn_green;
  expect_38_0 <= turn_green;
  expect_39_0 <= turn_yellow;
  expect_40_0 <= walk_soon;
  expect_40_1 <= not walk;
  expect_41_0 <= not walk;
  expect_42_0 <= walk;
  expect_42_1 <= not walk_soon;
  expect_42_2 <= ns_red;
  expect_42_3 <= turn_red;
  expect_42_4 <= ew_red;
  expect_43_0 <= walk;
  expect_44_0 <= not walk;
  expect_44_1 <= ns_red;
  expect_44_2 <= turn_red;
  expect_44_3 <= ew_red;
  expect_45_0 <= ns_red;
  expect_45_1 <= turn_red;
  expect_45_2 <= ew_red;
  expect_46_0 <= ns_green;
  expect_47_0 <= ns_green;
  expect_47_1 <= not walk;
  expect_48_0 <= walk;
  expect_48_1 <= not walk_soon;
  expect_49_0 <= walk;
  expect_49_1 <= not walk_soon;
  expect_50_0 <= not walk;
  expect_51_0 <= walk_soon;
  expect_52_0 <= not walk;
  expect_53_0 <= walk;
  expect_54_0 <= (ns_red and turn_red) or (ns_red and ew_red) or (turn_red and ew_red);
  expect_55_0 <= not walk or (ns_red and turn_red and ew_red);
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity traffic_actuated_tb is
end entity;

architecture tests of traffic_actuated_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal walk_button : std_logic := '0';
  signal far_loop : std_logic := '0';
  signal near_loop : std_logic := '0';
  signal ns_green : std_logic;
  signal ns_yellow : std_logic;
  signal ns_red : std_logic;
  signal turn_green : std_logic;
  signal turn_yellow : std_logic;
  signal turn_red : std_logic;
  signal ew_green : std_logic;
  signal ew_yellow : std_logic;
  signal ew_red : std_logic;
  signal walk : std_logic;
  signal walk_soon : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_2_2 : std_logic;
  signal expect_2_3 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_7_2 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_8_2 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_9_2 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_11_2 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_13_1 : std_logic;
  signal expect_13_2 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_17_1 : std_logic;
  signal expect_17_2 : std_logic;
  signal expect_18_0 : std_logic;
  signal expect_19_0 : std_logic;
  signal expect_20_0 : std_logic;
  signal expect_20_1 : std_logic;
  signal expect_21_0 : std_logic;
  signal expect_22_0 : std_logic;
  signal expect_23_0 : std_logic;
  signal expect_23_1 : std_logic;
  signal expect_23_2 : std_logic;
  signal expect_24_0 : std_logic;
  signal expect_25_0 : std_logic;
  signal expect_26_0 : std_logic;
  signal expect_27_0 : std_logic;
  signal expect_28_0 : std_logic;
  signal expect_29_0 : std_logic;
  signal expect_30_0 : std_logic;
  signal expect_31_0 : std_logic;
  signal expect_32_0 : std_logic;
  signal expect_33_0 : std_logic;
  signal expect_34_0 : std_logic;
  signal expect_34_1 : std_logic;
  signal expect_34_2 : std_logic;
  signal expect_35_0 : std_logic;
  signal expect_36_0 : std_logic;
  signal expect_37_0 : std_logic;
  signal expect_38_0 : std_logic;
  signal expect_39_0 : std_logic;
  signal expect_40_0 : std_logic;
  signal expect_40_1 : std_logic;
  signal expect_41_0 : std_logic;
  signal expect_42_0 : std_logic;
  signal expect_42_1 : std_logic;
  signal expect_42_2 : std_logic;
  signal expect_42_3 : std_logic;
  signal expect_42_4 : std_logic;
  signal expect_43_0 : std_logic;
  signal expect_44_0 : std_logic;
  signal expect_44_1 : std_logic;
  signal expect_44_2 : std_logic;
  signal expect_44_3 : std_logic;
  signal expect_45_0 : std_logic;
  signal expect_45_1 : std_logic;
  signal expect_45_2 : std_logic;
  signal expect_46_0 : std_logic;
  signal expect_47_0 : std_logic;
  signal expect_47_1 : std_logic;
  signal expect_48_0 : std_logic;
  signal expect_48_1 : std_logic;
  signal expect_49_0 : std_logic;
  signal expect_49_1 : std_logic;
  signal expect_50_0 : std_logic;
  signal expect_51_0 : std_logic;
  signal expect_52_0 : std_logic;
  signal expect_53_0 : std_logic;
  signal expect_54_0 : std_logic;
  signal expect_55_0 : std_logic;

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
  core : entity work.traffic_actuated
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      walk_button => walk_button,
      far_loop => far_loop,
      near_loop => near_loop,
      ns_green => ns_green,
      ns_yellow => ns_yellow,
      ns_red => ns_red,
      turn_green => turn_green,
      turn_yellow => turn_yellow,
      turn_red => turn_red,
      ew_green => ew_green,
      ew_yellow => ew_yellow,
      ew_red => ew_red,
      walk => walk,
      walk_soon => walk_soon
    );

  expectations : entity work.traffic_actuated_expect
    port map (
      clk => clk,
      rst => rst,
      ns_red => ns_red,
      turn_red => turn_red,
      ew_red => ew_red,
      walk => walk,
      ns_green => ns_green,
      ns_yellow => ns_yellow,
      ew_green => ew_green,
      ew_yellow => ew_yellow,
      turn_green => turn_green,
      turn_yellow => turn_yellow,
      walk_soon => walk_soon,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_2_2 => expect_2_2,
      expect_2_3 => expect_2_3,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_4_0 => expect_4_0,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_6_0 => expect_6_0,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_7_2 => expect_7_2,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_8_2 => expect_8_2,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_9_2 => expect_9_2,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_11_2 => expect_11_2,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_13_1 => expect_13_1,
      expect_13_2 => expect_13_2,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_16_0 => expect_16_0,
      expect_17_0 => expect_17_0,
      expect_17_1 => expect_17_1,
      expect_17_2 => expect_17_2,
      expect_18_0 => expect_18_0,
      expect_19_0 => expect_19_0,
      expect_20_0 => expect_20_0,
      expect_20_1 => expect_20_1,
      expect_21_0 => expect_21_0,
      expect_22_0 => expect_22_0,
      expect_23_0 => expect_23_0,
      expect_23_1 => expect_23_1,
      expect_23_2 => expect_23_2,
      expect_24_0 => expect_24_0,
      expect_25_0 => expect_25_0,
      expect_26_0 => expect_26_0,
      expect_27_0 => expect_27_0,
      expect_28_0 => expect_28_0,
      expect_29_0 => expect_29_0,
      expect_30_0 => expect_30_0,
      expect_31_0 => expect_31_0,
      expect_32_0 => expect_32_0,
      expect_33_0 => expect_33_0,
      expect_34_0 => expect_34_0,
      expect_34_1 => expect_34_1,
      expect_34_2 => expect_34_2,
      expect_35_0 => expect_35_0,
      expect_36_0 => expect_36_0,
      expect_37_0 => expect_37_0,
      expect_38_0 => expect_38_0,
      expect_39_0 => expect_39_0,
      expect_40_0 => expect_40_0,
      expect_40_1 => expect_40_1,
      expect_41_0 => expect_41_0,
      expect_42_0 => expect_42_0,
      expect_42_1 => expect_42_1,
      expect_42_2 => expect_42_2,
      expect_42_3 => expect_42_3,
      expect_42_4 => expect_42_4,
      expect_43_0 => expect_43_0,
      expect_44_0 => expect_44_0,
      expect_44_1 => expect_44_1,
      expect_44_2 => expect_44_2,
      expect_44_3 => expect_44_3,
      expect_45_0 => expect_45_0,
      expect_45_1 => expect_45_1,
      expect_45_2 => expect_45_2,
      expect_46_0 => expect_46_0,
      expect_47_0 => expect_47_0,
      expect_47_1 => expect_47_1,
      expect_48_0 => expect_48_0,
      expect_48_1 => expect_48_1,
      expect_49_0 => expect_49_0,
      expect_49_1 => expect_49_1,
      expect_50_0 => expect_50_0,
      expect_51_0 => expect_51_0,
      expect_52_0 => expect_52_0,
      expect_53_0 => expect_53_0,
      expect_54_0 => expect_54_0,
      expect_55_0 => expect_55_0
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
      walk_button <= '0';
      far_loop <= '0';
      near_loop <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..11");

    -- all lanes are red before the first scan
    failed := false;
    reset;
    wait for 1 ns; -- traffic_actuated.ladder:92
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - all lanes are red before the first scan");
    else
      print("ok 1 - all lanes are red before the first scan");
    end if;

    -- nobody in the turn lane, nobody on foot: two greens in turn
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 3 loop
      wait for 1 ns; -- traffic_actuated.ladder:97
      if not failed and (expect_1_0 and expect_1_1 and expect_1_2) /= '1' then
        failed := true;
        print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(9, '1');
      wait for 1 ns; -- traffic_actuated.ladder:99
      if not failed and (expect_2_0 and expect_2_1 and expect_2_2 and expect_2_3) /= '1' then
        failed := true;
        print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2) & image(expect_2_3)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red)
            & " walk=" & image(walk));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_actuated.ladder:101
      if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
        failed := true;
        print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
            & " ns_green=" & image(ns_green)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(119, '1');
      wait for 1 ns; -- traffic_actuated.ladder:103
      if not failed and (expect_4_0) /= '1' then
        failed := true;
        print("# failed expectation 4 conducts " & image(expect_4_0)
            & " ns_green=" & image(ns_green));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_actuated.ladder:105
      if not failed and (expect_5_0 and expect_5_1 and expect_5_2) /= '1' then
        failed := true;
        print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(29, '1');
      wait for 1 ns; -- traffic_actuated.ladder:107
      if not failed and (expect_6_0) /= '1' then
        failed := true;
        print("# failed expectation 6 conducts " & image(expect_6_0)
            & " ns_yellow=" & image(ns_yellow));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_actuated.ladder:109
      if not failed and (expect_7_0 and expect_7_1 and expect_7_2) /= '1' then
        failed := true;
        print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(9, '1');
      wait for 1 ns; -- traffic_actuated.ladder:111
      if not failed and (expect_8_0 and expect_8_1 and expect_8_2) /= '1' then
        failed := true;
        print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_actuated.ladder:113
      if not failed and (expect_9_0 and expect_9_1 and expect_9_2) /= '1' then
        failed := true;
        print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_green=" & image(ew_green));
      end if;
      scan(99, '1');
      wait for 1 ns; -- traffic_actuated.ladder:115
      if not failed and (expect_10_0) /= '1' then
        failed := true;
        print("# failed expectation 10 conducts " & image(expect_10_0)
            & " ew_green=" & image(ew_green));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_actuated.ladder:117
      if not failed and (expect_11_0 and expect_11_1 and expect_11_2) /= '1' then
        failed := true;
        print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1) & image(expect_11_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_yellow=" & image(ew_yellow));
      end if;
      scan(29, '1');
      wait for 1 ns; -- traffic_actuated.ladder:119
      if not failed and (expect_12_0) /= '1' then
        failed := true;
        print("# failed expectation 12 conducts " & image(expect_12_0)
            & " ew_yellow=" & image(ew_yellow));
      end if;
      scan(1, '1');
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 2 - nobody in the turn lane, nobody on foot: two greens in turn");
    else
      print("ok 2 - nobody in the turn lane, nobody on foot: two greens in turn");
    end if;

    -- one car in the turn lane is let go, once
    failed := false;
    reset;
    scan(1, '0');
    scan(10, '1');
    near_loop <= '1';
    scan(1, '0');
    near_loop <= '0';
    scan(1, '0');
    scan(160, '1');
    wait for 1 ns; -- traffic_actuated.ladder:128
    if not failed and (expect_13_0 and expect_13_1 and expect_13_2) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0) & image(expect_13_1) & image(expect_13_2)
          & " turn_green=" & image(turn_green)
          & " ns_red=" & image(ns_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(59, '1');
    wait for 1 ns; -- traffic_actuated.ladder:130
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " turn_green=" & image(turn_green));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:132
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " turn_yellow=" & image(turn_yellow));
    end if;
    scan(29, '1');
    wait for 1 ns; -- traffic_actuated.ladder:134
    if not failed and (expect_16_0) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0)
          & " turn_yellow=" & image(turn_yellow));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:136
    if not failed and (expect_17_0 and expect_17_1 and expect_17_2) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0) & image(expect_17_1) & image(expect_17_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(10, '1');
    wait for 1 ns; -- traffic_actuated.ladder:138
    if not failed and (expect_18_0) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0)
          & " ew_green=" & image(ew_green));
    end if;
    scan(140, '1');
    wait for 1 ns; -- traffic_actuated.ladder:140
    if not failed and (expect_19_0) /= '1' then
      failed := true;
      print("# failed expectation 19 conducts " & image(expect_19_0)
          & " ns_green=" & image(ns_green));
    end if;
    scan(160, '1');
    wait for 1 ns; -- traffic_actuated.ladder:142
    if not failed and (expect_20_0 and expect_20_1) /= '1' then
      failed := true;
      print("# failed expectation 20 conducts " & image(expect_20_0) & image(expect_20_1)
          & " ew_green=" & image(ew_green)
          & " turn_red=" & image(turn_red));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - one car in the turn lane is let go, once");
    else
      print("ok 3 - one car in the turn lane is let go, once");
    end if;

    -- the last moment to ask for the turn lane
    failed := false;
    reset;
    scan(1, '0');
    scan(169, '1');
    far_loop <= '1';
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:148
    if not failed and (expect_21_0) /= '1' then
      failed := true;
      print("# failed expectation 21 conducts " & image(expect_21_0)
          & " turn_green=" & image(turn_green));
    end if;
    reset;
    scan(1, '0');
    scan(170, '1');
    wait for 1 ns; -- traffic_actuated.ladder:152
    if not failed and (expect_22_0) /= '1' then
      failed := true;
      print("# failed expectation 22 conducts " & image(expect_22_0)
          & " ew_green=" & image(ew_green));
    end if;
    far_loop <= '1';
    scan(1, '0');
    far_loop <= '0';
    scan(1, '0');
    scan(290, '1');
    wait for 1 ns; -- traffic_actuated.ladder:155
    if not failed and (expect_23_0 and expect_23_1 and expect_23_2) /= '1' then
      failed := true;
      print("# failed expectation 23 conducts " & image(expect_23_0) & image(expect_23_1) & image(expect_23_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(10, '1');
    wait for 1 ns; -- traffic_actuated.ladder:157
    if not failed and (expect_24_0) /= '1' then
      failed := true;
      print("# failed expectation 24 conducts " & image(expect_24_0)
          & " turn_green=" & image(turn_green));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - the last moment to ask for the turn lane");
    else
      print("ok 4 - the last moment to ask for the turn lane");
    end if;

    -- a car that misses its green asks again
    failed := false;
    reset;
    scan(1, '0');
    near_loop <= '1';
    scan(1, '0');
    near_loop <= '0';
    scan(1, '0');
    scan(170, '1');
    wait for 1 ns; -- traffic_actuated.ladder:163
    if not failed and (expect_25_0) /= '1' then
      failed := true;
      print("# failed expectation 25 conducts " & image(expect_25_0)
          & " turn_green=" & image(turn_green));
    end if;
    far_loop <= '1';
    scan(60, '1');
    wait for 1 ns; -- traffic_actuated.ladder:165
    if not failed and (expect_26_0) /= '1' then
      failed := true;
      print("# failed expectation 26 conducts " & image(expect_26_0)
          & " turn_yellow=" & image(turn_yellow));
    end if;
    scan(370, '1');
    wait for 1 ns; -- traffic_actuated.ladder:167
    if not failed and (expect_27_0) /= '1' then
      failed := true;
      print("# failed expectation 27 conducts " & image(expect_27_0)
          & " turn_green=" & image(turn_green));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a car that misses its green asks again");
    else
      print("ok 5 - a car that misses its green asks again");
    end if;

    -- cars that roll from loop to loop are no queue
    failed := false;
    reset;
    scan(1, '0');
    scan(10, '1');
    for round in 1 to 3 loop
      far_loop <= '1';
      scan(1, '0');
      far_loop <= '0';
      scan(1, '0');
      scan(19, '1');
      near_loop <= '1';
      scan(1, '0');
      near_loop <= '0';
      scan(1, '0');
    end loop;
    scan(103, '1');
    wait for 1 ns; -- traffic_actuated.ladder:178
    if not failed and (expect_28_0) /= '1' then
      failed := true;
      print("# failed expectation 28 conducts " & image(expect_28_0)
          & " turn_green=" & image(turn_green));
    end if;
    scan(59, '1');
    wait for 1 ns; -- traffic_actuated.ladder:180
    if not failed and (expect_29_0) /= '1' then
      failed := true;
      print("# failed expectation 29 conducts " & image(expect_29_0)
          & " turn_green=" & image(turn_green));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:182
    if not failed and (expect_30_0) /= '1' then
      failed := true;
      print("# failed expectation 30 conducts " & image(expect_30_0)
          & " turn_yellow=" & image(turn_yellow));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - cars that roll from loop to loop are no queue");
    else
      print("ok 6 - cars that roll from loop to loop are no queue");
    end if;

    -- two seconds from loop to loop are a queue: twice the time, in this round only
    failed := false;
    reset;
    scan(1, '0');
    scan(10, '1');
    far_loop <= '1';
    scan(1, '0');
    far_loop <= '0';
    scan(1, '0');
    scan(20, '1');
    near_loop <= '1';
    scan(1, '0');
    near_loop <= '0';
    scan(1, '0');
    scan(140, '1');
    wait for 1 ns; -- traffic_actuated.ladder:191
    if not failed and (expect_31_0) /= '1' then
      failed := true;
      print("# failed expectation 31 conducts " & image(expect_31_0)
          & " turn_green=" & image(turn_green));
    end if;
    scan(119, '1');
    wait for 1 ns; -- traffic_actuated.ladder:193
    if not failed and (expect_32_0) /= '1' then
      failed := true;
      print("# failed expectation 32 conducts " & image(expect_32_0)
          & " turn_green=" & image(turn_green));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:195
    if not failed and (expect_33_0) /= '1' then
      failed := true;
      print("# failed expectation 33 conducts " & image(expect_33_0)
          & " turn_yellow=" & image(turn_yellow));
    end if;
    scan(170, '1');
    wait for 1 ns; -- traffic_actuated.ladder:197
    if not failed and (expect_34_0 and expect_34_1 and expect_34_2) /= '1' then
      failed := true;
      print("# failed expectation 34 conducts " & image(expect_34_0) & image(expect_34_1) & image(expect_34_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    near_loop <= '1';
    scan(1, '0');
    near_loop <= '0';
    scan(1, '0');
    scan(170, '1');
    wait for 1 ns; -- traffic_actuated.ladder:200
    if not failed and (expect_35_0) /= '1' then
      failed := true;
      print("# failed expectation 35 conducts " & image(expect_35_0)
          & " turn_green=" & image(turn_green));
    end if;
    scan(60, '1');
    wait for 1 ns; -- traffic_actuated.ladder:202
    if not failed and (expect_36_0) /= '1' then
      failed := true;
      print("# failed expectation 36 conducts " & image(expect_36_0)
          & " turn_yellow=" & image(turn_yellow));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - two seconds from loop to loop are a queue: twice the time, in this round only");
    else
      print("ok 7 - two seconds from loop to loop are a queue: twice the time, in this round only");
    end if;

    -- the second car, which reaches the stop line in its green only, shows the queue
    failed := false;
    reset;
    scan(1, '0');
    scan(10, '1');
    far_loop <= '1';
    scan(1, '0');
    far_loop <= '0';
    scan(1, '0');
    near_loop <= '1';
    scan(50, '1');
    far_loop <= '1';
    scan(110, '1');
    wait for 1 ns; -- traffic_actuated.ladder:210
    if not failed and (expect_37_0) /= '1' then
      failed := true;
      print("# failed expectation 37 conducts " & image(expect_37_0)
          & " turn_green=" & image(turn_green));
    end if;
    near_loop <= '0';
    scan(10, '1');
    near_loop <= '1';
    far_loop <= '0';
    scan(10, '1');
    near_loop <= '0';
    scan(99, '1');
    wait for 1 ns; -- traffic_actuated.ladder:215
    if not failed and (expect_38_0) /= '1' then
      failed := true;
      print("# failed expectation 38 conducts " & image(expect_38_0)
          & " turn_green=" & image(turn_green));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:217
    if not failed and (expect_39_0) /= '1' then
      failed := true;
      print("# failed expectation 39 conducts " & image(expect_39_0)
          & " turn_yellow=" & image(turn_yellow));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 8 - the second car, which reaches the stop line in its green only, shows the queue");
    else
      print("ok 8 - the second car, which reaches the stop line in its green only, shows the queue");
    end if;

    -- pedestrians walk in all directions when all lanes are red
    failed := false;
    reset;
    scan(1, '0');
    scan(50, '1');
    walk_button <= '1';
    scan(1, '0');
    walk_button <= '0';
    scan(1, '0');
    wait for 1 ns; -- traffic_actuated.ladder:223
    if not failed and (expect_40_0 and expect_40_1) /= '1' then
      failed := true;
      print("# failed expectation 40 conducts " & image(expect_40_0) & image(expect_40_1)
          & " walk_soon=" & image(walk_soon)
          & " walk=" & image(walk));
    end if;
    scan(259, '1');
    wait for 1 ns; -- traffic_actuated.ladder:225
    if not failed and (expect_41_0) /= '1' then
      failed := true;
      print("# failed expectation 41 conducts " & image(expect_41_0)
          & " walk=" & image(walk));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:227
    if not failed and (expect_42_0 and expect_42_1 and expect_42_2 and expect_42_3 and expect_42_4) /= '1' then
      failed := true;
      print("# failed expectation 42 conducts " & image(expect_42_0) & image(expect_42_1) & image(expect_42_2) & image(expect_42_3) & image(expect_42_4)
          & " walk=" & image(walk)
          & " walk_soon=" & image(walk_soon)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(79, '1');
    wait for 1 ns; -- traffic_actuated.ladder:229
    if not failed and (expect_43_0) /= '1' then
      failed := true;
      print("# failed expectation 43 conducts " & image(expect_43_0)
          & " walk=" & image(walk));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:231
    if not failed and (expect_44_0 and expect_44_1 and expect_44_2 and expect_44_3) /= '1' then
      failed := true;
      print("# failed expectation 44 conducts " & image(expect_44_0) & image(expect_44_1) & image(expect_44_2) & image(expect_44_3)
          & " walk=" & image(walk)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(29, '1');
    wait for 1 ns; -- traffic_actuated.ladder:233
    if not failed and (expect_45_0 and expect_45_1 and expect_45_2) /= '1' then
      failed := true;
      print("# failed expectation 45 conducts " & image(expect_45_0) & image(expect_45_1) & image(expect_45_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:235
    if not failed and (expect_46_0) /= '1' then
      failed := true;
      print("# failed expectation 46 conducts " & image(expect_46_0)
          & " ns_green=" & image(ns_green));
    end if;
    scan(300, '1');
    wait for 1 ns; -- traffic_actuated.ladder:237
    if not failed and (expect_47_0 and expect_47_1) /= '1' then
      failed := true;
      print("# failed expectation 47 conducts " & image(expect_47_0) & image(expect_47_1)
          & " ns_green=" & image(ns_green)
          & " walk=" & image(walk));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 9 - pedestrians walk in all directions when all lanes are red");
    else
      print("ok 9 - pedestrians walk in all directions when all lanes are red");
    end if;

    -- a push while others walk changes nothing, one while they leave the road waits for the next round
    failed := false;
    reset;
    walk_button <= '1';
    scan(1, '0');
    scan(10, '1');
    wait for 1 ns; -- traffic_actuated.ladder:242
    if not failed and (expect_48_0 and expect_48_1) /= '1' then
      failed := true;
      print("# failed expectation 48 conducts " & image(expect_48_0) & image(expect_48_1)
          & " walk=" & image(walk)
          & " walk_soon=" & image(walk_soon));
    end if;
    scan(10, '1');
    wait for 1 ns; -- traffic_actuated.ladder:244
    if not failed and (expect_49_0 and expect_49_1) /= '1' then
      failed := true;
      print("# failed expectation 49 conducts " & image(expect_49_0) & image(expect_49_1)
          & " walk=" & image(walk)
          & " walk_soon=" & image(walk_soon));
    end if;
    walk_button <= '0';
    scan(70, '1');
    wait for 1 ns; -- traffic_actuated.ladder:247
    if not failed and (expect_50_0) /= '1' then
      failed := true;
      print("# failed expectation 50 conducts " & image(expect_50_0)
          & " walk=" & image(walk));
    end if;
    walk_button <= '1';
    scan(1, '0');
    walk_button <= '0';
    scan(1, '0');
    wait for 1 ns; -- traffic_actuated.ladder:249
    if not failed and (expect_51_0) /= '1' then
      failed := true;
      print("# failed expectation 51 conducts " & image(expect_51_0)
          & " walk_soon=" & image(walk_soon));
    end if;
    scan(329, '1');
    wait for 1 ns; -- traffic_actuated.ladder:251
    if not failed and (expect_52_0) /= '1' then
      failed := true;
      print("# failed expectation 52 conducts " & image(expect_52_0)
          & " walk=" & image(walk));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_actuated.ladder:253
    if not failed and (expect_53_0) /= '1' then
      failed := true;
      print("# failed expectation 53 conducts " & image(expect_53_0)
          & " walk=" & image(walk));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 10 - a push while others walk changes nothing, one while they leave the road waits for the next round");
    else
      print("ok 10 - a push while others walk changes nothing, one while they leave the road waits for the next round");
    end if;

    -- all at once: one after the other is served, and never two
    failed := false;
    reset;
    scan(1, '0');
    walk_button <= '1';
    for round in 1 to 300 loop
      far_loop <= '1';
      scan(2, '1');
      wait for 1 ns; -- traffic_actuated.ladder:260
      if not failed and (expect_54_0) /= '1' then
        failed := true;
        print("# failed expectation 54 conducts " & image(expect_54_0)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      wait for 1 ns; -- traffic_actuated.ladder:261
      if not failed and (expect_55_0) /= '1' then
        failed := true;
        print("# failed expectation 55 conducts " & image(expect_55_0)
            & " walk=" & image(walk)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      far_loop <= '0';
      near_loop <= '1';
      scan(1, '1');
      near_loop <= '0';
      scan(1, '0');
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 11 - all at once: one after the other is served, and never two");
    else
      print("ok 11 - all at once: one after the other is served, and never two");
    end if;

    assert failures = 0 report integer'image(failures) & " of 11 tests failed" severity failure;
    wait;
  end process;
end architecture;
