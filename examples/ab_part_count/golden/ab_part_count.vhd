-- Made by hotrail 0.1.0 from ab_part_count.ladder. Do not edit: change the ladder and build again.

-- AB_TON: on-delay timer of Allen-Bradley, BASE = 1 tick, SIZE = DINT
-- Fitted to PRE = 500.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_AB_TON_BASE1_DINT_PRE500 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    DN    : out std_logic
  );
end entity ab_part_count_AB_TON_BASE1_DINT_PRE500;

architecture rtl of ab_part_count_AB_TON_BASE1_DINT_PRE500 is
  signal ACC : unsigned(8 downto 0) := (others => '0');
  signal DN_reg : std_logic := '0';
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(8 downto 0);
  signal equal_2 : std_logic;
  signal DN_next : std_logic;
  signal ACC_next : unsigned(8 downto 0);
begin
  condition <= power and was and not DN_reg and tick;
  equal <= '1' when ACC = 500 else '0';
  sum <= ACC + (to_unsigned(0, 8) & (condition and not equal));
  equal_2 <= '1' when ACC = 499 else '0';
  DN_next <= power and (DN_reg or (condition and equal_2) or equal);
  ACC_next <= sum when power = '1' else to_unsigned(0, 9);

  DN <= DN_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        DN_reg <= '0';
        was <= '0';
      else
        ACC <= ACC_next;
        DN_reg <= DN_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- AB_CTU: up counter of Allen-Bradley, SIZE = DINT
-- Fitted to PRE = 1000.
-- Example, with PRE = 5, ACC = 32766:
-- IN        _#_#
-- DN        ####
-- OV        ____
-- ACC-32760 6778
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_AB_CTU_DINT_PRE1000 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    clear_after : in  std_logic;
    DN          : out std_logic
  );
end entity ab_part_count_AB_CTU_DINT_PRE1000;

architecture rtl of ab_part_count_AB_CTU_DINT_PRE1000 is
  signal ACC : unsigned(31 downto 0) := (others => '0');
  signal was_up : std_logic := '1';
  signal sum : unsigned(31 downto 0);
  signal ACC_next : unsigned(31 downto 0);
  signal was_up_next : std_logic;
begin
  sum <= ACC + (to_unsigned(0, 31) & (power and not was_up));
  ACC_next <= to_unsigned(0, 32) when clear_after = '1' else sum;
  was_up_next <= not clear_after and power;

  DN <= '1' when signed(sum) >= 1000 else '0';

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

-- TON: on-delay timer
-- Fitted to PT = 500 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_TON_PT500 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity ab_part_count_TON_PT500;

architecture rtl of ab_part_count_TON_PT500 is
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

-- CTU: up counter
-- Fitted to PV = 1000.
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- R   _________##____
-- Q   ___######____##
-- CV  011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_CTU_PV1000 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    R     : in  std_logic;
    Q     : out std_logic
  );
end entity ab_part_count_CTU_PV1000;

architecture rtl of ab_part_count_CTU_PV1000 is
  signal CV : unsigned(9 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal CV_is_1000 : std_logic := '0';
  signal condition : std_logic;
  signal sum : unsigned(9 downto 0);
  signal choice : unsigned(9 downto 0);
  signal CV_next : unsigned(9 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal CV_is_1000_next : std_logic;
begin
  condition <= power and not was and not CV_is_1000;
  sum <= CV + 1;
  choice <= sum when condition = '1' else CV;
  CV_next <= to_unsigned(0, 10) when R = '1' else choice;
  equal <= '1' when CV = 999 else '0';
  choice_2 <= equal when condition = '1' else CV_is_1000;
  CV_is_1000_next <= '0' when R = '1' else choice_2;

  Q <= CV_is_1000_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
        was <= '0';
        CV_is_1000 <= '0';
      else
        CV <= CV_next;
        was <= power;
        CV_is_1000 <= CV_is_1000_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count is
  port (
    clk                 : in  std_logic;
    rst                 : in  std_logic;
    tick                : in  std_logic;
    pump_run            : in  std_logic;
    part_present        : in  std_logic;
    clear               : in  std_logic;
    pump_on_for_a_while : out std_logic;
    batch_done          : out std_logic;
    siemens_pump        : out std_logic;
    siemens_batch       : out std_logic
  );
end entity ab_part_count;

architecture rtl of ab_part_count is
  signal pump_on_for_a_while_reg : std_logic := '0';
  signal batch_done_reg : std_logic := '0';
  signal siemens_pump_reg : std_logic := '0';
  signal siemens_batch_reg : std_logic := '0';
  signal delay_tmr_DN : std_logic;
  signal pump_on_for_a_while_next : std_logic;
  signal part_count_DN : std_logic;
  signal batch_done_next : std_logic;
  signal db1_Q : std_logic;
  signal siemens_pump_next : std_logic;
  signal db2_Q : std_logic;
  signal siemens_batch_next : std_logic;
begin

  -- rung 1 "Delay_Tmr", ab_part_count.ladder:8
  delay_tmr: entity work.ab_part_count_AB_TON_BASE1_DINT_PRE500
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pump_run,
      DN => delay_tmr_DN
    );

  -- rung 2, ab_part_count.ladder:11
  pump_on_for_a_while_next <= delay_tmr_DN;

  -- rung 3 "Part_Count", ab_part_count.ladder:13
  part_count: entity work.ab_part_count_AB_CTU_DINT_PRE1000
    port map (
      clk => clk,
      rst => rst,
      power => part_present,
      clear_after => clear,
      DN => part_count_DN
    );

  -- rung 4, ab_part_count.ladder:16
  batch_done_next <= part_count_DN;

  -- rung 5, ab_part_count.ladder:18

  -- rung 6 "DB1", ab_part_count.ladder:20
  db1: entity work.ab_part_count_TON_PT500
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pump_run,
      Q => db1_Q
    );
  siemens_pump_next <= db1_Q;

  -- rung 7 "DB2", ab_part_count.ladder:23
  db2: entity work.ab_part_count_CTU_PV1000
    port map (
      clk => clk,
      rst => rst,
      power => part_present,
      R => clear,
      Q => db2_Q
    );
  siemens_batch_next <= db2_Q;

  pump_on_for_a_while <= pump_on_for_a_while_reg;
  batch_done <= batch_done_reg;
  siemens_pump <= siemens_pump_reg;
  siemens_batch <= siemens_batch_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        pump_on_for_a_while_reg <= '0';
        batch_done_reg <= '0';
        siemens_pump_reg <= '0';
        siemens_batch_reg <= '0';
      else
        pump_on_for_a_while_reg <= pump_on_for_a_while_next;
        batch_done_reg <= batch_done_next;
        siemens_pump_reg <= siemens_pump_next;
        siemens_batch_reg <= siemens_batch_next;
      end if;
    end if;
  end process;
end architecture rtl;
