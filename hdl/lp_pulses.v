// A pulse in the scan of every tenth of a second, and of every second, counted in ticks from reset.
module lp_pulses #(
    parameter TICKS_PER_TENTH = 100,    // 0: a tick does not divide it, there are no pulses
    parameter TICKS_PER_SECOND = 1000
) (
    input  wire clk,
    input  wire rst,
    input  wire start_scan,
    input  wire tick,                   // this scan has the tick; read with start_scan
    output reg  tenth,                  // for the whole scan
    output reg  second
);
  reg [31:0] tenth_count;
  reg [31:0] second_count;
  wire last_of_tenth  = tenth_count + 32'd1 == TICKS_PER_TENTH;
  wire last_of_second = second_count + 32'd1 == TICKS_PER_SECOND;

  always @(posedge clk)
    if (rst) begin
      tenth_count  <= 32'd0;
      second_count <= 32'd0;
      tenth  <= 1'b0;
      second <= 1'b0;
    end else if (start_scan) begin
      tenth  <= tick & last_of_tenth;
      second <= tick & last_of_second;
      if (tick) begin
        tenth_count  <= last_of_tenth ? 32'd0 : tenth_count + 32'd1;
        second_count <= last_of_second ? 32'd0 : second_count + 32'd1;
      end
    end
endmodule
