// SPDX-License-Identifier: Apache-2.0
// x^(2^k), k up to Squarings, for x of 0 … 1 (kernel: power in hls/shade/lighting.hpp).
// Interval 1, latency 2·Squarings cycles, of those in which en_i is 1. Squarings multipliers.
module hs_light_power #(
  parameter int unsigned Squarings,  // 1 or more
  parameter int unsigned GlossBits,
  parameter int unsigned CosineBits
) (
  input  logic                  clk_i,
  input  logic                  en_i,
  input  logic [GlossBits-1:0]  gloss_i,  // k
  input  logic [CosineBits-1:0] cosine_i,
  output logic [CosineBits-1:0] power_o
);
  localparam int unsigned Fraction = CosineBits - 1;

  logic [(Squarings+1)*CosineBits-1:0] powers;
  logic [(Squarings+1)*GlossBits-1:0] glosses;
  logic unused_gloss;

  assign powers[0 +: CosineBits] = cosine_i;
  assign glosses[0 +: GlossBits] = gloss_i;
  for (genvar j = 0; j < Squarings; j++) begin : gen_square
    logic [CosineBits-1:0] x, x_q, x_q2;
    logic [GlossBits-1:0] gloss_q, gloss_q2;
    logic [2*CosineBits-1:0] square_q, sum;
    logic unused_bits;

    assign x = powers[j*CosineBits +: CosineBits];
    assign sum = square_q + ((2 * CosineBits)'(1) << (Fraction - 1));
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        x_q <= x;
        gloss_q <= glosses[j*GlossBits +: GlossBits];
        square_q <= (2 * CosineBits)'(x) * (2 * CosineBits)'(x);
        x_q2 <= gloss_q > GlossBits'(j) ? sum[Fraction +: CosineBits] : x_q;
        gloss_q2 <= gloss_q;
      end
    end
    assign powers[(j+1)*CosineBits +: CosineBits] = x_q2;
    assign glosses[(j+1)*GlossBits +: GlossBits] = gloss_q2;
    assign unused_bits = ^{sum[2*CosineBits-1], sum[Fraction-1:0]};
  end

  assign power_o = powers[Squarings*CosineBits +: CosineBits];
  assign unused_gloss = ^glosses[Squarings*GlossBits +: GlossBits];
endmodule
