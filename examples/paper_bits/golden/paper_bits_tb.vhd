-- Made by hotrail 0.1.0 from paper_bits.ladder. Do not edit: change the ladder and build again.
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity paper_bits_expect is
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    bc_coil    : in  std_logic;
    bs_coil    : in  std_logic;
    bitset_r   : in  std_logic_vector(15 downto 0);
    expect_0_0 : out std_logic;
    expect_0_1 : out std_logic;
    expect_0_2 : out std_logic;
    expect_1_0 : out std_logic;
    expect_1_1 : out std_logic;
    expect_1_2 : out std_logic;
    expect_2_0 : out std_logic;
    expect_2_1 : out std_logic;
    expect_3_0 : out std_logic;
    expect_3_1 : out std_logic;
    expect_3_2 : out std_logic;
    expect_4_0 : out std_logic;
    expect_4_1 : out std_logic;
    expect_4_2 : out std_logic;
    expect_5_0 : out std_logic;
    expect_5_1 : out std_logic;
    expect_6_0 : out std_logic;
    expect_7_0 : out std_logic;
    expect_8_0 : out std_logic;
    expect_8_1 : out std_logic;
    expect_8_2 : out std_logic
  );
end entity paper_bits_expect;

architecture rtl of paper_bits_expect is
begin

  expect_0_0 <= not bc_coil;
  expect_0_1 <= bs_coil;
  expect_0_2 <= '1' when unsigned(bitset_r) = 4080 else '0';
  expect_1_0 <= bc_coil;
  expect_1_1 <= not bs_coil;
  expect_1_2 <= '1' when unsigned(bitset_r) = 3952 else '0';
  expect_2_0 <= bc_coil;
  expect_2_1 <= '1' when unsigned(bitset_r) = 3952 else '0';
  expect_3_0 <= bc_coil;
  expect_3_1 <= not bs_coil;
  expect_3_2 <= '1' when unsigned(bitset_r) = 3952 else '0';
  expect_4_0 <= bs_coil;
  expect_4_1 <= not bc_coil;
  expect_4_2 <= '1' when unsigned(bitset_r) = 4080 else '0';
  expect_5_0 <= bs_coil;
  expect_5_1 <= '1' when unsigned(bitset_r) = 4080 else '0';
  expect_6_0 <= '1' when unsigned(bitset_r) = 4080 else '0';
  expect_7_0 <= '1' when unsigned(bitset_r) = 3952 else '0';
  expect_8_0 <= bs_coil;
  expect_8_1 <= not bc_coil;
  expect_8_2 <= '1' when unsigned(bitset_r) = 4080 else '0';
end architecture rtl;


library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity paper_bits_tb is
end entity;

architecture tests of paper_bits_tb is
  signal clk : std_logic := '0';
  signal rst : std_logic := '0';
  signal tick : std_logic := '0';
  signal bc_ckt : std_logic := '0';
  signal bs_ckt : std_logic := '0';
  signal bc_coil : std_logic;
  signal bs_coil : std_logic;
  signal bitset_r : std_logic_vector(15 downto 0);
  signal expect_0_0 : std_logic;
  signal expect_0_1 : std_logic;
  signal expect_0_2 : std_logic;
  signal expect_1_0 : std_logic;
  signal expect_1_1 : std_logic;
  signal expect_1_2 : std_logic;
  signal expect_2_0 : std_logic;
  signal expect_2_1 : std_logic;
  signal expect_3_0 : std_logic;
  signal expect_3_1 : std_logic;
  signal expect_3_2 : std_logic;
  signal expect_4_0 : std_logic;
  signal expect_4_1 : std_logic;
  signal expect_4_2 : std_logic;
  signal expect_5_0 : std_logic;
  signal expect_5_1 : std_logic;
  signal expect_6_0 : std_logic;
  signal expect_7_0 : std_logic;
  signal expect_8_0 : std_logic;
  signal expect_8_1 : std_logic;
  signal expect_8_2 : std_logic;

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
  core : entity work.paper_bits
    port map (
      clk => clk,
      rst => rst,
      tick => tick,
      bc_ckt => bc_ckt,
      bs_ckt => bs_ckt,
      bc_coil => bc_coil,
      bs_coil => bs_coil,
      bitset_r => bitset_r
    );

  expectations : entity work.paper_bits_expect
    port map (
      clk => clk,
      rst => rst,
      bc_coil => bc_coil,
      bs_coil => bs_coil,
      bitset_r => bitset_r,
      expect_0_0 => expect_0_0,
      expect_0_1 => expect_0_1,
      expect_0_2 => expect_0_2,
      expect_1_0 => expect_1_0,
      expect_1_1 => expect_1_1,
      expect_1_2 => expect_1_2,
      expect_2_0 => expect_2_0,
      expect_2_1 => expect_2_1,
      expect_3_0 => expect_3_0,
      expect_3_1 => expect_3_1,
      expect_3_2 => expect_3_2,
      expect_4_0 => expect_4_0,
      expect_4_1 => expect_4_1,
      expect_4_2 => expect_4_2,
      expect_5_0 => expect_5_0,
      expect_5_1 => expect_5_1,
      expect_6_0 => expect_6_0,
      expect_7_0 => expect_7_0,
      expect_8_0 => expect_8_0,
      expect_8_1 => expect_8_1,
      expect_8_2 => expect_8_2
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
      bc_ckt <= '0';
      bs_ckt <= '0';
      rst <= '1';
      scan(1, '0');
      rst <= '0';
    end procedure;
  begin
    print("1..4");

    -- bit clear: one bit goes off and stays off, the others stay
    failed := false;
    reset;
    scan(1, '0');
    wait for 1 ns; -- paper_bits.ladder:22
    if not failed and (expect_0_0 and expect_0_1 and expect_0_2) /= '1' then
      failed := true;
      print("# failed expectation 0 conducts " & image(expect_0_0) & image(expect_0_1) & image(expect_0_2)
          & " bc_coil=" & image(bc_coil)
          & " bs_coil=" & image(bs_coil)
          & " bitset_r=" & image(bitset_r));
    end if;
    bc_ckt <= '1';
    scan(1, '0');
    wait for 1 ns; -- paper_bits.ladder:24
    if not failed and (expect_1_0 and expect_1_1 and expect_1_2) /= '1' then
      failed := true;
      print("# failed expectation 1 conducts " & image(expect_1_0) & image(expect_1_1) & image(expect_1_2)
          & " bc_coil=" & image(bc_coil)
          & " bs_coil=" & image(bs_coil)
          & " bitset_r=" & image(bitset_r));
    end if;
    bc_ckt <= '0';
    scan(3, '0');
    wait for 1 ns; -- paper_bits.ladder:26
    if not failed and (expect_2_0 and expect_2_1) /= '1' then
      failed := true;
      print("# failed expectation 2 conducts " & image(expect_2_0) & image(expect_2_1)
          & " bc_coil=" & image(bc_coil)
          & " bitset_r=" & image(bitset_r));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 1 - bit clear: one bit goes off and stays off, the others stay");
    else
      print("ok 1 - bit clear: one bit goes off and stays off, the others stay");
    end if;

    -- bit set: it comes on again and stays on
    failed := false;
    reset;
    bc_ckt <= '1';
    scan(1, '0');
    bc_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_bits.ladder:30
    if not failed and (expect_3_0 and expect_3_1 and expect_3_2) /= '1' then
      failed := true;
      print("# failed expectation 3 conducts " & image(expect_3_0) & image(expect_3_1) & image(expect_3_2)
          & " bc_coil=" & image(bc_coil)
          & " bs_coil=" & image(bs_coil)
          & " bitset_r=" & image(bitset_r));
    end if;
    bs_ckt <= '1';
    scan(1, '0');
    wait for 1 ns; -- paper_bits.ladder:32
    if not failed and (expect_4_0 and expect_4_1 and expect_4_2) /= '1' then
      failed := true;
      print("# failed expectation 4 conducts " & image(expect_4_0) & image(expect_4_1) & image(expect_4_2)
          & " bs_coil=" & image(bs_coil)
          & " bc_coil=" & image(bc_coil)
          & " bitset_r=" & image(bitset_r));
    end if;
    bs_ckt <= '0';
    scan(3, '0');
    wait for 1 ns; -- paper_bits.ladder:34
    if not failed and (expect_5_0 and expect_5_1) /= '1' then
      failed := true;
      print("# failed expectation 5 conducts " & image(expect_5_0) & image(expect_5_1)
          & " bs_coil=" & image(bs_coil)
          & " bitset_r=" & image(bitset_r));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 2 - bit set: it comes on again and stays on");
    else
      print("ok 2 - bit set: it comes on again and stays on");
    end if;

    -- clearing a bit that is off and setting one that is on change nothing
    failed := false;
    reset;
    bs_ckt <= '1';
    scan(1, '0');
    bs_ckt <= '0';
    scan(1, '0');
    wait for 1 ns; -- paper_bits.ladder:38
    if not failed and (expect_6_0) /= '1' then
      failed := true;
      print("# failed expectation 6 conducts " & image(expect_6_0)
          & " bitset_r=" & image(bitset_r));
    end if;
    for round in 1 to 2 loop
      bc_ckt <= '1';
      scan(1, '0');
      bc_ckt <= '0';
      scan(1, '0');
    end loop;
    wait for 1 ns; -- paper_bits.ladder:40
    if not failed and (expect_7_0) /= '1' then
      failed := true;
      print("# failed expectation 7 conducts " & image(expect_7_0)
          & " bitset_r=" & image(bitset_r));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 3 - clearing a bit that is off and setting one that is on change nothing");
    else
      print("ok 3 - clearing a bit that is off and setting one that is on change nothing");
    end if;

    -- both circuits at once: the later rung sets
    failed := false;
    reset;
    bc_ckt <= '1';
    bs_ckt <= '1';
    scan(1, '0');
    wait for 1 ns; -- paper_bits.ladder:44
    if not failed and (expect_8_0 and expect_8_1 and expect_8_2) /= '1' then
      failed := true;
      print("# failed expectation 8 conducts " & image(expect_8_0) & image(expect_8_1) & image(expect_8_2)
          & " bs_coil=" & image(bs_coil)
          & " bc_coil=" & image(bc_coil)
          & " bitset_r=" & image(bitset_r));
    end if;
    if failed then
      failures := failures + 1;
      print("not ok 4 - both circuits at once: the later rung sets");
    else
      print("ok 4 - both circuits at once: the later rung sets");
    end if;

    assert failures = 0 report integer'image(failures) & " of 4 tests failed" severity failure;
    wait;
  end process;
end architecture;
