-- Made by hotrail 0.1.0 from ab_seal.ladder. Do not edit: change the ladder and build again.

-- AB_TON: on-delay timer of Allen-Bradley, BASE = 1 tick, SIZE = DINT
-- Fitted to PRE = 2000.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_seal_AB_TON_BASE1_DINT_PRE2000 is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    tick    : in  std_logic;
    power   : in  std_logic;
    EN      : out std_logic;
    EN_last : out std_logic;
    DN      : out std_logic
  );
end entity ab_seal_AB_TON_BASE1_DINT_PRE2000;

architecture rtl of ab_seal_AB_TON_BASE1_DINT_PRE2000 is
  signal ACC : unsigned(10 downto 0) := (others => '0');
  signal EN_reg : std_logic := '0';
  signal DN_reg : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(10 downto 0);
  signal equal_2 : std_logic;
  signal DN_next : std_logic;
  signal ACC_next : unsigned(10 downto 0);
begin
  condition <= power and EN_reg and not DN_reg and tick;
  equal <= '1' when ACC = 2000 else '0';
  sum <= ACC + (to_unsigned(0, 10) & (condition and not equal));
  equal_2 <= '1' when ACC = 1999 else '0';
  DN_next <= power and (DN_reg or (condition and equal_2) or equal);
  ACC_next <= sum when power = '1' else to_unsigned(0, 11);

  EN <= power;
  EN_last <= EN_reg;
  DN <= DN_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        EN_reg <= '0';
        DN_reg <= '0';
      else
        ACC <= ACC_next;
        EN_reg <= power;
        DN_reg <= DN_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 2000 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_seal_TON_PT2000 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity ab_seal_TON_PT2000;

architecture rtl of ab_seal_TON_PT2000 is
  signal ET : unsigned(10 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_2000 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(10 downto 0);
  signal choice : unsigned(10 downto 0);
  signal ET_next : unsigned(10 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_2000_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_2000;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 11);
  equal <= '1' when ET = 1999 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_2000;
  ET_is_2000_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_2000_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_2000 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_2000 <= ET_is_2000_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_seal is
  port (
    clk               : in  std_logic;
    rst               : in  std_logic;
    tick              : in  std_logic;
    start_pb          : in  std_logic;
    stop_pb           : in  std_logic;
    motor             : out std_logic;
    next_step         : out std_logic;
    siemens_motor     : out std_logic;
    siemens_next_step : out std_logic
  );
end entity ab_seal;

architecture rtl of ab_seal is
  signal siemens_motor_reg : std_logic := '0';
  signal motor_reg : std_logic := '0';
  signal next_step_reg : std_logic := '0';
  signal siemens_next_step_reg : std_logic := '0';
  signal delay_tmr_EN : std_logic;
  signal delay_tmr_EN_last : std_logic;
  signal delay_tmr_DN : std_logic;
  signal delay_tmr_power : std_logic;
  signal motor_next : std_logic;
  signal next_step_next : std_logic;
  signal siemens_motor_next : std_logic;
  signal t1_Q : std_logic;
  signal siemens_next_step_next : std_logic;
begin

  -- rung 1 "Delay_Tmr seals itself in", ab_seal.ladder:9
  delay_tmr_power <= (start_pb or delay_tmr_EN_last) and stop_pb;
  delay_tmr: entity work.ab_seal_AB_TON_BASE1_DINT_PRE2000
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => delay_tmr_power,
      EN => delay_tmr_EN,
      EN_last => delay_tmr_EN_last,
      DN => delay_tmr_DN
    );

  -- rung 2, ab_seal.ladder:12
  motor_next <= delay_tmr_EN;

  -- rung 3, ab_seal.ladder:14
  next_step_next <= delay_tmr_DN;

  -- rung 4 "the same with Siemens' timer, which has no EN: a coil seals", ab_seal.ladder:16
  siemens_motor_next <= (start_pb or siemens_motor_reg) and stop_pb;
  t1: entity work.ab_seal_TON_PT2000
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => siemens_motor_next,
      Q => t1_Q
    );
  siemens_next_step_next <= t1_Q;

  motor <= motor_reg;
  next_step <= next_step_reg;
  siemens_motor <= siemens_motor_reg;
  siemens_next_step <= siemens_next_step_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        siemens_motor_reg <= '0';
        motor_reg <= '0';
        next_step_reg <= '0';
        siemens_next_step_reg <= '0';
      else
        siemens_motor_reg <= siemens_motor_next;
        motor_reg <= motor_next;
        next_step_reg <= next_step_next;
        siemens_next_step_reg <= siemens_next_step_next;
      end if;
    end if;
  end process;
end architecture rtl;
