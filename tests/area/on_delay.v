// A lamp that comes on when the switch has been on for 50 ticks.
module on_delay (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire switch,
  output reg  lamp
);
  // The tick in the clock in which the switch comes on does not count.
  reg switch_before;
  reg [5:0] elapsed;

  initial {lamp, switch_before, elapsed} = 0;

  always @(posedge clk)
    if (rst) begin
      switch_before <= 0;
      elapsed <= 0;
      lamp <= 0;
    end else begin
      switch_before <= switch;
      if (!switch || !switch_before) begin
        elapsed <= 0;
        lamp <= 0;
      end else if (tick && !lamp) begin
        elapsed <= elapsed + 1;
        lamp <= elapsed == 49;
      end
    end
endmodule
