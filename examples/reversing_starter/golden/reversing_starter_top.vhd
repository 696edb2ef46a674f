-- Made by hotrail 0.1.0 from reversing_starter.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects reversing_starter to the pins of a board.
entity reversing_starter_top is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    stop        : in  std_logic;
    overload    : in  std_logic;
    forward     : in  std_logic;
    reverse     : in  std_logic;
    run_forward : out std_logic;
    run_reverse : out std_logic;
    fault       : out std_logic
  );
end entity reversing_starter_top;

architecture rtl of reversing_starter_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal stop_meta : std_logic := '0';
  signal stop_sync : std_logic := '0';
  attribute async_reg of stop_meta : signal is "TRUE";
  attribute async_reg of stop_sync : signal is "TRUE";
  signal overload_meta : std_logic := '0';
  signal overload_sync : std_logic := '0';
  attribute async_reg of overload_meta : signal is "TRUE";
  attribute async_reg of overload_sync : signal is "TRUE";
  signal forward_meta : std_logic := '0';
  signal forward_sync : std_logic := '0';
  attribute async_reg of forward_meta : signal is "TRUE";
  attribute async_reg of forward_sync : signal is "TRUE";
  signal reverse_meta : std_logic := '0';
  signal reverse_sync : std_logic := '0';
  attribute async_reg of reverse_meta : signal is "TRUE";
  attribute async_reg of reverse_sync : signal is "TRUE";
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
      stop_meta <= stop;
      stop_sync <= stop_meta;
      overload_meta <= overload;
      overload_sync <= overload_meta;
      forward_meta <= forward;
      forward_sync <= forward_meta;
      reverse_meta <= reverse;
      reverse_sync <= reverse_meta;
    end if;
  end process;

  core: entity work.reversing_starter
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      stop => stop_sync,
      overload => overload_sync,
      forward => forward_sync,
      reverse => reverse_sync,
      run_forward => run_forward,
      run_reverse => run_reverse,
      fault => fault
    );
end architecture rtl;
