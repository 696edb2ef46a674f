// Made by hotrail 0.1.0 from traffic_lights.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects traffic_lights to the pins of a board.
module traffic_lights_top (
  input  wire clk,
  input  wire rst,
  output wire ns_green,
  output wire ns_yellow,
  output wire ns_red,
  output wire turn_green,
  output wire turn_yellow,
  output wire turn_red,
  output wire ew_green,
  output wire ew_yellow,
  output wire ew_red
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 400000 clocks of 4 MHz, wanted every 100 ms, error 0 ppm.
  reg [18:0] prescaler = 19'd0;
  wire tick = prescaler == 19'd399999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 19'd0;
    else prescaler <= tick ? 19'd0 : prescaler + 19'd1;
  end

  traffic_lights core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .ns_green(ns_green),
    .ns_yellow(ns_yellow),
    .ns_red(ns_red),
    .turn_green(turn_green),
    .turn_yellow(turn_yellow),
    .turn_red(turn_red),
    .ew_green(ew_green),
    .ew_yellow(ew_yellow),
    .ew_red(ew_red)
  );
endmodule

`default_nettype wire
