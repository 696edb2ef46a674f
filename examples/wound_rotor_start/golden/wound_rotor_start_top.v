// Made by hotrail 0.1.0 from wound_rotor_start.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects wound_rotor_start to the pins of a board.
module wound_rotor_start_top (
  input  wire clk,
  input  wire rst,
  input  wire S0,
  input  wire S1,
  input  wire F1,
  output wire K1,
  output wire K2,
  output wire K3,
  output wire K4
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 1200000 clocks of 12 MHz, wanted every 100 ms, error 0 ppm.
  reg [20:0] prescaler = 21'd0;
  wire tick = prescaler == 21'd1199999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 21'd0;
    else prescaler <= tick ? 21'd0 : prescaler + 21'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg S0_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg S0_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg S1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg S1_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg F1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg F1_sync = 1'b0;
  always @(posedge clk) begin
    S0_meta <= S0;
    S0_sync <= S0_meta;
    S1_meta <= S1;
    S1_sync <= S1_meta;
    F1_meta <= F1;
    F1_sync <= F1_meta;
  end

  wound_rotor_start core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .S0(S0_sync),
    .S1(S1_sync),
    .F1(F1_sync),
    .K1(K1),
    .K2(K2),
    .K3(K3),
    .K4(K4)
  );
endmodule

`default_nettype wire
