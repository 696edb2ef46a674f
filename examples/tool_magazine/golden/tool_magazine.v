// Made by hotrail 0.1.0 from tool_magazine.ladder. Do not edit: change the ladder and build again.

`default_nettype none

module tool_magazine (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire X4,
  input  wire X3,
  input  wire X2,
  input  wire X1,
  input  wire at2,
  input  wire at3,
  input  wire X15,
  input  wire X16,
  input  wire home,
  output wire turn,
  output wire Y0,
  output wire Y1,
  output wire Y2,
  output wire Y3,
  output wire Y4
);
  reg M2 = 1'b0;
  reg Y14 = 1'b0;
  reg M3 = 1'b0;
  reg M15 = 1'b0;
  reg Y0_reg = 1'b0;
  reg Y2_reg = 1'b0;
  reg Y3_reg = 1'b0;
  reg Y4_reg = 1'b0;
  reg M51 = 1'b0;
  reg X16_before = 1'b0;
  reg Y1_reg = 1'b0;
  reg turn_reg = 1'b0;

  // rung 1 "decode the command", tool_magazine.ladder:26
  wire T2 = ~X4 & ~X3 & X2 & ~X1;
  wire T3 = ~X4 & ~X3 & X2 & X1;
  wire T11 = X4 & ~X3 & X2 & X1;
  wire M51_next = X4 & X3 & ~X2 & ~X1;

  // rung 2 "call a location", tool_magazine.ladder:29
  wire M2_rung2 = T2 | M2;
  wire Y14_rung2 = T2 | Y14;
  wire M3_rung2 = M3 & ~T2;
  wire M3_rung2_2 = T3 | M3_rung2;
  wire M2_rung2_2 = M2_rung2 & ~T3;
  wire M15_rung2 = M15 & ~T3;
  wire Y14_next = Y14_rung2 & ~T11;

  // rung 3 "turn until it is reached", tool_magazine.ladder:32
  wire turn_next = M2_rung2_2 & ~at2 | M3_rung2_2 & ~at3;

  // rung 4, tool_magazine.ladder:34
  wire Y0_next = M2_rung2_2 & at2 | M3_rung2_2 & at3;

  // rung 5 "move the tool forward (paper, rung 4)", tool_magazine.ladder:36
  wire Y2_next = (Y14_next & Y0_next & ~Y0_reg | Y2_reg) & ~X15 & ~Y3_reg;

  // rung 6 "air pump (paper, rung 5)", tool_magazine.ladder:39
  wire Y4_next = (Y2_next & ~Y2_reg | Y4_reg | M51) & ~M15_rung2;

  // rung 7 "close the pump", tool_magazine.ladder:42

  // rung 8, tool_magazine.ladder:44
  wire M15_next = T11 | M15_rung2;

  // rung 9 "bring the tool back", tool_magazine.ladder:46
  wire rung9_power = M51_next & ~M51;
  wire Y3_rung9 = rung9_power | Y3_reg;
  wire M2_next = M2_rung2_2 & ~rung9_power;
  wire M3_next = M3_rung2_2 & ~rung9_power;

  // rung 10, tool_magazine.ladder:48
  wire Y3_next = Y3_rung9 & ~X16;

  // rung 11 "turn back when the tool is back", tool_magazine.ladder:50
  wire Y1_next = (X16 & ~X16_before | Y1_reg) & ~home;

  assign turn = turn_reg;
  assign Y0 = Y0_reg;
  assign Y1 = Y1_reg;
  assign Y2 = Y2_reg;
  assign Y3 = Y3_reg;
  assign Y4 = Y4_reg;

  always @(posedge clk) begin
    if (rst) begin
      M2 <= 1'b0;
      Y14 <= 1'b0;
      M3 <= 1'b0;
      M15 <= 1'b0;
      Y0_reg <= 1'b0;
      Y2_reg <= 1'b0;
      Y3_reg <= 1'b0;
      Y4_reg <= 1'b0;
      M51 <= 1'b0;
      X16_before <= 1'b0;
      Y1_reg <= 1'b0;
      turn_reg <= 1'b0;
    end else begin
      M2 <= M2_next;
      Y14 <= Y14_next;
      M3 <= M3_next;
      M15 <= M15_next;
      Y0_reg <= Y0_next;
      Y2_reg <= Y2_next;
      Y3_reg <= Y3_next;
      Y4_reg <= Y4_next;
      M51 <= M51_next;
      X16_before <= X16;
      Y1_reg <= Y1_next;
      turn_reg <= turn_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule

`default_nettype wire
