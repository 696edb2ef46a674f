-- Made by hotrail 0.1.0 from order_same_scan.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects order_same_scan to the pins of a board.
entity order_same_scan_top is
  port (
    clk : in  std_logic;
    rst : in  std_logic;
    X0  : in  std_logic;
    Y0  : out std_logic;
    Y1  : out std_logic
  );
end entity order_same_scan_top;

architecture rtl of order_same_scan_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal X0_meta : std_logic := '0';
  signal X0_sync : std_logic := '0';
  attribute async_reg of X0_meta : signal is "TRUE";
  attribute async_reg of X0_sync : signal is "TRUE";
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
      X0_meta <= X0;
      X0_sync <= X0_meta;
    end if;
  end process;

  core: entity work.order_same_scan
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      X0 => X0_sync,
      Y0 => Y0,
      Y1 => Y1
    );
end architecture rtl;
