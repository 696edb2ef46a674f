// Made by hotrail 0.1.0 from paper_bits.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects paper_bits to the pins of a board.
module paper_bits_top (
  input  wire        clk,
  input  wire        rst,
  input  wire        bc_ckt,
  input  wire        bs_ckt,
  output wire        bc_coil,
  output wire        bs_coil,
  output wire [15:0] bitset_r
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
  (* ASYNC_REG = "TRUE" *) reg bc_ckt_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg bc_ckt_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg bs_ckt_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg bs_ckt_sync = 1'b0;
  always @(posedge clk) begin
    bc_ckt_meta <= bc_ckt;
    bc_ckt_sync <= bc_ckt_meta;
    bs_ckt_meta <= bs_ckt;
    bs_ckt_sync <= bs_ckt_meta;
  end

  paper_bits core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .bc_ckt(bc_ckt_sync),
    .bs_ckt(bs_ckt_sync),
    .bc_coil(bc_coil),
    .bs_coil(bs_coil),
    .bitset_r(bitset_r)
  );
endmodule

`default_nettype wire
