-- Makes a pulse, one scan long, of every so many ticks.
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use work.lp.all;

entity lp_divider is
  generic (
    TICKS : natural := 100              -- 0: no pulses
  );
  port (
    clk        : in  std_logic;
    rst        : in  std_logic;
    start_scan : in  std_logic;
    tick       : in  std_logic;
    pulse      : out std_logic
  );
end entity;

architecture rtl of lp_divider is
  signal count : unsigned(bits_below(TICKS) - 1 downto 0);
  signal last  : std_logic;
begin
  last <= bit_of(TICKS /= 0 and count = at_least_one(TICKS) - 1);

  process (clk)
  begin
    if rising_edge(clk) then
      if rst = '1' then
        count <= (others => '0');
        pulse <= '0';
      elsif start_scan = '1' then
        pulse <= tick and last;
        if tick = '1' then
          if last = '1' then
            count <= (others => '0');
          else
            count <= count + 1;
          end if;
        end if;
      end if;
    end if;
  end process;
end architecture;
