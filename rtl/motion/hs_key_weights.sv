// SPDX-License-Identifier: Apache-2.0
// The weights of an axis at a fraction, from the tables of the package (kernel:
// hls/motion/key_weights.hpp): of all pixels but the one before the place, whose weight is what
// they leave of 1.
//
// Interval 1, latency 1, of cycles in which en_i is 1; all_i one such cycle after fraction_i.
module hs_key_weights #(
  parameter int unsigned TapWeightBits,
  localparam int unsigned Taps = hs_formats_pkg::KeyTaps,
  localparam int unsigned FractionBits = hs_formats_pkg::KeyFractionBits
) (
  input  logic                               clk_i,
  input  logic                               en_i,
  input  logic [FractionBits-1:0]            fraction_i,
  input  logic                               all_i,  // bicubic: all pixels match
  output logic [(Taps-1)*TapWeightBits-1:0]  weights_o  // signed; in order, the first one last
);
  localparam int unsigned InnerBits = hs_formats_pkg::KeyWeightBits;
  localparam int unsigned OuterBits = 3 * TapWeightBits;
  logic [InnerBits-1:0] inner_q;
  logic [TapWeightBits-1:0] inner;

  // The tables, their entries a power of two of bits apart.
  localparam int unsigned InnerPlaces = $clog2(InnerBits), OuterPlaces = $clog2(OuterBits);
  logic [(1<<(FractionBits+InnerPlaces))-1:0] inner_entries;
  for (genvar i = 0; i < 1 << FractionBits; i++) begin : gen_inner_entry
    assign inner_entries[i<<InnerPlaces +: 1<<InnerPlaces] =
        (1 << InnerPlaces)'(hs_formats_pkg::KeyInnerTable[i*InnerBits +: InnerBits]);
  end

  always_ff @(posedge clk_i) begin
    if (en_i) inner_q <= inner_entries[{fraction_i, InnerPlaces'(0)} +: InnerBits];
  end
  assign inner = TapWeightBits'(inner_q);

  if (Taps == 4) begin : gen_outer
    logic [(1<<(FractionBits+OuterPlaces))-1:0] outer_entries;
    logic [OuterBits-1:0] outer_q;
    for (genvar i = 0; i < 1 << FractionBits; i++) begin : gen_outer_entry
      assign outer_entries[i<<OuterPlaces +: 1<<OuterPlaces] =
          (1 << OuterPlaces)'(hs_formats_pkg::KeyOuterTable[i*OuterBits +: OuterBits]);
    end
    always_ff @(posedge clk_i) begin
      if (en_i) outer_q <= outer_entries[{fraction_i, OuterPlaces'(0)} +: OuterBits];
    end
    assign weights_o = all_i ? outer_q : OuterBits'({inner, TapWeightBits'(0)});
  end else begin : gen_inner
    logic unused_all;
    assign unused_all = all_i;
    assign weights_o = inner;
  end
endmodule
