// Made by hotrail 0.1.0 from paper_counters.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// UC: up counter with enable
// Fitted to PV = 5.
// Example, with PV = 2:
// IN  _#_##_#_#__#_#_
// EN  #########__####
// Q   ___######____##
// ACC 011222334001122
module paper_counters_UC_PV5 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  output wire Q
);
  reg [2:0] ACC = 3'd0;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire equal = ACC == 3'd5;
  wire [2:0] sum = ACC + {2'b0, condition & ~equal};
  wire [2:0] ACC_next = EN ? sum : 3'd0;
  wire equal_2 = ACC == 3'd4;

  assign Q = EN & (condition & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 3'd0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      was <= power;
    end
  end
endmodule

// DC: down counter with enable
// Fitted to PV = 5.
// Example, with PV = 2:
// IN  _#_##_#_#__
// EN  #######__##
// Q   ___####____
// ACC 21100002222
module paper_counters_DC_PV5 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  output wire Q
);
  reg [2:0] ACC = 3'd5;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire equal = ACC == 3'd0;
  wire [2:0] difference = ACC - {2'b0, condition & ~equal};
  wire [2:0] ACC_next = EN ? difference : 3'd5;
  wire equal_2 = ACC == 3'd1;

  assign Q = EN & (condition & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 3'd5;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      was <= power;
    end
  end
endmodule

// DRUM: drum counter, TAPS = [2, 4, 6, 8]
// Fitted to PV = 10.
// Example, with PV = 3, TAPS = [1, 2]:
// IN   _#_#_#_#___
// EN   #########_#
// Q    _____####__
// TAP0 _########__
// TAP1 ___######__
// ACC  01122334400
module paper_counters_DRUM_PV10 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  output wire Q,
  output wire TAP0,
  output wire TAP1,
  output wire TAP2,
  output wire TAP3
);
  reg [3:0] ACC = 4'd0;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire equal = ACC == 4'd10;
  wire [3:0] sum = ACC + {3'b0, condition & ~equal};
  wire [3:0] ACC_next = EN ? sum : 4'd0;
  wire equal_2 = ACC == 4'd9;

  assign Q = EN & (condition & equal_2 | equal);
  assign TAP0 = ACC_next >= 4'd2;
  assign TAP1 = ACC_next >= 4'd4;
  assign TAP2 = ACC_next >= 4'd6;
  assign TAP3 = ACC_next >= 4'd8;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 4'd0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      was <= power;
    end
  end
endmodule

module paper_counters (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire c1,
  input  wire c2,
  input  wire c3,
  input  wire c4,
  input  wire c5,
  input  wire c6,
  input  wire c7,
  input  wire c8,
  input  wire c9,
  input  wire cnt_en_ckt,
  output wire up_coil,
  output wire down_coil,
  output wire drum_coil,
  output wire tap0_out,
  output wire tap1_out,
  output wire tap2_out,
  output wire tap3_out
);
  reg up_coil_reg = 1'b0;
  reg down_coil_reg = 1'b0;
  reg drum_coil_reg = 1'b0;
  reg tap0_out_reg = 1'b0;
  reg tap1_out_reg = 1'b0;
  reg tap2_out_reg = 1'b0;
  reg tap3_out_reg = 1'b0;

  // rung 1 "the paper's Figure 14", paper_counters.ladder:11
  wire rung1_power = c9 | c2 & c3 & c4;
  wire counting_ckt = rung1_power & c1 | (c5 | rung1_power & c6) & (c7 & c8 | c6 & c1);

  // rung 2 "from zero to the preset", paper_counters.ladder:20
  wire up_Q;
  paper_counters_UC_PV5 up (
    .clk(clk),
    .rst(rst),
    .power(counting_ckt),
    .EN(cnt_en_ckt),
    .Q(up_Q)
  );
  wire up_coil_next = up_Q;

  // rung 3 "from the preset to zero", paper_counters.ladder:23
  wire down_Q;
  paper_counters_DC_PV5 down (
    .clk(clk),
    .rst(rst),
    .power(counting_ckt),
    .EN(cnt_en_ckt),
    .Q(down_Q)
  );
  wire down_coil_next = down_Q;

  // rung 4 "up to 2047, with four taps", paper_counters.ladder:26
  wire drum_Q;
  wire drum_TAP0;
  wire drum_TAP1;
  wire drum_TAP2;
  wire drum_TAP3;
  paper_counters_DRUM_PV10 drum (
    .clk(clk),
    .rst(rst),
    .power(counting_ckt),
    .EN(cnt_en_ckt),
    .Q(drum_Q),
    .TAP0(drum_TAP0),
    .TAP1(drum_TAP1),
    .TAP2(drum_TAP2),
    .TAP3(drum_TAP3)
  );
  wire drum_coil_next = drum_Q;

  // rung 5, paper_counters.ladder:29
  wire tap0_out_next = drum_TAP0;

  // rung 6, paper_counters.ladder:31
  wire tap1_out_next = drum_TAP1;

  // rung 7, paper_counters.ladder:33
  wire tap2_out_next = drum_TAP2;

  // rung 8, paper_counters.ladder:35
  wire tap3_out_next = drum_TAP3;

  assign up_coil = up_coil_reg;
  assign down_coil = down_coil_reg;
  assign drum_coil = drum_coil_reg;
  assign tap0_out = tap0_out_reg;
  assign tap1_out = tap1_out_reg;
  assign tap2_out = tap2_out_reg;
  assign tap3_out = tap3_out_reg;

  always @(posedge clk) begin
    if (rst) begin
      up_coil_reg <= 1'b0;
      down_coil_reg <= 1'b0;
      drum_coil_reg <= 1'b0;
      tap0_out_reg <= 1'b0;
      tap1_out_reg <= 1'b0;
      tap2_out_reg <= 1'b0;
      tap3_out_reg <= 1'b0;
    end else begin
      up_coil_reg <= up_coil_next;
      down_coil_reg <= down_coil_next;
      drum_coil_reg <= drum_coil_next;
      tap0_out_reg <= tap0_out_next;
      tap1_out_reg <= tap1_out_next;
      tap2_out_reg <= tap2_out_next;
      tap3_out_reg <= tap3_out_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
