-- Made by hotrail 0.1.0 from conveyor_line.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects conveyor_line to the pins of a board.
entity conveyor_line_top is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    start        : in  std_logic;
    reset_faults : in  std_logic;
    stop         : in  std_logic;
    L1           : in  std_logic;
    L2           : in  std_logic;
    L3           : in  std_logic;
    L4           : in  std_logic;
    P1           : in  std_logic;
    P2           : in  std_logic;
    P3           : in  std_logic;
    C1           : out std_logic;
    C2           : out std_logic;
    C3           : out std_logic;
    fault_1      : out std_logic;
    fault_2      : out std_logic;
    fault_3      : out std_logic
  );
end entity conveyor_line_top;

architecture rtl of conveyor_line_top is
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
  signal reset_faults_meta : std_logic := '0';
  signal reset_faults_sync : std_logic := '0';
  attribute async_reg of reset_faults_meta : signal is "TRUE";
  attribute async_reg of reset_faults_sync : signal is "TRUE";
  signal stop_meta : std_logic := '0';
  signal stop_sync : std_logic := '0';
  attribute async_reg of stop_meta : signal is "TRUE";
  attribute async_reg of stop_sync : signal is "TRUE";
  signal L1_meta : std_logic := '0';
  signal L1_sync : std_logic := '0';
  attribute async_reg of L1_meta : signal is "TRUE";
  attribute async_reg of L1_sync : signal is "TRUE";
  signal L2_meta : std_logic := '0';
  signal L2_sync : std_logic := '0';
  attribute async_reg of L2_meta : signal is "TRUE";
  attribute async_reg of L2_sync : signal is "TRUE";
  signal L3_meta : std_logic := '0';
  signal L3_sync : std_logic := '0';
  attribute async_reg of L3_meta : signal is "TRUE";
  attribute async_reg of L3_sync : signal is "TRUE";
  signal L4_meta : std_logic := '0';
  signal L4_sync : std_logic := '0';
  attribute async_reg of L4_meta : signal is "TRUE";
  attribute async_reg of L4_sync : signal is "TRUE";
  signal P1_meta : std_logic := '0';
  signal P1_sync : std_logic := '0';
  attribute async_reg of P1_meta : signal is "TRUE";
  attribute async_reg of P1_sync : signal is "TRUE";
  signal P2_meta : std_logic := '0';
  signal P2_sync : std_logic := '0';
  attribute async_reg of P2_meta : signal is "TRUE";
  attribute async_reg of P2_sync : signal is "TRUE";
  signal P3_meta : std_logic := '0';
  signal P3_sync : std_logic := '0';
  attribute async_reg of P3_meta : signal is "TRUE";
  attribute async_reg of P3_sync : signal is "TRUE";
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
      reset_faults_meta <= reset_faults;
      reset_faults_sync <= reset_faults_meta;
      stop_meta <= stop;
      stop_sync <= stop_meta;
      L1_meta <= L1;
      L1_sync <= L1_meta;
      L2_meta <= L2;
      L2_sync <= L2_meta;
      L3_meta <= L3;
      L3_sync <= L3_meta;
      L4_meta <= L4;
      L4_sync <= L4_meta;
      P1_meta <= P1;
      P1_sync <= P1_meta;
      P2_meta <= P2;
      P2_sync <= P2_meta;
      P3_meta <= P3;
      P3_sync <= P3_meta;
    end if;
  end process;

  core: entity work.conveyor_line
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      start => start_sync,
      reset_faults => reset_faults_sync,
      stop => stop_sync,
      L1 => L1_sync,
      L2 => L2_sync,
      L3 => L3_sync,
      L4 => L4_sync,
      P1 => P1_sync,
      P2 => P2_sync,
      P3 => P3_sync,
      C1 => C1,
      C2 => C2,
      C3 => C3,
      fault_1 => fault_1,
      fault_2 => fault_2,
      fault_3 => fault_3
    );
end architecture rtl;
