// Made by hotrail 0.1.0 from step_sequence.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 20 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module step_sequence_test_TON_PT20 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;
  reg ET_is_20 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_20;
  wire [4:0] sum = ET + 5'd1;
  wire [4:0] choice = condition_2 ? sum : ET;
  wire [4:0] ET_next = condition ? choice : 5'd0;
  wire equal = ET == 5'd19;
  wire choice_2 = condition_2 ? equal : ET_is_20;
  wire ET_is_20_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_20_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      was <= 1'b0;
      ET_is_20 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_20 <= ET_is_20_next;
    end
  end
endmodule

module step_sequence_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        start,
  input  wire        clamped,
  input  wire        deep,
  input  wire        free,
  input  wire        emergency,
  output wire        clamp,
  output wire        drill,
  output wire        lift,
  output wire        busy,
  output wire [15:0] step
);
  reg [2:0] step_reg = 3'd0;
  reg start_before = 1'b0;
  reg clamp_reg = 1'b0;
  reg drill_reg = 1'b0;
  reg lift_reg = 1'b0;
  reg busy_reg = 1'b0;

  // rung 1 "part is free", step_sequence.ladder:16
  wire [15:0] step_value = {13'b0, step_reg};
  wire rung1_equal = step_reg == 3'd4;
  wire [2:0] step_rung1 = (rung1_equal & free) ? 3'd0 : step_reg;

  // rung 2 "drill is up", step_sequence.ladder:18
  wire up_time_power = step_rung1 == 3'd3;
  wire up_time_Q;
  step_sequence_test_TON_PT20 up_time (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(up_time_power),
    .Q(up_time_Q)
  );
  wire [2:0] step_rung2 = up_time_Q ? 3'd4 : step_rung1;

  // rung 3 "hole is deep enough", step_sequence.ladder:20
  wire rung3_equal = step_rung2 == 3'd2;
  wire [2:0] step_rung3 = (rung3_equal & deep) ? 3'd3 : step_rung2;

  // rung 4 "part is held", step_sequence.ladder:22
  wire rung4_equal = step_rung3 == 3'd1;
  wire [2:0] step_rung4 = (rung4_equal & clamped) ? 3'd2 : step_rung3;

  // rung 5 "a new part", step_sequence.ladder:24
  wire rung5_equal = step_rung4 == 3'd0;
  wire [2:0] step_rung5 = (rung5_equal & start & ~start_before) ? 3'd1 : step_rung4;

  // rung 6 "emergency: back to the start", step_sequence.ladder:27
  wire [2:0] step_next = emergency ? 3'd0 : step_rung5;

  // rung 7 "outputs of the steps", step_sequence.ladder:30
  wire rung7_unequal = step_next != 3'd0;
  wire rung7_unequal_2 = step_next != 3'd4;
  wire clamp_next = rung7_unequal & rung7_unequal_2;
  wire drill_next = step_next == 3'd2;
  wire lift_next = step_next == 3'd3;
  wire busy_next = step_next != 3'd0;

  assign clamp = clamp_reg;
  assign drill = drill_reg;
  assign lift = lift_reg;
  assign busy = busy_reg;
  assign step = step_value;

  always @(posedge clk) begin
    if (rst) begin
      step_reg <= 3'd0;
      start_before <= 1'b0;
      clamp_reg <= 1'b0;
      drill_reg <= 1'b0;
      lift_reg <= 1'b0;
      busy_reg <= 1'b0;
    end else begin
      step_reg <= step_next;
      start_before <= start;
      clamp_reg <= clamp_next;
      drill_reg <= drill_next;
      lift_reg <= lift_next;
      busy_reg <= busy_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module step_sequence_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire [15:0] step,
  input  wire        clamp,
  input  wire        busy,
  input  wire        drill,
  input  wire        lift,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_0_3,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_4_3,
  output wire        expect_5_0,
  output wire        expect_6_0,
  output wire        expect_7_0,
  output wire        expect_8_0,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_9_2
);

  assign expect_0_0 = step == 16'd1;
  assign expect_0_1 = clamp;
  assign expect_0_2 = busy;
  assign expect_0_3 = ~drill;
  assign expect_1_0 = drill;
  assign expect_1_1 = clamp;
  assign expect_2_0 = lift;
  assign expect_2_1 = ~drill;
  assign expect_3_0 = lift;
  assign expect_4_0 = ~lift;
  assign expect_4_1 = ~clamp;
  assign expect_4_2 = busy;
  assign expect_4_3 = step == 16'd4;
  assign expect_5_0 = ~busy;
  assign expect_6_0 = step == 16'd1;
  assign expect_7_0 = step == 16'd2;
  assign expect_8_0 = step == 16'd3;
  assign expect_9_0 = ~clamp;
  assign expect_9_1 = ~drill;
  assign expect_9_2 = ~busy;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module step_sequence_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg clamped = 1'd0;
  reg deep = 1'd0;
  reg free = 1'd0;
  reg emergency = 1'd0;
  wire clamp;
  wire drill;
  wire lift;
  wire busy;
  wire [15:0] step;
  reg failed;
  integer failures;

  step_sequence_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .clamped(clamped),
    .deep(deep),
    .free(free),
    .emergency(emergency),
    .clamp(clamp),
    .drill(drill),
    .lift(lift),
    .busy(busy),
    .step(step)
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
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire [0:0] expect_3 = {expect_3_0};
  wire expect_4_0;
  wire expect_4_1;
  wire expect_4_2;
  wire expect_4_3;
  wire [0:3] expect_4 = {expect_4_0, expect_4_1, expect_4_2, expect_4_3};
  wire expect_5_0;
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire [0:0] expect_6 = {expect_6_0};
  wire expect_7_0;
  wire [0:0] expect_7 = {expect_7_0};
  wire expect_8_0;
  wire [0:0] expect_8 = {expect_8_0};
  wire expect_9_0;
  wire expect_9_1;
  wire expect_9_2;
  wire [0:2] expect_9 = {expect_9_0, expect_9_1, expect_9_2};
  step_sequence_expect expectations (
    .clk(clk),
    .rst(rst),
    .step(step),
    .clamp(clamp),
    .busy(busy),
    .drill(drill),
    .lift(lift),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_0_3(expect_0_3),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_4_3(expect_4_3),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_7_0(expect_7_0),
    .expect_8_0(expect_8_0),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_9_2(expect_9_2)
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
      clamped = 1'd0;
      deep = 1'd0;
      free = 1'd0;
      emergency = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..3");

    // one part
    failed = 1'b0;
    reset;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // step_sequence.ladder:39
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b step=%b clamp=%b busy=%b drill=%b at %0s", expect_0, step, clamp, busy, drill, "step_sequence.ladder:39");
    end
    clamped = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // step_sequence.ladder:41
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b drill=%b clamp=%b at %0s", expect_1, drill, clamp, "step_sequence.ladder:41");
    end
    deep = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // step_sequence.ladder:43
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b lift=%b drill=%b at %0s", expect_2, lift, drill, "step_sequence.ladder:43");
    end
    deep = 1'd0;
    scan(20, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // step_sequence.ladder:45
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b lift=%b at %0s", expect_3, lift, "step_sequence.ladder:45");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // step_sequence.ladder:47
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b lift=%b clamp=%b busy=%b step=%b at %0s", expect_4, lift, clamp, busy, step, "step_sequence.ladder:47");
    end
    clamped = 1'd0;
    free = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // step_sequence.ladder:49
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b busy=%b at %0s", expect_5, busy, "step_sequence.ladder:49");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "one part");
    end else $display("ok 1 - %0s", "one part");

    // a step at a time, whatever the switches say
    failed = 1'b0;
    reset;
    clamped = 1'd1;
    deep = 1'd1;
    free = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // step_sequence.ladder:54
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b step=%b at %0s", expect_6, step, "step_sequence.ladder:54");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // step_sequence.ladder:56
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b step=%b at %0s", expect_7, step, "step_sequence.ladder:56");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // step_sequence.ladder:58
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b step=%b at %0s", expect_8, step, "step_sequence.ladder:58");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "a step at a time, whatever the switches say");
    end else $display("ok 2 - %0s", "a step at a time, whatever the switches say");

    // emergency from any step
    failed = 1'b0;
    reset;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    clamped = 1'd1;
    scan(1, 1'b0);
    emergency = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // step_sequence.ladder:64
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b clamp=%b drill=%b busy=%b at %0s", expect_9, clamp, drill, busy, "step_sequence.ladder:64");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "emergency from any step");
    end else $display("ok 3 - %0s", "emergency from any step");

    if (failures != 0) $display("# %0d of 3 tests failed", failures);
    $finish;
  end
endmodule
