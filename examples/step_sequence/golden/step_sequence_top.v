// Made by hotrail 0.1.0 from step_sequence.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects step_sequence to the pins of a board.
module step_sequence_top (
  input  wire clk,
  input  wire rst,
  input  wire start,
  input  wire clamped,
  input  wire deep,
  input  wire free,
  input  wire emergency,
  output wire clamp,
  output wire drill,
  output wire lift,
  output wire busy
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
  (* ASYNC_REG = "TRUE" *) reg start_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg start_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clamped_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clamped_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg deep_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg deep_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg free_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg free_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg emergency_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg emergency_sync = 1'b0;
  always @(posedge clk) begin
    start_meta <= start;
    start_sync <= start_meta;
    clamped_meta <= clamped;
    clamped_sync <= clamped_meta;
    deep_meta <= deep;
    deep_sync <= deep_meta;
    free_meta <= free;
    free_sync <= free_meta;
    emergency_meta <= emergency;
    emergency_sync <= emergency_meta;
  end

  step_sequence core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .start(start_sync),
    .clamped(clamped_sync),
    .deep(deep_sync),
    .free(free_sync),
    .emergency(emergency_sync),
    .clamp(clamp),
    .drill(drill),
    .lift(lift),
    .busy(busy)
  );
endmodule

`default_nettype wire
