-- Made by hotrail 0.1.0 from ab_seal.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects ab_seal to the pins of a board.
entity ab_seal_top is
  port (
    clk               : in  std_logic;
    rst               : in  std_logic;
    start_pb          : in  std_logic;
    stop_pb           : in  std_logic;
    motor             : out std_logic;
    next_step         : out std_logic;
    siemens_motor     : out std_logic;
    siemens_next_step : out std_logic
  );
end entity ab_seal_top;

architecture rtl of ab_seal_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal start_pb_meta : std_logic := '0';
  signal start_pb_sync : std_logic := '0';
  attribute async_reg of start_pb_meta : signal is "TRUE";
  attribute async_reg of start_pb_sync : signal is "TRUE";
  signal stop_pb_meta : std_logic := '0';
  signal stop_pb_sync : std_logic := '0';
  attribute async_reg of stop_pb_meta : signal is "TRUE";
  attribute async_reg of stop_pb_sync : signal is "TRUE";
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
      start_pb_meta <= start_pb;
      start_pb_sync <= start_pb_meta;
      stop_pb_meta <= stop_pb;
      stop_pb_sync <= stop_pb_meta;
    end if;
  end process;

  core: entity work.ab_seal
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      start_pb => start_pb_sync,
      stop_pb => stop_pb_sync,
      motor => motor,
      next_step => next_step,
      siemens_motor => siemens_motor,
      siemens_next_step => siemens_next_step
    );
end architecture rtl;
