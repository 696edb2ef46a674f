// Made by hotrail 0.1.0 from flasher.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 200 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module flasher_TON_PT200 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q_last
);
  reg Q = 1'b0;
  reg [7:0] ET = 8'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~Q;
  wire [7:0] sum = ET + 8'd1;
  wire [7:0] choice = condition_2 ? sum : ET;
  wire [7:0] ET_next = condition ? choice : 8'd0;
  wire equal = ET == 8'hc7;
  wire choice_2 = condition_2 ? equal : Q;
  wire Q_next = condition ? choice_2 : 1'b0;

  assign Q_last = Q;

  always @(posedge clk) begin
    if (rst) begin
      Q <= 1'b0;
      ET <= 8'd0;
      was <= 1'b0;
    end else begin
      Q <= Q_next;
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 1300 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module flasher_TON_PT1300 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [10:0] ET = 11'd0;
  reg was = 1'b0;
  reg ET_is_1300 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_1300;
  wire [10:0] sum = ET + 11'd1;
  wire [10:0] choice = condition_2 ? sum : ET;
  wire [10:0] ET_next = condition ? choice : 11'd0;
  wire equal = ET == 11'd1299;
  wire choice_2 = condition_2 ? equal : ET_is_1300;
  wire ET_is_1300_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_1300_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 11'd0;
      was <= 1'b0;
      ET_is_1300 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_1300 <= ET_is_1300_next;
    end
  end
endmodule

module flasher (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire enable,
  output wire lamp
);
  reg lamp_reg = 1'b0;

  // rung 1 "the lamp is on until this timer has run", flasher.ladder:7
  wire off_time_Q_last;
  wire on_time_power = enable & ~off_time_Q_last;
  wire on_time_Q;
  flasher_TON_PT200 off_time (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(on_time_Q),
    .Q_last(off_time_Q_last)
  );
  flasher_TON_PT1300 on_time (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(on_time_power),
    .Q(on_time_Q)
  );

  // rung 2 "and off until this one has", flasher.ladder:10

  // rung 3 "lamp", flasher.ladder:13
  wire lamp_next = enable & ~on_time_Q;

  assign lamp = lamp_reg;

  always @(posedge clk) begin
    if (rst) begin
      lamp_reg <= 1'b0;
    end else begin
      lamp_reg <= lamp_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
