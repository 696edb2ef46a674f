// Made by hotrail 0.1.0 from paper_timers.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// DIVIDER: divider of the tick, N = 10 ticks
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module paper_timers_test_DIVIDER_N10 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  output wire Q
);
  reg [3:0] CV = 4'd0;

  wire equal = CV == 4'd9;
  wire Q_value = tick & equal;
  wire [3:0] sum = CV + {3'b0, tick};
  wire [3:0] CV_next = Q_value ? 4'd0 : sum;

  assign Q = Q_value;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 4'd0;
    end else begin
      CV <= CV_next;
    end
  end
endmodule

// DIVIDER: divider of the tick, N = 1 tick
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module paper_timers_test_DIVIDER_N1 (
  input  wire tick,
  output wire Q
);

  assign Q = tick;
endmodule

// TS: timer of seconds in three modes, MODE = OFF
// Fitted to PV = 3.
// Example, with PV = 3:
// IN  _##_____#__#_____
// Q   _#####__#######__
// QN  #_____##_______##
// ACC 00001233001001233
module paper_timers_test_TS_OFF_PV3 (
  input  wire       clk,
  input  wire       rst,
  input  wire       power,
  input  wire       EN,
  input  wire       unit,
  output wire       Q,
  output wire [1:0] ACC_last
);
  reg [1:0] ACC = 2'd0;
  reg run = 1'b0;
  reg was = 1'b0;

  wire equal = ACC == 2'd3;
  wire [1:0] sum = ACC + {1'b0, run & unit & ~equal};
  wire condition = run & was;
  wire [1:0] choice = condition ? 2'd0 : sum;
  wire [1:0] choice_2 = power ? 2'd0 : choice;
  wire equal_2 = ACC == 2'd2;
  wire condition_2 = power | run & ~(~power & ~condition & (run & unit & equal_2 | equal));
  wire [1:0] ACC_next = EN ? choice_2 : 2'd0;
  wire run_next = EN & condition_2;

  assign Q = EN & condition_2;
  assign ACC_last = ACC;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 2'd0;
      run <= 1'b0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      run <= run_next;
      was <= power;
    end
  end
endmodule

// TT: timer of tenths of a second in three modes
// Fitted to PV = 5.
// Example, with PV = 3:
// IN  _#######__##__
// EN  ###########_##
// Q   ____#######___
// QN  ####_______###
// ACC 00123333333000
module paper_timers_test_TT_PV5 (
  input  wire       clk,
  input  wire       rst,
  input  wire       power,
  input  wire       EN,
  input  wire       unit,
  output wire       Q,
  output wire [2:0] ACC_last
);
  reg [2:0] ACC = 3'd0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire equal = ACC == 3'd5;
  wire [2:0] sum = ACC + {2'b0, ran_next & ran & unit & ~equal};
  wire [2:0] ACC_next = EN ? sum : 3'd0;
  wire equal_2 = ACC == 3'd4;

  assign Q = EN & (ran_next & ran & unit & equal_2 | equal);
  assign ACC_last = ACC;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 3'd0;
      ran <= 1'b0;
    end else begin
      ACC <= ACC_next;
      ran <= ran_next;
    end
  end
endmodule

// TT: timer of tenths of a second in three modes, MODE = INTERVAL
// Fitted to PV = 4.
// Example, with PV = 3:
// IN  _#####_#_#__
// Q   _###___###__
// QN  #___###___##
// ACC 001233001200
module paper_timers_test_TT_INTERVAL_PV4 (
  input  wire       clk,
  input  wire       rst,
  input  wire       power,
  input  wire       EN,
  input  wire       unit,
  output wire       Q,
  output wire [2:0] ACC_last
);
  reg [2:0] ACC = 3'd0;
  reg run = 1'b0;
  reg was = 1'b0;

  wire equal = ACC == 3'd4;
  wire [2:0] sum = ACC + {2'b0, unit & ~equal};
  wire equal_2 = ACC == 3'd3;
  wire condition = power & ~was;
  wire [2:0] choice = condition ? 3'd0 : ACC;
  wire [2:0] choice_2 = run ? sum : choice;
  wire choice_3 = run ? ~(unit & equal_2 | equal) : condition;
  wire [2:0] choice_4 = (choice_3 | power) ? choice_2 : 3'd0;
  wire [2:0] ACC_next = EN ? choice_4 : 3'd0;
  wire run_next = EN & choice_3;

  assign Q = EN & choice_3;
  assign ACC_last = ACC;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 3'd0;
      run <= 1'b0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      run <= run_next;
      was <= power;
    end
  end
endmodule

module paper_timers_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        c1,
  input  wire        c2,
  input  wire        c3,
  input  wire        c4,
  input  wire        c5,
  input  wire        c6,
  input  wire        c7,
  input  wire        c8,
  input  wire        c9,
  input  wire        enable_ckt,
  output wire        timer_off_coil,
  output wire        timer_on_coil,
  output wire        timer_interval_coil,
  output wire [15:0] actual_tt_ACC,
  output wire [15:0] interval_tt_ACC,
  output wire [15:0] actual_ts_ACC
);
  reg timer_off_coil_reg = 1'b0;
  reg timer_on_coil_reg = 1'b0;
  reg timer_interval_coil_reg = 1'b0;

  // units of time, each a pulse that all blocks share
  wire every_1s_Q;
  paper_timers_test_DIVIDER_N10 every_1s (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .Q(every_1s_Q)
  );
  wire every_100ms_Q;
  paper_timers_test_DIVIDER_N1 every_100ms (
    .tick(tick),
    .Q(every_100ms_Q)
  );

  // rung 1 "the paper's Figure 14", paper_timers.ladder:11
  wire rung1_power = c9 | c2 & c3 & c4;
  wire timing_ckt = rung1_power & c1 | (c5 | rung1_power & c6) & (c7 & c8 | c6 & c1);

  // rung 2 "timer_type 00: off-delay, 3 s", paper_timers.ladder:20
  wire actual_ts_Q;
  wire [1:0] actual_ts_ACC_last;
  paper_timers_test_TS_OFF_PV3 actual_ts (
    .clk(clk),
    .rst(rst),
    .power(timing_ckt),
    .EN(enable_ckt),
    .unit(every_1s_Q),
    .Q(actual_ts_Q),
    .ACC_last(actual_ts_ACC_last)
  );
  wire timer_off_coil_next = actual_ts_Q;

  // rung 3 "timer_type 01: on-delay, 5 tenths", paper_timers.ladder:23
  wire actual_tt_Q;
  wire [2:0] actual_tt_ACC_last;
  paper_timers_test_TT_PV5 actual_tt (
    .clk(clk),
    .rst(rst),
    .power(timing_ckt),
    .EN(enable_ckt),
    .unit(every_100ms_Q),
    .Q(actual_tt_Q),
    .ACC_last(actual_tt_ACC_last)
  );
  wire timer_on_coil_next = actual_tt_Q;

  // rung 4 "timer_type 1x: interval-delay, 4 tenths", paper_timers.ladder:26
  wire interval_tt_Q;
  wire [2:0] interval_tt_ACC_last;
  paper_timers_test_TT_INTERVAL_PV4 interval_tt (
    .clk(clk),
    .rst(rst),
    .power(timing_ckt),
    .EN(enable_ckt),
    .unit(every_100ms_Q),
    .Q(interval_tt_Q),
    .ACC_last(interval_tt_ACC_last)
  );
  wire [15:0] actual_tt_ACC_value = {13'b0, actual_tt_ACC_last};
  wire [15:0] interval_tt_ACC_value = {13'b0, interval_tt_ACC_last};
  wire [15:0] actual_ts_ACC_value = {14'b0, actual_ts_ACC_last};
  wire timer_interval_coil_next = interval_tt_Q;

  assign timer_off_coil = timer_off_coil_reg;
  assign timer_on_coil = timer_on_coil_reg;
  assign timer_interval_coil = timer_interval_coil_reg;
  assign actual_tt_ACC = actual_tt_ACC_value;
  assign interval_tt_ACC = interval_tt_ACC_value;
  assign actual_ts_ACC = actual_ts_ACC_value;

  always @(posedge clk) begin
    if (rst) begin
      timer_off_coil_reg <= 1'b0;
      timer_on_coil_reg <= 1'b0;
      timer_interval_coil_reg <= 1'b0;
    end else begin
      timer_off_coil_reg <= timer_off_coil_next;
      timer_on_coil_reg <= timer_on_coil_next;
      timer_interval_coil_reg <= timer_interval_coil_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module paper_timers_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        timer_on_coil,
  input  wire [15:0] actual_tt_ACC,
  input  wire        timer_interval_coil,
  input  wire [15:0] interval_tt_ACC,
  input  wire        timer_off_coil,
  input  wire [15:0] actual_ts_ACC,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_4_0,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_6_0,
  output wire        expect_7_0,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_10_2,
  output wire        expect_11_0,
  output wire        expect_11_1,
  output wire        expect_11_2
);

  assign expect_0_0 = ~timer_on_coil;
  assign expect_0_1 = actual_tt_ACC == 16'd4;
  assign expect_1_0 = timer_on_coil;
  assign expect_1_1 = actual_tt_ACC == 16'd5;
  assign expect_2_0 = timer_on_coil;
  assign expect_2_1 = actual_tt_ACC == 16'd5;
  assign expect_3_0 = ~timer_on_coil;
  assign expect_3_1 = actual_tt_ACC == 16'd0;
  assign expect_4_0 = timer_interval_coil;
  assign expect_5_0 = timer_interval_coil;
  assign expect_5_1 = interval_tt_ACC == 16'd3;
  assign expect_6_0 = ~timer_interval_coil;
  assign expect_7_0 = timer_off_coil;
  assign expect_8_0 = timer_off_coil;
  assign expect_8_1 = actual_ts_ACC == 16'd2;
  assign expect_9_0 = ~timer_off_coil;
  assign expect_9_1 = actual_ts_ACC == 16'd3;
  assign expect_10_0 = ~timer_off_coil;
  assign expect_10_1 = ~timer_on_coil;
  assign expect_10_2 = ~timer_interval_coil;
  assign expect_11_0 = timer_off_coil;
  assign expect_11_1 = ~timer_on_coil;
  assign expect_11_2 = ~timer_interval_coil;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module paper_timers_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg c1 = 1'd0;
  reg c2 = 1'd0;
  reg c3 = 1'd0;
  reg c4 = 1'd0;
  reg c5 = 1'd0;
  reg c6 = 1'd0;
  reg c7 = 1'd0;
  reg c8 = 1'd0;
  reg c9 = 1'd0;
  reg enable_ckt = 1'd0;
  wire timer_off_coil;
  wire timer_on_coil;
  wire timer_interval_coil;
  wire [15:0] actual_tt_ACC;
  wire [15:0] interval_tt_ACC;
  wire [15:0] actual_ts_ACC;
  reg failed;
  integer failures;

  paper_timers_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .c1(c1),
    .c2(c2),
    .c3(c3),
    .c4(c4),
    .c5(c5),
    .c6(c6),
    .c7(c7),
    .c8(c8),
    .c9(c9),
    .enable_ckt(enable_ckt),
    .timer_off_coil(timer_off_coil),
    .timer_on_coil(timer_on_coil),
    .timer_interval_coil(timer_interval_coil),
    .actual_tt_ACC(actual_tt_ACC),
    .interval_tt_ACC(interval_tt_ACC),
    .actual_ts_ACC(actual_ts_ACC)
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
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire expect_5_1;
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  wire expect_6_0;
  wire [0:0] expect_6 = {expect_6_0};
  wire expect_7_0;
  wire [0:0] expect_7 = {expect_7_0};
  wire expect_8_0;
  wire expect_8_1;
  wire [0:1] expect_8 = {expect_8_0, expect_8_1};
  wire expect_9_0;
  wire expect_9_1;
  wire [0:1] expect_9 = {expect_9_0, expect_9_1};
  wire expect_10_0;
  wire expect_10_1;
  wire expect_10_2;
  wire [0:2] expect_10 = {expect_10_0, expect_10_1, expect_10_2};
  wire expect_11_0;
  wire expect_11_1;
  wire expect_11_2;
  wire [0:2] expect_11 = {expect_11_0, expect_11_1, expect_11_2};
  paper_timers_expect expectations (
    .clk(clk),
    .rst(rst),
    .timer_on_coil(timer_on_coil),
    .actual_tt_ACC(actual_tt_ACC),
    .timer_interval_coil(timer_interval_coil),
    .interval_tt_ACC(interval_tt_ACC),
    .timer_off_coil(timer_off_coil),
    .actual_ts_ACC(actual_ts_ACC),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_7_0(expect_7_0),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_10_2(expect_10_2),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_11_2(expect_11_2)
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
      c1 = 1'd0;
      c2 = 1'd0;
      c3 = 1'd0;
      c4 = 1'd0;
      c5 = 1'd0;
      c6 = 1'd0;
      c7 = 1'd0;
      c8 = 1'd0;
      c9 = 1'd0;
      enable_ckt = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..4");

    // on-delay: 0.5 s of power, kept while the enable circuit conducts
    failed = 1'b0;
    reset;
    enable_ckt = 1'd1;
    c9 = 1'd1;
    c1 = 1'd1;
    scan(1, 1'b0);
    scan(4, 1'b1);
    #1 if (!failed && &expect_0 !== 1'b1) begin // paper_timers.ladder:32
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b timer_on_coil=%b actual_tt_ACC=%b at %0s", expect_0, timer_on_coil, actual_tt_ACC, "paper_timers.ladder:32");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // paper_timers.ladder:34
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b timer_on_coil=%b actual_tt_ACC=%b at %0s", expect_1, timer_on_coil, actual_tt_ACC, "paper_timers.ladder:34");
    end
    c1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // paper_timers.ladder:36
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b timer_on_coil=%b actual_tt_ACC=%b at %0s", expect_2, timer_on_coil, actual_tt_ACC, "paper_timers.ladder:36");
    end
    enable_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // paper_timers.ladder:38
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b timer_on_coil=%b actual_tt_ACC=%b at %0s", expect_3, timer_on_coil, actual_tt_ACC, "paper_timers.ladder:38");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "on-delay: 0.5 s of power, kept while the enable circuit conducts");
    end else $display("ok 1 - %0s", "on-delay: 0.5 s of power, kept while the enable circuit conducts");

    // interval-delay: 0.4 s from the rise, whatever the power does then
    failed = 1'b0;
    reset;
    enable_ckt = 1'd1;
    c5 = 1'd1;
    c7 = 1'd1;
    c8 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // paper_timers.ladder:42
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b timer_interval_coil=%b at %0s", expect_4, timer_interval_coil, "paper_timers.ladder:42");
    end
    c5 = 1'd0;
    scan(1, 1'b0);
    scan(3, 1'b1);
    #1 if (!failed && &expect_5 !== 1'b1) begin // paper_timers.ladder:45
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b timer_interval_coil=%b interval_tt_ACC=%b at %0s", expect_5, timer_interval_coil, interval_tt_ACC, "paper_timers.ladder:45");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // paper_timers.ladder:47
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b timer_interval_coil=%b at %0s", expect_6, timer_interval_coil, "paper_timers.ladder:47");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "interval-delay: 0.4 s from the rise, whatever the power does then");
    end else $display("ok 2 - %0s", "interval-delay: 0.4 s from the rise, whatever the power does then");

    // off-delay: with the power, and 3 s longer
    failed = 1'b0;
    reset;
    enable_ckt = 1'd1;
    c5 = 1'd1;
    c6 = 1'd1;
    c1 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // paper_timers.ladder:51
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b timer_off_coil=%b at %0s", expect_7, timer_off_coil, "paper_timers.ladder:51");
    end
    scan(9, 1'b1);
    c6 = 1'd0;
    scan(1, 1'b0);
    scan(20, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // paper_timers.ladder:55
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b timer_off_coil=%b actual_ts_ACC=%b at %0s", expect_8, timer_off_coil, actual_ts_ACC, "paper_timers.ladder:55");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_9 !== 1'b1) begin // paper_timers.ladder:57
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b timer_off_coil=%b actual_ts_ACC=%b at %0s", expect_9, timer_off_coil, actual_ts_ACC, "paper_timers.ladder:57");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "off-delay: with the power, and 3 s longer");
    end else $display("ok 3 - %0s", "off-delay: with the power, and 3 s longer");

    // the enable circuit holds all three in their reset state
    failed = 1'b0;
    reset;
    c9 = 1'd1;
    c1 = 1'd1;
    scan(10, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // paper_timers.ladder:61
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b timer_off_coil=%b timer_on_coil=%b timer_interval_coil=%b at %0s", expect_10, timer_off_coil, timer_on_coil, timer_interval_coil, "paper_timers.ladder:61");
    end
    enable_ckt = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_11 !== 1'b1) begin // paper_timers.ladder:63
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b timer_off_coil=%b timer_on_coil=%b timer_interval_coil=%b at %0s", expect_11, timer_off_coil, timer_on_coil, timer_interval_coil, "paper_timers.ladder:63");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "the enable circuit holds all three in their reset state");
    end else $display("ok 4 - %0s", "the enable circuit holds all three in their reset state");

    if (failures != 0) $display("# %0d of 4 tests failed", failures);
    $finish;
  end
endmodule
