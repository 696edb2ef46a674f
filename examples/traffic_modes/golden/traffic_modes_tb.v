// Made by hotrail 0.1.0 from traffic_modes.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module traffic_modes_expect (
  input  wire clk,
  input  wire rst,
  input  wire ns_red,
  input  wire turn_red,
  input  wire ew_red,
  input  wire ns_green,
  input  wire ns_yellow,
  input  wire turn_green,
  input  wire turn_yellow,
  input  wire ew_green,
  input  wire ew_yellow,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_0_2,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_1_2,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_2_2,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_3_2,
  output wire expect_4_0,
  output wire expect_4_1,
  output wire expect_4_2,
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
  output wire expect_10_0,
  output wire expect_10_1,
  output wire expect_10_2,
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_11_2,
  output wire expect_12_0,
  output wire expect_12_1,
  output wire expect_12_2,
  output wire expect_13_0,
  output wire expect_13_1,
  output wire expect_13_2,
  output wire expect_14_0,
  output wire expect_14_1,
  output wire expect_14_2,
  output wire expect_15_0,
  output wire expect_15_1,
  output wire expect_15_2,
  output wire expect_16_0,
  output wire expect_16_1,
  output wire expect_16_2,
  output wire expect_17_0,
  output wire expect_17_1,
  output wire expect_17_2,
  output wire expect_18_0,
  output wire expect_18_1,
  output wire expect_18_2,
  output wire expect_19_0,
  output wire expect_19_1,
  output wire expect_19_2,
  output wire expect_20_0,
  output wire expect_20_1,
  output wire expect_20_2,
  output wire expect_21_0,
  output wire expect_21_1,
  output wire expect_21_2,
  output wire expect_22_0,
  output wire expect_22_1,
  output wire expect_22_2,
  output wire expect_23_0,
  output wire expect_23_1,
  output wire expect_23_2,
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
  output wire expect_28_0,
  output wire expect_29_0,
  output wire expect_30_0,
  output wire expect_31_0,
  output wire expect_31_1,
  output wire expect_31_2,
  output wire expect_32_0,
  output wire expect_33_0,
  output wire expect_33_1,
  output wire expect_33_2,
  output wire expect_34_0,
  output wire expect_34_1,
  output wire expect_34_2,
  output wire expect_35_0,
  output wire expect_35_1,
  output wire expect_35_2,
  output wire expect_35_3,
  output wire expect_35_4,
  output wire expect_35_5,
  output wire expect_35_6,
  output wire expect_35_7,
  output wire expect_35_8,
  output wire expect_36_0,
  output wire expect_36_1,
  output wire expect_36_2,
  output wire expect_37_0,
  output wire expect_37_1,
  output wire expect_37_2,
  output wire expect_37_3,
  output wire expect_37_4,
  output wire expect_37_5,
  output wire expect_37_6,
  output wire expect_37_7,
  output wire expect_37_8,
  output wire expect_38_0,
  output wire expect_38_1,
  output wire expect_38_2,
  output wire expect_39_0,
  output wire expect_40_0,
  output wire expect_41_0,
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
  output wire expect_46_0,
  output wire expect_47_0
);

  assign expect_0_0 = ns_red;
  assign expect_0_1 = turn_red;
  assign expect_0_2 = ew_red;
  assign expect_1_0 = ns_red;
  assign expect_1_1 = turn_red;
  assign expect_1_2 = ew_red;
  assign expect_2_0 = ns_red;
  assign expect_2_1 = turn_red;
  assign expect_2_2 = ew_red;
  assign expect_3_0 = ns_green;
  assign expect_3_1 = turn_red;
  assign expect_3_2 = ew_red;
  assign expect_4_0 = ns_green;
  assign expect_4_1 = turn_red;
  assign expect_4_2 = ew_red;
  assign expect_5_0 = ns_yellow;
  assign expect_5_1 = turn_red;
  assign expect_5_2 = ew_red;
  assign expect_6_0 = ns_yellow;
  assign expect_6_1 = turn_red;
  assign expect_6_2 = ew_red;
  assign expect_7_0 = ns_red;
  assign expect_7_1 = turn_red;
  assign expect_7_2 = ew_red;
  assign expect_8_0 = ns_red;
  assign expect_8_1 = turn_red;
  assign expect_8_2 = ew_red;
  assign expect_9_0 = ns_red;
  assign expect_9_1 = turn_green;
  assign expect_9_2 = ew_red;
  assign expect_10_0 = ns_red;
  assign expect_10_1 = turn_green;
  assign expect_10_2 = ew_red;
  assign expect_11_0 = ns_red;
  assign expect_11_1 = turn_yellow;
  assign expect_11_2 = ew_red;
  assign expect_12_0 = ns_red;
  assign expect_12_1 = turn_yellow;
  assign expect_12_2 = ew_red;
  assign expect_13_0 = ns_red;
  assign expect_13_1 = turn_red;
  assign expect_13_2 = ew_red;
  assign expect_14_0 = ns_red;
  assign expect_14_1 = turn_red;
  assign expect_14_2 = ew_red;
  assign expect_15_0 = ns_red;
  assign expect_15_1 = turn_red;
  assign expect_15_2 = ew_green;
  assign expect_16_0 = ns_red;
  assign expect_16_1 = turn_red;
  assign expect_16_2 = ew_green;
  assign expect_17_0 = ns_red;
  assign expect_17_1 = turn_red;
  assign expect_17_2 = ew_yellow;
  assign expect_18_0 = ns_red;
  assign expect_18_1 = turn_red;
  assign expect_18_2 = ew_yellow;
  assign expect_19_0 = ns_red;
  assign expect_19_1 = turn_red;
  assign expect_19_2 = ew_red;
  assign expect_20_0 = ns_green;
  assign expect_20_1 = turn_red;
  assign expect_20_2 = ew_red;
  assign expect_21_0 = ns_yellow;
  assign expect_21_1 = turn_red;
  assign expect_21_2 = ew_red;
  assign expect_22_0 = ns_red;
  assign expect_22_1 = turn_red;
  assign expect_22_2 = ew_red;
  assign expect_23_0 = ns_red;
  assign expect_23_1 = turn_red;
  assign expect_23_2 = ew_red;
  assign expect_24_0 = ns_red;
  assign expect_24_1 = turn_red;
  assign expect_24_2 = ew_green;
  assign expect_25_0 = ns_red;
  assign expect_25_1 = turn_red;
  assign expect_25_2 = ew_yellow;
  assign expect_26_0 = ns_red;
  assign expect_26_1 = turn_red;
  assign expect_26_2 = ew_red;
  assign expect_27_0 = turn_green;
  assign expect_28_0 = turn_green;
  assign expect_29_0 = turn_yellow;
  assign expect_30_0 = turn_yellow;
  assign expect_31_0 = ns_red;
  assign expect_31_1 = turn_red;
  assign expect_31_2 = ew_red;
  assign expect_32_0 = ew_green;
  assign expect_33_0 = ns_red;
  assign expect_33_1 = turn_red;
  assign expect_33_2 = ew_red;
  assign expect_34_0 = ns_red;
  assign expect_34_1 = turn_red;
  assign expect_34_2 = ew_red;
  assign expect_35_0 = ns_yellow;
  assign expect_35_1 = turn_yellow;
  assign expect_35_2 = ew_red;
  assign expect_35_3 = ~ns_red;
  assign expect_35_4 = ~turn_red;
  assign expect_35_5 = ~ns_green;
  assign expect_35_6 = ~turn_green;
  assign expect_35_7 = ~ew_green;
  assign expect_35_8 = ~ew_yellow;
  assign expect_36_0 = ns_yellow;
  assign expect_36_1 = turn_yellow;
  assign expect_36_2 = ew_red;
  assign expect_37_0 = ~ns_yellow;
  assign expect_37_1 = ~turn_yellow;
  assign expect_37_2 = ~ew_red;
  assign expect_37_3 = ~ns_red;
  assign expect_37_4 = ~turn_red;
  assign expect_37_5 = ~ns_green;
  assign expect_37_6 = ~turn_green;
  assign expect_37_7 = ~ew_green;
  assign expect_37_8 = ~ew_yellow;
  assign expect_38_0 = ~ns_yellow;
  assign expect_38_1 = ~turn_yellow;
  assign expect_38_2 = ~ew_red;
  assign expect_39_0 = ns_yellow;
  assign expect_40_0 = ns_yellow;
  assign expect_41_0 = ~ns_yellow;
  assign expect_42_0 = ns_red;
  assign expect_42_1 = turn_red;
  assign expect_42_2 = ew_red;
  assign expect_43_0 = ns_red;
  assign expect_43_1 = turn_red;
  assign expect_43_2 = ew_red;
  assign expect_44_0 = ns_green;
  assign expect_44_1 = turn_red;
  assign expect_44_2 = ew_red;
  assign expect_45_0 = ns_red & turn_red | ns_red & ew_red | turn_red & ew_red;
  assign expect_46_0 = ns_red & turn_red | ns_red & ew_red | turn_red & ew_red;
  assign expect_47_0 = ns_yellow & turn_yellow & ew_red | ~ns_yellow & ~turn_yellow & ~ew_red;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module traffic_modes_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg rush_hour = 1'd0;
  reg late_night = 1'd0;
  wire ns_green;
  wire ns_yellow;
  wire ns_red;
  wire turn_green;
  wire turn_yellow;
  wire turn_red;
  wire ew_green;
  wire ew_yellow;
  wire ew_red;
  reg failed;
  integer failures;

  traffic_modes core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .rush_hour(rush_hour),
    .late_night(late_night),
    .ns_green(ns_green),
    .ns_yellow(ns_yellow),
    .ns_red(ns_red),
    .turn_green(turn_green),
    .turn_yellow(turn_yellow),
    .turn_red(turn_red),
    .ew_green(ew_green),
    .ew_yellow(ew_yellow),
    .ew_red(ew_red)
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
  wire expect_2_2;
  wire [0:2] expect_2 = {expect_2_0, expect_2_1, expect_2_2};
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
  wire [0:2] expect_9 = {expect_9_0, expect_9_1, expect_9_2};
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
  wire expect_12_2;
  wire [0:2] expect_12 = {expect_12_0, expect_12_1, expect_12_2};
  wire expect_13_0;
  wire expect_13_1;
  wire expect_13_2;
  wire [0:2] expect_13 = {expect_13_0, expect_13_1, expect_13_2};
  wire expect_14_0;
  wire expect_14_1;
  wire expect_14_2;
  wire [0:2] expect_14 = {expect_14_0, expect_14_1, expect_14_2};
  wire expect_15_0;
  wire expect_15_1;
  wire expect_15_2;
  wire [0:2] expect_15 = {expect_15_0, expect_15_1, expect_15_2};
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
  wire expect_18_2;
  wire [0:2] expect_18 = {expect_18_0, expect_18_1, expect_18_2};
  wire expect_19_0;
  wire expect_19_1;
  wire expect_19_2;
  wire [0:2] expect_19 = {expect_19_0, expect_19_1, expect_19_2};
  wire expect_20_0;
  wire expect_20_1;
  wire expect_20_2;
  wire [0:2] expect_20 = {expect_20_0, expect_20_1, expect_20_2};
  wire expect_21_0;
  wire expect_21_1;
  wire expect_21_2;
  wire [0:2] expect_21 = {expect_21_0, expect_21_1, expect_21_2};
  wire expect_22_0;
  wire expect_22_1;
  wire expect_22_2;
  wire [0:2] expect_22 = {expect_22_0, expect_22_1, expect_22_2};
  wire expect_23_0;
  wire expect_23_1;
  wire expect_23_2;
  wire [0:2] expect_23 = {expect_23_0, expect_23_1, expect_23_2};
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
  wire [0:0] expect_27 = {expect_27_0};
  wire expect_28_0;
  wire [0:0] expect_28 = {expect_28_0};
  wire expect_29_0;
  wire [0:0] expect_29 = {expect_29_0};
  wire expect_30_0;
  wire [0:0] expect_30 = {expect_30_0};
  wire expect_31_0;
  wire expect_31_1;
  wire expect_31_2;
  wire [0:2] expect_31 = {expect_31_0, expect_31_1, expect_31_2};
  wire expect_32_0;
  wire [0:0] expect_32 = {expect_32_0};
  wire expect_33_0;
  wire expect_33_1;
  wire expect_33_2;
  wire [0:2] expect_33 = {expect_33_0, expect_33_1, expect_33_2};
  wire expect_34_0;
  wire expect_34_1;
  wire expect_34_2;
  wire [0:2] expect_34 = {expect_34_0, expect_34_1, expect_34_2};
  wire expect_35_0;
  wire expect_35_1;
  wire expect_35_2;
  wire expect_35_3;
  wire expect_35_4;
  wire expect_35_5;
  wire expect_35_6;
  wire expect_35_7;
  wire expect_35_8;
  wire [0:8] expect_35 = {expect_35_0, expect_35_1, expect_35_2, expect_35_3, expect_35_4, expect_35_5, expect_35_6, expect_35_7, expect_35_8};
  wire expect_36_0;
  wire expect_36_1;
  wire expect_36_2;
  wire [0:2] expect_36 = {expect_36_0, expect_36_1, expect_36_2};
  wire expect_37_0;
  wire expect_37_1;
  wire expect_37_2;
  wire expect_37_3;
  wire expect_37_4;
  wire expect_37_5;
  wire expect_37_6;
  wire expect_37_7;
  wire expect_37_8;
  wire [0:8] expect_37 = {expect_37_0, expect_37_1, expect_37_2, expect_37_3, expect_37_4, expect_37_5, expect_37_6, expect_37_7, expect_37_8};
  wire expect_38_0;
  wire expect_38_1;
  wire expect_38_2;
  wire [0:2] expect_38 = {expect_38_0, expect_38_1, expect_38_2};
  wire expect_39_0;
  wire [0:0] expect_39 = {expect_39_0};
  wire expect_40_0;
  wire [0:0] expect_40 = {expect_40_0};
  wire expect_41_0;
  wire [0:0] expect_41 = {expect_41_0};
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
  wire [0:0] expect_45 = {expect_45_0};
  wire expect_46_0;
  wire [0:0] expect_46 = {expect_46_0};
  wire expect_47_0;
  wire [0:0] expect_47 = {expect_47_0};
  traffic_modes_expect expectations (
    .clk(clk),
    .rst(rst),
    .ns_red(ns_red),
    .turn_red(turn_red),
    .ew_red(ew_red),
    .ns_green(ns_green),
    .ns_yellow(ns_yellow),
    .turn_green(turn_green),
    .turn_yellow(turn_yellow),
    .ew_green(ew_green),
    .ew_yellow(ew_yellow),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_2_2(expect_2_2),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
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
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_10_2(expect_10_2),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_11_2(expect_11_2),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_12_2(expect_12_2),
    .expect_13_0(expect_13_0),
    .expect_13_1(expect_13_1),
    .expect_13_2(expect_13_2),
    .expect_14_0(expect_14_0),
    .expect_14_1(expect_14_1),
    .expect_14_2(expect_14_2),
    .expect_15_0(expect_15_0),
    .expect_15_1(expect_15_1),
    .expect_15_2(expect_15_2),
    .expect_16_0(expect_16_0),
    .expect_16_1(expect_16_1),
    .expect_16_2(expect_16_2),
    .expect_17_0(expect_17_0),
    .expect_17_1(expect_17_1),
    .expect_17_2(expect_17_2),
    .expect_18_0(expect_18_0),
    .expect_18_1(expect_18_1),
    .expect_18_2(expect_18_2),
    .expect_19_0(expect_19_0),
    .expect_19_1(expect_19_1),
    .expect_19_2(expect_19_2),
    .expect_20_0(expect_20_0),
    .expect_20_1(expect_20_1),
    .expect_20_2(expect_20_2),
    .expect_21_0(expect_21_0),
    .expect_21_1(expect_21_1),
    .expect_21_2(expect_21_2),
    .expect_22_0(expect_22_0),
    .expect_22_1(expect_22_1),
    .expect_22_2(expect_22_2),
    .expect_23_0(expect_23_0),
    .expect_23_1(expect_23_1),
    .expect_23_2(expect_23_2),
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
    .expect_28_0(expect_28_0),
    .expect_29_0(expect_29_0),
    .expect_30_0(expect_30_0),
    .expect_31_0(expect_31_0),
    .expect_31_1(expect_31_1),
    .expect_31_2(expect_31_2),
    .expect_32_0(expect_32_0),
    .expect_33_0(expect_33_0),
    .expect_33_1(expect_33_1),
    .expect_33_2(expect_33_2),
    .expect_34_0(expect_34_0),
    .expect_34_1(expect_34_1),
    .expect_34_2(expect_34_2),
    .expect_35_0(expect_35_0),
    .expect_35_1(expect_35_1),
    .expect_35_2(expect_35_2),
    .expect_35_3(expect_35_3),
    .expect_35_4(expect_35_4),
    .expect_35_5(expect_35_5),
    .expect_35_6(expect_35_6),
    .expect_35_7(expect_35_7),
    .expect_35_8(expect_35_8),
    .expect_36_0(expect_36_0),
    .expect_36_1(expect_36_1),
    .expect_36_2(expect_36_2),
    .expect_37_0(expect_37_0),
    .expect_37_1(expect_37_1),
    .expect_37_2(expect_37_2),
    .expect_37_3(expect_37_3),
    .expect_37_4(expect_37_4),
    .expect_37_5(expect_37_5),
    .expect_37_6(expect_37_6),
    .expect_37_7(expect_37_7),
    .expect_37_8(expect_37_8),
    .expect_38_0(expect_38_0),
    .expect_38_1(expect_38_1),
    .expect_38_2(expect_38_2),
    .expect_39_0(expect_39_0),
    .expect_40_0(expect_40_0),
    .expect_41_0(expect_41_0),
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
    .expect_46_0(expect_46_0),
    .expect_47_0(expect_47_0)
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
      rush_hour = 1'd0;
      late_night = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..8");

    // all lanes are red before the first scan
    failed = 1'b0;
    reset;
    #1 if (!failed && &expect_0 !== 1'b1) begin // traffic_modes.ladder:67
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_0, ns_red, turn_red, ew_red, "traffic_modes.ladder:67");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "all lanes are red before the first scan");
    end else $display("ok 1 - %0s", "all lanes are red before the first scan");

    // a day: six intervals, and a second of red between two greens
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // traffic_modes.ladder:71
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_1, ns_red, turn_red, ew_red, "traffic_modes.ladder:71");
    end
    repeat (3) begin
      scan(9, 1'b1);
      #1 if (!failed && &expect_2 !== 1'b1) begin // traffic_modes.ladder:74
        failed = 1'b1;
        $display("# failed expectation 2 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_2, ns_red, turn_red, ew_red, "traffic_modes.ladder:74");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_3 !== 1'b1) begin // traffic_modes.ladder:76
        failed = 1'b1;
        $display("# failed expectation 3 conducts %b ns_green=%b turn_red=%b ew_red=%b at %0s", expect_3, ns_green, turn_red, ew_red, "traffic_modes.ladder:76");
      end
      scan(119, 1'b1);
      #1 if (!failed && &expect_4 !== 1'b1) begin // traffic_modes.ladder:78
        failed = 1'b1;
        $display("# failed expectation 4 conducts %b ns_green=%b turn_red=%b ew_red=%b at %0s", expect_4, ns_green, turn_red, ew_red, "traffic_modes.ladder:78");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_5 !== 1'b1) begin // traffic_modes.ladder:80
        failed = 1'b1;
        $display("# failed expectation 5 conducts %b ns_yellow=%b turn_red=%b ew_red=%b at %0s", expect_5, ns_yellow, turn_red, ew_red, "traffic_modes.ladder:80");
      end
      scan(29, 1'b1);
      #1 if (!failed && &expect_6 !== 1'b1) begin // traffic_modes.ladder:82
        failed = 1'b1;
        $display("# failed expectation 6 conducts %b ns_yellow=%b turn_red=%b ew_red=%b at %0s", expect_6, ns_yellow, turn_red, ew_red, "traffic_modes.ladder:82");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_7 !== 1'b1) begin // traffic_modes.ladder:84
        failed = 1'b1;
        $display("# failed expectation 7 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_7, ns_red, turn_red, ew_red, "traffic_modes.ladder:84");
      end
      scan(9, 1'b1);
      #1 if (!failed && &expect_8 !== 1'b1) begin // traffic_modes.ladder:86
        failed = 1'b1;
        $display("# failed expectation 8 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_8, ns_red, turn_red, ew_red, "traffic_modes.ladder:86");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_9 !== 1'b1) begin // traffic_modes.ladder:88
        failed = 1'b1;
        $display("# failed expectation 9 conducts %b ns_red=%b turn_green=%b ew_red=%b at %0s", expect_9, ns_red, turn_green, ew_red, "traffic_modes.ladder:88");
      end
      scan(59, 1'b1);
      #1 if (!failed && &expect_10 !== 1'b1) begin // traffic_modes.ladder:90
        failed = 1'b1;
        $display("# failed expectation 10 conducts %b ns_red=%b turn_green=%b ew_red=%b at %0s", expect_10, ns_red, turn_green, ew_red, "traffic_modes.ladder:90");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_11 !== 1'b1) begin // traffic_modes.ladder:92
        failed = 1'b1;
        $display("# failed expectation 11 conducts %b ns_red=%b turn_yellow=%b ew_red=%b at %0s", expect_11, ns_red, turn_yellow, ew_red, "traffic_modes.ladder:92");
      end
      scan(29, 1'b1);
      #1 if (!failed && &expect_12 !== 1'b1) begin // traffic_modes.ladder:94
        failed = 1'b1;
        $display("# failed expectation 12 conducts %b ns_red=%b turn_yellow=%b ew_red=%b at %0s", expect_12, ns_red, turn_yellow, ew_red, "traffic_modes.ladder:94");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_13 !== 1'b1) begin // traffic_modes.ladder:96
        failed = 1'b1;
        $display("# failed expectation 13 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_13, ns_red, turn_red, ew_red, "traffic_modes.ladder:96");
      end
      scan(9, 1'b1);
      #1 if (!failed && &expect_14 !== 1'b1) begin // traffic_modes.ladder:98
        failed = 1'b1;
        $display("# failed expectation 14 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_14, ns_red, turn_red, ew_red, "traffic_modes.ladder:98");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_15 !== 1'b1) begin // traffic_modes.ladder:100
        failed = 1'b1;
        $display("# failed expectation 15 conducts %b ns_red=%b turn_red=%b ew_green=%b at %0s", expect_15, ns_red, turn_red, ew_green, "traffic_modes.ladder:100");
      end
      scan(99, 1'b1);
      #1 if (!failed && &expect_16 !== 1'b1) begin // traffic_modes.ladder:102
        failed = 1'b1;
        $display("# failed expectation 16 conducts %b ns_red=%b turn_red=%b ew_green=%b at %0s", expect_16, ns_red, turn_red, ew_green, "traffic_modes.ladder:102");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_17 !== 1'b1) begin // traffic_modes.ladder:104
        failed = 1'b1;
        $display("# failed expectation 17 conducts %b ns_red=%b turn_red=%b ew_yellow=%b at %0s", expect_17, ns_red, turn_red, ew_yellow, "traffic_modes.ladder:104");
      end
      scan(29, 1'b1);
      #1 if (!failed && &expect_18 !== 1'b1) begin // traffic_modes.ladder:106
        failed = 1'b1;
        $display("# failed expectation 18 conducts %b ns_red=%b turn_red=%b ew_yellow=%b at %0s", expect_18, ns_red, turn_red, ew_yellow, "traffic_modes.ladder:106");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_19 !== 1'b1) begin // traffic_modes.ladder:108
        failed = 1'b1;
        $display("# failed expectation 19 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_19, ns_red, turn_red, ew_red, "traffic_modes.ladder:108");
      end
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "a day: six intervals, and a second of red between two greens");
    end else $display("ok 2 - %0s", "a day: six intervals, and a second of red between two greens");

    // rush hour: from north-south to east-west with one second of red
    failed = 1'b0;
    reset;
    rush_hour = 1'd1;
    scan(1, 1'b0);
    scan(10, 1'b1);
    repeat (2) begin
      #1 if (!failed && &expect_20 !== 1'b1) begin // traffic_modes.ladder:115
        failed = 1'b1;
        $display("# failed expectation 20 conducts %b ns_green=%b turn_red=%b ew_red=%b at %0s", expect_20, ns_green, turn_red, ew_red, "traffic_modes.ladder:115");
      end
      scan(120, 1'b1);
      #1 if (!failed && &expect_21 !== 1'b1) begin // traffic_modes.ladder:117
        failed = 1'b1;
        $display("# failed expectation 21 conducts %b ns_yellow=%b turn_red=%b ew_red=%b at %0s", expect_21, ns_yellow, turn_red, ew_red, "traffic_modes.ladder:117");
      end
      scan(30, 1'b1);
      #1 if (!failed && &expect_22 !== 1'b1) begin // traffic_modes.ladder:119
        failed = 1'b1;
        $display("# failed expectation 22 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_22, ns_red, turn_red, ew_red, "traffic_modes.ladder:119");
      end
      scan(9, 1'b1);
      #1 if (!failed && &expect_23 !== 1'b1) begin // traffic_modes.ladder:121
        failed = 1'b1;
        $display("# failed expectation 23 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_23, ns_red, turn_red, ew_red, "traffic_modes.ladder:121");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_24 !== 1'b1) begin // traffic_modes.ladder:123
        failed = 1'b1;
        $display("# failed expectation 24 conducts %b ns_red=%b turn_red=%b ew_green=%b at %0s", expect_24, ns_red, turn_red, ew_green, "traffic_modes.ladder:123");
      end
      scan(100, 1'b1);
      #1 if (!failed && &expect_25 !== 1'b1) begin // traffic_modes.ladder:125
        failed = 1'b1;
        $display("# failed expectation 25 conducts %b ns_red=%b turn_red=%b ew_yellow=%b at %0s", expect_25, ns_red, turn_red, ew_yellow, "traffic_modes.ladder:125");
      end
      scan(30, 1'b1);
      #1 if (!failed && &expect_26 !== 1'b1) begin // traffic_modes.ladder:127
        failed = 1'b1;
        $display("# failed expectation 26 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_26, ns_red, turn_red, ew_red, "traffic_modes.ladder:127");
      end
      scan(10, 1'b1);
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "rush hour: from north-south to east-west with one second of red");
    end else $display("ok 3 - %0s", "rush hour: from north-south to east-west with one second of red");

    // rush hour chosen while the lane turns: it still gets its yellow
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    scan(170, 1'b1);
    #1 if (!failed && &expect_27 !== 1'b1) begin // traffic_modes.ladder:134
      failed = 1'b1;
      $display("# failed expectation 27 conducts %b turn_green=%b at %0s", expect_27, turn_green, "traffic_modes.ladder:134");
    end
    rush_hour = 1'd1;
    scan(59, 1'b1);
    #1 if (!failed && &expect_28 !== 1'b1) begin // traffic_modes.ladder:137
      failed = 1'b1;
      $display("# failed expectation 28 conducts %b turn_green=%b at %0s", expect_28, turn_green, "traffic_modes.ladder:137");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_29 !== 1'b1) begin // traffic_modes.ladder:139
      failed = 1'b1;
      $display("# failed expectation 29 conducts %b turn_yellow=%b at %0s", expect_29, turn_yellow, "traffic_modes.ladder:139");
    end
    scan(29, 1'b1);
    #1 if (!failed && &expect_30 !== 1'b1) begin // traffic_modes.ladder:141
      failed = 1'b1;
      $display("# failed expectation 30 conducts %b turn_yellow=%b at %0s", expect_30, turn_yellow, "traffic_modes.ladder:141");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_31 !== 1'b1) begin // traffic_modes.ladder:143
      failed = 1'b1;
      $display("# failed expectation 31 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_31, ns_red, turn_red, ew_red, "traffic_modes.ladder:143");
    end
    scan(10, 1'b1);
    #1 if (!failed && &expect_32 !== 1'b1) begin // traffic_modes.ladder:145
      failed = 1'b1;
      $display("# failed expectation 32 conducts %b ew_green=%b at %0s", expect_32, ew_green, "traffic_modes.ladder:145");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "rush hour chosen while the lane turns: it still gets its yellow");
    end else $display("ok 4 - %0s", "rush hour chosen while the lane turns: it still gets its yellow");

    // late night begins when east-west is through
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    scan(10, 1'b1);
    late_night = 1'd1;
    scan(390, 1'b1);
    #1 if (!failed && &expect_33 !== 1'b1) begin // traffic_modes.ladder:152
      failed = 1'b1;
      $display("# failed expectation 33 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_33, ns_red, turn_red, ew_red, "traffic_modes.ladder:152");
    end
    scan(9, 1'b1);
    #1 if (!failed && &expect_34 !== 1'b1) begin // traffic_modes.ladder:154
      failed = 1'b1;
      $display("# failed expectation 34 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_34, ns_red, turn_red, ew_red, "traffic_modes.ladder:154");
    end
    scan(1, 1'b1);
    repeat (5) begin
      #1 if (!failed && &expect_35 !== 1'b1) begin // traffic_modes.ladder:157
        failed = 1'b1;
        $display("# failed expectation 35 conducts %b ns_yellow=%b turn_yellow=%b ew_red=%b ns_red=%b turn_red=%b ns_green=%b turn_green=%b ew_green=%b ew_yellow=%b at %0s", expect_35, ns_yellow, turn_yellow, ew_red, ns_red, turn_red, ns_green, turn_green, ew_green, ew_yellow, "traffic_modes.ladder:157");
      end
      scan(4, 1'b1);
      #1 if (!failed && &expect_36 !== 1'b1) begin // traffic_modes.ladder:160
        failed = 1'b1;
        $display("# failed expectation 36 conducts %b ns_yellow=%b turn_yellow=%b ew_red=%b at %0s", expect_36, ns_yellow, turn_yellow, ew_red, "traffic_modes.ladder:160");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_37 !== 1'b1) begin // traffic_modes.ladder:162
        failed = 1'b1;
        $display("# failed expectation 37 conducts %b ns_yellow=%b turn_yellow=%b ew_red=%b ns_red=%b turn_red=%b ns_green=%b turn_green=%b ew_green=%b ew_yellow=%b at %0s", expect_37, ns_yellow, turn_yellow, ew_red, ns_red, turn_red, ns_green, turn_green, ew_green, ew_yellow, "traffic_modes.ladder:162");
      end
      scan(4, 1'b1);
      #1 if (!failed && &expect_38 !== 1'b1) begin // traffic_modes.ladder:165
        failed = 1'b1;
        $display("# failed expectation 38 conducts %b ns_yellow=%b turn_yellow=%b ew_red=%b at %0s", expect_38, ns_yellow, turn_yellow, ew_red, "traffic_modes.ladder:165");
      end
      scan(1, 1'b1);
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "late night begins when east-west is through");
    end else $display("ok 5 - %0s", "late night begins when east-west is through");

    // morning: the blink ends, then all red, then north-south
    failed = 1'b0;
    reset;
    late_night = 1'd1;
    scan(1, 1'b0);
    scan(10, 1'b1);
    #1 if (!failed && &expect_39 !== 1'b1) begin // traffic_modes.ladder:172
      failed = 1'b1;
      $display("# failed expectation 39 conducts %b ns_yellow=%b at %0s", expect_39, ns_yellow, "traffic_modes.ladder:172");
    end
    scan(2, 1'b1);
    late_night = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_40 !== 1'b1) begin // traffic_modes.ladder:175
      failed = 1'b1;
      $display("# failed expectation 40 conducts %b ns_yellow=%b at %0s", expect_40, ns_yellow, "traffic_modes.ladder:175");
    end
    scan(3, 1'b1);
    #1 if (!failed && &expect_41 !== 1'b1) begin // traffic_modes.ladder:177
      failed = 1'b1;
      $display("# failed expectation 41 conducts %b ns_yellow=%b at %0s", expect_41, ns_yellow, "traffic_modes.ladder:177");
    end
    scan(5, 1'b1);
    #1 if (!failed && &expect_42 !== 1'b1) begin // traffic_modes.ladder:179
      failed = 1'b1;
      $display("# failed expectation 42 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_42, ns_red, turn_red, ew_red, "traffic_modes.ladder:179");
    end
    scan(9, 1'b1);
    #1 if (!failed && &expect_43 !== 1'b1) begin // traffic_modes.ladder:181
      failed = 1'b1;
      $display("# failed expectation 43 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_43, ns_red, turn_red, ew_red, "traffic_modes.ladder:181");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_44 !== 1'b1) begin // traffic_modes.ladder:183
      failed = 1'b1;
      $display("# failed expectation 44 conducts %b ns_green=%b turn_red=%b ew_red=%b at %0s", expect_44, ns_green, turn_red, ew_red, "traffic_modes.ladder:183");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "morning: the blink ends, then all red, then north-south");
    end else $display("ok 6 - %0s", "morning: the blink ends, then all red, then north-south");

    // selectors that are turned at every moment never set two lanes free
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (150) begin
      rush_hour = 1'd1;
      scan(5, 1'b1);
      #1 if (!failed && &expect_45 !== 1'b1) begin // traffic_modes.ladder:189
        failed = 1'b1;
        $display("# failed expectation 45 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_45, ns_red, turn_red, ew_red, "traffic_modes.ladder:189");
      end
      rush_hour = 1'd0;
      scan(2, 1'b1);
      #1 if (!failed && &expect_46 !== 1'b1) begin // traffic_modes.ladder:191
        failed = 1'b1;
        $display("# failed expectation 46 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_46, ns_red, turn_red, ew_red, "traffic_modes.ladder:191");
      end
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "selectors that are turned at every moment never set two lanes free");
    end else $display("ok 7 - %0s", "selectors that are turned at every moment never set two lanes free");

    // both selectors: the night has no lanes to leave out
    failed = 1'b0;
    reset;
    late_night = 1'd1;
    rush_hour = 1'd1;
    scan(1, 1'b0);
    scan(10, 1'b1);
    repeat (30) begin
      #1 if (!failed && &expect_47 !== 1'b1) begin // traffic_modes.ladder:198
        failed = 1'b1;
        $display("# failed expectation 47 conducts %b ns_yellow=%b turn_yellow=%b ew_red=%b at %0s", expect_47, ns_yellow, turn_yellow, ew_red, "traffic_modes.ladder:198");
      end
      scan(3, 1'b1);
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 8 - %0s", "both selectors: the night has no lanes to leave out");
    end else $display("ok 8 - %0s", "both selectors: the night has no lanes to leave out");

    if (failures != 0) $display("# %0d of 8 tests failed", failures);
    $finish;
  end
endmodule
