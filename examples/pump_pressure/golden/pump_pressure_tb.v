// Made by hotrail 0.1.0 from pump_pressure.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module pump_pressure_expect (
  input  wire clk,
  input  wire rst,
  input  wire pump,
  input  wire low_pressure,
  input  wire tripped,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_4_0,
  output wire expect_4_1,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_5_2,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_7_0,
  output wire expect_7_1,
  output wire expect_8_0,
  output wire expect_9_0,
  output wire expect_9_1,
  output wire expect_10_0,
  output wire expect_10_1,
  output wire expect_11_0,
  output wire expect_12_0,
  output wire expect_13_0,
  output wire expect_14_0,
  output wire expect_15_0,
  output wire expect_16_0,
  output wire expect_16_1,
  output wire expect_17_0,
  output wire expect_17_1,
  output wire expect_18_0,
  output wire expect_18_1,
  output wire expect_19_0,
  output wire expect_19_1
);

  assign expect_0_0 = pump;
  assign expect_0_1 = low_pressure;
  assign expect_1_0 = pump;
  assign expect_1_1 = ~low_pressure;
  assign expect_2_0 = pump;
  assign expect_2_1 = ~tripped;
  assign expect_3_0 = pump;
  assign expect_3_1 = ~tripped;
  assign expect_4_0 = pump;
  assign expect_4_1 = tripped;
  assign expect_5_0 = ~pump;
  assign expect_5_1 = tripped;
  assign expect_5_2 = ~low_pressure;
  assign expect_6_0 = ~pump;
  assign expect_6_1 = tripped;
  assign expect_7_0 = pump;
  assign expect_7_1 = low_pressure;
  assign expect_8_0 = pump;
  assign expect_9_0 = ~pump;
  assign expect_9_1 = tripped;
  assign expect_10_0 = pump;
  assign expect_10_1 = ~tripped;
  assign expect_11_0 = pump;
  assign expect_12_0 = ~pump;
  assign expect_13_0 = ~pump;
  assign expect_14_0 = ~pump;
  assign expect_15_0 = pump;
  assign expect_16_0 = ~pump;
  assign expect_16_1 = ~low_pressure;
  assign expect_17_0 = ~pump;
  assign expect_17_1 = tripped;
  assign expect_18_0 = ~pump;
  assign expect_18_1 = tripped;
  assign expect_19_0 = pump;
  assign expect_19_1 = ~tripped;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module pump_pressure_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg start = 1'd0;
  reg stop = 1'd0;
  reg pressure = 1'd0;
  wire pump;
  wire low_pressure;
  wire tripped;
  reg failed;
  integer failures;

  pump_pressure core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .start(start),
    .stop(stop),
    .pressure(pressure),
    .pump(pump),
    .low_pressure(low_pressure),
    .tripped(tripped)
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
  wire [0:1] expect_4 = {expect_4_0, expect_4_1};
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
  wire [0:0] expect_8 = {expect_8_0};
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
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  wire expect_16_0;
  wire expect_16_1;
  wire [0:1] expect_16 = {expect_16_0, expect_16_1};
  wire expect_17_0;
  wire expect_17_1;
  wire [0:1] expect_17 = {expect_17_0, expect_17_1};
  wire expect_18_0;
  wire expect_18_1;
  wire [0:1] expect_18 = {expect_18_0, expect_18_1};
  wire expect_19_0;
  wire expect_19_1;
  wire [0:1] expect_19 = {expect_19_0, expect_19_1};
  pump_pressure_expect expectations (
    .clk(clk),
    .rst(rst),
    .pump(pump),
    .low_pressure(low_pressure),
    .tripped(tripped),
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
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_16_0(expect_16_0),
    .expect_16_1(expect_16_1),
    .expect_17_0(expect_17_0),
    .expect_17_1(expect_17_1),
    .expect_18_0(expect_18_0),
    .expect_18_1(expect_18_1),
    .expect_19_0(expect_19_0),
    .expect_19_1(expect_19_1)
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
      pressure = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..6");

    // pressure in time
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // pump_pressure.ladder:26
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b pump=%b low_pressure=%b at %0s", expect_0, pump, low_pressure, "pump_pressure.ladder:26");
    end
    scan(49, 1'b1);
    pressure = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // pump_pressure.ladder:29
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b pump=%b low_pressure=%b at %0s", expect_1, pump, low_pressure, "pump_pressure.ladder:29");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // pump_pressure.ladder:31
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b pump=%b tripped=%b at %0s", expect_2, pump, tripped, "pump_pressure.ladder:31");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "pressure in time");
    end else $display("ok 1 - %0s", "pressure in time");

    // no pressure: the pump stops 5 s after the start
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(49, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // pump_pressure.ladder:37
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b pump=%b tripped=%b at %0s", expect_3, pump, tripped, "pump_pressure.ladder:37");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // pump_pressure.ladder:39
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b pump=%b tripped=%b at %0s", expect_4, pump, tripped, "pump_pressure.ladder:39");
    end
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // pump_pressure.ladder:41
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b pump=%b tripped=%b low_pressure=%b at %0s", expect_5, pump, tripped, low_pressure, "pump_pressure.ladder:41");
    end
    scan(50, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // pump_pressure.ladder:43
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b pump=%b tripped=%b at %0s", expect_6, pump, tripped, "pump_pressure.ladder:43");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "no pressure: the pump stops 5 s after the start");
    end else $display("ok 2 - %0s", "no pressure: the pump stops 5 s after the start");

    // pressure lost later: again 5 s
    failed = 1'b0;
    reset;
    stop = 1'd1;
    pressure = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    scan(200, 1'b1);
    pressure = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // pump_pressure.ladder:50
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b pump=%b low_pressure=%b at %0s", expect_7, pump, low_pressure, "pump_pressure.ladder:50");
    end
    scan(49, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // pump_pressure.ladder:53
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b pump=%b at %0s", expect_8, pump, "pump_pressure.ladder:53");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // pump_pressure.ladder:56
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b pump=%b tripped=%b at %0s", expect_9, pump, tripped, "pump_pressure.ladder:56");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "pressure lost later: again 5 s");
    end else $display("ok 3 - %0s", "pressure lost later: again 5 s");

    // pressure that flutters does not add up
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    repeat (3) begin
      scan(49, 1'b1);
      pressure = 1'd1;
      scan(1, 1'b0);
      pressure = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_10 !== 1'b1) begin // pump_pressure.ladder:66
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b pump=%b tripped=%b at %0s", expect_10, pump, tripped, "pump_pressure.ladder:66");
    end
    scan(49, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // pump_pressure.ladder:68
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b pump=%b at %0s", expect_11, pump, "pump_pressure.ladder:68");
    end
    scan(1, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // pump_pressure.ladder:71
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b pump=%b at %0s", expect_12, pump, "pump_pressure.ladder:71");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "pressure that flutters does not add up");
    end else $display("ok 4 - %0s", "pressure that flutters does not add up");

    // stop wins over start and needs no pressure
    failed = 1'b0;
    reset;
    start = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_13 !== 1'b1) begin // pump_pressure.ladder:75
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b pump=%b at %0s", expect_13, pump, "pump_pressure.ladder:75");
    end
    stop = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // pump_pressure.ladder:77
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b pump=%b at %0s", expect_14, pump, "pump_pressure.ladder:77");
    end
    start = 1'd0;
    scan(1, 1'b0);
    start = 1'd1;
    scan(1, 1'b0);
    start = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // pump_pressure.ladder:80
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b pump=%b at %0s", expect_15, pump, "pump_pressure.ladder:80");
    end
    stop = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_16 !== 1'b1) begin // pump_pressure.ladder:82
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b pump=%b low_pressure=%b at %0s", expect_16, pump, low_pressure, "pump_pressure.ladder:82");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "stop wins over start and needs no pressure");
    end else $display("ok 5 - %0s", "stop wins over start and needs no pressure");

    // a start button that got stuck does not start the pump again and again
    failed = 1'b0;
    reset;
    stop = 1'd1;
    start = 1'd1;
    scan(1, 1'b0);
    scan(50, 1'b1);
    scan(1, 1'b0);
    #1 if (!failed && &expect_17 !== 1'b1) begin // pump_pressure.ladder:89
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b pump=%b tripped=%b at %0s", expect_17, pump, tripped, "pump_pressure.ladder:89");
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_18 !== 1'b1) begin // pump_pressure.ladder:91
      failed = 1'b1;
      $display("# failed expectation 18 conducts %b pump=%b tripped=%b at %0s", expect_18, pump, tripped, "pump_pressure.ladder:91");
    end
    start = 1'd0;
    scan(1, 1'b0);
    start = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_19 !== 1'b1) begin // pump_pressure.ladder:94
      failed = 1'b1;
      $display("# failed expectation 19 conducts %b pump=%b tripped=%b at %0s", expect_19, pump, tripped, "pump_pressure.ladder:94");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "a start button that got stuck does not start the pump again and again");
    end else $display("ok 6 - %0s", "a start button that got stuck does not start the pump again and again");

    if (failures != 0) $display("# %0d of 6 tests failed", failures);
    $finish;
  end
endmodule
