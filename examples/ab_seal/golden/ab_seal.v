// Made by hotrail 0.1.0 from ab_seal.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_TON: on-delay timer of Allen-Bradley, BASE = 1 tick, SIZE = DINT
// Fitted to PRE = 2000.
module ab_seal_AB_TON_BASE1_DINT_PRE2000 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire EN,
  output wire EN_last,
  output wire DN
);
  reg [10:0] ACC = 11'd0;
  reg EN_reg = 1'b0;
  reg DN_reg = 1'b0;

  wire condition = power & EN_reg & ~DN_reg & tick;
  wire equal = ACC == 11'd2000;
  wire [10:0] sum = ACC + {10'b0, condition & ~equal};
  wire equal_2 = ACC == 11'd1999;
  wire DN_next = power & (DN_reg | condition & equal_2 | equal);
  wire [10:0] ACC_next = power ? sum : 11'd0;

  assign EN = power;
  assign EN_last = EN_reg;
  assign DN = DN_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 11'd0;
      EN_reg <= 1'b0;
      DN_reg <= 1'b0;
    end else begin
      ACC <= ACC_next;
      EN_reg <= power;
      DN_reg <= DN_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 2000 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module ab_seal_TON_PT2000 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [10:0] ET = 11'd0;
  reg was = 1'b0;
  reg ET_is_2000 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_2000;
  wire [10:0] sum = ET + 11'd1;
  wire [10:0] choice = condition_2 ? sum : ET;
  wire [10:0] ET_next = condition ? choice : 11'd0;
  wire equal = ET == 11'd1999;
  wire choice_2 = condition_2 ? equal : ET_is_2000;
  wire ET_is_2000_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_2000_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 11'd0;
      was <= 1'b0;
      ET_is_2000 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_2000 <= ET_is_2000_next;
    end
  end
endmodule

module ab_seal (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start_pb,
  input  wire stop_pb,
  output wire motor,
  output wire next_step,
  output wire siemens_motor,
  output wire siemens_next_step
);
  reg siemens_motor_reg = 1'b0;
  reg motor_reg = 1'b0;
  reg next_step_reg = 1'b0;
  reg siemens_next_step_reg = 1'b0;

  // rung 1 "Delay_Tmr seals itself in", ab_seal.ladder:9
  wire delay_tmr_EN;
  wire delay_tmr_EN_last;
  wire delay_tmr_DN;
  wire delay_tmr_power = (start_pb | delay_tmr_EN_last) & stop_pb;
  ab_seal_AB_TON_BASE1_DINT_PRE2000 delay_tmr (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(delay_tmr_power),
    .EN(delay_tmr_EN),
    .EN_last(delay_tmr_EN_last),
    .DN(delay_tmr_DN)
  );

  // rung 2, ab_seal.ladder:12
  wire motor_next = delay_tmr_EN;

  // rung 3, ab_seal.ladder:14
  wire next_step_next = delay_tmr_DN;

  // rung 4 "the same with Siemens' timer, which has no EN: a coil seals", ab_seal.ladder:16
  wire siemens_motor_next = (start_pb | siemens_motor_reg) & stop_pb;
  wire t1_Q;
  ab_seal_TON_PT2000 t1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(siemens_motor_next),
    .Q(t1_Q)
  );
  wire siemens_next_step_next = t1_Q;

  assign motor = motor_reg;
  assign next_step = next_step_reg;
  assign siemens_motor = siemens_motor_reg;
  assign siemens_next_step = siemens_next_step_reg;

  always @(posedge clk) begin
    if (rst) begin
      siemens_motor_reg <= 1'b0;
      motor_reg <= 1'b0;
      next_step_reg <= 1'b0;
      siemens_next_step_reg <= 1'b0;
    end else begin
      siemens_motor_reg <= siemens_motor_next;
      motor_reg <= motor_next;
      next_step_reg <= next_step_next;
      siemens_next_step_reg <= siemens_next_step_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
