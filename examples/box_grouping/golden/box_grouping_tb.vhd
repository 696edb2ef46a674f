-- Made by hotrail 0.1.0 from box_grouping.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

-- TOF: off-delay timer
-- Fitted to PT = 1000 ticks.
-- Example, with PT = 3:
-- IN  _##_____#__#_____
-- Q   _#####__#######__
-- ET  00001233001001233
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity box_grouping_test_TOF_PT1000 is
  port (
    clk   : in  std_logic;
    rst   : in  std_logic;
    tick  : in  std_logic;
    power : in  std_logic;
    Q     : out std_logic
  );
end entity box_grouping_test_TOF_PT1000;

architecture rtl of box_grouping_test_TOF_PT1000 is
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

entity box_grouping_test_CTUD_PV4 is
  port (
    clk     : in  std_logic;
    rst     : in  std_logic;
    power   : in  std_logic;
    CD      : in  std_logic;
    R       : in  std_logic;
    QU      : out std_logic;
    QD      : out std_logic;
    CV_last : out unsigned(15 downto 0)
  );
end entity box_grouping_test_CTUD_PV4;

architecture rtl of box_grouping_test_CTUD_PV4 is
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
  CV_last <= CV;

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

entity box_grouping_test is
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
    conveyor_3 : out std_logic;
    unloading  : out std_logic;
    boxes_CV   : out std_logic_vector(15 downto 0)
  );
end entity box_grouping_test;

architecture rtl of box_grouping_test is
  signal eye_in_before : std_logic := '0';
  signal pull_cord_before : std_logic := '0';
  signal conveyor_1_reg : std_logic := '0';
  signal unloading_reg : std_logic := '0';
  signal conveyor_2_reg : std_logic := '0';
  signal conveyor_3_reg : std_logic := '0';
  signal box_passed : std_logic;
  signal conveyor_1_next : std_logic;
  signal past_eye_Q : std_logic;
  signal boxes_QU : std_logic;
  signal boxes_QD : std_logic;
  signal boxes_CV_last : unsigned(15 downto 0);
  signal unloading_rung5 : std_logic;
  signal unloading_next : std_logic;
  signal conveyor_2_next : std_logic;
  signal conveyor_3_next : std_logic;
begin

  -- rung 1 "a box has passed the eye", box_grouping.ladder:13
  box_passed <= eye_in_before and not eye_in;

  -- rung 2 "conveyor 1: from the cord until then", box_grouping.ladder:16
  conveyor_1_next <= ((pull_cord and not pull_cord_before) or conveyor_1_reg) and not box_passed;

  -- rung 3 "a box moves on for a second after the eye", box_grouping.ladder:19
  past_eye: entity work.box_grouping_test_TOF_PT1000
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      power => eye_in,
      Q => past_eye_Q
    );

  -- rung 4 "boxes on conveyor 2: up at one eye, down at the other", box_grouping.ladder:22
  boxes: entity work.box_grouping_test_CTUD_PV4
    port map (
      clk => clk,
      rst => rst,
      power => eye_in,
      CD => eye_out,
      R => emptied,
      QU => boxes_QU,
      QD => boxes_QD,
      CV_last => boxes_CV_last
    );

  -- rung 5 "four are a group, once the last one is in its place", box_grouping.ladder:25
  unloading_rung5 <= (boxes_QU and not past_eye_Q) or unloading_reg;

  -- rung 6 "until the last one has gone", box_grouping.ladder:28
  unloading_next <= unloading_rung5 and not (boxes_QD and not eye_out);

  -- rung 7 "conveyor 2", box_grouping.ladder:31
  conveyor_2_next <= past_eye_Q or unloading_next;

  -- rung 8 "conveyor 3", box_grouping.ladder:34
  conveyor_3_next <= unloading_next;

  conveyor_1 <= conveyor_1_reg;
  conveyor_2 <= conveyor_2_reg;
  conveyor_3 <= conveyor_3_reg;
  unloading <= unloading_reg;
  boxes_CV <= std_logic_vector(boxes_CV_last);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        eye_in_before <= '0';
        pull_cord_before <= '0';
        conveyor_1_reg <= '0';
        unloading_reg <= '0';
        conveyor_2_reg <= '0';
        conveyor_3_reg <= '0';
      else
        eye_in_before <= eye_in;
        pull_cord_before <= pull_cord;
        conveyor_1_reg <= conveyor_1_next;
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

entity box_grouping_expect is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    unloading   : in  std_logic;
    conveyor_1  : in  std_logic;
    conveyor_2  : in  std_logic;
    boxes_CV    : in  std_logic_vector(15 downto 0);
    conveyor_3  : in  std_logic;
    expect_0_0  : out std_logic;
    expect_1_0  : out std_logic;
    expect_1_1  : out std_logic;
    expect_2_0  : out std_logic;
    expect_2_1  : out std_logic;
    expect_3_0  : out std_logic;
    expect_3_1  : out std_logic;
    expect_4_0  : out std_logic;
    expect_4_1  : out std_logic;
    expect_5_0  : out std_logic;
    expect_5_1  : out std_logic;
    expect_5_2  : out std_logic;
    expect_5_3  : out std_logic;
    expect_6_0  : out std_logic;
    expect_6_1  : out std_logic;
    expect_7_0  : out std_logic;
    expect_7_1  : out std_logic;
    expect_8_0  : out std_logic;
    expect_8_1  : out std_logic;
    expect_8_2  : out std_logic;
    expect_9_0  : out std_logic;
    expect_10_0 : out std_logic;
    expect_11_0 : out std_logic;
    expect_12_0 : out std_logic
  );
end entity box_grouping_expect;

architecture rtl of box_grouping_expect is
begin

  expect_0_0 <= not unloading;
  expect_1_0 <= conveyor_1;
  expect_1_1 <= not conveyor_2;
  expect_2_0 <= conveyor_1;
  expect_2_1 <= conveyor_2;
  expect_3_0 <= not conveyor_1;
  expect_3_1 <= conveyor_2;
  expect_4_0 <= conveyor_2;
  expect_4_1 <= not unloading;
  expect_5_0 <= '1' when unsigned(boxes_CV) = 4 else '0';
  expect_5_1 <= unloading;
  expect_5_2 <= conveyor_2;
  expect_5_3 <= conveyor_3;
  expect_6_0 <= '1' when unsigned(boxes_CV) = 1 else '0';
  expect_6_1 <= unloading;
  expect_7_0 <= '1' when unsigned(boxes_CV) = 0 else '0';
  expect_7_1 <= unloading;
  expect_8_0 <= not unloading;
  expect_8_1 <= not conveyor_2;
  expect_8_2 <= not conveyor_3;
  expect_9_0 <= '1' when unsigned(boxes_CV) = 1 else '0';
  expect_10_0 <= '1' when unsigned(boxes_CV) = 1 else '0';
  expect_11_0 <= '1' when unsigned(boxes_CV) = 2 else '0';
  expect_12_0 <= '1' when unsigned(boxes_CV) = 0 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity box_grouping_tb is
end entity;

architecture tests of box_grouping_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal pull_cord : std_logic := '0';
  signal eye_in : std_logic := '0';
  signal eye_out : std_logic := '0';
  signal emptied : std_logic := '0';
  signal conveyor_1 : std_logic;
  signal conveyor_2 : std_logic;
  signal conveyor_3 : std_logic;
  signal unloading : std_logic;
  signal boxes_CV : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_5_2 : std_logic;
  signal expect_5_3 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_6_1 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_7_1 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_8_2 : std_logic;
  signal expect_9_0 : std_logic;
  signal expect_10_0 : std_logic;
  signal expect_11_0 : std_logic;
  signal expect_12_0 : std_logic;

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
  core : entity work.box_grouping_test
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      pull_cord => pull_cord,
      eye_in => eye_in,
      eye_out => eye_out,
      emptied => emptied,
      conveyor_1 => conveyor_1,
      conveyor_2 => conveyor_2,
      conveyor_3 => conveyor_3,
      unloading => unloading,
      boxes_CV => boxes_CV
    );

  expectations : entity work.box_grouping_expect
    port map (
      clk => clk,
      rst => rst,
      unloading => unloading,
      conveyor_1 => conveyor_1,
      conveyor_2 => conveyor_2,
      boxes_CV => boxes_CV,
      conveyor_3 => conveyor_3,
      expect_0_0 => expect_0_0,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_5_2 => expect_5_2,
      expect_5_3 => expect_5_3,
      expect_6_0 => expect_6_0,
      expect_6_1 => expect_6_1,
      expect_7_0 => expect_7_0,
      expect_7_1 => expect_7_1,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_8_2 => expect_8_2,
      expect_9_0 => expect_9_0,
      expect_10_0 => expect_10_0,
      expect_11_0 => expect_11_0,
      expect_12_0 => expect_12_0
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
      eye_in <= '0';
      eye_out <= '0';
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
    for round in 1 to 4 loop
      wait for 1 ns; -- box_grouping.ladder:39
      if not failed and (expect_0_0) /= '1' then
        failed := true;
        print("# failed expectation 0 conducts " & image(expect_0_0)
            & " unloading=" & image(unloading));
      end if;
      pull_cord <= '1';
      scan(1, '0');
      pull_cord <= '0';
      scan(1, '0');
      wait for 1 ns; -- box_grouping.ladder:41
      if not failed and (expect_1_0 and expect_1_1) /= '1' then
        failed := true;
        print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1)
            & " conveyor_1=" & image(conveyor_1)
            & " conveyor_2=" & image(conveyor_2));
      end if;
      eye_in <= '1';
      scan(1, '0');
      wait for 1 ns; -- box_grouping.ladder:43
      if not failed and (expect_2_0 and expect_2_1) /= '1' then
        failed := true;
        print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
            & " conveyor_1=" & image(conveyor_1)
            & " conveyor_2=" & image(conveyor_2));
      end if;
      eye_in <= '0';
      scan(1, '0');
      wait for 1 ns; -- box_grouping.ladder:45
      if not failed and (expect_3_0 and expect_3_1) /= '1' then
        failed := true;
        print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1)
            & " conveyor_1=" & image(conveyor_1)
            & " conveyor_2=" & image(conveyor_2));
      end if;
      scan(999, '1');
      wait for 1 ns; -- box_grouping.ladder:47
      if not failed and (expect_4_0 and expect_4_1) /= '1' then
        failed := true;
        print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1)
            & " conveyor_2=" & image(conveyor_2)
            & " unloading=" & image(unloading));
      end if;
      scan(1, '1');
    end loop;
    wait for 1 ns; -- box_grouping.ladder:50
    if not failed and (expect_5_0 and expect_5_1 and expect_5_2 and expect_5_3) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1) & image(expect_5_2) & image(expect_5_3)
          & " boxes_CV=" & image(boxes_CV)
          & " unloading=" & image(unloading)
          & " conveyor_2=" & image(conveyor_2)
          & " conveyor_3=" & image(conveyor_3));
    end if;
    for round in 1 to 3 loop
      eye_out <= '1';
      scan(1, '0');
      eye_out <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- box_grouping.ladder:52
    if not failed and (expect_6_0 and expect_6_1) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0) & image(expect_6_1)
          & " boxes_CV=" & image(boxes_CV)
          & " unloading=" & image(unloading));
    end if;
    eye_out <= '1';
    scan(1, '0');
    wait for 1 ns; -- box_grouping.ladder:54
    if not failed and (expect_7_0 and expect_7_1) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0) & image(expect_7_1)
          & " boxes_CV=" & image(boxes_CV)
          & " unloading=" & image(unloading));
    end if;
    eye_out <= '0';
    scan(1, '0');
    wait for 1 ns; -- box_grouping.ladder:56
    if not failed and (expect_8_0 and expect_8_1 and expect_8_2) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2)
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
    eye_in <= '1';
    scan(1, '0');
    eye_in <= '0';
    scan(1, '0');
    wait for 1 ns; -- box_grouping.ladder:61
    if not failed and (expect_9_0) /= '1' then
      failed := true;
      print("# failed expectation 9 conducts " & image(expect_9_0)
          & " boxes_CV=" & image(boxes_CV));
    end if;
    eye_in <= '1';
    eye_out <= '1';
    scan(1, '0');
    wait for 1 ns; -- box_grouping.ladder:63
    if not failed and (expect_10_0) /= '1' then
      failed := true;
      print("# failed expectation 10 conducts " & image(expect_10_0)
          & " boxes_CV=" & image(boxes_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - a box that comes as one goes is counted once each way");
    else
      print("ok 2 - a box that comes as one goes is counted once each way");
    end if;

    -- a conveyor that was emptied by hand counts from nothing
    failed := false;
    reset;
    for round in 1 to 2 loop
      eye_in <= '1';
      scan(1, '0');
      eye_in <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- box_grouping.ladder:67
    if not failed and (expect_11_0) /= '1' then
      failed := true;
      print("# failed expectation 11 conducts " & image(expect_11_0)
          & " boxes_CV=" & image(boxes_CV));
    end if;
    emptied <= '1';
    scan(1, '0');
    emptied <= '0';
    scan(1, '0');
    wait for 1 ns; -- box_grouping.ladder:69
    if not failed and (expect_12_0) /= '1' then
      failed := true;
      print("# failed expectation 12 conducts " & image(expect_12_0)
          & " boxes_CV=" & image(boxes_CV));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - a conveyor that was emptied by hand counts from nothing");
    else
      print("ok 3 - a conveyor that was emptied by hand counts from nothing");
    end if;

    assert failures = 0 report integer'image(failures) & " of 3 tests failed" severity failure;
    wait;
  end process;
end architecture;
