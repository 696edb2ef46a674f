// What a timer counts: TS and TT, in three types. Combinational; the first half is ready one clock
// before the second, which sees the count that the first half has chosen.
module lp_timer (
    input  wire [1:0]  timer_type,      // 00 off-delay, 01 on-delay, 1x interval
    input  wire        enable,
    input  wire        power,
    input  wire        pulse,           // one unit of time has gone by
    input  wire        was,             // the power at the call before
    input  wire        was_enabled,     // power and enable at the call before
    input  wire        runs,            // a delay or an interval runs
    input  wire [15:0] preset,
    input  wire [15:0] old_count,
    output wire [15:0] count,
    // The second half.
    input  wire        reached,         // the chosen count is the preset or more
    output wire        coil,
    output wire        runs_on,
    output wire        clears           // the count goes back to 0 after all
);
  wire on_delay = timer_type == 2'b01;
  wire interval = timer_type[1];
  wire starts   = power & ~was & preset != 16'd0;

  wire [15:0] counted = old_count + {15'd0, pulse & (old_count < preset)};

  reg [15:0] chosen;
  always @* begin
    chosen = old_count;
    if (~enable) chosen = 16'd0;
    else if (on_delay) begin
      if (power & was_enabled) chosen = counted;
    end else if (interval) begin
      if (runs) chosen = counted;
      else if (starts) chosen = 16'd0;
    end else begin
      if (power) chosen = 16'd0;
      else if (runs) chosen = was ? 16'd0 : counted;
    end
  end
  assign count = chosen;

  wire goes_on = runs & ~reached;
  assign runs_on = enable & ~on_delay & (interval ? (runs ? goes_on : starts) : power | goes_on);
  assign coil    = on_delay ? reached : runs_on;
  assign clears  = interval & ~runs_on & ~power;
endmodule
