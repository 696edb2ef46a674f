-- Made by hotrail 0.1.0 from drum_sequence.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- DIVIDER: divider of the tick, N = 1 tick
-- Example, with N = 3:
-- tick ####_#__##
-- IN   ##########
-- Q    __#_____#_
-- CV   1201122201
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity drum_sequence_test_DIVIDER_N1 is
  port (
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity drum_sequence_test_DIVIDER_N1;

architecture rtl of drum_sequence_test_DIVIDER_N1 is
begin

  Q <= tick;
end architecture rtl;

-- DRUM: drum counter, TAPS = [1, 3, 5, 9]
-- Fitted to PV = 12.
-- Example, with PV = 3, TAPS = [1, 2]:
-- IN   _#_#_#_#___
-- EN   #########_#
-- Q    _____####__
-- TAP0 _########__
-- TAP1 ___######__
-- ACC  01122334400
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity drum_sequence_test_DRUM_PV12 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    power    : in  std_logic;
    EN       : in  std_logic;
    Q_last   : out std_logic;
    ACC_last : out unsigned(10 downto 0);
    TAP0     : out std_logic;
    TAP1     : out std_logic;
    TAP2     : out std_logic;
    TAP3     : out std_logic
  );
end entity drum_sequence_test_DRUM_PV12;

architecture rtl of drum_sequence_test_DRUM_PV12 is
  signal Q : std_logic := '0';
  signal ACC : unsigned(10 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ACC_at_least_3 : std_logic := '0';
  signal ACC_at_least_5 : std_logic := '0';
  signal ACC_at_least_9 : std_logic := '0';
  signal condition : std_logic;
  signal unequal : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(10 downto 0);
  signal ACC_next : unsigned(10 downto 0);
  signal equal : std_logic;
  signal choice : std_logic;
  signal Q_next : std_logic;
  signal equal_2 : std_logic;
  signal equal_3 : std_logic;
  signal choice_2 : std_logic;
  signal ACC_at_least_3_next : std_logic;
  signal equal_4 : std_logic;
  signal choice_3 : std_logic;
  signal ACC_at_least_5_next : std_logic;
  signal equal_5 : std_logic;
  signal choice_4 : std_logic;
  signal ACC_at_least_9_next : std_logic;
begin
  condition <= power and not was;
  unequal <= '1' when ACC /= 2047 else '0';
  condition_2 <= condition and unequal;
  sum <= ACC + (to_unsigned(0, 10) & condition_2);
  ACC_next <= sum when EN = '1' else to_unsigned(0, 11);
  equal <= '1' when ACC = 11 else '0';
  choice <= equal or Q when condition_2 = '1' else Q;
  Q_next <= EN and choice;
  equal_2 <= '1' when ACC = 0 else '0';
  equal_3 <= '1' when ACC = 2 else '0';
  choice_2 <= equal_3 or ACC_at_least_3 when condition_2 = '1' else ACC_at_least_3;
  ACC_at_least_3_next <= EN and choice_2;
  equal_4 <= '1' when ACC = 4 else '0';
  choice_3 <= equal_4 or ACC_at_least_5 when condition_2 = '1' else ACC_at_least_5;
  ACC_at_least_5_next <= EN and choice_3;
  equal_5 <= '1' when ACC = 8 else '0';
  choice_4 <= equal_5 or ACC_at_least_9 when condition_2 = '1' else ACC_at_least_9;
  ACC_at_least_9_next <= EN and choice_4;

  Q_last <= Q;
  ACC_last <= ACC;
  TAP0 <= not (not EN or (not condition and equal_2));
  TAP1 <= ACC_at_least_3_next;
  TAP2 <= ACC_at_least_5_next;
  TAP3 <= ACC_at_least_9_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q <= '0';
        ACC <= (others => '0');
        was <= '0';
        ACC_at_least_3 <= '0';
        ACC_at_least_5 <= '0';
        ACC_at_least_9 <= '0';
      else
        Q <= Q_next;
        ACC <= ACC_next;
        was <= power;
        ACC_at_least_3 <= ACC_at_least_3_next;
        ACC_at_least_5 <= ACC_at_least_5_next;
        ACC_at_least_9 <= ACC_at_least_9_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- T0_1: timer of tenths of a second
-- Fitted to PV = 10.
-- Example, with PV = 3:
-- IN  _#######__##__
-- EN  ###########_##
-- Q   ____#######___
-- QN  ####_______###
-- ACC 00123333333000
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity drum_sequence_test_T0_1_PV10 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    power  : in  std_logic;
    EN     : in  std_logic;
    unit   : in  std_logic;
    Q      : out std_logic;
    Q_last : out std_logic
  );
end entity drum_sequence_test_T0_1_PV10;

architecture rtl of drum_sequence_test_T0_1_PV10 is
  signal Q_reg : std_logic := '0';
  signal ACC : unsigned(3 downto 0) := (others => '0');
  signal ran : std_logic := '0';
  signal ran_next : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(3 downto 0);
  signal ACC_next : unsigned(3 downto 0);
  signal equal_2 : std_logic;
  signal Q_next : std_logic;
begin
  ran_next <= power and EN;
  equal <= '1' when ACC = 10 else '0';
  sum <= ACC + (to_unsigned(0, 3) & (ran_next and ran and unit and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 4);
  equal_2 <= '1' when ACC = 9 else '0';
  Q_next <= EN and ((ran_next and ran and unit and equal_2) or equal);

  Q <= Q_next;
  Q_last <= Q_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        ACC <= (others => '0');
        ran <= '0';
      else
        Q_reg <= Q_next;
        ACC <= ACC_next;
        ran <= ran_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity drum_sequence_test is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    tick     : in  std_logic;
    start    : in  std_logic;
    stop     : in  std_logic;
    water    : out std_logic;
    heater   : out std_logic;
    motor    : out std_logic;
    pump     : out std_logic;
    running  : out std_logic;
    drum_ACC : out std_logic_vector(15 downto 0)
  );
end entity drum_sequence_test;

architecture rtl of drum_sequence_test is
  signal running_reg : std_logic := '0';
  signal water_reg : std_logic := '0';
  signal heater_reg : std_logic := '0';
  signal motor_reg : std_logic := '0';
  signal pump_reg : std_logic := '0';
  signal every_100ms_Q : std_logic;
  signal drum_Q_last : std_logic;
  signal drum_ACC_last : unsigned(10 downto 0);
  signal drum_TAP0 : std_logic;
  signal drum_TAP1 : std_logic;
  signal drum_TAP2 : std_logic;
  signal drum_TAP3 : std_logic;
  signal running_next : std_logic;
  signal second_Q : std_logic;
  signal second_Q_last : std_logic;
  signal second_power : std_logic;
  signal second_EN : std_logic;
  signal water_next : std_logic;
  signal heater_next : std_logic;
  signal motor_next : std_logic;
  signal pump_next : std_logic;
  signal drum_ACC_value : unsigned(15 downto 0);
begin

  -- units of time, each a pulse that all blocks share
  every_100ms: entity work.drum_sequence_test_DIVIDER_N1
    port map (
      tick => tick,
      Q => every_100ms_Q
    );

  -- rung 1 "from start to the end of the programme", drum_sequence.ladder:9
  running_next <= (start or running_reg) and not stop and not drum_Q_last;

  -- rung 2 "a step each second", drum_sequence.ladder:12
  second_power <= running_next and not second_Q_last;
  second_EN <= running_next and not second_Q_last;
  second: entity work.drum_sequence_test_T0_1_PV10
    port map (
      clk => clk,
      rst => rst,
      power => second_power,
      EN => second_EN,
      unit => every_100ms_Q,
      Q => second_Q,
      Q_last => second_Q_last
    );
  drum: entity work.drum_sequence_test_DRUM_PV12
    port map (
      clk => clk,
      rst => rst,
      power => second_Q,
      EN => running_next,
      Q_last => drum_Q_last,
      ACC_last => drum_ACC_last,
      TAP0 => drum_TAP0,
      TAP1 => drum_TAP1,
      TAP2 => drum_TAP2,
      TAP3 => drum_TAP3
    );

  -- rung 3 "the steps, counted from the start", drum_sequence.ladder:15

  -- rung 4 "water from step 1 to 3", drum_sequence.ladder:18
  water_next <= drum_TAP0 and not drum_TAP1;

  -- rung 5 "heat from step 3 to 5", drum_sequence.ladder:21
  heater_next <= drum_TAP1 and not drum_TAP2;

  -- rung 6 "turn from step 3 to 9", drum_sequence.ladder:24
  motor_next <= drum_TAP1 and not drum_TAP3;

  -- rung 7 "pump off from step 9 to the end", drum_sequence.ladder:27
  pump_next <= drum_TAP3 and running_next;
  drum_ACC_value <= resize(drum_ACC_last, 16);

  water <= water_reg;
  heater <= heater_reg;
  motor <= motor_reg;
  pump <= pump_reg;
  running <= running_reg;
  drum_ACC <= std_logic_vector(drum_ACC_value);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        running_reg <= '0';
        water_reg <= '0';
        heater_reg <= '0';
        motor_reg <= '0';
        pump_reg <= '0';
      else
        running_reg <= running_next;
        water_reg <= water_next;
        heater_reg <= heater_next;
        motor_reg <= motor_next;
        pump_reg <= pump_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity drum_sequence_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    running     : in  std_logic;
    water       : in  std_logic;
    heater      : in  std_logic;
    drum_ACC    : in  std_logic_vector(15 downto 0);
    motor       : in  std_logic;
    pump        : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_2_0  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_3_2  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_4_2  : out std_logic;
    expect_4_3  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_5_2  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_6_2  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_8_2  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_9_2  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_10_2 : out std_logic;
    expect_10_3 : out std_logic;
    expect_11_0 : out std_logic
  );
end entity drum_sequence_expect;

architecture rtl of drum_sequence_expect is
begin

  expect_0_0 <= not running;
  expect_0_1 <= not water;
  expect_1_0 <= running;
  expect_1_1 <= not water;
  expect_2_0 <= not water;
  expect_3_0 <= water;
  expect_3_1 <= not heater;
  expect_3_2 <= '1' when unsigned(drum_ACC) = 1 else '0';
  expect_4_0 <= not water;
  expect_4_1 <= heater;
  expect_4_2 <= motor;
  expect_4_3 <= '1' when unsigned(drum_ACC) = 3 else '0';
  expect_5_0 <= not heater;
  expect_5_1 <= motor;
  expect_5_2 <= '1' when unsigned(drum_ACC) = 5 else '0';
  expect_6_0 <= not motor;
  expect_6_1 <= pump;
  expect_6_2 <= '1' when unsigned(drum_ACC) = 9 else '0';
  expect_7_0 <= pump;
  expect_7_1 <= running;
  expect_8_0 <= not pump;
  expect_8_1 <= not running;
  expect_8_2 <= '1' when unsigned(drum_ACC) = 0 else '0';
  expect_9_0 <= heater;
  expect_9_1 <= motor;
  expect_9_2 <= '1' when unsigned(drum_ACC) = 4 else '0';
  expect_10_0 <= not heater;
  expect_10_1 <= not motor;
  expect_10_2 <= not running;
  expect_10_3 <= '1' when unsigned(drum_ACC) = 0 else '0';
  expect_11_0 <= not water;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity drum_sequence_tb is
end entity;

architecture tests of drum_sequence_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal stop : std_logic := '0';
  signal water : std_logic;
  signal heater : std_logic;
  signal motor : std_logic;
  signal pump : std_logic;
  signal running : std_logic;
  signal drum_ACC : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_4_3 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_6_2 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_8_2 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_9_2 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_10_2 : std_logic;
  signal expect_10_3 : std_logic;
  signal expect_11_0 : std_logic;

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
  core : entity work.drum_sequence_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      stop => stop,
      water => water,
      heater => heater,
      motor => motor,
      pump => pump,
      running => running,
      drum_ACC => drum_ACC
    );

  expectations : entity work.drum_sequence_expect
    port map (
      clk => clk,
      rst => rst,
      running => running,
      water => water,
      heater => heater,
      drum_ACC => drum_ACC,
      motor => motor,
      pump => pump,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_4_3 => expect_4_3,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_6_2 => expect_6_2,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_8_2 => expect_8_2,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_9_2 => expect_9_2,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_10_2 => expect_10_2,
      expect_10_3 => expect_10_3,
      expect_11_0 => expect_11_0
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
      stop <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..2");

    -- the programme, step by step
    failed := false;
    reset;
    scan(1, '0');
    wait for 1 ns; -- drum_sequence.ladder:32
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " running=" & image(running)
          & " water=" & image(water));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- drum_sequence.ladder:34
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " running=" & image(running)
          & " water=" & image(water));
    end if;
    scan(9, '1');
    wait for 1 ns; -- drum_sequence.ladder:36
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " water=" & image(water));
    end if;
    scan(1, '1');
    wait for 1 ns; -- drum_sequence.ladder:38
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
          & " water=" & image(water)
          & " heater=" & image(heater)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    for round in 1 to 2 loop
      scan(2, '0');
      scan(10, '1');
    end loop;
    wait for 1 ns; -- drum_sequence.ladder:40
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2 and expect_4_3) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2) & image(expect_4_3)
          & " water=" & image(water)
          & " heater=" & image(heater)
          & " motor=" & image(motor)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    for round in 1 to 2 loop
      scan(2, '0');
      scan(10, '1');
    end loop;
    wait for 1 ns; -- drum_sequence.ladder:42
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2)
          & " heater=" & image(heater)
          & " motor=" & image(motor)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    for round in 1 to 4 loop
      scan(2, '0');
      scan(10, '1');
    end loop;
    wait for 1 ns; -- drum_sequence.ladder:44
    if not failed and (expect_6_0 and expect_6_1 and expect_6_2) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2)
          & " motor=" & image(motor)
          & " pump=" & image(pump)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    for round in 1 to 3 loop
      scan(2, '0');
      scan(9, '1');
      wait for 1 ns; -- drum_sequence.ladder:47
      if not failed and (expect_7_0 and expect_7_1) /= '1' then
        failed := true;
        print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
            & " pump=" & image(pump)
            & " running=" & image(running));
      end if;
      scan(1, '1');
    end loop;
    scan(1, '0');
    wait for 1 ns; -- drum_sequence.ladder:51
    if not failed and (expect_8_0 and expect_8_1 and expect_8_2) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2)
          & " pump=" & image(pump)
          & " running=" & image(running)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - the programme, step by step");
    else
      print("ok 1 - the programme, step by step");
    end if;

    -- stop puts the drum back
    failed := false;
    reset;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(10, '1');
    for round in 1 to 3 loop
      scan(2, '0');
      scan(10, '1');
    end loop;
    wait for 1 ns; -- drum_sequence.ladder:57
    if not failed and (expect_9_0 and expect_9_1 and expect_9_2) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2)
          & " heater=" & image(heater)
          & " motor=" & image(motor)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    stop <= '1';
    scan(1, '0');
    stop <= '0';
    scan(1, '0');
    wait for 1 ns; -- drum_sequence.ladder:59
    if not failed and (expect_10_0 and expect_10_1 and expect_10_2 and expect_10_3) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1) & image(expect_10_2) & image(expect_10_3)
          & " heater=" & image(heater)
          & " motor=" & image(motor)
          & " running=" & image(running)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(9, '1');
    wait for 1 ns; -- drum_sequence.ladder:62
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " water=" & image(water));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - stop puts the drum back");
    else
      print("ok 2 - stop puts the drum back");
    end if;

    assert failures = 0 report integer'image(failures) & " of 2 tests failed" severity failure;
    wait;
  end process;
end architecture;
