-- Made by hotrail 0.1.0 from traffic_modes.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_modes_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    ns_red      : in  std_logic;
    turn_red    : in  std_logic;
    ew_red      : in  std_logic;
    ns_green    : in  std_logic;
    ns_yellow   : in  std_logic;
    turn_green  : in  std_logic;
    turn_yellow : in  std_logic;
    ew_green    : in  std_logic;
    ew_yellow   : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_1_2  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_2_2  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_3_2  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_4_2  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_5_2  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_6_2  : out std_logic;
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
    expect_10_1 : out std_logic;
    expect_10_2 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_11_2 : out std_logic;
    expect_12_0 : out std_logic;
    expect_12_1 : out std_logic;
    expect_12_2 : out std_logic;
    expect_13_0 : out std_logic;
    expect_13_1 : out std_logic;
    expect_13_2 : out std_logic;
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
    expect_18_2 : out std_logic;
    expect_19_0 : out std_logic;
    expect_19_1 : out std_logic;
    expect_19_2 : out std_logic;
    expect_20_0 : out std_logic;
    expect_20_1 : out std_logic;
    expect_20_2 : out std_logic;
    expect_21_0 : out std_logic;
    expect_21_1 : out std_logic;
    expect_21_2 : out std_logic;
    expect_22_0 : out std_logic;
    expect_22_1 : out std_logic;
    expect_22_2 : out std_logic;
    expect_23_0 : out std_logic;
    expect_23_1 : out std_logic;
    expect_23_2 : out std_logic;
    expect_24_0 : out std_logic;
    expect_24_1 : out std_logic;
    expect_24_2 : out std_logic;
    expect_25_0 : out std_logic;
    expect_25_1 : out std_logic;
    expect_25_2 : out std_logic;
    expect_26_0 : out std_logic;
    expect_26_1 : out std_logic;
    expect_26_2 : out std_logic;
    expect_27_0 : out std_logic;
    expect_28_0 : out std_logic;
    expect_29_0 : out std_logic;
    expect_30_0 : out std_logic;
    expect_31_0 : out std_logic;
    expect_31_1 : out std_logic;
    expect_31_2 : out std_logic;
    expect_32_0 : out std_logic;
    expect_33_0 : out std_logic;
    expect_33_1 : out std_logic;
    expect_33_2 : out std_logic;
    expect_34_0 : out std_logic;
    expect_34_1 : out std_logic;
    expect_34_2 : out std_logic;
    expect_35_0 : out std_logic;
    expect_35_1 : out std_logic;
    expect_35_2 : out std_logic;
    expect_35_3 : out std_logic;
    expect_35_4 : out std_logic;
    expect_35_5 : out std_logic;
    expect_35_6 : out std_logic;
    expect_35_7 : out std_logic;
    expect_35_8 : out std_logic;
    expect_36_0 : out std_logic;
    expect_36_1 : out std_logic;
    expect_36_2 : out std_logic;
    expect_37_0 : out std_logic;
    expect_37_1 : out std_logic;
    expect_37_2 : out std_logic;
    expect_37_3 : out std_logic;
    expect_37_4 : out std_logic;
    expect_37_5 : out std_logic;
    expect_37_6 : out std_logic;
    expect_37_7 : out std_logic;
    expect_37_8 : out std_logic;
    expect_38_0 : out std_logic;
    expect_38_1 : out std_logic;
    expect_38_2 : out std_logic;
    expect_39_0 : out std_logic;
    expect_40_0 : out std_logic;
    expect_41_0 : out std_logic;
    expect_42_0 : out std_logic;
    expect_42_1 : out std_logic;
    expect_42_2 : out std_logic;
    expect_43_0 : out std_logic;
    expect_43_1 : out std_logic;
    expect_43_2 : out std_logic;
    expect_44_0 : out std_logic;
    expect_44_1 : out std_logic;
    expect_44_2 : out std_logic;
    expect_45_0 : out std_logic;
    expect_46_0 : out std_logic;
    expect_47_0 : out std_logic
  );
end entity traffic_modes_expect;

architecture rtl of traffic_modes_expect is
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
  expect_3_0 <= ns_green;
  expect_3_1 <= turn_red;
  expect_3_2 <= ew_red;
  expect_4_0 <= ns_green;
  expect_4_1 <= turn_red;
  expect_4_2 <= ew_red;
  expect_5_0 <= ns_yellow;
  expect_5_1 <= turn_red;
  expect_5_2 <= ew_red;
  expect_6_0 <= ns_yellow;
  expect_6_1 <= turn_red;
  expect_6_2 <= ew_red;
  expect_7_0 <= ns_red;
  expect_7_1 <= turn_red;
  expect_7_2 <= ew_red;
  expect_8_0 <= ns_red;
  expect_8_1 <= turn_red;
  expect_8_2 <= ew_red;
  expect_9_0 <= ns_red;
  expect_9_1 <= turn_green;
  expect_9_2 <= ew_red;
  expect_10_0 <= ns_red;
  expect_10_1 <= turn_green;
  expect_10_2 <= ew_red;
  expect_11_0 <= ns_red;
  expect_11_1 <= turn_yellow;
  expect_11_2 <= ew_red;
  expect_12_0 <= ns_red;
  expect_12_1 <= turn_yellow;
  expect_12_2 <= ew_red;
  expect_13_0 <= ns_red;
  expect_13_1 <= turn_red;
  expect_13_2 <= ew_red;
  expect_14_0 <= ns_red;
  expect_14_1 <= turn_red;
  expect_14_2 <= ew_red;
  expect_15_0 <= ns_red;
  expect_15_1 <= turn_red;
  expect_15_2 <= ew_green;
  expect_16_0 <= ns_red;
  expect_16_1 <= turn_red;
  expect_16_2 <= ew_green;
  expect_17_0 <= ns_red;
  expect_17_1 <= turn_red;
  expect_17_2 <= ew_yellow;
  expect_18_0 <= ns_red;
  expect_18_1 <= turn_red;
  expect_18_2 <= ew_yellow;
  expect_19_0 <= ns_red;
  expect_19_1 <= turn_red;
  expect_19_2 <= ew_red;
  expect_20_0 <= ns_green;
  expect_20_1 <= turn_red;
  expect_20_2 <= ew_red;
  expect_21_0 <= ns_yellow;
  expect_21_1 <= turn_red;
  expect_21_2 <= ew_red;
  expect_22_0 <= ns_red;
  expect_22_1 <= turn_red;
  expect_22_2 <= ew_red;
  expect_23_0 <= ns_red;
  expect_23_1 <= turn_red;
  expect_23_2 <= ew_red;
  expect_24_0 <= ns_red;
  expect_24_1 <= turn_red;
  expect_24_2 <= ew_green;
  expect_25_0 <= ns_red;
  expect_25_1 <= turn_red;
  expect_25_2 <= ew_yellow;
  expect_26_0 <= ns_red;
  expect_26_1 <= turn_red;
  expect_26_2 <= ew_red;
  expect_27_0 <= turn_green;
  expect_28_0 <= turn_green;
  expect_29_0 <= turn_yellow;
  expect_30_0 <= turn_yellow;
  expect_31_0 <= ns_red;
  expect_31_1 <= turn_red;
  expect_31_2 <= ew_red;
  expect_32_0 <= ew_green;
  expect_33_0 <= ns_red;
  expect_33_1 <= turn_red;
  expect_33_2 <= ew_red;
  expect_34_0 <= ns_red;
  expect_34_1 <= turn_red;
  expect_34_2 <= ew_red;
  expect_35_0 <= ns_yellow;
  expect_35_1 <= turn_yellow;
  expect_35_2 <= ew_red;
  expect_35_3 <= not ns_red;
  expect_35_4 <= not turn_red;
  expect_35_5 <= not ns_green;
  expect_35_6 <= not turn_green;
  expect_35_7 <= not ew_green;
  expect_35_8 <= not ew_yellow;
  expect_36_0 <= ns_yellow;
  expect_36_1 <= turn_yellow;
  expect_36_2 <= ew_red;
  expect_37_0 <= not ns_yellow;
  expect_37_1 <= not turn_yellow;
  expect_37_2 <= not ew_red;
  expect_37_3 <= not ns_red;
  expect_37_4 <= not turn_red;
  expect_37_5 <= not ns_green;
  expect_37_6 <= not turn_green;
  expect_37_7 <= not ew_green;
  expect_37_8 <= not ew_yellow;
  expect_38_0 <= not ns_yellow;
  expect_38_1 <= not turn_yellow;
  expect_38_2 <= not ew_red;
  expect_39_0 <= ns_yellow;
  expect_40_0 <= ns_yellow;
  expect_41_0 <= not ns_yellow;
  expect_42_0 <= ns_red;
  expect_42_1 <= turn_red;
  expect_42_2 <= ew_red;
  expect_43_0 <= ns_red;
  expect_43_1 <= turn_red;
  expect_43_2 <= ew_red;
  expect_44_0 <= ns_green;
  expect_44_1 <= turn_red;
  expect_44_2 <= ew_red;
  expect_45_0 <= (ns_red and turn_red) or (ns_red and ew_red) or (turn_red and ew_red);
  expect_46_0 <= (ns_red and turn_red) or (ns_red and ew_red) or (turn_red and ew_red);
  expect_47_0 <=
      (ns_yellow and turn_yellow and ew_red) or (not ns_yellow and not turn_yellow and not ew_red);
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity traffic_modes_tb is
end entity;

architecture tests of traffic_modes_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal rush_hour : std_logic := '0';
  signal late_night : std_logic := '0';
  signal ns_green : std_logic;
  signal ns_yellow : std_logic;
  signal ns_red : std_logic;
  signal turn_green : std_logic;
  signal turn_yellow : std_logic;
  signal turn_red : std_logic;
  signal ew_green : std_logic;
  signal ew_yellow : std_logic;
  signal ew_red : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_2_2 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_6_2 : std_logic;
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
  signal expect_10_1 : std_logic;
  signal expect_10_2 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_11_2 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_12_2 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_13_1 : std_logic;
  signal expect_13_2 : std_logic;
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
  signal expect_18_2 : std_logic;
  signal expect_19_0 : std_logic;
  signal expect_19_1 : std_logic;
  signal expect_19_2 : std_logic;
  signal expect_20_0 : std_logic;
  signal expect_20_1 : std_logic;
  signal expect_20_2 : std_logic;
  signal expect_21_0 : std_logic;
  signal expect_21_1 : std_logic;
  signal expect_21_2 : std_logic;
  signal expect_22_0 : std_logic;
  signal expect_22_1 : std_logic;
  signal expect_22_2 : std_logic;
  signal expect_23_0 : std_logic;
  signal expect_23_1 : std_logic;
  signal expect_23_2 : std_logic;
  signal expect_24_0 : std_logic;
  signal expect_24_1 : std_logic;
  signal expect_24_2 : std_logic;
  signal expect_25_0 : std_logic;
  signal expect_25_1 : std_logic;
  signal expect_25_2 : std_logic;
  signal expect_26_0 : std_logic;
  signal expect_26_1 : std_logic;
  signal expect_26_2 : std_logic;
  signal expect_27_0 : std_logic;
  signal expect_28_0 : std_logic;
  signal expect_29_0 : std_logic;
  signal expect_30_0 : std_logic;
  signal expect_31_0 : std_logic;
  signal expect_31_1 : std_logic;
  signal expect_31_2 : std_logic;
  signal expect_32_0 : std_logic;
  signal expect_33_0 : std_logic;
  signal expect_33_1 : std_logic;
  signal expect_33_2 : std_logic;
  signal expect_34_0 : std_logic;
  signal expect_34_1 : std_logic;
  signal expect_34_2 : std_logic;
  signal expect_35_0 : std_logic;
  signal expect_35_1 : std_logic;
  signal expect_35_2 : std_logic;
  signal expect_35_3 : std_logic;
  signal expect_35_4 : std_logic;
  signal expect_35_5 : std_logic;
  signal expect_35_6 : std_logic;
  signal expect_35_7 : std_logic;
  signal expect_35_8 : std_logic;
  signal expect_36_0 : std_logic;
  signal expect_36_1 : std_logic;
  signal expect_36_2 : std_logic;
  signal expect_37_0 : std_logic;
  signal expect_37_1 : std_logic;
  signal expect_37_2 : std_logic;
  signal expect_37_3 : std_logic;
  signal expect_37_4 : std_logic;
  signal expect_37_5 : std_logic;
  signal expect_37_6 : std_logic;
  signal expect_37_7 : std_logic;
  signal expect_37_8 : std_logic;
  signal expect_38_0 : std_logic;
  signal expect_38_1 : std_logic;
  signal expect_38_2 : std_logic;
  signal expect_39_0 : std_logic;
  signal expect_40_0 : std_logic;
  signal expect_41_0 : std_logic;
  signal expect_42_0 : std_logic;
  signal expect_42_1 : std_logic;
  signal expect_42_2 : std_logic;
  signal expect_43_0 : std_logic;
  signal expect_43_1 : std_logic;
  signal expect_43_2 : std_logic;
  signal expect_44_0 : std_logic;
  signal expect_44_1 : std_logic;
  signal expect_44_2 : std_logic;
  signal expect_45_0 : std_logic;
  signal expect_46_0 : std_logic;
  signal expect_47_0 : std_logic;

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
  core : entity work.traffic_modes
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      rush_hour => rush_hour,
      late_night => late_night,
      ns_green => ns_green,
      ns_yellow => ns_yellow,
      ns_red => ns_red,
      turn_green => turn_green,
      turn_yellow => turn_yellow,
      turn_red => turn_red,
      ew_green => ew_green,
      ew_yellow => ew_yellow,
      ew_red => ew_red
    );

  expectations : entity work.traffic_modes_expect
    port map (
      clk => clk,
      rst => rst,
      ns_red => ns_red,
      turn_red => turn_red,
      ew_red => ew_red,
      ns_green => ns_green,
      ns_yellow => ns_yellow,
      turn_green => turn_green,
      turn_yellow => turn_yellow,
      ew_green => ew_green,
      ew_yellow => ew_yellow,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_2_2 => expect_2_2,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_6_2 => expect_6_2,
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
      expect_10_1 => expect_10_1,
      expect_10_2 => expect_10_2,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_11_2 => expect_11_2,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_12_2 => expect_12_2,
      expect_13_0 => expect_13_0,
      expect_13_1 => expect_13_1,
      expect_13_2 => expect_13_2,
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
      expect_18_2 => expect_18_2,
      expect_19_0 => expect_19_0,
      expect_19_1 => expect_19_1,
      expect_19_2 => expect_19_2,
      expect_20_0 => expect_20_0,
      expect_20_1 => expect_20_1,
      expect_20_2 => expect_20_2,
      expect_21_0 => expect_21_0,
      expect_21_1 => expect_21_1,
      expect_21_2 => expect_21_2,
      expect_22_0 => expect_22_0,
      expect_22_1 => expect_22_1,
      expect_22_2 => expect_22_2,
      expect_23_0 => expect_23_0,
      expect_23_1 => expect_23_1,
      expect_23_2 => expect_23_2,
      expect_24_0 => expect_24_0,
      expect_24_1 => expect_24_1,
      expect_24_2 => expect_24_2,
      expect_25_0 => expect_25_0,
      expect_25_1 => expect_25_1,
      expect_25_2 => expect_25_2,
      expect_26_0 => expect_26_0,
      expect_26_1 => expect_26_1,
      expect_26_2 => expect_26_2,
      expect_27_0 => expect_27_0,
      expect_28_0 => expect_28_0,
      expect_29_0 => expect_29_0,
      expect_30_0 => expect_30_0,
      expect_31_0 => expect_31_0,
      expect_31_1 => expect_31_1,
      expect_31_2 => expect_31_2,
      expect_32_0 => expect_32_0,
      expect_33_0 => expect_33_0,
      expect_33_1 => expect_33_1,
      expect_33_2 => expect_33_2,
      expect_34_0 => expect_34_0,
      expect_34_1 => expect_34_1,
      expect_34_2 => expect_34_2,
      expect_35_0 => expect_35_0,
      expect_35_1 => expect_35_1,
      expect_35_2 => expect_35_2,
      expect_35_3 => expect_35_3,
      expect_35_4 => expect_35_4,
      expect_35_5 => expect_35_5,
      expect_35_6 => expect_35_6,
      expect_35_7 => expect_35_7,
      expect_35_8 => expect_35_8,
      expect_36_0 => expect_36_0,
      expect_36_1 => expect_36_1,
      expect_36_2 => expect_36_2,
      expect_37_0 => expect_37_0,
      expect_37_1 => expect_37_1,
      expect_37_2 => expect_37_2,
      expect_37_3 => expect_37_3,
      expect_37_4 => expect_37_4,
      expect_37_5 => expect_37_5,
      expect_37_6 => expect_37_6,
      expect_37_7 => expect_37_7,
      expect_37_8 => expect_37_8,
      expect_38_0 => expect_38_0,
      expect_38_1 => expect_38_1,
      expect_38_2 => expect_38_2,
      expect_39_0 => expect_39_0,
      expect_40_0 => expect_40_0,
      expect_41_0 => expect_41_0,
      expect_42_0 => expect_42_0,
      expect_42_1 => expect_42_1,
      expect_42_2 => expect_42_2,
      expect_43_0 => expect_43_0,
      expect_43_1 => expect_43_1,
      expect_43_2 => expect_43_2,
      expect_44_0 => expect_44_0,
      expect_44_1 => expect_44_1,
      expect_44_2 => expect_44_2,
      expect_45_0 => expect_45_0,
      expect_46_0 => expect_46_0,
      expect_47_0 => expect_47_0
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
      rush_hour <= '0';
      late_night <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..8");

    -- all lanes are red before the first scan
    failed := false;
    reset;
    wait for 1 ns; -- traffic_modes.ladder:67
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

    -- a day: six intervals, and a second of red between two greens
    failed := false;
    reset;
    scan(1, '0');
    wait for 1 ns; -- traffic_modes.ladder:71
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    for round in 1 to 3 loop
      scan(9, '1');
      wait for 1 ns; -- traffic_modes.ladder:74
      if not failed and (expect_2_0 and expect_2_1 and expect_2_2) /= '1' then
        failed := true;
        print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:76
      if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
        failed := true;
        print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
            & " ns_green=" & image(ns_green)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(119, '1');
      wait for 1 ns; -- traffic_modes.ladder:78
      if not failed and (expect_4_0 and expect_4_1 and expect_4_2) /= '1' then
        failed := true;
        print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2)
            & " ns_green=" & image(ns_green)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:80
      if not failed and (expect_5_0 and expect_5_1 and expect_5_2) /= '1' then
        failed := true;
        print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(29, '1');
      wait for 1 ns; -- traffic_modes.ladder:82
      if not failed and (expect_6_0 and expect_6_1 and expect_6_2) /= '1' then
        failed := true;
        print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:84
      if not failed and (expect_7_0 and expect_7_1 and expect_7_2) /= '1' then
        failed := true;
        print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(9, '1');
      wait for 1 ns; -- traffic_modes.ladder:86
      if not failed and (expect_8_0 and expect_8_1 and expect_8_2) /= '1' then
        failed := true;
        print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:88
      if not failed and (expect_9_0 and expect_9_1 and expect_9_2) /= '1' then
        failed := true;
        print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2)
            & " ns_red=" & image(ns_red)
            & " turn_green=" & image(turn_green)
            & " ew_red=" & image(ew_red));
      end if;
      scan(59, '1');
      wait for 1 ns; -- traffic_modes.ladder:90
      if not failed and (expect_10_0 and expect_10_1 and expect_10_2) /= '1' then
        failed := true;
        print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1) & image(expect_10_2)
            & " ns_red=" & image(ns_red)
            & " turn_green=" & image(turn_green)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:92
      if not failed and (expect_11_0 and expect_11_1 and expect_11_2) /= '1' then
        failed := true;
        print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1) & image(expect_11_2)
            & " ns_red=" & image(ns_red)
            & " turn_yellow=" & image(turn_yellow)
            & " ew_red=" & image(ew_red));
      end if;
      scan(29, '1');
      wait for 1 ns; -- traffic_modes.ladder:94
      if not failed and (expect_12_0 and expect_12_1 and expect_12_2) /= '1' then
        failed := true;
        print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1) & image(expect_12_2)
            & " ns_red=" & image(ns_red)
            & " turn_yellow=" & image(turn_yellow)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:96
      if not failed and (expect_13_0 and expect_13_1 and expect_13_2) /= '1' then
        failed := true;
        print("# failed expectation 13 conducts " & image(expect_13_0) & image(expect_13_1) & image(expect_13_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(9, '1');
      wait for 1 ns; -- traffic_modes.ladder:98
      if not failed and (expect_14_0 and expect_14_1 and expect_14_2) /= '1' then
        failed := true;
        print("# failed expectation 14 conducts " & image(expect_14_0) & image(expect_14_1) & image(expect_14_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:100
      if not failed and (expect_15_0 and expect_15_1 and expect_15_2) /= '1' then
        failed := true;
        print("# failed expectation 15 conducts " & image(expect_15_0) & image(expect_15_1) & image(expect_15_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_green=" & image(ew_green));
      end if;
      scan(99, '1');
      wait for 1 ns; -- traffic_modes.ladder:102
      if not failed and (expect_16_0 and expect_16_1 and expect_16_2) /= '1' then
        failed := true;
        print("# failed expectation 16 conducts " & image(expect_16_0) & image(expect_16_1) & image(expect_16_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_green=" & image(ew_green));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:104
      if not failed and (expect_17_0 and expect_17_1 and expect_17_2) /= '1' then
        failed := true;
        print("# failed expectation 17 conducts " & image(expect_17_0) & image(expect_17_1) & image(expect_17_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_yellow=" & image(ew_yellow));
      end if;
      scan(29, '1');
      wait for 1 ns; -- traffic_modes.ladder:106
      if not failed and (expect_18_0 and expect_18_1 and expect_18_2) /= '1' then
        failed := true;
        print("# failed expectation 18 conducts " & image(expect_18_0) & image(expect_18_1) & image(expect_18_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_yellow=" & image(ew_yellow));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:108
      if not failed and (expect_19_0 and expect_19_1 and expect_19_2) /= '1' then
        failed := true;
        print("# failed expectation 19 conducts " & image(expect_19_0) & image(expect_19_1) & image(expect_19_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 2 - a day: six intervals, and a second of red between two greens");
    else
      print("ok 2 - a day: six intervals, and a second of red between two greens");
    end if;

    -- rush hour: from north-south to east-west with one second of red
    failed := false;
    reset;
    rush_hour <= '1';
    scan(1, '0');
    scan(10, '1');
    for round in 1 to 2 loop
      wait for 1 ns; -- traffic_modes.ladder:115
      if not failed and (expect_20_0 and expect_20_1 and expect_20_2) /= '1' then
        failed := true;
        print("# failed expectation 20 conducts " & image(expect_20_0) & image(expect_20_1) & image(expect_20_2)
            & " ns_green=" & image(ns_green)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(120, '1');
      wait for 1 ns; -- traffic_modes.ladder:117
      if not failed and (expect_21_0 and expect_21_1 and expect_21_2) /= '1' then
        failed := true;
        print("# failed expectation 21 conducts " & image(expect_21_0) & image(expect_21_1) & image(expect_21_2)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(30, '1');
      wait for 1 ns; -- traffic_modes.ladder:119
      if not failed and (expect_22_0 and expect_22_1 and expect_22_2) /= '1' then
        failed := true;
        print("# failed expectation 22 conducts " & image(expect_22_0) & image(expect_22_1) & image(expect_22_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(9, '1');
      wait for 1 ns; -- traffic_modes.ladder:121
      if not failed and (expect_23_0 and expect_23_1 and expect_23_2) /= '1' then
        failed := true;
        print("# failed expectation 23 conducts " & image(expect_23_0) & image(expect_23_1) & image(expect_23_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:123
      if not failed and (expect_24_0 and expect_24_1 and expect_24_2) /= '1' then
        failed := true;
        print("# failed expectation 24 conducts " & image(expect_24_0) & image(expect_24_1) & image(expect_24_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_green=" & image(ew_green));
      end if;
      scan(100, '1');
      wait for 1 ns; -- traffic_modes.ladder:125
      if not failed and (expect_25_0 and expect_25_1 and expect_25_2) /= '1' then
        failed := true;
        print("# failed expectation 25 conducts " & image(expect_25_0) & image(expect_25_1) & image(expect_25_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_yellow=" & image(ew_yellow));
      end if;
      scan(30, '1');
      wait for 1 ns; -- traffic_modes.ladder:127
      if not failed and (expect_26_0 and expect_26_1 and expect_26_2) /= '1' then
        failed := true;
        print("# failed expectation 26 conducts " & image(expect_26_0) & image(expect_26_1) & image(expect_26_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(10, '1');
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 3 - rush hour: from north-south to east-west with one second of red");
    else
      print("ok 3 - rush hour: from north-south to east-west with one second of red");
    end if;

    -- rush hour chosen while the lane turns: it still gets its yellow
    failed := false;
    reset;
    scan(1, '0');
    scan(170, '1');
    wait for 1 ns; -- traffic_modes.ladder:134
    if not failed and (expect_27_0) /= '1' then
      failed := true;
      print("# failed expectation 27 conducts " & image(expect_27_0)
          & " turn_green=" & image(turn_green));
    end if;
    rush_hour <= '1';
    scan(59, '1');
    wait for 1 ns; -- traffic_modes.ladder:137
    if not failed and (expect_28_0) /= '1' then
      failed := true;
      print("# failed expectation 28 conducts " & image(expect_28_0)
          & " turn_green=" & image(turn_green));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_modes.ladder:139
    if not failed and (expect_29_0) /= '1' then
      failed := true;
      print("# failed expectation 29 conducts " & image(expect_29_0)
          & " turn_yellow=" & image(turn_yellow));
    end if;
    scan(29, '1');
    wait for 1 ns; -- traffic_modes.ladder:141
    if not failed and (expect_30_0) /= '1' then
      failed := true;
      print("# failed expectation 30 conducts " & image(expect_30_0)
          & " turn_yellow=" & image(turn_yellow));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_modes.ladder:143
    if not failed and (expect_31_0 and expect_31_1 and expect_31_2) /= '1' then
      failed := true;
      print("# failed expectation 31 conducts " & image(expect_31_0) & image(expect_31_1) & image(expect_31_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(10, '1');
    wait for 1 ns; -- traffic_modes.ladder:145
    if not failed and (expect_32_0) /= '1' then
      failed := true;
      print("# failed expectation 32 conducts " & image(expect_32_0)
          & " ew_green=" & image(ew_green));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - rush hour chosen while the lane turns: it still gets its yellow");
    else
      print("ok 4 - rush hour chosen while the lane turns: it still gets its yellow");
    end if;

    -- late night begins when east-west is through
    failed := false;
    reset;
    scan(1, '0');
    scan(10, '1');
    late_night <= '1';
    scan(390, '1');
    wait for 1 ns; -- traffic_modes.ladder:152
    if not failed and (expect_33_0 and expect_33_1 and expect_33_2) /= '1' then
      failed := true;
      print("# failed expectation 33 conducts " & image(expect_33_0) & image(expect_33_1) & image(expect_33_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(9, '1');
    wait for 1 ns; -- traffic_modes.ladder:154
    if not failed and (expect_34_0 and expect_34_1 and expect_34_2) /= '1' then
      failed := true;
      print("# failed expectation 34 conducts " & image(expect_34_0) & image(expect_34_1) & image(expect_34_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(1, '1');
    for round in 1 to 5 loop
      wait for 1 ns; -- traffic_modes.ladder:157
      if not failed and (expect_35_0 and expect_35_1 and expect_35_2 and expect_35_3 and expect_35_4 and expect_35_5 and expect_35_6 and expect_35_7 and expect_35_8) /= '1' then
        failed := true;
        print("# failed expectation 35 conducts " & image(expect_35_0) & image(expect_35_1) & image(expect_35_2) & image(expect_35_3) & image(expect_35_4) & image(expect_35_5) & image(expect_35_6) & image(expect_35_7) & image(expect_35_8)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_yellow=" & image(turn_yellow)
            & " ew_red=" & image(ew_red)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ns_green=" & image(ns_green)
            & " turn_green=" & image(turn_green)
            & " ew_green=" & image(ew_green)
            & " ew_yellow=" & image(ew_yellow));
      end if;
      scan(4, '1');
      wait for 1 ns; -- traffic_modes.ladder:160
      if not failed and (expect_36_0 and expect_36_1 and expect_36_2) /= '1' then
        failed := true;
        print("# failed expectation 36 conducts " & image(expect_36_0) & image(expect_36_1) & image(expect_36_2)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_yellow=" & image(turn_yellow)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_modes.ladder:162
      if not failed and (expect_37_0 and expect_37_1 and expect_37_2 and expect_37_3 and expect_37_4 and expect_37_5 and expect_37_6 and expect_37_7 and expect_37_8) /= '1' then
        failed := true;
        print("# failed expectation 37 conducts " & image(expect_37_0) & image(expect_37_1) & image(expect_37_2) & image(expect_37_3) & image(expect_37_4) & image(expect_37_5) & image(expect_37_6) & image(expect_37_7) & image(expect_37_8)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_yellow=" & image(turn_yellow)
            & " ew_red=" & image(ew_red)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ns_green=" & image(ns_green)
            & " turn_green=" & image(turn_green)
            & " ew_green=" & image(ew_green)
            & " ew_yellow=" & image(ew_yellow));
      end if;
      scan(4, '1');
      wait for 1 ns; -- traffic_modes.ladder:165
      if not failed and (expect_38_0 and expect_38_1 and expect_38_2) /= '1' then
        failed := true;
        print("# failed expectation 38 conducts " & image(expect_38_0) & image(expect_38_1) & image(expect_38_2)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_yellow=" & image(turn_yellow)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 5 - late night begins when east-west is through");
    else
      print("ok 5 - late night begins when east-west is through");
    end if;

    -- morning: the blink ends, then all red, then north-south
    failed := false;
    reset;
    late_night <= '1';
    scan(1, '0');
    scan(10, '1');
    wait for 1 ns; -- traffic_modes.ladder:172
    if not failed and (expect_39_0) /= '1' then
      failed := true;
      print("# failed expectation 39 conducts " & image(expect_39_0)
          & " ns_yellow=" & image(ns_yellow));
    end if;
    scan(2, '1');
    late_night <= '0';
    scan(1, '0');
    wait for 1 ns; -- traffic_modes.ladder:175
    if not failed and (expect_40_0) /= '1' then
      failed := true;
      print("# failed expectation 40 conducts " & image(expect_40_0)
          & " ns_yellow=" & image(ns_yellow));
    end if;
    scan(3, '1');
    wait for 1 ns; -- traffic_modes.ladder:177
    if not failed and (expect_41_0) /= '1' then
      failed := true;
      print("# failed expectation 41 conducts " & image(expect_41_0)
          & " ns_yellow=" & image(ns_yellow));
    end if;
    scan(5, '1');
    wait for 1 ns; -- traffic_modes.ladder:179
    if not failed and (expect_42_0 and expect_42_1 and expect_42_2) /= '1' then
      failed := true;
      print("# failed expectation 42 conducts " & image(expect_42_0) & image(expect_42_1) & image(expect_42_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(9, '1');
    wait for 1 ns; -- traffic_modes.ladder:181
    if not failed and (expect_43_0 and expect_43_1 and expect_43_2) /= '1' then
      failed := true;
      print("# failed expectation 43 conducts " & image(expect_43_0) & image(expect_43_1) & image(expect_43_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    scan(1, '1');
    wait for 1 ns; -- traffic_modes.ladder:183
    if not failed and (expect_44_0 and expect_44_1 and expect_44_2) /= '1' then
      failed := true;
      print("# failed expectation 44 conducts " & image(expect_44_0) & image(expect_44_1) & image(expect_44_2)
          & " ns_green=" & image(ns_green)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - morning: the blink ends, then all red, then north-south");
    else
      print("ok 6 - morning: the blink ends, then all red, then north-south");
    end if;

    -- selectors that are turned at every moment never set two lanes free
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 150 loop
      rush_hour <= '1';
      scan(5, '1');
      wait for 1 ns; -- traffic_modes.ladder:189
      if not failed and (expect_45_0) /= '1' then
        failed := true;
        print("# failed expectation 45 conducts " & image(expect_45_0)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      rush_hour <= '0';
      scan(2, '1');
      wait for 1 ns; -- traffic_modes.ladder:191
      if not failed and (expect_46_0) /= '1' then
        failed := true;
        print("# failed expectation 46 conducts " & image(expect_46_0)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 7 - selectors that are turned at every moment never set two lanes free");
    else
      print("ok 7 - selectors that are turned at every moment never set two lanes free");
    end if;

    -- both selectors: the night has no lanes to leave out
    failed := false;
    reset;
    late_night <= '1';
    rush_hour <= '1';
    scan(1, '0');
    scan(10, '1');
    for round in 1 to 30 loop
      wait for 1 ns; -- traffic_modes.ladder:198
      if not failed and (expect_47_0) /= '1' then
        failed := true;
        print("# failed expectation 47 conducts " & image(expect_47_0)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_yellow=" & image(turn_yellow)
            & " ew_red=" & image(ew_red));
      end if;
      scan(3, '1');
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 8 - both selectors: the night has no lanes to leave out");
    else
      print("ok 8 - both selectors: the night has no lanes to leave out");
    end if;

    assert failures = 0 report integer'image(failures) & " of 8 tests failed" severity failure;
    wait;
  end process;
end architecture;
