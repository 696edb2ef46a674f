// The power in hand and the two stacks: what a contact does with its attribute.
module lp_power #(
    parameter STACK_DEPTH = 4
) (
    input  wire       clk,
    input  wire       start_scan,       // the next contact starts a circuit
    input  wire       contact,          // a contact is executed in this clock
    input  wire       ends_circuit,     // an output or a prefix that latches power is executed
    input  wire [3:0] field,            // of the word: the attribute
    input  wire       conducts,
    output reg        pwra              // the power at the left of the next contact
);
  wire open = field == 4'd2 | field == 4'd5 | field == 4'd6 | field == 4'd8;
  wire up   = field == 4'd4 | field == 4'd5 | field == 4'd7 | field == 4'd8;
  wire ret  = field == 4'd3 | field == 4'd6 | field == 4'd7 | field == 4'd8;

  reg ended;                            // the circuit before is complete: power comes from the rail

  wire left_of_list;                    // top of stack 1
  wire pwrb;                            // top of stack 2: the branches so far
  wire left  = ended | pwra;
  wire right = (left & conducts) | (up & pwrb);

  // Where a list ends at the contact that opens an outer one, its power comes back through it.
  wire back  = up & conducts & pwrb;

  lp_stack #(.DEPTH(STACK_DEPTH)) stack1 (
      .clk(clk), .put(contact & open & ~ret), .take(contact & ret & ~open),
      .put_bit(left | back), .top(left_of_list)
  );
  lp_stack #(.DEPTH(STACK_DEPTH)) stack2 (
      .clk(clk), .put(contact & ret), .take(contact & up), .put_bit(right), .top(pwrb)
  );

  always @(posedge clk) begin
    if (start_scan | ends_circuit) ended <= 1'b1;
    else if (contact) ended <= 1'b0;
    // A scan begins without power: an output in front of every contact sees none.
    if (start_scan) pwra <= 1'b0;
    else if (contact) pwra <= ~ret ? right : open ? left : left_of_list;
  end
endmodule
