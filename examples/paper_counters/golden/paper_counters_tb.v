// Made by hotrail 0.1.0 from paper_counters.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// UC: up counter with enable
// Fitted to PV = 5.
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// EN  #########__####
// Q   ___######____##
// ACC 011222334001122
module paper_counters_test_UC_PV5 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        EN,
  output wire        Q,
  output wire [13:0] ACC_last
);
  reg [13:0] ACC = 14'd0;
  reg was = 1'b0;
  reg ACC_at_least_5 = 1'b0;

  wire unequal = ACC != 14'd9999;
  wire condition = power & ~was & unequal;
  wire [13:0] sum = ACC + {13'b0, condition};
  wire [13:0] ACC_next = EN ? sum : 14'd0;
  wire equal = ACC == 14'd4;
  wire choice = condition ? equal | ACC_at_least_5 : ACC_at_least_5;
  wire ACC_at_least_5_next = EN & choice;

  assign Q = ACC_at_least_5_next;
  assign ACC_last = ACC;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 14'd0;
      was <= 1'b0;
      ACC_at_least_5 <= 1'b0;
    end else begin
      ACC <= ACC_next;
      was <= power;
      ACC_at_least_5 <= ACC_at_least_5_next;
    end
  end
endmodule

// DC: down counter with enable
// Fitted to PV = 5.
// Example, with PV = 2:
// IN  _#_##_#_#__
// EN  #######__##
// Q   ___####____
// ACC 21100002222
module paper_counters_test_DC_PV5 (
  input  wire       clk,
  input  wire       rst,
  input  wire       power,
  input  wire       EN,
  output wire       Q,
  output wire [2:0] ACC_last
);
  reg [2:0] ACC = 3'd5;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire equal = ACC == 3'd0;
  wire [2:0] difference = ACC - {2'b0, condition & ~equal};
  wire [2:0] ACC_next = EN ? difference : 3'd5;
  wire equal_2 = ACC == 3'd1;

  assign Q = EN & (condition & equal_2 | equal);
  assign ACC_last = ACC;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 3'd5;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      was <= power;
    end
  end
endmodule

// DRUM: drum counter, TAPS = [2, 4, 6, 8]
// Fitted to PV = 10.
// Example, with PV = 3, TAPS = [1, 2]:
// IN   _#_#_#_#___
// EN   #########_#
// Q    _____####__
// TAP0 _########__
// TAP1 ___######__
// ACC  01122334400
module paper_counters_test_DRUM_PV10 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        EN,
  output wire        Q,
  output wire [10:0] ACC_last,
  output wire        TAP0,
  output wire        TAP1,
  output wire        TAP2,
  output wire        TAP3
);
  reg [10:0] ACC = 11'd0;
  reg was = 1'b0;
  reg ACC_at_least_10 = 1'b0;
  reg ACC_at_least_2 = 1'b0;
  reg ACC_at_least_4 = 1'b0;
  reg ACC_at_least_6 = 1'b0;
  reg ACC_at_least_8 = 1'b0;

  wire unequal = ACC != 11'd2047;
  wire condition = power & ~was & unequal;
  wire [10:0] sum = ACC + {10'b0, condition};
  wire [10:0] ACC_next = EN ? sum : 11'd0;
  wire equal = ACC == 11'd9;
  wire choice = condition ? equal | ACC_at_least_10 : ACC_at_least_10;
  wire ACC_at_least_10_next = EN & choice;
  wire equal_2 = ACC == 11'd1;
  wire choice_2 = condition ? equal_2 | ACC_at_least_2 : ACC_at_least_2;
  wire ACC_at_least_2_next = EN & choice_2;
  wire equal_3 = ACC == 11'd3;
  wire choice_3 = condition ? equal_3 | ACC_at_least_4 : ACC_at_least_4;
  wire ACC_at_least_4_next = EN & choice_3;
  wire equal_4 = ACC == 11'd5;
  wire choice_4 = condition ? equal_4 | ACC_at_least_6 : ACC_at_least_6;
  wire ACC_at_least_6_next = EN & choice_4;
  wire equal_5 = ACC == 11'd7;
  wire choice_5 = condition ? equal_5 | ACC_at_least_8 : ACC_at_least_8;
  wire ACC_at_least_8_next = EN & choice_5;

  assign Q = ACC_at_least_10_next;
  assign ACC_last = ACC;
  assign TAP0 = ACC_at_least_2_next;
  assign TAP1 = ACC_at_least_4_next;
  assign TAP2 = ACC_at_least_6_next;
  assign TAP3 = ACC_at_least_8_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 11'd0;
      was <= 1'b0;
      ACC_at_least_10 <= 1'b0;
      ACC_at_least_2 <= 1'b0;
      ACC_at_least_4 <= 1'b0;
      ACC_at_least_6 <= 1'b0;
      ACC_at_least_8 <= 1'b0;
    end else begin
      ACC <= ACC_next;
      was <= power;
      ACC_at_least_10 <= ACC_at_least_10_next;
      ACC_at_least_2 <= ACC_at_least_2_next;
      ACC_at_least_4 <= ACC_at_least_4_next;
      ACC_at_least_6 <= ACC_at_least_6_next;
      ACC_at_least_8 <= ACC_at_least_8_next;
    end
  end
endmodule

module paper_counters_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        c1,
  input  wire        c2,
  input  wire        c3,
  input  wire        c4,
  input  wire        c5,
  input  wire        c6,
  input  wire        c7,
  input  wire        c8,
  input  wire        c9,
  input  wire        cnt_en_ckt,
  output wire        up_coil,
  output wire        down_coil,
  output wire        drum_coil,
  output wire        tap0_out,
  output wire        tap1_out,
  output wire        tap2_out,
  output wire        tap3_out,
  output wire [15:0] up_ACC,
  output wire [15:0] down_ACC,
  output wire [15:0] drum_ACC
);
  reg up_coil_reg = 1'b0;
  reg down_coil_reg = 1'b0;
  reg drum_coil_reg = 1'b0;
  reg tap0_out_reg = 1'b0;
  reg tap1_out_reg = 1'b0;
  reg tap2_out_reg = 1'b0;
  reg tap3_out_reg = 1'b0;

  // rung 1 "the paper's Figure 14", paper_counters.ladder:11
  wire rung1_power = c9 | c2 & c3 & c4;
  wire counting_ckt = rung1_power & c1 | (c5 | rung1_power & c6) & (c7 & c8 | c6 & c1);

  // rung 2 "from zero to the preset", paper_counters.ladder:20
  wire up_Q;
  wire [13:0] up_ACC_last;
  paper_counters_test_UC_PV5 up (
    .clk(clk),
    .rst(rst),
    .power(counting_ckt),
    .EN(cnt_en_ckt),
    .Q(up_Q),
    .ACC_last(up_ACC_last)
  );
  wire up_coil_next = up_Q;

  // rung 3 "from the preset to zero", paper_counters.ladder:23
  wire down_Q;
  wire [2:0] down_ACC_last;
  paper_counters_test_DC_PV5 down (
    .clk(clk),
    .rst(rst),
    .power(counting_ckt),
    .EN(cnt_en_ckt),
    .Q(down_Q),
    .ACC_last(down_ACC_last)
  );
  wire down_coil_next = down_Q;

  // rung 4 "up to 2047, with four taps", paper_counters.ladder:26
  wire drum_Q;
  wire [10:0] drum_ACC_last;
  wire drum_TAP0;
  wire drum_TAP1;
  wire drum_TAP2;
  wire drum_TAP3;
  paper_counters_test_DRUM_PV10 drum (
    .clk(clk),
    .rst(rst),
    .power(counting_ckt),
    .EN(cnt_en_ckt),
    .Q(drum_Q),
    .ACC_last(drum_ACC_last),
    .TAP0(drum_TAP0),
    .TAP1(drum_TAP1),
    .TAP2(drum_TAP2),
    .TAP3(drum_TAP3)
  );
  wire drum_coil_next = drum_Q;

  // rung 5, paper_counters.ladder:29
  wire tap0_out_next = drum_TAP0;

  // rung 6, paper_counters.ladder:31
  wire tap1_out_next = drum_TAP1;

  // rung 7, paper_counters.ladder:33
  wire tap2_out_next = drum_TAP2;

  // rung 8, paper_counters.ladder:35
  wire [15:0] up_ACC_value = {2'b0, up_ACC_last};
  wire [15:0] down_ACC_value = {13'b0, down_ACC_last};
  wire [15:0] drum_ACC_value = {5'b0, drum_ACC_last};
  wire tap3_out_next = drum_TAP3;

  assign up_coil = up_coil_reg;
  assign down_coil = down_coil_reg;
  assign drum_coil = drum_coil_reg;
  assign tap0_out = tap0_out_reg;
  assign tap1_out = tap1_out_reg;
  assign tap2_out = tap2_out_reg;
  assign tap3_out = tap3_out_reg;
  assign up_ACC = up_ACC_value;
  assign down_ACC = down_ACC_value;
  assign drum_ACC = drum_ACC_value;

  always @(posedge clk) begin
    if (rst) begin
      up_coil_reg <= 1'b0;
      down_coil_reg <= 1'b0;
      drum_coil_reg <= 1'b0;
      tap0_out_reg <= 1'b0;
      tap1_out_reg <= 1'b0;
      tap2_out_reg <= 1'b0;
      tap3_out_reg <= 1'b0;
    end else begin
      up_coil_reg <= up_coil_next;
      down_coil_reg <= down_coil_next;
      drum_coil_reg <= drum_coil_next;
      tap0_out_reg <= tap0_out_next;
      tap1_out_reg <= tap1_out_next;
      tap2_out_reg <= tap2_out_next;
      tap3_out_reg <= tap3_out_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module paper_counters_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        up_coil,
  input  wire        down_coil,
  input  wire [15:0] up_ACC,
  input  wire [15:0] down_ACC,
  input  wire        tap0_out,
  input  wire        tap1_out,
  input  wire        tap2_out,
  input  wire        tap3_out,
  input  wire [15:0] drum_ACC,
  input  wire        drum_coil,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_0_3,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_1_2,
  output wire        expect_1_3,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_2_2,
  output wire        expect_2_3,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_3_2,
  output wire        expect_3_3,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_4_3,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_6_2,
  output wire        expect_6_3,
  output wire        expect_6_4,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_9_2,
  output wire        expect_9_3,
  output wire        expect_9_4,
  output wire        expect_9_5,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_10_2
);

  assign expect_0_0 = ~up_coil;
  assign expect_0_1 = ~down_coil;
  assign expect_0_2 = up_ACC == 16'd0;
  assign expect_0_3 = down_ACC == 16'd5;
  assign expect_1_0 = ~up_coil;
  assign expect_1_1 = ~down_coil;
  assign expect_1_2 = up_ACC == 16'd4;
  assign expect_1_3 = down_ACC == 16'd1;
  assign expect_2_0 = up_coil;
  assign expect_2_1 = down_coil;
  assign expect_2_2 = up_ACC == 16'd5;
  assign expect_2_3 = down_ACC == 16'd0;
  assign expect_3_0 = up_coil;
  assign expect_3_1 = down_coil;
  assign expect_3_2 = up_ACC == 16'd6;
  assign expect_3_3 = down_ACC == 16'd0;
  assign expect_4_0 = ~up_coil;
  assign expect_4_1 = ~down_coil;
  assign expect_4_2 = up_ACC == 16'd0;
  assign expect_4_3 = down_ACC == 16'd5;
  assign expect_5_0 = tap0_out;
  assign expect_5_1 = ~tap1_out;
  assign expect_6_0 = tap0_out;
  assign expect_6_1 = tap1_out;
  assign expect_6_2 = tap2_out;
  assign expect_6_3 = ~tap3_out;
  assign expect_6_4 = drum_ACC == 16'd7;
  assign expect_7_0 = tap3_out;
  assign expect_7_1 = ~drum_coil;
  assign expect_8_0 = tap3_out;
  assign expect_8_1 = drum_coil;
  assign expect_9_0 = ~tap0_out;
  assign expect_9_1 = ~tap1_out;
  assign expect_9_2 = ~tap2_out;
  assign expect_9_3 = ~tap3_out;
  assign expect_9_4 = ~drum_coil;
  assign expect_9_5 = drum_ACC == 16'd0;
  assign expect_10_0 = up_ACC == 16'd0;
  assign expect_10_1 = down_ACC == 16'd5;
  assign expect_10_2 = drum_ACC == 16'd0;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module paper_counters_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg c1 = 1'd0;
  reg c2 = 1'd0;
  reg c3 = 1'd0;
  reg c4 = 1'd0;
  reg c5 = 1'd0;
  reg c6 = 1'd0;
  reg c7 = 1'd0;
  reg c8 = 1'd0;
  reg c9 = 1'd0;
  reg cnt_en_ckt = 1'd0;
  wire up_coil;
  wire down_coil;
  wire drum_coil;
  wire tap0_out;
  wire tap1_out;
  wire tap2_out;
  wire tap3_out;
  wire [15:0] up_ACC;
  wire [15:0] down_ACC;
  wire [15:0] drum_ACC;
  reg failed;
  integer failures;

  paper_counters_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .c1(c1),
    .c2(c2),
    .c3(c3),
    .c4(c4),
    .c5(c5),
    .c6(c6),
    .c7(c7),
    .c8(c8),
    .c9(c9),
    .cnt_en_ckt(cnt_en_ckt),
    .up_coil(up_coil),
    .down_coil(down_coil),
    .drum_coil(drum_coil),
    .tap0_out(tap0_out),
    .tap1_out(tap1_out),
    .tap2_out(tap2_out),
    .tap3_out(tap3_out),
    .up_ACC(up_ACC),
    .down_ACC(down_ACC),
    .drum_ACC(drum_ACC)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire expect_0_3;
  wire [0:3] expect_0 = {expect_0_0, expect_0_1, expect_0_2, expect_0_3};
  wire expect_1_0;
  wire expect_1_1;
  wire expect_1_2;
  wire expect_1_3;
  wire [0:3] expect_1 = {expect_1_0, expect_1_1, expect_1_2, expect_1_3};
  wire expect_2_0;
  wire expect_2_1;
  wire expect_2_2;
  wire expect_2_3;
  wire [0:3] expect_2 = {expect_2_0, expect_2_1, expect_2_2, expect_2_3};
  wire expect_3_0;
  wire expect_3_1;
  wire expect_3_2;
  wire expect_3_3;
  wire [0:3] expect_3 = {expect_3_0, expect_3_1, expect_3_2, expect_3_3};
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
  wire expect_6_2;
  wire expect_6_3;
  wire expect_6_4;
  wire [0:4] expect_6 = {expect_6_0, expect_6_1, expect_6_2, expect_6_3, expect_6_4};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
  wire expect_8_0;
  wire expect_8_1;
  wire [0:1] expect_8 = {expect_8_0, expect_8_1};
  wire expect_9_0;
  wire expect_9_1;
  wire expect_9_2;
  wire expect_9_3;
  wire expect_9_4;
  wire expect_9_5;
  wire [0:5] expect_9 = {expect_9_0, expect_9_1, expect_9_2, expect_9_3, expect_9_4, expect_9_5};
  wire expect_10_0;
  wire expect_10_1;
  wire expect_10_2;
  wire [0:2] expect_10 = {expect_10_0, expect_10_1, expect_10_2};
  paper_counters_expect expectations (
    .clk(clk),
    .rst(rst),
    .up_coil(up_coil),
    .down_coil(down_coil),
    .up_ACC(up_ACC),
    .down_ACC(down_ACC),
    .tap0_out(tap0_out),
    .tap1_out(tap1_out),
    .tap2_out(tap2_out),
    .tap3_out(tap3_out),
    .drum_ACC(drum_ACC),
    .drum_coil(drum_coil),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_0_3(expect_0_3),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_1_3(expect_1_3),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_2_2(expect_2_2),
    .expect_2_3(expect_2_3),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_3_3(expect_3_3),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_4_3(expect_4_3),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_6_2(expect_6_2),
    .expect_6_3(expect_6_3),
    .expect_6_4(expect_6_4),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_9_2(expect_9_2),
    .expect_9_3(expect_9_3),
    .expect_9_4(expect_9_4),
    .expect_9_5(expect_9_5),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_10_2(expect_10_2)
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
      c1 = 1'd0;
      c2 = 1'd0;
      c3 = 1'd0;
      c4 = 1'd0;
      c5 = 1'd0;
      c6 = 1'd0;
      c7 = 1'd0;
      c8 = 1'd0;
      c9 = 1'd0;
      cnt_en_ckt = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..3");

    // up and down
    failed = 1'b0;
    reset;
    cnt_en_ckt = 1'd1;
    c9 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // paper_counters.ladder:39
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b up_coil=%b down_coil=%b up_ACC=%b down_ACC=%b at %0s", expect_0, up_coil, down_coil, up_ACC, down_ACC, "paper_counters.ladder:39");
    end
    repeat (4) begin
      c1 = 1'd1;
      scan(1, 1'b0);
      c1 = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_1 !== 1'b1) begin // paper_counters.ladder:41
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b up_coil=%b down_coil=%b up_ACC=%b down_ACC=%b at %0s", expect_1, up_coil, down_coil, up_ACC, down_ACC, "paper_counters.ladder:41");
    end
    c1 = 1'd1;
    scan(1, 1'b0);
    c1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // paper_counters.ladder:43
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b up_coil=%b down_coil=%b up_ACC=%b down_ACC=%b at %0s", expect_2, up_coil, down_coil, up_ACC, down_ACC, "paper_counters.ladder:43");
    end
    c1 = 1'd1;
    scan(1, 1'b0);
    c1 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // paper_counters.ladder:45
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b up_coil=%b down_coil=%b up_ACC=%b down_ACC=%b at %0s", expect_3, up_coil, down_coil, up_ACC, down_ACC, "paper_counters.ladder:45");
    end
    cnt_en_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // paper_counters.ladder:47
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b up_coil=%b down_coil=%b up_ACC=%b down_ACC=%b at %0s", expect_4, up_coil, down_coil, up_ACC, down_ACC, "paper_counters.ladder:47");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "up and down");
    end else $display("ok 1 - %0s", "up and down");

    // the taps come on one after another
    failed = 1'b0;
    reset;
    cnt_en_ckt = 1'd1;
    c5 = 1'd1;
    c7 = 1'd1;
    scan(1, 1'b0);
    repeat (2) begin
      c8 = 1'd1;
      scan(1, 1'b0);
      c8 = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_5 !== 1'b1) begin // paper_counters.ladder:52
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b tap0_out=%b tap1_out=%b at %0s", expect_5, tap0_out, tap1_out, "paper_counters.ladder:52");
    end
    repeat (5) begin
      c8 = 1'd1;
      scan(1, 1'b0);
      c8 = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_6 !== 1'b1) begin // paper_counters.ladder:54
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b tap0_out=%b tap1_out=%b tap2_out=%b tap3_out=%b drum_ACC=%b at %0s", expect_6, tap0_out, tap1_out, tap2_out, tap3_out, drum_ACC, "paper_counters.ladder:54");
    end
    c8 = 1'd1;
    scan(1, 1'b0);
    c8 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // paper_counters.ladder:56
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b tap3_out=%b drum_coil=%b at %0s", expect_7, tap3_out, drum_coil, "paper_counters.ladder:56");
    end
    repeat (2) begin
      c8 = 1'd1;
      scan(1, 1'b0);
      c8 = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_8 !== 1'b1) begin // paper_counters.ladder:58
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b tap3_out=%b drum_coil=%b at %0s", expect_8, tap3_out, drum_coil, "paper_counters.ladder:58");
    end
    cnt_en_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // paper_counters.ladder:60
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b tap0_out=%b tap1_out=%b tap2_out=%b tap3_out=%b drum_coil=%b drum_ACC=%b at %0s", expect_9, tap0_out, tap1_out, tap2_out, tap3_out, drum_coil, drum_ACC, "paper_counters.ladder:60");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "the taps come on one after another");
    end else $display("ok 2 - %0s", "the taps come on one after another");

    // a rise while the enable circuit is open is seen and not counted
    failed = 1'b0;
    reset;
    c9 = 1'd1;
    c1 = 1'd1;
    scan(1, 1'b0);
    cnt_en_ckt = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_10 !== 1'b1) begin // paper_counters.ladder:65
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b up_ACC=%b down_ACC=%b drum_ACC=%b at %0s", expect_10, up_ACC, down_ACC, drum_ACC, "paper_counters.ladder:65");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a rise while the enable circuit is open is seen and not counted");
    end else $display("ok 3 - %0s", "a rise while the enable circuit is open is seen and not counted");

    if (failures != 0) $display("# %0d of 3 tests failed", failures);
    $finish;
  end
endmodule
