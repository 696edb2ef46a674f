// Made by hotrail 0.1.0 from cash_register.ladder. Do not edit: change the ladder and build again.

`default_nettype none

// Connects cash_register to the pins of a board.
module cash_register_top (
  input  wire         clk,
  input  wire         rst,
  input  wire         key_combo,
  input  wire         key_double,
  input  wire         key_junior,
  input  wire         key_burger,
  input  wire         key_fries,
  input  wire         key_drink,
  input  wire         cancel_last,
  input  wire         total_key,
  input  wire         new_order,
  input  wire         new_day,
  input  wire         to_go,
  output wire         lamp_combo,
  output wire         lamp_double,
  output wire         lamp_junior,
  output wire         lamp_burger,
  output wire         lamp_fries,
  output wire         lamp_drink,
  output wire [31:0]  subtotal,
  output wire [31:0]  tax,
  output wire [31:0]  total,
  output wire         paid,
  output wire [191:0] sold,
  output wire [31:0]  profit
);
  // Reset: comes at once, goes in step with the clock.
  (* ASYNC_REG = "TRUE" *) reg [1:0] reset_pipe = 2'b11;
  always @(posedge clk or posedge rst) begin
    if (rst) reset_pipe <= 2'b11;
    else reset_pipe <= {reset_pipe[0], 1'b0};
  end
  wire core_rst = reset_pipe[1];

  // Tick: every 1000 clocks of 1 MHz, wanted every 1 ms, error 0 ppm.
  reg [9:0] prescaler = 10'd0;
  wire tick = prescaler == 10'd999;
  always @(posedge clk) begin
    if (core_rst) prescaler <= 10'd0;
    else prescaler <= tick ? 10'd0 : prescaler + 10'd1;
  end

  // Inputs: two flip-flops for each bit.
  (* ASYNC_REG = "TRUE" *) reg key_combo_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_combo_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_double_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_double_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_junior_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_junior_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_burger_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_burger_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_fries_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_fries_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_drink_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg key_drink_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg cancel_last_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg cancel_last_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg total_key_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg total_key_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg new_order_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg new_order_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg new_day_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg new_day_sync = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg to_go_meta = 1'b0;
  (* ASYNC_REG = "TRUE" *) reg to_go_sync = 1'b0;
  always @(posedge clk) begin
    key_combo_meta <= key_combo;
    key_combo_sync <= key_combo_meta;
    key_double_meta <= key_double;
    key_double_sync <= key_double_meta;
    key_junior_meta <= key_junior;
    key_junior_sync <= key_junior_meta;
    key_burger_meta <= key_burger;
    key_burger_sync <= key_burger_meta;
    key_fries_meta <= key_fries;
    key_fries_sync <= key_fries_meta;
    key_drink_meta <= key_drink;
    key_drink_sync <= key_drink_meta;
    cancel_last_meta <= cancel_last;
    cancel_last_sync <= cancel_last_meta;
    total_key_meta <= total_key;
    total_key_sync <= total_key_meta;
    new_order_meta <= new_order;
    new_order_sync <= new_order_meta;
    new_day_meta <= new_day;
    new_day_sync <= new_day_meta;
    to_go_meta <= to_go;
    to_go_sync <= to_go_meta;
  end

  cash_register core (
    .clk(clk),
    .rst(core_rst),
    .tick(tick),
    .key_combo(key_combo_sync),
    .key_double(key_double_sync),
    .key_junior(key_junior_sync),
    .key_burger(key_burger_sync),
    .key_fries(key_fries_sync),
    .key_drink(key_drink_sync),
    .cancel_last(cancel_last_sync),
    .total_key(total_key_sync),
    .new_order(new_order_sync),
    .new_day(new_day_sync),
    .to_go(to_go_sync),
    .lamp_combo(lamp_combo),
    .lamp_double(lamp_double),
    .lamp_junior(lamp_junior),
    .lamp_burger(lamp_burger),
    .lamp_fries(lamp_fries),
    .lamp_drink(lamp_drink),
    .subtotal(subtotal),
    .tax(tax),
    .total(total),
    .paid(paid),
    .sold(sold),
    .profit(profit)
  );
endmodule

`default_nettype wire
