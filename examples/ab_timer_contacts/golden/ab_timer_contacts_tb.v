// Made by hotrail 0.1.0 from ab_timer_contacts.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_TON: on-delay timer of Allen-Bradley, BASE = 10 ticks
// Example, with PRE = 3, BASE = 1:
// IN  _#######__###_
// EN  _#######__###_
// TT  _###______###_
// DN  ____####______
// ACC 00123333000120
module ab_timer_contacts_test_AB_TON_BASE10 (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [15:0] PRE,
  output wire [14:0] ACC_last,
  output wire        EN,
  output wire        TT,
  output wire        DN
);
  reg [14:0] ACC = 15'd0;
  reg DN_reg = 1'b0;
  reg [3:0] fraction = 4'd0;
  reg was = 1'b0;

  wire less = $signed(PRE) < 16'sd0;
  wire [14:0] choice = less ? 15'd0 : PRE[14:0];
  wire condition = power & was & ~DN_reg & tick;
  wire equal = fraction == 4'd9;
  wire condition_2 = condition & equal;
  wire [3:0] sum = fraction + {3'b0, condition};
  wire [3:0] choice_2 = condition_2 ? 4'd0 : sum;
  wire unequal = ACC != 15'd32767;
  wire [14:0] sum_2 = ACC + {14'b0, condition_2 & unequal};
  wire at_least = sum_2 >= choice;
  wire DN_next = power & (DN_reg | at_least);
  wire [14:0] ACC_next = power ? sum_2 : 15'd0;
  wire [3:0] fraction_next = power ? choice_2 : 4'd0;

  assign ACC_last = ACC;
  assign EN = power;
  assign TT = power & ~DN_next;
  assign DN = DN_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 15'd0;
      DN_reg <= 1'b0;
      fraction <= 4'd0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      DN_reg <= DN_next;
      fraction <= fraction_next;
      was <= power;
    end
  end
endmodule

// TON: on-delay timer
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module ab_timer_contacts_test_TON (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [31:0] PT,
  output wire        Q
);
  reg [31:0] ET = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET) < $signed(PT);
  wire [31:0] sum = ET + {31'b0, tick & less};
  wire [31:0] ET_next = (power & was) ? sum : 32'd0;
  wire at_least = $signed(ET_next) >= $signed(PT);

  assign Q = power & at_least;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 32'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

module ab_timer_contacts_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        run,
  input  wire        slower,
  output wire        enabled,
  output wire        timing,
  output wire        done,
  output wire        not_enabled,
  output wire        not_timing,
  output wire        not_done,
  output wire        siemens_done,
  output wire [15:0] t4_0_ACC
);
  reg [6:0] t4_0_PRE = 7'd50;
  reg [12:0] preset = 13'd500;
  reg enabled_reg = 1'b0;
  reg timing_reg = 1'b0;
  reg done_reg = 1'b0;
  reg not_enabled_reg = 1'b0;
  reg not_timing_reg = 1'b0;
  reg not_done_reg = 1'b0;
  reg siemens_done_reg = 1'b0;

  // rung 1 "T4:0, 50 units of 10 ms", ab_timer_contacts.ladder:12
  wire [15:0] t4_0_PRE_2 = {7'b0, {{2{t4_0_PRE[6]}}, t4_0_PRE}};
  wire [14:0] t4_0_ACC_last;
  wire t4_0_EN;
  wire t4_0_TT;
  wire t4_0_DN;
  ab_timer_contacts_test_AB_TON_BASE10 t4_0 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(run),
    .PRE(t4_0_PRE_2),
    .ACC_last(t4_0_ACC_last),
    .EN(t4_0_EN),
    .TT(t4_0_TT),
    .DN(t4_0_DN)
  );

  // rung 2 "EN", ab_timer_contacts.ladder:15
  wire enabled_next = t4_0_EN;

  // rung 3 "TT", ab_timer_contacts.ladder:18
  wire timing_next = t4_0_TT;

  // rung 4 "DN", ab_timer_contacts.ladder:21
  wire done_next = t4_0_DN;

  // rung 5, ab_timer_contacts.ladder:24
  wire not_enabled_next = ~t4_0_EN;

  // rung 6, ab_timer_contacts.ladder:26
  wire not_timing_next = ~t4_0_TT;

  // rung 7, ab_timer_contacts.ladder:28
  wire not_done_next = ~t4_0_DN;

  // rung 8 "the same with Siemens' timer: only Q is built in", ab_timer_contacts.ladder:30
  wire [31:0] t1_PT = {19'b0, preset};
  wire t1_Q;
  ab_timer_contacts_test_TON t1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(run),
    .PT(t1_PT),
    .Q(t1_Q)
  );
  wire siemens_done_next = t1_Q;

  // rung 9 "from 0.5 s to 5 s", ab_timer_contacts.ladder:33
  wire [6:0] t4_0_PRE_next = slower ? 7'd116 : t4_0_PRE;
  wire [12:0] preset_next = slower ? 13'd5000 : preset;
  wire [15:0] t4_0_ACC_value = {1'b0, t4_0_ACC_last};

  assign enabled = enabled_reg;
  assign timing = timing_reg;
  assign done = done_reg;
  assign not_enabled = not_enabled_reg;
  assign not_timing = not_timing_reg;
  assign not_done = not_done_reg;
  assign siemens_done = siemens_done_reg;
  assign t4_0_ACC = t4_0_ACC_value;

  always @(posedge clk) begin
    if (rst) begin
      t4_0_PRE <= 7'd50;
      preset <= 13'd500;
      enabled_reg <= 1'b0;
      timing_reg <= 1'b0;
      done_reg <= 1'b0;
      not_enabled_reg <= 1'b0;
      not_timing_reg <= 1'b0;
      not_done_reg <= 1'b0;
      siemens_done_reg <= 1'b0;
    end else begin
      t4_0_PRE <= t4_0_PRE_next;
      preset <= preset_next;
      enabled_reg <= enabled_next;
      timing_reg <= timing_next;
      done_reg <= done_next;
      not_enabled_reg <= not_enabled_next;
      not_timing_reg <= not_timing_next;
      not_done_reg <= not_done_next;
      siemens_done_reg <= siemens_done_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module ab_timer_contacts_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        enabled,
  input  wire        timing,
  input  wire        done,
  input  wire        not_enabled,
  input  wire        not_timing,
  input  wire        not_done,
  input  wire        siemens_done,
  input  wire [15:0] t4_0_ACC,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_0_3,
  output wire        expect_0_4,
  output wire        expect_0_5,
  output wire        expect_0_6,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_1_2,
  output wire        expect_1_3,
  output wire        expect_1_4,
  output wire        expect_1_5,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_2_2,
  output wire        expect_2_3,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_3_2,
  output wire        expect_3_3,
  output wire        expect_3_4,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_5_2,
  output wire        expect_5_3,
  output wire        expect_5_4,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_9_2,
  output wire        expect_10_0,
  output wire        expect_10_1,
  output wire        expect_10_2,
  output wire        expect_11_0,
  output wire        expect_11_1,
  output wire        expect_12_0,
  output wire        expect_12_1
);

  assign expect_0_0 = ~enabled;
  assign expect_0_1 = ~timing;
  assign expect_0_2 = ~done;
  assign expect_0_3 = not_enabled;
  assign expect_0_4 = not_timing;
  assign expect_0_5 = not_done;
  assign expect_0_6 = ~siemens_done;
  assign expect_1_0 = enabled;
  assign expect_1_1 = timing;
  assign expect_1_2 = ~done;
  assign expect_1_3 = ~not_enabled;
  assign expect_1_4 = ~not_timing;
  assign expect_1_5 = not_done;
  assign expect_2_0 = timing;
  assign expect_2_1 = ~done;
  assign expect_2_2 = ~siemens_done;
  assign expect_2_3 = t4_0_ACC == 16'd49;
  assign expect_3_0 = enabled;
  assign expect_3_1 = ~timing;
  assign expect_3_2 = done;
  assign expect_3_3 = siemens_done;
  assign expect_3_4 = t4_0_ACC == 16'd50;
  assign expect_4_0 = done;
  assign expect_4_1 = siemens_done;
  assign expect_4_2 = t4_0_ACC == 16'd50;
  assign expect_5_0 = ~enabled;
  assign expect_5_1 = ~timing;
  assign expect_5_2 = ~done;
  assign expect_5_3 = ~siemens_done;
  assign expect_5_4 = t4_0_ACC == 16'd0;
  assign expect_6_0 = ~done;
  assign expect_6_1 = ~siemens_done;
  assign expect_7_0 = done;
  assign expect_7_1 = siemens_done;
  assign expect_8_0 = done;
  assign expect_8_1 = siemens_done;
  assign expect_9_0 = done;
  assign expect_9_1 = ~siemens_done;
  assign expect_9_2 = t4_0_ACC == 16'd50;
  assign expect_10_0 = done;
  assign expect_10_1 = siemens_done;
  assign expect_10_2 = t4_0_ACC == 16'd50;
  assign expect_11_0 = ~done;
  assign expect_11_1 = ~siemens_done;
  assign expect_12_0 = done;
  assign expect_12_1 = siemens_done;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module ab_timer_contacts_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg run = 1'd0;
  reg slower = 1'd0;
  wire enabled;
  wire timing;
  wire done;
  wire not_enabled;
  wire not_timing;
  wire not_done;
  wire siemens_done;
  wire [15:0] t4_0_ACC;
  reg failed;
  integer failures;

  ab_timer_contacts_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .run(run),
    .slower(slower),
    .enabled(enabled),
    .timing(timing),
    .done(done),
    .not_enabled(not_enabled),
    .not_timing(not_timing),
    .not_done(not_done),
    .siemens_done(siemens_done),
    .t4_0_ACC(t4_0_ACC)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire expect_0_3;
  wire expect_0_4;
  wire expect_0_5;
  wire expect_0_6;
  wire [0:6] expect_0 = {expect_0_0, expect_0_1, expect_0_2, expect_0_3, expect_0_4, expect_0_5, expect_0_6};
  wire expect_1_0;
  wire expect_1_1;
  wire expect_1_2;
  wire expect_1_3;
  wire expect_1_4;
  wire expect_1_5;
  wire [0:5] expect_1 = {expect_1_0, expect_1_1, expect_1_2, expect_1_3, expect_1_4, expect_1_5};
  wire expect_2_0;
  wire expect_2_1;
  wire expect_2_2;
  wire expect_2_3;
  wire [0:3] expect_2 = {expect_2_0, expect_2_1, expect_2_2, expect_2_3};
  wire expect_3_0;
  wire expect_3_1;
  wire expect_3_2;
  wire expect_3_3;
  wire expect_3_4;
  wire [0:4] expect_3 = {expect_3_0, expect_3_1, expect_3_2, expect_3_3, expect_3_4};
  wire expect_4_0;
  wire expect_4_1;
  wire expect_4_2;
  wire [0:2] expect_4 = {expect_4_0, expect_4_1, expect_4_2};
  wire expect_5_0;
  wire expect_5_1;
  wire expect_5_2;
  wire expect_5_3;
  wire expect_5_4;
  wire [0:4] expect_5 = {expect_5_0, expect_5_1, expect_5_2, expect_5_3, expect_5_4};
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
  wire expect_9_2;
  wire [0:2] expect_9 = {expect_9_0, expect_9_1, expect_9_2};
  wire expect_10_0;
  wire expect_10_1;
  wire expect_10_2;
  wire [0:2] expect_10 = {expect_10_0, expect_10_1, expect_10_2};
  wire expect_11_0;
  wire expect_11_1;
  wire [0:1] expect_11 = {expect_11_0, expect_11_1};
  wire expect_12_0;
  wire expect_12_1;
  wire [0:1] expect_12 = {expect_12_0, expect_12_1};
  ab_timer_contacts_expect expectations (
    .clk(clk),
    .rst(rst),
    .enabled(enabled),
    .timing(timing),
    .done(done),
    .not_enabled(not_enabled),
    .not_timing(not_timing),
    .not_done(not_done),
    .siemens_done(siemens_done),
    .t4_0_ACC(t4_0_ACC),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_0_3(expect_0_3),
    .expect_0_4(expect_0_4),
    .expect_0_5(expect_0_5),
    .expect_0_6(expect_0_6),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_1_3(expect_1_3),
    .expect_1_4(expect_1_4),
    .expect_1_5(expect_1_5),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_2_2(expect_2_2),
    .expect_2_3(expect_2_3),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_3_3(expect_3_3),
    .expect_3_4(expect_3_4),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_5_2(expect_5_2),
    .expect_5_3(expect_5_3),
    .expect_5_4(expect_5_4),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_9_2(expect_9_2),
    .expect_10_0(expect_10_0),
    .expect_10_1(expect_10_1),
    .expect_10_2(expect_10_2),
    .expect_11_0(expect_11_0),
    .expect_11_1(expect_11_1),
    .expect_12_0(expect_12_0),
    .expect_12_1(expect_12_1)
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
      run = 1'd0;
      slower = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..4");

    // half a second
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // ab_timer_contacts.ladder:38
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b enabled=%b timing=%b done=%b not_enabled=%b not_timing=%b not_done=%b siemens_done=%b at %0s", expect_0, enabled, timing, done, not_enabled, not_timing, not_done, siemens_done, "ab_timer_contacts.ladder:38");
    end
    run = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // ab_timer_contacts.ladder:40
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b enabled=%b timing=%b done=%b not_enabled=%b not_timing=%b not_done=%b at %0s", expect_1, enabled, timing, done, not_enabled, not_timing, not_done, "ab_timer_contacts.ladder:40");
    end
    scan(499, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // ab_timer_contacts.ladder:42
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b timing=%b done=%b siemens_done=%b t4_0_ACC=%b at %0s", expect_2, timing, done, siemens_done, t4_0_ACC, "ab_timer_contacts.ladder:42");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // ab_timer_contacts.ladder:44
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b enabled=%b timing=%b done=%b siemens_done=%b t4_0_ACC=%b at %0s", expect_3, enabled, timing, done, siemens_done, t4_0_ACC, "ab_timer_contacts.ladder:44");
    end
    scan(1000, 1'b1);
    #1 if (!failed && &expect_4 !== 1'b1) begin // ab_timer_contacts.ladder:46
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b done=%b siemens_done=%b t4_0_ACC=%b at %0s", expect_4, done, siemens_done, t4_0_ACC, "ab_timer_contacts.ladder:46");
    end
    run = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // ab_timer_contacts.ladder:48
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b enabled=%b timing=%b done=%b siemens_done=%b t4_0_ACC=%b at %0s", expect_5, enabled, timing, done, siemens_done, t4_0_ACC, "ab_timer_contacts.ladder:48");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "half a second");
    end else $display("ok 1 - %0s", "half a second");

    // a power that is on in the first scan times like any other, on both
    failed = 1'b0;
    reset;
    run = 1'd1;
    scan(1, 1'b0);
    scan(499, 1'b1);
    #1 if (!failed && &expect_6 !== 1'b1) begin // ab_timer_contacts.ladder:53
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b done=%b siemens_done=%b at %0s", expect_6, done, siemens_done, "ab_timer_contacts.ladder:53");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // ab_timer_contacts.ladder:55
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b done=%b siemens_done=%b at %0s", expect_7, done, siemens_done, "ab_timer_contacts.ladder:55");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "a power that is on in the first scan times like any other, on both");
    end else $display("ok 2 - %0s", "a power that is on in the first scan times like any other, on both");

    // a preset that grows: DN stays on, Siemens' Q goes off and the time goes on
    failed = 1'b0;
    reset;
    run = 1'd1;
    scan(1, 1'b0);
    scan(500, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // ab_timer_contacts.ladder:59
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b done=%b siemens_done=%b at %0s", expect_8, done, siemens_done, "ab_timer_contacts.ladder:59");
    end
    slower = 1'd1;
    scan(1, 1'b0);
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // ab_timer_contacts.ladder:62
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b done=%b siemens_done=%b t4_0_ACC=%b at %0s", expect_9, done, siemens_done, t4_0_ACC, "ab_timer_contacts.ladder:62");
    end
    scan(4500, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // ab_timer_contacts.ladder:64
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b done=%b siemens_done=%b t4_0_ACC=%b at %0s", expect_10, done, siemens_done, t4_0_ACC, "ab_timer_contacts.ladder:64");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a preset that grows: DN stays on, Siemens' Q goes off and the time goes on");
    end else $display("ok 3 - %0s", "a preset that grows: DN stays on, Siemens' Q goes off and the time goes on");

    // a preset that grows in time counts on both
    failed = 1'b0;
    reset;
    run = 1'd1;
    scan(1, 1'b0);
    scan(400, 1'b1);
    slower = 1'd1;
    scan(1, 1'b0);
    scan(4599, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // ab_timer_contacts.ladder:70
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b done=%b siemens_done=%b at %0s", expect_11, done, siemens_done, "ab_timer_contacts.ladder:70");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // ab_timer_contacts.ladder:72
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b done=%b siemens_done=%b at %0s", expect_12, done, siemens_done, "ab_timer_contacts.ladder:72");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "a preset that grows in time counts on both");
    end else $display("ok 4 - %0s", "a preset that grows in time counts on both");

    if (failures != 0) $display("# %0d of 4 tests failed", failures);
    $finish;
  end
endmodule
