-- Made by hotrail 0.1.0 from box_grouping.ladder. Do not edit: change the ladder and build again.

-- TOF: off-delay timer
-- Fitted to PT = 1000 ticks.
-- Example, with PT = 3:
-- IN  _##_____#__#_____
-- Q   _#####__#######__
-- ET  00001233001001233
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity box_grouping_TOF_PT1000 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity box_grouping_TOF_PT1000;

architecture rtl of box_grouping_TOF_PT1000 is
  signal ET : unsigned(9 downto 0) := (others => '0');
  signal run : std_logic := '0';
  signal was : std_logic := '0';
  signal sum : unsigned(9 downto 0);
  signal equal : std_logic;
  signal choice : unsigned(9 downto 0);
  signal ET_next : unsigned(9 downto 0);
  signal run_next : std_logic;
begin
  sum <= ET + (to_unsigned(0, 9) & tick);
  equal <= '1' when ET = 999 else '0';
  choice <= to_unsigned(0, 10) when was = '1' else sum;
  ET_next <= to_unsigned(0, 10) when power = '1' else choice;
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

-- CTUD: up-down counter
-- Fitted to PV = 4.
-- Example, with PV = 2:
-- IN  _#_#__#______
-- CD  ____#_#_#____
-- R   ___________##
-- LD  __________#_#
-- QU  ___#______#__
-- QD  #_______##_##
-- CV  0112111100200
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity box_grouping_CTUD_PV4 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    CD    : in  std_logic;
    R     : in  std_logic;
    QU    : out std_logic;
    QD    : out std_logic
  );
end entity box_grouping_CTUD_PV4;

architecture rtl of box_grouping_CTUD_PV4 is
  signal CV : unsigned(15 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal was_down : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal unequal : std_logic;
  signal unequal_2 : std_logic;
  signal choice : unsigned(1 downto 0);
  signal sum : unsigned(15 downto 0);
  signal CV_next : unsigned(15 downto 0);
begin
  condition <= power and not was;
  condition_2 <= CD and not was_down;
  unequal <= '1' when CV /= 32767 else '0';
  unequal_2 <= '1' when CV /= 32768 else '0';
  choice <=
      to_unsigned(3, 2) when (condition_2 and not condition and unequal_2) = '1'
      else to_unsigned(0, 1) & (condition and not condition_2 and unequal);
  sum <= CV + unsigned(resize(signed(choice), 16));
  CV_next <= to_unsigned(0, 16) when R = '1' else sum;

  QU <= '1' when signed(CV_next) >= 4 else '0';
  QD <= '1' when signed(CV_next) <= 0 else '0';

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
        was <= '0';
        was_down <= '0';
      else
        CV <= CV_next;
        was <= power;
        was_down <= CD;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity box_grouping is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    tick       : in  std_logic;
    pull_cord  : in  std_logic;
    eye_in     : in  std_logic;
    eye_out    : in  std_logic;
    emptied    : in  std_logic;
    conveyor_1 : out std_logic;
    conveyor_2 : out std_logic;
    conveyor_3 : out std_logic
  );
end entity box_grouping;

architecture rtl of box_grouping is
  signal eye_in_before : std_logic := '0';
  signal pull_cord_before : std_logic := '0';
  signal conveyor_1_reg : std_logic := '0';
  signal conveyor_3_reg : std_logic := '0';
  signal conveyor_2_reg : std_logic := '0';
  signal box_passed : std_logic;
  signal conveyor_1_next : std_logic;
  signal past_eye_Q : std_logic;
  signal boxes_QU : std_logic;
  signal boxes_QD : std_logic;
  signal unloading_rung5 : std_logic;
  signal conveyor_3_next : std_logic;
  signal conveyor_2_next : std_logic;
begin

  -- rung 1 "a box has passed the eye", box_grouping.ladder:13
  box_passed <= eye_in_before and not eye_in;

  -- rung 2 "conveyor 1: from the cord until then", box_grouping.ladder:16
  conveyor_1_next <= ((pull_cord and not pull_cord_before) or conveyor_1_reg) and not box_passed;

  -- rung 3 "a box moves on for a second after the eye", box_grouping.ladder:19
  past_eye: entity work.box_grouping_TOF_PT1000
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => eye_in,
      Q => past_eye_Q
    );

  -- rung 4 "boxes on conveyor 2: up at one eye, down at the other", box_grouping.ladder:22
  boxes: entity work.box_grouping_CTUD_PV4
    port map (
      clk => clk,
      rst => rst,
      power => eye_in,
      CD => eye_out,
      R => emptied,
      QU => boxes_QU,
      QD => boxes_QD
    );

  -- rung 5 "four are a group, once the last one is in its place", box_grouping.ladder:25
  unloading_rung5 <= (boxes_QU and not past_eye_Q) or conveyor_3_reg;

  -- rung 6 "until the last one has gone", box_grouping.ladder:28
  conveyor_3_next <= unloading_rung5 and not (boxes_QD and not eye_out);

  -- rung 7 "conveyor 2", box_grouping.ladder:31
  conveyor_2_next <= past_eye_Q or conveyor_3_next;

  -- rung 8 "conveyor 3", box_grouping.ladder:34

  conveyor_1 <= conveyor_1_reg;
  conveyor_2 <= conveyor_2_reg;
  conveyor_3 <= conveyor_3_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        eye_in_before <= '0';
        pull_cord_before <= '0';
        conveyor_1_reg <= '0';
        conveyor_3_reg <= '0';
        conveyor_2_reg <= '0';
      else
        eye_in_before <= eye_in;
        pull_cord_before <= pull_cord;
        conveyor_1_reg <= conveyor_1_next;
        conveyor_3_reg <= conveyor_3_next;
        conveyor_2_reg <= conveyor_2_next;
      end if;
    end if;
  end process;
end architecture rtl;
