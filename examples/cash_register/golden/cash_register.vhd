-- Made by hotrail 0.1.0 from cash_register.ladder. Do not edit: change the ladder and build again.

-- CTUD: up-down counter
-- Example, with PV = 2:
-- IN  _#_#__#______
-- CD  ____#_#_#____
-- R   ___________##
-- LD  __________#_#
-- QU  ___#______#__
-- QD  #_______##_##
-- CV  0112111100200
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity cash_register_CTUD is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    CD    : in  std_logic;
    R     : in  std_logic;
    CV    : out unsigned(15 downto 0)
  );
end entity cash_register_CTUD;

architecture rtl of cash_register_CTUD is
  signal CV_reg : unsigned(15 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal was_down : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal unequal : std_logic;
  signal unequal_2 : std_logic;
  signal choice : unsigned(1 downto 0);
  signal sum : unsigned(15 downto 0);
  signal CV_next : unsigned(15 downto 0);
begin
  condition <= power and not was;
  condition_2 <= CD and not was_down;
  unequal <= '1' when CV_reg /= 32767 else '0';
  unequal_2 <= '1' when CV_reg /= 32768 else '0';
  choice <=
      to_unsigned(3, 2) when (condition_2 and not condition and unequal_2) = '1'
      else to_unsigned(0, 1) & (condition and not condition_2 and unequal);
  sum <= CV_reg + unsigned(resize(signed(choice), 16));
  CV_next <= to_unsigned(0, 16) when R = '1' else sum;

  CV <= CV_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV_reg <= (others => '0');
        was <= '0';
        was_down <= '0';
      else
        CV_reg <= CV_next;
        was <= power;
        was_down <= CD;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity cash_register is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    key_combo   : in  std_logic;
    key_double  : in  std_logic;
    key_junior  : in  std_logic;
    key_burger  : in  std_logic;
    key_fries   : in  std_logic;
    key_drink   : in  std_logic;
    cancel_last : in  std_logic;
    total_key   : in  std_logic;
    new_order   : in  std_logic;
    new_day     : in  std_logic;
    to_go       : in  std_logic;
    lamp_combo  : out std_logic;
    lamp_double : out std_logic;
    lamp_junior : out std_logic;
    lamp_burger : out std_logic;
    lamp_fries  : out std_logic;
    lamp_drink  : out std_logic;
    subtotal    : out std_logic_vector(31 downto 0);
    tax         : out std_logic_vector(31 downto 0);
    total       : out std_logic_vector(31 downto 0);
    paid        : out std_logic;
    sold        : out std_logic_vector(191 downto 0);
    profit      : out std_logic_vector(31 downto 0)
  );
end entity cash_register;

architecture rtl of cash_register is
  signal key_drink_before : std_logic := '0';
  signal key_fries_before : std_logic := '0';
  signal key_burger_before : std_logic := '0';
  signal key_junior_before : std_logic := '0';
  signal key_double_before : std_logic := '0';
  signal key_combo_before : std_logic := '0';
  signal paid_reg : std_logic := '0';
  signal place : unsigned(2 downto 0) := (others => '0');
  signal last_0 : unsigned(2 downto 0) := (others => '0');
  signal last_1 : unsigned(2 downto 0) := (others => '0');
  signal last_2 : unsigned(2 downto 0) := (others => '0');
  signal last_3 : unsigned(2 downto 0) := (others => '0');
  signal last_4 : unsigned(2 downto 0) := (others => '0');
  signal last_5 : unsigned(2 downto 0) := (others => '0');
  signal last_6 : unsigned(2 downto 0) := (others => '0');
  signal last_7 : unsigned(2 downto 0) := (others => '0');
  signal kept : unsigned(15 downto 0) := (others => '0');
  signal cancel_last_before : std_logic := '0';
  signal subtotal_reg : unsigned(31 downto 0) := (others => '0');
  signal tax_reg : unsigned(27 downto 0) := (others => '0');
  signal total_reg : unsigned(31 downto 0) := (others => '0');
  signal total_key_before : std_logic := '0';
  signal sold_0 : unsigned(31 downto 0) := (others => '0');
  signal sold_1 : unsigned(31 downto 0) := (others => '0');
  signal sold_2 : unsigned(31 downto 0) := (others => '0');
  signal sold_3 : unsigned(31 downto 0) := (others => '0');
  signal sold_4 : unsigned(31 downto 0) := (others => '0');
  signal sold_5 : unsigned(31 downto 0) := (others => '0');
  signal profit_reg : unsigned(31 downto 0) := (others => '0');
  signal new_day_before : std_logic := '0';
  signal lamp_combo_reg : std_logic := '0';
  signal lamp_double_reg : std_logic := '0';
  signal lamp_junior_reg : std_logic := '0';
  signal lamp_burger_reg : std_logic := '0';
  signal lamp_fries_reg : std_logic := '0';
  signal lamp_drink_reg : std_logic := '0';
  signal entry_rung2 : unsigned(3 downto 0);
  signal entry_rung3 : unsigned(3 downto 0);
  signal entry_rung4 : unsigned(3 downto 0);
  signal entry_rung5 : unsigned(3 downto 0);
  signal entry_rung6 : unsigned(3 downto 0);
  signal entry_rung7 : unsigned(3 downto 0);
  signal entry : unsigned(3 downto 0);
  signal rung9_unequal : std_logic;
  signal rung9_equal : std_logic;
  signal rung9_choice : unsigned(2 downto 0);
  signal last_0_next : unsigned(2 downto 0);
  signal rung9_equal_2 : std_logic;
  signal rung9_choice_2 : unsigned(2 downto 0);
  signal last_1_next : unsigned(2 downto 0);
  signal rung9_equal_3 : std_logic;
  signal rung9_choice_3 : unsigned(2 downto 0);
  signal last_2_next : unsigned(2 downto 0);
  signal rung9_equal_4 : std_logic;
  signal rung9_choice_4 : unsigned(2 downto 0);
  signal last_3_next : unsigned(2 downto 0);
  signal rung9_equal_5 : std_logic;
  signal rung9_choice_5 : unsigned(2 downto 0);
  signal last_4_next : unsigned(2 downto 0);
  signal rung9_equal_6 : std_logic;
  signal rung9_choice_6 : unsigned(2 downto 0);
  signal last_5_next : unsigned(2 downto 0);
  signal rung9_equal_7 : std_logic;
  signal rung9_choice_7 : unsigned(2 downto 0);
  signal last_6_next : unsigned(2 downto 0);
  signal rung9_equal_8 : std_logic;
  signal rung9_choice_8 : unsigned(2 downto 0);
  signal last_7_next : unsigned(2 downto 0);
  signal rung9_sum : unsigned(3 downto 0);
  signal place_rung9 : unsigned(2 downto 0);
  signal rung9_sum_2 : unsigned(15 downto 0);
  signal rung9_greater : std_logic;
  signal rung9_choice_9 : unsigned(3 downto 0);
  signal kept_rung9 : unsigned(15 downto 0);
  signal rung11_equal : std_logic;
  signal rung11_unequal : std_logic;
  signal rung11_power : std_logic;
  signal rung11_difference : unsigned(15 downto 0);
  signal kept_rung11 : unsigned(15 downto 0);
  signal rung11_sum : unsigned(3 downto 0);
  signal rung11_difference_2 : unsigned(3 downto 0);
  signal place_next : unsigned(2 downto 0);
  signal rung11_choice : unsigned(2 downto 0);
  signal rung11_choice_2 : unsigned(2 downto 0);
  signal rung11_choice_3 : unsigned(2 downto 0);
  signal rung11_choice_4 : unsigned(2 downto 0);
  signal rung11_choice_5 : unsigned(2 downto 0);
  signal rung11_choice_6 : unsigned(2 downto 0);
  signal rung11_choice_7 : unsigned(2 downto 0);
  signal cancelled : unsigned(3 downto 0);
  signal kept_next : unsigned(15 downto 0);
  signal paid_rung12 : std_logic;
  signal count_combo_power : std_logic;
  signal count_combo_CD : std_logic;
  signal count_combo_CV : unsigned(15 downto 0);
  signal count_double_power : std_logic;
  signal count_double_CD : std_logic;
  signal count_double_CV : unsigned(15 downto 0);
  signal count_junior_power : std_logic;
  signal count_junior_CD : std_logic;
  signal count_junior_CV : unsigned(15 downto 0);
  signal count_burger_power : std_logic;
  signal count_burger_CD : std_logic;
  signal count_burger_CV : unsigned(15 downto 0);
  signal count_fries_power : std_logic;
  signal count_fries_CD : std_logic;
  signal count_fries_CV : unsigned(15 downto 0);
  signal count_drink_power : std_logic;
  signal count_drink_CD : std_logic;
  signal count_drink_CV : unsigned(15 downto 0);
  signal lamp_combo_next : std_logic;
  signal lamp_double_next : std_logic;
  signal lamp_junior_next : std_logic;
  signal lamp_burger_next : std_logic;
  signal lamp_fries_next : std_logic;
  signal lamp_drink_next : std_logic;
  signal rung25_less : std_logic;
  signal rung25_choice : unsigned(15 downto 0);
  signal rung25_less_2 : std_logic;
  signal as_combo : unsigned(15 downto 0);
  signal rung25_extended : unsigned(31 downto 0);
  signal rung26_extended : unsigned(31 downto 0);
  signal rung26_product : unsigned(31 downto 0);
  signal rung26_extended_2 : unsigned(31 downto 0);
  signal rung26_product_2 : unsigned(31 downto 0);
  signal rung26_sum : unsigned(31 downto 0);
  signal rung26_extended_3 : unsigned(31 downto 0);
  signal rung26_product_3 : unsigned(31 downto 0);
  signal subtotal_rung26 : unsigned(31 downto 0);
  signal rung27_extended : unsigned(31 downto 0);
  signal rung27_product : unsigned(31 downto 0);
  signal rung27_sum : unsigned(31 downto 0);
  signal rung27_extended_2 : unsigned(31 downto 0);
  signal rung27_product_2 : unsigned(31 downto 0);
  signal rung27_sum_2 : unsigned(31 downto 0);
  signal rung27_extended_3 : unsigned(31 downto 0);
  signal rung27_product_3 : unsigned(31 downto 0);
  signal subtotal_rung27 : unsigned(31 downto 0);
  signal rung28_product : unsigned(31 downto 0);
  signal subtotal_next : unsigned(31 downto 0);
  signal tax_value : unsigned(31 downto 0);
  signal rung30_sum : unsigned(31 downto 0);
  signal rung30_sum_2 : unsigned(31 downto 0);
  signal tax_next : unsigned(27 downto 0);
  signal total_next : unsigned(31 downto 0);
  signal rung32_extended : unsigned(31 downto 0);
  signal rung32_product : unsigned(31 downto 0);
  signal rung32_extended_2 : unsigned(31 downto 0);
  signal rung32_product_2 : unsigned(31 downto 0);
  signal rung32_sum : unsigned(31 downto 0);
  signal rung32_extended_3 : unsigned(31 downto 0);
  signal rung32_product_3 : unsigned(31 downto 0);
  signal earned_rung32 : unsigned(31 downto 0);
  signal rung33_extended : unsigned(31 downto 0);
  signal rung33_product : unsigned(31 downto 0);
  signal rung33_sum : unsigned(31 downto 0);
  signal rung33_extended_2 : unsigned(31 downto 0);
  signal rung33_product_2 : unsigned(31 downto 0);
  signal rung33_sum_2 : unsigned(31 downto 0);
  signal rung33_extended_3 : unsigned(31 downto 0);
  signal rung33_product_3 : unsigned(31 downto 0);
  signal earned_rung33 : unsigned(31 downto 0);
  signal rung34_product : unsigned(31 downto 0);
  signal earned : unsigned(31 downto 0);
  signal rung35_greater : std_logic;
  signal rung35_power : std_logic;
  signal paid_next : std_logic;
  signal rung35_sum : unsigned(31 downto 0);
  signal sold_0_rung35 : unsigned(31 downto 0);
  signal rung35_sum_2 : unsigned(31 downto 0);
  signal sold_1_rung35 : unsigned(31 downto 0);
  signal rung35_sum_3 : unsigned(31 downto 0);
  signal sold_2_rung35 : unsigned(31 downto 0);
  signal rung35_sum_4 : unsigned(31 downto 0);
  signal sold_3_rung35 : unsigned(31 downto 0);
  signal rung35_sum_5 : unsigned(31 downto 0);
  signal sold_4_rung35 : unsigned(31 downto 0);
  signal rung35_sum_6 : unsigned(31 downto 0);
  signal sold_5_rung35 : unsigned(31 downto 0);
  signal rung35_sum_7 : unsigned(31 downto 0);
  signal profit_rung35 : unsigned(31 downto 0);
  signal rung36_power : std_logic;
  signal profit_next : unsigned(31 downto 0);
  signal sold_0_next : unsigned(31 downto 0);
  signal sold_1_next : unsigned(31 downto 0);
  signal sold_2_next : unsigned(31 downto 0);
  signal sold_3_next : unsigned(31 downto 0);
  signal sold_4_next : unsigned(31 downto 0);
  signal sold_5_next : unsigned(31 downto 0);
begin

  -- rung 1 "a key: one in a scan, the upper one of several", cash_register.ladder:52

  -- rung 2, cash_register.ladder:54
  entry_rung2 <=
      to_unsigned(5, 4) when (key_drink and not key_drink_before) = '1' else to_unsigned(15, 4);

  -- rung 3, cash_register.ladder:55
  entry_rung3 <= to_unsigned(4, 4) when (key_fries and not key_fries_before) = '1' else entry_rung2;

  -- rung 4, cash_register.ladder:56
  entry_rung4 <=
      to_unsigned(3, 4) when (key_burger and not key_burger_before) = '1' else entry_rung3;

  -- rung 5, cash_register.ladder:57
  entry_rung5 <=
      to_unsigned(2, 4) when (key_junior and not key_junior_before) = '1' else entry_rung4;

  -- rung 6, cash_register.ladder:58
  entry_rung6 <=
      to_unsigned(1, 4) when (key_double and not key_double_before) = '1' else entry_rung5;

  -- rung 7, cash_register.ladder:59
  entry_rung7 <= to_unsigned(0, 4) when (key_combo and not key_combo_before) = '1' else entry_rung6;

  -- rung 8, cash_register.ladder:60
  entry <= to_unsigned(15, 4) when (paid_reg or new_order) = '1' else entry_rung7;

  -- rung 9 "remember what was entered", cash_register.ladder:62
  rung9_unequal <= '1' when entry /= 15 else '0';
  rung9_equal <= '1' when place = 0 else '0';
  rung9_choice <= entry(2 downto 0) when rung9_equal = '1' else last_0;
  last_0_next <= rung9_choice when rung9_unequal = '1' else last_0;
  rung9_equal_2 <= '1' when place = 1 else '0';
  rung9_choice_2 <= entry(2 downto 0) when rung9_equal_2 = '1' else last_1;
  last_1_next <= rung9_choice_2 when rung9_unequal = '1' else last_1;
  rung9_equal_3 <= '1' when place = 2 else '0';
  rung9_choice_3 <= entry(2 downto 0) when rung9_equal_3 = '1' else last_2;
  last_2_next <= rung9_choice_3 when rung9_unequal = '1' else last_2;
  rung9_equal_4 <= '1' when place = 3 else '0';
  rung9_choice_4 <= entry(2 downto 0) when rung9_equal_4 = '1' else last_3;
  last_3_next <= rung9_choice_4 when rung9_unequal = '1' else last_3;
  rung9_equal_5 <= '1' when place = 4 else '0';
  rung9_choice_5 <= entry(2 downto 0) when rung9_equal_5 = '1' else last_4;
  last_4_next <= rung9_choice_5 when rung9_unequal = '1' else last_4;
  rung9_equal_6 <= '1' when place = 5 else '0';
  rung9_choice_6 <= entry(2 downto 0) when rung9_equal_6 = '1' else last_5;
  last_5_next <= rung9_choice_6 when rung9_unequal = '1' else last_5;
  rung9_equal_7 <= '1' when place = 6 else '0';
  rung9_choice_7 <= entry(2 downto 0) when rung9_equal_7 = '1' else last_6;
  last_6_next <= rung9_choice_7 when rung9_unequal = '1' else last_6;
  rung9_equal_8 <= '1' when place = 7 else '0';
  rung9_choice_8 <= entry(2 downto 0) when rung9_equal_8 = '1' else last_7;
  last_7_next <= rung9_choice_8 when rung9_unequal = '1' else last_7;
  rung9_sum <= resize(place, 4) + 1;
  place_rung9 <= rung9_sum(2 downto 0) when rung9_unequal = '1' else place;
  rung9_sum_2 <= kept + 1;
  rung9_greater <= '1' when rung9_sum_2 > 8 else '0';
  rung9_choice_9 <= to_unsigned(8, 4) when rung9_greater = '1' else rung9_sum_2(3 downto 0);
  kept_rung9 <= resize(rung9_choice_9, 16) when rung9_unequal = '1' else kept;

  -- rung 10 "take the last entry back", cash_register.ladder:66

  -- rung 11, cash_register.ladder:68
  rung11_equal <= '1' when entry = 15 else '0';
  rung11_unequal <= '1' when kept_rung9 /= 0 else '0';
  rung11_power <=
      cancel_last and not cancel_last_before and not paid_reg and rung11_equal and rung11_unequal;
  rung11_difference <= kept_rung9 - 1;
  kept_rung11 <= rung11_difference when rung11_power = '1' else kept_rung9;
  rung11_sum <= resize(place_rung9, 4) + 8;
  rung11_difference_2 <= rung11_sum - 1;
  place_next <= rung11_difference_2(2 downto 0) when rung11_power = '1' else place_rung9;
  rung11_choice <= last_1_next when place_next(0) = '1' else last_0_next;
  rung11_choice_2 <= last_3_next when place_next(0) = '1' else last_2_next;
  rung11_choice_3 <= last_5_next when place_next(0) = '1' else last_4_next;
  rung11_choice_4 <= last_7_next when place_next(0) = '1' else last_6_next;
  rung11_choice_5 <= rung11_choice_2 when place_next(1) = '1' else rung11_choice;
  rung11_choice_6 <= rung11_choice_4 when place_next(1) = '1' else rung11_choice_3;
  rung11_choice_7 <= rung11_choice_6 when place_next(2) = '1' else rung11_choice_5;
  cancelled <= resize(rung11_choice_7, 4) when rung11_power = '1' else to_unsigned(15, 4);

  -- rung 12 "new order", cash_register.ladder:72
  kept_next <= to_unsigned(0, 16) when new_order = '1' else kept_rung11;
  paid_rung12 <= paid_reg and not new_order;

  -- rung 13 "count", cash_register.ladder:75
  count_combo_power <= '1' when entry = 0 else '0';
  count_combo_CD <= '1' when cancelled = 0 else '0';
  count_combo: entity work.cash_register_CTUD
    port map (
      clk => clk,
      rst => rst,
      power => count_combo_power,
      CD => count_combo_CD,
      R => new_order,
      CV => count_combo_CV
    );

  -- rung 14, cash_register.ladder:77
  count_double_power <= '1' when entry = 1 else '0';
  count_double_CD <= '1' when cancelled = 1 else '0';
  count_double: entity work.cash_register_CTUD
    port map (
      clk => clk,
      rst => rst,
      power => count_double_power,
      CD => count_double_CD,
      R => new_order,
      CV => count_double_CV
    );

  -- rung 15, cash_register.ladder:78
  count_junior_power <= '1' when entry = 2 else '0';
  count_junior_CD <= '1' when cancelled = 2 else '0';
  count_junior: entity work.cash_register_CTUD
    port map (
      clk => clk,
      rst => rst,
      power => count_junior_power,
      CD => count_junior_CD,
      R => new_order,
      CV => count_junior_CV
    );

  -- rung 16, cash_register.ladder:79
  count_burger_power <= '1' when entry = 3 else '0';
  count_burger_CD <= '1' when cancelled = 3 else '0';
  count_burger: entity work.cash_register_CTUD
    port map (
      clk => clk,
      rst => rst,
      power => count_burger_power,
      CD => count_burger_CD,
      R => new_order,
      CV => count_burger_CV
    );

  -- rung 17, cash_register.ladder:80
  count_fries_power <= '1' when entry = 4 else '0';
  count_fries_CD <= '1' when cancelled = 4 else '0';
  count_fries: entity work.cash_register_CTUD
    port map (
      clk => clk,
      rst => rst,
      power => count_fries_power,
      CD => count_fries_CD,
      R => new_order,
      CV => count_fries_CV
    );

  -- rung 18, cash_register.ladder:81
  count_drink_power <= '1' when entry = 5 else '0';
  count_drink_CD <= '1' when cancelled = 5 else '0';
  count_drink: entity work.cash_register_CTUD
    port map (
      clk => clk,
      rst => rst,
      power => count_drink_power,
      CD => count_drink_CD,
      R => new_order,
      CV => count_drink_CV
    );

  -- rung 19 "a lamp in each key that was used", cash_register.ladder:83
  lamp_combo_next <= '1' when signed(count_combo_CV) > 0 else '0';

  -- rung 20, cash_register.ladder:85
  lamp_double_next <= '1' when signed(count_double_CV) > 0 else '0';

  -- rung 21, cash_register.ladder:86
  lamp_junior_next <= '1' when signed(count_junior_CV) > 0 else '0';

  -- rung 22, cash_register.ladder:87
  lamp_burger_next <= '1' when signed(count_burger_CV) > 0 else '0';

  -- rung 23, cash_register.ladder:88
  lamp_fries_next <= '1' when signed(count_fries_CV) > 0 else '0';

  -- rung 24, cash_register.ladder:89
  lamp_drink_next <= '1' when signed(count_drink_CV) > 0 else '0';

  -- rung 25 "burger, fries and drink cost what a combo costs", cash_register.ladder:91
  rung25_less <= '1' when signed(count_drink_CV) < signed(count_fries_CV) else '0';
  rung25_choice <= count_drink_CV when rung25_less = '1' else count_fries_CV;
  rung25_less_2 <= '1' when signed(rung25_choice) < signed(count_burger_CV) else '0';
  as_combo <= rung25_choice when rung25_less_2 = '1' else count_burger_CV;
  rung25_extended <= unsigned(resize(signed(as_combo), 32));

  -- rung 26 "what the order costs", cash_register.ladder:94
  rung26_extended <= unsigned(resize(signed(count_combo_CV), 32));
  rung26_product <= resize(rung26_extended * to_unsigned(899, 32), 32);
  rung26_extended_2 <= unsigned(resize(signed(count_double_CV), 32));
  rung26_product_2 <= resize(rung26_extended_2 * to_unsigned(1099, 32), 32);
  rung26_sum <= rung26_product + rung26_product_2;
  rung26_extended_3 <= unsigned(resize(signed(count_junior_CV), 32));
  rung26_product_3 <= resize(rung26_extended_3 * to_unsigned(649, 32), 32);
  subtotal_rung26 <= rung26_sum + rung26_product_3;

  -- rung 27, cash_register.ladder:97
  rung27_extended <= unsigned(resize(signed(count_burger_CV), 32));
  rung27_product <= resize(rung27_extended * to_unsigned(549, 32), 32);
  rung27_sum <= subtotal_rung26 + rung27_product;
  rung27_extended_2 <= unsigned(resize(signed(count_fries_CV), 32));
  rung27_product_2 <= resize(rung27_extended_2 * to_unsigned(279, 32), 32);
  rung27_sum_2 <= rung27_sum + rung27_product_2;
  rung27_extended_3 <= unsigned(resize(signed(count_drink_CV), 32));
  rung27_product_3 <= resize(rung27_extended_3 * to_unsigned(229, 32), 32);
  subtotal_rung27 <= rung27_sum_2 + rung27_product_3;

  -- rung 28, cash_register.ladder:100
  rung28_product <= resize(rung25_extended * to_unsigned(158, 32), 32);
  subtotal_next <= subtotal_rung27 - rung28_product;

  -- rung 29 "6.25 % are a sixteenth, rounded to a cent", cash_register.ladder:102
  tax_value <= unsigned(resize(signed(tax_reg), 32));

  -- rung 30, cash_register.ladder:104
  rung30_sum <= subtotal_next + 8;
  rung30_sum_2 <= rung30_sum + resize(unsigned'(3 downto 0 => rung30_sum(31)), 32);
  tax_next <= rung30_sum_2(31 downto 4) when (not to_go) = '1' else to_unsigned(0, 28);

  -- rung 31, cash_register.ladder:105
  total_next <= subtotal_next + unsigned(resize(signed(tax_next), 32));

  -- rung 32 "what it earns", cash_register.ladder:107
  rung32_extended <= unsigned(resize(signed(count_combo_CV), 32));
  rung32_product <= resize(rung32_extended * to_unsigned(310, 32), 32);
  rung32_extended_2 <= unsigned(resize(signed(count_double_CV), 32));
  rung32_product_2 <= resize(rung32_extended_2 * to_unsigned(370, 32), 32);
  rung32_sum <= rung32_product + rung32_product_2;
  rung32_extended_3 <= unsigned(resize(signed(count_junior_CV), 32));
  rung32_product_3 <= resize(rung32_extended_3 * to_unsigned(240, 32), 32);
  earned_rung32 <= rung32_sum + rung32_product_3;

  -- rung 33, cash_register.ladder:110
  rung33_extended <= unsigned(resize(signed(count_burger_CV), 32));
  rung33_product <= resize(rung33_extended * to_unsigned(150, 32), 32);
  rung33_sum <= earned_rung32 + rung33_product;
  rung33_extended_2 <= unsigned(resize(signed(count_fries_CV), 32));
  rung33_product_2 <= resize(rung33_extended_2 * to_unsigned(170, 32), 32);
  rung33_sum_2 <= rung33_sum + rung33_product_2;
  rung33_extended_3 <= unsigned(resize(signed(count_drink_CV), 32));
  rung33_product_3 <= resize(rung33_extended_3 * to_unsigned(140, 32), 32);
  earned_rung33 <= rung33_sum_2 + rung33_product_3;

  -- rung 34, cash_register.ladder:113
  rung34_product <= resize(rung25_extended * to_unsigned(158, 32), 32);
  earned <= earned_rung33 - rung34_product;

  -- rung 35 "paid: into the books of the day, once", cash_register.ladder:115
  rung35_greater <= '1' when signed(subtotal_next) > 0 else '0';
  rung35_power <= total_key and not total_key_before and not paid_rung12 and rung35_greater;
  paid_next <= rung35_power or paid_rung12;
  rung35_sum <= sold_0 + unsigned(resize(signed(count_combo_CV), 32));
  sold_0_rung35 <= rung35_sum when rung35_power = '1' else sold_0;
  rung35_sum_2 <= sold_1 + unsigned(resize(signed(count_double_CV), 32));
  sold_1_rung35 <= rung35_sum_2 when rung35_power = '1' else sold_1;
  rung35_sum_3 <= sold_2 + unsigned(resize(signed(count_junior_CV), 32));
  sold_2_rung35 <= rung35_sum_3 when rung35_power = '1' else sold_2;
  rung35_sum_4 <= sold_3 + unsigned(resize(signed(count_burger_CV), 32));
  sold_3_rung35 <= rung35_sum_4 when rung35_power = '1' else sold_3;
  rung35_sum_5 <= sold_4 + unsigned(resize(signed(count_fries_CV), 32));
  sold_4_rung35 <= rung35_sum_5 when rung35_power = '1' else sold_4;
  rung35_sum_6 <= sold_5 + unsigned(resize(signed(count_drink_CV), 32));
  sold_5_rung35 <= rung35_sum_6 when rung35_power = '1' else sold_5;
  rung35_sum_7 <= profit_reg + earned;
  profit_rung35 <= rung35_sum_7 when rung35_power = '1' else profit_reg;

  -- rung 36 "new day", cash_register.ladder:124
  rung36_power <= new_day and not new_day_before;
  profit_next <= to_unsigned(0, 32) when rung36_power = '1' else profit_rung35;
  sold_0_next <= to_unsigned(0, 32) when rung36_power = '1' else sold_0_rung35;
  sold_1_next <= to_unsigned(0, 32) when rung36_power = '1' else sold_1_rung35;
  sold_2_next <= to_unsigned(0, 32) when rung36_power = '1' else sold_2_rung35;
  sold_3_next <= to_unsigned(0, 32) when rung36_power = '1' else sold_3_rung35;
  sold_4_next <= to_unsigned(0, 32) when rung36_power = '1' else sold_4_rung35;
  sold_5_next <= to_unsigned(0, 32) when rung36_power = '1' else sold_5_rung35;

  lamp_combo <= lamp_combo_reg;
  lamp_double <= lamp_double_reg;
  lamp_junior <= lamp_junior_reg;
  lamp_burger <= lamp_burger_reg;
  lamp_fries <= lamp_fries_reg;
  lamp_drink <= lamp_drink_reg;
  subtotal <= std_logic_vector(subtotal_reg);
  tax <= std_logic_vector(tax_value);
  total <= std_logic_vector(total_reg);
  paid <= paid_reg;
  sold(31 downto 0) <= std_logic_vector(sold_0);
  sold(63 downto 32) <= std_logic_vector(sold_1);
  sold(95 downto 64) <= std_logic_vector(sold_2);
  sold(127 downto 96) <= std_logic_vector(sold_3);
  sold(159 downto 128) <= std_logic_vector(sold_4);
  sold(191 downto 160) <= std_logic_vector(sold_5);
  profit <= std_logic_vector(profit_reg);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        key_drink_before <= '0';
        key_fries_before <= '0';
        key_burger_before <= '0';
        key_junior_before <= '0';
        key_double_before <= '0';
        key_combo_before <= '0';
        paid_reg <= '0';
        place <= (others => '0');
        last_0 <= (others => '0');
        last_1 <= (others => '0');
        last_2 <= (others => '0');
        last_3 <= (others => '0');
        last_4 <= (others => '0');
        last_5 <= (others => '0');
        last_6 <= (others => '0');
        last_7 <= (others => '0');
        kept <= (others => '0');
        cancel_last_before <= '0';
        subtotal_reg <= (others => '0');
        tax_reg <= (others => '0');
        total_reg <= (others => '0');
        total_key_before <= '0';
        sold_0 <= (others => '0');
        sold_1 <= (others => '0');
        sold_2 <= (others => '0');
        sold_3 <= (others => '0');
        sold_4 <= (others => '0');
        sold_5 <= (others => '0');
        profit_reg <= (others => '0');
        new_day_before <= '0';
        lamp_combo_reg <= '0';
        lamp_double_reg <= '0';
        lamp_junior_reg <= '0';
        lamp_burger_reg <= '0';
        lamp_fries_reg <= '0';
        lamp_drink_reg <= '0';
      else
        key_drink_before <= key_drink;
        key_fries_before <= key_fries;
        key_burger_before <= key_burger;
        key_junior_before <= key_junior;
        key_double_before <= key_double;
        key_combo_before <= key_combo;
        paid_reg <= paid_next;
        place <= place_next;
        last_0 <= last_0_next;
        last_1 <= last_1_next;
        last_2 <= last_2_next;
        last_3 <= last_3_next;
        last_4 <= last_4_next;
        last_5 <= last_5_next;
        last_6 <= last_6_next;
        last_7 <= last_7_next;
        kept <= kept_next;
        cancel_last_before <= cancel_last;
        subtotal_reg <= subtotal_next;
        tax_reg <= tax_next;
        total_reg <= total_next;
        total_key_before <= total_key;
        sold_0 <= sold_0_next;
        sold_1 <= sold_1_next;
        sold_2 <= sold_2_next;
        sold_3 <= sold_3_next;
        sold_4 <= sold_4_next;
        sold_5 <= sold_5_next;
        profit_reg <= profit_next;
        new_day_before <= new_day;
        lamp_combo_reg <= lamp_combo_next;
        lamp_double_reg <= lamp_double_next;
        lamp_junior_reg <= lamp_junior_next;
        lamp_burger_reg <= lamp_burger_next;
        lamp_fries_reg <= lamp_fries_next;
        lamp_drink_reg <= lamp_drink_next;
      end if;
    end if;
  end process;
end architecture rtl;
