// Made by hotrail 0.1.0 from tool_magazine.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects tool_magazine to the pins of a board.
module tool_magazine_top (
  input  wire clk,
  input  wire rst,
  input  wire X4,
  input  wire X3,
  input  wire X2,
  input  wire X1,
  input  wire at2,
  input  wire at3,
  input  wire X15,
  input  wire X16,
  input  wire home,
  output wire turn,
  output wire Y0,
  output wire Y1,
  output wire Y2,
  output wire Y3,
  output wire Y4
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 12000 clocks of 12 MHz, wanted every 1 ms, error 0 ppm.
  reg [13:0] prescaler = 14'd0;
  wire tick = prescaler == 14'd11999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 14'd0;
    else prescaler <= tick ? 14'd0 : prescaler + 14'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg X4_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X4_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X3_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X3_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X2_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X2_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X1_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg at2_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg at2_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg at3_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg at3_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X15_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X15_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X16_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg X16_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg home_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg home_sync = 1'b0;
  always @(posedge clk) begin
    X4_meta <= X4;
    X4_sync <= X4_meta;
    X3_meta <= X3;
    X3_sync <= X3_meta;
    X2_meta <= X2;
    X2_sync <= X2_meta;
    X1_meta <= X1;
    X1_sync <= X1_meta;
    at2_meta <= at2;
    at2_sync <= at2_meta;
    at3_meta <= at3;
    at3_sync <= at3_meta;
    X15_meta <= X15;
    X15_sync <= X15_meta;
    X16_meta <= X16;
    X16_sync <= X16_meta;
    home_meta <= home;
    home_sync <= home_meta;
  end

  tool_magazine core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .X4(X4_sync),
    .X3(X3_sync),
    .X2(X2_sync),
    .X1(X1_sync),
    .at2(at2_sync),
    .at3(at3_sync),
    .X15(X15_sync),
    .X16(X16_sync),
    .home(home_sync),
    .turn(turn),
    .Y0(Y0),
    .Y1(Y1),
    .Y2(Y2),
    .Y3(Y3),
    .Y4(Y4)
  );
endmodule

`default_nettype wire
