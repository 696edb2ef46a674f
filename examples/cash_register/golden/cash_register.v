// Made by hotrail 0.1.0 from cash_register.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// CTUD: up-down counter
// Example, with PV = 2:
// IN  _#_#__#______
// CD  ____#_#_#____
// R   ___________##
// LD  __________#_#
// QU  ___#______#__
// QD  #_______##_##
// CV  0112111100200
module cash_register_CTUD (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        CD,
  input  wire        R,
  output wire [15:0] CV
);
  reg [15:0] CV_reg = 16'd0;
  reg was = 1'b0;
  reg was_down = 1'b0;

  wire condition = power & ~was;
  wire condition_2 = CD & ~was_down;
  wire unequal = CV_reg != 16'd32767;
  wire unequal_2 = CV_reg != 16'h8000;
  wire [1:0] choice =
      (condition_2 & ~condition & unequal_2) ? 2'd3 : {1'b0, condition & ~condition_2 & unequal};
  wire [15:0] sum = CV_reg + {{14{choice[1]}}, choice};
  wire [15:0] CV_next = R ? 16'd0 : sum;

  assign CV = CV_next;

  always @(posedge clk) begin
    if (rst) begin
      CV_reg <= 16'd0;
      was <= 1'b0;
      was_down <= 1'b0;
    end else begin
      CV_reg <= CV_next;
      was <= power;
      was_down <= CD;
    end
  end
endmodule

module cash_register (
  input  wire         clk,
  input  wire         rst,
  input  wire         tick,
  input  wire         key_combo,
  input  wire         key_double,
  input  wire         key_junior,
  input  wire         key_burger,
  input  wire         key_fries,
  input  wire         key_drink,
  input  wire         cancel_last,
  input  wire         total_key,
  input  wire         new_order,
  input  wire         new_day,
  input  wire         to_go,
  output wire         lamp_combo,
  output wire         lamp_double,
  output wire         lamp_junior,
  output wire         lamp_burger,
  output wire         lamp_fries,
  output wire         lamp_drink,
  output wire [31:0]  subtotal,
  output wire [31:0]  tax,
  output wire [31:0]  total,
  output wire         paid,
  output wire [191:0] sold,
  output wire [31:0]  profit
);
  reg key_drink_before = 1'b0;
  reg key_fries_before = 1'b0;
  reg key_burger_before = 1'b0;
  reg key_junior_before = 1'b0;
  reg key_double_before = 1'b0;
  reg key_combo_before = 1'b0;
  reg paid_reg = 1'b0;
  reg [2:0] place = 3'd0;
  reg [2:0] last_0 = 3'd0;
  reg [2:0] last_1 = 3'd0;
  reg [2:0] last_2 = 3'd0;
  reg [2:0] last_3 = 3'd0;
  reg [2:0] last_4 = 3'd0;
  reg [2:0] last_5 = 3'd0;
  reg [2:0] last_6 = 3'd0;
  reg [2:0] last_7 = 3'd0;
  reg [15:0] kept = 16'd0;
  reg cancel_last_before = 1'b0;
  reg [31:0] subtotal_reg = 32'd0;
  reg [27:0] tax_reg = 28'd0;
  reg [31:0] total_reg = 32'd0;
  reg total_key_before = 1'b0;
  reg [31:0] sold_0 = 32'd0;
  reg [31:0] sold_1 = 32'd0;
  reg [31:0] sold_2 = 32'd0;
  reg [31:0] sold_3 = 32'd0;
  reg [31:0] sold_4 = 32'd0;
  reg [31:0] sold_5 = 32'd0;
  reg [31:0] profit_reg = 32'd0;
  reg new_day_before = 1'b0;
  reg lamp_combo_reg = 1'b0;
  reg lamp_double_reg = 1'b0;
  reg lamp_junior_reg = 1'b0;
  reg lamp_burger_reg = 1'b0;
  reg lamp_fries_reg = 1'b0;
  reg lamp_drink_reg = 1'b0;

  // rung 1 "a key: one in a scan, the upper one of several", cash_register.ladder:52

  // rung 2, cash_register.ladder:54
  wire [3:0] entry_rung2 = (key_drink & ~key_drink_before) ? 4'd5 : 4'd15;

  // rung 3, cash_register.ladder:55
  wire [3:0] entry_rung3 = (key_fries & ~key_fries_before) ? 4'd4 : entry_rung2;

  // rung 4, cash_register.ladder:56
  wire [3:0] entry_rung4 = (key_burger & ~key_burger_before) ? 4'd3 : entry_rung3;

  // rung 5, cash_register.ladder:57
  wire [3:0] entry_rung5 = (key_junior & ~key_junior_before) ? 4'd2 : entry_rung4;

  // rung 6, cash_register.ladder:58
  wire [3:0] entry_rung6 = (key_double & ~key_double_before) ? 4'd1 : entry_rung5;

  // rung 7, cash_register.ladder:59
  wire [3:0] entry_rung7 = (key_combo & ~key_combo_before) ? 4'd0 : entry_rung6;

  // rung 8, cash_register.ladder:60
  wire [3:0] entry = (paid_reg | new_order) ? 4'd15 : entry_rung7;

  // rung 9 "remember what was entered", cash_register.ladder:62
  wire rung9_unequal = entry != 4'd15;
  wire rung9_equal = place == 3'd0;
  wire [2:0] rung9_choice = rung9_equal ? entry[2:0] : last_0;
  wire [2:0] last_0_next = rung9_unequal ? rung9_choice : last_0;
  wire rung9_equal_2 = place == 3'd1;
  wire [2:0] rung9_choice_2 = rung9_equal_2 ? entry[2:0] : last_1;
  wire [2:0] last_1_next = rung9_unequal ? rung9_choice_2 : last_1;
  wire rung9_equal_3 = place == 3'd2;
  wire [2:0] rung9_choice_3 = rung9_equal_3 ? entry[2:0] : last_2;
  wire [2:0] last_2_next = rung9_unequal ? rung9_choice_3 : last_2;
  wire rung9_equal_4 = place == 3'd3;
  wire [2:0] rung9_choice_4 = rung9_equal_4 ? entry[2:0] : last_3;
  wire [2:0] last_3_next = rung9_unequal ? rung9_choice_4 : last_3;
  wire rung9_equal_5 = place == 3'd4;
  wire [2:0] rung9_choice_5 = rung9_equal_5 ? entry[2:0] : last_4;
  wire [2:0] last_4_next = rung9_unequal ? rung9_choice_5 : last_4;
  wire rung9_equal_6 = place == 3'd5;
  wire [2:0] rung9_choice_6 = rung9_equal_6 ? entry[2:0] : last_5;
  wire [2:0] last_5_next = rung9_unequal ? rung9_choice_6 : last_5;
  wire rung9_equal_7 = place == 3'd6;
  wire [2:0] rung9_choice_7 = rung9_equal_7 ? entry[2:0] : last_6;
  wire [2:0] last_6_next = rung9_unequal ? rung9_choice_7 : last_6;
  wire rung9_equal_8 = place == 3'd7;
  wire [2:0] rung9_choice_8 = rung9_equal_8 ? entry[2:0] : last_7;
  wire [2:0] last_7_next = rung9_unequal ? rung9_choice_8 : last_7;
  wire [3:0] rung9_sum = {1'b0, place} + 4'd1;
  wire [2:0] place_rung9 = rung9_unequal ? rung9_sum[2:0] : place;
  wire [15:0] rung9_sum_2 = kept + 16'd1;
  wire rung9_greater = rung9_sum_2 > 16'd8;
  wire [3:0] rung9_choice_9 = rung9_greater ? 4'd8 : rung9_sum_2[3:0];
  wire [15:0] kept_rung9 = rung9_unequal ? {12'b0, rung9_choice_9} : kept;

  // rung 10 "take the last entry back", cash_register.ladder:66

  // rung 11, cash_register.ladder:68
  wire rung11_equal = entry == 4'd15;
  wire rung11_unequal = kept_rung9 != 16'd0;
  wire rung11_power = cancel_last & ~cancel_last_before & ~paid_reg & rung11_equal & rung11_unequal;
  wire [15:0] rung11_difference = kept_rung9 - 16'd1;
  wire [15:0] kept_rung11 = rung11_power ? rung11_difference : kept_rung9;
  wire [3:0] rung11_sum = {1'b0, place_rung9} + 4'd8;
  wire [3:0] rung11_difference_2 = rung11_sum - 4'd1;
  wire [2:0] place_next = rung11_power ? rung11_difference_2[2:0] : place_rung9;
  wire [2:0] rung11_choice = place_next[0] ? last_1_next : last_0_next;
  wire [2:0] rung11_choice_2 = place_next[0] ? last_3_next : last_2_next;
  wire [2:0] rung11_choice_3 = place_next[0] ? last_5_next : last_4_next;
  wire [2:0] rung11_choice_4 = place_next[0] ? last_7_next : last_6_next;
  wire [2:0] rung11_choice_5 = place_next[1] ? rung11_choice_2 : rung11_choice;
  wire [2:0] rung11_choice_6 = place_next[1] ? rung11_choice_4 : rung11_choice_3;
  wire [2:0] rung11_choice_7 = place_next[2] ? rung11_choice_6 : rung11_choice_5;
  wire [3:0] cancelled = rung11_power ? {1'b0, rung11_choice_7} : 4'd15;

  // rung 12 "new order", cash_register.ladder:72
  wire [15:0] kept_next = new_order ? 16'd0 : kept_rung11;
  wire paid_rung12 = paid_reg & ~new_order;

  // rung 13 "count", cash_register.ladder:75
  wire count_combo_power = entry == 4'd0;
  wire count_combo_CD = cancelled == 4'd0;
  wire [15:0] count_combo_CV;
  cash_register_CTUD count_combo (
    .clk(clk),
    .rst(rst),
    .power(count_combo_power),
    .CD(count_combo_CD),
    .R(new_order),
    .CV(count_combo_CV)
  );

  // rung 14, cash_register.ladder:77
  wire count_double_power = entry == 4'd1;
  wire count_double_CD = cancelled == 4'd1;
  wire [15:0] count_double_CV;
  cash_register_CTUD count_double (
    .clk(clk),
    .rst(rst),
    .power(count_double_power),
    .CD(count_double_CD),
    .R(new_order),
    .CV(count_double_CV)
  );

  // rung 15, cash_register.ladder:78
  wire count_junior_power = entry == 4'd2;
  wire count_junior_CD = cancelled == 4'd2;
  wire [15:0] count_junior_CV;
  cash_register_CTUD count_junior (
    .clk(clk),
    .rst(rst),
    .power(count_junior_power),
    .CD(count_junior_CD),
    .R(new_order),
    .CV(count_junior_CV)
  );

  // rung 16, cash_register.ladder:79
  wire count_burger_power = entry == 4'd3;
  wire count_burger_CD = cancelled == 4'd3;
  wire [15:0] count_burger_CV;
  cash_register_CTUD count_burger (
    .clk(clk),
    .rst(rst),
    .power(count_burger_power),
    .CD(count_burger_CD),
    .R(new_order),
    .CV(count_burger_CV)
  );

  // rung 17, cash_register.ladder:80
  wire count_fries_power = entry == 4'd4;
  wire count_fries_CD = cancelled == 4'd4;
  wire [15:0] count_fries_CV;
  cash_register_CTUD count_fries (
    .clk(clk),
    .rst(rst),
    .power(count_fries_power),
    .CD(count_fries_CD),
    .R(new_order),
    .CV(count_fries_CV)
  );

  // rung 18, cash_register.ladder:81
  wire count_drink_power = entry == 4'd5;
  wire count_drink_CD = cancelled == 4'd5;
  wire [15:0] count_drink_CV;
  cash_register_CTUD count_drink (
    .clk(clk),
    .rst(rst),
    .power(count_drink_power),
    .CD(count_drink_CD),
    .R(new_order),
    .CV(count_drink_CV)
  );

  // rung 19 "a lamp in each key that was used", cash_register.ladder:83
  wire lamp_combo_next = $signed(count_combo_CV) > 16'sd0;

  // rung 20, cash_register.ladder:85
  wire lamp_double_next = $signed(count_double_CV) > 16'sd0;

  // rung 21, cash_register.ladder:86
  wire lamp_junior_next = $signed(count_junior_CV) > 16'sd0;

  // rung 22, cash_register.ladder:87
  wire lamp_burger_next = $signed(count_burger_CV) > 16'sd0;

  // rung 23, cash_register.ladder:88
  wire lamp_fries_next = $signed(count_fries_CV) > 16'sd0;

  // rung 24, cash_register.ladder:89
  wire lamp_drink_next = $signed(count_drink_CV) > 16'sd0;

  // rung 25 "burger, fries and drink cost what a combo costs", cash_register.ladder:91
  wire rung25_less = $signed(count_drink_CV) < $signed(count_fries_CV);
  wire [15:0] rung25_choice = rung25_less ? count_drink_CV : count_fries_CV;
  wire rung25_less_2 = $signed(rung25_choice) < $signed(count_burger_CV);
  wire [15:0] as_combo = rung25_less_2 ? rung25_choice : count_burger_CV;
  wire [31:0] rung25_extended = {{16{as_combo[15]}}, as_combo};

  // rung 26 "what the order costs", cash_register.ladder:94
  wire [31:0] rung26_extended = {{16{count_combo_CV[15]}}, count_combo_CV};
  wire [31:0] rung26_product = rung26_extended * 32'd899;
  wire [31:0] rung26_extended_2 = {{16{count_double_CV[15]}}, count_double_CV};
  wire [31:0] rung26_product_2 = rung26_extended_2 * 32'd1099;
  wire [31:0] rung26_sum = rung26_product + rung26_product_2;
  wire [31:0] rung26_extended_3 = {{16{count_junior_CV[15]}}, count_junior_CV};
  wire [31:0] rung26_product_3 = rung26_extended_3 * 32'd649;
  wire [31:0] subtotal_rung26 = rung26_sum + rung26_product_3;

  // rung 27, cash_register.ladder:97
  wire [31:0] rung27_extended = {{16{count_burger_CV[15]}}, count_burger_CV};
  wire [31:0] rung27_product = rung27_extended * 32'd549;
  wire [31:0] rung27_sum = subtotal_rung26 + rung27_product;
  wire [31:0] rung27_extended_2 = {{16{count_fries_CV[15]}}, count_fries_CV};
  wire [31:0] rung27_product_2 = rung27_extended_2 * 32'd279;
  wire [31:0] rung27_sum_2 = rung27_sum + rung27_product_2;
  wire [31:0] rung27_extended_3 = {{16{count_drink_CV[15]}}, count_drink_CV};
  wire [31:0] rung27_product_3 = rung27_extended_3 * 32'd229;
  wire [31:0] subtotal_rung27 = rung27_sum_2 + rung27_product_3;

  // rung 28, cash_register.ladder:100
  wire [31:0] rung28_product = rung25_extended * 32'd158;
  wire [31:0] subtotal_next = subtotal_rung27 - rung28_product;

  // rung 29 "6.25 % are a sixteenth, rounded to a cent", cash_register.ladder:102
  wire [31:0] tax_value = {{4{tax_reg[27]}}, tax_reg};

  // rung 30, cash_register.ladder:104
  wire [31:0] rung30_sum = subtotal_next + 32'd8;
  wire [31:0] rung30_sum_2 = rung30_sum + {28'b0, {4{rung30_sum[31]}}};
  wire [27:0] tax_next = ~to_go ? rung30_sum_2[31:4] : 28'd0;

  // rung 31, cash_register.ladder:105
  wire [31:0] total_next = subtotal_next + {{4{tax_next[27]}}, tax_next};

  // rung 32 "what it earns", cash_register.ladder:107
  wire [31:0] rung32_extended = {{16{count_combo_CV[15]}}, count_combo_CV};
  wire [31:0] rung32_product = rung32_extended * 32'd310;
  wire [31:0] rung32_extended_2 = {{16{count_double_CV[15]}}, count_double_CV};
  wire [31:0] rung32_product_2 = rung32_extended_2 * 32'd370;
  wire [31:0] rung32_sum = rung32_product + rung32_product_2;
  wire [31:0] rung32_extended_3 = {{16{count_junior_CV[15]}}, count_junior_CV};
  wire [31:0] rung32_product_3 = rung32_extended_3 * 32'd240;
  wire [31:0] earned_rung32 = rung32_sum + rung32_product_3;

  // rung 33, cash_register.ladder:110
  wire [31:0] rung33_extended = {{16{count_burger_CV[15]}}, count_burger_CV};
  wire [31:0] rung33_product = rung33_extended * 32'd150;
  wire [31:0] rung33_sum = earned_rung32 + rung33_product;
  wire [31:0] rung33_extended_2 = {{16{count_fries_CV[15]}}, count_fries_CV};
  wire [31:0] rung33_product_2 = rung33_extended_2 * 32'd170;
  wire [31:0] rung33_sum_2 = rung33_sum + rung33_product_2;
  wire [31:0] rung33_extended_3 = {{16{count_drink_CV[15]}}, count_drink_CV};
  wire [31:0] rung33_product_3 = rung33_extended_3 * 32'd140;
  wire [31:0] earned_rung33 = rung33_sum_2 + rung33_product_3;

  // rung 34, cash_register.ladder:113
  wire [31:0] rung34_product = rung25_extended * 32'd158;
  wire [31:0] earned = earned_rung33 - rung34_product;

  // rung 35 "paid: into the books of the day, once", cash_register.ladder:115
  wire rung35_greater = $signed(subtotal_next) > 32'sd0;
  wire rung35_power = total_key & ~total_key_before & ~paid_rung12 & rung35_greater;
  wire paid_next = rung35_power | paid_rung12;
  wire [31:0] rung35_sum = sold_0 + {{16{count_combo_CV[15]}}, count_combo_CV};
  wire [31:0] sold_0_rung35 = rung35_power ? rung35_sum : sold_0;
  wire [31:0] rung35_sum_2 = sold_1 + {{16{count_double_CV[15]}}, count_double_CV};
  wire [31:0] sold_1_rung35 = rung35_power ? rung35_sum_2 : sold_1;
  wire [31:0] rung35_sum_3 = sold_2 + {{16{count_junior_CV[15]}}, count_junior_CV};
  wire [31:0] sold_2_rung35 = rung35_power ? rung35_sum_3 : sold_2;
  wire [31:0] rung35_sum_4 = sold_3 + {{16{count_burger_CV[15]}}, count_burger_CV};
  wire [31:0] sold_3_rung35 = rung35_power ? rung35_sum_4 : sold_3;
  wire [31:0] rung35_sum_5 = sold_4 + {{16{count_fries_CV[15]}}, count_fries_CV};
  wire [31:0] sold_4_rung35 = rung35_power ? rung35_sum_5 : sold_4;
  wire [31:0] rung35_sum_6 = sold_5 + {{16{count_drink_CV[15]}}, count_drink_CV};
  wire [31:0] sold_5_rung35 = rung35_power ? rung35_sum_6 : sold_5;
  wire [31:0] rung35_sum_7 = profit_reg + earned;
  wire [31:0] profit_rung35 = rung35_power ? rung35_sum_7 : profit_reg;

  // rung 36 "new day", cash_register.ladder:124
  wire rung36_power = new_day & ~new_day_before;
  wire [31:0] profit_next = rung36_power ? 32'd0 : profit_rung35;
  wire [31:0] sold_0_next = rung36_power ? 32'd0 : sold_0_rung35;
  wire [31:0] sold_1_next = rung36_power ? 32'd0 : sold_1_rung35;
  wire [31:0] sold_2_next = rung36_power ? 32'd0 : sold_2_rung35;
  wire [31:0] sold_3_next = rung36_power ? 32'd0 : sold_3_rung35;
  wire [31:0] sold_4_next = rung36_power ? 32'd0 : sold_4_rung35;
  wire [31:0] sold_5_next = rung36_power ? 32'd0 : sold_5_rung35;

  assign lamp_combo = lamp_combo_reg;
  assign lamp_double = lamp_double_reg;
  assign lamp_junior = lamp_junior_reg;
  assign lamp_burger = lamp_burger_reg;
  assign lamp_fries = lamp_fries_reg;
  assign lamp_drink = lamp_drink_reg;
  assign subtotal = subtotal_reg;
  assign tax = tax_value;
  assign total = total_reg;
  assign paid = paid_reg;
  assign sold[31:0] = sold_0;
  assign sold[63:32] = sold_1;
  assign sold[95:64] = sold_2;
  assign sold[127:96] = sold_3;
  assign sold[159:128] = sold_4;
  assign sold[191:160] = sold_5;
  assign profit = profit_reg;

  always @(posedge clk) begin
    if (rst) begin
      key_drink_before <= 1'b0;
      key_fries_before <= 1'b0;
      key_burger_before <= 1'b0;
      key_junior_before <= 1'b0;
      key_double_before <= 1'b0;
      key_combo_before <= 1'b0;
      paid_reg <= 1'b0;
      place <= 3'd0;
      last_0 <= 3'd0;
      last_1 <= 3'd0;
      last_2 <= 3'd0;
      last_3 <= 3'd0;
      last_4 <= 3'd0;
      last_5 <= 3'd0;
      last_6 <= 3'd0;
      last_7 <= 3'd0;
      kept <= 16'd0;
      cancel_last_before <= 1'b0;
      subtotal_reg <= 32'd0;
      tax_reg <= 28'd0;
      total_reg <= 32'd0;
      total_key_before <= 1'b0;
      sold_0 <= 32'd0;
      sold_1 <= 32'd0;
      sold_2 <= 32'd0;
      sold_3 <= 32'd0;
      sold_4 <= 32'd0;
      sold_5 <= 32'd0;
      profit_reg <= 32'd0;
      new_day_before <= 1'b0;
      lamp_combo_reg <= 1'b0;
      lamp_double_reg <= 1'b0;
      lamp_junior_reg <= 1'b0;
      lamp_burger_reg <= 1'b0;
      lamp_fries_reg <= 1'b0;
      lamp_drink_reg <= 1'b0;
    end else begin
      key_drink_before <= key_drink;
      key_fries_before <= key_fries;
      key_burger_before <= key_burger;
      key_junior_before <= key_junior;
      key_double_before <= key_double;
      key_combo_before <= key_combo;
      paid_reg <= paid_next;
      place <= place_next;
      last_0 <= last_0_next;
      last_1 <= last_1_next;
      last_2 <= last_2_next;
      last_3 <= last_3_next;
      last_4 <= last_4_next;
      last_5 <= last_5_next;
      last_6 <= last_6_next;
      last_7 <= last_7_next;
      kept <= kept_next;
      cancel_last_before <= cancel_last;
      subtotal_reg <= subtotal_next;
      tax_reg <= tax_next;
      total_reg <= total_next;
      total_key_before <= total_key;
      sold_0 <= sold_0_next;
      sold_1 <= sold_1_next;
      sold_2 <= sold_2_next;
      sold_3 <= sold_3_next;
      sold_4 <= sold_4_next;
      sold_5 <= sold_5_next;
      profit_reg <= profit_next;
      new_day_before <= new_day;
      lamp_combo_reg <= lamp_combo_next;
      lamp_double_reg <= lamp_double_next;
      lamp_junior_reg <= lamp_junior_next;
      lamp_burger_reg <= lamp_burger_next;
      lamp_fries_reg <= lamp_fries_next;
      lamp_drink_reg <= lamp_drink_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick, rung9_sum, rung11_difference_2, rung30_sum_2};
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
