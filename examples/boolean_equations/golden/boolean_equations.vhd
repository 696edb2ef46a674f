-- Made by hotrail 0.1.0 from boolean_equations.ladder. Do not edit: change the ladder and build again.

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

entity boolean_equations_CTU_PV10 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity boolean_equations_CTU_PV10;

architecture rtl of boolean_equations_CTU_PV10 is
  signal CV : unsigned(3 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal CV_next : unsigned(3 downto 0);
  signal equal_2 : std_logic;
begin
  condition <= power and not was;
  equal <= '1' when CV = 10 else '0';
  CV_next <= CV + (to_unsigned(0, 3) & (condition and not equal));
  equal_2 <= '1' when CV = 9 else '0';

  Q <= (condition and equal_2) or equal;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
        was <= '0';
      else
        CV <= CV_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity boolean_equations is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    X1   : in  std_logic;
    X2   : in  std_logic;
    X3   : in  std_logic;
    X4   : in  std_logic;
    Y1   : out std_logic;
    Y2   : out std_logic
  );
end entity boolean_equations;

architecture rtl of boolean_equations is
  signal Y1_reg : std_logic := '0';
  signal Y2_reg : std_logic := '0';
  signal Y1_next : std_logic;
  signal C2_Q : std_logic;
  signal Y2_next : std_logic;
begin

  -- rung 1 "Y1 <- !X1 & X2 & (X3 & X4)", boolean_equations.ladder:8
  Y1_next <= not X1 and X2 and X3 and X4;

  -- rung 2 "C2(K10) <- X2", boolean_equations.ladder:11
  C2: entity work.boolean_equations_CTU_PV10
    port map (
      clk => clk,
      rst => rst,
      power => X2,
      Q => C2_Q
    );

  -- rung 3 "Y2 <- C2", boolean_equations.ladder:14
  Y2_next <= C2_Q;

  Y1 <= Y1_reg;
  Y2 <= Y2_reg;

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
