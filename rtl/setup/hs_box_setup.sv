// SPDX-License-Identifier: Apache-2.0
// The bounding box of a triangle, cut to the frame, after pixel_range() of
// hls/setup/triangle_setup.hpp: the pixels whose centres lie in it, and where to look first in its
// top row: below vertex 0, which is the topmost.
//
// The box of the vertices of one cycle is there in the next, where x_start_o reads x0_i again.
// Outside: the box holds no pixel, and the positions mean nothing. No stall.
module hs_box_setup (
  input  logic                   clk_i,
  input  hs_formats_pkg::x_t     frame_width_i,
  input  hs_formats_pkg::y_t     frame_height_i,

  input  hs_formats_pkg::coord_t x0_i,
  input  hs_formats_pkg::coord_t y0_i,
  input  hs_formats_pkg::coord_t x1_i,
  input  hs_formats_pkg::coord_t y1_i,
  input  hs_formats_pkg::coord_t x2_i,
  input  hs_formats_pkg::coord_t y2_i,
  input  logic                   before_10_i,  // x1 < x0
  input  logic                   before_20_i,  // x2 < x0

  output logic                   outside_o,
  output hs_formats_pkg::x_t     x_first_o,
  output hs_formats_pkg::x_t     x_last_o,
  output hs_formats_pkg::x_t     x_start_o,
  output hs_formats_pkg::y_t     y_first_o,
  output hs_formats_pkg::y_t     y_last_o
);
  localparam int unsigned CoordBits = hs_formats_pkg::CoordBits;
  localparam int unsigned SubpixelBits = hs_formats_pkg::SubpixelBits;
  localparam int unsigned XBits = hs_formats_pkg::XBits;
  localparam int unsigned YBits = hs_formats_pkg::YBits;
  // A position and a half may be one past the largest position.
  localparam int unsigned SumBits = CoordBits + 1;
  localparam int unsigned PixelBits = SumBits - SubpixelBits;
  localparam logic signed [SumBits-1:0] Half = SumBits'(1) << (SubpixelBits - 1);
  localparam logic signed [SumBits-1:0] BelowHalf = Half - SumBits'(1);

  logic before_21;
  hs_formats_pkg::coord_t x_low, x_high, y_high;

  assign before_21 = x2_i < x1_i;

  always_comb begin
    x_low = x0_i;
    if (before_10_i && !before_21) x_low = x1_i;
    else if (before_20_i) x_low = x2_i;
    x_high = x0_i;
    if (!before_10_i && before_21) x_high = x1_i;
    else if (!before_20_i) x_high = x2_i;
    y_high = y2_i < y1_i ? y1_i : y2_i;
  end

  // ceil(low − 1/2) and floor(high − 1/2)
  logic signed [PixelBits-1:0] x_first, x_last, y_first, y_last, x_end, y_end;
  logic signed [PixelBits-1:0] x_first_q, x_last_q, y_first_q, y_last_q, x_top;

  assign x_first = PixelBits'((SumBits'(x_low) + BelowHalf) >>> SubpixelBits);
  assign x_last = PixelBits'((SumBits'(x_high) - Half) >>> SubpixelBits);
  assign y_first = PixelBits'((SumBits'(y0_i) + BelowHalf) >>> SubpixelBits);
  assign y_last = PixelBits'((SumBits'(y_high) - Half) >>> SubpixelBits);
  assign x_end = PixelBits'(frame_width_i) - PixelBits'(1);
  assign y_end = PixelBits'(frame_height_i) - PixelBits'(1);

  always_ff @(posedge clk_i) begin
    x_first_q <= x_first[PixelBits-1] ? '0 : x_first;
    x_last_q <= x_last > x_end ? x_end : x_last;
    y_first_q <= y_first[PixelBits-1] ? '0 : y_first;
    y_last_q <= y_last > y_end ? y_end : y_last;
  end

  assign outside_o = x_first_q > x_last_q || y_first_q > y_last_q;
  assign x_first_o = x_first_q[XBits-1:0];
  assign x_last_o = x_last_q[XBits-1:0];
  assign y_first_o = y_first_q[YBits-1:0];
  assign y_last_o = y_last_q[YBits-1:0];

  assign x_top = PixelBits'(x0_i >>> SubpixelBits);
  always_comb begin
    x_start_o = x_top[XBits-1:0];
    if (x_top < x_first_q) x_start_o = x_first_o;
    else if (x_top > x_last_q) x_start_o = x_last_o;
  end
endmodule
