-- Made by hotrail 0.1.0 from pump_pressure.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 50 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity pump_pressure_TON_PT50 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    power  : in  std_logic;
    Q      : out std_logic;
    Q_last : out std_logic
  );
end entity pump_pressure_TON_PT50;

architecture rtl of pump_pressure_TON_PT50 is
  signal Q_reg : std_logic := '0';
  signal ET : unsigned(5 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(5 downto 0);
  signal choice : unsigned(5 downto 0);
  signal ET_next : unsigned(5 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not Q_reg;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 6);
  equal <= '1' when ET = 49 else '0';
  choice_2 <= equal when condition_2 = '1' else Q_reg;
  Q_next <= choice_2 when condition = '1' else '0';

  Q <= Q_next;
  Q_last <= Q_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        ET <= (others => '0');
        was <= '0';
      else
        Q_reg <= Q_next;
        ET <= ET_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity pump_pressure is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    tick         : in  std_logic;
    start        : in  std_logic;
    stop         : in  std_logic;
    pressure     : in  std_logic;
    pump         : out std_logic;
    low_pressure : out std_logic;
    tripped      : out std_logic
  );
end entity pump_pressure;

architecture rtl of pump_pressure is
  signal start_before : std_logic := '0';
  signal pump_reg : std_logic := '0';
  signal tripped_reg : std_logic := '0';
  signal low_pressure_reg : std_logic := '0';
  signal delay_Q : std_logic;
  signal delay_Q_last : std_logic;
  signal pump_next : std_logic;
  signal low_pressure_next : std_logic;
  signal tripped_rung3 : std_logic;
  signal tripped_next : std_logic;
begin

  -- rung 1 "pump", pump_pressure.ladder:13
  pump_next <=
      ((start and not start_before) or pump_reg) and stop and (pressure or not delay_Q_last);

  -- rung 2 "time to build up pressure, or to lose it", pump_pressure.ladder:16
  low_pressure_next <= pump_next and not pressure;
  delay: entity work.pump_pressure_TON_PT50
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => low_pressure_next,
      Q => delay_Q,
      Q_last => delay_Q_last
    );

  -- rung 3 "tell the operator why it stands", pump_pressure.ladder:19
  tripped_rung3 <= tripped_reg and not (start and not start_before);

  -- rung 4, pump_pressure.ladder:21
  tripped_next <= delay_Q or tripped_rung3;

  pump <= pump_reg;
  low_pressure <= low_pressure_reg;
  tripped <= tripped_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        start_before <= '0';
        pump_reg <= '0';
        tripped_reg <= '0';
        low_pressure_reg <= '0';
      else
        start_before <= start;
        pump_reg <= pump_next;
        tripped_reg <= tripped_next;
        low_pressure_reg <= low_pressure_next;
      end if;
    end if;
  end process;
end architecture rtl;
