// Made by hotrail 0.1.0 from microwave.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects microwave to the pins of a board.
module microwave_top (
  input  wire clk,
  input  wire rst,
  input  wire start,
  input  wire cancel,
  input  wire door,
  input  wire foam,
  output wire magnetron,
  output wire turntable,
  output wire ready
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 1200000 clocks of 12 MHz, wanted every 100 ms, error 0 ppm.
  reg [20:0] prescaler = 21'd0;
  wire tick = prescaler == 21'd1199999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 21'd0;
    else prescaler <= tick ? 21'd0 : prescaler + 21'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg start_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg start_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg cancel_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg cancel_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg door_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg door_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg foam_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg foam_sync = 1'b0;
  always @(posedge clk) begin
    start_meta <= start;
    start_sync <= start_meta;
    cancel_meta <= cancel;
    cancel_sync <= cancel_meta;
    door_meta <= door;
    door_sync <= door_meta;
    foam_meta <= foam;
    foam_sync <= foam_meta;
  end

  microwave core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .start(start_sync),
    .cancel(cancel_sync),
    .door(door_sync),
    .foam(foam_sync),
    .magnetron(magnetron),
    .turntable(turntable),
    .ready(ready)
  );
endmodule

`default_nettype wire
