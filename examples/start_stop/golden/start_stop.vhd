-- Made by hotrail 0.1.0 from start_stop.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 5000 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity start_stop_TON_PT5000 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity start_stop_TON_PT5000;

architecture rtl of start_stop_TON_PT5000 is
  signal ET : unsigned(12 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_5000 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(12 downto 0);
  signal choice : unsigned(12 downto 0);
  signal ET_next : unsigned(12 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_5000_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_5000;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 13);
  equal <= '1' when ET = 4999 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_5000;
  ET_is_5000_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_5000_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_5000 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_5000 <= ET_is_5000_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity start_stop is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    start : in  std_logic;
    stop  : in  std_logic;
    motor : out std_logic;
    lamp  : out std_logic
  );
end entity start_stop;

architecture rtl of start_stop is
  signal motor_reg : std_logic := '0';
  signal lamp_reg : std_logic := '0';
  signal motor_next : std_logic;
  signal delay_Q : std_logic;
  signal lamp_next : std_logic;
begin

  -- rung 1 "seal-in", start_stop.ladder:7
  motor_next <= (start or motor_reg) and not stop;

  -- rung 2 "lamp after five seconds", start_stop.ladder:10
  delay: entity work.start_stop_TON_PT5000
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => motor_next,
      Q => delay_Q
    );
  lamp_next <= delay_Q;

  motor <= motor_reg;
  lamp <= lamp_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        motor_reg <= '0';
        lamp_reg <= '0';
      else
        motor_reg <= motor_next;
        lamp_reg <= lamp_next;
      end if;
    end if;
  end process;
end architecture rtl;
