// A fan that runs on for 50 ticks after its switch.
module off_delay (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire switch,
  output reg  fan
);
  // The tick in the clock in which the switch goes off does not count.
  reg switch_before;
  reg [5:0] elapsed;

  initial {fan, switch_before, elapsed} = 0;

  always @(posedge clk)
    if (rst) begin
      switch_before <= 0;
      elapsed <= 0;
      fan <= 0;
    end else begin
      switch_before <= switch;
      if (switch || switch_before) begin
        elapsed <= 0;
        fan <= 1;
      end else if (tick && fan) begin
        elapsed <= elapsed + 1;
        fan <= elapsed != 49;
      end
    end
endmodule
