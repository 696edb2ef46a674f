-- Made by hotrail 0.1.0 from paper_counters.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects paper_counters to the pins of a board.
entity paper_counters_top is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    c1         : in  std_logic;
    c2         : in  std_logic;
    c3         : in  std_logic;
    c4         : in  std_logic;
    c5         : in  std_logic;
    c6         : in  std_logic;
    c7         : in  std_logic;
    c8         : in  std_logic;
    c9         : in  std_logic;
    cnt_en_ckt : in  std_logic;
    up_coil    : out std_logic;
    down_coil  : out std_logic;
    drum_coil  : out std_logic;
    tap0_out   : out std_logic;
    tap1_out   : out std_logic;
    tap2_out   : out std_logic;
    tap3_out   : out std_logic
  );
end entity paper_counters_top;

architecture rtl of paper_counters_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal c1_meta : std_logic := '0';
  signal c1_sync : std_logic := '0';
  attribute async_reg of c1_meta : signal is "TRUE";
  attribute async_reg of c1_sync : signal is "TRUE";
  signal c2_meta : std_logic := '0';
  signal c2_sync : std_logic := '0';
  attribute async_reg of c2_meta : signal is "TRUE";
  attribute async_reg of c2_sync : signal is "TRUE";
  signal c3_meta : std_logic := '0';
  signal c3_sync : std_logic := '0';
  attribute async_reg of c3_meta : signal is "TRUE";
  attribute async_reg of c3_sync : signal is "TRUE";
  signal c4_meta : std_logic := '0';
  signal c4_sync : std_logic := '0';
  attribute async_reg of c4_meta : signal is "TRUE";
  attribute async_reg of c4_sync : signal is "TRUE";
  signal c5_meta : std_logic := '0';
  signal c5_sync : std_logic := '0';
  attribute async_reg of c5_meta : signal is "TRUE";
  attribute async_reg of c5_sync : signal is "TRUE";
  signal c6_meta : std_logic := '0';
  signal c6_sync : std_logic := '0';
  attribute async_reg of c6_meta : signal is "TRUE";
  attribute async_reg of c6_sync : signal is "TRUE";
  signal c7_meta : std_logic := '0';
  signal c7_sync : std_logic := '0';
  attribute async_reg of c7_meta : signal is "TRUE";
  attribute async_reg of c7_sync : signal is "TRUE";
  signal c8_meta : std_logic := '0';
  signal c8_sync : std_logic := '0';
  attribute async_reg of c8_meta : signal is "TRUE";
  attribute async_reg of c8_sync : signal is "TRUE";
  signal c9_meta : std_logic := '0';
  signal c9_sync : std_logic := '0';
  attribute async_reg of c9_meta : signal is "TRUE";
  attribute async_reg of c9_sync : signal is "TRUE";
  signal cnt_en_ckt_meta : std_logic := '0';
  signal cnt_en_ckt_sync : std_logic := '0';
  attribute async_reg of cnt_en_ckt_meta : signal is "TRUE";
  attribute async_reg of cnt_en_ckt_sync : signal is "TRUE";
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
      c1_meta <= c1;
      c1_sync <= c1_meta;
      c2_meta <= c2;
      c2_sync <= c2_meta;
      c3_meta <= c3;
      c3_sync <= c3_meta;
      c4_meta <= c4;
      c4_sync <= c4_meta;
      c5_meta <= c5;
      c5_sync <= c5_meta;
      c6_meta <= c6;
      c6_sync <= c6_meta;
      c7_meta <= c7;
      c7_sync <= c7_meta;
      c8_meta <= c8;
      c8_sync <= c8_meta;
      c9_meta <= c9;
      c9_sync <= c9_meta;
      cnt_en_ckt_meta <= cnt_en_ckt;
      cnt_en_ckt_sync <= cnt_en_ckt_meta;
    end if;
  end process;

  core: entity work.paper_counters
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      c1 => c1_sync,
      c2 => c2_sync,
      c3 => c3_sync,
      c4 => c4_sync,
      c5 => c5_sync,
      c6 => c6_sync,
      c7 => c7_sync,
      c8 => c8_sync,
      c9 => c9_sync,
      cnt_en_ckt => cnt_en_ckt_sync,
      up_coil => up_coil,
      down_coil => down_coil,
      drum_coil => drum_coil,
      tap0_out => tap0_out,
      tap1_out => tap1_out,
      tap2_out => tap2_out,
      tap3_out => tap3_out
    );
end architecture rtl;
