// Made by hotrail 0.1.0 from paper_shift.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// SHL: shift register to the left, REG has 48 bits
// Example, with REG = 1, REG0 = 32769:
// IN   #_#_#_#
// DATA __#___#
// EN   ####_##
// Q    ##_____
// REG0 2255001
module paper_shift_test_SHL_48 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        EN,
  input  wire        DATA,
  input  wire [15:0] REG0_before,
  input  wire [15:0] REG1_before,
  input  wire [15:0] REG2_before,
  output wire        Q,
  output wire [15:0] REG0,
  output wire [15:0] REG1,
  output wire [15:0] REG2
);
  reg Q_reg = 1'b0;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire [15:0] choice = condition ? {REG0_before[14:0], DATA} : REG0_before;
  wire [15:0] REG0_value = EN ? choice : 16'd0;
  wire [15:0] choice_2 = condition ? {REG1_before[14:0], REG0_before[15]} : REG1_before;
  wire [15:0] REG1_value = EN ? choice_2 : 16'd0;
  wire [15:0] choice_3 = condition ? {REG2_before[14:0], REG1_before[15]} : REG2_before;
  wire [15:0] REG2_value = EN ? choice_3 : 16'd0;
  wire choice_4 = condition ? REG2_before[15] : Q_reg;
  wire Q_next = EN ? choice_4 : 1'b0;

  assign Q = Q_next;
  assign REG0 = REG0_value;
  assign REG1 = REG1_value;
  assign REG2 = REG2_value;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      was <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      was <= power;
    end
  end
endmodule

// SHR: shift register to the right, REG has 32 bits
// Example, with REG = 1, REG0 = 3:
// IN   #_#_#
// EN   #####
// Q    ####_
// REG0 11000
module paper_shift_test_SHR_32 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        EN,
  input  wire        DATA,
  input  wire [15:0] REG0_before,
  input  wire [15:0] REG1_before,
  output wire        Q,
  output wire [15:0] REG0,
  output wire [15:0] REG1
);
  reg Q_reg = 1'b0;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire [15:0] choice = condition ? {DATA, REG1_before[15:1]} : REG1_before;
  wire [15:0] REG1_value = EN ? choice : 16'd0;
  wire [15:0] choice_2 = condition ? {REG1_before[0], REG0_before[15:1]} : REG0_before;
  wire [15:0] REG0_value = EN ? choice_2 : 16'd0;
  wire choice_3 = condition ? REG0_before[0] : Q_reg;
  wire Q_next = EN ? choice_3 : 1'b0;

  assign Q = Q_next;
  assign REG0 = REG0_value;
  assign REG1 = REG1_value;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      was <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      was <= power;
    end
  end
endmodule

module paper_shift_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        shift_ckt,
  input  wire        shift_en_ckt,
  input  wire        serialdata_ckt,
  output wire        left_coil,
  output wire        right_coil,
  output wire [15:0] actualdata_0,
  output wire [15:0] actualdata_1,
  output wire [15:0] actualdata_2,
  output wire [15:0] two_0,
  output wire [15:0] two_1
);
  reg [15:0] actualdata_0_reg = 16'hffff;
  reg [15:0] actualdata_1_reg = 16'd3855;
  reg [15:0] actualdata_2_reg = 16'hf0f0;
  reg [15:0] two_0_reg = 16'd3855;
  reg [15:0] two_1_reg = 16'h8001;
  reg left_coil_reg = 1'b0;
  reg right_coil_reg = 1'b0;

  // rung 1 "SL", paper_shift.ladder:10
  wire sl_Q;
  wire [15:0] sl_REG0;
  wire [15:0] sl_REG1;
  wire [15:0] sl_REG2;
  paper_shift_test_SHL_48 sl (
    .clk(clk),
    .rst(rst),
    .power(shift_ckt),
    .EN(shift_en_ckt),
    .DATA(serialdata_ckt),
    .REG0_before(actualdata_0_reg),
    .REG1_before(actualdata_1_reg),
    .REG2_before(actualdata_2_reg),
    .Q(sl_Q),
    .REG0(sl_REG0),
    .REG1(sl_REG1),
    .REG2(sl_REG2)
  );
  wire left_coil_next = sl_Q;

  // rung 2 "SR", paper_shift.ladder:13
  wire sr_Q;
  wire [15:0] sr_REG0;
  wire [15:0] sr_REG1;
  paper_shift_test_SHR_32 sr (
    .clk(clk),
    .rst(rst),
    .power(shift_ckt),
    .EN(shift_en_ckt),
    .DATA(serialdata_ckt),
    .REG0_before(two_0_reg),
    .REG1_before(two_1_reg),
    .Q(sr_Q),
    .REG0(sr_REG0),
    .REG1(sr_REG1)
  );
  wire right_coil_next = sr_Q;

  assign left_coil = left_coil_reg;
  assign right_coil = right_coil_reg;
  assign actualdata_0 = actualdata_0_reg;
  assign actualdata_1 = actualdata_1_reg;
  assign actualdata_2 = actualdata_2_reg;
  assign two_0 = two_0_reg;
  assign two_1 = two_1_reg;

  always @(posedge clk) begin
    if (rst) begin
      actualdata_0_reg <= 16'hffff;
      actualdata_1_reg <= 16'd3855;
      actualdata_2_reg <= 16'hf0f0;
      two_0_reg <= 16'd3855;
      two_1_reg <= 16'h8001;
      left_coil_reg <= 1'b0;
      right_coil_reg <= 1'b0;
    end else begin
      actualdata_0_reg <= sl_REG0;
      actualdata_1_reg <= sl_REG1;
      actualdata_2_reg <= sl_REG2;
      two_0_reg <= sr_REG0;
      two_1_reg <= sr_REG1;
      left_coil_reg <= left_coil_next;
      right_coil_reg <= right_coil_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module paper_shift_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        left_coil,
  input  wire [15:0] actualdata_0,
  input  wire [15:0] actualdata_1,
  input  wire [15:0] actualdata_2,
  input  wire        right_coil,
  input  wire [15:0] two_0,
  input  wire [15:0] two_1,
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
  output wire        expect_5_2,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_6_2,
  output wire        expect_7_0,
  output wire        expect_7_1,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_8_2,
  output wire        expect_8_3,
  output wire        expect_8_4
);

  assign expect_0_0 = left_coil;
  assign expect_0_1 = actualdata_0 == 16'hfffe;
  assign expect_0_2 = actualdata_1 == 16'd7711;
  assign expect_0_3 = actualdata_2 == 16'he1e0;
  assign expect_1_0 = left_coil;
  assign expect_1_1 = actualdata_0 == 16'hfffc;
  assign expect_1_2 = actualdata_1 == 16'd15423;
  assign expect_1_3 = actualdata_2 == 16'hc3c0;
  assign expect_2_0 = left_coil;
  assign expect_2_1 = actualdata_0 == 16'hfff8;
  assign expect_2_2 = actualdata_1 == 16'd30847;
  assign expect_2_3 = actualdata_2 == 16'h8780;
  assign expect_3_0 = left_coil;
  assign expect_3_1 = actualdata_0 == 16'hfff0;
  assign expect_3_2 = actualdata_1 == 16'hf0ff;
  assign expect_3_3 = actualdata_2 == 16'd3840;
  assign expect_4_0 = ~left_coil;
  assign expect_4_1 = actualdata_0 == 16'hffe0;
  assign expect_4_2 = actualdata_1 == 16'he1ff;
  assign expect_4_3 = actualdata_2 == 16'd7681;
  assign expect_5_0 = right_coil;
  assign expect_5_1 = two_0 == 16'h8787;
  assign expect_5_2 = two_1 == 16'd16384;
  assign expect_6_0 = right_coil;
  assign expect_6_1 = two_0 == 16'd17347;
  assign expect_6_2 = two_1 == 16'd8192;
  assign expect_7_0 = actualdata_0 == 16'hffff;
  assign expect_7_1 = two_1 == 16'hc000;
  assign expect_8_0 = ~left_coil;
  assign expect_8_1 = ~right_coil;
  assign expect_8_2 = actualdata_0 == 16'd0;
  assign expect_8_3 = actualdata_2 == 16'd0;
  assign expect_8_4 = two_1 == 16'd0;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module paper_shift_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg shift_ckt = 1'd0;
  reg shift_en_ckt = 1'd0;
  reg serialdata_ckt = 1'd0;
  wire left_coil;
  wire right_coil;
  wire [15:0] actualdata_0;
  wire [15:0] actualdata_1;
  wire [15:0] actualdata_2;
  wire [15:0] two_0;
  wire [15:0] two_1;
  reg failed;
  integer failures;

  paper_shift_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .shift_ckt(shift_ckt),
    .shift_en_ckt(shift_en_ckt),
    .serialdata_ckt(serialdata_ckt),
    .left_coil(left_coil),
    .right_coil(right_coil),
    .actualdata_0(actualdata_0),
    .actualdata_1(actualdata_1),
    .actualdata_2(actualdata_2),
    .two_0(two_0),
    .two_1(two_1)
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
  wire expect_8_3;
  wire expect_8_4;
  wire [0:4] expect_8 = {expect_8_0, expect_8_1, expect_8_2, expect_8_3, expect_8_4};
  paper_shift_expect expectations (
    .clk(clk),
    .rst(rst),
    .left_coil(left_coil),
    .actualdata_0(actualdata_0),
    .actualdata_1(actualdata_1),
    .actualdata_2(actualdata_2),
    .right_coil(right_coil),
    .two_0(two_0),
    .two_1(two_1),
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
    .expect_5_2(expect_5_2),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_6_2(expect_6_2),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_8_2(expect_8_2),
    .expect_8_3(expect_8_3),
    .expect_8_4(expect_8_4)
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
      shift_ckt = 1'd0;
      shift_en_ckt = 1'd0;
      serialdata_ckt = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..3");

    // to the left: the bit that leaves the high word is the coil
    failed = 1'b0;
    reset;
    shift_en_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // paper_shift.ladder:19
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b left_coil=%b actualdata_0=%b actualdata_1=%b actualdata_2=%b at %0s", expect_0, left_coil, actualdata_0, actualdata_1, actualdata_2, "paper_shift.ladder:19");
    end
    shift_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // paper_shift.ladder:22
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b left_coil=%b actualdata_0=%b actualdata_1=%b actualdata_2=%b at %0s", expect_1, left_coil, actualdata_0, actualdata_1, actualdata_2, "paper_shift.ladder:22");
    end
    shift_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // paper_shift.ladder:25
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b left_coil=%b actualdata_0=%b actualdata_1=%b actualdata_2=%b at %0s", expect_2, left_coil, actualdata_0, actualdata_1, actualdata_2, "paper_shift.ladder:25");
    end
    shift_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // paper_shift.ladder:28
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b left_coil=%b actualdata_0=%b actualdata_1=%b actualdata_2=%b at %0s", expect_3, left_coil, actualdata_0, actualdata_1, actualdata_2, "paper_shift.ladder:28");
    end
    shift_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // paper_shift.ladder:31
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b left_coil=%b actualdata_0=%b actualdata_1=%b actualdata_2=%b at %0s", expect_4, left_coil, actualdata_0, actualdata_1, actualdata_2, "paper_shift.ladder:31");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "to the left: the bit that leaves the high word is the coil");
    end else $display("ok 1 - %0s", "to the left: the bit that leaves the high word is the coil");

    // to the right: the bit that leaves the low word is the coil
    failed = 1'b0;
    reset;
    shift_en_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // paper_shift.ladder:37
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b right_coil=%b two_0=%b two_1=%b at %0s", expect_5, right_coil, two_0, two_1, "paper_shift.ladder:37");
    end
    shift_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // paper_shift.ladder:39
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b right_coil=%b two_0=%b two_1=%b at %0s", expect_6, right_coil, two_0, two_1, "paper_shift.ladder:39");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "to the right: the bit that leaves the low word is the coil");
    end else $display("ok 2 - %0s", "to the right: the bit that leaves the low word is the coil");

    // serial data enters at the vacated end, the enable circuit clears
    failed = 1'b0;
    reset;
    shift_en_ckt = 1'd1;
    serialdata_ckt = 1'd1;
    shift_ckt = 1'd1;
    scan(1, 1'b0);
    shift_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // paper_shift.ladder:43
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b actualdata_0=%b two_1=%b at %0s", expect_7, actualdata_0, two_1, "paper_shift.ladder:43");
    end
    shift_en_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // paper_shift.ladder:45
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b left_coil=%b right_coil=%b actualdata_0=%b actualdata_2=%b two_1=%b at %0s", expect_8, left_coil, right_coil, actualdata_0, actualdata_2, two_1, "paper_shift.ladder:45");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "serial data enters at the vacated end, the enable circuit clears");
    end else $display("ok 3 - %0s", "serial data enters at the vacated end, the enable circuit clears");

    if (failures != 0) $display("# %0d of 3 tests failed", failures);
    $finish;
  end
endmodule
