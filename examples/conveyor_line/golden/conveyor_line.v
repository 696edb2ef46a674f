// Made by hotrail 0.1.0 from conveyor_line.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TONR: retentive on-delay timer
// Fitted to PT = 100 ticks.
// Example, with PT = 3:
// IN  _##_###____######
// R   _________#___#___
// Q   ______###_______#
// ET  00111233300010123
module conveyor_line_TONR_PT100 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  input  wire R,
  output wire Q_last
);
  reg Q = 1'b0;
  reg [6:0] ET = 7'd0;
  reg was = 1'b0;
  reg ET_is_100 = 1'b0;

  wire condition = power & was & tick & ~ET_is_100;
  wire [6:0] sum = ET + 7'd1;
  wire [6:0] choice = condition ? sum : ET;
  wire [6:0] ET_next = R ? 7'd0 : choice;
  wire equal = ET == 7'd99;
  wire choice_2 = condition ? equal : ET_is_100;
  wire ET_is_100_next = R ? 1'b0 : choice_2;
  wire Q_next = ~R & ET_is_100_next;

  assign Q_last = Q;

  always @(posedge clk) begin
    if (rst) begin
      Q <= 1'b0;
      ET <= 7'd0;
      was <= 1'b0;
      ET_is_100 <= 1'b0;
    end else begin
      Q <= Q_next;
      ET <= ET_next;
      was <= power;
      ET_is_100 <= ET_is_100_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 40 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module conveyor_line_TON_PT40 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [5:0] ET = 6'd0;
  reg was = 1'b0;
  reg ET_is_40 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_40;
  wire [5:0] sum = ET + 6'd1;
  wire [5:0] choice = condition_2 ? sum : ET;
  wire [5:0] ET_next = condition ? choice : 6'd0;
  wire equal = ET == 6'd39;
  wire choice_2 = condition_2 ? equal : ET_is_40;
  wire ET_is_40_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_40_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 6'd0;
      was <= 1'b0;
      ET_is_40 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_40 <= ET_is_40_next;
    end
  end
endmodule

module conveyor_line (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire reset_faults,
  input  wire stop,
  input  wire L1,
  input  wire L2,
  input  wire L3,
  input  wire L4,
  input  wire P1,
  input  wire P2,
  input  wire P3,
  output wire C1,
  output wire C2,
  output wire C3,
  output wire fault_1,
  output wire fault_2,
  output wire fault_3
);
  reg start_before = 1'b0;
  reg on_u = 1'b0;
  reg filling = 1'b0;
  reg fault_3_reg = 1'b0;
  reg fault_2_reg = 1'b0;
  reg fault_1_reg = 1'b0;
  reg reset_faults_before = 1'b0;
  reg C1_reg = 1'b0;
  reg C2_reg = 1'b0;
  reg C3_reg = 1'b0;

  // rung 1 "switch the line on and off", conveyor_line.ladder:22
  wire on_next = (start & ~start_before | on_u) & stop;

  // rung 2 "fill from the low level to the high one", conveyor_line.ladder:25
  wire filling_next = (L2 | filling) & L1 & on_next;

  // rung 3 "conveyors, from the bin upwards", conveyor_line.ladder:28
  wire empty_2_Q_last;
  wire empty_3_Q_last;
  wire C3_next = (filling_next | ~empty_2_Q_last | ~empty_3_Q_last) & on_next & ~fault_3_reg;

  // rung 4, conveyor_line.ladder:30
  wire C2_next = (filling_next | ~empty_2_Q_last) & on_next & P3 & L4 & ~fault_2_reg;
  conveyor_line_TONR_PT100 empty_3 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(C3_next),
    .R(C2_next),
    .Q_last(empty_3_Q_last)
  );

  // rung 5, conveyor_line.ladder:31
  wire C1_next = filling_next & P2 & L3 & ~fault_1_reg;
  conveyor_line_TONR_PT100 empty_2 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(C2_next),
    .R(C1_next),
    .Q_last(empty_2_Q_last)
  );

  // rung 6 "a conveyor is empty when it has run for 10 s since the one above it", conveyor_line.ladder:33

  // rung 7, conveyor_line.ladder:35

  // rung 8 "faults", conveyor_line.ladder:37
  wire rung8_power = reset_faults & ~reset_faults_before;
  wire fault_1_rung8 = fault_1_reg & ~rung8_power;
  wire fault_2_rung8 = fault_2_reg & ~rung8_power;
  wire fault_3_rung8 = fault_3_reg & ~rung8_power;

  // rung 9, conveyor_line.ladder:39
  wire late_1_power = C1_next & ~P1;
  wire late_1_Q;
  conveyor_line_TON_PT40 late_1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(late_1_power),
    .Q(late_1_Q)
  );
  wire fault_1_next = late_1_Q | fault_1_rung8;

  // rung 10, conveyor_line.ladder:40
  wire late_2_power = C2_next & ~P2;
  wire late_2_Q;
  conveyor_line_TON_PT40 late_2 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(late_2_power),
    .Q(late_2_Q)
  );
  wire fault_2_next = late_2_Q | fault_2_rung8;

  // rung 11, conveyor_line.ladder:41
  wire late_3_power = C3_next & ~P3;
  wire late_3_Q;
  conveyor_line_TON_PT40 late_3 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(late_3_power),
    .Q(late_3_Q)
  );
  wire fault_3_next = late_3_Q | fault_3_rung8;

  assign C1 = C1_reg;
  assign C2 = C2_reg;
  assign C3 = C3_reg;
  assign fault_1 = fault_1_reg;
  assign fault_2 = fault_2_reg;
  assign fault_3 = fault_3_reg;

  always @(posedge clk) begin
    if (rst) begin
      start_before <= 1'b0;
      on_u <= 1'b0;
      filling <= 1'b0;
      fault_3_reg <= 1'b0;
      fault_2_reg <= 1'b0;
      fault_1_reg <= 1'b0;
      reset_faults_before <= 1'b0;
      C1_reg <= 1'b0;
      C2_reg <= 1'b0;
      C3_reg <= 1'b0;
    end else begin
      start_before <= start;
      on_u <= on_next;
      filling <= filling_next;
      fault_3_reg <= fault_3_next;
      fault_2_reg <= fault_2_next;
      fault_1_reg <= fault_1_next;
      reset_faults_before <= reset_faults;
      C1_reg <= C1_next;
      C2_reg <= C2_next;
      C3_reg <= C3_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
