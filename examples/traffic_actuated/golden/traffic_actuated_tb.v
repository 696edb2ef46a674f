// Made by hotrail 0.1.0 from traffic_actuated.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module traffic_actuated_expect (
  input  wire clk,
  input  wire rst,
  input  wire ns_red,
  input  wire turn_red,
  input  wire ew_red,
  input  wire walk,
  input  wire ns_green,
  input  wire ns_yellow,
  input  wire ew_green,
  input  wire ew_yellow,
  input  wire turn_green,
  input  wire turn_yellow,
  input  wire walk_soon,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_0_2,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_1_2,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_2_2,
  output wire expect_2_3,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_3_2,
  output wire expect_4_0,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_5_2,
  output wire expect_6_0,
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
  output wire expect_11_0,
  output wire expect_11_1,
  output wire expect_11_2,
  output wire expect_12_0,
  output wire expect_13_0,
  output wire expect_13_1,
  output wire expect_13_2,
  output wire expect_14_0,
  output wire expect_15_0,
  output wire expect_16_0,
  output wire expect_17_0,
  output wire expect_17_1,
  output wire expect_17_2,
  output wire expect_18_0,
  output wire expect_19_0,
  output wire expect_20_0,
  output wire expect_20_1,
  output wire expect_21_0,
  output wire expect_22_0,
  output wire expect_23_0,
  output wire expect_23_1,
  output wire expect_23_2,
  output wire expect_24_0,
  output wire expect_25_0,
  output wire expect_26_0,
  output wire expect_27_0,
  output wire expect_28_0,
  output wire expect_29_0,
  output wire expect_30_0,
  output wire expect_31_0,
  output wire expect_32_0,
  output wire expect_33_0,
  output wire expect_34_0,
  output wire expect_34_1,
  output wire expect_34_2,
  output wire expect_35_0,
  output wire expect_36_0,
  output wire expect_37_0,
  output wire expect_38_0,
  output wire expect_39_0,
  output wire expect_40_0,
  output wire expect_40_1,
  output wire expect_41_0,
  output wire expect_42_0,
  output wire expect_42_1,
  output wire expect_42_2,
  output wire expect_42_3,
  output wire expect_42_4,
  output wire expect_43_0,
  output wire expect_44_0,
  output wire expect_44_1,
  output wire expect_44_2,
  output wire expect_44_3,
  output wire expect_45_0,
  output wire expect_45_1,
  output wire expect_45_2,
  output wire expect_46_0,
  output wire expect_47_0,
  output wire expect_47_1,
  output wire expect_48_0,
  output wire expect_48_1,
  output wire expect_49_0,
  output wire expect_49_1,
  output wire expect_50_0,
  output wire expect_51_0,
  output wire expect_52_0,
  output wire expect_53_0,
  output wire expect_54_0,
  output wire expect_55_0
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
  assign expect_2_3 = ~walk;
  assign expect_3_0 = ns_green;
  assign expect_3_1 = turn_red;
  assign expect_3_2 = ew_red;
  assign expect_4_0 = ns_green;
  assign expect_5_0 = ns_yellow;
  assign expect_5_1 = turn_red;
  assign expect_5_2 = ew_red;
  assign expect_6_0 = ns_yellow;
  assign expect_7_0 = ns_red;
  assign expect_7_1 = turn_red;
  assign expect_7_2 = ew_red;
  assign expect_8_0 = ns_red;
  assign expect_8_1 = turn_red;
  assign expect_8_2 = ew_red;
  assign expect_9_0 = ns_red;
  assign expect_9_1 = turn_red;
  assign expect_9_2 = ew_green;
  assign expect_10_0 = ew_green;
  assign expect_11_0 = ns_red;
  assign expect_11_1 = turn_red;
  assign expect_11_2 = ew_yellow;
  assign expect_12_0 = ew_yellow;
  assign expect_13_0 = turn_green;
  assign expect_13_1 = ns_red;
  assign expect_13_2 = ew_red;
  assign expect_14_0 = turn_green;
  assign expect_15_0 = turn_yellow;
  assign expect_16_0 = turn_yellow;
  assign expect_17_0 = ns_red;
  assign expect_17_1 = turn_red;
  assign expect_17_2 = ew_red;
  assign expect_18_0 = ew_green;
  assign expect_19_0 = ns_green;
  assign expect_20_0 = ew_green;
  assign expect_20_1 = turn_red;
  assign expect_21_0 = turn_green;
  assign expect_22_0 = ew_green;
  assign expect_23_0 = ns_red;
  assign expect_23_1 = turn_red;
  assign expect_23_2 = ew_red;
  assign expect_24_0 = turn_green;
  assign expect_25_0 = turn_green;
  assign expect_26_0 = turn_yellow;
  assign expect_27_0 = turn_green;
  assign expect_28_0 = turn_green;
  assign expect_29_0 = turn_green;
  assign expect_30_0 = turn_yellow;
  assign expect_31_0 = turn_green;
  assign expect_32_0 = turn_green;
  assign expect_33_0 = turn_yellow;
  assign expect_34_0 = ns_red;
  assign expect_34_1 = turn_red;
  assign expect_34_2 = ew_red;
  assign expect_35_0 = turn_green;
  assign expect_36_0 = turn_yellow;
  assign expect_37_0 = turn_green;
  assign expect_38_0 = turn_green;
  assign expect_39_0 = turn_yellow;
  assign expect_40_0 = walk_soon;
  assign expect_40_1 = ~walk;
  assign expect_41_0 = ~walk;
  assign expect_42_0 = walk;
  assign expect_42_1 = ~walk_soon;
  assign expect_42_2 = ns_red;
  assign expect_42_3 = turn_red;
  assign expect_42_4 = ew_red;
  assign expect_43_0 = walk;
  assign expect_44_0 = ~walk;
  assign expect_44_1 = ns_red;
  assign expect_44_2 = turn_red;
  assign expect_44_3 = ew_red;
  assign expect_45_0 = ns_red;
  assign expect_45_1 = turn_red;
  assign expect_45_2 = ew_red;
  assign expect_46_0 = ns_green;
  assign expect_47_0 = ns_green;
  assign expect_47_1 = ~walk;
  assign expect_48_0 = walk;
  assign expect_48_1 = ~walk_soon;
  assign expect_49_0 = walk;
  assign expect_49_1 = ~walk_soon;
  assign expect_50_0 = ~walk;
  assign expect_51_0 = walk_soon;
  assign expect_52_0 = ~walk;
  assign expect_53_0 = walk;
  assign expect_54_0 = ns_red & turn_red | ns_red & ew_red | turn_red & ew_red;
  assign expect_55_0 = ~walk | ns_red & turn_red & ew_red;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module traffic_actuated_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg walk_button = 1'd0;
  reg far_loop = 1'd0;
  reg near_loop = 1'd0;
  wire ns_green;
  wire ns_yellow;
  wire ns_red;
  wire turn_green;
  wire turn_yellow;
  wire turn_red;
  wire ew_green;
  wire ew_yellow;
  wire ew_red;
  wire walk;
  wire walk_soon;
  reg failed;
  integer failures;

  traffic_actuated core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .walk_button(walk_button),
    .far_loop(far_loop),
    .near_loop(near_loop),
    .ns_green(ns_green),
    .ns_yellow(ns_yellow),
    .ns_red(ns_red),
    .turn_green(turn_green),
    .turn_yellow(turn_yellow),
    .turn_red(turn_red),
    .ew_green(ew_green),
    .ew_yellow(ew_yellow),
    .ew_red(ew_red),
    .walk(walk),
    .walk_soon(walk_soon)
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
  wire expect_2_3;
  wire [0:3] expect_2 = {expect_2_0, expect_2_1, expect_2_2, expect_2_3};
  wire expect_3_0;
  wire expect_3_1;
  wire expect_3_2;
  wire [0:2] expect_3 = {expect_3_0, expect_3_1, expect_3_2};
  wire expect_4_0;
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire expect_5_1;
  wire expect_5_2;
  wire [0:2] expect_5 = {expect_5_0, expect_5_1, expect_5_2};
  wire expect_6_0;
  wire [0:0] expect_6 = {expect_6_0};
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
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire expect_11_1;
  wire expect_11_2;
  wire [0:2] expect_11 = {expect_11_0, expect_11_1, expect_11_2};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire expect_13_1;
  wire expect_13_2;
  wire [0:2] expect_13 = {expect_13_0, expect_13_1, expect_13_2};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  wire expect_16_0;
  wire [0:0] expect_16 = {expect_16_0};
  wire expect_17_0;
  wire expect_17_1;
  wire expect_17_2;
  wire [0:2] expect_17 = {expect_17_0, expect_17_1, expect_17_2};
  wire expect_18_0;
  wire [0:0] expect_18 = {expect_18_0};
  wire expect_19_0;
  wire [0:0] expect_19 = {expect_19_0};
  wire expect_20_0;
  wire expect_20_1;
  wire [0:1] expect_20 = {expect_20_0, expect_20_1};
  wire expect_21_0;
  wire [0:0] expect_21 = {expect_21_0};
  wire expect_22_0;
  wire [0:0] expect_22 = {expect_22_0};
  wire expect_23_0;
  wire expect_23_1;
  wire expect_23_2;
  wire [0:2] expect_23 = {expect_23_0, expect_23_1, expect_23_2};
  wire expect_24_0;
  wire [0:0] expect_24 = {expect_24_0};
  wire expect_25_0;
  wire [0:0] expect_25 = {expect_25_0};
  wire expect_26_0;
  wire [0:0] expect_26 = {expect_26_0};
  wire expect_27_0;
  wire [0:0] expect_27 = {expect_27_0};
  wire expect_28_0;
  wire [0:0] expect_28 = {expect_28_0};
  wire expect_29_0;
  wire [0:0] expect_29 = {expect_29_0};
  wire expect_30_0;
  wire [0:0] expect_30 = {expect_30_0};
  wire expect_31_0;
  wire [0:0] expect_31 = {expect_31_0};
  wire expect_32_0;
  wire [0:0] expect_32 = {expect_32_0};
  wire expect_33_0;
  wire [0:0] expect_33 = {expect_33_0};
  wire expect_34_0;
  wire expect_34_1;
  wire expect_34_2;
  wire [0:2] expect_34 = {expect_34_0, expect_34_1, expect_34_2};
  wire expect_35_0;
  wire [0:0] expect_35 = {expect_35_0};
  wire expect_36_0;
  wire [0:0] expect_36 = {expect_36_0};
  wire expect_37_0;
  wire [0:0] expect_37 = {expect_37_0};
  wire expect_38_0;
  wire [0:0] expect_38 = {expect_38_0};
  wire expect_39_0;
  wire [0:0] expect_39 = {expect_39_0};
  wire expect_40_0;
  wire expect_40_1;
  wire [0:1] expect_40 = {expect_40_0, expect_40_1};
  wire expect_41_0;
  wire [0:0] expect_41 = {expect_41_0};
  wire expect_42_0;
  wire expect_42_1;
  wire expect_42_2;
  wire expect_42_3;
  wire expect_42_4;
  wire [0:4] expect_42 = {expect_42_0, expect_42_1, expect_42_2, expect_42_3, expect_42_4};
  wire expect_43_0;
  wire [0:0] expect_43 = {expect_43_0};
  wire expect_44_0;
  wire expect_44_1;
  wire expect_44_2;
  wire expect_44_3;
  wire [0:3] expect_44 = {expect_44_0, expect_44_1, expect_44_2, expect_44_3};
  wire expect_45_0;
  wire expect_45_1;
  wire expect_45_2;
  wire [0:2] expect_45 = {expect_45_0, expect_45_1, expect_45_2};
  wire expect_46_0;
  wire [0:0] expect_46 = {expect_46_0};
  wire expect_47_0;
  wire expect_47_1;
  wire [0:1] expect_47 = {expect_47_0, expect_47_1};
  wire expect_48_0;
  wire expect_48_1;
  wire [0:1] expect_48 = {expect_48_0, expect_48_1};
  wire expect_49_0;
  wire expect_49_1;
  wire [0:1] expect_49 = {expect_49_0, expect_49_1};
  wire expect_50_0;
  wire [0:0] expect_50 = {expect_50_0};
  wire expect_51_0;
  wire [0:0] expect_51 = {expect_51_0};
  wire expect_52_0;
  wire [0:0] expect_52 = {expect_52_0};
  wire expect_53_0;
  wire [0:0] expect_53 = {expect_53_0};
  wire expect_54_0;
  wire [0:0] expect_54 = {expect_54_0};
  wire expect_55_0;
  wire [0:0] expect_55 = {expect_55_0};
  traffic_actuated_expect expectations (
    .clk(clk),
    .rst(rst),
    .ns_red(ns_red),
    .turn_red(turn_red),
    .ew_red(ew_red),
    .walk(walk),
    .ns_green(ns_green),
    .ns_yellow(ns_yellow),
    .ew_green(ew_green),
    .ew_yellow(ew_yellow),
    .turn_green(turn_green),
    .turn_yellow(turn_yellow),
    .walk_soon(walk_soon),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_2_2(expect_2_2),
    .expect_2_3(expect_2_3),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_6_0(expect_6_0),
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
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_11_2(expect_11_2),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_13_1(expect_13_1),
    .expect_13_2(expect_13_2),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_16_0(expect_16_0),
    .expect_17_0(expect_17_0),
    .expect_17_1(expect_17_1),
    .expect_17_2(expect_17_2),
    .expect_18_0(expect_18_0),
    .expect_19_0(expect_19_0),
    .expect_20_0(expect_20_0),
    .expect_20_1(expect_20_1),
    .expect_21_0(expect_21_0),
    .expect_22_0(expect_22_0),
    .expect_23_0(expect_23_0),
    .expect_23_1(expect_23_1),
    .expect_23_2(expect_23_2),
    .expect_24_0(expect_24_0),
    .expect_25_0(expect_25_0),
    .expect_26_0(expect_26_0),
    .expect_27_0(expect_27_0),
    .expect_28_0(expect_28_0),
    .expect_29_0(expect_29_0),
    .expect_30_0(expect_30_0),
    .expect_31_0(expect_31_0),
    .expect_32_0(expect_32_0),
    .expect_33_0(expect_33_0),
    .expect_34_0(expect_34_0),
    .expect_34_1(expect_34_1),
    .expect_34_2(expect_34_2),
    .expect_35_0(expect_35_0),
    .expect_36_0(expect_36_0),
    .expect_37_0(expect_37_0),
    .expect_38_0(expect_38_0),
    .expect_39_0(expect_39_0),
    .expect_40_0(expect_40_0),
    .expect_40_1(expect_40_1),
    .expect_41_0(expect_41_0),
    .expect_42_0(expect_42_0),
    .expect_42_1(expect_42_1),
    .expect_42_2(expect_42_2),
    .expect_42_3(expect_42_3),
    .expect_42_4(expect_42_4),
    .expect_43_0(expect_43_0),
    .expect_44_0(expect_44_0),
    .expect_44_1(expect_44_1),
    .expect_44_2(expect_44_2),
    .expect_44_3(expect_44_3),
    .expect_45_0(expect_45_0),
    .expect_45_1(expect_45_1),
    .expect_45_2(expect_45_2),
    .expect_46_0(expect_46_0),
    .expect_47_0(expect_47_0),
    .expect_47_1(expect_47_1),
    .expect_48_0(expect_48_0),
    .expect_48_1(expect_48_1),
    .expect_49_0(expect_49_0),
    .expect_49_1(expect_49_1),
    .expect_50_0(expect_50_0),
    .expect_51_0(expect_51_0),
    .expect_52_0(expect_52_0),
    .expect_53_0(expect_53_0),
    .expect_54_0(expect_54_0),
    .expect_55_0(expect_55_0)
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
      walk_button = 1'd0;
      far_loop = 1'd0;
      near_loop = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..11");

    // all lanes are red before the first scan
    failed = 1'b0;
    reset;
    #1 if (!failed && &expect_0 !== 1'b1) begin // traffic_actuated.ladder:92
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_0, ns_red, turn_red, ew_red, "traffic_actuated.ladder:92");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "all lanes are red before the first scan");
    end else $display("ok 1 - %0s", "all lanes are red before the first scan");

    // nobody in the turn lane, nobody on foot: two greens in turn
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (3) begin
      #1 if (!failed && &expect_1 !== 1'b1) begin // traffic_actuated.ladder:97
        failed = 1'b1;
        $display("# failed expectation 1 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_1, ns_red, turn_red, ew_red, "traffic_actuated.ladder:97");
      end
      scan(9, 1'b1);
      #1 if (!failed && &expect_2 !== 1'b1) begin // traffic_actuated.ladder:99
        failed = 1'b1;
        $display("# failed expectation 2 conducts %b ns_red=%b turn_red=%b ew_red=%b walk=%b at %0s", expect_2, ns_red, turn_red, ew_red, walk, "traffic_actuated.ladder:99");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_3 !== 1'b1) begin // traffic_actuated.ladder:101
        failed = 1'b1;
        $display("# failed expectation 3 conducts %b ns_green=%b turn_red=%b ew_red=%b at %0s", expect_3, ns_green, turn_red, ew_red, "traffic_actuated.ladder:101");
      end
      scan(119, 1'b1);
      #1 if (!failed && &expect_4 !== 1'b1) begin // traffic_actuated.ladder:103
        failed = 1'b1;
        $display("# failed expectation 4 conducts %b ns_green=%b at %0s", expect_4, ns_green, "traffic_actuated.ladder:103");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_5 !== 1'b1) begin // traffic_actuated.ladder:105
        failed = 1'b1;
        $display("# failed expectation 5 conducts %b ns_yellow=%b turn_red=%b ew_red=%b at %0s", expect_5, ns_yellow, turn_red, ew_red, "traffic_actuated.ladder:105");
      end
      scan(29, 1'b1);
      #1 if (!failed && &expect_6 !== 1'b1) begin // traffic_actuated.ladder:107
        failed = 1'b1;
        $display("# failed expectation 6 conducts %b ns_yellow=%b at %0s", expect_6, ns_yellow, "traffic_actuated.ladder:107");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_7 !== 1'b1) begin // traffic_actuated.ladder:109
        failed = 1'b1;
        $display("# failed expectation 7 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_7, ns_red, turn_red, ew_red, "traffic_actuated.ladder:109");
      end
      scan(9, 1'b1);
      #1 if (!failed && &expect_8 !== 1'b1) begin // traffic_actuated.ladder:111
        failed = 1'b1;
        $display("# failed expectation 8 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_8, ns_red, turn_red, ew_red, "traffic_actuated.ladder:111");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_9 !== 1'b1) begin // traffic_actuated.ladder:113
        failed = 1'b1;
        $display("# failed expectation 9 conducts %b ns_red=%b turn_red=%b ew_green=%b at %0s", expect_9, ns_red, turn_red, ew_green, "traffic_actuated.ladder:113");
      end
      scan(99, 1'b1);
      #1 if (!failed && &expect_10 !== 1'b1) begin // traffic_actuated.ladder:115
        failed = 1'b1;
        $display("# failed expectation 10 conducts %b ew_green=%b at %0s", expect_10, ew_green, "traffic_actuated.ladder:115");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_11 !== 1'b1) begin // traffic_actuated.ladder:117
        failed = 1'b1;
        $display("# failed expectation 11 conducts %b ns_red=%b turn_red=%b ew_yellow=%b at %0s", expect_11, ns_red, turn_red, ew_yellow, "traffic_actuated.ladder:117");
      end
      scan(29, 1'b1);
      #1 if (!failed && &expect_12 !== 1'b1) begin // traffic_actuated.ladder:119
        failed = 1'b1;
        $display("# failed expectation 12 conducts %b ew_yellow=%b at %0s", expect_12, ew_yellow, "traffic_actuated.ladder:119");
      end
      scan(1, 1'b1);
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "nobody in the turn lane, nobody on foot: two greens in turn");
    end else $display("ok 2 - %0s", "nobody in the turn lane, nobody on foot: two greens in turn");

    // one car in the turn lane is let go, once
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    scan(10, 1'b1);
    near_loop = 1'd1;
    scan(1, 1'b0);
    near_loop = 1'd0;
    scan(1, 1'b0);
    scan(160, 1'b1);
    #1 if (!failed && &expect_13 !== 1'b1) begin // traffic_actuated.ladder:128
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b turn_green=%b ns_red=%b ew_red=%b at %0s", expect_13, turn_green, ns_red, ew_red, "traffic_actuated.ladder:128");
    end
    scan(59, 1'b1);
    #1 if (!failed && &expect_14 !== 1'b1) begin // traffic_actuated.ladder:130
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b turn_green=%b at %0s", expect_14, turn_green, "traffic_actuated.ladder:130");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_15 !== 1'b1) begin // traffic_actuated.ladder:132
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b turn_yellow=%b at %0s", expect_15, turn_yellow, "traffic_actuated.ladder:132");
    end
    scan(29, 1'b1);
    #1 if (!failed && &expect_16 !== 1'b1) begin // traffic_actuated.ladder:134
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b turn_yellow=%b at %0s", expect_16, turn_yellow, "traffic_actuated.ladder:134");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_17 !== 1'b1) begin // traffic_actuated.ladder:136
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_17, ns_red, turn_red, ew_red, "traffic_actuated.ladder:136");
    end
    scan(10, 1'b1);
    #1 if (!failed && &expect_18 !== 1'b1) begin // traffic_actuated.ladder:138
      failed = 1'b1;
      $display("# failed expectation 18 conducts %b ew_green=%b at %0s", expect_18, ew_green, "traffic_actuated.ladder:138");
    end
    scan(140, 1'b1);
    #1 if (!failed && &expect_19 !== 1'b1) begin // traffic_actuated.ladder:140
      failed = 1'b1;
      $display("# failed expectation 19 conducts %b ns_green=%b at %0s", expect_19, ns_green, "traffic_actuated.ladder:140");
    end
    scan(160, 1'b1);
    #1 if (!failed && &expect_20 !== 1'b1) begin // traffic_actuated.ladder:142
      failed = 1'b1;
      $display("# failed expectation 20 conducts %b ew_green=%b turn_red=%b at %0s", expect_20, ew_green, turn_red, "traffic_actuated.ladder:142");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "one car in the turn lane is let go, once");
    end else $display("ok 3 - %0s", "one car in the turn lane is let go, once");

    // the last moment to ask for the turn lane
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    scan(169, 1'b1);
    far_loop = 1'd1;
    scan(1, 1'b1);
    #1 if (!failed && &expect_21 !== 1'b1) begin // traffic_actuated.ladder:148
      failed = 1'b1;
      $display("# failed expectation 21 conducts %b turn_green=%b at %0s", expect_21, turn_green, "traffic_actuated.ladder:148");
    end
    reset;
    scan(1, 1'b0);
    scan(170, 1'b1);
    #1 if (!failed && &expect_22 !== 1'b1) begin // traffic_actuated.ladder:152
      failed = 1'b1;
      $display("# failed expectation 22 conducts %b ew_green=%b at %0s", expect_22, ew_green, "traffic_actuated.ladder:152");
    end
    far_loop = 1'd1;
    scan(1, 1'b0);
    far_loop = 1'd0;
    scan(1, 1'b0);
    scan(290, 1'b1);
    #1 if (!failed && &expect_23 !== 1'b1) begin // traffic_actuated.ladder:155
      failed = 1'b1;
      $display("# failed expectation 23 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_23, ns_red, turn_red, ew_red, "traffic_actuated.ladder:155");
    end
    scan(10, 1'b1);
    #1 if (!failed && &expect_24 !== 1'b1) begin // traffic_actuated.ladder:157
      failed = 1'b1;
      $display("# failed expectation 24 conducts %b turn_green=%b at %0s", expect_24, turn_green, "traffic_actuated.ladder:157");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "the last moment to ask for the turn lane");
    end else $display("ok 4 - %0s", "the last moment to ask for the turn lane");

    // a car that misses its green asks again
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    near_loop = 1'd1;
    scan(1, 1'b0);
    near_loop = 1'd0;
    scan(1, 1'b0);
    scan(170, 1'b1);
    #1 if (!failed && &expect_25 !== 1'b1) begin // traffic_actuated.ladder:163
      failed = 1'b1;
      $display("# failed expectation 25 conducts %b turn_green=%b at %0s", expect_25, turn_green, "traffic_actuated.ladder:163");
    end
    far_loop = 1'd1;
    scan(60, 1'b1);
    #1 if (!failed && &expect_26 !== 1'b1) begin // traffic_actuated.ladder:165
      failed = 1'b1;
      $display("# failed expectation 26 conducts %b turn_yellow=%b at %0s", expect_26, turn_yellow, "traffic_actuated.ladder:165");
    end
    scan(370, 1'b1);
    #1 if (!failed && &expect_27 !== 1'b1) begin // traffic_actuated.ladder:167
      failed = 1'b1;
      $display("# failed expectation 27 conducts %b turn_green=%b at %0s", expect_27, turn_green, "traffic_actuated.ladder:167");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a car that misses its green asks again");
    end else $display("ok 5 - %0s", "a car that misses its green asks again");

    // cars that roll from loop to loop are no queue
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    scan(10, 1'b1);
    repeat (3) begin
      far_loop = 1'd1;
      scan(1, 1'b0);
      far_loop = 1'd0;
      scan(1, 1'b0);
      scan(19, 1'b1);
      near_loop = 1'd1;
      scan(1, 1'b0);
      near_loop = 1'd0;
      scan(1, 1'b0);
    end
    scan(103, 1'b1);
    #1 if (!failed && &expect_28 !== 1'b1) begin // traffic_actuated.ladder:178
      failed = 1'b1;
      $display("# failed expectation 28 conducts %b turn_green=%b at %0s", expect_28, turn_green, "traffic_actuated.ladder:178");
    end
    scan(59, 1'b1);
    #1 if (!failed && &expect_29 !== 1'b1) begin // traffic_actuated.ladder:180
      failed = 1'b1;
      $display("# failed expectation 29 conducts %b turn_green=%b at %0s", expect_29, turn_green, "traffic_actuated.ladder:180");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_30 !== 1'b1) begin // traffic_actuated.ladder:182
      failed = 1'b1;
      $display("# failed expectation 30 conducts %b turn_yellow=%b at %0s", expect_30, turn_yellow, "traffic_actuated.ladder:182");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "cars that roll from loop to loop are no queue");
    end else $display("ok 6 - %0s", "cars that roll from loop to loop are no queue");

    // two seconds from loop to loop are a queue: twice the time, in this round only
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    scan(10, 1'b1);
    far_loop = 1'd1;
    scan(1, 1'b0);
    far_loop = 1'd0;
    scan(1, 1'b0);
    scan(20, 1'b1);
    near_loop = 1'd1;
    scan(1, 1'b0);
    near_loop = 1'd0;
    scan(1, 1'b0);
    scan(140, 1'b1);
    #1 if (!failed && &expect_31 !== 1'b1) begin // traffic_actuated.ladder:191
      failed = 1'b1;
      $display("# failed expectation 31 conducts %b turn_green=%b at %0s", expect_31, turn_green, "traffic_actuated.ladder:191");
    end
    scan(119, 1'b1);
    #1 if (!failed && &expect_32 !== 1'b1) begin // traffic_actuated.ladder:193
      failed = 1'b1;
      $display("# failed expectation 32 conducts %b turn_green=%b at %0s", expect_32, turn_green, "traffic_actuated.ladder:193");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_33 !== 1'b1) begin // traffic_actuated.ladder:195
      failed = 1'b1;
      $display("# failed expectation 33 conducts %b turn_yellow=%b at %0s", expect_33, turn_yellow, "traffic_actuated.ladder:195");
    end
    scan(170, 1'b1);
    #1 if (!failed && &expect_34 !== 1'b1) begin // traffic_actuated.ladder:197
      failed = 1'b1;
      $display("# failed expectation 34 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_34, ns_red, turn_red, ew_red, "traffic_actuated.ladder:197");
    end
    near_loop = 1'd1;
    scan(1, 1'b0);
    near_loop = 1'd0;
    scan(1, 1'b0);
    scan(170, 1'b1);
    #1 if (!failed && &expect_35 !== 1'b1) begin // traffic_actuated.ladder:200
      failed = 1'b1;
      $display("# failed expectation 35 conducts %b turn_green=%b at %0s", expect_35, turn_green, "traffic_actuated.ladder:200");
    end
    scan(60, 1'b1);
    #1 if (!failed && &expect_36 !== 1'b1) begin // traffic_actuated.ladder:202
      failed = 1'b1;
      $display("# failed expectation 36 conducts %b turn_yellow=%b at %0s", expect_36, turn_yellow, "traffic_actuated.ladder:202");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "two seconds from loop to loop are a queue: twice the time, in this round only");
    end else $display("ok 7 - %0s", "two seconds from loop to loop are a queue: twice the time, in this round only");

    // the second car, which reaches the stop line in its green only, shows the queue
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    scan(10, 1'b1);
    far_loop = 1'd1;
    scan(1, 1'b0);
    far_loop = 1'd0;
    scan(1, 1'b0);
    near_loop = 1'd1;
    scan(50, 1'b1);
    far_loop = 1'd1;
    scan(110, 1'b1);
    #1 if (!failed && &expect_37 !== 1'b1) begin // traffic_actuated.ladder:210
      failed = 1'b1;
      $display("# failed expectation 37 conducts %b turn_green=%b at %0s", expect_37, turn_green, "traffic_actuated.ladder:210");
    end
    near_loop = 1'd0;
    scan(10, 1'b1);
    near_loop = 1'd1;
    far_loop = 1'd0;
    scan(10, 1'b1);
    near_loop = 1'd0;
    scan(99, 1'b1);
    #1 if (!failed && &expect_38 !== 1'b1) begin // traffic_actuated.ladder:215
      failed = 1'b1;
      $display("# failed expectation 38 conducts %b turn_green=%b at %0s", expect_38, turn_green, "traffic_actuated.ladder:215");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_39 !== 1'b1) begin // traffic_actuated.ladder:217
      failed = 1'b1;
      $display("# failed expectation 39 conducts %b turn_yellow=%b at %0s", expect_39, turn_yellow, "traffic_actuated.ladder:217");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 8 - %0s", "the second car, which reaches the stop line in its green only, shows the queue");
    end else $display("ok 8 - %0s", "the second car, which reaches the stop line in its green only, shows the queue");

    // pedestrians walk in all directions when all lanes are red
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    scan(50, 1'b1);
    walk_button = 1'd1;
    scan(1, 1'b0);
    walk_button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_40 !== 1'b1) begin // traffic_actuated.ladder:223
      failed = 1'b1;
      $display("# failed expectation 40 conducts %b walk_soon=%b walk=%b at %0s", expect_40, walk_soon, walk, "traffic_actuated.ladder:223");
    end
    scan(259, 1'b1);
    #1 if (!failed && &expect_41 !== 1'b1) begin // traffic_actuated.ladder:225
      failed = 1'b1;
      $display("# failed expectation 41 conducts %b walk=%b at %0s", expect_41, walk, "traffic_actuated.ladder:225");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_42 !== 1'b1) begin // traffic_actuated.ladder:227
      failed = 1'b1;
      $display("# failed expectation 42 conducts %b walk=%b walk_soon=%b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_42, walk, walk_soon, ns_red, turn_red, ew_red, "traffic_actuated.ladder:227");
    end
    scan(79, 1'b1);
    #1 if (!failed && &expect_43 !== 1'b1) begin // traffic_actuated.ladder:229
      failed = 1'b1;
      $display("# failed expectation 43 conducts %b walk=%b at %0s", expect_43, walk, "traffic_actuated.ladder:229");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_44 !== 1'b1) begin // traffic_actuated.ladder:231
      failed = 1'b1;
      $display("# failed expectation 44 conducts %b walk=%b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_44, walk, ns_red, turn_red, ew_red, "traffic_actuated.ladder:231");
    end
    scan(29, 1'b1);
    #1 if (!failed && &expect_45 !== 1'b1) begin // traffic_actuated.ladder:233
      failed = 1'b1;
      $display("# failed expectation 45 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_45, ns_red, turn_red, ew_red, "traffic_actuated.ladder:233");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_46 !== 1'b1) begin // traffic_actuated.ladder:235
      failed = 1'b1;
      $display("# failed expectation 46 conducts %b ns_green=%b at %0s", expect_46, ns_green, "traffic_actuated.ladder:235");
    end
    scan(300, 1'b1);
    #1 if (!failed && &expect_47 !== 1'b1) begin // traffic_actuated.ladder:237
      failed = 1'b1;
      $display("# failed expectation 47 conducts %b ns_green=%b walk=%b at %0s", expect_47, ns_green, walk, "traffic_actuated.ladder:237");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 9 - %0s", "pedestrians walk in all directions when all lanes are red");
    end else $display("ok 9 - %0s", "pedestrians walk in all directions when all lanes are red");

    // a push while others walk changes nothing, one while they leave the road waits for the next round
    failed = 1'b0;
    reset;
    walk_button = 1'd1;
    scan(1, 1'b0);
    scan(10, 1'b1);
    #1 if (!failed && &expect_48 !== 1'b1) begin // traffic_actuated.ladder:242
      failed = 1'b1;
      $display("# failed expectation 48 conducts %b walk=%b walk_soon=%b at %0s", expect_48, walk, walk_soon, "traffic_actuated.ladder:242");
    end
    scan(10, 1'b1);
    #1 if (!failed && &expect_49 !== 1'b1) begin // traffic_actuated.ladder:244
      failed = 1'b1;
      $display("# failed expectation 49 conducts %b walk=%b walk_soon=%b at %0s", expect_49, walk, walk_soon, "traffic_actuated.ladder:244");
    end
    walk_button = 1'd0;
    scan(70, 1'b1);
    #1 if (!failed && &expect_50 !== 1'b1) begin // traffic_actuated.ladder:247
      failed = 1'b1;
      $display("# failed expectation 50 conducts %b walk=%b at %0s", expect_50, walk, "traffic_actuated.ladder:247");
    end
    walk_button = 1'd1;
    scan(1, 1'b0);
    walk_button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_51 !== 1'b1) begin // traffic_actuated.ladder:249
      failed = 1'b1;
      $display("# failed expectation 51 conducts %b walk_soon=%b at %0s", expect_51, walk_soon, "traffic_actuated.ladder:249");
    end
    scan(329, 1'b1);
    #1 if (!failed && &expect_52 !== 1'b1) begin // traffic_actuated.ladder:251
      failed = 1'b1;
      $display("# failed expectation 52 conducts %b walk=%b at %0s", expect_52, walk, "traffic_actuated.ladder:251");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_53 !== 1'b1) begin // traffic_actuated.ladder:253
      failed = 1'b1;
      $display("# failed expectation 53 conducts %b walk=%b at %0s", expect_53, walk, "traffic_actuated.ladder:253");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 10 - %0s", "a push while others walk changes nothing, one while they leave the road waits for the next round");
    end else $display("ok 10 - %0s", "a push while others walk changes nothing, one while they leave the road waits for the next round");

    // all at once: one after the other is served, and never two
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    walk_button = 1'd1;
    repeat (300) begin
      far_loop = 1'd1;
      scan(2, 1'b1);
      #1 if (!failed && &expect_54 !== 1'b1) begin // traffic_actuated.ladder:260
        failed = 1'b1;
        $display("# failed expectation 54 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_54, ns_red, turn_red, ew_red, "traffic_actuated.ladder:260");
      end
      #1 if (!failed && &expect_55 !== 1'b1) begin // traffic_actuated.ladder:261
        failed = 1'b1;
        $display("# failed expectation 55 conducts %b walk=%b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_55, walk, ns_red, turn_red, ew_red, "traffic_actuated.ladder:261");
      end
      far_loop = 1'd0;
      near_loop = 1'd1;
      scan(1, 1'b1);
      near_loop = 1'd0;
      scan(1, 1'b0);
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 11 - %0s", "all at once: one after the other is served, and never two");
    end else $display("ok 11 - %0s", "all at once: one after the other is served, and never two");

    if (failures != 0) $display("# %0d of 11 tests failed", failures);
    $finish;
  end
endmodule
