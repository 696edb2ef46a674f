-- Made by hotrail 0.1.0 from start_stop.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- TON: on-delay timer
-- Fitted to PT = 5000 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity start_stop_test_TON_PT5000 is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    tick    : in  std_logic;
    power   : in  std_logic;
    Q       : out std_logic;
    ET_last : out unsigned(12 downto 0)
  );
end entity start_stop_test_TON_PT5000;

architecture rtl of start_stop_test_TON_PT5000 is
  signal ET : unsigned(12 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_5000 : std_logic := '0';
  signal condition : std_logic;
  signal sum : unsigned(12 downto 0);
  signal ET_next : unsigned(12 downto 0);
  signal equal : std_logic;
  signal ET_is_5000_next : std_logic;
begin
  condition <= power and was;
  sum <= ET + (to_unsigned(0, 12) & (tick and not ET_is_5000));
  ET_next <= sum when condition = '1' else to_unsigned(0, 13);
  equal <= '1' when ET = 4999 else '0';
  ET_is_5000_next <= condition and ((tick and equal) or ET_is_5000);

  Q <= ET_is_5000_next;
  ET_last <= ET;

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

entity start_stop_test is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    tick     : in  std_logic;
    start    : in  std_logic;
    stop     : in  std_logic;
    motor    : out std_logic;
    lamp     : out std_logic;
    delay_ET : out std_logic_vector(31 downto 0)
  );
end entity start_stop_test;

architecture rtl of start_stop_test is
  signal motor_reg : std_logic := '0';
  signal lamp_reg : std_logic := '0';
  signal motor_next : std_logic;
  signal delay_Q : std_logic;
  signal delay_ET_last : unsigned(12 downto 0);
  signal delay_ET_value : unsigned(31 downto 0);
  signal lamp_next : std_logic;
begin

  -- rung 1 "seal-in", start_stop.ladder:7
  motor_next <= (start or motor_reg) and not stop;

  -- rung 2 "lamp after five seconds", start_stop.ladder:10
  delay: entity work.start_stop_test_TON_PT5000
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => motor_next,
      Q => delay_Q,
      ET_last => delay_ET_last
    );
  delay_ET_value <= resize(delay_ET_last, 32);
  lamp_next <= delay_Q;

  motor <= motor_reg;
  lamp <= lamp_reg;
  delay_ET <= std_logic_vector(delay_ET_value);

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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity start_stop_expect is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    motor      : in  std_logic;
    lamp       : in  std_logic;
    delay_ET   : in  std_logic_vector(31 downto 0);
    expect_0_0 : out std_logic;
    expect_0_1 : out std_logic;
    expect_1_0 : out std_logic;
    expect_1_1 : out std_logic;
    expect_2_0 : out std_logic;
    expect_2_1 : out std_logic;
    expect_3_0 : out std_logic;
    expect_4_0 : out std_logic;
    expect_5_0 : out std_logic;
    expect_5_1 : out std_logic;
    expect_5_2 : out std_logic;
    expect_6_0 : out std_logic;
    expect_6_1 : out std_logic;
    expect_6_2 : out std_logic
  );
end entity start_stop_expect;

architecture rtl of start_stop_expect is
begin

  expect_0_0 <= motor;
  expect_0_1 <= not lamp;
  expect_1_0 <= motor;
  expect_1_1 <= lamp;
  expect_2_0 <= not motor;
  expect_2_1 <= not lamp;
  expect_3_0 <= not motor;
  expect_4_0 <= motor;
  expect_5_0 <= motor;
  expect_5_1 <= not lamp;
  expect_5_2 <= '1' when unsigned(delay_ET) = 4999 else '0';
  expect_6_0 <= not motor;
  expect_6_1 <= not lamp;
  expect_6_2 <= '1' when unsigned(delay_ET) = 0 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity start_stop_tb is
end entity;

architecture tests of start_stop_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start : std_logic := '0';
  signal stop : std_logic := '0';
  signal motor : std_logic;
  signal lamp : std_logic;
  signal delay_ET : std_logic_vector(31 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_6_2 : std_logic;

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
  core : entity work.start_stop_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start => start,
      stop => stop,
      motor => motor,
      lamp => lamp,
      delay_ET => delay_ET
    );

  expectations : entity work.start_stop_expect
    port map (
      clk => clk,
      rst => rst,
      motor => motor,
      lamp => lamp,
      delay_ET => delay_ET,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_4_0 => expect_4_0,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_6_2 => expect_6_2
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
    print("1..3");

    -- stop drops the motor, the lamp needs five seconds
    failed := false;
    reset;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    wait for 1 ns; -- start_stop.ladder:15
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " motor=" & image(motor)
          & " lamp=" & image(lamp));
    end if;
    scan(5000, '1');
    wait for 1 ns; -- start_stop.ladder:17
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " motor=" & image(motor)
          & " lamp=" & image(lamp));
    end if;
    stop <= '1';
    scan(1, '0');
    wait for 1 ns; -- start_stop.ladder:19
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " motor=" & image(motor)
          & " lamp=" & image(lamp));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - stop drops the motor, the lamp needs five seconds");
    else
      print("ok 1 - stop drops the motor, the lamp needs five seconds");
    end if;

    -- stop wins over start
    failed := false;
    reset;
    start <= '1';
    stop <= '1';
    scan(1, '0');
    wait for 1 ns; -- start_stop.ladder:23
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " motor=" & image(motor));
    end if;
    stop <= '0';
    scan(1, '0');
    wait for 1 ns; -- start_stop.ladder:25
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " motor=" & image(motor));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - stop wins over start");
    else
      print("ok 2 - stop wins over start");
    end if;

    -- a motor that stops early gives no light
    failed := false;
    reset;
    start <= '1';
    scan(1, '0');
    start <= '0';
    scan(1, '0');
    scan(4999, '1');
    wait for 1 ns; -- start_stop.ladder:30
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2)
          & " motor=" & image(motor)
          & " lamp=" & image(lamp)
          & " delay_ET=" & image(delay_ET));
    end if;
    stop <= '1';
    scan(1, '0');
    stop <= '0';
    scan(1, '0');
    scan(10000, '1');
    wait for 1 ns; -- start_stop.ladder:33
    if not failed and (expect_6_0 and expect_6_1 and expect_6_2) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2)
          & " motor=" & image(motor)
          & " lamp=" & image(lamp)
          & " delay_ET=" & image(delay_ET));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a motor that stops early gives no light");
    else
      print("ok 3 - a motor that stops early gives no light");
    end if;

    assert failures = 0 report integer'image(failures) & " of 3 tests failed" severity failure;
    wait;
  end process;
end architecture;
