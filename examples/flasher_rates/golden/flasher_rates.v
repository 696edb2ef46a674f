// Made by hotrail 0.1.0 from flasher_rates.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module flasher_rates_TON (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [31:0] PT,
  input  wire        clear_after,
  output wire        Q,
  output wire [31:0] ET
);
  reg [31:0] ET_reg = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET_reg) < $signed(PT);
  wire [31:0] sum = ET_reg + {31'b0, tick & less};
  wire [31:0] ET_value = (power & was) ? sum : 32'd0;
  wire at_least = $signed(ET_value) >= $signed(PT);
  wire [31:0] ET_next = clear_after ? 32'd0 : ET_value;

  assign Q = power & at_least;
  assign ET = ET_value;

  always @(posedge clk) begin
    if (rst) begin
      ET_reg <= 32'd0;
      was <= 1'b0;
    end else begin
      ET_reg <= ET_next;
      was <= power;
    end
  end
endmodule

module flasher_rates (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire enable,
  input  wire slow,
  output wire lamp
);
  reg [4:0] on_time = 5'd0;
  reg [5:0] cycle_PT = 6'd0;
  reg lamp_reg = 1'b0;

  // rung 1 "rate", flasher_rates.ladder:12
  wire rung1_power = ~slow;
  wire [4:0] on_time_rung1 = rung1_power ? 5'd13 : on_time;
  wire [5:0] cycle_PT_rung1 = rung1_power ? 6'd25 : cycle_PT;
  wire [4:0] on_time_next = slow ? 5'd25 : on_time_rung1;
  wire [5:0] cycle_PT_next = slow ? 6'd42 : cycle_PT_rung1;
  wire [31:0] cycle_PT_2 = {26'b0, cycle_PT_next};

  // rung 2 "one cycle after the other", flasher_rates.ladder:17
  wire cycle_Q;
  wire [31:0] cycle_ET;
  flasher_rates_TON cycle (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(enable),
    .PT(cycle_PT_2),
    .clear_after(cycle_Q),
    .Q(cycle_Q),
    .ET(cycle_ET)
  );
  wire [31:0] rung2_choice = cycle_Q ? 32'd0 : cycle_ET;

  // rung 3 "lit in its first part", flasher_rates.ladder:20
  wire rung3_less = $signed(rung2_choice) < $signed({27'b0, on_time_next});
  wire lamp_next = enable & rung3_less;

  assign lamp = lamp_reg;

  always @(posedge clk) begin
    if (rst) begin
      on_time <= 5'd0;
      cycle_PT <= 6'd0;
      lamp_reg <= 1'b0;
    end else begin
      on_time <= on_time_next;
      cycle_PT <= cycle_PT_next;
      lamp_reg <= lamp_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
