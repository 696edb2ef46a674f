-- The ladder processor: executes a ladder from its code memory, one contact in a clock.
--
-- A scan samples the inputs, executes the words up to the one that ends it, and shows the outputs.
-- While `halt` is on, no new scan begins, and between scans (`idle`) a host may load code and write
-- and read the image and the registers. docs/processor.md describes every word.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.lp.all;

entity ladder_processor is
  generic (
    INPUT_PINS       : natural := 16;   -- bits 0.. of the image, up to a quarter of it
    OUTPUT_PINS      : natural := 16;   -- bits 256.. of the image, up to a quarter of it
    -- Memories grow to the next power of two. Of the image a quarter is inputs, a quarter outputs,
    -- half flags; of the registers a quarter begins at 0, a quarter at 512, half at 1024.
    CODE_WORDS       : positive range 2 to 1024 := 1024;
    IMAGE_BITS       : positive range 8 to 1024 := 1024;
    REGISTERS        : positive range 8 to 2047 := 2047;
    TIMERS           : natural := 1;    -- 0: left out; all five: no registers either
    COUNTERS         : natural := 1;
    DRUMS            : natural := 1;
    SHIFTS           : natural := 1;
    BITS             : natural := 1;    -- bit set and bit clear
    TICKS_PER_TENTH  : natural := 100;  -- ticks in a tenth of a second; 0: no timers of tenths
    TICKS_PER_SECOND : natural := 1000;
    STACK_DEPTH      : positive range 2 to positive'high := 4;      -- bits of each stack
    CODE_FILE        : string := "";    -- NAME.hex
    REGISTER_FILE    : string := "";    -- NAME_regs.hex
    IMAGE_FILE       : string := ""     -- NAME_image.hex
  );
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    tick       : in  std_logic;         -- one clock long; kept until a scan takes it
    inputs     : in  std_logic_vector(at_least_one(INPUT_PINS) - 1 downto 0);
    outputs    : out std_logic_vector(at_least_one(OUTPUT_PINS) - 1 downto 0);
    halt       : in  std_logic;
    idle       : out std_logic;
    scan_done  : out std_logic;         -- the outputs are new with the next clock
    -- The host.
    code_write : in  std_logic;
    waddr      : in  std_logic_vector(9 downto 0);
    code_in    : in  std_logic_vector(15 downto 0);
    at_reset   : in  std_logic;         -- what bits and registers are at reset, instead of now
    io_addr    : in  std_logic_vector(9 downto 0);
    io_write   : in  std_logic;
    io_in      : in  std_logic;
    io_out     : out std_logic;
    RM_addr    : in  std_logic_vector(10 downto 0);
    RM_rw      : in  std_logic;         -- 1: write
    RM_in      : in  std_logic_vector(15 downto 0);
    RM_out     : out std_logic_vector(15 downto 0)
  );
end entity;

architecture rtl of ladder_processor is
  constant HAS_FUNCTIONS : boolean := TIMERS + COUNTERS + DRUMS + SHIFTS + BITS /= 0;

  constant CODE_ADDRESS_BITS : positive := bits_below(CODE_WORDS);
  constant QUARTER           : positive := 2 ** bits_below(IMAGE_BITS) / 4;

  constant COIL     : std_logic_vector(3 downto 0) := "1001";
  constant SET      : std_logic_vector(3 downto 0) := "1010";
  constant RESET    : std_logic_vector(3 downto 0) := "1011";
  constant INVERTED : std_logic_vector(3 downto 0) := "1100";
  constant ENDS     : std_logic_vector(3 downto 0) := "1111";

  signal resetting, is_idle, start_scan, reading_inputs, running, valid : std_logic;
  signal writing_outputs, is_done, hold, advance, end_word             : std_logic;
  signal count                                     : std_logic_vector(10 downto 0);
  signal code_out, word                            : std_logic_vector(15 downto 0);
  signal code                                      : std_logic_vector(1 downto 0);
  signal field                                     : std_logic_vector(3 downto 0);
  signal writes_code                               : std_logic;
  signal contact, output_word, prefix              : std_logic;
  signal function_word, latches, ends_circuit      : std_logic;
  signal contact_status, conducts, pwra            : std_logic;
  signal writes, value                             : std_logic;
  signal write_coil, new_coil                      : std_logic;
  signal coil_address, function_address            : std_logic_vector(9 downto 0);
  signal function_coil, function_writes            : std_logic;
begin
  assert INPUT_PINS <= QUARTER report "INPUT_PINS is 0 to a quarter of IMAGE_BITS" severity failure;
  assert OUTPUT_PINS <= QUARTER report "OUTPUT_PINS is 0 to a quarter of IMAGE_BITS" severity failure;

  idle      <= is_idle;
  scan_done <= is_done;
  advance   <= not hold;

  sequencer : entity work.lp_sequencer
    generic map (INPUT_PINS => INPUT_PINS, OUTPUT_PINS => OUTPUT_PINS)
    port map (
      clk => clk, rst => rst, halt => halt, hold => hold, end_word => end_word,
      resetting => resetting, idle => is_idle, start_scan => start_scan,
      reading_inputs => reading_inputs, running => running, valid => valid,
      writing_outputs => writing_outputs, scan_done => is_done, count => count
    );

  -- The word behind the one in work, and the one in work.
  writes_code <= is_idle and code_write;
  code_memory : entity work.lp_memory
    generic map (WIDTH => 16, ADDRESS_BITS => CODE_ADDRESS_BITS, CONTENTS => CODE_FILE)
    port map (
      clk => clk,
      write => writes_code, write_address => waddr(CODE_ADDRESS_BITS - 1 downto 0),
      write_data => code_in,
      read => advance, read_address => count(CODE_ADDRESS_BITS - 1 downto 0), read_data => code_out
    );
  process (clk)
  begin
    if rising_edge(clk) then
      if hold = '0' then
        word <= code_out;
      end if;
    end if;
  end process;
  code  <= word(15 downto 14);
  field <= word(13 downto 10);

  contact       <= valid and not code(1);
  output_word   <= valid and bit_of(code = "10");
  prefix        <= valid and bit_of(code = "11");
  function_word <= output_word and bit_of(unsigned(field) < unsigned(COIL));
  end_word      <= output_word and bit_of(field = ENDS);

  -- Power.
  latches      <= prefix and bit_of(field(3 downto 1) = "000");
  ends_circuit <= output_word or latches;
  conducts     <= contact_status xor code(0);
  power : entity work.lp_power
    generic map (STACK_DEPTH => STACK_DEPTH)
    port map (
      clk => clk, start_scan => start_scan, contact => contact, ends_circuit => ends_circuit,
      field => field, conducts => conducts, pwra => pwra
    );

  -- Coils.
  writes <= bit_of(field = COIL or field = INVERTED)
            or (bit_of(field = SET or field = RESET) and pwra);
  value  <= bit_of(field = SET) or (bit_of(field = COIL) and pwra)
            or (bit_of(field = INVERTED) and not pwra);
  write_coil   <= function_writes when function_word = '1' else output_word and writes;
  coil_address <= function_address when function_word = '1' else word(9 downto 0);
  new_coil     <= function_coil when function_word = '1' else value;
  image : entity work.lp_image
    generic map (
      INPUT_PINS => INPUT_PINS, OUTPUT_PINS => OUTPUT_PINS, SIZE => IMAGE_BITS,
      CONTENTS => IMAGE_FILE
    )
    port map (
      clk => clk, inputs => inputs, outputs => outputs,
      rst => rst, resetting => resetting, idle => is_idle, start_scan => start_scan,
      reading_inputs => reading_inputs, running => running, writing_outputs => writing_outputs,
      scan_done => is_done, count => count(9 downto 0),
      advance => advance, next_address => code_out(9 downto 0), contact_status => contact_status,
      write_coil => write_coil, coil_address => coil_address, coil => new_coil,
      at_reset => at_reset, io_addr => io_addr, io_write => io_write, io_in => io_in,
      io_out => io_out
    );

  functions : if HAS_FUNCTIONS generate
    signal waiting, has_tick, done          : std_logic;
    signal read_register, written_register  : std_logic_vector(10 downto 0);
    signal read_word, written_word          : std_logic_vector(15 downto 0);
    signal write_register                   : std_logic;
  begin
    -- A tick waits for the next scan.
    process (clk)
    begin
      if rising_edge(clk) then
        if rst = '1' or start_scan = '1' then
          waiting <= '0';
        elsif tick = '1' then
          waiting <= '1';
        end if;
      end if;
    end process;
    has_tick <= tick or waiting;

    function_unit : entity work.lp_function
      generic map (
        TIMERS => TIMERS, COUNTERS => COUNTERS, DRUMS => DRUMS, SHIFTS => SHIFTS, BITS => BITS,
        TICKS_PER_TENTH => TICKS_PER_TENTH, TICKS_PER_SECOND => TICKS_PER_SECOND
      )
      port map (
        clk => clk, rst => rst, start_scan => start_scan, tick => has_tick,
        clear_units => resetting, clear_address => count(6 downto 0),
        prefix => prefix, run => function_word, field => field, low => word(9 downto 0),
        power => pwra, done => done,
        read_register => read_register, read_word => read_word,
        write_register => write_register, written_register => written_register,
        written_word => written_word,
        write_coil => function_writes, coil_address => function_address, coil => function_coil
      );
    register_array : entity work.lp_registers
      generic map (SIZE => REGISTERS, CONTENTS => REGISTER_FILE)
      port map (
        clk => clk, rst => rst, resetting => resetting, idle => is_idle, count => count,
        read_register => read_register, read_word => read_word,
        write_register => write_register, written_register => written_register,
        written_word => written_word,
        at_reset => at_reset, RM_addr => RM_addr, RM_rw => RM_rw, RM_in => RM_in, RM_out => RM_out
      );
    hold <= function_word and not done;
  end generate;

  no_functions : if not HAS_FUNCTIONS generate
    hold             <= '0';
    function_writes  <= '0';
    function_coil    <= '0';
    function_address <= (others => '0');
    RM_out           <= (others => '0');
  end generate;
end architecture;
