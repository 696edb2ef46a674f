// {{ header }}

`default_nettype none
{%- for (warning, reason) in waivers() %}
{% if loop.first %}
{% endif -%}
// {{ reason }}
/* verilator lint_off {{ warning }} */
{%- endfor %}
{%- for view in views() %}
{% for line in view.module.circuit.comment %}
//{% if !line.is_empty() %} {{ Harmless::unicode(line) }}{% endif %}
{%- endfor %}
module {{ view.module.name }} (
{%- let ranges = view.range_width() %}
{%- for port in view.ports() %}
  {{ port.direction() }} wire {{ port.padded_range(ranges) }}{{ port.name }}{% if !loop.last %},{% endif %}
{%- endfor %}
);
{%- for register in view.registers() %}
  reg {{ register.range() }}{{ register.name }} = {{ register.start() }};
{%- endfor %}
{%- for element in view.elements() %}
  wire {{ element.wire.range() }}{{ element.wire.name }} = {{ element.part.verilog() }};
{%- endfor %}
{%- if view.begins_plain() && view.has_registers() %}
{% endif %}
{%- for statement in view.statements() %}
{%- match statement %}
{%- when Statement::Section(comment) %}

  // {{ Harmless::unicode(comment) }}
{%- when Statement::Wire(wire, value) %}
  wire {{ wire.range() }}{{ wire.name }} ={{ value }};
{%- when Statement::PortWires(wires) %}
{%- for wire in wires %}
  wire {{ wire.range() }}{{ wire.name }};
{%- endfor %}
{%- when Statement::Instance { module, name, pins } %}
  {{ module }} {{ name }} (
{%- for pin in pins %}
    .{{ pin.port }}({{ pin.to }}){% if !loop.last %},{% endif %}
{%- endfor %}
  );
{%- endmatch %}
{%- endfor %}
{%- if view.has_outputs() %}
{% endif %}
{%- for (part, value) in view.outputs() %}
  assign {{ part.verilog() }} ={{ value }};
{%- endfor %}
{%- for process in view.processes() %}

  always @({{ view.edges() }}) begin
    if ({{ view.is_reset() }}) begin
{%- for register in process.registers %}
      {{ register.name }} <= {{ register.start() }};
{%- endfor %}
    end else{% if let Some(enable) = process.enable %} if ({{ enable }}){% endif %} begin
{%- for register in process.registers %}
      {{ register.name }} <= {{ register.next }};
{%- endfor %}
    end
  end
{%- endfor %}
{%- if let Some(unread) = view.unread() %}

  // What the program does not read.
  {{ unread }}
{%- endif %}
endmodule
{%- endfor %}
{%- for (warning, _) in waivers() %}
/* verilator lint_on {{ warning }} */
{%- endfor %}

`default_nettype wire
