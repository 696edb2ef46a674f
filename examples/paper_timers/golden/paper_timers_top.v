// Made by hotrail 0.1.0 from paper_timers.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects paper_timers to the pins of a board.
module paper_timers_top (
  input  wire clk,
  input  wire rst,
  input  wire c1,
  input  wire c2,
  input  wire c3,
  input  wire c4,
  input  wire c5,
  input  wire c6,
  input  wire c7,
  input  wire c8,
  input  wire c9,
  input  wire enable_ckt,
  output wire timer_off_coil,
  output wire timer_on_coil,
  output wire timer_interval_coil
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
  (* ASYNC_REG = "TRUE" *) reg c1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c1_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c2_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c2_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c3_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c3_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c4_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c4_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c5_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c5_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c6_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c6_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c7_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c7_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c8_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c8_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c9_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg c9_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg enable_ckt_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg enable_ckt_sync = 1'b0;
  always @(posedge clk) begin
    c1_meta <= c1;
    c1_sync <= c1_meta;
    c2_meta <= c2;
    c2_sync <= c2_meta;
    c3_meta <= c3;
    c3_sync <= c3_meta;
    c4_meta <= c4;
    c4_sync <= c4_meta;
    c5_meta <= c5;
    c5_sync <= c5_meta;
    c6_meta <= c6;
    c6_sync <= c6_meta;
    c7_meta <= c7;
    c7_sync <= c7_meta;
    c8_meta <= c8;
    c8_sync <= c8_meta;
    c9_meta <= c9;
    c9_sync <= c9_meta;
    enable_ckt_meta <= enable_ckt;
    enable_ckt_sync <= enable_ckt_meta;
  end

  paper_timers core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .c1(c1_sync),
    .c2(c2_sync),
    .c3(c3_sync),
    .c4(c4_sync),
    .c5(c5_sync),
    .c6(c6_sync),
    .c7(c7_sync),
    .c8(c8_sync),
    .c9(c9_sync),
    .enable_ckt(enable_ckt_sync),
    .timer_off_coil(timer_off_coil),
    .timer_on_coil(timer_on_coil),
    .timer_interval_coil(timer_interval_coil)
  );
endmodule

`default_nettype wire
