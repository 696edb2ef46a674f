-- Made by hotrail 0.1.0 from bridge.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity bridge_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    CR316       : in  std_logic;
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
    expect_13_0 : out std_logic
  );
end entity bridge_expect;

architecture rtl of bridge_expect is
begin

  expect_0_0 <= not CR316;
  expect_1_0 <= CR316;
  expect_2_0 <= not CR316;
  expect_3_0 <= CR316;
  expect_4_0 <= not CR316;
  expect_5_0 <= CR316;
  expect_6_0 <= not CR316;
  expect_7_0 <= CR316;
  expect_8_0 <= not CR316;
  expect_9_0 <= CR316;
  expect_10_0 <= not CR316;
  expect_11_0 <= CR316;
  expect_12_0 <= not CR316;
  expect_13_0 <= not CR316;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity bridge_tb is
end entity;

architecture tests of bridge_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal c1 : std_logic := '0';
  signal c2 : std_logic := '0';
  signal c3 : std_logic := '0';
  signal c4 : std_logic := '0';
  signal c5 : std_logic := '0';
  signal c6 : std_logic := '0';
  signal c7 : std_logic := '0';
  signal c8 : std_logic := '0';
  signal c9 : std_logic := '0';
  signal CR316 : std_logic;
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
  core : entity work.bridge
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      c1 => c1,
      c2 => c2,
      c3 => c3,
      c4 => c4,
      c5 => c5,
      c6 => c6,
      c7 => c7,
      c8 => c8,
      c9 => c9,
      CR316 => CR316
    );

  expectations : entity work.bridge_expect
    port map (
      clk => clk,
      rst => rst,
      CR316 => CR316,
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
      expect_13_0 => expect_13_0
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
      c1 <= '0';
      c2 <= '0';
      c3 <= '0';
      c4 <= '0';
      c5 <= '0';
      c6 <= '0';
      c7 <= '0';
      c8 <= '0';
      c9 <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..7");

    -- 9-1
    failed := false;
    reset;
    c9 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:18
    if not failed and (expect_0_0) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0)
          & " CR316=" & image(CR316));
    end if;
    c1 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:20
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " CR316=" & image(CR316));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - 9-1");
    else
      print("ok 1 - 9-1");
    end if;

    -- 2-3-4-1
    failed := false;
    reset;
    c2 <= '1';
    c4 <= '1';
    c1 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:24
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " CR316=" & image(CR316));
    end if;
    c3 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:26
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " CR316=" & image(CR316));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - 2-3-4-1");
    else
      print("ok 2 - 2-3-4-1");
    end if;

    -- 5-6-1: contact 6 from right to left
    failed := false;
    reset;
    c5 <= '1';
    c1 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:30
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " CR316=" & image(CR316));
    end if;
    c6 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:32
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " CR316=" & image(CR316));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - 5-6-1: contact 6 from right to left");
    else
      print("ok 3 - 5-6-1: contact 6 from right to left");
    end if;

    -- 5-7-8
    failed := false;
    reset;
    c5 <= '1';
    c7 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:36
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " CR316=" & image(CR316));
    end if;
    c8 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:38
    if not failed and (expect_7_0) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0)
          & " CR316=" & image(CR316));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - 5-7-8");
    else
      print("ok 4 - 5-7-8");
    end if;

    -- 9-6-7-8: contact 6 from left to right
    failed := false;
    reset;
    c9 <= '1';
    c7 <= '1';
    c8 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:42
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " CR316=" & image(CR316));
    end if;
    c6 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:44
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " CR316=" & image(CR316));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - 9-6-7-8: contact 6 from left to right");
    else
      print("ok 5 - 9-6-7-8: contact 6 from left to right");
    end if;

    -- 2-3-4-6-7-8
    failed := false;
    reset;
    c2 <= '1';
    c3 <= '1';
    c4 <= '1';
    c7 <= '1';
    c8 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:48
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " CR316=" & image(CR316));
    end if;
    c6 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:50
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " CR316=" & image(CR316));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - 2-3-4-6-7-8");
    else
      print("ok 6 - 2-3-4-6-7-8");
    end if;

    -- no path: everything behind the nodes, and contact 6 between them
    failed := false;
    reset;
    c6 <= '1';
    c1 <= '1';
    c7 <= '1';
    c8 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:54
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " CR316=" & image(CR316));
    end if;
    c2 <= '1';
    c3 <= '1';
    scan(1, '0');
    wait for 1 ns; -- bridge.ladder:56
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " CR316=" & image(CR316));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 7 - no path: everything behind the nodes, and contact 6 between them");
    else
      print("ok 7 - no path: everything behind the nodes, and contact 6 between them");
    end if;

    assert failures = 0 report integer'image(failures) & " of 7 tests failed" severity failure;
    wait;
  end process;
end architecture;
