// Made by hotrail 0.1.0 from order_same_scan.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects order_same_scan to the pins of a board.
module order_same_scan_top (
  input  wire clk,
  input  wire rst,
  input  wire X0,
  output wire Y0,
  output wire Y1
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
  (* ASYNC_REG = "TRUE" *) reg X0_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X0_sync = 1'b0;
  always @(posedge clk) begin
    X0_meta <= X0;
    X0_sync <= X0_meta;
  end

  order_same_scan core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .X0(X0_sync),
    .Y0(Y0),
    .Y1(Y1)
  );
endmodule

`default_nettype wire
