// Made by hotrail 0.1.0 from parts_per_minute.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module parts_per_minute_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire [15:0] parts,
  input  wire        done,
  output wire        expect_0_0,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_10_0,
  output wire        expect_11_0,
  output wire        expect_12_0,
  output wire        expect_13_0,
  output wire        expect_14_0,
  output wire        expect_14_1
);

  assign expect_0_0 = parts == 16'd0;
  assign expect_1_0 = ~done;
  assign expect_1_1 = parts == 16'd5;
  assign expect_2_0 = ~done;
  assign expect_2_1 = parts == 16'd6;
  assign expect_3_0 = done;
  assign expect_4_0 = done;
  assign expect_4_1 = parts == 16'd6;
  assign expect_5_0 = done;
  assign expect_5_1 = parts == 16'd5;
  assign expect_6_0 = ~done;
  assign expect_6_1 = parts == 16'd0;
  assign expect_7_0 = ~done;
  assign expect_7_1 = parts == 16'd1;
  assign expect_8_0 = done;
  assign expect_8_1 = parts == 16'd1;
  assign expect_9_0 = parts == 16'd0;
  assign expect_9_1 = ~done;
  assign expect_10_0 = ~done;
  assign expect_11_0 = done;
  assign expect_12_0 = parts == 16'd0;
  assign expect_13_0 = parts == 16'd1;
  assign expect_14_0 = done;
  assign expect_14_1 = parts == 16'd1;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module parts_per_minute_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg sensor = 1'd0;
  reg S = 1'd0;
  wire [15:0] parts;
  wire done;
  reg failed;
  integer failures;

  parts_per_minute core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .sensor(sensor),
    .S(S),
    .parts(parts),
    .done(done)
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
  wire expect_8_1;
  wire [0:1] expect_8 = {expect_8_0, expect_8_1};
  wire expect_9_0;
  wire expect_9_1;
  wire [0:1] expect_9 = {expect_9_0, expect_9_1};
  wire expect_10_0;
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire expect_14_1;
  wire [0:1] expect_14 = {expect_14_0, expect_14_1};
  parts_per_minute_expect expectations (
    .clk(clk),
    .rst(rst),
    .parts(parts),
    .done(done),
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
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_14_1(expect_14_1)
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
      S = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..5");

    // parts of one minute and no others
    failed = 1'b0;
    reset;
    repeat (3) begin
      sensor = 1'd1;
      scan(1, 1'b0);
      sensor = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_0 !== 1'b1) begin // parts_per_minute.ladder:22
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b parts=%b at %0s", expect_0, parts, "parts_per_minute.ladder:22");
    end
    S = 1'd1;
    scan(1, 1'b0);
    repeat (5) begin
      sensor = 1'd1;
      scan(1, 1'b0);
      sensor = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_1 !== 1'b1) begin // parts_per_minute.ladder:25
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b done=%b parts=%b at %0s", expect_1, done, parts, "parts_per_minute.ladder:25");
    end
    scan(59, 1'b1);
    sensor = 1'd1;
    scan(1, 1'b0);
    sensor = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // parts_per_minute.ladder:28
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b done=%b parts=%b at %0s", expect_2, done, parts, "parts_per_minute.ladder:28");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // parts_per_minute.ladder:30
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b done=%b at %0s", expect_3, done, "parts_per_minute.ladder:30");
    end
    repeat (7) begin
      sensor = 1'd1;
      scan(1, 1'b0);
      sensor = 1'd0;
      scan(1, 1'b0);
    end
    scan(600, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // parts_per_minute.ladder:33
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b done=%b parts=%b at %0s", expect_4, done, parts, "parts_per_minute.ladder:33");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "parts of one minute and no others");
    end else $display("ok 1 - %0s", "parts of one minute and no others");

    // open and closed again: another minute
    failed = 1'b0;
    reset;
    S = 1'd1;
    scan(1, 1'b0);
    repeat (5) begin
      sensor = 1'd1;
      scan(1, 1'b0);
      sensor = 1'd0;
      scan(1, 1'b0);
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_5 !== 1'b1) begin // parts_per_minute.ladder:39
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b done=%b parts=%b at %0s", expect_5, done, parts, "parts_per_minute.ladder:39");
    end
    S = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // parts_per_minute.ladder:41
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b done=%b parts=%b at %0s", expect_6, done, parts, "parts_per_minute.ladder:41");
    end
    repeat (2) begin
      sensor = 1'd1;
      scan(1, 1'b0);
      sensor = 1'd0;
      scan(1, 1'b0);
    end
    S = 1'd1;
    scan(1, 1'b0);
    sensor = 1'd1;
    scan(1, 1'b0);
    sensor = 1'd0;
    scan(1, 1'b0);
    scan(59, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // parts_per_minute.ladder:46
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b done=%b parts=%b at %0s", expect_7, done, parts, "parts_per_minute.ladder:46");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // parts_per_minute.ladder:48
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b done=%b parts=%b at %0s", expect_8, done, parts, "parts_per_minute.ladder:48");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "open and closed again: another minute");
    end else $display("ok 2 - %0s", "open and closed again: another minute");

    // opened before the minute is over
    failed = 1'b0;
    reset;
    S = 1'd1;
    scan(1, 1'b0);
    repeat (5) begin
      sensor = 1'd1;
      scan(1, 1'b0);
      sensor = 1'd0;
      scan(1, 1'b0);
    end
    scan(59, 1'b1);
    S = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // parts_per_minute.ladder:55
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b parts=%b done=%b at %0s", expect_9, parts, done, "parts_per_minute.ladder:55");
    end
    S = 1'd1;
    scan(1, 1'b0);
    scan(59, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // parts_per_minute.ladder:58
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b done=%b at %0s", expect_10, done, "parts_per_minute.ladder:58");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // parts_per_minute.ladder:60
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b done=%b at %0s", expect_11, done, "parts_per_minute.ladder:60");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "opened before the minute is over");
    end else $display("ok 3 - %0s", "opened before the minute is over");

    // a part in front of the sensor when S closes is not counted
    failed = 1'b0;
    reset;
    sensor = 1'd1;
    scan(1, 1'b0);
    S = 1'd1;
    scan(1, 1'b0);
    scan(1, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // parts_per_minute.ladder:66
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b parts=%b at %0s", expect_12, parts, "parts_per_minute.ladder:66");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "a part in front of the sensor when S closes is not counted");
    end else $display("ok 4 - %0s", "a part in front of the sensor when S closes is not counted");

    // a part that comes with S is, one that comes with the last tick is not
    failed = 1'b0;
    reset;
    sensor = 1'd1;
    S = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // parts_per_minute.ladder:70
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b parts=%b at %0s", expect_13, parts, "parts_per_minute.ladder:70");
    end
    sensor = 1'd0;
    scan(59, 1'b1);
    sensor = 1'd1;
    scan(1, 1'b1);
    #1 if (!failed && &expect_14 !== 1'b1) begin // parts_per_minute.ladder:74
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b done=%b parts=%b at %0s", expect_14, done, parts, "parts_per_minute.ladder:74");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a part that comes with S is, one that comes with the last tick is not");
    end else $display("ok 5 - %0s", "a part that comes with S is, one that comes with the last tick is not");

    if (failures != 0) $display("# %0d of 5 tests failed", failures);
    $finish;
  end
endmodule
