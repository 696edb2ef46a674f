// Made by hotrail 0.1.0 from ab_boxes.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects ab_boxes to the pins of a board.
module ab_boxes_top (
  input  wire clk,
  input  wire rst,
  input  wire pull_cord,
  input  wire eye_1,
  input  wire eye_2,
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

  // Tick: every 120000 clocks of 12 MHz, wanted every 10 ms, error 0 ppm.
  reg [16:0] prescaler = 17'd0;
  wire tick = prescaler == 17'd119999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 17'd0;
    else prescaler <= tick ? 17'd0 : prescaler + 17'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg pull_cord_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg pull_cord_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg eye_1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg eye_1_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg eye_2_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg eye_2_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg emptied_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg emptied_sync = 1'b0;
  always @(posedge clk) begin
    pull_cord_meta <= pull_cord;
    pull_cord_sync <= pull_cord_meta;
    eye_1_meta <= eye_1;
    eye_1_sync <= eye_1_meta;
    eye_2_meta <= eye_2;
    eye_2_sync <= eye_2_meta;
    emptied_meta <= emptied;
    emptied_sync <= emptied_meta;
  end

  ab_boxes core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .pull_cord(pull_cord_sync),
    .eye_1(eye_1_sync),
    .eye_2(eye_2_sync),
    .emptied(emptied_sync),
    .conveyor_1(conveyor_1),
    .conveyor_2(conveyor_2),
    .conveyor_3(conveyor_3)
  );
endmodule

`default_nettype wire
