// Made by hotrail 0.1.0 from wound_rotor_start.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module wound_rotor_start_expect (
  input  wire clk,
  input  wire rst,
  input  wire K1,
  input  wire K2,
  input  wire K3,
  input  wire K4,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_0_2,
  output wire expect_0_3,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_1_2,
  output wire expect_1_3,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_2_2,
  output wire expect_2_3,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_3_2,
  output wire expect_3_3,
  output wire expect_4_0,
  output wire expect_4_1,
  output wire expect_4_2,
  output wire expect_4_3,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_5_2,
  output wire expect_5_3,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_6_2,
  output wire expect_6_3,
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
  output wire expect_9_2,
  output wire expect_9_3,
  output wire expect_10_0,
  output wire expect_10_1,
  output wire expect_10_2,
  output wire expect_10_3,
  output wire expect_11_0,
  output wire expect_12_0,
  output wire expect_12_1,
  output wire expect_13_0,
  output wire expect_14_0,
  output wire expect_14_1,
  output wire expect_14_2,
  output wire expect_14_3,
  output wire expect_15_0,
  output wire expect_15_1,
  output wire expect_15_2,
  output wire expect_15_3,
  output wire expect_16_0,
  output wire expect_17_0,
  output wire expect_18_0,
  output wire expect_19_0,
  output wire expect_19_1
);

  assign expect_0_0 = K1;
  assign expect_0_1 = ~K2;
  assign expect_0_2 = ~K3;
  assign expect_0_3 = ~K4;
  assign expect_1_0 = K1;
  assign expect_1_1 = ~K2;
  assign expect_1_2 = ~K3;
  assign expect_1_3 = ~K4;
  assign expect_2_0 = K1;
  assign expect_2_1 = K2;
  assign expect_2_2 = ~K3;
  assign expect_2_3 = ~K4;
  assign expect_3_0 = K1;
  assign expect_3_1 = K2;
  assign expect_3_2 = ~K3;
  assign expect_3_3 = ~K4;
  assign expect_4_0 = K1;
  assign expect_4_1 = K2;
  assign expect_4_2 = K3;
  assign expect_4_3 = ~K4;
  assign expect_5_0 = K1;
  assign expect_5_1 = K2;
  assign expect_5_2 = K3;
  assign expect_5_3 = ~K4;
  assign expect_6_0 = K1;
  assign expect_6_1 = K2;
  assign expect_6_2 = K3;
  assign expect_6_3 = K4;
  assign expect_7_0 = K1;
  assign expect_7_1 = K2;
  assign expect_7_2 = K3;
  assign expect_7_3 = K4;
  assign expect_8_0 = K1;
  assign expect_8_1 = K2;
  assign expect_8_2 = K3;
  assign expect_8_3 = ~K4;
  assign expect_9_0 = ~K1;
  assign expect_9_1 = ~K2;
  assign expect_9_2 = ~K3;
  assign expect_9_3 = ~K4;
  assign expect_10_0 = K1;
  assign expect_10_1 = ~K2;
  assign expect_10_2 = ~K3;
  assign expect_10_3 = ~K4;
  assign expect_11_0 = ~K2;
  assign expect_12_0 = K2;
  assign expect_12_1 = ~K3;
  assign expect_13_0 = K4;
  assign expect_14_0 = ~K1;
  assign expect_14_1 = ~K2;
  assign expect_14_2 = ~K3;
  assign expect_14_3 = ~K4;
  assign expect_15_0 = ~K1;
  assign expect_15_1 = ~K2;
  assign expect_15_2 = ~K3;
  assign expect_15_3 = ~K4;
  assign expect_16_0 = ~K2;
  assign expect_17_0 = K2;
  assign expect_18_0 = ~K1;
  assign expect_19_0 = ~K1;
  assign expect_19_1 = ~K2;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module wound_rotor_start_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg S0 = 1'd0;
  reg S1 = 1'd0;
  reg F1 = 1'd0;
  wire K1;
  wire K2;
  wire K3;
  wire K4;
  reg failed;
  integer failures;

  wound_rotor_start core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .S0(S0),
    .S1(S1),
    .F1(F1),
    .K1(K1),
    .K2(K2),
    .K3(K3),
    .K4(K4)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire expect_0_3;
  wire [0:3] expect_0 = {expect_0_0, expect_0_1, expect_0_2, expect_0_3};
  wire expect_1_0;
  wire expect_1_1;
  wire expect_1_2;
  wire expect_1_3;
  wire [0:3] expect_1 = {expect_1_0, expect_1_1, expect_1_2, expect_1_3};
  wire expect_2_0;
  wire expect_2_1;
  wire expect_2_2;
  wire expect_2_3;
  wire [0:3] expect_2 = {expect_2_0, expect_2_1, expect_2_2, expect_2_3};
  wire expect_3_0;
  wire expect_3_1;
  wire expect_3_2;
  wire expect_3_3;
  wire [0:3] expect_3 = {expect_3_0, expect_3_1, expect_3_2, expect_3_3};
  wire expect_4_0;
  wire expect_4_1;
  wire expect_4_2;
  wire expect_4_3;
  wire [0:3] expect_4 = {expect_4_0, expect_4_1, expect_4_2, expect_4_3};
  wire expect_5_0;
  wire expect_5_1;
  wire expect_5_2;
  wire expect_5_3;
  wire [0:3] expect_5 = {expect_5_0, expect_5_1, expect_5_2, expect_5_3};
  wire expect_6_0;
  wire expect_6_1;
  wire expect_6_2;
  wire expect_6_3;
  wire [0:3] expect_6 = {expect_6_0, expect_6_1, expect_6_2, expect_6_3};
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
  wire expect_9_2;
  wire expect_9_3;
  wire [0:3] expect_9 = {expect_9_0, expect_9_1, expect_9_2, expect_9_3};
  wire expect_10_0;
  wire expect_10_1;
  wire expect_10_2;
  wire expect_10_3;
  wire [0:3] expect_10 = {expect_10_0, expect_10_1, expect_10_2, expect_10_3};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  wire expect_12_0;
  wire expect_12_1;
  wire [0:1] expect_12 = {expect_12_0, expect_12_1};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire expect_14_1;
  wire expect_14_2;
  wire expect_14_3;
  wire [0:3] expect_14 = {expect_14_0, expect_14_1, expect_14_2, expect_14_3};
  wire expect_15_0;
  wire expect_15_1;
  wire expect_15_2;
  wire expect_15_3;
  wire [0:3] expect_15 = {expect_15_0, expect_15_1, expect_15_2, expect_15_3};
  wire expect_16_0;
  wire [0:0] expect_16 = {expect_16_0};
  wire expect_17_0;
  wire [0:0] expect_17 = {expect_17_0};
  wire expect_18_0;
  wire [0:0] expect_18 = {expect_18_0};
  wire expect_19_0;
  wire expect_19_1;
  wire [0:1] expect_19 = {expect_19_0, expect_19_1};
  wound_rotor_start_expect expectations (
    .clk(clk),
    .rst(rst),
    .K1(K1),
    .K2(K2),
    .K3(K3),
    .K4(K4),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_0_3(expect_0_3),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_1_3(expect_1_3),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_2_2(expect_2_2),
    .expect_2_3(expect_2_3),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_3_3(expect_3_3),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_4_3(expect_4_3),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_5_3(expect_5_3),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_6_2(expect_6_2),
    .expect_6_3(expect_6_3),
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
    .expect_9_2(expect_9_2),
    .expect_9_3(expect_9_3),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_10_2(expect_10_2),
    .expect_10_3(expect_10_3),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_14_1(expect_14_1),
    .expect_14_2(expect_14_2),
    .expect_14_3(expect_14_3),
    .expect_15_0(expect_15_0),
    .expect_15_1(expect_15_1),
    .expect_15_2(expect_15_2),
    .expect_15_3(expect_15_3),
    .expect_16_0(expect_16_0),
    .expect_17_0(expect_17_0),
    .expect_18_0(expect_18_0),
    .expect_19_0(expect_19_0),
    .expect_19_1(expect_19_1)
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
      S0 = 1'd0;
      S1 = 1'd0;
      F1 = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..5");

    // K2, K3 and K4 follow, each after 5 s
    failed = 1'b0;
    reset;
    S0 = 1'd1;
    F1 = 1'd1;
    S1 = 1'd1;
    scan(1, 1'b0);
    S1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // wound_rotor_start.ladder:22
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_0, K1, K2, K3, K4, "wound_rotor_start.ladder:22");
    end
    scan(49, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // wound_rotor_start.ladder:24
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_1, K1, K2, K3, K4, "wound_rotor_start.ladder:24");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // wound_rotor_start.ladder:26
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_2, K1, K2, K3, K4, "wound_rotor_start.ladder:26");
    end
    scan(49, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // wound_rotor_start.ladder:28
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_3, K1, K2, K3, K4, "wound_rotor_start.ladder:28");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // wound_rotor_start.ladder:30
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_4, K1, K2, K3, K4, "wound_rotor_start.ladder:30");
    end
    scan(49, 1'b1);
    #1 if (!failed && &expect_5 !== 1'b1) begin // wound_rotor_start.ladder:32
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_5, K1, K2, K3, K4, "wound_rotor_start.ladder:32");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // wound_rotor_start.ladder:34
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_6, K1, K2, K3, K4, "wound_rotor_start.ladder:34");
    end
    scan(600, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // wound_rotor_start.ladder:36
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_7, K1, K2, K3, K4, "wound_rotor_start.ladder:36");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "K2, K3 and K4 follow, each after 5 s");
    end else $display("ok 1 - %0s", "K2, K3 and K4 follow, each after 5 s");

    // stop in the middle opens all, and a new start has all its steps
    failed = 1'b0;
    reset;
    S0 = 1'd1;
    F1 = 1'd1;
    S1 = 1'd1;
    scan(1, 1'b0);
    S1 = 1'd0;
    scan(1, 1'b0);
    scan(120, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // wound_rotor_start.ladder:42
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_8, K1, K2, K3, K4, "wound_rotor_start.ladder:42");
    end
    S0 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // wound_rotor_start.ladder:44
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_9, K1, K2, K3, K4, "wound_rotor_start.ladder:44");
    end
    S0 = 1'd1;
    scan(1, 1'b0);
    S1 = 1'd1;
    scan(1, 1'b0);
    S1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // wound_rotor_start.ladder:47
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_10, K1, K2, K3, K4, "wound_rotor_start.ladder:47");
    end
    scan(49, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // wound_rotor_start.ladder:49
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b K2=%b at %0s", expect_11, K2, "wound_rotor_start.ladder:49");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // wound_rotor_start.ladder:51
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b K2=%b K3=%b at %0s", expect_12, K2, K3, "wound_rotor_start.ladder:51");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "stop in the middle opens all, and a new start has all its steps");
    end else $display("ok 2 - %0s", "stop in the middle opens all, and a new start has all its steps");

    // the overload relay opens all, and its return starts nothing
    failed = 1'b0;
    reset;
    S0 = 1'd1;
    F1 = 1'd1;
    S1 = 1'd1;
    scan(1, 1'b0);
    S1 = 1'd0;
    scan(1, 1'b0);
    scan(150, 1'b1);
    #1 if (!failed && &expect_13 !== 1'b1) begin // wound_rotor_start.ladder:57
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b K4=%b at %0s", expect_13, K4, "wound_rotor_start.ladder:57");
    end
    F1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // wound_rotor_start.ladder:59
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_14, K1, K2, K3, K4, "wound_rotor_start.ladder:59");
    end
    F1 = 1'd1;
    scan(200, 1'b1);
    #1 if (!failed && &expect_15 !== 1'b1) begin // wound_rotor_start.ladder:61
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b K1=%b K2=%b K3=%b K4=%b at %0s", expect_15, K1, K2, K3, K4, "wound_rotor_start.ladder:61");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "the overload relay opens all, and its return starts nothing");
    end else $display("ok 3 - %0s", "the overload relay opens all, and its return starts nothing");

    // the start button once more changes nothing
    failed = 1'b0;
    reset;
    S0 = 1'd1;
    F1 = 1'd1;
    S1 = 1'd1;
    scan(1, 1'b0);
    S1 = 1'd0;
    scan(1, 1'b0);
    scan(40, 1'b1);
    S1 = 1'd1;
    scan(1, 1'b0);
    S1 = 1'd0;
    scan(1, 1'b0);
    scan(9, 1'b1);
    #1 if (!failed && &expect_16 !== 1'b1) begin // wound_rotor_start.ladder:69
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b K2=%b at %0s", expect_16, K2, "wound_rotor_start.ladder:69");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_17 !== 1'b1) begin // wound_rotor_start.ladder:71
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b K2=%b at %0s", expect_17, K2, "wound_rotor_start.ladder:71");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "the start button once more changes nothing");
    end else $display("ok 4 - %0s", "the start button once more changes nothing");

    // stop wins over start
    failed = 1'b0;
    reset;
    F1 = 1'd1;
    S1 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_18 !== 1'b1) begin // wound_rotor_start.ladder:75
      failed = 1'b1;
      $display("# failed expectation 18 conducts %b K1=%b at %0s", expect_18, K1, "wound_rotor_start.ladder:75");
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_19 !== 1'b1) begin // wound_rotor_start.ladder:77
      failed = 1'b1;
      $display("# failed expectation 19 conducts %b K1=%b K2=%b at %0s", expect_19, K1, K2, "wound_rotor_start.ladder:77");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "stop wins over start");
    end else $display("ok 5 - %0s", "stop wins over start");

    if (failures != 0) $display("# %0d of 5 tests failed", failures);
    $finish;
  end
endmodule
