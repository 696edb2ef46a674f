-- Made by hotrail 0.1.0 from microwave.ladder. Do not edit: change the ladder and build again.

-- TONR: retentive on-delay timer
-- Fitted to PT = 900 ticks.
-- Example, with PT = 3:
-- IN  _##_###____######
-- R   _________#___#___
-- Q   ______###_______#
-- ET  00111233300010123
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity microwave_TONR_PT900 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    power  : in  std_logic;
    R      : in  std_logic;
    Q      : out std_logic;
    Q_last : out std_logic
  );
end entity microwave_TONR_PT900;

architecture rtl of microwave_TONR_PT900 is
  signal Q_reg : std_logic := '0';
  signal ET : unsigned(9 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_900 : std_logic := '0';
  signal condition : std_logic;
  signal sum : unsigned(9 downto 0);
  signal choice : unsigned(9 downto 0);
  signal ET_next : unsigned(9 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_900_next : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and was and tick and not ET_is_900;
  sum <= ET + 1;
  choice <= sum when condition = '1' else ET;
  ET_next <= to_unsigned(0, 10) when R = '1' else choice;
  equal <= '1' when ET = 899 else '0';
  choice_2 <= equal when condition = '1' else ET_is_900;
  ET_is_900_next <= '0' when R = '1' else choice_2;
  Q_next <= not R and ET_is_900_next;

  Q <= Q_next;
  Q_last <= Q_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        ET <= (others => '0');
        was <= '0';
        ET_is_900 <= '0';
      else
        Q_reg <= Q_next;
        ET <= ET_next;
        was <= power;
        ET_is_900 <= ET_is_900_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TOF: off-delay timer
-- Fitted to PT = 30 ticks.
-- Example, with PT = 3:
-- IN  _##_____#__#_____
-- Q   _#####__#######__
-- ET  00001233001001233
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity microwave_TOF_PT30 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity microwave_TOF_PT30;

architecture rtl of microwave_TOF_PT30 is
  signal ET : unsigned(4 downto 0) := (others => '0');
  signal run : std_logic := '0';
  signal was : std_logic := '0';
  signal sum : unsigned(4 downto 0);
  signal equal : std_logic;
  signal choice : unsigned(4 downto 0);
  signal ET_next : unsigned(4 downto 0);
  signal run_next : std_logic;
begin
  sum <= ET + (to_unsigned(0, 4) & tick);
  equal <= '1' when ET = 29 else '0';
  choice <= to_unsigned(0, 5) when was = '1' else sum;
  ET_next <= to_unsigned(0, 5) when power = '1' else choice;
  run_next <= power or (run and not (not was and tick and equal));

  Q <= run_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        run <= '0';
        was <= '0';
      else
        ET <= ET_next;
        run <= run_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity microwave is
  port (
    clk       : in  std_logic;
    rst       : in  std_logic;
    tick      : in  std_logic;
    start     : in  std_logic;
    cancel    : in  std_logic;
    door      : in  std_logic;
    foam      : in  std_logic;
    magnetron : out std_logic;
    turntable : out std_logic;
    ready     : out std_logic
  );
end entity microwave;

architecture rtl of microwave is
  signal start_before : std_logic := '0';
  signal turntable_reg : std_logic := '0';
  signal magnetron_reg : std_logic := '0';
  signal ready_reg : std_logic := '0';
  signal done_Q : std_logic;
  signal done_Q_last : std_logic;
  signal turntable_next : std_logic;
  signal sinking_Q : std_logic;
  signal magnetron_next : std_logic;
  signal done_R : std_logic;
  signal ready_next : std_logic;
begin

  -- rung 1 "cook until the time is up or somebody wants the bowl", microwave.ladder:13
  turntable_next <=
      ((start and not start_before and not done_Q_last) or turntable_reg) and door and not cancel
      and not done_Q_last;

  -- rung 2 "the foam needs three seconds to sink", microwave.ladder:16
  sinking: entity work.microwave_TOF_PT30
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => foam,
      Q => sinking_Q
    );
  magnetron_next <= not sinking_Q and turntable_next;

  -- rung 3 "a minute and a half of power, in all", microwave.ladder:19
  done_R <= cancel or (done_Q_last and not door);
  done: entity work.microwave_TONR_PT900
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => magnetron_next,
      R => done_R,
      Q => done_Q,
      Q_last => done_Q_last
    );
  ready_next <= done_Q;

  magnetron <= magnetron_reg;
  turntable <= turntable_reg;
  ready <= ready_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        start_before <= '0';
        turntable_reg <= '0';
        magnetron_reg <= '0';
        ready_reg <= '0';
      else
        start_before <= start;
        turntable_reg <= turntable_next;
        magnetron_reg <= magnetron_next;
        ready_reg <= ready_next;
      end if;
    end if;
  end process;
end architecture rtl;
