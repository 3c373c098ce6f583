// SPDX-License-Identifier: Apache-2.0
// A unit of one's own in the place of hs_visible_select, written from docs/stages.md and the manifest of the vectors
// alone: it holds a pair of words, and sends each side once.
module own_select #(
  parameter AttributesBits = 1,
  parameter AttributesEmptyLsb = 0,
  parameter VisibleBits = 1,
  parameter VisibleLastLsb = 0,
  parameter VisibleVisibleLsb = 0
) (
  input                           clk_i,
  input                           rst_ni,
  input                           attributes_valid_i,
  output                          attributes_ready_o,
  input      [AttributesBits-1:0] attributes_i,
  input                           tested_valid_i,
  output                          tested_ready_o,
  input      [VisibleBits-1:0]    tested_i,
  output reg                      visible_valid_o,
  input                           visible_ready_i,
  output reg [VisibleBits-1:0]    visible_o,
  output reg                      passed_valid_o,
  input                           passed_ready_i,
  output reg [AttributesBits-1:0] passed_o
);
  wire free = (!visible_valid_o || visible_ready_i) && (!passed_valid_o || passed_ready_i);
  wire take = free && attributes_valid_i && tested_valid_i;
  assign attributes_ready_o = take;
  assign tested_ready_o = take;

  always @(posedge clk_i) begin
    if (visible_ready_i) visible_valid_o <= 1'b0;
    if (passed_ready_i) passed_valid_o <= 1'b0;
    if (take) begin
      visible_valid_o <= 1'b1;
      visible_o <= tested_i;
      passed_valid_o <= tested_i[VisibleVisibleLsb] || tested_i[VisibleLastLsb];
      passed_o <= attributes_i;
      passed_o[AttributesEmptyLsb] <= !tested_i[VisibleVisibleLsb];
    end
    if (!rst_ni) begin
      visible_valid_o <= 1'b0;
      passed_valid_o <= 1'b0;
    end
  end
endmodule
