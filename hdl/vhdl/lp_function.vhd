-- Timers, counters, drums, shifts and bits of registers: takes what prefixes give, and runs an
-- operation in several clocks while the words behind it wait. The operation of a kind that is left
-- out takes three clocks and does nothing.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.lp.all;

entity lp_function is
  generic (
    TIMERS           : natural := 1;
    COUNTERS         : natural := 1;
    DRUMS            : natural := 1;
    SHIFTS           : natural := 1;
    BITS             : natural := 1;
    TICKS_PER_TENTH  : natural := 100;
    TICKS_PER_SECOND : natural := 1000
  );
  port (
    clk              : in  std_logic;
    rst              : in  std_logic;
    start_scan       : in  std_logic;
    tick             : in  std_logic;
    clear_units      : in  std_logic;   -- while memories are being reset
    clear_address    : in  std_logic_vector(6 downto 0);
    -- The word in work.
    prefix           : in  std_logic;
    run              : in  std_logic;   -- a function, for all the clocks that it takes
    field            : in  std_logic_vector(3 downto 0);    -- kind of prefix, or operation
    low              : in  std_logic_vector(9 downto 0);
    power            : in  std_logic;
    done             : out std_logic;   -- in the last of these clocks
    -- The register array: a read shows its word one clock later.
    read_register    : out std_logic_vector(10 downto 0);
    read_word        : in  std_logic_vector(15 downto 0);
    write_register   : out std_logic;
    written_register : out std_logic_vector(10 downto 0);
    written_word     : out std_logic_vector(15 downto 0);
    -- The image.
    write_coil       : out std_logic;
    coil_address     : out std_logic_vector(9 downto 0);
    coil             : out std_logic
  );
end entity;

architecture rtl of lp_function is
  -- Operations.
  constant TS          : std_logic_vector(3 downto 0) := "0000";
  constant TT          : std_logic_vector(3 downto 0) := "0001";
  constant UC          : std_logic_vector(3 downto 0) := "0010";
  constant DC          : std_logic_vector(3 downto 0) := "0011";
  constant BIT_SET     : std_logic_vector(3 downto 0) := "0100";
  constant BIT_CLEAR   : std_logic_vector(3 downto 0) := "0101";
  constant DRUM        : std_logic_vector(3 downto 0) := "0110";
  constant SHIFT_RIGHT : std_logic_vector(3 downto 0) := "0111";
  constant SHIFT_LEFT  : std_logic_vector(3 downto 0) := "1000";
  -- Prefixes.
  constant ENABLES     : std_logic_vector(3 downto 0) := "0000";
  constant SERIALS     : std_logic_vector(3 downto 0) := "0001";
  constant UNIT        : std_logic_vector(3 downto 0) := "0010";
  constant NUMBERS     : std_logic_vector(3 downto 0) := "0011";

  signal is_timer, is_counter, is_drum, is_left, is_right, is_bit, down : std_logic;
  signal is_shift, is_count                       : std_logic;
  signal begun, no_taps, last_one, is_done        : std_logic;
  signal later                                    : std_logic_vector(8 downto 1);
  signal at                                       : std_logic_vector(8 downto 0);
  signal number                                   : unsigned(5 downto 0);   -- as given; taps or registers that are left
  signal enable, serial                           : std_logic;
  signal unit_number                              : std_logic_vector(5 downto 0);
  signal timer_type                               : std_logic_vector(1 downto 0);
  signal next_register                            : unsigned(10 downto 0);  -- the one that is read
  signal unit_address, kept_address               : std_logic_vector(6 downto 0);
  signal keeps                                    : std_logic;
  signal kept_now, kept_before                    : std_logic_vector(2 downto 0);
  signal was, was_enabled, runs, runs_on, rises   : std_logic;
  signal tenth, second, pulse                     : std_logic;
  signal reached, at_end                          : std_logic;
  signal timer_clears, timer_counts, timer_coil, timer_runs_on, timer_ends : std_logic;
  signal counter_clears, counter_loads, counter_counts                     : std_logic;
  signal clears, loads, counts, reaches, ends     : std_logic;
  signal load_largest, load_word, load_left, load_right, load_bit          : std_logic;
  signal load_preset, load_next, clear, set_bit, read_preset, limit_preset : std_logic;
  signal later_taps                               : std_logic;
  signal carry, has_bit, moves                    : std_logic;
  signal count_register, shifted_register         : std_logic_vector(10 downto 0);
  signal tap                                      : unsigned(4 downto 0);
begin
  -- Known from clock 1 of an operation on.
  process (clk)
  begin
    if rising_edge(clk) then
      is_timer   <= bit_of(TIMERS /= 0 and (field = TS or field = TT));
      is_counter <= bit_of(COUNTERS /= 0 and (field = UC or field = DC));
      is_drum    <= bit_of(DRUMS /= 0 and field = DRUM);
      is_left    <= bit_of(SHIFTS /= 0 and field = SHIFT_LEFT);
      is_right   <= bit_of(SHIFTS /= 0 and field = SHIFT_RIGHT);
      is_bit     <= bit_of(BITS /= 0 and (field = BIT_SET or field = BIT_CLEAR));
      down       <= bit_of(COUNTERS /= 0 and field = DC);
    end if;
  end process;
  is_shift <= is_left or is_right;
  is_count <= is_timer or is_counter or is_drum;

  -- The clock of the operation. A count takes 0 to 7, and one more 8 for each tap; a shift takes
  -- 0, and 1 and 2 for each register; a bit takes 0 to 2.
  at      <= later & (run and not begun);
  is_done <= ((at(7) and no_taps) or (at(8) and last_one)) when is_count = '1' else
             at(2) and last_one;
  done    <= is_done;
  process (clk)
  begin
    if rising_edge(clk) then
      no_taps  <= not is_drum or bit_of(number = 0);
      last_one <= (not is_shift and not is_drum) or bit_of(number = 1);
      if run = '0' or is_done = '1' then
        later <= (others => '0');
        begun <= '0';
      else
        begun    <= '1';
        later(1) <= at(0) or (at(2) and not is_count);
        later(2) <= at(1);
        if is_count = '1' then
          later(7 downto 3) <= at(6 downto 2);
        else
          later(7 downto 3) <= (others => '0');
        end if;
        later(8) <= at(7) or at(8);
      end if;
    end if;
  end process;

  -- What prefixes give.
  process (clk)
  begin
    if rising_edge(clk) then
      if start_scan = '1' or is_done = '1' then
        enable <= '1';
        serial <= '0';
      elsif prefix = '1' then
        if field = ENABLES then
          enable <= power;
        end if;
        if field = SERIALS then
          serial <= power;
        end if;
      end if;
      if prefix = '1' and field = UNIT then
        timer_type  <= low(9 downto 8);
        unit_number <= low(5 downto 0);
      end if;
      if prefix = '1' and field = NUMBERS then
        number <= unsigned(low(5 downto 0));
      elsif at(7) = '1' or at(8) = '1' or (is_shift = '1' and at(1) = '1') then
        number <= number - 1;
      end if;
      if prefix = '1' and field(2) = '1' then
        next_register <= unsigned(field(0) & low);
      elsif at(1) = '1' or at(8 downto 5) /= "0000" then
        if is_right = '1' then
          next_register <= next_register - 1;
        else
          next_register <= next_register + 1;
        end if;
      end if;
    end if;
  end process;

  -- What each unit keeps: timers and counters from 0, drums from 64, shifts from 96.
  unit_address <= (is_drum or is_shift) & (is_shift or unit_number(5)) & unit_number(4 downto 0);
  keeps        <= clear_units or (is_done and (is_count or is_shift));
  kept_address <= clear_address when clear_units = '1' else unit_address;
  kept_now     <= "000" when clear_units = '1' else runs_on & (power and enable) & power;
  kept : entity work.lp_memory
    generic map (WIDTH => 3, ADDRESS_BITS => 7)
    port map (
      clk => clk,
      write => keeps, write_address => kept_address, write_data => kept_now,
      read => at(1), read_address => unit_address, read_data => kept_before
    );
  runs        <= kept_before(2);
  was_enabled <= kept_before(1);
  was         <= kept_before(0);
  rises       <= power and not was;

  timing : if TIMERS /= 0 generate
    pulses : entity work.lp_pulses
      generic map (TICKS_PER_TENTH => TICKS_PER_TENTH, TICKS_PER_SECOND => TICKS_PER_SECOND)
      port map (
        clk => clk, rst => rst, start_scan => start_scan, tick => tick,
        tenth => tenth, second => second
      );
  end generate;
  no_timing : if TIMERS = 0 generate
    tenth  <= '0';
    second <= '0';
  end generate;

  -- Counts. Clock 0 reads the preset, 1 the count; 2 limits the preset; 3 decides; 4 counts;
  -- 5 compares; 6 writes the coil; 7 writes the count. Taps follow, each compared the clock before.
  pulse <= tenth when field(0) = '1' else second;
  timer : entity work.lp_timer
    port map (
      timer_type => timer_type, enable => enable, power => power, pulse => pulse,
      was => was, was_enabled => was_enabled, runs => runs,
      reached => reached, clears => timer_clears, counts => timer_counts,
      coil => timer_coil, runs_on => timer_runs_on, ends => timer_ends
    );
  counter : entity work.lp_counter
    port map (
      down => down, enable => enable, rises => rises, at_end => at_end,
      clears => counter_clears, loads => counter_loads, counts => counter_counts
    );

  -- What was decided the clock before.
  process (clk)
  begin
    if rising_edge(clk) then
      if is_timer = '1' then
        clears  <= timer_clears;
        counts  <= timer_counts;
        reaches <= timer_coil;
      else
        clears <= counter_clears;
        counts <= counter_counts;
        if down = '1' then
          reaches <= at_end;
        else
          reaches <= reached;
        end if;
      end if;
      loads   <= counter_loads;
      runs_on <= is_timer and timer_runs_on;
      ends    <= is_timer and timer_ends;
    end if;
  end process;

  moves        <= not enable or rises;  -- the registers of a shift change
  load_largest <= is_count and at(1);
  load_word    <= is_count and at(2);
  load_left    <= is_left and at(1);
  load_right   <= is_right and at(1);
  load_bit     <= is_bit and at(1);
  load_preset  <= at(4) and loads;
  load_next    <= at(4) and counts and not loads;
  clear        <= (at(4) and clears) or (at(6) and ends) or (is_shift and at(1) and not enable);
  set_bit      <= not field(0);
  later_taps   <= at(8) or at(7) or at(6);
  read_preset  <= at(1) or (is_drum and later_taps);
  limit_preset <= is_count and at(2);
  operand : entity work.lp_operand
    port map (
      clk => clk, read_word => read_word,
      load_largest => load_largest, load_word => load_word,
      load_left => load_left, load_right => load_right, load_bit => load_bit,
      load_preset => load_preset, load_next => load_next, clear => clear,
      drum => is_drum, down => down, power => power, set_bit => set_bit,
      bit_number => std_logic_vector(number(3 downto 0)), serial => serial, load_serial => at(0),
      read_preset => read_preset, limit_preset => limit_preset,
      word => written_word, reached => reached, at_end => at_end, carry => carry, has_bit => has_bit
    );

  -- The register array: a shift writes what it read two clocks before.
  count_register <= "0100" & is_drum & unit_number;
  process (clk)
  begin
    if rising_edge(clk) then
      if at(1) = '0' then
        shifted_register <= std_logic_vector(next_register);
      end if;
    end if;
  end process;
  read_register    <= count_register when is_count = '1' and at(1) = '1' else
                      std_logic_vector(next_register);
  write_register   <= at(7) when is_count = '1' else
                      at(2) and (is_bit or (is_shift and moves));
  written_register <= count_register when is_count = '1' else shifted_register;

  -- The coils: that of the operation, then those of the taps.
  process (clk)
  begin
    if rising_edge(clk) then
      if run = '0' or is_done = '1' then
        tap <= (others => '0');
      elsif at(7) = '1' or at(8) = '1' then
        tap <= tap + 1;
      end if;
    end if;
  end process;
  write_coil   <= (at(6) or at(8)) when is_count = '1' else
                  is_done and (is_bit or (is_shift and moves));
  coil_address <= std_logic_vector(unsigned(low) + tap);
  coil         <= has_bit when is_bit = '1' else
                  enable and carry when is_shift = '1' else
                  reaches;
end architecture;
