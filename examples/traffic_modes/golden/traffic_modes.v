// Made by hotrail 0.1.0 from traffic_modes.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to power = 1.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_modes_TON_power1 (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire [31:0] PT,
  input  wire        clear_after,
  output wire        Q,
  output wire [31:0] ET
);
  reg [31:0] ET_reg = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET_reg) < $signed(PT);
  wire [31:0] sum = ET_reg + {31'b0, tick & less};
  wire [31:0] ET_value = was ? sum : 32'd0;
  wire [31:0] ET_next = clear_after ? 32'd0 : ET_value;

  assign Q = $signed(ET_value) >= $signed(PT);
  assign ET = ET_value;

  always @(posedge clk) begin
    if (rst) begin
      ET_reg <= 32'd0;
      was <= 1'b0;
    end else begin
      ET_reg <= ET_next;
      was <= 1'b1;
    end
  end
endmodule

module traffic_modes (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire rush_hour,
  input  wire late_night,
  output wire ns_green,
  output wire ns_yellow,
  output wire ns_red,
  output wire turn_green,
  output wire turn_yellow,
  output wire turn_red,
  output wire ew_green,
  output wire ew_yellow,
  output wire ew_red
);
  reg [15:0] interval = 16'd9;
  reg [6:0] timer_PT = 7'd0;
  reg interval_is_2 = 1'b0;
  reg interval_is_5 = 1'b0;
  reg ew_yellow_reg = 1'b0;
  reg interval_is_10 = 1'b0;
  reg ns_green_reg = 1'b0;
  reg turn_green_reg = 1'b0;
  reg ew_green_reg = 1'b0;
  reg ns_yellow_reg = 1'b0;
  reg ns_red_reg = 1'b1;
  reg turn_yellow_reg = 1'b0;
  reg turn_red_reg = 1'b1;
  reg ew_red_reg = 1'b1;

  // rung 1 "how long the interval lasts", traffic_modes.ladder:28
  wire rung1_equal = interval == 16'd3;
  wire rung1_equal_2 = interval == 16'd6;
  wire rung1_equal_3 = interval == 16'd9;
  wire [6:0] timer_PT_rung1 = (rung1_equal | rung1_equal_2 | rung1_equal_3) ? 7'd10 : timer_PT;

  // rung 2, traffic_modes.ladder:31
  wire [6:0] timer_PT_rung2 =
      (interval_is_2 | interval_is_5 | ew_yellow_reg) ? 7'd30 : timer_PT_rung1;

  // rung 3, traffic_modes.ladder:34
  wire [6:0] timer_PT_rung3 = interval_is_10 ? 7'd10 : timer_PT_rung2;

  // rung 4, traffic_modes.ladder:35
  wire [6:0] timer_PT_rung4 = ns_green_reg ? 7'd120 : timer_PT_rung3;

  // rung 5, traffic_modes.ladder:36
  wire [6:0] timer_PT_rung5 = turn_green_reg ? 7'd60 : timer_PT_rung4;

  // rung 6, traffic_modes.ladder:37
  wire [6:0] timer_PT_next = ew_green_reg ? 7'd100 : timer_PT_rung5;
  wire [31:0] timer_PT_2 = {25'b0, timer_PT_next};

  // rung 7 "which one comes next", traffic_modes.ladder:39
  wire [15:0] next_rung7 = interval + 16'd1;

  // rung 8, traffic_modes.ladder:41
  wire rung8_power = rung1_equal & rush_hour;
  wire [15:0] next_rung8 = rung8_power ? 16'd7 : next_rung7;

  // rung 9, traffic_modes.ladder:42
  wire rung9_power = rung1_equal_3 & ~late_night;
  wire [15:0] next_rung9 = rung9_power ? 16'd1 : next_rung8;

  // rung 10, traffic_modes.ladder:43
  wire rung10_power = interval_is_10 & late_night;
  wire [15:0] next_rung10 = rung10_power ? 16'd10 : next_rung9;
  wire rung10_power_2 = interval_is_10 & ~late_night;
  wire [15:0] next_u = rung10_power_2 ? 16'd9 : next_rung10;

  // rung 11 "on to it", traffic_modes.ladder:45
  wire timer_Q;
  wire [31:0] timer_ET;
  traffic_modes_TON_power1 timer (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .PT(timer_PT_2),
    .clear_after(timer_Q),
    .Q(timer_Q),
    .ET(timer_ET)
  );
  wire [31:0] rung11_choice = timer_Q ? 32'd0 : timer_ET;
  wire [15:0] interval_next = timer_Q ? next_u : interval;

  // rung 12 "blink for half a second in each second", traffic_modes.ladder:48
  wire rung12_choice =
      timer_Q ? ~rung10_power_2 & (rung10_power | ~rung9_power & ~rung8_power & rung1_equal_3)
      : interval_is_10;
  wire rung12_less = $signed(rung11_choice) < 32'sd5;
  wire blink = rung12_choice & rung12_less;

  // rung 13 "north-south, straight on", traffic_modes.ladder:51
  wire rung13_equal = interval == 16'd0;
  wire ns_green_next =
      timer_Q ? ~rung10_power_2 & ~rung10_power & (rung9_power | ~rung8_power & rung13_equal)
      : ns_green_reg;

  // rung 14, traffic_modes.ladder:53
  wire interval_is_2_next =
      timer_Q ? ~rung10_power_2 & ~rung10_power & ~rung9_power & ~rung8_power & ns_green_reg
      : interval_is_2;
  wire ns_yellow_next = blink ? 1'b1 : interval_is_2_next;

  // rung 15, traffic_modes.ladder:54
  wire rung15_choice =
      timer_Q ? ~rung10_power_2 & (rung10_power | ~rung9_power & ~rung8_power & rung1_equal_3)
      : interval_is_10;
  wire ns_red_next = ~rung15_choice & ~ns_green_next & ~ns_yellow_next;

  // rung 16 "north-south, turning", traffic_modes.ladder:56
  wire turn_green_next =
      timer_Q ? ~rung10_power_2 & ~rung10_power & ~rung9_power & ~rung8_power & rung1_equal
      : turn_green_reg;

  // rung 17, traffic_modes.ladder:58
  wire interval_is_5_next =
      timer_Q ? ~rung10_power_2 & ~rung10_power & ~rung9_power & ~rung8_power & turn_green_reg
      : interval_is_5;
  wire turn_yellow_next = blink ? 1'b1 : interval_is_5_next;

  // rung 18, traffic_modes.ladder:59
  wire rung18_choice =
      timer_Q ? ~rung10_power_2 & (rung10_power | ~rung9_power & ~rung8_power & rung1_equal_3)
      : interval_is_10;
  wire turn_red_next = ~rung18_choice & ~turn_green_next & ~turn_yellow_next;

  // rung 19 "east-west", traffic_modes.ladder:61
  wire ew_green_next =
      timer_Q ? ~rung10_power_2 & ~rung10_power & ~rung9_power & (rung8_power | rung1_equal_2)
      : ew_green_reg;

  // rung 20, traffic_modes.ladder:63
  wire ew_yellow_next =
      timer_Q ? ~rung10_power_2 & ~rung10_power & ~rung9_power & ~rung8_power & ew_green_reg
      : ew_yellow_reg;

  // rung 21, traffic_modes.ladder:64
  wire interval_is_10_next =
      timer_Q ? ~rung10_power_2 & (rung10_power | ~rung9_power & ~rung8_power & rung1_equal_3)
      : interval_is_10;
  wire ew_red_next = blink ? 1'b1 : ~interval_is_10_next & ~ew_green_next & ~ew_yellow_next;

  assign ns_green = ns_green_reg;
  assign ns_yellow = ns_yellow_reg;
  assign ns_red = ns_red_reg;
  assign turn_green = turn_green_reg;
  assign turn_yellow = turn_yellow_reg;
  assign turn_red = turn_red_reg;
  assign ew_green = ew_green_reg;
  assign ew_yellow = ew_yellow_reg;
  assign ew_red = ew_red_reg;

  always @(posedge clk) begin
    if (rst) begin
      interval <= 16'd9;
      timer_PT <= 7'd0;
      interval_is_2 <= 1'b0;
      interval_is_5 <= 1'b0;
      ew_yellow_reg <= 1'b0;
      interval_is_10 <= 1'b0;
      ns_green_reg <= 1'b0;
      turn_green_reg <= 1'b0;
      ew_green_reg <= 1'b0;
      ns_yellow_reg <= 1'b0;
      ns_red_reg <= 1'b1;
      turn_yellow_reg <= 1'b0;
      turn_red_reg <= 1'b1;
      ew_red_reg <= 1'b1;
    end else begin
      interval <= interval_next;
      timer_PT <= timer_PT_next;
      interval_is_2 <= interval_is_2_next;
      interval_is_5 <= interval_is_5_next;
      ew_yellow_reg <= ew_yellow_next;
      interval_is_10 <= interval_is_10_next;
      ns_green_reg <= ns_green_next;
      turn_green_reg <= turn_green_next;
      ew_green_reg <= ew_green_next;
      ns_yellow_reg <= ns_yellow_next;
      ns_red_reg <= ns_red_next;
      turn_yellow_reg <= turn_yellow_next;
      turn_red_reg <= turn_red_next;
      ew_red_reg <= ew_red_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
