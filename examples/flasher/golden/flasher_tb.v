// Made by hotrail 0.1.0 from flasher.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 200 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module flasher_test_TON_PT200 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q_last
);
  reg Q = 1'b0;
  reg [7:0] ET = 8'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~Q;
  wire [7:0] sum = ET + 8'd1;
  wire [7:0] choice = condition_2 ? sum : ET;
  wire [7:0] ET_next = condition ? choice : 8'd0;
  wire equal = ET == 8'hc7;
  wire choice_2 = condition_2 ? equal : Q;
  wire Q_next = condition ? choice_2 : 1'b0;

  assign Q_last = Q;

  always @(posedge clk) begin
    if (rst) begin
      Q <= 1'b0;
      ET <= 8'd0;
      was <= 1'b0;
    end else begin
      Q <= Q_next;
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 1300 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module flasher_test_TON_PT1300 (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  output wire        Q,
  output wire [10:0] ET_last
);
  reg [10:0] ET = 11'd0;
  reg was = 1'b0;
  reg ET_is_1300 = 1'b0;

  wire condition = power & was;
  wire [10:0] sum = ET + {10'b0, tick & ~ET_is_1300};
  wire [10:0] ET_next = condition ? sum : 11'd0;
  wire equal = ET == 11'd1299;
  wire ET_is_1300_next = condition & (tick & equal | ET_is_1300);

  assign Q = ET_is_1300_next;
  assign ET_last = ET;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 11'd0;
      was <= 1'b0;
      ET_is_1300 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_1300 <= ET_is_1300_next;
    end
  end
endmodule

module flasher_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        enable,
  output wire        lamp,
  output wire [31:0] on_time_ET
);
  reg lamp_reg = 1'b0;

  // rung 1 "the lamp is on until this timer has run", flasher.ladder:7
  wire off_time_Q_last;
  wire on_time_power = enable & ~off_time_Q_last;
  wire on_time_Q;
  wire [10:0] on_time_ET_last;
  flasher_test_TON_PT200 off_time (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(on_time_Q),
    .Q_last(off_time_Q_last)
  );
  flasher_test_TON_PT1300 on_time (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(on_time_power),
    .Q(on_time_Q),
    .ET_last(on_time_ET_last)
  );

  // rung 2 "and off until this one has", flasher.ladder:10

  // rung 3 "lamp", flasher.ladder:13
  wire lamp_next = enable & ~on_time_Q;
  wire [31:0] on_time_ET_value = {21'b0, on_time_ET_last};

  assign lamp = lamp_reg;
  assign on_time_ET = on_time_ET_value;

  always @(posedge clk) begin
    if (rst) begin
      lamp_reg <= 1'b0;
    end else begin
      lamp_reg <= lamp_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module flasher_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        lamp,
  input  wire [31:0] on_time_ET,
  output wire        expect_0_0,
  output wire        expect_1_0,
  output wire        expect_2_0,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_4_0,
  output wire        expect_5_0,
  output wire        expect_6_0,
  output wire        expect_7_0,
  output wire        expect_7_1
);

  assign expect_0_0 = lamp;
  assign expect_1_0 = ~lamp;
  assign expect_2_0 = ~lamp;
  assign expect_3_0 = lamp;
  assign expect_3_1 = on_time_ET == 32'd0;
  assign expect_4_0 = lamp;
  assign expect_5_0 = ~lamp;
  assign expect_6_0 = lamp;
  assign expect_7_0 = ~lamp;
  assign expect_7_1 = on_time_ET == 32'd0;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module flasher_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg enable = 1'd0;
  wire lamp;
  wire [31:0] on_time_ET;
  reg failed;
  integer failures;

  flasher_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .enable(enable),
    .lamp(lamp),
    .on_time_ET(on_time_ET)
  );

  wire expect_0_0;
  wire [0:0] expect_0 = {expect_0_0};
  wire expect_1_0;
  wire [0:0] expect_1 = {expect_1_0};
  wire expect_2_0;
  wire [0:0] expect_2 = {expect_2_0};
  wire expect_3_0;
  wire expect_3_1;
  wire [0:1] expect_3 = {expect_3_0, expect_3_1};
  wire expect_4_0;
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire [0:0] expect_6 = {expect_6_0};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
  flasher_expect expectations (
    .clk(clk),
    .rst(rst),
    .lamp(lamp),
    .on_time_ET(on_time_ET),
    .expect_0_0(expect_0_0),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1)
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
      enable = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..2");

    // on for 1.3 s, off for 0.2 s, and again
    failed = 1'b0;
    reset;
    enable = 1'd1;
    scan(1300, 1'b1);
    #1 if (!failed && &expect_0 !== 1'b1) begin // flasher.ladder:19
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b lamp=%b at %0s", expect_0, lamp, "flasher.ladder:19");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // flasher.ladder:21
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b lamp=%b at %0s", expect_1, lamp, "flasher.ladder:21");
    end
    scan(200, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // flasher.ladder:23
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b lamp=%b at %0s", expect_2, lamp, "flasher.ladder:23");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // flasher.ladder:25
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b lamp=%b on_time_ET=%b at %0s", expect_3, lamp, on_time_ET, "flasher.ladder:25");
    end
    scan(1300, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // flasher.ladder:27
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b lamp=%b at %0s", expect_4, lamp, "flasher.ladder:27");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_5 !== 1'b1) begin // flasher.ladder:29
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b lamp=%b at %0s", expect_5, lamp, "flasher.ladder:29");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "on for 1.3 s, off for 0.2 s, and again");
    end else $display("ok 1 - %0s", "on for 1.3 s, off for 0.2 s, and again");

    // off without enable
    failed = 1'b0;
    reset;
    enable = 1'd1;
    scan(500, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // flasher.ladder:34
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b lamp=%b at %0s", expect_6, lamp, "flasher.ladder:34");
    end
    enable = 1'd0;
    scan(1, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // flasher.ladder:37
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b lamp=%b on_time_ET=%b at %0s", expect_7, lamp, on_time_ET, "flasher.ladder:37");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "off without enable");
    end else $display("ok 2 - %0s", "off without enable");

    if (failures != 0) $display("# %0d of 2 tests failed", failures);
    $finish;
  end
endmodule
