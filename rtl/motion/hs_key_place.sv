// SPDX-License-Identifier: Apache-2.0
// Where a pixel in between lies in a key frame along one axis, and which of its pixels a filter
// takes there (kernel: key_axis in hls/motion/key_place.hpp).
//
// Interval 1, latency 2, of cycles in which en_i is 1, which is their only stall.
// The first pixel may lie before the frame, the last behind it; the tiles are those of what is
// inside.
module hs_key_place #(
  parameter int unsigned SideBits,  // of a coordinate, and of a size
  parameter int unsigned TileBits,
  localparam int unsigned VectorBits = hs_formats_pkg::VectorBits,
  localparam int unsigned FractionBits = hs_formats_pkg::KeyFractionBits,
  localparam int unsigned Taps = hs_formats_pkg::KeyTaps
) (
  input  logic                    clk_i,
  input  logic                    en_i,
  input  logic [SideBits-1:0]     size_i,   // of the frame in between
  input  logic [SideBits-1:0]     pixel_i,
  input  logic [VectorBits-1:0]   vector_i,

  output logic [3:0]              first_o,  // the last bits of the first pixel's number
  output logic [Taps-1:0]         inside_o,
  output logic [TileBits-1:0]     tile_first_o,
  output logic [TileBits-1:0]     tile_last_o,
  output logic [FractionBits-1:0] fraction_o
);
  localparam int unsigned PlaceBits = hs_formats_pkg::KeyPlaceBits;
  localparam int unsigned VectorFraction = hs_formats_pkg::VectorFraction;
  localparam int unsigned Log2Samples = FractionBits - VectorFraction;
  // Room for the pixels before and behind, and four bits at least.
  localparam int unsigned ColumnBits = PlaceBits - FractionBits + 4;
  localparam int unsigned Before = Taps == 4 ? 1 : 0;
  localparam logic [PlaceBits-1:0] Half = PlaceBits'(Taps == 1 ? 0 : 1) << (FractionBits - 1);

  logic [PlaceBits-1:0] place_q;
  logic [SideBits:0] size;
  logic signed [ColumnBits-1:0] key_size, column, first, last, end_last;
  logic [Taps-1:0] is_inside;
  logic [ColumnBits-1:0] first_inside, last_inside;
  logic unused_bits;

  assign size = {1'b0, size_i} + (SideBits + 1)'((1 << Log2Samples) - 1);
  assign key_size = ColumnBits'(size) >> Log2Samples;
  assign column = {{4{place_q[PlaceBits-1]}}, place_q[PlaceBits-1:FractionBits]};
  assign first = column - ColumnBits'(Before);
  assign last = first + ColumnBits'(Taps - 1);
  assign end_last = key_size - ColumnBits'(1);

  for (genvar i = 0; i < Taps; i++) begin : gen_tap
    logic signed [ColumnBits-1:0] at;
    assign at = first + ColumnBits'(i);
    assign is_inside[i] = !at[ColumnBits-1] && at < key_size;
  end

  assign first_inside = first[ColumnBits-1] ? '0 : first;
  assign last_inside = last > end_last ? end_last : last;
  assign unused_bits = ^{first_inside, last_inside};

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      place_q <= (PlaceBits'({pixel_i, 1'b1}) << (VectorFraction - 1))
                 + {{(PlaceBits - VectorBits) {vector_i[VectorBits-1]}}, vector_i} - Half;

      first_o <= first[3:0];
      inside_o <= is_inside;
      tile_first_o <= TileBits'(first_inside >> 3);
      tile_last_o <= TileBits'(last_inside >> 3);
      fraction_o <= place_q[FractionBits-1:0];
    end
  end
endmodule
