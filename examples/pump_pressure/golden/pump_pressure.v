// Made by hotrail 0.1.0 from pump_pressure.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 50 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module pump_pressure_TON_PT50 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q,
  output wire Q_last
);
  reg Q_reg = 1'b0;
  reg [5:0] ET = 6'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~Q_reg;
  wire [5:0] sum = ET + 6'd1;
  wire [5:0] choice = condition_2 ? sum : ET;
  wire [5:0] ET_next = condition ? choice : 6'd0;
  wire equal = ET == 6'd49;
  wire choice_2 = condition_2 ? equal : Q_reg;
  wire Q_next = condition ? choice_2 : 1'b0;

  assign Q = Q_next;
  assign Q_last = Q_reg;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      ET <= 6'd0;
      was <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

module pump_pressure (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire stop,
  input  wire pressure,
  output wire pump,
  output wire low_pressure,
  output wire tripped
);
  reg start_before = 1'b0;
  reg pump_reg = 1'b0;
  reg tripped_reg = 1'b0;
  reg low_pressure_reg = 1'b0;

  // rung 1 "pump", pump_pressure.ladder:13
  wire delay_Q;
  wire delay_Q_last;
  wire pump_next = (start & ~start_before | pump_reg) & stop & (pressure | ~delay_Q_last);

  // rung 2 "time to build up pressure, or to lose it", pump_pressure.ladder:16
  wire low_pressure_next = pump_next & ~pressure;
  pump_pressure_TON_PT50 delay (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(low_pressure_next),
    .Q(delay_Q),
    .Q_last(delay_Q_last)
  );

  // rung 3 "tell the operator why it stands", pump_pressure.ladder:19
  wire tripped_rung3 = tripped_reg & ~(start & ~start_before);

  // rung 4, pump_pressure.ladder:21
  wire tripped_next = delay_Q | tripped_rung3;

  assign pump = pump_reg;
  assign low_pressure = low_pressure_reg;
  assign tripped = tripped_reg;

  always @(posedge clk) begin
    if (rst) begin
      start_before <= 1'b0;
      pump_reg <= 1'b0;
      tripped_reg <= 1'b0;
      low_pressure_reg <= 1'b0;
    end else begin
      start_before <= start;
      pump_reg <= pump_next;
      tripped_reg <= tripped_next;
      low_pressure_reg <= low_pressure_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
