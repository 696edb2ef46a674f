// Made by hotrail 0.1.0 from traffic_lights.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// The blocks stand in the program's file.
/* verilator lint_off DECLFILENAME */

// TON: on-delay timer
// Fitted to power = 1, PT = 120 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_lights_TON_power1_PT120 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire clear_after,
  output wire Q
);
  reg [6:0] ET = 7'd0;
  reg was = 1'b0;

  wire equal = ET == 7'd120;
  wire [6:0] sum = ET + {6'b0, tick & ~equal};
  wire [6:0] choice = was ? sum : 7'd0;
  wire equal_2 = ET == 7'd119;
  wire [6:0] ET_next = clear_after ? 7'd0 : choice;

  assign Q = was & (tick & equal_2 | equal);

  always @(posedge clk) begin
    if (rst) begin
      ET <= 7'd0;
      was <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= 1'b1;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 30 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_lights_TON_PT30 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [4:0] ET = 5'd0;
  reg was = 1'b0;
  reg ET_is_30 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_30;
  wire [4:0] sum = ET + 5'd1;
  wire [4:0] choice = condition_2 ? sum : ET;
  wire [4:0] ET_next = condition ? choice : 5'd0;
  wire equal = ET == 5'd29;
  wire choice_2 = condition_2 ? equal : ET_is_30;
  wire ET_is_30_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_30_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 5'd0;
      was <= 1'b0;
      ET_is_30 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_30 <= ET_is_30_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 60 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_lights_TON_PT60 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [5:0] ET = 6'd0;
  reg was = 1'b0;
  reg ET_is_60 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_60;
  wire [5:0] sum = ET + 6'd1;
  wire [5:0] choice = condition_2 ? sum : ET;
  wire [5:0] ET_next = condition ? choice : 6'd0;
  wire equal = ET == 6'd59;
  wire choice_2 = condition_2 ? equal : ET_is_60;
  wire ET_is_60_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_60_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 6'd0;
      was <= 1'b0;
      ET_is_60 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_60 <= ET_is_60_next;
    end
  end
endmodule

// TON: on-delay timer
// Fitted to PT = 100 ticks.
// Example, with PT = 3:
// IN  _#######__###__##_
// Q   ____####__________
// ET  001233330001200010
module traffic_lights_TON_PT100 (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire power,
  output wire Q
);
  reg [6:0] ET = 7'd0;
  reg was = 1'b0;
  reg ET_is_100 = 1'b0;

  wire condition = power & was;
  wire condition_2 = tick & ~ET_is_100;
  wire [6:0] sum = ET + 7'd1;
  wire [6:0] choice = condition_2 ? sum : ET;
  wire [6:0] ET_next = condition ? choice : 7'd0;
  wire equal = ET == 7'd99;
  wire choice_2 = condition_2 ? equal : ET_is_100;
  wire ET_is_100_next = condition ? choice_2 : 1'b0;

  assign Q = ET_is_100_next;

  always @(posedge clk) begin
    if (rst) begin
      ET <= 7'd0;
      was <= 1'b0;
      ET_is_100 <= 1'b0;
    end else begin
      ET <= ET_next;
      was <= power;
      ET_is_100 <= ET_is_100_next;
    end
  end
endmodule

module traffic_lights (
  input  wire clk,
  input  wire rst,
  input  wire tick,
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
  reg ns_green_reg = 1'b0;
  reg ns_yellow_reg = 1'b0;
  reg ns_red_reg = 1'b1;
  reg turn_green_reg = 1'b0;
  reg turn_yellow_reg = 1'b0;
  reg turn_red_reg = 1'b1;
  reg ew_green_reg = 1'b0;
  reg ew_yellow_reg = 1'b0;
  reg ew_red_reg = 1'b1;

  // rung 1 "intervals 1 to 6", traffic_lights.ladder:13
  wire t1_Q;
  wire t2_Q;
  traffic_lights_TON_PT30 t2 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t1_Q),
    .Q(t2_Q)
  );
  wire t3_Q;
  traffic_lights_TON_PT60 t3 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t2_Q),
    .Q(t3_Q)
  );
  wire t4_Q;
  traffic_lights_TON_PT30 t4 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t3_Q),
    .Q(t4_Q)
  );
  wire t5_Q;
  traffic_lights_TON_PT100 t5 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t4_Q),
    .Q(t5_Q)
  );
  wire t6_Q;
  traffic_lights_TON_power1_PT120 t1 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .clear_after(t6_Q),
    .Q(t1_Q)
  );
  traffic_lights_TON_PT30 t6 (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .power(t5_Q),
    .Q(t6_Q)
  );
  wire rung1_power = ~t6_Q & t1_Q;

  // rung 2 "interval 1: north-south may go", traffic_lights.ladder:17
  wire ns_green_next = ~rung1_power;

  // rung 3 "interval 2", traffic_lights.ladder:19
  wire ns_yellow_next = rung1_power & ~t2_Q;

  // rung 4 "interval 3: north-south may turn", traffic_lights.ladder:21
  wire turn_green_next = t2_Q & ~t3_Q;

  // rung 5 "interval 4", traffic_lights.ladder:23
  wire turn_yellow_next = t3_Q & ~t4_Q;

  // rung 6 "interval 5: east-west may go", traffic_lights.ladder:25
  wire ew_green_next = t4_Q & ~t5_Q;

  // rung 7 "interval 6", traffic_lights.ladder:27
  wire ew_yellow_next = t5_Q & rung1_power;

  // rung 8 "red whenever a lane has neither green nor yellow", traffic_lights.ladder:30
  wire ns_red_next = rung1_power & t2_Q;

  // rung 9, traffic_lights.ladder:32
  wire turn_red_next = ~turn_green_next & ~turn_yellow_next;

  // rung 10, traffic_lights.ladder:33
  wire ew_red_next = ~ew_green_next & ~ew_yellow_next;

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
      ns_green_reg <= 1'b0;
      ns_yellow_reg <= 1'b0;
      ns_red_reg <= 1'b1;
      turn_green_reg <= 1'b0;
      turn_yellow_reg <= 1'b0;
      turn_red_reg <= 1'b1;
      ew_green_reg <= 1'b0;
      ew_yellow_reg <= 1'b0;
      ew_red_reg <= 1'b1;
    end else begin
      ns_green_reg <= ns_green_next;
      ns_yellow_reg <= ns_yellow_next;
      ns_red_reg <= ns_red_next;
      turn_green_reg <= turn_green_next;
      turn_yellow_reg <= turn_yellow_next;
      turn_red_reg <= turn_red_next;
      ew_green_reg <= ew_green_next;
      ew_yellow_reg <= ew_yellow_next;
      ew_red_reg <= ew_red_next;
    end
  end
endmodule
/* verilator lint_on DECLFILENAME */

`default_nettype wire
