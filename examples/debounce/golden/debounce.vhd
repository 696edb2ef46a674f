-- Made by hotrail 0.1.0 from debounce.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 50 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity debounce_TON_PT50 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity debounce_TON_PT50;

architecture rtl of debounce_TON_PT50 is
  signal ET : unsigned(5 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_50 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(5 downto 0);
  signal choice : unsigned(5 downto 0);
  signal ET_next : unsigned(5 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_50_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_50;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 6);
  equal <= '1' when ET = 49 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_50;
  ET_is_50_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_50_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_50 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_50 <= ET_is_50_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TOF: off-delay timer
-- Fitted to PT = 5 ticks.
-- Example, with PT = 3:
-- IN  _##_____#__#_____
-- Q   _#####__#######__
-- ET  00001233001001233
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity debounce_TOF_PT5 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity debounce_TOF_PT5;

architecture rtl of debounce_TOF_PT5 is
  signal ET : unsigned(2 downto 0) := (others => '0');
  signal run : std_logic := '0';
  signal was : std_logic := '0';
  signal sum : unsigned(2 downto 0);
  signal equal : std_logic;
  signal choice : unsigned(2 downto 0);
  signal ET_next : unsigned(2 downto 0);
  signal run_next : std_logic;
begin
  sum <= ET + (to_unsigned(0, 2) & tick);
  equal <= '1' when ET = 4 else '0';
  choice <= to_unsigned(0, 3) when was = '1' else sum;
  ET_next <= to_unsigned(0, 3) when power = '1' else choice;
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

entity debounce is
  port (
    clk            : in  std_logic;
    rst            : in  std_logic;
    tick           : in  std_logic;
    limit_switch_1 : in  std_logic;
    settled        : out std_logic;
    at_once        : out std_logic
  );
end entity debounce;

architecture rtl of debounce is
  signal settled_reg : std_logic := '0';
  signal at_once_reg : std_logic := '0';
  signal quiet_Q : std_logic;
  signal settled_next : std_logic;
  signal gaps_Q : std_logic;
  signal at_once_next : std_logic;
begin

  -- rung 1 "wait until it has been on for half a second", debounce.ladder:11
  quiet: entity work.debounce_TON_PT50
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => limit_switch_1,
      Q => quiet_Q
    );
  settled_next <= quiet_Q;

  -- rung 2 "act at once, and bridge the gaps of the bounce", debounce.ladder:14
  gaps: entity work.debounce_TOF_PT5
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => limit_switch_1,
      Q => gaps_Q
    );
  at_once_next <= gaps_Q;

  settled <= settled_reg;
  at_once <= at_once_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        settled_reg <= '0';
        at_once_reg <= '0';
      else
        settled_reg <= settled_next;
        at_once_reg <= at_once_next;
      end if;
    end if;
  end process;
end architecture rtl;
