-- Made by hotrail 0.1.0 from ab_timer_contacts.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- AB_TON: on-delay timer of Allen-Bradley, BASE = 10 ticks
-- Example, with PRE = 3, BASE = 1:
-- IN  _#######__###_
-- EN  _#######__###_
-- TT  _###______###_
-- DN  ____####______
-- ACC 00123333000120
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_timer_contacts_test_AB_TON_BASE10 is
  port (
    clk      : in  std_logic;
    rst      : in  std_logic;
    tick     : in  std_logic;
    power    : in  std_logic;
    PRE      : in  unsigned(15 downto 0);
    ACC_last : out unsigned(14 downto 0);
    EN       : out std_logic;
    TT       : out std_logic;
    DN       : out std_logic
  );
end entity ab_timer_contacts_test_AB_TON_BASE10;

architecture rtl of ab_timer_contacts_test_AB_TON_BASE10 is
  signal ACC : unsigned(14 downto 0) := (others => '0');
  signal DN_reg : std_logic := '0';
  signal fraction : unsigned(3 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal choice : unsigned(14 downto 0);
  signal condition : std_logic;
  signal equal : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(3 downto 0);
  signal choice_2 : unsigned(3 downto 0);
  signal unequal : std_logic;
  signal sum_2 : unsigned(14 downto 0);
  signal at_least : std_logic;
  signal DN_next : std_logic;
  signal ACC_next : unsigned(14 downto 0);
  signal fraction_next : unsigned(3 downto 0);
begin
  less <= '1' when signed(PRE) < 0 else '0';
  choice <= to_unsigned(0, 15) when less = '1' else PRE(14 downto 0);
  condition <= power and was and not DN_reg and tick;
  equal <= '1' when fraction = 9 else '0';
  condition_2 <= condition and equal;
  sum <= fraction + (to_unsigned(0, 3) & condition);
  choice_2 <= to_unsigned(0, 4) when condition_2 = '1' else sum;
  unequal <= '1' when ACC /= 32767 else '0';
  sum_2 <= ACC + (to_unsigned(0, 14) & (condition_2 and unequal));
  at_least <= '1' when sum_2 >= choice else '0';
  DN_next <= power and (DN_reg or at_least);
  ACC_next <= sum_2 when power = '1' else to_unsigned(0, 15);
  fraction_next <= choice_2 when power = '1' else to_unsigned(0, 4);

  ACC_last <= ACC;
  EN <= power;
  TT <= power and not DN_next;
  DN <= DN_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        DN_reg <= '0';
        fraction <= (others => '0');
        was <= '0';
      else
        ACC <= ACC_next;
        DN_reg <= DN_next;
        fraction <= fraction_next;
        was <= power;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_timer_contacts_test_TON is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    PT    : in  unsigned(31 downto 0);
    Q     : out std_logic
  );
end entity ab_timer_contacts_test_TON;

architecture rtl of ab_timer_contacts_test_TON is
  signal ET : unsigned(31 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal less : std_logic;
  signal sum : unsigned(31 downto 0);
  signal ET_next : unsigned(31 downto 0);
  signal at_least : std_logic;
begin
  less <= '1' when signed(ET) < signed(PT) else '0';
  sum <= ET + (to_unsigned(0, 31) & (tick and less));
  ET_next <= sum when (power and was) = '1' else to_unsigned(0, 32);
  at_least <= '1' when signed(ET_next) >= signed(PT) else '0';

  Q <= power and at_least;

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

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_timer_contacts_test is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    tick         : in  std_logic;
    run          : in  std_logic;
    slower       : in  std_logic;
    enabled      : out std_logic;
    timing       : out std_logic;
    done         : out std_logic;
    not_enabled  : out std_logic;
    not_timing   : out std_logic;
    not_done     : out std_logic;
    siemens_done : out std_logic;
    t4_0_ACC     : out std_logic_vector(15 downto 0)
  );
end entity ab_timer_contacts_test;

architecture rtl of ab_timer_contacts_test is
  signal t4_0_PRE : unsigned(6 downto 0) := to_unsigned(50, 7);
  signal preset : unsigned(12 downto 0) := to_unsigned(500, 13);
  signal enabled_reg : std_logic := '0';
  signal timing_reg : std_logic := '0';
  signal done_reg : std_logic := '0';
  signal not_enabled_reg : std_logic := '0';
  signal not_timing_reg : std_logic := '0';
  signal not_done_reg : std_logic := '0';
  signal siemens_done_reg : std_logic := '0';
  signal t4_0_PRE_2 : unsigned(15 downto 0);
  signal t4_0_ACC_last : unsigned(14 downto 0);
  signal t4_0_EN : std_logic;
  signal t4_0_TT : std_logic;
  signal t4_0_DN : std_logic;
  signal enabled_next : std_logic;
  signal timing_next : std_logic;
  signal done_next : std_logic;
  signal not_enabled_next : std_logic;
  signal not_timing_next : std_logic;
  signal not_done_next : std_logic;
  signal t1_PT : unsigned(31 downto 0);
  signal t1_Q : std_logic;
  signal siemens_done_next : std_logic;
  signal t4_0_PRE_next : unsigned(6 downto 0);
  signal preset_next : unsigned(12 downto 0);
  signal t4_0_ACC_value : unsigned(15 downto 0);
begin

  -- rung 1 "T4:0, 50 units of 10 ms", ab_timer_contacts.ladder:12
  t4_0_PRE_2 <= resize(unsigned(resize(signed(t4_0_PRE), 9)), 16);
  t4_0: entity work.ab_timer_contacts_test_AB_TON_BASE10
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => run,
      PRE => t4_0_PRE_2,
      ACC_last => t4_0_ACC_last,
      EN => t4_0_EN,
      TT => t4_0_TT,
      DN => t4_0_DN
    );

  -- rung 2 "EN", ab_timer_contacts.ladder:15
  enabled_next <= t4_0_EN;

  -- rung 3 "TT", ab_timer_contacts.ladder:18
  timing_next <= t4_0_TT;

  -- rung 4 "DN", ab_timer_contacts.ladder:21
  done_next <= t4_0_DN;

  -- rung 5, ab_timer_contacts.ladder:24
  not_enabled_next <= not t4_0_EN;

  -- rung 6, ab_timer_contacts.ladder:26
  not_timing_next <= not t4_0_TT;

  -- rung 7, ab_timer_contacts.ladder:28
  not_done_next <= not t4_0_DN;

  -- rung 8 "the same with Siemens' timer: only Q is built in", ab_timer_contacts.ladder:30
  t1_PT <= resize(preset, 32);
  t1: entity work.ab_timer_contacts_test_TON
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => run,
      PT => t1_PT,
      Q => t1_Q
    );
  siemens_done_next <= t1_Q;

  -- rung 9 "from 0.5 s to 5 s", ab_timer_contacts.ladder:33
  t4_0_PRE_next <= to_unsigned(116, 7) when slower = '1' else t4_0_PRE;
  preset_next <= to_unsigned(5000, 13) when slower = '1' else preset;
  t4_0_ACC_value <= resize(t4_0_ACC_last, 16);

  enabled <= enabled_reg;
  timing <= timing_reg;
  done <= done_reg;
  not_enabled <= not_enabled_reg;
  not_timing <= not_timing_reg;
  not_done <= not_done_reg;
  siemens_done <= siemens_done_reg;
  t4_0_ACC <= std_logic_vector(t4_0_ACC_value);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        t4_0_PRE <= to_unsigned(50, 7);
        preset <= to_unsigned(500, 13);
        enabled_reg <= '0';
        timing_reg <= '0';
        done_reg <= '0';
        not_enabled_reg <= '0';
        not_timing_reg <= '0';
        not_done_reg <= '0';
        siemens_done_reg <= '0';
      else
        t4_0_PRE <= t4_0_PRE_next;
        preset <= preset_next;
        enabled_reg <= enabled_next;
        timing_reg <= timing_next;
        done_reg <= done_next;
        not_enabled_reg <= not_enabled_next;
        not_timing_reg <= not_timing_next;
        not_done_reg <= not_done_next;
        siemens_done_reg <= siemens_done_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_timer_contacts_expect is
  port (
    clk          : in  std_logic;
    rst          : in  std_logic;
    enabled      : in  std_logic;
    timing       : in  std_logic;
    done         : in  std_logic;
    not_enabled  : in  std_logic;
    not_timing   : in  std_logic;
    not_done     : in  std_logic;
    siemens_done : in  std_logic;
    t4_0_ACC     : in  std_logic_vector(15 downto 0);
    expect_0_0   : out std_logic;
    expect_0_1   : out std_logic;
    expect_0_2   : out std_logic;
    expect_0_3   : out std_logic;
    expect_0_4   : out std_logic;
    expect_0_5   : out std_logic;
    expect_0_6   : out std_logic;
    expect_1_0   : out std_logic;
    expect_1_1   : out std_logic;
    expect_1_2   : out std_logic;
    expect_1_3   : out std_logic;
    expect_1_4   : out std_logic;
    expect_1_5   : out std_logic;
    expect_2_0   : out std_logic;
    expect_2_1   : out std_logic;
    expect_2_2   : out std_logic;
    expect_2_3   : out std_logic;
    expect_3_0   : out std_logic;
    expect_3_1   : out std_logic;
    expect_3_2   : out std_logic;
    expect_3_3   : out std_logic;
    expect_3_4   : out std_logic;
    expect_4_0   : out std_logic;
    expect_4_1   : out std_logic;
    expect_4_2   : out std_logic;
    expect_5_0   : out std_logic;
    expect_5_1   : out std_logic;
    expect_5_2   : out std_logic;
    expect_5_3   : out std_logic;
    expect_5_4   : out std_logic;
    expect_6_0   : out std_logic;
    expect_6_1   : out std_logic;
    expect_7_0   : out std_logic;
    expect_7_1   : out std_logic;
    expect_8_0   : out std_logic;
    expect_8_1   : out std_logic;
    expect_9_0   : out std_logic;
    expect_9_1   : out std_logic;
    expect_9_2   : out std_logic;
    expect_10_0  : out std_logic;
    expect_10_1  : out std_logic;
    expect_10_2  : out std_logic;
    expect_11_0  : out std_logic;
    expect_11_1  : out std_logic;
    expect_12_0  : out std_logic;
    expect_12_1  : out std_logic
  );
end entity ab_timer_contacts_expect;

architecture rtl of ab_timer_contacts_expect is
begin

  expect_0_0 <= not enabled;
  expect_0_1 <= not timing;
  expect_0_2 <= not done;
  expect_0_3 <= not_enabled;
  expect_0_4 <= not_timing;
  expect_0_5 <= not_done;
  expect_0_6 <= not siemens_done;
  expect_1_0 <= enabled;
  expect_1_1 <= timing;
  expect_1_2 <= not done;
  expect_1_3 <= not not_enabled;
  expect_1_4 <= not not_timing;
  expect_1_5 <= not_done;
  expect_2_0 <= timing;
  expect_2_1 <= not done;
  expect_2_2 <= not siemens_done;
  expect_2_3 <= '1' when unsigned(t4_0_ACC) = 49 else '0';
  expect_3_0 <= enabled;
  expect_3_1 <= not timing;
  expect_3_2 <= done;
  expect_3_3 <= siemens_done;
  expect_3_4 <= '1' when unsigned(t4_0_ACC) = 50 else '0';
  expect_4_0 <= done;
  expect_4_1 <= siemens_done;
  expect_4_2 <= '1' when unsigned(t4_0_ACC) = 50 else '0';
  expect_5_0 <= not enabled;
  expect_5_1 <= not timing;
  expect_5_2 <= not done;
  expect_5_3 <= not siemens_done;
  expect_5_4 <= '1' when unsigned(t4_0_ACC) = 0 else '0';
  expect_6_0 <= not done;
  expect_6_1 <= not siemens_done;
  expect_7_0 <= done;
  expect_7_1 <= siemens_done;
  expect_8_0 <= done;
  expect_8_1 <= siemens_done;
  expect_9_0 <= done;
  expect_9_1 <= not siemens_done;
  expect_9_2 <= '1' when unsigned(t4_0_ACC) = 50 else '0';
  expect_10_0 <= done;
  expect_10_1 <= siemens_done;
  expect_10_2 <= '1' when unsigned(t4_0_ACC) = 50 else '0';
  expect_11_0 <= not done;
  expect_11_1 <= not siemens_done;
  expect_12_0 <= done;
  expect_12_1 <= siemens_done;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity ab_timer_contacts_tb is
end entity;

architecture tests of ab_timer_contacts_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal run : std_logic := '0';
  signal slower : std_logic := '0';
  signal enabled : std_logic;
  signal timing : std_logic;
  signal done : std_logic;
  signal not_enabled : std_logic;
  signal not_timing : std_logic;
  signal not_done : std_logic;
  signal siemens_done : std_logic;
  signal t4_0_ACC : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_0_3 : std_logic;
  signal expect_0_4 : std_logic;
  signal expect_0_5 : std_logic;
  signal expect_0_6 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_1_3 : std_logic;
  signal expect_1_4 : std_logic;
  signal expect_1_5 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_2_2 : std_logic;
  signal expect_2_3 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_3_3 : std_logic;
  signal expect_3_4 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_5_3 : std_logic;
  signal expect_5_4 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_9_2 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_10_1 : std_logic;
  signal expect_10_2 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_12_1 : std_logic;

  function image(bit : std_logic) return string is
    constant quoted : string := std_logic'image(bit);
  begin
    return quoted(2 to 2);
  end function;

  function image(bits : std_logic_vector) return string is
    alias from_left : std_logic_vector(1 to bits'length) is bits;
    variable text : string(1 to bits'length);
  begin
    for index in text'range loop
      text(index to index) := image(from_left(index));
    end loop;
    return text;
  end function;

  procedure print(text : string) is
    variable buf : line;
  begin
    write(buf, text);
    writeline(output, buf);
  end procedure;
begin
  core : entity work.ab_timer_contacts_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      run => run,
      slower => slower,
      enabled => enabled,
      timing => timing,
      done => done,
      not_enabled => not_enabled,
      not_timing => not_timing,
      not_done => not_done,
      siemens_done => siemens_done,
      t4_0_ACC => t4_0_ACC
    );

  expectations : entity work.ab_timer_contacts_expect
    port map (
      clk => clk,
      rst => rst,
      enabled => enabled,
      timing => timing,
      done => done,
      not_enabled => not_enabled,
      not_timing => not_timing,
      not_done => not_done,
      siemens_done => siemens_done,
      t4_0_ACC => t4_0_ACC,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_0_3 => expect_0_3,
      expect_0_4 => expect_0_4,
      expect_0_5 => expect_0_5,
      expect_0_6 => expect_0_6,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_1_3 => expect_1_3,
      expect_1_4 => expect_1_4,
      expect_1_5 => expect_1_5,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_2_2 => expect_2_2,
      expect_2_3 => expect_2_3,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_3_3 => expect_3_3,
      expect_3_4 => expect_3_4,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_5_3 => expect_5_3,
      expect_5_4 => expect_5_4,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_9_2 => expect_9_2,
      expect_10_0 => expect_10_0,
      expect_10_1 => expect_10_1,
      expect_10_2 => expect_10_2,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_12_0 => expect_12_0,
      expect_12_1 => expect_12_1
    );

  process
    variable failed : boolean;
    variable failures : natural := 0;

    -- One clock is one scan.
    procedure scan(times : natural; with_tick : std_logic) is
    begin
      tick <= with_tick;
      for count in 1 to times loop
        wait for 5 ns;
        clk <= '1';
        wait for 5 ns;
        clk <= '0';
      end loop;
    end procedure;

    procedure reset is
    begin
      tick <= '0';
      run <= '0';
      slower <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..4");

    -- half a second
    failed := false;
    reset;
    scan(1, '0');
    wait for 1 ns; -- ab_timer_contacts.ladder:38
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2 and expect_0_3 and expect_0_4 and expect_0_5 and expect_0_6) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2) & image(expect_0_3) & image(expect_0_4) & image(expect_0_5) & image(expect_0_6)
          & " enabled=" & image(enabled)
          & " timing=" & image(timing)
          & " done=" & image(done)
          & " not_enabled=" & image(not_enabled)
          & " not_timing=" & image(not_timing)
          & " not_done=" & image(not_done)
          & " siemens_done=" & image(siemens_done));
    end if;
    run <= '1';
    scan(1, '0');
    wait for 1 ns; -- ab_timer_contacts.ladder:40
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2 and expect_1_3 and expect_1_4 and expect_1_5) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2) & image(expect_1_3) & image(expect_1_4) & image(expect_1_5)
          & " enabled=" & image(enabled)
          & " timing=" & image(timing)
          & " done=" & image(done)
          & " not_enabled=" & image(not_enabled)
          & " not_timing=" & image(not_timing)
          & " not_done=" & image(not_done));
    end if;
    scan(499, '1');
    wait for 1 ns; -- ab_timer_contacts.ladder:42
    if not failed and (expect_2_0 and expect_2_1 and expect_2_2 and expect_2_3) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1) & image(expect_2_2) & image(expect_2_3)
          & " timing=" & image(timing)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done)
          & " t4_0_ACC=" & image(t4_0_ACC));
    end if;
    scan(1, '1');
    wait for 1 ns; -- ab_timer_contacts.ladder:44
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2 and expect_3_3 and expect_3_4) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2) & image(expect_3_3) & image(expect_3_4)
          & " enabled=" & image(enabled)
          & " timing=" & image(timing)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done)
          & " t4_0_ACC=" & image(t4_0_ACC));
    end if;
    scan(1000, '1');
    wait for 1 ns; -- ab_timer_contacts.ladder:46
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done)
          & " t4_0_ACC=" & image(t4_0_ACC));
    end if;
    run <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_timer_contacts.ladder:48
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2 and expect_5_3 and expect_5_4) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2) & image(expect_5_3) & image(expect_5_4)
          & " enabled=" & image(enabled)
          & " timing=" & image(timing)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done)
          & " t4_0_ACC=" & image(t4_0_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - half a second");
    else
      print("ok 1 - half a second");
    end if;

    -- a power that is on in the first scan times like any other, on both
    failed := false;
    reset;
    run <= '1';
    scan(1, '0');
    scan(499, '1');
    wait for 1 ns; -- ab_timer_contacts.ladder:53
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done));
    end if;
    scan(1, '1');
    wait for 1 ns; -- ab_timer_contacts.ladder:55
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - a power that is on in the first scan times like any other, on both");
    else
      print("ok 2 - a power that is on in the first scan times like any other, on both");
    end if;

    -- a preset that grows: DN stays on, Siemens' Q goes off and the time goes on
    failed := false;
    reset;
    run <= '1';
    scan(1, '0');
    scan(500, '1');
    wait for 1 ns; -- ab_timer_contacts.ladder:59
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done));
    end if;
    slower <= '1';
    scan(1, '0');
    scan(1, '0');
    wait for 1 ns; -- ab_timer_contacts.ladder:62
    if not failed and (expect_9_0 and expect_9_1 and expect_9_2) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done)
          & " t4_0_ACC=" & image(t4_0_ACC));
    end if;
    scan(4500, '1');
    wait for 1 ns; -- ab_timer_contacts.ladder:64
    if not failed and (expect_10_0 and expect_10_1 and expect_10_2) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0) & image(expect_10_1) & image(expect_10_2)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done)
          & " t4_0_ACC=" & image(t4_0_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a preset that grows: DN stays on, Siemens' Q goes off and the time goes on");
    else
      print("ok 3 - a preset that grows: DN stays on, Siemens' Q goes off and the time goes on");
    end if;

    -- a preset that grows in time counts on both
    failed := false;
    reset;
    run <= '1';
    scan(1, '0');
    scan(400, '1');
    slower <= '1';
    scan(1, '0');
    scan(4599, '1');
    wait for 1 ns; -- ab_timer_contacts.ladder:70
    if not failed and (expect_11_0 and expect_11_1) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done));
    end if;
    scan(1, '1');
    wait for 1 ns; -- ab_timer_contacts.ladder:72
    if not failed and (expect_12_0 and expect_12_1) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0) & image(expect_12_1)
          & " done=" & image(done)
          & " siemens_done=" & image(siemens_done));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - a preset that grows in time counts on both");
    else
      print("ok 4 - a preset that grows in time counts on both");
    end if;

    assert failures = 0 report integer'image(failures) & " of 4 tests failed" severity failure;
    wait;
  end process;
end architecture;
