// Made by hotrail 0.1.0 from paper_bits.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module paper_bits_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire        bc_coil,
  input  wire        bs_coil,
  input  wire [15:0] bitset_r,
  output wire        expect_0_0,
  output wire        expect_0_1,
  output wire        expect_0_2,
  output wire        expect_1_0,
  output wire        expect_1_1,
  output wire        expect_1_2,
  output wire        expect_2_0,
  output wire        expect_2_1,
  output wire        expect_3_0,
  output wire        expect_3_1,
  output wire        expect_3_2,
  output wire        expect_4_0,
  output wire        expect_4_1,
  output wire        expect_4_2,
  output wire        expect_5_0,
  output wire        expect_5_1,
  output wire        expect_6_0,
  output wire        expect_7_0,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_8_2
);

  assign expect_0_0 = ~bc_coil;
  assign expect_0_1 = bs_coil;
  assign expect_0_2 = bitset_r == 16'd4080;
  assign expect_1_0 = bc_coil;
  assign expect_1_1 = ~bs_coil;
  assign expect_1_2 = bitset_r == 16'd3952;
  assign expect_2_0 = bc_coil;
  assign expect_2_1 = bitset_r == 16'd3952;
  assign expect_3_0 = bc_coil;
  assign expect_3_1 = ~bs_coil;
  assign expect_3_2 = bitset_r == 16'd3952;
  assign expect_4_0 = bs_coil;
  assign expect_4_1 = ~bc_coil;
  assign expect_4_2 = bitset_r == 16'd4080;
  assign expect_5_0 = bs_coil;
  assign expect_5_1 = bitset_r == 16'd4080;
  assign expect_6_0 = bitset_r == 16'd4080;
  assign expect_7_0 = bitset_r == 16'd3952;
  assign expect_8_0 = bs_coil;
  assign expect_8_1 = ~bc_coil;
  assign expect_8_2 = bitset_r == 16'd4080;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module paper_bits_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg bc_ckt = 1'd0;
  reg bs_ckt = 1'd0;
  wire bc_coil;
  wire bs_coil;
  wire [15:0] bitset_r;
  reg failed;
  integer failures;

  paper_bits core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .bc_ckt(bc_ckt),
    .bs_ckt(bs_ckt),
    .bc_coil(bc_coil),
    .bs_coil(bs_coil),
    .bitset_r(bitset_r)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire expect_0_2;
  wire [0:2] expect_0 = {expect_0_0, expect_0_1, expect_0_2};
  wire expect_1_0;
  wire expect_1_1;
  wire expect_1_2;
  wire [0:2] expect_1 = {expect_1_0, expect_1_1, expect_1_2};
  wire expect_2_0;
  wire expect_2_1;
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire expect_3_1;
  wire expect_3_2;
  wire [0:2] expect_3 = {expect_3_0, expect_3_1, expect_3_2};
  wire expect_4_0;
  wire expect_4_1;
  wire expect_4_2;
  wire [0:2] expect_4 = {expect_4_0, expect_4_1, expect_4_2};
  wire expect_5_0;
  wire expect_5_1;
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  wire expect_6_0;
  wire [0:0] expect_6 = {expect_6_0};
  wire expect_7_0;
  wire [0:0] expect_7 = {expect_7_0};
  wire expect_8_0;
  wire expect_8_1;
  wire expect_8_2;
  wire [0:2] expect_8 = {expect_8_0, expect_8_1, expect_8_2};
  paper_bits_expect expectations (
    .clk(clk),
    .rst(rst),
    .bc_coil(bc_coil),
    .bs_coil(bs_coil),
    .bitset_r(bitset_r),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_0_2(expect_0_2),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_1_2(expect_1_2),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_3_2(expect_3_2),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_4_2(expect_4_2),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_7_0(expect_7_0),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_8_2(expect_8_2)
  );

  // One clock is one scan.
  task scan(input integer times, input with_tick);
    begin
      tick = with_tick;
      repeat (times) begin
        #5 clk = 1'b1;
        #5 clk = 1'b0;
      end
    end
  endtask

  task reset;
    begin
      tick = 1'd0;
      bc_ckt = 1'd0;
      bs_ckt = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..4");

    // bit clear: one bit goes off and stays off, the others stay
    failed = 1'b0;
    reset;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // paper_bits.ladder:22
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b bc_coil=%b bs_coil=%b bitset_r=%b at %0s", expect_0, bc_coil, bs_coil, bitset_r, "paper_bits.ladder:22");
    end
    bc_ckt = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // paper_bits.ladder:24
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b bc_coil=%b bs_coil=%b bitset_r=%b at %0s", expect_1, bc_coil, bs_coil, bitset_r, "paper_bits.ladder:24");
    end
    bc_ckt = 1'd0;
    scan(3, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // paper_bits.ladder:26
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b bc_coil=%b bitset_r=%b at %0s", expect_2, bc_coil, bitset_r, "paper_bits.ladder:26");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "bit clear: one bit goes off and stays off, the others stay");
    end else $display("ok 1 - %0s", "bit clear: one bit goes off and stays off, the others stay");

    // bit set: it comes on again and stays on
    failed = 1'b0;
    reset;
    bc_ckt = 1'd1;
    scan(1, 1'b0);
    bc_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_3 !== 1'b1) begin // paper_bits.ladder:30
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b bc_coil=%b bs_coil=%b bitset_r=%b at %0s", expect_3, bc_coil, bs_coil, bitset_r, "paper_bits.ladder:30");
    end
    bs_ckt = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // paper_bits.ladder:32
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b bs_coil=%b bc_coil=%b bitset_r=%b at %0s", expect_4, bs_coil, bc_coil, bitset_r, "paper_bits.ladder:32");
    end
    bs_ckt = 1'd0;
    scan(3, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // paper_bits.ladder:34
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b bs_coil=%b bitset_r=%b at %0s", expect_5, bs_coil, bitset_r, "paper_bits.ladder:34");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "bit set: it comes on again and stays on");
    end else $display("ok 2 - %0s", "bit set: it comes on again and stays on");

    // clearing a bit that is off and setting one that is on change nothing
    failed = 1'b0;
    reset;
    bs_ckt = 1'd1;
    scan(1, 1'b0);
    bs_ckt = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_6 !== 1'b1) begin // paper_bits.ladder:38
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b bitset_r=%b at %0s", expect_6, bitset_r, "paper_bits.ladder:38");
    end
    repeat (2) begin
      bc_ckt = 1'd1;
      scan(1, 1'b0);
      bc_ckt = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_7 !== 1'b1) begin // paper_bits.ladder:40
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b bitset_r=%b at %0s", expect_7, bitset_r, "paper_bits.ladder:40");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "clearing a bit that is off and setting one that is on change nothing");
    end else $display("ok 3 - %0s", "clearing a bit that is off and setting one that is on change nothing");

    // both circuits at once: the later rung sets
    failed = 1'b0;
    reset;
    bc_ckt = 1'd1;
    bs_ckt = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // paper_bits.ladder:44
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b bs_coil=%b bc_coil=%b bitset_r=%b at %0s", expect_8, bs_coil, bc_coil, bitset_r, "paper_bits.ladder:44");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "both circuits at once: the later rung sets");
    end else $display("ok 4 - %0s", "both circuits at once: the later rung sets");

    if (failures != 0) $display("# %0d of 4 tests failed", failures);
    $finish;
  end
endmodule
