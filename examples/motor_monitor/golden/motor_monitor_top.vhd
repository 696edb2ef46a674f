-- Made by hotrail 0.1.0 from motor_monitor.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects motor_monitor to the pins of a board.
entity motor_monitor_top is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    S1          : in  std_logic;
    turns_1     : in  std_logic;
    turns_2     : in  std_logic;
    turns_3     : in  std_logic;
    acknowledge : in  std_logic;
    fault       : out std_logic
  );
end entity motor_monitor_top;

architecture rtl of motor_monitor_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(20 downto 0) := (others => '0');
  signal tick : std_logic;
  signal S1_meta : std_logic := '0';
  signal S1_sync : std_logic := '0';
  attribute async_reg of S1_meta : signal is "TRUE";
  attribute async_reg of S1_sync : signal is "TRUE";
  signal turns_1_meta : std_logic := '0';
  signal turns_1_sync : std_logic := '0';
  attribute async_reg of turns_1_meta : signal is "TRUE";
  attribute async_reg of turns_1_sync : signal is "TRUE";
  signal turns_2_meta : std_logic := '0';
  signal turns_2_sync : std_logic := '0';
  attribute async_reg of turns_2_meta : signal is "TRUE";
  attribute async_reg of turns_2_sync : signal is "TRUE";
  signal turns_3_meta : std_logic := '0';
  signal turns_3_sync : std_logic := '0';
  attribute async_reg of turns_3_meta : signal is "TRUE";
  attribute async_reg of turns_3_sync : signal is "TRUE";
  signal acknowledge_meta : std_logic := '0';
  signal acknowledge_sync : std_logic := '0';
  attribute async_reg of acknowledge_meta : signal is "TRUE";
  attribute async_reg of acknowledge_sync : signal is "TRUE";
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
      S1_meta <= S1;
      S1_sync <= S1_meta;
      turns_1_meta <= turns_1;
      turns_1_sync <= turns_1_meta;
      turns_2_meta <= turns_2;
      turns_2_sync <= turns_2_meta;
      turns_3_meta <= turns_3;
      turns_3_sync <= turns_3_meta;
      acknowledge_meta <= acknowledge;
      acknowledge_sync <= acknowledge_meta;
    end if;
  end process;

  core: entity work.motor_monitor
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      S1 => S1_sync,
      turns_1 => turns_1_sync,
      turns_2 => turns_2_sync,
      turns_3 => turns_3_sync,
      acknowledge => acknowledge_sync,
      fault => fault
    );
end architecture rtl;
