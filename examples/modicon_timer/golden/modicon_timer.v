// Made by hotrail 0.1.0 from modicon_timer.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// DIVIDER: divider of the tick, N = 100 ticks
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module modicon_timer_DIVIDER_N100 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  output wire Q
);
  reg [6:0] CV = 7'd0;

  wire equal = CV == 7'd99;
  wire Q_value = tick & equal;
  wire [6:0] sum = CV + {6'b0, tick};
  wire [6:0] CV_next = Q_value ? 7'd0 : sum;

  assign Q = Q_value;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 7'd0;
    end else begin
      CV <= CV_next;
    end
  end
endmodule

// DIVIDER: divider of the tick, N = 10 ticks
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module modicon_timer_DIVIDER_N10 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  output wire Q
);
  reg [3:0] CV = 4'd0;

  wire equal = CV == 4'd9;
  wire Q_value = tick & equal;
  wire [3:0] sum = CV + {3'b0, tick};
  wire [3:0] CV_next = Q_value ? 4'd0 : sum;

  assign Q = Q_value;

  always @(posedge clk) begin
    if (rst) begin
      CV <= 4'd0;
    end else begin
      CV <= CV_next;
    end
  end
endmodule

// T1_0: timer of seconds
// Fitted to PV = 5.
// Example, with PV = 3:
// IN  _#######__##__
// EN  ###########_##
// Q   ____#######___
// QN  ####_______###
// ACC 00123333333000
module modicon_timer_T1_0_PV5 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  input  wire unit,
  output wire Q,
  output wire QN
);
  reg [2:0] ACC = 3'd0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire equal = ACC == 3'd5;
  wire [2:0] sum = ACC + {2'b0, ran_next & ran & unit & ~equal};
  wire [2:0] ACC_next = EN ? sum : 3'd0;
  wire equal_2 = ACC == 3'd4;
  wire Q_value = EN & (ran_next & ran & unit & equal_2 | equal);

  assign Q = Q_value;
  assign QN = ~Q_value;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 3'd0;
      ran <= 1'b0;
    end else begin
      ACC <= ACC_next;
      ran <= ran_next;
    end
  end
endmodule

// T1_0: timer of seconds
// Fitted to PV = 1.
// Example, with PV = 3:
// IN  _#######__##__
// EN  ###########_##
// Q   ____#######___
// QN  ####_______###
// ACC 00123333333000
module modicon_timer_T1_0_PV1 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  input  wire unit,
  output wire Q
);
  reg ACC = 1'b0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire ACC_next = EN & (ACC ^ ran_next & ran & unit & ~ACC);

  assign Q = ACC_next;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 1'b0;
      ran <= 1'b0;
    end else begin
      ACC <= ACC_next;
      ran <= ran_next;
    end
  end
endmodule

// T0_1: timer of tenths of a second
// Fitted to PV = 10.
// Example, with PV = 3:
// IN  _#######__##__
// EN  ###########_##
// Q   ____#######___
// QN  ####_______###
// ACC 00123333333000
module modicon_timer_T0_1_PV10 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  input  wire unit,
  output wire Q
);
  reg [3:0] ACC = 4'd0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire equal = ACC == 4'd10;
  wire [3:0] sum = ACC + {3'b0, ran_next & ran & unit & ~equal};
  wire [3:0] ACC_next = EN ? sum : 4'd0;
  wire equal_2 = ACC == 4'd9;

  assign Q = EN & (ran_next & ran & unit & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 4'd0;
      ran <= 1'b0;
    end else begin
      ACC <= ACC_next;
      ran <= ran_next;
    end
  end
endmodule

module modicon_timer (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire in_10001,
  input  wire in_10002,
  output wire coil_00107,
  output wire coil_00108,
  output wire cascade_tenths,
  output wire cascade_seconds
);
  reg coil_00107_reg = 1'b0;
  reg coil_00108_reg = 1'b0;
  reg cascade_tenths_reg = 1'b0;
  reg cascade_seconds_reg = 1'b0;

  // units of time, each a pulse that all blocks share
  wire every_1s_Q;
  modicon_timer_DIVIDER_N100 every_1s (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .Q(every_1s_Q)
  );
  wire every_100ms_Q;
  modicon_timer_DIVIDER_N10 every_100ms (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .Q(every_100ms_Q)
  );

  // rung 1 "T1.0 with a preset of 5; its time is in 40040", modicon_timer.ladder:10
  wire t40040_Q;
  wire t40040_QN;
  modicon_timer_T1_0_PV5 t40040 (
    .clk(clk),
    .rst(rst),
    .power(in_10001),
    .EN(in_10002),
    .unit(every_1s_Q),
    .Q(t40040_Q),
    .QN(t40040_QN)
  );
  wire coil_00107_next = t40040_Q;

  // rung 2, modicon_timer.ladder:13
  wire coil_00108_next = t40040_QN;

  // rung 3 "two seconds of two timers with presets of 1", modicon_timer.ladder:15
  wire s1_Q;
  modicon_timer_T1_0_PV1 s1 (
    .clk(clk),
    .rst(rst),
    .power(in_10001),
    .EN(in_10002),
    .unit(every_1s_Q),
    .Q(s1_Q)
  );
  wire s2_Q;
  modicon_timer_T1_0_PV1 s2 (
    .clk(clk),
    .rst(rst),
    .power(s1_Q),
    .EN(in_10002),
    .unit(every_1s_Q),
    .Q(s2_Q)
  );
  wire cascade_seconds_next = s2_Q;

  // rung 4 "and of two with presets of 10, as the manual advises", modicon_timer.ladder:18
  wire d1_Q;
  modicon_timer_T0_1_PV10 d1 (
    .clk(clk),
    .rst(rst),
    .power(in_10001),
    .EN(in_10002),
    .unit(every_100ms_Q),
    .Q(d1_Q)
  );
  wire d2_Q;
  modicon_timer_T0_1_PV10 d2 (
    .clk(clk),
    .rst(rst),
    .power(d1_Q),
    .EN(in_10002),
    .unit(every_100ms_Q),
    .Q(d2_Q)
  );
  wire cascade_tenths_next = d2_Q;

  assign coil_00107 = coil_00107_reg;
  assign coil_00108 = coil_00108_reg;
  assign cascade_tenths = cascade_tenths_reg;
  assign cascade_seconds = cascade_seconds_reg;

  always @(posedge clk) begin
    if (rst) begin
      coil_00107_reg <= 1'b0;
      coil_00108_reg <= 1'b0;
      cascade_tenths_reg <= 1'b0;
      cascade_seconds_reg <= 1'b0;
    end else begin
      coil_00107_reg <= coil_00107_next;
      coil_00108_reg <= coil_00108_next;
      cascade_tenths_reg <= cascade_tenths_next;
      cascade_seconds_reg <= cascade_seconds_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
