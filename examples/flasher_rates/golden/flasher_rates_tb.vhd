-- Made by hotrail 0.1.0 from flasher_rates.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- TON: on-delay timer
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_rates_test_TON is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    power       : in  std_logic;
    PT          : in  unsigned(31 downto 0);
    clear_after : in  std_logic;
    Q           : out std_logic;
    ET          : out unsigned(31 downto 0);
    ET_last     : out unsigned(31 downto 0)
  );
end entity flasher_rates_test_TON;

architecture rtl of flasher_rates_test_TON is
  signal ET_reg : unsigned(31 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal sum : unsigned(31 downto 0);
  signal ET_value : unsigned(31 downto 0);
  signal at_least : std_logic;
  signal ET_next : unsigned(31 downto 0);
begin
  less <= '1' when signed(ET_reg) < signed(PT) else '0';
  sum <= ET_reg + (to_unsigned(0, 31) & (tick and less));
  ET_value <= sum when (power and was) = '1' else to_unsigned(0, 32);
  at_least <= '1' when signed(ET_value) >= signed(PT) else '0';
  ET_next <= to_unsigned(0, 32) when clear_after = '1' else ET_value;

  Q <= power and at_least;
  ET <= ET_value;
  ET_last <= ET_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET_reg <= (others => '0');
        was <= '0';
      else
        ET_reg <= ET_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_rates_test is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    tick     : in  std_logic;
    enable   : in  std_logic;
    slow     : in  std_logic;
    lamp     : out std_logic;
    cycle_ET : out std_logic_vector(31 downto 0)
  );
end entity flasher_rates_test;

architecture rtl of flasher_rates_test is
  signal on_time : unsigned(4 downto 0) := (others => '0');
  signal cycle_PT : unsigned(5 downto 0) := (others => '0');
  signal lamp_reg : std_logic := '0';
  signal rung1_power : std_logic;
  signal on_time_rung1 : unsigned(4 downto 0);
  signal cycle_PT_rung1 : unsigned(5 downto 0);
  signal on_time_next : unsigned(4 downto 0);
  signal cycle_PT_next : unsigned(5 downto 0);
  signal cycle_PT_2 : unsigned(31 downto 0);
  signal cycle_Q : std_logic;
  signal cycle_ET_2 : unsigned(31 downto 0);
  signal cycle_ET_last : unsigned(31 downto 0);
  signal rung2_choice : unsigned(31 downto 0);
  signal rung3_less : std_logic;
  signal lamp_next : std_logic;
begin

  -- rung 1 "rate", flasher_rates.ladder:12
  rung1_power <= not slow;
  on_time_rung1 <= to_unsigned(13, 5) when rung1_power = '1' else on_time;
  cycle_PT_rung1 <= to_unsigned(25, 6) when rung1_power = '1' else cycle_PT;
  on_time_next <= to_unsigned(25, 5) when slow = '1' else on_time_rung1;
  cycle_PT_next <= to_unsigned(42, 6) when slow = '1' else cycle_PT_rung1;
  cycle_PT_2 <= resize(cycle_PT_next, 32);

  -- rung 2 "one cycle after the other", flasher_rates.ladder:17
  cycle: entity work.flasher_rates_test_TON
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => enable,
      PT => cycle_PT_2,
      clear_after => cycle_Q,
      Q => cycle_Q,
      ET => cycle_ET_2,
      ET_last => cycle_ET_last
    );
  rung2_choice <= to_unsigned(0, 32) when cycle_Q = '1' else cycle_ET_2;

  -- rung 3 "lit in its first part", flasher_rates.ladder:20
  rung3_less <= '1' when signed(rung2_choice) < signed(resize(on_time_next, 32)) else '0';
  lamp_next <= enable and rung3_less;

  lamp <= lamp_reg;
  cycle_ET <= std_logic_vector(cycle_ET_last);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        on_time <= (others => '0');
        cycle_PT <= (others => '0');
        lamp_reg <= '0';
      else
        on_time <= on_time_next;
        cycle_PT <= cycle_PT_next;
        lamp_reg <= lamp_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_rates_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    lamp        : in  std_logic;
    cycle_ET    : in  std_logic_vector(31 downto 0);
    expect_0_0  : out std_logic;
    expect_1_0  : out std_logic;
    expect_2_0  : out std_logic;
    expect_3_0  : out std_logic;
    expect_4_0  : out std_logic;
    expect_5_0  : out std_logic;
    expect_6_0  : out std_logic;
    expect_7_0  : out std_logic;
    expect_8_0  : out std_logic;
    expect_9_0  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
    expect_15_1 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic
  );
end entity flasher_rates_expect;

architecture rtl of flasher_rates_expect is
begin

  expect_0_0 <= lamp;
  expect_1_0 <= lamp;
  expect_2_0 <= not lamp;
  expect_3_0 <= not lamp;
  expect_4_0 <= lamp;
  expect_5_0 <= lamp;
  expect_6_0 <= lamp;
  expect_7_0 <= not lamp;
  expect_8_0 <= not lamp;
  expect_9_0 <= lamp;
  expect_10_0 <= not lamp;
  expect_10_1 <= '1' when unsigned(cycle_ET) = 0 else '0';
  expect_11_0 <= not lamp;
  expect_12_0 <= lamp;
  expect_13_0 <= not lamp;
  expect_14_0 <= not lamp;
  expect_15_0 <= '1' when unsigned(cycle_ET) = 0 else '0';
  expect_15_1 <= lamp;
  expect_16_0 <= lamp;
  expect_17_0 <= not lamp;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity flasher_rates_tb is
end entity;

architecture tests of flasher_rates_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal enable : std_logic := '0';
  signal slow : std_logic := '0';
  signal lamp : std_logic;
  signal cycle_ET : std_logic_vector(31 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
  signal expect_15_1 : std_logic;
  signal expect_16_0 : std_logic;
  signal expect_17_0 : std_logic;

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
  core : entity work.flasher_rates_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      enable => enable,
      slow => slow,
      lamp => lamp,
      cycle_ET => cycle_ET
    );

  expectations : entity work.flasher_rates_expect
    port map (
      clk => clk,
      rst => rst,
      lamp => lamp,
      cycle_ET => cycle_ET,
      expect_0_0 => expect_0_0,
      expect_1_0 => expect_1_0,
      expect_2_0 => expect_2_0,
      expect_3_0 => expect_3_0,
      expect_4_0 => expect_4_0,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_7_0 => expect_7_0,
      expect_8_0 => expect_8_0,
      expect_9_0 => expect_9_0,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
      expect_15_1 => expect_15_1,
      expect_16_0 => expect_16_0,
      expect_17_0 => expect_17_0
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
      slow <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..4");

    -- on for 1.3 s, off for 1.2 s, for ever
    failed := false;
    reset;
    enable <= '1';
    scan(1, '0');
    for round in 1 to 4 loop
      wait for 1 ns; -- flasher_rates.ladder:26
      if not failed and (expect_0_0) /= '1' then
        failed := true;
        print("# failed expectation 0 conducts " & image(expect_0_0)
            & " lamp=" & image(lamp));
      end if;
      scan(12, '1');
      wait for 1 ns; -- flasher_rates.ladder:28
      if not failed and (expect_1_0) /= '1' then
        failed := true;
        print("# failed expectation 1 conducts " & image(expect_1_0)
            & " lamp=" & image(lamp));
      end if;
      scan(1, '1');
      wait for 1 ns; -- flasher_rates.ladder:30
      if not failed and (expect_2_0) /= '1' then
        failed := true;
        print("# failed expectation 2 conducts " & image(expect_2_0)
            & " lamp=" & image(lamp));
      end if;
      scan(11, '1');
      wait for 1 ns; -- flasher_rates.ladder:32
      if not failed and (expect_3_0) /= '1' then
        failed := true;
        print("# failed expectation 3 conducts " & image(expect_3_0)
            & " lamp=" & image(lamp));
      end if;
      scan(1, '1');
    end loop;
    wait for 1 ns; -- flasher_rates.ladder:35
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " lamp=" & image(lamp));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - on for 1.3 s, off for 1.2 s, for ever");
    else
      print("ok 1 - on for 1.3 s, off for 1.2 s, for ever");
    end if;

    -- on for 2.5 s, off for 1.7 s, for ever
    failed := false;
    reset;
    enable <= '1';
    slow <= '1';
    scan(1, '0');
    for round in 1 to 4 loop
      wait for 1 ns; -- flasher_rates.ladder:40
      if not failed and (expect_5_0) /= '1' then
        failed := true;
        print("# failed expectation 5 conducts " & image(expect_5_0)
            & " lamp=" & image(lamp));
      end if;
      scan(24, '1');
      wait for 1 ns; -- flasher_rates.ladder:42
      if not failed and (expect_6_0) /= '1' then
        failed := true;
        print("# failed expectation 6 conducts " & image(expect_6_0)
            & " lamp=" & image(lamp));
      end if;
      scan(1, '1');
      wait for 1 ns; -- flasher_rates.ladder:44
      if not failed and (expect_7_0) /= '1' then
        failed := true;
        print("# failed expectation 7 conducts " & image(expect_7_0)
            & " lamp=" & image(lamp));
      end if;
      scan(16, '1');
      wait for 1 ns; -- flasher_rates.ladder:46
      if not failed and (expect_8_0) /= '1' then
        failed := true;
        print("# failed expectation 8 conducts " & image(expect_8_0)
            & " lamp=" & image(lamp));
      end if;
      scan(1, '1');
    end loop;
    wait for 1 ns; -- flasher_rates.ladder:49
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " lamp=" & image(lamp));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - on for 2.5 s, off for 1.7 s, for ever");
    else
      print("ok 2 - on for 2.5 s, off for 1.7 s, for ever");
    end if;

    -- off at once without enable, and from the beginning with it
    failed := false;
    reset;
    enable <= '1';
    scan(1, '0');
    scan(7, '1');
    enable <= '0';
    scan(1, '0');
    wait for 1 ns; -- flasher_rates.ladder:55
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " lamp=" & image(lamp)
          & " cycle_ET=" & image(cycle_ET));
    end if;
    scan(20, '1');
    wait for 1 ns; -- flasher_rates.ladder:57
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " lamp=" & image(lamp));
    end if;
    enable <= '1';
    scan(1, '0');
    scan(12, '1');
    wait for 1 ns; -- flasher_rates.ladder:60
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " lamp=" & image(lamp));
    end if;
    scan(1, '1');
    wait for 1 ns; -- flasher_rates.ladder:62
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " lamp=" & image(lamp));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - off at once without enable, and from the beginning with it");
    else
      print("ok 3 - off at once without enable, and from the beginning with it");
    end if;

    -- a shorter cycle chosen when it is over already begins anew
    failed := false;
    reset;
    enable <= '1';
    slow <= '1';
    scan(1, '0');
    scan(30, '1');
    wait for 1 ns; -- flasher_rates.ladder:67
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " lamp=" & image(lamp));
    end if;
    slow <= '0';
    scan(1, '0');
    wait for 1 ns; -- flasher_rates.ladder:69
    if not failed and (expect_15_0 and expect_15_1) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0) & image(expect_15_1)
          & " cycle_ET=" & image(cycle_ET)
          & " lamp=" & image(lamp));
    end if;
    scan(12, '1');
    wait for 1 ns; -- flasher_rates.ladder:71
    if not failed and (expect_16_0) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0)
          & " lamp=" & image(lamp));
    end if;
    scan(1, '1');
    wait for 1 ns; -- flasher_rates.ladder:73
    if not failed and (expect_17_0) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0)
          & " lamp=" & image(lamp));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a shorter cycle chosen when it is over already begins anew");
    else
      print("ok 4 - a shorter cycle chosen when it is over already begins anew");
    end if;

    assert failures = 0 report integer'image(failures) & " of 4 tests failed" severity failure;
    wait;
  end process;
end architecture;
