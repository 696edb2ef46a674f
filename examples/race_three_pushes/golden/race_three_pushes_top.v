// Made by hotrail 0.1.0 from race_three_pushes.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects race_three_pushes to the pins of a board.
module race_three_pushes_top (
  input  wire clk,
  input  wire rst,
  input  wire button,
  input  wire clear,
  output wire won
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
  (* ASYNC_REG = "TRUE" *) reg button_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg button_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clear_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clear_sync = 1'b0;
  always @(posedge clk) begin
    button_meta <= button;
    button_sync <= button_meta;
    clear_meta <= clear;
    clear_sync <= clear_meta;
  end

  race_three_pushes core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .button(button_sync),
    .clear(clear_sync),
    .won(won)
  );
endmodule

`default_nettype wire
