// Made by hotrail 0.1.0 from ab_boxes.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

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
module ab_boxes_test_AB_TOF_BASE1_PRE100 (
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
module ab_boxes_test_AB_CTU (
  input  wire        power,
  input  wire [15:0] ACC_before,
  input  wire        was_up_before,
  output wire [15:0] ACC,
  output wire        CU,
  output wire        was_up
);
  wire [15:0] ACC_value = ACC_before + {15'b0, power & ~was_up_before};

  assign ACC = ACC_value;
  assign CU = power;
  assign was_up = power;
endmodule

// AB_CTD: down counter of Allen-Bradley
// Fitted to PRE = 4.
// Example, with PRE = 1, ACC = 2:
// IN    _#_##_#
// CD    _#_##_#
// DN    ###____
// ACC+1 3221110
module ab_boxes_test_AB_CTD_PRE4 (
  input  wire        power,
  input  wire [15:0] ACC_before,
  input  wire        was_down_before,
  output wire [15:0] ACC,
  output wire        CD,
  output wire        DN,
  output wire        was_down
);
  wire [15:0] ACC_value = ACC_before - {15'b0, power & ~was_down_before};

  assign ACC = ACC_value;
  assign CD = power;
  assign DN = $signed(ACC_value) >= 16'sd4;
  assign was_down = power;
endmodule

module ab_boxes_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        pull_cord,
  input  wire        eye_1,
  input  wire        eye_2,
  input  wire        emptied,
  output wire        conveyor_1,
  output wire        conveyor_2,
  output wire        conveyor_3,
  output wire        unloading,
  output wire [15:0] boxes_ACC,
  output wire        boxes_DN,
  output wire        boxes_CU,
  output wire        boxes_CD
);
  reg power_before = 1'b0;
  reg pull_cord_before = 1'b0;
  reg conveyor_1_reg = 1'b0;
  reg [15:0] boxes_ACC_reg = 16'd0;
  reg boxes_CU_reg = 1'b0;
  reg boxes_DN_reg = 1'b0;
  reg boxes_was_up_reg = 1'b1;
  reg boxes_CD_reg = 1'b0;
  reg boxes_was_down = 1'b1;
  reg unloading_reg = 1'b0;
  reg conveyor_2_reg = 1'b0;
  reg conveyor_3_reg = 1'b0;

  // rung 1 "PE_1_Timer: a box moves on for a second after the eye", ab_boxes.ladder:14
  wire pe_1_timer_TT;
  wire pe_1_timer_DN;
  ab_boxes_test_AB_TOF_BASE1_PRE100 pe_1_timer (
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
  wire [15:0] boxes_ACC_2;
  wire boxes_CU_2;
  wire boxes_was_up;
  ab_boxes_test_AB_CTU boxes (
    .power(eye_1),
    .ACC_before(boxes_ACC_reg),
    .was_up_before(boxes_was_up_reg),
    .ACC(boxes_ACC_2),
    .CU(boxes_CU_2),
    .was_up(boxes_was_up)
  );

  // rung 5 "down at the other, on the same counter", ab_boxes.ladder:26
  wire [15:0] boxes_AB_CTD_ACC;
  wire boxes_AB_CTD_CD;
  wire boxes_AB_CTD_DN;
  wire boxes_AB_CTD_was_down;
  ab_boxes_test_AB_CTD_PRE4 boxes_AB_CTD (
    .power(eye_2),
    .ACC_before(boxes_ACC_2),
    .was_down_before(boxes_was_down),
    .ACC(boxes_AB_CTD_ACC),
    .CD(boxes_AB_CTD_CD),
    .DN(boxes_AB_CTD_DN),
    .was_down(boxes_AB_CTD_was_down)
  );

  // rung 6 "four are a group, once the last one is in its place", ab_boxes.ladder:29
  wire unloading_rung6 = boxes_AB_CTD_DN & ~pe_1_timer_DN | unloading_reg;

  // rung 7 "until the last one has gone", ab_boxes.ladder:32
  wire rung7_at_most = $signed(boxes_AB_CTD_ACC) <= 16'sd0;
  wire unloading_rung7 = unloading_rung6 & ~(rung7_at_most & ~eye_2);

  // rung 8, ab_boxes.ladder:35
  wire [15:0] boxes_ACC_next = emptied ? 16'd0 : boxes_AB_CTD_ACC;
  wire boxes_CU_next = emptied ? 1'b0 : boxes_CU_2;
  wire boxes_CD_next = emptied ? 1'b0 : boxes_AB_CTD_CD;
  wire boxes_DN_next = emptied ? 1'b0 : boxes_AB_CTD_DN;
  wire boxes_was_up_next = emptied ? 1'b0 : boxes_was_up;
  wire boxes_was_down_next = emptied ? 1'b0 : boxes_AB_CTD_was_down;
  wire unloading_next = emptied ? 1'b0 : unloading_rung7;

  // rung 9 "conveyor 2", ab_boxes.ladder:37
  wire conveyor_2_next = pe_1_timer_DN | unloading_next;

  // rung 10 "conveyor 3", ab_boxes.ladder:40
  wire conveyor_3_next = unloading_next;

  assign conveyor_1 = conveyor_1_reg;
  assign conveyor_2 = conveyor_2_reg;
  assign conveyor_3 = conveyor_3_reg;
  assign unloading = unloading_reg;
  assign boxes_ACC = boxes_ACC_reg;
  assign boxes_DN = boxes_DN_reg;
  assign boxes_CU = boxes_CU_reg;
  assign boxes_CD = boxes_CD_reg;

  always @(posedge clk) begin
    if (rst) begin
      power_before <= 1'b0;
      pull_cord_before <= 1'b0;
      conveyor_1_reg <= 1'b0;
      boxes_ACC_reg <= 16'd0;
      boxes_CU_reg <= 1'b0;
      boxes_DN_reg <= 1'b0;
      boxes_was_up_reg <= 1'b1;
      boxes_CD_reg <= 1'b0;
      boxes_was_down <= 1'b1;
      unloading_reg <= 1'b0;
      conveyor_2_reg <= 1'b0;
      conveyor_3_reg <= 1'b0;
    end else begin
      power_before <= pe_1_timer_TT;
      pull_cord_before <= pull_cord;
      conveyor_1_reg <= conveyor_1_next;
      boxes_ACC_reg <= boxes_ACC_next;
      boxes_CU_reg <= boxes_CU_next;
      boxes_DN_reg <= boxes_DN_next;
      boxes_was_up_reg <= boxes_was_up_next;
      boxes_CD_reg <= boxes_CD_next;
      boxes_was_down <= boxes_was_down_next;
      unloading_reg <= unloading_next;
      conveyor_2_reg <= conveyor_2_next;
      conveyor_3_reg <= conveyor_3_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module ab_boxes_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        conveyor_1,
  input  wire        conveyor_2,
  input  wire        conveyor_3,
  input  wire        unloading,
  input  wire [15:0] boxes_ACC,
  input  wire        boxes_DN,
  input  wire        boxes_CU,
  input  wire        boxes_CD,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_1_0,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_6_2,
  output wire        expect_6_3,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_7_2,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_9_2,
  output wire        expect_10_0,
  output wire        expect_11_0,
  output wire        expect_11_1,
  output wire        expect_11_2,
  output wire        expect_12_0,
  output wire        expect_13_0
);

  assign expect_0_0 = ~conveyor_1;
  assign expect_0_1 = ~conveyor_2;
  assign expect_0_2 = ~conveyor_3;
  assign expect_1_0 = ~unloading;
  assign expect_2_0 = conveyor_1;
  assign expect_2_1 = ~conveyor_2;
  assign expect_3_0 = conveyor_1;
  assign expect_3_1 = conveyor_2;
  assign expect_4_0 = ~conveyor_1;
  assign expect_4_1 = conveyor_2;
  assign expect_5_0 = conveyor_2;
  assign expect_5_1 = ~unloading;
  assign expect_6_0 = boxes_ACC == 16'd4;
  assign expect_6_1 = unloading;
  assign expect_6_2 = conveyor_2;
  assign expect_6_3 = conveyor_3;
  assign expect_7_0 = boxes_ACC == 16'd1;
  assign expect_7_1 = unloading;
  assign expect_7_2 = ~boxes_DN;
  assign expect_8_0 = boxes_ACC == 16'd0;
  assign expect_8_1 = unloading;
  assign expect_9_0 = ~unloading;
  assign expect_9_1 = ~conveyor_2;
  assign expect_9_2 = ~conveyor_3;
  assign expect_10_0 = boxes_ACC == 16'd1;
  assign expect_11_0 = boxes_ACC == 16'd1;
  assign expect_11_1 = boxes_CU;
  assign expect_11_2 = boxes_CD;
  assign expect_12_0 = boxes_ACC == 16'd2;
  assign expect_13_0 = boxes_ACC == 16'd0;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module ab_boxes_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg pull_cord = 1'd0;
  reg eye_1 = 1'd0;
  reg eye_2 = 1'd0;
  reg emptied = 1'd0;
  wire conveyor_1;
  wire conveyor_2;
  wire conveyor_3;
  wire unloading;
  wire [15:0] boxes_ACC;
  wire boxes_DN;
  wire boxes_CU;
  wire boxes_CD;
  reg failed;
  integer failures;

  ab_boxes_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .pull_cord(pull_cord),
    .eye_1(eye_1),
    .eye_2(eye_2),
    .emptied(emptied),
    .conveyor_1(conveyor_1),
    .conveyor_2(conveyor_2),
    .conveyor_3(conveyor_3),
    .unloading(unloading),
    .boxes_ACC(boxes_ACC),
    .boxes_DN(boxes_DN),
    .boxes_CU(boxes_CU),
    .boxes_CD(boxes_CD)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire [0:2] expect_0 = {expect_0_0, expect_0_1, expect_0_2};
  wire expect_1_0;
  wire [0:0] expect_1 = {expect_1_0};
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
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  wire expect_6_0;
  wire expect_6_1;
  wire expect_6_2;
  wire expect_6_3;
  wire [0:3] expect_6 = {expect_6_0, expect_6_1, expect_6_2, expect_6_3};
  wire expect_7_0;
  wire expect_7_1;
  wire expect_7_2;
  wire [0:2] expect_7 = {expect_7_0, expect_7_1, expect_7_2};
  wire expect_8_0;
  wire expect_8_1;
  wire [0:1] expect_8 = {expect_8_0, expect_8_1};
  wire expect_9_0;
  wire expect_9_1;
  wire expect_9_2;
  wire [0:2] expect_9 = {expect_9_0, expect_9_1, expect_9_2};
  wire expect_10_0;
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire expect_11_1;
  wire expect_11_2;
  wire [0:2] expect_11 = {expect_11_0, expect_11_1, expect_11_2};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  ab_boxes_expect expectations (
    .clk(clk),
    .rst(rst),
    .conveyor_1(conveyor_1),
    .conveyor_2(conveyor_2),
    .conveyor_3(conveyor_3),
    .unloading(unloading),
    .boxes_ACC(boxes_ACC),
    .boxes_DN(boxes_DN),
    .boxes_CU(boxes_CU),
    .boxes_CD(boxes_CD),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_6_2(expect_6_2),
    .expect_6_3(expect_6_3),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_7_2(expect_7_2),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_9_2(expect_9_2),
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_11_2(expect_11_2),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0)
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
      eye_1 = 1'd0;
      eye_2 = 1'd0;
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
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // ab_boxes.ladder:45
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b conveyor_1=%b conveyor_2=%b conveyor_3=%b at %0s", expect_0, conveyor_1, conveyor_2, conveyor_3, "ab_boxes.ladder:45");
    end
    repeat (4) begin
      #1 if (!failed && &expect_1 !== 1'b1) begin // ab_boxes.ladder:47
        failed = 1'b1;
        $display("# failed expectation 1 conducts %b unloading=%b at %0s", expect_1, unloading, "ab_boxes.ladder:47");
      end
      pull_cord = 1'd1;
      scan(1, 1'b0);
      pull_cord = 1'd0;
      scan(1, 1'b0);
      #1 if (!failed && &expect_2 !== 1'b1) begin // ab_boxes.ladder:49
        failed = 1'b1;
        $display("# failed expectation 2 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_2, conveyor_1, conveyor_2, "ab_boxes.ladder:49");
      end
      eye_1 = 1'd1;
      scan(1, 1'b0);
      #1 if (!failed && &expect_3 !== 1'b1) begin // ab_boxes.ladder:51
        failed = 1'b1;
        $display("# failed expectation 3 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_3, conveyor_1, conveyor_2, "ab_boxes.ladder:51");
      end
      eye_1 = 1'd0;
      scan(1, 1'b0);
      #1 if (!failed && &expect_4 !== 1'b1) begin // ab_boxes.ladder:53
        failed = 1'b1;
        $display("# failed expectation 4 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_4, conveyor_1, conveyor_2, "ab_boxes.ladder:53");
      end
      scan(99, 1'b1);
      #1 if (!failed && &expect_5 !== 1'b1) begin // ab_boxes.ladder:55
        failed = 1'b1;
        $display("# failed expectation 5 conducts %b conveyor_2=%b unloading=%b at %0s", expect_5, conveyor_2, unloading, "ab_boxes.ladder:55");
      end
      scan(1, 1'b1);
    end
    #1 if (!failed && &expect_6 !== 1'b1) begin // ab_boxes.ladder:58
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b boxes_ACC=%b unloading=%b conveyor_2=%b conveyor_3=%b at %0s", expect_6, boxes_ACC, unloading, conveyor_2, conveyor_3, "ab_boxes.ladder:58");
    end
    repeat (3) begin
      eye_2 = 1'd1;
      scan(1, 1'b0);
      eye_2 = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_7 !== 1'b1) begin // ab_boxes.ladder:60
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b boxes_ACC=%b unloading=%b boxes_DN=%b at %0s", expect_7, boxes_ACC, unloading, boxes_DN, "ab_boxes.ladder:60");
    end
    eye_2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // ab_boxes.ladder:62
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b boxes_ACC=%b unloading=%b at %0s", expect_8, boxes_ACC, unloading, "ab_boxes.ladder:62");
    end
    eye_2 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // ab_boxes.ladder:64
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b unloading=%b conveyor_2=%b conveyor_3=%b at %0s", expect_9, unloading, conveyor_2, conveyor_3, "ab_boxes.ladder:64");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "four boxes in, then four boxes out");
    end else $display("ok 1 - %0s", "four boxes in, then four boxes out");

    // a box that comes as one goes is counted once each way
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    eye_1 = 1'd1;
    scan(1, 1'b0);
    eye_1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // ab_boxes.ladder:69
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b boxes_ACC=%b at %0s", expect_10, boxes_ACC, "ab_boxes.ladder:69");
    end
    eye_1 = 1'd1;
    eye_2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // ab_boxes.ladder:71
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b boxes_ACC=%b boxes_CU=%b boxes_CD=%b at %0s", expect_11, boxes_ACC, boxes_CU, boxes_CD, "ab_boxes.ladder:71");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "a box that comes as one goes is counted once each way");
    end else $display("ok 2 - %0s", "a box that comes as one goes is counted once each way");

    // emptied by hand
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (2) begin
      eye_1 = 1'd1;
      scan(1, 1'b0);
      eye_1 = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_12 !== 1'b1) begin // ab_boxes.ladder:76
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b boxes_ACC=%b at %0s", expect_12, boxes_ACC, "ab_boxes.ladder:76");
    end
    emptied = 1'd1;
    scan(1, 1'b0);
    emptied = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // ab_boxes.ladder:78
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b boxes_ACC=%b at %0s", expect_13, boxes_ACC, "ab_boxes.ladder:78");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "emptied by hand");
    end else $display("ok 3 - %0s", "emptied by hand");

    if (failures != 0) $display("# %0d of 3 tests failed", failures);
    $finish;
  end
endmodule
