// Made by hotrail 0.1.0 from reversing_starter.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects reversing_starter to the pins of a board.
module reversing_starter_top (
  input  wire clk,
  input  wire rst,
  input  wire stop,
  input  wire overload,
  input  wire forward,
  input  wire reverse,
  output wire run_forward,
  output wire run_reverse,
  output wire fault
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
  (* ASYNC_REG = "TRUE" *) reg stop_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg stop_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg overload_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg overload_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg forward_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg forward_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reverse_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reverse_sync = 1'b0;
  always @(posedge clk) begin
    stop_meta <= stop;
    stop_sync <= stop_meta;
    overload_meta <= overload;
    overload_sync <= overload_meta;
    forward_meta <= forward;
    forward_sync <= forward_meta;
    reverse_meta <= reverse;
    reverse_sync <= reverse_meta;
  end

  reversing_starter core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .stop(stop_sync),
    .overload(overload_sync),
    .forward(forward_sync),
    .reverse(reverse_sync),
    .run_forward(run_forward),
    .run_reverse(run_reverse),
    .fault(fault)
  );
endmodule

`default_nettype wire
