-- What the files of the processor share.
library ieee;
use ieee.std_logic_1164.all;

package lp is
  -- How wide a port of so many pins is: there is one where there are none.
  function at_least_one(pins : natural) return positive;
  -- How many bits a count from 0 to below this number takes, at least one.
  function bits_below(number : natural) return positive;
  function bit_of(condition : boolean) return std_logic;
  -- Where an address stands in a memory of 2 ** bits: a quarter of it each for the first and the
  -- second quarter of the addresses, half of it for the others. So an address means the same
  -- whatever the size; what lies beyond falls together with what is there.
  function place_of(address : std_logic_vector; bits : positive) return std_logic_vector;
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

  function place_of(address : std_logic_vector; bits : positive) return std_logic_vector is
    constant WIDTH   : positive := address'length;
    variable from    : std_logic_vector(WIDTH - 1 downto 0) := address;
    variable quarter : std_logic := from(WIDTH - 2);
  begin
    if from(WIDTH - 1) = '1' then
      quarter := from(bits - 2);
    end if;
    return from(WIDTH - 1) & quarter & from(bits - 3 downto 0);
  end function;
end package body;
