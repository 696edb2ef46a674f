// Made by hotrail 0.1.0 from box_grouping.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TOF: off-delay timer
// Fitted to PT = 1000 ticks.
// Example, with PT = 3:
// IN  _##_____#__#_____
// Q   _#####__#######__
// ET  00001233001001233
module box_grouping_test_TOF_PT1000 (
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
module box_grouping_test_CTUD_PV4 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        CD,
  input  wire        R,
  output wire        QU,
  output wire        QD,
  output wire [15:0] CV_last
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
  assign CV_last = CV;

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

module box_grouping_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        pull_cord,
  input  wire        eye_in,
  input  wire        eye_out,
  input  wire        emptied,
  output wire        conveyor_1,
  output wire        conveyor_2,
  output wire        conveyor_3,
  output wire        unloading,
  output wire [15:0] boxes_CV
);
  reg eye_in_before = 1'b0;
  reg pull_cord_before = 1'b0;
  reg conveyor_1_reg = 1'b0;
  reg unloading_reg = 1'b0;
  reg conveyor_2_reg = 1'b0;
  reg conveyor_3_reg = 1'b0;

  // rung 1 "a box has passed the eye", box_grouping.ladder:13
  wire box_passed = eye_in_before & ~eye_in;

  // rung 2 "conveyor 1: from the cord until then", box_grouping.ladder:16
  wire conveyor_1_next = (pull_cord & ~pull_cord_before | conveyor_1_reg) & ~box_passed;

  // rung 3 "a box moves on for a second after the eye", box_grouping.ladder:19
  wire past_eye_Q;
  box_grouping_test_TOF_PT1000 past_eye (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(eye_in),
    .Q(past_eye_Q)
  );

  // rung 4 "boxes on conveyor 2: up at one eye, down at the other", box_grouping.ladder:22
  wire boxes_QU;
  wire boxes_QD;
  wire [15:0] boxes_CV_last;
  box_grouping_test_CTUD_PV4 boxes (
    .clk(clk),
    .rst(rst),
    .power(eye_in),
    .CD(eye_out),
    .R(emptied),
    .QU(boxes_QU),
    .QD(boxes_QD),
    .CV_last(boxes_CV_last)
  );

  // rung 5 "four are a group, once the last one is in its place", box_grouping.ladder:25
  wire unloading_rung5 = boxes_QU & ~past_eye_Q | unloading_reg;

  // rung 6 "until the last one has gone", box_grouping.ladder:28
  wire unloading_next = unloading_rung5 & ~(boxes_QD & ~eye_out);

  // rung 7 "conveyor 2", box_grouping.ladder:31
  wire conveyor_2_next = past_eye_Q | unloading_next;

  // rung 8 "conveyor 3", box_grouping.ladder:34
  wire conveyor_3_next = unloading_next;

  assign conveyor_1 = conveyor_1_reg;
  assign conveyor_2 = conveyor_2_reg;
  assign conveyor_3 = conveyor_3_reg;
  assign unloading = unloading_reg;
  assign boxes_CV = boxes_CV_last;

  always @(posedge clk) begin
    if (rst) begin
      eye_in_before <= 1'b0;
      pull_cord_before <= 1'b0;
      conveyor_1_reg <= 1'b0;
      unloading_reg <= 1'b0;
      conveyor_2_reg <= 1'b0;
      conveyor_3_reg <= 1'b0;
    end else begin
      eye_in_before <= eye_in;
      pull_cord_before <= pull_cord;
      conveyor_1_reg <= conveyor_1_next;
      unloading_reg <= unloading_next;
      conveyor_2_reg <= conveyor_2_next;
      conveyor_3_reg <= conveyor_3_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module box_grouping_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        unloading,
  input  wire        conveyor_1,
  input  wire        conveyor_2,
  input  wire [15:0] boxes_CV,
  input  wire        conveyor_3,
  output wire        expect_0_0,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_5_2,
  output wire        expect_5_3,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_8_2,
  output wire        expect_9_0,
  output wire        expect_10_0,
  output wire        expect_11_0,
  output wire        expect_12_0
);

  assign expect_0_0 = ~unloading;
  assign expect_1_0 = conveyor_1;
  assign expect_1_1 = ~conveyor_2;
  assign expect_2_0 = conveyor_1;
  assign expect_2_1 = conveyor_2;
  assign expect_3_0 = ~conveyor_1;
  assign expect_3_1 = conveyor_2;
  assign expect_4_0 = conveyor_2;
  assign expect_4_1 = ~unloading;
  assign expect_5_0 = boxes_CV == 16'd4;
  assign expect_5_1 = unloading;
  assign expect_5_2 = conveyor_2;
  assign expect_5_3 = conveyor_3;
  assign expect_6_0 = boxes_CV == 16'd1;
  assign expect_6_1 = unloading;
  assign expect_7_0 = boxes_CV == 16'd0;
  assign expect_7_1 = unloading;
  assign expect_8_0 = ~unloading;
  assign expect_8_1 = ~conveyor_2;
  assign expect_8_2 = ~conveyor_3;
  assign expect_9_0 = boxes_CV == 16'd1;
  assign expect_10_0 = boxes_CV == 16'd1;
  assign expect_11_0 = boxes_CV == 16'd2;
  assign expect_12_0 = boxes_CV == 16'd0;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module box_grouping_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg pull_cord = 1'd0;
  reg eye_in = 1'd0;
  reg eye_out = 1'd0;
  reg emptied = 1'd0;
  wire conveyor_1;
  wire conveyor_2;
  wire conveyor_3;
  wire unloading;
  wire [15:0] boxes_CV;
  reg failed;
  integer failures;

  box_grouping_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .pull_cord(pull_cord),
    .eye_in(eye_in),
    .eye_out(eye_out),
    .emptied(emptied),
    .conveyor_1(conveyor_1),
    .conveyor_2(conveyor_2),
    .conveyor_3(conveyor_3),
    .unloading(unloading),
    .boxes_CV(boxes_CV)
  );

  wire expect_0_0;
  wire [0:0] expect_0 = {expect_0_0};
  wire expect_1_0;
  wire expect_1_1;
  wire [0:1] expect_1 = {expect_1_0, expect_1_1};
  wire expect_2_0;
  wire expect_2_1;
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire expect_3_1;
  wire [0:1] expect_3 = {expect_3_0, expect_3_1};
  wire expect_4_0;
  wire expect_4_1;
  wire [0:1] expect_4 = {expect_4_0, expect_4_1};
  wire expect_5_0;
  wire expect_5_1;
  wire expect_5_2;
  wire expect_5_3;
  wire [0:3] expect_5 = {expect_5_0, expect_5_1, expect_5_2, expect_5_3};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
  wire expect_8_0;
  wire expect_8_1;
  wire expect_8_2;
  wire [0:2] expect_8 = {expect_8_0, expect_8_1, expect_8_2};
  wire expect_9_0;
  wire [0:0] expect_9 = {expect_9_0};
  wire expect_10_0;
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  box_grouping_expect expectations (
    .clk(clk),
    .rst(rst),
    .unloading(unloading),
    .conveyor_1(conveyor_1),
    .conveyor_2(conveyor_2),
    .boxes_CV(boxes_CV),
    .conveyor_3(conveyor_3),
    .expect_0_0(expect_0_0),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_5_3(expect_5_3),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_8_2(expect_8_2),
    .expect_9_0(expect_9_0),
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0)
  );

  // One clock is one scan.
  task scan(input integer times, input with_tick);
    begin
      tick = with_tick;
      repeat (times) begin
        #5 clk = 1'b1;
        #5 clk = 1'b0;
      end
    end
  endtask

  task reset;
    begin
      tick = 1'd0;
      pull_cord = 1'd0;
      eye_in = 1'd0;
      eye_out = 1'd0;
      emptied = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..3");

    // four boxes in, then four boxes out
    failed = 1'b0;
    reset;
    repeat (4) begin
      #1 if (!failed && &expect_0 !== 1'b1) begin // box_grouping.ladder:39
        failed = 1'b1;
        $display("# failed expectation 0 conducts %b unloading=%b at %0s", expect_0, unloading, "box_grouping.ladder:39");
      end
      pull_cord = 1'd1;
      scan(1, 1'b0);
      pull_cord = 1'd0;
      scan(1, 1'b0);
      #1 if (!failed && &expect_1 !== 1'b1) begin // box_grouping.ladder:41
        failed = 1'b1;
        $display("# failed expectation 1 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_1, conveyor_1, conveyor_2, "box_grouping.ladder:41");
      end
      eye_in = 1'd1;
      scan(1, 1'b0);
      #1 if (!failed && &expect_2 !== 1'b1) begin // box_grouping.ladder:43
        failed = 1'b1;
        $display("# failed expectation 2 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_2, conveyor_1, conveyor_2, "box_grouping.ladder:43");
      end
      eye_in = 1'd0;
      scan(1, 1'b0);
      #1 if (!failed && &expect_3 !== 1'b1) begin // box_grouping.ladder:45
        failed = 1'b1;
        $display("# failed expectation 3 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_3, conveyor_1, conveyor_2, "box_grouping.ladder:45");
      end
      scan(999, 1'b1);
      #1 if (!failed && &expect_4 !== 1'b1) begin // box_grouping.ladder:47
        failed = 1'b1;
        $display("# failed expectation 4 conducts %b conveyor_2=%b unloading=%b at %0s", expect_4, conveyor_2, unloading, "box_grouping.ladder:47");
      end
      scan(1, 1'b1);
    end
    #1 if (!failed && &expect_5 !== 1'b1) begin // box_grouping.ladder:50
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b boxes_CV=%b unloading=%b conveyor_2=%b conveyor_3=%b at %0s", expect_5, boxes_CV, unloading, conveyor_2, conveyor_3, "box_grouping.ladder:50");
    end
    repeat (3) begin
      eye_out = 1'd1;
      scan(1, 1'b0);
      eye_out = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_6 !== 1'b1) begin // box_grouping.ladder:52
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b boxes_CV=%b unloading=%b at %0s", expect_6, boxes_CV, unloading, "box_grouping.ladder:52");
    end
    eye_out = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // box_grouping.ladder:54
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b boxes_CV=%b unloading=%b at %0s", expect_7, boxes_CV, unloading, "box_grouping.ladder:54");
    end
    eye_out = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // box_grouping.ladder:56
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b unloading=%b conveyor_2=%b conveyor_3=%b at %0s", expect_8, unloading, conveyor_2, conveyor_3, "box_grouping.ladder:56");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "four boxes in, then four boxes out");
    end else $display("ok 1 - %0s", "four boxes in, then four boxes out");

    // a box that comes as one goes is counted once each way
    failed = 1'b0;
    reset;
    eye_in = 1'd1;
    scan(1, 1'b0);
    eye_in = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // box_grouping.ladder:61
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b boxes_CV=%b at %0s", expect_9, boxes_CV, "box_grouping.ladder:61");
    end
    eye_in = 1'd1;
    eye_out = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // box_grouping.ladder:63
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b boxes_CV=%b at %0s", expect_10, boxes_CV, "box_grouping.ladder:63");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "a box that comes as one goes is counted once each way");
    end else $display("ok 2 - %0s", "a box that comes as one goes is counted once each way");

    // a conveyor that was emptied by hand counts from nothing
    failed = 1'b0;
    reset;
    repeat (2) begin
      eye_in = 1'd1;
      scan(1, 1'b0);
      eye_in = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_11 !== 1'b1) begin // box_grouping.ladder:67
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b boxes_CV=%b at %0s", expect_11, boxes_CV, "box_grouping.ladder:67");
    end
    emptied = 1'd1;
    scan(1, 1'b0);
    emptied = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // box_grouping.ladder:69
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b boxes_CV=%b at %0s", expect_12, boxes_CV, "box_grouping.ladder:69");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a conveyor that was emptied by hand counts from nothing");
    end else $display("ok 3 - %0s", "a conveyor that was emptied by hand counts from nothing");

    if (failures != 0) $display("# %0d of 3 tests failed", failures);
    $finish;
  end
endmodule
