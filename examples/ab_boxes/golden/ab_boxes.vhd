-- Made by hotrail 0.1.0 from ab_boxes.ladder. Do not edit: change the ladder and build again.

-- AB_TOF: off-delay timer of Allen-Bradley, BASE = 1 tick
-- Fitted to PRE = 100.
-- Example, with PRE = 3, BASE = 1:
-- IN  _##_____#__#_____
-- EN  _##_____#__#_____
-- TT  ___###___##_###__
-- DN  _#####__#######__
-- ACC 30001233001001233
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_boxes_AB_TOF_BASE1_PRE100 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    TT    : out std_logic;
    DN    : out std_logic
  );
end entity ab_boxes_AB_TOF_BASE1_PRE100;

architecture rtl of ab_boxes_AB_TOF_BASE1_PRE100 is
  signal ACC : unsigned(6 downto 0) := to_unsigned(100, 7);
  signal DN_reg : std_logic := '0';
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(6 downto 0);
  signal equal : std_logic;
  signal ACC_next : unsigned(6 downto 0);
  signal DN_next : std_logic;
begin
  condition <= not power;
  condition_2 <= condition and not was and DN_reg and tick;
  sum <= ACC + (to_unsigned(0, 6) & condition_2);
  equal <= '1' when ACC = 99 else '0';
  ACC_next <= to_unsigned(0, 7) when power = '1' else sum;
  DN_next <= power or (DN_reg and not (condition_2 and equal));

  TT <= condition and DN_next;
  DN <= DN_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= to_unsigned(100, 7);
        DN_reg <= '0';
        was <= '0';
      else
        ACC <= ACC_next;
        DN_reg <= DN_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- AB_CTU: up counter of Allen-Bradley
-- Example, with PRE = 2:
-- IN  _#_##_#_##_#
-- (R) ________#___
-- CU  _#_##_#__#_#
-- DN  ___#####___#
-- ACC 011222330112
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_boxes_AB_CTU is
  port (
    power         : in  std_logic;
    ACC_before    : in  unsigned(15 downto 0);
    was_up_before : in  std_logic;
    ACC           : out unsigned(15 downto 0);
    was_up        : out std_logic
  );
end entity ab_boxes_AB_CTU;

architecture rtl of ab_boxes_AB_CTU is
  signal ACC_value : unsigned(15 downto 0);
begin
  ACC_value <= ACC_before + (to_unsigned(0, 15) & (power and not was_up_before));

  ACC <= ACC_value;
  was_up <= power;
end architecture rtl;

-- AB_CTD: down counter of Allen-Bradley
-- Fitted to PRE = 4.
-- Example, with PRE = 1, ACC = 2:
-- IN    _#_##_#
-- CD    _#_##_#
-- DN    ###____
-- ACC+1 3221110
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_boxes_AB_CTD_PRE4 is
  port (
    power           : in  std_logic;
    ACC_before      : in  unsigned(15 downto 0);
    was_down_before : in  std_logic;
    ACC             : out unsigned(15 downto 0);
    DN              : out std_logic;
    was_down        : out std_logic
  );
end entity ab_boxes_AB_CTD_PRE4;

architecture rtl of ab_boxes_AB_CTD_PRE4 is
  signal ACC_value : unsigned(15 downto 0);
begin
  ACC_value <= ACC_before - (to_unsigned(0, 15) & (power and not was_down_before));

  ACC <= ACC_value;
  DN <= '1' when signed(ACC_value) >= 4 else '0';
  was_down <= power;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_boxes is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    tick       : in  std_logic;
    pull_cord  : in  std_logic;
    eye_1      : in  std_logic;
    eye_2      : in  std_logic;
    emptied    : in  std_logic;
    conveyor_1 : out std_logic;
    conveyor_2 : out std_logic;
    conveyor_3 : out std_logic
  );
end entity ab_boxes;

architecture rtl of ab_boxes is
  signal power_before : std_logic := '0';
  signal pull_cord_before : std_logic := '0';
  signal conveyor_1_reg : std_logic := '0';
  signal boxes_ACC_reg : unsigned(15 downto 0) := (others => '0');
  signal boxes_was_up_reg : std_logic := '1';
  signal boxes_was_down : std_logic := '1';
  signal conveyor_3_reg : std_logic := '0';
  signal conveyor_2_reg : std_logic := '0';
  signal pe_1_timer_TT : std_logic;
  signal pe_1_timer_DN : std_logic;
  signal pe_1_left : std_logic;
  signal conveyor_1_next : std_logic;
  signal boxes_ACC : unsigned(15 downto 0);
  signal boxes_was_up : std_logic;
  signal boxes_AB_CTD_ACC : unsigned(15 downto 0);
  signal boxes_AB_CTD_DN : std_logic;
  signal boxes_AB_CTD_was_down : std_logic;
  signal unloading_rung6 : std_logic;
  signal rung7_at_most : std_logic;
  signal unloading_rung7 : std_logic;
  signal boxes_ACC_next : unsigned(15 downto 0);
  signal boxes_was_up_next : std_logic;
  signal boxes_was_down_next : std_logic;
  signal conveyor_3_next : std_logic;
  signal conveyor_2_next : std_logic;
begin

  -- rung 1 "PE_1_Timer: a box moves on for a second after the eye", ab_boxes.ladder:14
  pe_1_timer: entity work.ab_boxes_AB_TOF_BASE1_PRE100
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => eye_1,
      TT => pe_1_timer_TT,
      DN => pe_1_timer_DN
    );

  -- rung 2 "in the scan in which the delay begins", ab_boxes.ladder:17
  pe_1_left <= pe_1_timer_TT and not power_before;

  -- rung 3 "conveyor 1: from the cord until the eye is free again", ab_boxes.ladder:20
  conveyor_1_next <= ((pull_cord and not pull_cord_before) or conveyor_1_reg) and not pe_1_left;

  -- rung 4 "boxes on conveyor 2: up at one eye", ab_boxes.ladder:23
  boxes: entity work.ab_boxes_AB_CTU
    port map (
      power => eye_1,
      ACC_before => boxes_ACC_reg,
      was_up_before => boxes_was_up_reg,
      ACC => boxes_ACC,
      was_up => boxes_was_up
    );

  -- rung 5 "down at the other, on the same counter", ab_boxes.ladder:26
  boxes_AB_CTD: entity work.ab_boxes_AB_CTD_PRE4
    port map (
      power => eye_2,
      ACC_before => boxes_ACC,
      was_down_before => boxes_was_down,
      ACC => boxes_AB_CTD_ACC,
      DN => boxes_AB_CTD_DN,
      was_down => boxes_AB_CTD_was_down
    );

  -- rung 6 "four are a group, once the last one is in its place", ab_boxes.ladder:29
  unloading_rung6 <= (boxes_AB_CTD_DN and not pe_1_timer_DN) or conveyor_3_reg;

  -- rung 7 "until the last one has gone", ab_boxes.ladder:32
  rung7_at_most <= '1' when signed(boxes_AB_CTD_ACC) <= 0 else '0';
  unloading_rung7 <= unloading_rung6 and not (rung7_at_most and not eye_2);

  -- rung 8, ab_boxes.ladder:35
  boxes_ACC_next <= to_unsigned(0, 16) when emptied = '1' else boxes_AB_CTD_ACC;
  boxes_was_up_next <= '0' when emptied = '1' else boxes_was_up;
  boxes_was_down_next <= '0' when emptied = '1' else boxes_AB_CTD_was_down;
  conveyor_3_next <= '0' when emptied = '1' else unloading_rung7;

  -- rung 9 "conveyor 2", ab_boxes.ladder:37
  conveyor_2_next <= pe_1_timer_DN or conveyor_3_next;

  -- rung 10 "conveyor 3", ab_boxes.ladder:40

  conveyor_1 <= conveyor_1_reg;
  conveyor_2 <= conveyor_2_reg;
  conveyor_3 <= conveyor_3_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        power_before <= '0';
        pull_cord_before <= '0';
        conveyor_1_reg <= '0';
        boxes_ACC_reg <= (others => '0');
        boxes_was_up_reg <= '1';
        boxes_was_down <= '1';
        conveyor_3_reg <= '0';
        conveyor_2_reg <= '0';
      else
        power_before <= pe_1_timer_TT;
        pull_cord_before <= pull_cord;
        conveyor_1_reg <= conveyor_1_next;
        boxes_ACC_reg <= boxes_ACC_next;
        boxes_was_up_reg <= boxes_was_up_next;
        boxes_was_down <= boxes_was_down_next;
        conveyor_3_reg <= conveyor_3_next;
        conveyor_2_reg <= conveyor_2_next;
      end if;
    end if;
  end process;
end architecture rtl;
