-- Made by hotrail 0.1.0 from conveyor_zero_speed.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 25 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_zero_speed_TON_PT25 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    power  : in  std_logic;
    Q_last : out std_logic
  );
end entity conveyor_zero_speed_TON_PT25;

architecture rtl of conveyor_zero_speed_TON_PT25 is
  signal Q : std_logic := '0';
  signal ET : unsigned(4 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(4 downto 0);
  signal choice : unsigned(4 downto 0);
  signal ET_next : unsigned(4 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not Q;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 5);
  equal <= '1' when ET = 24 else '0';
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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_zero_speed is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    start : in  std_logic;
    stop  : in  std_logic;
    bolt  : in  std_logic;
    motor : out std_logic;
    fault : out std_logic
  );
end entity conveyor_zero_speed;

architecture rtl of conveyor_zero_speed is
  signal start_before : std_logic := '0';
  signal fault_reg : std_logic := '0';
  signal motor_reg : std_logic := '0';
  signal fault_rung1 : std_logic;
  signal bolt_stays_Q_last : std_logic;
  signal bolt_missing_Q_last : std_logic;
  signal fault_next : std_logic;
  signal motor_next : std_logic;
  signal bolt_stays_power : std_logic;
  signal bolt_missing_power : std_logic;
begin

  -- rung 1 "the shaft stands", conveyor_zero_speed.ladder:15
  fault_rung1 <= fault_reg and not (start and not start_before);

  -- rung 2, conveyor_zero_speed.ladder:17
  fault_next <= bolt_stays_Q_last or bolt_missing_Q_last or fault_rung1;

  -- rung 3 "motor", conveyor_zero_speed.ladder:19
  motor_next <= ((start and not start_before) or motor_reg) and stop and not fault_next;

  -- rung 4 "on for too long", conveyor_zero_speed.ladder:22
  bolt_stays_power <= motor_next and bolt;
  bolt_stays: entity work.conveyor_zero_speed_TON_PT25
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => bolt_stays_power,
      Q_last => bolt_stays_Q_last
    );

  -- rung 5 "off for too long", conveyor_zero_speed.ladder:25
  bolt_missing_power <= motor_next and not bolt;
  bolt_missing: entity work.conveyor_zero_speed_TON_PT25
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => bolt_missing_power,
      Q_last => bolt_missing_Q_last
    );

  motor <= motor_reg;
  fault <= fault_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        start_before <= '0';
        fault_reg <= '0';
        motor_reg <= '0';
      else
        start_before <= start;
        fault_reg <= fault_next;
        motor_reg <= motor_next;
      end if;
    end if;
  end process;
end architecture rtl;
