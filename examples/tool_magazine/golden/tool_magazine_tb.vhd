-- Made by hotrail 0.1.0 from tool_magazine.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity tool_magazine_test is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    X4   : in  std_logic;
    X3   : in  std_logic;
    X2   : in  std_logic;
    X1   : in  std_logic;
    at2  : in  std_logic;
    at3  : in  std_logic;
    X15  : in  std_logic;
    X16  : in  std_logic;
    home : in  std_logic;
    turn : out std_logic;
    Y0   : out std_logic;
    Y1   : out std_logic;
    Y2   : out std_logic;
    Y3   : out std_logic;
    Y4   : out std_logic;
    M2   : out std_logic;
    M50  : out std_logic;
    M15  : out std_logic;
    M3   : out std_logic;
    M51  : out std_logic
  );
end entity tool_magazine_test;

architecture rtl of tool_magazine_test is
  signal M2_reg : std_logic := '0';
  signal Y14 : std_logic := '0';
  signal M3_reg : std_logic := '0';
  signal M15_reg : std_logic := '0';
  signal Y0_reg : std_logic := '0';
  signal Y2_reg : std_logic := '0';
  signal Y3_reg : std_logic := '0';
  signal Y4_reg : std_logic := '0';
  signal M51_reg : std_logic := '0';
  signal X16_before : std_logic := '0';
  signal Y1_reg : std_logic := '0';
  signal turn_reg : std_logic := '0';
  signal M50_reg : std_logic := '0';
  signal T2 : std_logic;
  signal T3 : std_logic;
  signal M50_next : std_logic;
  signal M51_next : std_logic;
  signal M2_rung2 : std_logic;
  signal Y14_rung2 : std_logic;
  signal M3_rung2 : std_logic;
  signal M3_rung2_2 : std_logic;
  signal M2_rung2_2 : std_logic;
  signal M15_rung2 : std_logic;
  signal Y14_next : std_logic;
  signal turn_next : std_logic;
  signal Y0_next : std_logic;
  signal Y2_next : std_logic;
  signal Y4_next : std_logic;
  signal M15_next : std_logic;
  signal rung9_power : std_logic;
  signal Y3_rung9 : std_logic;
  signal M2_next : std_logic;
  signal M3_next : std_logic;
  signal Y3_next : std_logic;
  signal Y1_next : std_logic;
begin

  -- rung 1 "decode the command", tool_magazine.ladder:26
  T2 <= not X4 and not X3 and X2 and not X1;
  T3 <= not X4 and not X3 and X2 and X1;
  M50_next <= X4 and not X3 and X2 and X1;
  M51_next <= X4 and X3 and not X2 and not X1;

  -- rung 2 "call a location", tool_magazine.ladder:29
  M2_rung2 <= T2 or M2_reg;
  Y14_rung2 <= T2 or Y14;
  M3_rung2 <= M3_reg and not T2;
  M3_rung2_2 <= T3 or M3_rung2;
  M2_rung2_2 <= M2_rung2 and not T3;
  M15_rung2 <= M15_reg and not T3;
  Y14_next <= Y14_rung2 and not M50_next;

  -- rung 3 "turn until it is reached", tool_magazine.ladder:32
  turn_next <= (M2_rung2_2 and not at2) or (M3_rung2_2 and not at3);

  -- rung 4, tool_magazine.ladder:34
  Y0_next <= (M2_rung2_2 and at2) or (M3_rung2_2 and at3);

  -- rung 5 "move the tool forward (paper, rung 4)", tool_magazine.ladder:36
  Y2_next <= ((Y14_next and Y0_next and not Y0_reg) or Y2_reg) and not X15 and not Y3_reg;

  -- rung 6 "air pump (paper, rung 5)", tool_magazine.ladder:39
  Y4_next <= ((Y2_next and not Y2_reg) or Y4_reg or M51_reg) and not M15_rung2;

  -- rung 7 "close the pump", tool_magazine.ladder:42

  -- rung 8, tool_magazine.ladder:44
  M15_next <= M50_next or M15_rung2;

  -- rung 9 "bring the tool back", tool_magazine.ladder:46
  rung9_power <= M51_next and not M51_reg;
  Y3_rung9 <= rung9_power or Y3_reg;
  M2_next <= M2_rung2_2 and not rung9_power;
  M3_next <= M3_rung2_2 and not rung9_power;

  -- rung 10, tool_magazine.ladder:48
  Y3_next <= Y3_rung9 and not X16;

  -- rung 11 "turn back when the tool is back", tool_magazine.ladder:50
  Y1_next <= ((X16 and not X16_before) or Y1_reg) and not home;

  turn <= turn_reg;
  Y0 <= Y0_reg;
  Y1 <= Y1_reg;
  Y2 <= Y2_reg;
  Y3 <= Y3_reg;
  Y4 <= Y4_reg;
  M2 <= M2_reg;
  M50 <= M50_reg;
  M15 <= M15_reg;
  M3 <= M3_reg;
  M51 <= M51_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        M2_reg <= '0';
        Y14 <= '0';
        M3_reg <= '0';
        M15_reg <= '0';
        Y0_reg <= '0';
        Y2_reg <= '0';
        Y3_reg <= '0';
        Y4_reg <= '0';
        M51_reg <= '0';
        X16_before <= '0';
        Y1_reg <= '0';
        turn_reg <= '0';
        M50_reg <= '0';
      else
        M2_reg <= M2_next;
        Y14 <= Y14_next;
        M3_reg <= M3_next;
        M15_reg <= M15_next;
        Y0_reg <= Y0_next;
        Y2_reg <= Y2_next;
        Y3_reg <= Y3_next;
        Y4_reg <= Y4_next;
        M51_reg <= M51_next;
        X16_before <= X16;
        Y1_reg <= Y1_next;
        turn_reg <= turn_next;
        M50_reg <= M50_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity tool_magazine_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    M2          : in  std_logic;
    turn        : in  std_logic;
    Y0          : in  std_logic;
    Y2          : in  std_logic;
    Y4          : in  std_logic;
    M50         : in  std_logic;
    M15         : in  std_logic;
    M3          : in  std_logic;
    M51         : in  std_logic;
    Y3          : in  std_logic;
    Y1          : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_1_2  : out std_logic;
    expect_1_3  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_3_0  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_4_2  : out std_logic;
    expect_5_0  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_7_2  : out std_logic;
    expect_7_3  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_8_2  : out std_logic;
    expect_8_3  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_11_2 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic;
    expect_13_1 : out std_logic;
    expect_14_0 : out std_logic;
    expect_15_0 : out std_logic
  );
end entity tool_magazine_expect;

architecture rtl of tool_magazine_expect is
begin

  expect_0_0 <= M2;
  expect_0_1 <= turn;
  expect_0_2 <= not Y0;
  expect_1_0 <= not turn;
  expect_1_1 <= Y0;
  expect_1_2 <= Y2;
  expect_1_3 <= Y4;
  expect_2_0 <= not Y2;
  expect_2_1 <= Y4;
  expect_3_0 <= Y4;
  expect_4_0 <= M50;
  expect_4_1 <= M15;
  expect_4_2 <= Y4;
  expect_5_0 <= not Y4;
  expect_6_0 <= not M50;
  expect_6_1 <= not Y4;
  expect_7_0 <= M3;
  expect_7_1 <= not M2;
  expect_7_2 <= turn;
  expect_7_3 <= not Y0;
  expect_8_0 <= not turn;
  expect_8_1 <= Y0;
  expect_8_2 <= not Y2;
  expect_8_3 <= not Y4;
  expect_9_0 <= Y0;
  expect_9_1 <= not Y4;
  expect_10_0 <= not Y4;
  expect_11_0 <= M51;
  expect_11_1 <= Y3;
  expect_11_2 <= not Y1;
  expect_12_0 <= Y3;
  expect_13_0 <= not Y3;
  expect_13_1 <= Y1;
  expect_14_0 <= Y1;
  expect_15_0 <= not Y1;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity tool_magazine_tb is
end entity;

architecture tests of tool_magazine_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal X4 : std_logic := '0';
  signal X3 : std_logic := '0';
  signal X2 : std_logic := '0';
  signal X1 : std_logic := '0';
  signal at2 : std_logic := '0';
  signal at3 : std_logic := '0';
  signal X15 : std_logic := '0';
  signal X16 : std_logic := '0';
  signal home : std_logic := '0';
  signal turn : std_logic;
  signal Y0 : std_logic;
  signal Y1 : std_logic;
  signal Y2 : std_logic;
  signal Y3 : std_logic;
  signal Y4 : std_logic;
  signal M2 : std_logic;
  signal M50 : std_logic;
  signal M15 : std_logic;
  signal M3 : std_logic;
  signal M51 : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_1_3 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_7_2 : std_logic;
  signal expect_7_3 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_8_2 : std_logic;
  signal expect_8_3 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_11_2 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;
  signal expect_13_1 : std_logic;
  signal expect_14_0 : std_logic;
  signal expect_15_0 : std_logic;

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
  core : entity work.tool_magazine_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      X4 => X4,
      X3 => X3,
      X2 => X2,
      X1 => X1,
      at2 => at2,
      at3 => at3,
      X15 => X15,
      X16 => X16,
      home => home,
      turn => turn,
      Y0 => Y0,
      Y1 => Y1,
      Y2 => Y2,
      Y3 => Y3,
      Y4 => Y4,
      M2 => M2,
      M50 => M50,
      M15 => M15,
      M3 => M3,
      M51 => M51
    );

  expectations : entity work.tool_magazine_expect
    port map (
      clk => clk,
      rst => rst,
      M2 => M2,
      turn => turn,
      Y0 => Y0,
      Y2 => Y2,
      Y4 => Y4,
      M50 => M50,
      M15 => M15,
      M3 => M3,
      M51 => M51,
      Y3 => Y3,
      Y1 => Y1,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_1_3 => expect_1_3,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_7_2 => expect_7_2,
      expect_7_3 => expect_7_3,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_8_2 => expect_8_2,
      expect_8_3 => expect_8_3,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_11_2 => expect_11_2,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0,
      expect_13_1 => expect_13_1,
      expect_14_0 => expect_14_0,
      expect_15_0 => expect_15_0
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
      X4 <= '0';
      X3 <= '0';
      X2 <= '0';
      X1 <= '0';
      at2 <= '0';
      at3 <= '0';
      X15 <= '0';
      X16 <= '0';
      home <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..1");

    -- T2 unloads tool 2, T11 closes the pump, T3 clamps tool 3, T12 brings it home
    failed := false;
    reset;
    X2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:56
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " M2=" & image(M2)
          & " turn=" & image(turn)
          & " Y0=" & image(Y0));
    end if;
    at2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:58
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2 and expect_1_3) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2) & image(expect_1_3)
          & " turn=" & image(turn)
          & " Y0=" & image(Y0)
          & " Y2=" & image(Y2)
          & " Y4=" & image(Y4));
    end if;
    X15 <= '1';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:60
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " Y2=" & image(Y2)
          & " Y4=" & image(Y4));
    end if;
    X2 <= '0';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:62
    if not failed and (expect_3_0) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0)
          & " Y4=" & image(Y4));
    end if;
    X4 <= '1';
    X2 <= '1';
    X1 <= '1';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:65
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2)
          & " M50=" & image(M50)
          & " M15=" & image(M15)
          & " Y4=" & image(Y4));
    end if;
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:67
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " Y4=" & image(Y4));
    end if;
    X4 <= '0';
    X2 <= '0';
    X1 <= '0';
    X15 <= '0';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:69
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " M50=" & image(M50)
          & " Y4=" & image(Y4));
    end if;
    X2 <= '1';
    X1 <= '1';
    at2 <= '0';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:72
    if not failed and (expect_7_0 and expect_7_1 and expect_7_2 and expect_7_3) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2) & image(expect_7_3)
          & " M3=" & image(M3)
          & " M2=" & image(M2)
          & " turn=" & image(turn)
          & " Y0=" & image(Y0));
    end if;
    at3 <= '1';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:74
    if not failed and (expect_8_0 and expect_8_1 and expect_8_2 and expect_8_3) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2) & image(expect_8_3)
          & " turn=" & image(turn)
          & " Y0=" & image(Y0)
          & " Y2=" & image(Y2)
          & " Y4=" & image(Y4));
    end if;
    X2 <= '0';
    X1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:76
    if not failed and (expect_9_0 and expect_9_1) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1)
          & " Y0=" & image(Y0)
          & " Y4=" & image(Y4));
    end if;
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:78
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " Y4=" & image(Y4));
    end if;
    X4 <= '1';
    X3 <= '1';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:81
    if not failed and (expect_11_0 and expect_11_1 and expect_11_2) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1) & image(expect_11_2)
          & " M51=" & image(M51)
          & " Y3=" & image(Y3)
          & " Y1=" & image(Y1));
    end if;
    X4 <= '0';
    X3 <= '0';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:83
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " Y3=" & image(Y3));
    end if;
    X16 <= '1';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:85
    if not failed and (expect_13_0 and expect_13_1) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0) & image(expect_13_1)
          & " Y3=" & image(Y3)
          & " Y1=" & image(Y1));
    end if;
    X16 <= '0';
    at3 <= '0';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:87
    if not failed and (expect_14_0) /= '1' then
      failed := true;
      print("# failed expectation 14 conducts " & image(expect_14_0)
          & " Y1=" & image(Y1));
    end if;
    home <= '1';
    scan(1, '0');
    wait for 1 ns; -- tool_magazine.ladder:89
    if not failed and (expect_15_0) /= '1' then
      failed := true;
      print("# failed expectation 15 conducts " & image(expect_15_0)
          & " Y1=" & image(Y1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - T2 unloads tool 2, T11 closes the pump, T3 clamps tool 3, T12 brings it home");
    else
      print("ok 1 - T2 unloads tool 2, T11 closes the pump, T3 clamps tool 3, T12 brings it home");
    end if;

    assert failures = 0 report integer'image(failures) & " of 1 tests failed" severity failure;
    wait;
  end process;
end architecture;
