// Made by hotrail 0.1.0 from edges_and_latches.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects edges_and_latches to the pins of a board.
module edges_and_latches_top (
  input  wire clk,
  input  wire rst,
  input  wire a,
  input  wire b,
  input  wire clear,
  output wire on_rise,
  output wire on_fall,
  output wire shot_up,
  output wire shot_down,
  output wire coil_up,
  output wire coil_down,
  output wire latched,
  output wire inverted,
  output wire started
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
  (* ASYNC_REG = "TRUE" *) reg a_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg a_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg b_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg b_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clear_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clear_sync = 1'b0;
  always @(posedge clk) begin
    a_meta <= a;
    a_sync <= a_meta;
    b_meta <= b;
    b_sync <= b_meta;
    clear_meta <= clear;
    clear_sync <= clear_meta;
  end

  edges_and_latches core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .a(a_sync),
    .b(b_sync),
    .clear(clear_sync),
    .on_rise(on_rise),
    .on_fall(on_fall),
    .shot_up(shot_up),
    .shot_down(shot_down),
    .coil_up(coil_up),
    .coil_down(coil_down),
    .latched(latched),
    .inverted(inverted),
    .started(started)
  );
endmodule

`default_nettype wire
