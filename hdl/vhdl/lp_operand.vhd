-- The word that a function works on, the preset that a count is compared with, and the bit that
-- shifts carry from word to word.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.lp.all;

entity lp_operand is
  port (
    clk          : in  std_logic;
    read_word    : in  std_logic_vector(15 downto 0);       -- of the register array
    -- What becomes of the word; without any of these it stays.
    load_largest : in  std_logic;
    load_word    : in  std_logic;       -- as it was read
    load_left    : in  std_logic;       -- shifted, the carry comes in
    load_right   : in  std_logic;
    load_bit     : in  std_logic;       -- with one bit set or cleared where there is power
    load_preset  : in  std_logic;
    load_next    : in  std_logic;       -- one more, or less
    clear        : in  std_logic;       -- 0, above all others
    -- How.
    drum         : in  std_logic;
    down         : in  std_logic;
    power        : in  std_logic;
    set_bit      : in  std_logic;
    bit_number   : in  std_logic_vector(3 downto 0);
    serial       : in  std_logic;
    load_serial  : in  std_logic;       -- the carry becomes the serial data
    -- What becomes of the preset.
    read_preset  : in  std_logic;
    limit_preset : in  std_logic;       -- the word is the largest preset: no more than that
    -- What is known of them.
    word         : out std_logic_vector(15 downto 0);
    reached      : out std_logic;       -- the word is the preset or more
    at_end       : out std_logic;       -- the word is the last count
    carry        : out std_logic;
    has_bit      : out std_logic        -- the bit is now as it is to be
  );
end entity;

architecture rtl of lp_operand is
  signal largest, preset, operand         : unsigned(15 downto 0);
  signal place, changed                   : std_logic_vector(15 downto 0);
  signal is_reached, bit_was, bit_carried : std_logic;
begin
  word       <= std_logic_vector(operand);
  carry      <= bit_carried;
  largest    <= to_unsigned(2047, 16) when drum = '1' else to_unsigned(9999, 16);
  is_reached <= bit_of(operand >= preset);
  reached    <= is_reached;
  at_end     <= bit_of(operand = 0) when down = '1' else bit_of(operand = largest);

  place   <= std_logic_vector(shift_left(to_unsigned(1, 16), to_integer(unsigned(bit_number))));
  bit_was <= bit_of((read_word and place) /= x"0000");
  changed <= read_word when power = '0' else
             read_word or place when set_bit = '1' else
             read_word and not place;

  process (clk)
  begin
    if rising_edge(clk) then
      -- A preset with its sign bit set acts as 0.
      if limit_preset = '1' and preset(15) = '1' then
        preset <= (others => '0');
      elsif limit_preset = '1' and is_reached = '0' then
        preset <= operand;
      elsif read_preset = '1' then
        preset <= unsigned(read_word);
      end if;

      if clear = '1' then
        operand <= (others => '0');
      elsif load_next = '1' and down = '1' then
        operand <= operand - 1;
      elsif load_next = '1' then
        operand <= operand + 1;
      elsif load_preset = '1' then
        operand <= preset;
      elsif load_largest = '1' then
        operand <= largest;
      elsif load_left = '1' then
        operand <= unsigned(read_word(14 downto 0) & bit_carried);
      elsif load_right = '1' then
        operand <= unsigned(bit_carried & read_word(15 downto 1));
      elsif load_bit = '1' then
        operand <= unsigned(changed);
      elsif load_word = '1' then
        operand <= unsigned(read_word);
      end if;

      if load_serial = '1' then
        bit_carried <= serial;
      elsif load_left = '1' then
        bit_carried <= read_word(15);
      elsif load_right = '1' then
        bit_carried <= read_word(0);
      end if;
      if load_bit = '1' then
        has_bit <= power or (bit_was xnor set_bit);
      end if;
    end if;
  end process;
end architecture;
