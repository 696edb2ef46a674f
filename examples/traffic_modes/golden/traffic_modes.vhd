-- Made by hotrail 0.1.0 from traffic_modes.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to power = 1.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_modes_TON_power1 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    PT          : in  unsigned(31 downto 0);
    clear_after : in  std_logic;
    Q           : out std_logic;
    ET          : out unsigned(31 downto 0)
  );
end entity traffic_modes_TON_power1;

architecture rtl of traffic_modes_TON_power1 is
  signal ET_reg : unsigned(31 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal sum : unsigned(31 downto 0);
  signal ET_value : unsigned(31 downto 0);
  signal ET_next : unsigned(31 downto 0);
begin
  less <= '1' when signed(ET_reg) < signed(PT) else '0';
  sum <= ET_reg + (to_unsigned(0, 31) & (tick and less));
  ET_value <= sum when was = '1' else to_unsigned(0, 32);
  ET_next <= to_unsigned(0, 32) when clear_after = '1' else ET_value;

  Q <= '1' when signed(ET_value) >= signed(PT) else '0';
  ET <= ET_value;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET_reg <= (others => '0');
        was <= '0';
      else
        ET_reg <= ET_next;
        was <= '1';
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_modes is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    rush_hour   : in  std_logic;
    late_night  : in  std_logic;
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
end entity traffic_modes;

architecture rtl of traffic_modes is
  signal interval : unsigned(15 downto 0) := to_unsigned(9, 16);
  signal timer_PT : unsigned(6 downto 0) := (others => '0');
  signal interval_is_2 : std_logic := '0';
  signal interval_is_5 : std_logic := '0';
  signal ew_yellow_reg : std_logic := '0';
  signal interval_is_10 : std_logic := '0';
  signal ns_green_reg : std_logic := '0';
  signal turn_green_reg : std_logic := '0';
  signal ew_green_reg : std_logic := '0';
  signal ns_yellow_reg : std_logic := '0';
  signal ns_red_reg : std_logic := '1';
  signal turn_yellow_reg : std_logic := '0';
  signal turn_red_reg : std_logic := '1';
  signal ew_red_reg : std_logic := '1';
  signal rung1_equal : std_logic;
  signal rung1_equal_2 : std_logic;
  signal rung1_equal_3 : std_logic;
  signal timer_PT_rung1 : unsigned(6 downto 0);
  signal timer_PT_rung2 : unsigned(6 downto 0);
  signal timer_PT_rung3 : unsigned(6 downto 0);
  signal timer_PT_rung4 : unsigned(6 downto 0);
  signal timer_PT_rung5 : unsigned(6 downto 0);
  signal timer_PT_next : unsigned(6 downto 0);
  signal timer_PT_2 : unsigned(31 downto 0);
  signal next_rung7 : unsigned(15 downto 0);
  signal rung8_power : std_logic;
  signal next_rung8 : unsigned(15 downto 0);
  signal rung9_power : std_logic;
  signal next_rung9 : unsigned(15 downto 0);
  signal rung10_power : std_logic;
  signal next_rung10 : unsigned(15 downto 0);
  signal rung10_power_2 : std_logic;
  signal next_u : unsigned(15 downto 0);
  signal timer_Q : std_logic;
  signal timer_ET : unsigned(31 downto 0);
  signal rung11_choice : unsigned(31 downto 0);
  signal interval_next : unsigned(15 downto 0);
  signal rung12_choice : std_logic;
  signal rung12_less : std_logic;
  signal blink : std_logic;
  signal rung13_equal : std_logic;
  signal ns_green_next : std_logic;
  signal interval_is_2_next : std_logic;
  signal ns_yellow_next : std_logic;
  signal rung15_choice : std_logic;
  signal ns_red_next : std_logic;
  signal turn_green_next : std_logic;
  signal interval_is_5_next : std_logic;
  signal turn_yellow_next : std_logic;
  signal rung18_choice : std_logic;
  signal turn_red_next : std_logic;
  signal ew_green_next : std_logic;
  signal ew_yellow_next : std_logic;
  signal interval_is_10_next : std_logic;
  signal ew_red_next : std_logic;
begin

  -- rung 1 "how long the interval lasts", traffic_modes.ladder:28
  rung1_equal <= '1' when interval = 3 else '0';
  rung1_equal_2 <= '1' when interval = 6 else '0';
  rung1_equal_3 <= '1' when interval = 9 else '0';
  timer_PT_rung1 <=
      to_unsigned(10, 7) when (rung1_equal or rung1_equal_2 or rung1_equal_3) = '1' else timer_PT;

  -- rung 2, traffic_modes.ladder:31
  timer_PT_rung2 <=
      to_unsigned(30, 7) when (interval_is_2 or interval_is_5 or ew_yellow_reg) = '1'
      else timer_PT_rung1;

  -- rung 3, traffic_modes.ladder:34
  timer_PT_rung3 <= to_unsigned(10, 7) when interval_is_10 = '1' else timer_PT_rung2;

  -- rung 4, traffic_modes.ladder:35
  timer_PT_rung4 <= to_unsigned(120, 7) when ns_green_reg = '1' else timer_PT_rung3;

  -- rung 5, traffic_modes.ladder:36
  timer_PT_rung5 <= to_unsigned(60, 7) when turn_green_reg = '1' else timer_PT_rung4;

  -- rung 6, traffic_modes.ladder:37
  timer_PT_next <= to_unsigned(100, 7) when ew_green_reg = '1' else timer_PT_rung5;
  timer_PT_2 <= resize(timer_PT_next, 32);

  -- rung 7 "which one comes next", traffic_modes.ladder:39
  next_rung7 <= interval + 1;

  -- rung 8, traffic_modes.ladder:41
  rung8_power <= rung1_equal and rush_hour;
  next_rung8 <= to_unsigned(7, 16) when rung8_power = '1' else next_rung7;

  -- rung 9, traffic_modes.ladder:42
  rung9_power <= rung1_equal_3 and not late_night;
  next_rung9 <= to_unsigned(1, 16) when rung9_power = '1' else next_rung8;

  -- rung 10, traffic_modes.ladder:43
  rung10_power <= interval_is_10 and late_night;
  next_rung10 <= to_unsigned(10, 16) when rung10_power = '1' else next_rung9;
  rung10_power_2 <= interval_is_10 and not late_night;
  next_u <= to_unsigned(9, 16) when rung10_power_2 = '1' else next_rung10;

  -- rung 11 "on to it", traffic_modes.ladder:45
  timer: entity work.traffic_modes_TON_power1
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      PT => timer_PT_2,
      clear_after => timer_Q,
      Q => timer_Q,
      ET => timer_ET
    );
  rung11_choice <= to_unsigned(0, 32) when timer_Q = '1' else timer_ET;
  interval_next <= next_u when timer_Q = '1' else interval;

  -- rung 12 "blink for half a second in each second", traffic_modes.ladder:48
  rung12_choice <=
      not rung10_power_2
       and (rung10_power or (not rung9_power and not rung8_power and rung1_equal_3))
      when timer_Q = '1' else interval_is_10;
  rung12_less <= '1' when signed(rung11_choice) < 5 else '0';
  blink <= rung12_choice and rung12_less;

  -- rung 13 "north-south, straight on", traffic_modes.ladder:51
  rung13_equal <= '1' when interval = 0 else '0';
  ns_green_next <=
      not rung10_power_2 and not rung10_power
       and (rung9_power or (not rung8_power and rung13_equal))
      when timer_Q = '1' else ns_green_reg;

  -- rung 14, traffic_modes.ladder:53
  interval_is_2_next <=
      not rung10_power_2 and not rung10_power and not rung9_power and not rung8_power
       and ns_green_reg
      when timer_Q = '1' else interval_is_2;
  ns_yellow_next <= '1' when blink = '1' else interval_is_2_next;

  -- rung 15, traffic_modes.ladder:54
  rung15_choice <=
      not rung10_power_2
       and (rung10_power or (not rung9_power and not rung8_power and rung1_equal_3))
      when timer_Q = '1' else interval_is_10;
  ns_red_next <= not rung15_choice and not ns_green_next and not ns_yellow_next;

  -- rung 16 "north-south, turning", traffic_modes.ladder:56
  turn_green_next <=
      not rung10_power_2 and not rung10_power and not rung9_power and not rung8_power
       and rung1_equal
      when timer_Q = '1' else turn_green_reg;

  -- rung 17, traffic_modes.ladder:58
  interval_is_5_next <=
      not rung10_power_2 and not rung10_power and not rung9_power and not rung8_power
       and turn_green_reg
      when timer_Q = '1' else interval_is_5;
  turn_yellow_next <= '1' when blink = '1' else interval_is_5_next;

  -- rung 18, traffic_modes.ladder:59
  rung18_choice <=
      not rung10_power_2
       and (rung10_power or (not rung9_power and not rung8_power and rung1_equal_3))
      when timer_Q = '1' else interval_is_10;
  turn_red_next <= not rung18_choice and not turn_green_next and not turn_yellow_next;

  -- rung 19 "east-west", traffic_modes.ladder:61
  ew_green_next <=
      not rung10_power_2 and not rung10_power and not rung9_power
       and (rung8_power or rung1_equal_2)
      when timer_Q = '1' else ew_green_reg;

  -- rung 20, traffic_modes.ladder:63
  ew_yellow_next <=
      not rung10_power_2 and not rung10_power and not rung9_power and not rung8_power
       and ew_green_reg
      when timer_Q = '1' else ew_yellow_reg;

  -- rung 21, traffic_modes.ladder:64
  interval_is_10_next <=
      not rung10_power_2
       and (rung10_power or (not rung9_power and not rung8_power and rung1_equal_3))
      when timer_Q = '1' else interval_is_10;
  ew_red_next <=
      '1' when blink = '1'
      else not interval_is_10_next and not ew_green_next and not ew_yellow_next;

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
        interval <= to_unsigned(9, 16);
        timer_PT <= (others => '0');
        interval_is_2 <= '0';
        interval_is_5 <= '0';
        ew_yellow_reg <= '0';
        interval_is_10 <= '0';
        ns_green_reg <= '0';
        turn_green_reg <= '0';
        ew_green_reg <= '0';
        ns_yellow_reg <= '0';
        ns_red_reg <= '1';
        turn_yellow_reg <= '0';
        turn_red_reg <= '1';
        ew_red_reg <= '1';
      else
        interval <= interval_next;
        timer_PT <= timer_PT_next;
        interval_is_2 <= interval_is_2_next;
        interval_is_5 <= interval_is_5_next;
        ew_yellow_reg <= ew_yellow_next;
        interval_is_10 <= interval_is_10_next;
        ns_green_reg <= ns_green_next;
        turn_green_reg <= turn_green_next;
        ew_green_reg <= ew_green_next;
        ns_yellow_reg <= ns_yellow_next;
        ns_red_reg <= ns_red_next;
        turn_yellow_reg <= turn_yellow_next;
        turn_red_reg <= turn_red_next;
        ew_red_reg <= ew_red_next;
      end if;
    end if;
  end process;
end architecture rtl;
