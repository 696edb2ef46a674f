-- Made by hotrail 0.1.0 from bridge.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity bridge is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    c1    : in  std_logic;
    c2    : in  std_logic;
    c3    : in  std_logic;
    c4    : in  std_logic;
    c5    : in  std_logic;
    c6    : in  std_logic;
    c7    : in  std_logic;
    c8    : in  std_logic;
    c9    : in  std_logic;
    CR316 : out std_logic
  );
end entity bridge;

architecture rtl of bridge is
  signal CR316_reg : std_logic := '0';
  signal rung1_power : std_logic;
  signal CR316_next : std_logic;
begin

  -- rung 1 "the bridge", bridge.ladder:7
  rung1_power <= c9 or (c2 and c3 and c4);
  CR316_next <=
      (rung1_power and c1) or ((c5 or (rung1_power and c6)) and ((c7 and c8) or (c6 and c1)));

  CR316 <= CR316_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CR316_reg <= '0';
      else
        CR316_reg <= CR316_next;
      end if;
    end if;
  end process;
end architecture rtl;
