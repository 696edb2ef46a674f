-- Made by hotrail 0.1.0 from cash_register.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity cash_register_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    lamp_combo  : in  std_logic;
    lamp_fries  : in  std_logic;
    subtotal    : in  std_logic_vector(31 downto 0);
    tax         : in  std_logic_vector(31 downto 0);
    total       : in  std_logic_vector(31 downto 0);
    lamp_double : in  std_logic;
    lamp_junior : in  std_logic;
    lamp_burger : in  std_logic;
    lamp_drink  : in  std_logic;
    profit      : in  std_logic_vector(31 downto 0);
    sold_0      : in  std_logic_vector(31 downto 0);
    paid        : in  std_logic;
    sold_5      : in  std_logic_vector(31 downto 0);
    sold_4      : in  std_logic_vector(31 downto 0);
    sold_1      : in  std_logic_vector(31 downto 0);
    sold_3      : in  std_logic_vector(31 downto 0);
    sold_2      : in  std_logic_vector(31 downto 0);
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_0_3  : out std_logic;
    expect_0_4  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_1_2  : out std_logic;
    expect_1_3  : out std_logic;
    expect_1_4  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_2_2  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_8_0  : out std_logic;
    expect_9_0  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_13_1 : out std_logic;
    expect_13_2 : out std_logic;
    expect_13_3 : out std_logic;
    expect_13_4 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic;
    expect_18_0 : out std_logic;
    expect_18_1 : out std_logic;
    expect_19_0 : out std_logic;
    expect_19_1 : out std_logic;
    expect_19_2 : out std_logic;
    expect_20_0 : out std_logic;
    expect_20_1 : out std_logic;
    expect_21_0 : out std_logic;
    expect_21_1 : out std_logic;
    expect_22_0 : out std_logic;
    expect_22_1 : out std_logic;
    expect_23_0 : out std_logic;
    expect_24_0 : out std_logic;
    expect_25_0 : out std_logic;
    expect_25_1 : out std_logic;
    expect_26_0 : out std_logic;
    expect_27_0 : out std_logic;
    expect_28_0 : out std_logic;
    expect_28_1 : out std_logic;
    expect_28_2 : out std_logic;
    expect_29_0 : out std_logic;
    expect_29_1 : out std_logic;
    expect_29_2 : out std_logic;
    expect_29_3 : out std_logic;
    expect_29_4 : out std_logic;
    expect_29_5 : out std_logic;
    expect_30_0 : out std_logic;
    expect_30_1 : out std_logic;
    expect_30_2 : out std_logic;
    expect_30_3 : out std_logic;
    expect_31_0 : out std_logic;
    expect_31_1 : out std_logic;
    expect_31_2 : out std_logic;
    expect_31_3 : out std_logic;
    expect_32_0 : out std_logic;
    expect_32_1 : out std_logic;
    expect_32_2 : out std_logic;
    expect_32_3 : out std_logic;
    expect_33_0 : out std_logic;
    expect_33_1 : out std_logic;
    expect_33_2 : out std_logic;
    expect_34_0 : out std_logic;
    expect_34_1 : out std_logic;
    expect_35_0 : out std_logic;
    expect_35_1 : out std_logic;
    expect_35_2 : out std_logic;
    expect_35_3 : out std_logic;
    expect_35_4 : out std_logic;
    expect_36_0 : out std_logic;
    expect_36_1 : out std_logic;
    expect_37_0 : out std_logic;
    expect_37_1 : out std_logic;
    expect_37_2 : out std_logic;
    expect_38_0 : out std_logic;
    expect_38_1 : out std_logic;
    expect_39_0 : out std_logic;
    expect_40_0 : out std_logic;
    expect_40_1 : out std_logic;
    expect_40_2 : out std_logic;
    expect_41_0 : out std_logic;
    expect_41_1 : out std_logic;
    expect_42_0 : out std_logic;
    expect_43_0 : out std_logic;
    expect_43_1 : out std_logic;
    expect_44_0 : out std_logic;
    expect_45_0 : out std_logic;
    expect_45_1 : out std_logic
  );
end entity cash_register_expect;

architecture rtl of cash_register_expect is
begin

  expect_0_0 <= lamp_combo;
  expect_0_1 <= not lamp_fries;
  expect_0_2 <= '1' when unsigned(subtotal) = 899 else '0';
  expect_0_3 <= '1' when unsigned(tax) = 56 else '0';
  expect_0_4 <= '1' when unsigned(total) = 955 else '0';
  expect_1_0 <= lamp_combo;
  expect_1_1 <= lamp_fries;
  expect_1_2 <= '1' when unsigned(subtotal) = 1178 else '0';
  expect_1_3 <= '1' when unsigned(tax) = 74 else '0';
  expect_1_4 <= '1' when unsigned(total) = 1252 else '0';
  expect_2_0 <= '1' when unsigned(subtotal) = 1178 else '0';
  expect_2_1 <= '1' when unsigned(tax) = 0 else '0';
  expect_2_2 <= '1' when unsigned(total) = 1178 else '0';
  expect_3_0 <= '1' when unsigned(total) = 899 else '0';
  expect_3_1 <= lamp_combo;
  expect_4_0 <= '1' when unsigned(total) = 1998 else '0';
  expect_4_1 <= lamp_double;
  expect_5_0 <= '1' when unsigned(total) = 2647 else '0';
  expect_5_1 <= lamp_junior;
  expect_6_0 <= '1' when unsigned(total) = 3196 else '0';
  expect_6_1 <= lamp_burger;
  expect_7_0 <= '1' when unsigned(total) = 3425 else '0';
  expect_7_1 <= lamp_drink;
  expect_8_0 <= '1' when unsigned(total) = 3654 else '0';
  expect_9_0 <= '1' when unsigned(tax) = 41 else '0';
  expect_10_0 <= '1' when unsigned(subtotal) = 458 else '0';
  expect_10_1 <= '1' when unsigned(tax) = 29 else '0';
  expect_11_0 <= '1' when unsigned(subtotal) = 8792 else '0';
  expect_11_1 <= '1' when unsigned(tax) = 550 else '0';
  expect_12_0 <= '1' when unsigned(total) = 778 else '0';
  expect_13_0 <= '1' when unsigned(total) = 899 else '0';
  expect_13_1 <= lamp_burger;
  expect_13_2 <= lamp_fries;
  expect_13_3 <= lamp_drink;
  expect_13_4 <= not lamp_combo;
  expect_14_0 <= '1' when unsigned(total) = 1178 else '0';
  expect_15_0 <= '1' when unsigned(total) = 1798 else '0';
  expect_16_0 <= '1' when unsigned(total) = 1727 else '0';
  expect_17_0 <= '1' when unsigned(total) = 2306 else '0';
  expect_18_0 <= '1' when unsigned(total) = 2077 else '0';
  expect_18_1 <= not lamp_drink;
  expect_19_0 <= '1' when unsigned(total) = 1178 else '0';
  expect_19_1 <= lamp_combo;
  expect_19_2 <= lamp_fries;
  expect_20_0 <= '1' when unsigned(total) = 899 else '0';
  expect_20_1 <= not lamp_fries;
  expect_21_0 <= '1' when unsigned(total) = 0 else '0';
  expect_21_1 <= not lamp_combo;
  expect_22_0 <= '1' when unsigned(total) = 229 else '0';
  expect_22_1 <= lamp_drink;
  expect_23_0 <= '1' when unsigned(total) = 508 else '0';
  expect_24_0 <= '1' when unsigned(total) = 279 else '0';
  expect_25_0 <= '1' when unsigned(total) = 899 else '0';
  expect_25_1 <= not lamp_drink;
  expect_26_0 <= '1' when unsigned(total) = 1178 else '0';
  expect_27_0 <= '1' when unsigned(total) = 899 else '0';
  expect_28_0 <= '1' when unsigned(profit) = 0 else '0';
  expect_28_1 <= '1' when unsigned(sold_0) = 0 else '0';
  expect_28_2 <= not paid;
  expect_29_0 <= paid;
  expect_29_1 <= '1' when unsigned(total) = 2027 else '0';
  expect_29_2 <= '1' when unsigned(profit) = 760 else '0';
  expect_29_3 <= '1' when unsigned(sold_0) = 2 else '0';
  expect_29_4 <= '1' when unsigned(sold_5) = 1 else '0';
  expect_29_5 <= '1' when unsigned(sold_4) = 0 else '0';
  expect_30_0 <= paid;
  expect_30_1 <= '1' when unsigned(total) = 2027 else '0';
  expect_30_2 <= '1' when unsigned(profit) = 760 else '0';
  expect_30_3 <= '1' when unsigned(sold_0) = 2 else '0';
  expect_31_0 <= not paid;
  expect_31_1 <= '1' when unsigned(total) = 0 else '0';
  expect_31_2 <= not lamp_combo;
  expect_31_3 <= '1' when unsigned(profit) = 760 else '0';
  expect_32_0 <= '1' when unsigned(total) = 1099 else '0';
  expect_32_1 <= '1' when unsigned(profit) = 1130 else '0';
  expect_32_2 <= '1' when unsigned(sold_1) = 1 else '0';
  expect_32_3 <= '1' when unsigned(sold_0) = 2 else '0';
  expect_33_0 <= '1' when unsigned(total) = 0 else '0';
  expect_33_1 <= '1' when unsigned(profit) = 0 else '0';
  expect_33_2 <= '1' when unsigned(sold_0) = 0 else '0';
  expect_34_0 <= not paid;
  expect_34_1 <= '1' when unsigned(profit) = 0 else '0';
  expect_35_0 <= '1' when unsigned(profit) = 302 else '0';
  expect_35_1 <= '1' when unsigned(sold_3) = 1 else '0';
  expect_35_2 <= '1' when unsigned(sold_4) = 1 else '0';
  expect_35_3 <= '1' when unsigned(sold_5) = 1 else '0';
  expect_35_4 <= '1' when unsigned(sold_0) = 0 else '0';
  expect_36_0 <= '1' when unsigned(profit) = 240 else '0';
  expect_36_1 <= '1' when unsigned(sold_2) = 1 else '0';
  expect_37_0 <= '1' when unsigned(profit) = 0 else '0';
  expect_37_1 <= '1' when unsigned(sold_2) = 0 else '0';
  expect_37_2 <= lamp_burger;
  expect_38_0 <= '1' when unsigned(profit) = 150 else '0';
  expect_38_1 <= '1' when unsigned(sold_3) = 1 else '0';
  expect_39_0 <= '1' when unsigned(total) = 2731 else '0';
  expect_40_0 <= '1' when unsigned(total) = 899 else '0';
  expect_40_1 <= lamp_combo;
  expect_40_2 <= not lamp_drink;
  expect_41_0 <= '1' when unsigned(total) = 899 else '0';
  expect_41_1 <= lamp_combo;
  expect_42_0 <= '1' when unsigned(total) = 899 else '0';
  expect_43_0 <= '1' when unsigned(total) = 229 else '0';
  expect_43_1 <= not lamp_combo;
  expect_44_0 <= '1' when unsigned(total) = 0 else '0';
  expect_45_0 <= '1' when unsigned(total) = 0 else '0';
  expect_45_1 <= not lamp_combo;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity cash_register_tb is
end entity;

architecture tests of cash_register_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal key_combo : std_logic := '0';
  signal key_double : std_logic := '0';
  signal key_junior : std_logic := '0';
  signal key_burger : std_logic := '0';
  signal key_fries : std_logic := '0';
  signal key_drink : std_logic := '0';
  signal cancel_last : std_logic := '0';
  signal total_key : std_logic := '0';
  signal new_order : std_logic := '0';
  signal new_day : std_logic := '0';
  signal to_go : std_logic := '0';
  signal lamp_combo : std_logic;
  signal lamp_double : std_logic;
  signal lamp_junior : std_logic;
  signal lamp_burger : std_logic;
  signal lamp_fries : std_logic;
  signal lamp_drink : std_logic;
  signal subtotal : std_logic_vector(31 downto 0);
  signal tax : std_logic_vector(31 downto 0);
  signal total : std_logic_vector(31 downto 0);
  signal paid : std_logic;
  signal sold : std_logic_vector(191 downto 0);
  signal profit : std_logic_vector(31 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_0_3 : std_logic;
  signal expect_0_4 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_1_3 : std_logic;
  signal expect_1_4 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_2_2 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_13_1 : std_logic;
  signal expect_13_2 : std_logic;
  signal expect_13_3 : std_logic;
  signal expect_13_4 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_18_0 : std_logic;
  signal expect_18_1 : std_logic;
  signal expect_19_0 : std_logic;
  signal expect_19_1 : std_logic;
  signal expect_19_2 : std_logic;
  signal expect_20_0 : std_logic;
  signal expect_20_1 : std_logic;
  signal expect_21_0 : std_logic;
  signal expect_21_1 : std_logic;
  signal expect_22_0 : std_logic;
  signal expect_22_1 : std_logic;
  signal expect_23_0 : std_logic;
  signal expect_24_0 : std_logic;
  signal expect_25_0 : std_logic;
  signal expect_25_1 : std_logic;
  signal expect_26_0 : std_logic;
  signal expect_27_0 : std_logic;
  signal expect_28_0 : std_logic;
  signal expect_28_1 : std_logic;
  signal expect_28_2 : std_logic;
  signal expect_29_0 : std_logic;
  signal expect_29_1 : std_logic;
  signal expect_29_2 : std_logic;
  signal expect_29_3 : std_logic;
  signal expect_29_4 : std_logic;
  signal expect_29_5 : std_logic;
  signal expect_30_0 : std_logic;
  signal expect_30_1 : std_logic;
  signal expect_30_2 : std_logic;
  signal expect_30_3 : std_logic;
  signal expect_31_0 : std_logic;
  signal expect_31_1 : std_logic;
  signal expect_31_2 : std_logic;
  signal expect_31_3 : std_logic;
  signal expect_32_0 : std_logic;
  signal expect_32_1 : std_logic;
  signal expect_32_2 : std_logic;
  signal expect_32_3 : std_logic;
  signal expect_33_0 : std_logic;
  signal expect_33_1 : std_logic;
  signal expect_33_2 : std_logic;
  signal expect_34_0 : std_logic;
  signal expect_34_1 : std_logic;
  signal expect_35_0 : std_logic;
  signal expect_35_1 : std_logic;
  signal expect_35_2 : std_logic;
  signal expect_35_3 : std_logic;
  signal expect_35_4 : std_logic;
  signal expect_36_0 : std_logic;
  signal expect_36_1 : std_logic;
  signal expect_37_0 : std_logic;
  signal expect_37_1 : std_logic;
  signal expect_37_2 : std_logic;
  signal expect_38_0 : std_logic;
  signal expect_38_1 : std_logic;
  signal expect_39_0 : std_logic;
  signal expect_40_0 : std_logic;
  signal expect_40_1 : std_logic;
  signal expect_40_2 : std_logic;
  signal expect_41_0 : std_logic;
  signal expect_41_1 : std_logic;
  signal expect_42_0 : std_logic;
  signal expect_43_0 : std_logic;
  signal expect_43_1 : std_logic;
  signal expect_44_0 : std_logic;
  signal expect_45_0 : std_logic;
  signal expect_45_1 : std_logic;

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
  core : entity work.cash_register
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      key_combo => key_combo,
      key_double => key_double,
      key_junior => key_junior,
      key_burger => key_burger,
      key_fries => key_fries,
      key_drink => key_drink,
      cancel_last => cancel_last,
      total_key => total_key,
      new_order => new_order,
      new_day => new_day,
      to_go => to_go,
      lamp_combo => lamp_combo,
      lamp_double => lamp_double,
      lamp_junior => lamp_junior,
      lamp_burger => lamp_burger,
      lamp_fries => lamp_fries,
      lamp_drink => lamp_drink,
      subtotal => subtotal,
      tax => tax,
      total => total,
      paid => paid,
      sold => sold,
      profit => profit
    );

  expectations : entity work.cash_register_expect
    port map (
      clk => clk,
      rst => rst,
      lamp_combo => lamp_combo,
      lamp_fries => lamp_fries,
      subtotal => subtotal,
      tax => tax,
      total => total,
      lamp_double => lamp_double,
      lamp_junior => lamp_junior,
      lamp_burger => lamp_burger,
      lamp_drink => lamp_drink,
      profit => profit,
      sold_0 => sold(31 downto 0),
      paid => paid,
      sold_5 => sold(191 downto 160),
      sold_4 => sold(159 downto 128),
      sold_1 => sold(63 downto 32),
      sold_3 => sold(127 downto 96),
      sold_2 => sold(95 downto 64),
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_0_3 => expect_0_3,
      expect_0_4 => expect_0_4,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_1_3 => expect_1_3,
      expect_1_4 => expect_1_4,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_2_2 => expect_2_2,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_9_0 => expect_9_0,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_13_1 => expect_13_1,
      expect_13_2 => expect_13_2,
      expect_13_3 => expect_13_3,
      expect_13_4 => expect_13_4,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_16_0 => expect_16_0,
      expect_17_0 => expect_17_0,
      expect_18_0 => expect_18_0,
      expect_18_1 => expect_18_1,
      expect_19_0 => expect_19_0,
      expect_19_1 => expect_19_1,
      expect_19_2 => expect_19_2,
      expect_20_0 => expect_20_0,
      expect_20_1 => expect_20_1,
      expect_21_0 => expect_21_0,
      expect_21_1 => expect_21_1,
      expect_22_0 => expect_22_0,
      expect_22_1 => expect_22_1,
      expect_23_0 => expect_23_0,
      expect_24_0 => expect_24_0,
      expect_25_0 => expect_25_0,
      expect_25_1 => expect_25_1,
      expect_26_0 => expect_26_0,
      expect_27_0 => expect_27_0,
      expect_28_0 => expect_28_0,
      expect_28_1 => expect_28_1,
      expect_28_2 => expect_28_2,
      expect_29_0 => expect_29_0,
      expect_29_1 => expect_29_1,
      expect_29_2 => expect_29_2,
      expect_29_3 => expect_29_3,
      expect_29_4 => expect_29_4,
      expect_29_5 => expect_29_5,
      expect_30_0 => expect_30_0,
      expect_30_1 => expect_30_1,
      expect_30_2 => expect_30_2,
      expect_30_3 => expect_30_3,
      expect_31_0 => expect_31_0,
      expect_31_1 => expect_31_1,
      expect_31_2 => expect_31_2,
      expect_31_3 => expect_31_3,
      expect_32_0 => expect_32_0,
      expect_32_1 => expect_32_1,
      expect_32_2 => expect_32_2,
      expect_32_3 => expect_32_3,
      expect_33_0 => expect_33_0,
      expect_33_1 => expect_33_1,
      expect_33_2 => expect_33_2,
      expect_34_0 => expect_34_0,
      expect_34_1 => expect_34_1,
      expect_35_0 => expect_35_0,
      expect_35_1 => expect_35_1,
      expect_35_2 => expect_35_2,
      expect_35_3 => expect_35_3,
      expect_35_4 => expect_35_4,
      expect_36_0 => expect_36_0,
      expect_36_1 => expect_36_1,
      expect_37_0 => expect_37_0,
      expect_37_1 => expect_37_1,
      expect_37_2 => expect_37_2,
      expect_38_0 => expect_38_0,
      expect_38_1 => expect_38_1,
      expect_39_0 => expect_39_0,
      expect_40_0 => expect_40_0,
      expect_40_1 => expect_40_1,
      expect_40_2 => expect_40_2,
      expect_41_0 => expect_41_0,
      expect_41_1 => expect_41_1,
      expect_42_0 => expect_42_0,
      expect_43_0 => expect_43_0,
      expect_43_1 => expect_43_1,
      expect_44_0 => expect_44_0,
      expect_45_0 => expect_45_0,
      expect_45_1 => expect_45_1
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
      key_combo <= '0';
      key_double <= '0';
      key_junior <= '0';
      key_burger <= '0';
      key_fries <= '0';
      key_drink <= '0';
      cancel_last <= '0';
      total_key <= '0';
      new_order <= '0';
      new_day <= '0';
      to_go <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..14");

    -- two entries, with tax and to go
    failed := false;
    reset;
    key_combo <= '1';
    scan(1, '0');
    key_combo <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:130
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2 and expect_0_3 and expect_0_4) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2) & image(expect_0_3) & image(expect_0_4)
          & " lamp_combo=" & image(lamp_combo)
          & " lamp_fries=" & image(lamp_fries)
          & " subtotal=" & image(subtotal)
          & " tax=" & image(tax)
          & " total=" & image(total));
    end if;
    key_fries <= '1';
    scan(1, '0');
    key_fries <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:132
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2 and expect_1_3 and expect_1_4) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2) & image(expect_1_3) & image(expect_1_4)
          & " lamp_combo=" & image(lamp_combo)
          & " lamp_fries=" & image(lamp_fries)
          & " subtotal=" & image(subtotal)
          & " tax=" & image(tax)
          & " total=" & image(total));
    end if;
    to_go <= '1';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:134
    if not failed and (expect_2_0 and expect_2_1 and expect_2_2) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2)
          & " subtotal=" & image(subtotal)
          & " tax=" & image(tax)
          & " total=" & image(total));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - two entries, with tax and to go");
    else
      print("ok 1 - two entries, with tax and to go");
    end if;

    -- every key
    failed := false;
    reset;
    to_go <= '1';
    key_combo <= '1';
    scan(1, '0');
    key_combo <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:139
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " total=" & image(total)
          & " lamp_combo=" & image(lamp_combo));
    end if;
    key_double <= '1';
    scan(1, '0');
    key_double <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:141
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " total=" & image(total)
          & " lamp_double=" & image(lamp_double));
    end if;
    key_junior <= '1';
    scan(1, '0');
    key_junior <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:143
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " total=" & image(total)
          & " lamp_junior=" & image(lamp_junior));
    end if;
    key_burger <= '1';
    scan(1, '0');
    key_burger <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:145
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " total=" & image(total)
          & " lamp_burger=" & image(lamp_burger));
    end if;
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:147
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " total=" & image(total)
          & " lamp_drink=" & image(lamp_drink));
    end if;
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:149
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " total=" & image(total));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - every key");
    else
      print("ok 2 - every key");
    end if;

    -- a cent is rounded at the half
    failed := false;
    reset;
    key_junior <= '1';
    scan(1, '0');
    key_junior <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:153
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " tax=" & image(tax));
    end if;
    new_order <= '1';
    scan(1, '0');
    new_order <= '0';
    scan(1, '0');
    for round in 1 to 2 loop
      key_drink <= '1';
      scan(1, '0');
      key_drink <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- cash_register.ladder:156
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " subtotal=" & image(subtotal)
          & " tax=" & image(tax));
    end if;
    new_order <= '1';
    scan(1, '0');
    new_order <= '0';
    scan(1, '0');
    for round in 1 to 8 loop
      key_double <= '1';
      scan(1, '0');
      key_double <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- cash_register.ladder:159
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " subtotal=" & image(subtotal)
          & " tax=" & image(tax));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a cent is rounded at the half");
    else
      print("ok 3 - a cent is rounded at the half");
    end if;

    -- burger, fries and drink become a combo as soon as they are three
    failed := false;
    reset;
    to_go <= '1';
    key_burger <= '1';
    scan(1, '0');
    key_burger <= '0';
    scan(1, '0');
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:165
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " total=" & image(total));
    end if;
    key_fries <= '1';
    scan(1, '0');
    key_fries <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:167
    if not failed and (expect_13_0 and expect_13_1 and expect_13_2 and expect_13_3 and expect_13_4) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0) & image(expect_13_1) & image(expect_13_2) & image(expect_13_3) & image(expect_13_4)
          & " total=" & image(total)
          & " lamp_burger=" & image(lamp_burger)
          & " lamp_fries=" & image(lamp_fries)
          & " lamp_drink=" & image(lamp_drink)
          & " lamp_combo=" & image(lamp_combo));
    end if;
    key_fries <= '1';
    scan(1, '0');
    key_fries <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:169
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " total=" & image(total));
    end if;
    key_burger <= '1';
    scan(1, '0');
    key_burger <= '0';
    scan(1, '0');
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:172
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " total=" & image(total));
    end if;
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:174
    if not failed and (expect_16_0) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0)
          & " total=" & image(total));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - burger, fries and drink become a combo as soon as they are three");
    else
      print("ok 4 - burger, fries and drink become a combo as soon as they are three");
    end if;

    -- entries are taken back, the last first, down to nothing
    failed := false;
    reset;
    to_go <= '1';
    key_combo <= '1';
    scan(1, '0');
    key_combo <= '0';
    scan(1, '0');
    key_fries <= '1';
    scan(1, '0');
    key_fries <= '0';
    scan(1, '0');
    key_combo <= '1';
    scan(1, '0');
    key_combo <= '0';
    scan(1, '0');
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:182
    if not failed and (expect_17_0) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0)
          & " total=" & image(total));
    end if;
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:184
    if not failed and (expect_18_0 and expect_18_1) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0) & image(expect_18_1)
          & " total=" & image(total)
          & " lamp_drink=" & image(lamp_drink));
    end if;
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:186
    if not failed and (expect_19_0 and expect_19_1 and expect_19_2) /= '1' then
      failed := true;
      print("# failed expectation 19 conducts " & image(expect_19_0) & image(expect_19_1) & image(expect_19_2)
          & " total=" & image(total)
          & " lamp_combo=" & image(lamp_combo)
          & " lamp_fries=" & image(lamp_fries));
    end if;
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:188
    if not failed and (expect_20_0 and expect_20_1) /= '1' then
      failed := true;
      print("# failed expectation 20 conducts " & image(expect_20_0) & image(expect_20_1)
          & " total=" & image(total)
          & " lamp_fries=" & image(lamp_fries));
    end if;
    for round in 1 to 3 loop
      cancel_last <= '1';
      scan(1, '0');
      cancel_last <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- cash_register.ladder:190
    if not failed and (expect_21_0 and expect_21_1) /= '1' then
      failed := true;
      print("# failed expectation 21 conducts " & image(expect_21_0) & image(expect_21_1)
          & " total=" & image(total)
          & " lamp_combo=" & image(lamp_combo));
    end if;
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:192
    if not failed and (expect_22_0 and expect_22_1) /= '1' then
      failed := true;
      print("# failed expectation 22 conducts " & image(expect_22_0) & image(expect_22_1)
          & " total=" & image(total)
          & " lamp_drink=" & image(lamp_drink));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - entries are taken back, the last first, down to nothing");
    else
      print("ok 5 - entries are taken back, the last first, down to nothing");
    end if;

    -- a key that is held is one entry, a cancel that is held takes one back
    failed := false;
    reset;
    to_go <= '1';
    key_fries <= '1';
    scan(5, '0');
    key_fries <= '0';
    scan(1, '0');
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:198
    if not failed and (expect_23_0) /= '1' then
      failed := true;
      print("# failed expectation 23 conducts " & image(expect_23_0)
          & " total=" & image(total));
    end if;
    cancel_last <= '1';
    scan(5, '0');
    wait for 1 ns; -- cash_register.ladder:200
    if not failed and (expect_24_0) /= '1' then
      failed := true;
      print("# failed expectation 24 conducts " & image(expect_24_0)
          & " total=" & image(total));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - a key that is held is one entry, a cancel that is held takes one back");
    else
      print("ok 6 - a key that is held is one entry, a cancel that is held takes one back");
    end if;

    -- two keys at once are one entry, and a key is stronger than cancel
    failed := false;
    reset;
    to_go <= '1';
    key_combo <= '1';
    key_drink <= '1';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:205
    if not failed and (expect_25_0 and expect_25_1) /= '1' then
      failed := true;
      print("# failed expectation 25 conducts " & image(expect_25_0) & image(expect_25_1)
          & " total=" & image(total)
          & " lamp_drink=" & image(lamp_drink));
    end if;
    key_combo <= '0';
    key_drink <= '0';
    scan(1, '0');
    key_fries <= '1';
    cancel_last <= '1';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:208
    if not failed and (expect_26_0) /= '1' then
      failed := true;
      print("# failed expectation 26 conducts " & image(expect_26_0)
          & " total=" & image(total));
    end if;
    key_fries <= '0';
    cancel_last <= '0';
    scan(1, '0');
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:211
    if not failed and (expect_27_0) /= '1' then
      failed := true;
      print("# failed expectation 27 conducts " & image(expect_27_0)
          & " total=" & image(total));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - two keys at once are one entry, and a key is stronger than cancel");
    else
      print("ok 7 - two keys at once are one entry, and a key is stronger than cancel");
    end if;

    -- paid: the books of the day, and dead keys
    failed := false;
    reset;
    to_go <= '1';
    for round in 1 to 2 loop
      key_combo <= '1';
      scan(1, '0');
      key_combo <= '0';
      scan(1, '0');
    end loop;
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:217
    if not failed and (expect_28_0 and expect_28_1 and expect_28_2) /= '1' then
      failed := true;
      print("# failed expectation 28 conducts " & image(expect_28_0) & image(expect_28_1) & image(expect_28_2)
          & " profit=" & image(profit)
          & " sold[0]=" & image(sold(31 downto 0))
          & " paid=" & image(paid));
    end if;
    total_key <= '1';
    scan(5, '0');
    wait for 1 ns; -- cash_register.ladder:219
    if not failed and (expect_29_0 and expect_29_1 and expect_29_2 and expect_29_3 and expect_29_4 and expect_29_5) /= '1' then
      failed := true;
      print("# failed expectation 29 conducts " & image(expect_29_0) & image(expect_29_1) & image(expect_29_2) & image(expect_29_3) & image(expect_29_4) & image(expect_29_5)
          & " paid=" & image(paid)
          & " total=" & image(total)
          & " profit=" & image(profit)
          & " sold[0]=" & image(sold(31 downto 0))
          & " sold[5]=" & image(sold(191 downto 160))
          & " sold[4]=" & image(sold(159 downto 128)));
    end if;
    total_key <= '0';
    scan(1, '0');
    key_combo <= '1';
    scan(1, '0');
    key_combo <= '0';
    scan(1, '0');
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    total_key <= '1';
    scan(1, '0');
    total_key <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:225
    if not failed and (expect_30_0 and expect_30_1 and expect_30_2 and expect_30_3) /= '1' then
      failed := true;
      print("# failed expectation 30 conducts " & image(expect_30_0) & image(expect_30_1) & image(expect_30_2) & image(expect_30_3)
          & " paid=" & image(paid)
          & " total=" & image(total)
          & " profit=" & image(profit)
          & " sold[0]=" & image(sold(31 downto 0)));
    end if;
    new_order <= '1';
    scan(1, '0');
    new_order <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:227
    if not failed and (expect_31_0 and expect_31_1 and expect_31_2 and expect_31_3) /= '1' then
      failed := true;
      print("# failed expectation 31 conducts " & image(expect_31_0) & image(expect_31_1) & image(expect_31_2) & image(expect_31_3)
          & " paid=" & image(paid)
          & " total=" & image(total)
          & " lamp_combo=" & image(lamp_combo)
          & " profit=" & image(profit));
    end if;
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    key_double <= '1';
    scan(1, '0');
    key_double <= '0';
    scan(1, '0');
    total_key <= '1';
    scan(1, '0');
    total_key <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:231
    if not failed and (expect_32_0 and expect_32_1 and expect_32_2 and expect_32_3) /= '1' then
      failed := true;
      print("# failed expectation 32 conducts " & image(expect_32_0) & image(expect_32_1) & image(expect_32_2) & image(expect_32_3)
          & " total=" & image(total)
          & " profit=" & image(profit)
          & " sold[1]=" & image(sold(63 downto 32))
          & " sold[0]=" & image(sold(31 downto 0)));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 8 - paid: the books of the day, and dead keys");
    else
      print("ok 8 - paid: the books of the day, and dead keys");
    end if;

    -- an order that is thrown away is not in the books, nor is an empty one
    failed := false;
    reset;
    key_combo <= '1';
    scan(1, '0');
    key_combo <= '0';
    scan(1, '0');
    new_order <= '1';
    scan(1, '0');
    new_order <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:236
    if not failed and (expect_33_0 and expect_33_1 and expect_33_2) /= '1' then
      failed := true;
      print("# failed expectation 33 conducts " & image(expect_33_0) & image(expect_33_1) & image(expect_33_2)
          & " total=" & image(total)
          & " profit=" & image(profit)
          & " sold[0]=" & image(sold(31 downto 0)));
    end if;
    total_key <= '1';
    scan(1, '0');
    total_key <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:238
    if not failed and (expect_34_0 and expect_34_1) /= '1' then
      failed := true;
      print("# failed expectation 34 conducts " & image(expect_34_0) & image(expect_34_1)
          & " paid=" & image(paid)
          & " profit=" & image(profit));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 9 - an order that is thrown away is not in the books, nor is an empty one");
    else
      print("ok 9 - an order that is thrown away is not in the books, nor is an empty one");
    end if;

    -- three entered one by one earn what is left of their profit
    failed := false;
    reset;
    key_burger <= '1';
    scan(1, '0');
    key_burger <= '0';
    scan(1, '0');
    key_fries <= '1';
    scan(1, '0');
    key_fries <= '0';
    scan(1, '0');
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    total_key <= '1';
    scan(1, '0');
    total_key <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:245
    if not failed and (expect_35_0 and expect_35_1 and expect_35_2 and expect_35_3 and expect_35_4) /= '1' then
      failed := true;
      print("# failed expectation 35 conducts " & image(expect_35_0) & image(expect_35_1) & image(expect_35_2) & image(expect_35_3) & image(expect_35_4)
          & " profit=" & image(profit)
          & " sold[3]=" & image(sold(127 downto 96))
          & " sold[4]=" & image(sold(159 downto 128))
          & " sold[5]=" & image(sold(191 downto 160))
          & " sold[0]=" & image(sold(31 downto 0)));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 10 - three entered one by one earn what is left of their profit");
    else
      print("ok 10 - three entered one by one earn what is left of their profit");
    end if;

    -- a new day
    failed := false;
    reset;
    key_junior <= '1';
    scan(1, '0');
    key_junior <= '0';
    scan(1, '0');
    total_key <= '1';
    scan(1, '0');
    total_key <= '0';
    scan(1, '0');
    new_order <= '1';
    scan(1, '0');
    new_order <= '0';
    scan(1, '0');
    key_burger <= '1';
    scan(1, '0');
    key_burger <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:253
    if not failed and (expect_36_0 and expect_36_1) /= '1' then
      failed := true;
      print("# failed expectation 36 conducts " & image(expect_36_0) & image(expect_36_1)
          & " profit=" & image(profit)
          & " sold[2]=" & image(sold(95 downto 64)));
    end if;
    new_day <= '1';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:255
    if not failed and (expect_37_0 and expect_37_1 and expect_37_2) /= '1' then
      failed := true;
      print("# failed expectation 37 conducts " & image(expect_37_0) & image(expect_37_1) & image(expect_37_2)
          & " profit=" & image(profit)
          & " sold[2]=" & image(sold(95 downto 64))
          & " lamp_burger=" & image(lamp_burger));
    end if;
    total_key <= '1';
    scan(1, '0');
    total_key <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:257
    if not failed and (expect_38_0 and expect_38_1) /= '1' then
      failed := true;
      print("# failed expectation 38 conducts " & image(expect_38_0) & image(expect_38_1)
          & " profit=" & image(profit)
          & " sold[3]=" & image(sold(127 downto 96)));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 11 - a new day");
    else
      print("ok 11 - a new day");
    end if;

    -- the last eight entries can be taken back, and no more
    failed := false;
    reset;
    to_go <= '1';
    key_combo <= '1';
    scan(1, '0');
    key_combo <= '0';
    scan(1, '0');
    for round in 1 to 8 loop
      key_drink <= '1';
      scan(1, '0');
      key_drink <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- cash_register.ladder:263
    if not failed and (expect_39_0) /= '1' then
      failed := true;
      print("# failed expectation 39 conducts " & image(expect_39_0)
          & " total=" & image(total));
    end if;
    for round in 1 to 8 loop
      cancel_last <= '1';
      scan(1, '0');
      cancel_last <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- cash_register.ladder:265
    if not failed and (expect_40_0 and expect_40_1 and expect_40_2) /= '1' then
      failed := true;
      print("# failed expectation 40 conducts " & image(expect_40_0) & image(expect_40_1) & image(expect_40_2)
          & " total=" & image(total)
          & " lamp_combo=" & image(lamp_combo)
          & " lamp_drink=" & image(lamp_drink));
    end if;
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:267
    if not failed and (expect_41_0 and expect_41_1) /= '1' then
      failed := true;
      print("# failed expectation 41 conducts " & image(expect_41_0) & image(expect_41_1)
          & " total=" & image(total)
          & " lamp_combo=" & image(lamp_combo));
    end if;
    key_fries <= '1';
    scan(1, '0');
    key_fries <= '0';
    scan(1, '0');
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:270
    if not failed and (expect_42_0) /= '1' then
      failed := true;
      print("# failed expectation 42 conducts " & image(expect_42_0)
          & " total=" & image(total));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 12 - the last eight entries can be taken back, and no more");
    else
      print("ok 12 - the last eight entries can be taken back, and no more");
    end if;

    -- what was entered before a new order cannot be taken back in it
    failed := false;
    reset;
    to_go <= '1';
    key_combo <= '1';
    scan(1, '0');
    key_combo <= '0';
    scan(1, '0');
    new_order <= '1';
    scan(1, '0');
    new_order <= '0';
    scan(1, '0');
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    key_drink <= '1';
    scan(1, '0');
    key_drink <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:278
    if not failed and (expect_43_0 and expect_43_1) /= '1' then
      failed := true;
      print("# failed expectation 43 conducts " & image(expect_43_0) & image(expect_43_1)
          & " total=" & image(total)
          & " lamp_combo=" & image(lamp_combo));
    end if;
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    cancel_last <= '1';
    scan(1, '0');
    cancel_last <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:281
    if not failed and (expect_44_0) /= '1' then
      failed := true;
      print("# failed expectation 44 conducts " & image(expect_44_0)
          & " total=" & image(total));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 13 - what was entered before a new order cannot be taken back in it");
    else
      print("ok 13 - what was entered before a new order cannot be taken back in it");
    end if;

    -- a key together with new order is no entry
    failed := false;
    reset;
    key_combo <= '1';
    new_order <= '1';
    scan(1, '0');
    new_order <= '0';
    scan(1, '0');
    wait for 1 ns; -- cash_register.ladder:286
    if not failed and (expect_45_0 and expect_45_1) /= '1' then
      failed := true;
      print("# failed expectation 45 conducts " & image(expect_45_0) & image(expect_45_1)
          & " total=" & image(total)
          & " lamp_combo=" & image(lamp_combo));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 14 - a key together with new order is no entry");
    else
      print("ok 14 - a key together with new order is no entry");
    end if;

    assert failures = 0 report integer'image(failures) & " of 14 tests failed" severity failure;
    wait;
  end process;
end architecture;
