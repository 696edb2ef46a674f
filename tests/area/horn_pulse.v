// A horn that sounds for 50 ticks when the button is pressed, however long that is.
module horn_pulse (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire button,
  output reg  horn
);
  reg button_before;
  reg [5:0] elapsed;

  initial {horn, button_before, elapsed} = 0;

  always @(posedge clk)
    if (rst) begin
      button_before <= 0;
      elapsed <= 0;
      horn <= 0;
    end else begin
      button_before <= button;
      if (!horn) begin
        elapsed <= 0;
        horn <= button && !button_before;
      end else if (tick) begin
        elapsed <= elapsed + 1;
        horn <= elapsed != 49;
      end
    end
endmodule
