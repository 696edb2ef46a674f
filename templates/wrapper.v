// {{ view.header }}

`default_nettype none

// Connects {{ view.ports.module }} to the pins of a board.
{%- let columns = view.range_columns() %}
module {{ view.ports.wrapper }} (
  input  wire {{ view.pad("", columns) }}clk,
  input  wire {{ view.pad("", columns) }}{{ view.ports.reset }}
{%- for pin in view.pins %},
  input  wire {{ view.pad(pin.verilog_range(), columns) }}{{ pin.port }}
{%- endfor %}
{%- for lamp in view.lamps %},
  output wire {{ view.pad(lamp.verilog_range(), columns) }}{{ lamp.port }}
{%- endfor %}
);
{%- let tick = view.tick() %}
{%- let pipe = view.reset_pipe() %}
{%- let core_reset = view.core_reset() %}
  // Reset: comes at once, goes in step with the clock.
{%- if view.is_low() %}
  (* ASYNC_REG = "TRUE" *) reg [1:0] {{ pipe }} = 2'b00;
  always @(posedge clk or negedge rst_n) begin
    if (!rst_n) {{ pipe }} <= 2'b00;
    else {{ pipe }} <= {{ "{" }}{{ pipe }}[0], 1'b1};
  end
{%- else %}
  (* ASYNC_REG = "TRUE" *) reg [1:0] {{ pipe }} = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) {{ pipe }} <= 2'b11;
    else {{ pipe }} <= {{ "{" }}{{ pipe }}[0], 1'b0};
  end
{%- endif %}
  wire {{ core_reset }} = {{ pipe }}[1];

  // Tick: {{ view.board.tick_made() }}.
{%- match view.counter %}
{%- when Some(counter) %}
{%- let count = view.prescaler_name() %}
  reg {{ counter.verilog_range() }}{{ count }} = {{ counter.verilog_zero() }};
  wire {{ tick }} = {{ count }} == {{ counter.verilog_last() }};
  always @({{ view.verilog_edges() }}) begin
    if ({{ view.verilog_is_reset() }}) {{ count }} <= {{ counter.verilog_zero() }};
    else {{ count }} <= {{ tick }} ? {{ counter.verilog_zero() }} : {{ count }} + {{ counter.verilog_one() }};
  end
{%- when None %}
  wire {{ tick }} = 1'b1;
{%- endmatch %}
{%- if !view.pins.is_empty() %}

  // Inputs: two flip-flops for each bit.
{%- if view.has_words() %} The bits of a word that changes may arrive in two clocks.
{%- endif %}
{%- endif %}
{%- for pin in view.pins %}
  (* ASYNC_REG = "TRUE" *) reg {{ pin.verilog_range() }}{{ pin.meta }} = {{ pin.verilog_zero() }};
  (* ASYNC_REG = "TRUE" *) reg {{ pin.verilog_range() }}{{ pin.sync }} = {{ pin.verilog_zero() }};
{%- endfor %}
{%- if !view.pins.is_empty() %}
  always @(posedge clk) begin
{%- for pin in view.pins %}
    {{ pin.meta }} <= {{ pin.port }};
    {{ pin.sync }} <= {{ pin.meta }};
{%- endfor %}
  end
{%- endif %}
{%- for pin in view.pins %}
{%- if let Some(stable) = pin.stable %}

  // A new value of {{ pin.port }} passes when it has been there for {{ view.hold() }} at least.
  reg {{ pin.verilog_range() }}{{ stable }} = {{ pin.verilog_zero() }};
{%- if let Some(counter) = view.debounce %}
{%- for debounce in pin.debounced %}
{%- let bit = debounce.bit %}
{%- let stable = pin.verilog(stable, bit) %}
{%- let sync = pin.verilog(pin.sync, bit) %}
  reg {{ counter.verilog_range() }}{{ debounce.count }} = {{ counter.verilog_zero() }};
  always @({{ view.verilog_edges() }}) begin
    if ({{ view.verilog_is_reset() }}) begin
      {{ stable }} <= 1'b0;
      {{ debounce.count }} <= {{ counter.verilog_zero() }};
    end else if ({{ sync }} == {{ stable }}) begin
      {{ debounce.count }} <= {{ counter.verilog_zero() }};
    end else if ({{ tick }}) begin
      if ({{ debounce.count }} == {{ counter.verilog_last() }}) begin
        {{ stable }} <= {{ sync }};
        {{ debounce.count }} <= {{ counter.verilog_zero() }};
      end else begin
        {{ debounce.count }} <= {{ debounce.count }} + {{ counter.verilog_one() }};
      end
    end
  end
{%- endfor %}
{%- endif %}
{%- endif %}
{%- endfor %}

  {{ view.ports.module }} {{ view.core() }} (
    .clk(clk),
    .{{ view.ports.reset }}({{ core_reset }})
{%- if view.has_tick %},
    .tick({{ tick }})
{%- endif %}
{%- if view.ports.has_scan_ports %},
    .scan_start(1'b1)
{%- endif %}
{%- for pin in view.pins %},
    .{{ pin.port }}({{ pin.seen() }})
{%- endfor %}
{%- for lamp in view.lamps %},
    .{{ lamp.port }}({{ lamp.port }})
{%- endfor %}
  );
endmodule

`default_nettype wire
