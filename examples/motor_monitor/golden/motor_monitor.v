// Made by hotrail 0.1.0 from motor_monitor.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 100 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module motor_monitor_TON_PT100 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [6:0] ET = 7'd0;
  reg was = 1'b0;
  reg ET_is_100 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_100;
  wire [6:0] sum = ET + 7'd1;
  wire [6:0] choice = condition_2 ? sum : ET;
  wire [6:0] ET_next = condition ? choice : 7'd0;
  wire equal = ET == 7'd99;
  wire choice_2 = condition_2 ? equal : ET_is_100;
  wire ET_is_100_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_100_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 7'd0;
      was <= 1'b0;
      ET_is_100 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_100 <= ET_is_100_next;
    end
  end
endmodule

module motor_monitor (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire S1,
  input  wire turns_1,
  input  wire turns_2,
  input  wire turns_3,
  input  wire acknowledge,
  output wire fault
);
  reg acknowledge_before = 1'b0;
  reg fault_reg = 1'b0;

  // rung 1 "acknowledged", motor_monitor.ladder:12
  wire fault_rung1 = fault_reg & ~(acknowledge & ~acknowledge_before);

  // rung 2 "two of three for ten seconds", motor_monitor.ladder:15
  wire two_power = S1 & (~turns_1 & ~turns_2 | ~turns_1 & ~turns_3 | ~turns_2 & ~turns_3);
  wire two_Q;
  motor_monitor_TON_PT100 two (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(two_power),
    .Q(two_Q)
  );
  wire fault_rung2 = two_Q | fault_rung1;

  // rung 3 "all three", motor_monitor.ladder:18
  wire fault_next = S1 & ~turns_1 & ~turns_2 & ~turns_3 | fault_rung2;

  assign fault = fault_reg;

  always @(posedge clk) begin
    if (rst) begin
      acknowledge_before <= 1'b0;
      fault_reg <= 1'b0;
    end else begin
      acknowledge_before <= acknowledge;
      fault_reg <= fault_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
