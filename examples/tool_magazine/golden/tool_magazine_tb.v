// Made by hotrail 0.1.0 from tool_magazine.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module tool_magazine_test (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire X4,
  input  wire X3,
  input  wire X2,
  input  wire X1,
  input  wire at2,
  input  wire at3,
  input  wire X15,
  input  wire X16,
  input  wire home,
  output wire turn,
  output wire Y0,
  output wire Y1,
  output wire Y2,
  output wire Y3,
  output wire Y4,
  output wire M2,
  output wire M50,
  output wire M15,
  output wire M3,
  output wire M51
);
  reg M2_reg = 1'b0;
  reg Y14 = 1'b0;
  reg M3_reg = 1'b0;
  reg M15_reg = 1'b0;
  reg Y0_reg = 1'b0;
  reg Y2_reg = 1'b0;
  reg Y3_reg = 1'b0;
  reg Y4_reg = 1'b0;
  reg M51_reg = 1'b0;
  reg X16_before = 1'b0;
  reg Y1_reg = 1'b0;
  reg turn_reg = 1'b0;
  reg M50_reg = 1'b0;

  // rung 1 "decode the command", tool_magazine.ladder:26
  wire T2 = ~X4 & ~X3 & X2 & ~X1;
  wire T3 = ~X4 & ~X3 & X2 & X1;
  wire M50_next = X4 & ~X3 & X2 & X1;
  wire M51_next = X4 & X3 & ~X2 & ~X1;

  // rung 2 "call a location", tool_magazine.ladder:29
  wire M2_rung2 = T2 | M2_reg;
  wire Y14_rung2 = T2 | Y14;
  wire M3_rung2 = M3_reg & ~T2;
  wire M3_rung2_2 = T3 | M3_rung2;
  wire M2_rung2_2 = M2_rung2 & ~T3;
  wire M15_rung2 = M15_reg & ~T3;
  wire Y14_next = Y14_rung2 & ~M50_next;

  // rung 3 "turn until it is reached", tool_magazine.ladder:32
  wire turn_next = M2_rung2_2 & ~at2 | M3_rung2_2 & ~at3;

  // rung 4, tool_magazine.ladder:34
  wire Y0_next = M2_rung2_2 & at2 | M3_rung2_2 & at3;

  // rung 5 "move the tool forward (paper, rung 4)", tool_magazine.ladder:36
  wire Y2_next = (Y14_next & Y0_next & ~Y0_reg | Y2_reg) & ~X15 & ~Y3_reg;

  // rung 6 "air pump (paper, rung 5)", tool_magazine.ladder:39
  wire Y4_next = (Y2_next & ~Y2_reg | Y4_reg | M51_reg) & ~M15_rung2;

  // rung 7 "close the pump", tool_magazine.ladder:42

  // rung 8, tool_magazine.ladder:44
  wire M15_next = M50_next | M15_rung2;

  // rung 9 "bring the tool back", tool_magazine.ladder:46
  wire rung9_power = M51_next & ~M51_reg;
  wire Y3_rung9 = rung9_power | Y3_reg;
  wire M2_next = M2_rung2_2 & ~rung9_power;
  wire M3_next = M3_rung2_2 & ~rung9_power;

  // rung 10, tool_magazine.ladder:48
  wire Y3_next = Y3_rung9 & ~X16;

  // rung 11 "turn back when the tool is back", tool_magazine.ladder:50
  wire Y1_next = (X16 & ~X16_before | Y1_reg) & ~home;

  assign turn = turn_reg;
  assign Y0 = Y0_reg;
  assign Y1 = Y1_reg;
  assign Y2 = Y2_reg;
  assign Y3 = Y3_reg;
  assign Y4 = Y4_reg;
  assign M2 = M2_reg;
  assign M50 = M50_reg;
  assign M15 = M15_reg;
  assign M3 = M3_reg;
  assign M51 = M51_reg;

  always @(posedge clk) begin
    if (rst) begin
      M2_reg <= 1'b0;
      Y14 <= 1'b0;
      M3_reg <= 1'b0;
      M15_reg <= 1'b0;
      Y0_reg <= 1'b0;
      Y2_reg <= 1'b0;
      Y3_reg <= 1'b0;
      Y4_reg <= 1'b0;
      M51_reg <= 1'b0;
      X16_before <= 1'b0;
      Y1_reg <= 1'b0;
      turn_reg <= 1'b0;
      M50_reg <= 1'b0;
    end else begin
      M2_reg <= M2_next;
      Y14 <= Y14_next;
      M3_reg <= M3_next;
      M15_reg <= M15_next;
      Y0_reg <= Y0_next;
      Y2_reg <= Y2_next;
      Y3_reg <= Y3_next;
      Y4_reg <= Y4_next;
      M51_reg <= M51_next;
      X16_before <= X16;
      Y1_reg <= Y1_next;
      turn_reg <= turn_next;
      M50_reg <= M50_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule

`default_nettype wire

`default_nettype none

module tool_magazine_expect (
  input  wire clk,
  input  wire rst,
  input  wire M2,
  input  wire turn,
  input  wire Y0,
  input  wire Y2,
  input  wire Y4,
  input  wire M50,
  input  wire M15,
  input  wire M3,
  input  wire M51,
  input  wire Y3,
  input  wire Y1,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_0_2,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_1_2,
  output wire expect_1_3,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_3_0,
  output wire expect_4_0,
  output wire expect_4_1,
  output wire expect_4_2,
  output wire expect_5_0,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_7_0,
  output wire expect_7_1,
  output wire expect_7_2,
  output wire expect_7_3,
  output wire expect_8_0,
  output wire expect_8_1,
  output wire expect_8_2,
  output wire expect_8_3,
  output wire expect_9_0,
  output wire expect_9_1,
  output wire expect_10_0,
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_11_2,
  output wire expect_12_0,
  output wire expect_13_0,
  output wire expect_13_1,
  output wire expect_14_0,
  output wire expect_15_0
);

  assign expect_0_0 = M2;
  assign expect_0_1 = turn;
  assign expect_0_2 = ~Y0;
  assign expect_1_0 = ~turn;
  assign expect_1_1 = Y0;
  assign expect_1_2 = Y2;
  assign expect_1_3 = Y4;
  assign expect_2_0 = ~Y2;
  assign expect_2_1 = Y4;
  assign expect_3_0 = Y4;
  assign expect_4_0 = M50;
  assign expect_4_1 = M15;
  assign expect_4_2 = Y4;
  assign expect_5_0 = ~Y4;
  assign expect_6_0 = ~M50;
  assign expect_6_1 = ~Y4;
  assign expect_7_0 = M3;
  assign expect_7_1 = ~M2;
  assign expect_7_2 = turn;
  assign expect_7_3 = ~Y0;
  assign expect_8_0 = ~turn;
  assign expect_8_1 = Y0;
  assign expect_8_2 = ~Y2;
  assign expect_8_3 = ~Y4;
  assign expect_9_0 = Y0;
  assign expect_9_1 = ~Y4;
  assign expect_10_0 = ~Y4;
  assign expect_11_0 = M51;
  assign expect_11_1 = Y3;
  assign expect_11_2 = ~Y1;
  assign expect_12_0 = Y3;
  assign expect_13_0 = ~Y3;
  assign expect_13_1 = Y1;
  assign expect_14_0 = Y1;
  assign expect_15_0 = ~Y1;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module tool_magazine_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg X4 = 1'd0;
  reg X3 = 1'd0;
  reg X2 = 1'd0;
  reg X1 = 1'd0;
  reg at2 = 1'd0;
  reg at3 = 1'd0;
  reg X15 = 1'd0;
  reg X16 = 1'd0;
  reg home = 1'd0;
  wire turn;
  wire Y0;
  wire Y1;
  wire Y2;
  wire Y3;
  wire Y4;
  wire M2;
  wire M50;
  wire M15;
  wire M3;
  wire M51;
  reg failed;
  integer failures;

  tool_magazine_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .X4(X4),
    .X3(X3),
    .X2(X2),
    .X1(X1),
    .at2(at2),
    .at3(at3),
    .X15(X15),
    .X16(X16),
    .home(home),
    .turn(turn),
    .Y0(Y0),
    .Y1(Y1),
    .Y2(Y2),
    .Y3(Y3),
    .Y4(Y4),
    .M2(M2),
    .M50(M50),
    .M15(M15),
    .M3(M3),
    .M51(M51)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire [0:2] expect_0 = {expect_0_0, expect_0_1, expect_0_2};
  wire expect_1_0;
  wire expect_1_1;
  wire expect_1_2;
  wire expect_1_3;
  wire [0:3] expect_1 = {expect_1_0, expect_1_1, expect_1_2, expect_1_3};
  wire expect_2_0;
  wire expect_2_1;
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire [0:0] expect_3 = {expect_3_0};
  wire expect_4_0;
  wire expect_4_1;
  wire expect_4_2;
  wire [0:2] expect_4 = {expect_4_0, expect_4_1, expect_4_2};
  wire expect_5_0;
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire expect_7_2;
  wire expect_7_3;
  wire [0:3] expect_7 = {expect_7_0, expect_7_1, expect_7_2, expect_7_3};
  wire expect_8_0;
  wire expect_8_1;
  wire expect_8_2;
  wire expect_8_3;
  wire [0:3] expect_8 = {expect_8_0, expect_8_1, expect_8_2, expect_8_3};
  wire expect_9_0;
  wire expect_9_1;
  wire [0:1] expect_9 = {expect_9_0, expect_9_1};
  wire expect_10_0;
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire expect_11_1;
  wire expect_11_2;
  wire [0:2] expect_11 = {expect_11_0, expect_11_1, expect_11_2};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire expect_13_1;
  wire [0:1] expect_13 = {expect_13_0, expect_13_1};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  tool_magazine_expect expectations (
    .clk(clk),
    .rst(rst),
    .M2(M2),
    .turn(turn),
    .Y0(Y0),
    .Y2(Y2),
    .Y4(Y4),
    .M50(M50),
    .M15(M15),
    .M3(M3),
    .M51(M51),
    .Y3(Y3),
    .Y1(Y1),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_1_3(expect_1_3),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_7_2(expect_7_2),
    .expect_7_3(expect_7_3),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_8_2(expect_8_2),
    .expect_8_3(expect_8_3),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_11_2(expect_11_2),
    .expect_12_0(expect_12_0),
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
      X4 = 1'd0;
      X3 = 1'd0;
      X2 = 1'd0;
      X1 = 1'd0;
      at2 = 1'd0;
      at3 = 1'd0;
      X15 = 1'd0;
      X16 = 1'd0;
      home = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..1");

    // T2 unloads tool 2, T11 closes the pump, T3 clamps tool 3, T12 brings it home
    failed = 1'b0;
    reset;
    X2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // tool_magazine.ladder:56
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b M2=%b turn=%b Y0=%b at %0s", expect_0, M2, turn, Y0, "tool_magazine.ladder:56");
    end
    at2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // tool_magazine.ladder:58
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b turn=%b Y0=%b Y2=%b Y4=%b at %0s", expect_1, turn, Y0, Y2, Y4, "tool_magazine.ladder:58");
    end
    X15 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // tool_magazine.ladder:60
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b Y2=%b Y4=%b at %0s", expect_2, Y2, Y4, "tool_magazine.ladder:60");
    end
    X2 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // tool_magazine.ladder:62
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b Y4=%b at %0s", expect_3, Y4, "tool_magazine.ladder:62");
    end
    X4 = 1'd1;
    X2 = 1'd1;
    X1 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // tool_magazine.ladder:65
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b M50=%b M15=%b Y4=%b at %0s", expect_4, M50, M15, Y4, "tool_magazine.ladder:65");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // tool_magazine.ladder:67
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b Y4=%b at %0s", expect_5, Y4, "tool_magazine.ladder:67");
    end
    X4 = 1'd0;
    X2 = 1'd0;
    X1 = 1'd0;
    X15 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // tool_magazine.ladder:69
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b M50=%b Y4=%b at %0s", expect_6, M50, Y4, "tool_magazine.ladder:69");
    end
    X2 = 1'd1;
    X1 = 1'd1;
    at2 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // tool_magazine.ladder:72
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b M3=%b M2=%b turn=%b Y0=%b at %0s", expect_7, M3, M2, turn, Y0, "tool_magazine.ladder:72");
    end
    at3 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // tool_magazine.ladder:74
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b turn=%b Y0=%b Y2=%b Y4=%b at %0s", expect_8, turn, Y0, Y2, Y4, "tool_magazine.ladder:74");
    end
    X2 = 1'd0;
    X1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // tool_magazine.ladder:76
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b Y0=%b Y4=%b at %0s", expect_9, Y0, Y4, "tool_magazine.ladder:76");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // tool_magazine.ladder:78
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b Y4=%b at %0s", expect_10, Y4, "tool_magazine.ladder:78");
    end
    X4 = 1'd1;
    X3 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // tool_magazine.ladder:81
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b M51=%b Y3=%b Y1=%b at %0s", expect_11, M51, Y3, Y1, "tool_magazine.ladder:81");
    end
    X4 = 1'd0;
    X3 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // tool_magazine.ladder:83
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b Y3=%b at %0s", expect_12, Y3, "tool_magazine.ladder:83");
    end
    X16 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // tool_magazine.ladder:85
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b Y3=%b Y1=%b at %0s", expect_13, Y3, Y1, "tool_magazine.ladder:85");
    end
    X16 = 1'd0;
    at3 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // tool_magazine.ladder:87
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b Y1=%b at %0s", expect_14, Y1, "tool_magazine.ladder:87");
    end
    home = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // tool_magazine.ladder:89
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b Y1=%b at %0s", expect_15, Y1, "tool_magazine.ladder:89");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "T2 unloads tool 2, T11 closes the pump, T3 clamps tool 3, T12 brings it home");
    end else $display("ok 1 - %0s", "T2 unloads tool 2, T11 closes the pump, T3 clamps tool 3, T12 brings it home");

    if (failures != 0) $display("# %0d of 1 tests failed", failures);
    $finish;
  end
endmodule
