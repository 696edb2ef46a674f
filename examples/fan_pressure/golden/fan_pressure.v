// Made by hotrail 0.1.0 from fan_pressure.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 80 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module fan_pressure_TON_PT80 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q_last
);
  reg Q = 1'b0;
  reg [6:0] ET = 7'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~Q;
  wire [6:0] sum = ET + 7'd1;
  wire [6:0] choice = condition_2 ? sum : ET;
  wire [6:0] ET_next = condition ? choice : 7'd0;
  wire equal = ET == 7'd79;
  wire choice_2 = condition_2 ? equal : Q;
  wire Q_next = condition ? choice_2 : 1'b0;

  assign Q_last = Q;

  always @(posedge clk) begin
    if (rst) begin
      Q <= 1'b0;
      ET <= 7'd0;
      was <= 1'b0;
    end else begin
      Q <= Q_next;
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

module fan_pressure (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire stop,
  input  wire low_pressure,
  output wire fan,
  output wire tripped
);
  reg start_before = 1'b0;
  reg tripped_reg = 1'b0;
  reg fan_reg = 1'b0;

  // rung 1 "low pressure at full speed", fan_pressure.ladder:12
  wire tripped_rung1 = tripped_reg & ~(start & ~start_before);

  // rung 2, fan_pressure.ladder:14
  wire up_to_speed_Q_last;
  wire tripped_next = up_to_speed_Q_last & low_pressure | tripped_rung1;

  // rung 3 "fan", fan_pressure.ladder:16
  wire fan_next = (start & ~start_before | fan_reg) & stop & ~tripped_next;
  fan_pressure_TON_PT80 up_to_speed (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(fan_next),
    .Q_last(up_to_speed_Q_last)
  );

  // rung 4 "run-up", fan_pressure.ladder:19

  assign fan = fan_reg;
  assign tripped = tripped_reg;

  always @(posedge clk) begin
    if (rst) begin
      start_before <= 1'b0;
      tripped_reg <= 1'b0;
      fan_reg <= 1'b0;
    end else begin
      start_before <= start;
      tripped_reg <= tripped_next;
      fan_reg <= fan_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
