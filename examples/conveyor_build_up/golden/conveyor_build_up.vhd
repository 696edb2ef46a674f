-- Made by hotrail 0.1.0 from conveyor_build_up.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 30 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_build_up_TON_PT30 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity conveyor_build_up_TON_PT30;

architecture rtl of conveyor_build_up_TON_PT30 is
  signal ET : unsigned(4 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_30 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(4 downto 0);
  signal choice : unsigned(4 downto 0);
  signal ET_next : unsigned(4 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_30_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_30;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 5);
  equal <= '1' when ET = 29 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_30;
  ET_is_30_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_30_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_30 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_30 <= ET_is_30_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 50 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_build_up_TON_PT50 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity conveyor_build_up_TON_PT50;

architecture rtl of conveyor_build_up_TON_PT50 is
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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_build_up is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    tick       : in  std_logic;
    start      : in  std_logic;
    stop       : in  std_logic;
    eye        : in  std_logic;
    turning_2  : in  std_logic;
    conveyor_1 : out std_logic;
    conveyor_2 : out std_logic;
    build_up   : out std_logic
  );
end entity conveyor_build_up;

architecture rtl of conveyor_build_up is
  signal build_up_reg : std_logic := '0';
  signal start_before : std_logic := '0';
  signal conveyor_2_reg : std_logic := '0';
  signal conveyor_1_reg : std_logic := '0';
  signal blocked_power : std_logic;
  signal blocked_Q : std_logic;
  signal build_up_rung1 : std_logic;
  signal clear_Q : std_logic;
  signal build_up_next : std_logic;
  signal conveyor_2_next : std_logic;
  signal conveyor_1_next : std_logic;
begin

  -- rung 1 "a piece that passes is no pile", conveyor_build_up.ladder:14
  blocked_power <= not eye;
  blocked: entity work.conveyor_build_up_TON_PT30
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => blocked_power,
      Q => blocked_Q
    );
  build_up_rung1 <= blocked_Q or build_up_reg;

  -- rung 2 "the pile is gone", conveyor_build_up.ladder:17
  clear: entity work.conveyor_build_up_TON_PT50
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => eye,
      Q => clear_Q
    );
  build_up_next <= build_up_rung1 and not clear_Q;

  -- rung 3 "conveyor 2 runs as long as the line does", conveyor_build_up.ladder:20
  conveyor_2_next <= ((start and not start_before) or conveyor_2_reg) and stop;

  -- rung 4 "conveyor 1 runs while it can get rid of its material", conveyor_build_up.ladder:23
  conveyor_1_next <= conveyor_2_next and turning_2 and not build_up_next;

  conveyor_1 <= conveyor_1_reg;
  conveyor_2 <= conveyor_2_reg;
  build_up <= build_up_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        build_up_reg <= '0';
        start_before <= '0';
        conveyor_2_reg <= '0';
        conveyor_1_reg <= '0';
      else
        build_up_reg <= build_up_next;
        start_before <= start;
        conveyor_2_reg <= conveyor_2_next;
        conveyor_1_reg <= conveyor_1_next;
      end if;
    end if;
  end process;
end architecture rtl;
