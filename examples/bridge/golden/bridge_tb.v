// Made by hotrail 0.1.0 from bridge.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module bridge_expect (
  input  wire clk,
  input  wire rst,
  input  wire CR316,
  output wire expect_0_0,
  output wire expect_1_0,
  output wire expect_2_0,
  output wire expect_3_0,
  output wire expect_4_0,
  output wire expect_5_0,
  output wire expect_6_0,
  output wire expect_7_0,
  output wire expect_8_0,
  output wire expect_9_0,
  output wire expect_10_0,
  output wire expect_11_0,
  output wire expect_12_0,
  output wire expect_13_0
);

  assign expect_0_0 = ~CR316;
  assign expect_1_0 = CR316;
  assign expect_2_0 = ~CR316;
  assign expect_3_0 = CR316;
  assign expect_4_0 = ~CR316;
  assign expect_5_0 = CR316;
  assign expect_6_0 = ~CR316;
  assign expect_7_0 = CR316;
  assign expect_8_0 = ~CR316;
  assign expect_9_0 = CR316;
  assign expect_10_0 = ~CR316;
  assign expect_11_0 = CR316;
  assign expect_12_0 = ~CR316;
  assign expect_13_0 = ~CR316;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module bridge_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg c1 = 1'd0;
  reg c2 = 1'd0;
  reg c3 = 1'd0;
  reg c4 = 1'd0;
  reg c5 = 1'd0;
  reg c6 = 1'd0;
  reg c7 = 1'd0;
  reg c8 = 1'd0;
  reg c9 = 1'd0;
  wire CR316;
  reg failed;
  integer failures;

  bridge core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .c1(c1),
    .c2(c2),
    .c3(c3),
    .c4(c4),
    .c5(c5),
    .c6(c6),
    .c7(c7),
    .c8(c8),
    .c9(c9),
    .CR316(CR316)
  );

  wire expect_0_0;
  wire [0:0] expect_0 = {expect_0_0};
  wire expect_1_0;
  wire [0:0] expect_1 = {expect_1_0};
  wire expect_2_0;
  wire [0:0] expect_2 = {expect_2_0};
  wire expect_3_0;
  wire [0:0] expect_3 = {expect_3_0};
  wire expect_4_0;
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire [0:0] expect_6 = {expect_6_0};
  wire expect_7_0;
  wire [0:0] expect_7 = {expect_7_0};
  wire expect_8_0;
  wire [0:0] expect_8 = {expect_8_0};
  wire expect_9_0;
  wire [0:0] expect_9 = {expect_9_0};
  wire expect_10_0;
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  bridge_expect expectations (
    .clk(clk),
    .rst(rst),
    .CR316(CR316),
    .expect_0_0(expect_0_0),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_7_0(expect_7_0),
    .expect_8_0(expect_8_0),
    .expect_9_0(expect_9_0),
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
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
      c1 = 1'd0;
      c2 = 1'd0;
      c3 = 1'd0;
      c4 = 1'd0;
      c5 = 1'd0;
      c6 = 1'd0;
      c7 = 1'd0;
      c8 = 1'd0;
      c9 = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..7");

    // 9-1
    failed = 1'b0;
    reset;
    c9 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // bridge.ladder:18
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b CR316=%b at %0s", expect_0, CR316, "bridge.ladder:18");
    end
    c1 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // bridge.ladder:20
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b CR316=%b at %0s", expect_1, CR316, "bridge.ladder:20");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "9-1");
    end else $display("ok 1 - %0s", "9-1");

    // 2-3-4-1
    failed = 1'b0;
    reset;
    c2 = 1'd1;
    c4 = 1'd1;
    c1 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // bridge.ladder:24
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b CR316=%b at %0s", expect_2, CR316, "bridge.ladder:24");
    end
    c3 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // bridge.ladder:26
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b CR316=%b at %0s", expect_3, CR316, "bridge.ladder:26");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "2-3-4-1");
    end else $display("ok 2 - %0s", "2-3-4-1");

    // 5-6-1: contact 6 from right to left
    failed = 1'b0;
    reset;
    c5 = 1'd1;
    c1 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // bridge.ladder:30
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b CR316=%b at %0s", expect_4, CR316, "bridge.ladder:30");
    end
    c6 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // bridge.ladder:32
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b CR316=%b at %0s", expect_5, CR316, "bridge.ladder:32");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "5-6-1: contact 6 from right to left");
    end else $display("ok 3 - %0s", "5-6-1: contact 6 from right to left");

    // 5-7-8
    failed = 1'b0;
    reset;
    c5 = 1'd1;
    c7 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // bridge.ladder:36
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b CR316=%b at %0s", expect_6, CR316, "bridge.ladder:36");
    end
    c8 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // bridge.ladder:38
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b CR316=%b at %0s", expect_7, CR316, "bridge.ladder:38");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "5-7-8");
    end else $display("ok 4 - %0s", "5-7-8");

    // 9-6-7-8: contact 6 from left to right
    failed = 1'b0;
    reset;
    c9 = 1'd1;
    c7 = 1'd1;
    c8 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // bridge.ladder:42
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b CR316=%b at %0s", expect_8, CR316, "bridge.ladder:42");
    end
    c6 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // bridge.ladder:44
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b CR316=%b at %0s", expect_9, CR316, "bridge.ladder:44");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "9-6-7-8: contact 6 from left to right");
    end else $display("ok 5 - %0s", "9-6-7-8: contact 6 from left to right");

    // 2-3-4-6-7-8
    failed = 1'b0;
    reset;
    c2 = 1'd1;
    c3 = 1'd1;
    c4 = 1'd1;
    c7 = 1'd1;
    c8 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // bridge.ladder:48
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b CR316=%b at %0s", expect_10, CR316, "bridge.ladder:48");
    end
    c6 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // bridge.ladder:50
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b CR316=%b at %0s", expect_11, CR316, "bridge.ladder:50");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "2-3-4-6-7-8");
    end else $display("ok 6 - %0s", "2-3-4-6-7-8");

    // no path: everything behind the nodes, and contact 6 between them
    failed = 1'b0;
    reset;
    c6 = 1'd1;
    c1 = 1'd1;
    c7 = 1'd1;
    c8 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // bridge.ladder:54
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b CR316=%b at %0s", expect_12, CR316, "bridge.ladder:54");
    end
    c2 = 1'd1;
    c3 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // bridge.ladder:56
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b CR316=%b at %0s", expect_13, CR316, "bridge.ladder:56");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "no path: everything behind the nodes, and contact 6 between them");
    end else $display("ok 7 - %0s", "no path: everything behind the nodes, and contact 6 between them");

    if (failures != 0) $display("# %0d of 7 tests failed", failures);
    $finish;
  end
endmodule
