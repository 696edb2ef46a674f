// Made by hotrail 0.1.0 from traffic_lights.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to power = 1, PT = 120 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_lights_test_TON_power1_PT120 (
  input  wire       clk,
  input  wire       rst,
  input  wire       tick,
  input  wire       clear_after,
  output wire       Q,
  output wire [6:0] ET_last
);
  reg [6:0] ET = 7'd0;
  reg was = 1'b0;

  wire equal = ET == 7'd120;
  wire [6:0] sum = ET + {6'b0, tick & ~equal};
  wire [6:0] choice = was ? sum : 7'd0;
  wire equal_2 = ET == 7'd119;
  wire [6:0] ET_next = clear_after ? 7'd0 : choice;

  assign Q = was & (tick & equal_2 | equal);
  assign ET_last = ET;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 7'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= 1'b1;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 30 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_lights_test_TON_PT30 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;
  reg ET_is_30 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_30;
  wire [4:0] sum = ET + 5'd1;
  wire [4:0] choice = condition_2 ? sum : ET;
  wire [4:0] ET_next = condition ? choice : 5'd0;
  wire equal = ET == 5'd29;
  wire choice_2 = condition_2 ? equal : ET_is_30;
  wire ET_is_30_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_30_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      was <= 1'b0;
      ET_is_30 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_30 <= ET_is_30_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 60 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_lights_test_TON_PT60 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [5:0] ET = 6'd0;
  reg was = 1'b0;
  reg ET_is_60 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_60;
  wire [5:0] sum = ET + 6'd1;
  wire [5:0] choice = condition_2 ? sum : ET;
  wire [5:0] ET_next = condition ? choice : 6'd0;
  wire equal = ET == 6'd59;
  wire choice_2 = condition_2 ? equal : ET_is_60;
  wire ET_is_60_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_60_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 6'd0;
      was <= 1'b0;
      ET_is_60 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_60 <= ET_is_60_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 100 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_lights_test_TON_PT100 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [6:0] ET = 7'd0;
  reg was = 1'b0;
  reg ET_is_100 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_100;
  wire [6:0] sum = ET + 7'd1;
  wire [6:0] choice = condition_2 ? sum : ET;
  wire [6:0] ET_next = condition ? choice : 7'd0;
  wire equal = ET == 7'd99;
  wire choice_2 = condition_2 ? equal : ET_is_100;
  wire ET_is_100_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_100_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 7'd0;
      was <= 1'b0;
      ET_is_100 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_100 <= ET_is_100_next;
    end
  end
endmodule

module traffic_lights_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  output wire        ns_green,
  output wire        ns_yellow,
  output wire        ns_red,
  output wire        turn_green,
  output wire        turn_yellow,
  output wire        turn_red,
  output wire        ew_green,
  output wire        ew_yellow,
  output wire        ew_red,
  output wire [31:0] t1_ET
);
  reg ns_green_reg = 1'b0;
  reg ns_yellow_reg = 1'b0;
  reg ns_red_reg = 1'b1;
  reg turn_green_reg = 1'b0;
  reg turn_yellow_reg = 1'b0;
  reg turn_red_reg = 1'b1;
  reg ew_green_reg = 1'b0;
  reg ew_yellow_reg = 1'b0;
  reg ew_red_reg = 1'b1;

  // rung 1 "intervals 1 to 6", traffic_lights.ladder:13
  wire t1_Q;
  wire [6:0] t1_ET_last;
  wire t2_Q;
  traffic_lights_test_TON_PT30 t2 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t1_Q),
    .Q(t2_Q)
  );
  wire t3_Q;
  traffic_lights_test_TON_PT60 t3 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t2_Q),
    .Q(t3_Q)
  );
  wire t4_Q;
  traffic_lights_test_TON_PT30 t4 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t3_Q),
    .Q(t4_Q)
  );
  wire t5_Q;
  traffic_lights_test_TON_PT100 t5 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t4_Q),
    .Q(t5_Q)
  );
  wire t6_Q;
  traffic_lights_test_TON_power1_PT120 t1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .clear_after(t6_Q),
    .Q(t1_Q),
    .ET_last(t1_ET_last)
  );
  traffic_lights_test_TON_PT30 t6 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t5_Q),
    .Q(t6_Q)
  );
  wire rung1_power = ~t6_Q & t1_Q;

  // rung 2 "interval 1: north-south may go", traffic_lights.ladder:17
  wire ns_green_next = ~rung1_power;

  // rung 3 "interval 2", traffic_lights.ladder:19
  wire ns_yellow_next = rung1_power & ~t2_Q;

  // rung 4 "interval 3: north-south may turn", traffic_lights.ladder:21
  wire turn_green_next = t2_Q & ~t3_Q;

  // rung 5 "interval 4", traffic_lights.ladder:23
  wire turn_yellow_next = t3_Q & ~t4_Q;

  // rung 6 "interval 5: east-west may go", traffic_lights.ladder:25
  wire ew_green_next = t4_Q & ~t5_Q;

  // rung 7 "interval 6", traffic_lights.ladder:27
  wire ew_yellow_next = t5_Q & rung1_power;

  // rung 8 "red whenever a lane has neither green nor yellow", traffic_lights.ladder:30
  wire ns_red_next = rung1_power & t2_Q;

  // rung 9, traffic_lights.ladder:32
  wire turn_red_next = ~turn_green_next & ~turn_yellow_next;

  // rung 10, traffic_lights.ladder:33
  wire ew_red_next = ~ew_green_next & ~ew_yellow_next;
  wire [31:0] t1_ET_value = {25'b0, t1_ET_last};

  assign ns_green = ns_green_reg;
  assign ns_yellow = ns_yellow_reg;
  assign ns_red = ns_red_reg;
  assign turn_green = turn_green_reg;
  assign turn_yellow = turn_yellow_reg;
  assign turn_red = turn_red_reg;
  assign ew_green = ew_green_reg;
  assign ew_yellow = ew_yellow_reg;
  assign ew_red = ew_red_reg;
  assign t1_ET = t1_ET_value;

  always @(posedge clk) begin
    if (rst) begin
      ns_green_reg <= 1'b0;
      ns_yellow_reg <= 1'b0;
      ns_red_reg <= 1'b1;
      turn_green_reg <= 1'b0;
      turn_yellow_reg <= 1'b0;
      turn_red_reg <= 1'b1;
      ew_green_reg <= 1'b0;
      ew_yellow_reg <= 1'b0;
      ew_red_reg <= 1'b1;
    end else begin
      ns_green_reg <= ns_green_next;
      ns_yellow_reg <= ns_yellow_next;
      ns_red_reg <= ns_red_next;
      turn_green_reg <= turn_green_next;
      turn_yellow_reg <= turn_yellow_next;
      turn_red_reg <= turn_red_next;
      ew_green_reg <= ew_green_next;
      ew_yellow_reg <= ew_yellow_next;
      ew_red_reg <= ew_red_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module traffic_lights_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        ns_red,
  input  wire        turn_red,
  input  wire        ew_red,
  input  wire        ns_green,
  input  wire        ns_yellow,
  input  wire        turn_green,
  input  wire        turn_yellow,
  input  wire        ew_green,
  input  wire        ew_yellow,
  input  wire [31:0] t1_ET,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_1_2,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_2_2,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_3_2,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_5_2,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_6_2,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_7_2,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_8_2,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_9_2,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_10_2,
  output wire        expect_11_0,
  output wire        expect_11_1,
  output wire        expect_11_2,
  output wire        expect_12_0,
  output wire        expect_12_1,
  output wire        expect_12_2,
  output wire        expect_13_0,
  output wire        expect_14_0,
  output wire        expect_15_0,
  output wire        expect_16_0,
  output wire        expect_17_0,
  output wire        expect_17_1,
  output wire        expect_18_0
);

  assign expect_0_0 = ns_red;
  assign expect_0_1 = turn_red;
  assign expect_0_2 = ew_red;
  assign expect_1_0 = ns_green;
  assign expect_1_1 = turn_red;
  assign expect_1_2 = ew_red;
  assign expect_2_0 = ns_green;
  assign expect_2_1 = turn_red;
  assign expect_2_2 = ew_red;
  assign expect_3_0 = ns_yellow;
  assign expect_3_1 = turn_red;
  assign expect_3_2 = ew_red;
  assign expect_4_0 = ns_yellow;
  assign expect_4_1 = turn_red;
  assign expect_4_2 = ew_red;
  assign expect_5_0 = ns_red;
  assign expect_5_1 = turn_green;
  assign expect_5_2 = ew_red;
  assign expect_6_0 = ns_red;
  assign expect_6_1 = turn_green;
  assign expect_6_2 = ew_red;
  assign expect_7_0 = ns_red;
  assign expect_7_1 = turn_yellow;
  assign expect_7_2 = ew_red;
  assign expect_8_0 = ns_red;
  assign expect_8_1 = turn_yellow;
  assign expect_8_2 = ew_red;
  assign expect_9_0 = ns_red;
  assign expect_9_1 = turn_red;
  assign expect_9_2 = ew_green;
  assign expect_10_0 = ns_red;
  assign expect_10_1 = turn_red;
  assign expect_10_2 = ew_green;
  assign expect_11_0 = ns_red;
  assign expect_11_1 = turn_red;
  assign expect_11_2 = ew_yellow;
  assign expect_12_0 = ns_red;
  assign expect_12_1 = turn_red;
  assign expect_12_2 = ew_yellow;
  assign expect_13_0 = ns_red & turn_red | ns_red & ew_red | turn_red & ew_red;
  assign expect_14_0 =
      ns_green & ~ns_yellow & ~ns_red | ~ns_green & ns_yellow & ~ns_red
      | ~ns_green & ~ns_yellow & ns_red;
  assign expect_15_0 =
      turn_green & ~turn_yellow & ~turn_red | ~turn_green & turn_yellow & ~turn_red
      | ~turn_green & ~turn_yellow & turn_red;
  assign expect_16_0 =
      ew_green & ~ew_yellow & ~ew_red | ~ew_green & ew_yellow & ~ew_red
      | ~ew_green & ~ew_yellow & ew_red;
  assign expect_17_0 = ns_green;
  assign expect_17_1 = t1_ET == 32'd0;
  assign expect_18_0 = ns_green;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module traffic_lights_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  wire ns_green;
  wire ns_yellow;
  wire ns_red;
  wire turn_green;
  wire turn_yellow;
  wire turn_red;
  wire ew_green;
  wire ew_yellow;
  wire ew_red;
  wire [31:0] t1_ET;
  reg failed;
  integer failures;

  traffic_lights_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .ns_green(ns_green),
    .ns_yellow(ns_yellow),
    .ns_red(ns_red),
    .turn_green(turn_green),
    .turn_yellow(turn_yellow),
    .turn_red(turn_red),
    .ew_green(ew_green),
    .ew_yellow(ew_yellow),
    .ew_red(ew_red),
    .t1_ET(t1_ET)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire [0:2] expect_0 = {expect_0_0, expect_0_1, expect_0_2};
  wire expect_1_0;
  wire expect_1_1;
  wire expect_1_2;
  wire [0:2] expect_1 = {expect_1_0, expect_1_1, expect_1_2};
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
  wire expect_4_2;
  wire [0:2] expect_4 = {expect_4_0, expect_4_1, expect_4_2};
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
  wire expect_7_2;
  wire [0:2] expect_7 = {expect_7_0, expect_7_1, expect_7_2};
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
  wire [0:2] expect_10 = {expect_10_0, expect_10_1, expect_10_2};
  wire expect_11_0;
  wire expect_11_1;
  wire expect_11_2;
  wire [0:2] expect_11 = {expect_11_0, expect_11_1, expect_11_2};
  wire expect_12_0;
  wire expect_12_1;
  wire expect_12_2;
  wire [0:2] expect_12 = {expect_12_0, expect_12_1, expect_12_2};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  wire expect_16_0;
  wire [0:0] expect_16 = {expect_16_0};
  wire expect_17_0;
  wire expect_17_1;
  wire [0:1] expect_17 = {expect_17_0, expect_17_1};
  wire expect_18_0;
  wire [0:0] expect_18 = {expect_18_0};
  traffic_lights_expect expectations (
    .clk(clk),
    .rst(rst),
    .ns_red(ns_red),
    .turn_red(turn_red),
    .ew_red(ew_red),
    .ns_green(ns_green),
    .ns_yellow(ns_yellow),
    .turn_green(turn_green),
    .turn_yellow(turn_yellow),
    .ew_green(ew_green),
    .ew_yellow(ew_yellow),
    .t1_ET(t1_ET),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_2_2(expect_2_2),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_6_2(expect_6_2),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_7_2(expect_7_2),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_8_2(expect_8_2),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_9_2(expect_9_2),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_10_2(expect_10_2),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_11_2(expect_11_2),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1),
    .expect_12_2(expect_12_2),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_16_0(expect_16_0),
    .expect_17_0(expect_17_0),
    .expect_17_1(expect_17_1),
    .expect_18_0(expect_18_0)
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
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..4");

    // all lanes are red before the first scan
    failed = 1'b0;
    reset;
    #1 if (!failed && &expect_0 !== 1'b1) begin // traffic_lights.ladder:36
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_0, ns_red, turn_red, ew_red, "traffic_lights.ladder:36");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "all lanes are red before the first scan");
    end else $display("ok 1 - %0s", "all lanes are red before the first scan");

    // six intervals, again and again
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (3) begin
      #1 if (!failed && &expect_1 !== 1'b1) begin // traffic_lights.ladder:41
        failed = 1'b1;
        $display("# failed expectation 1 conducts %b ns_green=%b turn_red=%b ew_red=%b at %0s", expect_1, ns_green, turn_red, ew_red, "traffic_lights.ladder:41");
      end
      scan(119, 1'b1);
      #1 if (!failed && &expect_2 !== 1'b1) begin // traffic_lights.ladder:43
        failed = 1'b1;
        $display("# failed expectation 2 conducts %b ns_green=%b turn_red=%b ew_red=%b at %0s", expect_2, ns_green, turn_red, ew_red, "traffic_lights.ladder:43");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_3 !== 1'b1) begin // traffic_lights.ladder:45
        failed = 1'b1;
        $display("# failed expectation 3 conducts %b ns_yellow=%b turn_red=%b ew_red=%b at %0s", expect_3, ns_yellow, turn_red, ew_red, "traffic_lights.ladder:45");
      end
      scan(29, 1'b1);
      #1 if (!failed && &expect_4 !== 1'b1) begin // traffic_lights.ladder:47
        failed = 1'b1;
        $display("# failed expectation 4 conducts %b ns_yellow=%b turn_red=%b ew_red=%b at %0s", expect_4, ns_yellow, turn_red, ew_red, "traffic_lights.ladder:47");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_5 !== 1'b1) begin // traffic_lights.ladder:49
        failed = 1'b1;
        $display("# failed expectation 5 conducts %b ns_red=%b turn_green=%b ew_red=%b at %0s", expect_5, ns_red, turn_green, ew_red, "traffic_lights.ladder:49");
      end
      scan(59, 1'b1);
      #1 if (!failed && &expect_6 !== 1'b1) begin // traffic_lights.ladder:51
        failed = 1'b1;
        $display("# failed expectation 6 conducts %b ns_red=%b turn_green=%b ew_red=%b at %0s", expect_6, ns_red, turn_green, ew_red, "traffic_lights.ladder:51");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_7 !== 1'b1) begin // traffic_lights.ladder:53
        failed = 1'b1;
        $display("# failed expectation 7 conducts %b ns_red=%b turn_yellow=%b ew_red=%b at %0s", expect_7, ns_red, turn_yellow, ew_red, "traffic_lights.ladder:53");
      end
      scan(29, 1'b1);
      #1 if (!failed && &expect_8 !== 1'b1) begin // traffic_lights.ladder:55
        failed = 1'b1;
        $display("# failed expectation 8 conducts %b ns_red=%b turn_yellow=%b ew_red=%b at %0s", expect_8, ns_red, turn_yellow, ew_red, "traffic_lights.ladder:55");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_9 !== 1'b1) begin // traffic_lights.ladder:57
        failed = 1'b1;
        $display("# failed expectation 9 conducts %b ns_red=%b turn_red=%b ew_green=%b at %0s", expect_9, ns_red, turn_red, ew_green, "traffic_lights.ladder:57");
      end
      scan(99, 1'b1);
      #1 if (!failed && &expect_10 !== 1'b1) begin // traffic_lights.ladder:59
        failed = 1'b1;
        $display("# failed expectation 10 conducts %b ns_red=%b turn_red=%b ew_green=%b at %0s", expect_10, ns_red, turn_red, ew_green, "traffic_lights.ladder:59");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_11 !== 1'b1) begin // traffic_lights.ladder:61
        failed = 1'b1;
        $display("# failed expectation 11 conducts %b ns_red=%b turn_red=%b ew_yellow=%b at %0s", expect_11, ns_red, turn_red, ew_yellow, "traffic_lights.ladder:61");
      end
      scan(29, 1'b1);
      #1 if (!failed && &expect_12 !== 1'b1) begin // traffic_lights.ladder:63
        failed = 1'b1;
        $display("# failed expectation 12 conducts %b ns_red=%b turn_red=%b ew_yellow=%b at %0s", expect_12, ns_red, turn_red, ew_yellow, "traffic_lights.ladder:63");
      end
      scan(1, 1'b1);
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "six intervals, again and again");
    end else $display("ok 2 - %0s", "six intervals, again and again");

    // at every tick two lanes have red, and each lane has one light
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (400) begin
      #1 if (!failed && &expect_13 !== 1'b1) begin // traffic_lights.ladder:70
        failed = 1'b1;
        $display("# failed expectation 13 conducts %b ns_red=%b turn_red=%b ew_red=%b at %0s", expect_13, ns_red, turn_red, ew_red, "traffic_lights.ladder:70");
      end
      #1 if (!failed && &expect_14 !== 1'b1) begin // traffic_lights.ladder:71
        failed = 1'b1;
        $display("# failed expectation 14 conducts %b ns_green=%b ns_yellow=%b ns_red=%b at %0s", expect_14, ns_green, ns_yellow, ns_red, "traffic_lights.ladder:71");
      end
      #1 if (!failed && &expect_15 !== 1'b1) begin // traffic_lights.ladder:76
        failed = 1'b1;
        $display("# failed expectation 15 conducts %b turn_green=%b turn_yellow=%b turn_red=%b at %0s", expect_15, turn_green, turn_yellow, turn_red, "traffic_lights.ladder:76");
      end
      #1 if (!failed && &expect_16 !== 1'b1) begin // traffic_lights.ladder:81
        failed = 1'b1;
        $display("# failed expectation 16 conducts %b ew_green=%b ew_yellow=%b ew_red=%b at %0s", expect_16, ew_green, ew_yellow, ew_red, "traffic_lights.ladder:81");
      end
      scan(1, 1'b1);
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "at every tick two lanes have red, and each lane has one light");
    end else $display("ok 3 - %0s", "at every tick two lanes have red, and each lane has one light");

    // a cycle takes 37 s, and none of them a scan more
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    repeat (5) begin
      #1 if (!failed && &expect_17 !== 1'b1) begin // traffic_lights.ladder:92
        failed = 1'b1;
        $display("# failed expectation 17 conducts %b ns_green=%b t1_ET=%b at %0s", expect_17, ns_green, t1_ET, "traffic_lights.ladder:92");
      end
      scan(370, 1'b1);
    end
    #1 if (!failed && &expect_18 !== 1'b1) begin // traffic_lights.ladder:95
      failed = 1'b1;
      $display("# failed expectation 18 conducts %b ns_green=%b at %0s", expect_18, ns_green, "traffic_lights.ladder:95");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "a cycle takes 37 s, and none of them a scan more");
    end else $display("ok 4 - %0s", "a cycle takes 37 s, and none of them a scan more");

    if (failures != 0) $display("# %0d of 4 tests failed", failures);
    $finish;
  end
endmodule
