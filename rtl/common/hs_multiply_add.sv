// SPDX-License-Identifier: Apache-2.0
// A sum of products on one multiplier, a product a cycle. A long multiplication comes in chunks of
// its narrow factor, the least significant first: NarrowBits − 1 bits with a 0 above, the last one
// signed.
//
//   sum := base ± wide·narrow − borrow,   base = keep ? (shift ? floor(sum / 2^Chunk) : sum) : 0
//
// A shift leaves the Chunk bits that drop out in low_o: {sum_o, low_o} is then the whole number.
// Latency: a product offered in cycle t is in sum_o in cycle t + 3. While enable_i is 0 all stands
// still; flush_i drops the products on their way. The sum wraps.
module hs_multiply_add #(
  parameter int unsigned WideBits = 2,
  parameter int unsigned NarrowBits = 2,
  parameter int unsigned SumBits = WideBits + NarrowBits,
  localparam int unsigned Chunk = NarrowBits - 1
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         enable_i,
  input  logic                         flush_i,

  input  logic                         valid_i,
  input  logic                         keep_i,
  input  logic                         shift_i,
  input  logic                         subtract_i,
  input  logic                         borrow_i,
  input  logic signed [WideBits-1:0]   wide_i,
  input  logic signed [NarrowBits-1:0] narrow_i,

  output logic signed [SumBits-1:0]    sum_o,
  output logic [Chunk-1:0]             low_o
);
  localparam int unsigned Slice = 18;

  logic valid_q, valid_q2;
  logic [3:0] mode_q, mode_q2;
  logic signed [WideBits-1:0] wide_q;
  logic signed [NarrowBits-1:0] narrow_q;
  logic signed [SumBits-1:0] product, product_q, base, sum_q;
  logic [Chunk-1:0] low_q;
  logic keep, shift, subtract, borrow;

  assign {keep, shift, subtract, borrow} = mode_q2;

  always_comb begin
    base = '0;
    if (keep) base = shift ? sum_q >>> Chunk : sum_q;
  end

  // The slices of an FPGA multiply 18 by 25 bits. Where neither factor fits in 18, the wide one is
  // cut here, as a tool may cut both.
  if (WideBits > Slice && NarrowBits > Slice) begin : gen_cut
    logic signed [SumBits-1:0] product_low, product_high;
    assign product_low = $signed({1'b0, wide_q[Slice-2:0]}) * narrow_q;
    assign product_high = $signed(wide_q[WideBits-1:Slice-1]) * narrow_q;
    assign product = product_low + (product_high <<< (Slice - 1));
  end else begin : gen_whole
    assign product = wide_q * narrow_q;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q <= 1'b0;
      valid_q2 <= 1'b0;
    end else if (enable_i) begin
      valid_q <= valid_i && !flush_i;
      valid_q2 <= valid_q && !flush_i;
    end
  end

  always_ff @(posedge clk_i) begin
    if (enable_i) begin
      mode_q <= {keep_i, shift_i, subtract_i, borrow_i};
      wide_q <= wide_i;
      narrow_q <= narrow_i;
      mode_q2 <= mode_q;
      product_q <= product;
      if (valid_q2 && !flush_i) begin
        // −p − b = ~p + 1 − b: one adder with a carry in.
        sum_q <= base + (subtract ? ~product_q : product_q)
                 + $signed({{(SumBits - 1) {1'b0}}, subtract && !borrow});
        if (shift) low_q <= sum_q[Chunk-1:0];
      end
    end
  end

  assign sum_o = sum_q;
  assign low_o = low_q;
endmodule
