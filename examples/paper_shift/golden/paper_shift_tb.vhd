-- Made by hotrail 0.1.0 from paper_shift.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- SHL: shift register to the left, REG has 48 bits
-- Example, with REG = 1, REG0 = 32769:
-- IN   #_#_#_#
-- DATA __#___#
-- EN   ####_##
-- Q    ##_____
-- REG0 2255001
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_shift_test_SHL_48 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    EN          : in  std_logic;
    DATA        : in  std_logic;
    REG0_before : in  unsigned(15 downto 0);
    REG1_before : in  unsigned(15 downto 0);
    REG2_before : in  unsigned(15 downto 0);
    Q           : out std_logic;
    REG0        : out unsigned(15 downto 0);
    REG1        : out unsigned(15 downto 0);
    REG2        : out unsigned(15 downto 0)
  );
end entity paper_shift_test_SHL_48;

architecture rtl of paper_shift_test_SHL_48 is
  signal Q_reg : std_logic := '0';
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal choice : unsigned(15 downto 0);
  signal REG0_value : unsigned(15 downto 0);
  signal choice_2 : unsigned(15 downto 0);
  signal REG1_value : unsigned(15 downto 0);
  signal choice_3 : unsigned(15 downto 0);
  signal REG2_value : unsigned(15 downto 0);
  signal choice_4 : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and not was;
  choice <= REG0_before(14 downto 0) & DATA when condition = '1' else REG0_before;
  REG0_value <= choice when EN = '1' else to_unsigned(0, 16);
  choice_2 <= REG1_before(14 downto 0) & REG0_before(15) when condition = '1' else REG1_before;
  REG1_value <= choice_2 when EN = '1' else to_unsigned(0, 16);
  choice_3 <= REG2_before(14 downto 0) & REG1_before(15) when condition = '1' else REG2_before;
  REG2_value <= choice_3 when EN = '1' else to_unsigned(0, 16);
  choice_4 <= REG2_before(15) when condition = '1' else Q_reg;
  Q_next <= choice_4 when EN = '1' else '0';

  Q <= Q_next;
  REG0 <= REG0_value;
  REG1 <= REG1_value;
  REG2 <= REG2_value;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        was <= '0';
      else
        Q_reg <= Q_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- SHR: shift register to the right, REG has 32 bits
-- Example, with REG = 1, REG0 = 3:
-- IN   #_#_#
-- EN   #####
-- Q    ####_
-- REG0 11000
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_shift_test_SHR_32 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    EN          : in  std_logic;
    DATA        : in  std_logic;
    REG0_before : in  unsigned(15 downto 0);
    REG1_before : in  unsigned(15 downto 0);
    Q           : out std_logic;
    REG0        : out unsigned(15 downto 0);
    REG1        : out unsigned(15 downto 0)
  );
end entity paper_shift_test_SHR_32;

architecture rtl of paper_shift_test_SHR_32 is
  signal Q_reg : std_logic := '0';
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal choice : unsigned(15 downto 0);
  signal REG1_value : unsigned(15 downto 0);
  signal choice_2 : unsigned(15 downto 0);
  signal REG0_value : unsigned(15 downto 0);
  signal choice_3 : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and not was;
  choice <= DATA & REG1_before(15 downto 1) when condition = '1' else REG1_before;
  REG1_value <= choice when EN = '1' else to_unsigned(0, 16);
  choice_2 <= REG1_before(0) & REG0_before(15 downto 1) when condition = '1' else REG0_before;
  REG0_value <= choice_2 when EN = '1' else to_unsigned(0, 16);
  choice_3 <= REG0_before(0) when condition = '1' else Q_reg;
  Q_next <= choice_3 when EN = '1' else '0';

  Q <= Q_next;
  REG0 <= REG0_value;
  REG1 <= REG1_value;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        was <= '0';
      else
        Q_reg <= Q_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_shift_test is
  port (
    clk            : in  std_logic;
    rst            : in  std_logic;
    tick           : in  std_logic;
    shift_ckt      : in  std_logic;
    shift_en_ckt   : in  std_logic;
    serialdata_ckt : in  std_logic;
    left_coil      : out std_logic;
    right_coil     : out std_logic;
    actualdata_0   : out std_logic_vector(15 downto 0);
    actualdata_1   : out std_logic_vector(15 downto 0);
    actualdata_2   : out std_logic_vector(15 downto 0);
    two_0          : out std_logic_vector(15 downto 0);
    two_1          : out std_logic_vector(15 downto 0)
  );
end entity paper_shift_test;

architecture rtl of paper_shift_test is
  signal actualdata_0_reg : unsigned(15 downto 0) := x"FFFF";
  signal actualdata_1_reg : unsigned(15 downto 0) := to_unsigned(3855, 16);
  signal actualdata_2_reg : unsigned(15 downto 0) := x"F0F0";
  signal two_0_reg : unsigned(15 downto 0) := to_unsigned(3855, 16);
  signal two_1_reg : unsigned(15 downto 0) := x"8001";
  signal left_coil_reg : std_logic := '0';
  signal right_coil_reg : std_logic := '0';
  signal sl_Q : std_logic;
  signal sl_REG0 : unsigned(15 downto 0);
  signal sl_REG1 : unsigned(15 downto 0);
  signal sl_REG2 : unsigned(15 downto 0);
  signal left_coil_next : std_logic;
  signal sr_Q : std_logic;
  signal sr_REG0 : unsigned(15 downto 0);
  signal sr_REG1 : unsigned(15 downto 0);
  signal right_coil_next : std_logic;
begin

  -- rung 1 "SL", paper_shift.ladder:10
  sl: entity work.paper_shift_test_SHL_48
    port map (
      clk => clk,
      rst => rst,
      power => shift_ckt,
      EN => shift_en_ckt,
      DATA => serialdata_ckt,
      REG0_before => actualdata_0_reg,
      REG1_before => actualdata_1_reg,
      REG2_before => actualdata_2_reg,
      Q => sl_Q,
      REG0 => sl_REG0,
      REG1 => sl_REG1,
      REG2 => sl_REG2
    );
  left_coil_next <= sl_Q;

  -- rung 2 "SR", paper_shift.ladder:13
  sr: entity work.paper_shift_test_SHR_32
    port map (
      clk => clk,
      rst => rst,
      power => shift_ckt,
      EN => shift_en_ckt,
      DATA => serialdata_ckt,
      REG0_before => two_0_reg,
      REG1_before => two_1_reg,
      Q => sr_Q,
      REG0 => sr_REG0,
      REG1 => sr_REG1
    );
  right_coil_next <= sr_Q;

  left_coil <= left_coil_reg;
  right_coil <= right_coil_reg;
  actualdata_0 <= std_logic_vector(actualdata_0_reg);
  actualdata_1 <= std_logic_vector(actualdata_1_reg);
  actualdata_2 <= std_logic_vector(actualdata_2_reg);
  two_0 <= std_logic_vector(two_0_reg);
  two_1 <= std_logic_vector(two_1_reg);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        actualdata_0_reg <= x"FFFF";
        actualdata_1_reg <= to_unsigned(3855, 16);
        actualdata_2_reg <= x"F0F0";
        two_0_reg <= to_unsigned(3855, 16);
        two_1_reg <= x"8001";
        left_coil_reg <= '0';
        right_coil_reg <= '0';
      else
        actualdata_0_reg <= sl_REG0;
        actualdata_1_reg <= sl_REG1;
        actualdata_2_reg <= sl_REG2;
        two_0_reg <= sr_REG0;
        two_1_reg <= sr_REG1;
        left_coil_reg <= left_coil_next;
        right_coil_reg <= right_coil_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_shift_expect is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    left_coil    : in  std_logic;
    actualdata_0 : in  std_logic_vector(15 downto 0);
    actualdata_1 : in  std_logic_vector(15 downto 0);
    actualdata_2 : in  std_logic_vector(15 downto 0);
    right_coil   : in  std_logic;
    two_0        : in  std_logic_vector(15 downto 0);
    two_1        : in  std_logic_vector(15 downto 0);
    expect_0_0   : out std_logic;
    expect_0_1   : out std_logic;
    expect_0_2   : out std_logic;
    expect_0_3   : out std_logic;
    expect_1_0   : out std_logic;
    expect_1_1   : out std_logic;
    expect_1_2   : out std_logic;
    expect_1_3   : out std_logic;
    expect_2_0   : out std_logic;
    expect_2_1   : out std_logic;
    expect_2_2   : out std_logic;
    expect_2_3   : out std_logic;
    expect_3_0   : out std_logic;
    expect_3_1   : out std_logic;
    expect_3_2   : out std_logic;
    expect_3_3   : out std_logic;
    expect_4_0   : out std_logic;
    expect_4_1   : out std_logic;
    expect_4_2   : out std_logic;
    expect_4_3   : out std_logic;
    expect_5_0   : out std_logic;
    expect_5_1   : out std_logic;
    expect_5_2   : out std_logic;
    expect_6_0   : out std_logic;
    expect_6_1   : out std_logic;
    expect_6_2   : out std_logic;
    expect_7_0   : out std_logic;
    expect_7_1   : out std_logic;
    expect_8_0   : out std_logic;
    expect_8_1   : out std_logic;
    expect_8_2   : out std_logic;
    expect_8_3   : out std_logic;
    expect_8_4   : out std_logic
  );
end entity paper_shift_expect;

architecture rtl of paper_shift_expect is
begin

  expect_0_0 <= left_coil;
  expect_0_1 <= '1' when unsigned(actualdata_0) = 65534 else '0';
  expect_0_2 <= '1' when unsigned(actualdata_1) = 7711 else '0';
  expect_0_3 <= '1' when unsigned(actualdata_2) = 57824 else '0';
  expect_1_0 <= left_coil;
  expect_1_1 <= '1' when unsigned(actualdata_0) = 65532 else '0';
  expect_1_2 <= '1' when unsigned(actualdata_1) = 15423 else '0';
  expect_1_3 <= '1' when unsigned(actualdata_2) = 50112 else '0';
  expect_2_0 <= left_coil;
  expect_2_1 <= '1' when unsigned(actualdata_0) = 65528 else '0';
  expect_2_2 <= '1' when unsigned(actualdata_1) = 30847 else '0';
  expect_2_3 <= '1' when unsigned(actualdata_2) = 34688 else '0';
  expect_3_0 <= left_coil;
  expect_3_1 <= '1' when unsigned(actualdata_0) = 65520 else '0';
  expect_3_2 <= '1' when unsigned(actualdata_1) = 61695 else '0';
  expect_3_3 <= '1' when unsigned(actualdata_2) = 3840 else '0';
  expect_4_0 <= not left_coil;
  expect_4_1 <= '1' when unsigned(actualdata_0) = 65504 else '0';
  expect_4_2 <= '1' when unsigned(actualdata_1) = 57855 else '0';
  expect_4_3 <= '1' when unsigned(actualdata_2) = 7681 else '0';
  expect_5_0 <= right_coil;
  expect_5_1 <= '1' when unsigned(two_0) = 34695 else '0';
  expect_5_2 <= '1' when unsigned(two_1) = 16384 else '0';
  expect_6_0 <= right_coil;
  expect_6_1 <= '1' when unsigned(two_0) = 17347 else '0';
  expect_6_2 <= '1' when unsigned(two_1) = 8192 else '0';
  expect_7_0 <= '1' when unsigned(actualdata_0) = 65535 else '0';
  expect_7_1 <= '1' when unsigned(two_1) = 49152 else '0';
  expect_8_0 <= not left_coil;
  expect_8_1 <= not right_coil;
  expect_8_2 <= '1' when unsigned(actualdata_0) = 0 else '0';
  expect_8_3 <= '1' when unsigned(actualdata_2) = 0 else '0';
  expect_8_4 <= '1' when unsigned(two_1) = 0 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity paper_shift_tb is
end entity;

architecture tests of paper_shift_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal shift_ckt : std_logic := '0';
  signal shift_en_ckt : std_logic := '0';
  signal serialdata_ckt : std_logic := '0';
  signal left_coil : std_logic;
  signal right_coil : std_logic;
  signal actualdata_0 : std_logic_vector(15 downto 0);
  signal actualdata_1 : std_logic_vector(15 downto 0);
  signal actualdata_2 : std_logic_vector(15 downto 0);
  signal two_0 : std_logic_vector(15 downto 0);
  signal two_1 : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_0_3 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_1_3 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_2_2 : std_logic;
  signal expect_2_3 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_3_3 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_4_3 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_6_2 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_8_2 : std_logic;
  signal expect_8_3 : std_logic;
  signal expect_8_4 : std_logic;

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
  core : entity work.paper_shift_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      shift_ckt => shift_ckt,
      shift_en_ckt => shift_en_ckt,
      serialdata_ckt => serialdata_ckt,
      left_coil => left_coil,
      right_coil => right_coil,
      actualdata_0 => actualdata_0,
      actualdata_1 => actualdata_1,
      actualdata_2 => actualdata_2,
      two_0 => two_0,
      two_1 => two_1
    );

  expectations : entity work.paper_shift_expect
    port map (
      clk => clk,
      rst => rst,
      left_coil => left_coil,
      actualdata_0 => actualdata_0,
      actualdata_1 => actualdata_1,
      actualdata_2 => actualdata_2,
      right_coil => right_coil,
      two_0 => two_0,
      two_1 => two_1,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_0_3 => expect_0_3,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_1_3 => expect_1_3,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_2_2 => expect_2_2,
      expect_2_3 => expect_2_3,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_3_3 => expect_3_3,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_4_3 => expect_4_3,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_6_2 => expect_6_2,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_8_2 => expect_8_2,
      expect_8_3 => expect_8_3,
      expect_8_4 => expect_8_4
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
      shift_ckt <= '0';
      shift_en_ckt <= '0';
      serialdata_ckt <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..3");

    -- to the left: the bit that leaves the high word is the coil
    failed := false;
    reset;
    shift_en_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_shift.ladder:19
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2 and expect_0_3) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2) & image(expect_0_3)
          & " left_coil=" & image(left_coil)
          & " actualdata_0=" & image(actualdata_0)
          & " actualdata_1=" & image(actualdata_1)
          & " actualdata_2=" & image(actualdata_2));
    end if;
    shift_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_shift.ladder:22
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2 and expect_1_3) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2) & image(expect_1_3)
          & " left_coil=" & image(left_coil)
          & " actualdata_0=" & image(actualdata_0)
          & " actualdata_1=" & image(actualdata_1)
          & " actualdata_2=" & image(actualdata_2));
    end if;
    shift_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_shift.ladder:25
    if not failed and (expect_2_0 and expect_2_1 and expect_2_2 and expect_2_3) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2) & image(expect_2_3)
          & " left_coil=" & image(left_coil)
          & " actualdata_0=" & image(actualdata_0)
          & " actualdata_1=" & image(actualdata_1)
          & " actualdata_2=" & image(actualdata_2));
    end if;
    shift_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_shift.ladder:28
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2 and expect_3_3) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2) & image(expect_3_3)
          & " left_coil=" & image(left_coil)
          & " actualdata_0=" & image(actualdata_0)
          & " actualdata_1=" & image(actualdata_1)
          & " actualdata_2=" & image(actualdata_2));
    end if;
    shift_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_shift.ladder:31
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2 and expect_4_3) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2) & image(expect_4_3)
          & " left_coil=" & image(left_coil)
          & " actualdata_0=" & image(actualdata_0)
          & " actualdata_1=" & image(actualdata_1)
          & " actualdata_2=" & image(actualdata_2));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - to the left: the bit that leaves the high word is the coil");
    else
      print("ok 1 - to the left: the bit that leaves the high word is the coil");
    end if;

    -- to the right: the bit that leaves the low word is the coil
    failed := false;
    reset;
    shift_en_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_shift.ladder:37
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2)
          & " right_coil=" & image(right_coil)
          & " two_0=" & image(two_0)
          & " two_1=" & image(two_1));
    end if;
    shift_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_shift.ladder:39
    if not failed and (expect_6_0 and expect_6_1 and expect_6_2) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2)
          & " right_coil=" & image(right_coil)
          & " two_0=" & image(two_0)
          & " two_1=" & image(two_1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - to the right: the bit that leaves the low word is the coil");
    else
      print("ok 2 - to the right: the bit that leaves the low word is the coil");
    end if;

    -- serial data enters at the vacated end, the enable circuit clears
    failed := false;
    reset;
    shift_en_ckt <= '1';
    serialdata_ckt <= '1';
    shift_ckt <= '1';
    scan(1, '0');
    shift_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_shift.ladder:43
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " actualdata_0=" & image(actualdata_0)
          & " two_1=" & image(two_1));
    end if;
    shift_en_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_shift.ladder:45
    if not failed and (expect_8_0 and expect_8_1 and expect_8_2 and expect_8_3 and expect_8_4) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2) & image(expect_8_3) & image(expect_8_4)
          & " left_coil=" & image(left_coil)
          & " right_coil=" & image(right_coil)
          & " actualdata_0=" & image(actualdata_0)
          & " actualdata_2=" & image(actualdata_2)
          & " two_1=" & image(two_1));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - serial data enters at the vacated end, the enable circuit clears");
    else
      print("ok 3 - serial data enters at the vacated end, the enable circuit clears");
    end if;

    assert failures = 0 report integer'image(failures) & " of 3 tests failed" severity failure;
    wait;
  end process;
end architecture;
