-- Made by hotrail 0.1.0 from parts_average.ladder. Do not edit: change the ladder and build again.

-- CTU: up counter
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- R   _________##____
-- Q   ___######____##
-- CV  011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity parts_average_CTU is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    clear_after : in  std_logic;
    CV          : out unsigned(14 downto 0)
  );
end entity parts_average_CTU;

architecture rtl of parts_average_CTU is
  signal CV_reg : unsigned(14 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal unequal : std_logic;
  signal CV_value : unsigned(14 downto 0);
  signal CV_next : unsigned(14 downto 0);
begin
  unequal <= '1' when CV_reg /= 32767 else '0';
  CV_value <= CV_reg + (to_unsigned(0, 14) & (power and not was and unequal));
  CV_next <= to_unsigned(0, 15) when clear_after = '1' else CV_value;

  CV <= CV_value;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV_reg <= (others => '0');
        was <= '0';
      else
        CV_reg <= CV_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to power = 1, PT = 60 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity parts_average_TON_power1_PT60 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    clear_after : in  std_logic;
    Q           : out std_logic
  );
end entity parts_average_TON_power1_PT60;

architecture rtl of parts_average_TON_power1_PT60 is
  signal ET : unsigned(5 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal equal : std_logic;
  signal sum : unsigned(5 downto 0);
  signal choice : unsigned(5 downto 0);
  signal equal_2 : std_logic;
  signal ET_next : unsigned(5 downto 0);
begin
  equal <= '1' when ET = 60 else '0';
  sum <= ET + (to_unsigned(0, 5) & (tick and not equal));
  choice <= sum when was = '1' else to_unsigned(0, 6);
  equal_2 <= '1' when ET = 59 else '0';
  ET_next <= to_unsigned(0, 6) when clear_after = '1' else choice;

  Q <= was and ((tick and equal_2) or equal);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
      else
        ET <= ET_next;
        was <= '1';
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity parts_average is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    sensor      : in  std_logic;
    last_minute : out std_logic_vector(15 downto 0);
    average_10  : out std_logic_vector(15 downto 0);
    average_60  : out std_logic_vector(15 downto 0)
  );
end entity parts_average;

architecture rtl of parts_average is
  signal last_minute_reg : unsigned(14 downto 0) := (others => '0');
  signal newest : unsigned(5 downto 0) := (others => '0');
  signal tenth : unsigned(15 downto 0) := (others => '0');
  signal sum_10 : unsigned(15 downto 0) := (others => '0');
  signal minutes_0 : unsigned(14 downto 0) := (others => '0');
  signal minutes_1 : unsigned(14 downto 0) := (others => '0');
  signal minutes_2 : unsigned(14 downto 0) := (others => '0');
  signal minutes_3 : unsigned(14 downto 0) := (others => '0');
  signal minutes_4 : unsigned(14 downto 0) := (others => '0');
  signal minutes_5 : unsigned(14 downto 0) := (others => '0');
  signal minutes_6 : unsigned(14 downto 0) := (others => '0');
  signal minutes_7 : unsigned(14 downto 0) := (others => '0');
  signal minutes_8 : unsigned(14 downto 0) := (others => '0');
  signal minutes_9 : unsigned(14 downto 0) := (others => '0');
  signal minutes_10 : unsigned(14 downto 0) := (others => '0');
  signal minutes_11 : unsigned(14 downto 0) := (others => '0');
  signal minutes_12 : unsigned(14 downto 0) := (others => '0');
  signal minutes_13 : unsigned(14 downto 0) := (others => '0');
  signal minutes_14 : unsigned(14 downto 0) := (others => '0');
  signal minutes_15 : unsigned(14 downto 0) := (others => '0');
  signal minutes_16 : unsigned(14 downto 0) := (others => '0');
  signal minutes_17 : unsigned(14 downto 0) := (others => '0');
  signal minutes_18 : unsigned(14 downto 0) := (others => '0');
  signal minutes_19 : unsigned(14 downto 0) := (others => '0');
  signal minutes_20 : unsigned(14 downto 0) := (others => '0');
  signal minutes_21 : unsigned(14 downto 0) := (others => '0');
  signal minutes_22 : unsigned(14 downto 0) := (others => '0');
  signal minutes_23 : unsigned(14 downto 0) := (others => '0');
  signal minutes_24 : unsigned(14 downto 0) := (others => '0');
  signal minutes_25 : unsigned(14 downto 0) := (others => '0');
  signal minutes_26 : unsigned(14 downto 0) := (others => '0');
  signal minutes_27 : unsigned(14 downto 0) := (others => '0');
  signal minutes_28 : unsigned(14 downto 0) := (others => '0');
  signal minutes_29 : unsigned(14 downto 0) := (others => '0');
  signal minutes_30 : unsigned(14 downto 0) := (others => '0');
  signal minutes_31 : unsigned(14 downto 0) := (others => '0');
  signal minutes_32 : unsigned(14 downto 0) := (others => '0');
  signal minutes_33 : unsigned(14 downto 0) := (others => '0');
  signal minutes_34 : unsigned(14 downto 0) := (others => '0');
  signal minutes_35 : unsigned(14 downto 0) := (others => '0');
  signal minutes_36 : unsigned(14 downto 0) := (others => '0');
  signal minutes_37 : unsigned(14 downto 0) := (others => '0');
  signal minutes_38 : unsigned(14 downto 0) := (others => '0');
  signal minutes_39 : unsigned(14 downto 0) := (others => '0');
  signal minutes_40 : unsigned(14 downto 0) := (others => '0');
  signal minutes_41 : unsigned(14 downto 0) := (others => '0');
  signal minutes_42 : unsigned(14 downto 0) := (others => '0');
  signal minutes_43 : unsigned(14 downto 0) := (others => '0');
  signal minutes_44 : unsigned(14 downto 0) := (others => '0');
  signal minutes_45 : unsigned(14 downto 0) := (others => '0');
  signal minutes_46 : unsigned(14 downto 0) := (others => '0');
  signal minutes_47 : unsigned(14 downto 0) := (others => '0');
  signal minutes_48 : unsigned(14 downto 0) := (others => '0');
  signal minutes_49 : unsigned(14 downto 0) := (others => '0');
  signal minutes_50 : unsigned(14 downto 0) := (others => '0');
  signal minutes_51 : unsigned(14 downto 0) := (others => '0');
  signal minutes_52 : unsigned(14 downto 0) := (others => '0');
  signal minutes_53 : unsigned(14 downto 0) := (others => '0');
  signal minutes_54 : unsigned(14 downto 0) := (others => '0');
  signal minutes_55 : unsigned(14 downto 0) := (others => '0');
  signal minutes_56 : unsigned(14 downto 0) := (others => '0');
  signal minutes_57 : unsigned(14 downto 0) := (others => '0');
  signal minutes_58 : unsigned(14 downto 0) := (others => '0');
  signal minutes_59 : unsigned(14 downto 0) := (others => '0');
  signal sum_60 : unsigned(15 downto 0) := (others => '0');
  signal known_10 : unsigned(3 downto 0) := (others => '0');
  signal average_10_reg : unsigned(15 downto 0) := (others => '0');
  signal known_60 : unsigned(5 downto 0) := (others => '0');
  signal average_60_reg : unsigned(15 downto 0) := (others => '0');
  signal count_CV : unsigned(14 downto 0);
  signal minute_Q : std_logic;
  signal last_minute_value : unsigned(15 downto 0);
  signal last_minute_next : unsigned(14 downto 0);
  signal rung2_extended : unsigned(15 downto 0);
  signal rung3_difference : unsigned(6 downto 0);
  signal tenth_rung3 : unsigned(15 downto 0);
  signal rung4_less : std_logic;
  signal rung4_sum : unsigned(15 downto 0);
  signal tenth_next : unsigned(15 downto 0);
  signal rung5_choice : unsigned(14 downto 0);
  signal rung5_choice_2 : unsigned(14 downto 0);
  signal rung5_choice_3 : unsigned(14 downto 0);
  signal rung5_choice_4 : unsigned(14 downto 0);
  signal rung5_choice_5 : unsigned(14 downto 0);
  signal rung5_choice_6 : unsigned(14 downto 0);
  signal rung5_choice_7 : unsigned(14 downto 0);
  signal rung5_choice_8 : unsigned(14 downto 0);
  signal rung5_choice_9 : unsigned(14 downto 0);
  signal rung5_choice_10 : unsigned(14 downto 0);
  signal rung5_choice_11 : unsigned(14 downto 0);
  signal rung5_choice_12 : unsigned(14 downto 0);
  signal rung5_choice_13 : unsigned(14 downto 0);
  signal rung5_choice_14 : unsigned(14 downto 0);
  signal rung5_choice_15 : unsigned(14 downto 0);
  signal rung5_choice_16 : unsigned(14 downto 0);
  signal rung5_choice_17 : unsigned(14 downto 0);
  signal rung5_choice_18 : unsigned(14 downto 0);
  signal rung5_choice_19 : unsigned(14 downto 0);
  signal rung5_choice_20 : unsigned(14 downto 0);
  signal rung5_choice_21 : unsigned(14 downto 0);
  signal rung5_choice_22 : unsigned(14 downto 0);
  signal rung5_choice_23 : unsigned(14 downto 0);
  signal rung5_choice_24 : unsigned(14 downto 0);
  signal rung5_choice_25 : unsigned(14 downto 0);
  signal rung5_choice_26 : unsigned(14 downto 0);
  signal rung5_choice_27 : unsigned(14 downto 0);
  signal rung5_choice_28 : unsigned(14 downto 0);
  signal rung5_choice_29 : unsigned(14 downto 0);
  signal rung5_choice_30 : unsigned(14 downto 0);
  signal rung5_choice_31 : unsigned(14 downto 0);
  signal rung5_choice_32 : unsigned(14 downto 0);
  signal rung5_choice_33 : unsigned(14 downto 0);
  signal rung5_choice_34 : unsigned(14 downto 0);
  signal rung5_choice_35 : unsigned(14 downto 0);
  signal rung5_choice_36 : unsigned(14 downto 0);
  signal rung5_choice_37 : unsigned(14 downto 0);
  signal rung5_choice_38 : unsigned(14 downto 0);
  signal rung5_choice_39 : unsigned(14 downto 0);
  signal rung5_choice_40 : unsigned(14 downto 0);
  signal rung5_choice_41 : unsigned(14 downto 0);
  signal rung5_choice_42 : unsigned(14 downto 0);
  signal rung5_choice_43 : unsigned(14 downto 0);
  signal rung5_choice_44 : unsigned(14 downto 0);
  signal rung5_choice_45 : unsigned(14 downto 0);
  signal rung5_choice_46 : unsigned(14 downto 0);
  signal rung5_choice_47 : unsigned(14 downto 0);
  signal rung5_choice_48 : unsigned(14 downto 0);
  signal rung5_choice_49 : unsigned(14 downto 0);
  signal rung5_choice_50 : unsigned(14 downto 0);
  signal rung5_choice_51 : unsigned(14 downto 0);
  signal rung5_choice_52 : unsigned(14 downto 0);
  signal rung5_choice_53 : unsigned(14 downto 0);
  signal rung5_choice_54 : unsigned(14 downto 0);
  signal rung5_choice_55 : unsigned(14 downto 0);
  signal rung5_choice_56 : unsigned(14 downto 0);
  signal rung5_choice_57 : unsigned(14 downto 0);
  signal rung5_choice_58 : unsigned(14 downto 0);
  signal rung5_choice_59 : unsigned(14 downto 0);
  signal rung5_less : std_logic;
  signal rung5_choice_60 : unsigned(14 downto 0);
  signal rung5_difference : unsigned(15 downto 0);
  signal rung5_sum : unsigned(15 downto 0);
  signal sum_10_next : unsigned(15 downto 0);
  signal rung6_choice : unsigned(14 downto 0);
  signal rung6_choice_2 : unsigned(14 downto 0);
  signal rung6_choice_3 : unsigned(14 downto 0);
  signal rung6_choice_4 : unsigned(14 downto 0);
  signal rung6_choice_5 : unsigned(14 downto 0);
  signal rung6_choice_6 : unsigned(14 downto 0);
  signal rung6_choice_7 : unsigned(14 downto 0);
  signal rung6_choice_8 : unsigned(14 downto 0);
  signal rung6_choice_9 : unsigned(14 downto 0);
  signal rung6_choice_10 : unsigned(14 downto 0);
  signal rung6_choice_11 : unsigned(14 downto 0);
  signal rung6_choice_12 : unsigned(14 downto 0);
  signal rung6_choice_13 : unsigned(14 downto 0);
  signal rung6_choice_14 : unsigned(14 downto 0);
  signal rung6_choice_15 : unsigned(14 downto 0);
  signal rung6_choice_16 : unsigned(14 downto 0);
  signal rung6_choice_17 : unsigned(14 downto 0);
  signal rung6_choice_18 : unsigned(14 downto 0);
  signal rung6_choice_19 : unsigned(14 downto 0);
  signal rung6_choice_20 : unsigned(14 downto 0);
  signal rung6_choice_21 : unsigned(14 downto 0);
  signal rung6_choice_22 : unsigned(14 downto 0);
  signal rung6_choice_23 : unsigned(14 downto 0);
  signal rung6_choice_24 : unsigned(14 downto 0);
  signal rung6_choice_25 : unsigned(14 downto 0);
  signal rung6_choice_26 : unsigned(14 downto 0);
  signal rung6_choice_27 : unsigned(14 downto 0);
  signal rung6_choice_28 : unsigned(14 downto 0);
  signal rung6_choice_29 : unsigned(14 downto 0);
  signal rung6_choice_30 : unsigned(14 downto 0);
  signal rung6_choice_31 : unsigned(14 downto 0);
  signal rung6_choice_32 : unsigned(14 downto 0);
  signal rung6_choice_33 : unsigned(14 downto 0);
  signal rung6_choice_34 : unsigned(14 downto 0);
  signal rung6_choice_35 : unsigned(14 downto 0);
  signal rung6_choice_36 : unsigned(14 downto 0);
  signal rung6_choice_37 : unsigned(14 downto 0);
  signal rung6_choice_38 : unsigned(14 downto 0);
  signal rung6_choice_39 : unsigned(14 downto 0);
  signal rung6_choice_40 : unsigned(14 downto 0);
  signal rung6_choice_41 : unsigned(14 downto 0);
  signal rung6_choice_42 : unsigned(14 downto 0);
  signal rung6_choice_43 : unsigned(14 downto 0);
  signal rung6_choice_44 : unsigned(14 downto 0);
  signal rung6_choice_45 : unsigned(14 downto 0);
  signal rung6_choice_46 : unsigned(14 downto 0);
  signal rung6_choice_47 : unsigned(14 downto 0);
  signal rung6_choice_48 : unsigned(14 downto 0);
  signal rung6_choice_49 : unsigned(14 downto 0);
  signal rung6_choice_50 : unsigned(14 downto 0);
  signal rung6_choice_51 : unsigned(14 downto 0);
  signal rung6_choice_52 : unsigned(14 downto 0);
  signal rung6_choice_53 : unsigned(14 downto 0);
  signal rung6_choice_54 : unsigned(14 downto 0);
  signal rung6_choice_55 : unsigned(14 downto 0);
  signal rung6_choice_56 : unsigned(14 downto 0);
  signal rung6_choice_57 : unsigned(14 downto 0);
  signal rung6_choice_58 : unsigned(14 downto 0);
  signal rung6_choice_59 : unsigned(14 downto 0);
  signal rung6_difference : unsigned(15 downto 0);
  signal rung6_sum : unsigned(15 downto 0);
  signal sum_60_next : unsigned(15 downto 0);
  signal rung7_equal : std_logic;
  signal minutes_0_next : unsigned(14 downto 0);
  signal rung7_equal_2 : std_logic;
  signal minutes_1_next : unsigned(14 downto 0);
  signal rung7_equal_3 : std_logic;
  signal minutes_2_next : unsigned(14 downto 0);
  signal rung7_equal_4 : std_logic;
  signal minutes_3_next : unsigned(14 downto 0);
  signal rung7_equal_5 : std_logic;
  signal minutes_4_next : unsigned(14 downto 0);
  signal rung7_equal_6 : std_logic;
  signal minutes_5_next : unsigned(14 downto 0);
  signal rung7_equal_7 : std_logic;
  signal minutes_6_next : unsigned(14 downto 0);
  signal rung7_equal_8 : std_logic;
  signal minutes_7_next : unsigned(14 downto 0);
  signal rung7_equal_9 : std_logic;
  signal minutes_8_next : unsigned(14 downto 0);
  signal rung7_equal_10 : std_logic;
  signal minutes_9_next : unsigned(14 downto 0);
  signal rung7_equal_11 : std_logic;
  signal minutes_10_next : unsigned(14 downto 0);
  signal rung7_equal_12 : std_logic;
  signal minutes_11_next : unsigned(14 downto 0);
  signal rung7_equal_13 : std_logic;
  signal minutes_12_next : unsigned(14 downto 0);
  signal rung7_equal_14 : std_logic;
  signal minutes_13_next : unsigned(14 downto 0);
  signal rung7_equal_15 : std_logic;
  signal minutes_14_next : unsigned(14 downto 0);
  signal rung7_equal_16 : std_logic;
  signal minutes_15_next : unsigned(14 downto 0);
  signal rung7_equal_17 : std_logic;
  signal minutes_16_next : unsigned(14 downto 0);
  signal rung7_equal_18 : std_logic;
  signal minutes_17_next : unsigned(14 downto 0);
  signal rung7_equal_19 : std_logic;
  signal minutes_18_next : unsigned(14 downto 0);
  signal rung7_equal_20 : std_logic;
  signal minutes_19_next : unsigned(14 downto 0);
  signal rung7_equal_21 : std_logic;
  signal minutes_20_next : unsigned(14 downto 0);
  signal rung7_equal_22 : std_logic;
  signal minutes_21_next : unsigned(14 downto 0);
  signal rung7_equal_23 : std_logic;
  signal minutes_22_next : unsigned(14 downto 0);
  signal rung7_equal_24 : std_logic;
  signal minutes_23_next : unsigned(14 downto 0);
  signal rung7_equal_25 : std_logic;
  signal minutes_24_next : unsigned(14 downto 0);
  signal rung7_equal_26 : std_logic;
  signal minutes_25_next : unsigned(14 downto 0);
  signal rung7_equal_27 : std_logic;
  signal minutes_26_next : unsigned(14 downto 0);
  signal rung7_equal_28 : std_logic;
  signal minutes_27_next : unsigned(14 downto 0);
  signal rung7_equal_29 : std_logic;
  signal minutes_28_next : unsigned(14 downto 0);
  signal rung7_equal_30 : std_logic;
  signal minutes_29_next : unsigned(14 downto 0);
  signal rung7_equal_31 : std_logic;
  signal minutes_30_next : unsigned(14 downto 0);
  signal rung7_equal_32 : std_logic;
  signal minutes_31_next : unsigned(14 downto 0);
  signal rung7_equal_33 : std_logic;
  signal minutes_32_next : unsigned(14 downto 0);
  signal rung7_equal_34 : std_logic;
  signal minutes_33_next : unsigned(14 downto 0);
  signal rung7_equal_35 : std_logic;
  signal minutes_34_next : unsigned(14 downto 0);
  signal rung7_equal_36 : std_logic;
  signal minutes_35_next : unsigned(14 downto 0);
  signal rung7_equal_37 : std_logic;
  signal minutes_36_next : unsigned(14 downto 0);
  signal rung7_equal_38 : std_logic;
  signal minutes_37_next : unsigned(14 downto 0);
  signal rung7_equal_39 : std_logic;
  signal minutes_38_next : unsigned(14 downto 0);
  signal rung7_equal_40 : std_logic;
  signal minutes_39_next : unsigned(14 downto 0);
  signal rung7_equal_41 : std_logic;
  signal minutes_40_next : unsigned(14 downto 0);
  signal rung7_equal_42 : std_logic;
  signal minutes_41_next : unsigned(14 downto 0);
  signal rung7_equal_43 : std_logic;
  signal minutes_42_next : unsigned(14 downto 0);
  signal rung7_equal_44 : std_logic;
  signal minutes_43_next : unsigned(14 downto 0);
  signal rung7_equal_45 : std_logic;
  signal minutes_44_next : unsigned(14 downto 0);
  signal rung7_equal_46 : std_logic;
  signal minutes_45_next : unsigned(14 downto 0);
  signal rung7_equal_47 : std_logic;
  signal minutes_46_next : unsigned(14 downto 0);
  signal rung7_equal_48 : std_logic;
  signal minutes_47_next : unsigned(14 downto 0);
  signal rung7_equal_49 : std_logic;
  signal minutes_48_next : unsigned(14 downto 0);
  signal rung7_equal_50 : std_logic;
  signal minutes_49_next : unsigned(14 downto 0);
  signal rung7_equal_51 : std_logic;
  signal minutes_50_next : unsigned(14 downto 0);
  signal rung7_equal_52 : std_logic;
  signal minutes_51_next : unsigned(14 downto 0);
  signal rung7_equal_53 : std_logic;
  signal minutes_52_next : unsigned(14 downto 0);
  signal rung7_equal_54 : std_logic;
  signal minutes_53_next : unsigned(14 downto 0);
  signal rung7_equal_55 : std_logic;
  signal minutes_54_next : unsigned(14 downto 0);
  signal rung7_equal_56 : std_logic;
  signal minutes_55_next : unsigned(14 downto 0);
  signal rung7_equal_57 : std_logic;
  signal minutes_56_next : unsigned(14 downto 0);
  signal rung7_equal_58 : std_logic;
  signal minutes_57_next : unsigned(14 downto 0);
  signal rung7_equal_59 : std_logic;
  signal minutes_58_next : unsigned(14 downto 0);
  signal rung7_equal_60 : std_logic;
  signal minutes_59_next : unsigned(14 downto 0);
  signal rung7_sum : unsigned(5 downto 0);
  signal newest_rung7 : unsigned(5 downto 0);
  signal newest_next : unsigned(5 downto 0);
  signal rung9_sum : unsigned(3 downto 0);
  signal rung9_equal : std_logic;
  signal rung9_choice : unsigned(3 downto 0);
  signal known_10_next : unsigned(3 downto 0);
  signal rung9_extended : unsigned(15 downto 0);
  signal rung9_sum_2 : unsigned(15 downto 0);
  signal rung9_quotient : unsigned(15 downto 0);
  signal average_10_next : unsigned(15 downto 0);
  signal rung10_sum : unsigned(5 downto 0);
  signal rung10_equal : std_logic;
  signal rung10_choice : unsigned(5 downto 0);
  signal known_60_next : unsigned(5 downto 0);
  signal rung10_extended : unsigned(15 downto 0);
  signal rung10_sum_2 : unsigned(15 downto 0);
  signal rung10_quotient : unsigned(15 downto 0);
  signal average_60_next : unsigned(15 downto 0);
begin

  -- rung 1 "parts of the minute that runs", parts_average.ladder:22

  -- rung 2 "a minute is over", parts_average.ladder:25
  count: entity work.parts_average_CTU
    port map (
      clk => clk,
      rst => rst,
      power => sensor,
      clear_after => minute_Q,
      CV => count_CV
    );
  minute: entity work.parts_average_TON_power1_PT60
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      clear_after => minute_Q,
      Q => minute_Q
    );
  last_minute_value <= resize(last_minute_reg, 16);
  last_minute_next <= count_CV when minute_Q = '1' else last_minute_reg;
  rung2_extended <= resize(last_minute_next, 16);

  -- rung 3 "the oldest minute leaves its sum, the last one comes in", parts_average.ladder:28
  rung3_difference <= resize(newest, 7) - 10;
  tenth_rung3 <= unsigned(resize(signed(rung3_difference), 16)) when minute_Q = '1' else tenth;

  -- rung 4, parts_average.ladder:30
  rung4_less <= '1' when signed(tenth_rung3) < 0 else '0';
  rung4_sum <= tenth_rung3 + 60;
  tenth_next <= rung4_sum when rung4_less = '1' else tenth_rung3;

  -- rung 5, parts_average.ladder:31
  rung5_choice <= minutes_1 when tenth_next(0) = '1' else minutes_0;
  rung5_choice_2 <= minutes_3 when tenth_next(0) = '1' else minutes_2;
  rung5_choice_3 <= minutes_5 when tenth_next(0) = '1' else minutes_4;
  rung5_choice_4 <= minutes_7 when tenth_next(0) = '1' else minutes_6;
  rung5_choice_5 <= minutes_9 when tenth_next(0) = '1' else minutes_8;
  rung5_choice_6 <= minutes_11 when tenth_next(0) = '1' else minutes_10;
  rung5_choice_7 <= minutes_13 when tenth_next(0) = '1' else minutes_12;
  rung5_choice_8 <= minutes_15 when tenth_next(0) = '1' else minutes_14;
  rung5_choice_9 <= minutes_17 when tenth_next(0) = '1' else minutes_16;
  rung5_choice_10 <= minutes_19 when tenth_next(0) = '1' else minutes_18;
  rung5_choice_11 <= minutes_21 when tenth_next(0) = '1' else minutes_20;
  rung5_choice_12 <= minutes_23 when tenth_next(0) = '1' else minutes_22;
  rung5_choice_13 <= minutes_25 when tenth_next(0) = '1' else minutes_24;
  rung5_choice_14 <= minutes_27 when tenth_next(0) = '1' else minutes_26;
  rung5_choice_15 <= minutes_29 when tenth_next(0) = '1' else minutes_28;
  rung5_choice_16 <= minutes_31 when tenth_next(0) = '1' else minutes_30;
  rung5_choice_17 <= minutes_33 when tenth_next(0) = '1' else minutes_32;
  rung5_choice_18 <= minutes_35 when tenth_next(0) = '1' else minutes_34;
  rung5_choice_19 <= minutes_37 when tenth_next(0) = '1' else minutes_36;
  rung5_choice_20 <= minutes_39 when tenth_next(0) = '1' else minutes_38;
  rung5_choice_21 <= minutes_41 when tenth_next(0) = '1' else minutes_40;
  rung5_choice_22 <= minutes_43 when tenth_next(0) = '1' else minutes_42;
  rung5_choice_23 <= minutes_45 when tenth_next(0) = '1' else minutes_44;
  rung5_choice_24 <= minutes_47 when tenth_next(0) = '1' else minutes_46;
  rung5_choice_25 <= minutes_49 when tenth_next(0) = '1' else minutes_48;
  rung5_choice_26 <= minutes_51 when tenth_next(0) = '1' else minutes_50;
  rung5_choice_27 <= minutes_53 when tenth_next(0) = '1' else minutes_52;
  rung5_choice_28 <= minutes_55 when tenth_next(0) = '1' else minutes_54;
  rung5_choice_29 <= minutes_57 when tenth_next(0) = '1' else minutes_56;
  rung5_choice_30 <= minutes_59 when tenth_next(0) = '1' else minutes_58;
  rung5_choice_31 <= rung5_choice_2 when tenth_next(1) = '1' else rung5_choice;
  rung5_choice_32 <= rung5_choice_4 when tenth_next(1) = '1' else rung5_choice_3;
  rung5_choice_33 <= rung5_choice_6 when tenth_next(1) = '1' else rung5_choice_5;
  rung5_choice_34 <= rung5_choice_8 when tenth_next(1) = '1' else rung5_choice_7;
  rung5_choice_35 <= rung5_choice_10 when tenth_next(1) = '1' else rung5_choice_9;
  rung5_choice_36 <= rung5_choice_12 when tenth_next(1) = '1' else rung5_choice_11;
  rung5_choice_37 <= rung5_choice_14 when tenth_next(1) = '1' else rung5_choice_13;
  rung5_choice_38 <= rung5_choice_16 when tenth_next(1) = '1' else rung5_choice_15;
  rung5_choice_39 <= rung5_choice_18 when tenth_next(1) = '1' else rung5_choice_17;
  rung5_choice_40 <= rung5_choice_20 when tenth_next(1) = '1' else rung5_choice_19;
  rung5_choice_41 <= rung5_choice_22 when tenth_next(1) = '1' else rung5_choice_21;
  rung5_choice_42 <= rung5_choice_24 when tenth_next(1) = '1' else rung5_choice_23;
  rung5_choice_43 <= rung5_choice_26 when tenth_next(1) = '1' else rung5_choice_25;
  rung5_choice_44 <= rung5_choice_28 when tenth_next(1) = '1' else rung5_choice_27;
  rung5_choice_45 <= rung5_choice_30 when tenth_next(1) = '1' else rung5_choice_29;
  rung5_choice_46 <= rung5_choice_32 when tenth_next(2) = '1' else rung5_choice_31;
  rung5_choice_47 <= rung5_choice_34 when tenth_next(2) = '1' else rung5_choice_33;
  rung5_choice_48 <= rung5_choice_36 when tenth_next(2) = '1' else rung5_choice_35;
  rung5_choice_49 <= rung5_choice_38 when tenth_next(2) = '1' else rung5_choice_37;
  rung5_choice_50 <= rung5_choice_40 when tenth_next(2) = '1' else rung5_choice_39;
  rung5_choice_51 <= rung5_choice_42 when tenth_next(2) = '1' else rung5_choice_41;
  rung5_choice_52 <= rung5_choice_44 when tenth_next(2) = '1' else rung5_choice_43;
  rung5_choice_53 <= rung5_choice_47 when tenth_next(3) = '1' else rung5_choice_46;
  rung5_choice_54 <= rung5_choice_49 when tenth_next(3) = '1' else rung5_choice_48;
  rung5_choice_55 <= rung5_choice_51 when tenth_next(3) = '1' else rung5_choice_50;
  rung5_choice_56 <= rung5_choice_45 when tenth_next(3) = '1' else rung5_choice_52;
  rung5_choice_57 <= rung5_choice_54 when tenth_next(4) = '1' else rung5_choice_53;
  rung5_choice_58 <= rung5_choice_56 when tenth_next(4) = '1' else rung5_choice_55;
  rung5_choice_59 <= rung5_choice_58 when tenth_next(5) = '1' else rung5_choice_57;
  rung5_less <= '1' when tenth_next < 60 else '0';
  rung5_choice_60 <= rung5_choice_59 when rung5_less = '1' else to_unsigned(0, 15);
  rung5_difference <= sum_10 - resize(rung5_choice_60, 16);
  rung5_sum <= rung5_difference + rung2_extended;
  sum_10_next <= rung5_sum when minute_Q = '1' else sum_10;

  -- rung 6, parts_average.ladder:32
  rung6_choice <= minutes_1 when newest(0) = '1' else minutes_0;
  rung6_choice_2 <= minutes_3 when newest(0) = '1' else minutes_2;
  rung6_choice_3 <= minutes_5 when newest(0) = '1' else minutes_4;
  rung6_choice_4 <= minutes_7 when newest(0) = '1' else minutes_6;
  rung6_choice_5 <= minutes_9 when newest(0) = '1' else minutes_8;
  rung6_choice_6 <= minutes_11 when newest(0) = '1' else minutes_10;
  rung6_choice_7 <= minutes_13 when newest(0) = '1' else minutes_12;
  rung6_choice_8 <= minutes_15 when newest(0) = '1' else minutes_14;
  rung6_choice_9 <= minutes_17 when newest(0) = '1' else minutes_16;
  rung6_choice_10 <= minutes_19 when newest(0) = '1' else minutes_18;
  rung6_choice_11 <= minutes_21 when newest(0) = '1' else minutes_20;
  rung6_choice_12 <= minutes_23 when newest(0) = '1' else minutes_22;
  rung6_choice_13 <= minutes_25 when newest(0) = '1' else minutes_24;
  rung6_choice_14 <= minutes_27 when newest(0) = '1' else minutes_26;
  rung6_choice_15 <= minutes_29 when newest(0) = '1' else minutes_28;
  rung6_choice_16 <= minutes_31 when newest(0) = '1' else minutes_30;
  rung6_choice_17 <= minutes_33 when newest(0) = '1' else minutes_32;
  rung6_choice_18 <= minutes_35 when newest(0) = '1' else minutes_34;
  rung6_choice_19 <= minutes_37 when newest(0) = '1' else minutes_36;
  rung6_choice_20 <= minutes_39 when newest(0) = '1' else minutes_38;
  rung6_choice_21 <= minutes_41 when newest(0) = '1' else minutes_40;
  rung6_choice_22 <= minutes_43 when newest(0) = '1' else minutes_42;
  rung6_choice_23 <= minutes_45 when newest(0) = '1' else minutes_44;
  rung6_choice_24 <= minutes_47 when newest(0) = '1' else minutes_46;
  rung6_choice_25 <= minutes_49 when newest(0) = '1' else minutes_48;
  rung6_choice_26 <= minutes_51 when newest(0) = '1' else minutes_50;
  rung6_choice_27 <= minutes_53 when newest(0) = '1' else minutes_52;
  rung6_choice_28 <= minutes_55 when newest(0) = '1' else minutes_54;
  rung6_choice_29 <= minutes_57 when newest(0) = '1' else minutes_56;
  rung6_choice_30 <= minutes_59 when newest(0) = '1' else minutes_58;
  rung6_choice_31 <= rung6_choice_2 when newest(1) = '1' else rung6_choice;
  rung6_choice_32 <= rung6_choice_4 when newest(1) = '1' else rung6_choice_3;
  rung6_choice_33 <= rung6_choice_6 when newest(1) = '1' else rung6_choice_5;
  rung6_choice_34 <= rung6_choice_8 when newest(1) = '1' else rung6_choice_7;
  rung6_choice_35 <= rung6_choice_10 when newest(1) = '1' else rung6_choice_9;
  rung6_choice_36 <= rung6_choice_12 when newest(1) = '1' else rung6_choice_11;
  rung6_choice_37 <= rung6_choice_14 when newest(1) = '1' else rung6_choice_13;
  rung6_choice_38 <= rung6_choice_16 when newest(1) = '1' else rung6_choice_15;
  rung6_choice_39 <= rung6_choice_18 when newest(1) = '1' else rung6_choice_17;
  rung6_choice_40 <= rung6_choice_20 when newest(1) = '1' else rung6_choice_19;
  rung6_choice_41 <= rung6_choice_22 when newest(1) = '1' else rung6_choice_21;
  rung6_choice_42 <= rung6_choice_24 when newest(1) = '1' else rung6_choice_23;
  rung6_choice_43 <= rung6_choice_26 when newest(1) = '1' else rung6_choice_25;
  rung6_choice_44 <= rung6_choice_28 when newest(1) = '1' else rung6_choice_27;
  rung6_choice_45 <= rung6_choice_30 when newest(1) = '1' else rung6_choice_29;
  rung6_choice_46 <= rung6_choice_32 when newest(2) = '1' else rung6_choice_31;
  rung6_choice_47 <= rung6_choice_34 when newest(2) = '1' else rung6_choice_33;
  rung6_choice_48 <= rung6_choice_36 when newest(2) = '1' else rung6_choice_35;
  rung6_choice_49 <= rung6_choice_38 when newest(2) = '1' else rung6_choice_37;
  rung6_choice_50 <= rung6_choice_40 when newest(2) = '1' else rung6_choice_39;
  rung6_choice_51 <= rung6_choice_42 when newest(2) = '1' else rung6_choice_41;
  rung6_choice_52 <= rung6_choice_44 when newest(2) = '1' else rung6_choice_43;
  rung6_choice_53 <= rung6_choice_47 when newest(3) = '1' else rung6_choice_46;
  rung6_choice_54 <= rung6_choice_49 when newest(3) = '1' else rung6_choice_48;
  rung6_choice_55 <= rung6_choice_51 when newest(3) = '1' else rung6_choice_50;
  rung6_choice_56 <= rung6_choice_45 when newest(3) = '1' else rung6_choice_52;
  rung6_choice_57 <= rung6_choice_54 when newest(4) = '1' else rung6_choice_53;
  rung6_choice_58 <= rung6_choice_56 when newest(4) = '1' else rung6_choice_55;
  rung6_choice_59 <= rung6_choice_58 when newest(5) = '1' else rung6_choice_57;
  rung6_difference <= sum_60 - resize(rung6_choice_59, 16);
  rung6_sum <= rung6_difference + rung2_extended;
  sum_60_next <= rung6_sum when minute_Q = '1' else sum_60;

  -- rung 7 "it is kept for an hour", parts_average.ladder:34
  rung7_equal <= '1' when newest = 0 else '0';
  minutes_0_next <= last_minute_next when (minute_Q and rung7_equal) = '1' else minutes_0;
  rung7_equal_2 <= '1' when newest = 1 else '0';
  minutes_1_next <= last_minute_next when (minute_Q and rung7_equal_2) = '1' else minutes_1;
  rung7_equal_3 <= '1' when newest = 2 else '0';
  minutes_2_next <= last_minute_next when (minute_Q and rung7_equal_3) = '1' else minutes_2;
  rung7_equal_4 <= '1' when newest = 3 else '0';
  minutes_3_next <= last_minute_next when (minute_Q and rung7_equal_4) = '1' else minutes_3;
  rung7_equal_5 <= '1' when newest = 4 else '0';
  minutes_4_next <= last_minute_next when (minute_Q and rung7_equal_5) = '1' else minutes_4;
  rung7_equal_6 <= '1' when newest = 5 else '0';
  minutes_5_next <= last_minute_next when (minute_Q and rung7_equal_6) = '1' else minutes_5;
  rung7_equal_7 <= '1' when newest = 6 else '0';
  minutes_6_next <= last_minute_next when (minute_Q and rung7_equal_7) = '1' else minutes_6;
  rung7_equal_8 <= '1' when newest = 7 else '0';
  minutes_7_next <= last_minute_next when (minute_Q and rung7_equal_8) = '1' else minutes_7;
  rung7_equal_9 <= '1' when newest = 8 else '0';
  minutes_8_next <= last_minute_next when (minute_Q and rung7_equal_9) = '1' else minutes_8;
  rung7_equal_10 <= '1' when newest = 9 else '0';
  minutes_9_next <= last_minute_next when (minute_Q and rung7_equal_10) = '1' else minutes_9;
  rung7_equal_11 <= '1' when newest = 10 else '0';
  minutes_10_next <= last_minute_next when (minute_Q and rung7_equal_11) = '1' else minutes_10;
  rung7_equal_12 <= '1' when newest = 11 else '0';
  minutes_11_next <= last_minute_next when (minute_Q and rung7_equal_12) = '1' else minutes_11;
  rung7_equal_13 <= '1' when newest = 12 else '0';
  minutes_12_next <= last_minute_next when (minute_Q and rung7_equal_13) = '1' else minutes_12;
  rung7_equal_14 <= '1' when newest = 13 else '0';
  minutes_13_next <= last_minute_next when (minute_Q and rung7_equal_14) = '1' else minutes_13;
  rung7_equal_15 <= '1' when newest = 14 else '0';
  minutes_14_next <= last_minute_next when (minute_Q and rung7_equal_15) = '1' else minutes_14;
  rung7_equal_16 <= '1' when newest = 15 else '0';
  minutes_15_next <= last_minute_next when (minute_Q and rung7_equal_16) = '1' else minutes_15;
  rung7_equal_17 <= '1' when newest = 16 else '0';
  minutes_16_next <= last_minute_next when (minute_Q and rung7_equal_17) = '1' else minutes_16;
  rung7_equal_18 <= '1' when newest = 17 else '0';
  minutes_17_next <= last_minute_next when (minute_Q and rung7_equal_18) = '1' else minutes_17;
  rung7_equal_19 <= '1' when newest = 18 else '0';
  minutes_18_next <= last_minute_next when (minute_Q and rung7_equal_19) = '1' else minutes_18;
  rung7_equal_20 <= '1' when newest = 19 else '0';
  minutes_19_next <= last_minute_next when (minute_Q and rung7_equal_20) = '1' else minutes_19;
  rung7_equal_21 <= '1' when newest = 20 else '0';
  minutes_20_next <= last_minute_next when (minute_Q and rung7_equal_21) = '1' else minutes_20;
  rung7_equal_22 <= '1' when newest = 21 else '0';
  minutes_21_next <= last_minute_next when (minute_Q and rung7_equal_22) = '1' else minutes_21;
  rung7_equal_23 <= '1' when newest = 22 else '0';
  minutes_22_next <= last_minute_next when (minute_Q and rung7_equal_23) = '1' else minutes_22;
  rung7_equal_24 <= '1' when newest = 23 else '0';
  minutes_23_next <= last_minute_next when (minute_Q and rung7_equal_24) = '1' else minutes_23;
  rung7_equal_25 <= '1' when newest = 24 else '0';
  minutes_24_next <= last_minute_next when (minute_Q and rung7_equal_25) = '1' else minutes_24;
  rung7_equal_26 <= '1' when newest = 25 else '0';
  minutes_25_next <= last_minute_next when (minute_Q and rung7_equal_26) = '1' else minutes_25;
  rung7_equal_27 <= '1' when newest = 26 else '0';
  minutes_26_next <= last_minute_next when (minute_Q and rung7_equal_27) = '1' else minutes_26;
  rung7_equal_28 <= '1' when newest = 27 else '0';
  minutes_27_next <= last_minute_next when (minute_Q and rung7_equal_28) = '1' else minutes_27;
  rung7_equal_29 <= '1' when newest = 28 else '0';
  minutes_28_next <= last_minute_next when (minute_Q and rung7_equal_29) = '1' else minutes_28;
  rung7_equal_30 <= '1' when newest = 29 else '0';
  minutes_29_next <= last_minute_next when (minute_Q and rung7_equal_30) = '1' else minutes_29;
  rung7_equal_31 <= '1' when newest = 30 else '0';
  minutes_30_next <= last_minute_next when (minute_Q and rung7_equal_31) = '1' else minutes_30;
  rung7_equal_32 <= '1' when newest = 31 else '0';
  minutes_31_next <= last_minute_next when (minute_Q and rung7_equal_32) = '1' else minutes_31;
  rung7_equal_33 <= '1' when newest = 32 else '0';
  minutes_32_next <= last_minute_next when (minute_Q and rung7_equal_33) = '1' else minutes_32;
  rung7_equal_34 <= '1' when newest = 33 else '0';
  minutes_33_next <= last_minute_next when (minute_Q and rung7_equal_34) = '1' else minutes_33;
  rung7_equal_35 <= '1' when newest = 34 else '0';
  minutes_34_next <= last_minute_next when (minute_Q and rung7_equal_35) = '1' else minutes_34;
  rung7_equal_36 <= '1' when newest = 35 else '0';
  minutes_35_next <= last_minute_next when (minute_Q and rung7_equal_36) = '1' else minutes_35;
  rung7_equal_37 <= '1' when newest = 36 else '0';
  minutes_36_next <= last_minute_next when (minute_Q and rung7_equal_37) = '1' else minutes_36;
  rung7_equal_38 <= '1' when newest = 37 else '0';
  minutes_37_next <= last_minute_next when (minute_Q and rung7_equal_38) = '1' else minutes_37;
  rung7_equal_39 <= '1' when newest = 38 else '0';
  minutes_38_next <= last_minute_next when (minute_Q and rung7_equal_39) = '1' else minutes_38;
  rung7_equal_40 <= '1' when newest = 39 else '0';
  minutes_39_next <= last_minute_next when (minute_Q and rung7_equal_40) = '1' else minutes_39;
  rung7_equal_41 <= '1' when newest = 40 else '0';
  minutes_40_next <= last_minute_next when (minute_Q and rung7_equal_41) = '1' else minutes_40;
  rung7_equal_42 <= '1' when newest = 41 else '0';
  minutes_41_next <= last_minute_next when (minute_Q and rung7_equal_42) = '1' else minutes_41;
  rung7_equal_43 <= '1' when newest = 42 else '0';
  minutes_42_next <= last_minute_next when (minute_Q and rung7_equal_43) = '1' else minutes_42;
  rung7_equal_44 <= '1' when newest = 43 else '0';
  minutes_43_next <= last_minute_next when (minute_Q and rung7_equal_44) = '1' else minutes_43;
  rung7_equal_45 <= '1' when newest = 44 else '0';
  minutes_44_next <= last_minute_next when (minute_Q and rung7_equal_45) = '1' else minutes_44;
  rung7_equal_46 <= '1' when newest = 45 else '0';
  minutes_45_next <= last_minute_next when (minute_Q and rung7_equal_46) = '1' else minutes_45;
  rung7_equal_47 <= '1' when newest = 46 else '0';
  minutes_46_next <= last_minute_next when (minute_Q and rung7_equal_47) = '1' else minutes_46;
  rung7_equal_48 <= '1' when newest = 47 else '0';
  minutes_47_next <= last_minute_next when (minute_Q and rung7_equal_48) = '1' else minutes_47;
  rung7_equal_49 <= '1' when newest = 48 else '0';
  minutes_48_next <= last_minute_next when (minute_Q and rung7_equal_49) = '1' else minutes_48;
  rung7_equal_50 <= '1' when newest = 49 else '0';
  minutes_49_next <= last_minute_next when (minute_Q and rung7_equal_50) = '1' else minutes_49;
  rung7_equal_51 <= '1' when newest = 50 else '0';
  minutes_50_next <= last_minute_next when (minute_Q and rung7_equal_51) = '1' else minutes_50;
  rung7_equal_52 <= '1' when newest = 51 else '0';
  minutes_51_next <= last_minute_next when (minute_Q and rung7_equal_52) = '1' else minutes_51;
  rung7_equal_53 <= '1' when newest = 52 else '0';
  minutes_52_next <= last_minute_next when (minute_Q and rung7_equal_53) = '1' else minutes_52;
  rung7_equal_54 <= '1' when newest = 53 else '0';
  minutes_53_next <= last_minute_next when (minute_Q and rung7_equal_54) = '1' else minutes_53;
  rung7_equal_55 <= '1' when newest = 54 else '0';
  minutes_54_next <= last_minute_next when (minute_Q and rung7_equal_55) = '1' else minutes_54;
  rung7_equal_56 <= '1' when newest = 55 else '0';
  minutes_55_next <= last_minute_next when (minute_Q and rung7_equal_56) = '1' else minutes_55;
  rung7_equal_57 <= '1' when newest = 56 else '0';
  minutes_56_next <= last_minute_next when (minute_Q and rung7_equal_57) = '1' else minutes_56;
  rung7_equal_58 <= '1' when newest = 57 else '0';
  minutes_57_next <= last_minute_next when (minute_Q and rung7_equal_58) = '1' else minutes_57;
  rung7_equal_59 <= '1' when newest = 58 else '0';
  minutes_58_next <= last_minute_next when (minute_Q and rung7_equal_59) = '1' else minutes_58;
  rung7_equal_60 <= '1' when newest = 59 else '0';
  minutes_59_next <= last_minute_next when (minute_Q and rung7_equal_60) = '1' else minutes_59;
  rung7_sum <= newest + 1;
  newest_rung7 <= rung7_sum when minute_Q = '1' else newest;

  -- rung 8, parts_average.ladder:36
  newest_next <= to_unsigned(0, 6) when (minute_Q and rung7_equal_60) = '1' else newest_rung7;

  -- rung 9 "averages of the minutes that there are", parts_average.ladder:39
  rung9_sum <= known_10 + 1;
  rung9_equal <= '1' when known_10 = 10 else '0';
  rung9_choice <= to_unsigned(10, 4) when rung9_equal = '1' else rung9_sum;
  known_10_next <= rung9_choice when minute_Q = '1' else known_10;
  rung9_extended <= resize(known_10_next, 16);
  rung9_sum_2 <= sum_10_next + resize(rung9_extended(15 downto 1), 16);
  rung9_quotient <= to_unsigned(0, 16) when rung9_extended = 0 else rung9_sum_2 / rung9_extended;
  average_10_next <= rung9_quotient when minute_Q = '1' else average_10_reg;

  -- rung 10, parts_average.ladder:42
  rung10_sum <= known_60 + 1;
  rung10_equal <= '1' when known_60 = 60 else '0';
  rung10_choice <= to_unsigned(60, 6) when rung10_equal = '1' else rung10_sum;
  known_60_next <= rung10_choice when minute_Q = '1' else known_60;
  rung10_extended <= resize(known_60_next, 16);
  rung10_sum_2 <= sum_60_next + resize(rung10_extended(15 downto 1), 16);
  rung10_quotient <=
      to_unsigned(0, 16) when rung10_extended = 0 else rung10_sum_2 / rung10_extended;
  average_60_next <= rung10_quotient when minute_Q = '1' else average_60_reg;

  last_minute <= std_logic_vector(last_minute_value);
  average_10 <= std_logic_vector(average_10_reg);
  average_60 <= std_logic_vector(average_60_reg);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        last_minute_reg <= (others => '0');
        newest <= (others => '0');
        tenth <= (others => '0');
        sum_10 <= (others => '0');
        minutes_0 <= (others => '0');
        minutes_1 <= (others => '0');
        minutes_2 <= (others => '0');
        minutes_3 <= (others => '0');
        minutes_4 <= (others => '0');
        minutes_5 <= (others => '0');
        minutes_6 <= (others => '0');
        minutes_7 <= (others => '0');
        minutes_8 <= (others => '0');
        minutes_9 <= (others => '0');
        minutes_10 <= (others => '0');
        minutes_11 <= (others => '0');
        minutes_12 <= (others => '0');
        minutes_13 <= (others => '0');
        minutes_14 <= (others => '0');
        minutes_15 <= (others => '0');
        minutes_16 <= (others => '0');
        minutes_17 <= (others => '0');
        minutes_18 <= (others => '0');
        minutes_19 <= (others => '0');
        minutes_20 <= (others => '0');
        minutes_21 <= (others => '0');
        minutes_22 <= (others => '0');
        minutes_23 <= (others => '0');
        minutes_24 <= (others => '0');
        minutes_25 <= (others => '0');
        minutes_26 <= (others => '0');
        minutes_27 <= (others => '0');
        minutes_28 <= (others => '0');
        minutes_29 <= (others => '0');
        minutes_30 <= (others => '0');
        minutes_31 <= (others => '0');
        minutes_32 <= (others => '0');
        minutes_33 <= (others => '0');
        minutes_34 <= (others => '0');
        minutes_35 <= (others => '0');
        minutes_36 <= (others => '0');
        minutes_37 <= (others => '0');
        minutes_38 <= (others => '0');
        minutes_39 <= (others => '0');
        minutes_40 <= (others => '0');
        minutes_41 <= (others => '0');
        minutes_42 <= (others => '0');
        minutes_43 <= (others => '0');
        minutes_44 <= (others => '0');
        minutes_45 <= (others => '0');
        minutes_46 <= (others => '0');
        minutes_47 <= (others => '0');
        minutes_48 <= (others => '0');
        minutes_49 <= (others => '0');
        minutes_50 <= (others => '0');
        minutes_51 <= (others => '0');
        minutes_52 <= (others => '0');
        minutes_53 <= (others => '0');
        minutes_54 <= (others => '0');
        minutes_55 <= (others => '0');
        minutes_56 <= (others => '0');
        minutes_57 <= (others => '0');
        minutes_58 <= (others => '0');
        minutes_59 <= (others => '0');
        sum_60 <= (others => '0');
        known_10 <= (others => '0');
        average_10_reg <= (others => '0');
        known_60 <= (others => '0');
        average_60_reg <= (others => '0');
      else
        last_minute_reg <= last_minute_next;
        newest <= newest_next;
        tenth <= tenth_next;
        sum_10 <= sum_10_next;
        minutes_0 <= minutes_0_next;
        minutes_1 <= minutes_1_next;
        minutes_2 <= minutes_2_next;
        minutes_3 <= minutes_3_next;
        minutes_4 <= minutes_4_next;
        minutes_5 <= minutes_5_next;
        minutes_6 <= minutes_6_next;
        minutes_7 <= minutes_7_next;
        minutes_8 <= minutes_8_next;
        minutes_9 <= minutes_9_next;
        minutes_10 <= minutes_10_next;
        minutes_11 <= minutes_11_next;
        minutes_12 <= minutes_12_next;
        minutes_13 <= minutes_13_next;
        minutes_14 <= minutes_14_next;
        minutes_15 <= minutes_15_next;
        minutes_16 <= minutes_16_next;
        minutes_17 <= minutes_17_next;
        minutes_18 <= minutes_18_next;
        minutes_19 <= minutes_19_next;
        minutes_20 <= minutes_20_next;
        minutes_21 <= minutes_21_next;
        minutes_22 <= minutes_22_next;
        minutes_23 <= minutes_23_next;
        minutes_24 <= minutes_24_next;
        minutes_25 <= minutes_25_next;
        minutes_26 <= minutes_26_next;
        minutes_27 <= minutes_27_next;
        minutes_28 <= minutes_28_next;
        minutes_29 <= minutes_29_next;
        minutes_30 <= minutes_30_next;
        minutes_31 <= minutes_31_next;
        minutes_32 <= minutes_32_next;
        minutes_33 <= minutes_33_next;
        minutes_34 <= minutes_34_next;
        minutes_35 <= minutes_35_next;
        minutes_36 <= minutes_36_next;
        minutes_37 <= minutes_37_next;
        minutes_38 <= minutes_38_next;
        minutes_39 <= minutes_39_next;
        minutes_40 <= minutes_40_next;
        minutes_41 <= minutes_41_next;
        minutes_42 <= minutes_42_next;
        minutes_43 <= minutes_43_next;
        minutes_44 <= minutes_44_next;
        minutes_45 <= minutes_45_next;
        minutes_46 <= minutes_46_next;
        minutes_47 <= minutes_47_next;
        minutes_48 <= minutes_48_next;
        minutes_49 <= minutes_49_next;
        minutes_50 <= minutes_50_next;
        minutes_51 <= minutes_51_next;
        minutes_52 <= minutes_52_next;
        minutes_53 <= minutes_53_next;
        minutes_54 <= minutes_54_next;
        minutes_55 <= minutes_55_next;
        minutes_56 <= minutes_56_next;
        minutes_57 <= minutes_57_next;
        minutes_58 <= minutes_58_next;
        minutes_59 <= minutes_59_next;
        sum_60 <= sum_60_next;
        known_10 <= known_10_next;
        average_10_reg <= average_10_next;
        known_60 <= known_60_next;
        average_60_reg <= average_60_next;
      end if;
    end if;
  end process;
end architecture rtl;
