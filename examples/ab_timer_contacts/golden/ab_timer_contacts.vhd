-- Made by hotrail 0.1.0 from ab_timer_contacts.ladder. Do not edit: change the ladder and build again.

-- AB_TON: on-delay timer of Allen-Bradley, BASE = 10 ticks
-- Example, with PRE = 3, BASE = 1:
-- IN  _#######__###_
-- EN  _#######__###_
-- TT  _###______###_
-- DN  ____####______
-- ACC 00123333000120
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_timer_contacts_AB_TON_BASE10 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    PRE   : in  unsigned(15 downto 0);
    EN    : out std_logic;
    TT    : out std_logic;
    DN    : out std_logic
  );
end entity ab_timer_contacts_AB_TON_BASE10;

architecture rtl of ab_timer_contacts_AB_TON_BASE10 is
  signal ACC : unsigned(14 downto 0) := (others => '0');
  signal DN_reg : std_logic := '0';
  signal fraction : unsigned(3 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal choice : unsigned(14 downto 0);
  signal condition : std_logic;
  signal equal : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(3 downto 0);
  signal choice_2 : unsigned(3 downto 0);
  signal unequal : std_logic;
  signal sum_2 : unsigned(14 downto 0);
  signal at_least : std_logic;
  signal DN_next : std_logic;
  signal ACC_next : unsigned(14 downto 0);
  signal fraction_next : unsigned(3 downto 0);
begin
  less <= '1' when signed(PRE) < 0 else '0';
  choice <= to_unsigned(0, 15) when less = '1' else PRE(14 downto 0);
  condition <= power and was and not DN_reg and tick;
  equal <= '1' when fraction = 9 else '0';
  condition_2 <= condition and equal;
  sum <= fraction + (to_unsigned(0, 3) & condition);
  choice_2 <= to_unsigned(0, 4) when condition_2 = '1' else sum;
  unequal <= '1' when ACC /= 32767 else '0';
  sum_2 <= ACC + (to_unsigned(0, 14) & (condition_2 and unequal));
  at_least <= '1' when sum_2 >= choice else '0';
  DN_next <= power and (DN_reg or at_least);
  ACC_next <= sum_2 when power = '1' else to_unsigned(0, 15);
  fraction_next <= choice_2 when power = '1' else to_unsigned(0, 4);

  EN <= power;
  TT <= power and not DN_next;
  DN <= DN_next;

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

-- TON: on-delay timer
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_timer_contacts_TON is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    PT    : in  unsigned(31 downto 0);
    Q     : out std_logic
  );
end entity ab_timer_contacts_TON;

architecture rtl of ab_timer_contacts_TON is
  signal ET : unsigned(31 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal sum : unsigned(31 downto 0);
  signal ET_next : unsigned(31 downto 0);
  signal at_least : std_logic;
begin
  less <= '1' when signed(ET) < signed(PT) else '0';
  sum <= ET + (to_unsigned(0, 31) & (tick and less));
  ET_next <= sum when (power and was) = '1' else to_unsigned(0, 32);
  at_least <= '1' when signed(ET_next) >= signed(PT) else '0';

  Q <= power and at_least;

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

entity ab_timer_contacts is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    tick         : in  std_logic;
    run          : in  std_logic;
    slower       : in  std_logic;
    enabled      : out std_logic;
    timing       : out std_logic;
    done         : out std_logic;
    not_enabled  : out std_logic;
    not_timing   : out std_logic;
    not_done     : out std_logic;
    siemens_done : out std_logic
  );
end entity ab_timer_contacts;

architecture rtl of ab_timer_contacts is
  signal t4_0_PRE : unsigned(6 downto 0) := to_unsigned(50, 7);
  signal preset : unsigned(12 downto 0) := to_unsigned(500, 13);
  signal enabled_reg : std_logic := '0';
  signal timing_reg : std_logic := '0';
  signal done_reg : std_logic := '0';
  signal not_enabled_reg : std_logic := '0';
  signal not_timing_reg : std_logic := '0';
  signal not_done_reg : std_logic := '0';
  signal siemens_done_reg : std_logic := '0';
  signal t4_0_PRE_2 : unsigned(15 downto 0);
  signal t4_0_EN : std_logic;
  signal t4_0_TT : std_logic;
  signal t4_0_DN : std_logic;
  signal enabled_next : std_logic;
  signal timing_next : std_logic;
  signal done_next : std_logic;
  signal not_enabled_next : std_logic;
  signal not_timing_next : std_logic;
  signal not_done_next : std_logic;
  signal t1_PT : unsigned(31 downto 0);
  signal t1_Q : std_logic;
  signal siemens_done_next : std_logic;
  signal t4_0_PRE_next : unsigned(6 downto 0);
  signal preset_next : unsigned(12 downto 0);
begin

  -- rung 1 "T4:0, 50 units of 10 ms", ab_timer_contacts.ladder:12
  t4_0_PRE_2 <= resize(unsigned(resize(signed(t4_0_PRE), 9)), 16);
  t4_0: entity work.ab_timer_contacts_AB_TON_BASE10
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => run,
      PRE => t4_0_PRE_2,
      EN => t4_0_EN,
      TT => t4_0_TT,
      DN => t4_0_DN
    );

  -- rung 2 "EN", ab_timer_contacts.ladder:15
  enabled_next <= t4_0_EN;

  -- rung 3 "TT", ab_timer_contacts.ladder:18
  timing_next <= t4_0_TT;

  -- rung 4 "DN", ab_timer_contacts.ladder:21
  done_next <= t4_0_DN;

  -- rung 5, ab_timer_contacts.ladder:24
  not_enabled_next <= not t4_0_EN;

  -- rung 6, ab_timer_contacts.ladder:26
  not_timing_next <= not t4_0_TT;

  -- rung 7, ab_timer_contacts.ladder:28
  not_done_next <= not t4_0_DN;

  -- rung 8 "the same with Siemens' timer: only Q is built in", ab_timer_contacts.ladder:30
  t1_PT <= resize(preset, 32);
  t1: entity work.ab_timer_contacts_TON
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => run,
      PT => t1_PT,
      Q => t1_Q
    );
  siemens_done_next <= t1_Q;

  -- rung 9 "from 0.5 s to 5 s", ab_timer_contacts.ladder:33
  t4_0_PRE_next <= to_unsigned(116, 7) when slower = '1' else t4_0_PRE;
  preset_next <= to_unsigned(5000, 13) when slower = '1' else preset;

  enabled <= enabled_reg;
  timing <= timing_reg;
  done <= done_reg;
  not_enabled <= not_enabled_reg;
  not_timing <= not_timing_reg;
  not_done <= not_done_reg;
  siemens_done <= siemens_done_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        t4_0_PRE <= to_unsigned(50, 7);
        preset <= to_unsigned(500, 13);
        enabled_reg <= '0';
        timing_reg <= '0';
        done_reg <= '0';
        not_enabled_reg <= '0';
        not_timing_reg <= '0';
        not_done_reg <= '0';
        siemens_done_reg <= '0';
      else
        t4_0_PRE <= t4_0_PRE_next;
        preset <= preset_next;
        enabled_reg <= enabled_next;
        timing_reg <= timing_next;
        done_reg <= done_next;
        not_enabled_reg <= not_enabled_next;
        not_timing_reg <= not_timing_next;
        not_done_reg <= not_done_next;
        siemens_done_reg <= siemens_done_next;
      end if;
    end if;
  end process;
end architecture rtl;
