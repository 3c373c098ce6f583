// SPDX-License-Identifier: Apache-2.0
// The dot product of two vectors of three signed components, exact in SumBits.
// Interval 1, latency 2 cycles, of those in which en_i is 1. Three multipliers.
module hs_light_dot #(
  parameter int unsigned ABits,
  parameter int unsigned BBits,
  parameter int unsigned SumBits
) (
  input  logic                      clk_i,
  input  logic                      en_i,
  input  logic [3*ABits-1:0]        a_i,  // {x, y, z}
  input  logic [3*BBits-1:0]        b_i,
  output logic signed [SumBits-1:0] sum_o
);
  localparam int unsigned ProductBits = ABits + BBits;

  logic [3*SumBits-1:0] products;
  logic signed [SumBits-1:0] sum_q;

  for (genvar c = 0; c < 3; c++) begin : gen_component
    logic signed [ABits-1:0] a;
    logic signed [BBits-1:0] b;
    logic signed [ProductBits-1:0] product_q;
    assign a = a_i[c*ABits +: ABits];
    assign b = b_i[c*BBits +: BBits];
    always_ff @(posedge clk_i) begin
      if (en_i) product_q <= a * b;
    end
    assign products[c*SumBits +: SumBits] = SumBits'(product_q);
  end

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      sum_q <= products[2*SumBits +: SumBits] + products[SumBits +: SumBits]
               + products[0 +: SumBits];
    end
  end

  assign sum_o = sum_q;
endmodule
