-- Made by hotrail 0.1.0 from boolean_equations.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects boolean_equations to the pins of a board.
entity boolean_equations_top is
  port (
    clk : in  std_logic;
    rst : in  std_logic;
    X1  : in  std_logic;
    X2  : in  std_logic;
    X3  : in  std_logic;
    X4  : in  std_logic;
    Y1  : out std_logic;
    Y2  : out std_logic
  );
end entity boolean_equations_top;

architecture rtl of boolean_equations_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal X1_meta : std_logic := '0';
  signal X1_sync : std_logic := '0';
  attribute async_reg of X1_meta : signal is "TRUE";
  attribute async_reg of X1_sync : signal is "TRUE";
  signal X2_meta : std_logic := '0';
  signal X2_sync : std_logic := '0';
  attribute async_reg of X2_meta : signal is "TRUE";
  attribute async_reg of X2_sync : signal is "TRUE";
  signal X3_meta : std_logic := '0';
  signal X3_sync : std_logic := '0';
  attribute async_reg of X3_meta : signal is "TRUE";
  attribute async_reg of X3_sync : signal is "TRUE";
  signal X4_meta : std_logic := '0';
  signal X4_sync : std_logic := '0';
  attribute async_reg of X4_meta : signal is "TRUE";
  attribute async_reg of X4_sync : signal is "TRUE";
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
      X1_meta <= X1;
      X1_sync <= X1_meta;
      X2_meta <= X2;
      X2_sync <= X2_meta;
      X3_meta <= X3;
      X3_sync <= X3_meta;
      X4_meta <= X4;
      X4_sync <= X4_meta;
    end if;
  end process;

  core: entity work.boolean_equations
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      X1 => X1_sync,
      X2 => X2_sync,
      X3 => X3_sync,
      X4 => X4_sync,
      Y1 => Y1,
      Y2 => Y2
    );
end architecture rtl;
