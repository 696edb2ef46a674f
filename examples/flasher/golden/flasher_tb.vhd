-- Made by hotrail 0.1.0 from flasher.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- TON: on-delay timer
-- Fitted to PT = 200 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_test_TON_PT200 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    power  : in  std_logic;
    Q_last : out std_logic
  );
end entity flasher_test_TON_PT200;

architecture rtl of flasher_test_TON_PT200 is
  signal Q : std_logic := '0';
  signal ET : unsigned(7 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(7 downto 0);
  signal choice : unsigned(7 downto 0);
  signal ET_next : unsigned(7 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not Q;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 8);
  equal <= '1' when ET = 199 else '0';
  choice_2 <= equal when condition_2 = '1' else Q;
  Q_next <= choice_2 when condition = '1' else '0';

  Q_last <= Q;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q <= '0';
        ET <= (others => '0');
        was <= '0';
      else
        Q <= Q_next;
        ET <= ET_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 1300 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_test_TON_PT1300 is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    tick    : in  std_logic;
    power   : in  std_logic;
    Q       : out std_logic;
    ET_last : out unsigned(10 downto 0)
  );
end entity flasher_test_TON_PT1300;

architecture rtl of flasher_test_TON_PT1300 is
  signal ET : unsigned(10 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_1300 : std_logic := '0';
  signal condition : std_logic;
  signal sum : unsigned(10 downto 0);
  signal ET_next : unsigned(10 downto 0);
  signal equal : std_logic;
  signal ET_is_1300_next : std_logic;
begin
  condition <= power and was;
  sum <= ET + (to_unsigned(0, 10) & (tick and not ET_is_1300));
  ET_next <= sum when condition = '1' else to_unsigned(0, 11);
  equal <= '1' when ET = 1299 else '0';
  ET_is_1300_next <= condition and ((tick and equal) or ET_is_1300);

  Q <= ET_is_1300_next;
  ET_last <= ET;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_1300 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_1300 <= ET_is_1300_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_test is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    tick       : in  std_logic;
    enable     : in  std_logic;
    lamp       : out std_logic;
    on_time_ET : out std_logic_vector(31 downto 0)
  );
end entity flasher_test;

architecture rtl of flasher_test is
  signal lamp_reg : std_logic := '0';
  signal off_time_Q_last : std_logic;
  signal on_time_power : std_logic;
  signal on_time_Q : std_logic;
  signal on_time_ET_last : unsigned(10 downto 0);
  signal lamp_next : std_logic;
  signal on_time_ET_value : unsigned(31 downto 0);
begin

  -- rung 1 "the lamp is on until this timer has run", flasher.ladder:7
  on_time_power <= enable and not off_time_Q_last;
  off_time: entity work.flasher_test_TON_PT200
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => on_time_Q,
      Q_last => off_time_Q_last
    );
  on_time: entity work.flasher_test_TON_PT1300
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => on_time_power,
      Q => on_time_Q,
      ET_last => on_time_ET_last
    );

  -- rung 2 "and off until this one has", flasher.ladder:10

  -- rung 3 "lamp", flasher.ladder:13
  lamp_next <= enable and not on_time_Q;
  on_time_ET_value <= resize(on_time_ET_last, 32);

  lamp <= lamp_reg;
  on_time_ET <= std_logic_vector(on_time_ET_value);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        lamp_reg <= '0';
      else
        lamp_reg <= lamp_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_expect is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    lamp       : in  std_logic;
    on_time_ET : in  std_logic_vector(31 downto 0);
    expect_0_0 : out std_logic;
    expect_1_0 : out std_logic;
    expect_2_0 : out std_logic;
    expect_3_0 : out std_logic;
    expect_3_1 : out std_logic;
    expect_4_0 : out std_logic;
    expect_5_0 : out std_logic;
    expect_6_0 : out std_logic;
    expect_7_0 : out std_logic;
    expect_7_1 : out std_logic
  );
end entity flasher_expect;

architecture rtl of flasher_expect is
begin

  expect_0_0 <= lamp;
  expect_1_0 <= not lamp;
  expect_2_0 <= not lamp;
  expect_3_0 <= lamp;
  expect_3_1 <= '1' when unsigned(on_time_ET) = 0 else '0';
  expect_4_0 <= lamp;
  expect_5_0 <= not lamp;
  expect_6_0 <= lamp;
  expect_7_0 <= not lamp;
  expect_7_1 <= '1' when unsigned(on_time_ET) = 0 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity flasher_tb is
end entity;

architecture tests of flasher_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal enable : std_logic := '0';
  signal lamp : std_logic;
  signal on_time_ET : std_logic_vector(31 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;

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
  core : entity work.flasher_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      enable => enable,
      lamp => lamp,
      on_time_ET => on_time_ET
    );

  expectations : entity work.flasher_expect
    port map (
      clk => clk,
      rst => rst,
      lamp => lamp,
      on_time_ET => on_time_ET,
      expect_0_0 => expect_0_0,
      expect_1_0 => expect_1_0,
      expect_2_0 => expect_2_0,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1
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
      enable <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..2");

    -- on for 1.3 s, off for 0.2 s, and again
    failed := false;
    reset;
    enable <= '1';
    scan(1300, '1');
    wait for 1 ns; -- flasher.ladder:19
    if not failed and (expect_0_0) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0)
          & " lamp=" & image(lamp));
    end if;
    scan(1, '1');
    wait for 1 ns; -- flasher.ladder:21
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " lamp=" & image(lamp));
    end if;
    scan(200, '1');
    wait for 1 ns; -- flasher.ladder:23
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " lamp=" & image(lamp));
    end if;
    scan(1, '1');
    wait for 1 ns; -- flasher.ladder:25
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " lamp=" & image(lamp)
          & " on_time_ET=" & image(on_time_ET));
    end if;
    scan(1300, '1');
    wait for 1 ns; -- flasher.ladder:27
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " lamp=" & image(lamp));
    end if;
    scan(1, '1');
    wait for 1 ns; -- flasher.ladder:29
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " lamp=" & image(lamp));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - on for 1.3 s, off for 0.2 s, and again");
    else
      print("ok 1 - on for 1.3 s, off for 0.2 s, and again");
    end if;

    -- off without enable
    failed := false;
    reset;
    enable <= '1';
    scan(500, '1');
    wait for 1 ns; -- flasher.ladder:34
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " lamp=" & image(lamp));
    end if;
    enable <= '0';
    scan(1, '1');
    wait for 1 ns; -- flasher.ladder:37
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " lamp=" & image(lamp)
          & " on_time_ET=" & image(on_time_ET));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - off without enable");
    else
      print("ok 2 - off without enable");
    end if;

    assert failures = 0 report integer'image(failures) & " of 2 tests failed" severity failure;
    wait;
  end process;
end architecture;
