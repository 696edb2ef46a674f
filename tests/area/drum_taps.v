// A drum of 30 steps, whose four cams come on one after another; home turns it back.
module drum_taps (
  input  wire clk,
  input  wire rst,
  input  wire tick,
  input  wire step,
  input  wire home,
  output reg  oil,
  output reg  water,
  output reg  press,
  output reg  heat,
  output reg  done
);
  reg step_before;
  reg [4:0] count;

  initial {oil, water, press, heat, done, count, step_before} = 0;

  always @(posedge clk) begin
    step_before <= step;
    // Nobody sees more than 30 steps.
    if (step & ~step_before & ~done) begin
      count <= count + 1;
      if (count == 3) oil <= 1;
      if (count == 10) water <= 1;
      if (count == 16) press <= 1;
      if (count == 25) heat <= 1;
      if (count == 29) done <= 1;
    end
    if (home) {oil, water, press, heat, done, count} <= 0;
    if (rst) {oil, water, press, heat, done, count, step_before} <= 0;
  end
endmodule
