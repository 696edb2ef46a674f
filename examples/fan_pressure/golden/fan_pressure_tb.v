// Made by hotrail 0.1.0 from fan_pressure.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module fan_pressure_expect (
  input  wire clk,
  input  wire rst,
  input  wire fan,
  input  wire tripped,
  output wire expect_0_0,
  output wire expect_1_0,
  output wire expect_1_1,
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
  output wire expect_9_0,
  output wire expect_10_0,
  output wire expect_10_1,
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_12_0,
  output wire expect_12_1,
  output wire expect_13_0,
  output wire expect_14_0,
  output wire expect_15_0,
  output wire expect_16_0,
  output wire expect_16_1,
  output wire expect_17_0,
  output wire expect_17_1
);

  assign expect_0_0 = fan;
  assign expect_1_0 = fan;
  assign expect_1_1 = ~tripped;
  assign expect_2_0 = fan;
  assign expect_2_1 = ~tripped;
  assign expect_3_0 = fan;
  assign expect_4_0 = ~fan;
  assign expect_4_1 = tripped;
  assign expect_5_0 = ~fan;
  assign expect_5_1 = tripped;
  assign expect_6_0 = ~fan;
  assign expect_6_1 = tripped;
  assign expect_7_0 = fan;
  assign expect_7_1 = ~tripped;
  assign expect_8_0 = ~fan;
  assign expect_9_0 = ~tripped;
  assign expect_10_0 = ~fan;
  assign expect_10_1 = ~tripped;
  assign expect_11_0 = fan;
  assign expect_11_1 = ~tripped;
  assign expect_12_0 = ~fan;
  assign expect_12_1 = tripped;
  assign expect_13_0 = ~fan;
  assign expect_14_0 = ~fan;
  assign expect_15_0 = fan;
  assign expect_16_0 = ~fan;
  assign expect_16_1 = tripped;
  assign expect_17_0 = ~fan;
  assign expect_17_1 = tripped;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module fan_pressure_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg stop = 1'd0;
  reg low_pressure = 1'd0;
  wire fan;
  wire tripped;
  reg failed;
  integer failures;

  fan_pressure core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .stop(stop),
    .low_pressure(low_pressure),
    .fan(fan),
    .tripped(tripped)
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
  wire [0:0] expect_8 = {expect_8_0};
  wire expect_9_0;
  wire [0:0] expect_9 = {expect_9_0};
  wire expect_10_0;
  wire expect_10_1;
  wire [0:1] expect_10 = {expect_10_0, expect_10_1};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
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
  wire expect_16_1;
  wire [0:1] expect_16 = {expect_16_0, expect_16_1};
  wire expect_17_0;
  wire expect_17_1;
  wire [0:1] expect_17 = {expect_17_0, expect_17_1};
  fan_pressure_expect expectations (
    .clk(clk),
    .rst(rst),
    .fan(fan),
    .tripped(tripped),
    .expect_0_0(expect_0_0),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
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
    .expect_9_0(expect_9_0),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_16_0(expect_16_0),
    .expect_16_1(expect_16_1),
    .expect_17_0(expect_17_0),
    .expect_17_1(expect_17_1)
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
      low_pressure = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..6");

    // the pressure comes while the fan runs up
    failed = 1'b0;
    reset;
    stop = 1'd1;
    low_pressure = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // fan_pressure.ladder:25
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b fan=%b at %0s", expect_0, fan, "fan_pressure.ladder:25");
    end
    scan(79, 1'b1);
    low_pressure = 1'd0;
    scan(1, 1'b0);
    scan(600, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // fan_pressure.ladder:29
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b fan=%b tripped=%b at %0s", expect_1, fan, tripped, "fan_pressure.ladder:29");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "the pressure comes while the fan runs up");
    end else $display("ok 1 - %0s", "the pressure comes while the fan runs up");

    // no pressure after 8 s
    failed = 1'b0;
    reset;
    stop = 1'd1;
    low_pressure = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(79, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // fan_pressure.ladder:36
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b fan=%b tripped=%b at %0s", expect_2, fan, tripped, "fan_pressure.ladder:36");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // fan_pressure.ladder:38
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b fan=%b at %0s", expect_3, fan, "fan_pressure.ladder:38");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // fan_pressure.ladder:40
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b fan=%b tripped=%b at %0s", expect_4, fan, tripped, "fan_pressure.ladder:40");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "no pressure after 8 s");
    end else $display("ok 2 - %0s", "no pressure after 8 s");

    // pressure lost later stops the fan at once
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(300, 1'b1);
    low_pressure = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // fan_pressure.ladder:47
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b fan=%b tripped=%b at %0s", expect_5, fan, tripped, "fan_pressure.ladder:47");
    end
    low_pressure = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // fan_pressure.ladder:49
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b fan=%b tripped=%b at %0s", expect_6, fan, tripped, "fan_pressure.ladder:49");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // fan_pressure.ladder:51
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b fan=%b tripped=%b at %0s", expect_7, fan, tripped, "fan_pressure.ladder:51");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "pressure lost later stops the fan at once");
    end else $display("ok 3 - %0s", "pressure lost later stops the fan at once");

    // after a stop the low pressure is no fault
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(300, 1'b1);
    stop = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // fan_pressure.ladder:58
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b fan=%b at %0s", expect_8, fan, "fan_pressure.ladder:58");
    end
    low_pressure = 1'd1;
    stop = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // fan_pressure.ladder:60
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b tripped=%b at %0s", expect_9, tripped, "fan_pressure.ladder:60");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // fan_pressure.ladder:62
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b fan=%b tripped=%b at %0s", expect_10, fan, tripped, "fan_pressure.ladder:62");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "after a stop the low pressure is no fault");
    end else $display("ok 4 - %0s", "after a stop the low pressure is no fault");

    // the run-up begins anew with each start
    failed = 1'b0;
    reset;
    stop = 1'd1;
    low_pressure = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(79, 1'b1);
    stop = 1'd0;
    scan(1, 1'b0);
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(79, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // fan_pressure.ladder:73
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b fan=%b tripped=%b at %0s", expect_11, fan, tripped, "fan_pressure.ladder:73");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // fan_pressure.ladder:76
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b fan=%b tripped=%b at %0s", expect_12, fan, tripped, "fan_pressure.ladder:76");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "the run-up begins anew with each start");
    end else $display("ok 5 - %0s", "the run-up begins anew with each start");

    // both buttons at once, and a start button that is stuck
    failed = 1'b0;
    reset;
    start = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // fan_pressure.ladder:80
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b fan=%b at %0s", expect_13, fan, "fan_pressure.ladder:80");
    end
    stop = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // fan_pressure.ladder:82
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b fan=%b at %0s", expect_14, fan, "fan_pressure.ladder:82");
    end
    start = 1'd0;
    scan(1, 1'b0);
    start = 1'd1;
    low_pressure = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // fan_pressure.ladder:85
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b fan=%b at %0s", expect_15, fan, "fan_pressure.ladder:85");
    end
    scan(80, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_16 !== 1'b1) begin // fan_pressure.ladder:88
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b fan=%b tripped=%b at %0s", expect_16, fan, tripped, "fan_pressure.ladder:88");
    end
    scan(200, 1'b1);
    #1 if (!failed && &expect_17 !== 1'b1) begin // fan_pressure.ladder:90
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b fan=%b tripped=%b at %0s", expect_17, fan, tripped, "fan_pressure.ladder:90");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "both buttons at once, and a start button that is stuck");
    end else $display("ok 6 - %0s", "both buttons at once, and a start button that is stuck");

    if (failures != 0) $display("# %0d of 6 tests failed", failures);
    $finish;
  end
endmodule
