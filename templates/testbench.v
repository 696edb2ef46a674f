// {{ bench.header }}
// Runs the program's tests and reports in TAP, one line for each test.

{{ bench.modules }}
module {{ bench.name }};
  reg clk = 1'b0;
  reg {{ bench.reset_port }} = 1'b{{ bench.reset_off }};
{%- for signal in bench.signals %}
{%- if signal.is_input %}
  reg {% if signal.width > 1 %}[{{ signal.width - 1 }}:0] {% endif %}{{ signal.name }} = {{ signal.width }}'d0;
{%- else %}
  wire {% if signal.width > 1 %}[{{ signal.width - 1 }}:0] {% endif %}{{ signal.name }};
{%- endif %}
{%- endfor %}
{%- if bench.has_scans %}
  reg is_last;
  reg [1:0] pause = 2'd0;
{%- endif %}
  reg failed;
  integer failures;

  {{ bench.core.module }} core (
{%- for (port, signal) in bench.core.ports %}
    .{{ port }}({{ signal }}){% if !loop.last %},{% endif %}
{%- endfor %}
  );
{% if let Some(expect) = bench.expect %}
{%- for expectation in bench.expectations %}
{%- for element in expectation.elements %}
  wire {{ element }};
{%- endfor %}
  wire [0:{{ expectation.elements.len() - 1 }}] {{ expectation.name }} = { {%- for element in expectation.elements %}{{ element }}{% if !loop.last %}, {% endif %}{% endfor -%} };
{%- endfor %}
  {{ expect.module }} expectations (
{%- for (port, signal) in expect.ports %}
    .{{ port }}({{ signal }}){% if !loop.last %},{% endif %}
{%- endfor %}
  );
{% endif %}
{% if bench.has_scans %}
  // A scan is over when the core says so. None to three clocks without a scan come before it.
  task scan(input integer times, input with_tick);
    begin
      repeat (times) begin
        pause = pause + 2'd1;
        repeat (pause) clock;
        scan_start = 1'b1;
        tick = with_tick;
        is_last = 1'b0;
        while (!is_last) begin
          clock;
          scan_start = 1'b0;
          tick = 1'b0;
        end
      end
    end
  endtask

  task clock;
    begin
      #5 is_last = scan_done;
      clk = 1'b1;
      #5 clk = 1'b0;
    end
  endtask
{%- else %}
  // One clock is one scan.
  task scan(input integer times, input with_tick);
    begin
      tick = with_tick;
      repeat (times) begin
        #5 clk = 1'b1;
        #5 clk = 1'b0;
      end
    end
  endtask
{%- endif %}

  task reset;
    begin
{%- for signal in bench.signals %}{% if signal.is_input %}
      {{ signal.name }} = {{ signal.width }}'d0;
{%- endif %}{% endfor %}
      {{ bench.reset_port }} = 1'b{{ bench.reset_on }};
      {% if bench.has_scans %}clock{% else %}scan(1, 1'b0){% endif %};
      {{ bench.reset_port }} = 1'b{{ bench.reset_off }};
    end
  endtask

  initial begin
    failures = 0;
    $display("1..{{ bench.tests }}");
{%- for line in bench.lines %}
{%- match line.kind %}
{%- when LineKind::Start with (title) %}

    // {{ title }}
    failed = 1'b0;
{%- when LineKind::End with (number, title) %}
    if (failed) begin
      failures = failures + 1;
      $display("not ok {{ number }} - %0s", "{{ lines::verilog_string(title) }}");
    end else $display("ok {{ number }} - %0s", "{{ lines::verilog_string(title) }}");
{%- when LineKind::Drive with (signal, width, bits) %}
    {{ line.indent }}{{ signal }} = {{ width }}'d{{ bits }};
{%- when LineKind::Scan with (times, with_tick) %}
    {{ line.indent }}scan({{ times }}, 1'b{{ with_tick }});
{%- when LineKind::Repeat with (times, _) %}
    {{ line.indent }}repeat ({{ times }}) begin
{%- when LineKind::EndRepeat %}
    {{ line.indent }}end
{%- when LineKind::Reset %}
    {{ line.indent }}reset;
{%- when LineKind::Expect with (index, place, values) %}
    {{ line.indent }}#1 if (!failed && &expect_{{ index }} !== 1'b1) begin // {{ place }}
    {{ line.indent }}  failed = 1'b1;
    {{ line.indent }}  $display("{{ FAILED }}{{ index }} conducts %b{% for value in values %} {{ value.label }}=%b{% endfor %} at %0s", expect_{{ index }}{% for value in values %}, {{ value.text }}{% endfor %}, "{{ place }}");
    {{ line.indent }}end
{%- endmatch %}
{%- endfor %}

    if (failures != 0) $display("# %0d of {{ bench.tests }} tests failed", failures);
    $finish;
  end
endmodule
