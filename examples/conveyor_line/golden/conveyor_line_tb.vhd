-- Made by hotrail 0.1.0 from conveyor_line.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_line_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    C3          : in  std_logic;
    C2          : in  std_logic;
    C1          : in  std_logic;
    fault_1     : in  std_logic;
    fault_2     : in  std_logic;
    fault_3     : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_1_2  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_4_0  : out std_logic;
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
    expect_9_3  : out std_logic;
    expect_9_4  : out std_logic;
    expect_9_5  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_10_2 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_11_2 : out std_logic;
    expect_12_0 : out std_logic;
    expect_12_1 : out std_logic;
    expect_13_0 : out std_logic;
    expect_13_1 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
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
    expect_20_1 : out std_logic;
    expect_21_0 : out std_logic;
    expect_22_0 : out std_logic;
    expect_22_1 : out std_logic;
    expect_23_0 : out std_logic;
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
    expect_27_1 : out std_logic;
    expect_28_0 : out std_logic;
    expect_29_0 : out std_logic;
    expect_29_1 : out std_logic;
    expect_29_2 : out std_logic;
    expect_30_0 : out std_logic;
    expect_30_1 : out std_logic;
    expect_31_0 : out std_logic;
    expect_31_1 : out std_logic;
    expect_32_0 : out std_logic;
    expect_32_1 : out std_logic;
    expect_32_2 : out std_logic;
    expect_32_3 : out std_logic;
    expect_32_4 : out std_logic;
    expect_32_5 : out std_logic;
    expect_33_0 : out std_logic;
    expect_33_1 : out std_logic;
    expect_34_0 : out std_logic;
    expect_34_1 : out std_logic;
    expect_35_0 : out std_logic;
    expect_35_1 : out std_logic;
    expect_36_0 : out std_logic;
    expect_36_1 : out std_logic;
    expect_36_2 : out std_logic;
    expect_36_3 : out std_logic;
    expect_37_0 : out std_logic;
    expect_37_1 : out std_logic;
    expect_38_0 : out std_logic;
    expect_38_1 : out std_logic;
    expect_39_0 : out std_logic;
    expect_39_1 : out std_logic;
    expect_40_0 : out std_logic;
    expect_41_0 : out std_logic;
    expect_41_1 : out std_logic;
    expect_41_2 : out std_logic;
    expect_41_3 : out std_logic;
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
    expect_45_1 : out std_logic;
    expect_45_2 : out std_logic;
    expect_46_0 : out std_logic;
    expect_46_1 : out std_logic;
    expect_47_0 : out std_logic;
    expect_48_0 : out std_logic;
    expect_48_1 : out std_logic;
    expect_48_2 : out std_logic
  );
end entity conveyor_line_expect;

architecture rtl of conveyor_line_expect is
begin

  expect_0_0 <= C3;
  expect_0_1 <= not C2;
  expect_0_2 <= not C1;
  expect_1_0 <= C3;
  expect_1_1 <= C2;
  expect_1_2 <= not C1;
  expect_2_0 <= C3;
  expect_2_1 <= C2;
  expect_3_0 <= C3;
  expect_3_1 <= not C2;
  expect_4_0 <= C3;
  expect_5_0 <= not C3;
  expect_5_1 <= not C2;
  expect_5_2 <= not C1;
  expect_6_0 <= C3;
  expect_6_1 <= not C2;
  expect_6_2 <= not C1;
  expect_7_0 <= C3;
  expect_7_1 <= C2;
  expect_7_2 <= not C1;
  expect_8_0 <= C3;
  expect_8_1 <= C2;
  expect_8_2 <= C1;
  expect_9_0 <= C3;
  expect_9_1 <= C2;
  expect_9_2 <= C1;
  expect_9_3 <= not fault_1;
  expect_9_4 <= not fault_2;
  expect_9_5 <= not fault_3;
  expect_10_0 <= C1;
  expect_10_1 <= C2;
  expect_10_2 <= C3;
  expect_11_0 <= not C1;
  expect_11_1 <= C2;
  expect_11_2 <= C3;
  expect_12_0 <= C2;
  expect_12_1 <= C3;
  expect_13_0 <= not C2;
  expect_13_1 <= C3;
  expect_14_0 <= C3;
  expect_15_0 <= not C3;
  expect_16_0 <= not C1;
  expect_16_1 <= not C2;
  expect_16_2 <= not C3;
  expect_17_0 <= C1;
  expect_17_1 <= C2;
  expect_17_2 <= C3;
  expect_18_0 <= not C2;
  expect_18_1 <= C3;
  expect_19_0 <= C3;
  expect_20_0 <= C2;
  expect_20_1 <= C3;
  expect_21_0 <= C2;
  expect_22_0 <= not C2;
  expect_22_1 <= C3;
  expect_23_0 <= not C3;
  expect_24_0 <= not C1;
  expect_24_1 <= C2;
  expect_24_2 <= C3;
  expect_25_0 <= C1;
  expect_25_1 <= not C2;
  expect_25_2 <= C3;
  expect_26_0 <= not C1;
  expect_26_1 <= not C2;
  expect_26_2 <= C3;
  expect_27_0 <= C2;
  expect_27_1 <= not C1;
  expect_28_0 <= C1;
  expect_29_0 <= not C1;
  expect_29_1 <= C2;
  expect_29_2 <= C3;
  expect_30_0 <= C2;
  expect_30_1 <= not fault_2;
  expect_31_0 <= C2;
  expect_31_1 <= fault_2;
  expect_32_0 <= not C1;
  expect_32_1 <= not C2;
  expect_32_2 <= C3;
  expect_32_3 <= fault_2;
  expect_32_4 <= not fault_1;
  expect_32_5 <= not fault_3;
  expect_33_0 <= not C2;
  expect_33_1 <= C3;
  expect_34_0 <= C2;
  expect_34_1 <= not fault_2;
  expect_35_0 <= C3;
  expect_35_1 <= not fault_3;
  expect_36_0 <= not C3;
  expect_36_1 <= not C2;
  expect_36_2 <= not C1;
  expect_36_3 <= fault_3;
  expect_37_0 <= C3;
  expect_37_1 <= not fault_3;
  expect_38_0 <= not C3;
  expect_38_1 <= fault_3;
  expect_39_0 <= not C3;
  expect_39_1 <= fault_3;
  expect_40_0 <= C1;
  expect_41_0 <= not C1;
  expect_41_1 <= C2;
  expect_41_2 <= C3;
  expect_41_3 <= fault_1;
  expect_42_0 <= C1;
  expect_42_1 <= C2;
  expect_42_2 <= C3;
  expect_43_0 <= not C1;
  expect_43_1 <= not C2;
  expect_43_2 <= not C3;
  expect_44_0 <= not C1;
  expect_44_1 <= not C2;
  expect_44_2 <= not C3;
  expect_45_0 <= not C1;
  expect_45_1 <= C2;
  expect_45_2 <= C3;
  expect_46_0 <= not C2;
  expect_46_1 <= C3;
  expect_47_0 <= not C3;
  expect_48_0 <= C1;
  expect_48_1 <= C2;
  expect_48_2 <= C3;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity conveyor_line_tb is
end entity;

architecture tests of conveyor_line_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal reset_faults : std_logic := '0';
  signal stop : std_logic := '0';
  signal L1 : std_logic := '0';
  signal L2 : std_logic := '0';
  signal L3 : std_logic := '0';
  signal L4 : std_logic := '0';
  signal P1 : std_logic := '0';
  signal P2 : std_logic := '0';
  signal P3 : std_logic := '0';
  signal C1 : std_logic;
  signal C2 : std_logic;
  signal C3 : std_logic;
  signal fault_1 : std_logic;
  signal fault_2 : std_logic;
  signal fault_3 : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
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
  signal expect_9_3 : std_logic;
  signal expect_9_4 : std_logic;
  signal expect_9_5 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_10_2 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_11_2 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_13_1 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
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
  signal expect_20_1 : std_logic;
  signal expect_21_0 : std_logic;
  signal expect_22_0 : std_logic;
  signal expect_22_1 : std_logic;
  signal expect_23_0 : std_logic;
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
  signal expect_27_1 : std_logic;
  signal expect_28_0 : std_logic;
  signal expect_29_0 : std_logic;
  signal expect_29_1 : std_logic;
  signal expect_29_2 : std_logic;
  signal expect_30_0 : std_logic;
  signal expect_30_1 : std_logic;
  signal expect_31_0 : std_logic;
  signal expect_31_1 : std_logic;
  signal expect_32_0 : std_logic;
  signal expect_32_1 : std_logic;
  signal expect_32_2 : std_logic;
  signal expect_32_3 : std_logic;
  signal expect_32_4 : std_logic;
  signal expect_32_5 : std_logic;
  signal expect_33_0 : std_logic;
  signal expect_33_1 : std_logic;
  signal expect_34_0 : std_logic;
  signal expect_34_1 : std_logic;
  signal expect_35_0 : std_logic;
  signal expect_35_1 : std_logic;
  signal expect_36_0 : std_logic;
  signal expect_36_1 : std_logic;
  signal expect_36_2 : std_logic;
  signal expect_36_3 : std_logic;
  signal expect_37_0 : std_logic;
  signal expect_37_1 : std_logic;
  signal expect_38_0 : std_logic;
  signal expect_38_1 : std_logic;
  signal expect_39_0 : std_logic;
  signal expect_39_1 : std_logic;
  signal expect_40_0 : std_logic;
  signal expect_41_0 : std_logic;
  signal expect_41_1 : std_logic;
  signal expect_41_2 : std_logic;
  signal expect_41_3 : std_logic;
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
  signal expect_45_1 : std_logic;
  signal expect_45_2 : std_logic;
  signal expect_46_0 : std_logic;
  signal expect_46_1 : std_logic;
  signal expect_47_0 : std_logic;
  signal expect_48_0 : std_logic;
  signal expect_48_1 : std_logic;
  signal expect_48_2 : std_logic;

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
  core : entity work.conveyor_line
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      reset_faults => reset_faults,
      stop => stop,
      L1 => L1,
      L2 => L2,
      L3 => L3,
      L4 => L4,
      P1 => P1,
      P2 => P2,
      P3 => P3,
      C1 => C1,
      C2 => C2,
      C3 => C3,
      fault_1 => fault_1,
      fault_2 => fault_2,
      fault_3 => fault_3
    );

  expectations : entity work.conveyor_line_expect
    port map (
      clk => clk,
      rst => rst,
      C3 => C3,
      C2 => C2,
      C1 => C1,
      fault_1 => fault_1,
      fault_2 => fault_2,
      fault_3 => fault_3,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
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
      expect_9_3 => expect_9_3,
      expect_9_4 => expect_9_4,
      expect_9_5 => expect_9_5,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_10_2 => expect_10_2,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_11_2 => expect_11_2,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_13_0 => expect_13_0,
      expect_13_1 => expect_13_1,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
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
      expect_20_1 => expect_20_1,
      expect_21_0 => expect_21_0,
      expect_22_0 => expect_22_0,
      expect_22_1 => expect_22_1,
      expect_23_0 => expect_23_0,
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
      expect_27_1 => expect_27_1,
      expect_28_0 => expect_28_0,
      expect_29_0 => expect_29_0,
      expect_29_1 => expect_29_1,
      expect_29_2 => expect_29_2,
      expect_30_0 => expect_30_0,
      expect_30_1 => expect_30_1,
      expect_31_0 => expect_31_0,
      expect_31_1 => expect_31_1,
      expect_32_0 => expect_32_0,
      expect_32_1 => expect_32_1,
      expect_32_2 => expect_32_2,
      expect_32_3 => expect_32_3,
      expect_32_4 => expect_32_4,
      expect_32_5 => expect_32_5,
      expect_33_0 => expect_33_0,
      expect_33_1 => expect_33_1,
      expect_34_0 => expect_34_0,
      expect_34_1 => expect_34_1,
      expect_35_0 => expect_35_0,
      expect_35_1 => expect_35_1,
      expect_36_0 => expect_36_0,
      expect_36_1 => expect_36_1,
      expect_36_2 => expect_36_2,
      expect_36_3 => expect_36_3,
      expect_37_0 => expect_37_0,
      expect_37_1 => expect_37_1,
      expect_38_0 => expect_38_0,
      expect_38_1 => expect_38_1,
      expect_39_0 => expect_39_0,
      expect_39_1 => expect_39_1,
      expect_40_0 => expect_40_0,
      expect_41_0 => expect_41_0,
      expect_41_1 => expect_41_1,
      expect_41_2 => expect_41_2,
      expect_41_3 => expect_41_3,
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
      expect_45_1 => expect_45_1,
      expect_45_2 => expect_45_2,
      expect_46_0 => expect_46_0,
      expect_46_1 => expect_46_1,
      expect_47_0 => expect_47_0,
      expect_48_0 => expect_48_0,
      expect_48_1 => expect_48_1,
      expect_48_2 => expect_48_2
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
      reset_faults <= '0';
      stop <= '0';
      L1 <= '0';
      L2 <= '0';
      L3 <= '0';
      L4 <= '0';
      P1 <= '0';
      P2 <= '0';
      P3 <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..10");

    -- after power-up the conveyors run empty
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L3 <= '1';
    L4 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:46
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " C3=" & image(C3)
          & " C2=" & image(C2)
          & " C1=" & image(C1));
    end if;
    scan(30, '1');
    P3 <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:49
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2)
          & " C3=" & image(C3)
          & " C2=" & image(C2)
          & " C1=" & image(C1));
    end if;
    P2 <= '1';
    scan(1, '0');
    scan(99, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:53
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " C3=" & image(C3)
          & " C2=" & image(C2));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:56
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " C3=" & image(C3)
          & " C2=" & image(C2));
    end if;
    P2 <= '0';
    scan(99, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:60
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " C3=" & image(C3));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:63
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2)
          & " C3=" & image(C3)
          & " C2=" & image(C2)
          & " C1=" & image(C1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - after power-up the conveyors run empty");
    else
      print("ok 1 - after power-up the conveyors run empty");
    end if;

    -- they start from the bin upwards
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L2 <= '1';
    L3 <= '1';
    L4 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:68
    if not failed and (expect_6_0 and expect_6_1 and expect_6_2) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2)
          & " C3=" & image(C3)
          & " C2=" & image(C2)
          & " C1=" & image(C1));
    end if;
    scan(39, '1');
    P3 <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:71
    if not failed and (expect_7_0 and expect_7_1 and expect_7_2) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2)
          & " C3=" & image(C3)
          & " C2=" & image(C2)
          & " C1=" & image(C1));
    end if;
    scan(39, '1');
    P2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:74
    if not failed and (expect_8_0 and expect_8_1 and expect_8_2) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2)
          & " C3=" & image(C3)
          & " C2=" & image(C2)
          & " C1=" & image(C1));
    end if;
    scan(39, '1');
    P1 <= '1';
    L2 <= '0';
    scan(1, '0');
    scan(600, '1');
    wait for 1 ns; -- conveyor_line.ladder:78
    if not failed and (expect_9_0 and expect_9_1 and expect_9_2 and expect_9_3 and expect_9_4 and expect_9_5) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2) & image(expect_9_3) & image(expect_9_4) & image(expect_9_5)
          & " C3=" & image(C3)
          & " C2=" & image(C2)
          & " C1=" & image(C1)
          & " fault_1=" & image(fault_1)
          & " fault_2=" & image(fault_2)
          & " fault_3=" & image(fault_3));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - they start from the bin upwards");
    else
      print("ok 2 - they start from the bin upwards");
    end if;

    -- a full bin: the conveyors run empty one after the other, and wait for the low level
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L2 <= '1';
    L3 <= '1';
    L4 <= '1';
    P1 <= '1';
    P2 <= '1';
    P3 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    L2 <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:84
    if not failed and (expect_10_0 and expect_10_1 and expect_10_2) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1) & image(expect_10_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    L1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:86
    if not failed and (expect_11_0 and expect_11_1 and expect_11_2) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1) & image(expect_11_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    scan(99, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:89
    if not failed and (expect_12_0 and expect_12_1) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:92
    if not failed and (expect_13_0 and expect_13_1) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0) & image(expect_13_1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    scan(99, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:95
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " C3=" & image(C3));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:98
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " C3=" & image(C3));
    end if;
    L1 <= '1';
    scan(300, '1');
    wait for 1 ns; -- conveyor_line.ladder:100
    if not failed and (expect_16_0 and expect_16_1 and expect_16_2) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0) & image(expect_16_1) & image(expect_16_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    L2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:102
    if not failed and (expect_17_0 and expect_17_1 and expect_17_2) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0) & image(expect_17_1) & image(expect_17_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a full bin: the conveyors run empty one after the other, and wait for the low level");
    else
      print("ok 3 - a full bin: the conveyors run empty one after the other, and wait for the low level");
    end if;

    -- a conveyor that waits does not run empty
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L2 <= '1';
    L3 <= '1';
    L4 <= '1';
    P1 <= '1';
    P2 <= '1';
    P3 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    L1 <= '0';
    L2 <= '0';
    scan(1, '0');
    scan(50, '1');
    L4 <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:110
    if not failed and (expect_18_0 and expect_18_1) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0) & image(expect_18_1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    scan(300, '1');
    wait for 1 ns; -- conveyor_line.ladder:112
    if not failed and (expect_19_0) /= '1' then
      failed := true;
      print("# failed expectation 19 conducts " & image(expect_19_0)
          & " C3=" & image(C3));
    end if;
    L4 <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:114
    if not failed and (expect_20_0 and expect_20_1) /= '1' then
      failed := true;
      print("# failed expectation 20 conducts " & image(expect_20_0) & image(expect_20_1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    scan(49, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:117
    if not failed and (expect_21_0) /= '1' then
      failed := true;
      print("# failed expectation 21 conducts " & image(expect_21_0)
          & " C2=" & image(C2));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:120
    if not failed and (expect_22_0 and expect_22_1) /= '1' then
      failed := true;
      print("# failed expectation 22 conducts " & image(expect_22_0) & image(expect_22_1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    scan(100, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:123
    if not failed and (expect_23_0) /= '1' then
      failed := true;
      print("# failed expectation 23 conducts " & image(expect_23_0)
          & " C3=" & image(C3));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a conveyor that waits does not run empty");
    else
      print("ok 4 - a conveyor that waits does not run empty");
    end if;

    -- a hopper that is full stops the conveyor above it and no other
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L2 <= '1';
    L3 <= '1';
    L4 <= '1';
    P1 <= '1';
    P2 <= '1';
    P3 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    L3 <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:129
    if not failed and (expect_24_0 and expect_24_1 and expect_24_2) /= '1' then
      failed := true;
      print("# failed expectation 24 conducts " & image(expect_24_0) & image(expect_24_1) & image(expect_24_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    L3 <= '1';
    L4 <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:131
    if not failed and (expect_25_0 and expect_25_1 and expect_25_2) /= '1' then
      failed := true;
      print("# failed expectation 25 conducts " & image(expect_25_0) & image(expect_25_1) & image(expect_25_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    P2 <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:133
    if not failed and (expect_26_0 and expect_26_1 and expect_26_2) /= '1' then
      failed := true;
      print("# failed expectation 26 conducts " & image(expect_26_0) & image(expect_26_1) & image(expect_26_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    L4 <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:135
    if not failed and (expect_27_0 and expect_27_1) /= '1' then
      failed := true;
      print("# failed expectation 27 conducts " & image(expect_27_0) & image(expect_27_1)
          & " C2=" & image(C2)
          & " C1=" & image(C1));
    end if;
    P2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:137
    if not failed and (expect_28_0) /= '1' then
      failed := true;
      print("# failed expectation 28 conducts " & image(expect_28_0)
          & " C1=" & image(C1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a hopper that is full stops the conveyor above it and no other");
    else
      print("ok 5 - a hopper that is full stops the conveyor above it and no other");
    end if;

    -- C2 does not turn
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L2 <= '1';
    L3 <= '1';
    L4 <= '1';
    P1 <= '1';
    P2 <= '1';
    P3 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(50, '1');
    P2 <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:144
    if not failed and (expect_29_0 and expect_29_1 and expect_29_2) /= '1' then
      failed := true;
      print("# failed expectation 29 conducts " & image(expect_29_0) & image(expect_29_1) & image(expect_29_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    scan(39, '1');
    wait for 1 ns; -- conveyor_line.ladder:146
    if not failed and (expect_30_0 and expect_30_1) /= '1' then
      failed := true;
      print("# failed expectation 30 conducts " & image(expect_30_0) & image(expect_30_1)
          & " C2=" & image(C2)
          & " fault_2=" & image(fault_2));
    end if;
    scan(1, '1');
    wait for 1 ns; -- conveyor_line.ladder:148
    if not failed and (expect_31_0 and expect_31_1) /= '1' then
      failed := true;
      print("# failed expectation 31 conducts " & image(expect_31_0) & image(expect_31_1)
          & " C2=" & image(C2)
          & " fault_2=" & image(fault_2));
    end if;
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:150
    if not failed and (expect_32_0 and expect_32_1 and expect_32_2 and expect_32_3 and expect_32_4 and expect_32_5) /= '1' then
      failed := true;
      print("# failed expectation 32 conducts " & image(expect_32_0) & image(expect_32_1) & image(expect_32_2) & image(expect_32_3) & image(expect_32_4) & image(expect_32_5)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3)
          & " fault_2=" & image(fault_2)
          & " fault_1=" & image(fault_1)
          & " fault_3=" & image(fault_3));
    end if;
    scan(100, '1');
    wait for 1 ns; -- conveyor_line.ladder:152
    if not failed and (expect_33_0 and expect_33_1) /= '1' then
      failed := true;
      print("# failed expectation 33 conducts " & image(expect_33_0) & image(expect_33_1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    reset_faults <= '1';
    scan(1, '0');
    reset_faults <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:154
    if not failed and (expect_34_0 and expect_34_1) /= '1' then
      failed := true;
      print("# failed expectation 34 conducts " & image(expect_34_0) & image(expect_34_1)
          & " C2=" & image(C2)
          & " fault_2=" & image(fault_2));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - C2 does not turn");
    else
      print("ok 6 - C2 does not turn");
    end if;

    -- C3 never turns
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L2 <= '1';
    L3 <= '1';
    L4 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(39, '1');
    wait for 1 ns; -- conveyor_line.ladder:160
    if not failed and (expect_35_0 and expect_35_1) /= '1' then
      failed := true;
      print("# failed expectation 35 conducts " & image(expect_35_0) & image(expect_35_1)
          & " C3=" & image(C3)
          & " fault_3=" & image(fault_3));
    end if;
    scan(1, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:163
    if not failed and (expect_36_0 and expect_36_1 and expect_36_2 and expect_36_3) /= '1' then
      failed := true;
      print("# failed expectation 36 conducts " & image(expect_36_0) & image(expect_36_1) & image(expect_36_2) & image(expect_36_3)
          & " C3=" & image(C3)
          & " C2=" & image(C2)
          & " C1=" & image(C1)
          & " fault_3=" & image(fault_3));
    end if;
    reset_faults <= '1';
    scan(2, '0');
    wait for 1 ns; -- conveyor_line.ladder:165
    if not failed and (expect_37_0 and expect_37_1) /= '1' then
      failed := true;
      print("# failed expectation 37 conducts " & image(expect_37_0) & image(expect_37_1)
          & " C3=" & image(C3)
          & " fault_3=" & image(fault_3));
    end if;
    scan(40, '1');
    scan(2, '0');
    wait for 1 ns; -- conveyor_line.ladder:168
    if not failed and (expect_38_0 and expect_38_1) /= '1' then
      failed := true;
      print("# failed expectation 38 conducts " & image(expect_38_0) & image(expect_38_1)
          & " C3=" & image(C3)
          & " fault_3=" & image(fault_3));
    end if;
    scan(100, '1');
    wait for 1 ns; -- conveyor_line.ladder:170
    if not failed and (expect_39_0 and expect_39_1) /= '1' then
      failed := true;
      print("# failed expectation 39 conducts " & image(expect_39_0) & image(expect_39_1)
          & " C3=" & image(C3)
          & " fault_3=" & image(fault_3));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - C3 never turns");
    else
      print("ok 7 - C3 never turns");
    end if;

    -- C1 does not turn
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L2 <= '1';
    L3 <= '1';
    L4 <= '1';
    P2 <= '1';
    P3 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:175
    if not failed and (expect_40_0) /= '1' then
      failed := true;
      print("# failed expectation 40 conducts " & image(expect_40_0)
          & " C1=" & image(C1));
    end if;
    scan(40, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:178
    if not failed and (expect_41_0 and expect_41_1 and expect_41_2 and expect_41_3) /= '1' then
      failed := true;
      print("# failed expectation 41 conducts " & image(expect_41_0) & image(expect_41_1) & image(expect_41_2) & image(expect_41_3)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3)
          & " fault_1=" & image(fault_1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 8 - C1 does not turn");
    else
      print("ok 8 - C1 does not turn");
    end if;

    -- stop ends all at once, and wins over start
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L2 <= '1';
    L3 <= '1';
    L4 <= '1';
    P1 <= '1';
    P2 <= '1';
    P3 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:183
    if not failed and (expect_42_0 and expect_42_1 and expect_42_2) /= '1' then
      failed := true;
      print("# failed expectation 42 conducts " & image(expect_42_0) & image(expect_42_1) & image(expect_42_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    start <= '1';
    stop <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:185
    if not failed and (expect_43_0 and expect_43_1 and expect_43_2) /= '1' then
      failed := true;
      print("# failed expectation 43 conducts " & image(expect_43_0) & image(expect_43_1) & image(expect_43_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    stop <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:187
    if not failed and (expect_44_0 and expect_44_1 and expect_44_2) /= '1' then
      failed := true;
      print("# failed expectation 44 conducts " & image(expect_44_0) & image(expect_44_1) & image(expect_44_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 9 - stop ends all at once, and wins over start");
    else
      print("ok 9 - stop ends all at once, and wins over start");
    end if;

    -- after a stop between the levels the conveyors run empty and wait for the low level
    failed := false;
    reset;
    stop <= '1';
    L1 <= '1';
    L2 <= '1';
    L3 <= '1';
    L4 <= '1';
    P1 <= '1';
    P2 <= '1';
    P3 <= '1';
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(10, '1');
    L2 <= '0';
    stop <= '0';
    scan(1, '0');
    scan(600, '1');
    stop <= '1';
    scan(1, '0');
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:197
    if not failed and (expect_45_0 and expect_45_1 and expect_45_2) /= '1' then
      failed := true;
      print("# failed expectation 45 conducts " & image(expect_45_0) & image(expect_45_1) & image(expect_45_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    scan(100, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:200
    if not failed and (expect_46_0 and expect_46_1) /= '1' then
      failed := true;
      print("# failed expectation 46 conducts " & image(expect_46_0) & image(expect_46_1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    scan(100, '1');
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:203
    if not failed and (expect_47_0) /= '1' then
      failed := true;
      print("# failed expectation 47 conducts " & image(expect_47_0)
          & " C3=" & image(C3));
    end if;
    L2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- conveyor_line.ladder:205
    if not failed and (expect_48_0 and expect_48_1 and expect_48_2) /= '1' then
      failed := true;
      print("# failed expectation 48 conducts " & image(expect_48_0) & image(expect_48_1) & image(expect_48_2)
          & " C1=" & image(C1)
          & " C2=" & image(C2)
          & " C3=" & image(C3));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 10 - after a stop between the levels the conveyors run empty and wait for the low level");
    else
      print("ok 10 - after a stop between the levels the conveyors run empty and wait for the low level");
    end if;

    assert failures = 0 report integer'image(failures) & " of 10 tests failed" severity failure;
    wait;
  end process;
end architecture;
