-- Made by hotrail 0.1.0 from edges_and_latches.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity edges_and_latches_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    on_rise     : in  std_logic;
    on_fall     : in  std_logic;
    shot_up     : in  std_logic;
    coil_up     : in  std_logic;
    shot_down   : in  std_logic;
    coil_down   : in  std_logic;
    latched     : in  std_logic;
    inverted    : in  std_logic;
    started     : in  std_logic;
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
    expect_4_2  : out std_logic;
    expect_4_3  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_8_0  : out std_logic;
    expect_9_0  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_14_0 : out std_logic
  );
end entity edges_and_latches_expect;

architecture rtl of edges_and_latches_expect is
begin

  expect_0_0 <= on_rise;
  expect_0_1 <= not on_fall;
  expect_1_0 <= not on_rise;
  expect_1_1 <= not on_fall;
  expect_2_0 <= not on_rise;
  expect_2_1 <= on_fall;
  expect_3_0 <= not on_rise;
  expect_3_1 <= not on_fall;
  expect_4_0 <= shot_up;
  expect_4_1 <= coil_up;
  expect_4_2 <= not shot_down;
  expect_4_3 <= not coil_down;
  expect_5_0 <= not shot_up;
  expect_5_1 <= not coil_up;
  expect_6_0 <= shot_down;
  expect_6_1 <= coil_down;
  expect_7_0 <= on_rise;
  expect_7_1 <= not on_fall;
  expect_8_0 <= latched;
  expect_9_0 <= not latched;
  expect_10_0 <= inverted;
  expect_11_0 <= not inverted;
  expect_12_0 <= started;
  expect_13_0 <= not started;
  expect_14_0 <= started;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity edges_and_latches_tb is
end entity;

architecture tests of edges_and_latches_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal a : std_logic := '0';
  signal b : std_logic := '0';
  signal clear : std_logic := '0';
  signal on_rise : std_logic;
  signal on_fall : std_logic;
  signal shot_up : std_logic;
  signal shot_down : std_logic;
  signal coil_up : std_logic;
  signal coil_down : std_logic;
  signal latched : std_logic;
  signal inverted : std_logic;
  signal started : std_logic;
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
  signal expect_4_2 : std_logic;
  signal expect_4_3 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;
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
  core : entity work.edges_and_latches
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      a => a,
      b => b,
      clear => clear,
      on_rise => on_rise,
      on_fall => on_fall,
      shot_up => shot_up,
      shot_down => shot_down,
      coil_up => coil_up,
      coil_down => coil_down,
      latched => latched,
      inverted => inverted,
      started => started
    );

  expectations : entity work.edges_and_latches_expect
    port map (
      clk => clk,
      rst => rst,
      on_rise => on_rise,
      on_fall => on_fall,
      shot_up => shot_up,
      coil_up => coil_up,
      shot_down => shot_down,
      coil_down => coil_down,
      latched => latched,
      inverted => inverted,
      started => started,
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
      expect_4_2 => expect_4_2,
      expect_4_3 => expect_4_3,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_9_0 => expect_9_0,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0,
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
      a <= '0';
      b <= '0';
      clear <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..6");

    -- edges last one scan
    failed := false;
    reset;
    a <= '1';
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:32
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " on_rise=" & image(on_rise)
          & " on_fall=" & image(on_fall));
    end if;
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:34
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " on_rise=" & image(on_rise)
          & " on_fall=" & image(on_fall));
    end if;
    a <= '0';
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:36
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " on_rise=" & image(on_rise)
          & " on_fall=" & image(on_fall));
    end if;
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:38
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " on_rise=" & image(on_rise)
          & " on_fall=" & image(on_fall));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - edges last one scan");
    else
      print("ok 1 - edges last one scan");
    end if;

    -- one-shots and edge coils do the same
    failed := false;
    reset;
    a <= '1';
    b <= '1';
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:42
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2 and expect_4_3) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2) & image(expect_4_3)
          & " shot_up=" & image(shot_up)
          & " coil_up=" & image(coil_up)
          & " shot_down=" & image(shot_down)
          & " coil_down=" & image(coil_down));
    end if;
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:44
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " shot_up=" & image(shot_up)
          & " coil_up=" & image(coil_up));
    end if;
    b <= '0';
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:46
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " shot_down=" & image(shot_down)
          & " coil_down=" & image(coil_down));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - one-shots and edge coils do the same");
    else
      print("ok 2 - one-shots and edge coils do the same");
    end if;

    -- an input that is on in the first scan gives a rise and no fall
    failed := false;
    reset;
    a <= '1';
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:50
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " on_rise=" & image(on_rise)
          & " on_fall=" & image(on_fall));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - an input that is on in the first scan gives a rise and no fall");
    else
      print("ok 3 - an input that is on in the first scan gives a rise and no fall");
    end if;

    -- reset wins over set
    failed := false;
    reset;
    a <= '1';
    scan(1, '0');
    a <= '0';
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:54
    if not failed and (expect_8_0) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0)
          & " latched=" & image(latched));
    end if;
    a <= '1';
    clear <= '1';
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:56
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " latched=" & image(latched));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - reset wins over set");
    else
      print("ok 4 - reset wins over set");
    end if;

    -- twice inverted is not inverted
    failed := false;
    reset;
    a <= '1';
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:60
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " inverted=" & image(inverted));
    end if;
    a <= '0';
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:62
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " inverted=" & image(inverted));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 5 - twice inverted is not inverted");
    else
      print("ok 5 - twice inverted is not inverted");
    end if;

    -- the first scan happens once after each reset
    failed := false;
    reset;
    scan(1, '0');
    wait for 1 ns; -- edges_and_latches.ladder:66
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " started=" & image(started));
    end if;
    reset;
    wait for 1 ns; -- edges_and_latches.ladder:68
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " started=" & image(started));
    end if;
    scan(2, '0');
    wait for 1 ns; -- edges_and_latches.ladder:70
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " started=" & image(started));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 6 - the first scan happens once after each reset");
    else
      print("ok 6 - the first scan happens once after each reset");
    end if;

    assert failures = 0 report integer'image(failures) & " of 6 tests failed" severity failure;
    wait;
  end process;
end architecture;
