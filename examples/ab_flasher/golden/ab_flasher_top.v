// Made by hotrail 0.1.0 from ab_flasher.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects ab_flasher to the pins of a board.
module ab_flasher_top (
  input  wire clk,
  input  wire rst,
  input  wire enable,
  output wire ab_light,
  output wire siemens_light
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
  (* ASYNC_REG = "TRUE" *) reg enable_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg enable_sync = 1'b0;
  always @(posedge clk) begin
    enable_meta <= enable;
    enable_sync <= enable_meta;
  end

  ab_flasher core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .enable(enable_sync),
    .ab_light(ab_light),
    .siemens_light(siemens_light)
  );
endmodule

`default_nettype wire
