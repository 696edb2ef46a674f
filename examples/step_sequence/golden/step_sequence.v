// Made by hotrail 0.1.0 from step_sequence.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 20 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module step_sequence_TON_PT20 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;
  reg ET_is_20 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_20;
  wire [4:0] sum = ET + 5'd1;
  wire [4:0] choice = condition_2 ? sum : ET;
  wire [4:0] ET_next = condition ? choice : 5'd0;
  wire equal = ET == 5'd19;
  wire choice_2 = condition_2 ? equal : ET_is_20;
  wire ET_is_20_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_20_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      was <= 1'b0;
      ET_is_20 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_20 <= ET_is_20_next;
    end
  end
endmodule

module step_sequence (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire clamped,
  input  wire deep,
  input  wire free,
  input  wire emergency,
  output wire clamp,
  output wire drill,
  output wire lift,
  output wire busy
);
  reg [2:0] step = 3'd0;
  reg start_before = 1'b0;
  reg clamp_reg = 1'b0;
  reg drill_reg = 1'b0;
  reg lift_reg = 1'b0;
  reg busy_reg = 1'b0;

  // rung 1 "part is free", step_sequence.ladder:16
  wire rung1_equal = step == 3'd4;
  wire [2:0] step_rung1 = (rung1_equal & free) ? 3'd0 : step;

  // rung 2 "drill is up", step_sequence.ladder:18
  wire up_time_power = step_rung1 == 3'd3;
  wire up_time_Q;
  step_sequence_TON_PT20 up_time (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(up_time_power),
    .Q(up_time_Q)
  );
  wire [2:0] step_rung2 = up_time_Q ? 3'd4 : step_rung1;

  // rung 3 "hole is deep enough", step_sequence.ladder:20
  wire rung3_equal = step_rung2 == 3'd2;
  wire [2:0] step_rung3 = (rung3_equal & deep) ? 3'd3 : step_rung2;

  // rung 4 "part is held", step_sequence.ladder:22
  wire rung4_equal = step_rung3 == 3'd1;
  wire [2:0] step_rung4 = (rung4_equal & clamped) ? 3'd2 : step_rung3;

  // rung 5 "a new part", step_sequence.ladder:24
  wire rung5_equal = step_rung4 == 3'd0;
  wire [2:0] step_rung5 = (rung5_equal & start & ~start_before) ? 3'd1 : step_rung4;

  // rung 6 "emergency: back to the start", step_sequence.ladder:27
  wire [2:0] step_next = emergency ? 3'd0 : step_rung5;

  // rung 7 "outputs of the steps", step_sequence.ladder:30
  wire rung7_unequal = step_next != 3'd0;
  wire rung7_unequal_2 = step_next != 3'd4;
  wire clamp_next = rung7_unequal & rung7_unequal_2;
  wire drill_next = step_next == 3'd2;
  wire lift_next = step_next == 3'd3;
  wire busy_next = step_next != 3'd0;

  assign clamp = clamp_reg;
  assign drill = drill_reg;
  assign lift = lift_reg;
  assign busy = busy_reg;

  always @(posedge clk) begin
    if (rst) begin
      step <= 3'd0;
      start_before <= 1'b0;
      clamp_reg <= 1'b0;
      drill_reg <= 1'b0;
      lift_reg <= 1'b0;
      busy_reg <= 1'b0;
    end else begin
      step <= step_next;
      start_before <= start;
      clamp_reg <= clamp_next;
      drill_reg <= drill_next;
      lift_reg <= lift_next;
      busy_reg <= busy_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
