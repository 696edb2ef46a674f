-- Made by hotrail 0.1.0 from drum_sequence.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects drum_sequence to the pins of a board.
entity drum_sequence_top is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    start   : in  std_logic;
    stop    : in  std_logic;
    water   : out std_logic;
    heater  : out std_logic;
    motor   : out std_logic;
    pump    : out std_logic;
    running : out std_logic
  );
end entity drum_sequence_top;

architecture rtl of drum_sequence_top is
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
  signal stop_meta : std_logic := '0';
  signal stop_sync : std_logic := '0';
  attribute async_reg of stop_meta : signal is "TRUE";
  attribute async_reg of stop_sync : signal is "TRUE";
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
      stop_meta <= stop;
      stop_sync <= stop_meta;
    end if;
  end process;

  core: entity work.drum_sequence
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      start => start_sync,
      stop => stop_sync,
      water => water,
      heater => heater,
      motor => motor,
      pump => pump,
      running => running
    );
end architecture rtl;
