-- Made by hotrail 0.1.0 from step_sequence.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- TON: on-delay timer
-- Fitted to PT = 20 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity step_sequence_test_TON_PT20 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity step_sequence_test_TON_PT20;

architecture rtl of step_sequence_test_TON_PT20 is
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

entity step_sequence_test is
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
    busy      : out std_logic;
    step      : out std_logic_vector(15 downto 0)
  );
end entity step_sequence_test;

architecture rtl of step_sequence_test is
  signal step_reg : unsigned(2 downto 0) := (others => '0');
  signal start_before : std_logic := '0';
  signal clamp_reg : std_logic := '0';
  signal drill_reg : std_logic := '0';
  signal lift_reg : std_logic := '0';
  signal busy_reg : std_logic := '0';
  signal step_value : unsigned(15 downto 0);
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
  step_value <= resize(step_reg, 16);
  rung1_equal <= '1' when step_reg = 4 else '0';
  step_rung1 <= to_unsigned(0, 3) when (rung1_equal and free) = '1' else step_reg;

  -- rung 2 "drill is up", step_sequence.ladder:18
  up_time_power <= '1' when step_rung1 = 3 else '0';
  up_time: entity work.step_sequence_test_TON_PT20
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
  step <= std_logic_vector(step_value);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        step_reg <= (others => '0');
        start_before <= '0';
        clamp_reg <= '0';
        drill_reg <= '0';
        lift_reg <= '0';
        busy_reg <= '0';
      else
        step_reg <= step_next;
        start_before <= start;
        clamp_reg <= clamp_next;
        drill_reg <= drill_next;
        lift_reg <= lift_next;
        busy_reg <= busy_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity step_sequence_expect is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    step       : in  std_logic_vector(15 downto 0);
    clamp      : in  std_logic;
    busy       : in  std_logic;
    drill      : in  std_logic;
    lift       : in  std_logic;
    expect_0_0 : out std_logic;
    expect_0_1 : out std_logic;
    expect_0_2 : out std_logic;
    expect_0_3 : out std_logic;
    expect_1_0 : out std_logic;
    expect_1_1 : out std_logic;
    expect_2_0 : out std_logic;
    expect_2_1 : out std_logic;
    expect_3_0 : out std_logic;
    expect_4_0 : out std_logic;
    expect_4_1 : out std_logic;
    expect_4_2 : out std_logic;
    expect_4_3 : out std_logic;
    expect_5_0 : out std_logic;
    expect_6_0 : out std_logic;
    expect_7_0 : out std_logic;
    expect_8_0 : out std_logic;
    expect_9_0 : out std_logic;
    expect_9_1 : out std_logic;
    expect_9_2 : out std_logic
  );
end entity step_sequence_expect;

architecture rtl of step_sequence_expect is
begin

  expect_0_0 <= '1' when unsigned(step) = 1 else '0';
  expect_0_1 <= clamp;
  expect_0_2 <= busy;
  expect_0_3 <= not drill;
  expect_1_0 <= drill;
  expect_1_1 <= clamp;
  expect_2_0 <= lift;
  expect_2_1 <= not drill;
  expect_3_0 <= lift;
  expect_4_0 <= not lift;
  expect_4_1 <= not clamp;
  expect_4_2 <= busy;
  expect_4_3 <= '1' when unsigned(step) = 4 else '0';
  expect_5_0 <= not busy;
  expect_6_0 <= '1' when unsigned(step) = 1 else '0';
  expect_7_0 <= '1' when unsigned(step) = 2 else '0';
  expect_8_0 <= '1' when unsigned(step) = 3 else '0';
  expect_9_0 <= not clamp;
  expect_9_1 <= not drill;
  expect_9_2 <= not busy;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity step_sequence_tb is
end entity;

architecture tests of step_sequence_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal clamped : std_logic := '0';
  signal deep : std_logic := '0';
  signal free : std_logic := '0';
  signal emergency : std_logic := '0';
  signal clamp : std_logic;
  signal drill : std_logic;
  signal lift : std_logic;
  signal busy : std_logic;
  signal step : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_0_3 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_4_3 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_9_2 : std_logic;

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
  core : entity work.step_sequence_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      clamped => clamped,
      deep => deep,
      free => free,
      emergency => emergency,
      clamp => clamp,
      drill => drill,
      lift => lift,
      busy => busy,
      step => step
    );

  expectations : entity work.step_sequence_expect
    port map (
      clk => clk,
      rst => rst,
      step => step,
      clamp => clamp,
      busy => busy,
      drill => drill,
      lift => lift,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_0_3 => expect_0_3,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_4_3 => expect_4_3,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_7_0 => expect_7_0,
      expect_8_0 => expect_8_0,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_9_2 => expect_9_2
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
      start <= '0';
      clamped <= '0';
      deep <= '0';
      free <= '0';
      emergency <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..3");

    -- one part
    failed := false;
    reset;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- step_sequence.ladder:39
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2 and expect_0_3) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2) & image(expect_0_3)
          & " step=" & image(step)
          & " clamp=" & image(clamp)
          & " busy=" & image(busy)
          & " drill=" & image(drill));
    end if;
    clamped <= '1';
    scan(1, '0');
    wait for 1 ns; -- step_sequence.ladder:41
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " drill=" & image(drill)
          & " clamp=" & image(clamp));
    end if;
    deep <= '1';
    scan(1, '0');
    wait for 1 ns; -- step_sequence.ladder:43
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " lift=" & image(lift)
          & " drill=" & image(drill));
    end if;
    deep <= '0';
    scan(20, '1');
    wait for 1 ns; -- step_sequence.ladder:45
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " lift=" & image(lift));
    end if;
    scan(1, '1');
    wait for 1 ns; -- step_sequence.ladder:47
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2 and expect_4_3) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2) & image(expect_4_3)
          & " lift=" & image(lift)
          & " clamp=" & image(clamp)
          & " busy=" & image(busy)
          & " step=" & image(step));
    end if;
    clamped <= '0';
    free <= '1';
    scan(1, '0');
    wait for 1 ns; -- step_sequence.ladder:49
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " busy=" & image(busy));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - one part");
    else
      print("ok 1 - one part");
    end if;

    -- a step at a time, whatever the switches say
    failed := false;
    reset;
    clamped <= '1';
    deep <= '1';
    free <= '1';
    start <= '1';
    scan(1, '0');
    wait for 1 ns; -- step_sequence.ladder:54
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " step=" & image(step));
    end if;
    scan(1, '0');
    wait for 1 ns; -- step_sequence.ladder:56
    if not failed and (expect_7_0) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0)
          & " step=" & image(step));
    end if;
    scan(1, '0');
    wait for 1 ns; -- step_sequence.ladder:58
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " step=" & image(step));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - a step at a time, whatever the switches say");
    else
      print("ok 2 - a step at a time, whatever the switches say");
    end if;

    -- emergency from any step
    failed := false;
    reset;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    clamped <= '1';
    scan(1, '0');
    emergency <= '1';
    scan(1, '0');
    wait for 1 ns; -- step_sequence.ladder:64
    if not failed and (expect_9_0 and expect_9_1 and expect_9_2) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2)
          & " clamp=" & image(clamp)
          & " drill=" & image(drill)
          & " busy=" & image(busy));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - emergency from any step");
    else
      print("ok 3 - emergency from any step");
    end if;

    assert failures = 0 report integer'image(failures) & " of 3 tests failed" severity failure;
    wait;
  end process;
end architecture;
