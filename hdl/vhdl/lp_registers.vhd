-- The register array: presets, counts and words, and what they are at reset.
library ieee;
use ieee.std_logic_1164.all;
use work.lp.all;

entity lp_registers is
  generic (
    SIZE     : positive := 2047;        -- 8 to 2047, grown to the next power of two
    CONTENTS : string := ""             -- what the registers are at reset
  );
  port (
    clk              : in  std_logic;
    rst              : in  std_logic;
    resetting        : in  std_logic;
    idle             : in  std_logic;
    count            : in  std_logic_vector(10 downto 0);
    -- The functions.
    read_register    : in  std_logic_vector(10 downto 0);
    read_word        : out std_logic_vector(15 downto 0);
    write_register   : in  std_logic;
    written_register : in  std_logic_vector(10 downto 0);
    written_word     : in  std_logic_vector(15 downto 0);
    -- The host, between scans.
    at_reset         : in  std_logic;
    RM_addr          : in  std_logic_vector(10 downto 0);
    RM_rw            : in  std_logic;   -- 1: write
    RM_in            : in  std_logic_vector(15 downto 0);
    RM_out           : out std_logic_vector(15 downto 0)
  );
end entity;

architecture rtl of lp_registers is
  constant PLACE_BITS : positive := bits_below(SIZE);

  signal copied, initial_address       : std_logic_vector(10 downto 0);
  signal write_address, read_address   : std_logic_vector(10 downto 0);
  signal initial_place, host_place     : std_logic_vector(PLACE_BITS - 1 downto 0);
  signal write_place, read_place       : std_logic_vector(PLACE_BITS - 1 downto 0);
  signal copies, writes_initial, write : std_logic;
  signal initial_word, word            : std_logic_vector(15 downto 0);
  signal write_data                    : std_logic_vector(15 downto 0);
begin
  process (clk)
  begin
    if rising_edge(clk) then
      copied <= count;
      copies <= resetting and not rst;
    end if;
  end process;

  writes_initial  <= idle and RM_rw and at_reset;
  initial_address <= RM_addr when idle = '1' else count;
  initial_place <= place_of(initial_address, PLACE_BITS);
  host_place    <= place_of(RM_addr, PLACE_BITS);
  initial_registers : entity work.lp_memory
    generic map (WIDTH => 16, ADDRESS_BITS => PLACE_BITS, CONTENTS => CONTENTS)
    port map (
      clk => clk,
      write => writes_initial, write_address => host_place, write_data => RM_in,
      read => '1', read_address => initial_place, read_data => initial_word
    );

  write         <= copies or (idle and RM_rw and not at_reset) or (not idle and write_register);
  write_address <= copied when copies = '1' else RM_addr when idle = '1' else written_register;
  write_data    <= initial_word when copies = '1' else RM_in when idle = '1' else written_word;
  read_address  <= RM_addr when idle = '1' else read_register;
  write_place   <= place_of(write_address, PLACE_BITS);
  read_place    <= place_of(read_address, PLACE_BITS);
  registers : entity work.lp_memory
    generic map (WIDTH => 16, ADDRESS_BITS => PLACE_BITS)
    port map (
      clk => clk,
      write => write, write_address => write_place, write_data => write_data,
      read => '1', read_address => read_place, read_data => word
    );

  read_word <= word;
  RM_out    <= initial_word when at_reset = '1' else word;
end architecture;
