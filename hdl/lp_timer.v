// What a timer does: TS and TT, in three types. Combinational: with the old count compared it says
// what becomes of the count, with the new one compared what becomes of the rest.
module lp_timer (
    input  wire [1:0] timer_type,       // 00 off-delay, 01 on-delay, 1x interval
    input  wire       enable,
    input  wire       power,
    input  wire       pulse,            // one unit of time has gone by
    input  wire       was,              // the power at the call before
    input  wire       was_enabled,      // power and enable at the call before
    input  wire       runs,             // a delay or an interval runs
    input  wire       reached,          // the count is the preset or more
    // Of the old count.
    output wire       clears,           // it goes back to 0
    output wire       counts,           // else it grows by one
    // Of the new count.
    output wire       coil,
    output wire       runs_on,
    output wire       ends              // the count goes back to 0 after all
);
  wire on_delay  = timer_type == 2'b01;
  wire off_delay = timer_type == 2'b00;
  wire interval  = timer_type[1];
  wire starts    = interval & ~runs & power & ~was;

  assign clears = ~enable | starts | (off_delay & (power | (runs & was)));
  assign counts = pulse & ~reached & (on_delay ? power & was_enabled : runs);

  assign runs_on = enable & ~on_delay
                 & ((off_delay & power) | ((runs | starts) & ~reached));
  assign coil    = on_delay ? reached : runs_on;
  assign ends    = interval & ~runs_on & ~power;
endmodule
