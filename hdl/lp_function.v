// Timers, counters, drums, shifts and bits of registers: takes what prefixes give, and runs an
// operation in several clocks while the words behind it wait.
module lp_function #(
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
    output reg  [10:0] read_register,
    input  wire [15:0] read_word,
    output wire        write_register,
    output wire [10:0] written_register,
    output wire [15:0] written_word,
    // The image.
    output wire        write_coil,
    output wire [9:0]  coil_address,
    output wire        coil
);
  localparam [3:0] TT = 4'd1, UC = 4'd2, DC = 4'd3, BIT_SET = 4'd4, BIT_CLEAR = 4'd5, DRUM = 4'd6,
                   SHIFT_RIGHT = 4'd7, SHIFT_LEFT = 4'd8;
  localparam [3:0] ENABLE = 4'd0, SERIAL = 4'd1, UNIT = 4'd2, NUMBER = 4'd3, REGISTER_LOW = 4'd4,
                   REGISTER_HIGH = 4'd5;
  localparam [10:0] FIRST_COUNT = 11'd512, FIRST_DRUM = 11'd576;

  // What prefixes have given.
  reg        enable, serial;
  reg [5:0]  unit_number;
  reg [1:0]  timer_type;
  reg [5:0]  number;
  reg [10:0] register_number;

  always @(posedge clk)
    if (start_scan | (run & done)) begin
      enable <= 1'b1;
      serial <= 1'b0;
    end else if (prefix)
      case (field)
        ENABLE: enable <= power;
        SERIAL: serial <= power;
        UNIT: {timer_type, unit_number} <= {low[9:8], low[5:0]};
        NUMBER: number <= low[5:0];
        REGISTER_LOW: register_number <= {1'b0, low};
        REGISTER_HIGH: register_number <= {1'b1, low};
        default: ;
      endcase

  wire is_drum  = field == DRUM;
  wire is_bit   = field == BIT_SET | field == BIT_CLEAR;
  wire is_left  = field == SHIFT_LEFT;
  wire is_shift = field == SHIFT_RIGHT | is_left;
  wire is_timer = field == 4'd0 | field == TT;

  // The clock of the operation, from 0.
  reg [6:0] step;
  wire [6:0] last_step = is_bit ? 7'd2 : is_shift ? {number, 1'b1} : is_drum ? 7'd3 + {1'b0, number}
                       : 7'd3;
  assign done = step == last_step;
  always @(posedge clk)
    if (rst | ~run | done) step <= 7'd0;
    else step <= step + 7'd1;

  // What each unit keeps: timers and counters from 0, drums from 64, shifts from 96.
  wire [6:0] unit_address = is_drum ? {3'b100, unit_number[3:0]} : is_shift ? {2'b11, unit_number[4:0]}
                          : {1'b0, unit_number};
  wire was, was_enabled, runs;
  wire runs_on;
  wire keep = run & done & ~is_bit;
  lp_memory #(.WIDTH(3), .ADDRESS_BITS(7)) units (
      .clk(clk),
      .write(clear_units | keep),
      .write_address(clear_units ? clear_address : unit_address),
      .write_data(clear_units ? 3'd0 : {is_timer & runs_on, power & enable, power}),
      .read(step == 7'd0), .read_address(unit_address), .read_data({runs, was_enabled, was})
  );
  wire rises = power & ~was;

  // Presets: 0 where the sign bit is set, no more than the largest.
  wire [15:0] largest = is_drum ? 16'd2047 : 16'd9999;
  reg  [15:0] preset;
  always @(posedge clk)
    if (step == 7'd1)
      preset <= read_word[15] ? 16'd0 : read_word > largest ? largest : read_word;

  // Clock 2: the count is there. Clock 3: it is compared and written.
  wire tenth, second;
  lp_pulses #(.TICKS_PER_TENTH(TICKS_PER_TENTH), .TICKS_PER_SECOND(TICKS_PER_SECOND)) pulses (
      .clk(clk), .rst(rst), .start_scan(start_scan), .tick(tick), .tenth(tenth), .second(second)
  );
  wire [15:0] timed, counted;
  wire timer_coil, timer_clears;
  reg  [15:0] count;
  wire reached = count >= preset;
  lp_timer timer (
      .timer_type(timer_type), .enable(enable), .power(power),
      .pulse(field == TT ? tenth : second),
      .was(was), .was_enabled(was_enabled), .runs(runs),
      .preset(preset), .old_count(read_word), .count(timed),
      .reached(reached), .coil(timer_coil), .runs_on(runs_on), .clears(timer_clears)
  );
  lp_counter counter (
      .down(field == DC), .drum(is_drum), .enable(enable), .rises(rises),
      .preset(preset), .old_count(read_word), .count(counted)
  );
  always @(posedge clk) if (step == 7'd2) count <= is_timer ? timed : counted;

  wire [10:0] count_register = is_drum ? FIRST_DRUM + {7'd0, unit_number[3:0]}
                             : FIRST_COUNT + {5'd0, unit_number};
  wire [15:0] written_count = is_timer & timer_clears ? 16'd0 : count;
  wire counter_coil = field == DC ? count == 16'd0 : reached;

  // Bits: read, changed, written.
  wire [15:0] mask = 16'd1 << number[3:0];
  reg  [15:0] changed;
  always @(posedge clk)
    changed <= ~power ? read_word : field == BIT_SET ? read_word | mask : read_word & ~mask;
  wire bit_coil = |(changed & mask) == (field == BIT_SET);

  // Shifts: from the low register to the high one, or back.
  reg  carry;
  wire [5:0] place = is_left ? step[6:1] : number - 6'd1 - step[6:1];
  wire [5:0] written_place = is_left ? step[6:1] - 6'd1 : number - step[6:1];
  wire shifts_now = is_shift & ~step[0] & step != 7'd0;
  wire [15:0] shifted = is_left ? {read_word[14:0], carry} : {carry, read_word[15:1]};
  always @(posedge clk)
    if (step == 7'd0) carry <= serial;
    else if (shifts_now) carry <= is_left ? read_word[15] : read_word[0];

  // The register array.
  wire is_counted = ~is_bit & ~is_shift;
  wire [6:0] tap = step - 7'd2;
  always @*
    if (is_shift) read_register = register_number + {5'd0, place};
    else if (is_bit | step == 7'd0) read_register = register_number;
    else if (step == 7'd1) read_register = count_register;
    else read_register = register_number + {4'd0, tap};

  assign write_register = run & (
      (is_counted & step == 7'd3)
      | (is_bit & step == 7'd2)
      | (shifts_now & (~enable | rises)));
  assign written_register = is_counted ? count_register : is_bit ? register_number
                          : register_number + {5'd0, written_place};
  assign written_word = is_counted ? written_count : is_bit ? changed : enable ? shifted : 16'd0;

  // The coils: that of the operation, then those of the taps.
  wire [6:0] tap_coil = step - 7'd3;
  wire taps_now = is_drum & step > 7'd3;
  assign write_coil = run & (
      (is_counted & step >= 7'd3)
      | (is_bit & done)
      | (is_shift & done & (~enable | rises)));
  assign coil_address = is_drum ? low + {3'd0, tap_coil} : low;
  assign coil = is_bit ? bit_coil
              : is_shift ? enable & carry
              : taps_now ? count >= read_word
              : is_timer ? timer_coil
              : counter_coil;

  // These codes stand for what is left: TS has 0, UC is the counter that is no other.
  wire unused = &{1'b0, UC, low[7:6]};
endmodule
