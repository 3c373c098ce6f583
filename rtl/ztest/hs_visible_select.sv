// SPDX-License-Identifier: Apache-2.0
// Deferred shading, after hls/ztest/visible_select.hpp: the attributes of a triangle meet the word
// of the Z-test. Geometry hears the word; the attributes go on if the triangle is visible or the
// last, and `empty` is then that it is not visible.
//
// Interval 1, latency 0. Attributes and word come in one order, one of each a triangle, and are
// taken together. Fork: each output stays until taken, and the next pair waits for both.
module hs_visible_select (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // From triangle_setup, through a queue of all that are on their way to the Z-test
  input  logic                        attributes_valid_i,
  output logic                        attributes_ready_o,
  input  hs_formats_pkg::attributes_t attributes_i,

  // From the Z-test
  input  logic                        visible_valid_i,
  output logic                        visible_ready_o,
  input  hs_formats_pkg::visible_t    visible_i,

  // To geometry
  output logic                        visible_valid_o,
  input  logic                        visible_ready_i,
  output hs_formats_pkg::visible_t    visible_o,

  // To shade_setup or phong_setup
  output logic                        visible_attributes_valid_o,
  input  logic                        visible_attributes_ready_i,
  output hs_formats_pkg::attributes_t visible_attributes_o
);
  logic valid, wanted, take;
  logic visible_sent_q, attributes_sent_q;

  assign valid = attributes_valid_i && visible_valid_i;
  assign wanted = visible_i.visible || visible_i.last;
  assign visible_valid_o = valid && !visible_sent_q;
  assign visible_attributes_valid_o = valid && wanted && !attributes_sent_q;
  assign take = valid && (!visible_valid_o || visible_ready_i)
                && (!visible_attributes_valid_o || visible_attributes_ready_i);
  assign attributes_ready_o = take;
  assign visible_ready_o = take;
  assign visible_o = visible_i;

  always_comb begin
    visible_attributes_o = attributes_i;
    visible_attributes_o.empty = !visible_i.visible;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      visible_sent_q <= 1'b0;
      attributes_sent_q <= 1'b0;
    end else if (valid) begin
      visible_sent_q <= !take && (visible_sent_q || visible_ready_i);
      attributes_sent_q <= !take && (attributes_sent_q || visible_attributes_ready_i);
    end
  end
endmodule
