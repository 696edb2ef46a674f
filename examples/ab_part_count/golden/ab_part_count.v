// Made by hotrail 0.1.0 from ab_part_count.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// AB_TON: on-delay timer of Allen-Bradley, BASE = 1 tick, SIZE = DINT
// Fitted to PRE = 500.
module ab_part_count_AB_TON_BASE1_DINT_PRE500 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire DN
);
  reg [8:0] ACC = 9'd0;
  reg DN_reg = 1'b0;
  reg was = 1'b0;

  wire condition = power & was & ~DN_reg & tick;
  wire equal = ACC == 9'd500;
  wire [8:0] sum = ACC + {8'b0, condition & ~equal};
  wire equal_2 = ACC == 9'd499;
  wire DN_next = power & (DN_reg | condition & equal_2 | equal);
  wire [8:0] ACC_next = power ? sum : 9'd0;

  assign DN = DN_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 9'd0;
      DN_reg <= 1'b0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      DN_reg <= DN_next;
      was <= power;
    end
  end
endmodule

// AB_CTU: up counter of Allen-Bradley, SIZE = DINT
// Fitted to PRE = 1000.
// Example, with PRE = 5, ACC = 32766:
// IN        _#_#
// DN        ####
// OV        ____
// ACC-32760 6778
module ab_part_count_AB_CTU_DINT_PRE1000 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire clear_after,
  output wire DN
);
  reg [31:0] ACC = 32'd0;
  reg was_up = 1'b1;

  wire [31:0] sum = ACC + {31'b0, power & ~was_up};
  wire [31:0] ACC_next = clear_after ? 32'd0 : sum;
  wire was_up_next = ~clear_after & power;

  assign DN = $signed(sum) >= 32'sd1000;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 32'd0;
      was_up <= 1'b1;
    end else begin
      ACC <= ACC_next;
      was_up <= was_up_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 500 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module ab_part_count_TON_PT500 (
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

// CTU: up counter
// Fitted to PV = 1000.
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// R   _________##____
// Q   ___######____##
// CV  011222334001122
module ab_part_count_CTU_PV1000 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire R,
  output wire Q
);
  reg [9:0] CV = 10'd0;
  reg was = 1'b0;
  reg CV_is_1000 = 1'b0;

  wire condition = power & ~was & ~CV_is_1000;
  wire [9:0] sum = CV + 10'd1;
  wire [9:0] choice = condition ? sum : CV;
  wire [9:0] CV_next = R ? 10'd0 : choice;
  wire equal = CV == 10'd999;
  wire choice_2 = condition ? equal : CV_is_1000;
  wire CV_is_1000_next = R ? 1'b0 : choice_2;

  assign Q = CV_is_1000_next;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 10'd0;
      was <= 1'b0;
      CV_is_1000 <= 1'b0;
    end else begin
      CV <= CV_next;
      was <= power;
      CV_is_1000 <= CV_is_1000_next;
    end
  end
endmodule

module ab_part_count (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire pump_run,
  input  wire part_present,
  input  wire clear,
  output wire pump_on_for_a_while,
  output wire batch_done,
  output wire siemens_pump,
  output wire siemens_batch
);
  reg pump_on_for_a_while_reg = 1'b0;
  reg batch_done_reg = 1'b0;
  reg siemens_pump_reg = 1'b0;
  reg siemens_batch_reg = 1'b0;

  // rung 1 "Delay_Tmr", ab_part_count.ladder:8
  wire delay_tmr_DN;
  ab_part_count_AB_TON_BASE1_DINT_PRE500 delay_tmr (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pump_run),
    .DN(delay_tmr_DN)
  );

  // rung 2, ab_part_count.ladder:11
  wire pump_on_for_a_while_next = delay_tmr_DN;

  // rung 3 "Part_Count", ab_part_count.ladder:13
  wire part_count_DN;
  ab_part_count_AB_CTU_DINT_PRE1000 part_count (
    .clk(clk),
    .rst(rst),
    .power(part_present),
    .clear_after(clear),
    .DN(part_count_DN)
  );

  // rung 4, ab_part_count.ladder:16
  wire batch_done_next = part_count_DN;

  // rung 5, ab_part_count.ladder:18

  // rung 6 "DB1", ab_part_count.ladder:20
  wire db1_Q;
  ab_part_count_TON_PT500 db1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(pump_run),
    .Q(db1_Q)
  );
  wire siemens_pump_next = db1_Q;

  // rung 7 "DB2", ab_part_count.ladder:23
  wire db2_Q;
  ab_part_count_CTU_PV1000 db2 (
    .clk(clk),
    .rst(rst),
    .power(part_present),
    .R(clear),
    .Q(db2_Q)
  );
  wire siemens_batch_next = db2_Q;

  assign pump_on_for_a_while = pump_on_for_a_while_reg;
  assign batch_done = batch_done_reg;
  assign siemens_pump = siemens_pump_reg;
  assign siemens_batch = siemens_batch_reg;

  always @(posedge clk) begin
    if (rst) begin
      pump_on_for_a_while_reg <= 1'b0;
      batch_done_reg <= 1'b0;
      siemens_pump_reg <= 1'b0;
      siemens_batch_reg <= 1'b0;
    end else begin
      pump_on_for_a_while_reg <= pump_on_for_a_while_next;
      batch_done_reg <= batch_done_next;
      siemens_pump_reg <= siemens_pump_next;
      siemens_batch_reg <= siemens_batch_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
