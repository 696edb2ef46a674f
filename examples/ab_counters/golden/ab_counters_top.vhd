-- Made by hotrail 0.1.0 from ab_counters.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects ab_counters to the pins of a board.
entity ab_counters_top is
  port (
    clk               : in  std_logic;
    rst               : in  std_logic;
    count_up          : in  std_logic;
    count_down        : in  std_logic;
    reset_up          : in  std_logic;
    reset_down        : in  std_logic;
    to_the_end        : in  std_logic;
    up_done           : out std_logic;
    down_done         : out std_logic;
    siemens_up_done   : out std_logic;
    siemens_down_done : out std_logic;
    overflow          : out std_logic
  );
end entity ab_counters_top;

architecture rtl of ab_counters_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal count_up_meta : std_logic := '0';
  signal count_up_sync : std_logic := '0';
  attribute async_reg of count_up_meta : signal is "TRUE";
  attribute async_reg of count_up_sync : signal is "TRUE";
  signal count_down_meta : std_logic := '0';
  signal count_down_sync : std_logic := '0';
  attribute async_reg of count_down_meta : signal is "TRUE";
  attribute async_reg of count_down_sync : signal is "TRUE";
  signal reset_up_meta : std_logic := '0';
  signal reset_up_sync : std_logic := '0';
  attribute async_reg of reset_up_meta : signal is "TRUE";
  attribute async_reg of reset_up_sync : signal is "TRUE";
  signal reset_down_meta : std_logic := '0';
  signal reset_down_sync : std_logic := '0';
  attribute async_reg of reset_down_meta : signal is "TRUE";
  attribute async_reg of reset_down_sync : signal is "TRUE";
  signal to_the_end_meta : std_logic := '0';
  signal to_the_end_sync : std_logic := '0';
  attribute async_reg of to_the_end_meta : signal is "TRUE";
  attribute async_reg of to_the_end_sync : signal is "TRUE";
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
      count_up_meta <= count_up;
      count_up_sync <= count_up_meta;
      count_down_meta <= count_down;
      count_down_sync <= count_down_meta;
      reset_up_meta <= reset_up;
      reset_up_sync <= reset_up_meta;
      reset_down_meta <= reset_down;
      reset_down_sync <= reset_down_meta;
      to_the_end_meta <= to_the_end;
      to_the_end_sync <= to_the_end_meta;
    end if;
  end process;

  core: entity work.ab_counters
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      count_up => count_up_sync,
      count_down => count_down_sync,
      reset_up => reset_up_sync,
      reset_down => reset_down_sync,
      to_the_end => to_the_end_sync,
      up_done => up_done,
      down_done => down_done,
      siemens_up_done => siemens_up_done,
      siemens_down_done => siemens_down_done,
      overflow => overflow
    );
end architecture rtl;
