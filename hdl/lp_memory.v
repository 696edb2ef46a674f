// A memory with one port to write and one to read, which infers as block RAM. A read shows one clock
// later what stood there; nobody needs what it shows of an address that is written in the same clock,
// so synthesis need not make it the old word.
module lp_memory #(
    parameter WIDTH = 16,
    parameter ADDRESS_BITS = 10,
    parameter CONTENTS = ""             // contents at power-up for $readmemh; none if empty
) (
    input  wire                    clk,
    input  wire                    write,
    input  wire [ADDRESS_BITS-1:0] write_address,
    input  wire [WIDTH-1:0]        write_data,
    input  wire                    read,            // without it the last word read stays
    input  wire [ADDRESS_BITS-1:0] read_address,
    output reg  [WIDTH-1:0]        read_data
);
  (* no_rw_check *)
  reg [WIDTH-1:0] words [0:(1 << ADDRESS_BITS) - 1];

  integer i;
  initial begin
    for (i = 0; i < (1 << ADDRESS_BITS); i = i + 1) words[i] = {WIDTH{1'b0}};
    if (CONTENTS != "") $readmemh(CONTENTS, words);
  end

  always @(posedge clk) begin
    if (write) words[write_address] <= write_data;
    if (read) read_data <= words[read_address];
  end
endmodule
