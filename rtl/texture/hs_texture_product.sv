// SPDX-License-Identifier: Apache-2.0
// One channel of a lit colour times a texel, of full scale each (kernel: textured in
// hls/texture/texel_filter.hpp).
//
// Interval 1, latency 1 cycle, of those in which en_i is 1; what follows the register is the sum
// that divides by 2^ColourBits − 1. One multiplier.
module hs_texture_product #(
  parameter int unsigned TexelBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits
) (
  input  logic                  clk_i,
  input  logic                  en_i,
  input  logic [ColourBits-1:0] lit_i,
  input  logic [TexelBits-1:0]  texel_i,  // ColourBits, and fraction bits
  output logic [ColourBits-1:0] colour_o
);
  localparam int unsigned Places = hs_formats_pkg::FilteredBits;
  localparam int unsigned ProductBits = ColourBits + Places;
  // Half a step, and what the division makes of it.
  localparam logic [ProductBits-1:0] Half =
      (ProductBits'(1) << (Places - 1)) + (ProductBits'(1) << (Places - ColourBits - 1));

  logic [ColourBits+TexelBits-1:0] product_q;
  logic [ProductBits-1:0] product, sum;
  logic unused_fraction;

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      product_q <= (ColourBits + TexelBits)'(lit_i) * (ColourBits + TexelBits)'(texel_i);
    end
  end

  assign product = ProductBits'(product_q) << (Places - TexelBits);
  assign sum = product + (product >> ColourBits) + Half;
  assign colour_o = sum[ProductBits-1 -: ColourBits];
  assign unused_fraction = ^sum[Places-1:0];
endmodule
