-- Made by hotrail 0.1.0 from modicon_timer.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects modicon_timer to the pins of a board.
entity modicon_timer_top is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    in_10001        : in  std_logic;
    in_10002        : in  std_logic;
    coil_00107      : out std_logic;
    coil_00108      : out std_logic;
    cascade_tenths  : out std_logic;
    cascade_seconds : out std_logic
  );
end entity modicon_timer_top;

architecture rtl of modicon_timer_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(16 downto 0) := (others => '0');
  signal tick : std_logic;
  signal in_10001_meta : std_logic := '0';
  signal in_10001_sync : std_logic := '0';
  attribute async_reg of in_10001_meta : signal is "TRUE";
  attribute async_reg of in_10001_sync : signal is "TRUE";
  signal in_10002_meta : std_logic := '0';
  signal in_10002_sync : std_logic := '0';
  attribute async_reg of in_10002_meta : signal is "TRUE";
  attribute async_reg of in_10002_sync : signal is "TRUE";
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
      in_10001_meta <= in_10001;
      in_10001_sync <= in_10001_meta;
      in_10002_meta <= in_10002;
      in_10002_sync <= in_10002_meta;
    end if;
  end process;

  core: entity work.modicon_timer
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      in_10001 => in_10001_sync,
      in_10002 => in_10002_sync,
      coil_00107 => coil_00107,
      coil_00108 => coil_00108,
      cascade_tenths => cascade_tenths,
      cascade_seconds => cascade_seconds
    );
end architecture rtl;
