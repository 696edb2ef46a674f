-- Made by hotrail 0.1.0 from part_counter.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects part_counter to the pins of a board.
entity part_counter_top is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    part_at_machine : in  std_logic;
    clear           : in  std_logic;
    parts           : out std_logic_vector(15 downto 0);
    batch_full      : out std_logic
  );
end entity part_counter_top;

architecture rtl of part_counter_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(20 downto 0) := (others => '0');
  signal tick : std_logic;
  signal part_at_machine_meta : std_logic := '0';
  signal part_at_machine_sync : std_logic := '0';
  attribute async_reg of part_at_machine_meta : signal is "TRUE";
  attribute async_reg of part_at_machine_sync : signal is "TRUE";
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
      part_at_machine_meta <= part_at_machine;
      part_at_machine_sync <= part_at_machine_meta;
      clear_meta <= clear;
      clear_sync <= clear_meta;
    end if;
  end process;

  core: entity work.part_counter
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      part_at_machine => part_at_machine_sync,
      clear => clear_sync,
      parts => parts,
      batch_full => batch_full
    );
end architecture rtl;
