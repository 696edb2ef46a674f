// Made by hotrail 0.1.0 from conveyor_run_out.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module conveyor_run_out_expect (
  input  wire clk,
  input  wire rst,
  input  wire conveyor,
  input  wire empty,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_4_0,
  output wire expect_4_1,
  output wire expect_5_0,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_7_0,
  output wire expect_7_1,
  output wire expect_8_0,
  output wire expect_9_0,
  output wire expect_9_1,
  output wire expect_10_0,
  output wire expect_10_1,
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_12_0,
  output wire expect_13_0,
  output wire expect_14_0,
  output wire expect_15_0,
  output wire expect_15_1,
  output wire expect_16_0,
  output wire expect_17_0,
  output wire expect_18_0,
  output wire expect_19_0,
  output wire expect_19_1,
  output wire expect_20_0
);

  assign expect_0_0 = conveyor;
  assign expect_0_1 = ~empty;
  assign expect_1_0 = conveyor;
  assign expect_1_1 = ~empty;
  assign expect_2_0 = conveyor;
  assign expect_2_1 = empty;
  assign expect_3_0 = ~conveyor;
  assign expect_3_1 = empty;
  assign expect_4_0 = conveyor;
  assign expect_4_1 = empty;
  assign expect_5_0 = ~conveyor;
  assign expect_6_0 = conveyor;
  assign expect_6_1 = ~empty;
  assign expect_7_0 = ~conveyor;
  assign expect_7_1 = empty;
  assign expect_8_0 = ~conveyor;
  assign expect_9_0 = conveyor;
  assign expect_9_1 = ~empty;
  assign expect_10_0 = conveyor;
  assign expect_10_1 = ~empty;
  assign expect_11_0 = ~conveyor;
  assign expect_11_1 = empty;
  assign expect_12_0 = conveyor;
  assign expect_13_0 = ~conveyor;
  assign expect_14_0 = ~conveyor;
  assign expect_15_0 = ~conveyor;
  assign expect_15_1 = ~empty;
  assign expect_16_0 = conveyor;
  assign expect_17_0 = conveyor;
  assign expect_18_0 = ~conveyor;
  assign expect_19_0 = conveyor;
  assign expect_19_1 = empty;
  assign expect_20_0 = ~conveyor;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module conveyor_run_out_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg finish = 1'd0;
  reg emergency = 1'd0;
  reg product = 1'd0;
  reg wait_for_next = 1'd0;
  wire conveyor;
  wire empty;
  reg failed;
  integer failures;

  conveyor_run_out core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .finish(finish),
    .emergency(emergency),
    .product(product),
    .wait_for_next(wait_for_next),
    .conveyor(conveyor),
    .empty(empty)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire [0:1] expect_0 = {expect_0_0, expect_0_1};
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
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
  wire expect_8_0;
  wire [0:0] expect_8 = {expect_8_0};
  wire expect_9_0;
  wire expect_9_1;
  wire [0:1] expect_9 = {expect_9_0, expect_9_1};
  wire expect_10_0;
  wire expect_10_1;
  wire [0:1] expect_10 = {expect_10_0, expect_10_1};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire expect_15_1;
  wire [0:1] expect_15 = {expect_15_0, expect_15_1};
  wire expect_16_0;
  wire [0:0] expect_16 = {expect_16_0};
  wire expect_17_0;
  wire [0:0] expect_17 = {expect_17_0};
  wire expect_18_0;
  wire [0:0] expect_18 = {expect_18_0};
  wire expect_19_0;
  wire expect_19_1;
  wire [0:1] expect_19 = {expect_19_0, expect_19_1};
  wire expect_20_0;
  wire [0:0] expect_20 = {expect_20_0};
  conveyor_run_out_expect expectations (
    .clk(clk),
    .rst(rst),
    .conveyor(conveyor),
    .empty(empty),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_15_1(expect_15_1),
    .expect_16_0(expect_16_0),
    .expect_17_0(expect_17_0),
    .expect_18_0(expect_18_0),
    .expect_19_0(expect_19_0),
    .expect_19_1(expect_19_1),
    .expect_20_0(expect_20_0)
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
      finish = 1'd0;
      emergency = 1'd0;
      product = 1'd0;
      wait_for_next = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..7");

    // the belt empties before it stops
    failed = 1'b0;
    reset;
    emergency = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // conveyor_run_out.ladder:36
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b conveyor=%b empty=%b at %0s", expect_0, conveyor, empty, "conveyor_run_out.ladder:36");
    end
    scan(50, 1'b1);
    product = 1'd1;
    scan(10, 1'b1);
    product = 1'd0;
    scan(1, 1'b0);
    finish = 1'd1;
    scan(1, 1'b0);
    finish = 1'd0;
    scan(1, 1'b0);
    scan(119, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // conveyor_run_out.ladder:42
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b conveyor=%b empty=%b at %0s", expect_1, conveyor, empty, "conveyor_run_out.ladder:42");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // conveyor_run_out.ladder:44
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b conveyor=%b empty=%b at %0s", expect_2, conveyor, empty, "conveyor_run_out.ladder:44");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // conveyor_run_out.ladder:46
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b conveyor=%b empty=%b at %0s", expect_3, conveyor, empty, "conveyor_run_out.ladder:46");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "the belt empties before it stops");
    end else $display("ok 1 - %0s", "the belt empties before it stops");

    // finish on an empty belt stops at once
    failed = 1'b0;
    reset;
    emergency = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(120, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // conveyor_run_out.ladder:52
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b conveyor=%b empty=%b at %0s", expect_4, conveyor, empty, "conveyor_run_out.ladder:52");
    end
    finish = 1'd1;
    scan(1, 1'b0);
    finish = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // conveyor_run_out.ladder:54
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b conveyor=%b at %0s", expect_5, conveyor, "conveyor_run_out.ladder:54");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "finish on an empty belt stops at once");
    end else $display("ok 2 - %0s", "finish on an empty belt stops at once");

    // after power-up nobody knows what lies on the belt
    failed = 1'b0;
    reset;
    emergency = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    finish = 1'd1;
    scan(1, 1'b0);
    finish = 1'd0;
    scan(1, 1'b0);
    scan(119, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // conveyor_run_out.ladder:61
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b conveyor=%b empty=%b at %0s", expect_6, conveyor, empty, "conveyor_run_out.ladder:61");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // conveyor_run_out.ladder:64
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b conveyor=%b empty=%b at %0s", expect_7, conveyor, empty, "conveyor_run_out.ladder:64");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "after power-up nobody knows what lies on the belt");
    end else $display("ok 3 - %0s", "after power-up nobody knows what lies on the belt");

    // the time in which the belt waits does not count
    failed = 1'b0;
    reset;
    emergency = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    product = 1'd1;
    scan(1, 1'b0);
    product = 1'd0;
    scan(1, 1'b0);
    finish = 1'd1;
    scan(1, 1'b0);
    finish = 1'd0;
    scan(1, 1'b0);
    scan(60, 1'b1);
    repeat (3) begin
      wait_for_next = 1'd1;
      scan(1, 1'b0);
      #1 if (!failed && &expect_8 !== 1'b1) begin // conveyor_run_out.ladder:75
        failed = 1'b1;
        $display("# failed expectation 8 conducts %b conveyor=%b at %0s", expect_8, conveyor, "conveyor_run_out.ladder:75");
      end
      scan(200, 1'b1);
      wait_for_next = 1'd0;
      scan(1, 1'b0);
      #1 if (!failed && &expect_9 !== 1'b1) begin // conveyor_run_out.ladder:78
        failed = 1'b1;
        $display("# failed expectation 9 conducts %b conveyor=%b empty=%b at %0s", expect_9, conveyor, empty, "conveyor_run_out.ladder:78");
      end
      scan(10, 1'b1);
    end
    scan(29, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // conveyor_run_out.ladder:82
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b conveyor=%b empty=%b at %0s", expect_10, conveyor, empty, "conveyor_run_out.ladder:82");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // conveyor_run_out.ladder:85
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b conveyor=%b empty=%b at %0s", expect_11, conveyor, empty, "conveyor_run_out.ladder:85");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "the time in which the belt waits does not count");
    end else $display("ok 4 - %0s", "the time in which the belt waits does not count");

    // a product that comes while the belt empties has its whole time
    failed = 1'b0;
    reset;
    emergency = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    finish = 1'd1;
    scan(1, 1'b0);
    finish = 1'd0;
    scan(1, 1'b0);
    scan(110, 1'b1);
    product = 1'd1;
    scan(1, 1'b0);
    product = 1'd0;
    scan(1, 1'b0);
    scan(119, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // conveyor_run_out.ladder:94
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b conveyor=%b at %0s", expect_12, conveyor, "conveyor_run_out.ladder:94");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // conveyor_run_out.ladder:97
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b conveyor=%b at %0s", expect_13, conveyor, "conveyor_run_out.ladder:97");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a product that comes while the belt empties has its whole time");
    end else $display("ok 5 - %0s", "a product that comes while the belt empties has its whole time");

    // emergency keeps what the timer knows
    failed = 1'b0;
    reset;
    emergency = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    product = 1'd1;
    scan(1, 1'b0);
    product = 1'd0;
    scan(1, 1'b0);
    scan(100, 1'b1);
    emergency = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // conveyor_run_out.ladder:105
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b conveyor=%b at %0s", expect_14, conveyor, "conveyor_run_out.ladder:105");
    end
    scan(600, 1'b1);
    emergency = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // conveyor_run_out.ladder:108
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b conveyor=%b empty=%b at %0s", expect_15, conveyor, empty, "conveyor_run_out.ladder:108");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_16 !== 1'b1) begin // conveyor_run_out.ladder:110
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b conveyor=%b at %0s", expect_16, conveyor, "conveyor_run_out.ladder:110");
    end
    finish = 1'd1;
    scan(1, 1'b0);
    finish = 1'd0;
    scan(1, 1'b0);
    scan(19, 1'b1);
    #1 if (!failed && &expect_17 !== 1'b1) begin // conveyor_run_out.ladder:113
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b conveyor=%b at %0s", expect_17, conveyor, "conveyor_run_out.ladder:113");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_18 !== 1'b1) begin // conveyor_run_out.ladder:116
      failed = 1'b1;
      $display("# failed expectation 18 conducts %b conveyor=%b at %0s", expect_18, conveyor, "conveyor_run_out.ladder:116");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "emergency keeps what the timer knows");
    end else $display("ok 6 - %0s", "emergency keeps what the timer knows");

    // start takes a finish back; both at once finish
    failed = 1'b0;
    reset;
    emergency = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    finish = 1'd1;
    scan(1, 1'b0);
    finish = 1'd0;
    scan(1, 1'b0);
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(200, 1'b1);
    #1 if (!failed && &expect_19 !== 1'b1) begin // conveyor_run_out.ladder:124
      failed = 1'b1;
      $display("# failed expectation 19 conducts %b conveyor=%b empty=%b at %0s", expect_19, conveyor, empty, "conveyor_run_out.ladder:124");
    end
    start = 1'd1;
    finish = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_20 !== 1'b1) begin // conveyor_run_out.ladder:126
      failed = 1'b1;
      $display("# failed expectation 20 conducts %b conveyor=%b at %0s", expect_20, conveyor, "conveyor_run_out.ladder:126");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "start takes a finish back; both at once finish");
    end else $display("ok 7 - %0s", "start takes a finish back; both at once finish");

    if (failures != 0) $display("# %0d of 7 tests failed", failures);
    $finish;
  end
endmodule
