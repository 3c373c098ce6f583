// SPDX-License-Identifier: Apache-2.0
// The weights of an axis at a fraction, from the tables of the package (kernel: hls/key_filter.hpp): of
// all pixels but the one before the place, whose weight is what they leave of 1.
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

  always_ff @(posedge clk_i) begin
    if (en_i) inner_q <= hs_formats_pkg::KeyInnerTable[fraction_i*InnerBits +: InnerBits];
  end
  assign inner = TapWeightBits'(inner_q);

  if (Taps == 4) begin : gen_outer
    logic [OuterBits-1:0] outer_q;
    always_ff @(posedge clk_i) begin
      if (en_i) outer_q <= hs_formats_pkg::KeyOuterTable[fraction_i*OuterBits +: OuterBits];
    end
    assign weights_o = all_i ? outer_q : OuterBits'({inner, TapWeightBits'(0)});
  end else begin : gen_inner
    logic unused_all;
    assign unused_all = all_i;
    assign weights_o = inner;
  end
endmodule
