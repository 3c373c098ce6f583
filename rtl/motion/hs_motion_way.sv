// SPDX-License-Identifier: Apache-2.0
// From a pixel's centre to the place of the same point in a key frame, along one axis, in units of
// 2^−VectorFraction pixels (kernel: way_to in hls/motion/motion_field.hpp): scaled · 2^(extent −
// Point) pixels from the origin, rounded half up.
//
// Interval 1, latency 3 cycles, of those in which en_i is 1.
module hs_motion_way #(
  parameter int unsigned ScaledBits,
  parameter int unsigned Point,  // fraction bits of scaled_i
  localparam int unsigned OriginBits = hs_formats_pkg::OriginBits,
  localparam int unsigned ExtentBits = hs_formats_pkg::ExtentBits,
  localparam int unsigned VectorBits = hs_formats_pkg::VectorBits
) (
  input  logic                         clk_i,
  input  logic                         en_i,
  input  logic [ScaledBits-1:0]        scaled_i,
  input  logic [ExtentBits-1:0]        extent_i,  // OriginBits at most
  input  logic signed [OriginBits-1:0] origin_i,
  input  logic [OriginBits-1:0]        pixel_i,
  output logic                         fits_o,
  output logic [VectorBits-1:0]        vector_o  // if it fits
);
  localparam int unsigned Fraction = hs_formats_pkg::VectorFraction;
  // Twice the offset in its units: of the largest extent, scaled_i with Point − Head fraction bits.
  localparam int unsigned Head = OriginBits + Fraction + 1;
  localparam int unsigned Left = Head > Point ? Head - Point : 0;
  localparam int unsigned Dropped = Point > Head ? Point - Head : 0;
  localparam int unsigned TwiceBits = ScaledBits + Left - Dropped;
  // The offset is below 2^(TwiceBits − 1), and origin less pixel has a bit more than either.
  localparam int unsigned WholeBits = OriginBits + 1;
  localparam int unsigned PlaceBits = WholeBits + Fraction;
  localparam int unsigned SumBits = TwiceBits > PlaceBits ? TwiceBits : PlaceBits;
  localparam int unsigned WayBits = (SumBits > VectorBits ? SumBits : VectorBits) + 1;

  logic [ScaledBits+Left-1:0] widened;
  logic [5:0] places;
  logic [TwiceBits-1:0] coarse_q, twice_q;
  logic [2:0] fine_q;
  logic signed [WholeBits-1:0] whole_q, whole_q2;
  logic [WayBits-1:0] way_q;
  logic unused_dropped;

  assign widened = (ScaledBits+Left)'(scaled_i) << Left;
  assign unused_dropped = ^widened;
  assign places = 6'(OriginBits) - 6'(extent_i);

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      coarse_q <= widened[ScaledBits+Left-1 -: TwiceBits] >> {places[5:3], 3'b000};
      fine_q <= places[2:0];
      whole_q <= WholeBits'(origin_i) - $signed({1'b0, pixel_i});

      twice_q <= coarse_q >> fine_q;
      whole_q2 <= whole_q;

      // Half up; the centre is ½ from where the pixel begins.
      way_q <= WayBits'(twice_q[TwiceBits-1:1]) + WayBits'(twice_q[0])
               + (WayBits'(whole_q2) << Fraction) - (WayBits'(1) << (Fraction - 1));
    end
  end

  // The bits above are its sign.
  assign fits_o = &way_q[WayBits-1:VectorBits-1] || !(|way_q[WayBits-1:VectorBits-1]);
  assign vector_o = way_q[VectorBits-1:0];
endmodule
