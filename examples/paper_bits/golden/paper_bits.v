// Made by hotrail 0.1.0 from paper_bits.ladder. Do not edit: change the ladder and build again.

`default_nettype none

module paper_bits (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        bc_ckt,
  input  wire        bs_ckt,
  output wire        bc_coil,
  output wire        bs_coil,
  output wire [15:0] bitset_r
);
  reg [15:0] bitset_r_reg = 16'd4080;
  reg bc_coil_reg = 1'b0;
  reg bs_coil_reg = 1'b0;

  // rung 1 "BC: clears bit 7", paper_bits.ladder:8

  // rung 2 "BS: sets bit 7", paper_bits.ladder:11
  wire bs_coil_next = bs_ckt | bitset_r_reg[7] & ~bc_ckt;
  wire [15:0] bitset_r_next = {bitset_r_reg[15:8], bs_coil_next, bitset_r_reg[6:0]};

  // rung 3 "the bit is cleared", paper_bits.ladder:14
  wire bc_coil_next = ~bs_coil_next;

  // rung 4 "the bit is set", paper_bits.ladder:17

  assign bc_coil = bc_coil_reg;
  assign bs_coil = bs_coil_reg;
  assign bitset_r = bitset_r_reg;

  always @(posedge clk) begin
    if (rst) begin
      bitset_r_reg <= 16'd4080;
      bc_coil_reg <= 1'b0;
      bs_coil_reg <= 1'b0;
    end else begin
      bitset_r_reg <= bitset_r_next;
      bc_coil_reg <= bc_coil_next;
      bs_coil_reg <= bs_coil_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule

`default_nettype wire
