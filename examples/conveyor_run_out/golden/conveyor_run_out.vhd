-- Made by hotrail 0.1.0 from conveyor_run_out.ladder. Do not edit: change the ladder and build again.

-- TONR: retentive on-delay timer
-- Fitted to PT = 120 ticks.
-- Example, with PT = 3:
-- IN  _##_###____######
-- R   _________#___#___
-- Q   ______###_______#
-- ET  00111233300010123
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_run_out_TONR_PT120 is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    power  : in  std_logic;
    R      : in  std_logic;
    Q      : out std_logic;
    Q_last : out std_logic
  );
end entity conveyor_run_out_TONR_PT120;

architecture rtl of conveyor_run_out_TONR_PT120 is
  signal Q_reg : std_logic := '0';
  signal ET : unsigned(6 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_120 : std_logic := '0';
  signal condition : std_logic;
  signal sum : unsigned(6 downto 0);
  signal choice : unsigned(6 downto 0);
  signal ET_next : unsigned(6 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_120_next : std_logic;
  signal Q_next : std_logic;
begin
  condition <= power and was and tick and not ET_is_120;
  sum <= ET + 1;
  choice <= sum when condition = '1' else ET;
  ET_next <= to_unsigned(0, 7) when R = '1' else choice;
  equal <= '1' when ET = 119 else '0';
  choice_2 <= equal when condition = '1' else ET_is_120;
  ET_is_120_next <= '0' when R = '1' else choice_2;
  Q_next <= not R and ET_is_120_next;

  Q <= Q_next;
  Q_last <= Q_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        Q_reg <= '0';
        ET <= (others => '0');
        was <= '0';
        ET_is_120 <= '0';
      else
        Q_reg <= Q_next;
        ET <= ET_next;
        was <= power;
        ET_is_120 <= ET_is_120_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity conveyor_run_out is
  port (
    clk           : in  std_logic;
    rst           : in  std_logic;
    tick          : in  std_logic;
    start         : in  std_logic;
    finish        : in  std_logic;
    emergency     : in  std_logic;
    product       : in  std_logic;
    wait_for_next : in  std_logic;
    conveyor      : out std_logic;
    empty         : out std_logic
  );
end entity conveyor_run_out;

architecture rtl of conveyor_run_out is
  signal start_before : std_logic := '0';
  signal ordered : std_logic := '0';
  signal finishing : std_logic := '0';
  signal conveyor_reg : std_logic := '0';
  signal empty_reg : std_logic := '0';
  signal rung1_power : std_logic;
  signal ordered_rung1 : std_logic;
  signal finishing_rung1 : std_logic;
  signal finishing_rung2 : std_logic;
  signal track_Q : std_logic;
  signal track_Q_last : std_logic;
  signal ordered_rung3 : std_logic;
  signal finishing_rung3 : std_logic;
  signal ordered_next : std_logic;
  signal finishing_next : std_logic;
  signal conveyor_next : std_logic;
  signal empty_next : std_logic;
begin

  -- rung 1 "start", conveyor_run_out.ladder:18
  rung1_power <= start and not start_before;
  ordered_rung1 <= rung1_power or ordered;
  finishing_rung1 <= finishing and not rung1_power;

  -- rung 2 "finish", conveyor_run_out.ladder:20
  finishing_rung2 <= (finish and ordered_rung1) or finishing_rung1;

  -- rung 3 "stop when the last product has left", conveyor_run_out.ladder:22
  ordered_rung3 <= ordered_rung1 and not (finishing_rung2 and track_Q_last);
  finishing_rung3 <= finishing_rung2 and not track_Q_last;

  -- rung 4 "emergency", conveyor_run_out.ladder:24
  ordered_next <= ordered_rung3 and emergency;
  finishing_next <= finishing_rung3 and emergency;

  -- rung 5 "conveyor", conveyor_run_out.ladder:27
  conveyor_next <= ordered_next and not wait_for_next;
  track: entity work.conveyor_run_out_TONR_PT120
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => conveyor_next,
      R => product,
      Q => track_Q,
      Q_last => track_Q_last
    );

  -- rung 6 "a product needs 12 s over the belt", conveyor_run_out.ladder:30
  empty_next <= track_Q;

  conveyor <= conveyor_reg;
  empty <= empty_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        start_before <= '0';
        ordered <= '0';
        finishing <= '0';
        conveyor_reg <= '0';
        empty_reg <= '0';
      else
        start_before <= start;
        ordered <= ordered_next;
        finishing <= finishing_next;
        conveyor_reg <= conveyor_next;
        empty_reg <= empty_next;
      end if;
    end if;
  end process;
end architecture rtl;
