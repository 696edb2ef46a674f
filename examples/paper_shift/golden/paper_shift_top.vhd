-- Made by hotrail 0.1.0 from paper_shift.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects paper_shift to the pins of a board.
entity paper_shift_top is
  port (
    clk            : in  std_logic;
    rst            : in  std_logic;
    shift_ckt      : in  std_logic;
    shift_en_ckt   : in  std_logic;
    serialdata_ckt : in  std_logic;
    left_coil      : out std_logic;
    right_coil     : out std_logic
  );
end entity paper_shift_top;

architecture rtl of paper_shift_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal shift_ckt_meta : std_logic := '0';
  signal shift_ckt_sync : std_logic := '0';
  attribute async_reg of shift_ckt_meta : signal is "TRUE";
  attribute async_reg of shift_ckt_sync : signal is "TRUE";
  signal shift_en_ckt_meta : std_logic := '0';
  signal shift_en_ckt_sync : std_logic := '0';
  attribute async_reg of shift_en_ckt_meta : signal is "TRUE";
  attribute async_reg of shift_en_ckt_sync : signal is "TRUE";
  signal serialdata_ckt_meta : std_logic := '0';
  signal serialdata_ckt_sync : std_logic := '0';
  attribute async_reg of serialdata_ckt_meta : signal is "TRUE";
  attribute async_reg of serialdata_ckt_sync : signal is "TRUE";
begin

  -- Reset: comes at once, goes in step with the clock.
  process (clk, rst)
  begin
    if rst = '1' then
      reset_pipe <= "11";
    elsif rising_edge(clk) then
      reset_pipe <= reset_pipe(0) & '0';
    end if;
  end process;
  core_rst <= reset_pipe(1);

  -- Tick: every 12000 clocks of 12 MHz, wanted every 1 ms, error 0 ppm.
  tick <= '1' when prescaler = 11999 else '0';
  process (clk)
  begin
    if rising_edge(clk) then
      if tick = '1' then
        prescaler <= (others => '0');
      else
        prescaler <= prescaler + 1;
      end if;
      if core_rst = '1' then
        prescaler <= (others => '0');
      end if;
    end if;
  end process;

  -- Inputs: two flip-flops for each bit.
  process (clk)
  begin
    if rising_edge(clk) then
      shift_ckt_meta <= shift_ckt;
      shift_ckt_sync <= shift_ckt_meta;
      shift_en_ckt_meta <= shift_en_ckt;
      shift_en_ckt_sync <= shift_en_ckt_meta;
      serialdata_ckt_meta <= serialdata_ckt;
      serialdata_ckt_sync <= serialdata_ckt_meta;
    end if;
  end process;

  core: entity work.paper_shift
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      shift_ckt => shift_ckt_sync,
      shift_en_ckt => shift_en_ckt_sync,
      serialdata_ckt => serialdata_ckt_sync,
      left_coil => left_coil,
      right_coil => right_coil
    );
end architecture rtl;
