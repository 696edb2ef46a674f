// Made by hotrail 0.1.0 from reversing_starter.ladder. Do not edit: change the ladder and build again.

`default_nettype none

module reversing_starter (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire stop,
  input  wire overload,
  input  wire forward,
  input  wire reverse,
  output wire run_forward,
  output wire run_reverse,
  output wire fault
);
  reg run_forward_reg = 1'b0;
  reg run_reverse_reg = 1'b0;
  reg fault_reg = 1'b0;

  // rung 1 "forward", reversing_starter.ladder:10
  wire run_forward_next =
      (forward | run_forward_reg) & stop & ~overload & ~reverse & ~run_reverse_reg;

  // rung 2 "reverse", reversing_starter.ladder:13
  wire run_reverse_next =
      (reverse | run_reverse_reg) & stop & ~overload & ~forward & ~run_forward_next;

  // rung 3 "overload lamp", reversing_starter.ladder:16
  wire fault_next = overload;

  assign run_forward = run_forward_reg;
  assign run_reverse = run_reverse_reg;
  assign fault = fault_reg;

  always @(posedge clk) begin
    if (rst) begin
      run_forward_reg <= 1'b0;
      run_reverse_reg <= 1'b0;
      fault_reg <= 1'b0;
    end else begin
      run_forward_reg <= run_forward_next;
      run_reverse_reg <= run_reverse_next;
      fault_reg <= fault_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule

`default_nettype wire
