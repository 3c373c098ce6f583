// SPDX-License-Identifier: Apache-2.0
// The depth plane of each triangle whose walk begins, from its setup: what hs_raster_pineda sends
// where the Z-test evaluates planes (type gamma).
//
// A word a walk; the output is a register. Stall: free_o falls while a word is not taken; load_i
// waits for it.
module hs_raster_plane #(
  parameter int unsigned PlaneBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned WordBits = IndexBits + XBits + YBits + 3 * PlaneBits
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  // From hs_raster_pineda
  output logic                   free_o,
  input  logic                   load_i,
  input  hs_formats_pkg::index_t index_i,
  input  hs_formats_pkg::x_t     x_i,
  input  hs_formats_pkg::y_t     y_i,
  input  logic [PlaneBits-1:0]   depth_i,
  input  logic [PlaneBits-1:0]   dx_i,
  input  logic [PlaneBits-1:0]   dy_i,

  // To ztest_plane
  output logic                   valid_o,
  input  logic                   ready_i,
  output logic [WordBits-1:0]    word_o
);
  logic valid_q;
  logic [WordBits-1:0] word_q;

  assign free_o = !valid_q || ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (free_o) valid_q <= load_i;
  end

  always_ff @(posedge clk_i) begin
    if (load_i) word_q <= {index_i, x_i, y_i, depth_i, dx_i, dy_i};
  end

  assign valid_o = valid_q;
  assign word_o = word_q;
endmodule
