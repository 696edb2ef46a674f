// The word that a function works on, the preset that a count is compared with, and the bit that
// shifts carry from word to word.
module lp_operand (
    input  wire        clk,
    input  wire [15:0] read_word,       // of the register array
    // What becomes of the word; without any of these it stays.
    input  wire        load_largest,
    input  wire        load_word,       // as it was read
    input  wire        load_left,       // shifted, the carry comes in
    input  wire        load_right,
    input  wire        load_bit,        // with one bit set or cleared where there is power
    input  wire        load_preset,
    input  wire        load_next,       // one more, or less
    input  wire        clear,           // 0, above all others
    // How.
    input  wire        drum,
    input  wire        down,
    input  wire        power,
    input  wire        set_bit,
    input  wire [3:0]  bit_number,
    input  wire        serial,
    input  wire        load_serial,     // the carry becomes the serial data
    // What becomes of the preset.
    input  wire        read_preset,
    input  wire        limit_preset,    // the word is the largest preset: no more than that
    // What is known of them.
    output reg  [15:0] word,
    output wire        reached,         // the word is the preset or more
    output wire        at_end,          // the word is the last count
    output reg         carry,
    output reg         has_bit          // the bit is now as it is to be
);
  wire [15:0] largest = drum ? 16'd2047 : 16'd9999;
  reg  [15:0] preset;
  assign reached = word >= preset;
  assign at_end  = word == (down ? 16'd0 : largest);

  // A preset with its sign bit set acts as 0.
  always @(posedge clk)
    if (limit_preset & preset[15]) preset <= 16'd0;
    else if (read_preset | (limit_preset & ~reached)) preset <= limit_preset ? word : read_word;

  wire [15:0] place = 16'd1 << bit_number;
  wire [15:0] changed = (set_bit & power) ? read_word | place
                      : power ? read_word & ~place
                      : read_word;

  // The sum comes last, so it is chosen first.
  wire [15:0] next = word + {{15{down}}, 1'b1};
  always @(posedge clk)
    if (clear) word <= 16'd0;
    else if (load_next) word <= next;
    else if (load_preset) word <= preset;
    else if (load_largest) word <= largest;
    else if (load_left) word <= {read_word[14:0], carry};
    else if (load_right) word <= {carry, read_word[15:1]};
    else if (load_bit) word <= changed;
    else if (load_word) word <= read_word;

  always @(posedge clk) begin
    if (load_serial) carry <= serial;
    else if (load_left) carry <= read_word[15];
    else if (load_right) carry <= read_word[0];
    if (load_bit) has_bit <= power | (|(read_word & place)) == set_bit;
  end
endmodule
