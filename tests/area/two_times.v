// A fan starts 20 ticks after the switch and its heater 50 ticks after it, from one timer.
module two_times (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire switch,
  output reg  heater,
  output reg  fan
);
  reg switch_before;
  reg [5:0] elapsed;

  initial {heater, fan, switch_before, elapsed} = 0;

  always @(posedge clk)
    if (rst) begin
      switch_before <= 0;
      elapsed <= 0;
      heater <= 0;
      fan <= 0;
    end else begin
      switch_before <= switch;
      if (!switch || !switch_before) begin
        elapsed <= 0;
        heater <= 0;
        fan <= 0;
      end else if (tick && !heater) begin
        elapsed <= elapsed + 6'd1;
        if (elapsed == 49) heater <= 1;
        if (elapsed == 19) fan <= 1;
      end
    end
endmodule
