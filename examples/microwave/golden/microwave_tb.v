// Made by hotrail 0.1.0 from microwave.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module microwave_expect (
  input  wire clk,
  input  wire rst,
  input  wire magnetron,
  input  wire turntable,
  input  wire ready,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_0_2,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_2_0,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_3_2,
  output wire expect_4_0,
  output wire expect_4_1,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_6_0,
  output wire expect_7_0,
  output wire expect_7_1,
  output wire expect_8_0,
  output wire expect_8_1,
  output wire expect_9_0,
  output wire expect_9_1,
  output wire expect_10_0,
  output wire expect_10_1,
  output wire expect_11_0,
  output wire expect_12_0,
  output wire expect_12_1,
  output wire expect_13_0,
  output wire expect_14_0,
  output wire expect_15_0,
  output wire expect_16_0,
  output wire expect_17_0,
  output wire expect_17_1,
  output wire expect_18_0,
  output wire expect_19_0,
  output wire expect_20_0,
  output wire expect_20_1,
  output wire expect_21_0,
  output wire expect_21_1,
  output wire expect_22_0,
  output wire expect_23_0,
  output wire expect_23_1,
  output wire expect_24_0,
  output wire expect_25_0,
  output wire expect_26_0,
  output wire expect_27_0,
  output wire expect_28_0,
  output wire expect_28_1,
  output wire expect_29_0,
  output wire expect_29_1,
  output wire expect_30_0,
  output wire expect_31_0,
  output wire expect_31_1,
  output wire expect_32_0,
  output wire expect_33_0
);

  assign expect_0_0 = magnetron;
  assign expect_0_1 = turntable;
  assign expect_0_2 = ~ready;
  assign expect_1_0 = magnetron;
  assign expect_1_1 = ~ready;
  assign expect_2_0 = ready;
  assign expect_3_0 = ready;
  assign expect_3_1 = ~magnetron;
  assign expect_3_2 = ~turntable;
  assign expect_4_0 = ready;
  assign expect_4_1 = ~magnetron;
  assign expect_5_0 = ~magnetron;
  assign expect_5_1 = turntable;
  assign expect_6_0 = ~magnetron;
  assign expect_7_0 = ~magnetron;
  assign expect_7_1 = turntable;
  assign expect_8_0 = magnetron;
  assign expect_8_1 = turntable;
  assign expect_9_0 = magnetron;
  assign expect_9_1 = ~ready;
  assign expect_10_0 = ~magnetron;
  assign expect_10_1 = ready;
  assign expect_11_0 = ~magnetron;
  assign expect_12_0 = magnetron;
  assign expect_12_1 = ~ready;
  assign expect_13_0 = ~ready;
  assign expect_14_0 = ready;
  assign expect_15_0 = ~magnetron;
  assign expect_16_0 = magnetron;
  assign expect_17_0 = ~magnetron;
  assign expect_17_1 = ~turntable;
  assign expect_18_0 = ~magnetron;
  assign expect_19_0 = magnetron;
  assign expect_20_0 = magnetron;
  assign expect_20_1 = ~ready;
  assign expect_21_0 = ~magnetron;
  assign expect_21_1 = ready;
  assign expect_22_0 = ready;
  assign expect_23_0 = ready;
  assign expect_23_1 = ~magnetron;
  assign expect_24_0 = ~ready;
  assign expect_25_0 = magnetron;
  assign expect_26_0 = ~ready;
  assign expect_27_0 = ready;
  assign expect_28_0 = ~magnetron;
  assign expect_28_1 = ~turntable;
  assign expect_29_0 = ~ready;
  assign expect_29_1 = magnetron;
  assign expect_30_0 = ready;
  assign expect_31_0 = ~magnetron;
  assign expect_31_1 = ~turntable;
  assign expect_32_0 = ~magnetron;
  assign expect_33_0 = ~magnetron;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module microwave_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg cancel = 1'd0;
  reg door = 1'd0;
  reg foam = 1'd0;
  wire magnetron;
  wire turntable;
  wire ready;
  reg failed;
  integer failures;

  microwave core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .cancel(cancel),
    .door(door),
    .foam(foam),
    .magnetron(magnetron),
    .turntable(turntable),
    .ready(ready)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire [0:2] expect_0 = {expect_0_0, expect_0_1, expect_0_2};
  wire expect_1_0;
  wire expect_1_1;
  wire [0:1] expect_1 = {expect_1_0, expect_1_1};
  wire expect_2_0;
  wire [0:0] expect_2 = {expect_2_0};
  wire expect_3_0;
  wire expect_3_1;
  wire expect_3_2;
  wire [0:2] expect_3 = {expect_3_0, expect_3_1, expect_3_2};
  wire expect_4_0;
  wire expect_4_1;
  wire [0:1] expect_4 = {expect_4_0, expect_4_1};
  wire expect_5_0;
  wire expect_5_1;
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  wire expect_6_0;
  wire [0:0] expect_6 = {expect_6_0};
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
  wire expect_10_1;
  wire [0:1] expect_10 = {expect_10_0, expect_10_1};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  wire expect_12_0;
  wire expect_12_1;
  wire [0:1] expect_12 = {expect_12_0, expect_12_1};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  wire expect_16_0;
  wire [0:0] expect_16 = {expect_16_0};
  wire expect_17_0;
  wire expect_17_1;
  wire [0:1] expect_17 = {expect_17_0, expect_17_1};
  wire expect_18_0;
  wire [0:0] expect_18 = {expect_18_0};
  wire expect_19_0;
  wire [0:0] expect_19 = {expect_19_0};
  wire expect_20_0;
  wire expect_20_1;
  wire [0:1] expect_20 = {expect_20_0, expect_20_1};
  wire expect_21_0;
  wire expect_21_1;
  wire [0:1] expect_21 = {expect_21_0, expect_21_1};
  wire expect_22_0;
  wire [0:0] expect_22 = {expect_22_0};
  wire expect_23_0;
  wire expect_23_1;
  wire [0:1] expect_23 = {expect_23_0, expect_23_1};
  wire expect_24_0;
  wire [0:0] expect_24 = {expect_24_0};
  wire expect_25_0;
  wire [0:0] expect_25 = {expect_25_0};
  wire expect_26_0;
  wire [0:0] expect_26 = {expect_26_0};
  wire expect_27_0;
  wire [0:0] expect_27 = {expect_27_0};
  wire expect_28_0;
  wire expect_28_1;
  wire [0:1] expect_28 = {expect_28_0, expect_28_1};
  wire expect_29_0;
  wire expect_29_1;
  wire [0:1] expect_29 = {expect_29_0, expect_29_1};
  wire expect_30_0;
  wire [0:0] expect_30 = {expect_30_0};
  wire expect_31_0;
  wire expect_31_1;
  wire [0:1] expect_31 = {expect_31_0, expect_31_1};
  wire expect_32_0;
  wire [0:0] expect_32 = {expect_32_0};
  wire expect_33_0;
  wire [0:0] expect_33 = {expect_33_0};
  microwave_expect expectations (
    .clk(clk),
    .rst(rst),
    .magnetron(magnetron),
    .turntable(turntable),
    .ready(ready),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_16_0(expect_16_0),
    .expect_17_0(expect_17_0),
    .expect_17_1(expect_17_1),
    .expect_18_0(expect_18_0),
    .expect_19_0(expect_19_0),
    .expect_20_0(expect_20_0),
    .expect_20_1(expect_20_1),
    .expect_21_0(expect_21_0),
    .expect_21_1(expect_21_1),
    .expect_22_0(expect_22_0),
    .expect_23_0(expect_23_0),
    .expect_23_1(expect_23_1),
    .expect_24_0(expect_24_0),
    .expect_25_0(expect_25_0),
    .expect_26_0(expect_26_0),
    .expect_27_0(expect_27_0),
    .expect_28_0(expect_28_0),
    .expect_28_1(expect_28_1),
    .expect_29_0(expect_29_0),
    .expect_29_1(expect_29_1),
    .expect_30_0(expect_30_0),
    .expect_31_0(expect_31_0),
    .expect_31_1(expect_31_1),
    .expect_32_0(expect_32_0),
    .expect_33_0(expect_33_0)
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
      cancel = 1'd0;
      door = 1'd0;
      foam = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..8");

    // a bowl that does not boil
    failed = 1'b0;
    reset;
    door = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // microwave.ladder:25
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b magnetron=%b turntable=%b ready=%b at %0s", expect_0, magnetron, turntable, ready, "microwave.ladder:25");
    end
    scan(899, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // microwave.ladder:27
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b magnetron=%b ready=%b at %0s", expect_1, magnetron, ready, "microwave.ladder:27");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // microwave.ladder:29
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b ready=%b at %0s", expect_2, ready, "microwave.ladder:29");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // microwave.ladder:31
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b ready=%b magnetron=%b turntable=%b at %0s", expect_3, ready, magnetron, turntable, "microwave.ladder:31");
    end
    scan(600, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // microwave.ladder:33
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b ready=%b magnetron=%b at %0s", expect_4, ready, magnetron, "microwave.ladder:33");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "a bowl that does not boil");
    end else $display("ok 1 - %0s", "a bowl that does not boil");

    // foam: the power pauses until three seconds after it has sunk
    failed = 1'b0;
    reset;
    door = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(500, 1'b1);
    foam = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // microwave.ladder:40
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b magnetron=%b turntable=%b at %0s", expect_5, magnetron, turntable, "microwave.ladder:40");
    end
    scan(40, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // microwave.ladder:42
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b magnetron=%b at %0s", expect_6, magnetron, "microwave.ladder:42");
    end
    foam = 1'd0;
    scan(1, 1'b0);
    scan(29, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // microwave.ladder:45
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b magnetron=%b turntable=%b at %0s", expect_7, magnetron, turntable, "microwave.ladder:45");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // microwave.ladder:47
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b magnetron=%b turntable=%b at %0s", expect_8, magnetron, turntable, "microwave.ladder:47");
    end
    scan(399, 1'b1);
    #1 if (!failed && &expect_9 !== 1'b1) begin // microwave.ladder:49
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b magnetron=%b ready=%b at %0s", expect_9, magnetron, ready, "microwave.ladder:49");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // microwave.ladder:52
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b magnetron=%b ready=%b at %0s", expect_10, magnetron, ready, "microwave.ladder:52");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "foam: the power pauses until three seconds after it has sunk");
    end else $display("ok 2 - %0s", "foam: the power pauses until three seconds after it has sunk");

    // it boils again and again, and gets 90 s of power all the same
    failed = 1'b0;
    reset;
    door = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(450, 1'b1);
    repeat (9) begin
      scan(40, 1'b1);
      foam = 1'd1;
      scan(1, 1'b0);
      #1 if (!failed && &expect_11 !== 1'b1) begin // microwave.ladder:61
        failed = 1'b1;
        $display("# failed expectation 11 conducts %b magnetron=%b at %0s", expect_11, magnetron, "microwave.ladder:61");
      end
      scan(10, 1'b1);
      foam = 1'd0;
      scan(1, 1'b0);
      scan(30, 1'b1);
      #1 if (!failed && &expect_12 !== 1'b1) begin // microwave.ladder:65
        failed = 1'b1;
        $display("# failed expectation 12 conducts %b magnetron=%b ready=%b at %0s", expect_12, magnetron, ready, "microwave.ladder:65");
      end
    end
    scan(89, 1'b1);
    #1 if (!failed && &expect_13 !== 1'b1) begin // microwave.ladder:68
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b ready=%b at %0s", expect_13, ready, "microwave.ladder:68");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_14 !== 1'b1) begin // microwave.ladder:70
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b ready=%b at %0s", expect_14, ready, "microwave.ladder:70");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "it boils again and again, and gets 90 s of power all the same");
    end else $display("ok 3 - %0s", "it boils again and again, and gets 90 s of power all the same");

    // foam that flickers
    failed = 1'b0;
    reset;
    door = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    repeat (5) begin
      foam = 1'd1;
      scan(1, 1'b0);
      foam = 1'd0;
      scan(1, 1'b0);
      scan(29, 1'b1);
      #1 if (!failed && &expect_15 !== 1'b1) begin // microwave.ladder:79
        failed = 1'b1;
        $display("# failed expectation 15 conducts %b magnetron=%b at %0s", expect_15, magnetron, "microwave.ladder:79");
      end
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_16 !== 1'b1) begin // microwave.ladder:82
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b magnetron=%b at %0s", expect_16, magnetron, "microwave.ladder:82");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "foam that flickers");
    end else $display("ok 4 - %0s", "foam that flickers");

    // an open door stops it, start goes on where it was
    failed = 1'b0;
    reset;
    door = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(600, 1'b1);
    door = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_17 !== 1'b1) begin // microwave.ladder:89
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b magnetron=%b turntable=%b at %0s", expect_17, magnetron, turntable, "microwave.ladder:89");
    end
    scan(100, 1'b1);
    door = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_18 !== 1'b1) begin // microwave.ladder:92
      failed = 1'b1;
      $display("# failed expectation 18 conducts %b magnetron=%b at %0s", expect_18, magnetron, "microwave.ladder:92");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_19 !== 1'b1) begin // microwave.ladder:94
      failed = 1'b1;
      $display("# failed expectation 19 conducts %b magnetron=%b at %0s", expect_19, magnetron, "microwave.ladder:94");
    end
    scan(299, 1'b1);
    #1 if (!failed && &expect_20 !== 1'b1) begin // microwave.ladder:96
      failed = 1'b1;
      $display("# failed expectation 20 conducts %b magnetron=%b ready=%b at %0s", expect_20, magnetron, ready, "microwave.ladder:96");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_21 !== 1'b1) begin // microwave.ladder:99
      failed = 1'b1;
      $display("# failed expectation 21 conducts %b magnetron=%b ready=%b at %0s", expect_21, magnetron, ready, "microwave.ladder:99");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "an open door stops it, start goes on where it was");
    end else $display("ok 5 - %0s", "an open door stops it, start goes on where it was");

    // the next bowl: open the door, close it, start
    failed = 1'b0;
    reset;
    door = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(900, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_22 !== 1'b1) begin // microwave.ladder:106
      failed = 1'b1;
      $display("# failed expectation 22 conducts %b ready=%b at %0s", expect_22, ready, "microwave.ladder:106");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_23 !== 1'b1) begin // microwave.ladder:108
      failed = 1'b1;
      $display("# failed expectation 23 conducts %b ready=%b magnetron=%b at %0s", expect_23, ready, magnetron, "microwave.ladder:108");
    end
    door = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_24 !== 1'b1) begin // microwave.ladder:110
      failed = 1'b1;
      $display("# failed expectation 24 conducts %b ready=%b at %0s", expect_24, ready, "microwave.ladder:110");
    end
    door = 1'd1;
    scan(1, 1'b0);
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_25 !== 1'b1) begin // microwave.ladder:113
      failed = 1'b1;
      $display("# failed expectation 25 conducts %b magnetron=%b at %0s", expect_25, magnetron, "microwave.ladder:113");
    end
    scan(899, 1'b1);
    #1 if (!failed && &expect_26 !== 1'b1) begin // microwave.ladder:115
      failed = 1'b1;
      $display("# failed expectation 26 conducts %b ready=%b at %0s", expect_26, ready, "microwave.ladder:115");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_27 !== 1'b1) begin // microwave.ladder:117
      failed = 1'b1;
      $display("# failed expectation 27 conducts %b ready=%b at %0s", expect_27, ready, "microwave.ladder:117");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "the next bowl: open the door, close it, start");
    end else $display("ok 6 - %0s", "the next bowl: open the door, close it, start");

    // cancel forgets the time
    failed = 1'b0;
    reset;
    door = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(600, 1'b1);
    cancel = 1'd1;
    scan(1, 1'b0);
    cancel = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_28 !== 1'b1) begin // microwave.ladder:124
      failed = 1'b1;
      $display("# failed expectation 28 conducts %b magnetron=%b turntable=%b at %0s", expect_28, magnetron, turntable, "microwave.ladder:124");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(899, 1'b1);
    #1 if (!failed && &expect_29 !== 1'b1) begin // microwave.ladder:127
      failed = 1'b1;
      $display("# failed expectation 29 conducts %b ready=%b magnetron=%b at %0s", expect_29, ready, magnetron, "microwave.ladder:127");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_30 !== 1'b1) begin // microwave.ladder:129
      failed = 1'b1;
      $display("# failed expectation 30 conducts %b ready=%b at %0s", expect_30, ready, "microwave.ladder:129");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "cancel forgets the time");
    end else $display("ok 7 - %0s", "cancel forgets the time");

    // no power with the door open, and a held button does not wait for it
    failed = 1'b0;
    reset;
    start = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_31 !== 1'b1) begin // microwave.ladder:133
      failed = 1'b1;
      $display("# failed expectation 31 conducts %b magnetron=%b turntable=%b at %0s", expect_31, magnetron, turntable, "microwave.ladder:133");
    end
    door = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_32 !== 1'b1) begin // microwave.ladder:135
      failed = 1'b1;
      $display("# failed expectation 32 conducts %b magnetron=%b at %0s", expect_32, magnetron, "microwave.ladder:135");
    end
    cancel = 1'd1;
    start = 1'd0;
    scan(1, 1'b0);
    start = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_33 !== 1'b1) begin // microwave.ladder:138
      failed = 1'b1;
      $display("# failed expectation 33 conducts %b magnetron=%b at %0s", expect_33, magnetron, "microwave.ladder:138");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 8 - %0s", "no power with the door open, and a held button does not wait for it");
    end else $display("ok 8 - %0s", "no power with the door open, and a held button does not wait for it");

    if (failures != 0) $display("# %0d of 8 tests failed", failures);
    $finish;
  end
endmodule
