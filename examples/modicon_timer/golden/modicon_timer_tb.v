// Made by hotrail 0.1.0 from modicon_timer.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// DIVIDER: divider of the tick, N = 100 ticks
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module modicon_timer_test_DIVIDER_N100 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  output wire Q
);
  reg [6:0] CV = 7'd0;

  wire equal = CV == 7'd99;
  wire Q_value = tick & equal;
  wire [6:0] sum = CV + {6'b0, tick};
  wire [6:0] CV_next = Q_value ? 7'd0 : sum;

  assign Q = Q_value;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 7'd0;
    end else begin
      CV <= CV_next;
    end
  end
endmodule

// DIVIDER: divider of the tick, N = 10 ticks
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module modicon_timer_test_DIVIDER_N10 (
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

// T1_0: timer of seconds
// Fitted to PV = 5.
// Example, with PV = 3:
// IN  _#######__##__
// EN  ###########_##
// Q   ____#######___
// QN  ####_______###
// ACC 00123333333000
module modicon_timer_test_T1_0_PV5 (
  input  wire       clk,
  input  wire       rst,
  input  wire       power,
  input  wire       EN,
  input  wire       unit,
  output wire       Q,
  output wire       QN,
  output wire [2:0] ACC_last
);
  reg [2:0] ACC = 3'd0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire equal = ACC == 3'd5;
  wire [2:0] sum = ACC + {2'b0, ran_next & ran & unit & ~equal};
  wire [2:0] ACC_next = EN ? sum : 3'd0;
  wire equal_2 = ACC == 3'd4;
  wire Q_value = EN & (ran_next & ran & unit & equal_2 | equal);

  assign Q = Q_value;
  assign QN = ~Q_value;
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

// T1_0: timer of seconds
// Fitted to PV = 1.
// Example, with PV = 3:
// IN  _#######__##__
// EN  ###########_##
// Q   ____#######___
// QN  ####_______###
// ACC 00123333333000
module modicon_timer_test_T1_0_PV1 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  input  wire unit,
  output wire Q,
  output wire Q_last
);
  reg Q_reg = 1'b0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire Q_next = EN & (Q_reg ^ ran_next & ran & unit & ~Q_reg);

  assign Q = Q_next;
  assign Q_last = Q_reg;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      ran <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      ran <= ran_next;
    end
  end
endmodule

// T0_1: timer of tenths of a second
// Fitted to PV = 10.
// Example, with PV = 3:
// IN  _#######__##__
// EN  ###########_##
// Q   ____#######___
// QN  ####_______###
// ACC 00123333333000
module modicon_timer_test_T0_1_PV10 (
  input  wire       clk,
  input  wire       rst,
  input  wire       power,
  input  wire       EN,
  input  wire       unit,
  output wire       Q,
  output wire       Q_last,
  output wire [3:0] ACC_last
);
  reg Q_reg = 1'b0;
  reg [3:0] ACC = 4'd0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire equal = ACC == 4'd10;
  wire [3:0] sum = ACC + {3'b0, ran_next & ran & unit & ~equal};
  wire [3:0] ACC_next = EN ? sum : 4'd0;
  wire equal_2 = ACC == 4'd9;
  wire Q_next = EN & (ran_next & ran & unit & equal_2 | equal);

  assign Q = Q_next;
  assign Q_last = Q_reg;
  assign ACC_last = ACC;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      ACC <= 4'd0;
      ran <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      ACC <= ACC_next;
      ran <= ran_next;
    end
  end
endmodule

// T0_1: timer of tenths of a second
// Fitted to PV = 10.
// Example, with PV = 3:
// IN  _#######__##__
// EN  ###########_##
// Q   ____#######___
// QN  ####_______###
// ACC 00123333333000
module modicon_timer_test_T0_1_PV10_2 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  input  wire unit,
  output wire Q,
  output wire Q_last
);
  reg Q_reg = 1'b0;
  reg [3:0] ACC = 4'd0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire equal = ACC == 4'd10;
  wire [3:0] sum = ACC + {3'b0, ran_next & ran & unit & ~equal};
  wire [3:0] ACC_next = EN ? sum : 4'd0;
  wire equal_2 = ACC == 4'd9;
  wire Q_next = EN & (ran_next & ran & unit & equal_2 | equal);

  assign Q = Q_next;
  assign Q_last = Q_reg;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      ACC <= 4'd0;
      ran <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      ACC <= ACC_next;
      ran <= ran_next;
    end
  end
endmodule

module modicon_timer_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        in_10001,
  input  wire        in_10002,
  output wire        coil_00107,
  output wire        coil_00108,
  output wire        cascade_tenths,
  output wire        cascade_seconds,
  output wire [15:0] t40040_ACC,
  output wire        s1_Q,
  output wire        s2_Q,
  output wire        d1_Q,
  output wire        d2_Q,
  output wire [15:0] d1_ACC
);
  reg coil_00107_reg = 1'b0;
  reg coil_00108_reg = 1'b0;
  reg cascade_tenths_reg = 1'b0;
  reg cascade_seconds_reg = 1'b0;

  // units of time, each a pulse that all blocks share
  wire every_1s_Q;
  modicon_timer_test_DIVIDER_N100 every_1s (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .Q(every_1s_Q)
  );
  wire every_100ms_Q;
  modicon_timer_test_DIVIDER_N10 every_100ms (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .Q(every_100ms_Q)
  );

  // rung 1 "T1.0 with a preset of 5; its time is in 40040", modicon_timer.ladder:10
  wire t40040_Q;
  wire t40040_QN;
  wire [2:0] t40040_ACC_last;
  modicon_timer_test_T1_0_PV5 t40040 (
    .clk(clk),
    .rst(rst),
    .power(in_10001),
    .EN(in_10002),
    .unit(every_1s_Q),
    .Q(t40040_Q),
    .QN(t40040_QN),
    .ACC_last(t40040_ACC_last)
  );
  wire coil_00107_next = t40040_Q;

  // rung 2, modicon_timer.ladder:13
  wire coil_00108_next = t40040_QN;

  // rung 3 "two seconds of two timers with presets of 1", modicon_timer.ladder:15
  wire s1_Q_2;
  wire s1_Q_last;
  modicon_timer_test_T1_0_PV1 s1 (
    .clk(clk),
    .rst(rst),
    .power(in_10001),
    .EN(in_10002),
    .unit(every_1s_Q),
    .Q(s1_Q_2),
    .Q_last(s1_Q_last)
  );
  wire s2_Q_2;
  wire s2_Q_last;
  modicon_timer_test_T1_0_PV1 s2 (
    .clk(clk),
    .rst(rst),
    .power(s1_Q_2),
    .EN(in_10002),
    .unit(every_1s_Q),
    .Q(s2_Q_2),
    .Q_last(s2_Q_last)
  );
  wire cascade_seconds_next = s2_Q_2;

  // rung 4 "and of two with presets of 10, as the manual advises", modicon_timer.ladder:18
  wire d1_Q_2;
  wire d1_Q_last;
  wire [3:0] d1_ACC_last;
  modicon_timer_test_T0_1_PV10 d1 (
    .clk(clk),
    .rst(rst),
    .power(in_10001),
    .EN(in_10002),
    .unit(every_100ms_Q),
    .Q(d1_Q_2),
    .Q_last(d1_Q_last),
    .ACC_last(d1_ACC_last)
  );
  wire d2_Q_2;
  wire d2_Q_last;
  modicon_timer_test_T0_1_PV10_2 d2 (
    .clk(clk),
    .rst(rst),
    .power(d1_Q_2),
    .EN(in_10002),
    .unit(every_100ms_Q),
    .Q(d2_Q_2),
    .Q_last(d2_Q_last)
  );
  wire [15:0] t40040_ACC_value = {13'b0, t40040_ACC_last};
  wire [15:0] d1_ACC_value = {12'b0, d1_ACC_last};
  wire cascade_tenths_next = d2_Q_2;

  assign coil_00107 = coil_00107_reg;
  assign coil_00108 = coil_00108_reg;
  assign cascade_tenths = cascade_tenths_reg;
  assign cascade_seconds = cascade_seconds_reg;
  assign t40040_ACC = t40040_ACC_value;
  assign s1_Q = s1_Q_last;
  assign s2_Q = s2_Q_last;
  assign d1_Q = d1_Q_last;
  assign d2_Q = d2_Q_last;
  assign d1_ACC = d1_ACC_value;

  always @(posedge clk) begin
    if (rst) begin
      coil_00107_reg <= 1'b0;
      coil_00108_reg <= 1'b0;
      cascade_tenths_reg <= 1'b0;
      cascade_seconds_reg <= 1'b0;
    end else begin
      coil_00107_reg <= coil_00107_next;
      coil_00108_reg <= coil_00108_next;
      cascade_tenths_reg <= cascade_tenths_next;
      cascade_seconds_reg <= cascade_seconds_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module modicon_timer_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        coil_00107,
  input  wire        coil_00108,
  input  wire [15:0] t40040_ACC,
  input  wire        s1_Q,
  input  wire        s2_Q,
  input  wire        d1_Q,
  input  wire        d2_Q,
  input  wire        cascade_seconds,
  input  wire        cascade_tenths,
  input  wire [15:0] d1_ACC,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_2_2,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_3_2,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_5_0,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_7_2,
  output wire        expect_8_0,
  output wire        expect_9_0,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_10_2,
  output wire        expect_10_3,
  output wire        expect_11_0,
  output wire        expect_11_1,
  output wire        expect_12_0,
  output wire        expect_12_1,
  output wire        expect_13_0,
  output wire        expect_14_0,
  output wire        expect_14_1
);

  assign expect_0_0 = ~coil_00107;
  assign expect_0_1 = coil_00108;
  assign expect_0_2 = t40040_ACC == 16'd0;
  assign expect_1_0 = ~coil_00107;
  assign expect_1_1 = coil_00108;
  assign expect_2_0 = ~coil_00107;
  assign expect_2_1 = coil_00108;
  assign expect_2_2 = t40040_ACC == 16'd4;
  assign expect_3_0 = coil_00107;
  assign expect_3_1 = ~coil_00108;
  assign expect_3_2 = t40040_ACC == 16'd5;
  assign expect_4_0 = coil_00107;
  assign expect_4_1 = t40040_ACC == 16'd5;
  assign expect_5_0 = coil_00107;
  assign expect_6_0 = coil_00107;
  assign expect_6_1 = t40040_ACC == 16'd5;
  assign expect_7_0 = ~coil_00107;
  assign expect_7_1 = coil_00108;
  assign expect_7_2 = t40040_ACC == 16'd0;
  assign expect_8_0 = t40040_ACC == 16'd3;
  assign expect_9_0 = coil_00107;
  assign expect_10_0 = s1_Q;
  assign expect_10_1 = ~s2_Q;
  assign expect_10_2 = d1_Q;
  assign expect_10_3 = ~d2_Q;
  assign expect_11_0 = ~cascade_seconds;
  assign expect_11_1 = ~cascade_tenths;
  assign expect_12_0 = cascade_seconds;
  assign expect_12_1 = cascade_tenths;
  assign expect_13_0 = t40040_ACC == 16'd0;
  assign expect_14_0 = t40040_ACC == 16'd1;
  assign expect_14_1 = d1_ACC == 16'd1;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module modicon_timer_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg in_10001 = 1'd0;
  reg in_10002 = 1'd0;
  wire coil_00107;
  wire coil_00108;
  wire cascade_tenths;
  wire cascade_seconds;
  wire [15:0] t40040_ACC;
  wire s1_Q;
  wire s2_Q;
  wire d1_Q;
  wire d2_Q;
  wire [15:0] d1_ACC;
  reg failed;
  integer failures;

  modicon_timer_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .in_10001(in_10001),
    .in_10002(in_10002),
    .coil_00107(coil_00107),
    .coil_00108(coil_00108),
    .cascade_tenths(cascade_tenths),
    .cascade_seconds(cascade_seconds),
    .t40040_ACC(t40040_ACC),
    .s1_Q(s1_Q),
    .s2_Q(s2_Q),
    .d1_Q(d1_Q),
    .d2_Q(d2_Q),
    .d1_ACC(d1_ACC)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire [0:2] expect_0 = {expect_0_0, expect_0_1, expect_0_2};
  wire expect_1_0;
  wire expect_1_1;
  wire [0:1] expect_1 = {expect_1_0, expect_1_1};
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
  wire [0:1] expect_4 = {expect_4_0, expect_4_1};
  wire expect_5_0;
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire expect_7_2;
  wire [0:2] expect_7 = {expect_7_0, expect_7_1, expect_7_2};
  wire expect_8_0;
  wire [0:0] expect_8 = {expect_8_0};
  wire expect_9_0;
  wire [0:0] expect_9 = {expect_9_0};
  wire expect_10_0;
  wire expect_10_1;
  wire expect_10_2;
  wire expect_10_3;
  wire [0:3] expect_10 = {expect_10_0, expect_10_1, expect_10_2, expect_10_3};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire expect_12_1;
  wire [0:1] expect_12 = {expect_12_0, expect_12_1};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire expect_14_1;
  wire [0:1] expect_14 = {expect_14_0, expect_14_1};
  modicon_timer_expect expectations (
    .clk(clk),
    .rst(rst),
    .coil_00107(coil_00107),
    .coil_00108(coil_00108),
    .t40040_ACC(t40040_ACC),
    .s1_Q(s1_Q),
    .s2_Q(s2_Q),
    .d1_Q(d1_Q),
    .d2_Q(d2_Q),
    .cascade_seconds(cascade_seconds),
    .cascade_tenths(cascade_tenths),
    .d1_ACC(d1_ACC),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_2_2(expect_2_2),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_7_2(expect_7_2),
    .expect_8_0(expect_8_0),
    .expect_9_0(expect_9_0),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_10_2(expect_10_2),
    .expect_10_3(expect_10_3),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_14_1(expect_14_1)
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
      in_10001 = 1'd0;
      in_10002 = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..6");

    // without any power the bottom output conducts
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // modicon_timer.ladder:23
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b coil_00107=%b coil_00108=%b t40040_ACC=%b at %0s", expect_0, coil_00107, coil_00108, t40040_ACC, "modicon_timer.ladder:23");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "without any power the bottom output conducts");
    end else $display("ok 1 - %0s", "without any power the bottom output conducts");

    // five seconds
    failed = 1'b0;
    reset;
    in_10002 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // modicon_timer.ladder:27
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b coil_00107=%b coil_00108=%b at %0s", expect_1, coil_00107, coil_00108, "modicon_timer.ladder:27");
    end
    in_10001 = 1'd1;
    scan(1, 1'b0);
    scan(499, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // modicon_timer.ladder:30
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b coil_00107=%b coil_00108=%b t40040_ACC=%b at %0s", expect_2, coil_00107, coil_00108, t40040_ACC, "modicon_timer.ladder:30");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // modicon_timer.ladder:32
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b coil_00107=%b coil_00108=%b t40040_ACC=%b at %0s", expect_3, coil_00107, coil_00108, t40040_ACC, "modicon_timer.ladder:32");
    end
    scan(300, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // modicon_timer.ladder:34
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b coil_00107=%b t40040_ACC=%b at %0s", expect_4, coil_00107, t40040_ACC, "modicon_timer.ladder:34");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "five seconds");
    end else $display("ok 2 - %0s", "five seconds");

    // the enable circuit puts it back, the timing circuit does not
    failed = 1'b0;
    reset;
    in_10001 = 1'd1;
    in_10002 = 1'd1;
    scan(1, 1'b0);
    scan(500, 1'b1);
    #1 if (!failed && &expect_5 !== 1'b1) begin // modicon_timer.ladder:39
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b coil_00107=%b at %0s", expect_5, coil_00107, "modicon_timer.ladder:39");
    end
    in_10001 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // modicon_timer.ladder:41
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b coil_00107=%b t40040_ACC=%b at %0s", expect_6, coil_00107, t40040_ACC, "modicon_timer.ladder:41");
    end
    in_10002 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // modicon_timer.ladder:43
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b coil_00107=%b coil_00108=%b t40040_ACC=%b at %0s", expect_7, coil_00107, coil_00108, t40040_ACC, "modicon_timer.ladder:43");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "the enable circuit puts it back, the timing circuit does not");
    end else $display("ok 3 - %0s", "the enable circuit puts it back, the timing circuit does not");

    // retentive: the time with the timing circuit closed adds up
    failed = 1'b0;
    reset;
    in_10001 = 1'd1;
    in_10002 = 1'd1;
    scan(1, 1'b0);
    scan(300, 1'b1);
    in_10001 = 1'd0;
    scan(1000, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // modicon_timer.ladder:49
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b t40040_ACC=%b at %0s", expect_8, t40040_ACC, "modicon_timer.ladder:49");
    end
    in_10001 = 1'd1;
    scan(1, 1'b0);
    scan(200, 1'b1);
    #1 if (!failed && &expect_9 !== 1'b1) begin // modicon_timer.ladder:52
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b coil_00107=%b at %0s", expect_9, coil_00107, "modicon_timer.ladder:52");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "retentive: the time with the timing circuit closed adds up");
    end else $display("ok 4 - %0s", "retentive: the time with the timing circuit closed adds up");

    // cascades: the second timer starts with the pulse after the one that ends the first
    failed = 1'b0;
    reset;
    in_10001 = 1'd1;
    in_10002 = 1'd1;
    scan(1, 1'b0);
    scan(100, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // modicon_timer.ladder:57
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b s1_Q=%b s2_Q=%b d1_Q=%b d2_Q=%b at %0s", expect_10, s1_Q, s2_Q, d1_Q, d2_Q, "modicon_timer.ladder:57");
    end
    scan(99, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // modicon_timer.ladder:59
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b cascade_seconds=%b cascade_tenths=%b at %0s", expect_11, cascade_seconds, cascade_tenths, "modicon_timer.ladder:59");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // modicon_timer.ladder:61
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b cascade_seconds=%b cascade_tenths=%b at %0s", expect_12, cascade_seconds, cascade_tenths, "modicon_timer.ladder:61");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "cascades: the second timer starts with the pulse after the one that ends the first");
    end else $display("ok 5 - %0s", "cascades: the second timer starts with the pulse after the one that ends the first");

    // the first unit may be short: the pulses run free
    failed = 1'b0;
    reset;
    in_10002 = 1'd1;
    scan(90, 1'b1);
    in_10001 = 1'd1;
    scan(1, 1'b0);
    scan(9, 1'b1);
    #1 if (!failed && &expect_13 !== 1'b1) begin // modicon_timer.ladder:67
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b t40040_ACC=%b at %0s", expect_13, t40040_ACC, "modicon_timer.ladder:67");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_14 !== 1'b1) begin // modicon_timer.ladder:69
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b t40040_ACC=%b d1_ACC=%b at %0s", expect_14, t40040_ACC, d1_ACC, "modicon_timer.ladder:69");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "the first unit may be short: the pulses run free");
    end else $display("ok 6 - %0s", "the first unit may be short: the pulses run free");

    if (failures != 0) $display("# %0d of 6 tests failed", failures);
    $finish;
  end
endmodule
