-- Made by hotrail 0.1.0 from step_sequence.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 20 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity step_sequence_TON_PT20 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity step_sequence_TON_PT20;

architecture rtl of step_sequence_TON_PT20 is
  signal ET : unsigned(4 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_20 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(4 downto 0);
  signal choice : unsigned(4 downto 0);
  signal ET_next : unsigned(4 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_20_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_20;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 5);
  equal <= '1' when ET = 19 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_20;
  ET_is_20_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_20_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_20 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_20 <= ET_is_20_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity step_sequence is
  port (
    clk       : in  std_logic;
    rst       : in  std_logic;
    tick      : in  std_logic;
    start     : in  std_logic;
    clamped   : in  std_logic;
    deep      : in  std_logic;
    free      : in  std_logic;
    emergency : in  std_logic;
    clamp     : out std_logic;
    drill     : out std_logic;
    lift      : out std_logic;
    busy      : out std_logic
  );
end entity step_sequence;

architecture rtl of step_sequence is
  signal step : unsigned(2 downto 0) := (others => '0');
  signal start_before : std_logic := '0';
  signal clamp_reg : std_logic := '0';
  signal drill_reg : std_logic := '0';
  signal lift_reg : std_logic := '0';
  signal busy_reg : std_logic := '0';
  signal rung1_equal : std_logic;
  signal step_rung1 : unsigned(2 downto 0);
  signal up_time_power : std_logic;
  signal up_time_Q : std_logic;
  signal step_rung2 : unsigned(2 downto 0);
  signal rung3_equal : std_logic;
  signal step_rung3 : unsigned(2 downto 0);
  signal rung4_equal : std_logic;
  signal step_rung4 : unsigned(2 downto 0);
  signal rung5_equal : std_logic;
  signal step_rung5 : unsigned(2 downto 0);
  signal step_next : unsigned(2 downto 0);
  signal rung7_unequal : std_logic;
  signal rung7_unequal_2 : std_logic;
  signal clamp_next : std_logic;
  signal drill_next : std_logic;
  signal lift_next : std_logic;
  signal busy_next : std_logic;
begin

  -- rung 1 "part is free", step_sequence.ladder:16
  rung1_equal <= '1' when step = 4 else '0';
  step_rung1 <= to_unsigned(0, 3) when (rung1_equal and free) = '1' else step;

  -- rung 2 "drill is up", step_sequence.ladder:18
  up_time_power <= '1' when step_rung1 = 3 else '0';
  up_time: entity work.step_sequence_TON_PT20
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => up_time_power,
      Q => up_time_Q
    );
  step_rung2 <= to_unsigned(4, 3) when up_time_Q = '1' else step_rung1;

  -- rung 3 "hole is deep enough", step_sequence.ladder:20
  rung3_equal <= '1' when step_rung2 = 2 else '0';
  step_rung3 <= to_unsigned(3, 3) when (rung3_equal and deep) = '1' else step_rung2;

  -- rung 4 "part is held", step_sequence.ladder:22
  rung4_equal <= '1' when step_rung3 = 1 else '0';
  step_rung4 <= to_unsigned(2, 3) when (rung4_equal and clamped) = '1' else step_rung3;

  -- rung 5 "a new part", step_sequence.ladder:24
  rung5_equal <= '1' when step_rung4 = 0 else '0';
  step_rung5 <=
      to_unsigned(1, 3) when (rung5_equal and start and not start_before) = '1' else step_rung4;

  -- rung 6 "emergency: back to the start", step_sequence.ladder:27
  step_next <= to_unsigned(0, 3) when emergency = '1' else step_rung5;

  -- rung 7 "outputs of the steps", step_sequence.ladder:30
  rung7_unequal <= '1' when step_next /= 0 else '0';
  rung7_unequal_2 <= '1' when step_next /= 4 else '0';
  clamp_next <= rung7_unequal and rung7_unequal_2;
  drill_next <= '1' when step_next = 2 else '0';
  lift_next <= '1' when step_next = 3 else '0';
  busy_next <= '1' when step_next /= 0 else '0';

  clamp <= clamp_reg;
  drill <= drill_reg;
  lift <= lift_reg;
  busy <= busy_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        step <= (others => '0');
        start_before <= '0';
        clamp_reg <= '0';
        drill_reg <= '0';
        lift_reg <= '0';
        busy_reg <= '0';
      else
        step <= step_next;
        start_before <= start;
        clamp_reg <= clamp_next;
        drill_reg <= drill_next;
        lift_reg <= lift_next;
        busy_reg <= busy_next;
      end if;
    end if;
  end process;
end architecture rtl;
