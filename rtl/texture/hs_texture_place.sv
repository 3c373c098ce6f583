// SPDX-License-Identifier: Apache-2.0
// Where a pixel lies along one side of its texture, modulo that side (kernel: texel_place in
// hls/texture/texel_fetch.hpp): scaled · 2^(total − Point) texels. For the nearest texel its
// number; for a bilinear filter, half a texel to the left, with WeightBits fraction bits, rounded.
//
// Interval 1; place_o 3 cycles after scaled_i and total_i, 1 after log2_side_i, of those in which
// en_i is 1.
module hs_texture_place #(
  parameter int unsigned ScaledBits,
  parameter int unsigned Point,
  parameter int unsigned TotalBits,
  localparam int unsigned Bilinear = hs_formats_pkg::Bilinear,
  localparam int unsigned AddressBits = hs_formats_pkg::TexelAddressBits,
  localparam int unsigned SideBits = hs_formats_pkg::SideBits,
  localparam int unsigned WeightBits = hs_formats_pkg::WeightBits,
  localparam int unsigned PlaceBits = AddressBits + (Bilinear != 0 ? WeightBits : 0)
) (
  input  logic                  clk_i,
  input  logic                  en_i,
  input  logic [ScaledBits-1:0] scaled_i,
  input  logic [TotalBits-1:0]  total_i,
  input  logic [SideBits-1:0]   log2_side_i,
  output logic [PlaceBits-1:0]  place_o
);
  // Bits above are whole textures; those below the window change nothing.
  localparam int unsigned ShiftedBits = Point + AddressBits;
  localparam int unsigned WindowBits = PlaceBits + (Bilinear != 0 ? 1 : 0);

  logic [ShiftedBits-1:0] coarse_q, shifted;
  logic [2:0] fine_q;
  logic [WindowBits-1:0] window_q;
  logic [PlaceBits-1:0] place, outside, place_q;
  logic unused_below;

  assign shifted = coarse_q << fine_q;
  assign unused_below = ^shifted[ShiftedBits-WindowBits-1:0];

  if (Bilinear != 0) begin : gen_bilinear
    // The bit below rounds.
    assign place = window_q[WindowBits-1:1] + PlaceBits'(window_q[0])
                   - (PlaceBits'(1) << (WeightBits - 1));
    assign outside = ({PlaceBits{1'b1}} << WeightBits) << log2_side_i;
  end else begin : gen_nearest
    assign place = window_q;
    assign outside = {PlaceBits{1'b1}} << log2_side_i;
  end

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      coarse_q <= ShiftedBits'(scaled_i) << {total_i[TotalBits-1:3], 3'b000};
      fine_q <= total_i[2:0];
      window_q <= shifted[ShiftedBits-1 -: WindowBits];
      place_q <= place & ~outside;
    end
  end

  assign place_o = place_q;
endmodule
