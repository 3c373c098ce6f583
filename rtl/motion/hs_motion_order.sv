// SPDX-License-Identifier: Apache-2.0
// The words of a frame's motion in the order of tiles that the caches of key frames like (kernel:
// hls/motion/motion_order.hpp): rows of tiles from the top, tiles from the left, and in a tile of
// 8 × 8 pixels its rows from the top. A frame that shows no face is a word of face 0, at (0, 0).
//
// Words go into the motion buffer as they come, a cycle each; those of face 0 end a frame and are
// not kept. After the last one the tiles are walked: a cycle a word, and one for a tile without.
// Latency from the last word in to the first one out: 6 cycles where the first tile has a word.
// Stall: the walk waits while a word is not taken. No word comes in while one walks; and none after
// reset for a cycle a tile of the largest frame.
// Motion buffer: address {tile, row, column}, tiles counted along the rows of the largest frame; a
// word is one of motion from the face on. A read takes one cycle, its word stays until the next.
// Beside it, in the unit, a bit a pixel says which words are of this frame.
module hs_motion_order #(
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned MotionBits = hs_formats_pkg::MotionWordBits,
  localparam int unsigned EntryBits = MotionBits - 1 - XBits - YBits,
  localparam int unsigned TilesX = (hs_formats_pkg::MaxWidth + 7) / 8,
  localparam int unsigned TilesY = (hs_formats_pkg::MaxHeight + 7) / 8,
  localparam int unsigned TileBits = TilesX * TilesY > 1 ? $clog2(TilesX * TilesY) : 1,
  localparam int unsigned AddressBits = TileBits + 6
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t     frame_width_i,
  input  hs_formats_pkg::y_t     frame_height_i,

  // From motion_field
  input  logic                   motion_valid_i,
  output logic                   motion_ready_o,
  input  logic [MotionBits-1:0]  motion_i,

  // Motion buffer
  output logic                   write_en_o,
  output logic [AddressBits-1:0] write_address_o,
  output logic [EntryBits-1:0]   write_motion_o,
  output logic                   read_en_o,
  output logic [AddressBits-1:0] read_address_o,
  input  logic [EntryBits-1:0]   read_motion_i,

  // To motion_compensate and hole_find
  output logic                   ordered_valid_o,
  input  logic                   ordered_ready_i,
  output logic [MotionBits-1:0]  ordered_o
);
  localparam logic [TileBits-1:0] LastTile = TileBits'(TilesX * TilesY - 1);

  logic clearing_q, walking_q, ended;

  // --- In ---
  logic in_valid_q, in_last_q, in_stores_q, last, unused_tile;
  logic [TileBits-1:0] in_tile_q;
  logic [5:0] in_pixel_q;
  logic [EntryBits-1:0] in_entry_q, entry;
  logic [XBits-1:0] x, tile_x;
  logic [YBits-1:0] y, tile_y;

  assign {last, x, y, entry} = motion_i;
  assign tile_x = x >> 3;
  assign tile_y = y >> 3;
  assign unused_tile = ^{tile_x, tile_y};  // of few tiles the number has fewer bits
  assign motion_ready_o = !clearing_q && !walking_q && !(in_valid_q && in_last_q);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) in_valid_q <= 1'b0;
    else in_valid_q <= motion_valid_i && motion_ready_o;
  end

  // Signals of their own: Yosys 0.23 does not narrow a cast inside a concatenation.
  logic [2:0] x_low, y_low;
  assign x_low = 3'(x);
  assign y_low = 3'(y);

  always_ff @(posedge clk_i) begin
    in_last_q <= last;
    in_stores_q <= entry[EntryBits-1 -: FaceBits] != '0;
    in_tile_q <= TileBits'(tile_y) * TileBits'(TilesX) + TileBits'(tile_x);
    in_pixel_q <= {y_low, x_low};
    in_entry_q <= entry;
  end

  assign write_en_o = in_valid_q && in_stores_q;
  assign write_address_o = {in_tile_q, in_pixel_q};
  assign write_motion_o = in_entry_q;

  // --- Which pixels have a word: of a tile together, cleared as they are read ---
  logic fetch, fetch_last, row_last;
  logic [TileBits-1:0] fetch_tile_q, row_tile_q, clear_tile_q;
  logic [XBits-1:0] fetch_x_q;
  logic [YBits-1:0] fetch_y_q;
  logic [63:0] bits;

  hs_ram_1r1w #(
    .Width(64),
    .Depth(1 << TileBits),
    .Lanes(64)
  ) u_bits (
    .clk_i          (clk_i),
    .read_en_i      (fetch),
    .read_address_i (fetch_tile_q),
    .read_data_o    (bits),
    .write_en_i     (clearing_q || fetch ? '1 : 64'(write_en_o) << in_pixel_q),
    .write_address_i(clearing_q ? clear_tile_q : fetch ? fetch_tile_q : in_tile_q),
    .write_data_i   (clearing_q || fetch ? '0 : '1)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      clearing_q <= 1'b1;
      clear_tile_q <= '0;
    end else if (clearing_q) begin
      clearing_q <= clear_tile_q != LastTile;
      clear_tile_q <= clear_tile_q + TileBits'(1);
    end
  end

  // --- The walk: a tile is fetched while the words of the one before go out ---
  logic fetching_q;  // a tile of the frame is not fetched yet
  logic fetched_q;   // bits are those of a tile that is not begun yet
  logic begins, pick, go, pick_last;
  logic [TileBits-1:0] fetched_tile_q, tile_q;
  logic [XBits-1:0] fetched_x_q, tile_x_q;
  logic [YBits-1:0] fetched_y_q, tile_y_q;
  logic [63:0] waits_q, others;
  logic [5:0] pixel;

  always_comb begin
    pixel = '0;
    for (int unsigned i = 1; i <= 64; i++) begin
      if (waits_q[64-i]) pixel = 6'(64 - i);
    end
  end
  assign others = waits_q & (waits_q - 64'd1);
  assign pick = go && waits_q != '0;
  assign pick_last = waits_q == '0 || (go && others == '0);
  assign begins = fetched_q && pick_last;
  assign fetch = fetching_q && (!fetched_q || begins);
  assign row_last = fetch_x_q == (frame_width_i - XBits'(1)) >> 3;
  assign fetch_last = row_last && fetch_y_q == (frame_height_i - YBits'(1)) >> 3;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      walking_q <= 1'b0;
      fetching_q <= 1'b0;
      fetched_q <= 1'b0;
      waits_q <= '0;
    end else begin
      if (in_valid_q && in_last_q) begin
        walking_q <= 1'b1;
        fetching_q <= 1'b1;
      end else begin
        if (ended) walking_q <= 1'b0;
        if (fetch && fetch_last) fetching_q <= 1'b0;
      end
      fetched_q <= fetch || (fetched_q && !begins);
      if (begins) waits_q <= bits;
      else if (pick) waits_q <= others;
    end
  end

  always_ff @(posedge clk_i) begin
    if (!walking_q) begin
      fetch_x_q <= '0;
      fetch_y_q <= '0;
      fetch_tile_q <= '0;
      row_tile_q <= '0;
    end else if (fetch) begin
      fetched_x_q <= fetch_x_q;
      fetched_y_q <= fetch_y_q;
      fetched_tile_q <= fetch_tile_q;
      fetch_x_q <= row_last ? '0 : fetch_x_q + XBits'(1);
      fetch_tile_q <= fetch_tile_q + TileBits'(1);
      if (row_last) begin
        fetch_y_q <= fetch_y_q + YBits'(1);
        fetch_tile_q <= row_tile_q + TileBits'(TilesX);
        row_tile_q <= row_tile_q + TileBits'(TilesX);
      end
    end
    if (begins) begin
      tile_x_q <= fetched_x_q;
      tile_y_q <= fetched_y_q;
      tile_q <= fetched_tile_q;
    end
  end

  // --- Read, and a word is held until another one shows that it is not the last ---
  logic read_valid_q, held_valid_q, drained, moves, step;
  logic [XBits-1:0] read_x_q;
  logic [YBits-1:0] read_y_q;
  logic [MotionBits-2:0] held_q;

  assign read_en_o = pick;
  assign read_address_o = {tile_q, pixel};
  assign drained = walking_q && !fetching_q && !fetched_q && waits_q == '0 && !read_valid_q;
  assign ordered_valid_o = drained || (held_valid_q && read_valid_q);
  assign ordered_o = {drained, held_valid_q ? held_q : '0};
  assign moves = ordered_valid_o && ordered_ready_i;
  assign ended = drained && moves;
  assign step = read_valid_q && (!held_valid_q || moves);
  assign go = !read_valid_q || step;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      read_valid_q <= 1'b0;
      held_valid_q <= 1'b0;
    end else begin
      if (go) read_valid_q <= pick;
      if (step) held_valid_q <= 1'b1;
      else if (moves) held_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (pick) begin
      read_x_q <= XBits'(tile_x_q << 3) | XBits'(pixel[2:0]);
      read_y_q <= YBits'(tile_y_q << 3) | YBits'(pixel[5:3]);
    end
    if (step) held_q <= {read_x_q, read_y_q, read_motion_i};
  end
endmodule
