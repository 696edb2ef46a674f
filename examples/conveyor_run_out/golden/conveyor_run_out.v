// Made by hotrail 0.1.0 from conveyor_run_out.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TONR: retentive on-delay timer
// Fitted to PT = 120 ticks.
// Example, with PT = 3:
// IN  _##_###____######
// R   _________#___#___
// Q   ______###_______#
// ET  00111233300010123
module conveyor_run_out_TONR_PT120 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  input  wire R,
  output wire Q,
  output wire Q_last
);
  reg Q_reg = 1'b0;
  reg [6:0] ET = 7'd0;
  reg was = 1'b0;
  reg ET_is_120 = 1'b0;

  wire condition = power & was & tick & ~ET_is_120;
  wire [6:0] sum = ET + 7'd1;
  wire [6:0] choice = condition ? sum : ET;
  wire [6:0] ET_next = R ? 7'd0 : choice;
  wire equal = ET == 7'd119;
  wire choice_2 = condition ? equal : ET_is_120;
  wire ET_is_120_next = R ? 1'b0 : choice_2;
  wire Q_next = ~R & ET_is_120_next;

  assign Q = Q_next;
  assign Q_last = Q_reg;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      ET <= 7'd0;
      was <= 1'b0;
      ET_is_120 <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      ET <= ET_next;
      was <= power;
      ET_is_120 <= ET_is_120_next;
    end
  end
endmodule

module conveyor_run_out (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire finish,
  input  wire emergency,
  input  wire product,
  input  wire wait_for_next,
  output wire conveyor,
  output wire empty
);
  reg start_before = 1'b0;
  reg ordered = 1'b0;
  reg finishing = 1'b0;
  reg conveyor_reg = 1'b0;
  reg empty_reg = 1'b0;

  // rung 1 "start", conveyor_run_out.ladder:18
  wire rung1_power = start & ~start_before;
  wire ordered_rung1 = rung1_power | ordered;
  wire finishing_rung1 = finishing & ~rung1_power;

  // rung 2 "finish", conveyor_run_out.ladder:20
  wire finishing_rung2 = finish & ordered_rung1 | finishing_rung1;

  // rung 3 "stop when the last product has left", conveyor_run_out.ladder:22
  wire track_Q;
  wire track_Q_last;
  wire ordered_rung3 = ordered_rung1 & ~(finishing_rung2 & track_Q_last);
  wire finishing_rung3 = finishing_rung2 & ~track_Q_last;

  // rung 4 "emergency", conveyor_run_out.ladder:24
  wire ordered_next = ordered_rung3 & emergency;
  wire finishing_next = finishing_rung3 & emergency;

  // rung 5 "conveyor", conveyor_run_out.ladder:27
  wire conveyor_next = ordered_next & ~wait_for_next;
  conveyor_run_out_TONR_PT120 track (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(conveyor_next),
    .R(product),
    .Q(track_Q),
    .Q_last(track_Q_last)
  );

  // rung 6 "a product needs 12 s over the belt", conveyor_run_out.ladder:30
  wire empty_next = track_Q;

  assign conveyor = conveyor_reg;
  assign empty = empty_reg;

  always @(posedge clk) begin
    if (rst) begin
      start_before <= 1'b0;
      ordered <= 1'b0;
      finishing <= 1'b0;
      conveyor_reg <= 1'b0;
      empty_reg <= 1'b0;
    end else begin
      start_before <= start;
      ordered <= ordered_next;
      finishing <= finishing_next;
      conveyor_reg <= conveyor_next;
      empty_reg <= empty_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
