// Made by hotrail 0.1.0 from ab_part_count.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_TON: on-delay timer of Allen-Bradley, BASE = 1 tick, SIZE = DINT
// Fitted to PRE = 500.
module ab_part_count_test_AB_TON_BASE1_DINT_PRE500 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire DN
);
  reg [8:0] ACC = 9'd0;
  reg DN_reg = 1'b0;
  reg was = 1'b0;

  wire condition = power & was & ~DN_reg & tick;
  wire equal = ACC == 9'd500;
  wire [8:0] sum = ACC + {8'b0, condition & ~equal};
  wire equal_2 = ACC == 9'd499;
  wire DN_next = power & (DN_reg | condition & equal_2 | equal);
  wire [8:0] ACC_next = power ? sum : 9'd0;

  assign DN = DN_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 9'd0;
      DN_reg <= 1'b0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      DN_reg <= DN_next;
      was <= power;
    end
  end
endmodule

// AB_CTU: up counter of Allen-Bradley, SIZE = DINT
// Fitted to PRE = 1000.
// Example, with PRE = 5, ACC = 32766:
// IN        _#_#
// DN        ####
// OV        ____
// ACC-32760 6778
module ab_part_count_test_AB_CTU_DINT_PRE1000 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        clear_after,
  output wire [31:0] ACC_last,
  output wire        DN
);
  reg [31:0] ACC = 32'd0;
  reg was_up = 1'b1;

  wire [31:0] sum = ACC + {31'b0, power & ~was_up};
  wire [31:0] ACC_next = clear_after ? 32'd0 : sum;
  wire was_up_next = ~clear_after & power;

  assign ACC_last = ACC;
  assign DN = $signed(sum) >= 32'sd1000;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 32'd0;
      was_up <= 1'b1;
    end else begin
      ACC <= ACC_next;
      was_up <= was_up_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 500 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module ab_part_count_test_TON_PT500 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [8:0] ET = 9'd0;
  reg was = 1'b0;
  reg ET_is_500 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_500;
  wire [8:0] sum = ET + 9'd1;
  wire [8:0] choice = condition_2 ? sum : ET;
  wire [8:0] ET_next = condition ? choice : 9'd0;
  wire equal = ET == 9'd499;
  wire choice_2 = condition_2 ? equal : ET_is_500;
  wire ET_is_500_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_500_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 9'd0;
      was <= 1'b0;
      ET_is_500 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_500 <= ET_is_500_next;
    end
  end
endmodule

// CTU: up counter
// Fitted to PV = 1000.
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module ab_part_count_test_CTU_PV1000 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        R,
  output wire        Q,
  output wire [14:0] CV_last
);
  reg [14:0] CV = 15'd0;
  reg was = 1'b0;
  reg CV_at_least_1000 = 1'b0;

  wire unequal = CV != 15'd32767;
  wire condition = power & ~was & unequal;
  wire [14:0] sum = CV + {14'b0, condition};
  wire [14:0] CV_next = R ? 15'd0 : sum;
  wire equal = CV == 15'd999;
  wire choice = condition ? equal | CV_at_least_1000 : CV_at_least_1000;
  wire CV_at_least_1000_next = ~R & choice;

  assign Q = CV_at_least_1000_next;
  assign CV_last = CV;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 15'd0;
      was <= 1'b0;
      CV_at_least_1000 <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
      CV_at_least_1000 <= CV_at_least_1000_next;
    end
  end
endmodule

module ab_part_count_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        pump_run,
  input  wire        part_present,
  input  wire        clear,
  output wire        pump_on_for_a_while,
  output wire        batch_done,
  output wire        siemens_pump,
  output wire        siemens_batch,
  output wire [31:0] part_count_ACC,
  output wire [15:0] db2_CV
);
  reg pump_on_for_a_while_reg = 1'b0;
  reg batch_done_reg = 1'b0;
  reg siemens_pump_reg = 1'b0;
  reg siemens_batch_reg = 1'b0;

  // rung 1 "Delay_Tmr", ab_part_count.ladder:8
  wire delay_tmr_DN;
  ab_part_count_test_AB_TON_BASE1_DINT_PRE500 delay_tmr (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pump_run),
    .DN(delay_tmr_DN)
  );

  // rung 2, ab_part_count.ladder:11
  wire pump_on_for_a_while_next = delay_tmr_DN;

  // rung 3 "Part_Count", ab_part_count.ladder:13
  wire [31:0] part_count_ACC_last;
  wire part_count_DN;
  ab_part_count_test_AB_CTU_DINT_PRE1000 part_count (
    .clk(clk),
    .rst(rst),
    .power(part_present),
    .clear_after(clear),
    .ACC_last(part_count_ACC_last),
    .DN(part_count_DN)
  );

  // rung 4, ab_part_count.ladder:16
  wire batch_done_next = part_count_DN;

  // rung 5, ab_part_count.ladder:18

  // rung 6 "DB1", ab_part_count.ladder:20
  wire db1_Q;
  ab_part_count_test_TON_PT500 db1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pump_run),
    .Q(db1_Q)
  );
  wire siemens_pump_next = db1_Q;

  // rung 7 "DB2", ab_part_count.ladder:23
  wire db2_Q;
  wire [14:0] db2_CV_last;
  ab_part_count_test_CTU_PV1000 db2 (
    .clk(clk),
    .rst(rst),
    .power(part_present),
    .R(clear),
    .Q(db2_Q),
    .CV_last(db2_CV_last)
  );
  wire [15:0] db2_CV_value = {1'b0, db2_CV_last};
  wire siemens_batch_next = db2_Q;

  assign pump_on_for_a_while = pump_on_for_a_while_reg;
  assign batch_done = batch_done_reg;
  assign siemens_pump = siemens_pump_reg;
  assign siemens_batch = siemens_batch_reg;
  assign part_count_ACC = part_count_ACC_last;
  assign db2_CV = db2_CV_value;

  always @(posedge clk) begin
    if (rst) begin
      pump_on_for_a_while_reg <= 1'b0;
      batch_done_reg <= 1'b0;
      siemens_pump_reg <= 1'b0;
      siemens_batch_reg <= 1'b0;
    end else begin
      pump_on_for_a_while_reg <= pump_on_for_a_while_next;
      batch_done_reg <= batch_done_next;
      siemens_pump_reg <= siemens_pump_next;
      siemens_batch_reg <= siemens_batch_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module ab_part_count_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        pump_on_for_a_while,
  input  wire        siemens_pump,
  input  wire        batch_done,
  input  wire        siemens_batch,
  input  wire [31:0] part_count_ACC,
  input  wire [15:0] db2_CV,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_4_3,
  output wire        expect_5_0,
  output wire        expect_5_1
);

  assign expect_0_0 = ~pump_on_for_a_while;
  assign expect_0_1 = ~siemens_pump;
  assign expect_1_0 = pump_on_for_a_while;
  assign expect_1_1 = siemens_pump;
  assign expect_2_0 = ~pump_on_for_a_while;
  assign expect_2_1 = ~siemens_pump;
  assign expect_3_0 = ~batch_done;
  assign expect_3_1 = ~siemens_batch;
  assign expect_4_0 = batch_done;
  assign expect_4_1 = siemens_batch;
  assign expect_4_2 = part_count_ACC == 32'd1000;
  assign expect_4_3 = db2_CV == 16'd1000;
  assign expect_5_0 = ~batch_done;
  assign expect_5_1 = ~siemens_batch;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module ab_part_count_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg pump_run = 1'd0;
  reg part_present = 1'd0;
  reg clear = 1'd0;
  wire pump_on_for_a_while;
  wire batch_done;
  wire siemens_pump;
  wire siemens_batch;
  wire [31:0] part_count_ACC;
  wire [15:0] db2_CV;
  reg failed;
  integer failures;

  ab_part_count_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .pump_run(pump_run),
    .part_present(part_present),
    .clear(clear),
    .pump_on_for_a_while(pump_on_for_a_while),
    .batch_done(batch_done),
    .siemens_pump(siemens_pump),
    .siemens_batch(siemens_batch),
    .part_count_ACC(part_count_ACC),
    .db2_CV(db2_CV)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire [0:1] expect_0 = {expect_0_0, expect_0_1};
  wire expect_1_0;
  wire expect_1_1;
  wire [0:1] expect_1 = {expect_1_0, expect_1_1};
  wire expect_2_0;
  wire expect_2_1;
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire expect_3_1;
  wire [0:1] expect_3 = {expect_3_0, expect_3_1};
  wire expect_4_0;
  wire expect_4_1;
  wire expect_4_2;
  wire expect_4_3;
  wire [0:3] expect_4 = {expect_4_0, expect_4_1, expect_4_2, expect_4_3};
  wire expect_5_0;
  wire expect_5_1;
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  ab_part_count_expect expectations (
    .clk(clk),
    .rst(rst),
    .pump_on_for_a_while(pump_on_for_a_while),
    .siemens_pump(siemens_pump),
    .batch_done(batch_done),
    .siemens_batch(siemens_batch),
    .part_count_ACC(part_count_ACC),
    .db2_CV(db2_CV),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_4_3(expect_4_3),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1)
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
      pump_run = 1'd0;
      part_present = 1'd0;
      clear = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..2");

    // 500 ms
    failed = 1'b0;
    reset;
    pump_run = 1'd1;
    scan(1, 1'b0);
    scan(499, 1'b1);
    #1 if (!failed && &expect_0 !== 1'b1) begin // ab_part_count.ladder:29
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b pump_on_for_a_while=%b siemens_pump=%b at %0s", expect_0, pump_on_for_a_while, siemens_pump, "ab_part_count.ladder:29");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // ab_part_count.ladder:31
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b pump_on_for_a_while=%b siemens_pump=%b at %0s", expect_1, pump_on_for_a_while, siemens_pump, "ab_part_count.ladder:31");
    end
    pump_run = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // ab_part_count.ladder:33
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b pump_on_for_a_while=%b siemens_pump=%b at %0s", expect_2, pump_on_for_a_while, siemens_pump, "ab_part_count.ladder:33");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "500 ms");
    end else $display("ok 1 - %0s", "500 ms");

    // 1000 parts
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (999) begin
      part_present = 1'd1;
      scan(1, 1'b0);
      part_present = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_3 !== 1'b1) begin // ab_part_count.ladder:38
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b batch_done=%b siemens_batch=%b at %0s", expect_3, batch_done, siemens_batch, "ab_part_count.ladder:38");
    end
    part_present = 1'd1;
    scan(1, 1'b0);
    part_present = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // ab_part_count.ladder:40
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b batch_done=%b siemens_batch=%b part_count_ACC=%b db2_CV=%b at %0s", expect_4, batch_done, siemens_batch, part_count_ACC, db2_CV, "ab_part_count.ladder:40");
    end
    clear = 1'd1;
    scan(1, 1'b0);
    clear = 1'd0;
    scan(1, 1'b0);
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // ab_part_count.ladder:43
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b batch_done=%b siemens_batch=%b at %0s", expect_5, batch_done, siemens_batch, "ab_part_count.ladder:43");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "1000 parts");
    end else $display("ok 2 - %0s", "1000 parts");

    if (failures != 0) $display("# %0d of 2 tests failed", failures);
    $finish;
  end
endmodule
