// Made by hotrail 0.1.0 from box_grouping.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects box_grouping to the pins of a board.
module box_grouping_top (
  input  wire clk,
  input  wire rst,
  input  wire pull_cord,
  input  wire eye_in,
  input  wire eye_out,
  input  wire emptied,
  output wire conveyor_1,
  output wire conveyor_2,
  output wire conveyor_3
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
  (* ASYNC_REG = "TRUE" *) reg pull_cord_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg pull_cord_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg eye_in_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg eye_in_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg eye_out_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg eye_out_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg emptied_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg emptied_sync = 1'b0;
  always @(posedge clk) begin
    pull_cord_meta <= pull_cord;
    pull_cord_sync <= pull_cord_meta;
    eye_in_meta <= eye_in;
    eye_in_sync <= eye_in_meta;
    eye_out_meta <= eye_out;
    eye_out_sync <= eye_out_meta;
    emptied_meta <= emptied;
    emptied_sync <= emptied_meta;
  end

  box_grouping core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .pull_cord(pull_cord_sync),
    .eye_in(eye_in_sync),
    .eye_out(eye_out_sync),
    .emptied(emptied_sync),
    .conveyor_1(conveyor_1),
    .conveyor_2(conveyor_2),
    .conveyor_3(conveyor_3)
  );
endmodule

`default_nettype wire
