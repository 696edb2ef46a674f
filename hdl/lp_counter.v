// What a counter does: up, down, or the steps of a drum. Combinational.
module lp_counter (
    input  wire       down,
    input  wire       enable,
    input  wire       rises,
    input  wire       at_end,           // the count is the last one of its direction
    output wire       clears,           // it goes back to 0
    output wire       loads,            // it becomes the preset
    output wire       counts            // it goes one on
);
  assign clears = ~enable & ~down;
  assign loads  = ~enable & down;
  assign counts = rises & ~at_end;
endmodule
