// Made by hotrail 0.1.0 from ab_timer_contacts.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects ab_timer_contacts to the pins of a board.
module ab_timer_contacts_top (
  input  wire clk,
  input  wire rst,
  input  wire run,
  input  wire slower,
  output wire enabled,
  output wire timing,
  output wire done,
  output wire not_enabled,
  output wire not_timing,
  output wire not_done,
  output wire siemens_done
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
  (* ASYNC_REG = "TRUE" *) reg run_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg run_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg slower_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg slower_sync = 1'b0;
  always @(posedge clk) begin
    run_meta <= run;
    run_sync <= run_meta;
    slower_meta <= slower;
    slower_sync <= slower_meta;
  end

  ab_timer_contacts core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .run(run_sync),
    .slower(slower_sync),
    .enabled(enabled),
    .timing(timing),
    .done(done),
    .not_enabled(not_enabled),
    .not_timing(not_timing),
    .not_done(not_done),
    .siemens_done(siemens_done)
  );
endmodule

`default_nettype wire
