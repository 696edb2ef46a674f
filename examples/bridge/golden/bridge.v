// Made by hotrail 0.1.0 from bridge.ladder. Do not edit: change the ladder and build again.

`default_nettype none

module bridge (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire c1,
  input  wire c2,
  input  wire c3,
  input  wire c4,
  input  wire c5,
  input  wire c6,
  input  wire c7,
  input  wire c8,
  input  wire c9,
  output wire CR316
);
  reg CR316_reg = 1'b0;

  // rung 1 "the bridge", bridge.ladder:7
  wire rung1_power = c9 | c2 & c3 & c4;
  wire CR316_next = rung1_power & c1 | (c5 | rung1_power & c6) & (c7 & c8 | c6 & c1);

  assign CR316 = CR316_reg;

  always @(posedge clk) begin
    if (rst) begin
      CR316_reg <= 1'b0;
    end else begin
      CR316_reg <= CR316_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule

`default_nettype wire
