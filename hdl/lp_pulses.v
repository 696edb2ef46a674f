// A pulse in the scan of every tenth of a second, and of every second, counted in ticks from reset.
module lp_pulses #(
    parameter TICKS_PER_TENTH = 100,    // 0: a tick does not divide it, there are no pulses
    parameter TICKS_PER_SECOND = 1000
) (
    input  wire clk,
    input  wire rst,
    input  wire start_scan,
    input  wire tick,                   // this scan has the tick; read with start_scan
    output wire tenth,                  // for the whole scan
    output wire second
);
  lp_divider #(.TICKS(TICKS_PER_TENTH)) tenths (
      .clk(clk), .rst(rst), .start_scan(start_scan), .tick(tick), .pulse(tenth)
  );
  lp_divider #(.TICKS(TICKS_PER_SECOND)) seconds (
      .clk(clk), .rst(rst), .start_scan(start_scan), .tick(tick), .pulse(second)
  );
endmodule
