-- Made by hotrail 0.1.0 from ab_flasher.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_flasher_expect is
  port (
    clk           : in  std_logic;
    rst           : in  std_logic;
    ab_light      : in  std_logic;
    siemens_light : in  std_logic;
    expect_0_0    : out std_logic;
    expect_0_1    : out std_logic;
    expect_1_0    : out std_logic;
    expect_1_1    : out std_logic;
    expect_2_0    : out std_logic;
    expect_2_1    : out std_logic;
    expect_3_0    : out std_logic;
    expect_3_1    : out std_logic;
    expect_4_0    : out std_logic;
    expect_4_1    : out std_logic;
    expect_5_0    : out std_logic;
    expect_5_1    : out std_logic;
    expect_6_0    : out std_logic;
    expect_6_1    : out std_logic;
    expect_7_0    : out std_logic;
    expect_7_1    : out std_logic;
    expect_8_0    : out std_logic;
    expect_8_1    : out std_logic;
    expect_9_0    : out std_logic;
    expect_9_1    : out std_logic
  );
end entity ab_flasher_expect;

architecture rtl of ab_flasher_expect is
begin

  expect_0_0 <= ab_light;
  expect_0_1 <= siemens_light;
  expect_1_0 <= ab_light;
  expect_1_1 <= siemens_light;
  expect_2_0 <= ab_light;
  expect_2_1 <= siemens_light;
  expect_3_0 <= not ab_light;
  expect_3_1 <= not siemens_light;
  expect_4_0 <= not ab_light;
  expect_4_1 <= not siemens_light;
  expect_5_0 <= ab_light;
  expect_5_1 <= siemens_light;
  expect_6_0 <= ab_light;
  expect_6_1 <= siemens_light;
  expect_7_0 <= not ab_light;
  expect_7_1 <= not siemens_light;
  expect_8_0 <= ab_light;
  expect_8_1 <= siemens_light;
  expect_9_0 <= not ab_light;
  expect_9_1 <= not siemens_light;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity ab_flasher_tb is
end entity;

architecture tests of ab_flasher_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal enable : std_logic := '0';
  signal ab_light : std_logic;
  signal siemens_light : std_logic;
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
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;

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
  core : entity work.ab_flasher
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      enable => enable,
      ab_light => ab_light,
      siemens_light => siemens_light
    );

  expectations : entity work.ab_flasher_expect
    port map (
      clk => clk,
      rst => rst,
      ab_light => ab_light,
      siemens_light => siemens_light,
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
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1
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

    -- both flash alike, for three periods
    failed := false;
    reset;
    enable <= '1';
    scan(1, '0');
    scan(500, '1');
    wait for 1 ns; -- ab_flasher.ladder:25
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " ab_light=" & image(ab_light)
          & " siemens_light=" & image(siemens_light));
    end if;
    scan(299, '1');
    wait for 1 ns; -- ab_flasher.ladder:27
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " ab_light=" & image(ab_light)
          & " siemens_light=" & image(siemens_light));
    end if;
    scan(1, '1');
    wait for 1 ns; -- ab_flasher.ladder:29
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " ab_light=" & image(ab_light)
          & " siemens_light=" & image(siemens_light));
    end if;
    scan(1, '1');
    wait for 1 ns; -- ab_flasher.ladder:31
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " ab_light=" & image(ab_light)
          & " siemens_light=" & image(siemens_light));
    end if;
    for round in 1 to 2 loop
      scan(1, '1');
      scan(499, '1');
      wait for 1 ns; -- ab_flasher.ladder:35
      if not failed and (expect_4_0 and expect_4_1) /= '1' then
        failed := true;
        print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
            & " ab_light=" & image(ab_light)
            & " siemens_light=" & image(siemens_light));
      end if;
      scan(1, '1');
      wait for 1 ns; -- ab_flasher.ladder:37
      if not failed and (expect_5_0 and expect_5_1) /= '1' then
        failed := true;
        print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
            & " ab_light=" & image(ab_light)
            & " siemens_light=" & image(siemens_light));
      end if;
      scan(300, '1');
      wait for 1 ns; -- ab_flasher.ladder:39
      if not failed and (expect_6_0 and expect_6_1) /= '1' then
        failed := true;
        print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
            & " ab_light=" & image(ab_light)
            & " siemens_light=" & image(siemens_light));
      end if;
      scan(1, '1');
      wait for 1 ns; -- ab_flasher.ladder:41
      if not failed and (expect_7_0 and expect_7_1) /= '1' then
        failed := true;
        print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
            & " ab_light=" & image(ab_light)
            & " siemens_light=" & image(siemens_light));
      end if;
    end loop;
    if failed then
      failures := failures + 1;
      print("not ok 1 - both flash alike, for three periods");
    else
      print("ok 1 - both flash alike, for three periods");
    end if;

    -- the light goes out at once
    failed := false;
    reset;
    enable <= '1';
    scan(1, '0');
    scan(600, '1');
    wait for 1 ns; -- ab_flasher.ladder:47
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " ab_light=" & image(ab_light)
          & " siemens_light=" & image(siemens_light));
    end if;
    enable <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_flasher.ladder:49
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " ab_light=" & image(ab_light)
          & " siemens_light=" & image(siemens_light));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - the light goes out at once");
    else
      print("ok 2 - the light goes out at once");
    end if;

    assert failures = 0 report integer'image(failures) & " of 2 tests failed" severity failure;
    wait;
  end process;
end architecture;
