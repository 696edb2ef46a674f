-- Made by hotrail 0.1.0 from order_next_scan.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity order_next_scan_expect is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    Y0         : in  std_logic;
    Y1         : in  std_logic;
    expect_0_0 : out std_logic;
    expect_0_1 : out std_logic;
    expect_1_0 : out std_logic;
    expect_1_1 : out std_logic;
    expect_2_0 : out std_logic;
    expect_2_1 : out std_logic;
    expect_3_0 : out std_logic;
    expect_3_1 : out std_logic
  );
end entity order_next_scan_expect;

architecture rtl of order_next_scan_expect is
begin

  expect_0_0 <= Y0;
  expect_0_1 <= not Y1;
  expect_1_0 <= Y0;
  expect_1_1 <= Y1;
  expect_2_0 <= not Y0;
  expect_2_1 <= Y1;
  expect_3_0 <= not Y0;
  expect_3_1 <= not Y1;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity order_next_scan_tb is
end entity;

architecture tests of order_next_scan_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal X0 : std_logic := '0';
  signal Y0 : std_logic;
  signal Y1 : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;

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
  core : entity work.order_next_scan
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      X0 => X0,
      Y0 => Y0,
      Y1 => Y1
    );

  expectations : entity work.order_next_scan_expect
    port map (
      clk => clk,
      rst => rst,
      Y0 => Y0,
      Y1 => Y1,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1
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
      X0 <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..1");

    -- Y1 follows one scan later
    failed := false;
    reset;
    X0 <= '1';
    scan(1, '0');
    wait for 1 ns; -- order_next_scan.ladder:12
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " Y0=" & image(Y0)
          & " Y1=" & image(Y1));
    end if;
    scan(1, '0');
    wait for 1 ns; -- order_next_scan.ladder:14
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " Y0=" & image(Y0)
          & " Y1=" & image(Y1));
    end if;
    X0 <= '0';
    scan(1, '0');
    wait for 1 ns; -- order_next_scan.ladder:16
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " Y0=" & image(Y0)
          & " Y1=" & image(Y1));
    end if;
    scan(1, '0');
    wait for 1 ns; -- order_next_scan.ladder:18
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " Y0=" & image(Y0)
          & " Y1=" & image(Y1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - Y1 follows one scan later");
    else
      print("ok 1 - Y1 follows one scan later");
    end if;

    assert failures = 0 report integer'image(failures) & " of 1 tests failed" severity failure;
    wait;
  end process;
end architecture;
