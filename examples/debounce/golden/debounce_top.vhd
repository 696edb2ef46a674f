-- Made by hotrail 0.1.0 from debounce.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects debounce to the pins of a board.
entity debounce_top is
  port (
    clk            : in  std_logic;
    rst            : in  std_logic;
    limit_switch_1 : in  std_logic;
    settled        : out std_logic;
    at_once        : out std_logic
  );
end entity debounce_top;

architecture rtl of debounce_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(16 downto 0) := (others => '0');
  signal tick : std_logic;
  signal limit_switch_1_meta : std_logic := '0';
  signal limit_switch_1_sync : std_logic := '0';
  attribute async_reg of limit_switch_1_meta : signal is "TRUE";
  attribute async_reg of limit_switch_1_sync : signal is "TRUE";
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

  -- Tick: every 120000 clocks of 12 MHz, wanted every 10 ms, error 0 ppm.
  tick <= '1' when prescaler = 119999 else '0';
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
      limit_switch_1_meta <= limit_switch_1;
      limit_switch_1_sync <= limit_switch_1_meta;
    end if;
  end process;

  core: entity work.debounce
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      limit_switch_1 => limit_switch_1_sync,
      settled => settled,
      at_once => at_once
    );
end architecture rtl;
