// Made by hotrail 0.1.0 from modicon_timer.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects modicon_timer to the pins of a board.
module modicon_timer_top (
  input  wire clk,
  input  wire rst,
  input  wire in_10001,
  input  wire in_10002,
  output wire coil_00107,
  output wire coil_00108,
  output wire cascade_tenths,
  output wire cascade_seconds
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 120000 clocks of 12 MHz, wanted every 10 ms, error 0 ppm.
  reg [16:0] prescaler = 17'd0;
  wire tick = prescaler == 17'd119999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 17'd0;
    else prescaler <= tick ? 17'd0 : prescaler + 17'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg in_10001_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg in_10001_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg in_10002_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg in_10002_sync = 1'b0;
  always @(posedge clk) begin
    in_10001_meta <= in_10001;
    in_10001_sync <= in_10001_meta;
    in_10002_meta <= in_10002;
    in_10002_sync <= in_10002_meta;
  end

  modicon_timer core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .in_10001(in_10001_sync),
    .in_10002(in_10002_sync),
    .coil_00107(coil_00107),
    .coil_00108(coil_00108),
    .cascade_tenths(cascade_tenths),
    .cascade_seconds(cascade_seconds)
  );
endmodule

`default_nettype wire
