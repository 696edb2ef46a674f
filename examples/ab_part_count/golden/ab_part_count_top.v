// Made by hotrail 0.1.0 from ab_part_count.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects ab_part_count to the pins of a board.
module ab_part_count_top (
  input  wire clk,
  input  wire rst,
  input  wire pump_run,
  input  wire part_present,
  input  wire clear,
  output wire pump_on_for_a_while,
  output wire batch_done,
  output wire siemens_pump,
  output wire siemens_batch
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
  (* ASYNC_REG = "TRUE" *) reg pump_run_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg pump_run_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg part_present_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg part_present_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clear_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clear_sync = 1'b0;
  always @(posedge clk) begin
    pump_run_meta <= pump_run;
    pump_run_sync <= pump_run_meta;
    part_present_meta <= part_present;
    part_present_sync <= part_present_meta;
    clear_meta <= clear;
    clear_sync <= clear_meta;
  end

  ab_part_count core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .pump_run(pump_run_sync),
    .part_present(part_present_sync),
    .clear(clear_sync),
    .pump_on_for_a_while(pump_on_for_a_while),
    .batch_done(batch_done),
    .siemens_pump(siemens_pump),
    .siemens_batch(siemens_batch)
  );
endmodule

`default_nettype wire
