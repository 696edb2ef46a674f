-- Made by hotrail 0.1.0 from race_two_pushes.ladder. Do not edit: change the ladder and build again.

-- CTU: up counter
-- Fitted to PV = 2.
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- R   _________##____
-- Q   ___######____##
-- CV  011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity race_two_pushes_CTU_PV2 is
  port (
    clk           : in  std_logic;
    rst           : in  std_logic;
    power         : in  std_logic;
    clear_after   : in  std_logic;
    Q             : out std_logic;
    CV_at_least_1 : out std_logic
  );
end entity race_two_pushes_CTU_PV2;

architecture rtl of race_two_pushes_CTU_PV2 is
  signal CV : unsigned(1 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(1 downto 0);
  signal equal_2 : std_logic;
  signal CV_next : unsigned(1 downto 0);
  signal equal_3 : std_logic;
begin
  condition <= power and not was;
  equal <= '1' when CV = 2 else '0';
  sum <= CV + (to_unsigned(0, 1) & (condition and not equal));
  equal_2 <= '1' when CV = 1 else '0';
  CV_next <= to_unsigned(0, 2) when clear_after = '1' else sum;
  equal_3 <= '1' when CV = 0 else '0';

  Q <= (condition and equal_2) or equal;
  CV_at_least_1 <= not (not condition and equal_3);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
        was <= '0';
      else
        CV <= CV_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 20 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity race_two_pushes_TON_PT20 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    tick        : in  std_logic;
    power       : in  std_logic;
    clear_after : in  std_logic;
    Q           : out std_logic
  );
end entity race_two_pushes_TON_PT20;

architecture rtl of race_two_pushes_TON_PT20 is
  signal ET : unsigned(4 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(4 downto 0);
  signal choice : unsigned(4 downto 0);
  signal equal_2 : std_logic;
  signal ET_next : unsigned(4 downto 0);
begin
  condition <= power and was;
  equal <= '1' when ET = 20 else '0';
  sum <= ET + (to_unsigned(0, 4) & (tick and not equal));
  choice <= sum when condition = '1' else to_unsigned(0, 5);
  equal_2 <= '1' when ET = 19 else '0';
  ET_next <= to_unsigned(0, 5) when clear_after = '1' else choice;

  Q <= condition and ((tick and equal_2) or equal);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
      else
        ET <= ET_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity race_two_pushes is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    button : in  std_logic;
    clear  : in  std_logic;
    won    : out std_logic
  );
end entity race_two_pushes;

architecture rtl of race_two_pushes is
  signal won_reg : std_logic := '0';
  signal pushes_Q : std_logic;
  signal pushes_CV_at_least_1 : std_logic;
  signal time_Q : std_logic;
  signal won_rung3 : std_logic;
  signal rung4_power : std_logic;
  signal won_next : std_logic;
  signal pushes_clear_after : std_logic;
  signal time_clear_after : std_logic;
begin

  -- rung 1 "count the pushes", race_two_pushes.ladder:10

  -- rung 2 "the time runs from the first push on", race_two_pushes.ladder:13

  -- rung 3 "two pushes before the time is up", race_two_pushes.ladder:16
  won_rung3 <= (pushes_Q and not time_Q) or won_reg;

  -- rung 4 "won or lost, the next push is a first one", race_two_pushes.ladder:19
  rung4_power <= pushes_Q or time_Q;

  -- rung 5 "clear", race_two_pushes.ladder:22
  won_next <= won_rung3 and not clear;
  pushes_clear_after <= rung4_power or clear;
  pushes: entity work.race_two_pushes_CTU_PV2
    port map (
      clk => clk,
      rst => rst,
      power => button,
      clear_after => pushes_clear_after,
      Q => pushes_Q,
      CV_at_least_1 => pushes_CV_at_least_1
    );
  time_clear_after <= rung4_power or clear;
  time_u: entity work.race_two_pushes_TON_PT20
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pushes_CV_at_least_1,
      clear_after => time_clear_after,
      Q => time_Q
    );

  won <= won_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        won_reg <= '0';
      else
        won_reg <= won_next;
      end if;
    end if;
  end process;
end architecture rtl;
