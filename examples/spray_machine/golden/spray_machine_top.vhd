-- Made by hotrail 0.1.0 from spray_machine.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects spray_machine to the pins of a board.
entity spray_machine_top is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    start   : in  std_logic;
    stop    : in  std_logic;
    home    : in  std_logic;
    at_end  : in  std_logic;
    middle  : in  std_logic;
    forward : out std_logic;
    reverse : out std_logic;
    spray   : out std_logic
  );
end entity spray_machine_top;

architecture rtl of spray_machine_top is
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
  signal home_meta : std_logic := '0';
  signal home_sync : std_logic := '0';
  attribute async_reg of home_meta : signal is "TRUE";
  attribute async_reg of home_sync : signal is "TRUE";
  signal at_end_meta : std_logic := '0';
  signal at_end_sync : std_logic := '0';
  attribute async_reg of at_end_meta : signal is "TRUE";
  attribute async_reg of at_end_sync : signal is "TRUE";
  signal middle_meta : std_logic := '0';
  signal middle_sync : std_logic := '0';
  attribute async_reg of middle_meta : signal is "TRUE";
  attribute async_reg of middle_sync : signal is "TRUE";
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
      home_meta <= home;
      home_sync <= home_meta;
      at_end_meta <= at_end;
      at_end_sync <= at_end_meta;
      middle_meta <= middle;
      middle_sync <= middle_meta;
    end if;
  end process;

  core: entity work.spray_machine
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      start => start_sync,
      stop => stop_sync,
      home => home_sync,
      at_end => at_end_sync,
      middle => middle_sync,
      forward => forward,
      reverse => reverse,
      spray => spray
    );
end architecture rtl;
