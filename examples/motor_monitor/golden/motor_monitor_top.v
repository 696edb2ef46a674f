// Made by hotrail 0.1.0 from motor_monitor.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects motor_monitor to the pins of a board.
module motor_monitor_top (
  input  wire clk,
  input  wire rst,
  input  wire S1,
  input  wire turns_1,
  input  wire turns_2,
  input  wire turns_3,
  input  wire acknowledge,
  output wire fault
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
  (* ASYNC_REG = "TRUE" *) reg S1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg S1_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg turns_1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg turns_1_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg turns_2_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg turns_2_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg turns_3_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg turns_3_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg acknowledge_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg acknowledge_sync = 1'b0;
  always @(posedge clk) begin
    S1_meta <= S1;
    S1_sync <= S1_meta;
    turns_1_meta <= turns_1;
    turns_1_sync <= turns_1_meta;
    turns_2_meta <= turns_2;
    turns_2_sync <= turns_2_meta;
    turns_3_meta <= turns_3;
    turns_3_sync <= turns_3_meta;
    acknowledge_meta <= acknowledge;
    acknowledge_sync <= acknowledge_meta;
  end

  motor_monitor core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .S1(S1_sync),
    .turns_1(turns_1_sync),
    .turns_2(turns_2_sync),
    .turns_3(turns_3_sync),
    .acknowledge(acknowledge_sync),
    .fault(fault)
  );
endmodule

`default_nettype wire
