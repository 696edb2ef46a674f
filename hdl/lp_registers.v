// The register array: presets, counts and words, and what they are at reset.
module lp_registers #(
    parameter SIZE = 2047,              // 8 to 2047, grown to the next power of two
    parameter CONTENTS = ""             // what the registers are at reset
) (
    input  wire        clk,
    input  wire        rst,
    input  wire        resetting,
    input  wire        idle,
    input  wire [10:0] count,
    // The functions.
    input  wire [10:0] read_register,
    output wire [15:0] read_word,
    input  wire        write_register,
    input  wire [10:0] written_register,
    input  wire [15:0] written_word,
    // The host, between scans.
    input  wire        at_reset,
    input  wire [10:0] RM_addr,
    input  wire        RM_rw,           // 1: write
    input  wire [15:0] RM_in,
    output wire [15:0] RM_out
);
  reg [10:0] copied;
  reg        copies;
  always @(posedge clk) begin
    copied <= count;
    copies <= resetting & ~rst;
  end

  // Where an address stands: a quarter of the memory each for addresses from 0 and from 512, half of
  // it for those from 1024 on. So an address means the same whatever the size; what lies beyond
  // falls together with what is there.
  localparam PLACE_BITS = $clog2(SIZE);
  function [PLACE_BITS-1:0] place_of(input [10:0] address);
    // The comparison of constants leaves nothing of the choice where every address has its place.
    place_of = {address[10], address[PLACE_BITS == 11 || address[10] ? PLACE_BITS-2 : 9],
                address[PLACE_BITS-3:0]};
  endfunction

  wire [15:0] initial_word;
  lp_memory #(.WIDTH(16), .ADDRESS_BITS(PLACE_BITS), .CONTENTS(CONTENTS)) initial_registers (
      .clk(clk),
      .write(idle & RM_rw & at_reset), .write_address(place_of(RM_addr)), .write_data(RM_in),
      .read(1'b1), .read_address(place_of(idle ? RM_addr : count)), .read_data(initial_word)
  );
  lp_memory #(.WIDTH(16), .ADDRESS_BITS(PLACE_BITS)) registers (
      .clk(clk),
      .write(copies | (idle ? RM_rw & ~at_reset : write_register)),
      .write_address(place_of(copies ? copied : idle ? RM_addr : written_register)),
      .write_data(copies ? initial_word : idle ? RM_in : written_word),
      .read(1'b1), .read_address(place_of(idle ? RM_addr : read_register)), .read_data(read_word)
  );
  assign RM_out = at_reset ? initial_word : read_word;
endmodule
