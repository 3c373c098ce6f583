// SPDX-License-Identifier: Apache-2.0
// One channel of a bilinear filter: four texels, weighted, exact, then rounded once, half up
// (kernel: bilinear in hls/texture/texel_filter.hpp). Between the even and the odd one of
// two neighbours it is even + weight·(odd − even), whichever of them comes first.
//
// Interval 1; texel_o 6 cycles after texels_i and column_weight_i, 3 after row_weight_i, of those
// in which en_i is 1. Three multipliers: two of columns, one of rows.
module hs_texture_filter #(
  parameter int unsigned WeightBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned FilteredBits = hs_formats_pkg::FilteredBits
) (
  input  logic                    clk_i,
  input  logic                    en_i,
  input  logic [4*ColourBits-1:0] texels_i,  // bank 0 last
  input  logic [WeightBits:0]     column_weight_i,  // of the odd column, of 2^WeightBits
  input  logic [WeightBits:0]     row_weight_i,
  output logic [FilteredBits-1:0] texel_o
);
  localparam int unsigned RowBits = ColourBits + WeightBits;
  localparam int unsigned SumBits = RowBits + WeightBits;
  localparam int unsigned Dropped = SumBits - FilteredBits;

  logic [WeightBits:0] column_weight_q;
  logic [2*RowBits-1:0] rows_q;

  // The even row and the odd one.
  for (genvar row = 0; row < 2; row++) begin : gen_row
    logic [ColourBits-1:0] even, odd, even_q, even_q2;
    logic signed [ColourBits:0] difference_q;
    logic signed [RowBits:0] product_q;

    assign {odd, even} = texels_i[2*row*ColourBits +: 2*ColourBits];
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        even_q <= even;
        difference_q <= $signed({1'b0, odd}) - $signed({1'b0, even});
        even_q2 <= even_q;
        product_q <= (RowBits + 1)'(difference_q) * $signed((RowBits + 1)'(column_weight_q));
        rows_q[row*RowBits +: RowBits] <= {even_q2, {WeightBits{1'b0}}} + product_q[RowBits-1:0];
      end
    end
    logic unused_sign;
    assign unused_sign = product_q[RowBits];
  end

  logic [RowBits-1:0] even_row_q, even_row_q2;
  logic signed [RowBits:0] step_q;
  logic signed [SumBits:0] product_q;
  logic [WeightBits:0] row_weight_q;
  logic [SumBits-1:0] sum;
  logic [FilteredBits-1:0] texel_q;
  logic unused_bits;

  assign sum = {even_row_q2, {WeightBits{1'b0}}} + product_q[SumBits-1:0]
               + (SumBits'(1) << (Dropped - 1));
  assign unused_bits = ^{product_q[SumBits], sum[Dropped-1:0]};

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      column_weight_q <= column_weight_i;

      row_weight_q <= row_weight_i;
      even_row_q <= rows_q[0 +: RowBits];
      step_q <= $signed({1'b0, rows_q[RowBits +: RowBits]}) - $signed({1'b0, rows_q[0 +: RowBits]});

      even_row_q2 <= even_row_q;
      product_q <= (SumBits + 1)'(step_q) * $signed((SumBits + 1)'(row_weight_q));

      texel_q <= sum[SumBits-1 -: FilteredBits];
    end
  end

  assign texel_o = texel_q;
endmodule
