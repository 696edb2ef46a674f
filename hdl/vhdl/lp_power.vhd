-- The power in hand and the two stacks: what a contact does with its attribute.
library ieee;
use ieee.std_logic_1164.all;
use work.lp.all;

entity lp_power is
  generic (
    STACK_DEPTH : positive := 4
  );
  port (
    clk          : in  std_logic;
    start_scan   : in  std_logic;       -- the next contact starts a circuit
    contact      : in  std_logic;       -- a contact is executed in this clock
    ends_circuit : in  std_logic;       -- an output or a prefix that latches power is executed
    field        : in  std_logic_vector(3 downto 0);        -- of the word: the attribute
    conducts     : in  std_logic;
    pwra         : out std_logic        -- the power at the left of the next contact
  );
end entity;

architecture rtl of lp_power is
  signal opens, up, ret        : std_logic;
  signal ended                 : std_logic;     -- the circuit before is complete: power comes from the rail
  signal power                 : std_logic;
  signal left_of_list          : std_logic;     -- top of stack 1
  signal pwrb                  : std_logic;     -- top of stack 2: the branches so far
  signal left, right, back     : std_logic;
  signal put1, take1, put2, take2, put_left : std_logic;
begin
  pwra <= power;

  opens <= bit_of(field = x"2" or field = x"5" or field = x"6" or field = x"8");
  up    <= bit_of(field = x"4" or field = x"5" or field = x"7" or field = x"8");
  ret   <= bit_of(field = x"3" or field = x"6" or field = x"7" or field = x"8");

  left  <= ended or power;
  right <= (left and conducts) or (up and pwrb);

  -- Where a list ends at the contact that opens an outer one, its power comes back through it.
  back <= up and conducts and pwrb;

  put1     <= contact and opens and not ret;
  take1    <= contact and ret and not opens;
  put_left <= left or back;
  put2     <= contact and ret;
  take2    <= contact and up;

  stack1 : entity work.lp_stack
    generic map (DEPTH => STACK_DEPTH)
    port map (clk => clk, put => put1, take => take1, put_bit => put_left, top => left_of_list);

  stack2 : entity work.lp_stack
    generic map (DEPTH => STACK_DEPTH)
    port map (clk => clk, put => put2, take => take2, put_bit => right, top => pwrb);

  process (clk)
  begin
    if rising_edge(clk) then
      if start_scan = '1' or ends_circuit = '1' then
        ended <= '1';
      elsif contact = '1' then
        ended <= '0';
      end if;
      -- A scan begins without power: an output in front of every contact sees none.
      if start_scan = '1' then
        power <= '0';
      elsif contact = '1' then
        if ret = '0' then
          power <= right;
        elsif opens = '1' then
          power <= left;
        else
          power <= left_of_list;
        end if;
      end if;
    end if;
  end process;
end architecture;
