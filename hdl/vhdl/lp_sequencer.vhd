-- Resets the memories and shows the outputs, then scans: samples the inputs, runs the words, shows the
-- outputs.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.lp.all;

entity lp_sequencer is
  generic (
    INPUT_PINS  : natural := 16;        -- 0 to 256
    OUTPUT_PINS : natural := 16
  );
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    halt            : in  std_logic;    -- no new scan begins
    hold            : in  std_logic;    -- a function needs more clocks
    end_word        : in  std_logic;    -- the word in work ends the scan
    resetting       : out std_logic;    -- memories are being reset
    idle            : out std_logic;    -- between two scans
    start_scan      : out std_logic;    -- inputs are sampled
    reading_inputs  : out std_logic;    -- the input `count` goes into the image
    running         : out std_logic;    -- words are executed
    valid           : out std_logic;    -- the word in work is one of this scan
    writing_outputs : out std_logic;    -- outputs are on their way, the one at `count` next
    scan_done       : out std_logic;    -- outputs are shown
    count           : out std_logic_vector(10 downto 0)     -- of what the state does; the next word
  );
end entity;

architecture rtl of lp_sequencer is
  constant RESETS : std_logic_vector(2 downto 0) := "000";
  constant WAITS  : std_logic_vector(2 downto 0) := "001";
  constant READS  : std_logic_vector(2 downto 0) := "010";
  constant RUNS   : std_logic_vector(2 downto 0) := "011";
  constant WRITES : std_logic_vector(2 downto 0) := "100";
  constant SHOWS  : std_logic_vector(2 downto 0) := "101";

  signal state  : std_logic_vector(2 downto 0);
  signal filled : std_logic_vector(1 downto 0);     -- words behind each other: read from memory, in work
  signal place  : unsigned(10 downto 0);
  signal is_idle, is_running, is_valid, starts, leaves : std_logic;
begin
  is_idle    <= bit_of(state = WAITS);
  is_running <= bit_of(state = RUNS);
  is_valid   <= is_running and filled(1);
  starts     <= is_idle and not halt;

  resetting       <= bit_of(state = RESETS);
  idle            <= is_idle;
  start_scan      <= starts;
  reading_inputs  <= bit_of(state = READS);
  running         <= is_running;
  valid           <= is_valid;
  writing_outputs <= bit_of(state = WRITES);
  scan_done       <= bit_of(state = SHOWS);
  count           <= std_logic_vector(place);

  leaves <= bit_of(place = 2047) when state = RESETS else
            starts when state = WAITS else
            bit_of(place = at_least_one(INPUT_PINS) - 1) when state = READS else
            is_valid and end_word when state = RUNS else
            bit_of(place = OUTPUT_PINS) when state = WRITES else
            '1';

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        state <= RESETS;
      elsif leaves = '1' then
        if state = WAITS and INPUT_PINS /= 0 then
          state <= READS;
        elsif state = WAITS or state = READS then
          state <= RUNS;
        elsif state = RESETS or state = RUNS then
          state <= WRITES;
        elsif state = WRITES then
          state <= SHOWS;
        else
          state <= WAITS;
        end if;
      end if;
      if rst = '1' or leaves = '1' then
        place <= (others => '0');
      elsif hold = '0' then
        place <= place + 1;
      end if;
      if is_running = '0' then
        filled <= "00";
      else
        filled <= filled(0) & '1';
      end if;
    end if;
  end process;
end architecture;
