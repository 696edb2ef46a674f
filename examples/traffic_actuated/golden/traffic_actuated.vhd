-- Made by hotrail 0.1.0 from traffic_actuated.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 20 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_actuated_TON_PT20 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity traffic_actuated_TON_PT20;

architecture rtl of traffic_actuated_TON_PT20 is
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

-- TON: on-delay timer
-- Fitted to power = 1.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_actuated_TON_power1 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    PT          : in  unsigned(31 downto 0);
    clear_after : in  std_logic;
    Q           : out std_logic
  );
end entity traffic_actuated_TON_power1;

architecture rtl of traffic_actuated_TON_power1 is
  signal ET : unsigned(31 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal sum : unsigned(31 downto 0);
  signal choice : unsigned(31 downto 0);
  signal ET_next : unsigned(31 downto 0);
begin
  less <= '1' when signed(ET) < signed(PT) else '0';
  sum <= ET + (to_unsigned(0, 31) & (tick and less));
  choice <= sum when was = '1' else to_unsigned(0, 32);
  ET_next <= to_unsigned(0, 32) when clear_after = '1' else choice;

  Q <= '1' when signed(choice) >= signed(PT) else '0';

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

entity traffic_actuated is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    walk_button : in  std_logic;
    far_loop    : in  std_logic;
    near_loop   : in  std_logic;
    ns_green    : out std_logic;
    ns_yellow   : out std_logic;
    ns_red      : out std_logic;
    turn_green  : out std_logic;
    turn_yellow : out std_logic;
    turn_red    : out std_logic;
    ew_green    : out std_logic;
    ew_yellow   : out std_logic;
    ew_red      : out std_logic;
    walk        : out std_logic;
    walk_soon   : out std_logic
  );
end entity traffic_actuated;

architecture rtl of traffic_actuated is
  signal interval : unsigned(3 downto 0) := to_unsigned(9, 4);
  signal walk_soon_reg : std_logic := '0';
  signal turn_called : std_logic := '0';
  signal far_loop_before : std_logic := '0';
  signal on_the_way : std_logic := '0';
  signal near_loop_before : std_logic := '0';
  signal backed_up : std_logic := '0';
  signal timer_PT : unsigned(6 downto 0) := (others => '0');
  signal ns_green_reg : std_logic := '0';
  signal ns_yellow_reg : std_logic := '0';
  signal ns_red_reg : std_logic := '1';
  signal turn_green_reg : std_logic := '0';
  signal turn_yellow_reg : std_logic := '0';
  signal turn_red_reg : std_logic := '1';
  signal ew_green_reg : std_logic := '0';
  signal ew_yellow_reg : std_logic := '0';
  signal ew_red_reg : std_logic := '1';
  signal walk_reg : std_logic := '0';
  signal rung1_equal : std_logic;
  signal walk_soon_rung1 : std_logic;
  signal rung2_equal : std_logic;
  signal turn_called_rung2 : std_logic;
  signal on_the_way_rung3 : std_logic;
  signal slow_Q : std_logic;
  signal rung5_power : std_logic;
  signal on_the_way_next : std_logic;
  signal backed_up_rung5 : std_logic;
  signal rung6_equal : std_logic;
  signal rung6_equal_2 : std_logic;
  signal rung6_equal_3 : std_logic;
  signal timer_PT_rung6 : unsigned(6 downto 0);
  signal rung7_equal : std_logic;
  signal rung7_equal_2 : std_logic;
  signal rung7_equal_3 : std_logic;
  signal rung7_equal_4 : std_logic;
  signal timer_PT_rung7 : unsigned(6 downto 0);
  signal rung8_equal : std_logic;
  signal timer_PT_rung8 : unsigned(6 downto 0);
  signal timer_PT_rung9 : unsigned(6 downto 0);
  signal timer_PT_rung9_2 : unsigned(6 downto 0);
  signal rung10_equal : std_logic;
  signal timer_PT_rung10 : unsigned(6 downto 0);
  signal timer_PT_next : unsigned(6 downto 0);
  signal timer_PT_2 : unsigned(31 downto 0);
  signal next_rung12 : unsigned(3 downto 0);
  signal rung13_power : std_logic;
  signal next_rung13 : unsigned(3 downto 0);
  signal rung14_power : std_logic;
  signal next_rung14 : unsigned(3 downto 0);
  signal rung14_power_2 : std_logic;
  signal next_rung14_2 : unsigned(3 downto 0);
  signal next_u : unsigned(3 downto 0);
  signal timer_Q : std_logic;
  signal interval_next : unsigned(3 downto 0);
  signal rung17_choice : std_logic;
  signal walk_soon_next : std_logic;
  signal rung18_choice : std_logic;
  signal turn_called_next : std_logic;
  signal rung19_choice : std_logic;
  signal backed_up_next : std_logic;
  signal rung20_equal : std_logic;
  signal ns_green_next : std_logic;
  signal ns_yellow_next : std_logic;
  signal ns_red_next : std_logic;
  signal turn_green_next : std_logic;
  signal turn_yellow_next : std_logic;
  signal turn_red_next : std_logic;
  signal ew_green_next : std_logic;
  signal ew_yellow_next : std_logic;
  signal ew_red_next : std_logic;
  signal walk_next : std_logic;
begin

  -- rung 1 "a pedestrian waits", traffic_actuated.ladder:34
  rung1_equal <= '1' when interval = 10 else '0';
  walk_soon_rung1 <= (walk_button and not rung1_equal) or walk_soon_reg;

  -- rung 2 "a car waits in the turn lane", traffic_actuated.ladder:37
  rung2_equal <= '1' when interval = 4 else '0';
  turn_called_rung2 <= ((far_loop or near_loop) and not rung2_equal) or turn_called;

  -- rung 3 "a car that needs two seconds from loop to loop stands in a queue", traffic_actuated.ladder:40
  on_the_way_rung3 <= (far_loop and not far_loop_before) or on_the_way;

  -- rung 4, traffic_actuated.ladder:42
  slow: entity work.traffic_actuated_TON_PT20
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => on_the_way_rung3,
      Q => slow_Q
    );

  -- rung 5, traffic_actuated.ladder:43
  rung5_power <= near_loop and not near_loop_before;
  on_the_way_next <= on_the_way_rung3 and not rung5_power;
  backed_up_rung5 <= (rung5_power and on_the_way_rung3 and slow_Q) or backed_up;

  -- rung 6 "how long the interval lasts", traffic_actuated.ladder:45
  rung6_equal <= '1' when interval = 3 else '0';
  rung6_equal_2 <= '1' when interval = 6 else '0';
  rung6_equal_3 <= '1' when interval = 9 else '0';
  timer_PT_rung6 <=
      to_unsigned(10, 7) when (rung6_equal or rung6_equal_2 or rung6_equal_3) = '1' else timer_PT;

  -- rung 7, traffic_actuated.ladder:48
  rung7_equal <= '1' when interval = 2 else '0';
  rung7_equal_2 <= '1' when interval = 5 else '0';
  rung7_equal_3 <= '1' when interval = 8 else '0';
  rung7_equal_4 <= '1' when interval = 11 else '0';
  timer_PT_rung7 <=
      to_unsigned(30, 7)
      when (rung7_equal or rung7_equal_2 or rung7_equal_3 or rung7_equal_4) = '1'
      else timer_PT_rung6;

  -- rung 8, traffic_actuated.ladder:54
  rung8_equal <= '1' when interval = 1 else '0';
  timer_PT_rung8 <= to_unsigned(120, 7) when rung8_equal = '1' else timer_PT_rung7;

  -- rung 9, traffic_actuated.ladder:55
  timer_PT_rung9 <=
      to_unsigned(60, 7) when (rung2_equal and not backed_up_rung5) = '1' else timer_PT_rung8;
  timer_PT_rung9_2 <=
      to_unsigned(120, 7) when (rung2_equal and backed_up_rung5) = '1' else timer_PT_rung9;

  -- rung 10, traffic_actuated.ladder:56
  rung10_equal <= '1' when interval = 7 else '0';
  timer_PT_rung10 <= to_unsigned(100, 7) when rung10_equal = '1' else timer_PT_rung9_2;

  -- rung 11, traffic_actuated.ladder:57
  timer_PT_next <= to_unsigned(80, 7) when rung1_equal = '1' else timer_PT_rung10;
  timer_PT_2 <= resize(timer_PT_next, 32);

  -- rung 12 "which one comes next", traffic_actuated.ladder:59
  next_rung12 <= interval + 1;

  -- rung 13, traffic_actuated.ladder:61
  rung13_power <= rung6_equal and not turn_called_rung2;
  next_rung13 <= to_unsigned(7, 4) when rung13_power = '1' else next_rung12;

  -- rung 14, traffic_actuated.ladder:62
  rung14_power <= rung6_equal_3 and walk_soon_rung1;
  next_rung14 <= to_unsigned(10, 4) when rung14_power = '1' else next_rung13;
  rung14_power_2 <= rung6_equal_3 and not walk_soon_rung1;
  next_rung14_2 <= to_unsigned(1, 4) when rung14_power_2 = '1' else next_rung14;

  -- rung 15, traffic_actuated.ladder:63
  next_u <= to_unsigned(1, 4) when rung7_equal_4 = '1' else next_rung14_2;

  -- rung 16 "on to it", traffic_actuated.ladder:65
  timer: entity work.traffic_actuated_TON_power1
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      PT => timer_PT_2,
      clear_after => timer_Q,
      Q => timer_Q
    );
  interval_next <= next_u when timer_Q = '1' else interval;

  -- rung 17 "who is served waits no more", traffic_actuated.ladder:68
  rung17_choice <=
      not rung7_equal_4 and not rung14_power_2
       and (rung14_power or (not rung13_power and rung6_equal_3))
      when timer_Q = '1' else rung1_equal;
  walk_soon_next <= walk_soon_rung1 and not rung17_choice;

  -- rung 18, traffic_actuated.ladder:70
  rung18_choice <=
      not rung7_equal_4 and not rung14_power_2 and not rung14_power and not rung13_power
       and rung6_equal
      when timer_Q = '1' else rung2_equal;
  turn_called_next <= turn_called_rung2 and not rung18_choice;

  -- rung 19, traffic_actuated.ladder:71
  rung19_choice <=
      not rung7_equal_4 and not rung14_power_2 and not rung14_power and not rung13_power
       and rung2_equal
      when timer_Q = '1' else rung7_equal_2;
  backed_up_next <= backed_up_rung5 and not rung19_choice;

  -- rung 20 "north-south, straight on", traffic_actuated.ladder:73
  rung20_equal <= '1' when interval = 0 else '0';
  ns_green_next <=
      rung7_equal_4 or rung14_power_2 or (not rung14_power and not rung13_power and rung20_equal)
      when timer_Q = '1' else rung8_equal;

  -- rung 21, traffic_actuated.ladder:75
  ns_yellow_next <=
      not rung7_equal_4 and not rung14_power_2 and not rung14_power and not rung13_power
       and rung8_equal
      when timer_Q = '1' else rung7_equal;

  -- rung 22, traffic_actuated.ladder:76
  ns_red_next <= not ns_green_next and not ns_yellow_next;

  -- rung 23 "north-south, turning", traffic_actuated.ladder:78
  turn_green_next <=
      not rung7_equal_4 and not rung14_power_2 and not rung14_power and not rung13_power
       and rung6_equal
      when timer_Q = '1' else rung2_equal;

  -- rung 24, traffic_actuated.ladder:80
  turn_yellow_next <=
      not rung7_equal_4 and not rung14_power_2 and not rung14_power and not rung13_power
       and rung2_equal
      when timer_Q = '1' else rung7_equal_2;

  -- rung 25, traffic_actuated.ladder:81
  turn_red_next <= not turn_green_next and not turn_yellow_next;

  -- rung 26 "east-west", traffic_actuated.ladder:83
  ew_green_next <=
      not rung7_equal_4 and not rung14_power_2 and not rung14_power
       and (rung13_power or rung6_equal_2)
      when timer_Q = '1' else rung10_equal;

  -- rung 27, traffic_actuated.ladder:85
  ew_yellow_next <=
      not rung7_equal_4 and not rung14_power_2 and not rung14_power and not rung13_power
       and rung10_equal
      when timer_Q = '1' else rung7_equal_3;

  -- rung 28, traffic_actuated.ladder:86
  ew_red_next <= not ew_green_next and not ew_yellow_next;

  -- rung 29 "pedestrians", traffic_actuated.ladder:88
  walk_next <=
      not rung7_equal_4 and not rung14_power_2
       and (rung14_power or (not rung13_power and rung6_equal_3))
      when timer_Q = '1' else rung1_equal;

  ns_green <= ns_green_reg;
  ns_yellow <= ns_yellow_reg;
  ns_red <= ns_red_reg;
  turn_green <= turn_green_reg;
  turn_yellow <= turn_yellow_reg;
  turn_red <= turn_red_reg;
  ew_green <= ew_green_reg;
  ew_yellow <= ew_yellow_reg;
  ew_red <= ew_red_reg;
  walk <= walk_reg;
  walk_soon <= walk_soon_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        interval <= to_unsigned(9, 4);
        walk_soon_reg <= '0';
        turn_called <= '0';
        far_loop_before <= '0';
        on_the_way <= '0';
        near_loop_before <= '0';
        backed_up <= '0';
        timer_PT <= (others => '0');
        ns_green_reg <= '0';
        ns_yellow_reg <= '0';
        ns_red_reg <= '1';
        turn_green_reg <= '0';
        turn_yellow_reg <= '0';
        turn_red_reg <= '1';
        ew_green_reg <= '0';
        ew_yellow_reg <= '0';
        ew_red_reg <= '1';
        walk_reg <= '0';
      else
        interval <= interval_next;
        walk_soon_reg <= walk_soon_next;
        turn_called <= turn_called_next;
        far_loop_before <= far_loop;
        on_the_way <= on_the_way_next;
        near_loop_before <= near_loop;
        backed_up <= backed_up_next;
        timer_PT <= timer_PT_next;
        ns_green_reg <= ns_green_next;
        ns_yellow_reg <= ns_yellow_next;
        ns_red_reg <= ns_red_next;
        turn_green_reg <= turn_green_next;
        turn_yellow_reg <= turn_yellow_next;
        turn_red_reg <= turn_red_next;
        ew_green_reg <= ew_green_next;
        ew_yellow_reg <= ew_yellow_next;
        ew_red_reg <= ew_red_next;
        walk_reg <= walk_next;
      end if;
    end if;
  end process;
end architecture rtl;
