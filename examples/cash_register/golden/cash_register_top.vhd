-- Made by hotrail 0.1.0 from cash_register.ladder. Do not edit: change the ladder and build again.

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects cash_register to the pins of a board.
entity cash_register_top is
  port (
    clk         : in  std_logic;
    rst         : in  std_logic;
    key_combo   : in  std_logic;
    key_double  : in  std_logic;
    key_junior  : in  std_logic;
    key_burger  : in  std_logic;
    key_fries   : in  std_logic;
    key_drink   : in  std_logic;
    cancel_last : in  std_logic;
    total_key   : in  std_logic;
    new_order   : in  std_logic;
    new_day     : in  std_logic;
    to_go       : in  std_logic;
    lamp_combo  : out std_logic;
    lamp_double : out std_logic;
    lamp_junior : out std_logic;
    lamp_burger : out std_logic;
    lamp_fries  : out std_logic;
    lamp_drink  : out std_logic;
    subtotal    : out std_logic_vector(31 downto 0);
    tax         : out std_logic_vector(31 downto 0);
    total       : out std_logic_vector(31 downto 0);
    paid        : out std_logic;
    sold        : out std_logic_vector(191 downto 0);
    profit      : out std_logic_vector(31 downto 0)
  );
end entity cash_register_top;

architecture rtl of cash_register_top is
  attribute async_reg : string;
  signal reset_pipe : std_logic_vector(1 downto 0) := "11";
  attribute async_reg of reset_pipe : signal is "TRUE";
  signal core_rst : std_logic;
  signal prescaler : unsigned(9 downto 0) := (others => '0');
  signal tick : std_logic;
  signal key_combo_meta : std_logic := '0';
  signal key_combo_sync : std_logic := '0';
  attribute async_reg of key_combo_meta : signal is "TRUE";
  attribute async_reg of key_combo_sync : signal is "TRUE";
  signal key_double_meta : std_logic := '0';
  signal key_double_sync : std_logic := '0';
  attribute async_reg of key_double_meta : signal is "TRUE";
  attribute async_reg of key_double_sync : signal is "TRUE";
  signal key_junior_meta : std_logic := '0';
  signal key_junior_sync : std_logic := '0';
  attribute async_reg of key_junior_meta : signal is "TRUE";
  attribute async_reg of key_junior_sync : signal is "TRUE";
  signal key_burger_meta : std_logic := '0';
  signal key_burger_sync : std_logic := '0';
  attribute async_reg of key_burger_meta : signal is "TRUE";
  attribute async_reg of key_burger_sync : signal is "TRUE";
  signal key_fries_meta : std_logic := '0';
  signal key_fries_sync : std_logic := '0';
  attribute async_reg of key_fries_meta : signal is "TRUE";
  attribute async_reg of key_fries_sync : signal is "TRUE";
  signal key_drink_meta : std_logic := '0';
  signal key_drink_sync : std_logic := '0';
  attribute async_reg of key_drink_meta : signal is "TRUE";
  attribute async_reg of key_drink_sync : signal is "TRUE";
  signal cancel_last_meta : std_logic := '0';
  signal cancel_last_sync : std_logic := '0';
  attribute async_reg of cancel_last_meta : signal is "TRUE";
  attribute async_reg of cancel_last_sync : signal is "TRUE";
  signal total_key_meta : std_logic := '0';
  signal total_key_sync : std_logic := '0';
  attribute async_reg of total_key_meta : signal is "TRUE";
  attribute async_reg of total_key_sync : signal is "TRUE";
  signal new_order_meta : std_logic := '0';
  signal new_order_sync : std_logic := '0';
  attribute async_reg of new_order_meta : signal is "TRUE";
  attribute async_reg of new_order_sync : signal is "TRUE";
  signal new_day_meta : std_logic := '0';
  signal new_day_sync : std_logic := '0';
  attribute async_reg of new_day_meta : signal is "TRUE";
  attribute async_reg of new_day_sync : signal is "TRUE";
  signal to_go_meta : std_logic := '0';
  signal to_go_sync : std_logic := '0';
  attribute async_reg of to_go_meta : signal is "TRUE";
  attribute async_reg of to_go_sync : signal is "TRUE";
begin

  -- Reset: comes at once, goes in step with the clock.
  process (clk, rst)
  begin
    if rst = '1' then
      reset_pipe <= "11";
    elsif rising_edge(clk) then
      reset_pipe <= reset_pipe(0) & '0';
    end if;
  end process;
  core_rst <= reset_pipe(1);

  -- Tick: every 1000 clocks of 1 MHz, wanted every 1 ms, error 0 ppm.
  tick <= '1' when prescaler = 999 else '0';
  process (clk)
  begin
    if rising_edge(clk) then
      if tick = '1' then
        prescaler <= (others => '0');
      else
        prescaler <= prescaler + 1;
      end if;
      if core_rst = '1' then
        prescaler <= (others => '0');
      end if;
    end if;
  end process;

  -- Inputs: two flip-flops for each bit.
  process (clk)
  begin
    if rising_edge(clk) then
      key_combo_meta <= key_combo;
      key_combo_sync <= key_combo_meta;
      key_double_meta <= key_double;
      key_double_sync <= key_double_meta;
      key_junior_meta <= key_junior;
      key_junior_sync <= key_junior_meta;
      key_burger_meta <= key_burger;
      key_burger_sync <= key_burger_meta;
      key_fries_meta <= key_fries;
      key_fries_sync <= key_fries_meta;
      key_drink_meta <= key_drink;
      key_drink_sync <= key_drink_meta;
      cancel_last_meta <= cancel_last;
      cancel_last_sync <= cancel_last_meta;
      total_key_meta <= total_key;
      total_key_sync <= total_key_meta;
      new_order_meta <= new_order;
      new_order_sync <= new_order_meta;
      new_day_meta <= new_day;
      new_day_sync <= new_day_meta;
      to_go_meta <= to_go;
      to_go_sync <= to_go_meta;
    end if;
  end process;

  core: entity work.cash_register
    port map (
      clk => clk,
      rst => core_rst,
      tick => tick,
      key_combo => key_combo_sync,
      key_double => key_double_sync,
      key_junior => key_junior_sync,
      key_burger => key_burger_sync,
      key_fries => key_fries_sync,
      key_drink => key_drink_sync,
      cancel_last => cancel_last_sync,
      total_key => total_key_sync,
      new_order => new_order_sync,
      new_day => new_day_sync,
      to_go => to_go_sync,
      lamp_combo => lamp_combo,
      lamp_double => lamp_double,
      lamp_junior => lamp_junior,
      lamp_burger => lamp_burger,
      lamp_fries => lamp_fries,
      lamp_drink => lamp_drink,
      subtotal => subtotal,
      tax => tax,
      total => total,
      paid => paid,
      sold => sold,
      profit => profit
    );
end architecture rtl;
