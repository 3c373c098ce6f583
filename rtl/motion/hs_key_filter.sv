// SPDX-License-Identifier: Apache-2.0
// One channel of a key frame's pixels, weighted by columns, then by rows: exact (kernel:
// filtered_channel in hls/motion/key_filter.hpp).
//
// Interval 1, latency 6, of cycles in which en_i is 1. Multipliers: 3 for two by two pixels, 15 for
// four by four.
module hs_key_filter #(
  parameter int unsigned TapWeightBits,
  localparam int unsigned Taps = hs_formats_pkg::KeyTaps,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned SumBits = hs_formats_pkg::KeySumBits
) (
  input  logic                              clk_i,
  input  logic                              en_i,
  input  logic [Taps*Taps*ColourBits-1:0]   colours_i,  // in rows, the first pixel last
  input  logic [(Taps-1)*TapWeightBits-1:0] columns_i,
  input  logic [(Taps-1)*TapWeightBits-1:0] rows_i,
  output logic [SumBits-1:0]                sum_o
);
  // A bicubic row lies in (−½, 3/2) of full scale.
  localparam int unsigned RowBits = ColourBits + TapWeightBits;
  localparam int unsigned WeightsBits = (Taps - 1) * TapWeightBits;

  logic [Taps*RowBits-1:0] rows;
  logic [3*WeightsBits-1:0] rows_q;

  for (genvar row = 0; row < Taps; row++) begin : gen_row
    logic [Taps*(ColourBits+1)-1:0] values;
    for (genvar i = 0; i < Taps; i++) begin : gen_value
      assign values[i*(ColourBits+1) +: ColourBits+1] =
          {1'b0, colours_i[(row*Taps+i)*ColourBits +: ColourBits]};
    end
    hs_key_axis #(
      .ValueBits    (ColourBits + 1),
      .SumBits      (RowBits),
      .TapWeightBits(TapWeightBits)
    ) u_row (
      .clk_i    (clk_i),
      .en_i     (en_i),
      .values_i (values),
      .weights_i(columns_i),
      .sum_o    (rows[row*RowBits +: RowBits])
    );
  end

  always_ff @(posedge clk_i) begin
    if (en_i) rows_q <= {rows_q[2*WeightsBits-1:0], rows_i};
  end

  hs_key_axis #(
    .ValueBits    (RowBits),
    .SumBits      (SumBits),
    .TapWeightBits(TapWeightBits)
  ) u_column (
    .clk_i    (clk_i),
    .en_i     (en_i),
    .values_i (rows),
    .weights_i(rows_q[2*WeightsBits +: WeightsBits]),
    .sum_o    (sum_o)
  );
endmodule
