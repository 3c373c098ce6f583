// SPDX-License-Identifier: Apache-2.0
// The pixels that a filter takes of a key frame: which of them match, whether one of these has a
// weight, and what stands for those of the inner four that do not (kernel: key_colour in
// hls/motion/motion_compensate.hpp, standing_tap and filtered_key in hls/motion/key_filter.hpp).
//
// Interval 1, latency 2, of cycles in which en_i is 1, which is their only stall.
module hs_key_taps #(
  parameter int unsigned Side,
  localparam int unsigned Taps = hs_formats_pkg::KeyTaps,
  localparam int unsigned FractionBits = hs_formats_pkg::KeyFractionBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned SideBits = $clog2(Side),
  localparam int unsigned PixelBits = 3 * ColourBits + FaceBits
) (
  input  logic                             clk_i,
  input  logic                             en_i,
  input  logic                             active_i,  // it has a face and a vector
  input  logic [FaceBits-1:0]              face_i,
  input  logic [Side*Side*PixelBits-1:0]   pixels_i,  // {r, g, b, face} a bank, bank 0 last
  input  logic [SideBits-1:0]              column_i,  // of the first pixel, modulo Side
  input  logic [SideBits-1:0]              row_i,
  input  logic [Taps-1:0]                  inside_x_i,
  input  logic [Taps-1:0]                  inside_y_i,
  input  logic [FractionBits-1:0]          x_fraction_i,
  input  logic [FractionBits-1:0]          y_fraction_i,

  output logic                             shown_o,
  output logic                             all_o,  // all match
  output logic [3*Taps*Taps*ColourBits-1:0] colours_o  // {r, g, b} a pixel, in rows, the first last
);
  logic [Taps*Taps-1:0] match_q;
  logic [3*Taps*Taps*ColourBits-1:0] colours_q;

  // The banks, a power of two of bits apart.
  localparam int unsigned Places = $clog2(PixelBits);
  logic [(Side*Side<<Places)-1:0] banks;
  for (genvar bank = 0; bank < Side * Side; bank++) begin : gen_bank
    assign banks[bank<<Places +: 1<<Places] =
        (1 << Places)'(pixels_i[bank*PixelBits +: PixelBits]);
  end

  for (genvar i = 0; i < Taps * Taps; i++) begin : gen_tap
    logic [SideBits-1:0] column, row;
    logic [PixelBits-1:0] pixel;
    assign column = column_i + SideBits'(i % Taps);
    assign row = row_i + SideBits'(i / Taps);
    assign pixel = banks[{row, column, Places'(0)} +: PixelBits];
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        match_q[i] <= active_i && inside_x_i[i%Taps] && inside_y_i[i/Taps]
                      && pixel[FaceBits-1:0] == face_i;
        colours_q[3*i*ColourBits +: 3*ColourBits] <= pixel[PixelBits-1 -: 3*ColourBits];
      end
    end
  end

  if (Taps == 1) begin : gen_one
    logic unused_fractions;
    assign unused_fractions = ^{x_fraction_i, y_fraction_i};
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        shown_o <= match_q[0];
        all_o <= match_q[0];
        colours_o <= colours_q;
      end
    end
  end else begin : gen_four
    // The nearest of the inner four, bit 0 its column and bit 1 its row, and which axis is tried
    // first.
    localparam int unsigned First = Taps == 4 ? 1 : 0;
    localparam logic [FractionBits-1:0] Half = FractionBits'(1) << (FractionBits - 1);
    logic [FractionBits-1:0] from_x, from_y;
    logic [1:0] x_weighted, y_weighted, nearest_q, flip_q, standing;
    logic [3:0] inner, weighted_q;
    logic [3*ColourBits-1:0] colour;

    assign from_x = x_fraction_i[FractionBits-1] ? x_fraction_i - Half : Half - x_fraction_i;
    assign from_y = y_fraction_i[FractionBits-1] ? y_fraction_i - Half : Half - y_fraction_i;
    // Of the two columns or rows those that rounding leaves a weight: that behind a place from a
    // fraction on, that before it up to one.
    localparam int unsigned FirstBehind = hs_formats_pkg::KeyFirstBehind;
    localparam int unsigned LastBefore = hs_formats_pkg::KeyLastBefore;
    assign x_weighted[1] = x_fraction_i >= FractionBits'(FirstBehind);
    assign y_weighted[1] = y_fraction_i >= FractionBits'(FirstBehind);
    if (LastBefore == (1 << FractionBits) - 1) begin : gen_to_end
      assign x_weighted[0] = 1'b1;
      assign y_weighted[0] = 1'b1;
    end else begin : gen_to_last
      assign x_weighted[0] = x_fraction_i <= FractionBits'(LastBefore);
      assign y_weighted[0] = y_fraction_i <= FractionBits'(LastBefore);
    end

    assign inner = {match_q[(First+1)*Taps+First +: 2], match_q[First*Taps+First +: 2]};

    always_comb begin
      standing = ~nearest_q;
      if (inner[~nearest_q ^ flip_q]) standing = ~nearest_q ^ flip_q;
      if (inner[nearest_q ^ flip_q]) standing = nearest_q ^ flip_q;
      if (inner[nearest_q]) standing = nearest_q;
      colour = '0;
      for (int unsigned n = 0; n < 4; n++) begin
        if (standing == 2'(n)) begin
          colour = colours_q[3*((First+n/2)*Taps+First+n%2)*ColourBits +: 3*ColourBits];
        end
      end
    end

    always_ff @(posedge clk_i) begin
      if (en_i) begin
        nearest_q <= {y_fraction_i[FractionBits-1], x_fraction_i[FractionBits-1]};
        flip_q <= from_x <= from_y ? 2'b01 : 2'b10;
        weighted_q <= {{2{y_weighted[1]}} & x_weighted, {2{y_weighted[0]}} & x_weighted};
        shown_o <= (inner & weighted_q) != '0;
        all_o <= &match_q;
      end
    end

    for (genvar i = 0; i < Taps * Taps; i++) begin : gen_stand
      localparam int unsigned X = i % Taps, Y = i / Taps;
      localparam bit Inner = X - First < 2 && Y - First < 2;
      always_ff @(posedge clk_i) begin
        if (en_i) begin
          colours_o[3*i*ColourBits +: 3*ColourBits] <=
              Inner && !match_q[i] ? colour : colours_q[3*i*ColourBits +: 3*ColourBits];
        end
      end
    end
  end
endmodule
