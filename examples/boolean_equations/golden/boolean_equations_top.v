// Made by hotrail 0.1.0 from boolean_equations.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects boolean_equations to the pins of a board.
module boolean_equations_top (
  input  wire clk,
  input  wire rst,
  input  wire X1,
  input  wire X2,
  input  wire X3,
  input  wire X4,
  output wire Y1,
  output wire Y2
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 12000 clocks of 12 MHz, wanted every 1 ms, error 0 ppm.
  reg [13:0] prescaler = 14'd0;
  wire tick = prescaler == 14'd11999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 14'd0;
    else prescaler <= tick ? 14'd0 : prescaler + 14'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg X1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X1_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X2_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X2_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X3_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X3_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X4_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X4_sync = 1'b0;
  always @(posedge clk) begin
    X1_meta <= X1;
    X1_sync <= X1_meta;
    X2_meta <= X2;
    X2_sync <= X2_meta;
    X3_meta <= X3;
    X3_sync <= X3_meta;
    X4_meta <= X4;
    X4_sync <= X4_meta;
  end

  boolean_equations core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .X1(X1_sync),
    .X2(X2_sync),
    .X3(X3_sync),
    .X4(X4_sync),
    .Y1(Y1),
    .Y2(Y2)
  );
endmodule

`default_nettype wire
