// Made by hotrail 0.1.0 from debounce.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module debounce_expect (
  input  wire clk,
  input  wire rst,
  input  wire settled,
  input  wire at_once,
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
  output wire expect_5_1,
  output wire expect_6_0,
  output wire expect_7_0,
  output wire expect_8_0,
  output wire expect_8_1,
  output wire expect_9_0,
  output wire expect_9_1,
  output wire expect_10_0,
  output wire expect_10_1,
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_12_0,
  output wire expect_12_1,
  output wire expect_13_0,
  output wire expect_14_0
);

  assign expect_0_0 = ~settled;
  assign expect_0_1 = at_once;
  assign expect_1_0 = ~settled;
  assign expect_1_1 = at_once;
  assign expect_2_0 = ~settled;
  assign expect_2_1 = at_once;
  assign expect_3_0 = ~settled;
  assign expect_3_1 = at_once;
  assign expect_4_0 = settled;
  assign expect_4_1 = at_once;
  assign expect_5_0 = ~settled;
  assign expect_5_1 = at_once;
  assign expect_6_0 = at_once;
  assign expect_7_0 = ~at_once;
  assign expect_8_0 = ~settled;
  assign expect_8_1 = at_once;
  assign expect_9_0 = ~settled;
  assign expect_9_1 = at_once;
  assign expect_10_0 = ~settled;
  assign expect_10_1 = ~at_once;
  assign expect_11_0 = ~settled;
  assign expect_11_1 = at_once;
  assign expect_12_0 = ~settled;
  assign expect_12_1 = ~at_once;
  assign expect_13_0 = at_once;
  assign expect_14_0 = ~at_once;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module debounce_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg limit_switch_1 = 1'd0;
  wire settled;
  wire at_once;
  reg failed;
  integer failures;

  debounce core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .limit_switch_1(limit_switch_1),
    .settled(settled),
    .at_once(at_once)
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
  wire expect_5_1;
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  wire expect_6_0;
  wire [0:0] expect_6 = {expect_6_0};
  wire expect_7_0;
  wire [0:0] expect_7 = {expect_7_0};
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
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire expect_12_1;
  wire [0:1] expect_12 = {expect_12_0, expect_12_1};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  debounce_expect expectations (
    .clk(clk),
    .rst(rst),
    .settled(settled),
    .at_once(at_once),
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
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_7_0(expect_7_0),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0)
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
      limit_switch_1 = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..5");

    // a switch that bounces
    failed = 1'b0;
    reset;
    limit_switch_1 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // debounce.ladder:19
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b settled=%b at_once=%b at %0s", expect_0, settled, at_once, "debounce.ladder:19");
    end
    repeat (6) begin
      limit_switch_1 = 1'd0;
      scan(2, 1'b1);
      #1 if (!failed && &expect_1 !== 1'b1) begin // debounce.ladder:22
        failed = 1'b1;
        $display("# failed expectation 1 conducts %b settled=%b at_once=%b at %0s", expect_1, settled, at_once, "debounce.ladder:22");
      end
      limit_switch_1 = 1'd1;
      scan(1, 1'b1);
      #1 if (!failed && &expect_2 !== 1'b1) begin // debounce.ladder:24
        failed = 1'b1;
        $display("# failed expectation 2 conducts %b settled=%b at_once=%b at %0s", expect_2, settled, at_once, "debounce.ladder:24");
      end
    end
    scan(49, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // debounce.ladder:27
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b settled=%b at_once=%b at %0s", expect_3, settled, at_once, "debounce.ladder:27");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // debounce.ladder:29
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b settled=%b at_once=%b at %0s", expect_4, settled, at_once, "debounce.ladder:29");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "a switch that bounces");
    end else $display("ok 1 - %0s", "a switch that bounces");

    // the trailing edge: one at once, the other after the bridge
    failed = 1'b0;
    reset;
    limit_switch_1 = 1'd1;
    scan(1, 1'b0);
    scan(100, 1'b1);
    limit_switch_1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // debounce.ladder:35
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b settled=%b at_once=%b at %0s", expect_5, settled, at_once, "debounce.ladder:35");
    end
    scan(4, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // debounce.ladder:37
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b at_once=%b at %0s", expect_6, at_once, "debounce.ladder:37");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // debounce.ladder:39
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b at_once=%b at %0s", expect_7, at_once, "debounce.ladder:39");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "the trailing edge: one at once, the other after the bridge");
    end else $display("ok 2 - %0s", "the trailing edge: one at once, the other after the bridge");

    // a trailing edge that bounces gives no second signal
    failed = 1'b0;
    reset;
    limit_switch_1 = 1'd1;
    scan(1, 1'b0);
    scan(100, 1'b1);
    repeat (4) begin
      limit_switch_1 = 1'd0;
      scan(2, 1'b1);
      #1 if (!failed && &expect_8 !== 1'b1) begin // debounce.ladder:46
        failed = 1'b1;
        $display("# failed expectation 8 conducts %b settled=%b at_once=%b at %0s", expect_8, settled, at_once, "debounce.ladder:46");
      end
      limit_switch_1 = 1'd1;
      scan(1, 1'b1);
      #1 if (!failed && &expect_9 !== 1'b1) begin // debounce.ladder:48
        failed = 1'b1;
        $display("# failed expectation 9 conducts %b settled=%b at_once=%b at %0s", expect_9, settled, at_once, "debounce.ladder:48");
      end
    end
    limit_switch_1 = 1'd0;
    scan(1, 1'b0);
    scan(5, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // debounce.ladder:52
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b settled=%b at_once=%b at %0s", expect_10, settled, at_once, "debounce.ladder:52");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a trailing edge that bounces gives no second signal");
    end else $display("ok 3 - %0s", "a trailing edge that bounces gives no second signal");

    // a touch that is too short
    failed = 1'b0;
    reset;
    limit_switch_1 = 1'd1;
    scan(1, 1'b0);
    scan(49, 1'b1);
    limit_switch_1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // debounce.ladder:58
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b settled=%b at_once=%b at %0s", expect_11, settled, at_once, "debounce.ladder:58");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // debounce.ladder:60
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b settled=%b at_once=%b at %0s", expect_12, settled, at_once, "debounce.ladder:60");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "a touch that is too short");
    end else $display("ok 4 - %0s", "a touch that is too short");

    // a gap as long as the bridge ends the signal
    failed = 1'b0;
    reset;
    limit_switch_1 = 1'd1;
    scan(1, 1'b0);
    limit_switch_1 = 1'd0;
    scan(1, 1'b0);
    scan(4, 1'b1);
    #1 if (!failed && &expect_13 !== 1'b1) begin // debounce.ladder:65
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b at_once=%b at %0s", expect_13, at_once, "debounce.ladder:65");
    end
    limit_switch_1 = 1'd1;
    scan(1, 1'b0);
    limit_switch_1 = 1'd0;
    scan(1, 1'b0);
    scan(5, 1'b1);
    #1 if (!failed && &expect_14 !== 1'b1) begin // debounce.ladder:69
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b at_once=%b at %0s", expect_14, at_once, "debounce.ladder:69");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a gap as long as the bridge ends the signal");
    end else $display("ok 5 - %0s", "a gap as long as the bridge ends the signal");

    if (failures != 0) $display("# %0d of 5 tests failed", failures);
    $finish;
  end
endmodule
