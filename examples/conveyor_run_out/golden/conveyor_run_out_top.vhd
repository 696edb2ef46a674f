-- Made by hotrail 0.1.0 from conveyor_run_out.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects conveyor_run_out to the pins of a board.
entity conveyor_run_out_top is
  port (
    clk           : in  std_logic;
    rst           : in  std_logic;
    start         : in  std_logic;
    finish        : in  std_logic;
    emergency     : in  std_logic;
    product       : in  std_logic;
    wait_for_next : in  std_logic;
    conveyor      : out std_logic;
    empty         : out std_logic
  );
end entity conveyor_run_out_top;

architecture rtl of conveyor_run_out_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(20 downto 0) := (others => '0');
  signal tick : std_logic;
  signal start_meta : std_logic := '0';
  signal start_sync : std_logic := '0';
  attribute async_reg of start_meta : signal is "TRUE";
  attribute async_reg of start_sync : signal is "TRUE";
  signal finish_meta : std_logic := '0';
  signal finish_sync : std_logic := '0';
  attribute async_reg of finish_meta : signal is "TRUE";
  attribute async_reg of finish_sync : signal is "TRUE";
  signal emergency_meta : std_logic := '0';
  signal emergency_sync : std_logic := '0';
  attribute async_reg of emergency_meta : signal is "TRUE";
  attribute async_reg of emergency_sync : signal is "TRUE";
  signal product_meta : std_logic := '0';
  signal product_sync : std_logic := '0';
  attribute async_reg of product_meta : signal is "TRUE";
  attribute async_reg of product_sync : signal is "TRUE";
  signal wait_for_next_meta : std_logic := '0';
  signal wait_for_next_sync : std_logic := '0';
  attribute async_reg of wait_for_next_meta : signal is "TRUE";
  attribute async_reg of wait_for_next_sync : signal is "TRUE";
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

  -- Tick: every 1200000 clocks of 12 MHz, wanted every 100 ms, error 0 ppm.
  tick <= '1' when prescaler = 1199999 else '0';
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
      start_meta <= start;
      start_sync <= start_meta;
      finish_meta <= finish;
      finish_sync <= finish_meta;
      emergency_meta <= emergency;
      emergency_sync <= emergency_meta;
      product_meta <= product;
      product_sync <= product_meta;
      wait_for_next_meta <= wait_for_next;
      wait_for_next_sync <= wait_for_next_meta;
    end if;
  end process;

  core: entity work.conveyor_run_out
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      start => start_sync,
      finish => finish_sync,
      emergency => emergency_sync,
      product => product_sync,
      wait_for_next => wait_for_next_sync,
      conveyor => conveyor,
      empty => empty
    );
end architecture rtl;
