-- Made by hotrail 0.1.0 from parts_per_minute.ladder. Do not edit: change the ladder and build again.

-- TON: on-delay timer
-- Fitted to PT = 60 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity parts_per_minute_TON_PT60 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity parts_per_minute_TON_PT60;

architecture rtl of parts_per_minute_TON_PT60 is
  signal ET : unsigned(5 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_60 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(5 downto 0);
  signal choice : unsigned(5 downto 0);
  signal ET_next : unsigned(5 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_60_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_60;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 6);
  equal <= '1' when ET = 59 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_60;
  ET_is_60_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_60_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_60 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_60 <= ET_is_60_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- CTU: up counter
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- R   _________##____
-- Q   ___######____##
-- CV  011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity parts_per_minute_CTU is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    R     : in  std_logic;
    CV    : out unsigned(14 downto 0)
  );
end entity parts_per_minute_CTU;

architecture rtl of parts_per_minute_CTU is
  signal CV_reg : unsigned(14 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal unequal : std_logic;
  signal sum : unsigned(14 downto 0);
  signal CV_next : unsigned(14 downto 0);
begin
  unequal <= '1' when CV_reg /= 32767 else '0';
  sum <= CV_reg + (to_unsigned(0, 14) & (power and not was and unequal));
  CV_next <= to_unsigned(0, 15) when R = '1' else sum;

  CV <= CV_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV_reg <= (others => '0');
        was <= '0';
      else
        CV_reg <= CV_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity parts_per_minute is
  port (
    clk    : in  std_logic;
    rst    : in  std_logic;
    tick   : in  std_logic;
    sensor : in  std_logic;
    S      : in  std_logic;
    parts  : out std_logic_vector(15 downto 0);
    done   : out std_logic
  );
end entity parts_per_minute;

architecture rtl of parts_per_minute is
  signal sensor_before : std_logic := '0';
  signal parts_reg : unsigned(14 downto 0) := (others => '0');
  signal done_reg : std_logic := '0';
  signal minute_Q : std_logic;
  signal done_next : std_logic;
  signal count_power : std_logic;
  signal count_R : std_logic;
  signal count_CV : unsigned(14 downto 0);
  signal parts_value : unsigned(15 downto 0);
  signal parts_next : unsigned(14 downto 0);
begin

  -- rung 1 "the minute", parts_per_minute.ladder:11
  minute: entity work.parts_per_minute_TON_PT60
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => S,
      Q => minute_Q
    );
  done_next <= minute_Q;

  -- rung 2 "parts in it", parts_per_minute.ladder:14
  count_power <= sensor and not sensor_before and S and not minute_Q;
  count_R <= not S;
  count: entity work.parts_per_minute_CTU
    port map (
      clk => clk,
      rst => rst,
      power => count_power,
      R => count_R,
      CV => count_CV
    );

  -- rung 3 "the count, kept until S opens", parts_per_minute.ladder:17
  parts_value <= resize(parts_reg, 16);
  parts_next <= count_CV;

  parts <= std_logic_vector(parts_value);
  done <= done_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        sensor_before <= '0';
        parts_reg <= (others => '0');
        done_reg <= '0';
      else
        sensor_before <= sensor;
        parts_reg <= parts_next;
        done_reg <= done_next;
      end if;
    end if;
  end process;
end architecture rtl;
