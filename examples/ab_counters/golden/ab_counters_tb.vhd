-- Made by hotrail 0.1.0 from ab_counters.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- AB_CTU: up counter of Allen-Bradley
-- Fitted to PRE = 99.
-- Example, with PRE = 2:
-- IN  _#_##_#_##_#
-- (R) ________#___
-- CU  _#_##_#__#_#
-- DN  ___#####___#
-- ACC 011222330112
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_counters_test_AB_CTU_PRE99 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    clear_after : in  std_logic;
    ACC_last    : out unsigned(15 downto 0);
    DN          : out std_logic
  );
end entity ab_counters_test_AB_CTU_PRE99;

architecture rtl of ab_counters_test_AB_CTU_PRE99 is
  signal ACC : unsigned(15 downto 0) := (others => '0');
  signal was_up : std_logic := '1';
  signal sum : unsigned(15 downto 0);
  signal ACC_next : unsigned(15 downto 0);
  signal was_up_next : std_logic;
begin
  sum <= ACC + (to_unsigned(0, 15) & (power and not was_up));
  ACC_next <= to_unsigned(0, 16) when clear_after = '1' else sum;
  was_up_next <= not clear_after and power;

  ACC_last <= ACC;
  DN <= '1' when signed(sum) >= 99 else '0';

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        was_up <= '1';
      else
        ACC <= ACC_next;
        was_up <= was_up_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- AB_CTD: down counter of Allen-Bradley
-- Fitted to PRE = 1.
-- Example, with PRE = 1, ACC = 2:
-- IN    _#_##_#
-- CD    _#_##_#
-- DN    ###____
-- ACC+1 3221110
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_counters_test_AB_CTD_PRE1 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    clear_after : in  std_logic;
    ACC_last    : out unsigned(15 downto 0);
    DN          : out std_logic
  );
end entity ab_counters_test_AB_CTD_PRE1;

architecture rtl of ab_counters_test_AB_CTD_PRE1 is
  signal ACC : unsigned(15 downto 0) := to_unsigned(50, 16);
  signal was_down : std_logic := '1';
  signal difference : unsigned(15 downto 0);
  signal ACC_next : unsigned(15 downto 0);
  signal was_down_next : std_logic;
begin
  difference <= ACC - (to_unsigned(0, 15) & (power and not was_down));
  ACC_next <= to_unsigned(0, 16) when clear_after = '1' else difference;
  was_down_next <= not clear_after and power;

  ACC_last <= ACC;
  DN <= '1' when signed(difference) >= 1 else '0';

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= to_unsigned(50, 16);
        was_down <= '1';
      else
        ACC <= ACC_next;
        was_down <= was_down_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- AB_CTU: up counter of Allen-Bradley
-- Fitted to PRE = 99.
-- Example, with PRE = 2:
-- IN  _#_##_#_##_#
-- (R) ________#___
-- CU  _#_##_#__#_#
-- DN  ___#####___#
-- ACC 011222330112
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_counters_test_AB_CTU_PRE99_2 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    ACC_before  : in  unsigned(15 downto 0);
    clear_after : in  std_logic;
    ACC         : out unsigned(15 downto 0);
    DN_last     : out std_logic;
    OV          : out std_logic;
    OV_last     : out std_logic
  );
end entity ab_counters_test_AB_CTU_PRE99_2;

architecture rtl of ab_counters_test_AB_CTU_PRE99_2 is
  signal DN : std_logic := '0';
  signal OV_reg : std_logic := '0';
  signal UN : std_logic := '0';
  signal was_up : std_logic := '1';
  signal condition : std_logic;
  signal ACC_value : unsigned(15 downto 0);
  signal equal : std_logic;
  signal condition_2 : std_logic;
  signal OV_value : std_logic;
  signal at_least : std_logic;
  signal DN_next : std_logic;
  signal OV_next : std_logic;
  signal UN_next : std_logic;
  signal was_up_next : std_logic;
begin
  condition <= power and not was_up;
  ACC_value <= ACC_before + (to_unsigned(0, 15) & condition);
  equal <= '1' when ACC_before = 32767 else '0';
  condition_2 <= condition and equal;
  OV_value <= OV_reg or (condition_2 and not UN);
  at_least <= '1' when signed(ACC_value) >= 99 else '0';
  DN_next <= '0' when clear_after = '1' else at_least;
  OV_next <= '0' when clear_after = '1' else OV_value;
  UN_next <= '0' when clear_after = '1' else UN and not condition_2;
  was_up_next <= '0' when clear_after = '1' else power;

  ACC <= ACC_value;
  DN_last <= DN;
  OV <= OV_value;
  OV_last <= OV_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        DN <= '0';
        OV_reg <= '0';
        UN <= '0';
        was_up <= '1';
      else
        DN <= DN_next;
        OV_reg <= OV_next;
        UN <= UN_next;
        was_up <= was_up_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- CTU: up counter
-- Fitted to PV = 99.
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- R   _________##____
-- Q   ___######____##
-- CV  011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_counters_test_CTU_PV99 is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    power   : in  std_logic;
    R       : in  std_logic;
    Q       : out std_logic;
    CV_last : out unsigned(14 downto 0)
  );
end entity ab_counters_test_CTU_PV99;

architecture rtl of ab_counters_test_CTU_PV99 is
  signal CV : unsigned(14 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal CV_at_least_99 : std_logic := '0';
  signal unequal : std_logic;
  signal condition : std_logic;
  signal sum : unsigned(14 downto 0);
  signal CV_next : unsigned(14 downto 0);
  signal equal : std_logic;
  signal choice : std_logic;
  signal CV_at_least_99_next : std_logic;
begin
  unequal <= '1' when CV /= 32767 else '0';
  condition <= power and not was and unequal;
  sum <= CV + (to_unsigned(0, 14) & condition);
  CV_next <= to_unsigned(0, 15) when R = '1' else sum;
  equal <= '1' when CV = 98 else '0';
  choice <= equal or CV_at_least_99 when condition = '1' else CV_at_least_99;
  CV_at_least_99_next <= not R and choice;

  Q <= CV_at_least_99_next;
  CV_last <= CV;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
        was <= '0';
        CV_at_least_99 <= '0';
      else
        CV <= CV_next;
        was <= power;
        CV_at_least_99 <= CV_at_least_99_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- CTD: down counter
-- Fitted to PV = 50.
-- Example, with PV = 2:
-- IN  _##_#__#_#_
-- LD  ______##___
-- Q   ____##_____
-- CV  21110022211
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_counters_test_CTD_PV50 is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    power   : in  std_logic;
    LD      : in  std_logic;
    Q       : out std_logic;
    CV_last : out unsigned(15 downto 0)
  );
end entity ab_counters_test_CTD_PV50;

architecture rtl of ab_counters_test_CTD_PV50 is
  signal CV : unsigned(15 downto 0) := to_unsigned(50, 16);
  signal was : std_logic := '0';
  signal unequal : std_logic;
  signal difference : unsigned(15 downto 0);
  signal CV_next : unsigned(15 downto 0);
begin
  unequal <= '1' when CV /= 32768 else '0';
  difference <= CV - (to_unsigned(0, 15) & (power and not was and unequal));
  CV_next <= to_unsigned(50, 16) when LD = '1' else difference;

  Q <= '1' when signed(CV_next) <= 0 else '0';
  CV_last <= CV;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= to_unsigned(50, 16);
        was <= '0';
      else
        CV <= CV_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_counters_test is
  port (
    clk               : in  std_logic;
    rst               : in  std_logic;
    tick              : in  std_logic;
    count_up          : in  std_logic;
    count_down        : in  std_logic;
    reset_up          : in  std_logic;
    reset_down        : in  std_logic;
    to_the_end        : in  std_logic;
    up_done           : out std_logic;
    down_done         : out std_logic;
    siemens_up_done   : out std_logic;
    siemens_down_done : out std_logic;
    overflow          : out std_logic;
    c5_0_ACC          : out std_logic_vector(15 downto 0);
    c1_CV             : out std_logic_vector(15 downto 0);
    c5_1_ACC          : out std_logic_vector(15 downto 0);
    c2_CV             : out std_logic_vector(15 downto 0);
    c5_2_ACC          : out std_logic_vector(15 downto 0);
    c5_2_DN           : out std_logic;
    c5_2_OV           : out std_logic
  );
end entity ab_counters_test;

architecture rtl of ab_counters_test is
  signal c5_2_ACC_reg : unsigned(15 downto 0) := (others => '0');
  signal up_done_reg : std_logic := '0';
  signal down_done_reg : std_logic := '0';
  signal siemens_up_done_reg : std_logic := '0';
  signal siemens_down_done_reg : std_logic := '0';
  signal overflow_reg : std_logic := '0';
  signal c5_0_ACC_last : unsigned(15 downto 0);
  signal c5_0_DN : std_logic;
  signal up_done_next : std_logic;
  signal c5_1_ACC_last : unsigned(15 downto 0);
  signal c5_1_DN : std_logic;
  signal down_done_next : std_logic;
  signal c5_2_ACC_2 : unsigned(15 downto 0);
  signal c5_2_DN_last : std_logic;
  signal c5_2_OV_2 : std_logic;
  signal c5_2_OV_last : std_logic;
  signal c5_2_ACC_rung8 : unsigned(15 downto 0);
  signal c5_2_ACC_next : unsigned(15 downto 0);
  signal overflow_next : std_logic;
  signal c1_Q : std_logic;
  signal c1_CV_last : unsigned(14 downto 0);
  signal siemens_up_done_next : std_logic;
  signal c2_Q : std_logic;
  signal c2_CV_last : unsigned(15 downto 0);
  signal c1_CV_value : unsigned(15 downto 0);
  signal siemens_down_done_next : std_logic;
begin

  -- rung 1 "C5:0 up to 99", ab_counters.ladder:12
  c5_0: entity work.ab_counters_test_AB_CTU_PRE99
    port map (
      clk => clk,
      rst => rst,
      power => count_up,
      clear_after => reset_up,
      ACC_last => c5_0_ACC_last,
      DN => c5_0_DN
    );

  -- rung 2, ab_counters.ladder:15
  up_done_next <= c5_0_DN;

  -- rung 3, ab_counters.ladder:17

  -- rung 4 "C5:1 down from 50: DN while 1 or more are left", ab_counters.ladder:19
  c5_1: entity work.ab_counters_test_AB_CTD_PRE1
    port map (
      clk => clk,
      rst => rst,
      power => count_down,
      clear_after => reset_down,
      ACC_last => c5_1_ACC_last,
      DN => c5_1_DN
    );

  -- rung 5 "so nothing is left when it is off", ab_counters.ladder:22
  down_done_next <= not c5_1_DN;

  -- rung 6, ab_counters.ladder:25

  -- rung 7 "C5:2 for the end of the range; CTU stops at 32767", ab_counters.ladder:27
  c5_2: entity work.ab_counters_test_AB_CTU_PRE99_2
    port map (
      clk => clk,
      rst => rst,
      power => count_up,
      ACC_before => c5_2_ACC_reg,
      clear_after => reset_up,
      ACC => c5_2_ACC_2,
      DN_last => c5_2_DN_last,
      OV => c5_2_OV_2,
      OV_last => c5_2_OV_last
    );

  -- rung 8, ab_counters.ladder:30
  c5_2_ACC_rung8 <= to_unsigned(32766, 16) when to_the_end = '1' else c5_2_ACC_2;

  -- rung 9, ab_counters.ladder:32
  c5_2_ACC_next <= to_unsigned(0, 16) when reset_up = '1' else c5_2_ACC_rung8;
  overflow_next <= not reset_up and c5_2_OV_2;

  -- rung 10, ab_counters.ladder:34

  -- rung 11 "the same with Siemens' counters", ab_counters.ladder:36
  c1: entity work.ab_counters_test_CTU_PV99
    port map (
      clk => clk,
      rst => rst,
      power => count_up,
      R => reset_up,
      Q => c1_Q,
      CV_last => c1_CV_last
    );
  siemens_up_done_next <= c1_Q;

  -- rung 12, ab_counters.ladder:39
  c2: entity work.ab_counters_test_CTD_PV50
    port map (
      clk => clk,
      rst => rst,
      power => count_down,
      LD => reset_down,
      Q => c2_Q,
      CV_last => c2_CV_last
    );
  c1_CV_value <= resize(c1_CV_last, 16);
  siemens_down_done_next <= c2_Q;

  up_done <= up_done_reg;
  down_done <= down_done_reg;
  siemens_up_done <= siemens_up_done_reg;
  siemens_down_done <= siemens_down_done_reg;
  overflow <= overflow_reg;
  c5_0_ACC <= std_logic_vector(c5_0_ACC_last);
  c1_CV <= std_logic_vector(c1_CV_value);
  c5_1_ACC <= std_logic_vector(c5_1_ACC_last);
  c2_CV <= std_logic_vector(c2_CV_last);
  c5_2_ACC <= std_logic_vector(c5_2_ACC_reg);
  c5_2_DN <= c5_2_DN_last;
  c5_2_OV <= c5_2_OV_last;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        c5_2_ACC_reg <= (others => '0');
        up_done_reg <= '0';
        down_done_reg <= '0';
        siemens_up_done_reg <= '0';
        siemens_down_done_reg <= '0';
        overflow_reg <= '0';
      else
        c5_2_ACC_reg <= c5_2_ACC_next;
        up_done_reg <= up_done_next;
        down_done_reg <= down_done_next;
        siemens_up_done_reg <= siemens_up_done_next;
        siemens_down_done_reg <= siemens_down_done_next;
        overflow_reg <= overflow_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_counters_expect is
  port (
    clk               : in  std_logic;
    rst               : in  std_logic;
    up_done           : in  std_logic;
    siemens_up_done   : in  std_logic;
    c5_0_ACC          : in  std_logic_vector(15 downto 0);
    c1_CV             : in  std_logic_vector(15 downto 0);
    down_done         : in  std_logic;
    siemens_down_done : in  std_logic;
    c5_1_ACC          : in  std_logic_vector(15 downto 0);
    c2_CV             : in  std_logic_vector(15 downto 0);
    c5_2_ACC          : in  std_logic_vector(15 downto 0);
    overflow          : in  std_logic;
    c5_2_DN           : in  std_logic;
    c5_2_OV           : in  std_logic;
    expect_0_0        : out std_logic;
    expect_0_1        : out std_logic;
    expect_0_2        : out std_logic;
    expect_0_3        : out std_logic;
    expect_1_0        : out std_logic;
    expect_1_1        : out std_logic;
    expect_2_0        : out std_logic;
    expect_2_1        : out std_logic;
    expect_2_2        : out std_logic;
    expect_2_3        : out std_logic;
    expect_3_0        : out std_logic;
    expect_3_1        : out std_logic;
    expect_3_2        : out std_logic;
    expect_4_0        : out std_logic;
    expect_5_0        : out std_logic;
    expect_5_1        : out std_logic;
    expect_5_2        : out std_logic;
    expect_5_3        : out std_logic;
    expect_6_0        : out std_logic;
    expect_6_1        : out std_logic;
    expect_7_0        : out std_logic;
    expect_7_1        : out std_logic;
    expect_7_2        : out std_logic;
    expect_7_3        : out std_logic;
    expect_8_0        : out std_logic;
    expect_8_1        : out std_logic;
    expect_8_2        : out std_logic;
    expect_8_3        : out std_logic;
    expect_9_0        : out std_logic;
    expect_9_1        : out std_logic;
    expect_9_2        : out std_logic;
    expect_9_3        : out std_logic;
    expect_10_0       : out std_logic;
    expect_10_1       : out std_logic;
    expect_11_0       : out std_logic;
    expect_11_1       : out std_logic;
    expect_12_0       : out std_logic;
    expect_12_1       : out std_logic;
    expect_13_0       : out std_logic;
    expect_13_1       : out std_logic;
    expect_14_0       : out std_logic;
    expect_15_0       : out std_logic;
    expect_15_1       : out std_logic;
    expect_15_2       : out std_logic;
    expect_16_0       : out std_logic;
    expect_16_1       : out std_logic
  );
end entity ab_counters_expect;

architecture rtl of ab_counters_expect is
begin

  expect_0_0 <= not up_done;
  expect_0_1 <= not siemens_up_done;
  expect_0_2 <= '1' when unsigned(c5_0_ACC) = 98 else '0';
  expect_0_3 <= '1' when unsigned(c1_CV) = 98 else '0';
  expect_1_0 <= up_done;
  expect_1_1 <= siemens_up_done;
  expect_2_0 <= up_done;
  expect_2_1 <= siemens_up_done;
  expect_2_2 <= '1' when unsigned(c5_0_ACC) = 109 else '0';
  expect_2_3 <= '1' when unsigned(c1_CV) = 109 else '0';
  expect_3_0 <= not siemens_up_done;
  expect_3_1 <= '1' when unsigned(c5_0_ACC) = 0 else '0';
  expect_3_2 <= '1' when unsigned(c1_CV) = 0 else '0';
  expect_4_0 <= not up_done;
  expect_5_0 <= not down_done;
  expect_5_1 <= not siemens_down_done;
  expect_5_2 <= '1' when unsigned(c5_1_ACC) = 50 else '0';
  expect_5_3 <= '1' when unsigned(c2_CV) = 50 else '0';
  expect_6_0 <= not down_done;
  expect_6_1 <= not siemens_down_done;
  expect_7_0 <= down_done;
  expect_7_1 <= siemens_down_done;
  expect_7_2 <= '1' when unsigned(c5_1_ACC) = 0 else '0';
  expect_7_3 <= '1' when unsigned(c2_CV) = 0 else '0';
  expect_8_0 <= down_done;
  expect_8_1 <= siemens_down_done;
  expect_8_2 <= '1' when unsigned(c5_1_ACC) = 65535 else '0';
  expect_8_3 <= '1' when unsigned(c2_CV) = 65535 else '0';
  expect_9_0 <= '1' when unsigned(c5_0_ACC) = 0 else '0';
  expect_9_1 <= '1' when unsigned(c1_CV) = 1 else '0';
  expect_9_2 <= '1' when unsigned(c5_1_ACC) = 50 else '0';
  expect_9_3 <= '1' when unsigned(c2_CV) = 49 else '0';
  expect_10_0 <= '1' when unsigned(c5_0_ACC) = 1 else '0';
  expect_10_1 <= '1' when unsigned(c1_CV) = 1 else '0';
  expect_11_0 <= '1' when unsigned(c5_0_ACC) = 1 else '0';
  expect_11_1 <= '1' when unsigned(c1_CV) = 0 else '0';
  expect_12_0 <= '1' when unsigned(c5_1_ACC) = 47 else '0';
  expect_12_1 <= '1' when unsigned(c2_CV) = 47 else '0';
  expect_13_0 <= '1' when unsigned(c5_1_ACC) = 0 else '0';
  expect_13_1 <= '1' when unsigned(c2_CV) = 50 else '0';
  expect_14_0 <= '1' when unsigned(c5_2_ACC) = 32766 else '0';
  expect_15_0 <= '1' when unsigned(c5_2_ACC) = 32768 else '0';
  expect_15_1 <= overflow;
  expect_15_2 <= not c5_2_DN;
  expect_16_0 <= '1' when unsigned(c5_2_ACC) = 0 else '0';
  expect_16_1 <= not c5_2_OV;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity ab_counters_tb is
end entity;

architecture tests of ab_counters_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal count_up : std_logic := '0';
  signal count_down : std_logic := '0';
  signal reset_up : std_logic := '0';
  signal reset_down : std_logic := '0';
  signal to_the_end : std_logic := '0';
  signal up_done : std_logic;
  signal down_done : std_logic;
  signal siemens_up_done : std_logic;
  signal siemens_down_done : std_logic;
  signal overflow : std_logic;
  signal c5_0_ACC : std_logic_vector(15 downto 0);
  signal c1_CV : std_logic_vector(15 downto 0);
  signal c5_1_ACC : std_logic_vector(15 downto 0);
  signal c2_CV : std_logic_vector(15 downto 0);
  signal c5_2_ACC : std_logic_vector(15 downto 0);
  signal c5_2_DN : std_logic;
  signal c5_2_OV : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_0_3 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
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
  signal expect_5_3 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
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
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_13_1 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_15_1 : std_logic;
  signal expect_15_2 : std_logic;
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
  core : entity work.ab_counters_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      count_up => count_up,
      count_down => count_down,
      reset_up => reset_up,
      reset_down => reset_down,
      to_the_end => to_the_end,
      up_done => up_done,
      down_done => down_done,
      siemens_up_done => siemens_up_done,
      siemens_down_done => siemens_down_done,
      overflow => overflow,
      c5_0_ACC => c5_0_ACC,
      c1_CV => c1_CV,
      c5_1_ACC => c5_1_ACC,
      c2_CV => c2_CV,
      c5_2_ACC => c5_2_ACC,
      c5_2_DN => c5_2_DN,
      c5_2_OV => c5_2_OV
    );

  expectations : entity work.ab_counters_expect
    port map (
      clk => clk,
      rst => rst,
      up_done => up_done,
      siemens_up_done => siemens_up_done,
      c5_0_ACC => c5_0_ACC,
      c1_CV => c1_CV,
      down_done => down_done,
      siemens_down_done => siemens_down_done,
      c5_1_ACC => c5_1_ACC,
      c2_CV => c2_CV,
      c5_2_ACC => c5_2_ACC,
      overflow => overflow,
      c5_2_DN => c5_2_DN,
      c5_2_OV => c5_2_OV,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_0_3 => expect_0_3,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
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
      expect_5_3 => expect_5_3,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
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
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_13_0 => expect_13_0,
      expect_13_1 => expect_13_1,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_15_1 => expect_15_1,
      expect_15_2 => expect_15_2,
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
      count_up <= '0';
      count_down <= '0';
      reset_up <= '0';
      reset_down <= '0';
      to_the_end <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..6");

    -- up to 99 and beyond
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 98 loop
      count_up <= '1';
      scan(1, '0');
      count_up <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- ab_counters.ladder:44
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2 and expect_0_3) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2) & image(expect_0_3)
          & " up_done=" & image(up_done)
          & " siemens_up_done=" & image(siemens_up_done)
          & " c5_0_ACC=" & image(c5_0_ACC)
          & " c1_CV=" & image(c1_CV));
    end if;
    count_up <= '1';
    scan(1, '0');
    count_up <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:46
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " up_done=" & image(up_done)
          & " siemens_up_done=" & image(siemens_up_done));
    end if;
    for round in 1 to 10 loop
      count_up <= '1';
      scan(1, '0');
      count_up <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- ab_counters.ladder:48
    if not failed and (expect_2_0 and expect_2_1 and expect_2_2 and expect_2_3) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2) & image(expect_2_3)
          & " up_done=" & image(up_done)
          & " siemens_up_done=" & image(siemens_up_done)
          & " c5_0_ACC=" & image(c5_0_ACC)
          & " c1_CV=" & image(c1_CV));
    end if;
    reset_up <= '1';
    scan(1, '0');
    reset_up <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:50
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
          & " siemens_up_done=" & image(siemens_up_done)
          & " c5_0_ACC=" & image(c5_0_ACC)
          & " c1_CV=" & image(c1_CV));
    end if;
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:52
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " up_done=" & image(up_done));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - up to 99 and beyond");
    else
      print("ok 1 - up to 99 and beyond");
    end if;

    -- down from 50, and below 0
    failed := false;
    reset;
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:56
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2 and expect_5_3) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2) & image(expect_5_3)
          & " down_done=" & image(down_done)
          & " siemens_down_done=" & image(siemens_down_done)
          & " c5_1_ACC=" & image(c5_1_ACC)
          & " c2_CV=" & image(c2_CV));
    end if;
    for round in 1 to 49 loop
      count_down <= '1';
      scan(1, '0');
      count_down <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- ab_counters.ladder:58
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " down_done=" & image(down_done)
          & " siemens_down_done=" & image(siemens_down_done));
    end if;
    count_down <= '1';
    scan(1, '0');
    count_down <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:60
    if not failed and (expect_7_0 and expect_7_1 and expect_7_2 and expect_7_3) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2) & image(expect_7_3)
          & " down_done=" & image(down_done)
          & " siemens_down_done=" & image(siemens_down_done)
          & " c5_1_ACC=" & image(c5_1_ACC)
          & " c2_CV=" & image(c2_CV));
    end if;
    count_down <= '1';
    scan(1, '0');
    count_down <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:62
    if not failed and (expect_8_0 and expect_8_1 and expect_8_2 and expect_8_3) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2) & image(expect_8_3)
          & " down_done=" & image(down_done)
          & " siemens_down_done=" & image(siemens_down_done)
          & " c5_1_ACC=" & image(c5_1_ACC)
          & " c2_CV=" & image(c2_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - down from 50, and below 0");
    else
      print("ok 2 - down from 50, and below 0");
    end if;

    -- difference: an input that is on in the first scan counts at Siemens only
    failed := false;
    reset;
    count_up <= '1';
    count_down <= '1';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:66
    if not failed and (expect_9_0 and expect_9_1 and expect_9_2 and expect_9_3) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2) & image(expect_9_3)
          & " c5_0_ACC=" & image(c5_0_ACC)
          & " c1_CV=" & image(c1_CV)
          & " c5_1_ACC=" & image(c5_1_ACC)
          & " c2_CV=" & image(c2_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - difference: an input that is on in the first scan counts at Siemens only");
    else
      print("ok 3 - difference: an input that is on in the first scan counts at Siemens only");
    end if;

    -- difference: a held input counts once more after RES
    failed := false;
    reset;
    scan(1, '0');
    count_up <= '1';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:71
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " c5_0_ACC=" & image(c5_0_ACC)
          & " c1_CV=" & image(c1_CV));
    end if;
    reset_up <= '1';
    scan(1, '0');
    reset_up <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:74
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " c5_0_ACC=" & image(c5_0_ACC)
          & " c1_CV=" & image(c1_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - difference: a held input counts once more after RES");
    else
      print("ok 4 - difference: a held input counts once more after RES");
    end if;

    -- difference: RES of a down counter makes it 0, LD makes it the preset
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 3 loop
      count_down <= '1';
      scan(1, '0');
      count_down <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- ab_counters.ladder:79
    if not failed and (expect_12_0 and expect_12_1) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
          & " c5_1_ACC=" & image(c5_1_ACC)
          & " c2_CV=" & image(c2_CV));
    end if;
    reset_down <= '1';
    scan(1, '0');
    reset_down <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:81
    if not failed and (expect_13_0 and expect_13_1) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0) & image(expect_13_1)
          & " c5_1_ACC=" & image(c5_1_ACC)
          & " c2_CV=" & image(c2_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - difference: RES of a down counter makes it 0, LD makes it the preset");
    else
      print("ok 5 - difference: RES of a down counter makes it 0, LD makes it the preset");
    end if;

    -- difference: past the largest count one goes round and says so, Siemens' stops
    failed := false;
    reset;
    scan(1, '0');
    to_the_end <= '1';
    scan(1, '0');
    to_the_end <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:86
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " c5_2_ACC=" & image(c5_2_ACC));
    end if;
    for round in 1 to 2 loop
      count_up <= '1';
      scan(1, '0');
      count_up <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- ab_counters.ladder:88
    if not failed and (expect_15_0 and expect_15_1 and expect_15_2) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0) & image(expect_15_1) & image(expect_15_2)
          & " c5_2_ACC=" & image(c5_2_ACC)
          & " overflow=" & image(overflow)
          & " c5_2_DN=" & image(c5_2_DN));
    end if;
    reset_up <= '1';
    scan(1, '0');
    reset_up <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_counters.ladder:90
    if not failed and (expect_16_0 and expect_16_1) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0) & image(expect_16_1)
          & " c5_2_ACC=" & image(c5_2_ACC)
          & " c5_2_OV=" & image(c5_2_OV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - difference: past the largest count one goes round and says so, Siemens' stops");
    else
      print("ok 6 - difference: past the largest count one goes round and says so, Siemens' stops");
    end if;

    assert failures = 0 report integer'image(failures) & " of 6 tests failed" severity failure;
    wait;
  end process;
end architecture;
