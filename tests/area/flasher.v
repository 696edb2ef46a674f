// Two timers that start each other in turn: on for 30 ticks, off for 20.
module flasher (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire enable,
  output reg  lamp
);
  // What each timer saw in the clock before, and how far it is.
  reg on_before, off_before;
  reg [4:0] on_elapsed, off_elapsed;
  // The off time is over: the on time starts anew.
  reg over;

  wire on_runs = enable && !over;
  wire dark = on_runs && on_before && (on_elapsed == 30 || tick && on_elapsed == 29);

  initial {lamp, over, on_before, off_before, on_elapsed, off_elapsed} = 0;

  always @(posedge clk)
    if (rst) begin
      on_before <= 0;
      off_before <= 0;
      on_elapsed <= 0;
      off_elapsed <= 0;
      over <= 0;
      lamp <= 0;
    end else begin
      on_before <= on_runs;
      if (!on_runs || !on_before)
        on_elapsed <= 0;
      else if (tick && on_elapsed != 30)
        on_elapsed <= on_elapsed + 1;

      // The scan after the off time is over ends both, so it never counts beyond 20.
      off_before <= dark;
      if (!dark || !off_before)
        off_elapsed <= 0;
      else if (tick)
        off_elapsed <= off_elapsed + 1;
      over <= dark && off_before && tick && off_elapsed == 19;

      lamp <= enable && !dark;
    end
endmodule
