-- Made by hotrail 0.1.0 from paper_counters.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- UC: up counter with enable
-- Fitted to PV = 5.
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- EN  #########__####
-- Q   ___######____##
-- ACC 011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_counters_test_UC_PV5 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    power    : in  std_logic;
    EN       : in  std_logic;
    Q        : out std_logic;
    ACC_last : out unsigned(13 downto 0)
  );
end entity paper_counters_test_UC_PV5;

architecture rtl of paper_counters_test_UC_PV5 is
  signal ACC : unsigned(13 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ACC_at_least_5 : std_logic := '0';
  signal unequal : std_logic;
  signal condition : std_logic;
  signal sum : unsigned(13 downto 0);
  signal ACC_next : unsigned(13 downto 0);
  signal equal : std_logic;
  signal choice : std_logic;
  signal ACC_at_least_5_next : std_logic;
begin
  unequal <= '1' when ACC /= 9999 else '0';
  condition <= power and not was and unequal;
  sum <= ACC + (to_unsigned(0, 13) & condition);
  ACC_next <= sum when EN = '1' else to_unsigned(0, 14);
  equal <= '1' when ACC = 4 else '0';
  choice <= equal or ACC_at_least_5 when condition = '1' else ACC_at_least_5;
  ACC_at_least_5_next <= EN and choice;

  Q <= ACC_at_least_5_next;
  ACC_last <= ACC;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        was <= '0';
        ACC_at_least_5 <= '0';
      else
        ACC <= ACC_next;
        was <= power;
        ACC_at_least_5 <= ACC_at_least_5_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- DC: down counter with enable
-- Fitted to PV = 5.
-- Example, with PV = 2:
-- IN  _#_##_#_#__
-- EN  #######__##
-- Q   ___####____
-- ACC 21100002222
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_counters_test_DC_PV5 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    power    : in  std_logic;
    EN       : in  std_logic;
    Q        : out std_logic;
    ACC_last : out unsigned(2 downto 0)
  );
end entity paper_counters_test_DC_PV5;

architecture rtl of paper_counters_test_DC_PV5 is
  signal ACC : unsigned(2 downto 0) := to_unsigned(5, 3);
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal difference : unsigned(2 downto 0);
  signal ACC_next : unsigned(2 downto 0);
  signal equal_2 : std_logic;
begin
  condition <= power and not was;
  equal <= '1' when ACC = 0 else '0';
  difference <= ACC - (to_unsigned(0, 2) & (condition and not equal));
  ACC_next <= difference when EN = '1' else to_unsigned(5, 3);
  equal_2 <= '1' when ACC = 1 else '0';

  Q <= EN and ((condition and equal_2) or equal);
  ACC_last <= ACC;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= to_unsigned(5, 3);
        was <= '0';
      else
        ACC <= ACC_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- DRUM: drum counter, TAPS = [2, 4, 6, 8]
-- Fitted to PV = 10.
-- Example, with PV = 3, TAPS = [1, 2]:
-- IN   _#_#_#_#___
-- EN   #########_#
-- Q    _____####__
-- TAP0 _########__
-- TAP1 ___######__
-- ACC  01122334400
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_counters_test_DRUM_PV10 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    power    : in  std_logic;
    EN       : in  std_logic;
    Q        : out std_logic;
    ACC_last : out unsigned(10 downto 0);
    TAP0     : out std_logic;
    TAP1     : out std_logic;
    TAP2     : out std_logic;
    TAP3     : out std_logic
  );
end entity paper_counters_test_DRUM_PV10;

architecture rtl of paper_counters_test_DRUM_PV10 is
  signal ACC : unsigned(10 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ACC_at_least_10 : std_logic := '0';
  signal ACC_at_least_2 : std_logic := '0';
  signal ACC_at_least_4 : std_logic := '0';
  signal ACC_at_least_6 : std_logic := '0';
  signal ACC_at_least_8 : std_logic := '0';
  signal unequal : std_logic;
  signal condition : std_logic;
  signal sum : unsigned(10 downto 0);
  signal ACC_next : unsigned(10 downto 0);
  signal equal : std_logic;
  signal choice : std_logic;
  signal ACC_at_least_10_next : std_logic;
  signal equal_2 : std_logic;
  signal choice_2 : std_logic;
  signal ACC_at_least_2_next : std_logic;
  signal equal_3 : std_logic;
  signal choice_3 : std_logic;
  signal ACC_at_least_4_next : std_logic;
  signal equal_4 : std_logic;
  signal choice_4 : std_logic;
  signal ACC_at_least_6_next : std_logic;
  signal equal_5 : std_logic;
  signal choice_5 : std_logic;
  signal ACC_at_least_8_next : std_logic;
begin
  unequal <= '1' when ACC /= 2047 else '0';
  condition <= power and not was and unequal;
  sum <= ACC + (to_unsigned(0, 10) & condition);
  ACC_next <= sum when EN = '1' else to_unsigned(0, 11);
  equal <= '1' when ACC = 9 else '0';
  choice <= equal or ACC_at_least_10 when condition = '1' else ACC_at_least_10;
  ACC_at_least_10_next <= EN and choice;
  equal_2 <= '1' when ACC = 1 else '0';
  choice_2 <= equal_2 or ACC_at_least_2 when condition = '1' else ACC_at_least_2;
  ACC_at_least_2_next <= EN and choice_2;
  equal_3 <= '1' when ACC = 3 else '0';
  choice_3 <= equal_3 or ACC_at_least_4 when condition = '1' else ACC_at_least_4;
  ACC_at_least_4_next <= EN and choice_3;
  equal_4 <= '1' when ACC = 5 else '0';
  choice_4 <= equal_4 or ACC_at_least_6 when condition = '1' else ACC_at_least_6;
  ACC_at_least_6_next <= EN and choice_4;
  equal_5 <= '1' when ACC = 7 else '0';
  choice_5 <= equal_5 or ACC_at_least_8 when condition = '1' else ACC_at_least_8;
  ACC_at_least_8_next <= EN and choice_5;

  Q <= ACC_at_least_10_next;
  ACC_last <= ACC;
  TAP0 <= ACC_at_least_2_next;
  TAP1 <= ACC_at_least_4_next;
  TAP2 <= ACC_at_least_6_next;
  TAP3 <= ACC_at_least_8_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        was <= '0';
        ACC_at_least_10 <= '0';
        ACC_at_least_2 <= '0';
        ACC_at_least_4 <= '0';
        ACC_at_least_6 <= '0';
        ACC_at_least_8 <= '0';
      else
        ACC <= ACC_next;
        was <= power;
        ACC_at_least_10 <= ACC_at_least_10_next;
        ACC_at_least_2 <= ACC_at_least_2_next;
        ACC_at_least_4 <= ACC_at_least_4_next;
        ACC_at_least_6 <= ACC_at_least_6_next;
        ACC_at_least_8 <= ACC_at_least_8_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_counters_test is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    tick       : in  std_logic;
    c1         : in  std_logic;
    c2         : in  std_logic;
    c3         : in  std_logic;
    c4         : in  std_logic;
    c5         : in  std_logic;
    c6         : in  std_logic;
    c7         : in  std_logic;
    c8         : in  std_logic;
    c9         : in  std_logic;
    cnt_en_ckt : in  std_logic;
    up_coil    : out std_logic;
    down_coil  : out std_logic;
    drum_coil  : out std_logic;
    tap0_out   : out std_logic;
    tap1_out   : out std_logic;
    tap2_out   : out std_logic;
    tap3_out   : out std_logic;
    up_ACC     : out std_logic_vector(15 downto 0);
    down_ACC   : out std_logic_vector(15 downto 0);
    drum_ACC   : out std_logic_vector(15 downto 0)
  );
end entity paper_counters_test;

architecture rtl of paper_counters_test is
  signal up_coil_reg : std_logic := '0';
  signal down_coil_reg : std_logic := '0';
  signal drum_coil_reg : std_logic := '0';
  signal tap0_out_reg : std_logic := '0';
  signal tap1_out_reg : std_logic := '0';
  signal tap2_out_reg : std_logic := '0';
  signal tap3_out_reg : std_logic := '0';
  signal rung1_power : std_logic;
  signal counting_ckt : std_logic;
  signal up_Q : std_logic;
  signal up_ACC_last : unsigned(13 downto 0);
  signal up_coil_next : std_logic;
  signal down_Q : std_logic;
  signal down_ACC_last : unsigned(2 downto 0);
  signal down_coil_next : std_logic;
  signal drum_Q : std_logic;
  signal drum_ACC_last : unsigned(10 downto 0);
  signal drum_TAP0 : std_logic;
  signal drum_TAP1 : std_logic;
  signal drum_TAP2 : std_logic;
  signal drum_TAP3 : std_logic;
  signal drum_coil_next : std_logic;
  signal tap0_out_next : std_logic;
  signal tap1_out_next : std_logic;
  signal tap2_out_next : std_logic;
  signal up_ACC_value : unsigned(15 downto 0);
  signal down_ACC_value : unsigned(15 downto 0);
  signal drum_ACC_value : unsigned(15 downto 0);
  signal tap3_out_next : std_logic;
begin

  -- rung 1 "the paper's Figure 14", paper_counters.ladder:11
  rung1_power <= c9 or (c2 and c3 and c4);
  counting_ckt <=
      (rung1_power and c1) or ((c5 or (rung1_power and c6)) and ((c7 and c8) or (c6 and c1)));

  -- rung 2 "from zero to the preset", paper_counters.ladder:20
  up: entity work.paper_counters_test_UC_PV5
    port map (
      clk => clk,
      rst => rst,
      power => counting_ckt,
      EN => cnt_en_ckt,
      Q => up_Q,
      ACC_last => up_ACC_last
    );
  up_coil_next <= up_Q;

  -- rung 3 "from the preset to zero", paper_counters.ladder:23
  down: entity work.paper_counters_test_DC_PV5
    port map (
      clk => clk,
      rst => rst,
      power => counting_ckt,
      EN => cnt_en_ckt,
      Q => down_Q,
      ACC_last => down_ACC_last
    );
  down_coil_next <= down_Q;

  -- rung 4 "up to 2047, with four taps", paper_counters.ladder:26
  drum: entity work.paper_counters_test_DRUM_PV10
    port map (
      clk => clk,
      rst => rst,
      power => counting_ckt,
      EN => cnt_en_ckt,
      Q => drum_Q,
      ACC_last => drum_ACC_last,
      TAP0 => drum_TAP0,
      TAP1 => drum_TAP1,
      TAP2 => drum_TAP2,
      TAP3 => drum_TAP3
    );
  drum_coil_next <= drum_Q;

  -- rung 5, paper_counters.ladder:29
  tap0_out_next <= drum_TAP0;

  -- rung 6, paper_counters.ladder:31
  tap1_out_next <= drum_TAP1;

  -- rung 7, paper_counters.ladder:33
  tap2_out_next <= drum_TAP2;

  -- rung 8, paper_counters.ladder:35
  up_ACC_value <= resize(up_ACC_last, 16);
  down_ACC_value <= resize(down_ACC_last, 16);
  drum_ACC_value <= resize(drum_ACC_last, 16);
  tap3_out_next <= drum_TAP3;

  up_coil <= up_coil_reg;
  down_coil <= down_coil_reg;
  drum_coil <= drum_coil_reg;
  tap0_out <= tap0_out_reg;
  tap1_out <= tap1_out_reg;
  tap2_out <= tap2_out_reg;
  tap3_out <= tap3_out_reg;
  up_ACC <= std_logic_vector(up_ACC_value);
  down_ACC <= std_logic_vector(down_ACC_value);
  drum_ACC <= std_logic_vector(drum_ACC_value);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        up_coil_reg <= '0';
        down_coil_reg <= '0';
        drum_coil_reg <= '0';
        tap0_out_reg <= '0';
        tap1_out_reg <= '0';
        tap2_out_reg <= '0';
        tap3_out_reg <= '0';
      else
        up_coil_reg <= up_coil_next;
        down_coil_reg <= down_coil_next;
        drum_coil_reg <= drum_coil_next;
        tap0_out_reg <= tap0_out_next;
        tap1_out_reg <= tap1_out_next;
        tap2_out_reg <= tap2_out_next;
        tap3_out_reg <= tap3_out_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_counters_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    up_coil     : in  std_logic;
    down_coil   : in  std_logic;
    up_ACC      : in  std_logic_vector(15 downto 0);
    down_ACC    : in  std_logic_vector(15 downto 0);
    tap0_out    : in  std_logic;
    tap1_out    : in  std_logic;
    tap2_out    : in  std_logic;
    tap3_out    : in  std_logic;
    drum_ACC    : in  std_logic_vector(15 downto 0);
    drum_coil   : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_0_3  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_1_2  : out std_logic;
    expect_1_3  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_2_2  : out std_logic;
    expect_2_3  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_3_2  : out std_logic;
    expect_3_3  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_4_2  : out std_logic;
    expect_4_3  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_6_2  : out std_logic;
    expect_6_3  : out std_logic;
    expect_6_4  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_9_2  : out std_logic;
    expect_9_3  : out std_logic;
    expect_9_4  : out std_logic;
    expect_9_5  : out std_logic;
    expect_10_0 : out std_logic;
    expect_10_1 : out std_logic;
    expect_10_2 : out std_logic
  );
end entity paper_counters_expect;

architecture rtl of paper_counters_expect is
begin

  expect_0_0 <= not up_coil;
  expect_0_1 <= not down_coil;
  expect_0_2 <= '1' when unsigned(up_ACC) = 0 else '0';
  expect_0_3 <= '1' when unsigned(down_ACC) = 5 else '0';
  expect_1_0 <= not up_coil;
  expect_1_1 <= not down_coil;
  expect_1_2 <= '1' when unsigned(up_ACC) = 4 else '0';
  expect_1_3 <= '1' when unsigned(down_ACC) = 1 else '0';
  expect_2_0 <= up_coil;
  expect_2_1 <= down_coil;
  expect_2_2 <= '1' when unsigned(up_ACC) = 5 else '0';
  expect_2_3 <= '1' when unsigned(down_ACC) = 0 else '0';
  expect_3_0 <= up_coil;
  expect_3_1 <= down_coil;
  expect_3_2 <= '1' when unsigned(up_ACC) = 6 else '0';
  expect_3_3 <= '1' when unsigned(down_ACC) = 0 else '0';
  expect_4_0 <= not up_coil;
  expect_4_1 <= not down_coil;
  expect_4_2 <= '1' when unsigned(up_ACC) = 0 else '0';
  expect_4_3 <= '1' when unsigned(down_ACC) = 5 else '0';
  expect_5_0 <= tap0_out;
  expect_5_1 <= not tap1_out;
  expect_6_0 <= tap0_out;
  expect_6_1 <= tap1_out;
  expect_6_2 <= tap2_out;
  expect_6_3 <= not tap3_out;
  expect_6_4 <= '1' when unsigned(drum_ACC) = 7 else '0';
  expect_7_0 <= tap3_out;
  expect_7_1 <= not drum_coil;
  expect_8_0 <= tap3_out;
  expect_8_1 <= drum_coil;
  expect_9_0 <= not tap0_out;
  expect_9_1 <= not tap1_out;
  expect_9_2 <= not tap2_out;
  expect_9_3 <= not tap3_out;
  expect_9_4 <= not drum_coil;
  expect_9_5 <= '1' when unsigned(drum_ACC) = 0 else '0';
  expect_10_0 <= '1' when unsigned(up_ACC) = 0 else '0';
  expect_10_1 <= '1' when unsigned(down_ACC) = 5 else '0';
  expect_10_2 <= '1' when unsigned(drum_ACC) = 0 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity paper_counters_tb is
end entity;

architecture tests of paper_counters_tb is
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
  signal cnt_en_ckt : std_logic := '0';
  signal up_coil : std_logic;
  signal down_coil : std_logic;
  signal drum_coil : std_logic;
  signal tap0_out : std_logic;
  signal tap1_out : std_logic;
  signal tap2_out : std_logic;
  signal tap3_out : std_logic;
  signal up_ACC : std_logic_vector(15 downto 0);
  signal down_ACC : std_logic_vector(15 downto 0);
  signal drum_ACC : std_logic_vector(15 downto 0);
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
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_6_2 : std_logic;
  signal expect_6_3 : std_logic;
  signal expect_6_4 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_9_2 : std_logic;
  signal expect_9_3 : std_logic;
  signal expect_9_4 : std_logic;
  signal expect_9_5 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_10_2 : std_logic;

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
  core : entity work.paper_counters_test
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
      cnt_en_ckt => cnt_en_ckt,
      up_coil => up_coil,
      down_coil => down_coil,
      drum_coil => drum_coil,
      tap0_out => tap0_out,
      tap1_out => tap1_out,
      tap2_out => tap2_out,
      tap3_out => tap3_out,
      up_ACC => up_ACC,
      down_ACC => down_ACC,
      drum_ACC => drum_ACC
    );

  expectations : entity work.paper_counters_expect
    port map (
      clk => clk,
      rst => rst,
      up_coil => up_coil,
      down_coil => down_coil,
      up_ACC => up_ACC,
      down_ACC => down_ACC,
      tap0_out => tap0_out,
      tap1_out => tap1_out,
      tap2_out => tap2_out,
      tap3_out => tap3_out,
      drum_ACC => drum_ACC,
      drum_coil => drum_coil,
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
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_6_2 => expect_6_2,
      expect_6_3 => expect_6_3,
      expect_6_4 => expect_6_4,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_9_2 => expect_9_2,
      expect_9_3 => expect_9_3,
      expect_9_4 => expect_9_4,
      expect_9_5 => expect_9_5,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_10_2 => expect_10_2
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
      cnt_en_ckt <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..3");

    -- up and down
    failed := false;
    reset;
    cnt_en_ckt <= '1';
    c9 <= '1';
    scan(1, '0');
    wait for 1 ns; -- paper_counters.ladder:39
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2 and expect_0_3) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2) & image(expect_0_3)
          & " up_coil=" & image(up_coil)
          & " down_coil=" & image(down_coil)
          & " up_ACC=" & image(up_ACC)
          & " down_ACC=" & image(down_ACC));
    end if;
    for round in 1 to 4 loop
      c1 <= '1';
      scan(1, '0');
      c1 <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- paper_counters.ladder:41
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2 and expect_1_3) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2) & image(expect_1_3)
          & " up_coil=" & image(up_coil)
          & " down_coil=" & image(down_coil)
          & " up_ACC=" & image(up_ACC)
          & " down_ACC=" & image(down_ACC));
    end if;
    c1 <= '1';
    scan(1, '0');
    c1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_counters.ladder:43
    if not failed and (expect_2_0 and expect_2_1 and expect_2_2 and expect_2_3) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2) & image(expect_2_3)
          & " up_coil=" & image(up_coil)
          & " down_coil=" & image(down_coil)
          & " up_ACC=" & image(up_ACC)
          & " down_ACC=" & image(down_ACC));
    end if;
    c1 <= '1';
    scan(1, '0');
    c1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_counters.ladder:45
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2 and expect_3_3) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2) & image(expect_3_3)
          & " up_coil=" & image(up_coil)
          & " down_coil=" & image(down_coil)
          & " up_ACC=" & image(up_ACC)
          & " down_ACC=" & image(down_ACC));
    end if;
    cnt_en_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_counters.ladder:47
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2 and expect_4_3) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2) & image(expect_4_3)
          & " up_coil=" & image(up_coil)
          & " down_coil=" & image(down_coil)
          & " up_ACC=" & image(up_ACC)
          & " down_ACC=" & image(down_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - up and down");
    else
      print("ok 1 - up and down");
    end if;

    -- the taps come on one after another
    failed := false;
    reset;
    cnt_en_ckt <= '1';
    c5 <= '1';
    c7 <= '1';
    scan(1, '0');
    for round in 1 to 2 loop
      c8 <= '1';
      scan(1, '0');
      c8 <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- paper_counters.ladder:52
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " tap0_out=" & image(tap0_out)
          & " tap1_out=" & image(tap1_out));
    end if;
    for round in 1 to 5 loop
      c8 <= '1';
      scan(1, '0');
      c8 <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- paper_counters.ladder:54
    if not failed and (expect_6_0 and expect_6_1 and expect_6_2 and expect_6_3 and expect_6_4) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2) & image(expect_6_3) & image(expect_6_4)
          & " tap0_out=" & image(tap0_out)
          & " tap1_out=" & image(tap1_out)
          & " tap2_out=" & image(tap2_out)
          & " tap3_out=" & image(tap3_out)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    c8 <= '1';
    scan(1, '0');
    c8 <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_counters.ladder:56
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " tap3_out=" & image(tap3_out)
          & " drum_coil=" & image(drum_coil));
    end if;
    for round in 1 to 2 loop
      c8 <= '1';
      scan(1, '0');
      c8 <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- paper_counters.ladder:58
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " tap3_out=" & image(tap3_out)
          & " drum_coil=" & image(drum_coil));
    end if;
    cnt_en_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_counters.ladder:60
    if not failed and (expect_9_0 and expect_9_1 and expect_9_2 and expect_9_3 and expect_9_4 and expect_9_5) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2) & image(expect_9_3) & image(expect_9_4) & image(expect_9_5)
          & " tap0_out=" & image(tap0_out)
          & " tap1_out=" & image(tap1_out)
          & " tap2_out=" & image(tap2_out)
          & " tap3_out=" & image(tap3_out)
          & " drum_coil=" & image(drum_coil)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - the taps come on one after another");
    else
      print("ok 2 - the taps come on one after another");
    end if;

    -- a rise while the enable circuit is open is seen and not counted
    failed := false;
    reset;
    c9 <= '1';
    c1 <= '1';
    scan(1, '0');
    cnt_en_ckt <= '1';
    scan(1, '0');
    wait for 1 ns; -- paper_counters.ladder:65
    if not failed and (expect_10_0 and expect_10_1 and expect_10_2) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1) & image(expect_10_2)
          & " up_ACC=" & image(up_ACC)
          & " down_ACC=" & image(down_ACC)
          & " drum_ACC=" & image(drum_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a rise while the enable circuit is open is seen and not counted");
    else
      print("ok 3 - a rise while the enable circuit is open is seen and not counted");
    end if;

    assert failures = 0 report integer'image(failures) & " of 3 tests failed" severity failure;
    wait;
  end process;
end architecture;
