-- Made by hotrail 0.1.0 from debounce.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity debounce_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    settled     : in  std_logic;
    at_once     : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_6_0  : out std_logic;
    expect_7_0  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_12_0 : out std_logic;
    expect_12_1 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic
  );
end entity debounce_expect;

architecture rtl of debounce_expect is
begin

  expect_0_0 <= not settled;
  expect_0_1 <= at_once;
  expect_1_0 <= not settled;
  expect_1_1 <= at_once;
  expect_2_0 <= not settled;
  expect_2_1 <= at_once;
  expect_3_0 <= not settled;
  expect_3_1 <= at_once;
  expect_4_0 <= settled;
  expect_4_1 <= at_once;
  expect_5_0 <= not settled;
  expect_5_1 <= at_once;
  expect_6_0 <= at_once;
  expect_7_0 <= not at_once;
  expect_8_0 <= not settled;
  expect_8_1 <= at_once;
  expect_9_0 <= not settled;
  expect_9_1 <= at_once;
  expect_10_0 <= not settled;
  expect_10_1 <= not at_once;
  expect_11_0 <= not settled;
  expect_11_1 <= at_once;
  expect_12_0 <= not settled;
  expect_12_1 <= not at_once;
  expect_13_0 <= at_once;
  expect_14_0 <= not at_once;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity debounce_tb is
end entity;

architecture tests of debounce_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal limit_switch_1 : std_logic := '0';
  signal settled : std_logic;
  signal at_once : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_14_0 : std_logic;

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
  core : entity work.debounce
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      limit_switch_1 => limit_switch_1,
      settled => settled,
      at_once => at_once
    );

  expectations : entity work.debounce_expect
    port map (
      clk => clk,
      rst => rst,
      settled => settled,
      at_once => at_once,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_7_0 => expect_7_0,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1,
      expect_13_0 => expect_13_0,
      expect_14_0 => expect_14_0
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
      limit_switch_1 <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..5");

    -- a switch that bounces
    failed := false;
    reset;
    limit_switch_1 <= '1';
    scan(1, '0');
    wait for 1 ns; -- debounce.ladder:19
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " settled=" & image(settled)
          & " at_once=" & image(at_once));
    end if;
    for round in 1 to 6 loop
      limit_switch_1 <= '0';
      scan(2, '1');
      wait for 1 ns; -- debounce.ladder:22
      if not failed and (expect_1_0 and expect_1_1) /= '1' then
        failed := true;
        print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
            & " settled=" & image(settled)
            & " at_once=" & image(at_once));
      end if;
      limit_switch_1 <= '1';
      scan(1, '1');
      wait for 1 ns; -- debounce.ladder:24
      if not failed and (expect_2_0 and expect_2_1) /= '1' then
        failed := true;
        print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
            & " settled=" & image(settled)
            & " at_once=" & image(at_once));
      end if;
    end loop;
    scan(49, '1');
    wait for 1 ns; -- debounce.ladder:27
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " settled=" & image(settled)
          & " at_once=" & image(at_once));
    end if;
    scan(1, '1');
    wait for 1 ns; -- debounce.ladder:29
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " settled=" & image(settled)
          & " at_once=" & image(at_once));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - a switch that bounces");
    else
      print("ok 1 - a switch that bounces");
    end if;

    -- the trailing edge: one at once, the other after the bridge
    failed := false;
    reset;
    limit_switch_1 <= '1';
    scan(1, '0');
    scan(100, '1');
    limit_switch_1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- debounce.ladder:35
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " settled=" & image(settled)
          & " at_once=" & image(at_once));
    end if;
    scan(4, '1');
    wait for 1 ns; -- debounce.ladder:37
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " at_once=" & image(at_once));
    end if;
    scan(1, '1');
    wait for 1 ns; -- debounce.ladder:39
    if not failed and (expect_7_0) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0)
          & " at_once=" & image(at_once));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - the trailing edge: one at once, the other after the bridge");
    else
      print("ok 2 - the trailing edge: one at once, the other after the bridge");
    end if;

    -- a trailing edge that bounces gives no second signal
    failed := false;
    reset;
    limit_switch_1 <= '1';
    scan(1, '0');
    scan(100, '1');
    for round in 1 to 4 loop
      limit_switch_1 <= '0';
      scan(2, '1');
      wait for 1 ns; -- debounce.ladder:46
      if not failed and (expect_8_0 and expect_8_1) /= '1' then
        failed := true;
        print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
            & " settled=" & image(settled)
            & " at_once=" & image(at_once));
      end if;
      limit_switch_1 <= '1';
      scan(1, '1');
      wait for 1 ns; -- debounce.ladder:48
      if not failed and (expect_9_0 and expect_9_1) /= '1' then
        failed := true;
        print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
            & " settled=" & image(settled)
            & " at_once=" & image(at_once));
      end if;
    end loop;
    limit_switch_1 <= '0';
    scan(1, '0');
    scan(5, '1');
    wait for 1 ns; -- debounce.ladder:52
    if not failed and (expect_10_0 and expect_10_1) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1)
          & " settled=" & image(settled)
          & " at_once=" & image(at_once));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a trailing edge that bounces gives no second signal");
    else
      print("ok 3 - a trailing edge that bounces gives no second signal");
    end if;

    -- a touch that is too short
    failed := false;
    reset;
    limit_switch_1 <= '1';
    scan(1, '0');
    scan(49, '1');
    limit_switch_1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- debounce.ladder:58
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " settled=" & image(settled)
          & " at_once=" & image(at_once));
    end if;
    scan(100, '1');
    wait for 1 ns; -- debounce.ladder:60
    if not failed and (expect_12_0 and expect_12_1) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
          & " settled=" & image(settled)
          & " at_once=" & image(at_once));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a touch that is too short");
    else
      print("ok 4 - a touch that is too short");
    end if;

    -- a gap as long as the bridge ends the signal
    failed := false;
    reset;
    limit_switch_1 <= '1';
    scan(1, '0');
    limit_switch_1 <= '0';
    scan(1, '0');
    scan(4, '1');
    wait for 1 ns; -- debounce.ladder:65
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " at_once=" & image(at_once));
    end if;
    limit_switch_1 <= '1';
    scan(1, '0');
    limit_switch_1 <= '0';
    scan(1, '0');
    scan(5, '1');
    wait for 1 ns; -- debounce.ladder:69
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " at_once=" & image(at_once));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - a gap as long as the bridge ends the signal");
    else
      print("ok 5 - a gap as long as the bridge ends the signal");
    end if;

    assert failures = 0 report integer'image(failures) & " of 5 tests failed" severity failure;
    wait;
  end process;
end architecture;
