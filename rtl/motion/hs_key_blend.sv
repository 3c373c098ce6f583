// SPDX-License-Identifier: Apache-2.0
// One channel of both key frames: what the colour in between differs by added to each, blended,
// rounded once, half up, and clamped (kernel: key_colour and blended in
// hls/motion/motion_compensate.hpp).
//
// Interval 1, latency 4, of cycles in which en_i is 1. One multiplier.
module hs_key_blend #(
  parameter int unsigned SumBits,
  localparam int unsigned Relight = hs_formats_pkg::Relight,
  localparam int unsigned DifferenceBits = Relight != 0 ? hs_formats_pkg::DifferenceBits : 1,
  localparam int unsigned KeyWeightBits = hs_formats_pkg::KeyWeightBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits
) (
  input  logic                        clk_i,
  input  logic                        en_i,
  input  logic [SumBits-1:0]          key_0_i,
  input  logic [SumBits-1:0]          key_1_i,
  input  logic [DifferenceBits-1:0]   difference_0_i,  // without relight 0
  input  logic [DifferenceBits-1:0]   difference_1_i,
  input  logic [KeyWeightBits-1:0]    weight_i,  // of key 0
  input  logic                        shown_i,  // by a key
  output logic [ColourBits-1:0]       colour_o
);
  localparam int unsigned WeightBits = KeyWeightBits - 1;
  localparam int unsigned BlendBits = SumBits + WeightBits;
  localparam int unsigned HeadBits = BlendBits - 3 * WeightBits;

  logic signed [SumBits-1:0] key_0_q, key_1_q, key_1_q2, key_1_q3;
  logic signed [SumBits:0] difference_q;
  logic signed [KeyWeightBits:0] weight_q, weight_q2;
  logic signed [BlendBits+1:0] product_q;
  logic [BlendBits-1:0] sum;
  logic [HeadBits-1:0] head;
  logic [2:0] shown_q;
  logic unused_bits;

  if (Relight != 0) begin : gen_relight
    // A difference has fraction bits, and a sign.
    localparam int unsigned Places = 2 * WeightBits - (DifferenceBits - ColourBits - 1);
    localparam logic [SumBits-1:0] Zero = SumBits'(1) << (ColourBits + 2 * WeightBits);
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        key_0_q <= key_0_i + (SumBits'(difference_0_i) << Places) - Zero;
        key_1_q <= key_1_i + (SumBits'(difference_1_i) << Places) - Zero;
      end
    end
  end else begin : gen_as_lit
    logic unused_differences;
    assign unused_differences = ^{difference_0_i, difference_1_i};
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        key_0_q <= key_0_i;
        key_1_q <= key_1_i;
      end
    end
  end

  assign sum = ({{WeightBits{key_1_q3[SumBits-1]}}, key_1_q3} << WeightBits)
               + product_q[BlendBits-1:0] + (BlendBits'(1) << (3 * WeightBits - 1));
  assign head = sum[BlendBits-1 -: HeadBits];
  assign unused_bits = ^{product_q[BlendBits+1:BlendBits], sum[3*WeightBits-1:0]};

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      weight_q <= {1'b0, weight_i};
      shown_q <= {shown_q[1:0], shown_i};

      difference_q <= {key_0_q[SumBits-1], key_0_q} - {key_1_q[SumBits-1], key_1_q};
      key_1_q2 <= key_1_q;
      weight_q2 <= weight_q;

      product_q <= difference_q * weight_q2;
      key_1_q3 <= key_1_q2;

      if (!shown_q[2] || head[HeadBits-1]) colour_o <= '0;
      else if (head[HeadBits-2:0] >> ColourBits != '0) colour_o <= '1;
      else colour_o <= head[ColourBits-1:0];
    end
  end
endmodule
