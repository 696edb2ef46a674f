// Timers, counters, drums, shifts and bits of registers: takes what prefixes give, and runs an
// operation in several clocks while the words behind it wait. The operation of a kind that is left
// out takes three clocks and does nothing.
module lp_function #(
    parameter TIMERS = 1,
    parameter COUNTERS = 1,
    parameter DRUMS = 1,
    parameter SHIFTS = 1,
    parameter BITS = 1,
    parameter TICKS_PER_TENTH = 100,
    parameter TICKS_PER_SECOND = 1000
) (
    input  wire        clk,
    input  wire        rst,
    input  wire        start_scan,
    input  wire        tick,
    input  wire        clear_units,     // while memories are being reset
    input  wire [6:0]  clear_address,
    // The word in work.
    input  wire        prefix,
    input  wire        run,             // a function, for all the clocks that it takes
    input  wire [3:0]  field,           // kind of prefix, or operation
    input  wire [9:0]  low,
    input  wire        power,
    output wire        done,            // in the last of these clocks
    // The register array: a read shows its word one clock later.
    output wire [10:0] read_register,
    input  wire [15:0] read_word,
    output wire        write_register,
    output wire [10:0] written_register,
    output wire [15:0] written_word,
    // The image.
    output wire        write_coil,
    output wire [9:0]  coil_address,
    output wire        coil
);
  localparam [3:0] TS = 4'd0, TT = 4'd1, UC = 4'd2, DC = 4'd3, BIT_SET = 4'd4, BIT_CLEAR = 4'd5,
                   DRUM = 4'd6, SHIFT_RIGHT = 4'd7, SHIFT_LEFT = 4'd8;
  localparam [3:0] ENABLE = 4'd0, SERIAL = 4'd1, UNIT = 4'd2, NUMBER = 4'd3;

  // Known from clock 1 of an operation on.
  reg is_timer, is_counter, is_drum, is_left, is_right, is_bit, down;
  always @(posedge clk) begin
    is_timer   <= TIMERS != 0 & (field == TS | field == TT);
    is_counter <= COUNTERS != 0 & (field == UC | field == DC);
    is_drum    <= DRUMS != 0 & field == DRUM;
    is_left    <= SHIFTS != 0 & field == SHIFT_LEFT;
    is_right   <= SHIFTS != 0 & field == SHIFT_RIGHT;
    is_bit     <= BITS != 0 & (field == BIT_SET | field == BIT_CLEAR);
    down       <= COUNTERS != 0 & field == DC;
  end
  wire is_shift = is_left | is_right;
  wire is_count = is_timer | is_counter | is_drum;

  // The clock of the operation. A count takes 0 to 7, and one more 8 for each tap; a shift takes
  // 0, and 1 and 2 for each register; a bit takes 0 to 2.
  reg        begun;
  reg  [8:1] later;
  wire [8:0] at = {later, run & ~begun};
  reg  [5:0] number;                    // as given; taps or registers that are left
  reg        no_taps, last_one;
  always @(posedge clk) begin
    no_taps  <= ~is_drum | number == 6'd0;
    last_one <= ~is_shift & ~is_drum | number == 6'd1;
  end
  assign done = is_count ? (at[7] & no_taps) | (at[8] & last_one) : at[2] & last_one;
  always @(posedge clk)
    if (~run | done) {later, begun} <= 9'd0;
    else begin
      begun      <= 1'b1;
      later[1]   <= at[0] | (at[2] & ~is_count);
      later[2]   <= at[1];
      later[7:3] <= is_count ? at[6:2] : 5'd0;
      later[8]   <= at[7] | at[8];
    end

  // What prefixes give.
  reg        enable, serial;
  reg [5:0]  unit_number;
  reg [1:0]  timer_type;
  reg [10:0] next_register;             // the one that is read
  always @(posedge clk)
    if (start_scan | done) begin
      enable <= 1'b1;
      serial <= 1'b0;
    end else if (prefix) begin
      if (field == ENABLE) enable <= power;
      if (field == SERIAL) serial <= power;
    end
  always @(posedge clk) begin
    if (prefix & field == UNIT) {timer_type, unit_number} <= {low[9:8], low[5:0]};
    if (prefix & field == NUMBER) number <= low[5:0];
    else if (at[7] | at[8] | (is_shift & at[1])) number <= number - 6'd1;
    if (prefix & field[2]) next_register <= {field[0], low};
    else if (at[1] | |at[8:5])
      next_register <= next_register + {{10{is_right}}, 1'b1};
  end

  // What each unit keeps: timers and counters from 0, drums from 64, shifts from 96.
  wire [6:0] unit_address = {is_drum | is_shift, is_shift | unit_number[5], unit_number[4:0]};
  wire was, was_enabled, runs;
  reg  runs_on;
  lp_memory #(.WIDTH(3), .ADDRESS_BITS(7)) kept (
      .clk(clk),
      .write(clear_units | (done & (is_count | is_shift))),
      .write_address(clear_units ? clear_address : unit_address),
      .write_data(clear_units ? 3'd0 : {runs_on, power & enable, power}),
      .read(at[1]), .read_address(unit_address), .read_data({runs, was_enabled, was})
  );
  wire rises = power & ~was;

  wire tenth, second;
  generate
    if (TIMERS != 0) begin : timing
      lp_pulses #(.TICKS_PER_TENTH(TICKS_PER_TENTH), .TICKS_PER_SECOND(TICKS_PER_SECOND)) pulses (
          .clk(clk), .rst(rst), .start_scan(start_scan), .tick(tick),
          .tenth(tenth), .second(second)
      );
    end else begin : no_timing
      assign tenth = 1'b0;
      assign second = 1'b0;
      wire unused_time = &{1'b0, rst, tick};
    end
  endgenerate

  // Counts. Clock 0 reads the preset, 1 the count; 2 limits the preset; 3 decides; 4 counts;
  // 5 compares; 6 writes the coil; 7 writes the count. Taps follow, each compared the clock before.
  wire reached, at_end;
  wire timer_clears, timer_counts, timer_coil, timer_runs_on, timer_ends;
  lp_timer timer (
      .timer_type(timer_type), .enable(enable), .power(power),
      .pulse(field[0] ? tenth : second),
      .was(was), .was_enabled(was_enabled), .runs(runs),
      .reached(reached), .clears(timer_clears), .counts(timer_counts),
      .coil(timer_coil), .runs_on(timer_runs_on), .ends(timer_ends)
  );
  wire counter_clears, counter_loads, counter_counts;
  lp_counter counter (
      .down(down), .enable(enable), .rises(rises), .at_end(at_end),
      .clears(counter_clears), .loads(counter_loads), .counts(counter_counts)
  );

  // What was decided the clock before.
  reg clears, loads, counts, reaches, ends;
  always @(posedge clk) begin
    clears  <= is_timer ? timer_clears : counter_clears;
    loads   <= counter_loads;
    counts  <= is_timer ? timer_counts : counter_counts;
    reaches <= is_timer ? timer_coil : down ? at_end : reached;
    runs_on <= is_timer & timer_runs_on;
    ends    <= is_timer & timer_ends;
  end

  wire carry, has_bit;
  wire moves = ~enable | rises;         // the registers of a shift change
  lp_operand operand (
      .clk(clk), .read_word(read_word),
      .load_largest(is_count & at[1]), .load_word(is_count & at[2]),
      .load_left(is_left & at[1]), .load_right(is_right & at[1]), .load_bit(is_bit & at[1]),
      .load_preset(at[4] & loads), .load_next(at[4] & counts & ~loads),
      .clear((at[4] & clears) | (at[6] & ends) | (is_shift & at[1] & ~enable)),
      .drum(is_drum), .down(down), .power(power), .set_bit(~field[0]),
      .bit_number(number[3:0]), .serial(serial), .load_serial(at[0]),
      .read_preset(at[1] | (is_drum & |at[8:6])), .limit_preset(is_count & at[2]),
      .word(written_word), .reached(reached), .at_end(at_end), .carry(carry), .has_bit(has_bit)
  );

  // The register array: a shift writes what it read two clocks before.
  wire [10:0] count_register = {4'b0100, is_drum, unit_number};
  reg  [10:0] shifted_register;
  always @(posedge clk) if (~at[1]) shifted_register <= next_register;
  assign read_register    = is_count & at[1] ? count_register : next_register;
  assign write_register   = is_count ? at[7] : at[2] & (is_bit | (is_shift & moves));
  assign written_register = is_count ? count_register : shifted_register;

  // The coils: that of the operation, then those of the taps.
  reg [4:0] tap;
  always @(posedge clk)
    if (~run | done) tap <= 5'd0;
    else if (at[7] | at[8]) tap <= tap + 5'd1;
  assign write_coil = is_count ? at[6] | at[8] : done & (is_bit | (is_shift & moves));
  assign coil_address = low + {5'd0, tap};
  assign coil = is_bit ? has_bit
              : is_shift ? enable & carry
              : reaches;

  // The low bits of UNIT that are 0.
  wire unused = &{1'b0, low[7:6]};
endmodule
