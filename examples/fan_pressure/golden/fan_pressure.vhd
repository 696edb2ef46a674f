-- Made by hotrail 0.1.0 from fan_pressure.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 80 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity fan_pressure_TON_PT80 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    power  : in  std_logic;
    Q_last : out std_logic
  );
end entity fan_pressure_TON_PT80;

architecture rtl of fan_pressure_TON_PT80 is
  signal Q : std_logic := '0';
  signal ET : unsigned(6 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(6 downto 0);
  signal choice : unsigned(6 downto 0);
  signal ET_next : unsigned(6 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not Q;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 7);
  equal <= '1' when ET = 79 else '0';
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

entity fan_pressure is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    tick         : in  std_logic;
    start        : in  std_logic;
    stop         : in  std_logic;
    low_pressure : in  std_logic;
    fan          : out std_logic;
    tripped      : out std_logic
  );
end entity fan_pressure;

architecture rtl of fan_pressure is
  signal start_before : std_logic := '0';
  signal tripped_reg : std_logic := '0';
  signal fan_reg : std_logic := '0';
  signal tripped_rung1 : std_logic;
  signal up_to_speed_Q_last : std_logic;
  signal tripped_next : std_logic;
  signal fan_next : std_logic;
begin

  -- rung 1 "low pressure at full speed", fan_pressure.ladder:12
  tripped_rung1 <= tripped_reg and not (start and not start_before);

  -- rung 2, fan_pressure.ladder:14
  tripped_next <= (up_to_speed_Q_last and low_pressure) or tripped_rung1;

  -- rung 3 "fan", fan_pressure.ladder:16
  fan_next <= ((start and not start_before) or fan_reg) and stop and not tripped_next;
  up_to_speed: entity work.fan_pressure_TON_PT80
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => fan_next,
      Q_last => up_to_speed_Q_last
    );

  -- rung 4 "run-up", fan_pressure.ladder:19

  fan <= fan_reg;
  tripped <= tripped_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        start_before <= '0';
        tripped_reg <= '0';
        fan_reg <= '0';
      else
        start_before <= start;
        tripped_reg <= tripped_next;
        fan_reg <= fan_next;
      end if;
    end if;
  end process;
end architecture rtl;
