-- Made by hotrail 0.1.0 from traffic_lights.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- TON: on-delay timer
-- Fitted to power = 1, PT = 120 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_lights_test_TON_power1_PT120 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    clear_after : in  std_logic;
    Q           : out std_logic;
    ET_last     : out unsigned(6 downto 0)
  );
end entity traffic_lights_test_TON_power1_PT120;

architecture rtl of traffic_lights_test_TON_power1_PT120 is
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
  ET_last <= ET;

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

entity traffic_lights_test_TON_PT30 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity traffic_lights_test_TON_PT30;

architecture rtl of traffic_lights_test_TON_PT30 is
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

entity traffic_lights_test_TON_PT60 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity traffic_lights_test_TON_PT60;

architecture rtl of traffic_lights_test_TON_PT60 is
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

entity traffic_lights_test_TON_PT100 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity traffic_lights_test_TON_PT100;

architecture rtl of traffic_lights_test_TON_PT100 is
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

entity traffic_lights_test is
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
    ew_red      : out std_logic;
    t1_ET       : out std_logic_vector(31 downto 0)
  );
end entity traffic_lights_test;

architecture rtl of traffic_lights_test is
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
  signal t1_ET_last : unsigned(6 downto 0);
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
  signal t1_ET_value : unsigned(31 downto 0);
begin

  -- rung 1 "intervals 1 to 6", traffic_lights.ladder:13
  t2: entity work.traffic_lights_test_TON_PT30
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t1_Q,
      Q => t2_Q
    );
  t3: entity work.traffic_lights_test_TON_PT60
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t2_Q,
      Q => t3_Q
    );
  t4: entity work.traffic_lights_test_TON_PT30
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t3_Q,
      Q => t4_Q
    );
  t5: entity work.traffic_lights_test_TON_PT100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => t4_Q,
      Q => t5_Q
    );
  t1: entity work.traffic_lights_test_TON_power1_PT120
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      clear_after => t6_Q,
      Q => t1_Q,
      ET_last => t1_ET_last
    );
  t6: entity work.traffic_lights_test_TON_PT30
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
  t1_ET_value <= resize(t1_ET_last, 32);

  ns_green <= ns_green_reg;
  ns_yellow <= ns_yellow_reg;
  ns_red <= ns_red_reg;
  turn_green <= turn_green_reg;
  turn_yellow <= turn_yellow_reg;
  turn_red <= turn_red_reg;
  ew_green <= ew_green_reg;
  ew_yellow <= ew_yellow_reg;
  ew_red <= ew_red_reg;
  t1_ET <= std_logic_vector(t1_ET_value);

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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity traffic_lights_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    ns_red      : in  std_logic;
    turn_red    : in  std_logic;
    ew_red      : in  std_logic;
    ns_green    : in  std_logic;
    ns_yellow   : in  std_logic;
    turn_green  : in  std_logic;
    turn_yellow : in  std_logic;
    ew_green    : in  std_logic;
    ew_yellow   : in  std_logic;
    t1_ET       : in  std_logic_vector(31 downto 0);
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_1_2  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_2_2  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_3_2  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_4_2  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_5_2  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_6_2  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_7_2  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_8_2  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_9_2  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_10_2 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_11_2 : out std_logic;
    expect_12_0 : out std_logic;
    expect_12_1 : out std_logic;
    expect_12_2 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic;
    expect_17_1 : out std_logic;
    expect_18_0 : out std_logic
  );
end entity traffic_lights_expect;

architecture rtl of traffic_lights_expect is
begin

  expect_0_0 <= ns_red;
  expect_0_1 <= turn_red;
  expect_0_2 <= ew_red;
  expect_1_0 <= ns_green;
  expect_1_1 <= turn_red;
  expect_1_2 <= ew_red;
  expect_2_0 <= ns_green;
  expect_2_1 <= turn_red;
  expect_2_2 <= ew_red;
  expect_3_0 <= ns_yellow;
  expect_3_1 <= turn_red;
  expect_3_2 <= ew_red;
  expect_4_0 <= ns_yellow;
  expect_4_1 <= turn_red;
  expect_4_2 <= ew_red;
  expect_5_0 <= ns_red;
  expect_5_1 <= turn_green;
  expect_5_2 <= ew_red;
  expect_6_0 <= ns_red;
  expect_6_1 <= turn_green;
  expect_6_2 <= ew_red;
  expect_7_0 <= ns_red;
  expect_7_1 <= turn_yellow;
  expect_7_2 <= ew_red;
  expect_8_0 <= ns_red;
  expect_8_1 <= turn_yellow;
  expect_8_2 <= ew_red;
  expect_9_0 <= ns_red;
  expect_9_1 <= turn_red;
  expect_9_2 <= ew_green;
  expect_10_0 <= ns_red;
  expect_10_1 <= turn_red;
  expect_10_2 <= ew_green;
  expect_11_0 <= ns_red;
  expect_11_1 <= turn_red;
  expect_11_2 <= ew_yellow;
  expect_12_0 <= ns_red;
  expect_12_1 <= turn_red;
  expect_12_2 <= ew_yellow;
  expect_13_0 <= (ns_red and turn_red) or (ns_red and ew_red) or (turn_red and ew_red);
  expect_14_0 <=
      (ns_green and not ns_yellow and not ns_red) or (not ns_green and ns_yellow and not ns_red)
      or (not ns_green and not ns_yellow and ns_red);
  expect_15_0 <=
      (turn_green and not turn_yellow and not turn_red)
      or (not turn_green and turn_yellow and not turn_red)
      or (not turn_green and not turn_yellow and turn_red);
  expect_16_0 <=
      (ew_green and not ew_yellow and not ew_red) or (not ew_green and ew_yellow and not ew_red)
      or (not ew_green and not ew_yellow and ew_red);
  expect_17_0 <= ns_green;
  expect_17_1 <= '1' when unsigned(t1_ET) = 0 else '0';
  expect_18_0 <= ns_green;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity traffic_lights_tb is
end entity;

architecture tests of traffic_lights_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal ns_green : std_logic;
  signal ns_yellow : std_logic;
  signal ns_red : std_logic;
  signal turn_green : std_logic;
  signal turn_yellow : std_logic;
  signal turn_red : std_logic;
  signal ew_green : std_logic;
  signal ew_yellow : std_logic;
  signal ew_red : std_logic;
  signal t1_ET : std_logic_vector(31 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_2_2 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_6_2 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_7_2 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_8_2 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_9_2 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_10_2 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_11_2 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_12_2 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_17_0 : std_logic;
  signal expect_17_1 : std_logic;
  signal expect_18_0 : std_logic;

  function image(bit : std_logic) return string is
    constant quoted : string := std_logic'image(bit);
  begin
    return quoted(2 to 2);
  end function;

  function image(bits : std_logic_vector) return string is
    alias from_left : std_logic_vector(1 to bits'length) is bits;
    variable text : string(1 to bits'length);
  begin
    for index in text'range loop
      text(index to index) := image(from_left(index));
    end loop;
    return text;
  end function;

  procedure print(text : string) is
    variable buf : line;
  begin
    write(buf, text);
    writeline(output, buf);
  end procedure;
begin
  core : entity work.traffic_lights_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      ns_green => ns_green,
      ns_yellow => ns_yellow,
      ns_red => ns_red,
      turn_green => turn_green,
      turn_yellow => turn_yellow,
      turn_red => turn_red,
      ew_green => ew_green,
      ew_yellow => ew_yellow,
      ew_red => ew_red,
      t1_ET => t1_ET
    );

  expectations : entity work.traffic_lights_expect
    port map (
      clk => clk,
      rst => rst,
      ns_red => ns_red,
      turn_red => turn_red,
      ew_red => ew_red,
      ns_green => ns_green,
      ns_yellow => ns_yellow,
      turn_green => turn_green,
      turn_yellow => turn_yellow,
      ew_green => ew_green,
      ew_yellow => ew_yellow,
      t1_ET => t1_ET,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_2_2 => expect_2_2,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_6_2 => expect_6_2,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_7_2 => expect_7_2,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_8_2 => expect_8_2,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_9_2 => expect_9_2,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_10_2 => expect_10_2,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_11_2 => expect_11_2,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_12_2 => expect_12_2,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_16_0 => expect_16_0,
      expect_17_0 => expect_17_0,
      expect_17_1 => expect_17_1,
      expect_18_0 => expect_18_0
    );

  process
    variable failed : boolean;
    variable failures : natural := 0;

    -- One clock is one scan.
    procedure scan(times : natural; with_tick : std_logic) is
    begin
      tick <= with_tick;
      for count in 1 to times loop
        wait for 5 ns;
        clk <= '1';
        wait for 5 ns;
        clk <= '0';
      end loop;
    end procedure;

    procedure reset is
    begin
      tick <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..4");

    -- all lanes are red before the first scan
    failed := false;
    reset;
    wait for 1 ns; -- traffic_lights.ladder:36
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " ns_red=" & image(ns_red)
          & " turn_red=" & image(turn_red)
          & " ew_red=" & image(ew_red));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - all lanes are red before the first scan");
    else
      print("ok 1 - all lanes are red before the first scan");
    end if;

    -- six intervals, again and again
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 3 loop
      wait for 1 ns; -- traffic_lights.ladder:41
      if not failed and (expect_1_0 and expect_1_1 and expect_1_2) /= '1' then
        failed := true;
        print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2)
            & " ns_green=" & image(ns_green)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(119, '1');
      wait for 1 ns; -- traffic_lights.ladder:43
      if not failed and (expect_2_0 and expect_2_1 and expect_2_2) /= '1' then
        failed := true;
        print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2)
            & " ns_green=" & image(ns_green)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_lights.ladder:45
      if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
        failed := true;
        print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(29, '1');
      wait for 1 ns; -- traffic_lights.ladder:47
      if not failed and (expect_4_0 and expect_4_1 and expect_4_2) /= '1' then
        failed := true;
        print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2)
            & " ns_yellow=" & image(ns_yellow)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_lights.ladder:49
      if not failed and (expect_5_0 and expect_5_1 and expect_5_2) /= '1' then
        failed := true;
        print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2)
            & " ns_red=" & image(ns_red)
            & " turn_green=" & image(turn_green)
            & " ew_red=" & image(ew_red));
      end if;
      scan(59, '1');
      wait for 1 ns; -- traffic_lights.ladder:51
      if not failed and (expect_6_0 and expect_6_1 and expect_6_2) /= '1' then
        failed := true;
        print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2)
            & " ns_red=" & image(ns_red)
            & " turn_green=" & image(turn_green)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_lights.ladder:53
      if not failed and (expect_7_0 and expect_7_1 and expect_7_2) /= '1' then
        failed := true;
        print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2)
            & " ns_red=" & image(ns_red)
            & " turn_yellow=" & image(turn_yellow)
            & " ew_red=" & image(ew_red));
      end if;
      scan(29, '1');
      wait for 1 ns; -- traffic_lights.ladder:55
      if not failed and (expect_8_0 and expect_8_1 and expect_8_2) /= '1' then
        failed := true;
        print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2)
            & " ns_red=" & image(ns_red)
            & " turn_yellow=" & image(turn_yellow)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_lights.ladder:57
      if not failed and (expect_9_0 and expect_9_1 and expect_9_2) /= '1' then
        failed := true;
        print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_green=" & image(ew_green));
      end if;
      scan(99, '1');
      wait for 1 ns; -- traffic_lights.ladder:59
      if not failed and (expect_10_0 and expect_10_1 and expect_10_2) /= '1' then
        failed := true;
        print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1) & image(expect_10_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_green=" & image(ew_green));
      end if;
      scan(1, '1');
      wait for 1 ns; -- traffic_lights.ladder:61
      if not failed and (expect_11_0 and expect_11_1 and expect_11_2) /= '1' then
        failed := true;
        print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1) & image(expect_11_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_yellow=" & image(ew_yellow));
      end if;
      scan(29, '1');
      wait for 1 ns; -- traffic_lights.ladder:63
      if not failed and (expect_12_0 and expect_12_1 and expect_12_2) /= '1' then
        failed := true;
        print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1) & image(expect_12_2)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_yellow=" & image(ew_yellow));
      end if;
      scan(1, '1');
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 2 - six intervals, again and again");
    else
      print("ok 2 - six intervals, again and again");
    end if;

    -- at every tick two lanes have red, and each lane has one light
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 400 loop
      wait for 1 ns; -- traffic_lights.ladder:70
      if not failed and (expect_13_0) /= '1' then
        failed := true;
        print("# failed expectation 13 conducts " & image(expect_13_0)
            & " ns_red=" & image(ns_red)
            & " turn_red=" & image(turn_red)
            & " ew_red=" & image(ew_red));
      end if;
      wait for 1 ns; -- traffic_lights.ladder:71
      if not failed and (expect_14_0) /= '1' then
        failed := true;
        print("# failed expectation 14 conducts " & image(expect_14_0)
            & " ns_green=" & image(ns_green)
            & " ns_yellow=" & image(ns_yellow)
            & " ns_red=" & image(ns_red));
      end if;
      wait for 1 ns; -- traffic_lights.ladder:76
      if not failed and (expect_15_0) /= '1' then
        failed := true;
        print("# failed expectation 15 conducts " & image(expect_15_0)
            & " turn_green=" & image(turn_green)
            & " turn_yellow=" & image(turn_yellow)
            & " turn_red=" & image(turn_red));
      end if;
      wait for 1 ns; -- traffic_lights.ladder:81
      if not failed and (expect_16_0) /= '1' then
        failed := true;
        print("# failed expectation 16 conducts " & image(expect_16_0)
            & " ew_green=" & image(ew_green)
            & " ew_yellow=" & image(ew_yellow)
            & " ew_red=" & image(ew_red));
      end if;
      scan(1, '1');
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 3 - at every tick two lanes have red, and each lane has one light");
    else
      print("ok 3 - at every tick two lanes have red, and each lane has one light");
    end if;

    -- a cycle takes 37 s, and none of them a scan more
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 5 loop
      wait for 1 ns; -- traffic_lights.ladder:92
      if not failed and (expect_17_0 and expect_17_1) /= '1' then
        failed := true;
        print("# failed expectation 17 conducts " & image(expect_17_0) & image(expect_17_1)
            & " ns_green=" & image(ns_green)
            & " t1_ET=" & image(t1_ET));
      end if;
      scan(370, '1');
    end loop;
    wait for 1 ns; -- traffic_lights.ladder:95
    if not failed and (expect_18_0) /= '1' then
      failed := true;
      print("# failed expectation 18 conducts " & image(expect_18_0)
          & " ns_green=" & image(ns_green));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a cycle takes 37 s, and none of them a scan more");
    else
      print("ok 4 - a cycle takes 37 s, and none of them a scan more");
    end if;

    assert failures = 0 report integer'image(failures) & " of 4 tests failed" severity failure;
    wait;
  end process;
end architecture;
