// SPDX-License-Identifier: Apache-2.0
// The I-buffer and the Z-buffer in memory, as ztest_index reads and writes them: a direct-mapped
// cache of tiles of 8×8 pixels, before the unit as a gate of its stamps, and beside it as its RAMs.
//
//   stamp ─► look up ─► queue ─► gate ─► ztest_index
//               │ asks ahead       ▲        │ reads, writes
//               ▼                  │        ▼
//            memory ─────rows────► swap ◄─► slots ─► memory
//
// A stamp is looked up as it enters the queue: what its slot will hold when the stamps before it
// have passed. So a tile is asked for while they do. At the end of the queue the stamp waits for
// its tile, and for the unit to be empty; then the slot changes hands, a row of 16 pixels a cycle:
// rows of the old tile go to memory, from the first to the last of those that are not as memory has
// them; the new rows are what came, or 0 where the frame has not touched them. Of a tile on its way
// to memory nothing is asked until memory has it. A stamp that covers nothing needs no tile.
// After the last stamp of a frame the index tiles go to memory; depth is not needed any more.
// stored_o says that memory has the frame. A row is touched when a stamp that covers something of
// it is looked up; memory has it when its tile is replaced, and the bits `touched` say so then.
//
// Interval: a stamp a cycle where no slot changes hands, else 5 cycles, those that the unit takes
// to be empty, and what the memory is late. Latency: 2 cycles more than the unit.
// The unit's reads and writes are of the stamps as it took them: a read when it moves next, a write
// when it moves for the third time after; a move is stamp_ready_i.
// Illegal: objects, which look at depth at scan-out; type gamma.
module hs_tile_cache #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned MemoryBits,
  parameter int unsigned SlotsX,  // powers of two
  parameter int unsigned SlotsY,
  parameter int unsigned QueueDepth = 64,
  parameter int unsigned TilesAhead = 8,   // asked for and not in a slot
  parameter int unsigned TilesBehind = 16,  // replaced and not in memory, a power of two
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * DepthBits : 1,
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
  localparam int unsigned SlotBits = SlotXBits + SlotYBits
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  input  logic [hs_memory_pkg::AddressBits-1:0] index_base_i,
  input  logic [hs_memory_pkg::AddressBits-1:0] depth_base_i,
  output logic                                  stored_o,  // a frame is in memory

  // From raster_pineda, and on to ztest_index
  input  logic                                  stamp_valid_i,
  output logic                                  stamp_ready_o,
  input  logic [StampBits-1:0]                  stamp_i,
  output logic                                  stamp_valid_o,
  input  logic                                  stamp_ready_i,
  output logic [StampBits-1:0]                  stamp_o,

  // The unit's RAMs
  input  logic                                  read_en_i,
  output logic [Lanes*IndexBits-1:0]            read_index_o,
  output logic [DepthsBits-1:0]                 read_depth_o,
  input  logic [Lanes-1:0]                      write_en_i,
  input  hs_formats_pkg::index_t                write_index_i,
  input  logic [DepthsBits-1:0]                 write_depth_i,

  // Which rows of a tile were touched, of the bank that is drawn: a read takes a cycle
  output logic                                  touched_bank_o,
  output logic                                  touched_read_en_o,
  output logic [TileBits-1:0]                   touched_read_tile_o,
  input  logic [3:0]                            touched_i,
  output logic                                  touched_write_en_o,
  output logic [TileBits-1:0]                   touched_write_tile_o,
  output logic [3:0]                            touched_write_o,

  // Memory: ReadIndex, ReadDepth; WriteIndex, WriteDepth. Without depth the latter ask for nothing.
  output logic [1:0]                            read_valid_o,
  input  logic [1:0]                            read_ready_i,
  output hs_memory_pkg::request_t               read_index_request_o,
  output hs_memory_pkg::request_t               read_depth_request_o,
  input  logic [1:0]                            data_valid_i,
  input  logic [2*MemoryBits-1:0]               data_i,
  output logic [1:0]                            write_valid_o,
  input  logic [1:0]                            write_ready_i,
  output hs_memory_pkg::request_t               write_index_request_o,
  output hs_memory_pkg::request_t               write_depth_request_o,
  output logic [1:0]                            store_valid_o,
  input  logic [1:0]                            store_ready_i,
  output logic [2*MemoryBits-1:0]               store_o,
  input  logic [1:0]                            written_i
);
  localparam int unsigned HeadBits = 2 + IndexBits + XBits + YBits;
  localparam int unsigned ShiftX = 3 - $clog2(LanesX);  // of a stamp's x to its tile's
  localparam int unsigned ShiftY = 3 - $clog2(LanesY);
  localparam int unsigned RowStamps = 16 / Lanes;
  localparam int unsigned NumberBits = 6 - $clog2(Lanes);  // of a stamp in its tile
  localparam int unsigned SelectBits = RowStamps > 1 ? $clog2(RowStamps) : 1;  // in its row
  localparam int unsigned Slots = 1 << SlotBits;
  localparam int unsigned PlaceBits = SlotBits + 2 + SelectBits;  // {slot, row, stamp of the row}

  if (hs_formats_pkg::HasObjects != 0) begin : gen_objects_illegal
    $error("hs_tile_cache: with objects the Z-buffer is looked at when a frame is drawn: inside");
  end

  // --- Look-up and queue; what was replaced ---
  logic queued_valid, queued_ready, queued_change, queued_evict, fetch_valid, evict, behind;
  logic behind_room, flushes_q, flush_next, flush_valid, ends, none_behind, unused_head;
  logic [1:0] fetch_ready, row_valid, room;
  logic [3:0] queued_stored;
  logic [TileBits-1:0] queued_old, looked_tile, old_tile;
  logic [StampBits-1:0] queued;
  logic [SlotBits-1:0] flush_slot_q;
  logic [SlotBits:0] index_done;
  hs_formats_pkg::stamp_head_t queued_head;

  assign queued_head = queued[StampBits-1-:HeadBits];
  assign unused_head = ^queued_head;  // it has more than a place and `last`

  hs_tile_look #(
    .LanesX    (LanesX),
    .LanesY    (LanesY),
    .SlotsX    (SlotsX),
    .SlotsY    (SlotsY),
    .QueueDepth(QueueDepth)
  ) u_look (
    .clk_i               (clk_i),
    .rst_ni              (rst_ni),
    .stamp_valid_i       (stamp_valid_i),
    .stamp_ready_o       (stamp_ready_o),
    .stamp_i             (stamp_i),
    .queued_valid_o      (queued_valid),
    .queued_ready_i      (queued_ready),
    .queued_o            ({queued_change, queued_evict, queued_old, queued_stored, queued}),
    .bank_o              (touched_bank_o),
    .touched_read_en_o   (touched_read_en_o),
    .touched_read_tile_o (touched_read_tile_o),
    .touched_i           (touched_i),
    .touched_write_en_o  (touched_write_en_o),
    .touched_write_tile_o(touched_write_tile_o),
    .touched_write_o     (touched_write_o),
    .fetch_valid_o       (fetch_valid),
    .fetch_ready_i       (&fetch_ready),
    .looked_tile_o       (looked_tile),
    .behind_i            (behind),
    .evict_o             (evict),
    .behind_room_i       (behind_room),
    .old_tile_o          (old_tile),
    .flushes_i           (flushes_q),
    .flush_next_i        (flush_next),
    .flush_slot_i        (flush_slot_q),
    .flush_valid_o       (flush_valid),
    .ends_i              (ends)
  );

  // --- Gate: the place of a stamp goes along with it through the unit ---
  logic changed_q;  // the slot has changed hands for the stamp that waits
  logic read_valid_q, test_valid_q, write_valid_q, busy, last_q;
  logic [PlaceBits-1:0] place, read_place_q, test_place_q, write_place_q;
  logic [NumberBits-1:0] number;
  logic [SlotXBits-1:0] slot_x;
  logic [SlotYBits-1:0] slot_y;
  logic [1:0] row;
  logic [SelectBits-1:0] select;
  logic [TileXBits-1:0] tile_x;
  logic [TileYBits-1:0] tile_y;
  logic [SlotBits-1:0] slot;
  logic [3:0] stored_q [Slots];  // rows that memory had when the slot changed hands
  logic read_new_q, test_new_q, write_new_q;  // the stamp covers of a row that it had not

  assign number = (NumberBits'(queued_head.y) << ShiftX)
                  | (NumberBits'(queued_head.x) & NumberBits'((1 << ShiftX) - 1));
  assign tile_x = TileXBits'(queued_head.x >> ShiftX);
  assign tile_y = TileYBits'(queued_head.y >> ShiftY);
  // A block of tiles has slots of its own, and other blocks have them in another order: what is
  // high or wide does not meet itself.
  assign slot_x = SlotXBits'(tile_x) ^ SlotXBits'(tile_y >> SlotYBits);
  assign slot_y = SlotYBits'(tile_y) ^ SlotYBits'(tile_x >> SlotXBits);
  assign slot = {slot_y, slot_x};
  assign row = 2'(number >> (NumberBits - 2));
  assign select = SelectBits'(number) & SelectBits'(RowStamps - 1);
  assign place = {slot, row, select};
  assign stamp_valid_o = queued_valid && (!queued_change || changed_q);
  assign stamp_o = queued;
  assign queued_ready = stamp_ready_i && stamp_valid_o;
  assign busy = read_valid_q || test_valid_q || write_valid_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      read_valid_q <= 1'b0;
      test_valid_q <= 1'b0;
      write_valid_q <= 1'b0;
    end else if (stamp_ready_i) begin
      read_valid_q <= stamp_valid_o;
      test_valid_q <= read_valid_q;
      write_valid_q <= test_valid_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (stamp_ready_i) begin
      read_place_q <= place;
      test_place_q <= read_place_q;
      write_place_q <= test_place_q;
      read_new_q <= queued[StampBits-HeadBits-1-:Lanes] != '0
                    && !stored_q[slot][place[SelectBits +: 2]];
      test_new_q <= read_new_q;
      write_new_q <= test_new_q;
    end
  end

  // --- A slot changes hands, or is flushed: row_q reads a row and moves the one before it ---
  logic swaps_q, swap_start, step, moves_out, from_memory, swap_ends, flushes_tile;
  logic [3:0] dirty_q [Slots];  // rows that are not as memory has them
  logic [3:0] dirty, unit_dirty;
  logic [1:0] first, final_row;  // of those
  logic unit_writes;
  logic [2:0] row_q;   // 4: none is read any more
  logic [SlotBits-1:0] swap_slot;

  assign swap_start = queued_valid && queued_change && !changed_q && !swaps_q && !busy;
  assign swap_slot = flushes_q ? flush_slot_q : slot;
  assign dirty = (flushes_q ? flush_valid : queued_evict) ? dirty_q[swap_slot] : 4'd0;
  assign flushes_tile = flushes_q && dirty != 4'd0;
  always_comb begin
    first = 2'd0;
    final_row = 2'd3;
    for (int unsigned i = 4; i > 0; i--) if (dirty[i-1]) first = 2'(i - 1);
    for (int unsigned i = 0; i < 4; i++) if (dirty[i]) final_row = 2'(i);
  end
  // The row before row_q.
  assign moves_out = dirty != 4'd0 && row_q > 3'(first) && row_q <= 3'(final_row) + 3'd1;
  assign from_memory = swaps_q && queued_stored != 4'd0;
  assign step = (swaps_q || flushes_tile)
                && (row_q == 3'd0 || ((!moves_out || (room[0] && (flushes_q || room[1])))
                                      && (!from_memory || &row_valid)));
  assign swap_ends = step && row_q == 3'd4;
  assign flush_next = flushes_q && (swap_ends || !flushes_tile);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      swaps_q <= 1'b0;
      changed_q <= 1'b0;
      row_q <= 3'd0;
    end else begin
      if (swap_start) swaps_q <= 1'b1;
      else if (swap_ends) swaps_q <= 1'b0;
      if (swap_ends && swaps_q) changed_q <= 1'b1;
      else if (queued_ready) changed_q <= 1'b0;
      if (step) row_q <= swap_ends ? 3'd0 : row_q + 3'd1;
    end
  end

  assign unit_writes = stamp_ready_i && write_valid_q && (write_new_q || |write_en_i);
  assign unit_dirty = dirty_q[write_place_q[PlaceBits-1-:SlotBits]]
                      | 4'd1 << write_place_q[SelectBits +: 2];

  always_ff @(posedge clk_i) begin
    if (unit_writes) dirty_q[write_place_q[PlaceBits-1-:SlotBits]] <= unit_dirty;
    else if (swap_ends && swaps_q) dirty_q[slot] <= 4'd0;
    if (swap_ends && swaps_q) stored_q[slot] <= queued_stored;
  end

  hs_tile_behind #(
    .TileBits   (TileBits),
    .TilesBehind(TilesBehind),
    .DoneBits   (SlotBits + 1)
  ) u_behind (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .looked_tile_i (looked_tile),
    .behind_o      (behind),
    .room_o        (behind_room),
    .evict_i       (evict),
    .evict_tile_i  (old_tile),
    .swapped_i     (swap_ends && swaps_q),
    .swapped_tile_i(queued_evict),
    .clean_i       (dirty == 4'd0),
    .written_i     (written_i),
    .none_o        (none_behind),
    .ends_i        (ends),
    .index_done_o  (index_done)
  );

  // --- Flush: when the last stamp has left the unit, and memory has what was replaced ---
  logic flushed_all_q;
  logic [SlotBits:0] flushed_q;
  assign ends = flushed_all_q && index_done == flushed_q;
  assign stored_o = ends;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      last_q <= 1'b0;
      flushes_q <= 1'b0;
      flushed_all_q <= 1'b0;
    end else begin
      if (queued_ready && queued_head.last) last_q <= 1'b1;
      if (last_q && !busy && none_behind) begin
        last_q <= 1'b0;
        flushes_q <= 1'b1;
      end
      if (flush_next && &flush_slot_q) begin
        flushes_q <= 1'b0;
        flushed_all_q <= 1'b1;
      end
      if (ends) flushed_all_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (last_q) begin
      flush_slot_q <= '0;
      flushed_q <= '0;
    end else if (flush_next) begin
      flush_slot_q <= flush_slot_q + SlotBits'(1);
      flushed_q <= flushed_q + (SlotBits+1)'(flushes_tile);
    end
  end

  // --- Slots ---
  hs_tile_slots #(
    .LanesX    (LanesX),
    .LanesY    (LanesY),
    .MemoryBits(MemoryBits),
    .SlotBits  (SlotBits),
    .TileBits  (TileBits),
    .TilesAhead(TilesAhead)
  ) u_slots (
    .clk_i                (clk_i),
    .rst_ni               (rst_ni),
    .index_base_i         (index_base_i),
    .depth_base_i         (depth_base_i),
    .bank_i               (touched_bank_o),
    .read_en_i            (read_en_i),
    .read_place_i         (read_place_q),
    .read_index_o         (read_index_o),
    .read_depth_o         (read_depth_o),
    .write_en_i           (write_en_i),
    .write_place_i        (write_place_q),
    .write_index_i        (write_index_i),
    .write_depth_i        (write_depth_i),
    .fetch_i              (fetch_valid),
    .fetch_tile_i         (looked_tile),
    .fetch_ready_o        (fetch_ready),
    .row_valid_o          (row_valid),
    .step_i               (step),
    .flushes_i            (flushes_q),
    .slot_i               (swap_slot),
    .row_i                (row_q),
    .stored_i             (queued_stored),
    .moves_out_i          (moves_out),
    .first_i              (first),
    .final_i              (final_row),
    .out_tile_i           (flushes_q ? old_tile : queued_old),
    .room_o               (room),
    .read_valid_o         (read_valid_o),
    .read_ready_i         (read_ready_i),
    .read_index_request_o (read_index_request_o),
    .read_depth_request_o (read_depth_request_o),
    .data_valid_i         (data_valid_i),
    .data_i               (data_i),
    .write_valid_o        (write_valid_o),
    .write_ready_i        (write_ready_i),
    .write_index_request_o(write_index_request_o),
    .write_depth_request_o(write_depth_request_o),
    .store_valid_o        (store_valid_o),
    .store_ready_i        (store_ready_i),
    .store_o              (store_o)
  );
endmodule
