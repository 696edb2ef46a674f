-- Made by hotrail 0.1.0 from race_three_pushes.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity race_three_pushes_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    won         : in  std_logic;
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
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic;
    expect_16_0 : out std_logic;
    expect_17_0 : out std_logic
  );
end entity race_three_pushes_expect;

architecture rtl of race_three_pushes_expect is
begin

  expect_0_0 <= not won;
  expect_1_0 <= won;
  expect_2_0 <= not won;
  expect_3_0 <= not won;
  expect_4_0 <= not won;
  expect_5_0 <= won;
  expect_6_0 <= not won;
  expect_7_0 <= not won;
  expect_8_0 <= won;
  expect_9_0 <= not won;
  expect_10_0 <= not won;
  expect_11_0 <= won;
  expect_12_0 <= not won;
  expect_13_0 <= not won;
  expect_14_0 <= won;
  expect_15_0 <= not won;
  expect_16_0 <= not won;
  expect_17_0 <= won;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity race_three_pushes_tb is
end entity;

architecture tests of race_three_pushes_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal button : std_logic := '0';
  signal clear : std_logic := '0';
  signal won : std_logic;
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
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;
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
  core : entity work.race_three_pushes
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      button => button,
      clear => clear,
      won => won
    );

  expectations : entity work.race_three_pushes_expect
    port map (
      clk => clk,
      rst => rst,
      won => won,
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
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0,
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
      button <= '0';
      clear <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..9");

    -- three pushes, the third in the last moment
    failed := false;
    reset;
    scan(100, '1');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(10, '1');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:35
    if not failed and (expect_0_0) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0)
          & " won=" & image(won));
    end if;
    scan(9, '1');
    button <= '1';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:38
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - three pushes, the third in the last moment");
    else
      print("ok 1 - three pushes, the third in the last moment");
    end if;

    -- the third push a moment too late
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(10, '1');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(10, '1');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:46
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - the third push a moment too late");
    else
      print("ok 2 - the third push a moment too late");
    end if;

    -- a push with the tick that ends the time is too late
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(10, '1');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(9, '1');
    button <= '1';
    scan(1, '1');
    wait for 1 ns; -- race_three_pushes.ladder:54
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a push with the tick that ends the time is too late");
    else
      print("ok 3 - a push with the tick that ends the time is too late");
    end if;

    -- any three in a row: 0 s, 1.8 s, 2.1 s, 2.2 s
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(18, '1');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    scan(3, '1');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:62
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " won=" & image(won));
    end if;
    scan(1, '1');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:65
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - any three in a row: 0 s, 1.8 s, 2.1 s, 2.2 s");
    else
      print("ok 4 - any three in a row: 0 s, 1.8 s, 2.1 s, 2.2 s");
    end if;

    -- one push each second is never enough
    failed := false;
    reset;
    for round in 1 to 10 loop
      button <= '1';
      scan(1, '0');
      button <= '0';
      scan(1, '0');
      scan(10, '1');
    end loop;
    wait for 1 ns; -- race_three_pushes.ladder:72
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - one push each second is never enough");
    else
      print("ok 5 - one push each second is never enough");
    end if;

    -- three pushes right after power-up
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:77
    if not failed and (expect_7_0) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0)
          & " won=" & image(won));
    end if;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:79
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - three pushes right after power-up");
    else
      print("ok 6 - three pushes right after power-up");
    end if;

    -- a held button is one push
    failed := false;
    reset;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:84
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " won=" & image(won));
    end if;
    scan(100, '1');
    button <= '1';
    scan(5, '0');
    scan(10, '1');
    wait for 1 ns; -- race_three_pushes.ladder:88
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - a held button is one push");
    else
      print("ok 7 - a held button is one push");
    end if;

    -- a race that is won stays won until it is cleared
    failed := false;
    reset;
    for round in 1 to 3 loop
      button <= '1';
      scan(1, '0');
      button <= '0';
      scan(1, '0');
    end loop;
    scan(100, '1');
    wait for 1 ns; -- race_three_pushes.ladder:93
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " won=" & image(won));
    end if;
    clear <= '1';
    scan(1, '0');
    clear <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:95
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " won=" & image(won));
    end if;
    for round in 1 to 2 loop
      button <= '1';
      scan(1, '0');
      button <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- race_three_pushes.ladder:97
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " won=" & image(won));
    end if;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:99
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 8 - a race that is won stays won until it is cleared");
    else
      print("ok 8 - a race that is won stays won until it is cleared");
    end if;

    -- clear wins over the third push
    failed := false;
    reset;
    for round in 1 to 2 loop
      button <= '1';
      scan(1, '0');
      button <= '0';
      scan(1, '0');
    end loop;
    button <= '1';
    clear <= '1';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:104
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " won=" & image(won));
    end if;
    button <= '0';
    clear <= '0';
    scan(1, '0');
    for round in 1 to 2 loop
      button <= '1';
      scan(1, '0');
      button <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- race_three_pushes.ladder:107
    if not failed and (expect_16_0) /= '1' then
      failed := true;
      print("# failed expectation 16 conducts " & image(expect_16_0)
          & " won=" & image(won));
    end if;
    button <= '1';
    scan(1, '0');
    button <= '0';
    scan(1, '0');
    wait for 1 ns; -- race_three_pushes.ladder:109
    if not failed and (expect_17_0) /= '1' then
      failed := true;
      print("# failed expectation 17 conducts " & image(expect_17_0)
          & " won=" & image(won));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 9 - clear wins over the third push");
    else
      print("ok 9 - clear wins over the third push");
    end if;

    assert failures = 0 report integer'image(failures) & " of 9 tests failed" severity failure;
    wait;
  end process;
end architecture;
