// Made by hotrail 0.1.0 from ab_retentive.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_RTO: retentive timer of Allen-Bradley, BASE = 100 ticks
// Example, with PRE = 3, BASE = 1:
// IN  _##_###____#_##
// (R) ____________#__
// EN  _##_###____#_##
// TT  _##_##_______##
// DN  ______######___
// ACC 001112333333001
module ab_retentive_test_AB_RTO_BASE100 (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [15:0] PRE,
  input  wire        clear_after,
  output wire [14:0] ACC_last,
  output wire        EN_last,
  output wire        TT_last,
  output wire        DN
);
  reg [14:0] ACC = 15'd0;
  reg EN = 1'b0;
  reg TT = 1'b0;
  reg DN_reg = 1'b0;
  reg [6:0] fraction = 7'd0;
  reg was = 1'b0;

  wire less = $signed(PRE) < 16'sd0;
  wire [14:0] choice = less ? 15'd0 : PRE[14:0];
  wire condition = power & was & ~DN_reg & tick;
  wire equal = fraction == 7'd99;
  wire condition_2 = condition & equal;
  wire [6:0] sum = fraction + {6'b0, condition};
  wire [6:0] choice_2 = condition_2 ? 7'd0 : sum;
  wire unequal = ACC != 15'd32767;
  wire [14:0] sum_2 = ACC + {14'b0, condition_2 & unequal};
  wire at_least = sum_2 >= choice;
  wire DN_value = DN_reg | power & at_least;
  wire [14:0] ACC_next = clear_after ? 15'd0 : sum_2;
  wire EN_next = clear_after ? 1'b0 : power;
  wire TT_next = clear_after ? 1'b0 : power & ~DN_value;
  wire DN_next = clear_after ? 1'b0 : DN_value;
  wire [6:0] fraction_next = clear_after ? 7'd0 : choice_2;

  assign ACC_last = ACC;
  assign EN_last = EN;
  assign TT_last = TT;
  assign DN = DN_value;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 15'd0;
      EN <= 1'b0;
      TT <= 1'b0;
      DN_reg <= 1'b0;
      fraction <= 7'd0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      EN <= EN_next;
      TT <= TT_next;
      DN_reg <= DN_next;
      fraction <= fraction_next;
      was <= power;
    end
  end
endmodule

// TONR: retentive on-delay timer
// Example, with PT = 3:
// IN  _##_###____######
// R   _________#___#___
// Q   ______###_______#
// ET  00111233300010123
module ab_retentive_test_TONR (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [31:0] PT,
  input  wire        R,
  output wire        Q,
  output wire [31:0] ET_last
);
  reg [31:0] ET = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET) < $signed(PT);
  wire [31:0] sum = ET + {31'b0, power & was & tick & less};
  wire [31:0] ET_next = R ? 32'd0 : sum;
  wire at_least = $signed(ET_next) >= $signed(PT);

  assign Q = ~R & at_least;
  assign ET_last = ET;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 32'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

module ab_retentive_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        pump,
  input  wire        reset_button,
  input  wire        longer,
  output wire        service,
  output wire        siemens_service,
  output wire [15:0] t4_2_ACC,
  output wire [31:0] t3_ET,
  output wire        t4_2_EN,
  output wire        t4_2_TT
);
  reg [3:0] t4_2_PRE = 4'd5;
  reg [9:0] limit = 10'd500;
  reg service_reg = 1'b0;
  reg siemens_service_reg = 1'b0;

  // rung 1 "T4:2, five units of a second", ab_retentive.ladder:12
  wire [15:0] t4_2_PRE_2 = {12'b0, t4_2_PRE};
  wire [14:0] t4_2_ACC_last;
  wire t4_2_EN_last;
  wire t4_2_TT_last;
  wire t4_2_DN;
  ab_retentive_test_AB_RTO_BASE100 t4_2 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pump),
    .PRE(t4_2_PRE_2),
    .clear_after(reset_button),
    .ACC_last(t4_2_ACC_last),
    .EN_last(t4_2_EN_last),
    .TT_last(t4_2_TT_last),
    .DN(t4_2_DN)
  );

  // rung 2, ab_retentive.ladder:15
  wire service_next = t4_2_DN;

  // rung 3 "RES", ab_retentive.ladder:17

  // rung 4 "the same with Siemens' timer", ab_retentive.ladder:20
  wire [31:0] t3_PT = {22'b0, limit};
  wire t3_Q;
  wire [31:0] t3_ET_last;
  ab_retentive_test_TONR t3 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pump),
    .PT(t3_PT),
    .R(reset_button),
    .Q(t3_Q),
    .ET_last(t3_ET_last)
  );
  wire siemens_service_next = t3_Q;

  // rung 5, ab_retentive.ladder:23
  wire [3:0] t4_2_PRE_next = longer ? 4'd8 : t4_2_PRE;
  wire [9:0] limit_next = longer ? 10'd800 : limit;
  wire [15:0] t4_2_ACC_value = {1'b0, t4_2_ACC_last};

  assign service = service_reg;
  assign siemens_service = siemens_service_reg;
  assign t4_2_ACC = t4_2_ACC_value;
  assign t3_ET = t3_ET_last;
  assign t4_2_EN = t4_2_EN_last;
  assign t4_2_TT = t4_2_TT_last;

  always @(posedge clk) begin
    if (rst) begin
      t4_2_PRE <= 4'd5;
      limit <= 10'd500;
      service_reg <= 1'b0;
      siemens_service_reg <= 1'b0;
    end else begin
      t4_2_PRE <= t4_2_PRE_next;
      limit <= limit_next;
      service_reg <= service_next;
      siemens_service_reg <= siemens_service_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module ab_retentive_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire [15:0] t4_2_ACC,
  input  wire [31:0] t3_ET,
  input  wire        service,
  input  wire        siemens_service,
  input  wire        t4_2_EN,
  input  wire        t4_2_TT,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_2_2,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_5_2,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_8_2,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_9_2,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_11_0,
  output wire        expect_11_1,
  output wire        expect_12_0,
  output wire        expect_12_1
);

  assign expect_0_0 = t4_2_ACC == 16'd2;
  assign expect_0_1 = t3_ET == 32'd250;
  assign expect_1_0 = ~service;
  assign expect_1_1 = ~siemens_service;
  assign expect_2_0 = service;
  assign expect_2_1 = siemens_service;
  assign expect_2_2 = t4_2_ACC == 16'd5;
  assign expect_3_0 = service;
  assign expect_3_1 = siemens_service;
  assign expect_4_0 = service;
  assign expect_4_1 = siemens_service;
  assign expect_4_2 = t4_2_EN;
  assign expect_5_0 = ~service;
  assign expect_5_1 = ~siemens_service;
  assign expect_5_2 = t3_ET == 32'd0;
  assign expect_6_0 = ~service;
  assign expect_6_1 = ~siemens_service;
  assign expect_7_0 = service;
  assign expect_7_1 = siemens_service;
  assign expect_8_0 = ~siemens_service;
  assign expect_8_1 = t4_2_ACC == 16'd0;
  assign expect_8_2 = t3_ET == 32'd0;
  assign expect_9_0 = ~t4_2_EN;
  assign expect_9_1 = ~t4_2_TT;
  assign expect_9_2 = t4_2_ACC == 16'd0;
  assign expect_10_0 = t4_2_EN;
  assign expect_10_1 = t4_2_TT;
  assign expect_11_0 = service;
  assign expect_11_1 = ~siemens_service;
  assign expect_12_0 = siemens_service;
  assign expect_12_1 = t4_2_ACC == 16'd5;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module ab_retentive_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg pump = 1'd0;
  reg reset_button = 1'd0;
  reg longer = 1'd0;
  wire service;
  wire siemens_service;
  wire [15:0] t4_2_ACC;
  wire [31:0] t3_ET;
  wire t4_2_EN;
  wire t4_2_TT;
  reg failed;
  integer failures;

  ab_retentive_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .pump(pump),
    .reset_button(reset_button),
    .longer(longer),
    .service(service),
    .siemens_service(siemens_service),
    .t4_2_ACC(t4_2_ACC),
    .t3_ET(t3_ET),
    .t4_2_EN(t4_2_EN),
    .t4_2_TT(t4_2_TT)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire [0:1] expect_0 = {expect_0_0, expect_0_1};
  wire expect_1_0;
  wire expect_1_1;
  wire [0:1] expect_1 = {expect_1_0, expect_1_1};
  wire expect_2_0;
  wire expect_2_1;
  wire expect_2_2;
  wire [0:2] expect_2 = {expect_2_0, expect_2_1, expect_2_2};
  wire expect_3_0;
  wire expect_3_1;
  wire [0:1] expect_3 = {expect_3_0, expect_3_1};
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
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
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
  wire [0:1] expect_10 = {expect_10_0, expect_10_1};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire expect_12_1;
  wire [0:1] expect_12 = {expect_12_0, expect_12_1};
  ab_retentive_expect expectations (
    .clk(clk),
    .rst(rst),
    .t4_2_ACC(t4_2_ACC),
    .t3_ET(t3_ET),
    .service(service),
    .siemens_service(siemens_service),
    .t4_2_EN(t4_2_EN),
    .t4_2_TT(t4_2_TT),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_2_2(expect_2_2),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_8_2(expect_8_2),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_9_2(expect_9_2),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1)
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
      pump = 1'd0;
      reset_button = 1'd0;
      longer = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..5");

    // time adds up over rests, to the hundredth
    failed = 1'b0;
    reset;
    pump = 1'd1;
    scan(1, 1'b0);
    scan(250, 1'b1);
    pump = 1'd0;
    scan(1000, 1'b1);
    #1 if (!failed && &expect_0 !== 1'b1) begin // ab_retentive.ladder:29
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b t4_2_ACC=%b t3_ET=%b at %0s", expect_0, t4_2_ACC, t3_ET, "ab_retentive.ladder:29");
    end
    pump = 1'd1;
    scan(1, 1'b0);
    scan(249, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // ab_retentive.ladder:32
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b service=%b siemens_service=%b at %0s", expect_1, service, siemens_service, "ab_retentive.ladder:32");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // ab_retentive.ladder:34
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b service=%b siemens_service=%b t4_2_ACC=%b at %0s", expect_2, service, siemens_service, t4_2_ACC, "ab_retentive.ladder:34");
    end
    pump = 1'd0;
    scan(100, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // ab_retentive.ladder:36
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b service=%b siemens_service=%b at %0s", expect_3, service, siemens_service, "ab_retentive.ladder:36");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "time adds up over rests, to the hundredth");
    end else $display("ok 1 - %0s", "time adds up over rests, to the hundredth");

    // RES puts it back, and a pump that runs goes on from 0
    failed = 1'b0;
    reset;
    pump = 1'd1;
    scan(1, 1'b0);
    scan(500, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // ab_retentive.ladder:41
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b service=%b siemens_service=%b t4_2_EN=%b at %0s", expect_4, service, siemens_service, t4_2_EN, "ab_retentive.ladder:41");
    end
    reset_button = 1'd1;
    scan(1, 1'b0);
    reset_button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // ab_retentive.ladder:43
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b service=%b siemens_service=%b t3_ET=%b at %0s", expect_5, service, siemens_service, t3_ET, "ab_retentive.ladder:43");
    end
    scan(499, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // ab_retentive.ladder:45
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b service=%b siemens_service=%b at %0s", expect_6, service, siemens_service, "ab_retentive.ladder:45");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // ab_retentive.ladder:47
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b service=%b siemens_service=%b at %0s", expect_7, service, siemens_service, "ab_retentive.ladder:47");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "RES puts it back, and a pump that runs goes on from 0");
    end else $display("ok 2 - %0s", "RES puts it back, and a pump that runs goes on from 0");

    // while the button is held neither counts
    failed = 1'b0;
    reset;
    pump = 1'd1;
    scan(1, 1'b0);
    reset_button = 1'd1;
    scan(600, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // ab_retentive.ladder:52
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b siemens_service=%b t4_2_ACC=%b t3_ET=%b at %0s", expect_8, siemens_service, t4_2_ACC, t3_ET, "ab_retentive.ladder:52");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "while the button is held neither counts");
    end else $display("ok 3 - %0s", "while the button is held neither counts");

    // RES is a coil: the bits are off until the timer's own rung is executed again
    failed = 1'b0;
    reset;
    pump = 1'd1;
    scan(1, 1'b0);
    scan(100, 1'b1);
    reset_button = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // ab_retentive.ladder:58
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b t4_2_EN=%b t4_2_TT=%b t4_2_ACC=%b at %0s", expect_9, t4_2_EN, t4_2_TT, t4_2_ACC, "ab_retentive.ladder:58");
    end
    reset_button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // ab_retentive.ladder:60
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b t4_2_EN=%b t4_2_TT=%b at %0s", expect_10, t4_2_EN, t4_2_TT, "ab_retentive.ladder:60");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "RES is a coil: the bits are off until the timer's own rung is executed again");
    end else $display("ok 4 - %0s", "RES is a coil: the bits are off until the timer's own rung is executed again");

    // a preset that grows: DN stays on, Siemens' Q goes off and the time goes on
    failed = 1'b0;
    reset;
    pump = 1'd1;
    scan(1, 1'b0);
    scan(500, 1'b1);
    longer = 1'd1;
    scan(1, 1'b0);
    longer = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // ab_retentive.ladder:66
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b service=%b siemens_service=%b at %0s", expect_11, service, siemens_service, "ab_retentive.ladder:66");
    end
    scan(300, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // ab_retentive.ladder:68
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b siemens_service=%b t4_2_ACC=%b at %0s", expect_12, siemens_service, t4_2_ACC, "ab_retentive.ladder:68");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a preset that grows: DN stays on, Siemens' Q goes off and the time goes on");
    end else $display("ok 5 - %0s", "a preset that grows: DN stays on, Siemens' Q goes off and the time goes on");

    if (failures != 0) $display("# %0d of 5 tests failed", failures);
    $finish;
  end
endmodule
