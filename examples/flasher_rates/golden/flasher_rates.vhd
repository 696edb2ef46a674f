-- Made by hotrail 0.1.0 from flasher_rates.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_rates_TON is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    power       : in  std_logic;
    PT          : in  unsigned(31 downto 0);
    clear_after : in  std_logic;
    Q           : out std_logic;
    ET          : out unsigned(31 downto 0)
  );
end entity flasher_rates_TON;

architecture rtl of flasher_rates_TON is
  signal ET_reg : unsigned(31 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal sum : unsigned(31 downto 0);
  signal ET_value : unsigned(31 downto 0);
  signal at_least : std_logic;
  signal ET_next : unsigned(31 downto 0);
begin
  less <= '1' when signed(ET_reg) < signed(PT) else '0';
  sum <= ET_reg + (to_unsigned(0, 31) & (tick and less));
  ET_value <= sum when (power and was) = '1' else to_unsigned(0, 32);
  at_least <= '1' when signed(ET_value) >= signed(PT) else '0';
  ET_next <= to_unsigned(0, 32) when clear_after = '1' else ET_value;

  Q <= power and at_least;
  ET <= ET_value;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET_reg <= (others => '0');
        was <= '0';
      else
        ET_reg <= ET_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_rates is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    enable : in  std_logic;
    slow   : in  std_logic;
    lamp   : out std_logic
  );
end entity flasher_rates;

architecture rtl of flasher_rates is
  signal on_time : unsigned(4 downto 0) := (others => '0');
  signal cycle_PT : unsigned(5 downto 0) := (others => '0');
  signal lamp_reg : std_logic := '0';
  signal rung1_power : std_logic;
  signal on_time_rung1 : unsigned(4 downto 0);
  signal cycle_PT_rung1 : unsigned(5 downto 0);
  signal on_time_next : unsigned(4 downto 0);
  signal cycle_PT_next : unsigned(5 downto 0);
  signal cycle_PT_2 : unsigned(31 downto 0);
  signal cycle_Q : std_logic;
  signal cycle_ET : unsigned(31 downto 0);
  signal rung2_choice : unsigned(31 downto 0);
  signal rung3_less : std_logic;
  signal lamp_next : std_logic;
begin

  -- rung 1 "rate", flasher_rates.ladder:12
  rung1_power <= not slow;
  on_time_rung1 <= to_unsigned(13, 5) when rung1_power = '1' else on_time;
  cycle_PT_rung1 <= to_unsigned(25, 6) when rung1_power = '1' else cycle_PT;
  on_time_next <= to_unsigned(25, 5) when slow = '1' else on_time_rung1;
  cycle_PT_next <= to_unsigned(42, 6) when slow = '1' else cycle_PT_rung1;
  cycle_PT_2 <= resize(cycle_PT_next, 32);

  -- rung 2 "one cycle after the other", flasher_rates.ladder:17
  cycle: entity work.flasher_rates_TON
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => enable,
      PT => cycle_PT_2,
      clear_after => cycle_Q,
      Q => cycle_Q,
      ET => cycle_ET
    );
  rung2_choice <= to_unsigned(0, 32) when cycle_Q = '1' else cycle_ET;

  -- rung 3 "lit in its first part", flasher_rates.ladder:20
  rung3_less <= '1' when signed(rung2_choice) < signed(resize(on_time_next, 32)) else '0';
  lamp_next <= enable and rung3_less;

  lamp <= lamp_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        on_time <= (others => '0');
        cycle_PT <= (others => '0');
        lamp_reg <= '0';
      else
        on_time <= on_time_next;
        cycle_PT <= cycle_PT_next;
        lamp_reg <= lamp_next;
      end if;
    end if;
  end process;
end architecture rtl;
