-- Made by hotrail 0.1.0 from edges_and_latches.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity edges_and_latches is
  port (
    clk       : in  std_logic;
    rst       : in  std_logic;
    tick      : in  std_logic;
    a         : in  std_logic;
    b         : in  std_logic;
    clear     : in  std_logic;
    on_rise   : out std_logic;
    on_fall   : out std_logic;
    shot_up   : out std_logic;
    shot_down : out std_logic;
    coil_up   : out std_logic;
    coil_down : out std_logic;
    latched   : out std_logic;
    inverted  : out std_logic;
    started   : out std_logic
  );
end entity edges_and_latches;

architecture rtl of edges_and_latches is
  signal inverted_reg : std_logic := '0';
  signal power_before : std_logic := '0';
  signal coil_up_power_before : std_logic := '0';
  signal latched_reg : std_logic := '0';
  signal first_scan : std_logic := '1';
  signal started_reg : std_logic := '0';
  signal on_rise_reg : std_logic := '0';
  signal on_fall_reg : std_logic := '0';
  signal shot_up_reg : std_logic := '0';
  signal shot_down_reg : std_logic := '0';
  signal coil_up_reg : std_logic := '0';
  signal coil_down_reg : std_logic := '0';
  signal on_rise_next : std_logic;
  signal on_fall_next : std_logic;
  signal power_before_next : std_logic;
  signal shot_up_next : std_logic;
  signal shot_down_next : std_logic;
  signal coil_up_power_before_next : std_logic;
  signal coil_up_next : std_logic;
  signal coil_down_next : std_logic;
  signal latched_rung4 : std_logic;
  signal latched_next : std_logic;
  signal inverted_next : std_logic;
  signal started_next : std_logic;
begin

  -- rung 1 "edge contacts", edges_and_latches.ladder:11
  on_rise_next <= a and not inverted_reg;
  on_fall_next <= inverted_reg and not a;

  -- rung 2 "one-shots on the power of a and b", edges_and_latches.ladder:14
  power_before_next <= a and b;
  shot_up_next <= power_before_next and not power_before;
  shot_down_next <= power_before and not power_before_next;

  -- rung 3 "edge coils", edges_and_latches.ladder:17
  coil_up_power_before_next <= a and b;
  coil_up_next <= coil_up_power_before_next and not coil_up_power_before;
  coil_down_next <= coil_up_power_before and not coil_up_power_before_next;

  -- rung 4 "latch: reset wins, because it stands below", edges_and_latches.ladder:20
  latched_rung4 <= a or latched_reg;

  -- rung 5, edges_and_latches.ladder:22
  latched_next <= latched_rung4 and not clear;

  -- rung 6 "inverted coil", edges_and_latches.ladder:24
  inverted_next <= a;

  -- rung 7 "first scan", edges_and_latches.ladder:27
  started_next <= first_scan or started_reg;

  on_rise <= on_rise_reg;
  on_fall <= on_fall_reg;
  shot_up <= shot_up_reg;
  shot_down <= shot_down_reg;
  coil_up <= coil_up_reg;
  coil_down <= coil_down_reg;
  latched <= latched_reg;
  inverted <= inverted_reg;
  started <= started_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        inverted_reg <= '0';
        power_before <= '0';
        coil_up_power_before <= '0';
        latched_reg <= '0';
        first_scan <= '1';
        started_reg <= '0';
        on_rise_reg <= '0';
        on_fall_reg <= '0';
        shot_up_reg <= '0';
        shot_down_reg <= '0';
        coil_up_reg <= '0';
        coil_down_reg <= '0';
      else
        inverted_reg <= inverted_next;
        power_before <= power_before_next;
        coil_up_power_before <= coil_up_power_before_next;
        latched_reg <= latched_next;
        first_scan <= '0';
        started_reg <= started_next;
        on_rise_reg <= on_rise_next;
        on_fall_reg <= on_fall_next;
        shot_up_reg <= shot_up_next;
        shot_down_reg <= shot_down_next;
        coil_up_reg <= coil_up_next;
        coil_down_reg <= coil_down_next;
      end if;
    end if;
  end process;
end architecture rtl;
