-- Made by hotrail 0.1.0 from part_counter.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity part_counter_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    parts       : in  std_logic_vector(15 downto 0);
    batch_full  : in  std_logic;
    expect_0_0  : out std_logic;
    expect_1_0  : out std_logic;
    expect_2_0  : out std_logic;
    expect_3_0  : out std_logic;
    expect_4_0  : out std_logic;
    expect_5_0  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_7_0  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic
  );
end entity part_counter_expect;

architecture rtl of part_counter_expect is
begin

  expect_0_0 <= '1' when unsigned(parts) = 0 else '0';
  expect_1_0 <= '1' when unsigned(parts) = 1 else '0';
  expect_2_0 <= '1' when unsigned(parts) = 1 else '0';
  expect_3_0 <= '1' when unsigned(parts) = 2 else '0';
  expect_4_0 <= '1' when unsigned(parts) = 0 else '0';
  expect_5_0 <= '1' when unsigned(parts) = 3 else '0';
  expect_6_0 <= not batch_full;
  expect_6_1 <= '1' when unsigned(parts) = 4 else '0';
  expect_7_0 <= not batch_full;
  expect_8_0 <= batch_full;
  expect_8_1 <= '1' when unsigned(parts) = 5 else '0';
  expect_9_0 <= batch_full;
  expect_9_1 <= '1' when unsigned(parts) = 6 else '0';
  expect_10_0 <= '1' when unsigned(parts) = 1 else '0';
  expect_11_0 <= '1' when unsigned(parts) = 0 else '0';
  expect_12_0 <= '1' when unsigned(parts) = 0 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity part_counter_tb is
end entity;

architecture tests of part_counter_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal part_at_machine : std_logic := '0';
  signal clear : std_logic := '0';
  signal parts : std_logic_vector(15 downto 0);
  signal batch_full : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;

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
  core : entity work.part_counter
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      part_at_machine => part_at_machine,
      clear => clear,
      parts => parts,
      batch_full => batch_full
    );

  expectations : entity work.part_counter_expect
    port map (
      clk => clk,
      rst => rst,
      parts => parts,
      batch_full => batch_full,
      expect_0_0 => expect_0_0,
      expect_1_0 => expect_1_0,
      expect_2_0 => expect_2_0,
      expect_3_0 => expect_3_0,
      expect_4_0 => expect_4_0,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0
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
      part_at_machine <= '0';
      clear <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..6");

    -- half a second makes a part
    failed := false;
    reset;
    part_at_machine <= '1';
    scan(1, '0');
    scan(4, '1');
    wait for 1 ns; -- part_counter.ladder:21
    if not failed and (expect_0_0) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0)
          & " parts=" & image(parts));
    end if;
    scan(1, '1');
    wait for 1 ns; -- part_counter.ladder:23
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " parts=" & image(parts));
    end if;
    scan(600, '1');
    wait for 1 ns; -- part_counter.ladder:25
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " parts=" & image(parts));
    end if;
    part_at_machine <= '0';
    scan(1, '0');
    part_at_machine <= '1';
    scan(1, '0');
    scan(5, '1');
    wait for 1 ns; -- part_counter.ladder:29
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - half a second makes a part");
    else
      print("ok 1 - half a second makes a part");
    end if;

    -- less does not
    failed := false;
    reset;
    for round in 1 to 10 loop
      part_at_machine <= '1';
      scan(1, '0');
      scan(4, '1');
      part_at_machine <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- part_counter.ladder:37
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - less does not");
    else
      print("ok 2 - less does not");
    end if;

    -- a part that flickers when it comes and when it goes is one part
    failed := false;
    reset;
    for round in 1 to 3 loop
      for round_2 in 1 to 4 loop
        part_at_machine <= '1';
        scan(2, '1');
        part_at_machine <= '0';
        scan(1, '1');
      end loop;
      part_at_machine <= '1';
      scan(20, '1');
      part_at_machine <= '0';
      scan(1, '1');
      for round_2 in 1 to 4 loop
        part_at_machine <= '1';
        scan(1, '1');
        part_at_machine <= '0';
        scan(1, '1');
      end loop;
    end loop;
    wait for 1 ns; -- part_counter.ladder:52
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a part that flickers when it comes and when it goes is one part");
    else
      print("ok 3 - a part that flickers when it comes and when it goes is one part");
    end if;

    -- the fifth part fills the batch, more parts still count
    failed := false;
    reset;
    for round in 1 to 4 loop
      part_at_machine <= '1';
      scan(1, '0');
      scan(5, '1');
      part_at_machine <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- part_counter.ladder:60
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " batch_full=" & image(batch_full)
          & " parts=" & image(parts));
    end if;
    part_at_machine <= '1';
    scan(1, '0');
    scan(4, '1');
    wait for 1 ns; -- part_counter.ladder:63
    if not failed and (expect_7_0) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0)
          & " batch_full=" & image(batch_full));
    end if;
    scan(1, '1');
    wait for 1 ns; -- part_counter.ladder:65
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " batch_full=" & image(batch_full)
          & " parts=" & image(parts));
    end if;
    part_at_machine <= '0';
    scan(1, '0');
    part_at_machine <= '1';
    scan(1, '0');
    scan(5, '1');
    wait for 1 ns; -- part_counter.ladder:69
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " batch_full=" & image(batch_full)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - the fifth part fills the batch, more parts still count");
    else
      print("ok 4 - the fifth part fills the batch, more parts still count");
    end if;

    -- cleared with a part in front of the switch: it does not count once more
    failed := false;
    reset;
    part_at_machine <= '1';
    scan(1, '0');
    scan(5, '1');
    wait for 1 ns; -- part_counter.ladder:74
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " parts=" & image(parts));
    end if;
    clear <= '1';
    scan(1, '0');
    clear <= '0';
    scan(1, '0');
    scan(10, '1');
    wait for 1 ns; -- part_counter.ladder:77
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - cleared with a part in front of the switch: it does not count once more");
    else
      print("ok 5 - cleared with a part in front of the switch: it does not count once more");
    end if;

    -- a part that is complete while clear is held is lost
    failed := false;
    reset;
    part_at_machine <= '1';
    clear <= '1';
    scan(1, '0');
    scan(5, '1');
    clear <= '0';
    scan(1, '0');
    scan(10, '1');
    wait for 1 ns; -- part_counter.ladder:84
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " parts=" & image(parts));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - a part that is complete while clear is held is lost");
    else
      print("ok 6 - a part that is complete while clear is held is lost");
    end if;

    assert failures = 0 report integer'image(failures) & " of 6 tests failed" severity failure;
    wait;
  end process;
end architecture;
