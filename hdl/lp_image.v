// The image: 1024 bits for inputs, outputs and flags, what they are at reset, and the pins.
module lp_image #(
    parameter INPUTS = 16,
    parameter OUTPUTS = 16,
    parameter FILE = ""                 // what the bits are at reset
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
  localparam [9:0] FIRST_OUTPUT = 10'd256, ONE = 10'd1023;

  // Bits are copied one clock after they were read.
  reg [9:0] copied;
  reg       copies;
  always @(posedge clk) begin
    copied <= count;
    copies <= resetting & ~rst;
  end
  wire initial_bit;
  lp_memory #(.WIDTH(1), .ADDRESS_BITS(10), .FILE(FILE)) initial_bits (
      .clk(clk),
      .write(idle & io_write & at_reset), .write_address(io_addr), .write_data(io_in),
      .read(1'b1), .read_address(idle ? io_addr : count), .read_data(initial_bit)
  );

  // The inputs go in one by one, the first first.
  localparam IN = INPUTS > 0 ? INPUTS : 1;
  reg [IN-1:0] sampled;
  always @(posedge clk)
    if (start_scan) sampled <= inputs;
    else if (reading_inputs) sampled <= sampled >> 1;

  reg       write;
  reg [9:0] write_address;
  reg       write_bit;
  always @* begin
    write         = write_coil;
    write_address = coil_address;
    write_bit     = coil;
    if (copies) begin
      write         = 1'b1;
      write_address = copied;
      write_bit     = initial_bit | copied == ONE;
    end else if (reading_inputs) begin
      write         = 1'b1;
      write_address = count;
      write_bit     = sampled[0];
    end else if (idle) begin
      write         = io_write & ~at_reset;
      write_address = io_addr;
      write_bit     = io_in;
    end
  end
  wire [9:0] read_address = running ? next_address
                          : idle ? io_addr
                          : FIRST_OUTPUT + count;
  wire stored;
  lp_memory #(.WIDTH(1), .ADDRESS_BITS(10)) bits (
      .clk(clk),
      .write(write), .write_address(write_address), .write_data(write_bit),
      .read(advance | ~running), .read_address(read_address), .read_data(stored)
  );

  // A contact right behind a coil on the same bit sees what the coil wrote.
  reg is_new, new_bit;
  always @(posedge clk) begin
    if (advance | ~running) is_new <= running & write & write_address == read_address;
    new_bit <= write_bit;
  end
  assign contact_status = is_new ? new_bit : stored;
  assign io_out = at_reset ? initial_bit : stored;

  // The outputs come out one by one and are shown all at once.
  localparam OUT = OUTPUTS > 0 ? OUTPUTS : 1;
  localparam [31:0] PINS = OUTPUTS, SHOWN = OUT;
  reg [OUT-1:0] collected;
  reg           collects;
  always @(posedge clk) begin
    collects <= writing_outputs & count[8:0] != PINS[8:0];
    if (collects) collected <= collected >> 1 | {OUT{stored}} << OUT - 1;
  end

  // At reset the outputs show what the bits of the image are then.
  wire reset_output = copies & copied[9:8] == 2'b01 & {1'b0, copied[7:0]} < SHOWN[8:0];
  always @(posedge clk)
    if (scan_done) outputs <= collected;
    else if (reset_output) outputs <= outputs >> 1 | {OUT{initial_bit}} << OUT - 1;
endmodule
