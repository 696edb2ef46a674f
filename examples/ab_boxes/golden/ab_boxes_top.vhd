-- Made by hotrail 0.1.0 from ab_boxes.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects ab_boxes to the pins of a board.
entity ab_boxes_top is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    pull_cord  : in  std_logic;
    eye_1      : in  std_logic;
    eye_2      : in  std_logic;
    emptied    : in  std_logic;
    conveyor_1 : out std_logic;
    conveyor_2 : out std_logic;
    conveyor_3 : out std_logic
  );
end entity ab_boxes_top;

architecture rtl of ab_boxes_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(16 downto 0) := (others => '0');
  signal tick : std_logic;
  signal pull_cord_meta : std_logic := '0';
  signal pull_cord_sync : std_logic := '0';
  attribute async_reg of pull_cord_meta : signal is "TRUE";
  attribute async_reg of pull_cord_sync : signal is "TRUE";
  signal eye_1_meta : std_logic := '0';
  signal eye_1_sync : std_logic := '0';
  attribute async_reg of eye_1_meta : signal is "TRUE";
  attribute async_reg of eye_1_sync : signal is "TRUE";
  signal eye_2_meta : std_logic := '0';
  signal eye_2_sync : std_logic := '0';
  attribute async_reg of eye_2_meta : signal is "TRUE";
  attribute async_reg of eye_2_sync : signal is "TRUE";
  signal emptied_meta : std_logic := '0';
  signal emptied_sync : std_logic := '0';
  attribute async_reg of emptied_meta : signal is "TRUE";
  attribute async_reg of emptied_sync : signal is "TRUE";
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
      pull_cord_meta <= pull_cord;
      pull_cord_sync <= pull_cord_meta;
      eye_1_meta <= eye_1;
      eye_1_sync <= eye_1_meta;
      eye_2_meta <= eye_2;
      eye_2_sync <= eye_2_meta;
      emptied_meta <= emptied;
      emptied_sync <= emptied_meta;
    end if;
  end process;

  core: entity work.ab_boxes
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      pull_cord => pull_cord_sync,
      eye_1 => eye_1_sync,
      eye_2 => eye_2_sync,
      emptied => emptied_sync,
      conveyor_1 => conveyor_1,
      conveyor_2 => conveyor_2,
      conveyor_3 => conveyor_3
    );
end architecture rtl;
