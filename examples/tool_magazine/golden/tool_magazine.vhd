-- Made by hotrail 0.1.0 from tool_magazine.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity tool_magazine is
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
    Y4   : out std_logic
  );
end entity tool_magazine;

architecture rtl of tool_magazine is
  signal M2 : std_logic := '0';
  signal Y14 : std_logic := '0';
  signal M3 : std_logic := '0';
  signal M15 : std_logic := '0';
  signal Y0_reg : std_logic := '0';
  signal Y2_reg : std_logic := '0';
  signal Y3_reg : std_logic := '0';
  signal Y4_reg : std_logic := '0';
  signal M51 : std_logic := '0';
  signal X16_before : std_logic := '0';
  signal Y1_reg : std_logic := '0';
  signal turn_reg : std_logic := '0';
  signal T2 : std_logic;
  signal T3 : std_logic;
  signal T11 : std_logic;
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
  T11 <= X4 and not X3 and X2 and X1;
  M51_next <= X4 and X3 and not X2 and not X1;

  -- rung 2 "call a location", tool_magazine.ladder:29
  M2_rung2 <= T2 or M2;
  Y14_rung2 <= T2 or Y14;
  M3_rung2 <= M3 and not T2;
  M3_rung2_2 <= T3 or M3_rung2;
  M2_rung2_2 <= M2_rung2 and not T3;
  M15_rung2 <= M15 and not T3;
  Y14_next <= Y14_rung2 and not T11;

  -- rung 3 "turn until it is reached", tool_magazine.ladder:32
  turn_next <= (M2_rung2_2 and not at2) or (M3_rung2_2 and not at3);

  -- rung 4, tool_magazine.ladder:34
  Y0_next <= (M2_rung2_2 and at2) or (M3_rung2_2 and at3);

  -- rung 5 "move the tool forward (paper, rung 4)", tool_magazine.ladder:36
  Y2_next <= ((Y14_next and Y0_next and not Y0_reg) or Y2_reg) and not X15 and not Y3_reg;

  -- rung 6 "air pump (paper, rung 5)", tool_magazine.ladder:39
  Y4_next <= ((Y2_next and not Y2_reg) or Y4_reg or M51) and not M15_rung2;

  -- rung 7 "close the pump", tool_magazine.ladder:42

  -- rung 8, tool_magazine.ladder:44
  M15_next <= T11 or M15_rung2;

  -- rung 9 "bring the tool back", tool_magazine.ladder:46
  rung9_power <= M51_next and not M51;
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

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        M2 <= '0';
        Y14 <= '0';
        M3 <= '0';
        M15 <= '0';
        Y0_reg <= '0';
        Y2_reg <= '0';
        Y3_reg <= '0';
        Y4_reg <= '0';
        M51 <= '0';
        X16_before <= '0';
        Y1_reg <= '0';
        turn_reg <= '0';
      else
        M2 <= M2_next;
        Y14 <= Y14_next;
        M3 <= M3_next;
        M15 <= M15_next;
        Y0_reg <= Y0_next;
        Y2_reg <= Y2_next;
        Y3_reg <= Y3_next;
        Y4_reg <= Y4_next;
        M51 <= M51_next;
        X16_before <= X16;
        Y1_reg <= Y1_next;
        turn_reg <= turn_next;
      end if;
    end if;
  end process;
end architecture rtl;
