-- What a counter does: up, down, or the steps of a drum. Combinational.
library ieee;
use ieee.std_logic_1164.all;

entity lp_counter is
  port (
    down   : in  std_logic;
    enable : in  std_logic;
    rises  : in  std_logic;
    at_end : in  std_logic;             -- the count is the last one of its direction
    clears : out std_logic;             -- it goes back to 0
    loads  : out std_logic;             -- it becomes the preset
    counts : out std_logic              -- it goes one on
  );
end entity;

architecture rtl of lp_counter is
begin
  clears <= not enable and not down;
  loads  <= not enable and down;
  counts <= rises and not at_end;
end architecture;
