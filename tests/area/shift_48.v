// A shift register of 48 places; a part that enters at the front is seen when it leaves.
module shift_48 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire step,
  input  wire part,
  input  wire empty,
  output reg  leaves
);
  reg step_before;
  reg [47:0] line;

  initial {leaves, line, step_before} = 0;

  always @(posedge clk) begin
    step_before <= step;
    if (step & ~step_before) {leaves, line} <= {line, part};
    if (empty) {leaves, line} <= 0;
    if (rst) {leaves, line, step_before} <= 0;
  end
endmodule
