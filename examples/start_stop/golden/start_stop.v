// Made by hotrail 0.1.0 from start_stop.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 5000 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module start_stop_TON_PT5000 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [12:0] ET = 13'd0;
  reg was = 1'b0;
  reg ET_is_5000 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_5000;
  wire [12:0] sum = ET + 13'd1;
  wire [12:0] choice = condition_2 ? sum : ET;
  wire [12:0] ET_next = condition ? choice : 13'd0;
  wire equal = ET == 13'd4999;
  wire choice_2 = condition_2 ? equal : ET_is_5000;
  wire ET_is_5000_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_5000_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 13'd0;
      was <= 1'b0;
      ET_is_5000 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_5000 <= ET_is_5000_next;
    end
  end
endmodule

module start_stop (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire stop,
  output wire motor,
  output wire lamp
);
  reg motor_reg = 1'b0;
  reg lamp_reg = 1'b0;

  // rung 1 "seal-in", start_stop.ladder:7
  wire motor_next = (start | motor_reg) & ~stop;

  // rung 2 "lamp after five seconds", start_stop.ladder:10
  wire delay_Q;
  start_stop_TON_PT5000 delay (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(motor_next),
    .Q(delay_Q)
  );
  wire lamp_next = delay_Q;

  assign motor = motor_reg;
  assign lamp = lamp_reg;

  always @(posedge clk) begin
    if (rst) begin
      motor_reg <= 1'b0;
      lamp_reg <= 1'b0;
    end else begin
      motor_reg <= motor_next;
      lamp_reg <= lamp_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
