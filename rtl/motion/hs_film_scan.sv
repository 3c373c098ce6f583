// SPDX-License-Identifier: Apache-2.0
// A frame of the film out, a pixel a word, row by row (kernel: hls/motion/film_scan.hpp): one of
// the two key frames, or what the film buffer holds, with the background where that shows nothing.
//
// A word of `show` is a frame; the next one is taken when the last pixel of the one before was.
// Interval: a cycle a pixel. Latency from show to the first pixel: 2 cycles. Stall: nothing is read
// while a pixel is not taken.
// Memories: a read takes one cycle, its word stays until the next read. Key frames: a word a block
// of KeySide × KeySide pixels {r, g, b, face}, blocks along the rows of the largest frame, whole
// tiles of 8 × 8. Film buffer: a pixel {shown, r, g, b}, along the rows of the largest frame; what
// is read is cleared, and a read gives the old word.
module hs_film_scan #(
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned KeySide = hs_formats_pkg::KeySide,
  localparam int unsigned FilmBits = hs_formats_pkg::FilmPixelWordBits,
  localparam int unsigned MaxWidth = hs_formats_pkg::MaxWidth,
  localparam int unsigned MaxHeight = hs_formats_pkg::MaxHeight,
  localparam int unsigned PixelBits = 3 * ColourBits + FaceBits,
  localparam int unsigned BlockBits = KeySide * KeySide * PixelBits,
  localparam int unsigned BlocksX = (MaxWidth + 7) / 8 * (8 / KeySide),
  localparam int unsigned BlocksY = (MaxHeight + 7) / 8 * (8 / KeySide),
  localparam int unsigned KeyAddressBits = $clog2(BlocksX * BlocksY),
  localparam int unsigned FilmAddressBits =
      MaxWidth * MaxHeight > 1 ? $clog2(MaxWidth * MaxHeight) : 1
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t         frame_width_i,
  input  hs_formats_pkg::y_t         frame_height_i,
  input  logic [3*ColourBits-1:0]    background_i,

  // From control: {source, slot}, source 0 is a key frame
  input  logic                       show_valid_i,
  output logic                       show_ready_o,
  input  logic [1:0]                 show_i,

  // Key frames
  output logic                       key_read_en_o,
  output logic                       key_read_bank_o,
  output logic [KeyAddressBits-1:0]  key_read_address_o,
  input  logic [BlockBits-1:0]       read_block_i,

  // Film buffer: 0 is written to the address that is read
  output logic                       film_read_en_o,
  output logic                       film_write_en_o,
  output logic [FilmAddressBits-1:0] film_address_o,
  input  logic [3*ColourBits:0]      read_film_i,

  // To the display
  output logic                       film_valid_o,
  input  logic                       film_ready_i,
  output logic [FilmBits-1:0]        film_o
);
  localparam int unsigned SideBits = $clog2(KeySide);
  localparam int unsigned LaneBits = 2 * SideBits;

  logic active_q, valid_q, step, row_end, frame_end, is_film_q, slot_q;
  logic [XBits-1:0] x_q;
  logic [YBits-1:0] y_q;
  logic [KeyAddressBits-1:0] key_row_q;
  logic [FilmAddressBits-1:0] film_row_q;

  assign show_ready_o = !active_q && !valid_q;
  assign step = active_q && (!valid_q || film_ready_i);
  assign row_end = x_q == frame_width_i - XBits'(1);
  assign frame_end = row_end && y_q == frame_height_i - YBits'(1);

  // Signals of their own: Yosys 0.23 does not narrow a cast inside a concatenation.
  logic [SideBits-1:0] x_side, y_side;
  assign x_side = SideBits'(x_q);
  assign y_side = SideBits'(y_q);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      valid_q <= 1'b0;
    end else begin
      if (show_valid_i && show_ready_o) active_q <= 1'b1;
      else if (step && frame_end) active_q <= 1'b0;
      if (step) valid_q <= 1'b1;
      else if (film_ready_i) valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (show_valid_i && show_ready_o) begin
      {is_film_q, slot_q} <= show_i;
      x_q <= '0;
      y_q <= '0;
      key_row_q <= '0;
      film_row_q <= '0;
    end else if (step) begin
      x_q <= row_end ? '0 : x_q + XBits'(1);
      if (row_end) begin
        y_q <= y_q + YBits'(1);
        film_row_q <= film_row_q + FilmAddressBits'(MaxWidth);
        if (&y_side) key_row_q <= key_row_q + KeyAddressBits'(BlocksX);
      end
    end
  end

  assign key_read_en_o = step && !is_film_q;
  assign key_read_bank_o = slot_q;
  assign key_read_address_o = key_row_q + (KeyAddressBits'(x_q) >> SideBits);
  assign film_read_en_o = step && is_film_q;
  assign film_write_en_o = film_read_en_o;
  assign film_address_o = film_row_q + FilmAddressBits'(x_q);

  // --- The pixel that was read ---
  logic [XBits+YBits:0] head_q;
  logic [LaneBits-1:0] lane_q;
  logic [3*ColourBits-1:0] of_key;

  always_ff @(posedge clk_i) begin
    if (step) begin
      head_q <= {frame_end, x_q, y_q};
      lane_q <= {y_side, x_side};
    end
  end

  always_comb begin
    of_key = '0;
    for (int unsigned i = 0; i < KeySide * KeySide; i++) begin
      if (lane_q == LaneBits'(i)) of_key = read_block_i[i*PixelBits+FaceBits +: 3*ColourBits];
    end
  end

  assign film_valid_o = valid_q;
  assign film_o = {head_q, !is_film_q ? of_key
                           : read_film_i[3*ColourBits] ? read_film_i[3*ColourBits-1:0]
                           : background_i};
endmodule
