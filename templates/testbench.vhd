-- {{ bench.header }}
-- Runs the program's tests and reports in TAP, one line for each test; ends with a failure if one
-- of them fails. GHDL's --ieee-asserts=disable-at-0 keeps numeric_std quiet about the moment in which
-- signals have no value yet.

{{ bench.modules }}
library ieee;
use ieee.std_logic_1164.all;
use ieee.numeric_std.all;
use std.textio.all;

entity {{ bench.name }} is
end entity;

architecture tests of {{ bench.name }} is
  signal clk : std_logic := '0';
  signal {{ bench.reset_port }} : std_logic := '{{ bench.reset_off }}';
{%- for signal in bench.signals %}
{%- if signal.width > 1 %}
  signal {{ signal.name }} : std_logic_vector({{ signal.width - 1 }} downto 0){% if signal.is_input %} := (others => '0'){% endif %};
{%- else %}
  signal {{ signal.name }} : std_logic{% if signal.is_input %} := '0'{% endif %};
{%- endif %}
{%- endfor %}
{%- for expectation in bench.expectations %}
{%- for element in expectation.elements %}
  signal {{ element }} : std_logic;
{%- endfor %}
{%- endfor %}

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
  core : entity work.{{ bench.core.module }}
    port map (
{%- for (port, signal) in bench.core.ports %}
      {{ port }} => {{ signal }}{% if !loop.last %},{% endif %}
{%- endfor %}
    );
{% if let Some(expect) = bench.expect %}
  expectations : entity work.{{ expect.module }}
    port map (
{%- for (port, signal) in expect.ports %}
      {{ port }} => {{ signal }}{% if !loop.last %},{% endif %}
{%- endfor %}
    );
{% endif %}
  process
    variable failed : boolean;
    variable failures : natural := 0;
{%- if bench.has_scans %}
    variable is_last : std_logic;
    variable pause : natural := 0;

    procedure clock is
    begin
      wait for 5 ns;
      is_last := scan_done;
      clk <= '1';
      wait for 5 ns;
      clk <= '0';
    end procedure;

    -- A scan is over when the core says so. None to three clocks without a scan come before it.
    procedure scan(times : natural; with_tick : std_logic) is
    begin
      for count in 1 to times loop
        pause := (pause + 1) mod 4;
        for idle in 1 to pause loop
          clock;
        end loop;
        scan_start <= '1';
        tick <= with_tick;
        loop
          clock;
          scan_start <= '0';
          tick <= '0';
          exit when is_last = '1';
        end loop;
      end loop;
    end procedure;
{%- else %}

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
{%- endif %}

    procedure reset is
    begin
{%- for signal in bench.signals %}{% if signal.is_input %}
      {{ signal.name }} <= {% if signal.width > 1 %}(others => '0'){% else %}'0'{% endif %};
{%- endif %}{% endfor %}
      {{ bench.reset_port }} <= '{{ bench.reset_on }}';
      {% if bench.has_scans %}clock{% else %}scan(1, '0'){% endif %};
      {{ bench.reset_port }} <= '{{ bench.reset_off }}';
    end procedure;
  begin
    print("1..{{ bench.tests }}");
{%- for line in bench.lines %}
{%- match line.kind %}
{%- when LineKind::Start with (title) %}

    -- {{ title }}
    failed := false;
{%- when LineKind::End with (number, title) %}
    if failed then
      failures := failures + 1;
      print("not ok {{ number }} - {{ title }}");
    else
      print("ok {{ number }} - {{ title }}");
    end if;
{%- when LineKind::Drive with (signal, width, bits) %}
    {{ line.indent }}{{ signal }} <= {% if *width > 1 %}"{{ lines::binary(bits, width) }}"{% else %}'{{ bits }}'{% endif %};
{%- when LineKind::Scan with (times, with_tick) %}
    {{ line.indent }}scan({{ times }}, '{{ with_tick }}');
{%- when LineKind::Repeat with (times, counter) %}
    {{ line.indent }}for {{ counter }} in 1 to {{ times }} loop
{%- when LineKind::EndRepeat %}
    {{ line.indent }}end loop;
{%- when LineKind::Reset %}
    {{ line.indent }}reset;
{%- when LineKind::Expect with (index, place, values) %}
    {{ line.indent }}wait for 1 ns; -- {{ place }}
    {{ line.indent }}if not failed and ({% for element in bench.expectations[*index].elements %}{{ element }}{% if !loop.last %} and {% endif %}{% endfor %}) /= '1' then
    {{ line.indent }}  failed := true;
    {{ line.indent }}  print("{{ FAILED }}{{ index }} conducts "{% for element in bench.expectations[*index].elements %} & image({{ element }}){% endfor %}{% for value in values %}
    {{ line.indent }}      & " {{ value.label }}=" & image({{ value.text }}){% endfor %});
    {{ line.indent }}end if;
{%- endmatch %}
{%- endfor %}

    assert failures = 0 report integer'image(failures) & " of {{ bench.tests }} tests failed" severity failure;
    wait;
  end process;
end architecture;
