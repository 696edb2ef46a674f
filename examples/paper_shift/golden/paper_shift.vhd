-- Made by hotrail 0.1.0 from paper_shift.ladder. Do not edit: change the ladder and build again.

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

entity paper_shift_SHL_48 is
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
end entity paper_shift_SHL_48;

architecture rtl of paper_shift_SHL_48 is
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

entity paper_shift_SHR_32 is
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
end entity paper_shift_SHR_32;

architecture rtl of paper_shift_SHR_32 is
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

entity paper_shift is
  port (
    clk            : in  std_logic;
    rst            : in  std_logic;
    tick           : in  std_logic;
    shift_ckt      : in  std_logic;
    shift_en_ckt   : in  std_logic;
    serialdata_ckt : in  std_logic;
    left_coil      : out std_logic;
    right_coil     : out std_logic
  );
end entity paper_shift;

architecture rtl of paper_shift is
  signal actualdata_0 : unsigned(15 downto 0) := x"FFFF";
  signal actualdata_1 : unsigned(15 downto 0) := to_unsigned(3855, 16);
  signal actualdata_2 : unsigned(15 downto 0) := x"F0F0";
  signal two_0 : unsigned(15 downto 0) := to_unsigned(3855, 16);
  signal two_1 : unsigned(15 downto 0) := x"8001";
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
  sl: entity work.paper_shift_SHL_48
    port map (
      clk => clk,
      rst => rst,
      power => shift_ckt,
      EN => shift_en_ckt,
      DATA => serialdata_ckt,
      REG0_before => actualdata_0,
      REG1_before => actualdata_1,
      REG2_before => actualdata_2,
      Q => sl_Q,
      REG0 => sl_REG0,
      REG1 => sl_REG1,
      REG2 => sl_REG2
    );
  left_coil_next <= sl_Q;

  -- rung 2 "SR", paper_shift.ladder:13
  sr: entity work.paper_shift_SHR_32
    port map (
      clk => clk,
      rst => rst,
      power => shift_ckt,
      EN => shift_en_ckt,
      DATA => serialdata_ckt,
      REG0_before => two_0,
      REG1_before => two_1,
      Q => sr_Q,
      REG0 => sr_REG0,
      REG1 => sr_REG1
    );
  right_coil_next <= sr_Q;

  left_coil <= left_coil_reg;
  right_coil <= right_coil_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        actualdata_0 <= x"FFFF";
        actualdata_1 <= to_unsigned(3855, 16);
        actualdata_2 <= x"F0F0";
        two_0 <= to_unsigned(3855, 16);
        two_1 <= x"8001";
        left_coil_reg <= '0';
        right_coil_reg <= '0';
      else
        actualdata_0 <= sl_REG0;
        actualdata_1 <= sl_REG1;
        actualdata_2 <= sl_REG2;
        two_0 <= sr_REG0;
        two_1 <= sr_REG1;
        left_coil_reg <= left_coil_next;
        right_coil_reg <= right_coil_next;
      end if;
    end if;
  end process;
end architecture rtl;
