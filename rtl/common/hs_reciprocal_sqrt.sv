// SPDX-License-Identifier: Apache-2.0
// The reciprocal of a length from its square (kernel: hls/shade/reciprocal_sqrt.hpp): normalization
// by pairs of bits, a line from a table, one rounding.
//
// Interval 1; shift_o 1 and root_o 4 cycles after length_i, of those in which en_i is 1. One
// multiplier of RootSlopeBits × RootOffsetBits, and a table of 256 words of 32 bits.
module hs_reciprocal_sqrt #(
  parameter int unsigned LengthBits,  // even, 20 or more
  localparam int unsigned ShiftBits = hs_formats_pkg::RootShiftBits,
  localparam int unsigned RootBits = hs_formats_pkg::RootBits
) (
  input  logic                  clk_i,
  input  logic                  en_i,
  input  logic [LengthBits-1:0] length_i,
  output logic [ShiftBits-1:0]  shift_o,
  output logic [RootBits-1:0]   root_o
);
  localparam int unsigned IndexBits = hs_formats_pkg::RootIndexBits;
  localparam int unsigned OffsetBits = hs_formats_pkg::RootOffsetBits;
  localparam int unsigned ValueBits = hs_formats_pkg::RootValueFraction;
  localparam int unsigned SlopeBits = hs_formats_pkg::RootSlopeBits;
  localparam int unsigned EntryBits = ValueBits + SlopeBits;
  localparam int unsigned EntryPlaces = $clog2(EntryBits);
  localparam int unsigned FieldBits = IndexBits + OffsetBits;
  localparam int unsigned LineBits = ValueBits + OffsetBits;
  localparam int unsigned Dropped = LineBits - RootBits;
  localparam int unsigned Top = LengthBits - 1;
  localparam int unsigned Steps = 5;

  if (EntryBits != 1 << EntryPlaces) begin : gen_entry_illegal
    $error("hs_reciprocal_sqrt: an entry of the table is a power of two of bits");
  end

  // Normalization, by 16 pairs of bits, 8, 4, 2 and 1.
  logic [LengthBits-1:0] normalized, length_q, aligned;
  logic [Steps-1:0] places;
  logic [ShiftBits-1:0] shift_q;

  always_comb begin
    normalized = length_i;
    places = '0;
    for (int unsigned i = 0; i < Steps; i++) begin
      if ((32 >> i) <= Top && normalized >> (LengthBits - (32 >> i)) == '0) begin
        normalized = normalized << (32 >> i);
        places[Steps-1-i] = 1'b1;
      end
    end
  end

  // The table: index {octave, top of the field}.
  logic [IndexBits:0] index;
  logic [FieldBits-1:0] field;
  logic [EntryBits-1:0] entry_q;
  logic [OffsetBits-1:0] offset_q;
  logic [ValueBits-1:0] value_q;
  logic [SlopeBits+OffsetBits-1:0] product_q;
  logic [LineBits-1:0] line;
  logic [RootBits-1:0] root_q;
  logic unused_bits;

  assign aligned = length_q[Top] ? length_q : length_q << 1;
  assign field = aligned[Top-1 -: FieldBits];
  assign index = {length_q[Top], field[FieldBits-1 -: IndexBits]};
  assign line = {value_q, {OffsetBits{1'b0}}} - LineBits'(product_q)
                + (LineBits'(1) << (Dropped - 1));

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      length_q <= normalized;
      shift_q <= ShiftBits'(places);

      entry_q <= hs_formats_pkg::RootTable[{index, {EntryPlaces{1'b0}}} +: EntryBits];
      offset_q <= field[OffsetBits-1:0];

      value_q <= entry_q[EntryBits-1 -: ValueBits];
      product_q <= (SlopeBits + OffsetBits)'(entry_q[SlopeBits-1:0])
                   * (SlopeBits + OffsetBits)'(offset_q);

      root_q <= line[LineBits-1 -: RootBits];
    end
  end

  assign shift_o = shift_q;
  assign root_o = root_q;
  assign unused_bits = ^{places, aligned, line[Dropped-1:0]};
endmodule
