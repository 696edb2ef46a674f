-- Made by hotrail 0.1.0 from ab_flasher.ladder. Do not edit: change the ladder and build again.

-- AB_TON: on-delay timer of Allen-Bradley, BASE = 10 ticks
-- Fitted to PRE = 30.
-- Example, with PRE = 3, BASE = 1:
-- IN  _#######__###_
-- EN  _#######__###_
-- TT  _###______###_
-- DN  ____####______
-- ACC 00123333000120
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_flasher_AB_TON_BASE10_PRE30 is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    tick    : in  std_logic;
    power   : in  std_logic;
    DN_last : out std_logic
  );
end entity ab_flasher_AB_TON_BASE10_PRE30;

architecture rtl of ab_flasher_AB_TON_BASE10_PRE30 is
  signal ACC : unsigned(4 downto 0) := (others => '0');
  signal DN : std_logic := '0';
  signal fraction : unsigned(3 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(3 downto 0);
  signal choice : unsigned(3 downto 0);
  signal equal_2 : std_logic;
  signal sum_2 : unsigned(4 downto 0);
  signal equal_3 : std_logic;
  signal DN_next : std_logic;
  signal ACC_next : unsigned(4 downto 0);
  signal fraction_next : unsigned(3 downto 0);
begin
  condition <= power and was and not DN and tick;
  equal <= '1' when fraction = 9 else '0';
  condition_2 <= condition and equal;
  sum <= fraction + (to_unsigned(0, 3) & condition);
  choice <= to_unsigned(0, 4) when condition_2 = '1' else sum;
  equal_2 <= '1' when ACC = 30 else '0';
  sum_2 <= ACC + (to_unsigned(0, 4) & (condition_2 and not equal_2));
  equal_3 <= '1' when ACC = 29 else '0';
  DN_next <= power and (DN or (condition_2 and equal_3) or equal_2);
  ACC_next <= sum_2 when power = '1' else to_unsigned(0, 5);
  fraction_next <= choice when power = '1' else to_unsigned(0, 4);

  DN_last <= DN;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        DN <= '0';
        fraction <= (others => '0');
        was <= '0';
      else
        ACC <= ACC_next;
        DN <= DN_next;
        fraction <= fraction_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- AB_TON: on-delay timer of Allen-Bradley, BASE = 10 ticks
-- Fitted to PRE = 50.
-- Example, with PRE = 3, BASE = 1:
-- IN  _#######__###_
-- EN  _#######__###_
-- TT  _###______###_
-- DN  ____####______
-- ACC 00123333000120
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_flasher_AB_TON_BASE10_PRE50 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    DN    : out std_logic
  );
end entity ab_flasher_AB_TON_BASE10_PRE50;

architecture rtl of ab_flasher_AB_TON_BASE10_PRE50 is
  signal ACC : unsigned(5 downto 0) := (others => '0');
  signal DN_reg : std_logic := '0';
  signal fraction : unsigned(3 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(3 downto 0);
  signal choice : unsigned(3 downto 0);
  signal equal_2 : std_logic;
  signal sum_2 : unsigned(5 downto 0);
  signal equal_3 : std_logic;
  signal DN_next : std_logic;
  signal ACC_next : unsigned(5 downto 0);
  signal fraction_next : unsigned(3 downto 0);
begin
  condition <= power and was and not DN_reg and tick;
  equal <= '1' when fraction = 9 else '0';
  condition_2 <= condition and equal;
  sum <= fraction + (to_unsigned(0, 3) & condition);
  choice <= to_unsigned(0, 4) when condition_2 = '1' else sum;
  equal_2 <= '1' when ACC = 50 else '0';
  sum_2 <= ACC + (to_unsigned(0, 5) & (condition_2 and not equal_2));
  equal_3 <= '1' when ACC = 49 else '0';
  DN_next <= power and (DN_reg or (condition_2 and equal_3) or equal_2);
  ACC_next <= sum_2 when power = '1' else to_unsigned(0, 6);
  fraction_next <= choice when power = '1' else to_unsigned(0, 4);

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
-- Fitted to PT = 300 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_flasher_TON_PT300 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    power  : in  std_logic;
    Q_last : out std_logic
  );
end entity ab_flasher_TON_PT300;

architecture rtl of ab_flasher_TON_PT300 is
  signal Q : std_logic := '0';
  signal ET : unsigned(8 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(8 downto 0);
  signal choice : unsigned(8 downto 0);
  signal ET_next : unsigned(8 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not Q;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 9);
  equal <= '1' when ET = 299 else '0';
  choice_2 <= equal when condition_2 = '1' else Q;
  Q_next <= choice_2 when condition = '1' else '0';

  Q_last <= Q;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q <= '0';
        ET <= (others => '0');
        was <= '0';
      else
        Q <= Q_next;
        ET <= ET_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 500 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_flasher_TON_PT500 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity ab_flasher_TON_PT500;

architecture rtl of ab_flasher_TON_PT500 is
  signal ET : unsigned(8 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_500 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(8 downto 0);
  signal choice : unsigned(8 downto 0);
  signal ET_next : unsigned(8 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_500_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_500;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 9);
  equal <= '1' when ET = 499 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_500;
  ET_is_500_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_500_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_500 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_500 <= ET_is_500_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_flasher is
  port (
    clk           : in  std_logic;
    rst           : in  std_logic;
    tick          : in  std_logic;
    enable        : in  std_logic;
    ab_light      : out std_logic;
    siemens_light : out std_logic
  );
end entity ab_flasher;

architecture rtl of ab_flasher is
  signal ab_light_reg : std_logic := '0';
  signal siemens_light_reg : std_logic := '0';
  signal t4_1_DN_last : std_logic;
  signal t4_0_power : std_logic;
  signal t4_0_DN : std_logic;
  signal ab_light_next : std_logic;
  signal t2_Q_last : std_logic;
  signal t1_power : std_logic;
  signal t1_Q : std_logic;
  signal siemens_light_next : std_logic;
begin

  -- rung 1 "T4:0: dark for 0.5 s", ab_flasher.ladder:7
  t4_0_power <= enable and not t4_1_DN_last;
  t4_1: entity work.ab_flasher_AB_TON_BASE10_PRE30
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t4_0_DN,
      DN_last => t4_1_DN_last
    );
  t4_0: entity work.ab_flasher_AB_TON_BASE10_PRE50
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t4_0_power,
      DN => t4_0_DN
    );

  -- rung 2 "T4:1: lit for 0.3 s", ab_flasher.ladder:10

  -- rung 3, ab_flasher.ladder:13
  ab_light_next <= t4_0_DN;

  -- rung 4 "the same with Siemens' timers", ab_flasher.ladder:15
  t1_power <= enable and not t2_Q_last;
  t2: entity work.ab_flasher_TON_PT300
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t1_Q,
      Q_last => t2_Q_last
    );
  t1: entity work.ab_flasher_TON_PT500
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t1_power,
      Q => t1_Q
    );

  -- rung 5, ab_flasher.ladder:18

  -- rung 6, ab_flasher.ladder:20
  siemens_light_next <= t1_Q;

  ab_light <= ab_light_reg;
  siemens_light <= siemens_light_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ab_light_reg <= '0';
        siemens_light_reg <= '0';
      else
        ab_light_reg <= ab_light_next;
        siemens_light_reg <= siemens_light_next;
      end if;
    end if;
  end process;
end architecture rtl;
