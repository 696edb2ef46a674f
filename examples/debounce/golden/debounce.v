// Made by hotrail 0.1.0 from debounce.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// PT = 3
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
  reg [31:0] ET = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET) < 32'sd50;
  wire [31:0] sum = ET + {31'b0, tick & less};
  wire [31:0] ET_next = (power & was) ? sum : 32'd0;
  wire at_least = $signed(ET_next) >= 32'sd50;

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

// TOF: off-delay timer
// PT = 3
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
  reg [31:0] ET = 32'd0;
  reg run = 1'b0;
  reg was = 1'b0;

  wire less = $signed(ET) < 32'sd5;
  wire [31:0] sum = ET + {31'b0, tick & less};
  wire [31:0] choice = was ? 32'd0 : sum;
  wire less_2 = $signed(choice) < 32'sd5;
  wire [31:0] choice_2 = run ? choice : ET;
  wire [31:0] ET_next = power ? 32'd0 : choice_2;
  wire run_next = power | run & less_2;

  assign Q = run_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 32'd0;
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
