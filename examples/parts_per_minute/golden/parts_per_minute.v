// Made by hotrail 0.1.0 from parts_per_minute.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// PT = 3
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
  reg [31:0] ET = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET) < 32'sd60;
  wire [31:0] sum = ET + {31'b0, tick & less};
  wire [31:0] ET_next = (power & was) ? sum : 32'd0;
  wire at_least = $signed(ET_next) >= 32'sd60;

  assign Q = power & at_least;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 32'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

// CTU: up counter
// PV = 2
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module parts_per_minute_CTU_PV0 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        R,
  output wire [15:0] CV
);
  reg [15:0] CV_reg = 16'd0;
  reg was = 1'b0;

  wire unequal = CV_reg != 16'd32767;
  wire [15:0] sum = CV_reg + {15'b0, power & ~was & unequal};
  wire [15:0] CV_next = R ? 16'd0 : sum;

  assign CV = CV_next;

  always @(posedge clk) begin
    if (rst) begin
      CV_reg <= 16'd0;
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
  reg [15:0] parts_reg = 16'd0;
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
  wire [15:0] count_CV;
  parts_per_minute_CTU_PV0 count (
    .clk(clk),
    .rst(rst),
    .power(count_power),
    .R(count_R),
    .CV(count_CV)
  );

  // rung 3 "the count, kept until S opens", parts_per_minute.ladder:17
  wire [15:0] parts_next = count_CV;

  assign parts = parts_reg;
  assign done = done_reg;

  always @(posedge clk) begin
    if (rst) begin
      sensor_before <= 1'b0;
      parts_reg <= 16'd0;
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
