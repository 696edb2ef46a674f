-- Made by hotrail 0.1.0 from motor_monitor.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 100 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity motor_monitor_TON_PT100 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity motor_monitor_TON_PT100;

architecture rtl of motor_monitor_TON_PT100 is
  signal ET : unsigned(6 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_100 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(6 downto 0);
  signal choice : unsigned(6 downto 0);
  signal ET_next : unsigned(6 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_100_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_100;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 7);
  equal <= '1' when ET = 99 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_100;
  ET_is_100_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_100_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_100 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_100 <= ET_is_100_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity motor_monitor is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    S1          : in  std_logic;
    turns_1     : in  std_logic;
    turns_2     : in  std_logic;
    turns_3     : in  std_logic;
    acknowledge : in  std_logic;
    fault       : out std_logic
  );
end entity motor_monitor;

architecture rtl of motor_monitor is
  signal acknowledge_before : std_logic := '0';
  signal fault_reg : std_logic := '0';
  signal fault_rung1 : std_logic;
  signal two_power : std_logic;
  signal two_Q : std_logic;
  signal fault_rung2 : std_logic;
  signal fault_next : std_logic;
begin

  -- rung 1 "acknowledged", motor_monitor.ladder:12
  fault_rung1 <= fault_reg and not (acknowledge and not acknowledge_before);

  -- rung 2 "two of three for ten seconds", motor_monitor.ladder:15
  two_power <=
      S1
      and ((not turns_1 and not turns_2) or (not turns_1 and not turns_3)
           or (not turns_2 and not turns_3));
  two: entity work.motor_monitor_TON_PT100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => two_power,
      Q => two_Q
    );
  fault_rung2 <= two_Q or fault_rung1;

  -- rung 3 "all three", motor_monitor.ladder:18
  fault_next <= (S1 and not turns_1 and not turns_2 and not turns_3) or fault_rung2;

  fault <= fault_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        acknowledge_before <= '0';
        fault_reg <= '0';
      else
        acknowledge_before <= acknowledge;
        fault_reg <= fault_next;
      end if;
    end if;
  end process;
end architecture rtl;
