-- {{ header }}
{%- for view in views() %}
{% for line in view.module.circuit.comment %}
--{% if !line.is_empty() %} {{ Harmless::ascii(line) }}{% endif %}
{%- endfor %}
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;

entity {{ view.module.name }} is
  port (
{%- let longest = view.port_width() %}
{%- for port in view.ports() %}
    {{ "{:<1$}"|format(port.name, longest) }} : {{ port.mode() }} {{ view.port_type(port) }}{% if !loop.last %};{% endif %}
{%- endfor %}
  );
end entity {{ view.module.name }};

architecture rtl of {{ view.module.name }} is
{%- for register in view.registers() %}
  signal {{ register.name }} : {{ register.subtype() }} := {{ register.start() }};
{%- endfor %}
{%- for wire in view.wires() %}
  signal {{ wire.name }} : {{ wire.subtype() }};
{%- endfor %}
begin
{%- for element in view.elements() %}
  {{ element.wire.name }} <= {{ element.part.inside() }};
{%- endfor %}
{%- for statement in view.statements() %}
{%- match statement %}
{%- when Statement::Section(comment) %}

  -- {{ Harmless::ascii(comment) }}
{%- when Statement::Wire(wire, value) %}
  {{ wire.name }} <={{ value }};
{%- when Statement::PortWires(_) %}
{%- when Statement::Instance { module, name, pins } %}
  {{ name }}: entity work.{{ module }}
    port map (
{%- for pin in pins %}
      {{ pin.port }} => {{ pin.to }}{% if !loop.last %},{% endif %}
{%- endfor %}
    );
{%- endmatch %}
{%- endfor %}
{%- if view.has_outputs() %}
{% endif %}
{%- for (part, value) in view.outputs() %}
  {{ part.vhdl() }} <={{ value }};
{%- endfor %}
{%- for process in view.processes() %}
{%- if view.is_async() %}

  process (clk, rst_n)
  begin
    if rst_n = '0' then
{%- for register in process.registers %}
      {{ register.name }} <= {{ register.start() }};
{%- endfor %}
    elsif rising_edge(clk) then
{%- match process.enable %}
{%- when Some(enable) %}
      if {{ enable }} = '1' then
{%- for register in process.registers %}
        {{ register.name }} <= {{ register.next }};
{%- endfor %}
      end if;
{%- when None %}
{%- for register in process.registers %}
      {{ register.name }} <= {{ register.next }};
{%- endfor %}
{%- endmatch %}
    end if;
  end process;
{%- else %}

  process (clk)
  begin
    if rising_edge(clk) then
      if {{ view.is_reset() }} then
{%- for register in process.registers %}
        {{ register.name }} <= {{ register.start() }};
{%- endfor %}
{%- match process.enable %}
{%- when Some(enable) %}
      elsif {{ enable }} = '1' then
{%- when None %}
      else
{%- endmatch %}
{%- for register in process.registers %}
        {{ register.name }} <= {{ register.next }};
{%- endfor %}
      end if;
    end if;
  end process;
{%- endif %}
{%- endfor %}
end architecture rtl;
{%- endfor %}
