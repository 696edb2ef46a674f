// Made by hotrail 0.1.0 from conveyor_run_out.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects conveyor_run_out to the pins of a board.
module conveyor_run_out_top (
  input  wire clk,
  input  wire rst,
  input  wire start,
  input  wire finish,
  input  wire emergency,
  input  wire product,
  input  wire wait_for_next,
  output wire conveyor,
  output wire empty
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
  (* ASYNC_REG = "TRUE" *) reg finish_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg finish_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg emergency_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg emergency_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg product_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg product_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg wait_for_next_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg wait_for_next_sync = 1'b0;
  always @(posedge clk) begin
    start_meta <= start;
    start_sync <= start_meta;
    finish_meta <= finish;
    finish_sync <= finish_meta;
    emergency_meta <= emergency;
    emergency_sync <= emergency_meta;
    product_meta <= product;
    product_sync <= product_meta;
    wait_for_next_meta <= wait_for_next;
    wait_for_next_sync <= wait_for_next_meta;
  end

  conveyor_run_out core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .start(start_sync),
    .finish(finish_sync),
    .emergency(emergency_sync),
    .product(product_sync),
    .wait_for_next(wait_for_next_sync),
    .conveyor(conveyor),
    .empty(empty)
  );
endmodule

`default_nettype wire
