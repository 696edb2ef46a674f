-- Made by hotrail 0.1.0 from ab_retentive.ladder. Do not edit: change the ladder and build again.

-- AB_RTO: retentive timer of Allen-Bradley, BASE = 100 ticks
-- Example, with PRE = 3, BASE = 1:
-- IN  _##_###____#_##
-- (R) ____________#__
-- EN  _##_###____#_##
-- TT  _##_##_______##
-- DN  ______######___
-- ACC 001112333333001
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_retentive_AB_RTO_BASE100 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    power       : in  std_logic;
    PRE         : in  unsigned(15 downto 0);
    clear_after : in  std_logic;
    DN          : out std_logic
  );
end entity ab_retentive_AB_RTO_BASE100;

architecture rtl of ab_retentive_AB_RTO_BASE100 is
  signal ACC : unsigned(14 downto 0) := (others => '0');
  signal DN_reg : std_logic := '0';
  signal fraction : unsigned(6 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal choice : unsigned(14 downto 0);
  signal condition : std_logic;
  signal equal : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(6 downto 0);
  signal choice_2 : unsigned(6 downto 0);
  signal unequal : std_logic;
  signal sum_2 : unsigned(14 downto 0);
  signal at_least : std_logic;
  signal DN_value : std_logic;
  signal ACC_next : unsigned(14 downto 0);
  signal DN_next : std_logic;
  signal fraction_next : unsigned(6 downto 0);
begin
  less <= '1' when signed(PRE) < 0 else '0';
  choice <= to_unsigned(0, 15) when less = '1' else PRE(14 downto 0);
  condition <= power and was and not DN_reg and tick;
  equal <= '1' when fraction = 99 else '0';
  condition_2 <= condition and equal;
  sum <= fraction + (to_unsigned(0, 6) & condition);
  choice_2 <= to_unsigned(0, 7) when condition_2 = '1' else sum;
  unequal <= '1' when ACC /= 32767 else '0';
  sum_2 <= ACC + (to_unsigned(0, 14) & (condition_2 and unequal));
  at_least <= '1' when sum_2 >= choice else '0';
  DN_value <= DN_reg or (power and at_least);
  ACC_next <= to_unsigned(0, 15) when clear_after = '1' else sum_2;
  DN_next <= not clear_after and DN_value;
  fraction_next <= to_unsigned(0, 7) when clear_after = '1' else choice_2;

  DN <= DN_value;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        DN_reg <= '0';
        fraction <= (others => '0');
        was <= '0';
      else
        ACC <= ACC_next;
        DN_reg <= DN_next;
        fraction <= fraction_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TONR: retentive on-delay timer
-- Example, with PT = 3:
-- IN  _##_###____######
-- R   _________#___#___
-- Q   ______###_______#
-- ET  00111233300010123
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_retentive_TONR is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    PT    : in  unsigned(31 downto 0);
    R     : in  std_logic;
    Q     : out std_logic
  );
end entity ab_retentive_TONR;

architecture rtl of ab_retentive_TONR is
  signal ET : unsigned(31 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal sum : unsigned(31 downto 0);
  signal ET_next : unsigned(31 downto 0);
  signal at_least : std_logic;
begin
  less <= '1' when signed(ET) < signed(PT) else '0';
  sum <= ET + (to_unsigned(0, 31) & (power and was and tick and less));
  ET_next <= to_unsigned(0, 32) when R = '1' else sum;
  at_least <= '1' when signed(ET_next) >= signed(PT) else '0';

  Q <= not R and at_least;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
      else
        ET <= ET_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_retentive is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    tick            : in  std_logic;
    pump            : in  std_logic;
    reset_button    : in  std_logic;
    longer          : in  std_logic;
    service         : out std_logic;
    siemens_service : out std_logic
  );
end entity ab_retentive;

architecture rtl of ab_retentive is
  signal t4_2_PRE : unsigned(3 downto 0) := to_unsigned(5, 4);
  signal limit : unsigned(9 downto 0) := to_unsigned(500, 10);
  signal service_reg : std_logic := '0';
  signal siemens_service_reg : std_logic := '0';
  signal t4_2_PRE_2 : unsigned(15 downto 0);
  signal t4_2_DN : std_logic;
  signal service_next : std_logic;
  signal t3_PT : unsigned(31 downto 0);
  signal t3_Q : std_logic;
  signal siemens_service_next : std_logic;
  signal t4_2_PRE_next : unsigned(3 downto 0);
  signal limit_next : unsigned(9 downto 0);
begin

  -- rung 1 "T4:2, five units of a second", ab_retentive.ladder:12
  t4_2_PRE_2 <= resize(t4_2_PRE, 16);
  t4_2: entity work.ab_retentive_AB_RTO_BASE100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pump,
      PRE => t4_2_PRE_2,
      clear_after => reset_button,
      DN => t4_2_DN
    );

  -- rung 2, ab_retentive.ladder:15
  service_next <= t4_2_DN;

  -- rung 3 "RES", ab_retentive.ladder:17

  -- rung 4 "the same with Siemens' timer", ab_retentive.ladder:20
  t3_PT <= resize(limit, 32);
  t3: entity work.ab_retentive_TONR
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pump,
      PT => t3_PT,
      R => reset_button,
      Q => t3_Q
    );
  siemens_service_next <= t3_Q;

  -- rung 5, ab_retentive.ladder:23
  t4_2_PRE_next <= to_unsigned(8, 4) when longer = '1' else t4_2_PRE;
  limit_next <= to_unsigned(800, 10) when longer = '1' else limit;

  service <= service_reg;
  siemens_service <= siemens_service_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        t4_2_PRE <= to_unsigned(5, 4);
        limit <= to_unsigned(500, 10);
        service_reg <= '0';
        siemens_service_reg <= '0';
      else
        t4_2_PRE <= t4_2_PRE_next;
        limit <= limit_next;
        service_reg <= service_next;
        siemens_service_reg <= siemens_service_next;
      end if;
    end if;
  end process;
end architecture rtl;
