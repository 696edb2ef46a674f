// The image: bits for inputs, outputs and flags, what they are at reset, and the pins.
module lp_image #(
    parameter INPUTS = 16,
    parameter OUTPUTS = 16,
    parameter SIZE = 1024,              // 8 to 1024, grown to the next power of two
    parameter CONTENTS = ""             // what the bits are at reset
) (
    input  wire                                clk,
    input  wire [(INPUTS > 0 ? INPUTS : 1)-1:0] inputs,
    output reg  [(OUTPUTS > 0 ? OUTPUTS : 1)-1:0] outputs,
    // What the sequencer does.
    input  wire        rst,
    input  wire        resetting,
    input  wire        idle,
    input  wire        start_scan,
    input  wire        reading_inputs,
    input  wire        running,
    input  wire        writing_outputs,
    input  wire        scan_done,
    input  wire [9:0]  count,
    // Contacts and coils.
    input  wire        advance,         // the word behind the one in work goes into work
    input  wire [9:0]  next_address,
    output wire        contact_status,  // the bit of the word in work
    input  wire        write_coil,
    input  wire [9:0]  coil_address,
    input  wire        coil,
    // The host, between scans.
    input  wire        at_reset,
    input  wire [9:0]  io_addr,
    input  wire        io_write,
    input  wire        io_in,
    output wire        io_out
);
  localparam IN = INPUTS > 0 ? INPUTS : 1, OUT = OUTPUTS > 0 ? OUTPUTS : 1;
  // Where an address stands: a quarter of the memory each for addresses from 0 and from 256, half of
  // it for those from 512 on. So an address means the same whatever the size; what lies beyond
  // falls together with what is there.
  localparam PLACE_BITS = $clog2(SIZE);
  function [PLACE_BITS-1:0] place_of(input [9:0] address);
    // The comparison of constants leaves nothing of the choice where every address has its place.
    place_of = {address[9], address[PLACE_BITS == 10 || address[9] ? PLACE_BITS-2 : 8],
                address[PLACE_BITS-3:0]};
  endfunction
  localparam [31:0] PINS = OUTPUTS;

  // Bits at reset, inputs and those of the host are written one clock after their turn: a bit at
  // reset has to be read first.
  wire [9:0] place = idle ? io_addr : count;
  reg  [9:0] put_place;
  reg        resets, samples, hosts, host_bit;
  always @(posedge clk) begin
    put_place <= place;
    resets    <= resetting & ~rst;
    samples   <= reading_inputs;
    hosts     <= idle & io_write & ~at_reset;
    host_bit  <= io_in;
  end

  wire initial_bit;
  lp_memory #(.WIDTH(1), .ADDRESS_BITS(PLACE_BITS), .CONTENTS(CONTENTS)) initial_bits (
      .clk(clk),
      .write(idle & io_write & at_reset), .write_address(place_of(io_addr)), .write_data(io_in),
      .read(1'b1), .read_address(place_of(place)), .read_data(initial_bit)
  );

  // The inputs go in one by one, the first first.
  reg [IN-1:0] sampled;
  always @(posedge clk)
    if (start_scan) sampled <= inputs;
    else if (samples) sampled <= sampled >> 1;

  // The last bit at reset is the constant 1.
  wire is_one = resets & ~resetting;
  wire put = resets | samples | hosts;
  wire put_bit = resets ? initial_bit | is_one : samples ? sampled[0] : host_bit;

  wire write     = put | write_coil;
  wire write_bit = put ? put_bit : coil;
  wire [PLACE_BITS-1:0] write_address = place_of(put ? put_place : coil_address);
  wire [PLACE_BITS-1:0] read_address
    = place_of(running ? next_address : {writing_outputs ? 2'b01 : place[9:8], place[7:0]});
  wire stored;
  lp_memory #(.WIDTH(1), .ADDRESS_BITS(PLACE_BITS)) bits (
      .clk(clk),
      .write(write), .write_address(write_address), .write_data(write_bit),
      .read(advance), .read_address(read_address), .read_data(stored)
  );

  // A contact right behind a coil on the same bit sees what the coil wrote, and a host what it wrote.
  reg is_new, new_bit;
  always @(posedge clk) if (advance) begin
    is_new  <= write & write_address == read_address;
    new_bit <= write_bit;
  end
  assign contact_status = is_new ? new_bit : stored;
  assign io_out = at_reset ? initial_bit : contact_status;

  // The outputs come out one by one and are shown all at once.
  reg [OUT-1:0] collected;
  reg           collects;
  always @(posedge clk) begin
    collects <= writing_outputs & count[8:0] != PINS[8:0];
    if (collects) collected <= collected >> 1 | {OUT{contact_status}} << OUT - 1;
    if (rst) outputs <= {OUT{1'b0}};
    else if (scan_done) outputs <= collected;
  end
endmodule
