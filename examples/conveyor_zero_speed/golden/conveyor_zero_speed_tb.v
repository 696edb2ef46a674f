// Made by hotrail 0.1.0 from conveyor_zero_speed.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module conveyor_zero_speed_expect (
  input  wire clk,
  input  wire rst,
  input  wire motor,
  input  wire fault,
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
  output wire expect_10_0,
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_12_0,
  output wire expect_12_1,
  output wire expect_13_0,
  output wire expect_13_1,
  output wire expect_14_0,
  output wire expect_15_0
);

  assign expect_0_0 = motor;
  assign expect_0_1 = ~fault;
  assign expect_1_0 = motor;
  assign expect_1_1 = ~fault;
  assign expect_2_0 = ~motor;
  assign expect_2_1 = fault;
  assign expect_3_0 = motor;
  assign expect_3_1 = ~fault;
  assign expect_4_0 = ~motor;
  assign expect_4_1 = fault;
  assign expect_5_0 = motor;
  assign expect_6_0 = ~motor;
  assign expect_6_1 = fault;
  assign expect_7_0 = motor;
  assign expect_7_1 = ~fault;
  assign expect_8_0 = ~fault;
  assign expect_9_0 = ~motor;
  assign expect_10_0 = ~fault;
  assign expect_11_0 = ~motor;
  assign expect_11_1 = fault;
  assign expect_12_0 = ~motor;
  assign expect_12_1 = fault;
  assign expect_13_0 = motor;
  assign expect_13_1 = ~fault;
  assign expect_14_0 = motor;
  assign expect_15_0 = ~motor;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module conveyor_zero_speed_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg stop = 1'd0;
  reg bolt = 1'd0;
  wire motor;
  wire fault;
  reg failed;
  integer failures;

  conveyor_zero_speed core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .stop(stop),
    .bolt(bolt),
    .motor(motor),
    .fault(fault)
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
  wire [0:0] expect_9 = {expect_9_0};
  wire expect_10_0;
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire expect_12_1;
  wire [0:1] expect_12 = {expect_12_0, expect_12_1};
  wire expect_13_0;
  wire expect_13_1;
  wire [0:1] expect_13 = {expect_13_0, expect_13_1};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  conveyor_zero_speed_expect expectations (
    .clk(clk),
    .rst(rst),
    .motor(motor),
    .fault(fault),
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
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_13_0(expect_13_0),
    .expect_13_1(expect_13_1),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0)
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
      bolt = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..8");

    // a shaft that turns
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    repeat (10) begin
      bolt = 1'd1;
      scan(2, 1'b1);
      bolt = 1'd0;
      scan(13, 1'b1);
    end
    #1 if (!failed && &expect_0 !== 1'b1) begin // conveyor_zero_speed.ladder:35
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b motor=%b fault=%b at %0s", expect_0, motor, fault, "conveyor_zero_speed.ladder:35");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "a shaft that turns");
    end else $display("ok 1 - %0s", "a shaft that turns");

    // it stops with the bolt away from the switch
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    bolt = 1'd1;
    scan(2, 1'b1);
    bolt = 1'd0;
    scan(1, 1'b0);
    scan(24, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // conveyor_zero_speed.ladder:44
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b motor=%b fault=%b at %0s", expect_1, motor, fault, "conveyor_zero_speed.ladder:44");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // conveyor_zero_speed.ladder:47
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b motor=%b fault=%b at %0s", expect_2, motor, fault, "conveyor_zero_speed.ladder:47");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "it stops with the bolt away from the switch");
    end else $display("ok 2 - %0s", "it stops with the bolt away from the switch");

    // it stops with the bolt in front of the switch
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    bolt = 1'd1;
    scan(1, 1'b0);
    scan(24, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // conveyor_zero_speed.ladder:55
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b motor=%b fault=%b at %0s", expect_3, motor, fault, "conveyor_zero_speed.ladder:55");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // conveyor_zero_speed.ladder:58
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b motor=%b fault=%b at %0s", expect_4, motor, fault, "conveyor_zero_speed.ladder:58");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "it stops with the bolt in front of the switch");
    end else $display("ok 3 - %0s", "it stops with the bolt in front of the switch");

    // it never starts to turn
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(24, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // conveyor_zero_speed.ladder:65
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b motor=%b at %0s", expect_5, motor, "conveyor_zero_speed.ladder:65");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // conveyor_zero_speed.ladder:68
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b motor=%b fault=%b at %0s", expect_6, motor, fault, "conveyor_zero_speed.ladder:68");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "it never starts to turn");
    end else $display("ok 4 - %0s", "it never starts to turn");

    // a slow start is allowed
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(24, 1'b1);
    bolt = 1'd1;
    scan(1, 1'b0);
    scan(24, 1'b1);
    bolt = 1'd0;
    scan(1, 1'b0);
    scan(24, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // conveyor_zero_speed.ladder:79
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b motor=%b fault=%b at %0s", expect_7, motor, fault, "conveyor_zero_speed.ladder:79");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a slow start is allowed");
    end else $display("ok 5 - %0s", "a slow start is allowed");

    // a shaft that stands with the motor is no fault
    failed = 1'b0;
    reset;
    stop = 1'd1;
    scan(100, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // conveyor_zero_speed.ladder:84
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b fault=%b at %0s", expect_8, fault, "conveyor_zero_speed.ladder:84");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    stop = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // conveyor_zero_speed.ladder:88
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b motor=%b at %0s", expect_9, motor, "conveyor_zero_speed.ladder:88");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // conveyor_zero_speed.ladder:90
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b fault=%b at %0s", expect_10, fault, "conveyor_zero_speed.ladder:90");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "a shaft that stands with the motor is no fault");
    end else $display("ok 6 - %0s", "a shaft that stands with the motor is no fault");

    // a fault is kept until the next start, and a stuck button is none
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    scan(25, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // conveyor_zero_speed.ladder:96
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b motor=%b fault=%b at %0s", expect_11, motor, fault, "conveyor_zero_speed.ladder:96");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // conveyor_zero_speed.ladder:98
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b motor=%b fault=%b at %0s", expect_12, motor, fault, "conveyor_zero_speed.ladder:98");
    end
    start = 1'd0;
    scan(1, 1'b0);
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // conveyor_zero_speed.ladder:101
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b motor=%b fault=%b at %0s", expect_13, motor, fault, "conveyor_zero_speed.ladder:101");
    end
    scan(24, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // conveyor_zero_speed.ladder:104
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b motor=%b at %0s", expect_14, motor, "conveyor_zero_speed.ladder:104");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "a fault is kept until the next start, and a stuck button is none");
    end else $display("ok 7 - %0s", "a fault is kept until the next start, and a stuck button is none");

    // stop wins over start
    failed = 1'b0;
    reset;
    start = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // conveyor_zero_speed.ladder:108
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b motor=%b at %0s", expect_15, motor, "conveyor_zero_speed.ladder:108");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 8 - %0s", "stop wins over start");
    end else $display("ok 8 - %0s", "stop wins over start");

    if (failures != 0) $display("# %0d of 8 tests failed", failures);
    $finish;
  end
endmodule
