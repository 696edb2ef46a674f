-- Made by hotrail 0.1.0 from reversing_starter.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity reversing_starter is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    stop        : in  std_logic;
    overload    : in  std_logic;
    forward     : in  std_logic;
    reverse     : in  std_logic;
    run_forward : out std_logic;
    run_reverse : out std_logic;
    fault       : out std_logic
  );
end entity reversing_starter;

architecture rtl of reversing_starter is
  signal run_forward_reg : std_logic := '0';
  signal run_reverse_reg : std_logic := '0';
  signal fault_reg : std_logic := '0';
  signal run_forward_next : std_logic;
  signal run_reverse_next : std_logic;
  signal fault_next : std_logic;
begin

  -- rung 1 "forward", reversing_starter.ladder:10
  run_forward_next <=
      (forward or run_forward_reg) and stop and not overload and not reverse
      and not run_reverse_reg;

  -- rung 2 "reverse", reversing_starter.ladder:13
  run_reverse_next <=
      (reverse or run_reverse_reg) and stop and not overload and not forward
      and not run_forward_next;

  -- rung 3 "overload lamp", reversing_starter.ladder:16
  fault_next <= overload;

  run_forward <= run_forward_reg;
  run_reverse <= run_reverse_reg;
  fault <= fault_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        run_forward_reg <= '0';
        run_reverse_reg <= '0';
        fault_reg <= '0';
      else
        run_forward_reg <= run_forward_next;
        run_reverse_reg <= run_reverse_next;
        fault_reg <= fault_next;
      end if;
    end if;
  end process;
end architecture rtl;
