// SPDX-License-Identifier: Apache-2.0
// The front of hs_tile_cache: a stamp is looked up, and waits in a queue.
//
//   stamp ─► look up ─► queue
//
// Tags are what a slot will hold when the stamps in the queue have passed. A stamp whose tile is
// not there marks that its slot changes hands for it; what memory has of the tile is asked for, but
// not while it is on its way to memory (behind_i). A stamp that covers nothing needs no tile.
// Behind the last stamp of a frame none is looked up until the frame is in memory (ends_i); while
// it is flushed the tag of flush_slot_i is on old_tile_o, and flush_next_i leaves it.
// Interval: a stamp a cycle. Latency: 2 cycles.
module hs_tile_look #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned SlotsX,
  parameter int unsigned SlotsY,
  parameter int unsigned QueueDepth,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned StampBits = 2 + IndexBits + XBits + YBits + Lanes * (1 + DepthBits),
  localparam int unsigned TilesX = (hs_formats_pkg::MaxWidth + 7) / 8,
  localparam int unsigned TilesY = (hs_formats_pkg::MaxHeight + 7) / 8,
  localparam int unsigned TileXBits = TilesX > 1 ? $clog2(TilesX) : 1,
  localparam int unsigned TileYBits = TilesY > 1 ? $clog2(TilesY) : 1,
  localparam int unsigned TileBits = TileXBits + TileYBits,
  localparam int unsigned SlotXBits =
      $clog2(SlotsX) < TileXBits ? (SlotsX > 1 ? $clog2(SlotsX) : 1) : TileXBits,
  localparam int unsigned SlotYBits =
      $clog2(SlotsY) < TileYBits ? (SlotsY > 1 ? $clog2(SlotsY) : 1) : TileYBits,
  localparam int unsigned SlotBits = SlotXBits + SlotYBits,
  // {change: the slot changes hands, evict: it had a tile; that tile; rows that memory has of the
  // new one; the stamp}
  localparam int unsigned QueuedBits = 2 + TileBits + 4 + StampBits
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  input  logic                  stamp_valid_i,
  output logic                  stamp_ready_o,
  input  logic [StampBits-1:0]  stamp_i,
  output logic                  queued_valid_o,
  input  logic                  queued_ready_i,
  output logic [QueuedBits-1:0] queued_o,

  // Which rows of a tile were touched, of the bank that is drawn: a read takes a cycle
  output logic                  bank_o,
  output logic                  touched_read_en_o,
  output logic [TileBits-1:0]   touched_read_tile_o,
  input  logic [3:0]            touched_i,
  output logic                  touched_write_en_o,
  output logic [TileBits-1:0]   touched_write_tile_o,
  output logic [3:0]            touched_write_o,

  // A tile is asked for; a tile is replaced
  output logic                  fetch_valid_o,
  input  logic                  fetch_ready_i,
  output logic [TileBits-1:0]   looked_tile_o,
  input  logic                  behind_i,  // that tile is on its way to memory
  output logic                  evict_o,
  input  logic                  behind_room_i,
  output logic [TileBits-1:0]   old_tile_o,

  // Flush
  input  logic                  flushes_i,
  input  logic                  flush_next_i,
  input  logic [SlotBits-1:0]   flush_slot_i,
  output logic                  flush_valid_o,
  input  logic                  ends_i
);
  localparam int unsigned HeadBits = 2 + IndexBits + XBits + YBits;
  localparam int unsigned ShiftX = 3 - $clog2(LanesX);  // of a stamp's x to its tile's
  localparam int unsigned ShiftY = 3 - $clog2(LanesY);
  localparam int unsigned NumberBits = 6 - $clog2(Lanes);  // of a stamp in its tile
  localparam int unsigned Slots = 1 << SlotBits;

  logic looked_valid_q, look, looked_go, closing_q;  // closing: until the frame is in memory
  logic [StampBits-1:0] looked_q;
  hs_formats_pkg::stamp_head_t stamp_head, looked_head;
  logic [TileBits-1:0] stamp_tile, looked_tile, old_tile;
  logic [SlotXBits-1:0] slot_x;
  logic [SlotYBits-1:0] slot_y;
  logic [TileXBits-1:0] stamp_tile_x, tile_x;
  logic [TileYBits-1:0] stamp_tile_y, tile_y;
  logic [SlotBits-1:0] looked_slot, tag_slot;
  logic [NumberBits-1:0] number;
  logic [TileBits-1:0] tags_q [Slots];
  logic [3:0] rows_q [Slots];  // touched, of the tile
  logic [3:0] old_rows, looked_rows, stored_rows, forward_q;
  logic [Slots-1:0] valid_q;
  logic covers, change, fetch, evict, queue_ready, forwards_q, unused_heads;

  assign stamp_head = stamp_i[StampBits-1-:HeadBits];
  assign looked_head = looked_q[StampBits-1-:HeadBits];
  // By variables: Yosys does not narrow inside of a concatenation.
  assign stamp_tile_x = TileXBits'(stamp_head.x >> ShiftX);
  assign stamp_tile_y = TileYBits'(stamp_head.y >> ShiftY);
  assign stamp_tile = {stamp_tile_y, stamp_tile_x};
  assign tile_x = TileXBits'(looked_head.x >> ShiftX);
  assign tile_y = TileYBits'(looked_head.y >> ShiftY);
  assign looked_tile = {tile_y, tile_x};
  // As hs_tile_cache has it.
  assign slot_x = SlotXBits'(tile_x) ^ SlotXBits'(tile_y >> SlotYBits);
  assign slot_y = SlotYBits'(tile_y) ^ SlotYBits'(tile_x >> SlotXBits);
  assign looked_slot = {slot_y, slot_x};

  assign number = (NumberBits'(looked_head.y) << ShiftX)
                  | (NumberBits'(looked_head.x) & NumberBits'((1 << ShiftX) - 1));
  assign looked_rows = 4'd1 << 2'(number >> (NumberBits - 2));
  assign unused_heads = ^{stamp_head, looked_head};  // they have more than a place and `last`

  assign tag_slot = flushes_i ? flush_slot_i : looked_slot;
  assign old_tile = tags_q[tag_slot];
  assign old_rows = rows_q[tag_slot];
  assign covers = looked_q[StampBits-HeadBits-1-:Lanes] != '0;
  assign change = covers && !(valid_q[looked_slot] && old_tile == looked_tile);
  // A tile that is replaced while it is looked up is as it is then.
  assign stored_rows = forwards_q ? forward_q : touched_i;
  assign fetch = change && stored_rows != 4'd0;
  assign evict = change && valid_q[looked_slot];
  assign looked_go = looked_valid_q && queue_ready && !closing_q && (!evict || behind_room_i)
                     && (!fetch || (fetch_ready_i && !behind_i));
  // The bits of the next frame are others: its first stamp waits outside.
  assign stamp_ready_o = !closing_q
                         && (!looked_valid_q || (looked_go && !looked_head.last));
  assign look = stamp_valid_i && stamp_ready_o;

  assign touched_read_en_o = look;
  assign touched_read_tile_o = stamp_tile;
  assign touched_write_en_o = (looked_go && evict) || (flush_next_i && valid_q[flush_slot_i]);
  assign touched_write_tile_o = old_tile;
  assign touched_write_o = old_rows;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      looked_valid_q <= 1'b0;
      closing_q <= 1'b0;
      bank_o <= 1'b0;
      valid_q <= '0;
    end else begin
      if (look) looked_valid_q <= 1'b1;
      else if (looked_go) looked_valid_q <= 1'b0;
      if (looked_go && looked_head.last) closing_q <= 1'b1;
      if (looked_go && change) valid_q[looked_slot] <= 1'b1;
      if (ends_i) begin
        closing_q <= 1'b0;
        bank_o <= !bank_o;
        valid_q <= '0;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (look) looked_q <= stamp_i;
    if (looked_go && change) tags_q[looked_slot] <= looked_tile;
    if (looked_go && covers) rows_q[looked_slot] <= (change ? stored_rows : old_rows) | looked_rows;
    if (look) begin
      forwards_q <= looked_go && evict && old_tile == stamp_tile;
      forward_q <= old_rows;
    end
  end

  assign fetch_valid_o = looked_go && fetch;
  assign looked_tile_o = looked_tile;
  assign evict_o = looked_go && evict;
  assign old_tile_o = old_tile;
  assign flush_valid_o = valid_q[flush_slot_i];

  hs_fifo #(
    .Width(QueuedBits),
    .Depth(QueueDepth)
  ) u_queue (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (looked_go),
    .in_ready_o (queue_ready),
    .in_i       ({change, evict, old_tile, stored_rows, looked_q}),
    .out_valid_o(queued_valid_o),
    .out_ready_i(queued_ready_i),
    .out_o      (queued_o)
  );
endmodule
