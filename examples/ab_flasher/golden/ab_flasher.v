// Made by hotrail 0.1.0 from ab_flasher.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_TON: on-delay timer of Allen-Bradley, BASE = 10 ticks
// Fitted to PRE = 30.
// Example, with PRE = 3, BASE = 1:
// IN  _#######__###_
// EN  _#######__###_
// TT  _###______###_
// DN  ____####______
// ACC 00123333000120
module ab_flasher_AB_TON_BASE10_PRE30 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire DN_last
);
  reg [4:0] ACC = 5'd0;
  reg DN = 1'b0;
  reg [3:0] fraction = 4'd0;
  reg was = 1'b0;

  wire condition = power & was & ~DN & tick;
  wire equal = fraction == 4'd9;
  wire condition_2 = condition & equal;
  wire [3:0] sum = fraction + {3'b0, condition};
  wire [3:0] choice = condition_2 ? 4'd0 : sum;
  wire equal_2 = ACC == 5'd30;
  wire [4:0] sum_2 = ACC + {4'b0, condition_2 & ~equal_2};
  wire equal_3 = ACC == 5'd29;
  wire DN_next = power & (DN | condition_2 & equal_3 | equal_2);
  wire [4:0] ACC_next = power ? sum_2 : 5'd0;
  wire [3:0] fraction_next = power ? choice : 4'd0;

  assign DN_last = DN;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 5'd0;
      DN <= 1'b0;
      fraction <= 4'd0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      DN <= DN_next;
      fraction <= fraction_next;
      was <= power;
    end
  end
endmodule

// AB_TON: on-delay timer of Allen-Bradley, BASE = 10 ticks
// Fitted to PRE = 50.
// Example, with PRE = 3, BASE = 1:
// IN  _#######__###_
// EN  _#######__###_
// TT  _###______###_
// DN  ____####______
// ACC 00123333000120
module ab_flasher_AB_TON_BASE10_PRE50 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire DN
);
  reg [5:0] ACC = 6'd0;
  reg DN_reg = 1'b0;
  reg [3:0] fraction = 4'd0;
  reg was = 1'b0;

  wire condition = power & was & ~DN_reg & tick;
  wire equal = fraction == 4'd9;
  wire condition_2 = condition & equal;
  wire [3:0] sum = fraction + {3'b0, condition};
  wire [3:0] choice = condition_2 ? 4'd0 : sum;
  wire equal_2 = ACC == 6'd50;
  wire [5:0] sum_2 = ACC + {5'b0, condition_2 & ~equal_2};
  wire equal_3 = ACC == 6'd49;
  wire DN_next = power & (DN_reg | condition_2 & equal_3 | equal_2);
  wire [5:0] ACC_next = power ? sum_2 : 6'd0;
  wire [3:0] fraction_next = power ? choice : 4'd0;

  assign DN = DN_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 6'd0;
      DN_reg <= 1'b0;
      fraction <= 4'd0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      DN_reg <= DN_next;
      fraction <= fraction_next;
      was <= power;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 300 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module ab_flasher_TON_PT300 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q_last
);
  reg Q = 1'b0;
  reg [8:0] ET = 9'd0;
  reg was = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~Q;
  wire [8:0] sum = ET + 9'd1;
  wire [8:0] choice = condition_2 ? sum : ET;
  wire [8:0] ET_next = condition ? choice : 9'd0;
  wire equal = ET == 9'd299;
  wire choice_2 = condition_2 ? equal : Q;
  wire Q_next = condition ? choice_2 : 1'b0;

  assign Q_last = Q;

  always @(posedge clk) begin
    if (rst) begin
      Q <= 1'b0;
      ET <= 9'd0;
      was <= 1'b0;
    end else begin
      Q <= Q_next;
      ET <= ET_next;
      was <= power;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 500 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module ab_flasher_TON_PT500 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [8:0] ET = 9'd0;
  reg was = 1'b0;
  reg ET_is_500 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_500;
  wire [8:0] sum = ET + 9'd1;
  wire [8:0] choice = condition_2 ? sum : ET;
  wire [8:0] ET_next = condition ? choice : 9'd0;
  wire equal = ET == 9'd499;
  wire choice_2 = condition_2 ? equal : ET_is_500;
  wire ET_is_500_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_500_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 9'd0;
      was <= 1'b0;
      ET_is_500 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_500 <= ET_is_500_next;
    end
  end
endmodule

module ab_flasher (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire enable,
  output wire ab_light,
  output wire siemens_light
);
  reg ab_light_reg = 1'b0;
  reg siemens_light_reg = 1'b0;

  // rung 1 "T4:0: dark for 0.5 s", ab_flasher.ladder:7
  wire t4_1_DN_last;
  wire t4_0_power = enable & ~t4_1_DN_last;
  wire t4_0_DN;
  ab_flasher_AB_TON_BASE10_PRE30 t4_1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t4_0_DN),
    .DN_last(t4_1_DN_last)
  );
  ab_flasher_AB_TON_BASE10_PRE50 t4_0 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t4_0_power),
    .DN(t4_0_DN)
  );

  // rung 2 "T4:1: lit for 0.3 s", ab_flasher.ladder:10

  // rung 3, ab_flasher.ladder:13
  wire ab_light_next = t4_0_DN;

  // rung 4 "the same with Siemens' timers", ab_flasher.ladder:15
  wire t2_Q_last;
  wire t1_power = enable & ~t2_Q_last;
  wire t1_Q;
  ab_flasher_TON_PT300 t2 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t1_Q),
    .Q_last(t2_Q_last)
  );
  ab_flasher_TON_PT500 t1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t1_power),
    .Q(t1_Q)
  );

  // rung 5, ab_flasher.ladder:18

  // rung 6, ab_flasher.ladder:20
  wire siemens_light_next = t1_Q;

  assign ab_light = ab_light_reg;
  assign siemens_light = siemens_light_reg;

  always @(posedge clk) begin
    if (rst) begin
      ab_light_reg <= 1'b0;
      siemens_light_reg <= 1'b0;
    end else begin
      ab_light_reg <= ab_light_next;
      siemens_light_reg <= siemens_light_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
