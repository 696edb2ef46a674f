-- The image: bits for inputs, outputs and flags, what they are at reset, and the pins.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.lp.all;

entity lp_image is
  generic (
    INPUT_PINS  : natural := 16;
    OUTPUT_PINS : natural := 16;
    SIZE        : positive := 1024;     -- 8 to 1024, grown to the next power of two
    CONTENTS    : string := ""          -- what the bits are at reset
  );
  port (
    clk             : in  std_logic;
    inputs          : in  std_logic_vector(at_least_one(INPUT_PINS) - 1 downto 0);
    outputs         : out std_logic_vector(at_least_one(OUTPUT_PINS) - 1 downto 0);
    -- What the sequencer does.
    rst             : in  std_logic;
    resetting       : in  std_logic;
    idle            : in  std_logic;
    start_scan      : in  std_logic;
    reading_inputs  : in  std_logic;
    running         : in  std_logic;
    writing_outputs : in  std_logic;
    scan_done       : in  std_logic;
    count           : in  std_logic_vector(9 downto 0);
    -- Contacts and coils.
    advance         : in  std_logic;    -- the word behind the one in work goes into work
    next_address    : in  std_logic_vector(9 downto 0);
    contact_status  : out std_logic;    -- the bit of the word in work
    write_coil      : in  std_logic;
    coil_address    : in  std_logic_vector(9 downto 0);
    coil            : in  std_logic;
    -- The host, between scans.
    at_reset        : in  std_logic;
    io_addr         : in  std_logic_vector(9 downto 0);
    io_write        : in  std_logic;
    io_in           : in  std_logic;
    io_out          : out std_logic
  );
end entity;

architecture rtl of lp_image is
  constant IN_BITS  : positive := at_least_one(INPUT_PINS);
  constant OUT_BITS : positive := at_least_one(OUTPUT_PINS);
  constant PLACE_BITS : positive := bits_below(SIZE);

  signal place, put_place                    : std_logic_vector(9 downto 0);
  signal resets, samples, hosts, host_bit    : std_logic;
  signal writes_reset                        : std_logic;
  signal io_data, initial_data               : std_logic_vector(0 downto 0);
  signal sampled                             : std_logic_vector(IN_BITS - 1 downto 0);
  signal is_one, put, put_bit                : std_logic;
  signal write                               : std_logic;
  signal written, looked_at                  : std_logic_vector(9 downto 0);
  signal initial_place, host_place           : std_logic_vector(PLACE_BITS - 1 downto 0);
  signal write_address, read_address         : std_logic_vector(PLACE_BITS - 1 downto 0);
  signal write_data, stored                  : std_logic_vector(0 downto 0);
  signal is_new, new_bit, status             : std_logic;
  signal collected                           : std_logic_vector(OUT_BITS - 1 downto 0);
  signal collects                            : std_logic;
begin
  -- Bits at reset, inputs and those of the host are written one clock after their turn: a bit at
  -- reset has to be read first.
  place <= io_addr when idle = '1' else count;
  process (clk)
  begin
    if rising_edge(clk) then
      put_place <= place;
      resets    <= resetting and not rst;
      samples   <= reading_inputs;
      hosts     <= idle and io_write and not at_reset;
      host_bit  <= io_in;
    end if;
  end process;

  initial_place <= place_of(place, PLACE_BITS);
  host_place    <= place_of(io_addr, PLACE_BITS);
  writes_reset <= idle and io_write and at_reset;
  io_data(0)   <= io_in;
  initial_bits : entity work.lp_memory
    generic map (WIDTH => 1, ADDRESS_BITS => PLACE_BITS, CONTENTS => CONTENTS)
    port map (
      clk => clk,
      write => writes_reset, write_address => host_place, write_data => io_data,
      read => '1', read_address => initial_place, read_data => initial_data
    );

  -- The inputs go in one by one, the first first.
  process (clk)
  begin
    if rising_edge(clk) then
      if start_scan = '1' then
        sampled <= inputs;
      elsif samples = '1' then
        sampled <= std_logic_vector(shift_right(unsigned(sampled), 1));
      end if;
    end if;
  end process;

  -- The last bit at reset is the constant 1.
  is_one  <= resets and not resetting;
  put     <= resets or samples or hosts;
  put_bit <= (initial_data(0) or is_one) when resets = '1' else
             sampled(0) when samples = '1' else
             host_bit;

  write         <= put or write_coil;
  written       <= put_place when put = '1' else coil_address;
  write_data(0) <= put_bit when put = '1' else coil;
  looked_at     <= next_address when running = '1' else
                   "01" & place(7 downto 0) when writing_outputs = '1' else
                   place;
  write_address <= place_of(written, PLACE_BITS);
  read_address  <= place_of(looked_at, PLACE_BITS);
  bits : entity work.lp_memory
    generic map (WIDTH => 1, ADDRESS_BITS => PLACE_BITS)
    port map (
      clk => clk,
      write => write, write_address => write_address, write_data => write_data,
      read => advance, read_address => read_address, read_data => stored
    );

  -- A contact right behind a coil on the same bit sees what the coil wrote, and a host what it wrote.
  process (clk)
  begin
    if rising_edge(clk) then
      if advance = '1' then
        is_new  <= write and bit_of(write_address = read_address);
        new_bit <= write_data(0);
      end if;
    end if;
  end process;
  status         <= new_bit when is_new = '1' else stored(0);
  contact_status <= status;
  io_out         <= initial_data(0) when at_reset = '1' else status;

  -- The outputs come out one by one and are shown all at once.
  process (clk)
  begin
    if rising_edge(clk) then
      collects <= writing_outputs and bit_of(unsigned(count(8 downto 0)) /= OUTPUT_PINS);
      if collects = '1' then
        collected <= std_logic_vector(shift_right(unsigned(collected), 1));
        collected(OUT_BITS - 1) <= status;
      end if;
      if rst = '1' then
        outputs <= (others => '0');
      elsif scan_done = '1' then
        outputs <= collected;
      end if;
    end if;
  end process;
end architecture;
