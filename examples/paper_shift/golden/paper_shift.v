// Made by hotrail 0.1.0 from paper_shift.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// SHL: shift register to the left, REG has 48 bits
// Example, with REG = 1, REG0 = 32769:
// IN   #_#_#_#
// DATA __#___#
// EN   ####_##
// Q    ##_____
// REG0 2255001
module paper_shift_SHL_48 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        EN,
  input  wire        DATA,
  input  wire [15:0] REG0_before,
  input  wire [15:0] REG1_before,
  input  wire [15:0] REG2_before,
  output wire        Q,
  output wire [15:0] REG0,
  output wire [15:0] REG1,
  output wire [15:0] REG2
);
  reg Q_reg = 1'b0;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire [15:0] choice = condition ? {REG0_before[14:0], DATA} : REG0_before;
  wire [15:0] REG0_value = EN ? choice : 16'd0;
  wire [15:0] choice_2 = condition ? {REG1_before[14:0], REG0_before[15]} : REG1_before;
  wire [15:0] REG1_value = EN ? choice_2 : 16'd0;
  wire [15:0] choice_3 = condition ? {REG2_before[14:0], REG1_before[15]} : REG2_before;
  wire [15:0] REG2_value = EN ? choice_3 : 16'd0;
  wire choice_4 = condition ? REG2_before[15] : Q_reg;
  wire Q_next = EN ? choice_4 : 1'b0;

  assign Q = Q_next;
  assign REG0 = REG0_value;
  assign REG1 = REG1_value;
  assign REG2 = REG2_value;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      was <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      was <= power;
    end
  end
endmodule

// SHR: shift register to the right, REG has 32 bits
// Example, with REG = 1, REG0 = 3:
// IN   #_#_#
// EN   #####
// Q    ####_
// REG0 11000
module paper_shift_SHR_32 (
  input  wire        clk,
  input  wire        rst,
  input  wire        power,
  input  wire        EN,
  input  wire        DATA,
  input  wire [15:0] REG0_before,
  input  wire [15:0] REG1_before,
  output wire        Q,
  output wire [15:0] REG0,
  output wire [15:0] REG1
);
  reg Q_reg = 1'b0;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire [15:0] choice = condition ? {DATA, REG1_before[15:1]} : REG1_before;
  wire [15:0] REG1_value = EN ? choice : 16'd0;
  wire [15:0] choice_2 = condition ? {REG1_before[0], REG0_before[15:1]} : REG0_before;
  wire [15:0] REG0_value = EN ? choice_2 : 16'd0;
  wire choice_3 = condition ? REG0_before[0] : Q_reg;
  wire Q_next = EN ? choice_3 : 1'b0;

  assign Q = Q_next;
  assign REG0 = REG0_value;
  assign REG1 = REG1_value;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      was <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      was <= power;
    end
  end
endmodule

module paper_shift (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire shift_ckt,
  input  wire shift_en_ckt,
  input  wire serialdata_ckt,
  output wire left_coil,
  output wire right_coil
);
  reg [15:0] actualdata_0 = 16'hffff;
  reg [15:0] actualdata_1 = 16'd3855;
  reg [15:0] actualdata_2 = 16'hf0f0;
  reg [15:0] two_0 = 16'd3855;
  reg [15:0] two_1 = 16'h8001;
  reg left_coil_reg = 1'b0;
  reg right_coil_reg = 1'b0;

  // rung 1 "SL", paper_shift.ladder:10
  wire sl_Q;
  wire [15:0] sl_REG0;
  wire [15:0] sl_REG1;
  wire [15:0] sl_REG2;
  paper_shift_SHL_48 sl (
    .clk(clk),
    .rst(rst),
    .power(shift_ckt),
    .EN(shift_en_ckt),
    .DATA(serialdata_ckt),
    .REG0_before(actualdata_0),
    .REG1_before(actualdata_1),
    .REG2_before(actualdata_2),
    .Q(sl_Q),
    .REG0(sl_REG0),
    .REG1(sl_REG1),
    .REG2(sl_REG2)
  );
  wire left_coil_next = sl_Q;

  // rung 2 "SR", paper_shift.ladder:13
  wire sr_Q;
  wire [15:0] sr_REG0;
  wire [15:0] sr_REG1;
  paper_shift_SHR_32 sr (
    .clk(clk),
    .rst(rst),
    .power(shift_ckt),
    .EN(shift_en_ckt),
    .DATA(serialdata_ckt),
    .REG0_before(two_0),
    .REG1_before(two_1),
    .Q(sr_Q),
    .REG0(sr_REG0),
    .REG1(sr_REG1)
  );
  wire right_coil_next = sr_Q;

  assign left_coil = left_coil_reg;
  assign right_coil = right_coil_reg;

  always @(posedge clk) begin
    if (rst) begin
      actualdata_0 <= 16'hffff;
      actualdata_1 <= 16'd3855;
      actualdata_2 <= 16'hf0f0;
      two_0 <= 16'd3855;
      two_1 <= 16'h8001;
      left_coil_reg <= 1'b0;
      right_coil_reg <= 1'b0;
    end else begin
      actualdata_0 <= sl_REG0;
      actualdata_1 <= sl_REG1;
      actualdata_2 <= sl_REG2;
      two_0 <= sr_REG0;
      two_1 <= sr_REG1;
      left_coil_reg <= left_coil_next;
      right_coil_reg <= right_coil_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
