// A lamp that comes on with the 50th box, until the counter is reset.
module up_counter (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire box,
  input  wire clear,
  output reg  full
);
  reg box_before;
  reg [5:0] count;

  initial {full, box_before, count} = 0;

  always @(posedge clk)
    if (rst) begin
      box_before <= 0;
      count <= 0;
      full <= 0;
    end else begin
      box_before <= box;
      if (clear) begin
        count <= 0;
        full <= 0;
      end else if (box && !box_before && !full) begin
        count <= count + 1;
        full <= count == 49;
      end
    end
endmodule
