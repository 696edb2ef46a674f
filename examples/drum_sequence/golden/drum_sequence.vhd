-- Made by hotrail 0.1.0 from drum_sequence.ladder. Do not edit: change the ladder and build again.

-- DIVIDER: divider of the tick, N = 1 tick
-- Example, with N = 3:
-- tick ####_#__##
-- IN   ##########
-- Q    __#_____#_
-- CV   1201122201
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity drum_sequence_DIVIDER_N1 is
  port (
    tick : in  std_logic;
    Q    : out std_logic
  );
end entity drum_sequence_DIVIDER_N1;

architecture rtl of drum_sequence_DIVIDER_N1 is
begin

  Q <= tick;
end architecture rtl;

-- DRUM: drum counter, TAPS = [1, 3, 5, 9]
-- Fitted to PV = 12.
-- Example, with PV = 3, TAPS = [1, 2]:
-- IN   _#_#_#_#___
-- EN   #########_#
-- Q    _____####__
-- TAP0 _########__
-- TAP1 ___######__
-- ACC  01122334400
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity drum_sequence_DRUM_PV12 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    power  : in  std_logic;
    EN     : in  std_logic;
    Q_last : out std_logic;
    TAP0   : out std_logic;
    TAP1   : out std_logic;
    TAP2   : out std_logic;
    TAP3   : out std_logic
  );
end entity drum_sequence_DRUM_PV12;

architecture rtl of drum_sequence_DRUM_PV12 is
  signal Q : std_logic := '0';
  signal ACC : unsigned(3 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(3 downto 0);
  signal ACC_next : unsigned(3 downto 0);
  signal equal_2 : std_logic;
  signal Q_next : std_logic;
  signal equal_3 : std_logic;
begin
  condition <= power and not was;
  equal <= '1' when ACC = 12 else '0';
  sum <= ACC + (to_unsigned(0, 3) & (condition and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 4);
  equal_2 <= '1' when ACC = 11 else '0';
  Q_next <= EN and ((condition and equal_2) or equal);
  equal_3 <= '1' when ACC = 0 else '0';

  Q_last <= Q;
  TAP0 <= not (not EN or (not condition and equal_3));
  TAP1 <= '1' when ACC_next >= 3 else '0';
  TAP2 <= '1' when ACC_next >= 5 else '0';
  TAP3 <= '1' when ACC_next >= 9 else '0';

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q <= '0';
        ACC <= (others => '0');
        was <= '0';
      else
        Q <= Q_next;
        ACC <= ACC_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- T0_1: timer of tenths of a second
-- Fitted to PV = 10.
-- Example, with PV = 3:
-- IN  _#######__##__
-- EN  ###########_##
-- Q   ____#######___
-- QN  ####_______###
-- ACC 00123333333000
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity drum_sequence_T0_1_PV10 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    power  : in  std_logic;
    EN     : in  std_logic;
    unit   : in  std_logic;
    Q      : out std_logic;
    Q_last : out std_logic
  );
end entity drum_sequence_T0_1_PV10;

architecture rtl of drum_sequence_T0_1_PV10 is
  signal Q_reg : std_logic := '0';
  signal ACC : unsigned(3 downto 0) := (others => '0');
  signal ran : std_logic := '0';
  signal ran_next : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(3 downto 0);
  signal ACC_next : unsigned(3 downto 0);
  signal equal_2 : std_logic;
  signal Q_next : std_logic;
begin
  ran_next <= power and EN;
  equal <= '1' when ACC = 10 else '0';
  sum <= ACC + (to_unsigned(0, 3) & (ran_next and ran and unit and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 4);
  equal_2 <= '1' when ACC = 9 else '0';
  Q_next <= EN and ((ran_next and ran and unit and equal_2) or equal);

  Q <= Q_next;
  Q_last <= Q_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        ACC <= (others => '0');
        ran <= '0';
      else
        Q_reg <= Q_next;
        ACC <= ACC_next;
        ran <= ran_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity drum_sequence is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    tick    : in  std_logic;
    start   : in  std_logic;
    stop    : in  std_logic;
    water   : out std_logic;
    heater  : out std_logic;
    motor   : out std_logic;
    pump    : out std_logic;
    running : out std_logic
  );
end entity drum_sequence;

architecture rtl of drum_sequence is
  signal running_reg : std_logic := '0';
  signal water_reg : std_logic := '0';
  signal heater_reg : std_logic := '0';
  signal motor_reg : std_logic := '0';
  signal pump_reg : std_logic := '0';
  signal every_100ms_Q : std_logic;
  signal drum_Q_last : std_logic;
  signal drum_TAP0 : std_logic;
  signal drum_TAP1 : std_logic;
  signal drum_TAP2 : std_logic;
  signal drum_TAP3 : std_logic;
  signal running_next : std_logic;
  signal second_Q : std_logic;
  signal second_Q_last : std_logic;
  signal second_power : std_logic;
  signal second_EN : std_logic;
  signal water_next : std_logic;
  signal heater_next : std_logic;
  signal motor_next : std_logic;
  signal pump_next : std_logic;
begin

  -- units of time, each a pulse that all blocks share
  every_100ms: entity work.drum_sequence_DIVIDER_N1
    port map (
      tick => tick,
      Q => every_100ms_Q
    );

  -- rung 1 "from start to the end of the programme", drum_sequence.ladder:9
  running_next <= (start or running_reg) and not stop and not drum_Q_last;

  -- rung 2 "a step each second", drum_sequence.ladder:12
  second_power <= running_next and not second_Q_last;
  second_EN <= running_next and not second_Q_last;
  second: entity work.drum_sequence_T0_1_PV10
    port map (
      clk => clk,
      rst => rst,
      power => second_power,
      EN => second_EN,
      unit => every_100ms_Q,
      Q => second_Q,
      Q_last => second_Q_last
    );
  drum: entity work.drum_sequence_DRUM_PV12
    port map (
      clk => clk,
      rst => rst,
      power => second_Q,
      EN => running_next,
      Q_last => drum_Q_last,
      TAP0 => drum_TAP0,
      TAP1 => drum_TAP1,
      TAP2 => drum_TAP2,
      TAP3 => drum_TAP3
    );

  -- rung 3 "the steps, counted from the start", drum_sequence.ladder:15

  -- rung 4 "water from step 1 to 3", drum_sequence.ladder:18
  water_next <= drum_TAP0 and not drum_TAP1;

  -- rung 5 "heat from step 3 to 5", drum_sequence.ladder:21
  heater_next <= drum_TAP1 and not drum_TAP2;

  -- rung 6 "turn from step 3 to 9", drum_sequence.ladder:24
  motor_next <= drum_TAP1 and not drum_TAP3;

  -- rung 7 "pump off from step 9 to the end", drum_sequence.ladder:27
  pump_next <= drum_TAP3 and running_next;

  water <= water_reg;
  heater <= heater_reg;
  motor <= motor_reg;
  pump <= pump_reg;
  running <= running_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        running_reg <= '0';
        water_reg <= '0';
        heater_reg <= '0';
        motor_reg <= '0';
        pump_reg <= '0';
      else
        running_reg <= running_next;
        water_reg <= water_next;
        heater_reg <= heater_next;
        motor_reg <= motor_next;
        pump_reg <= pump_next;
      end if;
    end if;
  end process;
end architecture rtl;
