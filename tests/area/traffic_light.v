// Red for 30 s, green for 25 s, yellow for 5 s, by counting the pulses of a clock of one second.
module traffic_light (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire second,
  output reg  red,
  output reg  green,
  output reg  yellow
);
  reg second_before;
  reg [5:0] elapsed;

  initial {red, green, yellow, second_before, elapsed} = {1'b1, 9'd0};

  always @(posedge clk)
    if (rst) begin
      second_before <= 0;
      elapsed <= 0;
      {red, green, yellow} <= 3'b100;
    end else begin
      second_before <= second;
      if (second && !second_before) begin
        elapsed <= (elapsed == 59) ? 6'd0 : elapsed + 6'd1;
        if (elapsed == 29) {red, green, yellow} <= 3'b010;
        if (elapsed == 54) {red, green, yellow} <= 3'b001;
        if (elapsed == 59) {red, green, yellow} <= 3'b100;
      end
    end
endmodule
