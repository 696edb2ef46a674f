// Made by hotrail 0.1.0 from ab_boxes.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_TOF: off-delay timer of Allen-Bradley, BASE = 1 tick
// Fitted to PRE = 100.
// Example, with PRE = 3, BASE = 1:
// IN  _##_____#__#_____
// EN  _##_____#__#_____
// TT  ___###___##_###__
// DN  _#####__#######__
// ACC 30001233001001233
module ab_boxes_AB_TOF_BASE1_PRE100 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire TT,
  output wire DN
);
  reg [6:0] ACC = 7'd100;
  reg DN_reg = 1'b0;
  reg was = 1'b0;

  wire condition = ~power;
  wire condition_2 = condition & ~was & DN_reg & tick;
  wire [6:0] sum = ACC + {6'b0, condition_2};
  wire equal = ACC == 7'd99;
  wire [6:0] ACC_next = power ? 7'd0 : sum;
  wire DN_next = power | DN_reg & ~(condition_2 & equal);

  assign TT = condition & DN_next;
  assign DN = DN_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 7'd100;
      DN_reg <= 1'b0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      DN_reg <= DN_next;
      was <= power;
    end
  end
endmodule

// AB_CTU: up counter of Allen-Bradley
// Example, with PRE = 2:
// IN  _#_##_#_##_#
// (R) ________#___
// CU  _#_##_#__#_#
// DN  ___#####___#
// ACC 011222330112
module ab_boxes_AB_CTU (
  input  wire        power,
  input  wire [15:0] ACC_before,
  input  wire        was_up_before,
  output wire [15:0] ACC,
  output wire        was_up
);
  wire [15:0] ACC_value = ACC_before + {15'b0, power & ~was_up_before};

  assign ACC = ACC_value;
  assign was_up = power;
endmodule

// AB_CTD: down counter of Allen-Bradley
// Fitted to PRE = 4.
// Example, with PRE = 1, ACC = 2:
// IN    _#_##_#
// CD    _#_##_#
// DN    ###____
// ACC+1 3221110
module ab_boxes_AB_CTD_PRE4 (
  input  wire        power,
  input  wire [15:0] ACC_before,
  input  wire        was_down_before,
  output wire [15:0] ACC,
  output wire        DN,
  output wire        was_down
);
  wire [15:0] ACC_value = ACC_before - {15'b0, power & ~was_down_before};

  assign ACC = ACC_value;
  assign DN = $signed(ACC_value) >= 16'sd4;
  assign was_down = power;
endmodule

module ab_boxes (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire pull_cord,
  input  wire eye_1,
  input  wire eye_2,
  input  wire emptied,
  output wire conveyor_1,
  output wire conveyor_2,
  output wire conveyor_3
);
  reg power_before = 1'b0;
  reg pull_cord_before = 1'b0;
  reg conveyor_1_reg = 1'b0;
  reg [15:0] boxes_ACC_reg = 16'd0;
  reg boxes_was_up_reg = 1'b1;
  reg boxes_was_down = 1'b1;
  reg conveyor_3_reg = 1'b0;
  reg conveyor_2_reg = 1'b0;

  // rung 1 "PE_1_Timer: a box moves on for a second after the eye", ab_boxes.ladder:14
  wire pe_1_timer_TT;
  wire pe_1_timer_DN;
  ab_boxes_AB_TOF_BASE1_PRE100 pe_1_timer (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(eye_1),
    .TT(pe_1_timer_TT),
    .DN(pe_1_timer_DN)
  );

  // rung 2 "in the scan in which the delay begins", ab_boxes.ladder:17
  wire pe_1_left = pe_1_timer_TT & ~power_before;

  // rung 3 "conveyor 1: from the cord until the eye is free again", ab_boxes.ladder:20
  wire conveyor_1_next = (pull_cord & ~pull_cord_before | conveyor_1_reg) & ~pe_1_left;

  // rung 4 "boxes on conveyor 2: up at one eye", ab_boxes.ladder:23
  wire [15:0] boxes_ACC;
  wire boxes_was_up;
  ab_boxes_AB_CTU boxes (
    .power(eye_1),
    .ACC_before(boxes_ACC_reg),
    .was_up_before(boxes_was_up_reg),
    .ACC(boxes_ACC),
    .was_up(boxes_was_up)
  );

  // rung 5 "down at the other, on the same counter", ab_boxes.ladder:26
  wire [15:0] boxes_AB_CTD_ACC;
  wire boxes_AB_CTD_DN;
  wire boxes_AB_CTD_was_down;
  ab_boxes_AB_CTD_PRE4 boxes_AB_CTD (
    .power(eye_2),
    .ACC_before(boxes_ACC),
    .was_down_before(boxes_was_down),
    .ACC(boxes_AB_CTD_ACC),
    .DN(boxes_AB_CTD_DN),
    .was_down(boxes_AB_CTD_was_down)
  );

  // rung 6 "four are a group, once the last one is in its place", ab_boxes.ladder:29
  wire unloading_rung6 = boxes_AB_CTD_DN & ~pe_1_timer_DN | conveyor_3_reg;

  // rung 7 "until the last one has gone", ab_boxes.ladder:32
  wire rung7_at_most = $signed(boxes_AB_CTD_ACC) <= 16'sd0;
  wire unloading_rung7 = unloading_rung6 & ~(rung7_at_most & ~eye_2);

  // rung 8, ab_boxes.ladder:35
  wire [15:0] boxes_ACC_next = emptied ? 16'd0 : boxes_AB_CTD_ACC;
  wire boxes_was_up_next = emptied ? 1'b0 : boxes_was_up;
  wire boxes_was_down_next = emptied ? 1'b0 : boxes_AB_CTD_was_down;
  wire conveyor_3_next = emptied ? 1'b0 : unloading_rung7;

  // rung 9 "conveyor 2", ab_boxes.ladder:37
  wire conveyor_2_next = pe_1_timer_DN | conveyor_3_next;

  // rung 10 "conveyor 3", ab_boxes.ladder:40

  assign conveyor_1 = conveyor_1_reg;
  assign conveyor_2 = conveyor_2_reg;
  assign conveyor_3 = conveyor_3_reg;

  always @(posedge clk) begin
    if (rst) begin
      power_before <= 1'b0;
      pull_cord_before <= 1'b0;
      conveyor_1_reg <= 1'b0;
      boxes_ACC_reg <= 16'd0;
      boxes_was_up_reg <= 1'b1;
      boxes_was_down <= 1'b1;
      conveyor_3_reg <= 1'b0;
      conveyor_2_reg <= 1'b0;
    end else begin
      power_before <= pe_1_timer_TT;
      pull_cord_before <= pull_cord;
      conveyor_1_reg <= conveyor_1_next;
      boxes_ACC_reg <= boxes_ACC_next;
      boxes_was_up_reg <= boxes_was_up_next;
      boxes_was_down <= boxes_was_down_next;
      conveyor_3_reg <= conveyor_3_next;
      conveyor_2_reg <= conveyor_2_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
