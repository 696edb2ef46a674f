// Made by hotrail 0.1.0 from ab_retentive.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_RTO: retentive timer of Allen-Bradley, BASE = 100 ticks
// Example, with PRE = 3, BASE = 1:
// IN  _##_###____#_##
// (R) ____________#__
// EN  _##_###____#_##
// TT  _##_##_______##
// DN  ______######___
// ACC 001112333333001
module ab_retentive_AB_RTO_BASE100 (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [15:0] PRE,
  input  wire        clear_after,
  output wire        DN
);
  reg [14:0] ACC = 15'd0;
  reg DN_reg = 1'b0;
  reg [6:0] fraction = 7'd0;
  reg was = 1'b0;

  wire less = $signed(PRE) < 16'sd0;
  wire [14:0] choice = less ? 15'd0 : PRE[14:0];
  wire condition = power & was & ~DN_reg & tick;
  wire equal = fraction == 7'd99;
  wire condition_2 = condition & equal;
  wire [6:0] sum = fraction + {6'b0, condition};
  wire [6:0] choice_2 = condition_2 ? 7'd0 : sum;
  wire unequal = ACC != 15'd32767;
  wire [14:0] sum_2 = ACC + {14'b0, condition_2 & unequal};
  wire at_least = sum_2 >= choice;
  wire DN_value = DN_reg | power & at_least;
  wire [14:0] ACC_next = clear_after ? 15'd0 : sum_2;
  wire DN_next = ~clear_after & DN_value;
  wire [6:0] fraction_next = clear_after ? 7'd0 : choice_2;

  assign DN = DN_value;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 15'd0;
      DN_reg <= 1'b0;
      fraction <= 7'd0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      DN_reg <= DN_next;
      fraction <= fraction_next;
      was <= power;
    end
  end
endmodule

// TONR: retentive on-delay timer
// Example, with PT = 3:
// IN  _##_###____######
// R   _________#___#___
// Q   ______###_______#
// ET  00111233300010123
module ab_retentive_TONR (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [31:0] PT,
  input  wire        R,
  output wire        Q
);
  reg [31:0] ET = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET) < $signed(PT);
  wire [31:0] sum = ET + {31'b0, power & was & tick & less};
  wire [31:0] ET_next = R ? 32'd0 : sum;
  wire at_least = $signed(ET_next) >= $signed(PT);

  assign Q = ~R & at_least;

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

module ab_retentive (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire pump,
  input  wire reset_button,
  input  wire longer,
  output wire service,
  output wire siemens_service
);
  reg [3:0] t4_2_PRE = 4'd5;
  reg [9:0] limit = 10'd500;
  reg service_reg = 1'b0;
  reg siemens_service_reg = 1'b0;

  // rung 1 "T4:2, five units of a second", ab_retentive.ladder:12
  wire [15:0] t4_2_PRE_2 = {12'b0, t4_2_PRE};
  wire t4_2_DN;
  ab_retentive_AB_RTO_BASE100 t4_2 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pump),
    .PRE(t4_2_PRE_2),
    .clear_after(reset_button),
    .DN(t4_2_DN)
  );

  // rung 2, ab_retentive.ladder:15
  wire service_next = t4_2_DN;

  // rung 3 "RES", ab_retentive.ladder:17

  // rung 4 "the same with Siemens' timer", ab_retentive.ladder:20
  wire [31:0] t3_PT = {22'b0, limit};
  wire t3_Q;
  ab_retentive_TONR t3 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pump),
    .PT(t3_PT),
    .R(reset_button),
    .Q(t3_Q)
  );
  wire siemens_service_next = t3_Q;

  // rung 5, ab_retentive.ladder:23
  wire [3:0] t4_2_PRE_next = longer ? 4'd8 : t4_2_PRE;
  wire [9:0] limit_next = longer ? 10'd800 : limit;

  assign service = service_reg;
  assign siemens_service = siemens_service_reg;

  always @(posedge clk) begin
    if (rst) begin
      t4_2_PRE <= 4'd5;
      limit <= 10'd500;
      service_reg <= 1'b0;
      siemens_service_reg <= 1'b0;
    end else begin
      t4_2_PRE <= t4_2_PRE_next;
      limit <= limit_next;
      service_reg <= service_next;
      siemens_service_reg <= siemens_service_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
