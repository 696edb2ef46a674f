// Made by hotrail 0.1.0 from paper_shift.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects paper_shift to the pins of a board.
module paper_shift_top (
  input  wire clk,
  input  wire rst,
  input  wire shift_ckt,
  input  wire shift_en_ckt,
  input  wire serialdata_ckt,
  output wire left_coil,
  output wire right_coil
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
  (* ASYNC_REG = "TRUE" *) reg shift_ckt_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg shift_ckt_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg shift_en_ckt_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg shift_en_ckt_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg serialdata_ckt_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg serialdata_ckt_sync = 1'b0;
  always @(posedge clk) begin
    shift_ckt_meta <= shift_ckt;
    shift_ckt_sync <= shift_ckt_meta;
    shift_en_ckt_meta <= shift_en_ckt;
    shift_en_ckt_sync <= shift_en_ckt_meta;
    serialdata_ckt_meta <= serialdata_ckt;
    serialdata_ckt_sync <= serialdata_ckt_meta;
  end

  paper_shift core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .shift_ckt(shift_ckt_sync),
    .shift_en_ckt(shift_en_ckt_sync),
    .serialdata_ckt(serialdata_ckt_sync),
    .left_coil(left_coil),
    .right_coil(right_coil)
  );
endmodule

`default_nettype wire
