// Made by hotrail 0.1.0 from conveyor_build_up.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module conveyor_build_up_expect (
  input  wire clk,
  input  wire rst,
  input  wire conveyor_2,
  input  wire conveyor_1,
  input  wire build_up,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_1_0,
  output wire expect_2_0,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_4_0,
  output wire expect_4_1,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_6_2,
  output wire expect_7_0,
  output wire expect_7_1,
  output wire expect_8_0,
  output wire expect_8_1,
  output wire expect_9_0,
  output wire expect_9_1,
  output wire expect_10_0,
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_12_0,
  output wire expect_13_0,
  output wire expect_14_0,
  output wire expect_14_1,
  output wire expect_15_0,
  output wire expect_15_1,
  output wire expect_16_0,
  output wire expect_16_1
);

  assign expect_0_0 = conveyor_2;
  assign expect_0_1 = ~conveyor_1;
  assign expect_1_0 = ~conveyor_1;
  assign expect_2_0 = conveyor_1;
  assign expect_3_0 = ~conveyor_1;
  assign expect_3_1 = conveyor_2;
  assign expect_4_0 = conveyor_1;
  assign expect_4_1 = ~build_up;
  assign expect_5_0 = conveyor_1;
  assign expect_5_1 = ~build_up;
  assign expect_6_0 = build_up;
  assign expect_6_1 = ~conveyor_1;
  assign expect_6_2 = conveyor_2;
  assign expect_7_0 = build_up;
  assign expect_7_1 = ~conveyor_1;
  assign expect_8_0 = build_up;
  assign expect_8_1 = ~conveyor_1;
  assign expect_9_0 = ~build_up;
  assign expect_9_1 = conveyor_1;
  assign expect_10_0 = build_up;
  assign expect_11_0 = build_up;
  assign expect_11_1 = ~conveyor_1;
  assign expect_12_0 = conveyor_1;
  assign expect_13_0 = ~conveyor_1;
  assign expect_14_0 = conveyor_1;
  assign expect_14_1 = conveyor_2;
  assign expect_15_0 = ~conveyor_1;
  assign expect_15_1 = ~conveyor_2;
  assign expect_16_0 = ~conveyor_1;
  assign expect_16_1 = ~conveyor_2;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module conveyor_build_up_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg stop = 1'd0;
  reg eye = 1'd0;
  reg turning_2 = 1'd0;
  wire conveyor_1;
  wire conveyor_2;
  wire build_up;
  reg failed;
  integer failures;

  conveyor_build_up core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .stop(stop),
    .eye(eye),
    .turning_2(turning_2),
    .conveyor_1(conveyor_1),
    .conveyor_2(conveyor_2),
    .build_up(build_up)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire [0:1] expect_0 = {expect_0_0, expect_0_1};
  wire expect_1_0;
  wire [0:0] expect_1 = {expect_1_0};
  wire expect_2_0;
  wire [0:0] expect_2 = {expect_2_0};
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
  wire [0:2] expect_6 = {expect_6_0, expect_6_1, expect_6_2};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
  wire expect_8_0;
  wire expect_8_1;
  wire [0:1] expect_8 = {expect_8_0, expect_8_1};
  wire expect_9_0;
  wire expect_9_1;
  wire [0:1] expect_9 = {expect_9_0, expect_9_1};
  wire expect_10_0;
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire expect_14_1;
  wire [0:1] expect_14 = {expect_14_0, expect_14_1};
  wire expect_15_0;
  wire expect_15_1;
  wire [0:1] expect_15 = {expect_15_0, expect_15_1};
  wire expect_16_0;
  wire expect_16_1;
  wire [0:1] expect_16 = {expect_16_0, expect_16_1};
  conveyor_build_up_expect expectations (
    .clk(clk),
    .rst(rst),
    .conveyor_2(conveyor_2),
    .conveyor_1(conveyor_1),
    .build_up(build_up),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_6_2(expect_6_2),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_14_1(expect_14_1),
    .expect_15_0(expect_15_0),
    .expect_15_1(expect_15_1),
    .expect_16_0(expect_16_0),
    .expect_16_1(expect_16_1)
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
      start = 1'd0;
      stop = 1'd0;
      eye = 1'd0;
      turning_2 = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..6");

    // conveyor 1 waits until conveyor 2 turns
    failed = 1'b0;
    reset;
    stop = 1'd1;
    eye = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // conveyor_build_up.ladder:29
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b conveyor_2=%b conveyor_1=%b at %0s", expect_0, conveyor_2, conveyor_1, "conveyor_build_up.ladder:29");
    end
    scan(20, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // conveyor_build_up.ladder:31
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b conveyor_1=%b at %0s", expect_1, conveyor_1, "conveyor_build_up.ladder:31");
    end
    turning_2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // conveyor_build_up.ladder:33
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b conveyor_1=%b at %0s", expect_2, conveyor_1, "conveyor_build_up.ladder:33");
    end
    turning_2 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // conveyor_build_up.ladder:35
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_3, conveyor_1, conveyor_2, "conveyor_build_up.ladder:35");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "conveyor 1 waits until conveyor 2 turns");
    end else $display("ok 1 - %0s", "conveyor 1 waits until conveyor 2 turns");

    // pieces that pass
    failed = 1'b0;
    reset;
    stop = 1'd1;
    eye = 1'd1;
    turning_2 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    repeat (5) begin
      eye = 1'd0;
      scan(1, 1'b0);
      scan(29, 1'b1);
      #1 if (!failed && &expect_4 !== 1'b1) begin // conveyor_build_up.ladder:43
        failed = 1'b1;
        $display("# failed expectation 4 conducts %b conveyor_1=%b build_up=%b at %0s", expect_4, conveyor_1, build_up, "conveyor_build_up.ladder:43");
      end
      eye = 1'd1;
      scan(1, 1'b0);
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "pieces that pass");
    end else $display("ok 2 - %0s", "pieces that pass");

    // a pile, and its end
    failed = 1'b0;
    reset;
    stop = 1'd1;
    eye = 1'd1;
    turning_2 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    eye = 1'd0;
    scan(1, 1'b0);
    scan(29, 1'b1);
    #1 if (!failed && &expect_5 !== 1'b1) begin // conveyor_build_up.ladder:52
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b conveyor_1=%b build_up=%b at %0s", expect_5, conveyor_1, build_up, "conveyor_build_up.ladder:52");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // conveyor_build_up.ladder:54
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b build_up=%b conveyor_1=%b conveyor_2=%b at %0s", expect_6, build_up, conveyor_1, conveyor_2, "conveyor_build_up.ladder:54");
    end
    scan(200, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // conveyor_build_up.ladder:56
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b build_up=%b conveyor_1=%b at %0s", expect_7, build_up, conveyor_1, "conveyor_build_up.ladder:56");
    end
    eye = 1'd1;
    scan(1, 1'b0);
    scan(49, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // conveyor_build_up.ladder:59
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b build_up=%b conveyor_1=%b at %0s", expect_8, build_up, conveyor_1, "conveyor_build_up.ladder:59");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_9 !== 1'b1) begin // conveyor_build_up.ladder:61
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b build_up=%b conveyor_1=%b at %0s", expect_9, build_up, conveyor_1, "conveyor_build_up.ladder:61");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a pile, and its end");
    end else $display("ok 3 - %0s", "a pile, and its end");

    // a pile that lets light through for moments is still a pile
    failed = 1'b0;
    reset;
    stop = 1'd1;
    turning_2 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(30, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // conveyor_build_up.ladder:67
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b build_up=%b at %0s", expect_10, build_up, "conveyor_build_up.ladder:67");
    end
    repeat (4) begin
      eye = 1'd1;
      scan(1, 1'b0);
      scan(49, 1'b1);
      eye = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_11 !== 1'b1) begin // conveyor_build_up.ladder:73
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b build_up=%b conveyor_1=%b at %0s", expect_11, build_up, conveyor_1, "conveyor_build_up.ladder:73");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "a pile that lets light through for moments is still a pile");
    end else $display("ok 4 - %0s", "a pile that lets light through for moments is still a pile");

    // a dead photo-eye stops conveyor 1
    failed = 1'b0;
    reset;
    stop = 1'd1;
    eye = 1'd1;
    turning_2 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(100, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // conveyor_build_up.ladder:79
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b conveyor_1=%b at %0s", expect_12, conveyor_1, "conveyor_build_up.ladder:79");
    end
    eye = 1'd0;
    scan(31, 1'b1);
    #1 if (!failed && &expect_13 !== 1'b1) begin // conveyor_build_up.ladder:82
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b conveyor_1=%b at %0s", expect_13, conveyor_1, "conveyor_build_up.ladder:82");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a dead photo-eye stops conveyor 1");
    end else $display("ok 5 - %0s", "a dead photo-eye stops conveyor 1");

    // stop ends both, and wins over start
    failed = 1'b0;
    reset;
    stop = 1'd1;
    eye = 1'd1;
    turning_2 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // conveyor_build_up.ladder:87
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_14, conveyor_1, conveyor_2, "conveyor_build_up.ladder:87");
    end
    start = 1'd1;
    stop = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // conveyor_build_up.ladder:89
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_15, conveyor_1, conveyor_2, "conveyor_build_up.ladder:89");
    end
    stop = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_16 !== 1'b1) begin // conveyor_build_up.ladder:91
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b conveyor_1=%b conveyor_2=%b at %0s", expect_16, conveyor_1, conveyor_2, "conveyor_build_up.ladder:91");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "stop ends both, and wins over start");
    end else $display("ok 6 - %0s", "stop ends both, and wins over start");

    if (failures != 0) $display("# %0d of 6 tests failed", failures);
    $finish;
  end
endmodule
