// A shift register of 48 places: whether there is a part at the front is seen when the place
// leaves.
module shift_48 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire step,
  input  wire gap,
  input  wire empty,
  output reg  leaves
);
  reg step_before;
  reg [47:0] line;

  initial {leaves, line, step_before} = 0;

  always @(posedge clk) begin
    step_before <= step;
    if (step & ~step_before) {leaves, line} <= {line, ~gap};
    if (empty) {leaves, line} <= 0;
    if (rst) {leaves, line, step_before} <= 0;
  end
endmodule
