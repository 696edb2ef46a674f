// Made by hotrail 0.1.0 from parts_average.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// CTU: up counter
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module parts_average_CTU (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        clear_after,
  output wire [14:0] CV
);
  reg [14:0] CV_reg = 15'd0;
  reg was = 1'b0;

  wire unequal = CV_reg != 15'd32767;
  wire [14:0] CV_value = CV_reg + {14'b0, power & ~was & unequal};
  wire [14:0] CV_next = clear_after ? 15'd0 : CV_value;

  assign CV = CV_value;

  always @(posedge clk) begin
    if (rst) begin
      CV_reg <= 15'd0;
      was <= 1'b0;
    end else begin
      CV_reg <= CV_next;
      was <= power;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to power = 1, PT = 60 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module parts_average_TON_power1_PT60 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire clear_after,
  output wire Q
);
  reg [5:0] ET = 6'd0;
  reg was = 1'b0;

  wire equal = ET == 6'd60;
  wire [5:0] sum = ET + {5'b0, tick & ~equal};
  wire [5:0] choice = was ? sum : 6'd0;
  wire equal_2 = ET == 6'd59;
  wire [5:0] ET_next = clear_after ? 6'd0 : choice;

  assign Q = was & (tick & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ET <= 6'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= 1'b1;
    end
  end
endmodule

module parts_average (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        sensor,
  output wire [15:0] last_minute,
  output wire [15:0] average_10,
  output wire [15:0] average_60
);
  reg [14:0] last_minute_reg = 15'd0;
  reg [5:0] newest = 6'd0;
  reg [15:0] tenth = 16'd0;
  reg [15:0] sum_10 = 16'd0;
  reg [14:0] minutes_0 = 15'd0;
  reg [14:0] minutes_1 = 15'd0;
  reg [14:0] minutes_2 = 15'd0;
  reg [14:0] minutes_3 = 15'd0;
  reg [14:0] minutes_4 = 15'd0;
  reg [14:0] minutes_5 = 15'd0;
  reg [14:0] minutes_6 = 15'd0;
  reg [14:0] minutes_7 = 15'd0;
  reg [14:0] minutes_8 = 15'd0;
  reg [14:0] minutes_9 = 15'd0;
  reg [14:0] minutes_10 = 15'd0;
  reg [14:0] minutes_11 = 15'd0;
  reg [14:0] minutes_12 = 15'd0;
  reg [14:0] minutes_13 = 15'd0;
  reg [14:0] minutes_14 = 15'd0;
  reg [14:0] minutes_15 = 15'd0;
  reg [14:0] minutes_16 = 15'd0;
  reg [14:0] minutes_17 = 15'd0;
  reg [14:0] minutes_18 = 15'd0;
  reg [14:0] minutes_19 = 15'd0;
  reg [14:0] minutes_20 = 15'd0;
  reg [14:0] minutes_21 = 15'd0;
  reg [14:0] minutes_22 = 15'd0;
  reg [14:0] minutes_23 = 15'd0;
  reg [14:0] minutes_24 = 15'd0;
  reg [14:0] minutes_25 = 15'd0;
  reg [14:0] minutes_26 = 15'd0;
  reg [14:0] minutes_27 = 15'd0;
  reg [14:0] minutes_28 = 15'd0;
  reg [14:0] minutes_29 = 15'd0;
  reg [14:0] minutes_30 = 15'd0;
  reg [14:0] minutes_31 = 15'd0;
  reg [14:0] minutes_32 = 15'd0;
  reg [14:0] minutes_33 = 15'd0;
  reg [14:0] minutes_34 = 15'd0;
  reg [14:0] minutes_35 = 15'd0;
  reg [14:0] minutes_36 = 15'd0;
  reg [14:0] minutes_37 = 15'd0;
  reg [14:0] minutes_38 = 15'd0;
  reg [14:0] minutes_39 = 15'd0;
  reg [14:0] minutes_40 = 15'd0;
  reg [14:0] minutes_41 = 15'd0;
  reg [14:0] minutes_42 = 15'd0;
  reg [14:0] minutes_43 = 15'd0;
  reg [14:0] minutes_44 = 15'd0;
  reg [14:0] minutes_45 = 15'd0;
  reg [14:0] minutes_46 = 15'd0;
  reg [14:0] minutes_47 = 15'd0;
  reg [14:0] minutes_48 = 15'd0;
  reg [14:0] minutes_49 = 15'd0;
  reg [14:0] minutes_50 = 15'd0;
  reg [14:0] minutes_51 = 15'd0;
  reg [14:0] minutes_52 = 15'd0;
  reg [14:0] minutes_53 = 15'd0;
  reg [14:0] minutes_54 = 15'd0;
  reg [14:0] minutes_55 = 15'd0;
  reg [14:0] minutes_56 = 15'd0;
  reg [14:0] minutes_57 = 15'd0;
  reg [14:0] minutes_58 = 15'd0;
  reg [14:0] minutes_59 = 15'd0;
  reg [15:0] sum_60 = 16'd0;
  reg [3:0] known_10 = 4'd0;
  reg [15:0] average_10_reg = 16'd0;
  reg [5:0] known_60 = 6'd0;
  reg [15:0] average_60_reg = 16'd0;

  // rung 1 "parts of the minute that runs", parts_average.ladder:22
  wire [14:0] count_CV;

  // rung 2 "a minute is over", parts_average.ladder:25
  wire minute_Q;
  parts_average_CTU count (
    .clk(clk),
    .rst(rst),
    .power(sensor),
    .clear_after(minute_Q),
    .CV(count_CV)
  );
  parts_average_TON_power1_PT60 minute (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .clear_after(minute_Q),
    .Q(minute_Q)
  );
  wire [15:0] last_minute_value = {1'b0, last_minute_reg};
  wire [14:0] last_minute_next = minute_Q ? count_CV : last_minute_reg;
  wire [15:0] rung2_extended = {1'b0, last_minute_next};

  // rung 3 "the oldest minute leaves its sum, the last one comes in", parts_average.ladder:28
  wire [6:0] rung3_difference = {1'b0, newest} - 7'd10;
  wire [15:0] tenth_rung3 = minute_Q ? {{9{rung3_difference[6]}}, rung3_difference} : tenth;

  // rung 4, parts_average.ladder:30
  wire rung4_less = $signed(tenth_rung3) < 16'sd0;
  wire [15:0] rung4_sum = tenth_rung3 + 16'd60;
  wire [15:0] tenth_next = rung4_less ? rung4_sum : tenth_rung3;

  // rung 5, parts_average.ladder:31
  wire [14:0] rung5_choice = tenth_next[0] ? minutes_1 : minutes_0;
  wire [14:0] rung5_choice_2 = tenth_next[0] ? minutes_3 : minutes_2;
  wire [14:0] rung5_choice_3 = tenth_next[0] ? minutes_5 : minutes_4;
  wire [14:0] rung5_choice_4 = tenth_next[0] ? minutes_7 : minutes_6;
  wire [14:0] rung5_choice_5 = tenth_next[0] ? minutes_9 : minutes_8;
  wire [14:0] rung5_choice_6 = tenth_next[0] ? minutes_11 : minutes_10;
  wire [14:0] rung5_choice_7 = tenth_next[0] ? minutes_13 : minutes_12;
  wire [14:0] rung5_choice_8 = tenth_next[0] ? minutes_15 : minutes_14;
  wire [14:0] rung5_choice_9 = tenth_next[0] ? minutes_17 : minutes_16;
  wire [14:0] rung5_choice_10 = tenth_next[0] ? minutes_19 : minutes_18;
  wire [14:0] rung5_choice_11 = tenth_next[0] ? minutes_21 : minutes_20;
  wire [14:0] rung5_choice_12 = tenth_next[0] ? minutes_23 : minutes_22;
  wire [14:0] rung5_choice_13 = tenth_next[0] ? minutes_25 : minutes_24;
  wire [14:0] rung5_choice_14 = tenth_next[0] ? minutes_27 : minutes_26;
  wire [14:0] rung5_choice_15 = tenth_next[0] ? minutes_29 : minutes_28;
  wire [14:0] rung5_choice_16 = tenth_next[0] ? minutes_31 : minutes_30;
  wire [14:0] rung5_choice_17 = tenth_next[0] ? minutes_33 : minutes_32;
  wire [14:0] rung5_choice_18 = tenth_next[0] ? minutes_35 : minutes_34;
  wire [14:0] rung5_choice_19 = tenth_next[0] ? minutes_37 : minutes_36;
  wire [14:0] rung5_choice_20 = tenth_next[0] ? minutes_39 : minutes_38;
  wire [14:0] rung5_choice_21 = tenth_next[0] ? minutes_41 : minutes_40;
  wire [14:0] rung5_choice_22 = tenth_next[0] ? minutes_43 : minutes_42;
  wire [14:0] rung5_choice_23 = tenth_next[0] ? minutes_45 : minutes_44;
  wire [14:0] rung5_choice_24 = tenth_next[0] ? minutes_47 : minutes_46;
  wire [14:0] rung5_choice_25 = tenth_next[0] ? minutes_49 : minutes_48;
  wire [14:0] rung5_choice_26 = tenth_next[0] ? minutes_51 : minutes_50;
  wire [14:0] rung5_choice_27 = tenth_next[0] ? minutes_53 : minutes_52;
  wire [14:0] rung5_choice_28 = tenth_next[0] ? minutes_55 : minutes_54;
  wire [14:0] rung5_choice_29 = tenth_next[0] ? minutes_57 : minutes_56;
  wire [14:0] rung5_choice_30 = tenth_next[0] ? minutes_59 : minutes_58;
  wire [14:0] rung5_choice_31 = tenth_next[1] ? rung5_choice_2 : rung5_choice;
  wire [14:0] rung5_choice_32 = tenth_next[1] ? rung5_choice_4 : rung5_choice_3;
  wire [14:0] rung5_choice_33 = tenth_next[1] ? rung5_choice_6 : rung5_choice_5;
  wire [14:0] rung5_choice_34 = tenth_next[1] ? rung5_choice_8 : rung5_choice_7;
  wire [14:0] rung5_choice_35 = tenth_next[1] ? rung5_choice_10 : rung5_choice_9;
  wire [14:0] rung5_choice_36 = tenth_next[1] ? rung5_choice_12 : rung5_choice_11;
  wire [14:0] rung5_choice_37 = tenth_next[1] ? rung5_choice_14 : rung5_choice_13;
  wire [14:0] rung5_choice_38 = tenth_next[1] ? rung5_choice_16 : rung5_choice_15;
  wire [14:0] rung5_choice_39 = tenth_next[1] ? rung5_choice_18 : rung5_choice_17;
  wire [14:0] rung5_choice_40 = tenth_next[1] ? rung5_choice_20 : rung5_choice_19;
  wire [14:0] rung5_choice_41 = tenth_next[1] ? rung5_choice_22 : rung5_choice_21;
  wire [14:0] rung5_choice_42 = tenth_next[1] ? rung5_choice_24 : rung5_choice_23;
  wire [14:0] rung5_choice_43 = tenth_next[1] ? rung5_choice_26 : rung5_choice_25;
  wire [14:0] rung5_choice_44 = tenth_next[1] ? rung5_choice_28 : rung5_choice_27;
  wire [14:0] rung5_choice_45 = tenth_next[1] ? rung5_choice_30 : rung5_choice_29;
  wire [14:0] rung5_choice_46 = tenth_next[2] ? rung5_choice_32 : rung5_choice_31;
  wire [14:0] rung5_choice_47 = tenth_next[2] ? rung5_choice_34 : rung5_choice_33;
  wire [14:0] rung5_choice_48 = tenth_next[2] ? rung5_choice_36 : rung5_choice_35;
  wire [14:0] rung5_choice_49 = tenth_next[2] ? rung5_choice_38 : rung5_choice_37;
  wire [14:0] rung5_choice_50 = tenth_next[2] ? rung5_choice_40 : rung5_choice_39;
  wire [14:0] rung5_choice_51 = tenth_next[2] ? rung5_choice_42 : rung5_choice_41;
  wire [14:0] rung5_choice_52 = tenth_next[2] ? rung5_choice_44 : rung5_choice_43;
  wire [14:0] rung5_choice_53 = tenth_next[3] ? rung5_choice_47 : rung5_choice_46;
  wire [14:0] rung5_choice_54 = tenth_next[3] ? rung5_choice_49 : rung5_choice_48;
  wire [14:0] rung5_choice_55 = tenth_next[3] ? rung5_choice_51 : rung5_choice_50;
  wire [14:0] rung5_choice_56 = tenth_next[3] ? rung5_choice_45 : rung5_choice_52;
  wire [14:0] rung5_choice_57 = tenth_next[4] ? rung5_choice_54 : rung5_choice_53;
  wire [14:0] rung5_choice_58 = tenth_next[4] ? rung5_choice_56 : rung5_choice_55;
  wire [14:0] rung5_choice_59 = tenth_next[5] ? rung5_choice_58 : rung5_choice_57;
  wire rung5_less = tenth_next < 16'd60;
  wire [14:0] rung5_choice_60 = rung5_less ? rung5_choice_59 : 15'd0;
  wire [15:0] rung5_difference = sum_10 - {1'b0, rung5_choice_60};
  wire [15:0] rung5_sum = rung5_difference + rung2_extended;
  wire [15:0] sum_10_next = minute_Q ? rung5_sum : sum_10;

  // rung 6, parts_average.ladder:32
  wire [14:0] rung6_choice = newest[0] ? minutes_1 : minutes_0;
  wire [14:0] rung6_choice_2 = newest[0] ? minutes_3 : minutes_2;
  wire [14:0] rung6_choice_3 = newest[0] ? minutes_5 : minutes_4;
  wire [14:0] rung6_choice_4 = newest[0] ? minutes_7 : minutes_6;
  wire [14:0] rung6_choice_5 = newest[0] ? minutes_9 : minutes_8;
  wire [14:0] rung6_choice_6 = newest[0] ? minutes_11 : minutes_10;
  wire [14:0] rung6_choice_7 = newest[0] ? minutes_13 : minutes_12;
  wire [14:0] rung6_choice_8 = newest[0] ? minutes_15 : minutes_14;
  wire [14:0] rung6_choice_9 = newest[0] ? minutes_17 : minutes_16;
  wire [14:0] rung6_choice_10 = newest[0] ? minutes_19 : minutes_18;
  wire [14:0] rung6_choice_11 = newest[0] ? minutes_21 : minutes_20;
  wire [14:0] rung6_choice_12 = newest[0] ? minutes_23 : minutes_22;
  wire [14:0] rung6_choice_13 = newest[0] ? minutes_25 : minutes_24;
  wire [14:0] rung6_choice_14 = newest[0] ? minutes_27 : minutes_26;
  wire [14:0] rung6_choice_15 = newest[0] ? minutes_29 : minutes_28;
  wire [14:0] rung6_choice_16 = newest[0] ? minutes_31 : minutes_30;
  wire [14:0] rung6_choice_17 = newest[0] ? minutes_33 : minutes_32;
  wire [14:0] rung6_choice_18 = newest[0] ? minutes_35 : minutes_34;
  wire [14:0] rung6_choice_19 = newest[0] ? minutes_37 : minutes_36;
  wire [14:0] rung6_choice_20 = newest[0] ? minutes_39 : minutes_38;
  wire [14:0] rung6_choice_21 = newest[0] ? minutes_41 : minutes_40;
  wire [14:0] rung6_choice_22 = newest[0] ? minutes_43 : minutes_42;
  wire [14:0] rung6_choice_23 = newest[0] ? minutes_45 : minutes_44;
  wire [14:0] rung6_choice_24 = newest[0] ? minutes_47 : minutes_46;
  wire [14:0] rung6_choice_25 = newest[0] ? minutes_49 : minutes_48;
  wire [14:0] rung6_choice_26 = newest[0] ? minutes_51 : minutes_50;
  wire [14:0] rung6_choice_27 = newest[0] ? minutes_53 : minutes_52;
  wire [14:0] rung6_choice_28 = newest[0] ? minutes_55 : minutes_54;
  wire [14:0] rung6_choice_29 = newest[0] ? minutes_57 : minutes_56;
  wire [14:0] rung6_choice_30 = newest[0] ? minutes_59 : minutes_58;
  wire [14:0] rung6_choice_31 = newest[1] ? rung6_choice_2 : rung6_choice;
  wire [14:0] rung6_choice_32 = newest[1] ? rung6_choice_4 : rung6_choice_3;
  wire [14:0] rung6_choice_33 = newest[1] ? rung6_choice_6 : rung6_choice_5;
  wire [14:0] rung6_choice_34 = newest[1] ? rung6_choice_8 : rung6_choice_7;
  wire [14:0] rung6_choice_35 = newest[1] ? rung6_choice_10 : rung6_choice_9;
  wire [14:0] rung6_choice_36 = newest[1] ? rung6_choice_12 : rung6_choice_11;
  wire [14:0] rung6_choice_37 = newest[1] ? rung6_choice_14 : rung6_choice_13;
  wire [14:0] rung6_choice_38 = newest[1] ? rung6_choice_16 : rung6_choice_15;
  wire [14:0] rung6_choice_39 = newest[1] ? rung6_choice_18 : rung6_choice_17;
  wire [14:0] rung6_choice_40 = newest[1] ? rung6_choice_20 : rung6_choice_19;
  wire [14:0] rung6_choice_41 = newest[1] ? rung6_choice_22 : rung6_choice_21;
  wire [14:0] rung6_choice_42 = newest[1] ? rung6_choice_24 : rung6_choice_23;
  wire [14:0] rung6_choice_43 = newest[1] ? rung6_choice_26 : rung6_choice_25;
  wire [14:0] rung6_choice_44 = newest[1] ? rung6_choice_28 : rung6_choice_27;
  wire [14:0] rung6_choice_45 = newest[1] ? rung6_choice_30 : rung6_choice_29;
  wire [14:0] rung6_choice_46 = newest[2] ? rung6_choice_32 : rung6_choice_31;
  wire [14:0] rung6_choice_47 = newest[2] ? rung6_choice_34 : rung6_choice_33;
  wire [14:0] rung6_choice_48 = newest[2] ? rung6_choice_36 : rung6_choice_35;
  wire [14:0] rung6_choice_49 = newest[2] ? rung6_choice_38 : rung6_choice_37;
  wire [14:0] rung6_choice_50 = newest[2] ? rung6_choice_40 : rung6_choice_39;
  wire [14:0] rung6_choice_51 = newest[2] ? rung6_choice_42 : rung6_choice_41;
  wire [14:0] rung6_choice_52 = newest[2] ? rung6_choice_44 : rung6_choice_43;
  wire [14:0] rung6_choice_53 = newest[3] ? rung6_choice_47 : rung6_choice_46;
  wire [14:0] rung6_choice_54 = newest[3] ? rung6_choice_49 : rung6_choice_48;
  wire [14:0] rung6_choice_55 = newest[3] ? rung6_choice_51 : rung6_choice_50;
  wire [14:0] rung6_choice_56 = newest[3] ? rung6_choice_45 : rung6_choice_52;
  wire [14:0] rung6_choice_57 = newest[4] ? rung6_choice_54 : rung6_choice_53;
  wire [14:0] rung6_choice_58 = newest[4] ? rung6_choice_56 : rung6_choice_55;
  wire [14:0] rung6_choice_59 = newest[5] ? rung6_choice_58 : rung6_choice_57;
  wire [15:0] rung6_difference = sum_60 - {1'b0, rung6_choice_59};
  wire [15:0] rung6_sum = rung6_difference + rung2_extended;
  wire [15:0] sum_60_next = minute_Q ? rung6_sum : sum_60;

  // rung 7 "it is kept for an hour", parts_average.ladder:34
  wire rung7_equal = newest == 6'd0;
  wire [14:0] rung7_choice = rung7_equal ? count_CV : minutes_0;
  wire [14:0] minutes_0_next = minute_Q ? rung7_choice : minutes_0;
  wire rung7_equal_2 = newest == 6'd1;
  wire [14:0] rung7_choice_2 = rung7_equal_2 ? count_CV : minutes_1;
  wire [14:0] minutes_1_next = minute_Q ? rung7_choice_2 : minutes_1;
  wire rung7_equal_3 = newest == 6'd2;
  wire [14:0] rung7_choice_3 = rung7_equal_3 ? count_CV : minutes_2;
  wire [14:0] minutes_2_next = minute_Q ? rung7_choice_3 : minutes_2;
  wire rung7_equal_4 = newest == 6'd3;
  wire [14:0] rung7_choice_4 = rung7_equal_4 ? count_CV : minutes_3;
  wire [14:0] minutes_3_next = minute_Q ? rung7_choice_4 : minutes_3;
  wire rung7_equal_5 = newest == 6'd4;
  wire [14:0] rung7_choice_5 = rung7_equal_5 ? count_CV : minutes_4;
  wire [14:0] minutes_4_next = minute_Q ? rung7_choice_5 : minutes_4;
  wire rung7_equal_6 = newest == 6'd5;
  wire [14:0] rung7_choice_6 = rung7_equal_6 ? count_CV : minutes_5;
  wire [14:0] minutes_5_next = minute_Q ? rung7_choice_6 : minutes_5;
  wire rung7_equal_7 = newest == 6'd6;
  wire [14:0] rung7_choice_7 = rung7_equal_7 ? count_CV : minutes_6;
  wire [14:0] minutes_6_next = minute_Q ? rung7_choice_7 : minutes_6;
  wire rung7_equal_8 = newest == 6'd7;
  wire [14:0] rung7_choice_8 = rung7_equal_8 ? count_CV : minutes_7;
  wire [14:0] minutes_7_next = minute_Q ? rung7_choice_8 : minutes_7;
  wire rung7_equal_9 = newest == 6'd8;
  wire [14:0] rung7_choice_9 = rung7_equal_9 ? count_CV : minutes_8;
  wire [14:0] minutes_8_next = minute_Q ? rung7_choice_9 : minutes_8;
  wire rung7_equal_10 = newest == 6'd9;
  wire [14:0] rung7_choice_10 = rung7_equal_10 ? count_CV : minutes_9;
  wire [14:0] minutes_9_next = minute_Q ? rung7_choice_10 : minutes_9;
  wire rung7_equal_11 = newest == 6'd10;
  wire [14:0] rung7_choice_11 = rung7_equal_11 ? count_CV : minutes_10;
  wire [14:0] minutes_10_next = minute_Q ? rung7_choice_11 : minutes_10;
  wire rung7_equal_12 = newest == 6'd11;
  wire [14:0] rung7_choice_12 = rung7_equal_12 ? count_CV : minutes_11;
  wire [14:0] minutes_11_next = minute_Q ? rung7_choice_12 : minutes_11;
  wire rung7_equal_13 = newest == 6'd12;
  wire [14:0] rung7_choice_13 = rung7_equal_13 ? count_CV : minutes_12;
  wire [14:0] minutes_12_next = minute_Q ? rung7_choice_13 : minutes_12;
  wire rung7_equal_14 = newest == 6'd13;
  wire [14:0] rung7_choice_14 = rung7_equal_14 ? count_CV : minutes_13;
  wire [14:0] minutes_13_next = minute_Q ? rung7_choice_14 : minutes_13;
  wire rung7_equal_15 = newest == 6'd14;
  wire [14:0] rung7_choice_15 = rung7_equal_15 ? count_CV : minutes_14;
  wire [14:0] minutes_14_next = minute_Q ? rung7_choice_15 : minutes_14;
  wire rung7_equal_16 = newest == 6'd15;
  wire [14:0] rung7_choice_16 = rung7_equal_16 ? count_CV : minutes_15;
  wire [14:0] minutes_15_next = minute_Q ? rung7_choice_16 : minutes_15;
  wire rung7_equal_17 = newest == 6'd16;
  wire [14:0] rung7_choice_17 = rung7_equal_17 ? count_CV : minutes_16;
  wire [14:0] minutes_16_next = minute_Q ? rung7_choice_17 : minutes_16;
  wire rung7_equal_18 = newest == 6'd17;
  wire [14:0] rung7_choice_18 = rung7_equal_18 ? count_CV : minutes_17;
  wire [14:0] minutes_17_next = minute_Q ? rung7_choice_18 : minutes_17;
  wire rung7_equal_19 = newest == 6'd18;
  wire [14:0] rung7_choice_19 = rung7_equal_19 ? count_CV : minutes_18;
  wire [14:0] minutes_18_next = minute_Q ? rung7_choice_19 : minutes_18;
  wire rung7_equal_20 = newest == 6'd19;
  wire [14:0] rung7_choice_20 = rung7_equal_20 ? count_CV : minutes_19;
  wire [14:0] minutes_19_next = minute_Q ? rung7_choice_20 : minutes_19;
  wire rung7_equal_21 = newest == 6'd20;
  wire [14:0] rung7_choice_21 = rung7_equal_21 ? count_CV : minutes_20;
  wire [14:0] minutes_20_next = minute_Q ? rung7_choice_21 : minutes_20;
  wire rung7_equal_22 = newest == 6'd21;
  wire [14:0] rung7_choice_22 = rung7_equal_22 ? count_CV : minutes_21;
  wire [14:0] minutes_21_next = minute_Q ? rung7_choice_22 : minutes_21;
  wire rung7_equal_23 = newest == 6'd22;
  wire [14:0] rung7_choice_23 = rung7_equal_23 ? count_CV : minutes_22;
  wire [14:0] minutes_22_next = minute_Q ? rung7_choice_23 : minutes_22;
  wire rung7_equal_24 = newest == 6'd23;
  wire [14:0] rung7_choice_24 = rung7_equal_24 ? count_CV : minutes_23;
  wire [14:0] minutes_23_next = minute_Q ? rung7_choice_24 : minutes_23;
  wire rung7_equal_25 = newest == 6'd24;
  wire [14:0] rung7_choice_25 = rung7_equal_25 ? count_CV : minutes_24;
  wire [14:0] minutes_24_next = minute_Q ? rung7_choice_25 : minutes_24;
  wire rung7_equal_26 = newest == 6'd25;
  wire [14:0] rung7_choice_26 = rung7_equal_26 ? count_CV : minutes_25;
  wire [14:0] minutes_25_next = minute_Q ? rung7_choice_26 : minutes_25;
  wire rung7_equal_27 = newest == 6'd26;
  wire [14:0] rung7_choice_27 = rung7_equal_27 ? count_CV : minutes_26;
  wire [14:0] minutes_26_next = minute_Q ? rung7_choice_27 : minutes_26;
  wire rung7_equal_28 = newest == 6'd27;
  wire [14:0] rung7_choice_28 = rung7_equal_28 ? count_CV : minutes_27;
  wire [14:0] minutes_27_next = minute_Q ? rung7_choice_28 : minutes_27;
  wire rung7_equal_29 = newest == 6'd28;
  wire [14:0] rung7_choice_29 = rung7_equal_29 ? count_CV : minutes_28;
  wire [14:0] minutes_28_next = minute_Q ? rung7_choice_29 : minutes_28;
  wire rung7_equal_30 = newest == 6'd29;
  wire [14:0] rung7_choice_30 = rung7_equal_30 ? count_CV : minutes_29;
  wire [14:0] minutes_29_next = minute_Q ? rung7_choice_30 : minutes_29;
  wire rung7_equal_31 = newest == 6'd30;
  wire [14:0] rung7_choice_31 = rung7_equal_31 ? count_CV : minutes_30;
  wire [14:0] minutes_30_next = minute_Q ? rung7_choice_31 : minutes_30;
  wire rung7_equal_32 = newest == 6'd31;
  wire [14:0] rung7_choice_32 = rung7_equal_32 ? count_CV : minutes_31;
  wire [14:0] minutes_31_next = minute_Q ? rung7_choice_32 : minutes_31;
  wire rung7_equal_33 = newest == 6'd32;
  wire [14:0] rung7_choice_33 = rung7_equal_33 ? count_CV : minutes_32;
  wire [14:0] minutes_32_next = minute_Q ? rung7_choice_33 : minutes_32;
  wire rung7_equal_34 = newest == 6'd33;
  wire [14:0] rung7_choice_34 = rung7_equal_34 ? count_CV : minutes_33;
  wire [14:0] minutes_33_next = minute_Q ? rung7_choice_34 : minutes_33;
  wire rung7_equal_35 = newest == 6'd34;
  wire [14:0] rung7_choice_35 = rung7_equal_35 ? count_CV : minutes_34;
  wire [14:0] minutes_34_next = minute_Q ? rung7_choice_35 : minutes_34;
  wire rung7_equal_36 = newest == 6'd35;
  wire [14:0] rung7_choice_36 = rung7_equal_36 ? count_CV : minutes_35;
  wire [14:0] minutes_35_next = minute_Q ? rung7_choice_36 : minutes_35;
  wire rung7_equal_37 = newest == 6'd36;
  wire [14:0] rung7_choice_37 = rung7_equal_37 ? count_CV : minutes_36;
  wire [14:0] minutes_36_next = minute_Q ? rung7_choice_37 : minutes_36;
  wire rung7_equal_38 = newest == 6'd37;
  wire [14:0] rung7_choice_38 = rung7_equal_38 ? count_CV : minutes_37;
  wire [14:0] minutes_37_next = minute_Q ? rung7_choice_38 : minutes_37;
  wire rung7_equal_39 = newest == 6'd38;
  wire [14:0] rung7_choice_39 = rung7_equal_39 ? count_CV : minutes_38;
  wire [14:0] minutes_38_next = minute_Q ? rung7_choice_39 : minutes_38;
  wire rung7_equal_40 = newest == 6'd39;
  wire [14:0] rung7_choice_40 = rung7_equal_40 ? count_CV : minutes_39;
  wire [14:0] minutes_39_next = minute_Q ? rung7_choice_40 : minutes_39;
  wire rung7_equal_41 = newest == 6'd40;
  wire [14:0] rung7_choice_41 = rung7_equal_41 ? count_CV : minutes_40;
  wire [14:0] minutes_40_next = minute_Q ? rung7_choice_41 : minutes_40;
  wire rung7_equal_42 = newest == 6'd41;
  wire [14:0] rung7_choice_42 = rung7_equal_42 ? count_CV : minutes_41;
  wire [14:0] minutes_41_next = minute_Q ? rung7_choice_42 : minutes_41;
  wire rung7_equal_43 = newest == 6'd42;
  wire [14:0] rung7_choice_43 = rung7_equal_43 ? count_CV : minutes_42;
  wire [14:0] minutes_42_next = minute_Q ? rung7_choice_43 : minutes_42;
  wire rung7_equal_44 = newest == 6'd43;
  wire [14:0] rung7_choice_44 = rung7_equal_44 ? count_CV : minutes_43;
  wire [14:0] minutes_43_next = minute_Q ? rung7_choice_44 : minutes_43;
  wire rung7_equal_45 = newest == 6'd44;
  wire [14:0] rung7_choice_45 = rung7_equal_45 ? count_CV : minutes_44;
  wire [14:0] minutes_44_next = minute_Q ? rung7_choice_45 : minutes_44;
  wire rung7_equal_46 = newest == 6'd45;
  wire [14:0] rung7_choice_46 = rung7_equal_46 ? count_CV : minutes_45;
  wire [14:0] minutes_45_next = minute_Q ? rung7_choice_46 : minutes_45;
  wire rung7_equal_47 = newest == 6'd46;
  wire [14:0] rung7_choice_47 = rung7_equal_47 ? count_CV : minutes_46;
  wire [14:0] minutes_46_next = minute_Q ? rung7_choice_47 : minutes_46;
  wire rung7_equal_48 = newest == 6'd47;
  wire [14:0] rung7_choice_48 = rung7_equal_48 ? count_CV : minutes_47;
  wire [14:0] minutes_47_next = minute_Q ? rung7_choice_48 : minutes_47;
  wire rung7_equal_49 = newest == 6'd48;
  wire [14:0] rung7_choice_49 = rung7_equal_49 ? count_CV : minutes_48;
  wire [14:0] minutes_48_next = minute_Q ? rung7_choice_49 : minutes_48;
  wire rung7_equal_50 = newest == 6'd49;
  wire [14:0] rung7_choice_50 = rung7_equal_50 ? count_CV : minutes_49;
  wire [14:0] minutes_49_next = minute_Q ? rung7_choice_50 : minutes_49;
  wire rung7_equal_51 = newest == 6'd50;
  wire [14:0] rung7_choice_51 = rung7_equal_51 ? count_CV : minutes_50;
  wire [14:0] minutes_50_next = minute_Q ? rung7_choice_51 : minutes_50;
  wire rung7_equal_52 = newest == 6'd51;
  wire [14:0] rung7_choice_52 = rung7_equal_52 ? count_CV : minutes_51;
  wire [14:0] minutes_51_next = minute_Q ? rung7_choice_52 : minutes_51;
  wire rung7_equal_53 = newest == 6'd52;
  wire [14:0] rung7_choice_53 = rung7_equal_53 ? count_CV : minutes_52;
  wire [14:0] minutes_52_next = minute_Q ? rung7_choice_53 : minutes_52;
  wire rung7_equal_54 = newest == 6'd53;
  wire [14:0] rung7_choice_54 = rung7_equal_54 ? count_CV : minutes_53;
  wire [14:0] minutes_53_next = minute_Q ? rung7_choice_54 : minutes_53;
  wire rung7_equal_55 = newest == 6'd54;
  wire [14:0] rung7_choice_55 = rung7_equal_55 ? count_CV : minutes_54;
  wire [14:0] minutes_54_next = minute_Q ? rung7_choice_55 : minutes_54;
  wire rung7_equal_56 = newest == 6'd55;
  wire [14:0] rung7_choice_56 = rung7_equal_56 ? count_CV : minutes_55;
  wire [14:0] minutes_55_next = minute_Q ? rung7_choice_56 : minutes_55;
  wire rung7_equal_57 = newest == 6'd56;
  wire [14:0] rung7_choice_57 = rung7_equal_57 ? count_CV : minutes_56;
  wire [14:0] minutes_56_next = minute_Q ? rung7_choice_57 : minutes_56;
  wire rung7_equal_58 = newest == 6'd57;
  wire [14:0] rung7_choice_58 = rung7_equal_58 ? count_CV : minutes_57;
  wire [14:0] minutes_57_next = minute_Q ? rung7_choice_58 : minutes_57;
  wire rung7_equal_59 = newest == 6'd58;
  wire [14:0] rung7_choice_59 = rung7_equal_59 ? count_CV : minutes_58;
  wire [14:0] minutes_58_next = minute_Q ? rung7_choice_59 : minutes_58;
  wire rung7_equal_60 = newest == 6'd59;
  wire [14:0] rung7_choice_60 = rung7_equal_60 ? count_CV : minutes_59;
  wire [14:0] minutes_59_next = minute_Q ? rung7_choice_60 : minutes_59;
  wire [5:0] rung7_sum = newest + 6'd1;

  // rung 8, parts_average.ladder:36
  wire [5:0] rung8_choice = rung7_equal_60 ? 6'd0 : rung7_sum;
  wire [5:0] newest_next = minute_Q ? rung8_choice : newest;

  // rung 9 "averages of the minutes that there are", parts_average.ladder:39
  wire [3:0] rung9_sum = known_10 + 4'd1;
  wire rung9_equal = known_10 == 4'd10;
  wire [3:0] rung9_choice = rung9_equal ? 4'd10 : rung9_sum;
  wire [3:0] known_10_next = minute_Q ? rung9_choice : known_10;
  wire [15:0] rung9_extended = {12'b0, known_10_next};
  wire [15:0] rung9_sum_2 = sum_10_next + {1'b0, rung9_extended[15:1]};
  wire [15:0] rung9_quotient = rung9_extended == 16'd0 ? 16'd0 : rung9_sum_2 / rung9_extended;
  wire [15:0] average_10_next = minute_Q ? rung9_quotient : average_10_reg;

  // rung 10, parts_average.ladder:42
  wire [5:0] rung10_sum = known_60 + 6'd1;
  wire rung10_equal = known_60 == 6'd60;
  wire [5:0] rung10_choice = rung10_equal ? 6'd60 : rung10_sum;
  wire [5:0] known_60_next = minute_Q ? rung10_choice : known_60;
  wire [15:0] rung10_extended = {10'b0, known_60_next};
  wire [15:0] rung10_sum_2 = sum_60_next + {1'b0, rung10_extended[15:1]};
  wire [15:0] rung10_quotient = rung10_extended == 16'd0 ? 16'd0 : rung10_sum_2 / rung10_extended;
  wire [15:0] average_60_next = minute_Q ? rung10_quotient : average_60_reg;

  assign last_minute = last_minute_value;
  assign average_10 = average_10_reg;
  assign average_60 = average_60_reg;

  always @(posedge clk) begin
    if (rst) begin
      last_minute_reg <= 15'd0;
      newest <= 6'd0;
      tenth <= 16'd0;
      sum_10 <= 16'd0;
      minutes_0 <= 15'd0;
      minutes_1 <= 15'd0;
      minutes_2 <= 15'd0;
      minutes_3 <= 15'd0;
      minutes_4 <= 15'd0;
      minutes_5 <= 15'd0;
      minutes_6 <= 15'd0;
      minutes_7 <= 15'd0;
      minutes_8 <= 15'd0;
      minutes_9 <= 15'd0;
      minutes_10 <= 15'd0;
      minutes_11 <= 15'd0;
      minutes_12 <= 15'd0;
      minutes_13 <= 15'd0;
      minutes_14 <= 15'd0;
      minutes_15 <= 15'd0;
      minutes_16 <= 15'd0;
      minutes_17 <= 15'd0;
      minutes_18 <= 15'd0;
      minutes_19 <= 15'd0;
      minutes_20 <= 15'd0;
      minutes_21 <= 15'd0;
      minutes_22 <= 15'd0;
      minutes_23 <= 15'd0;
      minutes_24 <= 15'd0;
      minutes_25 <= 15'd0;
      minutes_26 <= 15'd0;
      minutes_27 <= 15'd0;
      minutes_28 <= 15'd0;
      minutes_29 <= 15'd0;
      minutes_30 <= 15'd0;
      minutes_31 <= 15'd0;
      minutes_32 <= 15'd0;
      minutes_33 <= 15'd0;
      minutes_34 <= 15'd0;
      minutes_35 <= 15'd0;
      minutes_36 <= 15'd0;
      minutes_37 <= 15'd0;
      minutes_38 <= 15'd0;
      minutes_39 <= 15'd0;
      minutes_40 <= 15'd0;
      minutes_41 <= 15'd0;
      minutes_42 <= 15'd0;
      minutes_43 <= 15'd0;
      minutes_44 <= 15'd0;
      minutes_45 <= 15'd0;
      minutes_46 <= 15'd0;
      minutes_47 <= 15'd0;
      minutes_48 <= 15'd0;
      minutes_49 <= 15'd0;
      minutes_50 <= 15'd0;
      minutes_51 <= 15'd0;
      minutes_52 <= 15'd0;
      minutes_53 <= 15'd0;
      minutes_54 <= 15'd0;
      minutes_55 <= 15'd0;
      minutes_56 <= 15'd0;
      minutes_57 <= 15'd0;
      minutes_58 <= 15'd0;
      minutes_59 <= 15'd0;
      sum_60 <= 16'd0;
      known_10 <= 4'd0;
      average_10_reg <= 16'd0;
      known_60 <= 6'd0;
      average_60_reg <= 16'd0;
    end else begin
      last_minute_reg <= last_minute_next;
      newest <= newest_next;
      tenth <= tenth_next;
      sum_10 <= sum_10_next;
      minutes_0 <= minutes_0_next;
      minutes_1 <= minutes_1_next;
      minutes_2 <= minutes_2_next;
      minutes_3 <= minutes_3_next;
      minutes_4 <= minutes_4_next;
      minutes_5 <= minutes_5_next;
      minutes_6 <= minutes_6_next;
      minutes_7 <= minutes_7_next;
      minutes_8 <= minutes_8_next;
      minutes_9 <= minutes_9_next;
      minutes_10 <= minutes_10_next;
      minutes_11 <= minutes_11_next;
      minutes_12 <= minutes_12_next;
      minutes_13 <= minutes_13_next;
      minutes_14 <= minutes_14_next;
      minutes_15 <= minutes_15_next;
      minutes_16 <= minutes_16_next;
      minutes_17 <= minutes_17_next;
      minutes_18 <= minutes_18_next;
      minutes_19 <= minutes_19_next;
      minutes_20 <= minutes_20_next;
      minutes_21 <= minutes_21_next;
      minutes_22 <= minutes_22_next;
      minutes_23 <= minutes_23_next;
      minutes_24 <= minutes_24_next;
      minutes_25 <= minutes_25_next;
      minutes_26 <= minutes_26_next;
      minutes_27 <= minutes_27_next;
      minutes_28 <= minutes_28_next;
      minutes_29 <= minutes_29_next;
      minutes_30 <= minutes_30_next;
      minutes_31 <= minutes_31_next;
      minutes_32 <= minutes_32_next;
      minutes_33 <= minutes_33_next;
      minutes_34 <= minutes_34_next;
      minutes_35 <= minutes_35_next;
      minutes_36 <= minutes_36_next;
      minutes_37 <= minutes_37_next;
      minutes_38 <= minutes_38_next;
      minutes_39 <= minutes_39_next;
      minutes_40 <= minutes_40_next;
      minutes_41 <= minutes_41_next;
      minutes_42 <= minutes_42_next;
      minutes_43 <= minutes_43_next;
      minutes_44 <= minutes_44_next;
      minutes_45 <= minutes_45_next;
      minutes_46 <= minutes_46_next;
      minutes_47 <= minutes_47_next;
      minutes_48 <= minutes_48_next;
      minutes_49 <= minutes_49_next;
      minutes_50 <= minutes_50_next;
      minutes_51 <= minutes_51_next;
      minutes_52 <= minutes_52_next;
      minutes_53 <= minutes_53_next;
      minutes_54 <= minutes_54_next;
      minutes_55 <= minutes_55_next;
      minutes_56 <= minutes_56_next;
      minutes_57 <= minutes_57_next;
      minutes_58 <= minutes_58_next;
      minutes_59 <= minutes_59_next;
      sum_60 <= sum_60_next;
      known_10 <= known_10_next;
      average_10_reg <= average_10_next;
      known_60 <= known_60_next;
      average_60_reg <= average_60_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
