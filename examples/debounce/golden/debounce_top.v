// Made by hotrail 0.1.0 from debounce.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects debounce to the pins of a board.
module debounce_top (
  input  wire clk,
  input  wire rst,
  input  wire limit_switch_1,
  output wire settled,
  output wire at_once
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
  (* ASYNC_REG = "TRUE" *) reg limit_switch_1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg limit_switch_1_sync = 1'b0;
  always @(posedge clk) begin
    limit_switch_1_meta <= limit_switch_1;
    limit_switch_1_sync <= limit_switch_1_meta;
  end

  debounce core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .limit_switch_1(limit_switch_1_sync),
    .settled(settled),
    .at_once(at_once)
  );
endmodule

`default_nettype wire
