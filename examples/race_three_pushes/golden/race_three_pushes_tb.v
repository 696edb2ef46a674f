// Made by hotrail 0.1.0 from race_three_pushes.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module race_three_pushes_expect (
  input  wire clk,
  input  wire rst,
  input  wire won,
  output wire expect_0_0,
  output wire expect_1_0,
  output wire expect_2_0,
  output wire expect_3_0,
  output wire expect_4_0,
  output wire expect_5_0,
  output wire expect_6_0,
  output wire expect_7_0,
  output wire expect_8_0,
  output wire expect_9_0,
  output wire expect_10_0,
  output wire expect_11_0,
  output wire expect_12_0,
  output wire expect_13_0,
  output wire expect_14_0,
  output wire expect_15_0,
  output wire expect_16_0,
  output wire expect_17_0
);

  assign expect_0_0 = ~won;
  assign expect_1_0 = won;
  assign expect_2_0 = ~won;
  assign expect_3_0 = ~won;
  assign expect_4_0 = ~won;
  assign expect_5_0 = won;
  assign expect_6_0 = ~won;
  assign expect_7_0 = ~won;
  assign expect_8_0 = won;
  assign expect_9_0 = ~won;
  assign expect_10_0 = ~won;
  assign expect_11_0 = won;
  assign expect_12_0 = ~won;
  assign expect_13_0 = ~won;
  assign expect_14_0 = won;
  assign expect_15_0 = ~won;
  assign expect_16_0 = ~won;
  assign expect_17_0 = won;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module race_three_pushes_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg button = 1'd0;
  reg clear = 1'd0;
  wire won;
  reg failed;
  integer failures;

  race_three_pushes core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .button(button),
    .clear(clear),
    .won(won)
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
  wire [0:0] expect_6 = {expect_6_0};
  wire expect_7_0;
  wire [0:0] expect_7 = {expect_7_0};
  wire expect_8_0;
  wire [0:0] expect_8 = {expect_8_0};
  wire expect_9_0;
  wire [0:0] expect_9 = {expect_9_0};
  wire expect_10_0;
  wire [0:0] expect_10 = {expect_10_0};
  wire expect_11_0;
  wire [0:0] expect_11 = {expect_11_0};
  wire expect_12_0;
  wire [0:0] expect_12 = {expect_12_0};
  wire expect_13_0;
  wire [0:0] expect_13 = {expect_13_0};
  wire expect_14_0;
  wire [0:0] expect_14 = {expect_14_0};
  wire expect_15_0;
  wire [0:0] expect_15 = {expect_15_0};
  wire expect_16_0;
  wire [0:0] expect_16 = {expect_16_0};
  wire expect_17_0;
  wire [0:0] expect_17 = {expect_17_0};
  race_three_pushes_expect expectations (
    .clk(clk),
    .rst(rst),
    .won(won),
    .expect_0_0(expect_0_0),
    .expect_1_0(expect_1_0),
    .expect_2_0(expect_2_0),
    .expect_3_0(expect_3_0),
    .expect_4_0(expect_4_0),
    .expect_5_0(expect_5_0),
    .expect_6_0(expect_6_0),
    .expect_7_0(expect_7_0),
    .expect_8_0(expect_8_0),
    .expect_9_0(expect_9_0),
    .expect_10_0(expect_10_0),
    .expect_11_0(expect_11_0),
    .expect_12_0(expect_12_0),
    .expect_13_0(expect_13_0),
    .expect_14_0(expect_14_0),
    .expect_15_0(expect_15_0),
    .expect_16_0(expect_16_0),
    .expect_17_0(expect_17_0)
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
      button = 1'd0;
      clear = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..9");

    // three pushes, the third in the last moment
    failed = 1'b0;
    reset;
    scan(100, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_0 !== 1'b1) begin // race_three_pushes.ladder:35
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b won=%b at %0s", expect_0, won, "race_three_pushes.ladder:35");
    end
    scan(9, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_1 !== 1'b1) begin // race_three_pushes.ladder:38
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b won=%b at %0s", expect_1, won, "race_three_pushes.ladder:38");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "three pushes, the third in the last moment");
    end else $display("ok 1 - %0s", "three pushes, the third in the last moment");

    // the third push a moment too late
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_2 !== 1'b1) begin // race_three_pushes.ladder:46
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b won=%b at %0s", expect_2, won, "race_three_pushes.ladder:46");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "the third push a moment too late");
    end else $display("ok 2 - %0s", "the third push a moment too late");

    // a push with the tick that ends the time is too late
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(10, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(9, 1'b1);
    button = 1'd1;
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // race_three_pushes.ladder:54
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b won=%b at %0s", expect_3, won, "race_three_pushes.ladder:54");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 3 - %0s", "a push with the tick that ends the time is too late");
    end else $display("ok 3 - %0s", "a push with the tick that ends the time is too late");

    // any three in a row: 0 s, 1.8 s, 2.1 s, 2.2 s
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(18, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    scan(3, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_4 !== 1'b1) begin // race_three_pushes.ladder:62
      failed = 1'b1;
      $display("# failed expectation 4 conducts %b won=%b at %0s", expect_4, won, "race_three_pushes.ladder:62");
    end
    scan(1, 1'b1);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_5 !== 1'b1) begin // race_three_pushes.ladder:65
      failed = 1'b1;
      $display("# failed expectation 5 conducts %b won=%b at %0s", expect_5, won, "race_three_pushes.ladder:65");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 4 - %0s", "any three in a row: 0 s, 1.8 s, 2.1 s, 2.2 s");
    end else $display("ok 4 - %0s", "any three in a row: 0 s, 1.8 s, 2.1 s, 2.2 s");

    // one push each second is never enough
    failed = 1'b0;
    reset;
    repeat (10) begin
      button = 1'd1;
      scan(1, 1'b0);
      button = 1'd0;
      scan(1, 1'b0);
      scan(10, 1'b1);
    end
    #1 if (!failed && &expect_6 !== 1'b1) begin // race_three_pushes.ladder:72
      failed = 1'b1;
      $display("# failed expectation 6 conducts %b won=%b at %0s", expect_6, won, "race_three_pushes.ladder:72");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 5 - %0s", "one push each second is never enough");
    end else $display("ok 5 - %0s", "one push each second is never enough");

    // three pushes right after power-up
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_7 !== 1'b1) begin // race_three_pushes.ladder:77
      failed = 1'b1;
      $display("# failed expectation 7 conducts %b won=%b at %0s", expect_7, won, "race_three_pushes.ladder:77");
    end
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_8 !== 1'b1) begin // race_three_pushes.ladder:79
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b won=%b at %0s", expect_8, won, "race_three_pushes.ladder:79");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 6 - %0s", "three pushes right after power-up");
    end else $display("ok 6 - %0s", "three pushes right after power-up");

    // a held button is one push
    failed = 1'b0;
    reset;
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // race_three_pushes.ladder:84
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b won=%b at %0s", expect_9, won, "race_three_pushes.ladder:84");
    end
    scan(100, 1'b1);
    button = 1'd1;
    scan(5, 1'b0);
    scan(10, 1'b1);
    #1 if (!failed && &expect_10 !== 1'b1) begin // race_three_pushes.ladder:88
      failed = 1'b1;
      $display("# failed expectation 10 conducts %b won=%b at %0s", expect_10, won, "race_three_pushes.ladder:88");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 7 - %0s", "a held button is one push");
    end else $display("ok 7 - %0s", "a held button is one push");

    // a race that is won stays won until it is cleared
    failed = 1'b0;
    reset;
    repeat (3) begin
      button = 1'd1;
      scan(1, 1'b0);
      button = 1'd0;
      scan(1, 1'b0);
    end
    scan(100, 1'b1);
    #1 if (!failed && &expect_11 !== 1'b1) begin // race_three_pushes.ladder:93
      failed = 1'b1;
      $display("# failed expectation 11 conducts %b won=%b at %0s", expect_11, won, "race_three_pushes.ladder:93");
    end
    clear = 1'd1;
    scan(1, 1'b0);
    clear = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_12 !== 1'b1) begin // race_three_pushes.ladder:95
      failed = 1'b1;
      $display("# failed expectation 12 conducts %b won=%b at %0s", expect_12, won, "race_three_pushes.ladder:95");
    end
    repeat (2) begin
      button = 1'd1;
      scan(1, 1'b0);
      button = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_13 !== 1'b1) begin // race_three_pushes.ladder:97
      failed = 1'b1;
      $display("# failed expectation 13 conducts %b won=%b at %0s", expect_13, won, "race_three_pushes.ladder:97");
    end
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_14 !== 1'b1) begin // race_three_pushes.ladder:99
      failed = 1'b1;
      $display("# failed expectation 14 conducts %b won=%b at %0s", expect_14, won, "race_three_pushes.ladder:99");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 8 - %0s", "a race that is won stays won until it is cleared");
    end else $display("ok 8 - %0s", "a race that is won stays won until it is cleared");

    // clear wins over the third push
    failed = 1'b0;
    reset;
    repeat (2) begin
      button = 1'd1;
      scan(1, 1'b0);
      button = 1'd0;
      scan(1, 1'b0);
    end
    button = 1'd1;
    clear = 1'd1;
    scan(1, 1'b0);
    #1 if (!failed && &expect_15 !== 1'b1) begin // race_three_pushes.ladder:104
      failed = 1'b1;
      $display("# failed expectation 15 conducts %b won=%b at %0s", expect_15, won, "race_three_pushes.ladder:104");
    end
    button = 1'd0;
    clear = 1'd0;
    scan(1, 1'b0);
    repeat (2) begin
      button = 1'd1;
      scan(1, 1'b0);
      button = 1'd0;
      scan(1, 1'b0);
    end
    #1 if (!failed && &expect_16 !== 1'b1) begin // race_three_pushes.ladder:107
      failed = 1'b1;
      $display("# failed expectation 16 conducts %b won=%b at %0s", expect_16, won, "race_three_pushes.ladder:107");
    end
    button = 1'd1;
    scan(1, 1'b0);
    button = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_17 !== 1'b1) begin // race_three_pushes.ladder:109
      failed = 1'b1;
      $display("# failed expectation 17 conducts %b won=%b at %0s", expect_17, won, "race_three_pushes.ladder:109");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 9 - %0s", "clear wins over the third push");
    end else $display("ok 9 - %0s", "clear wins over the third push");

    if (failures != 0) $display("# %0d of 9 tests failed", failures);
    $finish;
  end
endmodule
