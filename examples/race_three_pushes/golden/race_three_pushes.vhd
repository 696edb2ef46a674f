-- Made by hotrail 0.1.0 from race_three_pushes.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to power = 1, PT = 20 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity race_three_pushes_TON_power1_PT20 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    clear_after : in  std_logic;
    Q           : out std_logic
  );
end entity race_three_pushes_TON_power1_PT20;

architecture rtl of race_three_pushes_TON_power1_PT20 is
  signal ET : unsigned(4 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal equal : std_logic;
  signal sum : unsigned(4 downto 0);
  signal choice : unsigned(4 downto 0);
  signal equal_2 : std_logic;
  signal ET_next : unsigned(4 downto 0);
begin
  equal <= '1' when ET = 20 else '0';
  sum <= ET + (to_unsigned(0, 4) & (tick and not equal));
  choice <= sum when was = '1' else to_unsigned(0, 5);
  equal_2 <= '1' when ET = 19 else '0';
  ET_next <= to_unsigned(0, 5) when clear_after = '1' else choice;

  Q <= was and ((tick and equal_2) or equal);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
      else
        ET <= ET_next;
        was <= '1';
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity race_three_pushes is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    button : in  std_logic;
    clear  : in  std_logic;
    won    : out std_logic
  );
end entity race_three_pushes;

architecture rtl of race_three_pushes is
  signal button_before : std_logic := '0';
  signal turn_b : std_logic := '0';
  signal seen_a : std_logic := '0';
  signal seen_b : std_logic := '0';
  signal won_reg : std_logic := '0';
  signal pushed : std_logic;
  signal age_a_Q : std_logic;
  signal age_b_Q : std_logic;
  signal won_rung4 : std_logic;
  signal age_a_clear_after : std_logic;
  signal seen_a_rung5 : std_logic;
  signal age_b_clear_after : std_logic;
  signal seen_b_rung5 : std_logic;
  signal turn_b_next : std_logic;
  signal won_next : std_logic;
  signal seen_a_next : std_logic;
  signal seen_b_next : std_logic;
begin

  -- rung 1 "a push", race_three_pushes.ladder:14
  pushed <= button and not button_before;

  -- rung 2 "how long ago the last pushes were", race_three_pushes.ladder:17

  -- rung 3, race_three_pushes.ladder:19

  -- rung 4 "the last but one is less than two seconds old", race_three_pushes.ladder:21
  won_rung4 <=
      (pushed and ((not turn_b and seen_a and not age_a_Q) or (turn_b and seen_b and not age_b_Q)))
      or won_reg;

  -- rung 5 "this push takes its place", race_three_pushes.ladder:24
  age_a_clear_after <= pushed and not turn_b;
  age_a: entity work.race_three_pushes_TON_power1_PT20
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      clear_after => age_a_clear_after,
      Q => age_a_Q
    );
  seen_a_rung5 <= age_a_clear_after or seen_a;
  age_b_clear_after <= pushed and turn_b;
  age_b: entity work.race_three_pushes_TON_power1_PT20
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      clear_after => age_b_clear_after,
      Q => age_b_Q
    );
  seen_b_rung5 <= age_b_clear_after or seen_b;
  turn_b_next <= not turn_b when (age_a_clear_after or age_b_clear_after) = '1' else turn_b;

  -- rung 6 "clear", race_three_pushes.ladder:27
  won_next <= '0' when clear = '1' else won_rung4;
  seen_a_next <= '0' when clear = '1' else seen_a_rung5;
  seen_b_next <= '0' when clear = '1' else seen_b_rung5;

  won <= won_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        button_before <= '0';
        turn_b <= '0';
        seen_a <= '0';
        seen_b <= '0';
        won_reg <= '0';
      else
        button_before <= button;
        turn_b <= turn_b_next;
        seen_a <= seen_a_next;
        seen_b <= seen_b_next;
        won_reg <= won_next;
      end if;
    end if;
  end process;
end architecture rtl;
