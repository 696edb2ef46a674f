-- Made by hotrail 0.1.0 from wound_rotor_start.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects wound_rotor_start to the pins of a board.
entity wound_rotor_start_top is
  port (
    clk : in  std_logic;
    rst : in  std_logic;
    S0  : in  std_logic;
    S1  : in  std_logic;
    F1  : in  std_logic;
    K1  : out std_logic;
    K2  : out std_logic;
    K3  : out std_logic;
    K4  : out std_logic
  );
end entity wound_rotor_start_top;

architecture rtl of wound_rotor_start_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(20 downto 0) := (others => '0');
  signal tick : std_logic;
  signal S0_meta : std_logic := '0';
  signal S0_sync : std_logic := '0';
  attribute async_reg of S0_meta : signal is "TRUE";
  attribute async_reg of S0_sync : signal is "TRUE";
  signal S1_meta : std_logic := '0';
  signal S1_sync : std_logic := '0';
  attribute async_reg of S1_meta : signal is "TRUE";
  attribute async_reg of S1_sync : signal is "TRUE";
  signal F1_meta : std_logic := '0';
  signal F1_sync : std_logic := '0';
  attribute async_reg of F1_meta : signal is "TRUE";
  attribute async_reg of F1_sync : signal is "TRUE";
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
      S0_meta <= S0;
      S0_sync <= S0_meta;
      S1_meta <= S1;
      S1_sync <= S1_meta;
      F1_meta <= F1;
      F1_sync <= F1_meta;
    end if;
  end process;

  core: entity work.wound_rotor_start
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      S0 => S0_sync,
      S1 => S1_sync,
      F1 => F1_sync,
      K1 => K1,
      K2 => K2,
      K3 => K3,
      K4 => K4
    );
end architecture rtl;
