// SPDX-License-Identifier: Apache-2.0
// A weighted sum along an axis, exact (kernel: filtered_channel in hls/motion/key_filter.hpp). The
// weights sum to 1, so that the value before the place, B, needs no product: 2^w·B + Σ
// weight·(value − B).
//
// Interval 1, latency 3, of cycles in which en_i is 1. One multiplier for two values, three for
// four.
module hs_key_axis #(
  parameter int unsigned ValueBits,
  parameter int unsigned SumBits,
  parameter int unsigned TapWeightBits,
  localparam int unsigned Taps = hs_formats_pkg::KeyTaps
) (
  input  logic                              clk_i,
  input  logic                              en_i,
  input  logic [Taps*ValueBits-1:0]         values_i,  // signed, the first one last
  input  logic [(Taps-1)*TapWeightBits-1:0] weights_i,
  output logic [SumBits-1:0]                sum_o  // signed
);
  localparam int unsigned Base = Taps == 4 ? 1 : 0;
  localparam int unsigned ProductBits = ValueBits + 1 + TapWeightBits;
  localparam int unsigned WeightBits = TapWeightBits - 2;

  logic signed [ValueBits-1:0] base, base_q, base_q2;
  logic [(Taps-1)*SumBits-1:0] products;
  logic signed [SumBits-1:0] total;

  assign base = values_i[Base*ValueBits +: ValueBits];

  for (genvar i = 0; i < Taps - 1; i++) begin : gen_product
    localparam int unsigned Tap = i < Base ? i : i + 1;
    logic signed [ValueBits-1:0] value;
    logic signed [ValueBits:0] difference_q;
    logic signed [TapWeightBits-1:0] weight_q;
    logic signed [ProductBits-1:0] product_q;
    logic unused_product;

    assign value = values_i[Tap*ValueBits +: ValueBits];
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        difference_q <= {value[ValueBits-1], value} - {base[ValueBits-1], base};
        weight_q <= weights_i[i*TapWeightBits +: TapWeightBits];
        product_q <= difference_q * weight_q;
      end
    end
    assign unused_product = ^product_q;  // the sum has room for less
    assign products[i*SumBits +: SumBits] = SumBits'(product_q);
  end

  always_comb begin
    total = SumBits'(base_q2) <<< WeightBits;
    for (int unsigned i = 0; i < Taps - 1; i++) total += products[i*SumBits +: SumBits];
  end

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      base_q <= base;
      base_q2 <= base_q;
      sum_o <= total;
    end
  end
endmodule
