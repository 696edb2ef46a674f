// Made by hotrail 0.1.0 from wound_rotor_start.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 50 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module wound_rotor_start_TON_PT50 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [5:0] ET = 6'd0;
  reg was = 1'b0;
  reg ET_is_50 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_50;
  wire [5:0] sum = ET + 6'd1;
  wire [5:0] choice = condition_2 ? sum : ET;
  wire [5:0] ET_next = condition ? choice : 6'd0;
  wire equal = ET == 6'd49;
  wire choice_2 = condition_2 ? equal : ET_is_50;
  wire ET_is_50_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_50_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 6'd0;
      was <= 1'b0;
      ET_is_50 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_50 <= ET_is_50_next;
    end
  end
endmodule

module wound_rotor_start (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire S0,
  input  wire S1,
  input  wire F1,
  output wire K1,
  output wire K2,
  output wire K3,
  output wire K4
);
  reg K1_reg = 1'b0;
  reg K2_reg = 1'b0;
  reg K3_reg = 1'b0;
  reg K4_reg = 1'b0;

  // rung 1 "line", wound_rotor_start.ladder:13
  wire K1_next = (S1 | K1_reg) & S0 & F1;

  // rung 2 "resistors", wound_rotor_start.ladder:16
  wire first_Q;
  wound_rotor_start_TON_PT50 first (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(K1_next),
    .Q(first_Q)
  );
  wire second_Q;
  wound_rotor_start_TON_PT50 second (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(first_Q),
    .Q(second_Q)
  );
  wire third_Q;
  wound_rotor_start_TON_PT50 third (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(second_Q),
    .Q(third_Q)
  );
  wire K2_next = first_Q;
  wire K3_next = second_Q;
  wire K4_next = third_Q;

  assign K1 = K1_reg;
  assign K2 = K2_reg;
  assign K3 = K3_reg;
  assign K4 = K4_reg;

  always @(posedge clk) begin
    if (rst) begin
      K1_reg <= 1'b0;
      K2_reg <= 1'b0;
      K3_reg <= 1'b0;
      K4_reg <= 1'b0;
    end else begin
      K1_reg <= K1_next;
      K2_reg <= K2_next;
      K3_reg <= K3_next;
      K4_reg <= K4_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
