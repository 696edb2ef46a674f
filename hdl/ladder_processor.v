// The ladder processor: executes a ladder from its code memory, one contact in a clock.
//
// A scan samples the inputs, executes the words up to the one that ends it, and shows the outputs.
// While `halt` is on, no new scan begins, and between scans (`idle`) a host may load code and write
// and read the image and the registers. docs/processor.md describes every word.
module ladder_processor #(
    parameter INPUTS = 16,              // pins: bits 0.. of the image, up to a quarter of it
    parameter OUTPUTS = 16,             // pins: bits 256.. of the image, up to a quarter of it
    parameter CODE_WORDS = 1024,        // 2 to 1024; memories grow to the next power of two
    parameter IMAGE_BITS = 1024,        // 8 to 1024: a quarter inputs, a quarter outputs, half flags
    parameter REGISTERS = 2047,         // 8 to 2047: a quarter from 0, a quarter from 512, half from 1024
    parameter TIMERS = 1,               // 0: left out; all five: no registers either
    parameter COUNTERS = 1,
    parameter DRUMS = 1,
    parameter SHIFTS = 1,
    parameter BITS = 1,                 // bit set and bit clear
    parameter TICKS_PER_TENTH = 100,    // ticks in a tenth of a second; 0: no timers of tenths
    parameter TICKS_PER_SECOND = 1000,
    parameter STACK_DEPTH = 4,          // bits of each stack, 2 or more
    parameter CODE_FILE = "",           // NAME.hex
    parameter REGISTER_FILE = "",       // NAME_regs.hex
    parameter IMAGE_FILE = ""           // NAME_image.hex
) (
    input  wire clk,
    input  wire rst,
    input  wire tick,                   // one clock long; kept until a scan takes it
    input  wire [(INPUTS > 0 ? INPUTS : 1)-1:0] inputs,
    output wire [(OUTPUTS > 0 ? OUTPUTS : 1)-1:0] outputs,
    input  wire halt,
    output wire idle,
    output wire scan_done,              // the outputs are new with the next clock
    // The host.
    input  wire        code_write,
    input  wire [9:0]  waddr,
    input  wire [15:0] code_in,
    input  wire        at_reset,        // what bits and registers are at reset, instead of now
    input  wire [9:0]  io_addr,
    input  wire        io_write,
    input  wire        io_in,
    output wire        io_out,
    input  wire [10:0] RM_addr,
    input  wire        RM_rw,           // 1: write
    input  wire [15:0] RM_in,
    output wire [15:0] RM_out
);
  localparam FUNCTIONS = TIMERS != 0 || COUNTERS != 0 || DRUMS != 0 || SHIFTS != 0 || BITS != 0;
  localparam CODE_ADDRESS_BITS = $clog2(CODE_WORDS);
  localparam QUARTER = (1 << $clog2(IMAGE_BITS)) / 4;
  localparam [3:0] COIL = 4'd9, SET = 4'd10, RESET = 4'd11, INVERTED = 4'd12, END = 4'd15;

  // A size that cannot be built names a module that does not exist.
  generate
    if (CODE_WORDS < 2 || CODE_WORDS > 1024)
      CODE_WORDS_is_2_to_1024 illegal_code_words ();
    if (IMAGE_BITS < 8 || IMAGE_BITS > 1024)
      IMAGE_BITS_is_8_to_1024 illegal_image_bits ();
    if (REGISTERS < 8 || REGISTERS > 2047)
      REGISTERS_is_8_to_2047 illegal_registers ();
    if (STACK_DEPTH < 2)
      STACK_DEPTH_is_2_or_more illegal_stack_depth ();
    if (INPUTS < 0 || INPUTS > QUARTER)
      INPUTS_is_0_to_a_quarter_of_IMAGE_BITS illegal_inputs ();
    if (OUTPUTS < 0 || OUTPUTS > QUARTER)
      OUTPUTS_is_0_to_a_quarter_of_IMAGE_BITS illegal_outputs ();
  endgenerate

  wire resetting, start_scan, reading_inputs, running, valid, writing_outputs;
  wire hold, end_word;
  wire [10:0] count;
  lp_sequencer #(.INPUTS(INPUTS), .OUTPUTS(OUTPUTS)) sequencer (
      .clk(clk), .rst(rst), .halt(halt), .hold(hold), .end_word(end_word),
      .resetting(resetting), .idle(idle), .start_scan(start_scan),
      .reading_inputs(reading_inputs), .running(running), .valid(valid),
      .writing_outputs(writing_outputs), .scan_done(scan_done), .count(count)
  );

  // The word behind the one in work, and the one in work.
  wire [15:0] code_out;
  lp_memory #(.WIDTH(16), .ADDRESS_BITS(CODE_ADDRESS_BITS), .CONTENTS(CODE_FILE)) code_memory (
      .clk(clk),
      .write(idle & code_write), .write_address(waddr[CODE_ADDRESS_BITS-1:0]), .write_data(code_in),
      .read(~hold), .read_address(count[CODE_ADDRESS_BITS-1:0]), .read_data(code_out)
  );
  wire unused_address = &{1'b0, waddr};
  reg [15:0] word;
  always @(posedge clk) if (~hold) word <= code_out;
  wire [1:0] code  = word[15:14];
  wire [3:0] field = word[13:10];

  wire contact = valid & ~code[1];
  wire output_word = valid & code == 2'b10;
  wire prefix = valid & code == 2'b11;
  wire function_word = output_word & field < COIL;
  assign end_word = output_word & field == END;

  // Power.
  wire contact_status;
  wire pwra;
  wire latches = prefix & field[3:1] == 3'd0;
  lp_power #(.STACK_DEPTH(STACK_DEPTH)) power (
      .clk(clk), .start_scan(start_scan), .contact(contact),
      .ends_circuit(output_word | latches), .field(field),
      .conducts(contact_status ^ code[0]), .pwra(pwra)
  );

  // Coils.
  wire writes = field == COIL | field == INVERTED | ((field == SET | field == RESET) & pwra);
  wire value  = field == SET | (field == COIL & pwra) | (field == INVERTED & ~pwra);
  wire function_coil, function_writes;
  wire [9:0] function_address;
  lp_image #(
      .INPUTS(INPUTS), .OUTPUTS(OUTPUTS), .SIZE(IMAGE_BITS), .CONTENTS(IMAGE_FILE)
  ) image (
      .clk(clk), .inputs(inputs), .outputs(outputs),
      .rst(rst), .resetting(resetting), .idle(idle), .start_scan(start_scan),
      .reading_inputs(reading_inputs), .running(running), .writing_outputs(writing_outputs),
      .scan_done(scan_done), .count(count[9:0]),
      .advance(~hold), .next_address(code_out[9:0]), .contact_status(contact_status),
      .write_coil(function_word ? function_writes : output_word & writes),
      .coil_address(function_word ? function_address : word[9:0]),
      .coil(function_word ? function_coil : value),
      .at_reset(at_reset), .io_addr(io_addr), .io_write(io_write), .io_in(io_in), .io_out(io_out)
  );

  generate
    if (FUNCTIONS) begin : functions
      // A tick waits for the next scan.
      reg waiting;
      always @(posedge clk)
        if (rst | start_scan) waiting <= 1'b0;
        else if (tick) waiting <= 1'b1;

      wire done;
      wire [10:0] read_register, written_register;
      wire [15:0] read_word, written_word;
      wire write_register;
      lp_function #(
          .TIMERS(TIMERS), .COUNTERS(COUNTERS), .DRUMS(DRUMS), .SHIFTS(SHIFTS), .BITS(BITS),
          .TICKS_PER_TENTH(TICKS_PER_TENTH), .TICKS_PER_SECOND(TICKS_PER_SECOND)
      ) function_unit (
          .clk(clk), .rst(rst), .start_scan(start_scan), .tick(tick | waiting),
          .clear_units(resetting), .clear_address(count[6:0]),
          .prefix(prefix), .run(function_word), .field(field), .low(word[9:0]), .power(pwra),
          .done(done),
          .read_register(read_register), .read_word(read_word),
          .write_register(write_register), .written_register(written_register),
          .written_word(written_word),
          .write_coil(function_writes), .coil_address(function_address), .coil(function_coil)
      );
      lp_registers #(.SIZE(REGISTERS), .CONTENTS(REGISTER_FILE)) register_array (
          .clk(clk), .rst(rst), .resetting(resetting), .idle(idle), .count(count),
          .read_register(read_register), .read_word(read_word),
          .write_register(write_register), .written_register(written_register),
          .written_word(written_word),
          .at_reset(at_reset), .RM_addr(RM_addr), .RM_rw(RM_rw), .RM_in(RM_in), .RM_out(RM_out)
      );
      assign hold = function_word & ~done;
    end else begin : no_functions
      assign hold = 1'b0;
      assign function_writes = 1'b0;
      assign function_coil = 1'b0;
      assign function_address = 10'd0;
      assign RM_out = 16'd0;
      wire unused = &{1'b0, tick, count[10], RM_addr, RM_rw, RM_in};
    end
  endgenerate
endmodule
