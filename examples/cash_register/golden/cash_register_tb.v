// Made by hotrail 0.1.0 from cash_register.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module cash_register_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        lamp_combo,
  input  wire        lamp_fries,
  input  wire [31:0] subtotal,
  input  wire [31:0] tax,
  input  wire [31:0] total,
  input  wire        lamp_double,
  input  wire        lamp_junior,
  input  wire        lamp_burger,
  input  wire        lamp_drink,
  input  wire [31:0] profit,
  input  wire [31:0] sold_0,
  input  wire        paid,
  input  wire [31:0] sold_5,
  input  wire [31:0] sold_4,
  input  wire [31:0] sold_1,
  input  wire [31:0] sold_3,
  input  wire [31:0] sold_2,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_0_3,
  output wire        expect_0_4,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_1_2,
  output wire        expect_1_3,
  output wire        expect_1_4,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_2_2,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_8_0,
  output wire        expect_9_0,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_11_0,
  output wire        expect_11_1,
  output wire        expect_12_0,
  output wire        expect_13_0,
  output wire        expect_13_1,
  output wire        expect_13_2,
  output wire        expect_13_3,
  output wire        expect_13_4,
  output wire        expect_14_0,
  output wire        expect_15_0,
  output wire        expect_16_0,
  output wire        expect_17_0,
  output wire        expect_18_0,
  output wire        expect_18_1,
  output wire        expect_19_0,
  output wire        expect_19_1,
  output wire        expect_19_2,
  output wire        expect_20_0,
  output wire        expect_20_1,
  output wire        expect_21_0,
  output wire        expect_21_1,
  output wire        expect_22_0,
  output wire        expect_22_1,
  output wire        expect_23_0,
  output wire        expect_24_0,
  output wire        expect_25_0,
  output wire        expect_25_1,
  output wire        expect_26_0,
  output wire        expect_27_0,
  output wire        expect_28_0,
  output wire        expect_28_1,
  output wire        expect_28_2,
  output wire        expect_29_0,
  output wire        expect_29_1,
  output wire        expect_29_2,
  output wire        expect_29_3,
  output wire        expect_29_4,
  output wire        expect_29_5,
  output wire        expect_30_0,
  output wire        expect_30_1,
  output wire        expect_30_2,
  output wire        expect_30_3,
  output wire        expect_31_0,
  output wire        expect_31_1,
  output wire        expect_31_2,
  output wire        expect_31_3,
  output wire        expect_32_0,
  output wire        expect_32_1,
  output wire        expect_32_2,
  output wire        expect_32_3,
  output wire        expect_33_0,
  output wire        expect_33_1,
  output wire        expect_33_2,
  output wire        expect_34_0,
  output wire        expect_34_1,
  output wire        expect_35_0,
  output wire        expect_35_1,
  output wire        expect_35_2,
  output wire        expect_35_3,
  output wire        expect_35_4,
  output wire        expect_36_0,
  output wire        expect_36_1,
  output wire        expect_37_0,
  output wire        expect_37_1,
  output wire        expect_37_2,
  output wire        expect_38_0,
  output wire        expect_38_1,
  output wire        expect_39_0,
  output wire        expect_40_0,
  output wire        expect_40_1,
  output wire        expect_40_2,
  output wire        expect_41_0,
  output wire        expect_41_1,
  output wire        expect_42_0,
  output wire        expect_43_0,
  output wire        expect_43_1,
  output wire        expect_44_0,
  output wire        expect_45_0,
  output wire        expect_45_1
);

  assign expect_0_0 = lamp_combo;
  assign expect_0_1 = ~lamp_fries;
  assign expect_0_2 = subtotal == 32'd899;
  assign expect_0_3 = tax == 32'd56;
  assign expect_0_4 = total == 32'd955;
  assign expect_1_0 = lamp_combo;
  assign expect_1_1 = lamp_fries;
  assign expect_1_2 = subtotal == 32'd1178;
  assign expect_1_3 = tax == 32'd74;
  assign expect_1_4 = total == 32'd1252;
  assign expect_2_0 = subtotal == 32'd1178;
  assign expect_2_1 = tax == 32'd0;
  assign expect_2_2 = total == 32'd1178;
  assign expect_3_0 = total == 32'd899;
  assign expect_3_1 = lamp_combo;
  assign expect_4_0 = total == 32'd1998;
  assign expect_4_1 = lamp_double;
  assign expect_5_0 = total == 32'd2647;
  assign expect_5_1 = lamp_junior;
  assign expect_6_0 = total == 32'd3196;
  assign expect_6_1 = lamp_burger;
  assign expect_7_0 = total == 32'd3425;
  assign expect_7_1 = lamp_drink;
  assign expect_8_0 = total == 32'd3654;
  assign expect_9_0 = tax == 32'd41;
  assign expect_10_0 = subtotal == 32'd458;
  assign expect_10_1 = tax == 32'd29;
  assign expect_11_0 = subtotal == 32'd8792;
  assign expect_11_1 = tax == 32'd550;
  assign expect_12_0 = total == 32'd778;
  assign expect_13_0 = total == 32'd899;
  assign expect_13_1 = lamp_burger;
  assign expect_13_2 = lamp_fries;
  assign expect_13_3 = lamp_drink;
  assign expect_13_4 = ~lamp_combo;
  assign expect_14_0 = total == 32'd1178;
  assign expect_15_0 = total == 32'd1798;
  assign expect_16_0 = total == 32'd1727;
  assign expect_17_0 = total == 32'd2306;
  assign expect_18_0 = total == 32'd2077;
  assign expect_18_1 = ~lamp_drink;
  assign expect_19_0 = total == 32'd1178;
  assign expect_19_1 = lamp_combo;
  assign expect_19_2 = lamp_fries;
  assign expect_20_0 = total == 32'd899;
  assign expect_20_1 = ~lamp_fries;
  assign expect_21_0 = total == 32'd0;
  assign expect_21_1 = ~lamp_combo;
  assign expect_22_0 = total == 32'd229;
  assign expect_22_1 = lamp_drink;
  assign expect_23_0 = total == 32'd508;
  assign expect_24_0 = total == 32'd279;
  assign expect_25_0 = total == 32'd899;
  assign expect_25_1 = ~lamp_drink;
  assign expect_26_0 = total == 32'd1178;
  assign expect_27_0 = total == 32'd899;
  assign expect_28_0 = profit == 32'd0;
  assign expect_28_1 = sold_0 == 32'd0;
  assign expect_28_2 = ~paid;
  assign expect_29_0 = paid;
  assign expect_29_1 = total == 32'd2027;
  assign expect_29_2 = profit == 32'd760;
  assign expect_29_3 = sold_0 == 32'd2;
  assign expect_29_4 = sold_5 == 32'd1;
  assign expect_29_5 = sold_4 == 32'd0;
  assign expect_30_0 = paid;
  assign expect_30_1 = total == 32'd2027;
  assign expect_30_2 = profit == 32'd760;
  assign expect_30_3 = sold_0 == 32'd2;
  assign expect_31_0 = ~paid;
  assign expect_31_1 = total == 32'd0;
  assign expect_31_2 = ~lamp_combo;
  assign expect_31_3 = profit == 32'd760;
  assign expect_32_0 = total == 32'd1099;
  assign expect_32_1 = profit == 32'd1130;
  assign expect_32_2 = sold_1 == 32'd1;
  assign expect_32_3 = sold_0 == 32'd2;
  assign expect_33_0 = total == 32'd0;
  assign expect_33_1 = profit == 32'd0;
  assign expect_33_2 = sold_0 == 32'd0;
  assign expect_34_0 = ~paid;
  assign expect_34_1 = profit == 32'd0;
  assign expect_35_0 = profit == 32'd302;
  assign expect_35_1 = sold_3 == 32'd1;
  assign expect_35_2 = sold_4 == 32'd1;
  assign expect_35_3 = sold_5 == 32'd1;
  assign expect_35_4 = sold_0 == 32'd0;
  assign expect_36_0 = profit == 32'd240;
  assign expect_36_1 = sold_2 == 32'd1;
  assign expect_37_0 = profit == 32'd0;
  assign expect_37_1 = sold_2 == 32'd0;
  assign expect_37_2 = lamp_burger;
  assign expect_38_0 = profit == 32'd150;
  assign expect_38_1 = sold_3 == 32'd1;
  assign expect_39_0 = total == 32'd2731;
  assign expect_40_0 = total == 32'd899;
  assign expect_40_1 = lamp_combo;
  assign expect_40_2 = ~lamp_drink;
  assign expect_41_0 = total == 32'd899;
  assign expect_41_1 = lamp_combo;
  assign expect_42_0 = total == 32'd899;
  assign expect_43_0 = total == 32'd229;
  assign expect_43_1 = ~lamp_combo;
  assign expect_44_0 = total == 32'd0;
  assign expect_45_0 = total == 32'd0;
  assign expect_45_1 = ~lamp_combo;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module cash_register_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg key_combo = 1'd0;
  reg key_double = 1'd0;
  reg key_junior = 1'd0;
  reg key_burger = 1'd0;
  reg key_fries = 1'd0;
  reg key_drink = 1'd0;
  reg cancel_last = 1'd0;
  reg total_key = 1'd0;
  reg new_order = 1'd0;
  reg new_day = 1'd0;
  reg to_go = 1'd0;
  wire lamp_combo;
  wire lamp_double;
  wire lamp_junior;
  wire lamp_burger;
  wire lamp_fries;
  wire lamp_drink;
  wire [31:0] subtotal;
  wire [31:0] tax;
  wire [31:0] total;
  wire paid;
  wire [191:0] sold;
  wire [31:0] profit;
  reg failed;
  integer failures;

  cash_register core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .key_combo(key_combo),
    .key_double(key_double),
    .key_junior(key_junior),
    .key_burger(key_burger),
    .key_fries(key_fries),
    .key_drink(key_drink),
    .cancel_last(cancel_last),
    .total_key(total_key),
    .new_order(new_order),
    .new_day(new_day),
    .to_go(to_go),
    .lamp_combo(lamp_combo),
    .lamp_double(lamp_double),
    .lamp_junior(lamp_junior),
    .lamp_burger(lamp_burger),
    .lamp_fries(lamp_fries),
    .lamp_drink(lamp_drink),
    .subtotal(subtotal),
    .tax(tax),
    .total(total),
    .paid(paid),
    .sold(sold),
    .profit(profit)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire expect_0_3;
  wire expect_0_4;
  wire [0:4] expect_0 = {expect_0_0, expect_0_1, expect_0_2, expect_0_3, expect_0_4};
  wire expect_1_0;
  wire expect_1_1;
  wire expect_1_2;
  wire expect_1_3;
  wire expect_1_4;
  wire [0:4] expect_1 = {expect_1_0, expect_1_1, expect_1_2, expect_1_3, expect_1_4};
  wire expect_2_0;
  wire expect_2_1;
  wire expect_2_2;
  wire [0:2] expect_2 = {expect_2_0, expect_2_1, expect_2_2};
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
  wire expect_10_1;
  wire [0:1] expect_10 = {expect_10_0, expect_10_1};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire expect_13_1;
  wire expect_13_2;
  wire expect_13_3;
  wire expect_13_4;
  wire [0:4] expect_13 = {expect_13_0, expect_13_1, expect_13_2, expect_13_3, expect_13_4};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  wire expect_16_0;
  wire [0:0] expect_16 = {expect_16_0};
  wire expect_17_0;
  wire [0:0] expect_17 = {expect_17_0};
  wire expect_18_0;
  wire expect_18_1;
  wire [0:1] expect_18 = {expect_18_0, expect_18_1};
  wire expect_19_0;
  wire expect_19_1;
  wire expect_19_2;
  wire [0:2] expect_19 = {expect_19_0, expect_19_1, expect_19_2};
  wire expect_20_0;
  wire expect_20_1;
  wire [0:1] expect_20 = {expect_20_0, expect_20_1};
  wire expect_21_0;
  wire expect_21_1;
  wire [0:1] expect_21 = {expect_21_0, expect_21_1};
  wire expect_22_0;
  wire expect_22_1;
  wire [0:1] expect_22 = {expect_22_0, expect_22_1};
  wire expect_23_0;
  wire [0:0] expect_23 = {expect_23_0};
  wire expect_24_0;
  wire [0:0] expect_24 = {expect_24_0};
  wire expect_25_0;
  wire expect_25_1;
  wire [0:1] expect_25 = {expect_25_0, expect_25_1};
  wire expect_26_0;
  wire [0:0] expect_26 = {expect_26_0};
  wire expect_27_0;
  wire [0:0] expect_27 = {expect_27_0};
  wire expect_28_0;
  wire expect_28_1;
  wire expect_28_2;
  wire [0:2] expect_28 = {expect_28_0, expect_28_1, expect_28_2};
  wire expect_29_0;
  wire expect_29_1;
  wire expect_29_2;
  wire expect_29_3;
  wire expect_29_4;
  wire expect_29_5;
  wire [0:5] expect_29 = {expect_29_0, expect_29_1, expect_29_2, expect_29_3, expect_29_4, expect_29_5};
  wire expect_30_0;
  wire expect_30_1;
  wire expect_30_2;
  wire expect_30_3;
  wire [0:3] expect_30 = {expect_30_0, expect_30_1, expect_30_2, expect_30_3};
  wire expect_31_0;
  wire expect_31_1;
  wire expect_31_2;
  wire expect_31_3;
  wire [0:3] expect_31 = {expect_31_0, expect_31_1, expect_31_2, expect_31_3};
  wire expect_32_0;
  wire expect_32_1;
  wire expect_32_2;
  wire expect_32_3;
  wire [0:3] expect_32 = {expect_32_0, expect_32_1, expect_32_2, expect_32_3};
  wire expect_33_0;
  wire expect_33_1;
  wire expect_33_2;
  wire [0:2] expect_33 = {expect_33_0, expect_33_1, expect_33_2};
  wire expect_34_0;
  wire expect_34_1;
  wire [0:1] expect_34 = {expect_34_0, expect_34_1};
  wire expect_35_0;
  wire expect_35_1;
  wire expect_35_2;
  wire expect_35_3;
  wire expect_35_4;
  wire [0:4] expect_35 = {expect_35_0, expect_35_1, expect_35_2, expect_35_3, expect_35_4};
  wire expect_36_0;
  wire expect_36_1;
  wire [0:1] expect_36 = {expect_36_0, expect_36_1};
  wire expect_37_0;
  wire expect_37_1;
  wire expect_37_2;
  wire [0:2] expect_37 = {expect_37_0, expect_37_1, expect_37_2};
  wire expect_38_0;
  wire expect_38_1;
  wire [0:1] expect_38 = {expect_38_0, expect_38_1};
  wire expect_39_0;
  wire [0:0] expect_39 = {expect_39_0};
  wire expect_40_0;
  wire expect_40_1;
  wire expect_40_2;
  wire [0:2] expect_40 = {expect_40_0, expect_40_1, expect_40_2};
  wire expect_41_0;
  wire expect_41_1;
  wire [0:1] expect_41 = {expect_41_0, expect_41_1};
  wire expect_42_0;
  wire [0:0] expect_42 = {expect_42_0};
  wire expect_43_0;
  wire expect_43_1;
  wire [0:1] expect_43 = {expect_43_0, expect_43_1};
  wire expect_44_0;
  wire [0:0] expect_44 = {expect_44_0};
  wire expect_45_0;
  wire expect_45_1;
  wire [0:1] expect_45 = {expect_45_0, expect_45_1};
  cash_register_expect expectations (
    .clk(clk),
    .rst(rst),
    .lamp_combo(lamp_combo),
    .lamp_fries(lamp_fries),
    .subtotal(subtotal),
    .tax(tax),
    .total(total),
    .lamp_double(lamp_double),
    .lamp_junior(lamp_junior),
    .lamp_burger(lamp_burger),
    .lamp_drink(lamp_drink),
    .profit(profit),
    .sold_0(sold[31:0]),
    .paid(paid),
    .sold_5(sold[191:160]),
    .sold_4(sold[159:128]),
    .sold_1(sold[63:32]),
    .sold_3(sold[127:96]),
    .sold_2(sold[95:64]),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_0_3(expect_0_3),
    .expect_0_4(expect_0_4),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_1_3(expect_1_3),
    .expect_1_4(expect_1_4),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_2_2(expect_2_2),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_9_0(expect_9_0),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_13_1(expect_13_1),
    .expect_13_2(expect_13_2),
    .expect_13_3(expect_13_3),
    .expect_13_4(expect_13_4),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_16_0(expect_16_0),
    .expect_17_0(expect_17_0),
    .expect_18_0(expect_18_0),
    .expect_18_1(expect_18_1),
    .expect_19_0(expect_19_0),
    .expect_19_1(expect_19_1),
    .expect_19_2(expect_19_2),
    .expect_20_0(expect_20_0),
    .expect_20_1(expect_20_1),
    .expect_21_0(expect_21_0),
    .expect_21_1(expect_21_1),
    .expect_22_0(expect_22_0),
    .expect_22_1(expect_22_1),
    .expect_23_0(expect_23_0),
    .expect_24_0(expect_24_0),
    .expect_25_0(expect_25_0),
    .expect_25_1(expect_25_1),
    .expect_26_0(expect_26_0),
    .expect_27_0(expect_27_0),
    .expect_28_0(expect_28_0),
    .expect_28_1(expect_28_1),
    .expect_28_2(expect_28_2),
    .expect_29_0(expect_29_0),
    .expect_29_1(expect_29_1),
    .expect_29_2(expect_29_2),
    .expect_29_3(expect_29_3),
    .expect_29_4(expect_29_4),
    .expect_29_5(expect_29_5),
    .expect_30_0(expect_30_0),
    .expect_30_1(expect_30_1),
    .expect_30_2(expect_30_2),
    .expect_30_3(expect_30_3),
    .expect_31_0(expect_31_0),
    .expect_31_1(expect_31_1),
    .expect_31_2(expect_31_2),
    .expect_31_3(expect_31_3),
    .expect_32_0(expect_32_0),
    .expect_32_1(expect_32_1),
    .expect_32_2(expect_32_2),
    .expect_32_3(expect_32_3),
    .expect_33_0(expect_33_0),
    .expect_33_1(expect_33_1),
    .expect_33_2(expect_33_2),
    .expect_34_0(expect_34_0),
    .expect_34_1(expect_34_1),
    .expect_35_0(expect_35_0),
    .expect_35_1(expect_35_1),
    .expect_35_2(expect_35_2),
    .expect_35_3(expect_35_3),
    .expect_35_4(expect_35_4),
    .expect_36_0(expect_36_0),
    .expect_36_1(expect_36_1),
    .expect_37_0(expect_37_0),
    .expect_37_1(expect_37_1),
    .expect_37_2(expect_37_2),
    .expect_38_0(expect_38_0),
    .expect_38_1(expect_38_1),
    .expect_39_0(expect_39_0),
    .expect_40_0(expect_40_0),
    .expect_40_1(expect_40_1),
    .expect_40_2(expect_40_2),
    .expect_41_0(expect_41_0),
    .expect_41_1(expect_41_1),
    .expect_42_0(expect_42_0),
    .expect_43_0(expect_43_0),
    .expect_43_1(expect_43_1),
    .expect_44_0(expect_44_0),
    .expect_45_0(expect_45_0),
    .expect_45_1(expect_45_1)
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
      key_combo = 1'd0;
      key_double = 1'd0;
      key_junior = 1'd0;
      key_burger = 1'd0;
      key_fries = 1'd0;
      key_drink = 1'd0;
      cancel_last = 1'd0;
      total_key = 1'd0;
      new_order = 1'd0;
      new_day = 1'd0;
      to_go = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..14");

    // two entries, with tax and to go
    failed = 1'b0;
    reset;
    key_combo = 1'd1;
    scan(1, 1'b0);
    key_combo = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // cash_register.ladder:130
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b lamp_combo=%b lamp_fries=%b subtotal=%b tax=%b total=%b at %0s", expect_0, lamp_combo, lamp_fries, subtotal, tax, total, "cash_register.ladder:130");
    end
    key_fries = 1'd1;
    scan(1, 1'b0);
    key_fries = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // cash_register.ladder:132
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b lamp_combo=%b lamp_fries=%b subtotal=%b tax=%b total=%b at %0s", expect_1, lamp_combo, lamp_fries, subtotal, tax, total, "cash_register.ladder:132");
    end
    to_go = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // cash_register.ladder:134
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b subtotal=%b tax=%b total=%b at %0s", expect_2, subtotal, tax, total, "cash_register.ladder:134");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "two entries, with tax and to go");
    end else $display("ok 1 - %0s", "two entries, with tax and to go");

    // every key
    failed = 1'b0;
    reset;
    to_go = 1'd1;
    key_combo = 1'd1;
    scan(1, 1'b0);
    key_combo = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // cash_register.ladder:139
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b total=%b lamp_combo=%b at %0s", expect_3, total, lamp_combo, "cash_register.ladder:139");
    end
    key_double = 1'd1;
    scan(1, 1'b0);
    key_double = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // cash_register.ladder:141
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b total=%b lamp_double=%b at %0s", expect_4, total, lamp_double, "cash_register.ladder:141");
    end
    key_junior = 1'd1;
    scan(1, 1'b0);
    key_junior = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // cash_register.ladder:143
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b total=%b lamp_junior=%b at %0s", expect_5, total, lamp_junior, "cash_register.ladder:143");
    end
    key_burger = 1'd1;
    scan(1, 1'b0);
    key_burger = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // cash_register.ladder:145
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b total=%b lamp_burger=%b at %0s", expect_6, total, lamp_burger, "cash_register.ladder:145");
    end
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // cash_register.ladder:147
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b total=%b lamp_drink=%b at %0s", expect_7, total, lamp_drink, "cash_register.ladder:147");
    end
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // cash_register.ladder:149
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b total=%b at %0s", expect_8, total, "cash_register.ladder:149");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "every key");
    end else $display("ok 2 - %0s", "every key");

    // a cent is rounded at the half
    failed = 1'b0;
    reset;
    key_junior = 1'd1;
    scan(1, 1'b0);
    key_junior = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // cash_register.ladder:153
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b tax=%b at %0s", expect_9, tax, "cash_register.ladder:153");
    end
    new_order = 1'd1;
    scan(1, 1'b0);
    new_order = 1'd0;
    scan(1, 1'b0);
    repeat (2) begin
      key_drink = 1'd1;
      scan(1, 1'b0);
      key_drink = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_10 !== 1'b1) begin // cash_register.ladder:156
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b subtotal=%b tax=%b at %0s", expect_10, subtotal, tax, "cash_register.ladder:156");
    end
    new_order = 1'd1;
    scan(1, 1'b0);
    new_order = 1'd0;
    scan(1, 1'b0);
    repeat (8) begin
      key_double = 1'd1;
      scan(1, 1'b0);
      key_double = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_11 !== 1'b1) begin // cash_register.ladder:159
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b subtotal=%b tax=%b at %0s", expect_11, subtotal, tax, "cash_register.ladder:159");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a cent is rounded at the half");
    end else $display("ok 3 - %0s", "a cent is rounded at the half");

    // burger, fries and drink become a combo as soon as they are three
    failed = 1'b0;
    reset;
    to_go = 1'd1;
    key_burger = 1'd1;
    scan(1, 1'b0);
    key_burger = 1'd0;
    scan(1, 1'b0);
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // cash_register.ladder:165
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b total=%b at %0s", expect_12, total, "cash_register.ladder:165");
    end
    key_fries = 1'd1;
    scan(1, 1'b0);
    key_fries = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // cash_register.ladder:167
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b total=%b lamp_burger=%b lamp_fries=%b lamp_drink=%b lamp_combo=%b at %0s", expect_13, total, lamp_burger, lamp_fries, lamp_drink, lamp_combo, "cash_register.ladder:167");
    end
    key_fries = 1'd1;
    scan(1, 1'b0);
    key_fries = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // cash_register.ladder:169
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b total=%b at %0s", expect_14, total, "cash_register.ladder:169");
    end
    key_burger = 1'd1;
    scan(1, 1'b0);
    key_burger = 1'd0;
    scan(1, 1'b0);
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // cash_register.ladder:172
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b total=%b at %0s", expect_15, total, "cash_register.ladder:172");
    end
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_16 !== 1'b1) begin // cash_register.ladder:174
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b total=%b at %0s", expect_16, total, "cash_register.ladder:174");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "burger, fries and drink become a combo as soon as they are three");
    end else $display("ok 4 - %0s", "burger, fries and drink become a combo as soon as they are three");

    // entries are taken back, the last first, down to nothing
    failed = 1'b0;
    reset;
    to_go = 1'd1;
    key_combo = 1'd1;
    scan(1, 1'b0);
    key_combo = 1'd0;
    scan(1, 1'b0);
    key_fries = 1'd1;
    scan(1, 1'b0);
    key_fries = 1'd0;
    scan(1, 1'b0);
    key_combo = 1'd1;
    scan(1, 1'b0);
    key_combo = 1'd0;
    scan(1, 1'b0);
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_17 !== 1'b1) begin // cash_register.ladder:182
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b total=%b at %0s", expect_17, total, "cash_register.ladder:182");
    end
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_18 !== 1'b1) begin // cash_register.ladder:184
      failed = 1'b1;
      $display("# failed expectation 18 conducts %b total=%b lamp_drink=%b at %0s", expect_18, total, lamp_drink, "cash_register.ladder:184");
    end
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_19 !== 1'b1) begin // cash_register.ladder:186
      failed = 1'b1;
      $display("# failed expectation 19 conducts %b total=%b lamp_combo=%b lamp_fries=%b at %0s", expect_19, total, lamp_combo, lamp_fries, "cash_register.ladder:186");
    end
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_20 !== 1'b1) begin // cash_register.ladder:188
      failed = 1'b1;
      $display("# failed expectation 20 conducts %b total=%b lamp_fries=%b at %0s", expect_20, total, lamp_fries, "cash_register.ladder:188");
    end
    repeat (3) begin
      cancel_last = 1'd1;
      scan(1, 1'b0);
      cancel_last = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_21 !== 1'b1) begin // cash_register.ladder:190
      failed = 1'b1;
      $display("# failed expectation 21 conducts %b total=%b lamp_combo=%b at %0s", expect_21, total, lamp_combo, "cash_register.ladder:190");
    end
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_22 !== 1'b1) begin // cash_register.ladder:192
      failed = 1'b1;
      $display("# failed expectation 22 conducts %b total=%b lamp_drink=%b at %0s", expect_22, total, lamp_drink, "cash_register.ladder:192");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "entries are taken back, the last first, down to nothing");
    end else $display("ok 5 - %0s", "entries are taken back, the last first, down to nothing");

    // a key that is held is one entry, a cancel that is held takes one back
    failed = 1'b0;
    reset;
    to_go = 1'd1;
    key_fries = 1'd1;
    scan(5, 1'b0);
    key_fries = 1'd0;
    scan(1, 1'b0);
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_23 !== 1'b1) begin // cash_register.ladder:198
      failed = 1'b1;
      $display("# failed expectation 23 conducts %b total=%b at %0s", expect_23, total, "cash_register.ladder:198");
    end
    cancel_last = 1'd1;
    scan(5, 1'b0);
    #1 if (!failed && &expect_24 !== 1'b1) begin // cash_register.ladder:200
      failed = 1'b1;
      $display("# failed expectation 24 conducts %b total=%b at %0s", expect_24, total, "cash_register.ladder:200");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "a key that is held is one entry, a cancel that is held takes one back");
    end else $display("ok 6 - %0s", "a key that is held is one entry, a cancel that is held takes one back");

    // two keys at once are one entry, and a key is stronger than cancel
    failed = 1'b0;
    reset;
    to_go = 1'd1;
    key_combo = 1'd1;
    key_drink = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_25 !== 1'b1) begin // cash_register.ladder:205
      failed = 1'b1;
      $display("# failed expectation 25 conducts %b total=%b lamp_drink=%b at %0s", expect_25, total, lamp_drink, "cash_register.ladder:205");
    end
    key_combo = 1'd0;
    key_drink = 1'd0;
    scan(1, 1'b0);
    key_fries = 1'd1;
    cancel_last = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_26 !== 1'b1) begin // cash_register.ladder:208
      failed = 1'b1;
      $display("# failed expectation 26 conducts %b total=%b at %0s", expect_26, total, "cash_register.ladder:208");
    end
    key_fries = 1'd0;
    cancel_last = 1'd0;
    scan(1, 1'b0);
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_27 !== 1'b1) begin // cash_register.ladder:211
      failed = 1'b1;
      $display("# failed expectation 27 conducts %b total=%b at %0s", expect_27, total, "cash_register.ladder:211");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "two keys at once are one entry, and a key is stronger than cancel");
    end else $display("ok 7 - %0s", "two keys at once are one entry, and a key is stronger than cancel");

    // paid: the books of the day, and dead keys
    failed = 1'b0;
    reset;
    to_go = 1'd1;
    repeat (2) begin
      key_combo = 1'd1;
      scan(1, 1'b0);
      key_combo = 1'd0;
      scan(1, 1'b0);
    end
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_28 !== 1'b1) begin // cash_register.ladder:217
      failed = 1'b1;
      $display("# failed expectation 28 conducts %b profit=%b sold[0]=%b paid=%b at %0s", expect_28, profit, sold[31:0], paid, "cash_register.ladder:217");
    end
    total_key = 1'd1;
    scan(5, 1'b0);
    #1 if (!failed && &expect_29 !== 1'b1) begin // cash_register.ladder:219
      failed = 1'b1;
      $display("# failed expectation 29 conducts %b paid=%b total=%b profit=%b sold[0]=%b sold[5]=%b sold[4]=%b at %0s", expect_29, paid, total, profit, sold[31:0], sold[191:160], sold[159:128], "cash_register.ladder:219");
    end
    total_key = 1'd0;
    scan(1, 1'b0);
    key_combo = 1'd1;
    scan(1, 1'b0);
    key_combo = 1'd0;
    scan(1, 1'b0);
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    total_key = 1'd1;
    scan(1, 1'b0);
    total_key = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_30 !== 1'b1) begin // cash_register.ladder:225
      failed = 1'b1;
      $display("# failed expectation 30 conducts %b paid=%b total=%b profit=%b sold[0]=%b at %0s", expect_30, paid, total, profit, sold[31:0], "cash_register.ladder:225");
    end
    new_order = 1'd1;
    scan(1, 1'b0);
    new_order = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_31 !== 1'b1) begin // cash_register.ladder:227
      failed = 1'b1;
      $display("# failed expectation 31 conducts %b paid=%b total=%b lamp_combo=%b profit=%b at %0s", expect_31, paid, total, lamp_combo, profit, "cash_register.ladder:227");
    end
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    key_double = 1'd1;
    scan(1, 1'b0);
    key_double = 1'd0;
    scan(1, 1'b0);
    total_key = 1'd1;
    scan(1, 1'b0);
    total_key = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_32 !== 1'b1) begin // cash_register.ladder:231
      failed = 1'b1;
      $display("# failed expectation 32 conducts %b total=%b profit=%b sold[1]=%b sold[0]=%b at %0s", expect_32, total, profit, sold[63:32], sold[31:0], "cash_register.ladder:231");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 8 - %0s", "paid: the books of the day, and dead keys");
    end else $display("ok 8 - %0s", "paid: the books of the day, and dead keys");

    // an order that is thrown away is not in the books, nor is an empty one
    failed = 1'b0;
    reset;
    key_combo = 1'd1;
    scan(1, 1'b0);
    key_combo = 1'd0;
    scan(1, 1'b0);
    new_order = 1'd1;
    scan(1, 1'b0);
    new_order = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_33 !== 1'b1) begin // cash_register.ladder:236
      failed = 1'b1;
      $display("# failed expectation 33 conducts %b total=%b profit=%b sold[0]=%b at %0s", expect_33, total, profit, sold[31:0], "cash_register.ladder:236");
    end
    total_key = 1'd1;
    scan(1, 1'b0);
    total_key = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_34 !== 1'b1) begin // cash_register.ladder:238
      failed = 1'b1;
      $display("# failed expectation 34 conducts %b paid=%b profit=%b at %0s", expect_34, paid, profit, "cash_register.ladder:238");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 9 - %0s", "an order that is thrown away is not in the books, nor is an empty one");
    end else $display("ok 9 - %0s", "an order that is thrown away is not in the books, nor is an empty one");

    // three entered one by one earn what is left of their profit
    failed = 1'b0;
    reset;
    key_burger = 1'd1;
    scan(1, 1'b0);
    key_burger = 1'd0;
    scan(1, 1'b0);
    key_fries = 1'd1;
    scan(1, 1'b0);
    key_fries = 1'd0;
    scan(1, 1'b0);
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    total_key = 1'd1;
    scan(1, 1'b0);
    total_key = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_35 !== 1'b1) begin // cash_register.ladder:245
      failed = 1'b1;
      $display("# failed expectation 35 conducts %b profit=%b sold[3]=%b sold[4]=%b sold[5]=%b sold[0]=%b at %0s", expect_35, profit, sold[127:96], sold[159:128], sold[191:160], sold[31:0], "cash_register.ladder:245");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 10 - %0s", "three entered one by one earn what is left of their profit");
    end else $display("ok 10 - %0s", "three entered one by one earn what is left of their profit");

    // a new day
    failed = 1'b0;
    reset;
    key_junior = 1'd1;
    scan(1, 1'b0);
    key_junior = 1'd0;
    scan(1, 1'b0);
    total_key = 1'd1;
    scan(1, 1'b0);
    total_key = 1'd0;
    scan(1, 1'b0);
    new_order = 1'd1;
    scan(1, 1'b0);
    new_order = 1'd0;
    scan(1, 1'b0);
    key_burger = 1'd1;
    scan(1, 1'b0);
    key_burger = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_36 !== 1'b1) begin // cash_register.ladder:253
      failed = 1'b1;
      $display("# failed expectation 36 conducts %b profit=%b sold[2]=%b at %0s", expect_36, profit, sold[95:64], "cash_register.ladder:253");
    end
    new_day = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_37 !== 1'b1) begin // cash_register.ladder:255
      failed = 1'b1;
      $display("# failed expectation 37 conducts %b profit=%b sold[2]=%b lamp_burger=%b at %0s", expect_37, profit, sold[95:64], lamp_burger, "cash_register.ladder:255");
    end
    total_key = 1'd1;
    scan(1, 1'b0);
    total_key = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_38 !== 1'b1) begin // cash_register.ladder:257
      failed = 1'b1;
      $display("# failed expectation 38 conducts %b profit=%b sold[3]=%b at %0s", expect_38, profit, sold[127:96], "cash_register.ladder:257");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 11 - %0s", "a new day");
    end else $display("ok 11 - %0s", "a new day");

    // the last eight entries can be taken back, and no more
    failed = 1'b0;
    reset;
    to_go = 1'd1;
    key_combo = 1'd1;
    scan(1, 1'b0);
    key_combo = 1'd0;
    scan(1, 1'b0);
    repeat (8) begin
      key_drink = 1'd1;
      scan(1, 1'b0);
      key_drink = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_39 !== 1'b1) begin // cash_register.ladder:263
      failed = 1'b1;
      $display("# failed expectation 39 conducts %b total=%b at %0s", expect_39, total, "cash_register.ladder:263");
    end
    repeat (8) begin
      cancel_last = 1'd1;
      scan(1, 1'b0);
      cancel_last = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_40 !== 1'b1) begin // cash_register.ladder:265
      failed = 1'b1;
      $display("# failed expectation 40 conducts %b total=%b lamp_combo=%b lamp_drink=%b at %0s", expect_40, total, lamp_combo, lamp_drink, "cash_register.ladder:265");
    end
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_41 !== 1'b1) begin // cash_register.ladder:267
      failed = 1'b1;
      $display("# failed expectation 41 conducts %b total=%b lamp_combo=%b at %0s", expect_41, total, lamp_combo, "cash_register.ladder:267");
    end
    key_fries = 1'd1;
    scan(1, 1'b0);
    key_fries = 1'd0;
    scan(1, 1'b0);
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_42 !== 1'b1) begin // cash_register.ladder:270
      failed = 1'b1;
      $display("# failed expectation 42 conducts %b total=%b at %0s", expect_42, total, "cash_register.ladder:270");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 12 - %0s", "the last eight entries can be taken back, and no more");
    end else $display("ok 12 - %0s", "the last eight entries can be taken back, and no more");

    // what was entered before a new order cannot be taken back in it
    failed = 1'b0;
    reset;
    to_go = 1'd1;
    key_combo = 1'd1;
    scan(1, 1'b0);
    key_combo = 1'd0;
    scan(1, 1'b0);
    new_order = 1'd1;
    scan(1, 1'b0);
    new_order = 1'd0;
    scan(1, 1'b0);
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    key_drink = 1'd1;
    scan(1, 1'b0);
    key_drink = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_43 !== 1'b1) begin // cash_register.ladder:278
      failed = 1'b1;
      $display("# failed expectation 43 conducts %b total=%b lamp_combo=%b at %0s", expect_43, total, lamp_combo, "cash_register.ladder:278");
    end
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    cancel_last = 1'd1;
    scan(1, 1'b0);
    cancel_last = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_44 !== 1'b1) begin // cash_register.ladder:281
      failed = 1'b1;
      $display("# failed expectation 44 conducts %b total=%b at %0s", expect_44, total, "cash_register.ladder:281");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 13 - %0s", "what was entered before a new order cannot be taken back in it");
    end else $display("ok 13 - %0s", "what was entered before a new order cannot be taken back in it");

    // a key together with new order is no entry
    failed = 1'b0;
    reset;
    key_combo = 1'd1;
    new_order = 1'd1;
    scan(1, 1'b0);
    new_order = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_45 !== 1'b1) begin // cash_register.ladder:286
      failed = 1'b1;
      $display("# failed expectation 45 conducts %b total=%b lamp_combo=%b at %0s", expect_45, total, lamp_combo, "cash_register.ladder:286");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 14 - %0s", "a key together with new order is no entry");
    end else $display("ok 14 - %0s", "a key together with new order is no entry");

    if (failures != 0) $display("# %0d of 14 tests failed", failures);
    $finish;
  end
endmodule
