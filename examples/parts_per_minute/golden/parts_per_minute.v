// Made by hotrail 0.1.0 from parts_per_minute.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 60 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module parts_per_minute_TON_PT60 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [5:0] ET = 6'd0;
  reg was = 1'b0;
  reg ET_is_60 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_60;
  wire [5:0] sum = ET + 6'd1;
  wire [5:0] choice = condition_2 ? sum : ET;
  wire [5:0] ET_next = condition ? choice : 6'd0;
  wire equal = ET == 6'd59;
  wire choice_2 = condition_2 ? equal : ET_is_60;
  wire ET_is_60_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_60_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 6'd0;
      was <= 1'b0;
      ET_is_60 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_60 <= ET_is_60_next;
    end
  end
endmodule

// CTU: up counter
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module parts_per_minute_CTU (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        R,
  output wire [14:0] CV
);
  reg [14:0] CV_reg = 15'd0;
  reg was = 1'b0;

  wire unequal = CV_reg != 15'd32767;
  wire [14:0] sum = CV_reg + {14'b0, power & ~was & unequal};
  wire [14:0] CV_next = R ? 15'd0 : sum;

  assign CV = CV_next;

  always @(posedge clk) begin
    if (rst) begin
      CV_reg <= 15'd0;
      was <= 1'b0;
    end else begin
      CV_reg <= CV_next;
      was <= power;
    end
  end
endmodule

module parts_per_minute (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        sensor,
  input  wire        S,
  output wire [15:0] parts,
  output wire        done
);
  reg sensor_before = 1'b0;
  reg [14:0] parts_reg = 15'd0;
  reg done_reg = 1'b0;

  // rung 1 "the minute", parts_per_minute.ladder:11
  wire minute_Q;
  parts_per_minute_TON_PT60 minute (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(S),
    .Q(minute_Q)
  );
  wire done_next = minute_Q;

  // rung 2 "parts in it", parts_per_minute.ladder:14
  wire count_power = sensor & ~sensor_before & S & ~minute_Q;
  wire count_R = ~S;
  wire [14:0] count_CV;
  parts_per_minute_CTU count (
    .clk(clk),
    .rst(rst),
    .power(count_power),
    .R(count_R),
    .CV(count_CV)
  );

  // rung 3 "the count, kept until S opens", parts_per_minute.ladder:17
  wire [15:0] parts_value = {1'b0, parts_reg};
  wire [14:0] parts_next = count_CV;

  assign parts = parts_value;
  assign done = done_reg;

  always @(posedge clk) begin
    if (rst) begin
      sensor_before <= 1'b0;
      parts_reg <= 15'd0;
      done_reg <= 1'b0;
    end else begin
      sensor_before <= sensor;
      parts_reg <= parts_next;
      done_reg <= done_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
