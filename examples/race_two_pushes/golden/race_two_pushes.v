// Made by hotrail 0.1.0 from race_two_pushes.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// CTU: up counter
// Fitted to PV = 2.
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module race_two_pushes_CTU_PV2 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire clear_after,
  output wire Q,
  output wire CV_at_least_1
);
  reg [1:0] CV = 2'd0;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire equal = CV == 2'd2;
  wire [1:0] sum = CV + {1'b0, condition & ~equal};
  wire equal_2 = CV == 2'd1;
  wire [1:0] CV_next = clear_after ? 2'd0 : sum;
  wire equal_3 = CV == 2'd0;

  assign Q = condition & equal_2 | equal;
  assign CV_at_least_1 = ~(~condition & equal_3);

  always @(posedge clk) begin
    if (rst) begin
      CV <= 2'd0;
      was <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 20 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module race_two_pushes_TON_PT20 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  input  wire clear_after,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire equal = ET == 5'd20;
  wire [4:0] sum = ET + {4'b0, tick & ~equal};
  wire [4:0] choice = condition ? sum : 5'd0;
  wire equal_2 = ET == 5'd19;
  wire [4:0] ET_next = clear_after ? 5'd0 : choice;

  assign Q = condition & (tick & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

module race_two_pushes (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire button,
  input  wire clear,
  output wire won
);
  reg won_reg = 1'b0;

  // rung 1 "count the pushes", race_two_pushes.ladder:10
  wire pushes_Q;
  wire pushes_CV_at_least_1;

  // rung 2 "the time runs from the first push on", race_two_pushes.ladder:13
  wire time_Q;

  // rung 3 "two pushes before the time is up", race_two_pushes.ladder:16
  wire won_rung3 = pushes_Q & ~time_Q | won_reg;

  // rung 4 "won or lost, the next push is a first one", race_two_pushes.ladder:19
  wire rung4_power = pushes_Q | time_Q;

  // rung 5 "clear", race_two_pushes.ladder:22
  wire won_next = won_rung3 & ~clear;
  wire pushes_clear_after = rung4_power | clear;
  race_two_pushes_CTU_PV2 pushes (
    .clk(clk),
    .rst(rst),
    .power(button),
    .clear_after(pushes_clear_after),
    .Q(pushes_Q),
    .CV_at_least_1(pushes_CV_at_least_1)
  );
  wire time_clear_after = rung4_power | clear;
  race_two_pushes_TON_PT20 time_u (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pushes_CV_at_least_1),
    .clear_after(time_clear_after),
    .Q(time_Q)
  );

  assign won = won_reg;

  always @(posedge clk) begin
    if (rst) begin
      won_reg <= 1'b0;
    end else begin
      won_reg <= won_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
