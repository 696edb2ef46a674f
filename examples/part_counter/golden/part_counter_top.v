// Made by hotrail 0.1.0 from part_counter.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects part_counter to the pins of a board.
module part_counter_top (
  input  wire        clk,
  input  wire        rst,
  input  wire        part_at_machine,
  input  wire        clear,
  output wire [15:0] parts,
  output wire        batch_full
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
  (* ASYNC_REG = "TRUE" *) reg part_at_machine_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg part_at_machine_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clear_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg clear_sync = 1'b0;
  always @(posedge clk) begin
    part_at_machine_meta <= part_at_machine;
    part_at_machine_sync <= part_at_machine_meta;
    clear_meta <= clear;
    clear_sync <= clear_meta;
  end

  part_counter core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .part_at_machine(part_at_machine_sync),
    .clear(clear_sync),
    .parts(parts),
    .batch_full(batch_full)
  );
endmodule

`default_nettype wire
