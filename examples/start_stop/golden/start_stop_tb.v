// Made by hotrail 0.1.0 from start_stop.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 5000 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module start_stop_test_TON_PT5000 (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  output wire        Q,
  output wire [12:0] ET_last
);
  reg [12:0] ET = 13'd0;
  reg was = 1'b0;
  reg ET_is_5000 = 1'b0;

  wire condition = power & was;
  wire [12:0] sum = ET + {12'b0, tick & ~ET_is_5000};
  wire [12:0] ET_next = condition ? sum : 13'd0;
  wire equal = ET == 13'd4999;
  wire ET_is_5000_next = condition & (tick & equal | ET_is_5000);

  assign Q = ET_is_5000_next;
  assign ET_last = ET;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 13'd0;
      was <= 1'b0;
      ET_is_5000 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_5000 <= ET_is_5000_next;
    end
  end
endmodule

module start_stop_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        start,
  input  wire        stop,
  output wire        motor,
  output wire        lamp,
  output wire [31:0] delay_ET
);
  reg motor_reg = 1'b0;
  reg lamp_reg = 1'b0;

  // rung 1 "seal-in", start_stop.ladder:7
  wire motor_next = (start | motor_reg) & ~stop;

  // rung 2 "lamp after five seconds", start_stop.ladder:10
  wire delay_Q;
  wire [12:0] delay_ET_last;
  start_stop_test_TON_PT5000 delay (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(motor_next),
    .Q(delay_Q),
    .ET_last(delay_ET_last)
  );
  wire [31:0] delay_ET_value = {19'b0, delay_ET_last};
  wire lamp_next = delay_Q;

  assign motor = motor_reg;
  assign lamp = lamp_reg;
  assign delay_ET = delay_ET_value;

  always @(posedge clk) begin
    if (rst) begin
      motor_reg <= 1'b0;
      lamp_reg <= 1'b0;
    end else begin
      motor_reg <= motor_next;
      lamp_reg <= lamp_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module start_stop_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        motor,
  input  wire        lamp,
  input  wire [31:0] delay_ET,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_4_0,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_5_2,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_6_2
);

  assign expect_0_0 = motor;
  assign expect_0_1 = ~lamp;
  assign expect_1_0 = motor;
  assign expect_1_1 = lamp;
  assign expect_2_0 = ~motor;
  assign expect_2_1 = ~lamp;
  assign expect_3_0 = ~motor;
  assign expect_4_0 = motor;
  assign expect_5_0 = motor;
  assign expect_5_1 = ~lamp;
  assign expect_5_2 = delay_ET == 32'd4999;
  assign expect_6_0 = ~motor;
  assign expect_6_1 = ~lamp;
  assign expect_6_2 = delay_ET == 32'd0;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module start_stop_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg stop = 1'd0;
  wire motor;
  wire lamp;
  wire [31:0] delay_ET;
  reg failed;
  integer failures;

  start_stop_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .stop(stop),
    .motor(motor),
    .lamp(lamp),
    .delay_ET(delay_ET)
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
  wire [0:0] expect_3 = {expect_3_0};
  wire expect_4_0;
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire expect_5_1;
  wire expect_5_2;
  wire [0:2] expect_5 = {expect_5_0, expect_5_1, expect_5_2};
  wire expect_6_0;
  wire expect_6_1;
  wire expect_6_2;
  wire [0:2] expect_6 = {expect_6_0, expect_6_1, expect_6_2};
  start_stop_expect expectations (
    .clk(clk),
    .rst(rst),
    .motor(motor),
    .lamp(lamp),
    .delay_ET(delay_ET),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_6_2(expect_6_2)
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
    $display("1..3");

    // stop drops the motor, the lamp needs five seconds
    failed = 1'b0;
    reset;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // start_stop.ladder:15
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b motor=%b lamp=%b at %0s", expect_0, motor, lamp, "start_stop.ladder:15");
    end
    scan(5000, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // start_stop.ladder:17
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b motor=%b lamp=%b at %0s", expect_1, motor, lamp, "start_stop.ladder:17");
    end
    stop = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // start_stop.ladder:19
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b motor=%b lamp=%b at %0s", expect_2, motor, lamp, "start_stop.ladder:19");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "stop drops the motor, the lamp needs five seconds");
    end else $display("ok 1 - %0s", "stop drops the motor, the lamp needs five seconds");

    // stop wins over start
    failed = 1'b0;
    reset;
    start = 1'd1;
    stop = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // start_stop.ladder:23
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b motor=%b at %0s", expect_3, motor, "start_stop.ladder:23");
    end
    stop = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // start_stop.ladder:25
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b motor=%b at %0s", expect_4, motor, "start_stop.ladder:25");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "stop wins over start");
    end else $display("ok 2 - %0s", "stop wins over start");

    // a motor that stops early gives no light
    failed = 1'b0;
    reset;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(4999, 1'b1);
    #1 if (!failed && &expect_5 !== 1'b1) begin // start_stop.ladder:30
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b motor=%b lamp=%b delay_ET=%b at %0s", expect_5, motor, lamp, delay_ET, "start_stop.ladder:30");
    end
    stop = 1'd1;
    scan(1, 1'b0);
    stop = 1'd0;
    scan(1, 1'b0);
    scan(10000, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // start_stop.ladder:33
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b motor=%b lamp=%b delay_ET=%b at %0s", expect_6, motor, lamp, delay_ET, "start_stop.ladder:33");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a motor that stops early gives no light");
    end else $display("ok 3 - %0s", "a motor that stops early gives no light");

    if (failures != 0) $display("# %0d of 3 tests failed", failures);
    $finish;
  end
endmodule
