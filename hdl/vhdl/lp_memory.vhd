-- A memory with one port to write and one to read, which infers as block RAM. A read shows one clock
-- later what stood there; nobody needs what it shows of an address that is written in the same clock.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity lp_memory is
  generic (
    WIDTH        : positive := 16;
    ADDRESS_BITS : positive := 10;
    CONTENTS     : string := ""         -- a file as for $readmemh: at power-up; none if empty
  );
  port (
    clk           : in  std_logic;
    write         : in  std_logic;
    write_address : in  std_logic_vector(ADDRESS_BITS - 1 downto 0);
    write_data    : in  std_logic_vector(WIDTH - 1 downto 0);
    read          : in  std_logic;      -- without it the last word read stays
    read_address  : in  std_logic_vector(ADDRESS_BITS - 1 downto 0);
    read_data     : out std_logic_vector(WIDTH - 1 downto 0)
  );
end entity;

architecture rtl of lp_memory is
  constant LAST : natural := 2 ** ADDRESS_BITS - 1;
  type memory is array (0 to LAST) of std_logic_vector(WIDTH - 1 downto 0);

  function value_of(digit : character) return integer is
  begin
    case digit is
      when '0' to '9' => return character'pos(digit) - character'pos('0');
      when 'A' to 'F' => return character'pos(digit) - character'pos('A') + 10;
      when 'a' to 'f' => return character'pos(digit) - character'pos('a') + 10;
      when others => return -1;
    end case;
  end function;

  -- Words in hexadecimal, `@` in front of an address, comments from `//` on.
  impure function contents_of(name : string) return memory is
    file source       : text open read_mode is name;
    variable row      : line;
    variable words    : memory := (others => (others => '0'));
    variable at       : natural := 0;
    variable number   : natural;
    variable digits   : natural;
    variable is_place : boolean;
    variable position : positive;
  begin
    while not endfile(source) loop
      readline(source, row);
      position := 1;
      while position <= row'length loop
        exit when row(position) = '/';
        is_place := row(position) = '@';
        if is_place then
          position := position + 1;
        end if;
        number := 0;
        digits := 0;
        while position <= row'length loop
          exit when value_of(row(position)) < 0;
          number := number * 16 + value_of(row(position));
          digits := digits + 1;
          position := position + 1;
        end loop;
        if digits = 0 then
          position := position + 1;
        elsif is_place then
          at := number;
        else
          words(at) := std_logic_vector(to_unsigned(number, WIDTH));
          at := at + 1;
        end if;
      end loop;
    end loop;
    return words;
  end function;

  impure function start return memory is
  begin
    if CONTENTS = "" then
      return (others => (others => '0'));
    end if;
    return contents_of(CONTENTS);
  end function;

  signal words : memory := start;
begin
  process (clk)
  begin
    if rising_edge(clk) then
      if write = '1' then
        words(to_integer(unsigned(write_address))) <= write_data;
      end if;
      if read = '1' then
        read_data <= words(to_integer(unsigned(read_address)));
      end if;
    end if;
  end process;
end architecture;
