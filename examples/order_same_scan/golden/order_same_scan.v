// Made by hotrail 0.1.0 from order_same_scan.ladder. Do not edit: change the ladder and build again.

`default_nettype none

module order_same_scan (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire X0,
  output wire Y0,
  output wire Y1
);
  reg Y0_reg = 1'b0;
  reg Y1_reg = 1'b0;

  // rung 1, order_same_scan.ladder:7
  wire Y0_next = X0;

  // rung 2, order_same_scan.ladder:8
  wire Y1_next = X0;

  assign Y0 = Y0_reg;
  assign Y1 = Y1_reg;

  always @(posedge clk) begin
    if (rst) begin
      Y0_reg <= 1'b0;
      Y1_reg <= 1'b0;
    end else begin
      Y0_reg <= Y0_next;
      Y1_reg <= Y1_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule

`default_nettype wire
