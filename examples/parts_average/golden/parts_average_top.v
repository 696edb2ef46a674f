// Made by hotrail 0.1.0 from parts_average.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects parts_average to the pins of a board.
module parts_average_top (
  input  wire        clk,
  input  wire        rst,
  input  wire        sensor,
  output wire [15:0] last_minute,
  output wire [15:0] average_10,
  output wire [15:0] average_60
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 1000000 clocks of 1 MHz, wanted every 1 s, error 0 ppm.
  reg [19:0] prescaler = 20'd0;
  wire tick = prescaler == 20'd999999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 20'd0;
    else prescaler <= tick ? 20'd0 : prescaler + 20'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg sensor_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg sensor_sync = 1'b0;
  always @(posedge clk) begin
    sensor_meta <= sensor;
    sensor_sync <= sensor_meta;
  end

  parts_average core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .sensor(sensor_sync),
    .last_minute(last_minute),
    .average_10(average_10),
    .average_60(average_60)
  );
endmodule

`default_nettype wire
