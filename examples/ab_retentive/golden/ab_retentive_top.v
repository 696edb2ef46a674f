// Made by hotrail 0.1.0 from ab_retentive.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects ab_retentive to the pins of a board.
module ab_retentive_top (
  input  wire clk,
  input  wire rst,
  input  wire pump,
  input  wire reset_button,
  input  wire longer,
  output wire service,
  output wire siemens_service
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 120000 clocks of 12 MHz, wanted every 10 ms, error 0 ppm.
  reg [16:0] prescaler = 17'd0;
  wire tick = prescaler == 17'd119999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 17'd0;
    else prescaler <= tick ? 17'd0 : prescaler + 17'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg pump_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg pump_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reset_button_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reset_button_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg longer_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg longer_sync = 1'b0;
  always @(posedge clk) begin
    pump_meta <= pump;
    pump_sync <= pump_meta;
    reset_button_meta <= reset_button;
    reset_button_sync <= reset_button_meta;
    longer_meta <= longer;
    longer_sync <= longer_meta;
  end

  ab_retentive core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .pump(pump_sync),
    .reset_button(reset_button_sync),
    .longer(longer_sync),
    .service(service),
    .siemens_service(siemens_service)
  );
endmodule

`default_nettype wire
