-- Bits, last in, first out. Put and take at once exchange the top. What a circuit leaves behind may
-- stay: the next one never takes more than it has put.
library ieee;
use ieee.std_logic_1164.all;

entity lp_stack is
  generic (
    DEPTH : positive := 4
  );
  port (
    clk     : in  std_logic;
    put     : in  std_logic;
    take    : in  std_logic;
    put_bit : in  std_logic;
    top     : out std_logic
  );
end entity;

architecture rtl of lp_stack is
  signal bits : std_logic_vector(DEPTH - 1 downto 0);       -- the top is bit 0
begin
  top <= bits(0);

  process (clk)
  begin
    if rising_edge(clk) then
      if put = '1' and take = '1' then
        bits(0) <= put_bit;
      elsif put = '1' then
        bits <= bits(DEPTH - 2 downto 0) & put_bit;
      elsif take = '1' then
        bits <= '0' & bits(DEPTH - 1 downto 1);
      end if;
    end if;
  end process;
end architecture;
