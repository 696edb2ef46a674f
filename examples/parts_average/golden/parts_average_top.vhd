-- Made by hotrail 0.1.0 from parts_average.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects parts_average to the pins of a board.
entity parts_average_top is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    sensor      : in  std_logic;
    last_minute : out std_logic_vector(15 downto 0);
    average_10  : out std_logic_vector(15 downto 0);
    average_60  : out std_logic_vector(15 downto 0)
  );
end entity parts_average_top;

architecture rtl of parts_average_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(19 downto 0) := (others => '0');
  signal tick : std_logic;
  signal sensor_meta : std_logic := '0';
  signal sensor_sync : std_logic := '0';
  attribute async_reg of sensor_meta : signal is "TRUE";
  attribute async_reg of sensor_sync : signal is "TRUE";
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

  -- Tick: every 1000000 clocks of 1 MHz, wanted every 1 s, error 0 ppm.
  tick <= '1' when prescaler = 999999 else '0';
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
      sensor_meta <= sensor;
      sensor_sync <= sensor_meta;
    end if;
  end process;

  core: entity work.parts_average
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      sensor => sensor_sync,
      last_minute => last_minute,
      average_10 => average_10,
      average_60 => average_60
    );
end architecture rtl;
