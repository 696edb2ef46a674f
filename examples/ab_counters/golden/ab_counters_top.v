// Made by hotrail 0.1.0 from ab_counters.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects ab_counters to the pins of a board.
module ab_counters_top (
  input  wire clk,
  input  wire rst,
  input  wire count_up,
  input  wire count_down,
  input  wire reset_up,
  input  wire reset_down,
  input  wire to_the_end,
  output wire up_done,
  output wire down_done,
  output wire siemens_up_done,
  output wire siemens_down_done,
  output wire overflow
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
  (* ASYNC_REG = "TRUE" *) reg count_up_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg count_up_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg count_down_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg count_down_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reset_up_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reset_up_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reset_down_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reset_down_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg to_the_end_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg to_the_end_sync = 1'b0;
  always @(posedge clk) begin
    count_up_meta <= count_up;
    count_up_sync <= count_up_meta;
    count_down_meta <= count_down;
    count_down_sync <= count_down_meta;
    reset_up_meta <= reset_up;
    reset_up_sync <= reset_up_meta;
    reset_down_meta <= reset_down;
    reset_down_sync <= reset_down_meta;
    to_the_end_meta <= to_the_end;
    to_the_end_sync <= to_the_end_meta;
  end

  ab_counters core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .count_up(count_up_sync),
    .count_down(count_down_sync),
    .reset_up(reset_up_sync),
    .reset_down(reset_down_sync),
    .to_the_end(to_the_end_sync),
    .up_done(up_done),
    .down_done(down_done),
    .siemens_up_done(siemens_up_done),
    .siemens_down_done(siemens_down_done),
    .overflow(overflow)
  );
endmodule

`default_nettype wire
