-- Made by hotrail 0.1.0 from ab_boxes.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

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

entity ab_boxes_test_AB_TOF_BASE1_PRE100 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    TT    : out std_logic;
    DN    : out std_logic
  );
end entity ab_boxes_test_AB_TOF_BASE1_PRE100;

architecture rtl of ab_boxes_test_AB_TOF_BASE1_PRE100 is
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

entity ab_boxes_test_AB_CTU is
  port (
    power         : in  std_logic;
    ACC_before    : in  unsigned(15 downto 0);
    was_up_before : in  std_logic;
    ACC           : out unsigned(15 downto 0);
    CU            : out std_logic;
    was_up        : out std_logic
  );
end entity ab_boxes_test_AB_CTU;

architecture rtl of ab_boxes_test_AB_CTU is
  signal ACC_value : unsigned(15 downto 0);
begin
  ACC_value <= ACC_before + (to_unsigned(0, 15) & (power and not was_up_before));

  ACC <= ACC_value;
  CU <= power;
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

entity ab_boxes_test_AB_CTD_PRE4 is
  port (
    power           : in  std_logic;
    ACC_before      : in  unsigned(15 downto 0);
    was_down_before : in  std_logic;
    ACC             : out unsigned(15 downto 0);
    CD              : out std_logic;
    DN              : out std_logic;
    was_down        : out std_logic
  );
end entity ab_boxes_test_AB_CTD_PRE4;

architecture rtl of ab_boxes_test_AB_CTD_PRE4 is
  signal ACC_value : unsigned(15 downto 0);
begin
  ACC_value <= ACC_before - (to_unsigned(0, 15) & (power and not was_down_before));

  ACC <= ACC_value;
  CD <= power;
  DN <= '1' when signed(ACC_value) >= 4 else '0';
  was_down <= power;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_boxes_test is
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
    conveyor_3 : out std_logic;
    unloading  : out std_logic;
    boxes_ACC  : out std_logic_vector(15 downto 0);
    boxes_DN   : out std_logic;
    boxes_CU   : out std_logic;
    boxes_CD   : out std_logic
  );
end entity ab_boxes_test;

architecture rtl of ab_boxes_test is
  signal power_before : std_logic := '0';
  signal pull_cord_before : std_logic := '0';
  signal conveyor_1_reg : std_logic := '0';
  signal boxes_ACC_reg : unsigned(15 downto 0) := (others => '0');
  signal boxes_CU_reg : std_logic := '0';
  signal boxes_DN_reg : std_logic := '0';
  signal boxes_was_up_reg : std_logic := '1';
  signal boxes_CD_reg : std_logic := '0';
  signal boxes_was_down : std_logic := '1';
  signal unloading_reg : std_logic := '0';
  signal conveyor_2_reg : std_logic := '0';
  signal conveyor_3_reg : std_logic := '0';
  signal pe_1_timer_TT : std_logic;
  signal pe_1_timer_DN : std_logic;
  signal pe_1_left : std_logic;
  signal conveyor_1_next : std_logic;
  signal boxes_ACC_2 : unsigned(15 downto 0);
  signal boxes_CU_2 : std_logic;
  signal boxes_was_up : std_logic;
  signal boxes_AB_CTD_ACC : unsigned(15 downto 0);
  signal boxes_AB_CTD_CD : std_logic;
  signal boxes_AB_CTD_DN : std_logic;
  signal boxes_AB_CTD_was_down : std_logic;
  signal unloading_rung6 : std_logic;
  signal rung7_at_most : std_logic;
  signal unloading_rung7 : std_logic;
  signal boxes_ACC_next : unsigned(15 downto 0);
  signal boxes_CU_next : std_logic;
  signal boxes_CD_next : std_logic;
  signal boxes_DN_next : std_logic;
  signal boxes_was_up_next : std_logic;
  signal boxes_was_down_next : std_logic;
  signal unloading_next : std_logic;
  signal conveyor_2_next : std_logic;
  signal conveyor_3_next : std_logic;
begin

  -- rung 1 "PE_1_Timer: a box moves on for a second after the eye", ab_boxes.ladder:14
  pe_1_timer: entity work.ab_boxes_test_AB_TOF_BASE1_PRE100
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
  boxes: entity work.ab_boxes_test_AB_CTU
    port map (
      power => eye_1,
      ACC_before => boxes_ACC_reg,
      was_up_before => boxes_was_up_reg,
      ACC => boxes_ACC_2,
      CU => boxes_CU_2,
      was_up => boxes_was_up
    );

  -- rung 5 "down at the other, on the same counter", ab_boxes.ladder:26
  boxes_AB_CTD: entity work.ab_boxes_test_AB_CTD_PRE4
    port map (
      power => eye_2,
      ACC_before => boxes_ACC_2,
      was_down_before => boxes_was_down,
      ACC => boxes_AB_CTD_ACC,
      CD => boxes_AB_CTD_CD,
      DN => boxes_AB_CTD_DN,
      was_down => boxes_AB_CTD_was_down
    );

  -- rung 6 "four are a group, once the last one is in its place", ab_boxes.ladder:29
  unloading_rung6 <= (boxes_AB_CTD_DN and not pe_1_timer_DN) or unloading_reg;

  -- rung 7 "until the last one has gone", ab_boxes.ladder:32
  rung7_at_most <= '1' when signed(boxes_AB_CTD_ACC) <= 0 else '0';
  unloading_rung7 <= unloading_rung6 and not (rung7_at_most and not eye_2);

  -- rung 8, ab_boxes.ladder:35
  boxes_ACC_next <= to_unsigned(0, 16) when emptied = '1' else boxes_AB_CTD_ACC;
  boxes_CU_next <= '0' when emptied = '1' else boxes_CU_2;
  boxes_CD_next <= '0' when emptied = '1' else boxes_AB_CTD_CD;
  boxes_DN_next <= '0' when emptied = '1' else boxes_AB_CTD_DN;
  boxes_was_up_next <= '0' when emptied = '1' else boxes_was_up;
  boxes_was_down_next <= '0' when emptied = '1' else boxes_AB_CTD_was_down;
  unloading_next <= '0' when emptied = '1' else unloading_rung7;

  -- rung 9 "conveyor 2", ab_boxes.ladder:37
  conveyor_2_next <= pe_1_timer_DN or unloading_next;

  -- rung 10 "conveyor 3", ab_boxes.ladder:40
  conveyor_3_next <= unloading_next;

  conveyor_1 <= conveyor_1_reg;
  conveyor_2 <= conveyor_2_reg;
  conveyor_3 <= conveyor_3_reg;
  unloading <= unloading_reg;
  boxes_ACC <= std_logic_vector(boxes_ACC_reg);
  boxes_DN <= boxes_DN_reg;
  boxes_CU <= boxes_CU_reg;
  boxes_CD <= boxes_CD_reg;

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        power_before <= '0';
        pull_cord_before <= '0';
        conveyor_1_reg <= '0';
        boxes_ACC_reg <= (others => '0');
        boxes_CU_reg <= '0';
        boxes_DN_reg <= '0';
        boxes_was_up_reg <= '1';
        boxes_CD_reg <= '0';
        boxes_was_down <= '1';
        unloading_reg <= '0';
        conveyor_2_reg <= '0';
        conveyor_3_reg <= '0';
      else
        power_before <= pe_1_timer_TT;
        pull_cord_before <= pull_cord;
        conveyor_1_reg <= conveyor_1_next;
        boxes_ACC_reg <= boxes_ACC_next;
        boxes_CU_reg <= boxes_CU_next;
        boxes_DN_reg <= boxes_DN_next;
        boxes_was_up_reg <= boxes_was_up_next;
        boxes_CD_reg <= boxes_CD_next;
        boxes_was_down <= boxes_was_down_next;
        unloading_reg <= unloading_next;
        conveyor_2_reg <= conveyor_2_next;
        conveyor_3_reg <= conveyor_3_next;
      end if;
    end if;
  end process;
end architecture rtl;

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity ab_boxes_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    conveyor_1  : in  std_logic;
    conveyor_2  : in  std_logic;
    conveyor_3  : in  std_logic;
    unloading   : in  std_logic;
    boxes_ACC   : in  std_logic_vector(15 downto 0);
    boxes_DN    : in  std_logic;
    boxes_CU    : in  std_logic;
    boxes_CD    : in  std_logic;
    expect_0_0  : out std_logic;
    expect_0_1  : out std_logic;
    expect_0_2  : out std_logic;
    expect_1_0  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_6_2  : out std_logic;
    expect_6_3  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_7_2  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_9_0  : out std_logic;
    expect_9_1  : out std_logic;
    expect_9_2  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_11_1 : out std_logic;
    expect_11_2 : out std_logic;
    expect_12_0 : out std_logic;
    expect_13_0 : out std_logic
  );
end entity ab_boxes_expect;

architecture rtl of ab_boxes_expect is
begin

  expect_0_0 <= not conveyor_1;
  expect_0_1 <= not conveyor_2;
  expect_0_2 <= not conveyor_3;
  expect_1_0 <= not unloading;
  expect_2_0 <= conveyor_1;
  expect_2_1 <= not conveyor_2;
  expect_3_0 <= conveyor_1;
  expect_3_1 <= conveyor_2;
  expect_4_0 <= not conveyor_1;
  expect_4_1 <= conveyor_2;
  expect_5_0 <= conveyor_2;
  expect_5_1 <= not unloading;
  expect_6_0 <= '1' when unsigned(boxes_ACC) = 4 else '0';
  expect_6_1 <= unloading;
  expect_6_2 <= conveyor_2;
  expect_6_3 <= conveyor_3;
  expect_7_0 <= '1' when unsigned(boxes_ACC) = 1 else '0';
  expect_7_1 <= unloading;
  expect_7_2 <= not boxes_DN;
  expect_8_0 <= '1' when unsigned(boxes_ACC) = 0 else '0';
  expect_8_1 <= unloading;
  expect_9_0 <= not unloading;
  expect_9_1 <= not conveyor_2;
  expect_9_2 <= not conveyor_3;
  expect_10_0 <= '1' when unsigned(boxes_ACC) = 1 else '0';
  expect_11_0 <= '1' when unsigned(boxes_ACC) = 1 else '0';
  expect_11_1 <= boxes_CU;
  expect_11_2 <= boxes_CD;
  expect_12_0 <= '1' when unsigned(boxes_ACC) = 2 else '0';
  expect_13_0 <= '1' when unsigned(boxes_ACC) = 0 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity ab_boxes_tb is
end entity;

architecture tests of ab_boxes_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal pull_cord : std_logic := '0';
  signal eye_1 : std_logic := '0';
  signal eye_2 : std_logic := '0';
  signal emptied : std_logic := '0';
  signal conveyor_1 : std_logic;
  signal conveyor_2 : std_logic;
  signal conveyor_3 : std_logic;
  signal unloading : std_logic;
  signal boxes_ACC : std_logic_vector(15 downto 0);
  signal boxes_DN : std_logic;
  signal boxes_CU : std_logic;
  signal boxes_CD : std_logic;
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_6_2 : std_logic;
  signal expect_6_3 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_7_2 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_9_1 : std_logic;
  signal expect_9_2 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_11_1 : std_logic;
  signal expect_11_2 : std_logic;
  signal expect_12_0 : std_logic;
  signal expect_13_0 : std_logic;

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
  core : entity work.ab_boxes_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      pull_cord => pull_cord,
      eye_1 => eye_1,
      eye_2 => eye_2,
      emptied => emptied,
      conveyor_1 => conveyor_1,
      conveyor_2 => conveyor_2,
      conveyor_3 => conveyor_3,
      unloading => unloading,
      boxes_ACC => boxes_ACC,
      boxes_DN => boxes_DN,
      boxes_CU => boxes_CU,
      boxes_CD => boxes_CD
    );

  expectations : entity work.ab_boxes_expect
    port map (
      clk => clk,
      rst => rst,
      conveyor_1 => conveyor_1,
      conveyor_2 => conveyor_2,
      conveyor_3 => conveyor_3,
      unloading => unloading,
      boxes_ACC => boxes_ACC,
      boxes_DN => boxes_DN,
      boxes_CU => boxes_CU,
      boxes_CD => boxes_CD,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_6_2 => expect_6_2,
      expect_6_3 => expect_6_3,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_7_2 => expect_7_2,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_9_0 => expect_9_0,
      expect_9_1 => expect_9_1,
      expect_9_2 => expect_9_2,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_11_1 => expect_11_1,
      expect_11_2 => expect_11_2,
      expect_12_0 => expect_12_0,
      expect_13_0 => expect_13_0
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
      pull_cord <= '0';
      eye_1 <= '0';
      eye_2 <= '0';
      emptied <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..3");

    -- four boxes in, then four boxes out
    failed := false;
    reset;
    scan(1, '0');
    wait for 1 ns; -- ab_boxes.ladder:45
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " conveyor_1=" & image(conveyor_1)
          & " conveyor_2=" & image(conveyor_2)
          & " conveyor_3=" & image(conveyor_3));
    end if;
    for round in 1 to 4 loop
      wait for 1 ns; -- ab_boxes.ladder:47
      if not failed and (expect_1_0) /= '1' then
        failed := true;
        print("# failed expectation 1 conducts " & image(expect_1_0)
            & " unloading=" & image(unloading));
      end if;
      pull_cord <= '1';
      scan(1, '0');
      pull_cord <= '0';
      scan(1, '0');
      wait for 1 ns; -- ab_boxes.ladder:49
      if not failed and (expect_2_0 and expect_2_1) /= '1' then
        failed := true;
        print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
            & " conveyor_1=" & image(conveyor_1)
            & " conveyor_2=" & image(conveyor_2));
      end if;
      eye_1 <= '1';
      scan(1, '0');
      wait for 1 ns; -- ab_boxes.ladder:51
      if not failed and (expect_3_0 and expect_3_1) /= '1' then
        failed := true;
        print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
            & " conveyor_1=" & image(conveyor_1)
            & " conveyor_2=" & image(conveyor_2));
      end if;
      eye_1 <= '0';
      scan(1, '0');
      wait for 1 ns; -- ab_boxes.ladder:53
      if not failed and (expect_4_0 and expect_4_1) /= '1' then
        failed := true;
        print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
            & " conveyor_1=" & image(conveyor_1)
            & " conveyor_2=" & image(conveyor_2));
      end if;
      scan(99, '1');
      wait for 1 ns; -- ab_boxes.ladder:55
      if not failed and (expect_5_0 and expect_5_1) /= '1' then
        failed := true;
        print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
            & " conveyor_2=" & image(conveyor_2)
            & " unloading=" & image(unloading));
      end if;
      scan(1, '1');
    end loop;
    wait for 1 ns; -- ab_boxes.ladder:58
    if not failed and (expect_6_0 and expect_6_1 and expect_6_2 and expect_6_3) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1) & image(expect_6_2) & image(expect_6_3)
          & " boxes_ACC=" & image(boxes_ACC)
          & " unloading=" & image(unloading)
          & " conveyor_2=" & image(conveyor_2)
          & " conveyor_3=" & image(conveyor_3));
    end if;
    for round in 1 to 3 loop
      eye_2 <= '1';
      scan(1, '0');
      eye_2 <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- ab_boxes.ladder:60
    if not failed and (expect_7_0 and expect_7_1 and expect_7_2) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1) & image(expect_7_2)
          & " boxes_ACC=" & image(boxes_ACC)
          & " unloading=" & image(unloading)
          & " boxes_DN=" & image(boxes_DN));
    end if;
    eye_2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- ab_boxes.ladder:62
    if not failed and (expect_8_0 and expect_8_1) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1)
          & " boxes_ACC=" & image(boxes_ACC)
          & " unloading=" & image(unloading));
    end if;
    eye_2 <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_boxes.ladder:64
    if not failed and (expect_9_0 and expect_9_1 and expect_9_2) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0) & image(expect_9_1) & image(expect_9_2)
          & " unloading=" & image(unloading)
          & " conveyor_2=" & image(conveyor_2)
          & " conveyor_3=" & image(conveyor_3));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - four boxes in, then four boxes out");
    else
      print("ok 1 - four boxes in, then four boxes out");
    end if;

    -- a box that comes as one goes is counted once each way
    failed := false;
    reset;
    scan(1, '0');
    eye_1 <= '1';
    scan(1, '0');
    eye_1 <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_boxes.ladder:69
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " boxes_ACC=" & image(boxes_ACC));
    end if;
    eye_1 <= '1';
    eye_2 <= '1';
    scan(1, '0');
    wait for 1 ns; -- ab_boxes.ladder:71
    if not failed and (expect_11_0 and expect_11_1 and expect_11_2) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0) & image(expect_11_1) & image(expect_11_2)
          & " boxes_ACC=" & image(boxes_ACC)
          & " boxes_CU=" & image(boxes_CU)
          & " boxes_CD=" & image(boxes_CD));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - a box that comes as one goes is counted once each way");
    else
      print("ok 2 - a box that comes as one goes is counted once each way");
    end if;

    -- emptied by hand
    failed := false;
    reset;
    scan(1, '0');
    for round in 1 to 2 loop
      eye_1 <= '1';
      scan(1, '0');
      eye_1 <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- ab_boxes.ladder:76
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " boxes_ACC=" & image(boxes_ACC));
    end if;
    emptied <= '1';
    scan(1, '0');
    emptied <= '0';
    scan(1, '0');
    wait for 1 ns; -- ab_boxes.ladder:78
    if not failed and (expect_13_0) /= '1' then
      failed := true;
      print("# failed expectation 13 conducts " & image(expect_13_0)
          & " boxes_ACC=" & image(boxes_ACC));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - emptied by hand");
    else
      print("ok 3 - emptied by hand");
    end if;

    assert failures = 0 report integer'image(failures) & " of 3 tests failed" severity failure;
    wait;
  end process;
end architecture;
