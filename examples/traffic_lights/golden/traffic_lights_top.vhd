-- Made by hotrail 0.1.0 from traffic_lights.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects traffic_lights to the pins of a board.
entity traffic_lights_top is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    ns_green    : out std_logic;
    ns_yellow   : out std_logic;
    ns_red      : out std_logic;
    turn_green  : out std_logic;
    turn_yellow : out std_logic;
    turn_red    : out std_logic;
    ew_green    : out std_logic;
    ew_yellow   : out std_logic;
    ew_red      : out std_logic
  );
end entity traffic_lights_top;

architecture rtl of traffic_lights_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(18 downto 0) := (others => '0');
  signal tick : std_logic;
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

  -- Tick: every 400000 clocks of 4 MHz, wanted every 100 ms, error 0 ppm.
  tick <= '1' when prescaler = 399999 else '0';
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

  core: entity work.traffic_lights
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      ns_green => ns_green,
      ns_yellow => ns_yellow,
      ns_red => ns_red,
      turn_green => turn_green,
      turn_yellow => turn_yellow,
      turn_red => turn_red,
      ew_green => ew_green,
      ew_yellow => ew_yellow,
      ew_red => ew_red
    );
end architecture rtl;
