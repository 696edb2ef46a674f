// Made by hotrail 0.1.0 from parts_per_minute.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects parts_per_minute to the pins of a board.
module parts_per_minute_top (
  input  wire        clk,
  input  wire        rst,
  input  wire        sensor,
  input  wire        S,
  output wire [15:0] parts,
  output wire        done
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 12000000 clocks of 12 MHz, wanted every 1 s, error 0 ppm.
  reg [23:0] prescaler = 24'd0;
  wire tick = prescaler == 24'd11999999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 24'd0;
    else prescaler <= tick ? 24'd0 : prescaler + 24'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg sensor_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg sensor_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg S_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg S_sync = 1'b0;
  always @(posedge clk) begin
    sensor_meta <= sensor;
    sensor_sync <= sensor_meta;
    S_meta <= S;
    S_sync <= S_meta;
  end

  parts_per_minute core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .sensor(sensor_sync),
    .S(S_sync),
    .parts(parts),
    .done(done)
  );
endmodule

`default_nettype wire
