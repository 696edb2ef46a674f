// Made by hotrail 0.1.0 from part_counter.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 5 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module part_counter_TON_PT5 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [2:0] ET = 3'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire equal = ET == 3'd5;
  wire [2:0] sum = ET + {2'b0, tick & ~equal};
  wire [2:0] ET_next = condition ? sum : 3'd0;
  wire equal_2 = ET == 3'd4;

  assign Q = condition & (tick & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ET <= 3'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

// CTU: up counter
// Fitted to PV = 5.
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module part_counter_CTU_PV5 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        R,
  output wire        Q,
  output wire [14:0] CV
);
  reg [14:0] CV_reg = 15'd0;
  reg was = 1'b0;
  reg CV_at_least_5 = 1'b0;

  wire unequal = CV_reg != 15'd32767;
  wire condition = power & ~was & unequal;
  wire [14:0] sum = CV_reg + {14'b0, condition};
  wire [14:0] CV_next = R ? 15'd0 : sum;
  wire equal = CV_reg == 15'd4;
  wire choice = condition ? equal | CV_at_least_5 : CV_at_least_5;
  wire CV_at_least_5_next = ~R & choice;

  assign Q = CV_at_least_5_next;
  assign CV = CV_next;

  always @(posedge clk) begin
    if (rst) begin
      CV_reg <= 15'd0;
      was <= 1'b0;
      CV_at_least_5 <= 1'b0;
    end else begin
      CV_reg <= CV_next;
      was <= power;
      CV_at_least_5 <= CV_at_least_5_next;
    end
  end
endmodule

module part_counter (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        part_at_machine,
  input  wire        clear,
  output wire [15:0] parts,
  output wire        batch_full
);
  reg [14:0] parts_reg = 15'd0;
  reg batch_full_reg = 1'b0;

  // rung 1 "a part is one that stays for half a second", part_counter.ladder:12
  wire present_Q;
  part_counter_TON_PT5 present (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(part_at_machine),
    .Q(present_Q)
  );
  wire count_Q;
  wire [14:0] count_CV;
  part_counter_CTU_PV5 count (
    .clk(clk),
    .rst(rst),
    .power(present_Q),
    .R(clear),
    .Q(count_Q),
    .CV(count_CV)
  );
  wire batch_full_next = count_Q;

  // rung 2 "show the count", part_counter.ladder:15
  wire [15:0] parts_value = {1'b0, parts_reg};
  wire [14:0] parts_next = count_CV;

  assign parts = parts_value;
  assign batch_full = batch_full_reg;

  always @(posedge clk) begin
    if (rst) begin
      parts_reg <= 15'd0;
      batch_full_reg <= 1'b0;
    end else begin
      parts_reg <= parts_next;
      batch_full_reg <= batch_full_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
