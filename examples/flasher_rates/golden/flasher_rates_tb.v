// Made by hotrail 0.1.0 from flasher_rates.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module flasher_rates_test_TON (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [31:0] PT,
  input  wire        clear_after,
  output wire        Q,
  output wire [31:0] ET,
  output wire [31:0] ET_last
);
  reg [31:0] ET_reg = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET_reg) < $signed(PT);
  wire [31:0] sum = ET_reg + {31'b0, tick & less};
  wire [31:0] ET_value = (power & was) ? sum : 32'd0;
  wire at_least = $signed(ET_value) >= $signed(PT);
  wire [31:0] ET_next = clear_after ? 32'd0 : ET_value;

  assign Q = power & at_least;
  assign ET = ET_value;
  assign ET_last = ET_reg;

  always @(posedge clk) begin
    if (rst) begin
      ET_reg <= 32'd0;
      was <= 1'b0;
    end else begin
      ET_reg <= ET_next;
      was <= power;
    end
  end
endmodule

module flasher_rates_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        enable,
  input  wire        slow,
  output wire        lamp,
  output wire [31:0] cycle_ET
);
  reg [4:0] on_time = 5'd0;
  reg [5:0] cycle_PT = 6'd0;
  reg lamp_reg = 1'b0;

  // rung 1 "rate", flasher_rates.ladder:12
  wire rung1_power = ~slow;
  wire [4:0] on_time_rung1 = rung1_power ? 5'd13 : on_time;
  wire [5:0] cycle_PT_rung1 = rung1_power ? 6'd25 : cycle_PT;
  wire [4:0] on_time_next = slow ? 5'd25 : on_time_rung1;
  wire [5:0] cycle_PT_next = slow ? 6'd42 : cycle_PT_rung1;
  wire [31:0] cycle_PT_2 = {26'b0, cycle_PT_next};

  // rung 2 "one cycle after the other", flasher_rates.ladder:17
  wire cycle_Q;
  wire [31:0] cycle_ET_2;
  wire [31:0] cycle_ET_last;
  flasher_rates_test_TON cycle (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(enable),
    .PT(cycle_PT_2),
    .clear_after(cycle_Q),
    .Q(cycle_Q),
    .ET(cycle_ET_2),
    .ET_last(cycle_ET_last)
  );
  wire [31:0] rung2_choice = cycle_Q ? 32'd0 : cycle_ET_2;

  // rung 3 "lit in its first part", flasher_rates.ladder:20
  wire rung3_less = $signed(rung2_choice) < $signed({27'b0, on_time_next});
  wire lamp_next = enable & rung3_less;

  assign lamp = lamp_reg;
  assign cycle_ET = cycle_ET_last;

  always @(posedge clk) begin
    if (rst) begin
      on_time <= 5'd0;
      cycle_PT <= 6'd0;
      lamp_reg <= 1'b0;
    end else begin
      on_time <= on_time_next;
      cycle_PT <= cycle_PT_next;
      lamp_reg <= lamp_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module flasher_rates_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        lamp,
  input  wire [31:0] cycle_ET,
  output wire        expect_0_0,
  output wire        expect_1_0,
  output wire        expect_2_0,
  output wire        expect_3_0,
  output wire        expect_4_0,
  output wire        expect_5_0,
  output wire        expect_6_0,
  output wire        expect_7_0,
  output wire        expect_8_0,
  output wire        expect_9_0,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_11_0,
  output wire        expect_12_0,
  output wire        expect_13_0,
  output wire        expect_14_0,
  output wire        expect_15_0,
  output wire        expect_15_1,
  output wire        expect_16_0,
  output wire        expect_17_0
);

  assign expect_0_0 = lamp;
  assign expect_1_0 = lamp;
  assign expect_2_0 = ~lamp;
  assign expect_3_0 = ~lamp;
  assign expect_4_0 = lamp;
  assign expect_5_0 = lamp;
  assign expect_6_0 = lamp;
  assign expect_7_0 = ~lamp;
  assign expect_8_0 = ~lamp;
  assign expect_9_0 = lamp;
  assign expect_10_0 = ~lamp;
  assign expect_10_1 = cycle_ET == 32'd0;
  assign expect_11_0 = ~lamp;
  assign expect_12_0 = lamp;
  assign expect_13_0 = ~lamp;
  assign expect_14_0 = ~lamp;
  assign expect_15_0 = cycle_ET == 32'd0;
  assign expect_15_1 = lamp;
  assign expect_16_0 = lamp;
  assign expect_17_0 = ~lamp;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module flasher_rates_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg enable = 1'd0;
  reg slow = 1'd0;
  wire lamp;
  wire [31:0] cycle_ET;
  reg failed;
  integer failures;

  flasher_rates_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .enable(enable),
    .slow(slow),
    .lamp(lamp),
    .cycle_ET(cycle_ET)
  );

  wire expect_0_0;
  wire [0:0] expect_0 = {expect_0_0};
  wire expect_1_0;
  wire [0:0] expect_1 = {expect_1_0};
  wire expect_2_0;
  wire [0:0] expect_2 = {expect_2_0};
  wire expect_3_0;
  wire [0:0] expect_3 = {expect_3_0};
  wire expect_4_0;
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire [0:0] expect_6 = {expect_6_0};
  wire expect_7_0;
  wire [0:0] expect_7 = {expect_7_0};
  wire expect_8_0;
  wire [0:0] expect_8 = {expect_8_0};
  wire expect_9_0;
  wire [0:0] expect_9 = {expect_9_0};
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
  wire expect_15_1;
  wire [0:1] expect_15 = {expect_15_0, expect_15_1};
  wire expect_16_0;
  wire [0:0] expect_16 = {expect_16_0};
  wire expect_17_0;
  wire [0:0] expect_17 = {expect_17_0};
  flasher_rates_expect expectations (
    .clk(clk),
    .rst(rst),
    .lamp(lamp),
    .cycle_ET(cycle_ET),
    .expect_0_0(expect_0_0),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_7_0(expect_7_0),
    .expect_8_0(expect_8_0),
    .expect_9_0(expect_9_0),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_15_1(expect_15_1),
    .expect_16_0(expect_16_0),
    .expect_17_0(expect_17_0)
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
      slow = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..4");

    // on for 1.3 s, off for 1.2 s, for ever
    failed = 1'b0;
    reset;
    enable = 1'd1;
    scan(1, 1'b0);
    repeat (4) begin
      #1 if (!failed && &expect_0 !== 1'b1) begin // flasher_rates.ladder:26
        failed = 1'b1;
        $display("# failed expectation 0 conducts %b lamp=%b at %0s", expect_0, lamp, "flasher_rates.ladder:26");
      end
      scan(12, 1'b1);
      #1 if (!failed && &expect_1 !== 1'b1) begin // flasher_rates.ladder:28
        failed = 1'b1;
        $display("# failed expectation 1 conducts %b lamp=%b at %0s", expect_1, lamp, "flasher_rates.ladder:28");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_2 !== 1'b1) begin // flasher_rates.ladder:30
        failed = 1'b1;
        $display("# failed expectation 2 conducts %b lamp=%b at %0s", expect_2, lamp, "flasher_rates.ladder:30");
      end
      scan(11, 1'b1);
      #1 if (!failed && &expect_3 !== 1'b1) begin // flasher_rates.ladder:32
        failed = 1'b1;
        $display("# failed expectation 3 conducts %b lamp=%b at %0s", expect_3, lamp, "flasher_rates.ladder:32");
      end
      scan(1, 1'b1);
    end
    #1 if (!failed && &expect_4 !== 1'b1) begin // flasher_rates.ladder:35
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b lamp=%b at %0s", expect_4, lamp, "flasher_rates.ladder:35");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "on for 1.3 s, off for 1.2 s, for ever");
    end else $display("ok 1 - %0s", "on for 1.3 s, off for 1.2 s, for ever");

    // on for 2.5 s, off for 1.7 s, for ever
    failed = 1'b0;
    reset;
    enable = 1'd1;
    slow = 1'd1;
    scan(1, 1'b0);
    repeat (4) begin
      #1 if (!failed && &expect_5 !== 1'b1) begin // flasher_rates.ladder:40
        failed = 1'b1;
        $display("# failed expectation 5 conducts %b lamp=%b at %0s", expect_5, lamp, "flasher_rates.ladder:40");
      end
      scan(24, 1'b1);
      #1 if (!failed && &expect_6 !== 1'b1) begin // flasher_rates.ladder:42
        failed = 1'b1;
        $display("# failed expectation 6 conducts %b lamp=%b at %0s", expect_6, lamp, "flasher_rates.ladder:42");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_7 !== 1'b1) begin // flasher_rates.ladder:44
        failed = 1'b1;
        $display("# failed expectation 7 conducts %b lamp=%b at %0s", expect_7, lamp, "flasher_rates.ladder:44");
      end
      scan(16, 1'b1);
      #1 if (!failed && &expect_8 !== 1'b1) begin // flasher_rates.ladder:46
        failed = 1'b1;
        $display("# failed expectation 8 conducts %b lamp=%b at %0s", expect_8, lamp, "flasher_rates.ladder:46");
      end
      scan(1, 1'b1);
    end
    #1 if (!failed && &expect_9 !== 1'b1) begin // flasher_rates.ladder:49
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b lamp=%b at %0s", expect_9, lamp, "flasher_rates.ladder:49");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "on for 2.5 s, off for 1.7 s, for ever");
    end else $display("ok 2 - %0s", "on for 2.5 s, off for 1.7 s, for ever");

    // off at once without enable, and from the beginning with it
    failed = 1'b0;
    reset;
    enable = 1'd1;
    scan(1, 1'b0);
    scan(7, 1'b1);
    enable = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // flasher_rates.ladder:55
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b lamp=%b cycle_ET=%b at %0s", expect_10, lamp, cycle_ET, "flasher_rates.ladder:55");
    end
    scan(20, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // flasher_rates.ladder:57
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b lamp=%b at %0s", expect_11, lamp, "flasher_rates.ladder:57");
    end
    enable = 1'd1;
    scan(1, 1'b0);
    scan(12, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // flasher_rates.ladder:60
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b lamp=%b at %0s", expect_12, lamp, "flasher_rates.ladder:60");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_13 !== 1'b1) begin // flasher_rates.ladder:62
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b lamp=%b at %0s", expect_13, lamp, "flasher_rates.ladder:62");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "off at once without enable, and from the beginning with it");
    end else $display("ok 3 - %0s", "off at once without enable, and from the beginning with it");

    // a shorter cycle chosen when it is over already begins anew
    failed = 1'b0;
    reset;
    enable = 1'd1;
    slow = 1'd1;
    scan(1, 1'b0);
    scan(30, 1'b1);
    #1 if (!failed && &expect_14 !== 1'b1) begin // flasher_rates.ladder:67
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b lamp=%b at %0s", expect_14, lamp, "flasher_rates.ladder:67");
    end
    slow = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // flasher_rates.ladder:69
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b cycle_ET=%b lamp=%b at %0s", expect_15, cycle_ET, lamp, "flasher_rates.ladder:69");
    end
    scan(12, 1'b1);
    #1 if (!failed && &expect_16 !== 1'b1) begin // flasher_rates.ladder:71
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b lamp=%b at %0s", expect_16, lamp, "flasher_rates.ladder:71");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_17 !== 1'b1) begin // flasher_rates.ladder:73
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b lamp=%b at %0s", expect_17, lamp, "flasher_rates.ladder:73");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "a shorter cycle chosen when it is over already begins anew");
    end else $display("ok 4 - %0s", "a shorter cycle chosen when it is over already begins anew");

    if (failures != 0) $display("# %0d of 4 tests failed", failures);
    $finish;
  end
endmodule
