// Made by hotrail 0.1.0 from part_counter.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module part_counter_expect (
  input  wire        clk,
  input  wire        rst,
  input  wire [15:0] parts,
  input  wire        batch_full,
  output wire        expect_0_0,
  output wire        expect_1_0,
  output wire        expect_2_0,
  output wire        expect_3_0,
  output wire        expect_4_0,
  output wire        expect_5_0,
  output wire        expect_6_0,
  output wire        expect_6_1,
  output wire        expect_7_0,
  output wire        expect_8_0,
  output wire        expect_8_1,
  output wire        expect_9_0,
  output wire        expect_9_1,
  output wire        expect_10_0,
  output wire        expect_11_0,
  output wire        expect_12_0
);

  assign expect_0_0 = parts == 16'd0;
  assign expect_1_0 = parts == 16'd1;
  assign expect_2_0 = parts == 16'd1;
  assign expect_3_0 = parts == 16'd2;
  assign expect_4_0 = parts == 16'd0;
  assign expect_5_0 = parts == 16'd3;
  assign expect_6_0 = ~batch_full;
  assign expect_6_1 = parts == 16'd4;
  assign expect_7_0 = ~batch_full;
  assign expect_8_0 = batch_full;
  assign expect_8_1 = parts == 16'd5;
  assign expect_9_0 = batch_full;
  assign expect_9_1 = parts == 16'd6;
  assign expect_10_0 = parts == 16'd1;
  assign expect_11_0 = parts == 16'd0;
  assign expect_12_0 = parts == 16'd0;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module part_counter_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg part_at_machine = 1'd0;
  reg clear = 1'd0;
  wire [15:0] parts;
  wire batch_full;
  reg failed;
  integer failures;

  part_counter core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .part_at_machine(part_at_machine),
    .clear(clear),
    .parts(parts),
    .batch_full(batch_full)
  );

  wire expect_0_0;
  wire [0:0] expect_0 = {expect_0_0};
  wire expect_1_0;
  wire [0:0] expect_1 = {expect_1_0};
  wire expect_2_0;
  wire [0:0] expect_2 = {expect_2_0};
  wire expect_3_0;
  wire [0:0] expect_3 = {expect_3_0};
  wire expect_4_0;
  wire [0:0] expect_4 = {expect_4_0};
  wire expect_5_0;
  wire [0:0] expect_5 = {expect_5_0};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire [0:0] expect_7 = {expect_7_0};
  wire expect_8_0;
  wire expect_8_1;
  wire [0:1] expect_8 = {expect_8_0, expect_8_1};
  wire expect_9_0;
  wire expect_9_1;
  wire [0:1] expect_9 = {expect_9_0, expect_9_1};
  wire expect_10_0;
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  part_counter_expect expectations (
    .clk(clk),
    .rst(rst),
    .parts(parts),
    .batch_full(batch_full),
    .expect_0_0(expect_0_0),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1),
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0)
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
      part_at_machine = 1'd0;
      clear = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..6");

    // half a second makes a part
    failed = 1'b0;
    reset;
    part_at_machine = 1'd1;
    scan(1, 1'b0);
    scan(4, 1'b1);
    #1 if (!failed && &expect_0 !== 1'b1) begin // part_counter.ladder:21
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b parts=%b at %0s", expect_0, parts, "part_counter.ladder:21");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // part_counter.ladder:23
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b parts=%b at %0s", expect_1, parts, "part_counter.ladder:23");
    end
    scan(600, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // part_counter.ladder:25
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b parts=%b at %0s", expect_2, parts, "part_counter.ladder:25");
    end
    part_at_machine = 1'd0;
    scan(1, 1'b0);
    part_at_machine = 1'd1;
    scan(1, 1'b0);
    scan(5, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // part_counter.ladder:29
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b parts=%b at %0s", expect_3, parts, "part_counter.ladder:29");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "half a second makes a part");
    end else $display("ok 1 - %0s", "half a second makes a part");

    // less does not
    failed = 1'b0;
    reset;
    repeat (10) begin
      part_at_machine = 1'd1;
      scan(1, 1'b0);
      scan(4, 1'b1);
      part_at_machine = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_4 !== 1'b1) begin // part_counter.ladder:37
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b parts=%b at %0s", expect_4, parts, "part_counter.ladder:37");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "less does not");
    end else $display("ok 2 - %0s", "less does not");

    // a part that flickers when it comes and when it goes is one part
    failed = 1'b0;
    reset;
    repeat (3) begin
      repeat (4) begin
        part_at_machine = 1'd1;
        scan(2, 1'b1);
        part_at_machine = 1'd0;
        scan(1, 1'b1);
      end
      part_at_machine = 1'd1;
      scan(20, 1'b1);
      part_at_machine = 1'd0;
      scan(1, 1'b1);
      repeat (4) begin
        part_at_machine = 1'd1;
        scan(1, 1'b1);
        part_at_machine = 1'd0;
        scan(1, 1'b1);
      end
    end
    #1 if (!failed && &expect_5 !== 1'b1) begin // part_counter.ladder:52
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b parts=%b at %0s", expect_5, parts, "part_counter.ladder:52");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a part that flickers when it comes and when it goes is one part");
    end else $display("ok 3 - %0s", "a part that flickers when it comes and when it goes is one part");

    // the fifth part fills the batch, more parts still count
    failed = 1'b0;
    reset;
    repeat (4) begin
      part_at_machine = 1'd1;
      scan(1, 1'b0);
      scan(5, 1'b1);
      part_at_machine = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_6 !== 1'b1) begin // part_counter.ladder:60
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b batch_full=%b parts=%b at %0s", expect_6, batch_full, parts, "part_counter.ladder:60");
    end
    part_at_machine = 1'd1;
    scan(1, 1'b0);
    scan(4, 1'b1);
    #1 if (!failed && &expect_7 !== 1'b1) begin // part_counter.ladder:63
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b batch_full=%b at %0s", expect_7, batch_full, "part_counter.ladder:63");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // part_counter.ladder:65
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b batch_full=%b parts=%b at %0s", expect_8, batch_full, parts, "part_counter.ladder:65");
    end
    part_at_machine = 1'd0;
    scan(1, 1'b0);
    part_at_machine = 1'd1;
    scan(1, 1'b0);
    scan(5, 1'b1);
    #1 if (!failed && &expect_9 !== 1'b1) begin // part_counter.ladder:69
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b batch_full=%b parts=%b at %0s", expect_9, batch_full, parts, "part_counter.ladder:69");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "the fifth part fills the batch, more parts still count");
    end else $display("ok 4 - %0s", "the fifth part fills the batch, more parts still count");

    // cleared with a part in front of the switch: it does not count once more
    failed = 1'b0;
    reset;
    part_at_machine = 1'd1;
    scan(1, 1'b0);
    scan(5, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // part_counter.ladder:74
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b parts=%b at %0s", expect_10, parts, "part_counter.ladder:74");
    end
    clear = 1'd1;
    scan(1, 1'b0);
    clear = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // part_counter.ladder:77
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b parts=%b at %0s", expect_11, parts, "part_counter.ladder:77");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "cleared with a part in front of the switch: it does not count once more");
    end else $display("ok 5 - %0s", "cleared with a part in front of the switch: it does not count once more");

    // a part that is complete while clear is held is lost
    failed = 1'b0;
    reset;
    part_at_machine = 1'd1;
    clear = 1'd1;
    scan(1, 1'b0);
    scan(5, 1'b1);
    clear = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    #1 if (!failed && &expect_12 !== 1'b1) begin // part_counter.ladder:84
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b parts=%b at %0s", expect_12, parts, "part_counter.ladder:84");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "a part that is complete while clear is held is lost");
    end else $display("ok 6 - %0s", "a part that is complete while clear is held is lost");

    if (failures != 0) $display("# %0d of 6 tests failed", failures);
    $finish;
  end
endmodule
