// Made by hotrail 0.1.0 from ab_counters.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_CTU: up counter of Allen-Bradley
// Fitted to PRE = 99.
// Example, with PRE = 2:
// IN  _#_##_#_##_#
// (R) ________#___
// CU  _#_##_#__#_#
// DN  ___#####___#
// ACC 011222330112
module ab_counters_AB_CTU_PRE99 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire clear_after,
  output wire DN
);
  reg [15:0] ACC = 16'd0;
  reg was_up = 1'b1;

  wire [15:0] sum = ACC + {15'b0, power & ~was_up};
  wire [15:0] ACC_next = clear_after ? 16'd0 : sum;
  wire was_up_next = ~clear_after & power;

  assign DN = $signed(sum) >= 16'sd99;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 16'd0;
      was_up <= 1'b1;
    end else begin
      ACC <= ACC_next;
      was_up <= was_up_next;
    end
  end
endmodule

// AB_CTD: down counter of Allen-Bradley
// Fitted to PRE = 1.
// Example, with PRE = 1, ACC = 2:
// IN    _#_##_#
// CD    _#_##_#
// DN    ###____
// ACC+1 3221110
module ab_counters_AB_CTD_PRE1 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire clear_after,
  output wire DN
);
  reg [15:0] ACC = 16'd50;
  reg was_down = 1'b1;

  wire [15:0] difference = ACC - {15'b0, power & ~was_down};
  wire [15:0] ACC_next = clear_after ? 16'd0 : difference;
  wire was_down_next = ~clear_after & power;

  assign DN = $signed(difference) >= 16'sd1;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 16'd50;
      was_down <= 1'b1;
    end else begin
      ACC <= ACC_next;
      was_down <= was_down_next;
    end
  end
endmodule

// AB_CTU: up counter of Allen-Bradley
// Example, with PRE = 2:
// IN  _#_##_#_##_#
// (R) ________#___
// CU  _#_##_#__#_#
// DN  ___#####___#
// ACC 011222330112
module ab_counters_AB_CTU (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire [15:0] ACC_before,
  input  wire        clear_after,
  output wire [15:0] ACC,
  output wire        OV
);
  reg OV_reg = 1'b0;
  reg UN = 1'b0;
  reg was_up = 1'b1;

  wire condition = power & ~was_up;
  wire [15:0] ACC_value = ACC_before + {15'b0, condition};
  wire equal = ACC_before == 16'd32767;
  wire condition_2 = condition & equal;
  wire OV_value = OV_reg | condition_2 & ~UN;
  wire OV_next = clear_after ? 1'b0 : OV_value;
  wire UN_next = clear_after ? 1'b0 : UN & ~condition_2;
  wire was_up_next = clear_after ? 1'b0 : power;

  assign ACC = ACC_value;
  assign OV = OV_value;

  always @(posedge clk) begin
    if (rst) begin
      OV_reg <= 1'b0;
      UN <= 1'b0;
      was_up <= 1'b1;
    end else begin
      OV_reg <= OV_next;
      UN <= UN_next;
      was_up <= was_up_next;
    end
  end
endmodule

// CTU: up counter
// Fitted to PV = 99.
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module ab_counters_CTU_PV99 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire R,
  output wire Q
);
  reg [6:0] CV = 7'd0;
  reg was = 1'b0;
  reg CV_is_99 = 1'b0;

  wire condition = power & ~was & ~CV_is_99;
  wire [6:0] sum = CV + 7'd1;
  wire [6:0] choice = condition ? sum : CV;
  wire [6:0] CV_next = R ? 7'd0 : choice;
  wire equal = CV == 7'd98;
  wire choice_2 = condition ? equal : CV_is_99;
  wire CV_is_99_next = R ? 1'b0 : choice_2;

  assign Q = CV_is_99_next;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 7'd0;
      was <= 1'b0;
      CV_is_99 <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
      CV_is_99 <= CV_is_99_next;
    end
  end
endmodule

// CTD: down counter
// Fitted to PV = 50.
// Example, with PV = 2:
// IN  _##_#__#_#_
// LD  ______##___
// Q   ____##_____
// CV  21110022211
module ab_counters_CTD_PV50 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire LD,
  output wire Q
);
  reg [5:0] CV = 6'd50;
  reg was = 1'b0;
  reg CV_is_0 = 1'b0;

  wire condition = power & ~was & ~CV_is_0;
  wire [5:0] difference = CV - 6'd1;
  wire [5:0] choice = condition ? difference : CV;
  wire [5:0] CV_next = LD ? 6'd50 : choice;
  wire equal = CV == 6'd1;
  wire choice_2 = condition ? equal : CV_is_0;
  wire CV_is_0_next = LD ? 1'b0 : choice_2;

  assign Q = CV_is_0_next;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 6'd50;
      was <= 1'b0;
      CV_is_0 <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
      CV_is_0 <= CV_is_0_next;
    end
  end
endmodule

module ab_counters (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire count_up,
  input  wire count_down,
  input  wire reset_up,
  input  wire reset_down,
  input  wire to_the_end,
  output wire up_done,
  output wire down_done,
  output wire siemens_up_done,
  output wire siemens_down_done,
  output wire overflow
);
  reg [15:0] c5_2_ACC_reg = 16'd0;
  reg up_done_reg = 1'b0;
  reg down_done_reg = 1'b0;
  reg siemens_up_done_reg = 1'b0;
  reg siemens_down_done_reg = 1'b0;
  reg overflow_reg = 1'b0;

  // rung 1 "C5:0 up to 99", ab_counters.ladder:12
  wire c5_0_DN;
  ab_counters_AB_CTU_PRE99 c5_0 (
    .clk(clk),
    .rst(rst),
    .power(count_up),
    .clear_after(reset_up),
    .DN(c5_0_DN)
  );

  // rung 2, ab_counters.ladder:15
  wire up_done_next = c5_0_DN;

  // rung 3, ab_counters.ladder:17

  // rung 4 "C5:1 down from 50: DN while 1 or more are left", ab_counters.ladder:19
  wire c5_1_DN;
  ab_counters_AB_CTD_PRE1 c5_1 (
    .clk(clk),
    .rst(rst),
    .power(count_down),
    .clear_after(reset_down),
    .DN(c5_1_DN)
  );

  // rung 5 "so nothing is left when it is off", ab_counters.ladder:22
  wire down_done_next = ~c5_1_DN;

  // rung 6, ab_counters.ladder:25

  // rung 7 "C5:2 for the end of the range; CTU stops at 32767", ab_counters.ladder:27
  wire [15:0] c5_2_ACC;
  wire c5_2_OV;
  ab_counters_AB_CTU c5_2 (
    .clk(clk),
    .rst(rst),
    .power(count_up),
    .ACC_before(c5_2_ACC_reg),
    .clear_after(reset_up),
    .ACC(c5_2_ACC),
    .OV(c5_2_OV)
  );

  // rung 8, ab_counters.ladder:30
  wire [15:0] c5_2_ACC_rung8 = to_the_end ? 16'd32766 : c5_2_ACC;

  // rung 9, ab_counters.ladder:32
  wire [15:0] c5_2_ACC_next = reset_up ? 16'd0 : c5_2_ACC_rung8;
  wire overflow_next = ~reset_up & c5_2_OV;

  // rung 10, ab_counters.ladder:34

  // rung 11 "the same with Siemens' counters", ab_counters.ladder:36
  wire c1_Q;
  ab_counters_CTU_PV99 c1 (
    .clk(clk),
    .rst(rst),
    .power(count_up),
    .R(reset_up),
    .Q(c1_Q)
  );
  wire siemens_up_done_next = c1_Q;

  // rung 12, ab_counters.ladder:39
  wire c2_Q;
  ab_counters_CTD_PV50 c2 (
    .clk(clk),
    .rst(rst),
    .power(count_down),
    .LD(reset_down),
    .Q(c2_Q)
  );
  wire siemens_down_done_next = c2_Q;

  assign up_done = up_done_reg;
  assign down_done = down_done_reg;
  assign siemens_up_done = siemens_up_done_reg;
  assign siemens_down_done = siemens_down_done_reg;
  assign overflow = overflow_reg;

  always @(posedge clk) begin
    if (rst) begin
      c5_2_ACC_reg <= 16'd0;
      up_done_reg <= 1'b0;
      down_done_reg <= 1'b0;
      siemens_up_done_reg <= 1'b0;
      siemens_down_done_reg <= 1'b0;
      overflow_reg <= 1'b0;
    end else begin
      c5_2_ACC_reg <= c5_2_ACC_next;
      up_done_reg <= up_done_next;
      down_done_reg <= down_done_next;
      siemens_up_done_reg <= siemens_up_done_next;
      siemens_down_done_reg <= siemens_down_done_next;
      overflow_reg <= overflow_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
