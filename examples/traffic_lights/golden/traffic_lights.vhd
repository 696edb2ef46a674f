-- Made by hotrail 0.1.0 from traffic_lights.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to power = 1, PT = 120 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_lights_TON_power1_PT120 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    clear_after : in  std_logic;
    Q           : out std_logic
  );
end entity traffic_lights_TON_power1_PT120;

architecture rtl of traffic_lights_TON_power1_PT120 is
  signal ET : unsigned(6 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal equal : std_logic;
  signal sum : unsigned(6 downto 0);
  signal choice : unsigned(6 downto 0);
  signal equal_2 : std_logic;
  signal ET_next : unsigned(6 downto 0);
begin
  equal <= '1' when ET = 120 else '0';
  sum <= ET + (to_unsigned(0, 6) & (tick and not equal));
  choice <= sum when was = '1' else to_unsigned(0, 7);
  equal_2 <= '1' when ET = 119 else '0';
  ET_next <= to_unsigned(0, 7) when clear_after = '1' else choice;

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

-- TON: on-delay timer
-- Fitted to PT = 30 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_lights_TON_PT30 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity traffic_lights_TON_PT30;

architecture rtl of traffic_lights_TON_PT30 is
  signal ET : unsigned(4 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_30 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(4 downto 0);
  signal choice : unsigned(4 downto 0);
  signal ET_next : unsigned(4 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_30_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_30;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 5);
  equal <= '1' when ET = 29 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_30;
  ET_is_30_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_30_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_30 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_30 <= ET_is_30_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 60 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_lights_TON_PT60 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity traffic_lights_TON_PT60;

architecture rtl of traffic_lights_TON_PT60 is
  signal ET : unsigned(5 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_60 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(5 downto 0);
  signal choice : unsigned(5 downto 0);
  signal ET_next : unsigned(5 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_60_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_60;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 6);
  equal <= '1' when ET = 59 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_60;
  ET_is_60_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_60_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_60 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_60 <= ET_is_60_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 100 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_lights_TON_PT100 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity traffic_lights_TON_PT100;

architecture rtl of traffic_lights_TON_PT100 is
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

entity traffic_lights is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    ns_green    : out std_logic;
    ns_yellow   : out std_logic;
    ns_red      : out std_logic;
    turn_green  : out std_logic;
    turn_yellow : out std_logic;
    turn_red    : out std_logic;
    ew_green    : out std_logic;
    ew_yellow   : out std_logic;
    ew_red      : out std_logic
  );
end entity traffic_lights;

architecture rtl of traffic_lights is
  signal ns_green_reg : std_logic := '0';
  signal ns_yellow_reg : std_logic := '0';
  signal ns_red_reg : std_logic := '1';
  signal turn_green_reg : std_logic := '0';
  signal turn_yellow_reg : std_logic := '0';
  signal turn_red_reg : std_logic := '1';
  signal ew_green_reg : std_logic := '0';
  signal ew_yellow_reg : std_logic := '0';
  signal ew_red_reg : std_logic := '1';
  signal t1_Q : std_logic;
  signal t2_Q : std_logic;
  signal t3_Q : std_logic;
  signal t4_Q : std_logic;
  signal t5_Q : std_logic;
  signal t6_Q : std_logic;
  signal rung1_power : std_logic;
  signal ns_green_next : std_logic;
  signal ns_yellow_next : std_logic;
  signal turn_green_next : std_logic;
  signal turn_yellow_next : std_logic;
  signal ew_green_next : std_logic;
  signal ew_yellow_next : std_logic;
  signal ns_red_next : std_logic;
  signal turn_red_next : std_logic;
  signal ew_red_next : std_logic;
begin

  -- rung 1 "intervals 1 to 6", traffic_lights.ladder:13
  t2: entity work.traffic_lights_TON_PT30
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t1_Q,
      Q => t2_Q
    );
  t3: entity work.traffic_lights_TON_PT60
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t2_Q,
      Q => t3_Q
    );
  t4: entity work.traffic_lights_TON_PT30
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t3_Q,
      Q => t4_Q
    );
  t5: entity work.traffic_lights_TON_PT100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t4_Q,
      Q => t5_Q
    );
  t1: entity work.traffic_lights_TON_power1_PT120
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      clear_after => t6_Q,
      Q => t1_Q
    );
  t6: entity work.traffic_lights_TON_PT30
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t5_Q,
      Q => t6_Q
    );
  rung1_power <= not t6_Q and t1_Q;

  -- rung 2 "interval 1: north-south may go", traffic_lights.ladder:17
  ns_green_next <= not rung1_power;

  -- rung 3 "interval 2", traffic_lights.ladder:19
  ns_yellow_next <= rung1_power and not t2_Q;

  -- rung 4 "interval 3: north-south may turn", traffic_lights.ladder:21
  turn_green_next <= t2_Q and not t3_Q;

  -- rung 5 "interval 4", traffic_lights.ladder:23
  turn_yellow_next <= t3_Q and not t4_Q;

  -- rung 6 "interval 5: east-west may go", traffic_lights.ladder:25
  ew_green_next <= t4_Q and not t5_Q;

  -- rung 7 "interval 6", traffic_lights.ladder:27
  ew_yellow_next <= t5_Q and rung1_power;

  -- rung 8 "red whenever a lane has neither green nor yellow", traffic_lights.ladder:30
  ns_red_next <= rung1_power and t2_Q;

  -- rung 9, traffic_lights.ladder:32
  turn_red_next <= not turn_green_next and not turn_yellow_next;

  -- rung 10, traffic_lights.ladder:33
  ew_red_next <= not ew_green_next and not ew_yellow_next;

  ns_green <= ns_green_reg;
  ns_yellow <= ns_yellow_reg;
  ns_red <= ns_red_reg;
  turn_green <= turn_green_reg;
  turn_yellow <= turn_yellow_reg;
  turn_red <= turn_red_reg;
  ew_green <= ew_green_reg;
  ew_yellow <= ew_yellow_reg;
  ew_red <= ew_red_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ns_green_reg <= '0';
        ns_yellow_reg <= '0';
        ns_red_reg <= '1';
        turn_green_reg <= '0';
        turn_yellow_reg <= '0';
        turn_red_reg <= '1';
        ew_green_reg <= '0';
        ew_yellow_reg <= '0';
        ew_red_reg <= '1';
      else
        ns_green_reg <= ns_green_next;
        ns_yellow_reg <= ns_yellow_next;
        ns_red_reg <= ns_red_next;
        turn_green_reg <= turn_green_next;
        turn_yellow_reg <= turn_yellow_next;
        turn_red_reg <= turn_red_next;
        ew_green_reg <= ew_green_next;
        ew_yellow_reg <= ew_yellow_next;
        ew_red_reg <= ew_red_next;
      end if;
    end if;
  end process;
end architecture rtl;
