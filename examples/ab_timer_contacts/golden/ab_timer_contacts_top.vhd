-- Made by hotrail 0.1.0 from ab_timer_contacts.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects ab_timer_contacts to the pins of a board.
entity ab_timer_contacts_top is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    run          : in  std_logic;
    slower       : in  std_logic;
    enabled      : out std_logic;
    timing       : out std_logic;
    done         : out std_logic;
    not_enabled  : out std_logic;
    not_timing   : out std_logic;
    not_done     : out std_logic;
    siemens_done : out std_logic
  );
end entity ab_timer_contacts_top;

architecture rtl of ab_timer_contacts_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(13 downto 0) := (others => '0');
  signal tick : std_logic;
  signal run_meta : std_logic := '0';
  signal run_sync : std_logic := '0';
  attribute async_reg of run_meta : signal is "TRUE";
  attribute async_reg of run_sync : signal is "TRUE";
  signal slower_meta : std_logic := '0';
  signal slower_sync : std_logic := '0';
  attribute async_reg of slower_meta : signal is "TRUE";
  attribute async_reg of slower_sync : signal is "TRUE";
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
      run_meta <= run;
      run_sync <= run_meta;
      slower_meta <= slower;
      slower_sync <= slower_meta;
    end if;
  end process;

  core: entity work.ab_timer_contacts
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      run => run_sync,
      slower => slower_sync,
      enabled => enabled,
      timing => timing,
      done => done,
      not_enabled => not_enabled,
      not_timing => not_timing,
      not_done => not_done,
      siemens_done => siemens_done
    );
end architecture rtl;
