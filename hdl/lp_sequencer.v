// Resets the memories and shows the outputs, then scans: samples the inputs, runs the words, shows the
// outputs.
module lp_sequencer #(
    parameter INPUTS = 16,              // 0 to 256
    parameter OUTPUTS = 16
) (
    input  wire        clk,
    input  wire        rst,
    input  wire        halt,            // no new scan begins
    input  wire        hold,            // a function needs more clocks
    input  wire        end_word,        // the word in work ends the scan
    output wire        resetting,       // memories are being reset
    output wire        idle,            // between two scans
    output wire        start_scan,      // inputs are sampled
    output wire        reading_inputs,  // the input `count` goes into the image
    output wire        running,         // words are executed
    output wire        valid,           // the word in work is one of this scan
    output wire        writing_outputs, // outputs are on their way, the one at `count` next
    output wire        scan_done,       // outputs are shown
    output reg  [10:0] count            // of what the state does; the address of the next word
);
  localparam [2:0] RESET = 3'd0, IDLE = 3'd1, READ = 3'd2, RUN = 3'd3, WRITE = 3'd4, SHOW = 3'd5;

  reg [2:0] state;
  reg [1:0] filled;                     // words behind each other: read from memory, in work

  assign resetting       = state == RESET;
  assign idle            = state == IDLE;
  assign start_scan      = idle & ~halt;
  assign reading_inputs  = state == READ;
  assign running         = state == RUN;
  assign valid           = running & filled[1];
  assign writing_outputs = state == WRITE;
  assign scan_done       = state == SHOW;

  wire reset_done = count == 11'd2047;
  localparam [31:0] LAST_INPUT = INPUTS > 0 ? INPUTS - 1 : 0, LAST_WRITE = OUTPUTS;
  wire read_done  = count == LAST_INPUT[10:0];
  wire write_done = count == LAST_WRITE[10:0];
  wire run_done   = valid & end_word;

  reg leaves;                           // the state changes
  always @*
    case (state)
      RESET: leaves = reset_done;
      IDLE: leaves = start_scan;
      READ: leaves = read_done;
      RUN: leaves = run_done;
      WRITE: leaves = write_done;
      default: leaves = 1'b1;
    endcase

  always @(posedge clk)
    if (rst) state <= RESET;
    else if (leaves)
      case (state)
        RESET: state <= WRITE;
        IDLE: state <= INPUTS == 0 ? RUN : READ;
        READ: state <= RUN;
        RUN: state <= WRITE;
        WRITE: state <= SHOW;
        default: state <= IDLE;
      endcase

  always @(posedge clk)
    if (rst | leaves) count <= 11'd0;
    else if (~hold) count <= count + 11'd1;

  always @(posedge clk)
    if (~running) filled <= 2'b00;
    else filled <= {filled[0], 1'b1};
endmodule
