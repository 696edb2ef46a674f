// Made by hotrail 0.1.0 from debounce.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 50 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module debounce_TON_PT50 (
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

// TOF: off-delay timer
// Fitted to PT = 5 ticks.
// Example, with PT = 3:
// IN  _##_____#__#_____
// Q   _#####__#######__
// ET  00001233001001233
module debounce_TOF_PT5 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [2:0] ET = 3'd0;
  reg run = 1'b0;
  reg was = 1'b0;

  wire [2:0] sum = ET + {2'b0, tick};
  wire equal = ET == 3'd4;
  wire [2:0] choice = was ? 3'd0 : sum;
  wire [2:0] ET_next = power ? 3'd0 : choice;
  wire run_next = power | run & ~(~was & tick & equal);

  assign Q = run_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 3'd0;
      run <= 1'b0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      run <= run_next;
      was <= power;
    end
  end
endmodule

module debounce (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire limit_switch_1,
  output wire settled,
  output wire at_once
);
  reg settled_reg = 1'b0;
  reg at_once_reg = 1'b0;

  // rung 1 "wait until it has been on for half a second", debounce.ladder:11
  wire quiet_Q;
  debounce_TON_PT50 quiet (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(limit_switch_1),
    .Q(quiet_Q)
  );
  wire settled_next = quiet_Q;

  // rung 2 "act at once, and bridge the gaps of the bounce", debounce.ladder:14
  wire gaps_Q;
  debounce_TOF_PT5 gaps (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(limit_switch_1),
    .Q(gaps_Q)
  );
  wire at_once_next = gaps_Q;

  assign settled = settled_reg;
  assign at_once = at_once_reg;

  always @(posedge clk) begin
    if (rst) begin
      settled_reg <= 1'b0;
      at_once_reg <= 1'b0;
    end else begin
      settled_reg <= settled_next;
      at_once_reg <= at_once_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
