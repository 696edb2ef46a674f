// Made by hotrail 0.1.0 from ab_flasher.ladder. Do not edit: change the ladder and build again.
// Runs the program's tests and reports in TAP, one line for each test.

`default_nettype none

module ab_flasher_expect (
  input  wire clk,
  input  wire rst,
  input  wire ab_light,
  input  wire siemens_light,
  output wire expect_0_0,
  output wire expect_0_1,
  output wire expect_1_0,
  output wire expect_1_1,
  output wire expect_2_0,
  output wire expect_2_1,
  output wire expect_3_0,
  output wire expect_3_1,
  output wire expect_4_0,
  output wire expect_4_1,
  output wire expect_5_0,
  output wire expect_5_1,
  output wire expect_6_0,
  output wire expect_6_1,
  output wire expect_7_0,
  output wire expect_7_1,
  output wire expect_8_0,
  output wire expect_8_1,
  output wire expect_9_0,
  output wire expect_9_1
);

  assign expect_0_0 = ab_light;
  assign expect_0_1 = siemens_light;
  assign expect_1_0 = ab_light;
  assign expect_1_1 = siemens_light;
  assign expect_2_0 = ab_light;
  assign expect_2_1 = siemens_light;
  assign expect_3_0 = ~ab_light;
  assign expect_3_1 = ~siemens_light;
  assign expect_4_0 = ~ab_light;
  assign expect_4_1 = ~siemens_light;
  assign expect_5_0 = ab_light;
  assign expect_5_1 = siemens_light;
  assign expect_6_0 = ab_light;
  assign expect_6_1 = siemens_light;
  assign expect_7_0 = ~ab_light;
  assign expect_7_1 = ~siemens_light;
  assign expect_8_0 = ab_light;
  assign expect_8_1 = siemens_light;
  assign expect_9_0 = ~ab_light;
  assign expect_9_1 = ~siemens_light;

  // What the program does not read.
  wire unused = &{1'b0, clk, rst};
endmodule

`default_nettype wire


module ab_flasher_tb;
  reg clk = 1'b0;
  reg rst = 1'b0;
  reg tick = 1'd0;
  reg enable = 1'd0;
  wire ab_light;
  wire siemens_light;
  reg failed;
  integer failures;

  ab_flasher core (
    .clk(clk),
    .rst(rst),
    .tick(tick),
    .enable(enable),
    .ab_light(ab_light),
    .siemens_light(siemens_light)
  );

  wire expect_0_0;
  wire expect_0_1;
  wire [0:1] expect_0 = {expect_0_0, expect_0_1};
  wire expect_1_0;
  wire expect_1_1;
  wire [0:1] expect_1 = {expect_1_0, expect_1_1};
  wire expect_2_0;
  wire expect_2_1;
  wire [0:1] expect_2 = {expect_2_0, expect_2_1};
  wire expect_3_0;
  wire expect_3_1;
  wire [0:1] expect_3 = {expect_3_0, expect_3_1};
  wire expect_4_0;
  wire expect_4_1;
  wire [0:1] expect_4 = {expect_4_0, expect_4_1};
  wire expect_5_0;
  wire expect_5_1;
  wire [0:1] expect_5 = {expect_5_0, expect_5_1};
  wire expect_6_0;
  wire expect_6_1;
  wire [0:1] expect_6 = {expect_6_0, expect_6_1};
  wire expect_7_0;
  wire expect_7_1;
  wire [0:1] expect_7 = {expect_7_0, expect_7_1};
  wire expect_8_0;
  wire expect_8_1;
  wire [0:1] expect_8 = {expect_8_0, expect_8_1};
  wire expect_9_0;
  wire expect_9_1;
  wire [0:1] expect_9 = {expect_9_0, expect_9_1};
  ab_flasher_expect expectations (
    .clk(clk),
    .rst(rst),
    .ab_light(ab_light),
    .siemens_light(siemens_light),
    .expect_0_0(expect_0_0),
    .expect_0_1(expect_0_1),
    .expect_1_0(expect_1_0),
    .expect_1_1(expect_1_1),
    .expect_2_0(expect_2_0),
    .expect_2_1(expect_2_1),
    .expect_3_0(expect_3_0),
    .expect_3_1(expect_3_1),
    .expect_4_0(expect_4_0),
    .expect_4_1(expect_4_1),
    .expect_5_0(expect_5_0),
    .expect_5_1(expect_5_1),
    .expect_6_0(expect_6_0),
    .expect_6_1(expect_6_1),
    .expect_7_0(expect_7_0),
    .expect_7_1(expect_7_1),
    .expect_8_0(expect_8_0),
    .expect_8_1(expect_8_1),
    .expect_9_0(expect_9_0),
    .expect_9_1(expect_9_1)
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
      enable = 1'd0;
      rst = 1'b1;
      scan(1, 1'b0);
      rst = 1'b0;
    end
  endtask

  initial begin
    failures = 0;
    $display("1..2");

    // both flash alike, for three periods
    failed = 1'b0;
    reset;
    enable = 1'd1;
    scan(1, 1'b0);
    scan(500, 1'b1);
    #1 if (!failed && &expect_0 !== 1'b1) begin // ab_flasher.ladder:25
      failed = 1'b1;
      $display("# failed expectation 0 conducts %b ab_light=%b siemens_light=%b at %0s", expect_0, ab_light, siemens_light, "ab_flasher.ladder:25");
    end
    scan(299, 1'b1);
    #1 if (!failed && &expect_1 !== 1'b1) begin // ab_flasher.ladder:27
      failed = 1'b1;
      $display("# failed expectation 1 conducts %b ab_light=%b siemens_light=%b at %0s", expect_1, ab_light, siemens_light, "ab_flasher.ladder:27");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_2 !== 1'b1) begin // ab_flasher.ladder:29
      failed = 1'b1;
      $display("# failed expectation 2 conducts %b ab_light=%b siemens_light=%b at %0s", expect_2, ab_light, siemens_light, "ab_flasher.ladder:29");
    end
    scan(1, 1'b1);
    #1 if (!failed && &expect_3 !== 1'b1) begin // ab_flasher.ladder:31
      failed = 1'b1;
      $display("# failed expectation 3 conducts %b ab_light=%b siemens_light=%b at %0s", expect_3, ab_light, siemens_light, "ab_flasher.ladder:31");
    end
    repeat (2) begin
      scan(1, 1'b1);
      scan(499, 1'b1);
      #1 if (!failed && &expect_4 !== 1'b1) begin // ab_flasher.ladder:35
        failed = 1'b1;
        $display("# failed expectation 4 conducts %b ab_light=%b siemens_light=%b at %0s", expect_4, ab_light, siemens_light, "ab_flasher.ladder:35");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_5 !== 1'b1) begin // ab_flasher.ladder:37
        failed = 1'b1;
        $display("# failed expectation 5 conducts %b ab_light=%b siemens_light=%b at %0s", expect_5, ab_light, siemens_light, "ab_flasher.ladder:37");
      end
      scan(300, 1'b1);
      #1 if (!failed && &expect_6 !== 1'b1) begin // ab_flasher.ladder:39
        failed = 1'b1;
        $display("# failed expectation 6 conducts %b ab_light=%b siemens_light=%b at %0s", expect_6, ab_light, siemens_light, "ab_flasher.ladder:39");
      end
      scan(1, 1'b1);
      #1 if (!failed && &expect_7 !== 1'b1) begin // ab_flasher.ladder:41
        failed = 1'b1;
        $display("# failed expectation 7 conducts %b ab_light=%b siemens_light=%b at %0s", expect_7, ab_light, siemens_light, "ab_flasher.ladder:41");
      end
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 1 - %0s", "both flash alike, for three periods");
    end else $display("ok 1 - %0s", "both flash alike, for three periods");

    // the light goes out at once
    failed = 1'b0;
    reset;
    enable = 1'd1;
    scan(1, 1'b0);
    scan(600, 1'b1);
    #1 if (!failed && &expect_8 !== 1'b1) begin // ab_flasher.ladder:47
      failed = 1'b1;
      $display("# failed expectation 8 conducts %b ab_light=%b siemens_light=%b at %0s", expect_8, ab_light, siemens_light, "ab_flasher.ladder:47");
    end
    enable = 1'd0;
    scan(1, 1'b0);
    #1 if (!failed && &expect_9 !== 1'b1) begin // ab_flasher.ladder:49
      failed = 1'b1;
      $display("# failed expectation 9 conducts %b ab_light=%b siemens_light=%b at %0s", expect_9, ab_light, siemens_light, "ab_flasher.ladder:49");
    end
    if (failed) begin
      failures = failures + 1;
      $display("not ok 2 - %0s", "the light goes out at once");
    end else $display("ok 2 - %0s", "the light goes out at once");

    if (failures != 0) $display("# %0d of 2 tests failed", failures);
    $finish;
  end
endmodule
