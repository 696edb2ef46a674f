// Made by hotrail 0.1.0 from box_grouping.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TOF: off-delay timer
// Fitted to PT = 1000 ticks.
// Example, with PT = 3:
// IN  _##_____#__#_____
// Q   _#####__#######__
// ET  00001233001001233
module box_grouping_TOF_PT1000 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [9:0] ET = 10'd0;
  reg run = 1'b0;
  reg was = 1'b0;

  wire [9:0] sum = ET + {9'b0, tick};
  wire equal = ET == 10'd999;
  wire [9:0] choice = was ? 10'd0 : sum;
  wire [9:0] ET_next = power ? 10'd0 : choice;
  wire run_next = power | run & ~(~was & tick & equal);

  assign Q = run_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 10'd0;
      run <= 1'b0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      run <= run_next;
      was <= power;
    end
  end
endmodule

// CTUD: up-down counter
// Fitted to PV = 4.
// Example, with PV = 2:
// IN  _#_#__#______
// CD  ____#_#_#____
// R   ___________##
// LD  __________#_#
// QU  ___#______#__
// QD  #_______##_##
// CV  0112111100200
module box_grouping_CTUD_PV4 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire CD,
  input  wire R,
  output wire QU,
  output wire QD
);
  reg [15:0] CV = 16'd0;
  reg was = 1'b0;
  reg was_down = 1'b0;

  wire condition = power & ~was;
  wire condition_2 = CD & ~was_down;
  wire unequal = CV != 16'd32767;
  wire unequal_2 = CV != 16'h8000;
  wire [1:0] choice =
      (condition_2 & ~condition & unequal_2) ? 2'd3 : {1'b0, condition & ~condition_2 & unequal};
  wire [15:0] sum = CV + {{14{choice[1]}}, choice};
  wire [15:0] CV_next = R ? 16'd0 : sum;

  assign QU = $signed(CV_next) >= 16'sd4;
  assign QD = $signed(CV_next) <= 16'sd0;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 16'd0;
      was <= 1'b0;
      was_down <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
      was_down <= CD;
    end
  end
endmodule

module box_grouping (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire pull_cord,
  input  wire eye_in,
  input  wire eye_out,
  input  wire emptied,
  output wire conveyor_1,
  output wire conveyor_2,
  output wire conveyor_3
);
  reg eye_in_before = 1'b0;
  reg pull_cord_before = 1'b0;
  reg conveyor_1_reg = 1'b0;
  reg conveyor_3_reg = 1'b0;
  reg conveyor_2_reg = 1'b0;

  // rung 1 "a box has passed the eye", box_grouping.ladder:13
  wire box_passed = eye_in_before & ~eye_in;

  // rung 2 "conveyor 1: from the cord until then", box_grouping.ladder:16
  wire conveyor_1_next = (pull_cord & ~pull_cord_before | conveyor_1_reg) & ~box_passed;

  // rung 3 "a box moves on for a second after the eye", box_grouping.ladder:19
  wire past_eye_Q;
  box_grouping_TOF_PT1000 past_eye (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(eye_in),
    .Q(past_eye_Q)
  );

  // rung 4 "boxes on conveyor 2: up at one eye, down at the other", box_grouping.ladder:22
  wire boxes_QU;
  wire boxes_QD;
  box_grouping_CTUD_PV4 boxes (
    .clk(clk),
    .rst(rst),
    .power(eye_in),
    .CD(eye_out),
    .R(emptied),
    .QU(boxes_QU),
    .QD(boxes_QD)
  );

  // rung 5 "four are a group, once the last one is in its place", box_grouping.ladder:25
  wire unloading_rung5 = boxes_QU & ~past_eye_Q | conveyor_3_reg;

  // rung 6 "until the last one has gone", box_grouping.ladder:28
  wire conveyor_3_next = unloading_rung5 & ~(boxes_QD & ~eye_out);

  // rung 7 "conveyor 2", box_grouping.ladder:31
  wire conveyor_2_next = past_eye_Q | conveyor_3_next;

  // rung 8 "conveyor 3", box_grouping.ladder:34

  assign conveyor_1 = conveyor_1_reg;
  assign conveyor_2 = conveyor_2_reg;
  assign conveyor_3 = conveyor_3_reg;

  always @(posedge clk) begin
    if (rst) begin
      eye_in_before <= 1'b0;
      pull_cord_before <= 1'b0;
      conveyor_1_reg <= 1'b0;
      conveyor_3_reg <= 1'b0;
      conveyor_2_reg <= 1'b0;
    end else begin
      eye_in_before <= eye_in;
      pull_cord_before <= pull_cord;
      conveyor_1_reg <= conveyor_1_next;
      conveyor_3_reg <= conveyor_3_next;
      conveyor_2_reg <= conveyor_2_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
