-- Made by hotrail 0.1.0 from ab_counters.ladder. Do not edit: change the ladder and build again.

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

entity ab_counters_AB_CTU_PRE99 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    clear_after : in  std_logic;
    DN          : out std_logic
  );
end entity ab_counters_AB_CTU_PRE99;

architecture rtl of ab_counters_AB_CTU_PRE99 is
  signal ACC : unsigned(15 downto 0) := (others => '0');
  signal was_up : std_logic := '1';
  signal sum : unsigned(15 downto 0);
  signal ACC_next : unsigned(15 downto 0);
  signal was_up_next : std_logic;
begin
  sum <= ACC + (to_unsigned(0, 15) & (power and not was_up));
  ACC_next <= to_unsigned(0, 16) when clear_after = '1' else sum;
  was_up_next <= not clear_after and power;

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

entity ab_counters_AB_CTD_PRE1 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    clear_after : in  std_logic;
    DN          : out std_logic
  );
end entity ab_counters_AB_CTD_PRE1;

architecture rtl of ab_counters_AB_CTD_PRE1 is
  signal ACC : unsigned(15 downto 0) := to_unsigned(50, 16);
  signal was_down : std_logic := '1';
  signal difference : unsigned(15 downto 0);
  signal ACC_next : unsigned(15 downto 0);
  signal was_down_next : std_logic;
begin
  difference <= ACC - (to_unsigned(0, 15) & (power and not was_down));
  ACC_next <= to_unsigned(0, 16) when clear_after = '1' else difference;
  was_down_next <= not clear_after and power;

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
-- Example, with PRE = 2:
-- IN  _#_##_#_##_#
-- (R) ________#___
-- CU  _#_##_#__#_#
-- DN  ___#####___#
-- ACC 011222330112
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_counters_AB_CTU is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    ACC_before  : in  unsigned(15 downto 0);
    clear_after : in  std_logic;
    ACC         : out unsigned(15 downto 0);
    OV          : out std_logic
  );
end entity ab_counters_AB_CTU;

architecture rtl of ab_counters_AB_CTU is
  signal OV_reg : std_logic := '0';
  signal UN : std_logic := '0';
  signal was_up : std_logic := '1';
  signal condition : std_logic;
  signal ACC_value : unsigned(15 downto 0);
  signal equal : std_logic;
  signal condition_2 : std_logic;
  signal OV_value : std_logic;
  signal OV_next : std_logic;
  signal UN_next : std_logic;
  signal was_up_next : std_logic;
begin
  condition <= power and not was_up;
  ACC_value <= ACC_before + (to_unsigned(0, 15) & condition);
  equal <= '1' when ACC_before = 32767 else '0';
  condition_2 <= condition and equal;
  OV_value <= OV_reg or (condition_2 and not UN);
  OV_next <= '0' when clear_after = '1' else OV_value;
  UN_next <= '0' when clear_after = '1' else UN and not condition_2;
  was_up_next <= '0' when clear_after = '1' else power;

  ACC <= ACC_value;
  OV <= OV_value;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        OV_reg <= '0';
        UN <= '0';
        was_up <= '1';
      else
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

entity ab_counters_CTU_PV99 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    R     : in  std_logic;
    Q     : out std_logic
  );
end entity ab_counters_CTU_PV99;

architecture rtl of ab_counters_CTU_PV99 is
  signal CV : unsigned(6 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal CV_is_99 : std_logic := '0';
  signal condition : std_logic;
  signal sum : unsigned(6 downto 0);
  signal choice : unsigned(6 downto 0);
  signal CV_next : unsigned(6 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal CV_is_99_next : std_logic;
begin
  condition <= power and not was and not CV_is_99;
  sum <= CV + 1;
  choice <= sum when condition = '1' else CV;
  CV_next <= to_unsigned(0, 7) when R = '1' else choice;
  equal <= '1' when CV = 98 else '0';
  choice_2 <= equal when condition = '1' else CV_is_99;
  CV_is_99_next <= '0' when R = '1' else choice_2;

  Q <= CV_is_99_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
        was <= '0';
        CV_is_99 <= '0';
      else
        CV <= CV_next;
        was <= power;
        CV_is_99 <= CV_is_99_next;
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

entity ab_counters_CTD_PV50 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    LD    : in  std_logic;
    Q     : out std_logic
  );
end entity ab_counters_CTD_PV50;

architecture rtl of ab_counters_CTD_PV50 is
  signal CV : unsigned(5 downto 0) := to_unsigned(50, 6);
  signal was : std_logic := '0';
  signal CV_is_0 : std_logic := '0';
  signal condition : std_logic;
  signal difference : unsigned(5 downto 0);
  signal choice : unsigned(5 downto 0);
  signal CV_next : unsigned(5 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal CV_is_0_next : std_logic;
begin
  condition <= power and not was and not CV_is_0;
  difference <= CV - 1;
  choice <= difference when condition = '1' else CV;
  CV_next <= to_unsigned(50, 6) when LD = '1' else choice;
  equal <= '1' when CV = 1 else '0';
  choice_2 <= equal when condition = '1' else CV_is_0;
  CV_is_0_next <= '0' when LD = '1' else choice_2;

  Q <= CV_is_0_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= to_unsigned(50, 6);
        was <= '0';
        CV_is_0 <= '0';
      else
        CV <= CV_next;
        was <= power;
        CV_is_0 <= CV_is_0_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_counters is
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
    overflow          : out std_logic
  );
end entity ab_counters;

architecture rtl of ab_counters is
  signal c5_2_ACC_reg : unsigned(15 downto 0) := (others => '0');
  signal up_done_reg : std_logic := '0';
  signal down_done_reg : std_logic := '0';
  signal siemens_up_done_reg : std_logic := '0';
  signal siemens_down_done_reg : std_logic := '0';
  signal overflow_reg : std_logic := '0';
  signal c5_0_DN : std_logic;
  signal up_done_next : std_logic;
  signal c5_1_DN : std_logic;
  signal down_done_next : std_logic;
  signal c5_2_ACC : unsigned(15 downto 0);
  signal c5_2_OV : std_logic;
  signal c5_2_ACC_rung8 : unsigned(15 downto 0);
  signal c5_2_ACC_next : unsigned(15 downto 0);
  signal overflow_next : std_logic;
  signal c1_Q : std_logic;
  signal siemens_up_done_next : std_logic;
  signal c2_Q : std_logic;
  signal siemens_down_done_next : std_logic;
begin

  -- rung 1 "C5:0 up to 99", ab_counters.ladder:12
  c5_0: entity work.ab_counters_AB_CTU_PRE99
    port map (
      clk => clk,
      rst => rst,
      power => count_up,
      clear_after => reset_up,
      DN => c5_0_DN
    );

  -- rung 2, ab_counters.ladder:15
  up_done_next <= c5_0_DN;

  -- rung 3, ab_counters.ladder:17

  -- rung 4 "C5:1 down from 50: DN while 1 or more are left", ab_counters.ladder:19
  c5_1: entity work.ab_counters_AB_CTD_PRE1
    port map (
      clk => clk,
      rst => rst,
      power => count_down,
      clear_after => reset_down,
      DN => c5_1_DN
    );

  -- rung 5 "so nothing is left when it is off", ab_counters.ladder:22
  down_done_next <= not c5_1_DN;

  -- rung 6, ab_counters.ladder:25

  -- rung 7 "C5:2 for the end of the range; CTU stops at 32767", ab_counters.ladder:27
  c5_2: entity work.ab_counters_AB_CTU
    port map (
      clk => clk,
      rst => rst,
      power => count_up,
      ACC_before => c5_2_ACC_reg,
      clear_after => reset_up,
      ACC => c5_2_ACC,
      OV => c5_2_OV
    );

  -- rung 8, ab_counters.ladder:30
  c5_2_ACC_rung8 <= to_unsigned(32766, 16) when to_the_end = '1' else c5_2_ACC;

  -- rung 9, ab_counters.ladder:32
  c5_2_ACC_next <= to_unsigned(0, 16) when reset_up = '1' else c5_2_ACC_rung8;
  overflow_next <= not reset_up and c5_2_OV;

  -- rung 10, ab_counters.ladder:34

  -- rung 11 "the same with Siemens' counters", ab_counters.ladder:36
  c1: entity work.ab_counters_CTU_PV99
    port map (
      clk => clk,
      rst => rst,
      power => count_up,
      R => reset_up,
      Q => c1_Q
    );
  siemens_up_done_next <= c1_Q;

  -- rung 12, ab_counters.ladder:39
  c2: entity work.ab_counters_CTD_PV50
    port map (
      clk => clk,
      rst => rst,
      power => count_down,
      LD => reset_down,
      Q => c2_Q
    );
  siemens_down_done_next <= c2_Q;

  up_done <= up_done_reg;
  down_done <= down_done_reg;
  siemens_up_done <= siemens_up_done_reg;
  siemens_down_done <= siemens_down_done_reg;
  overflow <= overflow_reg;

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
