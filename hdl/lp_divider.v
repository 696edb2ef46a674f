// Makes a pulse, one scan long, of every so many ticks.
module lp_divider #(
    parameter TICKS = 100               // 0: no pulses
) (
    input  wire clk,
    input  wire rst,
    input  wire start_scan,
    input  wire tick,
    output reg  pulse
);
  localparam BITS = TICKS > 1 ? $clog2(TICKS) : 1;
  localparam [31:0] LAST = TICKS - 1;

  reg [BITS-1:0] count;
  wire last = TICKS != 0 & count == LAST[BITS-1:0];

  always @(posedge clk)
    if (rst) begin
      count <= {BITS{1'b0}};
      pulse <= 1'b0;
    end else if (start_scan) begin
      pulse <= tick & last;
      if (tick) count <= last ? {BITS{1'b0}} : count + 1'b1;
    end
endmodule
