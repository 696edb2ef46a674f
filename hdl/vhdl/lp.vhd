-- What the files of the processor share.
library ieee;
use ieee.std_logic_1164.all;

package lp is
  -- How wide a port of so many pins is: there is one where there are none.
  function at_least_one(pins : natural) return positive;
  -- How many bits a count from 0 to below this number takes, at least one.
  function bits_below(number : natural) return positive;
  function bit_of(condition : boolean) return std_logic;
end package;

package body lp is
  function at_least_one(pins : natural) return positive is
  begin
    if pins = 0 then
      return 1;
    end if;
    return pins;
  end function;

  function bits_below(number : natural) return positive is
    variable bits : positive := 1;
  begin
    while bits < 31 and 2 ** bits < number loop
      bits := bits + 1;
    end loop;
    return bits;
  end function;

  function bit_of(condition : boolean) return std_logic is
  begin
    if condition then
      return '1';
    end if;
    return '0';
  end function;
end package body;
