-- Made by hotrail 0.1.0 from flasher.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 200 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_TON_PT200 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    power  : in  std_logic;
    Q_last : out std_logic
  );
end entity flasher_TON_PT200;

architecture rtl of flasher_TON_PT200 is
  signal Q : std_logic := '0';
  signal ET : unsigned(7 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(7 downto 0);
  signal choice : unsigned(7 downto 0);
  signal ET_next : unsigned(7 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not Q;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 8);
  equal <= '1' when ET = 199 else '0';
  choice_2 <= equal when condition_2 = '1' else Q;
  Q_next <= choice_2 when condition = '1' else '0';

  Q_last <= Q;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q <= '0';
        ET <= (others => '0');
        was <= '0';
      else
        Q <= Q_next;
        ET <= ET_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 1300 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher_TON_PT1300 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity flasher_TON_PT1300;

architecture rtl of flasher_TON_PT1300 is
  signal ET : unsigned(10 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_1300 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(10 downto 0);
  signal choice : unsigned(10 downto 0);
  signal ET_next : unsigned(10 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_1300_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_1300;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 11);
  equal <= '1' when ET = 1299 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_1300;
  ET_is_1300_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_1300_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_1300 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_1300 <= ET_is_1300_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity flasher is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    enable : in  std_logic;
    lamp   : out std_logic
  );
end entity flasher;

architecture rtl of flasher is
  signal lamp_reg : std_logic := '0';
  signal off_time_Q_last : std_logic;
  signal on_time_power : std_logic;
  signal on_time_Q : std_logic;
  signal lamp_next : std_logic;
begin

  -- rung 1 "the lamp is on until this timer has run", flasher.ladder:7
  on_time_power <= enable and not off_time_Q_last;
  off_time: entity work.flasher_TON_PT200
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => on_time_Q,
      Q_last => off_time_Q_last
    );
  on_time: entity work.flasher_TON_PT1300
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => on_time_power,
      Q => on_time_Q
    );

  -- rung 2 "and off until this one has", flasher.ladder:10

  -- rung 3 "lamp", flasher.ladder:13
  lamp_next <= enable and not on_time_Q;

  lamp <= lamp_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        lamp_reg <= '0';
      else
        lamp_reg <= lamp_next;
      end if;
    end if;
  end process;
end architecture rtl;
