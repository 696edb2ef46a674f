-- Made by hotrail 0.1.0 from ab_seal.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- AB_TON: on-delay timer of Allen-Bradley, BASE = 1 tick, SIZE = DINT
-- Fitted to PRE = 2000.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_seal_test_AB_TON_BASE1_DINT_PRE2000 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    tick     : in  std_logic;
    power    : in  std_logic;
    ACC_last : out unsigned(30 downto 0);
    EN       : out std_logic;
    EN_last  : out std_logic;
    DN       : out std_logic
  );
end entity ab_seal_test_AB_TON_BASE1_DINT_PRE2000;

architecture rtl of ab_seal_test_AB_TON_BASE1_DINT_PRE2000 is
  signal ACC : unsigned(30 downto 0) := (others => '0');
  signal EN_reg : std_logic := '0';
  signal DN_reg : std_logic := '0';
  signal unequal : std_logic;
  signal sum : unsigned(30 downto 0);
  signal at_least : std_logic;
  signal DN_next : std_logic;
  signal ACC_next : unsigned(30 downto 0);
begin
  unequal <= '1' when ACC /= "1111111111111111111111111111111" else '0';
  sum <= ACC + (to_unsigned(0, 30) & (power and EN_reg and not DN_reg and tick and unequal));
  at_least <= '1' when sum >= 2000 else '0';
  DN_next <= power and (DN_reg or at_least);
  ACC_next <= sum when power = '1' else to_unsigned(0, 31);

  ACC_last <= ACC;
  EN <= power;
  EN_last <= EN_reg;
  DN <= DN_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        EN_reg <= '0';
        DN_reg <= '0';
      else
        ACC <= ACC_next;
        EN_reg <= power;
        DN_reg <= DN_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 2000 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_seal_test_TON_PT2000 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity ab_seal_test_TON_PT2000;

architecture rtl of ab_seal_test_TON_PT2000 is
  signal ET : unsigned(10 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_2000 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(10 downto 0);
  signal choice : unsigned(10 downto 0);
  signal ET_next : unsigned(10 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_2000_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_2000;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 11);
  equal <= '1' when ET = 1999 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_2000;
  ET_is_2000_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_2000_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_2000 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_2000 <= ET_is_2000_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_seal_test is
  port (
    clk               : in  std_logic;
    rst               : in  std_logic;
    tick              : in  std_logic;
    start_pb          : in  std_logic;
    stop_pb           : in  std_logic;
    motor             : out std_logic;
    next_step         : out std_logic;
    siemens_motor     : out std_logic;
    siemens_next_step : out std_logic;
    delay_tmr_ACC     : out std_logic_vector(31 downto 0)
  );
end entity ab_seal_test;

architecture rtl of ab_seal_test is
  signal siemens_motor_reg : std_logic := '0';
  signal motor_reg : std_logic := '0';
  signal next_step_reg : std_logic := '0';
  signal siemens_next_step_reg : std_logic := '0';
  signal delay_tmr_ACC_last : unsigned(30 downto 0);
  signal delay_tmr_EN : std_logic;
  signal delay_tmr_EN_last : std_logic;
  signal delay_tmr_DN : std_logic;
  signal delay_tmr_power : std_logic;
  signal motor_next : std_logic;
  signal next_step_next : std_logic;
  signal siemens_motor_next : std_logic;
  signal t1_Q : std_logic;
  signal delay_tmr_ACC_value : unsigned(31 downto 0);
  signal siemens_next_step_next : std_logic;
begin

  -- rung 1 "Delay_Tmr seals itself in", ab_seal.ladder:9
  delay_tmr_power <= (start_pb or delay_tmr_EN_last) and stop_pb;
  delay_tmr: entity work.ab_seal_test_AB_TON_BASE1_DINT_PRE2000
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => delay_tmr_power,
      ACC_last => delay_tmr_ACC_last,
      EN => delay_tmr_EN,
      EN_last => delay_tmr_EN_last,
      DN => delay_tmr_DN
    );

  -- rung 2, ab_seal.ladder:12
  motor_next <= delay_tmr_EN;

  -- rung 3, ab_seal.ladder:14
  next_step_next <= delay_tmr_DN;

  -- rung 4 "the same with Siemens' timer, which has no EN: a coil seals", ab_seal.ladder:16
  siemens_motor_next <= (start_pb or siemens_motor_reg) and stop_pb;
  t1: entity work.ab_seal_test_TON_PT2000
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => siemens_motor_next,
      Q => t1_Q
    );
  delay_tmr_ACC_value <= resize(delay_tmr_ACC_last, 32);
  siemens_next_step_next <= t1_Q;

  motor <= motor_reg;
  next_step <= next_step_reg;
  siemens_motor <= siemens_motor_reg;
  siemens_next_step <= siemens_next_step_reg;
  delay_tmr_ACC <= std_logic_vector(delay_tmr_ACC_value);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        siemens_motor_reg <= '0';
        motor_reg <= '0';
        next_step_reg <= '0';
        siemens_next_step_reg <= '0';
      else
        siemens_motor_reg <= siemens_motor_next;
        motor_reg <= motor_next;
        next_step_reg <= next_step_next;
        siemens_next_step_reg <= siemens_next_step_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_seal_expect is
  port (
    clk               : in  std_logic;
    rst               : in  std_logic;
    motor             : in  std_logic;
    siemens_motor     : in  std_logic;
    next_step         : in  std_logic;
    siemens_next_step : in  std_logic;
    delay_tmr_ACC     : in  std_logic_vector(31 downto 0);
    expect_0_0        : out std_logic;
    expect_0_1        : out std_logic;
    expect_1_0        : out std_logic;
    expect_1_1        : out std_logic;
    expect_1_2        : out std_logic;
    expect_1_3        : out std_logic;
    expect_2_0        : out std_logic;
    expect_2_1        : out std_logic;
    expect_3_0        : out std_logic;
    expect_3_1        : out std_logic;
    expect_3_2        : out std_logic;
    expect_4_0        : out std_logic;
    expect_4_1        : out std_logic;
    expect_4_2        : out std_logic;
    expect_4_3        : out std_logic;
    expect_5_0        : out std_logic;
    expect_5_1        : out std_logic;
    expect_6_0        : out std_logic;
    expect_6_1        : out std_logic;
    expect_7_0        : out std_logic;
    expect_7_1        : out std_logic;
    expect_7_2        : out std_logic;
    expect_7_3        : out std_logic
  );
end entity ab_seal_expect;

architecture rtl of ab_seal_expect is
begin

  expect_0_0 <= not motor;
  expect_0_1 <= not siemens_motor;
  expect_1_0 <= motor;
  expect_1_1 <= siemens_motor;
  expect_1_2 <= not next_step;
  expect_1_3 <= not siemens_next_step;
  expect_2_0 <= not next_step;
  expect_2_1 <= not siemens_next_step;
  expect_3_0 <= next_step;
  expect_3_1 <= siemens_next_step;
  expect_3_2 <= '1' when unsigned(delay_tmr_ACC) = 2000 else '0';
  expect_4_0 <= not motor;
  expect_4_1 <= not siemens_motor;
  expect_4_2 <= not next_step;
  expect_4_3 <= not siemens_next_step;
  expect_5_0 <= not motor;
  expect_5_1 <= not siemens_motor;
  expect_6_0 <= not motor;
  expect_6_1 <= not siemens_motor;
  expect_7_0 <= not motor;
  expect_7_1 <= not next_step;
  expect_7_2 <= not siemens_motor;
  expect_7_3 <= not siemens_next_step;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity ab_seal_tb is
end entity;

architecture tests of ab_seal_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal start_pb : std_logic := '0';
  signal stop_pb : std_logic := '0';
  signal motor : std_logic;
  signal next_step : std_logic;
  signal siemens_motor : std_logic;
  signal siemens_next_step : std_logic;
  signal delay_tmr_ACC : std_logic_vector(31 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_1_3 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_4_3 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_7_2 : std_logic;
  signal expect_7_3 : std_logic;

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
  core : entity work.ab_seal_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      start_pb => start_pb,
      stop_pb => stop_pb,
      motor => motor,
      next_step => next_step,
      siemens_motor => siemens_motor,
      siemens_next_step => siemens_next_step,
      delay_tmr_ACC => delay_tmr_ACC
    );

  expectations : entity work.ab_seal_expect
    port map (
      clk => clk,
      rst => rst,
      motor => motor,
      siemens_motor => siemens_motor,
      next_step => next_step,
      siemens_next_step => siemens_next_step,
      delay_tmr_ACC => delay_tmr_ACC,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_1_3 => expect_1_3,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_4_3 => expect_4_3,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_7_2 => expect_7_2,
      expect_7_3 => expect_7_3
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
      start_pb <= '0';
      stop_pb <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..3");

    -- start, two seconds, stop
    failed := false;
    reset;
    stop_pb <= '1';
    scan(1, '0');
    wait for 1 ns; -- ab_seal.ladder:21
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " motor=" & image(motor)
          & " siemens_motor=" & image(siemens_motor));
    end if;
    start_pb <= '1';
    scan(1, '0');
    start_pb <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_seal.ladder:23
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2 and expect_1_3) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2) & image(expect_1_3)
          & " motor=" & image(motor)
          & " siemens_motor=" & image(siemens_motor)
          & " next_step=" & image(next_step)
          & " siemens_next_step=" & image(siemens_next_step));
    end if;
    scan(1999, '1');
    wait for 1 ns; -- ab_seal.ladder:25
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " next_step=" & image(next_step)
          & " siemens_next_step=" & image(siemens_next_step));
    end if;
    scan(1, '1');
    wait for 1 ns; -- ab_seal.ladder:27
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
          & " next_step=" & image(next_step)
          & " siemens_next_step=" & image(siemens_next_step)
          & " delay_tmr_ACC=" & image(delay_tmr_ACC));
    end if;
    stop_pb <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_seal.ladder:29
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2 and expect_4_3) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2) & image(expect_4_3)
          & " motor=" & image(motor)
          & " siemens_motor=" & image(siemens_motor)
          & " next_step=" & image(next_step)
          & " siemens_next_step=" & image(siemens_next_step));
    end if;
    stop_pb <= '1';
    scan(1, '0');
    wait for 1 ns; -- ab_seal.ladder:31
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " motor=" & image(motor)
          & " siemens_motor=" & image(siemens_motor));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - start, two seconds, stop");
    else
      print("ok 1 - start, two seconds, stop");
    end if;

    -- stop wins over start
    failed := false;
    reset;
    start_pb <= '1';
    scan(1, '0');
    wait for 1 ns; -- ab_seal.ladder:35
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " motor=" & image(motor)
          & " siemens_motor=" & image(siemens_motor));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - stop wins over start");
    else
      print("ok 2 - stop wins over start");
    end if;

    -- nothing runs after reset with the start button released
    failed := false;
    reset;
    stop_pb <= '1';
    scan(1, '0');
    scan(3000, '1');
    wait for 1 ns; -- ab_seal.ladder:39
    if not failed and (expect_7_0 and expect_7_1 and expect_7_2 and expect_7_3) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2) & image(expect_7_3)
          & " motor=" & image(motor)
          & " next_step=" & image(next_step)
          & " siemens_motor=" & image(siemens_motor)
          & " siemens_next_step=" & image(siemens_next_step));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - nothing runs after reset with the start button released");
    else
      print("ok 3 - nothing runs after reset with the start button released");
    end if;

    assert failures = 0 report integer'image(failures) & " of 3 tests failed" severity failure;
    wait;
  end process;
end architecture;
