// Made by hotrail 0.1.0 from edges_and_latches.ladder. Do not edit: change the ladder and build again.

`default_nettype none

module edges_and_latches (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire a,
  input  wire b,
  input  wire clear,
  output wire on_rise,
  output wire on_fall,
  output wire shot_up,
  output wire shot_down,
  output wire coil_up,
  output wire coil_down,
  output wire latched,
  output wire inverted,
  output wire started
);
  reg inverted_reg = 1'b0;
  reg power_before = 1'b0;
  reg coil_up_power_before = 1'b0;
  reg latched_reg = 1'b0;
  reg first_scan = 1'b1;
  reg started_reg = 1'b0;
  reg on_rise_reg = 1'b0;
  reg on_fall_reg = 1'b0;
  reg shot_up_reg = 1'b0;
  reg shot_down_reg = 1'b0;
  reg coil_up_reg = 1'b0;
  reg coil_down_reg = 1'b0;

  // rung 1 "edge contacts", edges_and_latches.ladder:11
  wire on_rise_next = a & ~inverted_reg;
  wire on_fall_next = inverted_reg & ~a;

  // rung 2 "one-shots on the power of a and b", edges_and_latches.ladder:14
  wire power_before_next = a & b;
  wire shot_up_next = power_before_next & ~power_before;
  wire shot_down_next = power_before & ~power_before_next;

  // rung 3 "edge coils", edges_and_latches.ladder:17
  wire coil_up_power_before_next = a & b;
  wire coil_up_next = coil_up_power_before_next & ~coil_up_power_before;
  wire coil_down_next = coil_up_power_before & ~coil_up_power_before_next;

  // rung 4 "latch: reset wins, because it stands below", edges_and_latches.ladder:20
  wire latched_rung4 = a | latched_reg;

  // rung 5, edges_and_latches.ladder:22
  wire latched_next = latched_rung4 & ~clear;

  // rung 6 "inverted coil", edges_and_latches.ladder:24
  wire inverted_next = a;

  // rung 7 "first scan", edges_and_latches.ladder:27
  wire started_next = first_scan | started_reg;

  assign on_rise = on_rise_reg;
  assign on_fall = on_fall_reg;
  assign shot_up = shot_up_reg;
  assign shot_down = shot_down_reg;
  assign coil_up = coil_up_reg;
  assign coil_down = coil_down_reg;
  assign latched = latched_reg;
  assign inverted = inverted_reg;
  assign started = started_reg;

  always @(posedge clk) begin
    if (rst) begin
      inverted_reg <= 1'b0;
      power_before <= 1'b0;
      coil_up_power_before <= 1'b0;
      latched_reg <= 1'b0;
      first_scan <= 1'b1;
      started_reg <= 1'b0;
      on_rise_reg <= 1'b0;
      on_fall_reg <= 1'b0;
      shot_up_reg <= 1'b0;
      shot_down_reg <= 1'b0;
      coil_up_reg <= 1'b0;
      coil_down_reg <= 1'b0;
    end else begin
      inverted_reg <= inverted_next;
      power_before <= power_before_next;
      coil_up_power_before <= coil_up_power_before_next;
      latched_reg <= latched_next;
      first_scan <= 1'b0;
      started_reg <= started_next;
      on_rise_reg <= on_rise_next;
      on_fall_reg <= on_fall_next;
      shot_up_reg <= shot_up_next;
      shot_down_reg <= shot_down_next;
      coil_up_reg <= coil_up_next;
      coil_down_reg <= coil_down_next;
    end
  end

  // What the program does not read.
  wire unused = &{1'b0, tick};
endmodule

`default_nettype wire
