-- Made by hotrail 0.1.0 from paper_bits.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_bits is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    tick     : in  std_logic;
    bc_ckt   : in  std_logic;
    bs_ckt   : in  std_logic;
    bc_coil  : out std_logic;
    bs_coil  : out std_logic;
    bitset_r : out std_logic_vector(15 downto 0)
  );
end entity paper_bits;

architecture rtl of paper_bits is
  signal bitset_r_reg : unsigned(15 downto 0) := to_unsigned(4080, 16);
  signal bc_coil_reg : std_logic := '0';
  signal bs_coil_reg : std_logic := '0';
  signal bs_coil_next : std_logic;
  signal bitset_r_next : unsigned(15 downto 0);
  signal bc_coil_next : std_logic;
begin

  -- rung 1 "BC: clears bit 7", paper_bits.ladder:8

  -- rung 2 "BS: sets bit 7", paper_bits.ladder:11
  bs_coil_next <= bs_ckt or (bitset_r_reg(7) and not bc_ckt);
  bitset_r_next <= bitset_r_reg(15 downto 8) & bs_coil_next & bitset_r_reg(6 downto 0);

  -- rung 3 "the bit is cleared", paper_bits.ladder:14
  bc_coil_next <= not bs_coil_next;

  -- rung 4 "the bit is set", paper_bits.ladder:17

  bc_coil <= bc_coil_reg;
  bs_coil <= bs_coil_reg;
  bitset_r <= std_logic_vector(bitset_r_reg);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        bitset_r_reg <= to_unsigned(4080, 16);
        bc_coil_reg <= '0';
        bs_coil_reg <= '0';
      else
        bitset_r_reg <= bitset_r_next;
        bc_coil_reg <= bc_coil_next;
        bs_coil_reg <= bs_coil_next;
      end if;
    end if;
  end process;
end architecture rtl;
