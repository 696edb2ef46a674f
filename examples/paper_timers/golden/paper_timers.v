// Made by hotrail 0.1.0 from paper_timers.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// DIVIDER: divider of the tick, N = 10 ticks
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module paper_timers_DIVIDER_N10 (
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

// DIVIDER: divider of the tick, N = 1 tick
// Example, with N = 3:
// tick ####_#__##
// IN   ##########
// Q    __#_____#_
// CV   1201122201
module paper_timers_DIVIDER_N1 (
  input  wire tick,
  output wire Q
);

  assign Q = tick;
endmodule

// TS: timer of seconds in three modes, MODE = OFF
// Fitted to PV = 3.
// Example, with PV = 3:
// IN  _##_____#__#_____
// Q   _#####__#######__
// QN  #_____##_______##
// ACC 00001233001001233
module paper_timers_TS_OFF_PV3 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  input  wire unit,
  output wire Q
);
  reg [1:0] ACC = 2'd0;
  reg run = 1'b0;
  reg was = 1'b0;

  wire equal = ACC == 2'd3;
  wire [1:0] sum = ACC + {1'b0, run & unit & ~equal};
  wire condition = run & was;
  wire equal_2 = ACC == 2'd2;
  wire condition_2 = power | run & ~(~power & ~condition & (run & unit & equal_2 | equal));
  wire [1:0] choice = condition ? 2'd0 : sum;
  wire [1:0] ACC_next = power ? 2'd0 : choice;
  wire run_next = EN & condition_2;

  assign Q = EN & condition_2;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 2'd0;
      run <= 1'b0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      run <= run_next;
      was <= power;
    end
  end
endmodule

// TT: timer of tenths of a second in three modes
// Fitted to PV = 5.
// Example, with PV = 3:
// IN  _#######__##__
// EN  ###########_##
// Q   ____#######___
// QN  ####_______###
// ACC 00123333333000
module paper_timers_TT_PV5 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  input  wire unit,
  output wire Q
);
  reg [2:0] ACC = 3'd0;
  reg ran = 1'b0;

  wire ran_next = power & EN;
  wire equal = ACC == 3'd5;
  wire [2:0] sum = ACC + {2'b0, ran_next & ran & unit & ~equal};
  wire [2:0] ACC_next = EN ? sum : 3'd0;
  wire equal_2 = ACC == 3'd4;

  assign Q = EN & (ran_next & ran & unit & equal_2 | equal);

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

// TT: timer of tenths of a second in three modes, MODE = INTERVAL
// Fitted to PV = 4.
// Example, with PV = 3:
// IN  _#####_#_#__
// Q   _###___###__
// QN  #___###___##
// ACC 001233001200
module paper_timers_TT_INTERVAL_PV4 (
  input  wire clk,
  input  wire rst,
  input  wire power,
  input  wire EN,
  input  wire unit,
  output wire Q
);
  reg [2:0] ACC = 3'd0;
  reg run = 1'b0;
  reg was = 1'b0;

  wire [2:0] sum = ACC + {2'b0, unit};
  wire equal = ACC == 3'd3;
  wire choice = run ? ~(unit & equal) : power & ~was;
  wire [2:0] ACC_next = run ? sum : 3'd0;
  wire run_next = EN & choice;

  assign Q = EN & choice;

  always @(posedge clk) begin
    if (rst) begin
      ACC <= 3'd0;
      run <= 1'b0;
      was <= 1'b0;
    end else begin
      ACC <= ACC_next;
      run <= run_next;
      was <= power;
    end
  end
endmodule

module paper_timers (
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
  input  wire enable_ckt,
  output wire timer_off_coil,
  output wire timer_on_coil,
  output wire timer_interval_coil
);
  reg timer_off_coil_reg = 1'b0;
  reg timer_on_coil_reg = 1'b0;
  reg timer_interval_coil_reg = 1'b0;

  // units of time, each a pulse that all blocks share
  wire every_1s_Q;
  paper_timers_DIVIDER_N10 every_1s (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .Q(every_1s_Q)
  );
  wire every_100ms_Q;
  paper_timers_DIVIDER_N1 every_100ms (
    .tick(tick),
    .Q(every_100ms_Q)
  );

  // rung 1 "the paper's Figure 14", paper_timers.ladder:11
  wire rung1_power = c9 | c2 & c3 & c4;
  wire timing_ckt = rung1_power & c1 | (c5 | rung1_power & c6) & (c7 & c8 | c6 & c1);

  // rung 2 "timer_type 00: off-delay, 3 s", paper_timers.ladder:20
  wire actual_ts_Q;
  paper_timers_TS_OFF_PV3 actual_ts (
    .clk(clk),
    .rst(rst),
    .power(timing_ckt),
    .EN(enable_ckt),
    .unit(every_1s_Q),
    .Q(actual_ts_Q)
  );
  wire timer_off_coil_next = actual_ts_Q;

  // rung 3 "timer_type 01: on-delay, 5 tenths", paper_timers.ladder:23
  wire actual_tt_Q;
  paper_timers_TT_PV5 actual_tt (
    .clk(clk),
    .rst(rst),
    .power(timing_ckt),
    .EN(enable_ckt),
    .unit(every_100ms_Q),
    .Q(actual_tt_Q)
  );
  wire timer_on_coil_next = actual_tt_Q;

  // rung 4 "timer_type 1x: interval-delay, 4 tenths", paper_timers.ladder:26
  wire interval_tt_Q;
  paper_timers_TT_INTERVAL_PV4 interval_tt (
    .clk(clk),
    .rst(rst),
    .power(timing_ckt),
    .EN(enable_ckt),
    .unit(every_100ms_Q),
    .Q(interval_tt_Q)
  );
  wire timer_interval_coil_next = interval_tt_Q;

  assign timer_off_coil = timer_off_coil_reg;
  assign timer_on_coil = timer_on_coil_reg;
  assign timer_interval_coil = timer_interval_coil_reg;

  always @(posedge clk) begin
    if (rst) begin
      timer_off_coil_reg <= 1'b0;
      timer_on_coil_reg <= 1'b0;
      timer_interval_coil_reg <= 1'b0;
    end else begin
      timer_off_coil_reg <= timer_off_coil_next;
      timer_on_coil_reg <= timer_on_coil_next;
      timer_interval_coil_reg <= timer_interval_coil_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
