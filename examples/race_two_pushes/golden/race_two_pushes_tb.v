// Made by hotrail 0.1.0 from race_two_pushes.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// CTU: up counter
// Fitted to PV = 2.
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module race_two_pushes_test_CTU_PV2 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        clear_after,
  output wire        Q,
  output wire [14:0] CV_last,
  output wire        CV_at_least_1
);
  reg [14:0] CV = 15'd0;
  reg was = 1'b0;

  wire condition = ~was;
  wire unequal = CV != 15'd32767;
  wire [14:0] sum = CV + {14'b0, power & condition & unequal};
  wire [14:0] CV_next = clear_after ? 15'd0 : sum;
  wire equal = CV == 15'd0;

  assign Q = sum >= 15'd2;
  assign CV_last = CV;
  assign CV_at_least_1 = ~(~(power & condition) & equal);

  always @(posedge clk) begin
    if (rst) begin
      CV <= 15'd0;
      was <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 20 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module race_two_pushes_test_TON_PT20 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  input  wire clear_after,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire equal = ET == 5'd20;
  wire [4:0] sum = ET + {4'b0, tick & ~equal};
  wire [4:0] choice = condition ? sum : 5'd0;
  wire equal_2 = ET == 5'd19;
  wire [4:0] ET_next = clear_after ? 5'd0 : choice;

  assign Q = condition & (tick & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

module race_two_pushes_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        button,
  input  wire        clear,
  output wire        won,
  output wire [15:0] pushes_CV
);
  reg won_reg = 1'b0;

  // rung 1 "count the pushes", race_two_pushes.ladder:10
  wire pushes_Q;
  wire [14:0] pushes_CV_last;
  wire pushes_CV_at_least_1;

  // rung 2 "the time runs from the first push on", race_two_pushes.ladder:13
  wire time_Q;

  // rung 3 "two pushes before the time is up", race_two_pushes.ladder:16
  wire won_rung3 = pushes_Q & ~time_Q | won_reg;

  // rung 4 "won or lost, the next push is a first one", race_two_pushes.ladder:19
  wire rung4_power = pushes_Q | time_Q;

  // rung 5 "clear", race_two_pushes.ladder:22
  wire won_next = won_rung3 & ~clear;
  wire [15:0] pushes_CV_value = {1'b0, pushes_CV_last};
  wire pushes_clear_after = rung4_power | clear;
  race_two_pushes_test_CTU_PV2 pushes (
    .clk(clk),
    .rst(rst),
    .power(button),
    .clear_after(pushes_clear_after),
    .Q(pushes_Q),
    .CV_last(pushes_CV_last),
    .CV_at_least_1(pushes_CV_at_least_1)
  );
  wire time_clear_after = rung4_power | clear;
  race_two_pushes_test_TON_PT20 time_u (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pushes_CV_at_least_1),
    .clear_after(time_clear_after),
    .Q(time_Q)
  );

  assign won = won_reg;
  assign pushes_CV = pushes_CV_value;

  always @(posedge clk) begin
    if (rst) begin
      won_reg <= 1'b0;
    end else begin
      won_reg <= won_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module race_two_pushes_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        won,
  input  wire [15:0] pushes_CV,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_1_0,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_4_0,
  output wire        expect_5_0,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_11_0,
  output wire        expect_12_0,
  output wire        expect_13_0,
  output wire        expect_14_0,
  output wire        expect_14_1,
  output wire        expect_15_0,
  output wire        expect_16_0,
  output wire        expect_16_1
);

  assign expect_0_0 = ~won;
  assign expect_0_1 = pushes_CV == 16'd1;
  assign expect_1_0 = won;
  assign expect_2_0 = pushes_CV == 16'd0;
  assign expect_2_1 = ~won;
  assign expect_3_0 = pushes_CV == 16'd1;
  assign expect_3_1 = ~won;
  assign expect_4_0 = pushes_CV == 16'd1;
  assign expect_5_0 = won;
  assign expect_6_0 = ~won;
  assign expect_6_1 = pushes_CV == 16'd0;
  assign expect_7_0 = ~won;
  assign expect_7_1 = pushes_CV == 16'd1;
  assign expect_8_0 = ~won;
  assign expect_8_1 = pushes_CV == 16'd0;
  assign expect_9_0 = ~won;
  assign expect_9_1 = pushes_CV == 16'd0;
  assign expect_10_0 = won;
  assign expect_10_1 = pushes_CV == 16'd0;
  assign expect_11_0 = won;
  assign expect_12_0 = won;
  assign expect_13_0 = ~won;
  assign expect_14_0 = ~won;
  assign expect_14_1 = pushes_CV == 16'd1;
  assign expect_15_0 = won;
  assign expect_16_0 = ~won;
  assign expect_16_1 = pushes_CV == 16'd0;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module race_two_pushes_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg button = 1'd0;
  reg clear = 1'd0;
  wire won;
  wire [15:0] pushes_CV;
  reg failed;
  integer failures;

  race_two_pushes_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .button(button),
    .clear(clear),
    .won(won),
    .pushes_CV(pushes_CV)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire [0:1] expect_0 = {expect_0_0, expect_0_1};
  wire expect_1_0;
  wire [0:0] expect_1 = {expect_1_0};
  wire expect_2_0;
  wire expect_2_1;
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire expect_3_1;
  wire [0:1] expect_3 = {expect_3_0, expect_3_1};
  wire expect_4_0;
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
  wire expect_8_0;
  wire expect_8_1;
  wire [0:1] expect_8 = {expect_8_0, expect_8_1};
  wire expect_9_0;
  wire expect_9_1;
  wire [0:1] expect_9 = {expect_9_0, expect_9_1};
  wire expect_10_0;
  wire expect_10_1;
  wire [0:1] expect_10 = {expect_10_0, expect_10_1};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire expect_14_1;
  wire [0:1] expect_14 = {expect_14_0, expect_14_1};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  wire expect_16_0;
  wire expect_16_1;
  wire [0:1] expect_16 = {expect_16_0, expect_16_1};
  race_two_pushes_expect expectations (
    .clk(clk),
    .rst(rst),
    .won(won),
    .pushes_CV(pushes_CV),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_14_1(expect_14_1),
    .expect_15_0(expect_15_0),
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
      button = 1'd0;
      clear = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..7");

    // the second push in the last moment
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(19, 1'b1);
    #1 if (!failed && &expect_0 !== 1'b1) begin // race_two_pushes.ladder:28
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b won=%b pushes_CV=%b at %0s", expect_0, won, pushes_CV, "race_two_pushes.ladder:28");
    end
    button = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // race_two_pushes.ladder:30
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b won=%b at %0s", expect_1, won, "race_two_pushes.ladder:30");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "the second push in the last moment");
    end else $display("ok 1 - %0s", "the second push in the last moment");

    // the second push a moment too late is a first one
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(20, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // race_two_pushes.ladder:35
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b pushes_CV=%b won=%b at %0s", expect_2, pushes_CV, won, "race_two_pushes.ladder:35");
    end
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // race_two_pushes.ladder:37
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b pushes_CV=%b won=%b at %0s", expect_3, pushes_CV, won, "race_two_pushes.ladder:37");
    end
    scan(19, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // race_two_pushes.ladder:39
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b pushes_CV=%b at %0s", expect_4, pushes_CV, "race_two_pushes.ladder:39");
    end
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // race_two_pushes.ladder:41
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b won=%b at %0s", expect_5, won, "race_two_pushes.ladder:41");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "the second push a moment too late is a first one");
    end else $display("ok 2 - %0s", "the second push a moment too late is a first one");

    // a push with the tick that ends the time is too late
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(19, 1'b1);
    button = 1'd1;
    scan(1, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // race_two_pushes.ladder:47
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b won=%b pushes_CV=%b at %0s", expect_6, won, pushes_CV, "race_two_pushes.ladder:47");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a push with the tick that ends the time is too late");
    end else $display("ok 3 - %0s", "a push with the tick that ends the time is too late");

    // a button that is held is pushed once
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    scan(19, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // race_two_pushes.ladder:52
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b won=%b pushes_CV=%b at %0s", expect_7, won, pushes_CV, "race_two_pushes.ladder:52");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // race_two_pushes.ladder:54
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b won=%b pushes_CV=%b at %0s", expect_8, won, pushes_CV, "race_two_pushes.ladder:54");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_9 !== 1'b1) begin // race_two_pushes.ladder:56
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b won=%b pushes_CV=%b at %0s", expect_9, won, pushes_CV, "race_two_pushes.ladder:56");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "a button that is held is pushed once");
    end else $display("ok 4 - %0s", "a button that is held is pushed once");

    // a race that is won stays won
    failed = 1'b0;
    reset;
    repeat (2) begin
      button = 1'd1;
      scan(1, 1'b0);
      button = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_10 !== 1'b1) begin // race_two_pushes.ladder:60
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b won=%b pushes_CV=%b at %0s", expect_10, won, pushes_CV, "race_two_pushes.ladder:60");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // race_two_pushes.ladder:62
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b won=%b at %0s", expect_11, won, "race_two_pushes.ladder:62");
    end
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(100, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // race_two_pushes.ladder:65
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b won=%b at %0s", expect_12, won, "race_two_pushes.ladder:65");
    end
    clear = 1'd1;
    scan(1, 1'b0);
    clear = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // race_two_pushes.ladder:67
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b won=%b at %0s", expect_13, won, "race_two_pushes.ladder:67");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "a race that is won stays won");
    end else $display("ok 5 - %0s", "a race that is won stays won");

    // clear in the middle of a race ends it
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    clear = 1'd1;
    scan(1, 1'b0);
    clear = 1'd0;
    scan(1, 1'b0);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // race_two_pushes.ladder:74
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b won=%b pushes_CV=%b at %0s", expect_14, won, pushes_CV, "race_two_pushes.ladder:74");
    end
    scan(19, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // race_two_pushes.ladder:77
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b won=%b at %0s", expect_15, won, "race_two_pushes.ladder:77");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "clear in the middle of a race ends it");
    end else $display("ok 6 - %0s", "clear in the middle of a race ends it");

    // clear wins over a push
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    button = 1'd1;
    clear = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_16 !== 1'b1) begin // race_two_pushes.ladder:82
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b won=%b pushes_CV=%b at %0s", expect_16, won, pushes_CV, "race_two_pushes.ladder:82");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "clear wins over a push");
    end else $display("ok 7 - %0s", "clear wins over a push");

    if (failures != 0) $display("# %0d of 7 tests failed", failures);
    $finish;
  end
endmodule
