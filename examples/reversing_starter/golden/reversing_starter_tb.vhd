-- Made by hotrail 0.1.0 from reversing_starter.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity reversing_starter_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    run_forward : in  std_logic;
    run_reverse : in  std_logic;
    fault       : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_1_0  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_4_0  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic
  );
end entity reversing_starter_expect;

architecture rtl of reversing_starter_expect is
begin

  expect_0_0 <= run_forward;
  expect_0_1 <= not run_reverse;
  expect_1_0 <= not run_forward;
  expect_2_0 <= run_reverse;
  expect_2_1 <= not run_forward;
  expect_3_0 <= not run_forward;
  expect_3_1 <= run_reverse;
  expect_4_0 <= run_reverse;
  expect_5_0 <= not run_forward;
  expect_5_1 <= not run_reverse;
  expect_6_0 <= not run_forward;
  expect_6_1 <= fault;
  expect_7_0 <= not run_forward;
  expect_7_1 <= not fault;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity reversing_starter_tb is
end entity;

architecture tests of reversing_starter_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal stop : std_logic := '0';
  signal overload : std_logic := '0';
  signal forward : std_logic := '0';
  signal reverse : std_logic := '0';
  signal run_forward : std_logic;
  signal run_reverse : std_logic;
  signal fault : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
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
  core : entity work.reversing_starter
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      stop => stop,
      overload => overload,
      forward => forward,
      reverse => reverse,
      run_forward => run_forward,
      run_reverse => run_reverse,
      fault => fault
    );

  expectations : entity work.reversing_starter_expect
    port map (
      clk => clk,
      rst => rst,
      run_forward => run_forward,
      run_reverse => run_reverse,
      fault => fault,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
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
      stop <= '0';
      overload <= '0';
      forward <= '0';
      reverse <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..4");

    -- forward seals in and reverse needs a stop first
    failed := false;
    reset;
    stop <= '1';
    forward <= '1';
    scan(1, '0');
    forward <= '0';
    scan(1, '0');
    wait for 1 ns; -- reversing_starter.ladder:22
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " run_forward=" & image(run_forward)
          & " run_reverse=" & image(run_reverse));
    end if;
    stop <= '0';
    scan(1, '0');
    wait for 1 ns; -- reversing_starter.ladder:24
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " run_forward=" & image(run_forward));
    end if;
    stop <= '1';
    reverse <= '1';
    scan(1, '0');
    reverse <= '0';
    scan(1, '0');
    wait for 1 ns; -- reversing_starter.ladder:27
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " run_reverse=" & image(run_reverse)
          & " run_forward=" & image(run_forward));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - forward seals in and reverse needs a stop first");
    else
      print("ok 1 - forward seals in and reverse needs a stop first");
    end if;

    -- the other button drops the contactor before the other one closes
    failed := false;
    reset;
    stop <= '1';
    forward <= '1';
    scan(1, '0');
    forward <= '0';
    scan(1, '0');
    reverse <= '1';
    scan(1, '0');
    wait for 1 ns; -- reversing_starter.ladder:33
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " run_forward=" & image(run_forward)
          & " run_reverse=" & image(run_reverse));
    end if;
    reverse <= '0';
    scan(1, '0');
    wait for 1 ns; -- reversing_starter.ladder:35
    if not failed and (expect_4_0) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0)
          & " run_reverse=" & image(run_reverse));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - the other button drops the contactor before the other one closes");
    else
      print("ok 2 - the other button drops the contactor before the other one closes");
    end if;

    -- both buttons together start nothing
    failed := false;
    reset;
    stop <= '1';
    forward <= '1';
    reverse <= '1';
    scan(3, '0');
    wait for 1 ns; -- reversing_starter.ladder:39
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " run_forward=" & image(run_forward)
          & " run_reverse=" & image(run_reverse));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - both buttons together start nothing");
    else
      print("ok 3 - both buttons together start nothing");
    end if;

    -- overload stops either direction
    failed := false;
    reset;
    stop <= '1';
    forward <= '1';
    scan(1, '0');
    forward <= '0';
    scan(1, '0');
    overload <= '1';
    scan(1, '0');
    wait for 1 ns; -- reversing_starter.ladder:45
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " run_forward=" & image(run_forward)
          & " fault=" & image(fault));
    end if;
    overload <= '0';
    scan(1, '0');
    wait for 1 ns; -- reversing_starter.ladder:47
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " run_forward=" & image(run_forward)
          & " fault=" & image(fault));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - overload stops either direction");
    else
      print("ok 4 - overload stops either direction");
    end if;

    assert failures = 0 report integer'image(failures) & " of 4 tests failed" severity failure;
    wait;
  end process;
end architecture;
