// SPDX-License-Identifier: Apache-2.0
// The texels that a pixel shows, from its place in the texture (kernel: nearest_fetch and
// bilinear_fetch in hls/texture/texel_fetch.hpp): their address in each bank of the memory, and
// for a bilinear filter the weights of the odd column and the odd row, of 2^WeightBits.
//
// Two neighbours differ in the parity of a column or a row, and each of the four has a bank:
// {odd row, odd column}.
// Interval 1. Latency, of cycles in which en_i is 1: bilinear 2, and the weights 1; else 1.
module hs_texture_address #(
  parameter int unsigned AddressBits,  // of a texel
  localparam int unsigned Bilinear = hs_formats_pkg::Bilinear,
  localparam int unsigned SideBits = hs_formats_pkg::SideBits,
  localparam int unsigned WeightBits = hs_formats_pkg::WeightBits,
  localparam int unsigned PlaceBits = AddressBits + (Bilinear != 0 ? WeightBits : 0),
  localparam int unsigned Banks = Bilinear != 0 ? 4 : 1,
  localparam int unsigned BankAddressBits = AddressBits == $clog2(Banks) ? 1
                                            : AddressBits - $clog2(Banks)
) (
  input  logic                             clk_i,
  input  logic                             en_i,
  input  logic [PlaceBits-1:0]             u_i,
  input  logic [PlaceBits-1:0]             v_i,
  input  logic [AddressBits-1:0]           base_i,
  input  logic [SideBits-1:0]              log2_width_i,
  input  logic [SideBits-1:0]              log2_height_i,
  output logic [Banks*BankAddressBits-1:0] address_o,
  output logic [WeightBits:0]              column_weight_o,
  output logic [WeightBits:0]              row_weight_o
);
  logic [Banks*BankAddressBits-1:0] address_q;
  assign address_o = address_q;

  if (Bilinear != 0) begin : gen_bilinear
    localparam int unsigned HalfBits = AddressBits - 1;  // of half a column or row number

    // Sides 1 and 0: u and v.
    logic [2*HalfBits-1:0] halves_q;   // {row, column} of the odd ones
    logic [2*HalfBits-1:0] evens_q;    // and of the even ones, which come a texel later or not
    logic [2*(WeightBits+1)-1:0] weights_q;
    logic [AddressBits-1:0] base_q;
    logic [SideBits-1:0] log2_width_q;

    for (genvar side = 0; side < 2; side++) begin : gen_side
      logic [PlaceBits-1:0] place;
      logic [SideBits-1:0] log2_side;
      logic [HalfBits-1:0] half;
      logic [AddressBits-1:0] outside;
      logic is_odd, unused_outside;
      logic [WeightBits:0] weight;

      assign place = side == 0 ? u_i : v_i;
      assign log2_side = side == 0 ? log2_width_i : log2_height_i;
      assign {half, is_odd} = place[PlaceBits-1:WeightBits];
      assign weight = {1'b0, place[WeightBits-1:0]};
      assign outside = {AddressBits{1'b1}} << log2_side;
      assign unused_outside = outside[0];

      always_ff @(posedge clk_i) begin
        if (en_i) begin
          halves_q[side*HalfBits +: HalfBits] <= half;
          evens_q[side*HalfBits +: HalfBits] <=
              (half + HalfBits'(is_odd)) & ~outside[AddressBits-1:1];
          weights_q[side*(WeightBits+1) +: WeightBits+1] <=
              is_odd ? {1'b1, {WeightBits{1'b0}}} - weight : weight;
        end
      end
    end

    always_ff @(posedge clk_i) begin
      if (en_i) begin
        base_q <= base_i;
        log2_width_q <= log2_width_i;
      end
    end

    for (genvar bank = 0; bank < Banks; bank++) begin : gen_bank
      logic [HalfBits-1:0] column, row;
      logic [AddressBits-1:0] rows;
      logic [BankAddressBits-1:0] address;
      logic unused_bits;

      assign column = bank % 2 != 0 ? halves_q[0 +: HalfBits] : evens_q[0 +: HalfBits];
      assign row = bank / 2 != 0 ? halves_q[HalfBits +: HalfBits] : evens_q[HalfBits +: HalfBits];
      assign rows = AddressBits'(row) << log2_width_q;
      if (AddressBits > 2) begin : gen_address
        assign address = base_q[AddressBits-1:2] | rows[AddressBits-2:1]
                         | column[BankAddressBits-1:0];
      end else begin : gen_one_word
        assign address = '0;
      end
      assign unused_bits = ^{base_q, rows, column};
      always_ff @(posedge clk_i) begin
        if (en_i) address_q[bank*BankAddressBits +: BankAddressBits] <= address;
      end
    end

    assign {row_weight_o, column_weight_o} = weights_q;
  end else begin : gen_nearest
    logic unused_side;
    assign unused_side = ^log2_height_i;
    always_ff @(posedge clk_i) begin
      if (en_i) address_q <= base_i | (v_i << log2_width_i) | u_i;
    end
    assign column_weight_o = '0;
    assign row_weight_o = '0;
  end
endmodule
