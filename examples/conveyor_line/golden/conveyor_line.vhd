-- Made by hotrail 0.1.0 from conveyor_line.ladder. Do not edit: change the ladder and build again.

-- TONR: retentive on-delay timer
-- Fitted to PT = 100 ticks.
-- Example, with PT = 3:
-- IN  _##_###____######
-- R   _________#___#___
-- Q   ______###_______#
-- ET  00111233300010123
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_line_TONR_PT100 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    power  : in  std_logic;
    R      : in  std_logic;
    Q_last : out std_logic
  );
end entity conveyor_line_TONR_PT100;

architecture rtl of conveyor_line_TONR_PT100 is
  signal Q : std_logic := '0';
  signal ET : unsigned(6 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_100 : std_logic := '0';
  signal condition : std_logic;
  signal sum : unsigned(6 downto 0);
  signal choice : unsigned(6 downto 0);
  signal ET_next : unsigned(6 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_100_next : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and was and tick and not ET_is_100;
  sum <= ET + 1;
  choice <= sum when condition = '1' else ET;
  ET_next <= to_unsigned(0, 7) when R = '1' else choice;
  equal <= '1' when ET = 99 else '0';
  choice_2 <= equal when condition = '1' else ET_is_100;
  ET_is_100_next <= '0' when R = '1' else choice_2;
  Q_next <= not R and ET_is_100_next;

  Q_last <= Q;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q <= '0';
        ET <= (others => '0');
        was <= '0';
        ET_is_100 <= '0';
      else
        Q <= Q_next;
        ET <= ET_next;
        was <= power;
        ET_is_100 <= ET_is_100_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 40 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_line_TON_PT40 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity conveyor_line_TON_PT40;

architecture rtl of conveyor_line_TON_PT40 is
  signal ET : unsigned(5 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_40 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(5 downto 0);
  signal choice : unsigned(5 downto 0);
  signal ET_next : unsigned(5 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_40_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_40;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 6);
  equal <= '1' when ET = 39 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_40;
  ET_is_40_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_40_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_40 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_40 <= ET_is_40_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_line is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    tick         : in  std_logic;
    start        : in  std_logic;
    reset_faults : in  std_logic;
    stop         : in  std_logic;
    L1           : in  std_logic;
    L2           : in  std_logic;
    L3           : in  std_logic;
    L4           : in  std_logic;
    P1           : in  std_logic;
    P2           : in  std_logic;
    P3           : in  std_logic;
    C1           : out std_logic;
    C2           : out std_logic;
    C3           : out std_logic;
    fault_1      : out std_logic;
    fault_2      : out std_logic;
    fault_3      : out std_logic
  );
end entity conveyor_line;

architecture rtl of conveyor_line is
  signal start_before : std_logic := '0';
  signal on_u : std_logic := '0';
  signal filling : std_logic := '0';
  signal fault_3_reg : std_logic := '0';
  signal fault_2_reg : std_logic := '0';
  signal fault_1_reg : std_logic := '0';
  signal reset_faults_before : std_logic := '0';
  signal C1_reg : std_logic := '0';
  signal C2_reg : std_logic := '0';
  signal C3_reg : std_logic := '0';
  signal on_next : std_logic;
  signal filling_next : std_logic;
  signal empty_2_Q_last : std_logic;
  signal empty_3_Q_last : std_logic;
  signal C3_next : std_logic;
  signal C2_next : std_logic;
  signal C1_next : std_logic;
  signal rung8_power : std_logic;
  signal fault_1_rung8 : std_logic;
  signal fault_2_rung8 : std_logic;
  signal fault_3_rung8 : std_logic;
  signal late_1_power : std_logic;
  signal late_1_Q : std_logic;
  signal fault_1_next : std_logic;
  signal late_2_power : std_logic;
  signal late_2_Q : std_logic;
  signal fault_2_next : std_logic;
  signal late_3_power : std_logic;
  signal late_3_Q : std_logic;
  signal fault_3_next : std_logic;
begin

  -- rung 1 "switch the line on and off", conveyor_line.ladder:22
  on_next <= ((start and not start_before) or on_u) and stop;

  -- rung 2 "fill from the low level to the high one", conveyor_line.ladder:25
  filling_next <= (L2 or filling) and L1 and on_next;

  -- rung 3 "conveyors, from the bin upwards", conveyor_line.ladder:28
  C3_next <=
      (filling_next or not empty_2_Q_last or not empty_3_Q_last) and on_next and not fault_3_reg;

  -- rung 4, conveyor_line.ladder:30
  C2_next <= (filling_next or not empty_2_Q_last) and on_next and P3 and L4 and not fault_2_reg;
  empty_3: entity work.conveyor_line_TONR_PT100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => C3_next,
      R => C2_next,
      Q_last => empty_3_Q_last
    );

  -- rung 5, conveyor_line.ladder:31
  C1_next <= filling_next and P2 and L3 and not fault_1_reg;
  empty_2: entity work.conveyor_line_TONR_PT100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => C2_next,
      R => C1_next,
      Q_last => empty_2_Q_last
    );

  -- rung 6 "a conveyor is empty when it has run for 10 s since the one above it", conveyor_line.ladder:33

  -- rung 7, conveyor_line.ladder:35

  -- rung 8 "faults", conveyor_line.ladder:37
  rung8_power <= reset_faults and not reset_faults_before;
  fault_1_rung8 <= fault_1_reg and not rung8_power;
  fault_2_rung8 <= fault_2_reg and not rung8_power;
  fault_3_rung8 <= fault_3_reg and not rung8_power;

  -- rung 9, conveyor_line.ladder:39
  late_1_power <= C1_next and not P1;
  late_1: entity work.conveyor_line_TON_PT40
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => late_1_power,
      Q => late_1_Q
    );
  fault_1_next <= late_1_Q or fault_1_rung8;

  -- rung 10, conveyor_line.ladder:40
  late_2_power <= C2_next and not P2;
  late_2: entity work.conveyor_line_TON_PT40
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => late_2_power,
      Q => late_2_Q
    );
  fault_2_next <= late_2_Q or fault_2_rung8;

  -- rung 11, conveyor_line.ladder:41
  late_3_power <= C3_next and not P3;
  late_3: entity work.conveyor_line_TON_PT40
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => late_3_power,
      Q => late_3_Q
    );
  fault_3_next <= late_3_Q or fault_3_rung8;

  C1 <= C1_reg;
  C2 <= C2_reg;
  C3 <= C3_reg;
  fault_1 <= fault_1_reg;
  fault_2 <= fault_2_reg;
  fault_3 <= fault_3_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        start_before <= '0';
        on_u <= '0';
        filling <= '0';
        fault_3_reg <= '0';
        fault_2_reg <= '0';
        fault_1_reg <= '0';
        reset_faults_before <= '0';
        C1_reg <= '0';
        C2_reg <= '0';
        C3_reg <= '0';
      else
        start_before <= start;
        on_u <= on_next;
        filling <= filling_next;
        fault_3_reg <= fault_3_next;
        fault_2_reg <= fault_2_next;
        fault_1_reg <= fault_1_next;
        reset_faults_before <= reset_faults;
        C1_reg <= C1_next;
        C2_reg <= C2_next;
        C3_reg <= C3_next;
      end if;
    end if;
  end process;
end architecture rtl;
