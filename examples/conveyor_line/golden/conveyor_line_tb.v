// Made by hotrail 0.1.0 from conveyor_line.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module conveyor_line_expect (
  input  wire clk,
  input  wire rst,
  input  wire C3,
  input  wire C2,
  input  wire C1,
  input  wire fault_1,
  input  wire fault_2,
  input  wire fault_3,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_0_2,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_1_2,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_4_0,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_5_2,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_6_2,
  output wire expect_7_0,
  output wire expect_7_1,
  output wire expect_7_2,
  output wire expect_8_0,
  output wire expect_8_1,
  output wire expect_8_2,
  output wire expect_9_0,
  output wire expect_9_1,
  output wire expect_9_2,
  output wire expect_9_3,
  output wire expect_9_4,
  output wire expect_9_5,
  output wire expect_10_0,
  output wire expect_10_1,
  output wire expect_10_2,
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_11_2,
  output wire expect_12_0,
  output wire expect_12_1,
  output wire expect_13_0,
  output wire expect_13_1,
  output wire expect_14_0,
  output wire expect_15_0,
  output wire expect_16_0,
  output wire expect_16_1,
  output wire expect_16_2,
  output wire expect_17_0,
  output wire expect_17_1,
  output wire expect_17_2,
  output wire expect_18_0,
  output wire expect_18_1,
  output wire expect_19_0,
  output wire expect_20_0,
  output wire expect_20_1,
  output wire expect_21_0,
  output wire expect_22_0,
  output wire expect_22_1,
  output wire expect_23_0,
  output wire expect_24_0,
  output wire expect_24_1,
  output wire expect_24_2,
  output wire expect_25_0,
  output wire expect_25_1,
  output wire expect_25_2,
  output wire expect_26_0,
  output wire expect_26_1,
  output wire expect_26_2,
  output wire expect_27_0,
  output wire expect_27_1,
  output wire expect_28_0,
  output wire expect_29_0,
  output wire expect_29_1,
  output wire expect_29_2,
  output wire expect_30_0,
  output wire expect_30_1,
  output wire expect_31_0,
  output wire expect_31_1,
  output wire expect_32_0,
  output wire expect_32_1,
  output wire expect_32_2,
  output wire expect_32_3,
  output wire expect_32_4,
  output wire expect_32_5,
  output wire expect_33_0,
  output wire expect_33_1,
  output wire expect_34_0,
  output wire expect_34_1,
  output wire expect_35_0,
  output wire expect_35_1,
  output wire expect_36_0,
  output wire expect_36_1,
  output wire expect_36_2,
  output wire expect_36_3,
  output wire expect_37_0,
  output wire expect_37_1,
  output wire expect_38_0,
  output wire expect_38_1,
  output wire expect_39_0,
  output wire expect_39_1,
  output wire expect_40_0,
  output wire expect_41_0,
  output wire expect_41_1,
  output wire expect_41_2,
  output wire expect_41_3,
  output wire expect_42_0,
  output wire expect_42_1,
  output wire expect_42_2,
  output wire expect_43_0,
  output wire expect_43_1,
  output wire expect_43_2,
  output wire expect_44_0,
  output wire expect_44_1,
  output wire expect_44_2,
  output wire expect_45_0,
  output wire expect_45_1,
  output wire expect_45_2,
  output wire expect_46_0,
  output wire expect_46_1,
  output wire expect_47_0,
  output wire expect_48_0,
  output wire expect_48_1,
  output wire expect_48_2
);

  assign expect_0_0 = C3;
  assign expect_0_1 = ~C2;
  assign expect_0_2 = ~C1;
  assign expect_1_0 = C3;
  assign expect_1_1 = C2;
  assign expect_1_2 = ~C1;
  assign expect_2_0 = C3;
  assign expect_2_1 = C2;
  assign expect_3_0 = C3;
  assign expect_3_1 = ~C2;
  assign expect_4_0 = C3;
  assign expect_5_0 = ~C3;
  assign expect_5_1 = ~C2;
  assign expect_5_2 = ~C1;
  assign expect_6_0 = C3;
  assign expect_6_1 = ~C2;
  assign expect_6_2 = ~C1;
  assign expect_7_0 = C3;
  assign expect_7_1 = C2;
  assign expect_7_2 = ~C1;
  assign expect_8_0 = C3;
  assign expect_8_1 = C2;
  assign expect_8_2 = C1;
  assign expect_9_0 = C3;
  assign expect_9_1 = C2;
  assign expect_9_2 = C1;
  assign expect_9_3 = ~fault_1;
  assign expect_9_4 = ~fault_2;
  assign expect_9_5 = ~fault_3;
  assign expect_10_0 = C1;
  assign expect_10_1 = C2;
  assign expect_10_2 = C3;
  assign expect_11_0 = ~C1;
  assign expect_11_1 = C2;
  assign expect_11_2 = C3;
  assign expect_12_0 = C2;
  assign expect_12_1 = C3;
  assign expect_13_0 = ~C2;
  assign expect_13_1 = C3;
  assign expect_14_0 = C3;
  assign expect_15_0 = ~C3;
  assign expect_16_0 = ~C1;
  assign expect_16_1 = ~C2;
  assign expect_16_2 = ~C3;
  assign expect_17_0 = C1;
  assign expect_17_1 = C2;
  assign expect_17_2 = C3;
  assign expect_18_0 = ~C2;
  assign expect_18_1 = C3;
  assign expect_19_0 = C3;
  assign expect_20_0 = C2;
  assign expect_20_1 = C3;
  assign expect_21_0 = C2;
  assign expect_22_0 = ~C2;
  assign expect_22_1 = C3;
  assign expect_23_0 = ~C3;
  assign expect_24_0 = ~C1;
  assign expect_24_1 = C2;
  assign expect_24_2 = C3;
  assign expect_25_0 = C1;
  assign expect_25_1 = ~C2;
  assign expect_25_2 = C3;
  assign expect_26_0 = ~C1;
  assign expect_26_1 = ~C2;
  assign expect_26_2 = C3;
  assign expect_27_0 = C2;
  assign expect_27_1 = ~C1;
  assign expect_28_0 = C1;
  assign expect_29_0 = ~C1;
  assign expect_29_1 = C2;
  assign expect_29_2 = C3;
  assign expect_30_0 = C2;
  assign expect_30_1 = ~fault_2;
  assign expect_31_0 = C2;
  assign expect_31_1 = fault_2;
  assign expect_32_0 = ~C1;
  assign expect_32_1 = ~C2;
  assign expect_32_2 = C3;
  assign expect_32_3 = fault_2;
  assign expect_32_4 = ~fault_1;
  assign expect_32_5 = ~fault_3;
  assign expect_33_0 = ~C2;
  assign expect_33_1 = C3;
  assign expect_34_0 = C2;
  assign expect_34_1 = ~fault_2;
  assign expect_35_0 = C3;
  assign expect_35_1 = ~fault_3;
  assign expect_36_0 = ~C3;
  assign expect_36_1 = ~C2;
  assign expect_36_2 = ~C1;
  assign expect_36_3 = fault_3;
  assign expect_37_0 = C3;
  assign expect_37_1 = ~fault_3;
  assign expect_38_0 = ~C3;
  assign expect_38_1 = fault_3;
  assign expect_39_0 = ~C3;
  assign expect_39_1 = fault_3;
  assign expect_40_0 = C1;
  assign expect_41_0 = ~C1;
  assign expect_41_1 = C2;
  assign expect_41_2 = C3;
  assign expect_41_3 = fault_1;
  assign expect_42_0 = C1;
  assign expect_42_1 = C2;
  assign expect_42_2 = C3;
  assign expect_43_0 = ~C1;
  assign expect_43_1 = ~C2;
  assign expect_43_2 = ~C3;
  assign expect_44_0 = ~C1;
  assign expect_44_1 = ~C2;
  assign expect_44_2 = ~C3;
  assign expect_45_0 = ~C1;
  assign expect_45_1 = C2;
  assign expect_45_2 = C3;
  assign expect_46_0 = ~C2;
  assign expect_46_1 = C3;
  assign expect_47_0 = ~C3;
  assign expect_48_0 = C1;
  assign expect_48_1 = C2;
  assign expect_48_2 = C3;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module conveyor_line_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg reset_faults = 1'd0;
  reg stop = 1'd0;
  reg L1 = 1'd0;
  reg L2 = 1'd0;
  reg L3 = 1'd0;
  reg L4 = 1'd0;
  reg P1 = 1'd0;
  reg P2 = 1'd0;
  reg P3 = 1'd0;
  wire C1;
  wire C2;
  wire C3;
  wire fault_1;
  wire fault_2;
  wire fault_3;
  reg failed;
  integer failures;

  conveyor_line core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .reset_faults(reset_faults),
    .stop(stop),
    .L1(L1),
    .L2(L2),
    .L3(L3),
    .L4(L4),
    .P1(P1),
    .P2(P2),
    .P3(P3),
    .C1(C1),
    .C2(C2),
    .C3(C3),
    .fault_1(fault_1),
    .fault_2(fault_2),
    .fault_3(fault_3)
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
  wire expect_2_1;
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire expect_3_1;
  wire [0:1] expect_3 = {expect_3_0, expect_3_1};
  wire expect_4_0;
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire expect_5_1;
  wire expect_5_2;
  wire [0:2] expect_5 = {expect_5_0, expect_5_1, expect_5_2};
  wire expect_6_0;
  wire expect_6_1;
  wire expect_6_2;
  wire [0:2] expect_6 = {expect_6_0, expect_6_1, expect_6_2};
  wire expect_7_0;
  wire expect_7_1;
  wire expect_7_2;
  wire [0:2] expect_7 = {expect_7_0, expect_7_1, expect_7_2};
  wire expect_8_0;
  wire expect_8_1;
  wire expect_8_2;
  wire [0:2] expect_8 = {expect_8_0, expect_8_1, expect_8_2};
  wire expect_9_0;
  wire expect_9_1;
  wire expect_9_2;
  wire expect_9_3;
  wire expect_9_4;
  wire expect_9_5;
  wire [0:5] expect_9 = {expect_9_0, expect_9_1, expect_9_2, expect_9_3, expect_9_4, expect_9_5};
  wire expect_10_0;
  wire expect_10_1;
  wire expect_10_2;
  wire [0:2] expect_10 = {expect_10_0, expect_10_1, expect_10_2};
  wire expect_11_0;
  wire expect_11_1;
  wire expect_11_2;
  wire [0:2] expect_11 = {expect_11_0, expect_11_1, expect_11_2};
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
  wire expect_16_0;
  wire expect_16_1;
  wire expect_16_2;
  wire [0:2] expect_16 = {expect_16_0, expect_16_1, expect_16_2};
  wire expect_17_0;
  wire expect_17_1;
  wire expect_17_2;
  wire [0:2] expect_17 = {expect_17_0, expect_17_1, expect_17_2};
  wire expect_18_0;
  wire expect_18_1;
  wire [0:1] expect_18 = {expect_18_0, expect_18_1};
  wire expect_19_0;
  wire [0:0] expect_19 = {expect_19_0};
  wire expect_20_0;
  wire expect_20_1;
  wire [0:1] expect_20 = {expect_20_0, expect_20_1};
  wire expect_21_0;
  wire [0:0] expect_21 = {expect_21_0};
  wire expect_22_0;
  wire expect_22_1;
  wire [0:1] expect_22 = {expect_22_0, expect_22_1};
  wire expect_23_0;
  wire [0:0] expect_23 = {expect_23_0};
  wire expect_24_0;
  wire expect_24_1;
  wire expect_24_2;
  wire [0:2] expect_24 = {expect_24_0, expect_24_1, expect_24_2};
  wire expect_25_0;
  wire expect_25_1;
  wire expect_25_2;
  wire [0:2] expect_25 = {expect_25_0, expect_25_1, expect_25_2};
  wire expect_26_0;
  wire expect_26_1;
  wire expect_26_2;
  wire [0:2] expect_26 = {expect_26_0, expect_26_1, expect_26_2};
  wire expect_27_0;
  wire expect_27_1;
  wire [0:1] expect_27 = {expect_27_0, expect_27_1};
  wire expect_28_0;
  wire [0:0] expect_28 = {expect_28_0};
  wire expect_29_0;
  wire expect_29_1;
  wire expect_29_2;
  wire [0:2] expect_29 = {expect_29_0, expect_29_1, expect_29_2};
  wire expect_30_0;
  wire expect_30_1;
  wire [0:1] expect_30 = {expect_30_0, expect_30_1};
  wire expect_31_0;
  wire expect_31_1;
  wire [0:1] expect_31 = {expect_31_0, expect_31_1};
  wire expect_32_0;
  wire expect_32_1;
  wire expect_32_2;
  wire expect_32_3;
  wire expect_32_4;
  wire expect_32_5;
  wire [0:5] expect_32 = {expect_32_0, expect_32_1, expect_32_2, expect_32_3, expect_32_4, expect_32_5};
  wire expect_33_0;
  wire expect_33_1;
  wire [0:1] expect_33 = {expect_33_0, expect_33_1};
  wire expect_34_0;
  wire expect_34_1;
  wire [0:1] expect_34 = {expect_34_0, expect_34_1};
  wire expect_35_0;
  wire expect_35_1;
  wire [0:1] expect_35 = {expect_35_0, expect_35_1};
  wire expect_36_0;
  wire expect_36_1;
  wire expect_36_2;
  wire expect_36_3;
  wire [0:3] expect_36 = {expect_36_0, expect_36_1, expect_36_2, expect_36_3};
  wire expect_37_0;
  wire expect_37_1;
  wire [0:1] expect_37 = {expect_37_0, expect_37_1};
  wire expect_38_0;
  wire expect_38_1;
  wire [0:1] expect_38 = {expect_38_0, expect_38_1};
  wire expect_39_0;
  wire expect_39_1;
  wire [0:1] expect_39 = {expect_39_0, expect_39_1};
  wire expect_40_0;
  wire [0:0] expect_40 = {expect_40_0};
  wire expect_41_0;
  wire expect_41_1;
  wire expect_41_2;
  wire expect_41_3;
  wire [0:3] expect_41 = {expect_41_0, expect_41_1, expect_41_2, expect_41_3};
  wire expect_42_0;
  wire expect_42_1;
  wire expect_42_2;
  wire [0:2] expect_42 = {expect_42_0, expect_42_1, expect_42_2};
  wire expect_43_0;
  wire expect_43_1;
  wire expect_43_2;
  wire [0:2] expect_43 = {expect_43_0, expect_43_1, expect_43_2};
  wire expect_44_0;
  wire expect_44_1;
  wire expect_44_2;
  wire [0:2] expect_44 = {expect_44_0, expect_44_1, expect_44_2};
  wire expect_45_0;
  wire expect_45_1;
  wire expect_45_2;
  wire [0:2] expect_45 = {expect_45_0, expect_45_1, expect_45_2};
  wire expect_46_0;
  wire expect_46_1;
  wire [0:1] expect_46 = {expect_46_0, expect_46_1};
  wire expect_47_0;
  wire [0:0] expect_47 = {expect_47_0};
  wire expect_48_0;
  wire expect_48_1;
  wire expect_48_2;
  wire [0:2] expect_48 = {expect_48_0, expect_48_1, expect_48_2};
  conveyor_line_expect expectations (
    .clk(clk),
    .rst(rst),
    .C3(C3),
    .C2(C2),
    .C1(C1),
    .fault_1(fault_1),
    .fault_2(fault_2),
    .fault_3(fault_3),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_6_2(expect_6_2),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_7_2(expect_7_2),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_8_2(expect_8_2),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_9_2(expect_9_2),
    .expect_9_3(expect_9_3),
    .expect_9_4(expect_9_4),
    .expect_9_5(expect_9_5),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_10_2(expect_10_2),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_11_2(expect_11_2),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_13_0(expect_13_0),
    .expect_13_1(expect_13_1),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_16_0(expect_16_0),
    .expect_16_1(expect_16_1),
    .expect_16_2(expect_16_2),
    .expect_17_0(expect_17_0),
    .expect_17_1(expect_17_1),
    .expect_17_2(expect_17_2),
    .expect_18_0(expect_18_0),
    .expect_18_1(expect_18_1),
    .expect_19_0(expect_19_0),
    .expect_20_0(expect_20_0),
    .expect_20_1(expect_20_1),
    .expect_21_0(expect_21_0),
    .expect_22_0(expect_22_0),
    .expect_22_1(expect_22_1),
    .expect_23_0(expect_23_0),
    .expect_24_0(expect_24_0),
    .expect_24_1(expect_24_1),
    .expect_24_2(expect_24_2),
    .expect_25_0(expect_25_0),
    .expect_25_1(expect_25_1),
    .expect_25_2(expect_25_2),
    .expect_26_0(expect_26_0),
    .expect_26_1(expect_26_1),
    .expect_26_2(expect_26_2),
    .expect_27_0(expect_27_0),
    .expect_27_1(expect_27_1),
    .expect_28_0(expect_28_0),
    .expect_29_0(expect_29_0),
    .expect_29_1(expect_29_1),
    .expect_29_2(expect_29_2),
    .expect_30_0(expect_30_0),
    .expect_30_1(expect_30_1),
    .expect_31_0(expect_31_0),
    .expect_31_1(expect_31_1),
    .expect_32_0(expect_32_0),
    .expect_32_1(expect_32_1),
    .expect_32_2(expect_32_2),
    .expect_32_3(expect_32_3),
    .expect_32_4(expect_32_4),
    .expect_32_5(expect_32_5),
    .expect_33_0(expect_33_0),
    .expect_33_1(expect_33_1),
    .expect_34_0(expect_34_0),
    .expect_34_1(expect_34_1),
    .expect_35_0(expect_35_0),
    .expect_35_1(expect_35_1),
    .expect_36_0(expect_36_0),
    .expect_36_1(expect_36_1),
    .expect_36_2(expect_36_2),
    .expect_36_3(expect_36_3),
    .expect_37_0(expect_37_0),
    .expect_37_1(expect_37_1),
    .expect_38_0(expect_38_0),
    .expect_38_1(expect_38_1),
    .expect_39_0(expect_39_0),
    .expect_39_1(expect_39_1),
    .expect_40_0(expect_40_0),
    .expect_41_0(expect_41_0),
    .expect_41_1(expect_41_1),
    .expect_41_2(expect_41_2),
    .expect_41_3(expect_41_3),
    .expect_42_0(expect_42_0),
    .expect_42_1(expect_42_1),
    .expect_42_2(expect_42_2),
    .expect_43_0(expect_43_0),
    .expect_43_1(expect_43_1),
    .expect_43_2(expect_43_2),
    .expect_44_0(expect_44_0),
    .expect_44_1(expect_44_1),
    .expect_44_2(expect_44_2),
    .expect_45_0(expect_45_0),
    .expect_45_1(expect_45_1),
    .expect_45_2(expect_45_2),
    .expect_46_0(expect_46_0),
    .expect_46_1(expect_46_1),
    .expect_47_0(expect_47_0),
    .expect_48_0(expect_48_0),
    .expect_48_1(expect_48_1),
    .expect_48_2(expect_48_2)
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
      reset_faults = 1'd0;
      stop = 1'd0;
      L1 = 1'd0;
      L2 = 1'd0;
      L3 = 1'd0;
      L4 = 1'd0;
      P1 = 1'd0;
      P2 = 1'd0;
      P3 = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..10");

    // after power-up the conveyors run empty
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // conveyor_line.ladder:46
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b C3=%b C2=%b C1=%b at %0s", expect_0, C3, C2, C1, "conveyor_line.ladder:46");
    end
    scan(30, 1'b1);
    P3 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // conveyor_line.ladder:49
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b C3=%b C2=%b C1=%b at %0s", expect_1, C3, C2, C1, "conveyor_line.ladder:49");
    end
    P2 = 1'd1;
    scan(1, 1'b0);
    scan(99, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // conveyor_line.ladder:53
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b C3=%b C2=%b at %0s", expect_2, C3, C2, "conveyor_line.ladder:53");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // conveyor_line.ladder:56
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b C3=%b C2=%b at %0s", expect_3, C3, C2, "conveyor_line.ladder:56");
    end
    P2 = 1'd0;
    scan(99, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // conveyor_line.ladder:60
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b C3=%b at %0s", expect_4, C3, "conveyor_line.ladder:60");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // conveyor_line.ladder:63
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b C3=%b C2=%b C1=%b at %0s", expect_5, C3, C2, C1, "conveyor_line.ladder:63");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "after power-up the conveyors run empty");
    end else $display("ok 1 - %0s", "after power-up the conveyors run empty");

    // they start from the bin upwards
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L2 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // conveyor_line.ladder:68
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b C3=%b C2=%b C1=%b at %0s", expect_6, C3, C2, C1, "conveyor_line.ladder:68");
    end
    scan(39, 1'b1);
    P3 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // conveyor_line.ladder:71
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b C3=%b C2=%b C1=%b at %0s", expect_7, C3, C2, C1, "conveyor_line.ladder:71");
    end
    scan(39, 1'b1);
    P2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // conveyor_line.ladder:74
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b C3=%b C2=%b C1=%b at %0s", expect_8, C3, C2, C1, "conveyor_line.ladder:74");
    end
    scan(39, 1'b1);
    P1 = 1'd1;
    L2 = 1'd0;
    scan(1, 1'b0);
    scan(600, 1'b1);
    #1 if (!failed && &expect_9 !== 1'b1) begin // conveyor_line.ladder:78
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b C3=%b C2=%b C1=%b fault_1=%b fault_2=%b fault_3=%b at %0s", expect_9, C3, C2, C1, fault_1, fault_2, fault_3, "conveyor_line.ladder:78");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "they start from the bin upwards");
    end else $display("ok 2 - %0s", "they start from the bin upwards");

    // a full bin: the conveyors run empty one after the other, and wait for the low level
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L2 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    P1 = 1'd1;
    P2 = 1'd1;
    P3 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    L2 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // conveyor_line.ladder:84
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b C1=%b C2=%b C3=%b at %0s", expect_10, C1, C2, C3, "conveyor_line.ladder:84");
    end
    L1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // conveyor_line.ladder:86
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b C1=%b C2=%b C3=%b at %0s", expect_11, C1, C2, C3, "conveyor_line.ladder:86");
    end
    scan(99, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // conveyor_line.ladder:89
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b C2=%b C3=%b at %0s", expect_12, C2, C3, "conveyor_line.ladder:89");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // conveyor_line.ladder:92
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b C2=%b C3=%b at %0s", expect_13, C2, C3, "conveyor_line.ladder:92");
    end
    scan(99, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // conveyor_line.ladder:95
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b C3=%b at %0s", expect_14, C3, "conveyor_line.ladder:95");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // conveyor_line.ladder:98
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b C3=%b at %0s", expect_15, C3, "conveyor_line.ladder:98");
    end
    L1 = 1'd1;
    scan(300, 1'b1);
    #1 if (!failed && &expect_16 !== 1'b1) begin // conveyor_line.ladder:100
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b C1=%b C2=%b C3=%b at %0s", expect_16, C1, C2, C3, "conveyor_line.ladder:100");
    end
    L2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_17 !== 1'b1) begin // conveyor_line.ladder:102
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b C1=%b C2=%b C3=%b at %0s", expect_17, C1, C2, C3, "conveyor_line.ladder:102");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a full bin: the conveyors run empty one after the other, and wait for the low level");
    end else $display("ok 3 - %0s", "a full bin: the conveyors run empty one after the other, and wait for the low level");

    // a conveyor that waits does not run empty
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L2 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    P1 = 1'd1;
    P2 = 1'd1;
    P3 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    L1 = 1'd0;
    L2 = 1'd0;
    scan(1, 1'b0);
    scan(50, 1'b1);
    L4 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_18 !== 1'b1) begin // conveyor_line.ladder:110
      failed = 1'b1;
      $display("# failed expectation 18 conducts %b C2=%b C3=%b at %0s", expect_18, C2, C3, "conveyor_line.ladder:110");
    end
    scan(300, 1'b1);
    #1 if (!failed && &expect_19 !== 1'b1) begin // conveyor_line.ladder:112
      failed = 1'b1;
      $display("# failed expectation 19 conducts %b C3=%b at %0s", expect_19, C3, "conveyor_line.ladder:112");
    end
    L4 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_20 !== 1'b1) begin // conveyor_line.ladder:114
      failed = 1'b1;
      $display("# failed expectation 20 conducts %b C2=%b C3=%b at %0s", expect_20, C2, C3, "conveyor_line.ladder:114");
    end
    scan(49, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_21 !== 1'b1) begin // conveyor_line.ladder:117
      failed = 1'b1;
      $display("# failed expectation 21 conducts %b C2=%b at %0s", expect_21, C2, "conveyor_line.ladder:117");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_22 !== 1'b1) begin // conveyor_line.ladder:120
      failed = 1'b1;
      $display("# failed expectation 22 conducts %b C2=%b C3=%b at %0s", expect_22, C2, C3, "conveyor_line.ladder:120");
    end
    scan(100, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_23 !== 1'b1) begin // conveyor_line.ladder:123
      failed = 1'b1;
      $display("# failed expectation 23 conducts %b C3=%b at %0s", expect_23, C3, "conveyor_line.ladder:123");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "a conveyor that waits does not run empty");
    end else $display("ok 4 - %0s", "a conveyor that waits does not run empty");

    // a hopper that is full stops the conveyor above it and no other
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L2 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    P1 = 1'd1;
    P2 = 1'd1;
    P3 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    L3 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_24 !== 1'b1) begin // conveyor_line.ladder:129
      failed = 1'b1;
      $display("# failed expectation 24 conducts %b C1=%b C2=%b C3=%b at %0s", expect_24, C1, C2, C3, "conveyor_line.ladder:129");
    end
    L3 = 1'd1;
    L4 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_25 !== 1'b1) begin // conveyor_line.ladder:131
      failed = 1'b1;
      $display("# failed expectation 25 conducts %b C1=%b C2=%b C3=%b at %0s", expect_25, C1, C2, C3, "conveyor_line.ladder:131");
    end
    P2 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_26 !== 1'b1) begin // conveyor_line.ladder:133
      failed = 1'b1;
      $display("# failed expectation 26 conducts %b C1=%b C2=%b C3=%b at %0s", expect_26, C1, C2, C3, "conveyor_line.ladder:133");
    end
    L4 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_27 !== 1'b1) begin // conveyor_line.ladder:135
      failed = 1'b1;
      $display("# failed expectation 27 conducts %b C2=%b C1=%b at %0s", expect_27, C2, C1, "conveyor_line.ladder:135");
    end
    P2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_28 !== 1'b1) begin // conveyor_line.ladder:137
      failed = 1'b1;
      $display("# failed expectation 28 conducts %b C1=%b at %0s", expect_28, C1, "conveyor_line.ladder:137");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a hopper that is full stops the conveyor above it and no other");
    end else $display("ok 5 - %0s", "a hopper that is full stops the conveyor above it and no other");

    // C2 does not turn
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L2 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    P1 = 1'd1;
    P2 = 1'd1;
    P3 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(50, 1'b1);
    P2 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_29 !== 1'b1) begin // conveyor_line.ladder:144
      failed = 1'b1;
      $display("# failed expectation 29 conducts %b C1=%b C2=%b C3=%b at %0s", expect_29, C1, C2, C3, "conveyor_line.ladder:144");
    end
    scan(39, 1'b1);
    #1 if (!failed && &expect_30 !== 1'b1) begin // conveyor_line.ladder:146
      failed = 1'b1;
      $display("# failed expectation 30 conducts %b C2=%b fault_2=%b at %0s", expect_30, C2, fault_2, "conveyor_line.ladder:146");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_31 !== 1'b1) begin // conveyor_line.ladder:148
      failed = 1'b1;
      $display("# failed expectation 31 conducts %b C2=%b fault_2=%b at %0s", expect_31, C2, fault_2, "conveyor_line.ladder:148");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_32 !== 1'b1) begin // conveyor_line.ladder:150
      failed = 1'b1;
      $display("# failed expectation 32 conducts %b C1=%b C2=%b C3=%b fault_2=%b fault_1=%b fault_3=%b at %0s", expect_32, C1, C2, C3, fault_2, fault_1, fault_3, "conveyor_line.ladder:150");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_33 !== 1'b1) begin // conveyor_line.ladder:152
      failed = 1'b1;
      $display("# failed expectation 33 conducts %b C2=%b C3=%b at %0s", expect_33, C2, C3, "conveyor_line.ladder:152");
    end
    reset_faults = 1'd1;
    scan(1, 1'b0);
    reset_faults = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_34 !== 1'b1) begin // conveyor_line.ladder:154
      failed = 1'b1;
      $display("# failed expectation 34 conducts %b C2=%b fault_2=%b at %0s", expect_34, C2, fault_2, "conveyor_line.ladder:154");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "C2 does not turn");
    end else $display("ok 6 - %0s", "C2 does not turn");

    // C3 never turns
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L2 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(39, 1'b1);
    #1 if (!failed && &expect_35 !== 1'b1) begin // conveyor_line.ladder:160
      failed = 1'b1;
      $display("# failed expectation 35 conducts %b C3=%b fault_3=%b at %0s", expect_35, C3, fault_3, "conveyor_line.ladder:160");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_36 !== 1'b1) begin // conveyor_line.ladder:163
      failed = 1'b1;
      $display("# failed expectation 36 conducts %b C3=%b C2=%b C1=%b fault_3=%b at %0s", expect_36, C3, C2, C1, fault_3, "conveyor_line.ladder:163");
    end
    reset_faults = 1'd1;
    scan(2, 1'b0);
    #1 if (!failed && &expect_37 !== 1'b1) begin // conveyor_line.ladder:165
      failed = 1'b1;
      $display("# failed expectation 37 conducts %b C3=%b fault_3=%b at %0s", expect_37, C3, fault_3, "conveyor_line.ladder:165");
    end
    scan(40, 1'b1);
    scan(2, 1'b0);
    #1 if (!failed && &expect_38 !== 1'b1) begin // conveyor_line.ladder:168
      failed = 1'b1;
      $display("# failed expectation 38 conducts %b C3=%b fault_3=%b at %0s", expect_38, C3, fault_3, "conveyor_line.ladder:168");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_39 !== 1'b1) begin // conveyor_line.ladder:170
      failed = 1'b1;
      $display("# failed expectation 39 conducts %b C3=%b fault_3=%b at %0s", expect_39, C3, fault_3, "conveyor_line.ladder:170");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "C3 never turns");
    end else $display("ok 7 - %0s", "C3 never turns");

    // C1 does not turn
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L2 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    P2 = 1'd1;
    P3 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_40 !== 1'b1) begin // conveyor_line.ladder:175
      failed = 1'b1;
      $display("# failed expectation 40 conducts %b C1=%b at %0s", expect_40, C1, "conveyor_line.ladder:175");
    end
    scan(40, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_41 !== 1'b1) begin // conveyor_line.ladder:178
      failed = 1'b1;
      $display("# failed expectation 41 conducts %b C1=%b C2=%b C3=%b fault_1=%b at %0s", expect_41, C1, C2, C3, fault_1, "conveyor_line.ladder:178");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 8 - %0s", "C1 does not turn");
    end else $display("ok 8 - %0s", "C1 does not turn");

    // stop ends all at once, and wins over start
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L2 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    P1 = 1'd1;
    P2 = 1'd1;
    P3 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_42 !== 1'b1) begin // conveyor_line.ladder:183
      failed = 1'b1;
      $display("# failed expectation 42 conducts %b C1=%b C2=%b C3=%b at %0s", expect_42, C1, C2, C3, "conveyor_line.ladder:183");
    end
    start = 1'd1;
    stop = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_43 !== 1'b1) begin // conveyor_line.ladder:185
      failed = 1'b1;
      $display("# failed expectation 43 conducts %b C1=%b C2=%b C3=%b at %0s", expect_43, C1, C2, C3, "conveyor_line.ladder:185");
    end
    stop = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_44 !== 1'b1) begin // conveyor_line.ladder:187
      failed = 1'b1;
      $display("# failed expectation 44 conducts %b C1=%b C2=%b C3=%b at %0s", expect_44, C1, C2, C3, "conveyor_line.ladder:187");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 9 - %0s", "stop ends all at once, and wins over start");
    end else $display("ok 9 - %0s", "stop ends all at once, and wins over start");

    // after a stop between the levels the conveyors run empty and wait for the low level
    failed = 1'b0;
    reset;
    stop = 1'd1;
    L1 = 1'd1;
    L2 = 1'd1;
    L3 = 1'd1;
    L4 = 1'd1;
    P1 = 1'd1;
    P2 = 1'd1;
    P3 = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    L2 = 1'd0;
    stop = 1'd0;
    scan(1, 1'b0);
    scan(600, 1'b1);
    stop = 1'd1;
    scan(1, 1'b0);
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_45 !== 1'b1) begin // conveyor_line.ladder:197
      failed = 1'b1;
      $display("# failed expectation 45 conducts %b C1=%b C2=%b C3=%b at %0s", expect_45, C1, C2, C3, "conveyor_line.ladder:197");
    end
    scan(100, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_46 !== 1'b1) begin // conveyor_line.ladder:200
      failed = 1'b1;
      $display("# failed expectation 46 conducts %b C2=%b C3=%b at %0s", expect_46, C2, C3, "conveyor_line.ladder:200");
    end
    scan(100, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_47 !== 1'b1) begin // conveyor_line.ladder:203
      failed = 1'b1;
      $display("# failed expectation 47 conducts %b C3=%b at %0s", expect_47, C3, "conveyor_line.ladder:203");
    end
    L2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_48 !== 1'b1) begin // conveyor_line.ladder:205
      failed = 1'b1;
      $display("# failed expectation 48 conducts %b C1=%b C2=%b C3=%b at %0s", expect_48, C1, C2, C3, "conveyor_line.ladder:205");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 10 - %0s", "after a stop between the levels the conveyors run empty and wait for the low level");
    end else $display("ok 10 - %0s", "after a stop between the levels the conveyors run empty and wait for the low level");

    if (failures != 0) $display("# %0d of 10 tests failed", failures);
    $finish;
  end
endmodule
