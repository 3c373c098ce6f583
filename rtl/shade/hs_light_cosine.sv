// SPDX-License-Identifier: Apache-2.0
// max(0, n·a / |n|), 1 at most, from the dot product and what hs_reciprocal_sqrt makes of |n|²
// (kernel: cosine in hls/shade/lighting.hpp); 0 where enable_i is 0.
//
// Interval 1; cosine_o 6 cycles after dot_i and enable_i, 5 after shift_i, 2 after root_i, of those
// in which en_i is 1. One multiplier.
module hs_light_cosine #(
  parameter int unsigned NormalBits,
  localparam int unsigned DotBits = hs_formats_pkg::DotBits,
  localparam int unsigned ShiftBits = hs_formats_pkg::RootShiftBits,
  localparam int unsigned RootBits = hs_formats_pkg::RootBits,
  localparam int unsigned CosineBits = hs_formats_pkg::CosineBits
) (
  input  logic                      clk_i,
  input  logic                      en_i,
  input  logic                      enable_i,
  input  logic signed [DotBits-1:0] dot_i,
  input  logic [ShiftBits-1:0]      shift_i,
  input  logic [RootBits-1:0]       root_i,
  output logic [CosineBits-1:0]     cosine_o
);
  localparam int unsigned ScaledBits = DotBits - 1;  // of n with |n| below 2: no bit is lost
  localparam int unsigned ProductBits = CosineBits + RootBits;

  logic [ScaledBits-1:0] dot_q, scaled;
  logic [CosineBits:0] rounded;
  logic [CosineBits-1:0] projection_q, projection_q2, projection_q3, cosine, cosine_q;
  logic [ProductBits-1:0] product_q, sum;
  logic unused_fraction;

  assign scaled = (dot_q << shift_i) + (ScaledBits'(1) << (NormalBits - 1));
  assign rounded = scaled[ScaledBits-1:NormalBits];
  assign sum = product_q + (ProductBits'(1) << (RootBits - 1));
  assign cosine = sum[ProductBits-1 -: CosineBits];
  assign unused_fraction = ^{scaled[NormalBits-1:0], sum[RootBits-1:0]};

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      dot_q <= enable_i && dot_i > 0 ? dot_i[ScaledBits-1:0] : '0;
      projection_q <= rounded[CosineBits] ? '1 : rounded[CosineBits-1:0];
      projection_q2 <= projection_q;
      projection_q3 <= projection_q2;
      product_q <= ProductBits'(projection_q3) * ProductBits'(root_i);
      cosine_q <= cosine[CosineBits-1] ? {1'b1, {(CosineBits - 1) {1'b0}}} : cosine;
    end
  end

  assign cosine_o = cosine_q;
endmodule
