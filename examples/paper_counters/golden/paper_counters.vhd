-- Made by hotrail 0.1.0 from paper_counters.ladder. Do not edit: change the ladder and build again.

-- UC: up counter with enable
-- Fitted to PV = 5.
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- EN  #########__####
-- Q   ___######____##
-- ACC 011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_counters_UC_PV5 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    EN    : in  std_logic;
    Q     : out std_logic
  );
end entity paper_counters_UC_PV5;

architecture rtl of paper_counters_UC_PV5 is
  signal ACC : unsigned(2 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(2 downto 0);
  signal ACC_next : unsigned(2 downto 0);
  signal equal_2 : std_logic;
begin
  condition <= power and not was;
  equal <= '1' when ACC = 5 else '0';
  sum <= ACC + (to_unsigned(0, 2) & (condition and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 3);
  equal_2 <= '1' when ACC = 4 else '0';

  Q <= EN and ((condition and equal_2) or equal);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        was <= '0';
      else
        ACC <= ACC_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- DC: down counter with enable
-- Fitted to PV = 5.
-- Example, with PV = 2:
-- IN  _#_##_#_#__
-- EN  #######__##
-- Q   ___####____
-- ACC 21100002222
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_counters_DC_PV5 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    EN    : in  std_logic;
    Q     : out std_logic
  );
end entity paper_counters_DC_PV5;

architecture rtl of paper_counters_DC_PV5 is
  signal ACC : unsigned(2 downto 0) := to_unsigned(5, 3);
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal difference : unsigned(2 downto 0);
  signal ACC_next : unsigned(2 downto 0);
  signal equal_2 : std_logic;
begin
  condition <= power and not was;
  equal <= '1' when ACC = 0 else '0';
  difference <= ACC - (to_unsigned(0, 2) & (condition and not equal));
  ACC_next <= difference when EN = '1' else to_unsigned(5, 3);
  equal_2 <= '1' when ACC = 1 else '0';

  Q <= EN and ((condition and equal_2) or equal);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= to_unsigned(5, 3);
        was <= '0';
      else
        ACC <= ACC_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- DRUM: drum counter, TAPS = [2, 4, 6, 8]
-- Fitted to PV = 10.
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

entity paper_counters_DRUM_PV10 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    power : in  std_logic;
    EN    : in  std_logic;
    Q     : out std_logic;
    TAP0  : out std_logic;
    TAP1  : out std_logic;
    TAP2  : out std_logic;
    TAP3  : out std_logic
  );
end entity paper_counters_DRUM_PV10;

architecture rtl of paper_counters_DRUM_PV10 is
  signal ACC : unsigned(3 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(3 downto 0);
  signal ACC_next : unsigned(3 downto 0);
  signal equal_2 : std_logic;
begin
  condition <= power and not was;
  equal <= '1' when ACC = 10 else '0';
  sum <= ACC + (to_unsigned(0, 3) & (condition and not equal));
  ACC_next <= sum when EN = '1' else to_unsigned(0, 4);
  equal_2 <= '1' when ACC = 9 else '0';

  Q <= EN and ((condition and equal_2) or equal);
  TAP0 <= '1' when ACC_next >= 2 else '0';
  TAP1 <= '1' when ACC_next >= 4 else '0';
  TAP2 <= '1' when ACC_next >= 6 else '0';
  TAP3 <= '1' when ACC_next >= 8 else '0';

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        was <= '0';
      else
        ACC <= ACC_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_counters is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    tick       : in  std_logic;
    c1         : in  std_logic;
    c2         : in  std_logic;
    c3         : in  std_logic;
    c4         : in  std_logic;
    c5         : in  std_logic;
    c6         : in  std_logic;
    c7         : in  std_logic;
    c8         : in  std_logic;
    c9         : in  std_logic;
    cnt_en_ckt : in  std_logic;
    up_coil    : out std_logic;
    down_coil  : out std_logic;
    drum_coil  : out std_logic;
    tap0_out   : out std_logic;
    tap1_out   : out std_logic;
    tap2_out   : out std_logic;
    tap3_out   : out std_logic
  );
end entity paper_counters;

architecture rtl of paper_counters is
  signal up_coil_reg : std_logic := '0';
  signal down_coil_reg : std_logic := '0';
  signal drum_coil_reg : std_logic := '0';
  signal tap0_out_reg : std_logic := '0';
  signal tap1_out_reg : std_logic := '0';
  signal tap2_out_reg : std_logic := '0';
  signal tap3_out_reg : std_logic := '0';
  signal rung1_power : std_logic;
  signal counting_ckt : std_logic;
  signal up_Q : std_logic;
  signal up_coil_next : std_logic;
  signal down_Q : std_logic;
  signal down_coil_next : std_logic;
  signal drum_Q : std_logic;
  signal drum_TAP0 : std_logic;
  signal drum_TAP1 : std_logic;
  signal drum_TAP2 : std_logic;
  signal drum_TAP3 : std_logic;
  signal drum_coil_next : std_logic;
  signal tap0_out_next : std_logic;
  signal tap1_out_next : std_logic;
  signal tap2_out_next : std_logic;
  signal tap3_out_next : std_logic;
begin

  -- rung 1 "the paper's Figure 14", paper_counters.ladder:11
  rung1_power <= c9 or (c2 and c3 and c4);
  counting_ckt <=
      (rung1_power and c1) or ((c5 or (rung1_power and c6)) and ((c7 and c8) or (c6 and c1)));

  -- rung 2 "from zero to the preset", paper_counters.ladder:20
  up: entity work.paper_counters_UC_PV5
    port map (
      clk => clk,
      rst => rst,
      power => counting_ckt,
      EN => cnt_en_ckt,
      Q => up_Q
    );
  up_coil_next <= up_Q;

  -- rung 3 "from the preset to zero", paper_counters.ladder:23
  down: entity work.paper_counters_DC_PV5
    port map (
      clk => clk,
      rst => rst,
      power => counting_ckt,
      EN => cnt_en_ckt,
      Q => down_Q
    );
  down_coil_next <= down_Q;

  -- rung 4 "up to 2047, with four taps", paper_counters.ladder:26
  drum: entity work.paper_counters_DRUM_PV10
    port map (
      clk => clk,
      rst => rst,
      power => counting_ckt,
      EN => cnt_en_ckt,
      Q => drum_Q,
      TAP0 => drum_TAP0,
      TAP1 => drum_TAP1,
      TAP2 => drum_TAP2,
      TAP3 => drum_TAP3
    );
  drum_coil_next <= drum_Q;

  -- rung 5, paper_counters.ladder:29
  tap0_out_next <= drum_TAP0;

  -- rung 6, paper_counters.ladder:31
  tap1_out_next <= drum_TAP1;

  -- rung 7, paper_counters.ladder:33
  tap2_out_next <= drum_TAP2;

  -- rung 8, paper_counters.ladder:35
  tap3_out_next <= drum_TAP3;

  up_coil <= up_coil_reg;
  down_coil <= down_coil_reg;
  drum_coil <= drum_coil_reg;
  tap0_out <= tap0_out_reg;
  tap1_out <= tap1_out_reg;
  tap2_out <= tap2_out_reg;
  tap3_out <= tap3_out_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        up_coil_reg <= '0';
        down_coil_reg <= '0';
        drum_coil_reg <= '0';
        tap0_out_reg <= '0';
        tap1_out_reg <= '0';
        tap2_out_reg <= '0';
        tap3_out_reg <= '0';
      else
        up_coil_reg <= up_coil_next;
        down_coil_reg <= down_coil_next;
        drum_coil_reg <= drum_coil_next;
        tap0_out_reg <= tap0_out_next;
        tap1_out_reg <= tap1_out_next;
        tap2_out_reg <= tap2_out_next;
        tap3_out_reg <= tap3_out_next;
      end if;
    end if;
  end process;
end architecture rtl;
