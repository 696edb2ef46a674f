-- Made by hotrail 0.1.0 from order_next_scan.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity order_next_scan is
  port (
    clk  : in  std_logic;
    rst  : in  std_logic;
    tick : in  std_logic;
    X0   : in  std_logic;
    Y0   : out std_logic;
    Y1   : out std_logic
  );
end entity order_next_scan;

architecture rtl of order_next_scan is
  signal Y0_reg : std_logic := '0';
  signal Y1_reg : std_logic := '0';
  signal Y1_next : std_logic;
  signal Y0_next : std_logic;
begin

  -- rung 1, order_next_scan.ladder:7
  Y1_next <= Y0_reg;

  -- rung 2, order_next_scan.ladder:8
  Y0_next <= X0;

  Y0 <= Y0_reg;
  Y1 <= Y1_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Y0_reg <= '0';
        Y1_reg <= '0';
      else
        Y0_reg <= Y0_next;
        Y1_reg <= Y1_next;
      end if;
    end if;
  end process;
end architecture rtl;
