// What a counter counts: up, down, or the steps of a drum. Combinational.
module lp_counter (
    input  wire        down,
    input  wire        drum,
    input  wire        enable,
    input  wire        rises,
    input  wire [15:0] preset,
    input  wire [15:0] old_count,
    output wire [15:0] count
);
  wire [15:0] largest = drum ? 16'd2047 : 16'd9999;
  wire [15:0] more = old_count + {15'd0, rises & (old_count < largest)};
  wire [15:0] less = old_count - {15'd0, rises & (old_count != 16'd0)};

  assign count = ~enable ? (down ? preset : 16'd0) : down ? less : more;
endmodule
