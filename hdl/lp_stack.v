// Four bits, last in, first out. Put and take at once exchange the top.
module lp_stack (
    input  wire clk,
    input  wire enable,
    input  wire clear,                  // holds nothing before this clock's put
    input  wire put,
    input  wire take,
    input  wire put_bit,
    output wire top
);
  reg [3:0] bits;
  reg [1:0] pointer;                    // where the next bit goes; four bits lead back to 0

  wire [1:0] below = pointer - 2'd1;
  wire [1:0] start = clear ? 2'd0 : pointer;
  wire [1:0] place = take ? below : start;

  assign top = bits[below];

  always @(posedge clk)
    if (enable) begin
      if (put) bits[place] <= put_bit;
      if (put & ~take) pointer <= start + 2'd1;
      else if (take & ~put) pointer <= below;
      else pointer <= start;
    end
endmodule
