// Made by hotrail 0.1.0 from flasher_rates.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects flasher_rates to the pins of a board.
module flasher_rates_top (
  input  wire clk,
  input  wire rst,
  input  wire enable,
  input  wire slow,
  output wire lamp
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
  (* ASYNC_REG = "TRUE" *) reg enable_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg enable_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg slow_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg slow_sync = 1'b0;
  always @(posedge clk) begin
    enable_meta <= enable;
    enable_sync <= enable_meta;
    slow_meta <= slow;
    slow_sync <= slow_meta;
  end

  flasher_rates core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .enable(enable_sync),
    .slow(slow_sync),
    .lamp(lamp)
  );
endmodule

`default_nettype wire
