// SPDX-License-Identifier: Apache-2.0
// The reciprocal of a texture coordinate (kernel: hls/texture/reciprocal_lookup.hpp): normalization
// by bits, a line from a table, one rounding.
//
// Interval 1; shift_o 1 and inverse_o 4 cycles after value_i, of those in which en_i is 1. One
// multiplier of InverseSlopeBits × InverseOffsetBits, and a table of 256 words of 36 bits.
module hs_reciprocal_lookup #(
  parameter int unsigned ValueBits,  // 2 to 32
  localparam int unsigned ShiftBits = hs_formats_pkg::InverseShiftBits,
  localparam int unsigned InverseBits = hs_formats_pkg::InverseBits
) (
  input  logic                   clk_i,
  input  logic                   en_i,
  input  logic [ValueBits-1:0]   value_i,
  output logic [ShiftBits-1:0]   shift_o,
  output logic [InverseBits-1:0] inverse_o
);
  localparam int unsigned IndexBits = hs_formats_pkg::InverseIndexBits;
  localparam int unsigned OffsetBits = hs_formats_pkg::InverseOffsetBits;
  localparam int unsigned LeftBits = hs_formats_pkg::InverseValueFraction;
  localparam int unsigned SlopeBits = hs_formats_pkg::InverseSlopeBits;
  localparam int unsigned EntryBits = LeftBits + SlopeBits;
  localparam int unsigned EntryPlaces = $clog2(EntryBits);
  localparam int unsigned FieldBits = IndexBits + OffsetBits;
  localparam int unsigned LineBits = LeftBits + OffsetBits;
  localparam int unsigned Dropped = LineBits - InverseBits;
  localparam int unsigned Top = ValueBits - 1;
  localparam int unsigned Steps = 5;

  // Normalization, by 16 bits, 8, 4, 2 and 1.
  logic [ValueBits-1:0] normalized, value_q;
  logic [Steps-1:0] places;
  logic [ShiftBits-1:0] shift_q;

  always_comb begin
    normalized = value_i;
    places = '0;
    for (int unsigned i = 0; i < Steps; i++) begin
      if ((16 >> i) <= Top && normalized >> (ValueBits - (16 >> i)) == '0) begin
        normalized = normalized << (16 >> i);
        places[Steps-1-i] = 1'b1;
      end
    end
  end

  // The table, its entries a power of two of bits apart.
  logic [(1<<(IndexBits+EntryPlaces))-1:0] entries;

  for (genvar i = 0; i < 1 << IndexBits; i++) begin : gen_entry
    assign entries[i<<EntryPlaces +: 1<<EntryPlaces] =
        (1 << EntryPlaces)'(hs_formats_pkg::InverseTable[i*EntryBits +: EntryBits]);
  end

  // It is read by the top of the field; a short value has zeros below it.
  logic [Top+FieldBits-1:0] below;
  logic [FieldBits-1:0] field;
  logic [IndexBits-1:0] index;
  logic [EntryBits-1:0] entry_q;
  logic [OffsetBits-1:0] offset_q;
  logic [LeftBits-1:0] left_q;
  logic [SlopeBits+OffsetBits-1:0] product_q;
  logic [LineBits-1:0] line;
  logic [InverseBits-1:0] inverse_q;
  logic unused_bits;

  assign below = {value_q[Top-1:0], {FieldBits{1'b0}}};
  assign field = below[Top+FieldBits-1 -: FieldBits];
  assign index = field[FieldBits-1 -: IndexBits];
  assign line = {left_q, {OffsetBits{1'b0}}} - LineBits'(product_q)
                + (LineBits'(1) << (Dropped - 1));

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      value_q <= normalized;
      shift_q <= ShiftBits'(places);

      entry_q <= entries[{index, {EntryPlaces{1'b0}}} +: EntryBits];
      offset_q <= field[OffsetBits-1:0];

      left_q <= entry_q[EntryBits-1 -: LeftBits];
      product_q <= (SlopeBits + OffsetBits)'(entry_q[SlopeBits-1:0])
                   * (SlopeBits + OffsetBits)'(offset_q);

      inverse_q <= line[LineBits-1 -: InverseBits];
    end
  end

  assign shift_o = shift_q;
  assign inverse_o = inverse_q;
  assign unused_bits = ^{places, value_q[Top], below[Top-1:0], line[Dropped-1:0]};
endmodule
