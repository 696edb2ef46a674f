// Made by hotrail 0.1.0 from reversing_starter.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module reversing_starter_expect (
  input  wire clk,
  input  wire rst,
  input  wire run_forward,
  input  wire run_reverse,
  input  wire fault,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_1_0,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_4_0,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_7_0,
  output wire expect_7_1
);

  assign expect_0_0 = run_forward;
  assign expect_0_1 = ~run_reverse;
  assign expect_1_0 = ~run_forward;
  assign expect_2_0 = run_reverse;
  assign expect_2_1 = ~run_forward;
  assign expect_3_0 = ~run_forward;
  assign expect_3_1 = run_reverse;
  assign expect_4_0 = run_reverse;
  assign expect_5_0 = ~run_forward;
  assign expect_5_1 = ~run_reverse;
  assign expect_6_0 = ~run_forward;
  assign expect_6_1 = fault;
  assign expect_7_0 = ~run_forward;
  assign expect_7_1 = ~fault;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module reversing_starter_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg stop = 1'd0;
  reg overload = 1'd0;
  reg forward = 1'd0;
  reg reverse = 1'd0;
  wire run_forward;
  wire run_reverse;
  wire fault;
  reg failed;
  integer failures;

  reversing_starter core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .stop(stop),
    .overload(overload),
    .forward(forward),
    .reverse(reverse),
    .run_forward(run_forward),
    .run_reverse(run_reverse),
    .fault(fault)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire [0:1] expect_0 = {expect_0_0, expect_0_1};
  wire expect_1_0;
  wire [0:0] expect_1 = {expect_1_0};
  wire expect_2_0;
  wire expect_2_1;
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire expect_3_1;
  wire [0:1] expect_3 = {expect_3_0, expect_3_1};
  wire expect_4_0;
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire expect_5_1;
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
  reversing_starter_expect expectations (
    .clk(clk),
    .rst(rst),
    .run_forward(run_forward),
    .run_reverse(run_reverse),
    .fault(fault),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1)
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
      stop = 1'd0;
      overload = 1'd0;
      forward = 1'd0;
      reverse = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..4");

    // forward seals in and reverse needs a stop first
    failed = 1'b0;
    reset;
    stop = 1'd1;
    forward = 1'd1;
    scan(1, 1'b0);
    forward = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // reversing_starter.ladder:22
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b run_forward=%b run_reverse=%b at %0s", expect_0, run_forward, run_reverse, "reversing_starter.ladder:22");
    end
    stop = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // reversing_starter.ladder:24
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b run_forward=%b at %0s", expect_1, run_forward, "reversing_starter.ladder:24");
    end
    stop = 1'd1;
    reverse = 1'd1;
    scan(1, 1'b0);
    reverse = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // reversing_starter.ladder:27
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b run_reverse=%b run_forward=%b at %0s", expect_2, run_reverse, run_forward, "reversing_starter.ladder:27");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "forward seals in and reverse needs a stop first");
    end else $display("ok 1 - %0s", "forward seals in and reverse needs a stop first");

    // the other button drops the contactor before the other one closes
    failed = 1'b0;
    reset;
    stop = 1'd1;
    forward = 1'd1;
    scan(1, 1'b0);
    forward = 1'd0;
    scan(1, 1'b0);
    reverse = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // reversing_starter.ladder:33
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b run_forward=%b run_reverse=%b at %0s", expect_3, run_forward, run_reverse, "reversing_starter.ladder:33");
    end
    reverse = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // reversing_starter.ladder:35
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b run_reverse=%b at %0s", expect_4, run_reverse, "reversing_starter.ladder:35");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "the other button drops the contactor before the other one closes");
    end else $display("ok 2 - %0s", "the other button drops the contactor before the other one closes");

    // both buttons together start nothing
    failed = 1'b0;
    reset;
    stop = 1'd1;
    forward = 1'd1;
    reverse = 1'd1;
    scan(3, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // reversing_starter.ladder:39
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b run_forward=%b run_reverse=%b at %0s", expect_5, run_forward, run_reverse, "reversing_starter.ladder:39");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "both buttons together start nothing");
    end else $display("ok 3 - %0s", "both buttons together start nothing");

    // overload stops either direction
    failed = 1'b0;
    reset;
    stop = 1'd1;
    forward = 1'd1;
    scan(1, 1'b0);
    forward = 1'd0;
    scan(1, 1'b0);
    overload = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // reversing_starter.ladder:45
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b run_forward=%b fault=%b at %0s", expect_6, run_forward, fault, "reversing_starter.ladder:45");
    end
    overload = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // reversing_starter.ladder:47
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b run_forward=%b fault=%b at %0s", expect_7, run_forward, fault, "reversing_starter.ladder:47");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "overload stops either direction");
    end else $display("ok 4 - %0s", "overload stops either direction");

    if (failures != 0) $display("# %0d of 4 tests failed", failures);
    $finish;
  end
endmodule
