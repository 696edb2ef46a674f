-- Made by hotrail 0.1.0 from spray_machine.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 15 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity spray_machine_TON_PT15 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity spray_machine_TON_PT15;

architecture rtl of spray_machine_TON_PT15 is
  signal ET : unsigned(3 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(3 downto 0);
  signal ET_next : unsigned(3 downto 0);
  signal equal_2 : std_logic;
begin
  condition <= power and was;
  equal <= '1' when ET = 15 else '0';
  sum <= ET + (to_unsigned(0, 3) & (tick and not equal));
  ET_next <= sum when condition = '1' else to_unsigned(0, 4);
  equal_2 <= '1' when ET = 14 else '0';

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

-- TP: pulse timer
-- Fitted to PT = 20 ticks.
-- Example, with PT = 3:
-- IN  _#####_#_#__
-- Q   _###___###__
-- ET  001233001200
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity spray_machine_TP_PT20 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity spray_machine_TP_PT20;

architecture rtl of spray_machine_TP_PT20 is
  signal ET : unsigned(4 downto 0) := (others => '0');
  signal run : std_logic := '0';
  signal was : std_logic := '0';
  signal sum : unsigned(4 downto 0);
  signal equal : std_logic;
  signal run_next : std_logic;
  signal ET_next : unsigned(4 downto 0);
begin
  sum <= ET + (to_unsigned(0, 4) & tick);
  equal <= '1' when ET = 19 else '0';
  run_next <= not (tick and equal) when run = '1' else power and not was;
  ET_next <= sum when run = '1' else to_unsigned(0, 5);

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

entity spray_machine is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    tick    : in  std_logic;
    start   : in  std_logic;
    stop    : in  std_logic;
    home    : in  std_logic;
    at_end  : in  std_logic;
    middle  : in  std_logic;
    forward : out std_logic;
    reverse : out std_logic;
    spray   : out std_logic
  );
end entity spray_machine;

architecture rtl of spray_machine is
  signal start_before : std_logic := '0';
  signal cycle : std_logic := '0';
  signal reverse_reg : std_logic := '0';
  signal forward_reg : std_logic := '0';
  signal spray_reg : std_logic := '0';
  signal cycle_next : std_logic;
  signal forward_next : std_logic;
  signal rest_power : std_logic;
  signal rest_Q : std_logic;
  signal reverse_next : std_logic;
  signal shot_power : std_logic;
  signal shot_Q : std_logic;
  signal spray_next : std_logic;
begin

  -- rung 1 "over-all motion, until the part is back home", spray_machine.ladder:15
  cycle_next <= ((start and not start_before) or cycle) and stop and (not reverse_reg or not home);

  -- rung 2 "forward, from home to the end", spray_machine.ladder:18
  forward_next <= cycle_next and (home or forward_reg) and not reverse_reg and not at_end;

  -- rung 3 "come to rest, then back home; after a stop too, from anywhere", spray_machine.ladder:21
  rest_power <= cycle_next and not forward_next and not home;
  rest: entity work.spray_machine_TON_PT15
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => rest_power,
      Q => rest_Q
    );
  reverse_next <= rest_Q;

  -- rung 4 "spray for two seconds while the part moves forward", spray_machine.ladder:24
  shot_power <= forward_next and middle;
  shot: entity work.spray_machine_TP_PT20
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => shot_power,
      Q => shot_Q
    );
  spray_next <= shot_Q and forward_next;

  forward <= forward_reg;
  reverse <= reverse_reg;
  spray <= spray_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        start_before <= '0';
        cycle <= '0';
        reverse_reg <= '0';
        forward_reg <= '0';
        spray_reg <= '0';
      else
        start_before <= start;
        cycle <= cycle_next;
        reverse_reg <= reverse_next;
        forward_reg <= forward_next;
        spray_reg <= spray_next;
      end if;
    end if;
  end process;
end architecture rtl;
