// Bits, last in, first out. Put and take at once exchange the top. What a circuit leaves behind may
// stay: the next one never takes more than it has put.
module lp_stack #(
    parameter DEPTH = 4
) (
    input  wire clk,
    input  wire put,
    input  wire take,
    input  wire put_bit,
    output wire top
);
  reg [DEPTH-1:0] bits;                 // the top is bit 0

  assign top = bits[0];

  always @(posedge clk)
    if (put & take) bits[0] <= put_bit;
    else if (put) bits <= {bits[DEPTH-2:0], put_bit};
    else if (take) bits <= {1'b0, bits[DEPTH-1:1]};
endmodule
