// Made by hotrail 0.1.0 from drum_sequence.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// DIVIDER: divider of the tick, N = 1 tick
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module drum_sequence_test_DIVIDER_N1 (
  input  wire tick,
  output wire Q
);

  assign Q = tick;
endmodule

// DRUM: drum counter, TAPS = [1, 3, 5, 9]
// Fitted to PV = 12.
// Example, with PV = 3, TAPS = [1, 2]:
// IN   _#_#_#_#___
// EN   #########_#
// Q    _____####__
// TAP0 _########__
// TAP1 ___######__
// ACC  01122334400
module drum_sequence_test_DRUM_PV12 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        EN,
  output wire        Q_last,
  output wire [10:0] ACC_last,
  output wire        TAP0,
  output wire        TAP1,
  output wire        TAP2,
  output wire        TAP3
);
  reg Q = 1'b0;
  reg [10:0] ACC = 11'd0;
  reg was = 1'b0;
  reg ACC_at_least_3 = 1'b0;
  reg ACC_at_least_5 = 1'b0;
  reg ACC_at_least_9 = 1'b0;

  wire condition = power & ~was;
  wire unequal = ACC != 11'd2047;
  wire condition_2 = condition & unequal;
  wire [10:0] sum = ACC + {10'b0, condition_2};
  wire [10:0] ACC_next = EN ? sum : 11'd0;
  wire equal = ACC == 11'd11;
  wire choice = condition_2 ? equal | Q : Q;
  wire Q_next = EN & choice;
  wire equal_2 = ACC == 11'd0;
  wire equal_3 = ACC == 11'd2;
  wire choice_2 = condition_2 ? equal_3 | ACC_at_least_3 : ACC_at_least_3;
  wire ACC_at_least_3_next = EN & choice_2;
  wire equal_4 = ACC == 11'd4;
  wire choice_3 = condition_2 ? equal_4 | ACC_at_least_5 : ACC_at_least_5;
  wire ACC_at_least_5_next = EN & choice_3;
  wire equal_5 = ACC == 11'd8;
  wire choice_4 = condition_2 ? equal_5 | ACC_at_least_9 : ACC_at_least_9;
  wire ACC_at_least_9_next = EN & choice_4;

  assign Q_last = Q;
  assign ACC_last = ACC;
  assign TAP0 = ~(~EN | ~condition & equal_2);
  assign TAP1 = ACC_at_least_3_next;
  assign TAP2 = ACC_at_least_5_next;
  assign TAP3 = ACC_at_least_9_next;

  always @(posedge clk) begin
    if (rst) begin
      Q <= 1'b0;
      ACC <= 11'd0;
      was <= 1'b0;
      ACC_at_least_3 <= 1'b0;
      ACC_at_least_5 <= 1'b0;
      ACC_at_least_9 <= 1'b0;
    end else begin
      Q <= Q_next;
      ACC <= ACC_next;
      was <= power;
      ACC_at_least_3 <= ACC_at_least_3_next;
      ACC_at_least_5 <= ACC_at_least_5_next;
      ACC_at_least_9 <= ACC_at_least_9_next;
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
module drum_sequence_test_T0_1_PV10 (
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

module drum_sequence_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        start,
  input  wire        stop,
  output wire        water,
  output wire        heater,
  output wire        motor,
  output wire        pump,
  output wire        running,
  output wire [15:0] drum_ACC
);
  reg running_reg = 1'b0;
  reg water_reg = 1'b0;
  reg heater_reg = 1'b0;
  reg motor_reg = 1'b0;
  reg pump_reg = 1'b0;

  // units of time, each a pulse that all blocks share
  wire every_100ms_Q;
  drum_sequence_test_DIVIDER_N1 every_100ms (
    .tick(tick),
    .Q(every_100ms_Q)
  );

  // rung 1 "from start to the end of the programme", drum_sequence.ladder:9
  wire drum_Q_last;
  wire [10:0] drum_ACC_last;
  wire drum_TAP0;
  wire drum_TAP1;
  wire drum_TAP2;
  wire drum_TAP3;
  wire running_next = (start | running_reg) & ~stop & ~drum_Q_last;

  // rung 2 "a step each second", drum_sequence.ladder:12
  wire second_Q;
  wire second_Q_last;
  wire second_power = running_next & ~second_Q_last;
  wire second_EN = running_next & ~second_Q_last;
  drum_sequence_test_T0_1_PV10 second (
    .clk(clk),
    .rst(rst),
    .power(second_power),
    .EN(second_EN),
    .unit(every_100ms_Q),
    .Q(second_Q),
    .Q_last(second_Q_last)
  );
  drum_sequence_test_DRUM_PV12 drum (
    .clk(clk),
    .rst(rst),
    .power(second_Q),
    .EN(running_next),
    .Q_last(drum_Q_last),
    .ACC_last(drum_ACC_last),
    .TAP0(drum_TAP0),
    .TAP1(drum_TAP1),
    .TAP2(drum_TAP2),
    .TAP3(drum_TAP3)
  );

  // rung 3 "the steps, counted from the start", drum_sequence.ladder:15

  // rung 4 "water from step 1 to 3", drum_sequence.ladder:18
  wire water_next = drum_TAP0 & ~drum_TAP1;

  // rung 5 "heat from step 3 to 5", drum_sequence.ladder:21
  wire heater_next = drum_TAP1 & ~drum_TAP2;

  // rung 6 "turn from step 3 to 9", drum_sequence.ladder:24
  wire motor_next = drum_TAP1 & ~drum_TAP3;

  // rung 7 "pump off from step 9 to the end", drum_sequence.ladder:27
  wire pump_next = drum_TAP3 & running_next;
  wire [15:0] drum_ACC_value = {5'b0, drum_ACC_last};

  assign water = water_reg;
  assign heater = heater_reg;
  assign motor = motor_reg;
  assign pump = pump_reg;
  assign running = running_reg;
  assign drum_ACC = drum_ACC_value;

  always @(posedge clk) begin
    if (rst) begin
      running_reg <= 1'b0;
      water_reg <= 1'b0;
      heater_reg <= 1'b0;
      motor_reg <= 1'b0;
      pump_reg <= 1'b0;
    end else begin
      running_reg <= running_next;
      water_reg <= water_next;
      heater_reg <= heater_next;
      motor_reg <= motor_next;
      pump_reg <= pump_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module drum_sequence_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        running,
  input  wire        water,
  input  wire        heater,
  input  wire [15:0] drum_ACC,
  input  wire        motor,
  input  wire        pump,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_3_2,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_4_3,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_5_2,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_6_2,
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
  output wire        expect_10_2,
  output wire        expect_10_3,
  output wire        expect_11_0
);

  assign expect_0_0 = ~running;
  assign expect_0_1 = ~water;
  assign expect_1_0 = running;
  assign expect_1_1 = ~water;
  assign expect_2_0 = ~water;
  assign expect_3_0 = water;
  assign expect_3_1 = ~heater;
  assign expect_3_2 = drum_ACC == 16'd1;
  assign expect_4_0 = ~water;
  assign expect_4_1 = heater;
  assign expect_4_2 = motor;
  assign expect_4_3 = drum_ACC == 16'd3;
  assign expect_5_0 = ~heater;
  assign expect_5_1 = motor;
  assign expect_5_2 = drum_ACC == 16'd5;
  assign expect_6_0 = ~motor;
  assign expect_6_1 = pump;
  assign expect_6_2 = drum_ACC == 16'd9;
  assign expect_7_0 = pump;
  assign expect_7_1 = running;
  assign expect_8_0 = ~pump;
  assign expect_8_1 = ~running;
  assign expect_8_2 = drum_ACC == 16'd0;
  assign expect_9_0 = heater;
  assign expect_9_1 = motor;
  assign expect_9_2 = drum_ACC == 16'd4;
  assign expect_10_0 = ~heater;
  assign expect_10_1 = ~motor;
  assign expect_10_2 = ~running;
  assign expect_10_3 = drum_ACC == 16'd0;
  assign expect_11_0 = ~water;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module drum_sequence_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg stop = 1'd0;
  wire water;
  wire heater;
  wire motor;
  wire pump;
  wire running;
  wire [15:0] drum_ACC;
  reg failed;
  integer failures;

  drum_sequence_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .stop(stop),
    .water(water),
    .heater(heater),
    .motor(motor),
    .pump(pump),
    .running(running),
    .drum_ACC(drum_ACC)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire [0:1] expect_0 = {expect_0_0, expect_0_1};
  wire expect_1_0;
  wire expect_1_1;
  wire [0:1] expect_1 = {expect_1_0, expect_1_1};
  wire expect_2_0;
  wire [0:0] expect_2 = {expect_2_0};
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
  wire expect_5_2;
  wire [0:2] expect_5 = {expect_5_0, expect_5_1, expect_5_2};
  wire expect_6_0;
  wire expect_6_1;
  wire expect_6_2;
  wire [0:2] expect_6 = {expect_6_0, expect_6_1, expect_6_2};
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
  wire expect_10_2;
  wire expect_10_3;
  wire [0:3] expect_10 = {expect_10_0, expect_10_1, expect_10_2, expect_10_3};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  drum_sequence_expect expectations (
    .clk(clk),
    .rst(rst),
    .running(running),
    .water(water),
    .heater(heater),
    .drum_ACC(drum_ACC),
    .motor(motor),
    .pump(pump),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_4_3(expect_4_3),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_6_2(expect_6_2),
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
    .expect_10_2(expect_10_2),
    .expect_10_3(expect_10_3),
    .expect_11_0(expect_11_0)
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
      start = 1'd0;
      stop = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..2");

    // the programme, step by step
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // drum_sequence.ladder:32
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b running=%b water=%b at %0s", expect_0, running, water, "drum_sequence.ladder:32");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // drum_sequence.ladder:34
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b running=%b water=%b at %0s", expect_1, running, water, "drum_sequence.ladder:34");
    end
    scan(9, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // drum_sequence.ladder:36
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b water=%b at %0s", expect_2, water, "drum_sequence.ladder:36");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // drum_sequence.ladder:38
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b water=%b heater=%b drum_ACC=%b at %0s", expect_3, water, heater, drum_ACC, "drum_sequence.ladder:38");
    end
    repeat (2) begin
      scan(2, 1'b0);
      scan(10, 1'b1);
    end
    #1 if (!failed && &expect_4 !== 1'b1) begin // drum_sequence.ladder:40
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b water=%b heater=%b motor=%b drum_ACC=%b at %0s", expect_4, water, heater, motor, drum_ACC, "drum_sequence.ladder:40");
    end
    repeat (2) begin
      scan(2, 1'b0);
      scan(10, 1'b1);
    end
    #1 if (!failed && &expect_5 !== 1'b1) begin // drum_sequence.ladder:42
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b heater=%b motor=%b drum_ACC=%b at %0s", expect_5, heater, motor, drum_ACC, "drum_sequence.ladder:42");
    end
    repeat (4) begin
      scan(2, 1'b0);
      scan(10, 1'b1);
    end
    #1 if (!failed && &expect_6 !== 1'b1) begin // drum_sequence.ladder:44
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b motor=%b pump=%b drum_ACC=%b at %0s", expect_6, motor, pump, drum_ACC, "drum_sequence.ladder:44");
    end
    repeat (3) begin
      scan(2, 1'b0);
      scan(9, 1'b1);
      #1 if (!failed && &expect_7 !== 1'b1) begin // drum_sequence.ladder:47
        failed = 1'b1;
        $display("# failed expectation 7 conducts %b pump=%b running=%b at %0s", expect_7, pump, running, "drum_sequence.ladder:47");
      end
      scan(1, 1'b1);
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // drum_sequence.ladder:51
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b pump=%b running=%b drum_ACC=%b at %0s", expect_8, pump, running, drum_ACC, "drum_sequence.ladder:51");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "the programme, step by step");
    end else $display("ok 1 - %0s", "the programme, step by step");

    // stop puts the drum back
    failed = 1'b0;
    reset;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    repeat (3) begin
      scan(2, 1'b0);
      scan(10, 1'b1);
    end
    #1 if (!failed && &expect_9 !== 1'b1) begin // drum_sequence.ladder:57
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b heater=%b motor=%b drum_ACC=%b at %0s", expect_9, heater, motor, drum_ACC, "drum_sequence.ladder:57");
    end
    stop = 1'd1;
    scan(1, 1'b0);
    stop = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // drum_sequence.ladder:59
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b heater=%b motor=%b running=%b drum_ACC=%b at %0s", expect_10, heater, motor, running, drum_ACC, "drum_sequence.ladder:59");
    end
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(9, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // drum_sequence.ladder:62
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b water=%b at %0s", expect_11, water, "drum_sequence.ladder:62");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "stop puts the drum back");
    end else $display("ok 2 - %0s", "stop puts the drum back");

    if (failures != 0) $display("# %0d of 2 tests failed", failures);
    $finish;
  end
endmodule
