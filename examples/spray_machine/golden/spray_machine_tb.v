// Made by hotrail 0.1.0 from spray_machine.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module spray_machine_expect (
  input  wire clk,
  input  wire rst,
  input  wire forward,
  input  wire reverse,
  input  wire spray,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_0_2,
  output wire expect_1_0,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_3_0,
  output wire expect_4_0,
  output wire expect_4_1,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_7_0,
  output wire expect_7_1,
  output wire expect_8_0,
  output wire expect_8_1,
  output wire expect_9_0,
  output wire expect_10_0,
  output wire expect_10_1,
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_12_0,
  output wire expect_13_0,
  output wire expect_13_1,
  output wire expect_14_0,
  output wire expect_14_1,
  output wire expect_14_2,
  output wire expect_15_0,
  output wire expect_15_1,
  output wire expect_15_2,
  output wire expect_16_0,
  output wire expect_16_1,
  output wire expect_16_2,
  output wire expect_17_0,
  output wire expect_17_1,
  output wire expect_17_2,
  output wire expect_18_0,
  output wire expect_18_1,
  output wire expect_19_0,
  output wire expect_20_0,
  output wire expect_21_0,
  output wire expect_22_0,
  output wire expect_22_1,
  output wire expect_23_0,
  output wire expect_23_1,
  output wire expect_24_0,
  output wire expect_24_1,
  output wire expect_25_0,
  output wire expect_25_1,
  output wire expect_26_0,
  output wire expect_27_0,
  output wire expect_27_1,
  output wire expect_28_0,
  output wire expect_28_1,
  output wire expect_29_0,
  output wire expect_30_0,
  output wire expect_30_1,
  output wire expect_31_0,
  output wire expect_31_1,
  output wire expect_32_0,
  output wire expect_32_1,
  output wire expect_33_0,
  output wire expect_34_0,
  output wire expect_34_1,
  output wire expect_35_0,
  output wire expect_36_0,
  output wire expect_36_1,
  output wire expect_37_0,
  output wire expect_37_1,
  output wire expect_38_0
);

  assign expect_0_0 = forward;
  assign expect_0_1 = ~reverse;
  assign expect_0_2 = ~spray;
  assign expect_1_0 = forward;
  assign expect_2_0 = forward;
  assign expect_2_1 = spray;
  assign expect_3_0 = spray;
  assign expect_4_0 = forward;
  assign expect_4_1 = ~spray;
  assign expect_5_0 = ~forward;
  assign expect_5_1 = ~reverse;
  assign expect_6_0 = ~forward;
  assign expect_6_1 = ~reverse;
  assign expect_7_0 = reverse;
  assign expect_7_1 = ~forward;
  assign expect_8_0 = reverse;
  assign expect_8_1 = ~spray;
  assign expect_9_0 = reverse;
  assign expect_10_0 = ~reverse;
  assign expect_10_1 = ~forward;
  assign expect_11_0 = ~reverse;
  assign expect_11_1 = ~forward;
  assign expect_12_0 = forward;
  assign expect_13_0 = forward;
  assign expect_13_1 = spray;
  assign expect_14_0 = ~forward;
  assign expect_14_1 = ~spray;
  assign expect_14_2 = ~reverse;
  assign expect_15_0 = ~forward;
  assign expect_15_1 = ~spray;
  assign expect_15_2 = ~reverse;
  assign expect_16_0 = ~reverse;
  assign expect_16_1 = ~forward;
  assign expect_16_2 = ~spray;
  assign expect_17_0 = reverse;
  assign expect_17_1 = ~forward;
  assign expect_17_2 = ~spray;
  assign expect_18_0 = ~reverse;
  assign expect_18_1 = ~forward;
  assign expect_19_0 = ~reverse;
  assign expect_20_0 = ~reverse;
  assign expect_21_0 = reverse;
  assign expect_22_0 = ~forward;
  assign expect_22_1 = ~reverse;
  assign expect_23_0 = ~forward;
  assign expect_23_1 = ~reverse;
  assign expect_24_0 = ~forward;
  assign expect_24_1 = ~reverse;
  assign expect_25_0 = ~forward;
  assign expect_25_1 = reverse;
  assign expect_26_0 = reverse;
  assign expect_27_0 = ~reverse;
  assign expect_27_1 = ~forward;
  assign expect_28_0 = ~reverse;
  assign expect_28_1 = ~forward;
  assign expect_29_0 = spray;
  assign expect_30_0 = ~spray;
  assign expect_30_1 = ~forward;
  assign expect_31_0 = ~spray;
  assign expect_31_1 = ~forward;
  assign expect_32_0 = forward;
  assign expect_32_1 = ~reverse;
  assign expect_33_0 = reverse;
  assign expect_34_0 = reverse;
  assign expect_34_1 = ~forward;
  assign expect_35_0 = reverse;
  assign expect_36_0 = ~forward;
  assign expect_36_1 = ~reverse;
  assign expect_37_0 = ~forward;
  assign expect_37_1 = ~reverse;
  assign expect_38_0 = ~forward;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module spray_machine_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg stop = 1'd0;
  reg home = 1'd0;
  reg at_end = 1'd0;
  reg middle = 1'd0;
  wire forward;
  wire reverse;
  wire spray;
  reg failed;
  integer failures;

  spray_machine core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .stop(stop),
    .home(home),
    .at_end(at_end),
    .middle(middle),
    .forward(forward),
    .reverse(reverse),
    .spray(spray)
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
  wire [0:0] expect_3 = {expect_3_0};
  wire expect_4_0;
  wire expect_4_1;
  wire [0:1] expect_4 = {expect_4_0, expect_4_1};
  wire expect_5_0;
  wire expect_5_1;
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
  wire expect_8_0;
  wire expect_8_1;
  wire [0:1] expect_8 = {expect_8_0, expect_8_1};
  wire expect_9_0;
  wire [0:0] expect_9 = {expect_9_0};
  wire expect_10_0;
  wire expect_10_1;
  wire [0:1] expect_10 = {expect_10_0, expect_10_1};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire expect_13_1;
  wire [0:1] expect_13 = {expect_13_0, expect_13_1};
  wire expect_14_0;
  wire expect_14_1;
  wire expect_14_2;
  wire [0:2] expect_14 = {expect_14_0, expect_14_1, expect_14_2};
  wire expect_15_0;
  wire expect_15_1;
  wire expect_15_2;
  wire [0:2] expect_15 = {expect_15_0, expect_15_1, expect_15_2};
  wire expect_16_0;
  wire expect_16_1;
  wire expect_16_2;
  wire [0:2] expect_16 = {expect_16_0, expect_16_1, expect_16_2};
  wire expect_17_0;
  wire expect_17_1;
  wire expect_17_2;
  wire [0:2] expect_17 = {expect_17_0, expect_17_1, expect_17_2};
  wire expect_18_0;
  wire expect_18_1;
  wire [0:1] expect_18 = {expect_18_0, expect_18_1};
  wire expect_19_0;
  wire [0:0] expect_19 = {expect_19_0};
  wire expect_20_0;
  wire [0:0] expect_20 = {expect_20_0};
  wire expect_21_0;
  wire [0:0] expect_21 = {expect_21_0};
  wire expect_22_0;
  wire expect_22_1;
  wire [0:1] expect_22 = {expect_22_0, expect_22_1};
  wire expect_23_0;
  wire expect_23_1;
  wire [0:1] expect_23 = {expect_23_0, expect_23_1};
  wire expect_24_0;
  wire expect_24_1;
  wire [0:1] expect_24 = {expect_24_0, expect_24_1};
  wire expect_25_0;
  wire expect_25_1;
  wire [0:1] expect_25 = {expect_25_0, expect_25_1};
  wire expect_26_0;
  wire [0:0] expect_26 = {expect_26_0};
  wire expect_27_0;
  wire expect_27_1;
  wire [0:1] expect_27 = {expect_27_0, expect_27_1};
  wire expect_28_0;
  wire expect_28_1;
  wire [0:1] expect_28 = {expect_28_0, expect_28_1};
  wire expect_29_0;
  wire [0:0] expect_29 = {expect_29_0};
  wire expect_30_0;
  wire expect_30_1;
  wire [0:1] expect_30 = {expect_30_0, expect_30_1};
  wire expect_31_0;
  wire expect_31_1;
  wire [0:1] expect_31 = {expect_31_0, expect_31_1};
  wire expect_32_0;
  wire expect_32_1;
  wire [0:1] expect_32 = {expect_32_0, expect_32_1};
  wire expect_33_0;
  wire [0:0] expect_33 = {expect_33_0};
  wire expect_34_0;
  wire expect_34_1;
  wire [0:1] expect_34 = {expect_34_0, expect_34_1};
  wire expect_35_0;
  wire [0:0] expect_35 = {expect_35_0};
  wire expect_36_0;
  wire expect_36_1;
  wire [0:1] expect_36 = {expect_36_0, expect_36_1};
  wire expect_37_0;
  wire expect_37_1;
  wire [0:1] expect_37 = {expect_37_0, expect_37_1};
  wire expect_38_0;
  wire [0:0] expect_38 = {expect_38_0};
  spray_machine_expect expectations (
    .clk(clk),
    .rst(rst),
    .forward(forward),
    .reverse(reverse),
    .spray(spray),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_13_1(expect_13_1),
    .expect_14_0(expect_14_0),
    .expect_14_1(expect_14_1),
    .expect_14_2(expect_14_2),
    .expect_15_0(expect_15_0),
    .expect_15_1(expect_15_1),
    .expect_15_2(expect_15_2),
    .expect_16_0(expect_16_0),
    .expect_16_1(expect_16_1),
    .expect_16_2(expect_16_2),
    .expect_17_0(expect_17_0),
    .expect_17_1(expect_17_1),
    .expect_17_2(expect_17_2),
    .expect_18_0(expect_18_0),
    .expect_18_1(expect_18_1),
    .expect_19_0(expect_19_0),
    .expect_20_0(expect_20_0),
    .expect_21_0(expect_21_0),
    .expect_22_0(expect_22_0),
    .expect_22_1(expect_22_1),
    .expect_23_0(expect_23_0),
    .expect_23_1(expect_23_1),
    .expect_24_0(expect_24_0),
    .expect_24_1(expect_24_1),
    .expect_25_0(expect_25_0),
    .expect_25_1(expect_25_1),
    .expect_26_0(expect_26_0),
    .expect_27_0(expect_27_0),
    .expect_27_1(expect_27_1),
    .expect_28_0(expect_28_0),
    .expect_28_1(expect_28_1),
    .expect_29_0(expect_29_0),
    .expect_30_0(expect_30_0),
    .expect_30_1(expect_30_1),
    .expect_31_0(expect_31_0),
    .expect_31_1(expect_31_1),
    .expect_32_0(expect_32_0),
    .expect_32_1(expect_32_1),
    .expect_33_0(expect_33_0),
    .expect_34_0(expect_34_0),
    .expect_34_1(expect_34_1),
    .expect_35_0(expect_35_0),
    .expect_36_0(expect_36_0),
    .expect_36_1(expect_36_1),
    .expect_37_0(expect_37_0),
    .expect_37_1(expect_37_1),
    .expect_38_0(expect_38_0)
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
      home = 1'd0;
      at_end = 1'd0;
      middle = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..9");

    // a part there and back
    failed = 1'b0;
    reset;
    stop = 1'd1;
    home = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // spray_machine.ladder:30
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b forward=%b reverse=%b spray=%b at %0s", expect_0, forward, reverse, spray, "spray_machine.ladder:30");
    end
    scan(10, 1'b1);
    home = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // spray_machine.ladder:33
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b forward=%b at %0s", expect_1, forward, "spray_machine.ladder:33");
    end
    scan(30, 1'b1);
    middle = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // spray_machine.ladder:36
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b forward=%b spray=%b at %0s", expect_2, forward, spray, "spray_machine.ladder:36");
    end
    scan(5, 1'b1);
    middle = 1'd0;
    scan(1, 1'b0);
    scan(14, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // spray_machine.ladder:40
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b spray=%b at %0s", expect_3, spray, "spray_machine.ladder:40");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // spray_machine.ladder:42
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b forward=%b spray=%b at %0s", expect_4, forward, spray, "spray_machine.ladder:42");
    end
    scan(10, 1'b1);
    at_end = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // spray_machine.ladder:45
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b forward=%b reverse=%b at %0s", expect_5, forward, reverse, "spray_machine.ladder:45");
    end
    scan(14, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // spray_machine.ladder:47
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b forward=%b reverse=%b at %0s", expect_6, forward, reverse, "spray_machine.ladder:47");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // spray_machine.ladder:49
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b reverse=%b forward=%b at %0s", expect_7, reverse, forward, "spray_machine.ladder:49");
    end
    at_end = 1'd0;
    scan(20, 1'b1);
    middle = 1'd1;
    scan(10, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // spray_machine.ladder:52
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b reverse=%b spray=%b at %0s", expect_8, reverse, spray, "spray_machine.ladder:52");
    end
    middle = 1'd0;
    scan(20, 1'b1);
    #1 if (!failed && &expect_9 !== 1'b1) begin // spray_machine.ladder:54
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b reverse=%b at %0s", expect_9, reverse, "spray_machine.ladder:54");
    end
    home = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // spray_machine.ladder:56
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b reverse=%b forward=%b at %0s", expect_10, reverse, forward, "spray_machine.ladder:56");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // spray_machine.ladder:58
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b reverse=%b forward=%b at %0s", expect_11, reverse, forward, "spray_machine.ladder:58");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // spray_machine.ladder:60
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b forward=%b at %0s", expect_12, forward, "spray_machine.ladder:60");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "a part there and back");
    end else $display("ok 1 - %0s", "a part there and back");

    // stop in the middle: the next start brings the part home
    failed = 1'b0;
    reset;
    stop = 1'd1;
    home = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    home = 1'd0;
    scan(10, 1'b1);
    middle = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // spray_machine.ladder:67
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b forward=%b spray=%b at %0s", expect_13, forward, spray, "spray_machine.ladder:67");
    end
    stop = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // spray_machine.ladder:69
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b forward=%b spray=%b reverse=%b at %0s", expect_14, forward, spray, reverse, "spray_machine.ladder:69");
    end
    stop = 1'd1;
    scan(100, 1'b1);
    #1 if (!failed && &expect_15 !== 1'b1) begin // spray_machine.ladder:71
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b forward=%b spray=%b reverse=%b at %0s", expect_15, forward, spray, reverse, "spray_machine.ladder:71");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(14, 1'b1);
    #1 if (!failed && &expect_16 !== 1'b1) begin // spray_machine.ladder:74
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b reverse=%b forward=%b spray=%b at %0s", expect_16, reverse, forward, spray, "spray_machine.ladder:74");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_17 !== 1'b1) begin // spray_machine.ladder:76
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b reverse=%b forward=%b spray=%b at %0s", expect_17, reverse, forward, spray, "spray_machine.ladder:76");
    end
    middle = 1'd0;
    home = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_18 !== 1'b1) begin // spray_machine.ladder:78
      failed = 1'b1;
      $display("# failed expectation 18 conducts %b reverse=%b forward=%b at %0s", expect_18, reverse, forward, "spray_machine.ladder:78");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "stop in the middle: the next start brings the part home");
    end else $display("ok 2 - %0s", "stop in the middle: the next start brings the part home");

    // stop at the end: the rest begins anew
    failed = 1'b0;
    reset;
    stop = 1'd1;
    at_end = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(14, 1'b1);
    stop = 1'd0;
    scan(1, 1'b0);
    stop = 1'd1;
    scan(50, 1'b1);
    #1 if (!failed && &expect_19 !== 1'b1) begin // spray_machine.ladder:86
      failed = 1'b1;
      $display("# failed expectation 19 conducts %b reverse=%b at %0s", expect_19, reverse, "spray_machine.ladder:86");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(14, 1'b1);
    #1 if (!failed && &expect_20 !== 1'b1) begin // spray_machine.ladder:89
      failed = 1'b1;
      $display("# failed expectation 20 conducts %b reverse=%b at %0s", expect_20, reverse, "spray_machine.ladder:89");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_21 !== 1'b1) begin // spray_machine.ladder:91
      failed = 1'b1;
      $display("# failed expectation 21 conducts %b reverse=%b at %0s", expect_21, reverse, "spray_machine.ladder:91");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "stop at the end: the rest begins anew");
    end else $display("ok 3 - %0s", "stop at the end: the rest begins anew");

    // an end switch that bounces shortens no rest and turns nothing round
    failed = 1'b0;
    reset;
    stop = 1'd1;
    home = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    home = 1'd0;
    scan(50, 1'b1);
    at_end = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_22 !== 1'b1) begin // spray_machine.ladder:98
      failed = 1'b1;
      $display("# failed expectation 22 conducts %b forward=%b reverse=%b at %0s", expect_22, forward, reverse, "spray_machine.ladder:98");
    end
    repeat (7) begin
      at_end = 1'd0;
      scan(1, 1'b1);
      #1 if (!failed && &expect_23 !== 1'b1) begin // spray_machine.ladder:101
        failed = 1'b1;
        $display("# failed expectation 23 conducts %b forward=%b reverse=%b at %0s", expect_23, forward, reverse, "spray_machine.ladder:101");
      end
      at_end = 1'd1;
      scan(1, 1'b1);
      #1 if (!failed && &expect_24 !== 1'b1) begin // spray_machine.ladder:103
        failed = 1'b1;
        $display("# failed expectation 24 conducts %b forward=%b reverse=%b at %0s", expect_24, forward, reverse, "spray_machine.ladder:103");
      end
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_25 !== 1'b1) begin // spray_machine.ladder:106
      failed = 1'b1;
      $display("# failed expectation 25 conducts %b forward=%b reverse=%b at %0s", expect_25, forward, reverse, "spray_machine.ladder:106");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "an end switch that bounces shortens no rest and turns nothing round");
    end else $display("ok 4 - %0s", "an end switch that bounces shortens no rest and turns nothing round");

    // a home switch that bounces ends the cycle once
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(15, 1'b1);
    #1 if (!failed && &expect_26 !== 1'b1) begin // spray_machine.ladder:112
      failed = 1'b1;
      $display("# failed expectation 26 conducts %b reverse=%b at %0s", expect_26, reverse, "spray_machine.ladder:112");
    end
    repeat (3) begin
      home = 1'd1;
      scan(1, 1'b0);
      #1 if (!failed && &expect_27 !== 1'b1) begin // spray_machine.ladder:115
        failed = 1'b1;
        $display("# failed expectation 27 conducts %b reverse=%b forward=%b at %0s", expect_27, reverse, forward, "spray_machine.ladder:115");
      end
      home = 1'd0;
      scan(1, 1'b0);
      #1 if (!failed && &expect_28 !== 1'b1) begin // spray_machine.ladder:117
        failed = 1'b1;
        $display("# failed expectation 28 conducts %b reverse=%b forward=%b at %0s", expect_28, reverse, forward, "spray_machine.ladder:117");
      end
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a home switch that bounces ends the cycle once");
    end else $display("ok 5 - %0s", "a home switch that bounces ends the cycle once");

    // spraying ends with the forward motion
    failed = 1'b0;
    reset;
    stop = 1'd1;
    home = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    home = 1'd0;
    middle = 1'd1;
    scan(10, 1'b1);
    #1 if (!failed && &expect_29 !== 1'b1) begin // spray_machine.ladder:124
      failed = 1'b1;
      $display("# failed expectation 29 conducts %b spray=%b at %0s", expect_29, spray, "spray_machine.ladder:124");
    end
    at_end = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_30 !== 1'b1) begin // spray_machine.ladder:126
      failed = 1'b1;
      $display("# failed expectation 30 conducts %b spray=%b forward=%b at %0s", expect_30, spray, forward, "spray_machine.ladder:126");
    end
    at_end = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_31 !== 1'b1) begin // spray_machine.ladder:128
      failed = 1'b1;
      $display("# failed expectation 31 conducts %b spray=%b forward=%b at %0s", expect_31, spray, forward, "spray_machine.ladder:128");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "spraying ends with the forward motion");
    end else $display("ok 6 - %0s", "spraying ends with the forward motion");

    // start once more during the motion changes nothing
    failed = 1'b0;
    reset;
    stop = 1'd1;
    home = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    home = 1'd0;
    scan(10, 1'b1);
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_32 !== 1'b1) begin // spray_machine.ladder:135
      failed = 1'b1;
      $display("# failed expectation 32 conducts %b forward=%b reverse=%b at %0s", expect_32, forward, reverse, "spray_machine.ladder:135");
    end
    at_end = 1'd1;
    scan(20, 1'b1);
    #1 if (!failed && &expect_33 !== 1'b1) begin // spray_machine.ladder:137
      failed = 1'b1;
      $display("# failed expectation 33 conducts %b reverse=%b at %0s", expect_33, reverse, "spray_machine.ladder:137");
    end
    at_end = 1'd0;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_34 !== 1'b1) begin // spray_machine.ladder:139
      failed = 1'b1;
      $display("# failed expectation 34 conducts %b reverse=%b forward=%b at %0s", expect_34, reverse, forward, "spray_machine.ladder:139");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "start once more during the motion changes nothing");
    end else $display("ok 7 - %0s", "start once more during the motion changes nothing");

    // a held start button makes one cycle
    failed = 1'b0;
    reset;
    stop = 1'd1;
    home = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    home = 1'd0;
    scan(10, 1'b1);
    at_end = 1'd1;
    scan(20, 1'b1);
    at_end = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_35 !== 1'b1) begin // spray_machine.ladder:146
      failed = 1'b1;
      $display("# failed expectation 35 conducts %b reverse=%b at %0s", expect_35, reverse, "spray_machine.ladder:146");
    end
    home = 1'd1;
    scan(1, 1'b0);
    scan(50, 1'b1);
    #1 if (!failed && &expect_36 !== 1'b1) begin // spray_machine.ladder:149
      failed = 1'b1;
      $display("# failed expectation 36 conducts %b forward=%b reverse=%b at %0s", expect_36, forward, reverse, "spray_machine.ladder:149");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 8 - %0s", "a held start button makes one cycle");
    end else $display("ok 8 - %0s", "a held start button makes one cycle");

    // stop wins over start
    failed = 1'b0;
    reset;
    home = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_37 !== 1'b1) begin // spray_machine.ladder:153
      failed = 1'b1;
      $display("# failed expectation 37 conducts %b forward=%b reverse=%b at %0s", expect_37, forward, reverse, "spray_machine.ladder:153");
    end
    stop = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_38 !== 1'b1) begin // spray_machine.ladder:155
      failed = 1'b1;
      $display("# failed expectation 38 conducts %b forward=%b at %0s", expect_38, forward, "spray_machine.ladder:155");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 9 - %0s", "stop wins over start");
    end else $display("ok 9 - %0s", "stop wins over start");

    if (failures != 0) $display("# %0d of 9 tests failed", failures);
    $finish;
  end
endmodule
