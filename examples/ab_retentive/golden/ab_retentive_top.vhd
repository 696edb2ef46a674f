-- Made by hotrail 0.1.0 from ab_retentive.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects ab_retentive to the pins of a board.
entity ab_retentive_top is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    pump            : in  std_logic;
    reset_button    : in  std_logic;
    longer          : in  std_logic;
    service         : out std_logic;
    siemens_service : out std_logic
  );
end entity ab_retentive_top;

architecture rtl of ab_retentive_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(16 downto 0) := (others => '0');
  signal tick : std_logic;
  signal pump_meta : std_logic := '0';
  signal pump_sync : std_logic := '0';
  attribute async_reg of pump_meta : signal is "TRUE";
  attribute async_reg of pump_sync : signal is "TRUE";
  signal reset_button_meta : std_logic := '0';
  signal reset_button_sync : std_logic := '0';
  attribute async_reg of reset_button_meta : signal is "TRUE";
  attribute async_reg of reset_button_sync : signal is "TRUE";
  signal longer_meta : std_logic := '0';
  signal longer_sync : std_logic := '0';
  attribute async_reg of longer_meta : signal is "TRUE";
  attribute async_reg of longer_sync : signal is "TRUE";
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
      pump_meta <= pump;
      pump_sync <= pump_meta;
      reset_button_meta <= reset_button;
      reset_button_sync <= reset_button_meta;
      longer_meta <= longer;
      longer_sync <= longer_meta;
    end if;
  end process;

  core: entity work.ab_retentive
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      pump => pump_sync,
      reset_button => reset_button_sync,
      longer => longer_sync,
      service => service,
      siemens_service => siemens_service
    );
end architecture rtl;
