// Made by hotrail 0.1.0 from boolean_equations.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// CTU: up counter
// Fitted to PV = 10.
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module boolean_equations_test_CTU_PV10 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  output wire        Q,
  output wire [14:0] CV_last
);
  reg [14:0] CV = 15'd0;
  reg was = 1'b0;
  reg CV_at_least_10 = 1'b0;

  wire unequal = CV != 15'd32767;
  wire condition = power & ~was & unequal;
  wire [14:0] CV_next = CV + {14'b0, condition};
  wire equal = CV == 15'd9;
  wire CV_at_least_10_next = condition ? equal | CV_at_least_10 : CV_at_least_10;

  assign Q = CV_at_least_10_next;
  assign CV_last = CV;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 15'd0;
      was <= 1'b0;
      CV_at_least_10 <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
      CV_at_least_10 <= CV_at_least_10_next;
    end
  end
endmodule

module boolean_equations_test (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        X1,
  input  wire        X2,
  input  wire        X3,
  input  wire        X4,
  output wire        Y1,
  output wire        Y2,
  output wire [15:0] C2_CV
);
  reg Y1_reg = 1'b0;
  reg Y2_reg = 1'b0;

  // rung 1 "Y1 <- !X1 & X2 & (X3 & X4)", boolean_equations.ladder:8
  wire Y1_next = ~X1 & X2 & X3 & X4;

  // rung 2 "C2(K10) <- X2", boolean_equations.ladder:11
  wire C2_Q;
  wire [14:0] C2_CV_last;
  boolean_equations_test_CTU_PV10 C2 (
    .clk(clk),
    .rst(rst),
    .power(X2),
    .Q(C2_Q),
    .CV_last(C2_CV_last)
  );

  // rung 3 "Y2 <- C2", boolean_equations.ladder:14
  wire [15:0] C2_CV_value = {1'b0, C2_CV_last};
  wire Y2_next = C2_Q;

  assign Y1 = Y1_reg;
  assign Y2 = Y2_reg;
  assign C2_CV = C2_CV_value;

  always @(posedge clk) begin
    if (rst) begin
      Y1_reg <= 1'b0;
      Y2_reg <= 1'b0;
    end else begin
      Y1_reg <= Y1_next;
      Y2_reg <= Y2_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire

`default_nettype none

module boolean_equations_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        Y1,
  input  wire        Y2,
  input  wire [15:0] C2_CV,
  output wire        expect_0_0,
  output wire        expect_1_0,
  output wire        expect_2_0,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_5_0,
  output wire        expect_6_0,
  output wire        expect_6_1
);

  assign expect_0_0 = Y1;
  assign expect_1_0 = ~Y1;
  assign expect_2_0 = ~Y1;
  assign expect_3_0 = ~Y2;
  assign expect_3_1 = C2_CV == 16'd9;
  assign expect_4_0 = Y2;
  assign expect_4_1 = C2_CV == 16'd10;
  assign expect_5_0 = Y2;
  assign expect_6_0 = Y2;
  assign expect_6_1 = C2_CV == 16'd11;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module boolean_equations_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg X1 = 1'd0;
  reg X2 = 1'd0;
  reg X3 = 1'd0;
  reg X4 = 1'd0;
  wire Y1;
  wire Y2;
  wire [15:0] C2_CV;
  reg failed;
  integer failures;

  boolean_equations_test core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .X1(X1),
    .X2(X2),
    .X3(X3),
    .X4(X4),
    .Y1(Y1),
    .Y2(Y2),
    .C2_CV(C2_CV)
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
  wire expect_4_1;
  wire [0:1] expect_4 = {expect_4_0, expect_4_1};
  wire expect_5_0;
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  boolean_equations_expect expectations (
    .clk(clk),
    .rst(rst),
    .Y1(Y1),
    .Y2(Y2),
    .C2_CV(C2_CV),
    .expect_0_0(expect_0_0),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1)
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
      X1 = 1'd0;
      X2 = 1'd0;
      X3 = 1'd0;
      X4 = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..2");

    // Y1 needs all four
    failed = 1'b0;
    reset;
    X2 = 1'd1;
    X3 = 1'd1;
    X4 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // boolean_equations.ladder:19
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b Y1=%b at %0s", expect_0, Y1, "boolean_equations.ladder:19");
    end
    X1 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // boolean_equations.ladder:21
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b Y1=%b at %0s", expect_1, Y1, "boolean_equations.ladder:21");
    end
    X1 = 1'd0;
    X4 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // boolean_equations.ladder:23
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b Y1=%b at %0s", expect_2, Y1, "boolean_equations.ladder:23");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "Y1 needs all four");
    end else $display("ok 1 - %0s", "Y1 needs all four");

    // Y2 comes on with the tenth rise of X2 and stays
    failed = 1'b0;
    reset;
    repeat (9) begin
      X2 = 1'd1;
      scan(1, 1'b0);
      X2 = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_3 !== 1'b1) begin // boolean_equations.ladder:27
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b Y2=%b C2_CV=%b at %0s", expect_3, Y2, C2_CV, "boolean_equations.ladder:27");
    end
    X2 = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // boolean_equations.ladder:29
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b Y2=%b C2_CV=%b at %0s", expect_4, Y2, C2_CV, "boolean_equations.ladder:29");
    end
    X2 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // boolean_equations.ladder:31
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b Y2=%b at %0s", expect_5, Y2, "boolean_equations.ladder:31");
    end
    X2 = 1'd1;
    scan(1, 1'b0);
    X2 = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // boolean_equations.ladder:33
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b Y2=%b C2_CV=%b at %0s", expect_6, Y2, C2_CV, "boolean_equations.ladder:33");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "Y2 comes on with the tenth rise of X2 and stays");
    end else $display("ok 2 - %0s", "Y2 comes on with the tenth rise of X2 and stays");

    if (failures != 0) $display("# %0d of 2 tests failed", failures);
    $finish;
  end
endmodule
