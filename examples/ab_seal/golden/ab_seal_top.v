// Made by hotrail 0.1.0 from ab_seal.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects ab_seal to the pins of a board.
module ab_seal_top (
  input  wire clk,
  input  wire rst,
  input  wire start_pb,
  input  wire stop_pb,
  output wire motor,
  output wire next_step,
  output wire siemens_motor,
  output wire siemens_next_step
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
  (* ASYNC_REG = "TRUE" *) reg start_pb_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg start_pb_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg stop_pb_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg stop_pb_sync = 1'b0;
  always @(posedge clk) begin
    start_pb_meta <= start_pb;
    start_pb_sync <= start_pb_meta;
    stop_pb_meta <= stop_pb;
    stop_pb_sync <= stop_pb_meta;
  end

  ab_seal core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .start_pb(start_pb_sync),
    .stop_pb(stop_pb_sync),
    .motor(motor),
    .next_step(next_step),
    .siemens_motor(siemens_motor),
    .siemens_next_step(siemens_next_step)
  );
endmodule

`default_nettype wire
