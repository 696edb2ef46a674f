// Made by hotrail 0.1.0 from race_three_pushes.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to power = 1, PT = 20 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module race_three_pushes_TON_power1_PT20 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire clear_after,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;

  wire equal = ET == 5'd20;
  wire [4:0] sum = ET + {4'b0, tick & ~equal};
  wire [4:0] choice = was ? sum : 5'd0;
  wire equal_2 = ET == 5'd19;
  wire [4:0] ET_next = clear_after ? 5'd0 : choice;

  assign Q = was & (tick & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= 1'b1;
    end
  end
endmodule

module race_three_pushes (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire button,
  input  wire clear,
  output wire won
);
  reg button_before = 1'b0;
  reg turn_b = 1'b0;
  reg seen_a = 1'b0;
  reg seen_b = 1'b0;
  reg won_reg = 1'b0;

  // rung 1 "a push", race_three_pushes.ladder:14
  wire pushed = button & ~button_before;

  // rung 2 "how long ago the last pushes were", race_three_pushes.ladder:17
  wire age_a_Q;

  // rung 3, race_three_pushes.ladder:19
  wire age_b_Q;

  // rung 4 "the last but one is less than two seconds old", race_three_pushes.ladder:21
  wire won_rung4 = pushed & (~turn_b & seen_a & ~age_a_Q | turn_b & seen_b & ~age_b_Q) | won_reg;

  // rung 5 "this push takes its place", race_three_pushes.ladder:24
  wire age_a_clear_after = pushed & ~turn_b;
  race_three_pushes_TON_power1_PT20 age_a (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .clear_after(age_a_clear_after),
    .Q(age_a_Q)
  );
  wire seen_a_rung5 = age_a_clear_after | seen_a;
  wire age_b_clear_after = pushed & turn_b;
  race_three_pushes_TON_power1_PT20 age_b (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .clear_after(age_b_clear_after),
    .Q(age_b_Q)
  );
  wire seen_b_rung5 = age_b_clear_after | seen_b;
  wire turn_b_next = (age_a_clear_after | age_b_clear_after) ? ~turn_b : turn_b;

  // rung 6 "clear", race_three_pushes.ladder:27
  wire won_next = clear ? 1'b0 : won_rung4;
  wire seen_a_next = clear ? 1'b0 : seen_a_rung5;
  wire seen_b_next = clear ? 1'b0 : seen_b_rung5;

  assign won = won_reg;

  always @(posedge clk) begin
    if (rst) begin
      button_before <= 1'b0;
      turn_b <= 1'b0;
      seen_a <= 1'b0;
      seen_b <= 1'b0;
      won_reg <= 1'b0;
    end else begin
      button_before <= button;
      turn_b <= turn_b_next;
      seen_a <= seen_a_next;
      seen_b <= seen_b_next;
      won_reg <= won_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
