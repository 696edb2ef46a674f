// Made by hotrail 0.1.0 from conveyor_zero_speed.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 25 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module conveyor_zero_speed_TON_PT25 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q_last
);
  reg Q = 1'b0;
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~Q;
  wire [4:0] sum = ET + 5'd1;
  wire [4:0] choice = condition_2 ? sum : ET;
  wire [4:0] ET_next = condition ? choice : 5'd0;
  wire equal = ET == 5'd24;
  wire choice_2 = condition_2 ? equal : Q;
  wire Q_next = condition ? choice_2 : 1'b0;

  assign Q_last = Q;

  always @(posedge clk) begin
    if (rst) begin
      Q <= 1'b0;
      ET <= 5'd0;
      was <= 1'b0;
    end else begin
      Q <= Q_next;
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

module conveyor_zero_speed (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire stop,
  input  wire bolt,
  output wire motor,
  output wire fault
);
  reg start_before = 1'b0;
  reg fault_reg = 1'b0;
  reg motor_reg = 1'b0;

  // rung 1 "the shaft stands", conveyor_zero_speed.ladder:15
  wire fault_rung1 = fault_reg & ~(start & ~start_before);

  // rung 2, conveyor_zero_speed.ladder:17
  wire bolt_stays_Q_last;
  wire bolt_missing_Q_last;
  wire fault_next = bolt_stays_Q_last | bolt_missing_Q_last | fault_rung1;

  // rung 3 "motor", conveyor_zero_speed.ladder:19
  wire motor_next = (start & ~start_before | motor_reg) & stop & ~fault_next;

  // rung 4 "on for too long", conveyor_zero_speed.ladder:22
  wire bolt_stays_power = motor_next & bolt;
  conveyor_zero_speed_TON_PT25 bolt_stays (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(bolt_stays_power),
    .Q_last(bolt_stays_Q_last)
  );

  // rung 5 "off for too long", conveyor_zero_speed.ladder:25
  wire bolt_missing_power = motor_next & ~bolt;
  conveyor_zero_speed_TON_PT25 bolt_missing (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(bolt_missing_power),
    .Q_last(bolt_missing_Q_last)
  );

  assign motor = motor_reg;
  assign fault = fault_reg;

  always @(posedge clk) begin
    if (rst) begin
      start_before <= 1'b0;
      fault_reg <= 1'b0;
      motor_reg <= 1'b0;
    end else begin
      start_before <= start;
      fault_reg <= fault_next;
      motor_reg <= motor_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
