-- Made by hotrail 0.1.0 from wound_rotor_start.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 50 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity wound_rotor_start_TON_PT50 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity wound_rotor_start_TON_PT50;

architecture rtl of wound_rotor_start_TON_PT50 is
  signal ET : unsigned(5 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_50 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(5 downto 0);
  signal choice : unsigned(5 downto 0);
  signal ET_next : unsigned(5 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_50_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_50;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 6);
  equal <= '1' when ET = 49 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_50;
  ET_is_50_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_50_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_50 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_50 <= ET_is_50_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity wound_rotor_start is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    S0   : in  std_logic;
    S1   : in  std_logic;
    F1   : in  std_logic;
    K1   : out std_logic;
    K2   : out std_logic;
    K3   : out std_logic;
    K4   : out std_logic
  );
end entity wound_rotor_start;

architecture rtl of wound_rotor_start is
  signal K1_reg : std_logic := '0';
  signal K2_reg : std_logic := '0';
  signal K3_reg : std_logic := '0';
  signal K4_reg : std_logic := '0';
  signal K1_next : std_logic;
  signal first_Q : std_logic;
  signal second_Q : std_logic;
  signal third_Q : std_logic;
  signal K2_next : std_logic;
  signal K3_next : std_logic;
  signal K4_next : std_logic;
begin

  -- rung 1 "line", wound_rotor_start.ladder:13
  K1_next <= (S1 or K1_reg) and S0 and F1;

  -- rung 2 "resistors", wound_rotor_start.ladder:16
  first: entity work.wound_rotor_start_TON_PT50
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => K1_next,
      Q => first_Q
    );
  second: entity work.wound_rotor_start_TON_PT50
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => first_Q,
      Q => second_Q
    );
  third: entity work.wound_rotor_start_TON_PT50
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => second_Q,
      Q => third_Q
    );
  K2_next <= first_Q;
  K3_next <= second_Q;
  K4_next <= third_Q;

  K1 <= K1_reg;
  K2 <= K2_reg;
  K3 <= K3_reg;
  K4 <= K4_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        K1_reg <= '0';
        K2_reg <= '0';
        K3_reg <= '0';
        K4_reg <= '0';
      else
        K1_reg <= K1_next;
        K2_reg <= K2_next;
        K3_reg <= K3_next;
        K4_reg <= K4_next;
      end if;
    end if;
  end process;
end architecture rtl;
