// Made by hotrail 0.1.0 from edges_and_latches.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module edges_and_latches_expect (
  input  wire clk,
  input  wire rst,
  input  wire on_rise,
  input  wire on_fall,
  input  wire shot_up,
  input  wire coil_up,
  input  wire shot_down,
  input  wire coil_down,
  input  wire latched,
  input  wire inverted,
  input  wire started,
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
  output wire expect_4_2,
  output wire expect_4_3,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_7_0,
  output wire expect_7_1,
  output wire expect_8_0,
  output wire expect_9_0,
  output wire expect_10_0,
  output wire expect_11_0,
  output wire expect_12_0,
  output wire expect_13_0,
  output wire expect_14_0
);

  assign expect_0_0 = on_rise;
  assign expect_0_1 = ~on_fall;
  assign expect_1_0 = ~on_rise;
  assign expect_1_1 = ~on_fall;
  assign expect_2_0 = ~on_rise;
  assign expect_2_1 = on_fall;
  assign expect_3_0 = ~on_rise;
  assign expect_3_1 = ~on_fall;
  assign expect_4_0 = shot_up;
  assign expect_4_1 = coil_up;
  assign expect_4_2 = ~shot_down;
  assign expect_4_3 = ~coil_down;
  assign expect_5_0 = ~shot_up;
  assign expect_5_1 = ~coil_up;
  assign expect_6_0 = shot_down;
  assign expect_6_1 = coil_down;
  assign expect_7_0 = on_rise;
  assign expect_7_1 = ~on_fall;
  assign expect_8_0 = latched;
  assign expect_9_0 = ~latched;
  assign expect_10_0 = inverted;
  assign expect_11_0 = ~inverted;
  assign expect_12_0 = started;
  assign expect_13_0 = ~started;
  assign expect_14_0 = started;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module edges_and_latches_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg a = 1'd0;
  reg b = 1'd0;
  reg clear = 1'd0;
  wire on_rise;
  wire on_fall;
  wire shot_up;
  wire shot_down;
  wire coil_up;
  wire coil_down;
  wire latched;
  wire inverted;
  wire started;
  reg failed;
  integer failures;

  edges_and_latches core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .a(a),
    .b(b),
    .clear(clear),
    .on_rise(on_rise),
    .on_fall(on_fall),
    .shot_up(shot_up),
    .shot_down(shot_down),
    .coil_up(coil_up),
    .coil_down(coil_down),
    .latched(latched),
    .inverted(inverted),
    .started(started)
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
  wire expect_4_2;
  wire expect_4_3;
  wire [0:3] expect_4 = {expect_4_0, expect_4_1, expect_4_2, expect_4_3};
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
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  edges_and_latches_expect expectations (
    .clk(clk),
    .rst(rst),
    .on_rise(on_rise),
    .on_fall(on_fall),
    .shot_up(shot_up),
    .coil_up(coil_up),
    .shot_down(shot_down),
    .coil_down(coil_down),
    .latched(latched),
    .inverted(inverted),
    .started(started),
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
    .expect_4_2(expect_4_2),
    .expect_4_3(expect_4_3),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_9_0(expect_9_0),
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0),
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
      a = 1'd0;
      b = 1'd0;
      clear = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..6");

    // edges last one scan
    failed = 1'b0;
    reset;
    a = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // edges_and_latches.ladder:32
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b on_rise=%b on_fall=%b at %0s", expect_0, on_rise, on_fall, "edges_and_latches.ladder:32");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // edges_and_latches.ladder:34
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b on_rise=%b on_fall=%b at %0s", expect_1, on_rise, on_fall, "edges_and_latches.ladder:34");
    end
    a = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // edges_and_latches.ladder:36
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b on_rise=%b on_fall=%b at %0s", expect_2, on_rise, on_fall, "edges_and_latches.ladder:36");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // edges_and_latches.ladder:38
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b on_rise=%b on_fall=%b at %0s", expect_3, on_rise, on_fall, "edges_and_latches.ladder:38");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "edges last one scan");
    end else $display("ok 1 - %0s", "edges last one scan");

    // one-shots and edge coils do the same
    failed = 1'b0;
    reset;
    a = 1'd1;
    b = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // edges_and_latches.ladder:42
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b shot_up=%b coil_up=%b shot_down=%b coil_down=%b at %0s", expect_4, shot_up, coil_up, shot_down, coil_down, "edges_and_latches.ladder:42");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // edges_and_latches.ladder:44
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b shot_up=%b coil_up=%b at %0s", expect_5, shot_up, coil_up, "edges_and_latches.ladder:44");
    end
    b = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // edges_and_latches.ladder:46
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b shot_down=%b coil_down=%b at %0s", expect_6, shot_down, coil_down, "edges_and_latches.ladder:46");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "one-shots and edge coils do the same");
    end else $display("ok 2 - %0s", "one-shots and edge coils do the same");

    // an input that is on in the first scan gives a rise and no fall
    failed = 1'b0;
    reset;
    a = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // edges_and_latches.ladder:50
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b on_rise=%b on_fall=%b at %0s", expect_7, on_rise, on_fall, "edges_and_latches.ladder:50");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "an input that is on in the first scan gives a rise and no fall");
    end else $display("ok 3 - %0s", "an input that is on in the first scan gives a rise and no fall");

    // reset wins over set
    failed = 1'b0;
    reset;
    a = 1'd1;
    scan(1, 1'b0);
    a = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // edges_and_latches.ladder:54
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b latched=%b at %0s", expect_8, latched, "edges_and_latches.ladder:54");
    end
    a = 1'd1;
    clear = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // edges_and_latches.ladder:56
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b latched=%b at %0s", expect_9, latched, "edges_and_latches.ladder:56");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "reset wins over set");
    end else $display("ok 4 - %0s", "reset wins over set");

    // twice inverted is not inverted
    failed = 1'b0;
    reset;
    a = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // edges_and_latches.ladder:60
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b inverted=%b at %0s", expect_10, inverted, "edges_and_latches.ladder:60");
    end
    a = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // edges_and_latches.ladder:62
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b inverted=%b at %0s", expect_11, inverted, "edges_and_latches.ladder:62");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "twice inverted is not inverted");
    end else $display("ok 5 - %0s", "twice inverted is not inverted");

    // the first scan happens once after each reset
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // edges_and_latches.ladder:66
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b started=%b at %0s", expect_12, started, "edges_and_latches.ladder:66");
    end
    reset;
    #1 if (!failed && &expect_13 !== 1'b1) begin // edges_and_latches.ladder:68
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b started=%b at %0s", expect_13, started, "edges_and_latches.ladder:68");
    end
    scan(2, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // edges_and_latches.ladder:70
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b started=%b at %0s", expect_14, started, "edges_and_latches.ladder:70");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "the first scan happens once after each reset");
    end else $display("ok 6 - %0s", "the first scan happens once after each reset");

    if (failures != 0) $display("# %0d of 6 tests failed", failures);
    $finish;
  end
endmodule
