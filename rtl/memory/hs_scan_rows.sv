// SPDX-License-Identifier: Apache-2.0
// The I-buffer in memory, as scan_index reads it: the tiles of the frame come ahead into a ring.
//
// A frame's tiles are walked row by row. What the Z-test has not touched of one, by rows of 16
// pixels (hs_row_fetch), is 0, and a tile without a touched row costs no traffic. The bits that say
// so are cleared as they are looked at, so that the next frame of the bank finds them so. A token
// with start_clear_i clears those of the whole bank, and scan_index hears nothing of it. The token
// of a frame goes on to scan_index when the first tile has come.
// scan_index reads the stamps of the frame in order, one a read_en_i; its word comes a cycle later
// and stays until the next. While hold_o is 1 the next stamp has not come, and scan_index must not
// read: its words wait.
// Ring: a tile's place is free when its last stamp was read. It holds a row of tiles, and half as
// many at least ahead of it.
module hs_scan_rows #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned MemoryBits,
  parameter int unsigned TilesAhead = 4,  // asked for at a time
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned TilesX = (hs_formats_pkg::MaxWidth + 7) / 8,
  localparam int unsigned TilesY = (hs_formats_pkg::MaxHeight + 7) / 8,
  localparam int unsigned TileXBits = TilesX > 1 ? $clog2(TilesX) : 1,
  localparam int unsigned TileYBits = TilesY > 1 ? $clog2(TilesY) : 1,
  localparam int unsigned TileBits = TileXBits + TileYBits,
  localparam int unsigned RingBits = $clog2(TilesX + (TilesX + 1) / 2)
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  input  hs_formats_pkg::x_t                    frame_width_i,
  input  hs_formats_pkg::y_t                    frame_height_i,
  input  logic [hs_memory_pkg::AddressBits-1:0] base_i,
  input  logic                                  scan_bank_i,  // from the cycle after start on

  // From frame control
  input  logic                                  start_valid_i,
  output logic                                  start_ready_o,
  input  logic                                  start_clear_i,

  // To scan_index, and its port
  output logic                                  start_valid_o,
  input  logic                                  start_ready_i,
  output logic                                  hold_o,
  input  logic                                  read_en_i,
  output logic [Lanes*IndexBits-1:0]            read_index_o,

  // Which rows of a tile were touched: read, and cleared
  output logic                                  touched_en_o,
  output logic [TileBits-1:0]                   touched_tile_o,
  input  logic [3:0]                            touched_i,

  // Memory
  output logic                                  read_valid_o,
  input  logic                                  read_ready_i,
  output hs_memory_pkg::request_t               read_o,
  input  logic                                  data_valid_i,
  input  logic [MemoryBits-1:0]                 data_i
);
  localparam int unsigned ShiftX = 3 - $clog2(LanesX);  // of a stamp's x to its tile's
  localparam int unsigned ShiftY = 3 - $clog2(LanesY);
  localparam int unsigned RowBits = 16 * IndexBits;
  localparam int unsigned RowStamps = 16 / Lanes;
  localparam int unsigned NumberBits = 6 - $clog2(Lanes);  // of a stamp in its tile
  localparam int unsigned SelectBits = RowStamps > 1 ? $clog2(RowStamps) : 1;  // in its row
  localparam int unsigned Ring = 1 << RingBits;

  // --- Start ---
  logic active_q, clearing_q, started_q, walking_q, start, end_read;
  assign start_ready_o = !active_q && !clearing_q && start_ready_i;
  assign start = start_valid_i && start_ready_o;
  assign start_valid_o = active_q && !started_q && !hold_o;

  // --- Walk: a tile is looked up | asked for, or 0 ---
  logic looked_valid_q, look, looked_go, tile_ready, touched;
  logic [TileXBits-1:0] tile_x_q, tile_x_last;
  logic [TileYBits-1:0] tile_y_q, tile_y_last;
  logic [TileBits-1:0] looked_tile_q;
  logic [RingBits:0] walk_q, fill_q, free_q, base_q;  // places of the ring, and once around

  assign tile_x_last = TileXBits'((frame_width_i - XBits'(1)) >> 3);
  assign tile_y_last = TileYBits'((frame_height_i - YBits'(1)) >> 3);
  assign touched = touched_i != 4'd0;
  assign looked_go = looked_valid_q && (!touched || tile_ready);
  // A place for the tile that is looked at in this cycle, after the one before it.
  assign look = walking_q && (!looked_valid_q || looked_go)
                && walk_q - free_q < (RingBits+1)'(Ring - 1);
  assign touched_en_o = look || clearing_q;
  assign touched_tile_o = {tile_y_q, tile_x_q};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      clearing_q <= 1'b0;
      started_q <= 1'b0;
      walking_q <= 1'b0;
      looked_valid_q <= 1'b0;
    end else begin
      if (start) begin
        active_q <= !start_clear_i;
        walking_q <= !start_clear_i;
        clearing_q <= start_clear_i;
        started_q <= 1'b0;
      end else begin
        if (end_read) active_q <= 1'b0;
        if (look && tile_x_q == tile_x_last && tile_y_q == tile_y_last) walking_q <= 1'b0;
        if (&touched_tile_o) clearing_q <= 1'b0;
        if (start_valid_o && start_ready_i) started_q <= 1'b1;
      end
      if (look) looked_valid_q <= 1'b1;
      else if (looked_go) looked_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (start) begin
      tile_x_q <= '0;
      tile_y_q <= '0;
    end else if (clearing_q) begin
      {tile_y_q, tile_x_q} <= touched_tile_o + TileBits'(1);
    end else if (look) begin
      tile_x_q <= tile_x_q == tile_x_last ? '0 : tile_x_q + TileXBits'(1);
      if (tile_x_q == tile_x_last) tile_y_q <= tile_y_q + TileYBits'(1);
    end
    if (look) looked_tile_q <= touched_tile_o;
    if (start) walk_q <= '0;
    else if (looked_go) walk_q <= walk_q + (RingBits+1)'(1);
  end

  // --- Fill: the places of tiles that were asked for, in a queue; there: what came, or is 0 ---
  logic [3:0] touched_q [Ring];
  logic [Ring-1:0] there_q;
  logic row_valid, place_valid, unused_place_ready, fills, fill_ends;
  logic [RingBits-1:0] fill_place;
  logic [RowBits-1:0] row, read_row;
  logic [1:0] fill_row_q;

  hs_fifo #(
    .Width(RingBits),
    .Depth(TilesAhead)
  ) u_places (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (looked_go && touched),
    .in_ready_o (unused_place_ready),
    .in_i       (walk_q[RingBits-1:0]),
    .out_valid_o(place_valid),
    .out_ready_i(fill_ends),
    .out_o      (fill_place)
  );

  hs_row_fetch #(
    .RowBits   (RowBits),
    .MemoryBits(MemoryBits),
    .TileBits  (TileBits + 1),
    .Tiles     (TilesAhead),
    .Rows      (2)
  ) u_fetch (
    .clk_i       (clk_i),
    .rst_ni      (rst_ni),
    .base_i      (base_i),
    .tile_valid_i(looked_valid_q && touched),
    .tile_ready_o(tile_ready),
    .tile_i      ({scan_bank_i, looked_tile_q}),
    .row_valid_o (row_valid),
    .row_ready_i (place_valid),
    .row_o       (row),
    .read_valid_o(read_valid_o),
    .read_ready_i(read_ready_i),
    .read_o      (read_o),
    .data_valid_i(data_valid_i),
    .data_i      (data_i)
  );

  assign fills = row_valid && place_valid;
  assign fill_ends = fills && fill_row_q == 2'd3;

  always_ff @(posedge clk_i) begin
    if (looked_go) begin
      touched_q[walk_q[RingBits-1:0]] <= touched_i;
      there_q[walk_q[RingBits-1:0]] <= !touched;
    end
    if (fill_ends) there_q[fill_place] <= 1'b1;
    if (start) begin
      fill_q <= '0;
      fill_row_q <= '0;
    end else begin
      if (fill_q != walk_q && there_q[fill_q[RingBits-1:0]]) fill_q <= fill_q + (RingBits+1)'(1);
      if (fills) fill_row_q <= fill_row_q + 2'd1;
    end
  end

  // --- Read ---
  hs_formats_pkg::x_t x_q, x_last;
  hs_formats_pkg::y_t y_q, y_last;
  logic [TileXBits-1:0] read_tile_x;
  logic [RingBits:0] place;
  logic [NumberBits-1:0] number;
  logic [1:0] row_number;
  logic row_end, tile_end, zero_read_q;
  logic [SelectBits-1:0] select, select_q;

  assign x_last = (frame_width_i - XBits'(1)) >> $clog2(LanesX);
  assign y_last = (frame_height_i - YBits'(1)) >> $clog2(LanesY);
  assign read_tile_x = TileXBits'(x_q >> ShiftX);
  assign place = base_q + (RingBits+1)'(read_tile_x);
  assign hold_o = active_q && fill_q - base_q <= (RingBits+1)'(read_tile_x);
  assign number = (NumberBits'(y_q) << ShiftX)
                  | (NumberBits'(x_q) & NumberBits'((1 << ShiftX) - 1));
  assign select = SelectBits'(number);
  assign row_number = 2'(number >> (NumberBits - 2));
  assign row_end = x_q == x_last;
  assign end_read = read_en_i && row_end && y_q == y_last;
  // The last stamp of a tile in a row of stamps, and in the last one of its tile.
  assign tile_end = row_end || (x_q & XBits'((1 << ShiftX) - 1)) == XBits'((1 << ShiftX) - 1);

  always_ff @(posedge clk_i) begin
    if (start) begin
      x_q <= '0;
      y_q <= '0;
      base_q <= '0;
      free_q <= '0;
    end else if (read_en_i) begin
      x_q <= row_end ? '0 : x_q + XBits'(1);
      if (row_end) y_q <= y_q + YBits'(1);
      if ((y_q & YBits'((1 << ShiftY) - 1)) == YBits'((1 << ShiftY) - 1)) begin
        if (row_end) base_q <= place + (RingBits+1)'(1);
        if (tile_end) free_q <= free_q + (RingBits+1)'(1);
      end
    end
    if (read_en_i) begin
      zero_read_q <= !touched_q[place[RingBits-1:0]][row_number];
      select_q <= select & SelectBits'(RowStamps - 1);
    end
  end

  hs_ram_1r1w #(
    .Width(RowBits),
    .Depth(4 * Ring)
  ) u_ring (
    .clk_i          (clk_i),
    .read_en_i      (read_en_i),
    .read_address_i ({place[RingBits-1:0], row_number}),
    .read_data_o    (read_row),
    .write_en_i     (fills),
    .write_address_i({fill_place, fill_row_q}),
    .write_data_i   (row)
  );

  always_comb begin
    read_index_o = '0;
    for (int unsigned i = 0; i < RowStamps; i++) begin
      if (!zero_read_q && select_q == SelectBits'(i)) begin
        read_index_o = read_row[i*Lanes*IndexBits +: Lanes*IndexBits];
      end
    end
  end
endmodule
