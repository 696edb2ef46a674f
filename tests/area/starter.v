// Two contactors that are never on together.
module starter (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire stop,
  input  wire overload,
  input  wire forward,
  input  wire reverse,
  output reg  run_forward,
  output reg  run_reverse,
  output reg  fault
);
  wire may_run = stop & ~overload;
  wire forward_next = (forward | run_forward) & may_run & ~reverse & ~run_reverse;

  initial {run_forward, run_reverse, fault} = 0;

  always @(posedge clk)
    if (rst) begin
      run_forward <= 0;
      run_reverse <= 0;
      fault <= 0;
    end else begin
      run_forward <= forward_next;
      run_reverse <= (reverse | run_reverse) & may_run & ~forward & ~forward_next;
      fault <= overload;
    end
endmodule
