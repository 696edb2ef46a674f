// Made by hotrail 0.1.0 from microwave.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TONR: retentive on-delay timer
// Fitted to PT = 900 ticks.
// Example, with PT = 3:
// IN  _##_###____######
// R   _________#___#___
// Q   ______###_______#
// ET  00111233300010123
module microwave_TONR_PT900 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  input  wire R,
  output wire Q,
  output wire Q_last
);
  reg Q_reg = 1'b0;
  reg [9:0] ET = 10'd0;
  reg was = 1'b0;
  reg ET_is_900 = 1'b0;

  wire condition = power & was & tick & ~ET_is_900;
  wire [9:0] sum = ET + 10'd1;
  wire [9:0] choice = condition ? sum : ET;
  wire [9:0] ET_next = R ? 10'd0 : choice;
  wire equal = ET == 10'd899;
  wire choice_2 = condition ? equal : ET_is_900;
  wire ET_is_900_next = R ? 1'b0 : choice_2;
  wire Q_next = ~R & ET_is_900_next;

  assign Q = Q_next;
  assign Q_last = Q_reg;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      ET <= 10'd0;
      was <= 1'b0;
      ET_is_900 <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      ET <= ET_next;
      was <= power;
      ET_is_900 <= ET_is_900_next;
    end
  end
endmodule

// TOF: off-delay timer
// Fitted to PT = 30 ticks.
// Example, with PT = 3:
// IN  _##_____#__#_____
// Q   _#####__#######__
// ET  00001233001001233
module microwave_TOF_PT30 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg run = 1'b0;
  reg was = 1'b0;

  wire [4:0] sum = ET + {4'b0, tick};
  wire equal = ET == 5'd29;
  wire [4:0] choice = was ? 5'd0 : sum;
  wire [4:0] ET_next = power ? 5'd0 : choice;
  wire run_next = power | run & ~(~was & tick & equal);

  assign Q = run_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      run <= 1'b0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      run <= run_next;
      was <= power;
    end
  end
endmodule

module microwave (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire cancel,
  input  wire door,
  input  wire foam,
  output wire magnetron,
  output wire turntable,
  output wire ready
);
  reg start_before = 1'b0;
  reg turntable_reg = 1'b0;
  reg magnetron_reg = 1'b0;
  reg ready_reg = 1'b0;

  // rung 1 "cook until the time is up or somebody wants the bowl", microwave.ladder:13
  wire done_Q;
  wire done_Q_last;
  wire turntable_next =
      (start & ~start_before & ~done_Q_last | turntable_reg) & door & ~cancel & ~done_Q_last;

  // rung 2 "the foam needs three seconds to sink", microwave.ladder:16
  wire sinking_Q;
  microwave_TOF_PT30 sinking (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(foam),
    .Q(sinking_Q)
  );
  wire magnetron_next = ~sinking_Q & turntable_next;

  // rung 3 "a minute and a half of power, in all", microwave.ladder:19
  wire done_R = cancel | done_Q_last & ~door;
  microwave_TONR_PT900 done (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(magnetron_next),
    .R(done_R),
    .Q(done_Q),
    .Q_last(done_Q_last)
  );
  wire ready_next = done_Q;

  assign magnetron = magnetron_reg;
  assign turntable = turntable_reg;
  assign ready = ready_reg;

  always @(posedge clk) begin
    if (rst) begin
      start_before <= 1'b0;
      turntable_reg <= 1'b0;
      magnetron_reg <= 1'b0;
      ready_reg <= 1'b0;
    end else begin
      start_before <= start;
      turntable_reg <= turntable_next;
      magnetron_reg <= magnetron_next;
      ready_reg <= ready_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
