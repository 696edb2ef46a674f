// Made by hotrail 0.1.0 from ab_counters.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

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
module ab_counters_test_AB_CTU_PRE99 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        clear_after,
  output wire [15:0] ACC_last,
  output wire        DN
);
  reg [15:0] ACC = 16'd0;
  reg was_up = 1'b1;

  wire [15:0] sum = ACC + {15'b0, power & ~was_up};
  wire [15:0] ACC_next = clear_after ? 16'd0 : sum;
  wire was_up_next = ~clear_after & power;

  assign ACC_last = ACC;
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
module ab_counters_test_AB_CTD_PRE1 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        clear_after,
  output wire [15:0] ACC_last,
  output wire        DN
);
  reg [15:0] ACC = 16'd50;
  reg was_down = 1'b1;

  wire [15:0] difference = ACC - {15'b0, power & ~was_down};
  wire [15:0] ACC_next = clear_after ? 16'd0 : difference;
  wire was_down_next = ~clear_after & power;

  assign ACC_last = ACC;
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
// Fitted to PRE = 99.
// Example, with PRE = 2:
// IN  _#_##_#_##_#
// (R) ________#___
// CU  _#_##_#__#_#
// DN  ___#####___#
// ACC 011222330112
module ab_counters_test_AB_CTU_PRE99_2 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire [15:0] ACC_before,
  input  wire        clear_after,
  output wire [15:0] ACC,
  output wire        DN_last,
  output wire        OV,
  output wire        OV_last
);
  reg DN = 1'b0;
  reg OV_reg = 1'b0;
  reg UN = 1'b0;
  reg was_up = 1'b1;

  wire condition = power & ~was_up;
  wire [15:0] ACC_value = ACC_before + {15'b0, condition};
  wire equal = ACC_before == 16'd32767;
  wire condition_2 = condition & equal;
  wire OV_value = OV_reg | condition_2 & ~UN;
  wire at_least = $signed(ACC_value) >= 16'sd99;
  wire DN_next = clear_after ? 1'b0 : at_least;
  wire OV_next = clear_after ? 1'b0 : OV_value;
  wire UN_next = clear_after ? 1'b0 : UN & ~condition_2;
  wire was_up_next = clear_after ? 1'b0 : power;

  assign ACC = ACC_value;
  assign DN_last = DN;
  assign OV = OV_value;
  assign OV_last = OV_reg;

  always @(posedge clk) begin
    if (rst) begin
      DN <= 1'b0;
      OV_reg <= 1'b0;
      UN <= 1'b0;
      was_up <= 1'b1;
    end else begin
      DN <= DN_next;
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
module ab_counters_test_CTU_PV99 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        R,
  output wire        Q,
  output wire [14:0] CV_last
);
  reg [14:0] CV = 15'd0;
  reg was = 1'b0;
  reg CV_at_least_99 = 1'b0;

  wire unequal = CV != 15'd32767;
  wire condition = power & ~was & unequal;
  wire [14:0] sum = CV + {14'b0, condition};
  wire [14:0] CV_next = R ? 15'd0 : sum;
  wire equal = CV == 15'd98;
  wire choice = condition ? equal | CV_at_least_99 : CV_at_least_99;
  wire CV_at_least_99_next = ~R & choice;

  assign Q = CV_at_least_99_next;
  assign CV_last = CV;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 15'd0;
      was <= 1'b0;
      CV_at_least_99 <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
      CV_at_least_99 <= CV_at_least_99_next;
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
module ab_counters_test_CTD_PV50 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        LD,
  output wire        Q,
  output wire [15:0] CV_last
);
  reg [15:0] CV = 16'd50;
  reg was = 1'b0;

  wire unequal = CV != 16'h8000;
  wire [15:0] difference = CV - {15'b0, power & ~was & unequal};
  wire [15:0] CV_next = LD ? 16'd50 : difference;

  assign Q = $signed(CV_next) <= 16'sd0;
  assign CV_last = CV;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 16'd50;
      was <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
    end
  end
endmodule

module ab_counters_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        count_up,
  input  wire        count_down,
  input  wire        reset_up,
  input  wire        reset_down,
  input  wire        to_the_end,
  output wire        up_done,
  output wire        down_done,
  output wire        siemens_up_done,
  output wire        siemens_down_done,
  output wire        overflow,
  output wire [15:0] c5_0_ACC,
  output wire [15:0] c1_CV,
  output wire [15:0] c5_1_ACC,
  output wire [15:0] c2_CV,
  output wire [15:0] c5_2_ACC,
  output wire        c5_2_DN,
  output wire        c5_2_OV
);
  reg [15:0] c5_2_ACC_reg = 16'd0;
  reg up_done_reg = 1'b0;
  reg down_done_reg = 1'b0;
  reg siemens_up_done_reg = 1'b0;
  reg siemens_down_done_reg = 1'b0;
  reg overflow_reg = 1'b0;

  // rung 1 "C5:0 up to 99", ab_counters.ladder:12
  wire [15:0] c5_0_ACC_last;
  wire c5_0_DN;
  ab_counters_test_AB_CTU_PRE99 c5_0 (
    .clk(clk),
    .rst(rst),
    .power(count_up),
    .clear_after(reset_up),
    .ACC_last(c5_0_ACC_last),
    .DN(c5_0_DN)
  );

  // rung 2, ab_counters.ladder:15
  wire up_done_next = c5_0_DN;

  // rung 3, ab_counters.ladder:17

  // rung 4 "C5:1 down from 50: DN while 1 or more are left", ab_counters.ladder:19
  wire [15:0] c5_1_ACC_last;
  wire c5_1_DN;
  ab_counters_test_AB_CTD_PRE1 c5_1 (
    .clk(clk),
    .rst(rst),
    .power(count_down),
    .clear_after(reset_down),
    .ACC_last(c5_1_ACC_last),
    .DN(c5_1_DN)
  );

  // rung 5 "so nothing is left when it is off", ab_counters.ladder:22
  wire down_done_next = ~c5_1_DN;

  // rung 6, ab_counters.ladder:25

  // rung 7 "C5:2 for the end of the range; CTU stops at 32767", ab_counters.ladder:27
  wire [15:0] c5_2_ACC_2;
  wire c5_2_DN_last;
  wire c5_2_OV_2;
  wire c5_2_OV_last;
  ab_counters_test_AB_CTU_PRE99_2 c5_2 (
    .clk(clk),
    .rst(rst),
    .power(count_up),
    .ACC_before(c5_2_ACC_reg),
    .clear_after(reset_up),
    .ACC(c5_2_ACC_2),
    .DN_last(c5_2_DN_last),
    .OV(c5_2_OV_2),
    .OV_last(c5_2_OV_last)
  );

  // rung 8, ab_counters.ladder:30
  wire [15:0] c5_2_ACC_rung8 = to_the_end ? 16'd32766 : c5_2_ACC_2;

  // rung 9, ab_counters.ladder:32
  wire [15:0] c5_2_ACC_next = reset_up ? 16'd0 : c5_2_ACC_rung8;
  wire overflow_next = ~reset_up & c5_2_OV_2;

  // rung 10, ab_counters.ladder:34

  // rung 11 "the same with Siemens' counters", ab_counters.ladder:36
  wire c1_Q;
  wire [14:0] c1_CV_last;
  ab_counters_test_CTU_PV99 c1 (
    .clk(clk),
    .rst(rst),
    .power(count_up),
    .R(reset_up),
    .Q(c1_Q),
    .CV_last(c1_CV_last)
  );
  wire siemens_up_done_next = c1_Q;

  // rung 12, ab_counters.ladder:39
  wire c2_Q;
  wire [15:0] c2_CV_last;
  ab_counters_test_CTD_PV50 c2 (
    .clk(clk),
    .rst(rst),
    .power(count_down),
    .LD(reset_down),
    .Q(c2_Q),
    .CV_last(c2_CV_last)
  );
  wire [15:0] c1_CV_value = {1'b0, c1_CV_last};
  wire siemens_down_done_next = c2_Q;

  assign up_done = up_done_reg;
  assign down_done = down_done_reg;
  assign siemens_up_done = siemens_up_done_reg;
  assign siemens_down_done = siemens_down_done_reg;
  assign overflow = overflow_reg;
  assign c5_0_ACC = c5_0_ACC_last;
  assign c1_CV = c1_CV_value;
  assign c5_1_ACC = c5_1_ACC_last;
  assign c2_CV = c2_CV_last;
  assign c5_2_ACC = c5_2_ACC_reg;
  assign c5_2_DN = c5_2_DN_last;
  assign c5_2_OV = c5_2_OV_last;

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

`default_nettype none

module ab_counters_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        up_done,
  input  wire        siemens_up_done,
  input  wire [15:0] c5_0_ACC,
  input  wire [15:0] c1_CV,
  input  wire        down_done,
  input  wire        siemens_down_done,
  input  wire [15:0] c5_1_ACC,
  input  wire [15:0] c2_CV,
  input  wire [15:0] c5_2_ACC,
  input  wire        overflow,
  input  wire        c5_2_DN,
  input  wire        c5_2_OV,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_0_3,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_2_2,
  output wire        expect_2_3,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_3_2,
  output wire        expect_4_0,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_5_2,
  output wire        expect_5_3,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_7_2,
  output wire        expect_7_3,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_8_2,
  output wire        expect_8_3,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_9_2,
  output wire        expect_9_3,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_11_0,
  output wire        expect_11_1,
  output wire        expect_12_0,
  output wire        expect_12_1,
  output wire        expect_13_0,
  output wire        expect_13_1,
  output wire        expect_14_0,
  output wire        expect_15_0,
  output wire        expect_15_1,
  output wire        expect_15_2,
  output wire        expect_16_0,
  output wire        expect_16_1
);

  assign expect_0_0 = ~up_done;
  assign expect_0_1 = ~siemens_up_done;
  assign expect_0_2 = c5_0_ACC == 16'd98;
  assign expect_0_3 = c1_CV == 16'd98;
  assign expect_1_0 = up_done;
  assign expect_1_1 = siemens_up_done;
  assign expect_2_0 = up_done;
  assign expect_2_1 = siemens_up_done;
  assign expect_2_2 = c5_0_ACC == 16'd109;
  assign expect_2_3 = c1_CV == 16'd109;
  assign expect_3_0 = ~siemens_up_done;
  assign expect_3_1 = c5_0_ACC == 16'd0;
  assign expect_3_2 = c1_CV == 16'd0;
  assign expect_4_0 = ~up_done;
  assign expect_5_0 = ~down_done;
  assign expect_5_1 = ~siemens_down_done;
  assign expect_5_2 = c5_1_ACC == 16'd50;
  assign expect_5_3 = c2_CV == 16'd50;
  assign expect_6_0 = ~down_done;
  assign expect_6_1 = ~siemens_down_done;
  assign expect_7_0 = down_done;
  assign expect_7_1 = siemens_down_done;
  assign expect_7_2 = c5_1_ACC == 16'd0;
  assign expect_7_3 = c2_CV == 16'd0;
  assign expect_8_0 = down_done;
  assign expect_8_1 = siemens_down_done;
  assign expect_8_2 = c5_1_ACC == 16'hffff;
  assign expect_8_3 = c2_CV == 16'hffff;
  assign expect_9_0 = c5_0_ACC == 16'd0;
  assign expect_9_1 = c1_CV == 16'd1;
  assign expect_9_2 = c5_1_ACC == 16'd50;
  assign expect_9_3 = c2_CV == 16'd49;
  assign expect_10_0 = c5_0_ACC == 16'd1;
  assign expect_10_1 = c1_CV == 16'd1;
  assign expect_11_0 = c5_0_ACC == 16'd1;
  assign expect_11_1 = c1_CV == 16'd0;
  assign expect_12_0 = c5_1_ACC == 16'd47;
  assign expect_12_1 = c2_CV == 16'd47;
  assign expect_13_0 = c5_1_ACC == 16'd0;
  assign expect_13_1 = c2_CV == 16'd50;
  assign expect_14_0 = c5_2_ACC == 16'd32766;
  assign expect_15_0 = c5_2_ACC == 16'h8000;
  assign expect_15_1 = overflow;
  assign expect_15_2 = ~c5_2_DN;
  assign expect_16_0 = c5_2_ACC == 16'd0;
  assign expect_16_1 = ~c5_2_OV;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module ab_counters_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg count_up = 1'd0;
  reg count_down = 1'd0;
  reg reset_up = 1'd0;
  reg reset_down = 1'd0;
  reg to_the_end = 1'd0;
  wire up_done;
  wire down_done;
  wire siemens_up_done;
  wire siemens_down_done;
  wire overflow;
  wire [15:0] c5_0_ACC;
  wire [15:0] c1_CV;
  wire [15:0] c5_1_ACC;
  wire [15:0] c2_CV;
  wire [15:0] c5_2_ACC;
  wire c5_2_DN;
  wire c5_2_OV;
  reg failed;
  integer failures;

  ab_counters_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .count_up(count_up),
    .count_down(count_down),
    .reset_up(reset_up),
    .reset_down(reset_down),
    .to_the_end(to_the_end),
    .up_done(up_done),
    .down_done(down_done),
    .siemens_up_done(siemens_up_done),
    .siemens_down_done(siemens_down_done),
    .overflow(overflow),
    .c5_0_ACC(c5_0_ACC),
    .c1_CV(c1_CV),
    .c5_1_ACC(c5_1_ACC),
    .c2_CV(c2_CV),
    .c5_2_ACC(c5_2_ACC),
    .c5_2_DN(c5_2_DN),
    .c5_2_OV(c5_2_OV)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire expect_0_3;
  wire [0:3] expect_0 = {expect_0_0, expect_0_1, expect_0_2, expect_0_3};
  wire expect_1_0;
  wire expect_1_1;
  wire [0:1] expect_1 = {expect_1_0, expect_1_1};
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
  wire expect_5_3;
  wire [0:3] expect_5 = {expect_5_0, expect_5_1, expect_5_2, expect_5_3};
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
  wire expect_9_2;
  wire expect_9_3;
  wire [0:3] expect_9 = {expect_9_0, expect_9_1, expect_9_2, expect_9_3};
  wire expect_10_0;
  wire expect_10_1;
  wire [0:1] expect_10 = {expect_10_0, expect_10_1};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire expect_12_1;
  wire [0:1] expect_12 = {expect_12_0, expect_12_1};
  wire expect_13_0;
  wire expect_13_1;
  wire [0:1] expect_13 = {expect_13_0, expect_13_1};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire expect_15_1;
  wire expect_15_2;
  wire [0:2] expect_15 = {expect_15_0, expect_15_1, expect_15_2};
  wire expect_16_0;
  wire expect_16_1;
  wire [0:1] expect_16 = {expect_16_0, expect_16_1};
  ab_counters_expect expectations (
    .clk(clk),
    .rst(rst),
    .up_done(up_done),
    .siemens_up_done(siemens_up_done),
    .c5_0_ACC(c5_0_ACC),
    .c1_CV(c1_CV),
    .down_done(down_done),
    .siemens_down_done(siemens_down_done),
    .c5_1_ACC(c5_1_ACC),
    .c2_CV(c2_CV),
    .c5_2_ACC(c5_2_ACC),
    .overflow(overflow),
    .c5_2_DN(c5_2_DN),
    .c5_2_OV(c5_2_OV),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_0_3(expect_0_3),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
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
    .expect_5_3(expect_5_3),
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
    .expect_9_2(expect_9_2),
    .expect_9_3(expect_9_3),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_13_0(expect_13_0),
    .expect_13_1(expect_13_1),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_15_1(expect_15_1),
    .expect_15_2(expect_15_2),
    .expect_16_0(expect_16_0),
    .expect_16_1(expect_16_1)
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
      count_up = 1'd0;
      count_down = 1'd0;
      reset_up = 1'd0;
      reset_down = 1'd0;
      to_the_end = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..6");

    // up to 99 and beyond
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (98) begin
      count_up = 1'd1;
      scan(1, 1'b0);
      count_up = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_0 !== 1'b1) begin // ab_counters.ladder:44
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b up_done=%b siemens_up_done=%b c5_0_ACC=%b c1_CV=%b at %0s", expect_0, up_done, siemens_up_done, c5_0_ACC, c1_CV, "ab_counters.ladder:44");
    end
    count_up = 1'd1;
    scan(1, 1'b0);
    count_up = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // ab_counters.ladder:46
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b up_done=%b siemens_up_done=%b at %0s", expect_1, up_done, siemens_up_done, "ab_counters.ladder:46");
    end
    repeat (10) begin
      count_up = 1'd1;
      scan(1, 1'b0);
      count_up = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_2 !== 1'b1) begin // ab_counters.ladder:48
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b up_done=%b siemens_up_done=%b c5_0_ACC=%b c1_CV=%b at %0s", expect_2, up_done, siemens_up_done, c5_0_ACC, c1_CV, "ab_counters.ladder:48");
    end
    reset_up = 1'd1;
    scan(1, 1'b0);
    reset_up = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // ab_counters.ladder:50
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b siemens_up_done=%b c5_0_ACC=%b c1_CV=%b at %0s", expect_3, siemens_up_done, c5_0_ACC, c1_CV, "ab_counters.ladder:50");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // ab_counters.ladder:52
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b up_done=%b at %0s", expect_4, up_done, "ab_counters.ladder:52");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "up to 99 and beyond");
    end else $display("ok 1 - %0s", "up to 99 and beyond");

    // down from 50, and below 0
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // ab_counters.ladder:56
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b down_done=%b siemens_down_done=%b c5_1_ACC=%b c2_CV=%b at %0s", expect_5, down_done, siemens_down_done, c5_1_ACC, c2_CV, "ab_counters.ladder:56");
    end
    repeat (49) begin
      count_down = 1'd1;
      scan(1, 1'b0);
      count_down = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_6 !== 1'b1) begin // ab_counters.ladder:58
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b down_done=%b siemens_down_done=%b at %0s", expect_6, down_done, siemens_down_done, "ab_counters.ladder:58");
    end
    count_down = 1'd1;
    scan(1, 1'b0);
    count_down = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // ab_counters.ladder:60
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b down_done=%b siemens_down_done=%b c5_1_ACC=%b c2_CV=%b at %0s", expect_7, down_done, siemens_down_done, c5_1_ACC, c2_CV, "ab_counters.ladder:60");
    end
    count_down = 1'd1;
    scan(1, 1'b0);
    count_down = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // ab_counters.ladder:62
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b down_done=%b siemens_down_done=%b c5_1_ACC=%b c2_CV=%b at %0s", expect_8, down_done, siemens_down_done, c5_1_ACC, c2_CV, "ab_counters.ladder:62");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "down from 50, and below 0");
    end else $display("ok 2 - %0s", "down from 50, and below 0");

    // difference: an input that is on in the first scan counts at Siemens only
    failed = 1'b0;
    reset;
    count_up = 1'd1;
    count_down = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // ab_counters.ladder:66
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b c5_0_ACC=%b c1_CV=%b c5_1_ACC=%b c2_CV=%b at %0s", expect_9, c5_0_ACC, c1_CV, c5_1_ACC, c2_CV, "ab_counters.ladder:66");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "difference: an input that is on in the first scan counts at Siemens only");
    end else $display("ok 3 - %0s", "difference: an input that is on in the first scan counts at Siemens only");

    // difference: a held input counts once more after RES
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    count_up = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // ab_counters.ladder:71
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b c5_0_ACC=%b c1_CV=%b at %0s", expect_10, c5_0_ACC, c1_CV, "ab_counters.ladder:71");
    end
    reset_up = 1'd1;
    scan(1, 1'b0);
    reset_up = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // ab_counters.ladder:74
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b c5_0_ACC=%b c1_CV=%b at %0s", expect_11, c5_0_ACC, c1_CV, "ab_counters.ladder:74");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "difference: a held input counts once more after RES");
    end else $display("ok 4 - %0s", "difference: a held input counts once more after RES");

    // difference: RES of a down counter makes it 0, LD makes it the preset
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (3) begin
      count_down = 1'd1;
      scan(1, 1'b0);
      count_down = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_12 !== 1'b1) begin // ab_counters.ladder:79
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b c5_1_ACC=%b c2_CV=%b at %0s", expect_12, c5_1_ACC, c2_CV, "ab_counters.ladder:79");
    end
    reset_down = 1'd1;
    scan(1, 1'b0);
    reset_down = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // ab_counters.ladder:81
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b c5_1_ACC=%b c2_CV=%b at %0s", expect_13, c5_1_ACC, c2_CV, "ab_counters.ladder:81");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "difference: RES of a down counter makes it 0, LD makes it the preset");
    end else $display("ok 5 - %0s", "difference: RES of a down counter makes it 0, LD makes it the preset");

    // difference: past the largest count one goes round and says so, Siemens' stops
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    to_the_end = 1'd1;
    scan(1, 1'b0);
    to_the_end = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // ab_counters.ladder:86
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b c5_2_ACC=%b at %0s", expect_14, c5_2_ACC, "ab_counters.ladder:86");
    end
    repeat (2) begin
      count_up = 1'd1;
      scan(1, 1'b0);
      count_up = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_15 !== 1'b1) begin // ab_counters.ladder:88
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b c5_2_ACC=%b overflow=%b c5_2_DN=%b at %0s", expect_15, c5_2_ACC, overflow, c5_2_DN, "ab_counters.ladder:88");
    end
    reset_up = 1'd1;
    scan(1, 1'b0);
    reset_up = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_16 !== 1'b1) begin // ab_counters.ladder:90
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b c5_2_ACC=%b c5_2_OV=%b at %0s", expect_16, c5_2_ACC, c5_2_OV, "ab_counters.ladder:90");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "difference: past the largest count one goes round and says so, Siemens' stops");
    end else $display("ok 6 - %0s", "difference: past the largest count one goes round and says so, Siemens' stops");

    if (failures != 0) $display("# %0d of 6 tests failed", failures);
    $finish;
  end
endmodule
