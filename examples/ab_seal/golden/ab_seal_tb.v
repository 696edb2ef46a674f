// Made by hotrail 0.1.0 from ab_seal.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_TON: on-delay timer of Allen-Bradley, BASE = 1 tick, SIZE = DINT
// Fitted to PRE = 2000.
module ab_seal_test_AB_TON_BASE1_DINT_PRE2000 (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  output wire [30:0] ACC_last,
  output wire        EN,
  output wire        EN_last,
  output wire        DN
);
  reg [30:0] ACC = 31'd0;
  reg EN_reg = 1'b0;
  reg DN_reg = 1'b0;

  wire unequal = ACC != 31'd2147483647;
  wire [30:0] sum = ACC + {30'b0, power & EN_reg & ~DN_reg & tick & unequal};
  wire at_least = sum >= 31'd2000;
  wire DN_next = power & (DN_reg | at_least);
  wire [30:0] ACC_next = power ? sum : 31'd0;

  assign ACC_last = ACC;
  assign EN = power;
  assign EN_last = EN_reg;
  assign DN = DN_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 31'd0;
      EN_reg <= 1'b0;
      DN_reg <= 1'b0;
    end else begin
      ACC <= ACC_next;
      EN_reg <= power;
      DN_reg <= DN_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 2000 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module ab_seal_test_TON_PT2000 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [10:0] ET = 11'd0;
  reg was = 1'b0;
  reg ET_is_2000 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_2000;
  wire [10:0] sum = ET + 11'd1;
  wire [10:0] choice = condition_2 ? sum : ET;
  wire [10:0] ET_next = condition ? choice : 11'd0;
  wire equal = ET == 11'd1999;
  wire choice_2 = condition_2 ? equal : ET_is_2000;
  wire ET_is_2000_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_2000_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 11'd0;
      was <= 1'b0;
      ET_is_2000 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_2000 <= ET_is_2000_next;
    end
  end
endmodule

module ab_seal_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        start_pb,
  input  wire        stop_pb,
  output wire        motor,
  output wire        next_step,
  output wire        siemens_motor,
  output wire        siemens_next_step,
  output wire [31:0] delay_tmr_ACC
);
  reg siemens_motor_reg = 1'b0;
  reg motor_reg = 1'b0;
  reg next_step_reg = 1'b0;
  reg siemens_next_step_reg = 1'b0;

  // rung 1 "Delay_Tmr seals itself in", ab_seal.ladder:9
  wire [30:0] delay_tmr_ACC_last;
  wire delay_tmr_EN;
  wire delay_tmr_EN_last;
  wire delay_tmr_DN;
  wire delay_tmr_power = (start_pb | delay_tmr_EN_last) & stop_pb;
  ab_seal_test_AB_TON_BASE1_DINT_PRE2000 delay_tmr (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(delay_tmr_power),
    .ACC_last(delay_tmr_ACC_last),
    .EN(delay_tmr_EN),
    .EN_last(delay_tmr_EN_last),
    .DN(delay_tmr_DN)
  );

  // rung 2, ab_seal.ladder:12
  wire motor_next = delay_tmr_EN;

  // rung 3, ab_seal.ladder:14
  wire next_step_next = delay_tmr_DN;

  // rung 4 "the same with Siemens' timer, which has no EN: a coil seals", ab_seal.ladder:16
  wire siemens_motor_next = (start_pb | siemens_motor_reg) & stop_pb;
  wire t1_Q;
  ab_seal_test_TON_PT2000 t1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(siemens_motor_next),
    .Q(t1_Q)
  );
  wire [31:0] delay_tmr_ACC_value = {1'b0, delay_tmr_ACC_last};
  wire siemens_next_step_next = t1_Q;

  assign motor = motor_reg;
  assign next_step = next_step_reg;
  assign siemens_motor = siemens_motor_reg;
  assign siemens_next_step = siemens_next_step_reg;
  assign delay_tmr_ACC = delay_tmr_ACC_value;

  always @(posedge clk) begin
    if (rst) begin
      siemens_motor_reg <= 1'b0;
      motor_reg <= 1'b0;
      next_step_reg <= 1'b0;
      siemens_next_step_reg <= 1'b0;
    end else begin
      siemens_motor_reg <= siemens_motor_next;
      motor_reg <= motor_next;
      next_step_reg <= next_step_next;
      siemens_next_step_reg <= siemens_next_step_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module ab_seal_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        motor,
  input  wire        siemens_motor,
  input  wire        next_step,
  input  wire        siemens_next_step,
  input  wire [31:0] delay_tmr_ACC,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_1_2,
  output wire        expect_1_3,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_3_2,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_4_3,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_7_2,
  output wire        expect_7_3
);

  assign expect_0_0 = ~motor;
  assign expect_0_1 = ~siemens_motor;
  assign expect_1_0 = motor;
  assign expect_1_1 = siemens_motor;
  assign expect_1_2 = ~next_step;
  assign expect_1_3 = ~siemens_next_step;
  assign expect_2_0 = ~next_step;
  assign expect_2_1 = ~siemens_next_step;
  assign expect_3_0 = next_step;
  assign expect_3_1 = siemens_next_step;
  assign expect_3_2 = delay_tmr_ACC == 32'd2000;
  assign expect_4_0 = ~motor;
  assign expect_4_1 = ~siemens_motor;
  assign expect_4_2 = ~next_step;
  assign expect_4_3 = ~siemens_next_step;
  assign expect_5_0 = ~motor;
  assign expect_5_1 = ~siemens_motor;
  assign expect_6_0 = ~motor;
  assign expect_6_1 = ~siemens_motor;
  assign expect_7_0 = ~motor;
  assign expect_7_1 = ~next_step;
  assign expect_7_2 = ~siemens_motor;
  assign expect_7_3 = ~siemens_next_step;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module ab_seal_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start_pb = 1'd0;
  reg stop_pb = 1'd0;
  wire motor;
  wire next_step;
  wire siemens_motor;
  wire siemens_next_step;
  wire [31:0] delay_tmr_ACC;
  reg failed;
  integer failures;

  ab_seal_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start_pb(start_pb),
    .stop_pb(stop_pb),
    .motor(motor),
    .next_step(next_step),
    .siemens_motor(siemens_motor),
    .siemens_next_step(siemens_next_step),
    .delay_tmr_ACC(delay_tmr_ACC)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire [0:1] expect_0 = {expect_0_0, expect_0_1};
  wire expect_1_0;
  wire expect_1_1;
  wire expect_1_2;
  wire expect_1_3;
  wire [0:3] expect_1 = {expect_1_0, expect_1_1, expect_1_2, expect_1_3};
  wire expect_2_0;
  wire expect_2_1;
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire expect_3_1;
  wire expect_3_2;
  wire [0:2] expect_3 = {expect_3_0, expect_3_1, expect_3_2};
  wire expect_4_0;
  wire expect_4_1;
  wire expect_4_2;
  wire expect_4_3;
  wire [0:3] expect_4 = {expect_4_0, expect_4_1, expect_4_2, expect_4_3};
  wire expect_5_0;
  wire expect_5_1;
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire expect_7_2;
  wire expect_7_3;
  wire [0:3] expect_7 = {expect_7_0, expect_7_1, expect_7_2, expect_7_3};
  ab_seal_expect expectations (
    .clk(clk),
    .rst(rst),
    .motor(motor),
    .siemens_motor(siemens_motor),
    .next_step(next_step),
    .siemens_next_step(siemens_next_step),
    .delay_tmr_ACC(delay_tmr_ACC),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_1_3(expect_1_3),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_4_3(expect_4_3),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_7_2(expect_7_2),
    .expect_7_3(expect_7_3)
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
      start_pb = 1'd0;
      stop_pb = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..3");

    // start, two seconds, stop
    failed = 1'b0;
    reset;
    stop_pb = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // ab_seal.ladder:21
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b motor=%b siemens_motor=%b at %0s", expect_0, motor, siemens_motor, "ab_seal.ladder:21");
    end
    start_pb = 1'd1;
    scan(1, 1'b0);
    start_pb = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // ab_seal.ladder:23
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b motor=%b siemens_motor=%b next_step=%b siemens_next_step=%b at %0s", expect_1, motor, siemens_motor, next_step, siemens_next_step, "ab_seal.ladder:23");
    end
    scan(1999, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // ab_seal.ladder:25
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b next_step=%b siemens_next_step=%b at %0s", expect_2, next_step, siemens_next_step, "ab_seal.ladder:25");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // ab_seal.ladder:27
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b next_step=%b siemens_next_step=%b delay_tmr_ACC=%b at %0s", expect_3, next_step, siemens_next_step, delay_tmr_ACC, "ab_seal.ladder:27");
    end
    stop_pb = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // ab_seal.ladder:29
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b motor=%b siemens_motor=%b next_step=%b siemens_next_step=%b at %0s", expect_4, motor, siemens_motor, next_step, siemens_next_step, "ab_seal.ladder:29");
    end
    stop_pb = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // ab_seal.ladder:31
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b motor=%b siemens_motor=%b at %0s", expect_5, motor, siemens_motor, "ab_seal.ladder:31");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "start, two seconds, stop");
    end else $display("ok 1 - %0s", "start, two seconds, stop");

    // stop wins over start
    failed = 1'b0;
    reset;
    start_pb = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // ab_seal.ladder:35
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b motor=%b siemens_motor=%b at %0s", expect_6, motor, siemens_motor, "ab_seal.ladder:35");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "stop wins over start");
    end else $display("ok 2 - %0s", "stop wins over start");

    // nothing runs after reset with the start button released
    failed = 1'b0;
    reset;
    stop_pb = 1'd1;
    scan(1, 1'b0);
    scan(3000, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // ab_seal.ladder:39
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b motor=%b next_step=%b siemens_motor=%b siemens_next_step=%b at %0s", expect_7, motor, next_step, siemens_motor, siemens_next_step, "ab_seal.ladder:39");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "nothing runs after reset with the start button released");
    end else $display("ok 3 - %0s", "nothing runs after reset with the start button released");

    if (failures != 0) $display("# %0d of 3 tests failed", failures);
    $finish;
  end
endmodule
