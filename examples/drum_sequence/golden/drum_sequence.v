// Made by hotrail 0.1.0 from drum_sequence.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// DIVIDER: divider of the tick, N = 1 tick
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module drum_sequence_DIVIDER_N1 (
  input  wire tick,
  output wire Q
);

  assign Q = tick;
endmodule

// DRUM: drum counter, TAPS = [1, 3, 5, 9]
// Fitted to PV = 12.
// Example, with PV = 3, TAPS = [1, 2]:
// IN   _#_#_#_#___
// EN   #########_#
// Q    _____####__
// TAP0 _########__
// TAP1 ___######__
// ACC  01122334400
module drum_sequence_DRUM_PV12 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  output wire Q_last,
  output wire TAP0,
  output wire TAP1,
  output wire TAP2,
  output wire TAP3
);
  reg Q = 1'b0;
  reg [3:0] ACC = 4'd0;
  reg was = 1'b0;

  wire condition = power & ~was;
  wire equal = ACC == 4'd12;
  wire [3:0] sum = ACC + {3'b0, condition & ~equal};
  wire [3:0] ACC_next = EN ? sum : 4'd0;
  wire equal_2 = ACC == 4'd11;
  wire Q_next = EN & (condition & equal_2 | equal);
  wire equal_3 = ACC == 4'd0;

  assign Q_last = Q;
  assign TAP0 = ~(~EN | ~condition & equal_3);
  assign TAP1 = ACC_next >= 4'd3;
  assign TAP2 = ACC_next >= 4'd5;
  assign TAP3 = ACC_next >= 4'd9;

  always @(posedge clk) begin
    if (rst) begin
      Q <= 1'b0;
      ACC <= 4'd0;
      was <= 1'b0;
    end else begin
      Q <= Q_next;
      ACC <= ACC_next;
      was <= power;
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
module drum_sequence_T0_1_PV10 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  input  wire unit,
  output wire Q,
  output wire Q_last
);
  reg Q_reg = 1'b0;
  reg [3:0] ACC = 4'd0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire equal = ACC == 4'd10;
  wire [3:0] sum = ACC + {3'b0, ran_next & ran & unit & ~equal};
  wire [3:0] ACC_next = EN ? sum : 4'd0;
  wire equal_2 = ACC == 4'd9;
  wire Q_next = EN & (ran_next & ran & unit & equal_2 | equal);

  assign Q = Q_next;
  assign Q_last = Q_reg;

  always @(posedge clk) begin
    if (rst) begin
      Q_reg <= 1'b0;
      ACC <= 4'd0;
      ran <= 1'b0;
    end else begin
      Q_reg <= Q_next;
      ACC <= ACC_next;
      ran <= ran_next;
    end
  end
endmodule

module drum_sequence (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire start,
  input  wire stop,
  output wire water,
  output wire heater,
  output wire motor,
  output wire pump,
  output wire running
);
  reg running_reg = 1'b0;
  reg water_reg = 1'b0;
  reg heater_reg = 1'b0;
  reg motor_reg = 1'b0;
  reg pump_reg = 1'b0;

  // units of time, each a pulse that all blocks share
  wire every_100ms_Q;
  drum_sequence_DIVIDER_N1 every_100ms (
    .tick(tick),
    .Q(every_100ms_Q)
  );

  // rung 1 "from start to the end of the programme", drum_sequence.ladder:9
  wire drum_Q_last;
  wire drum_TAP0;
  wire drum_TAP1;
  wire drum_TAP2;
  wire drum_TAP3;
  wire running_next = (start | running_reg) & ~stop & ~drum_Q_last;

  // rung 2 "a step each second", drum_sequence.ladder:12
  wire second_Q;
  wire second_Q_last;
  wire second_power = running_next & ~second_Q_last;
  wire second_EN = running_next & ~second_Q_last;
  drum_sequence_T0_1_PV10 second (
    .clk(clk),
    .rst(rst),
    .power(second_power),
    .EN(second_EN),
    .unit(every_100ms_Q),
    .Q(second_Q),
    .Q_last(second_Q_last)
  );
  drum_sequence_DRUM_PV12 drum (
    .clk(clk),
    .rst(rst),
    .power(second_Q),
    .EN(running_next),
    .Q_last(drum_Q_last),
    .TAP0(drum_TAP0),
    .TAP1(drum_TAP1),
    .TAP2(drum_TAP2),
    .TAP3(drum_TAP3)
  );

  // rung 3 "the steps, counted from the start", drum_sequence.ladder:15

  // rung 4 "water from step 1 to 3", drum_sequence.ladder:18
  wire water_next = drum_TAP0 & ~drum_TAP1;

  // rung 5 "heat from step 3 to 5", drum_sequence.ladder:21
  wire heater_next = drum_TAP1 & ~drum_TAP2;

  // rung 6 "turn from step 3 to 9", drum_sequence.ladder:24
  wire motor_next = drum_TAP1 & ~drum_TAP3;

  // rung 7 "pump off from step 9 to the end", drum_sequence.ladder:27
  wire pump_next = drum_TAP3 & running_next;

  assign water = water_reg;
  assign heater = heater_reg;
  assign motor = motor_reg;
  assign pump = pump_reg;
  assign running = running_reg;

  always @(posedge clk) begin
    if (rst) begin
      running_reg <= 1'b0;
      water_reg <= 1'b0;
      heater_reg <= 1'b0;
      motor_reg <= 1'b0;
      pump_reg <= 1'b0;
    end else begin
      running_reg <= running_next;
      water_reg <= water_next;
      heater_reg <= heater_next;
      motor_reg <= motor_next;
      pump_reg <= pump_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
