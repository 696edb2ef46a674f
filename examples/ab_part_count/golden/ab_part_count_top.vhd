-- Made by hotrail 0.1.0 from ab_part_count.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects ab_part_count to the pins of a board.
entity ab_part_count_top is
  port (
    clk                 : in  std_logic;
    rst                 : in  std_logic;
    pump_run            : in  std_logic;
    part_present        : in  std_logic;
    clear               : in  std_logic;
    pump_on_for_a_while : out std_logic;
    batch_done          : out std_logic;
    siemens_pump        : out std_logic;
    siemens_batch       : out std_logic
  );
end entity ab_part_count_top;

architecture rtl of ab_part_count_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal pump_run_meta : std_logic := '0';
  signal pump_run_sync : std_logic := '0';
  attribute async_reg of pump_run_meta : signal is "TRUE";
  attribute async_reg of pump_run_sync : signal is "TRUE";
  signal part_present_meta : std_logic := '0';
  signal part_present_sync : std_logic := '0';
  attribute async_reg of part_present_meta : signal is "TRUE";
  attribute async_reg of part_present_sync : signal is "TRUE";
  signal clear_meta : std_logic := '0';
  signal clear_sync : std_logic := '0';
  attribute async_reg of clear_meta : signal is "TRUE";
  attribute async_reg of clear_sync : signal is "TRUE";
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
      pump_run_meta <= pump_run;
      pump_run_sync <= pump_run_meta;
      part_present_meta <= part_present;
      part_present_sync <= part_present_meta;
      clear_meta <= clear;
      clear_sync <= clear_meta;
    end if;
  end process;

  core: entity work.ab_part_count
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      pump_run => pump_run_sync,
      part_present => part_present_sync,
      clear => clear_sync,
      pump_on_for_a_while => pump_on_for_a_while,
      batch_done => batch_done,
      siemens_pump => siemens_pump,
      siemens_batch => siemens_batch
    );
end architecture rtl;
