// Made by hotrail 0.1.0 from drum_sequence.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects drum_sequence to the pins of a board.
module drum_sequence_top (
  input  wire clk,
  input  wire rst,
  input  wire start,
  input  wire stop,
  output wire water,
  output wire heater,
  output wire motor,
  output wire pump,
  output wire running
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
  (* ASYNC_REG = "TRUE" *) reg stop_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg stop_sync = 1'b0;
  always @(posedge clk) begin
    start_meta <= start;
    start_sync <= start_meta;
    stop_meta <= stop;
    stop_sync <= stop_meta;
  end

  drum_sequence core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .start(start_sync),
    .stop(stop_sync),
    .water(water),
    .heater(heater),
    .motor(motor),
    .pump(pump),
    .running(running)
  );
endmodule

`default_nettype wire
