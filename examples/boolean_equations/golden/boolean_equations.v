// Made by hotrail 0.1.0 from boolean_equations.ladder. Do not edit: change the ladder and build again.

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
module boolean_equations_CTU_PV10 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  output wire Q
);
  reg [3:0] CV = 4'd0;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire equal = CV == 4'd10;
  wire [3:0] CV_next = CV + {3'b0, condition & ~equal};
  wire equal_2 = CV == 4'd9;

  assign Q = condition & equal_2 | equal;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 4'd0;
      was <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
    end
  end
endmodule

module boolean_equations (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire X1,
  input  wire X2,
  input  wire X3,
  input  wire X4,
  output wire Y1,
  output wire Y2
);
  reg Y1_reg = 1'b0;
  reg Y2_reg = 1'b0;

  // rung 1 "Y1 <- !X1 & X2 & (X3 & X4)", boolean_equations.ladder:8
  wire Y1_next = ~X1 & X2 & X3 & X4;

  // rung 2 "C2(K10) <- X2", boolean_equations.ladder:11
  wire C2_Q;
  boolean_equations_CTU_PV10 C2 (
    .clk(clk),
    .rst(rst),
    .power(X2),
    .Q(C2_Q)
  );

  // rung 3 "Y2 <- C2", boolean_equations.ladder:14
  wire Y2_next = C2_Q;

  assign Y1 = Y1_reg;
  assign Y2 = Y2_reg;

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
