// SPDX-License-Identifier: Apache-2.0
// own_select on golden words, in Icarus or Verilator, with nothing of halfspace but the vectors: run in their folder.
`timescale 1ns / 1ns
module bench;
  `include "vectors.svh"
  reg [AttributesBits-1:0] attributes[0:AttributesWords-1], passed[0:VisibleAttributesWords-1];
  reg [VisibleBits-1:0] visible[0:VisibleWords-1];
  wire [AttributesBits-1:0] passed_o;
  wire [VisibleBits-1:0] visible_o;
  wire attributes_ready, tested_ready, visible_valid, passed_valid;
  reg clk = 0, rst_n = 0, visible_ready = 0, passed_ready = 0, attributes_valid = 0, tested_valid = 0;
  reg attributes_taken = 0, tested_taken = 0;
  integer a = 0, t = 0, v = 0, p = 0, wrong = 0, seed = 1, cycles = 0;

  own_select #(.AttributesBits(AttributesBits), .AttributesEmptyLsb(AttributesEmptyLsb), .VisibleBits(VisibleBits),
               .VisibleLastLsb(VisibleLastLsb), .VisibleVisibleLsb(VisibleVisibleLsb)) unit (
    .clk_i(clk), .rst_ni(rst_n),
    .attributes_valid_i(attributes_valid), .attributes_ready_o(attributes_ready), .attributes_i(attributes[a]),
    .tested_valid_i(tested_valid), .tested_ready_o(tested_ready), .tested_i(visible[t]),
    .visible_valid_o(visible_valid), .visible_ready_i(visible_ready), .visible_o(visible_o),
    .passed_valid_o(passed_valid), .passed_ready_i(passed_ready), .passed_o(passed_o));

  always #5 clk = !clk;
  initial begin
    $readmemh("attributes.hex", attributes);
    $readmemh("visible.hex", visible);
    $readmemh("visible_attributes.hex", passed);
    #20 @(negedge clk) rst_n = 1;
  end

  // What was valid or ready is known before the clock's edge; a word that is offered stays until it is taken.
  always @(negedge clk) if (rst_n) begin
    if (!attributes_valid || attributes_taken) attributes_valid <= a < AttributesWords && $random(seed) % 4 != 0;
    if (!tested_valid || tested_taken) tested_valid <= t < VisibleWords && $random(seed) % 4 != 0;
    visible_ready <= $random(seed) % 4 != 0;
    passed_ready <= $random(seed) % 4 != 0;
  end
  always @(posedge clk) if (rst_n) begin
    cycles <= cycles + 1;
    attributes_taken <= attributes_valid && attributes_ready;
    tested_taken <= tested_valid && tested_ready;
    if (attributes_valid && attributes_ready) a <= a + 1;
    if (tested_valid && tested_ready) t <= t + 1;
    if (visible_valid && visible_ready) begin
      if (v >= VisibleWords || visible_o !== visible[v]) wrong <= wrong + 1;
      v <= v + 1;
    end
    if (passed_valid && passed_ready) begin
      if (p >= VisibleAttributesWords || passed_o !== passed[p]) begin
        if (wrong == 0) $display("word %0d of visible_attributes: %h, expected %h", p, passed_o, passed[p]);
        wrong <= wrong + 1;
      end
      p <= p + 1;
    end
    if ((v == VisibleWords && p == VisibleAttributesWords) || cycles > 20 * VisibleWords) begin
      $display("%0d and %0d of %0d and %0d words, %0d wrong", v, p, VisibleWords, VisibleAttributesWords, wrong);
      if (wrong != 0 || v != VisibleWords || p != VisibleAttributesWords) $display("FAIL"); else $display("PASS");
      $finish;
    end
  end
endmodule
