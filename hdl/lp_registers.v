// The register array: presets, counts and words, and what they are at reset.
module lp_registers #(
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

  wire [15:0] initial_word;
  lp_memory #(.WIDTH(16), .ADDRESS_BITS(11), .CONTENTS(CONTENTS)) initial_registers (
      .clk(clk),
      .write(idle & RM_rw & at_reset), .write_address(RM_addr), .write_data(RM_in),
      .read(1'b1), .read_address(idle ? RM_addr : count), .read_data(initial_word)
  );
  lp_memory #(.WIDTH(16), .ADDRESS_BITS(11)) registers (
      .clk(clk),
      .write(copies | (idle ? RM_rw & ~at_reset : write_register)),
      .write_address(copies ? copied : idle ? RM_addr : written_register),
      .write_data(copies ? initial_word : idle ? RM_in : written_word),
      .read(1'b1), .read_address(idle ? RM_addr : read_register), .read_data(read_word)
  );
  assign RM_out = at_reset ? initial_word : read_word;
endmodule
