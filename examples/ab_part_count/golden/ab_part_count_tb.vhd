-- Made by hotrail 0.1.0 from ab_part_count.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- AB_TON: on-delay timer of Allen-Bradley, BASE = 1 tick, SIZE = DINT
-- Fitted to PRE = 500.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_test_AB_TON_BASE1_DINT_PRE500 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    DN    : out std_logic
  );
end entity ab_part_count_test_AB_TON_BASE1_DINT_PRE500;

architecture rtl of ab_part_count_test_AB_TON_BASE1_DINT_PRE500 is
  signal ACC : unsigned(8 downto 0) := (others => '0');
  signal DN_reg : std_logic := '0';
  signal was : std_logic := '0';
  signal condition : std_logic;
  signal equal : std_logic;
  signal sum : unsigned(8 downto 0);
  signal equal_2 : std_logic;
  signal DN_next : std_logic;
  signal ACC_next : unsigned(8 downto 0);
begin
  condition <= power and was and not DN_reg and tick;
  equal <= '1' when ACC = 500 else '0';
  sum <= ACC + (to_unsigned(0, 8) & (condition and not equal));
  equal_2 <= '1' when ACC = 499 else '0';
  DN_next <= power and (DN_reg or (condition and equal_2) or equal);
  ACC_next <= sum when power = '1' else to_unsigned(0, 9);

  DN <= DN_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
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

-- AB_CTU: up counter of Allen-Bradley, SIZE = DINT
-- Fitted to PRE = 1000.
-- Example, with PRE = 5, ACC = 32766:
-- IN        _#_#
-- DN        ####
-- OV        ____
-- ACC-32760 6778
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_test_AB_CTU_DINT_PRE1000 is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    power       : in  std_logic;
    clear_after : in  std_logic;
    ACC_last    : out unsigned(31 downto 0);
    DN          : out std_logic
  );
end entity ab_part_count_test_AB_CTU_DINT_PRE1000;

architecture rtl of ab_part_count_test_AB_CTU_DINT_PRE1000 is
  signal ACC : unsigned(31 downto 0) := (others => '0');
  signal was_up : std_logic := '1';
  signal sum : unsigned(31 downto 0);
  signal ACC_next : unsigned(31 downto 0);
  signal was_up_next : std_logic;
begin
  sum <= ACC + (to_unsigned(0, 31) & (power and not was_up));
  ACC_next <= to_unsigned(0, 32) when clear_after = '1' else sum;
  was_up_next <= not clear_after and power;

  ACC_last <= ACC;
  DN <= '1' when signed(sum) >= 1000 else '0';

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ACC <= (others => '0');
        was_up <= '1';
      else
        ACC <= ACC_next;
        was_up <= was_up_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- TON: on-delay timer
-- Fitted to PT = 500 ticks.
-- Example, with PT = 3:
-- IN  _#######__###__##_
-- Q   ____####__________
-- ET  001233330001200010
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_test_TON_PT500 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity ab_part_count_test_TON_PT500;

architecture rtl of ab_part_count_test_TON_PT500 is
  signal ET : unsigned(8 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal ET_is_500 : std_logic := '0';
  signal condition : std_logic;
  signal condition_2 : std_logic;
  signal sum : unsigned(8 downto 0);
  signal choice : unsigned(8 downto 0);
  signal ET_next : unsigned(8 downto 0);
  signal equal : std_logic;
  signal choice_2 : std_logic;
  signal ET_is_500_next : std_logic;
begin
  condition <= power and was;
  condition_2 <= tick and not ET_is_500;
  sum <= ET + 1;
  choice <= sum when condition_2 = '1' else ET;
  ET_next <= choice when condition = '1' else to_unsigned(0, 9);
  equal <= '1' when ET = 499 else '0';
  choice_2 <= equal when condition_2 = '1' else ET_is_500;
  ET_is_500_next <= choice_2 when condition = '1' else '0';

  Q <= ET_is_500_next;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        ET <= (others => '0');
        was <= '0';
        ET_is_500 <= '0';
      else
        ET <= ET_next;
        was <= power;
        ET_is_500 <= ET_is_500_next;
      end if;
    end if;
  end process;
end architecture rtl;

-- CTU: up counter
-- Fitted to PV = 1000.
-- Example, with PV = 2:
-- IN  _#_##_#_#__#_#_
-- R   _________##____
-- Q   ___######____##
-- CV  011222334001122
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_test_CTU_PV1000 is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    power   : in  std_logic;
    R       : in  std_logic;
    Q       : out std_logic;
    CV_last : out unsigned(14 downto 0)
  );
end entity ab_part_count_test_CTU_PV1000;

architecture rtl of ab_part_count_test_CTU_PV1000 is
  signal CV : unsigned(14 downto 0) := (others => '0');
  signal was : std_logic := '0';
  signal CV_at_least_1000 : std_logic := '0';
  signal unequal : std_logic;
  signal condition : std_logic;
  signal sum : unsigned(14 downto 0);
  signal CV_next : unsigned(14 downto 0);
  signal equal : std_logic;
  signal choice : std_logic;
  signal CV_at_least_1000_next : std_logic;
begin
  unequal <= '1' when CV /= 32767 else '0';
  condition <= power and not was and unequal;
  sum <= CV + (to_unsigned(0, 14) & condition);
  CV_next <= to_unsigned(0, 15) when R = '1' else sum;
  equal <= '1' when CV = 999 else '0';
  choice <= equal or CV_at_least_1000 when condition = '1' else CV_at_least_1000;
  CV_at_least_1000_next <= not R and choice;

  Q <= CV_at_least_1000_next;
  CV_last <= CV;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        CV <= (others => '0');
        was <= '0';
        CV_at_least_1000 <= '0';
      else
        CV <= CV_next;
        was <= power;
        CV_at_least_1000 <= CV_at_least_1000_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_test is
  port (
    clk                 : in  std_logic;
    rst                 : in  std_logic;
    tick                : in  std_logic;
    pump_run            : in  std_logic;
    part_present        : in  std_logic;
    clear               : in  std_logic;
    pump_on_for_a_while : out std_logic;
    batch_done          : out std_logic;
    siemens_pump        : out std_logic;
    siemens_batch       : out std_logic;
    part_count_ACC      : out std_logic_vector(31 downto 0);
    db2_CV              : out std_logic_vector(15 downto 0)
  );
end entity ab_part_count_test;

architecture rtl of ab_part_count_test is
  signal pump_on_for_a_while_reg : std_logic := '0';
  signal batch_done_reg : std_logic := '0';
  signal siemens_pump_reg : std_logic := '0';
  signal siemens_batch_reg : std_logic := '0';
  signal delay_tmr_DN : std_logic;
  signal pump_on_for_a_while_next : std_logic;
  signal part_count_ACC_last : unsigned(31 downto 0);
  signal part_count_DN : std_logic;
  signal batch_done_next : std_logic;
  signal db1_Q : std_logic;
  signal siemens_pump_next : std_logic;
  signal db2_Q : std_logic;
  signal db2_CV_last : unsigned(14 downto 0);
  signal db2_CV_value : unsigned(15 downto 0);
  signal siemens_batch_next : std_logic;
begin

  -- rung 1 "Delay_Tmr", ab_part_count.ladder:8
  delay_tmr: entity work.ab_part_count_test_AB_TON_BASE1_DINT_PRE500
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pump_run,
      DN => delay_tmr_DN
    );

  -- rung 2, ab_part_count.ladder:11
  pump_on_for_a_while_next <= delay_tmr_DN;

  -- rung 3 "Part_Count", ab_part_count.ladder:13
  part_count: entity work.ab_part_count_test_AB_CTU_DINT_PRE1000
    port map (
      clk => clk,
      rst => rst,
      power => part_present,
      clear_after => clear,
      ACC_last => part_count_ACC_last,
      DN => part_count_DN
    );

  -- rung 4, ab_part_count.ladder:16
  batch_done_next <= part_count_DN;

  -- rung 5, ab_part_count.ladder:18

  -- rung 6 "DB1", ab_part_count.ladder:20
  db1: entity work.ab_part_count_test_TON_PT500
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => pump_run,
      Q => db1_Q
    );
  siemens_pump_next <= db1_Q;

  -- rung 7 "DB2", ab_part_count.ladder:23
  db2: entity work.ab_part_count_test_CTU_PV1000
    port map (
      clk => clk,
      rst => rst,
      power => part_present,
      R => clear,
      Q => db2_Q,
      CV_last => db2_CV_last
    );
  db2_CV_value <= resize(db2_CV_last, 16);
  siemens_batch_next <= db2_Q;

  pump_on_for_a_while <= pump_on_for_a_while_reg;
  batch_done <= batch_done_reg;
  siemens_pump <= siemens_pump_reg;
  siemens_batch <= siemens_batch_reg;
  part_count_ACC <= std_logic_vector(part_count_ACC_last);
  db2_CV <= std_logic_vector(db2_CV_value);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        pump_on_for_a_while_reg <= '0';
        batch_done_reg <= '0';
        siemens_pump_reg <= '0';
        siemens_batch_reg <= '0';
      else
        pump_on_for_a_while_reg <= pump_on_for_a_while_next;
        batch_done_reg <= batch_done_next;
        siemens_pump_reg <= siemens_pump_next;
        siemens_batch_reg <= siemens_batch_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_part_count_expect is
  port (
    clk                 : in  std_logic;
    rst                 : in  std_logic;
    pump_on_for_a_while : in  std_logic;
    siemens_pump        : in  std_logic;
    batch_done          : in  std_logic;
    siemens_batch       : in  std_logic;
    part_count_ACC      : in  std_logic_vector(31 downto 0);
    db2_CV              : in  std_logic_vector(15 downto 0);
    expect_0_0          : out std_logic;
    expect_0_1          : out std_logic;
    expect_1_0          : out std_logic;
    expect_1_1          : out std_logic;
    expect_2_0          : out std_logic;
    expect_2_1          : out std_logic;
    expect_3_0          : out std_logic;
    expect_3_1          : out std_logic;
    expect_4_0          : out std_logic;
    expect_4_1          : out std_logic;
    expect_4_2          : out std_logic;
    expect_4_3          : out std_logic;
    expect_5_0          : out std_logic;
    expect_5_1          : out std_logic
  );
end entity ab_part_count_expect;

architecture rtl of ab_part_count_expect is
begin

  expect_0_0 <= not pump_on_for_a_while;
  expect_0_1 <= not siemens_pump;
  expect_1_0 <= pump_on_for_a_while;
  expect_1_1 <= siemens_pump;
  expect_2_0 <= not pump_on_for_a_while;
  expect_2_1 <= not siemens_pump;
  expect_3_0 <= not batch_done;
  expect_3_1 <= not siemens_batch;
  expect_4_0 <= batch_done;
  expect_4_1 <= siemens_batch;
  expect_4_2 <= '1' when unsigned(part_count_ACC) = 1000 else '0';
  expect_4_3 <= '1' when unsigned(db2_CV) = 1000 else '0';
  expect_5_0 <= not batch_done;
  expect_5_1 <= not siemens_batch;
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity ab_part_count_tb is
end entity;

architecture tests of ab_part_count_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal pump_run : std_logic := '0';
  signal part_present : std_logic := '0';
  signal clear : std_logic := '0';
  signal pump_on_for_a_while : std_logic;
  signal batch_done : std_logic;
  signal siemens_pump : std_logic;
  signal siemens_batch : std_logic;
  signal part_count_ACC : std_logic_vector(31 downto 0);
  signal db2_CV : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_4_3 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;

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
  core : entity work.ab_part_count_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      pump_run => pump_run,
      part_present => part_present,
      clear => clear,
      pump_on_for_a_while => pump_on_for_a_while,
      batch_done => batch_done,
      siemens_pump => siemens_pump,
      siemens_batch => siemens_batch,
      part_count_ACC => part_count_ACC,
      db2_CV => db2_CV
    );

  expectations : entity work.ab_part_count_expect
    port map (
      clk => clk,
      rst => rst,
      pump_on_for_a_while => pump_on_for_a_while,
      siemens_pump => siemens_pump,
      batch_done => batch_done,
      siemens_batch => siemens_batch,
      part_count_ACC => part_count_ACC,
      db2_CV => db2_CV,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_4_3 => expect_4_3,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1
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
      pump_run <= '0';
      part_present <= '0';
      clear <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..2");

    -- 500 ms
    failed := false;
    reset;
    pump_run <= '1';
    scan(1, '0');
    scan(499, '1');
    wait for 1 ns; -- ab_part_count.ladder:29
    if not failed and (expect_0_0 and expect_0_1) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1)
          & " pump_on_for_a_while=" & image(pump_on_for_a_while)
          & " siemens_pump=" & image(siemens_pump));
    end if;
    scan(1, '1');
    wait for 1 ns; -- ab_part_count.ladder:31
    if not failed and (expect_1_0 and expect_1_1) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
          & " pump_on_for_a_while=" & image(pump_on_for_a_while)
          & " siemens_pump=" & image(siemens_pump));
    end if;
    pump_run <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_part_count.ladder:33
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " pump_on_for_a_while=" & image(pump_on_for_a_while)
          & " siemens_pump=" & image(siemens_pump));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - 500 ms");
    else
      print("ok 1 - 500 ms");
    end if;

    -- 1000 parts
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 999 loop
      part_present <= '1';
      scan(1, '0');
      part_present <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- ab_part_count.ladder:38
    if not failed and (expect_3_0 and expect_3_1) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
          & " batch_done=" & image(batch_done)
          & " siemens_batch=" & image(siemens_batch));
    end if;
    part_present <= '1';
    scan(1, '0');
    part_present <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_part_count.ladder:40
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2 and expect_4_3) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2) & image(expect_4_3)
          & " batch_done=" & image(batch_done)
          & " siemens_batch=" & image(siemens_batch)
          & " part_count_ACC=" & image(part_count_ACC)
          & " db2_CV=" & image(db2_CV));
    end if;
    clear <= '1';
    scan(1, '0');
    clear <= '0';
    scan(1, '0');
    scan(1, '0');
    wait for 1 ns; -- ab_part_count.ladder:43
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " batch_done=" & image(batch_done)
          & " siemens_batch=" & image(siemens_batch));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - 1000 parts");
    else
      print("ok 2 - 1000 parts");
    end if;

    assert failures = 0 report integer'image(failures) & " of 2 tests failed" severity failure;
    wait;
  end process;
end architecture;
