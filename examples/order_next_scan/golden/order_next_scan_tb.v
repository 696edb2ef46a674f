// Made by hotrail 0.1.0 from order_next_scan.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module order_next_scan_expect (
  input  wire clk,
  input  wire rst,
  input  wire Y0,
  input  wire Y1,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_3_0,
  output wire expect_3_1
);

  assign expect_0_0 = Y0;
  assign expect_0_1 = ~Y1;
  assign expect_1_0 = Y0;
  assign expect_1_1 = Y1;
  assign expect_2_0 = ~Y0;
  assign expect_2_1 = Y1;
  assign expect_3_0 = ~Y0;
  assign expect_3_1 = ~Y1;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module order_next_scan_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg X0 = 1'd0;
  wire Y0;
  wire Y1;
  reg failed;
  integer failures;

  order_next_scan core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .X0(X0),
    .Y0(Y0),
    .Y1(Y1)
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
  order_next_scan_expect expectations (
    .clk(clk),
    .rst(rst),
    .Y0(Y0),
    .Y1(Y1),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1)
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
      X0 = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..1");

    // Y1 follows one scan later
    failed = 1'b0;
    reset;
    X0 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // order_next_scan.ladder:12
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b Y0=%b Y1=%b at %0s", expect_0, Y0, Y1, "order_next_scan.ladder:12");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // order_next_scan.ladder:14
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b Y0=%b Y1=%b at %0s", expect_1, Y0, Y1, "order_next_scan.ladder:14");
    end
    X0 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // order_next_scan.ladder:16
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b Y0=%b Y1=%b at %0s", expect_2, Y0, Y1, "order_next_scan.ladder:16");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // order_next_scan.ladder:18
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b Y0=%b Y1=%b at %0s", expect_3, Y0, Y1, "order_next_scan.ladder:18");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "Y1 follows one scan later");
    end else $display("ok 1 - %0s", "Y1 follows one scan later");

    if (failures != 0) $display("# %0d of 1 tests failed", failures);
    $finish;
  end
endmodule
