// SPDX-License-Identifier: Apache-2.0
// One channel of a lit colour: the sum over the lights of base + Σ weight·factor, exact, then half
// up and full scale at most (kernel: light_sum and rounded_colour in hls/shade/lighting.hpp).
// Interval 1, latency 3 cycles after the last light, of those in which en_i is 1; first_i, 1 for
// the first light, comes a cycle after its operands. A multiplier a way.
module hs_light_channel #(
  parameter int unsigned Ways,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned CosineBits = hs_formats_pkg::CosineBits,
  localparam int unsigned CoefficientBits = hs_formats_pkg::CoefficientBits
) (
  input  logic                            clk_i,
  input  logic                            en_i,
  input  logic                            first_i,
  input  logic [CoefficientBits-1:0]      base_i,
  input  logic [Ways*CoefficientBits-1:0] weights_i,
  input  logic [Ways*CosineBits-1:0]      factors_i,
  output logic [ColourBits-1:0]           colour_o
);
  localparam int unsigned SumBits = hs_formats_pkg::LightSumBits;
  localparam int unsigned Fraction = hs_formats_pkg::LightSumFraction;
  localparam int unsigned WholeBits = SumBits - Fraction;
  localparam int unsigned ProductBits = CoefficientBits + CosineBits;

  logic [CoefficientBits-1:0] base_q;
  logic [Ways*ProductBits-1:0] products_q;
  logic [SumBits-1:0] sum, sum_q, rounded;
  logic [WholeBits-1:0] whole;
  logic [ColourBits-1:0] colour_q;
  logic unused_fraction;

  for (genvar way = 0; way < Ways; way++) begin : gen_way
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        products_q[way*ProductBits +: ProductBits] <=
            ProductBits'(weights_i[way*CoefficientBits +: CoefficientBits])
            * ProductBits'(factors_i[way*CosineBits +: CosineBits]);
      end
    end
  end

  always_comb begin
    sum = (first_i ? '0 : sum_q) + (SumBits'(base_q) << (CosineBits - 1));
    for (int unsigned way = 0; way < Ways; way++) begin
      sum = sum + SumBits'(products_q[way*ProductBits +: ProductBits]);
    end
  end

  assign rounded = sum_q + (SumBits'(1) << (Fraction - 1));
  assign whole = rounded[SumBits-1:Fraction];
  assign unused_fraction = ^rounded[Fraction-1:0];

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      base_q <= base_i;
      sum_q <= sum;
      colour_q <= whole[WholeBits-1:ColourBits] != '0 ? '1 : whole[ColourBits-1:0];
    end
  end

  assign colour_o = colour_q;
endmodule
