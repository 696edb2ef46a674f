-- Made by hotrail 0.1.0 from boolean_equations.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- CTU: up counter
-- Fitted to PV = 10.
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- R   _________##____
-- Q   ___######____##
-- CV  011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity boolean_equations_test_CTU_PV10 is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    power   : in  std_logic;
    Q       : out std_logic;
    CV_last : out unsigned(14 downto 0)
  );
end entity boolean_equations_test_CTU_PV10;

architecture rtl of boolean_equations_test_CTU_PV10 is
  signal CV : unsigned(14 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal CV_at_least_10 : std_logic := '0';
  signal unequal : std_logic;
  signal condition : std_logic;
  signal CV_next : unsigned(14 downto 0);
  signal equal : std_logic;
  signal CV_at_least_10_next : std_logic;
begin
  unequal <= '1' when CV /= 32767 else '0';
  condition <= power and not was and unequal;
  CV_next <= CV + (to_unsigned(0, 14) & condition);
  equal <= '1' when CV = 9 else '0';
  CV_at_least_10_next <= equal or CV_at_least_10 when condition = '1' else CV_at_least_10;

  Q <= CV_at_least_10_next;
  CV_last <= CV;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
        was <= '0';
        CV_at_least_10 <= '0';
      else
        CV <= CV_next;
        was <= power;
        CV_at_least_10 <= CV_at_least_10_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity boolean_equations_test is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    X1    : in  std_logic;
    X2    : in  std_logic;
    X3    : in  std_logic;
    X4    : in  std_logic;
    Y1    : out std_logic;
    Y2    : out std_logic;
    C2_CV : out std_logic_vector(15 downto 0)
  );
end entity boolean_equations_test;

architecture rtl of boolean_equations_test is
  signal Y1_reg : std_logic := '0';
  signal Y2_reg : std_logic := '0';
  signal Y1_next : std_logic;
  signal C2_Q : std_logic;
  signal C2_CV_last : unsigned(14 downto 0);
  signal C2_CV_value : unsigned(15 downto 0);
  signal Y2_next : std_logic;
begin

  -- rung 1 "Y1 <- !X1 & X2 & (X3 & X4)", boolean_equations.ladder:8
  Y1_next <= not X1 and X2 and X3 and X4;

  -- rung 2 "C2(K10) <- X2", boolean_equations.ladder:11
  C2: entity work.boolean_equations_test_CTU_PV10
    port map (
      clk => clk,
      rst => rst,
      power => X2,
      Q => C2_Q,
      CV_last => C2_CV_last
    );

  -- rung 3 "Y2 <- C2", boolean_equations.ladder:14
  C2_CV_value <= resize(C2_CV_last, 16);
  Y2_next <= C2_Q;

  Y1 <= Y1_reg;
  Y2 <= Y2_reg;
  C2_CV <= std_logic_vector(C2_CV_value);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Y1_reg <= '0';
        Y2_reg <= '0';
      else
        Y1_reg <= Y1_next;
        Y2_reg <= Y2_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity boolean_equations_expect is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    Y1         : in  std_logic;
    Y2         : in  std_logic;
    C2_CV      : in  std_logic_vector(15 downto 0);
    expect_0_0 : out std_logic;
    expect_1_0 : out std_logic;
    expect_2_0 : out std_logic;
    expect_3_0 : out std_logic;
    expect_3_1 : out std_logic;
    expect_4_0 : out std_logic;
    expect_4_1 : out std_logic;
    expect_5_0 : out std_logic;
    expect_6_0 : out std_logic;
    expect_6_1 : out std_logic
  );
end entity boolean_equations_expect;

architecture rtl of boolean_equations_expect is
begin

  expect_0_0 <= Y1;
  expect_1_0 <= not Y1;
  expect_2_0 <= not Y1;
  expect_3_0 <= not Y2;
  expect_3_1 <= '1' when unsigned(C2_CV) = 9 else '0';
  expect_4_0 <= Y2;
  expect_4_1 <= '1' when unsigned(C2_CV) = 10 else '0';
  expect_5_0 <= Y2;
  expect_6_0 <= Y2;
  expect_6_1 <= '1' when unsigned(C2_CV) = 11 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity boolean_equations_tb is
end entity;

architecture tests of boolean_equations_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal X1 : std_logic := '0';
  signal X2 : std_logic := '0';
  signal X3 : std_logic := '0';
  signal X4 : std_logic := '0';
  signal Y1 : std_logic;
  signal Y2 : std_logic;
  signal C2_CV : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;

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
  core : entity work.boolean_equations_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      X1 => X1,
      X2 => X2,
      X3 => X3,
      X4 => X4,
      Y1 => Y1,
      Y2 => Y2,
      C2_CV => C2_CV
    );

  expectations : entity work.boolean_equations_expect
    port map (
      clk => clk,
      rst => rst,
      Y1 => Y1,
      Y2 => Y2,
      C2_CV => C2_CV,
      expect_0_0 => expect_0_0,
      expect_1_0 => expect_1_0,
      expect_2_0 => expect_2_0,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_5_0 => expect_5_0,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1
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
      X1 <= '0';
      X2 <= '0';
      X3 <= '0';
      X4 <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..2");

    -- Y1 needs all four
    failed := false;
    reset;
    X2 <= '1';
    X3 <= '1';
    X4 <= '1';
    scan(1, '0');
    wait for 1 ns; -- boolean_equations.ladder:19
    if not failed and (expect_0_0) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0)
          & " Y1=" & image(Y1));
    end if;
    X1 <= '1';
    scan(1, '0');
    wait for 1 ns; -- boolean_equations.ladder:21
    if not failed and (expect_1_0) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0)
          & " Y1=" & image(Y1));
    end if;
    X1 <= '0';
    X4 <= '0';
    scan(1, '0');
    wait for 1 ns; -- boolean_equations.ladder:23
    if not failed and (expect_2_0) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0)
          & " Y1=" & image(Y1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - Y1 needs all four");
    else
      print("ok 1 - Y1 needs all four");
    end if;

    -- Y2 comes on with the tenth rise of X2 and stays
    failed := false;
    reset;
    for round in 1 to 9 loop
      X2 <= '1';
      scan(1, '0');
      X2 <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- boolean_equations.ladder:27
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " Y2=" & image(Y2)
          & " C2_CV=" & image(C2_CV));
    end if;
    X2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- boolean_equations.ladder:29
    if not failed and (expect_4_0 and expect_4_1) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
          & " Y2=" & image(Y2)
          & " C2_CV=" & image(C2_CV));
    end if;
    X2 <= '0';
    scan(1, '0');
    wait for 1 ns; -- boolean_equations.ladder:31
    if not failed and (expect_5_0) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0)
          & " Y2=" & image(Y2));
    end if;
    X2 <= '1';
    scan(1, '0');
    X2 <= '0';
    scan(1, '0');
    wait for 1 ns; -- boolean_equations.ladder:33
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " Y2=" & image(Y2)
          & " C2_CV=" & image(C2_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - Y2 comes on with the tenth rise of X2 and stays");
    else
      print("ok 2 - Y2 comes on with the tenth rise of X2 and stays");
    end if;

    assert failures = 0 report integer'image(failures) & " of 2 tests failed" severity failure;
    wait;
  end process;
end architecture;
