-- {{ view.header }}

library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

-- Connects {{ view.ports.module }} to the pins of a board.
{%- let columns = view.name_columns() %}
entity {{ view.ports.wrapper }} is
  port (
    {{ view.pad("clk", columns) }} : in  std_logic;
    {{ view.pad(view.ports.reset, columns) }} : in  std_logic
{%- for pin in view.pins %};
    {{ view.pad(pin.port, columns) }} : in  {{ pin.vhdl_type() }}
{%- endfor %}
{%- for lamp in view.lamps %};
    {{ view.pad(lamp.port, columns) }} : out {{ lamp.vhdl_type() }}
{%- endfor %}
  );
end entity {{ view.ports.wrapper }};
{%- let tick = view.tick() %}
{%- let pipe = view.reset_pipe() %}
{%- let core_reset = view.core_reset() %}

architecture rtl of {{ view.ports.wrapper }} is
  attribute async_reg : string;
  signal {{ pipe }} : std_logic_vector(1 downto 0) := {% if view.is_low() %}"00"{% else %}"11"{% endif %};
  attribute async_reg of {{ pipe }} : signal is "TRUE";
  signal {{ core_reset }} : std_logic;
{%- if let Some(counter) = view.counter %}
  signal {{ view.prescaler_name() }} : unsigned({{ counter.vhdl_high() }} downto 0) := (others => '0');
{%- endif %}
  signal {{ tick }} : std_logic;
{%- for pin in view.pins %}
  signal {{ pin.meta }} : {{ pin.vhdl_type() }} := {{ pin.vhdl_zero() }};
  signal {{ pin.sync }} : {{ pin.vhdl_type() }} := {{ pin.vhdl_zero() }};
  attribute async_reg of {{ pin.meta }} : signal is "TRUE";
  attribute async_reg of {{ pin.sync }} : signal is "TRUE";
{%- if let Some(stable) = pin.stable %}
  signal {{ stable }} : {{ pin.vhdl_type() }} := {{ pin.vhdl_zero() }};
{%- if let Some(counter) = view.debounce %}
{%- for debounce in pin.debounced %}
  signal {{ debounce.count }} : unsigned({{ counter.vhdl_high() }} downto 0) := (others => '0');
{%- endfor %}
{%- endif %}
{%- endif %}
{%- endfor %}
begin

  -- Reset: comes at once, goes in step with the clock.
{%- if view.is_low() %}
  process (clk, rst_n)
  begin
    if rst_n = '0' then
      {{ pipe }} <= "00";
    elsif rising_edge(clk) then
      {{ pipe }} <= {{ pipe }}(0) & '1';
    end if;
  end process;
{%- else %}
  process (clk, rst)
  begin
    if rst = '1' then
      {{ pipe }} <= "11";
    elsif rising_edge(clk) then
      {{ pipe }} <= {{ pipe }}(0) & '0';
    end if;
  end process;
{%- endif %}
  {{ core_reset }} <= {{ pipe }}(1);

  -- Tick: {{ view.board.tick_made() }}.
{%- match view.counter %}
{%- when Some(counter) %}
{%- let count = view.prescaler_name() %}
  {{ tick }} <= '1' when {{ count }} = {{ counter.vhdl_last() }} else '0';
  process ({{ view.vhdl_sensitivity() }})
  begin
    if rising_edge(clk) then
      if {{ tick }} = '1' then
        {{ count }} <= (others => '0');
      else
        {{ count }} <= {{ count }} + 1;
      end if;
{%- if view.is_async() %}
    end if;
    if {{ view.vhdl_is_reset() }} then
      {{ count }} <= (others => '0');
    end if;
{%- else %}
      if {{ view.vhdl_is_reset() }} then
        {{ count }} <= (others => '0');
      end if;
    end if;
{%- endif %}
  end process;
{%- when None %}
  {{ tick }} <= '1';
{%- endmatch %}
{%- if !view.pins.is_empty() %}

  -- Inputs: two flip-flops for each bit.
{%- if view.has_words() %} The bits of a word that changes may arrive in two clocks.
{%- endif %}
  process (clk)
  begin
    if rising_edge(clk) then
{%- for pin in view.pins %}
      {{ pin.meta }} <= {{ pin.port }};
      {{ pin.sync }} <= {{ pin.meta }};
{%- endfor %}
    end if;
  end process;
{%- endif %}
{%- for pin in view.pins %}
{%- if let Some(stable) = pin.stable %}

  -- A new value of {{ pin.port }} passes when it has been there for {{ view.hold() }} at least.
{%- if let Some(counter) = view.debounce %}
{%- for debounce in pin.debounced %}
{%- let bit = debounce.bit %}
{%- let stable = pin.vhdl(stable, bit) %}
{%- let sync = pin.vhdl(pin.sync, bit) %}
  process ({{ view.vhdl_sensitivity() }})
  begin
    if rising_edge(clk) then
      if {{ sync }} = {{ stable }} then
        {{ debounce.count }} <= (others => '0');
      elsif {{ tick }} = '1' then
        if {{ debounce.count }} = {{ counter.vhdl_last() }} then
          {{ stable }} <= {{ sync }};
          {{ debounce.count }} <= (others => '0');
        else
          {{ debounce.count }} <= {{ debounce.count }} + 1;
        end if;
      end if;
{%- if view.is_async() %}
    end if;
    if {{ view.vhdl_is_reset() }} then
      {{ stable }} <= '0';
      {{ debounce.count }} <= (others => '0');
    end if;
{%- else %}
      if {{ view.vhdl_is_reset() }} then
        {{ stable }} <= '0';
        {{ debounce.count }} <= (others => '0');
      end if;
    end if;
{%- endif %}
  end process;
{%- endfor %}
{%- endif %}
{%- endif %}
{%- endfor %}

  {{ view.core() }}: entity work.{{ view.ports.module }}
    port map (
      clk => clk,
      {{ view.ports.reset }} => {{ core_reset }}
{%- if view.has_tick %},
      tick => {{ tick }}
{%- endif %}
{%- if view.ports.has_scan_ports %},
      scan_start => '1'
{%- endif %}
{%- for pin in view.pins %},
      {{ pin.port }} => {{ pin.seen() }}
{%- endfor %}
{%- for lamp in view.lamps %},
      {{ lamp.port }} => {{ lamp.port }}
{%- endfor %}
    );
end architecture rtl;
