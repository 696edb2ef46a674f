// Made by hotrail 0.1.0 from conveyor_line.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects conveyor_line to the pins of a board.
module conveyor_line_top (
  input  wire clk,
  input  wire rst,
  input  wire start,
  input  wire reset_faults,
  input  wire stop,
  input  wire L1,
  input  wire L2,
  input  wire L3,
  input  wire L4,
  input  wire P1,
  input  wire P2,
  input  wire P3,
  output wire C1,
  output wire C2,
  output wire C3,
  output wire fault_1,
  output wire fault_2,
  output wire fault_3
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
  (* ASYNC_REG = "TRUE" *) reg start_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg start_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reset_faults_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg reset_faults_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg stop_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg stop_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg L1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg L1_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg L2_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg L2_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg L3_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg L3_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg L4_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg L4_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg P1_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg P1_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg P2_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg P2_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg P3_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg P3_sync = 1'b0;
  always @(posedge clk) begin
    start_meta <= start;
    start_sync <= start_meta;
    reset_faults_meta <= reset_faults;
    reset_faults_sync <= reset_faults_meta;
    stop_meta <= stop;
    stop_sync <= stop_meta;
    L1_meta <= L1;
    L1_sync <= L1_meta;
    L2_meta <= L2;
    L2_sync <= L2_meta;
    L3_meta <= L3;
    L3_sync <= L3_meta;
    L4_meta <= L4;
    L4_sync <= L4_meta;
    P1_meta <= P1;
    P1_sync <= P1_meta;
    P2_meta <= P2;
    P2_sync <= P2_meta;
    P3_meta <= P3;
    P3_sync <= P3_meta;
  end

  conveyor_line core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .start(start_sync),
    .reset_faults(reset_faults_sync),
    .stop(stop_sync),
    .L1(L1_sync),
    .L2(L2_sync),
    .L3(L3_sync),
    .L4(L4_sync),
    .P1(P1_sync),
    .P2(P2_sync),
    .P3(P3_sync),
    .C1(C1),
    .C2(C2),
    .C3(C3),
    .fault_1(fault_1),
    .fault_2(fault_2),
    .fault_3(fault_3)
  );
endmodule

`default_nettype wire
