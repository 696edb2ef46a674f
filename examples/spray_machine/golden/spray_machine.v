// Made by hotrail 0.1.0 from spray_machine.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 15 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module spray_machine_TON_PT15 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [3:0] ET = 4'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire equal = ET == 4'd15;
  wire [3:0] sum = ET + {3'b0, tick & ~equal};
  wire [3:0] ET_next = condition ? sum : 4'd0;
  wire equal_2 = ET == 4'd14;

  assign Q = condition & (tick & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ET <= 4'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

// TP: pulse timer
// Fitted to PT = 20 ticks.
// Example, with PT = 3:
// IN  _#####_#_#__
// Q   _###___###__
// ET  001233001200
module spray_machine_TP_PT20 (
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
  wire equal = ET == 5'd19;
  wire run_next = run ? ~(tick & equal) : power & ~was;
  wire [4:0] ET_next = run ? sum : 5'd0;

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

module spray_machine (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire stop,
  input  wire home,
  input  wire at_end,
  input  wire middle,
  output wire forward,
  output wire reverse,
  output wire spray
);
  reg start_before = 1'b0;
  reg cycle = 1'b0;
  reg reverse_reg = 1'b0;
  reg forward_reg = 1'b0;
  reg spray_reg = 1'b0;

  // rung 1 "over-all motion, until the part is back home", spray_machine.ladder:15
  wire cycle_next = (start & ~start_before | cycle) & stop & (~reverse_reg | ~home);

  // rung 2 "forward, from home to the end", spray_machine.ladder:18
  wire forward_next = cycle_next & (home | forward_reg) & ~reverse_reg & ~at_end;

  // rung 3 "come to rest, then back home; after a stop too, from anywhere", spray_machine.ladder:21
  wire rest_power = cycle_next & ~forward_next & ~home;
  wire rest_Q;
  spray_machine_TON_PT15 rest (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(rest_power),
    .Q(rest_Q)
  );
  wire reverse_next = rest_Q;

  // rung 4 "spray for two seconds while the part moves forward", spray_machine.ladder:24
  wire shot_power = forward_next & middle;
  wire shot_Q;
  spray_machine_TP_PT20 shot (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(shot_power),
    .Q(shot_Q)
  );
  wire spray_next = shot_Q & forward_next;

  assign forward = forward_reg;
  assign reverse = reverse_reg;
  assign spray = spray_reg;

  always @(posedge clk) begin
    if (rst) begin
      start_before <= 1'b0;
      cycle <= 1'b0;
      reverse_reg <= 1'b0;
      forward_reg <= 1'b0;
      spray_reg <= 1'b0;
    end else begin
      start_before <= start;
      cycle <= cycle_next;
      reverse_reg <= reverse_next;
      forward_reg <= forward_next;
      spray_reg <= spray_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
