-- Made by hotrail 0.1.0 from paper_bits.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects paper_bits to the pins of a board.
entity paper_bits_top is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    bc_ckt   : in  std_logic;
    bs_ckt   : in  std_logic;
    bc_coil  : out std_logic;
    bs_coil  : out std_logic;
    bitset_r : out std_logic_vector(15 downto 0)
  );
end entity paper_bits_top;

architecture rtl of paper_bits_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal bc_ckt_meta : std_logic := '0';
  signal bc_ckt_sync : std_logic := '0';
  attribute async_reg of bc_ckt_meta : signal is "TRUE";
  attribute async_reg of bc_ckt_sync : signal is "TRUE";
  signal bs_ckt_meta : std_logic := '0';
  signal bs_ckt_sync : std_logic := '0';
  attribute async_reg of bs_ckt_meta : signal is "TRUE";
  attribute async_reg of bs_ckt_sync : signal is "TRUE";
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
      bc_ckt_meta <= bc_ckt;
      bc_ckt_sync <= bc_ckt_meta;
      bs_ckt_meta <= bs_ckt;
      bs_ckt_sync <= bs_ckt_meta;
    end if;
  end process;

  core: entity work.paper_bits
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      bc_ckt => bc_ckt_sync,
      bs_ckt => bs_ckt_sync,
      bc_coil => bc_coil,
      bs_coil => bs_coil,
      bitset_r => bitset_r
    );
end architecture rtl;
