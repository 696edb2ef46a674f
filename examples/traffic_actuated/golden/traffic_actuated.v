// Made by hotrail 0.1.0 from traffic_actuated.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to PT = 20 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_actuated_TON_PT20 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;
  reg ET_is_20 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_20;
  wire [4:0] sum = ET + 5'd1;
  wire [4:0] choice = condition_2 ? sum : ET;
  wire [4:0] ET_next = condition ? choice : 5'd0;
  wire equal = ET == 5'd19;
  wire choice_2 = condition_2 ? equal : ET_is_20;
  wire ET_is_20_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_20_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      was <= 1'b0;
      ET_is_20 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_20 <= ET_is_20_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to power = 1.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_actuated_TON_power1 (
  input  wire        clk,
  input  wire        rst,
  input  wire        tick,
  input  wire [31:0] PT,
  input  wire        clear_after,
  output wire        Q
);
  reg [31:0] ET = 32'd0;
  reg was = 1'b0;

  wire less = $signed(ET) < $signed(PT);
  wire [31:0] sum = ET + {31'b0, tick & less};
  wire [31:0] choice = was ? sum : 32'd0;
  wire [31:0] ET_next = clear_after ? 32'd0 : choice;

  assign Q = $signed(choice) >= $signed(PT);

  always @(posedge clk) begin
    if (rst) begin
      ET <= 32'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= 1'b1;
    end
  end
endmodule

module traffic_actuated (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire walk_button,
  input  wire far_loop,
  input  wire near_loop,
  output wire ns_green,
  output wire ns_yellow,
  output wire ns_red,
  output wire turn_green,
  output wire turn_yellow,
  output wire turn_red,
  output wire ew_green,
  output wire ew_yellow,
  output wire ew_red,
  output wire walk,
  output wire walk_soon
);
  reg [3:0] interval = 4'd9;
  reg walk_soon_reg = 1'b0;
  reg turn_called = 1'b0;
  reg far_loop_before = 1'b0;
  reg on_the_way = 1'b0;
  reg near_loop_before = 1'b0;
  reg backed_up = 1'b0;
  reg [6:0] timer_PT = 7'd0;
  reg ns_green_reg = 1'b0;
  reg ns_yellow_reg = 1'b0;
  reg ns_red_reg = 1'b1;
  reg turn_green_reg = 1'b0;
  reg turn_yellow_reg = 1'b0;
  reg turn_red_reg = 1'b1;
  reg ew_green_reg = 1'b0;
  reg ew_yellow_reg = 1'b0;
  reg ew_red_reg = 1'b1;
  reg walk_reg = 1'b0;

  // rung 1 "a pedestrian waits", traffic_actuated.ladder:34
  wire rung1_equal = interval == 4'd10;
  wire walk_soon_rung1 = walk_button & ~rung1_equal | walk_soon_reg;

  // rung 2 "a car waits in the turn lane", traffic_actuated.ladder:37
  wire rung2_equal = interval == 4'd4;
  wire turn_called_rung2 = (far_loop | near_loop) & ~rung2_equal | turn_called;

  // rung 3 "a car that needs two seconds from loop to loop stands in a queue", traffic_actuated.ladder:40
  wire on_the_way_rung3 = far_loop & ~far_loop_before | on_the_way;

  // rung 4, traffic_actuated.ladder:42
  wire slow_Q;
  traffic_actuated_TON_PT20 slow (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(on_the_way_rung3),
    .Q(slow_Q)
  );

  // rung 5, traffic_actuated.ladder:43
  wire rung5_power = near_loop & ~near_loop_before;
  wire on_the_way_next = on_the_way_rung3 & ~rung5_power;
  wire backed_up_rung5 = rung5_power & on_the_way_rung3 & slow_Q | backed_up;

  // rung 6 "how long the interval lasts", traffic_actuated.ladder:45
  wire rung6_equal = interval == 4'd3;
  wire rung6_equal_2 = interval == 4'd6;
  wire rung6_equal_3 = interval == 4'd9;
  wire [6:0] timer_PT_rung6 = (rung6_equal | rung6_equal_2 | rung6_equal_3) ? 7'd10 : timer_PT;

  // rung 7, traffic_actuated.ladder:48
  wire rung7_equal = interval == 4'd2;
  wire rung7_equal_2 = interval == 4'd5;
  wire rung7_equal_3 = interval == 4'd8;
  wire rung7_equal_4 = interval == 4'd11;
  wire [6:0] timer_PT_rung7 =
      (rung7_equal | rung7_equal_2 | rung7_equal_3 | rung7_equal_4) ? 7'd30 : timer_PT_rung6;

  // rung 8, traffic_actuated.ladder:54
  wire rung8_equal = interval == 4'd1;
  wire [6:0] timer_PT_rung8 = rung8_equal ? 7'd120 : timer_PT_rung7;

  // rung 9, traffic_actuated.ladder:55
  wire [6:0] timer_PT_rung9 = (rung2_equal & ~backed_up_rung5) ? 7'd60 : timer_PT_rung8;
  wire [6:0] timer_PT_rung9_2 = (rung2_equal & backed_up_rung5) ? 7'd120 : timer_PT_rung9;

  // rung 10, traffic_actuated.ladder:56
  wire rung10_equal = interval == 4'd7;
  wire [6:0] timer_PT_rung10 = rung10_equal ? 7'd100 : timer_PT_rung9_2;

  // rung 11, traffic_actuated.ladder:57
  wire [6:0] timer_PT_next = rung1_equal ? 7'd80 : timer_PT_rung10;
  wire [31:0] timer_PT_2 = {25'b0, timer_PT_next};

  // rung 12 "which one comes next", traffic_actuated.ladder:59
  wire [3:0] next_rung12 = interval + 4'd1;

  // rung 13, traffic_actuated.ladder:61
  wire rung13_power = rung6_equal & ~turn_called_rung2;
  wire [3:0] next_rung13 = rung13_power ? 4'd7 : next_rung12;

  // rung 14, traffic_actuated.ladder:62
  wire rung14_power = rung6_equal_3 & walk_soon_rung1;
  wire [3:0] next_rung14 = rung14_power ? 4'd10 : next_rung13;
  wire rung14_power_2 = rung6_equal_3 & ~walk_soon_rung1;
  wire [3:0] next_rung14_2 = rung14_power_2 ? 4'd1 : next_rung14;

  // rung 15, traffic_actuated.ladder:63
  wire [3:0] next_u = rung7_equal_4 ? 4'd1 : next_rung14_2;

  // rung 16 "on to it", traffic_actuated.ladder:65
  wire timer_Q;
  traffic_actuated_TON_power1 timer (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .PT(timer_PT_2),
    .clear_after(timer_Q),
    .Q(timer_Q)
  );
  wire [3:0] interval_next = timer_Q ? next_u : interval;

  // rung 17 "who is served waits no more", traffic_actuated.ladder:68
  wire rung17_choice =
      timer_Q ? ~rung7_equal_4 & ~rung14_power_2 & (rung14_power | ~rung13_power & rung6_equal_3)
      : rung1_equal;
  wire walk_soon_next = walk_soon_rung1 & ~rung17_choice;

  // rung 18, traffic_actuated.ladder:70
  wire rung18_choice =
      timer_Q ? ~rung7_equal_4 & ~rung14_power_2 & ~rung14_power & ~rung13_power & rung6_equal
      : rung2_equal;
  wire turn_called_next = turn_called_rung2 & ~rung18_choice;

  // rung 19, traffic_actuated.ladder:71
  wire rung19_choice =
      timer_Q ? ~rung7_equal_4 & ~rung14_power_2 & ~rung14_power & ~rung13_power & rung2_equal
      : rung7_equal_2;
  wire backed_up_next = backed_up_rung5 & ~rung19_choice;

  // rung 20 "north-south, straight on", traffic_actuated.ladder:73
  wire rung20_equal = interval == 4'd0;
  wire ns_green_next =
      timer_Q ? rung7_equal_4 | rung14_power_2 | ~rung14_power & ~rung13_power & rung20_equal
      : rung8_equal;

  // rung 21, traffic_actuated.ladder:75
  wire ns_yellow_next =
      timer_Q ? ~rung7_equal_4 & ~rung14_power_2 & ~rung14_power & ~rung13_power & rung8_equal
      : rung7_equal;

  // rung 22, traffic_actuated.ladder:76
  wire ns_red_next = ~ns_green_next & ~ns_yellow_next;

  // rung 23 "north-south, turning", traffic_actuated.ladder:78
  wire turn_green_next =
      timer_Q ? ~rung7_equal_4 & ~rung14_power_2 & ~rung14_power & ~rung13_power & rung6_equal
      : rung2_equal;

  // rung 24, traffic_actuated.ladder:80
  wire turn_yellow_next =
      timer_Q ? ~rung7_equal_4 & ~rung14_power_2 & ~rung14_power & ~rung13_power & rung2_equal
      : rung7_equal_2;

  // rung 25, traffic_actuated.ladder:81
  wire turn_red_next = ~turn_green_next & ~turn_yellow_next;

  // rung 26 "east-west", traffic_actuated.ladder:83
  wire ew_green_next =
      timer_Q ? ~rung7_equal_4 & ~rung14_power_2 & ~rung14_power & (rung13_power | rung6_equal_2)
      : rung10_equal;

  // rung 27, traffic_actuated.ladder:85
  wire ew_yellow_next =
      timer_Q ? ~rung7_equal_4 & ~rung14_power_2 & ~rung14_power & ~rung13_power & rung10_equal
      : rung7_equal_3;

  // rung 28, traffic_actuated.ladder:86
  wire ew_red_next = ~ew_green_next & ~ew_yellow_next;

  // rung 29 "pedestrians", traffic_actuated.ladder:88
  wire walk_next =
      timer_Q ? ~rung7_equal_4 & ~rung14_power_2 & (rung14_power | ~rung13_power & rung6_equal_3)
      : rung1_equal;

  assign ns_green = ns_green_reg;
  assign ns_yellow = ns_yellow_reg;
  assign ns_red = ns_red_reg;
  assign turn_green = turn_green_reg;
  assign turn_yellow = turn_yellow_reg;
  assign turn_red = turn_red_reg;
  assign ew_green = ew_green_reg;
  assign ew_yellow = ew_yellow_reg;
  assign ew_red = ew_red_reg;
  assign walk = walk_reg;
  assign walk_soon = walk_soon_reg;

  always @(posedge clk) begin
    if (rst) begin
      interval <= 4'd9;
      walk_soon_reg <= 1'b0;
      turn_called <= 1'b0;
      far_loop_before <= 1'b0;
      on_the_way <= 1'b0;
      near_loop_before <= 1'b0;
      backed_up <= 1'b0;
      timer_PT <= 7'd0;
      ns_green_reg <= 1'b0;
      ns_yellow_reg <= 1'b0;
      ns_red_reg <= 1'b1;
      turn_green_reg <= 1'b0;
      turn_yellow_reg <= 1'b0;
      turn_red_reg <= 1'b1;
      ew_green_reg <= 1'b0;
      ew_yellow_reg <= 1'b0;
      ew_red_reg <= 1'b1;
      walk_reg <= 1'b0;
    end else begin
      interval <= interval_next;
      walk_soon_reg <= walk_soon_next;
      turn_called <= turn_called_next;
      far_loop_before <= far_loop;
      on_the_way <= on_the_way_next;
      near_loop_before <= near_loop;
      backed_up <= backed_up_next;
      timer_PT <= timer_PT_next;
      ns_green_reg <= ns_green_next;
      ns_yellow_reg <= ns_yellow_next;
      ns_red_reg <= ns_red_next;
      turn_green_reg <= turn_green_next;
      turn_yellow_reg <= turn_yellow_next;
      turn_red_reg <= turn_red_next;
      ew_green_reg <= ew_green_next;
      ew_yellow_reg <= ew_yellow_next;
      ew_red_reg <= ew_red_next;
      walk_reg <= walk_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
