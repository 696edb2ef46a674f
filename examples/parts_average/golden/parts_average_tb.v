// Made by hotrail 0.1.0 from parts_average.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module parts_average_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire [15:0] last_minute,
  input  wire [15:0] average_10,
  input  wire [15:0] average_60,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_1_2,
  output wire        expect_2_0,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_3_2,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_6_0,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_10_0,
  output wire        expect_11_0,
  output wire        expect_11_1,
  output wire        expect_12_0,
  output wire        expect_12_1,
  output wire        expect_12_2,
  output wire        expect_13_0,
  output wire        expect_14_0,
  output wire        expect_14_1,
  output wire        expect_15_0,
  output wire        expect_16_0,
  output wire        expect_17_0
);

  assign expect_0_0 = last_minute == 16'd0;
  assign expect_0_1 = average_10 == 16'd0;
  assign expect_0_2 = average_60 == 16'd0;
  assign expect_1_0 = last_minute == 16'd7;
  assign expect_1_1 = average_10 == 16'd7;
  assign expect_1_2 = average_60 == 16'd7;
  assign expect_2_0 = last_minute == 16'd7;
  assign expect_3_0 = last_minute == 16'd0;
  assign expect_3_1 = average_10 == 16'd4;
  assign expect_3_2 = average_60 == 16'd4;
  assign expect_4_0 = last_minute == 16'd0;
  assign expect_4_1 = average_10 == 16'd6;
  assign expect_4_2 = average_60 == 16'd6;
  assign expect_5_0 = average_10 == 16'd3;
  assign expect_5_1 = average_60 == 16'd3;
  assign expect_6_0 = average_10 == 16'd3;
  assign expect_7_0 = average_10 == 16'd2;
  assign expect_7_1 = average_60 == 16'd3;
  assign expect_8_0 = average_10 == 16'd1;
  assign expect_8_1 = average_60 == 16'd3;
  assign expect_9_0 = average_10 == 16'd0;
  assign expect_9_1 = average_60 == 16'd2;
  assign expect_10_0 = average_60 == 16'd60;
  assign expect_11_0 = average_10 == 16'd0;
  assign expect_11_1 = average_60 == 16'd1;
  assign expect_12_0 = last_minute == 16'd30;
  assign expect_12_1 = average_10 == 16'd3;
  assign expect_12_2 = average_60 == 16'd1;
  assign expect_13_0 = average_60 == 16'd1;
  assign expect_14_0 = average_60 == 16'd0;
  assign expect_14_1 = average_10 == 16'd0;
  assign expect_15_0 = last_minute == 16'd1;
  assign expect_16_0 = last_minute == 16'd0;
  assign expect_17_0 = last_minute == 16'd1;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module parts_average_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg sensor = 1'd0;
  wire [15:0] last_minute;
  wire [15:0] average_10;
  wire [15:0] average_60;
  reg failed;
  integer failures;

  parts_average core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .sensor(sensor),
    .last_minute(last_minute),
    .average_10(average_10),
    .average_60(average_60)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire [0:2] expect_0 = {expect_0_0, expect_0_1, expect_0_2};
  wire expect_1_0;
  wire expect_1_1;
  wire expect_1_2;
  wire [0:2] expect_1 = {expect_1_0, expect_1_1, expect_1_2};
  wire expect_2_0;
  wire [0:0] expect_2 = {expect_2_0};
  wire expect_3_0;
  wire expect_3_1;
  wire expect_3_2;
  wire [0:2] expect_3 = {expect_3_0, expect_3_1, expect_3_2};
  wire expect_4_0;
  wire expect_4_1;
  wire expect_4_2;
  wire [0:2] expect_4 = {expect_4_0, expect_4_1, expect_4_2};
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
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire expect_12_1;
  wire expect_12_2;
  wire [0:2] expect_12 = {expect_12_0, expect_12_1, expect_12_2};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire expect_14_1;
  wire [0:1] expect_14 = {expect_14_0, expect_14_1};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  wire expect_16_0;
  wire [0:0] expect_16 = {expect_16_0};
  wire expect_17_0;
  wire [0:0] expect_17 = {expect_17_0};
  parts_average_expect expectations (
    .clk(clk),
    .rst(rst),
    .last_minute(last_minute),
    .average_10(average_10),
    .average_60(average_60),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
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
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_12_2(expect_12_2),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_14_1(expect_14_1),
    .expect_15_0(expect_15_0),
    .expect_16_0(expect_16_0),
    .expect_17_0(expect_17_0)
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
      sensor = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..4");

    // the first minute
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (7) begin
      sensor = 1'd1;
      scan(1, 1'b0);
      sensor = 1'd0;
      scan(1, 1'b0);
    end
    scan(59, 1'b1);
    #1 if (!failed && &expect_0 !== 1'b1) begin // parts_average.ladder:50
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b last_minute=%b average_10=%b average_60=%b at %0s", expect_0, last_minute, average_10, average_60, "parts_average.ladder:50");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // parts_average.ladder:52
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b last_minute=%b average_10=%b average_60=%b at %0s", expect_1, last_minute, average_10, average_60, "parts_average.ladder:52");
    end
    scan(59, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // parts_average.ladder:54
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b last_minute=%b at %0s", expect_2, last_minute, "parts_average.ladder:54");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // parts_average.ladder:56
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b last_minute=%b average_10=%b average_60=%b at %0s", expect_3, last_minute, average_10, average_60, "parts_average.ladder:56");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "the first minute");
    end else $display("ok 1 - %0s", "the first minute");

    // averages of the minutes that there are
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (3) begin
      repeat (10) begin
        sensor = 1'd1;
        scan(1, 1'b0);
        sensor = 1'd0;
        scan(1, 1'b0);
      end
      scan(60, 1'b1);
    end
    repeat (2) begin
      scan(60, 1'b1);
    end
    #1 if (!failed && &expect_4 !== 1'b1) begin // parts_average.ladder:65
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b last_minute=%b average_10=%b average_60=%b at %0s", expect_4, last_minute, average_10, average_60, "parts_average.ladder:65");
    end
    repeat (4) begin
      scan(60, 1'b1);
    end
    #1 if (!failed && &expect_5 !== 1'b1) begin // parts_average.ladder:67
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b average_10=%b average_60=%b at %0s", expect_5, average_10, average_60, "parts_average.ladder:67");
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // parts_average.ladder:69
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b average_10=%b at %0s", expect_6, average_10, "parts_average.ladder:69");
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // parts_average.ladder:71
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b average_10=%b average_60=%b at %0s", expect_7, average_10, average_60, "parts_average.ladder:71");
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // parts_average.ladder:73
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b average_10=%b average_60=%b at %0s", expect_8, average_10, average_60, "parts_average.ladder:73");
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_9 !== 1'b1) begin // parts_average.ladder:75
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b average_10=%b average_60=%b at %0s", expect_9, average_10, average_60, "parts_average.ladder:75");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "averages of the minutes that there are");
    end else $display("ok 2 - %0s", "averages of the minutes that there are");

    // an hour and more
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (60) begin
      sensor = 1'd1;
      scan(1, 1'b0);
      sensor = 1'd0;
      scan(1, 1'b0);
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // parts_average.ladder:81
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b average_60=%b at %0s", expect_10, average_60, "parts_average.ladder:81");
    end
    scan(3540, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // parts_average.ladder:83
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b average_10=%b average_60=%b at %0s", expect_11, average_10, average_60, "parts_average.ladder:83");
    end
    repeat (30) begin
      sensor = 1'd1;
      scan(1, 1'b0);
      sensor = 1'd0;
      scan(1, 1'b0);
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // parts_average.ladder:86
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b last_minute=%b average_10=%b average_60=%b at %0s", expect_12, last_minute, average_10, average_60, "parts_average.ladder:86");
    end
    scan(3540, 1'b1);
    #1 if (!failed && &expect_13 !== 1'b1) begin // parts_average.ladder:88
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b average_60=%b at %0s", expect_13, average_60, "parts_average.ladder:88");
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_14 !== 1'b1) begin // parts_average.ladder:90
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b average_60=%b average_10=%b at %0s", expect_14, average_60, average_10, "parts_average.ladder:90");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "an hour and more");
    end else $display("ok 3 - %0s", "an hour and more");

    // a part in front of the sensor at the end of the minute is counted once, in its minute
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    scan(59, 1'b1);
    sensor = 1'd1;
    scan(1, 1'b1);
    #1 if (!failed && &expect_15 !== 1'b1) begin // parts_average.ladder:96
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b last_minute=%b at %0s", expect_15, last_minute, "parts_average.ladder:96");
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_16 !== 1'b1) begin // parts_average.ladder:98
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b last_minute=%b at %0s", expect_16, last_minute, "parts_average.ladder:98");
    end
    sensor = 1'd0;
    scan(1, 1'b0);
    sensor = 1'd1;
    scan(1, 1'b0);
    sensor = 1'd0;
    scan(1, 1'b0);
    scan(60, 1'b1);
    #1 if (!failed && &expect_17 !== 1'b1) begin // parts_average.ladder:102
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b last_minute=%b at %0s", expect_17, last_minute, "parts_average.ladder:102");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "a part in front of the sensor at the end of the minute is counted once, in its minute");
    end else $display("ok 4 - %0s", "a part in front of the sensor at the end of the minute is counted once, in its minute");

    if (failures != 0) $display("# %0d of 4 tests failed", failures);
    $finish;
  end
endmodule
