// Clamp, drill and lift, one after the other: one flip-flop for each step.
module step_sequence (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire clamped,
  input  wire deep,
  input  wire up,
  input  wire emergency,
  output reg  clamp,
  output reg  drill,
  output reg  lift
);
  reg start_before;

  // A step that ends starts the next one; a lift that ends makes room for a new part at once.
  wire lifting = lift & ~up;
  wire idle = ~clamp & ~drill & ~lifting;

  initial {clamp, drill, lift, start_before} = 0;

  always @(posedge clk) begin
    start_before <= start;
    clamp <= clamp & ~clamped | start & ~start_before & idle;
    drill <= drill & ~deep | clamp & clamped;
    lift <= lifting | drill & deep;
    if (emergency) {clamp, drill, lift} <= 3'b000;
    if (rst) {clamp, drill, lift, start_before} <= 4'b0000;
  end
endmodule
