-- Made by hotrail 0.1.0 from part_counter.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 5 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity part_counter_TON_PT5 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity part_counter_TON_PT5;

architecture rtl of part_counter_TON_PT5 is
  signal ET : unsigned(2 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(2 downto 0);
  signal ET_next : unsigned(2 downto 0);
  signal equal_2 : std_logic;
begin
  condition <= power and was;
  equal <= '1' when ET = 5 else '0';
  sum <= ET + (to_unsigned(0, 2) & (tick and not equal));
  ET_next <= sum when condition = '1' else to_unsigned(0, 3);
  equal_2 <= '1' when ET = 4 else '0';

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

-- CTU: up counter
-- Fitted to PV = 5.
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- R   _________##____
-- Q   ___######____##
-- CV  011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity part_counter_CTU_PV5 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    R     : in  std_logic;
    Q     : out std_logic;
    CV    : out unsigned(14 downto 0)
  );
end entity part_counter_CTU_PV5;

architecture rtl of part_counter_CTU_PV5 is
  signal CV_reg : unsigned(14 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal CV_at_least_5 : std_logic := '0';
  signal unequal : std_logic;
  signal condition : std_logic;
  signal sum : unsigned(14 downto 0);
  signal CV_next : unsigned(14 downto 0);
  signal equal : std_logic;
  signal choice : std_logic;
  signal CV_at_least_5_next : std_logic;
begin
  unequal <= '1' when CV_reg /= 32767 else '0';
  condition <= power and not was and unequal;
  sum <= CV_reg + (to_unsigned(0, 14) & condition);
  CV_next <= to_unsigned(0, 15) when R = '1' else sum;
  equal <= '1' when CV_reg = 4 else '0';
  choice <= equal or CV_at_least_5 when condition = '1' else CV_at_least_5;
  CV_at_least_5_next <= not R and choice;

  Q <= CV_at_least_5_next;
  CV <= CV_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV_reg <= (others => '0');
        was <= '0';
        CV_at_least_5 <= '0';
      else
        CV_reg <= CV_next;
        was <= power;
        CV_at_least_5 <= CV_at_least_5_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity part_counter is
  port (
    clk             : in  std_logic;
    rst             : in  std_logic;
    tick            : in  std_logic;
    part_at_machine : in  std_logic;
    clear           : in  std_logic;
    parts           : out std_logic_vector(15 downto 0);
    batch_full      : out std_logic
  );
end entity part_counter;

architecture rtl of part_counter is
  signal parts_reg : unsigned(14 downto 0) := (others => '0');
  signal batch_full_reg : std_logic := '0';
  signal present_Q : std_logic;
  signal count_Q : std_logic;
  signal count_CV : unsigned(14 downto 0);
  signal batch_full_next : std_logic;
  signal parts_value : unsigned(15 downto 0);
  signal parts_next : unsigned(14 downto 0);
begin

  -- rung 1 "a part is one that stays for half a second", part_counter.ladder:12
  present: entity work.part_counter_TON_PT5
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => part_at_machine,
      Q => present_Q
    );
  count: entity work.part_counter_CTU_PV5
    port map (
      clk => clk,
      rst => rst,
      power => present_Q,
      R => clear,
      Q => count_Q,
      CV => count_CV
    );
  batch_full_next <= count_Q;

  -- rung 2 "show the count", part_counter.ladder:15
  parts_value <= resize(parts_reg, 16);
  parts_next <= count_CV;

  parts <= std_logic_vector(parts_value);
  batch_full <= batch_full_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        parts_reg <= (others => '0');
        batch_full_reg <= '0';
      else
        parts_reg <= parts_next;
        batch_full_reg <= batch_full_next;
      end if;
    end if;
  end process;
end architecture rtl;
