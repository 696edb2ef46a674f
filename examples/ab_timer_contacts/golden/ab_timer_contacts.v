// Made by hotrail 0.1.0 from ab_timer_contacts.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_TON: on-delay timer of Allen-Bradley, BASE = 10 ticks
// Example, with PRE = 3, BASE = 1:
// IN  _#######__###_
// EN  _#######__###_
// TT  _###______###_
// DN  ____####______
// ACC 00123333000120
module ab_timer_contacts_AB_TON_BASE10 (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [15:0] PRE,
  output wire        EN,
  output wire        TT,
  output wire        DN
);
  reg [14:0] ACC = 15'd0;
  reg DN_reg = 1'b0;
  reg [3:0] fraction = 4'd0;
  reg was = 1'b0;

  wire less = $signed(PRE) < 16'sd0;
  wire [14:0] choice = less ? 15'd0 : PRE[14:0];
  wire condition = power & was & ~DN_reg & tick;
  wire equal = fraction == 4'd9;
  wire condition_2 = condition & equal;
  wire [3:0] sum = fraction + {3'b0, condition};
  wire [3:0] choice_2 = condition_2 ? 4'd0 : sum;
  wire unequal = ACC != 15'd32767;
  wire [14:0] sum_2 = ACC + {14'b0, condition_2 & unequal};
  wire at_least = sum_2 >= choice;
  wire DN_next = power & (DN_reg | at_least);
  wire [14:0] ACC_next = power ? sum_2 : 15'd0;
  wire [3:0] fraction_next = power ? choice_2 : 4'd0;

  assign EN = power;
  assign TT = power & ~DN_next;
  assign DN = DN_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 15'd0;
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
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module ab_timer_contacts_TON (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire        power,
  input  wire [31:0] PT,
  output wire        Q
);
  reg [31:0] ET = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET) < $signed(PT);
  wire [31:0] sum = ET + {31'b0, tick & less};
  wire [31:0] ET_next = (power & was) ? sum : 32'd0;
  wire at_least = $signed(ET_next) >= $signed(PT);

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

module ab_timer_contacts (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire run,
  input  wire slower,
  output wire enabled,
  output wire timing,
  output wire done,
  output wire not_enabled,
  output wire not_timing,
  output wire not_done,
  output wire siemens_done
);
  reg [6:0] t4_0_PRE = 7'd50;
  reg [12:0] preset = 13'd500;
  reg enabled_reg = 1'b0;
  reg timing_reg = 1'b0;
  reg done_reg = 1'b0;
  reg not_enabled_reg = 1'b0;
  reg not_timing_reg = 1'b0;
  reg not_done_reg = 1'b0;
  reg siemens_done_reg = 1'b0;

  // rung 1 "T4:0, 50 units of 10 ms", ab_timer_contacts.ladder:12
  wire [15:0] t4_0_PRE_2 = {7'b0, {{2{t4_0_PRE[6]}}, t4_0_PRE}};
  wire t4_0_EN;
  wire t4_0_TT;
  wire t4_0_DN;
  ab_timer_contacts_AB_TON_BASE10 t4_0 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(run),
    .PRE(t4_0_PRE_2),
    .EN(t4_0_EN),
    .TT(t4_0_TT),
    .DN(t4_0_DN)
  );

  // rung 2 "EN", ab_timer_contacts.ladder:15
  wire enabled_next = t4_0_EN;

  // rung 3 "TT", ab_timer_contacts.ladder:18
  wire timing_next = t4_0_TT;

  // rung 4 "DN", ab_timer_contacts.ladder:21
  wire done_next = t4_0_DN;

  // rung 5, ab_timer_contacts.ladder:24
  wire not_enabled_next = ~t4_0_EN;

  // rung 6, ab_timer_contacts.ladder:26
  wire not_timing_next = ~t4_0_TT;

  // rung 7, ab_timer_contacts.ladder:28
  wire not_done_next = ~t4_0_DN;

  // rung 8 "the same with Siemens' timer: only Q is built in", ab_timer_contacts.ladder:30
  wire [31:0] t1_PT = {19'b0, preset};
  wire t1_Q;
  ab_timer_contacts_TON t1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(run),
    .PT(t1_PT),
    .Q(t1_Q)
  );
  wire siemens_done_next = t1_Q;

  // rung 9 "from 0.5 s to 5 s", ab_timer_contacts.ladder:33
  wire [6:0] t4_0_PRE_next = slower ? 7'd116 : t4_0_PRE;
  wire [12:0] preset_next = slower ? 13'd5000 : preset;

  assign enabled = enabled_reg;
  assign timing = timing_reg;
  assign done = done_reg;
  assign not_enabled = not_enabled_reg;
  assign not_timing = not_timing_reg;
  assign not_done = not_done_reg;
  assign siemens_done = siemens_done_reg;

  always @(posedge clk) begin
    if (rst) begin
      t4_0_PRE <= 7'd50;
      preset <= 13'd500;
      enabled_reg <= 1'b0;
      timing_reg <= 1'b0;
      done_reg <= 1'b0;
      not_enabled_reg <= 1'b0;
      not_timing_reg <= 1'b0;
      not_done_reg <= 1'b0;
      siemens_done_reg <= 1'b0;
    end else begin
      t4_0_PRE <= t4_0_PRE_next;
      preset <= preset_next;
      enabled_reg <= enabled_next;
      timing_reg <= timing_next;
      done_reg <= done_next;
      not_enabled_reg <= not_enabled_next;
      not_timing_reg <= not_timing_next;
      not_done_reg <= not_done_next;
      siemens_done_reg <= siemens_done_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
