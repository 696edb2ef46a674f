// Made by hotrail 0.1.0 from flasher.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// PT = 3
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
  reg [31:0] ET = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET) < 32'sd200;
  wire [31:0] sum = ET + {31'b0, tick & less};
  wire [31:0] ET_next = (power & was) ? sum : 32'd0;
  wire at_least = $signed(ET_next) >= 32'sd200;
  wire Q_next = power & at_least;

  assign Q_last = Q;

  always @(posedge clk) begin
    if (rst) begin
      Q <= 1'b0;
      ET <= 32'd0;
      was <= 1'b0;
    end else begin
      Q <= Q_next;
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

// TON: on-delay timer
// PT = 3
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
  reg [31:0] ET = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET) < 32'sd1300;
  wire [31:0] sum = ET + {31'b0, tick & less};
  wire [31:0] ET_next = (power & was) ? sum : 32'd0;
  wire at_least = $signed(ET_next) >= 32'sd1300;

  assign Q = power & at_least;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 32'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
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
