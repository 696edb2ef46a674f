// Made by hotrail 0.1.0 from conveyor_build_up.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 30 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module conveyor_build_up_TON_PT30 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;
  reg ET_is_30 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_30;
  wire [4:0] sum = ET + 5'd1;
  wire [4:0] choice = condition_2 ? sum : ET;
  wire [4:0] ET_next = condition ? choice : 5'd0;
  wire equal = ET == 5'd29;
  wire choice_2 = condition_2 ? equal : ET_is_30;
  wire ET_is_30_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_30_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      was <= 1'b0;
      ET_is_30 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_30 <= ET_is_30_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 50 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module conveyor_build_up_TON_PT50 (
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

module conveyor_build_up (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire stop,
  input  wire eye,
  input  wire turning_2,
  output wire conveyor_1,
  output wire conveyor_2,
  output wire build_up
);
  reg build_up_reg = 1'b0;
  reg start_before = 1'b0;
  reg conveyor_2_reg = 1'b0;
  reg conveyor_1_reg = 1'b0;

  // rung 1 "a piece that passes is no pile", conveyor_build_up.ladder:14
  wire blocked_power = ~eye;
  wire blocked_Q;
  conveyor_build_up_TON_PT30 blocked (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(blocked_power),
    .Q(blocked_Q)
  );
  wire build_up_rung1 = blocked_Q | build_up_reg;

  // rung 2 "the pile is gone", conveyor_build_up.ladder:17
  wire clear_Q;
  conveyor_build_up_TON_PT50 clear (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(eye),
    .Q(clear_Q)
  );
  wire build_up_next = build_up_rung1 & ~clear_Q;

  // rung 3 "conveyor 2 runs as long as the line does", conveyor_build_up.ladder:20
  wire conveyor_2_next = (start & ~start_before | conveyor_2_reg) & stop;

  // rung 4 "conveyor 1 runs while it can get rid of its material", conveyor_build_up.ladder:23
  wire conveyor_1_next = conveyor_2_next & turning_2 & ~build_up_next;

  assign conveyor_1 = conveyor_1_reg;
  assign conveyor_2 = conveyor_2_reg;
  assign build_up = build_up_reg;

  always @(posedge clk) begin
    if (rst) begin
      build_up_reg <= 1'b0;
      start_before <= 1'b0;
      conveyor_2_reg <= 1'b0;
      conveyor_1_reg <= 1'b0;
    end else begin
      build_up_reg <= build_up_next;
      start_before <= start;
      conveyor_2_reg <= conveyor_2_next;
      conveyor_1_reg <= conveyor_1_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
