// SPDX-License-Identifier: Apache-2.0
// The slots of hs_tile_cache, with index and depth: the RAMs of ztest_index, and the four clients
// of memory.
//
// A place is {slot, row of 16 pixels, stamp of the row}. ztest_index reads and writes stamps; a
// read takes a cycle, its word stays until the next one. In a step, which has the RAMs to itself,
// row row_i of slot_i is read, if it is below 4, and the one before it, which was read in the step
// before, goes to memory (moves_out_i) and gets its new words: of the rows stored_i what came from
// memory, 0 of others. The last of the rows that go, final_i, sends the request for all of them.
// Flushed rows go to memory and stay as they are, and depth does not go.
module hs_tile_slots #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned MemoryBits,
  parameter int unsigned SlotBits,
  parameter int unsigned TileBits,
  parameter int unsigned TilesAhead,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * DepthBits : 1,
  localparam int unsigned RowStamps = 16 / Lanes,
  localparam int unsigned SelectBits = RowStamps > 1 ? $clog2(RowStamps) : 1,
  localparam int unsigned PlaceBits = SlotBits + 2 + SelectBits
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  input  logic [hs_memory_pkg::AddressBits-1:0] index_base_i,
  input  logic [hs_memory_pkg::AddressBits-1:0] depth_base_i,
  input  logic                                  bank_i,

  // ztest_index
  input  logic                                  read_en_i,
  input  logic [PlaceBits-1:0]                  read_place_i,
  output logic [Lanes*IndexBits-1:0]            read_index_o,
  output logic [DepthsBits-1:0]                 read_depth_o,
  input  logic [Lanes-1:0]                      write_en_i,
  input  logic [PlaceBits-1:0]                  write_place_i,
  input  hs_formats_pkg::index_t                write_index_i,
  input  logic [DepthsBits-1:0]                 write_depth_i,

  // Tiles that are asked for
  input  logic                                  fetch_i,
  input  logic [TileBits-1:0]                   fetch_tile_i,
  output logic [1:0]                            fetch_ready_o,
  output logic [1:0]                            row_valid_o,

  // Steps
  input  logic                                  step_i,
  input  logic                                  flushes_i,
  input  logic [SlotBits-1:0]                   slot_i,
  input  logic [2:0]                            row_i,
  input  logic [3:0]                            stored_i,
  input  logic                                  moves_out_i,
  input  logic [1:0]                            first_i,
  input  logic [1:0]                            final_i,
  input  logic [TileBits-1:0]                   out_tile_i,
  output logic [1:0]                            room_o,

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
  output logic [2*MemoryBits-1:0]               store_o
);
  localparam int unsigned Slots = 1 << SlotBits;
  localparam int unsigned IndexRowBits = 16 * IndexBits;
  localparam int unsigned DepthRowBits = HasDepth != 0 ? 16 * DepthBits : 1;

  logic [SelectBits-1:0] select_q;
  logic [SlotBits+1:0] read_row_place, write_row_place;
  logic [15:0] write_mask;
  logic write_swaps, row_taken, row_out, row_last;
  logic [1:0] row_before;
  logic [IndexRowBits-1:0] index_row, read_index_row;
  logic [DepthRowBits-1:0] depth_row, read_depth_row;

  assign row_before = 2'(row_i - 3'd1);
  assign read_row_place = step_i ? {slot_i, row_i[1:0]} : read_place_i[PlaceBits-1-:SlotBits+2];
  assign write_swaps = step_i && !flushes_i && row_i != 3'd0;
  assign write_row_place = write_swaps ? {slot_i, row_before}
                           : write_place_i[PlaceBits-1-:SlotBits+2];
  assign row_taken = write_swaps && stored_i != 4'd0;
  assign row_out = step_i && row_i != 3'd0 && moves_out_i;
  assign row_last = row_i == 3'(final_i) + 3'd1;

  always_comb begin
    write_mask = {16{write_swaps}};
    for (int unsigned i = 0; i < RowStamps; i++) begin
      if (!write_swaps && (RowStamps == 1 || write_place_i[SelectBits-1:0] == SelectBits'(i))) begin
        write_mask[i*Lanes +: Lanes] = write_en_i;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (read_en_i) select_q <= read_place_i[SelectBits-1:0];
  end

  hs_ram_1r1w #(
    .Width(IndexRowBits),
    .Depth(4 * Slots),
    .Lanes(16)
  ) u_index (
    .clk_i          (clk_i),
    .read_en_i      (read_en_i || (step_i && row_i != 3'd4)),
    .read_address_i (read_row_place),
    .read_data_o    (read_index_row),
    .write_en_i     (write_mask),
    .write_address_i(write_row_place),
    .write_data_i   (write_swaps ? (stored_i[row_before] ? index_row : '0) : {16{write_index_i}})
  );

  always_comb begin
    read_index_o = '0;
    for (int unsigned i = 0; i < RowStamps; i++) begin
      if (RowStamps == 1 || select_q == SelectBits'(i)) begin
        read_index_o = read_index_row[i*Lanes*IndexBits +: Lanes*IndexBits];
      end
    end
  end

  hs_row_fetch #(
    .RowBits   (IndexRowBits),
    .MemoryBits(MemoryBits),
    .TileBits  (TileBits + 1),
    .Tiles     (TilesAhead)
  ) u_fetch_index (
    .clk_i       (clk_i),
    .rst_ni      (rst_ni),
    .base_i      (index_base_i),
    .tile_valid_i(fetch_i),
    .tile_ready_o(fetch_ready_o[0]),
    .tile_i      ({bank_i, fetch_tile_i}),
    .row_valid_o (row_valid_o[0]),
    .row_ready_i (row_taken),
    .row_o       (index_row),
    .read_valid_o(read_valid_o[0]),
    .read_ready_i(read_ready_i[0]),
    .read_o      (read_index_request_o),
    .data_valid_i(data_valid_i[0]),
    .data_i      (data_i[0 +: MemoryBits])
  );

  hs_row_store #(
    .RowBits   (IndexRowBits),
    .MemoryBits(MemoryBits),
    .TileBits  (TileBits + 1)
  ) u_store_index (
    .clk_i        (clk_i),
    .rst_ni       (rst_ni),
    .base_i       (index_base_i),
    .room_o       (room_o[0]),
    .row_i        (row_out),
    .row_word_i   (read_index_row),
    .row_last_i   (row_last),
    .tile_i       ({bank_i, out_tile_i}),
    .first_i      (first_i),
    .more_i       (final_i - first_i),
    .write_valid_o(write_valid_o[0]),
    .write_ready_i(write_ready_i[0]),
    .write_o      (write_index_request_o),
    .store_valid_o(store_valid_o[0]),
    .store_ready_i(store_ready_i[0]),
    .store_o      (store_o[0 +: MemoryBits])
  );

  if (HasDepth != 0) begin : gen_depth
    hs_ram_1r1w #(
      .Width(DepthRowBits),
      .Depth(4 * Slots),
      .Lanes(16)
    ) u_depth (
      .clk_i          (clk_i),
      .read_en_i      (read_en_i || (step_i && row_i != 3'd4)),
      .read_address_i (read_row_place),
      .read_data_o    (read_depth_row),
      .write_en_i     (write_mask),
      .write_address_i(write_row_place),
      .write_data_i   (write_swaps ? depth_row : {RowStamps{write_depth_i}})
    );

    always_comb begin
      read_depth_o = '0;
      for (int unsigned i = 0; i < RowStamps; i++) begin
        if (RowStamps == 1 || select_q == SelectBits'(i)) begin
          read_depth_o = read_depth_row[i*DepthsBits +: DepthsBits];
        end
      end
    end

    hs_row_fetch #(
      .RowBits   (DepthRowBits),
      .MemoryBits(MemoryBits),
      .TileBits  (TileBits),
      .Tiles     (TilesAhead)
    ) u_fetch_depth (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .base_i      (depth_base_i),
      .tile_valid_i(fetch_i),
      .tile_ready_o(fetch_ready_o[1]),
      .tile_i      (fetch_tile_i),
      .row_valid_o (row_valid_o[1]),
      .row_ready_i (row_taken),
      .row_o       (depth_row),
      .read_valid_o(read_valid_o[1]),
      .read_ready_i(read_ready_i[1]),
      .read_o      (read_depth_request_o),
      .data_valid_i(data_valid_i[1]),
      .data_i      (data_i[MemoryBits +: MemoryBits])
    );

    hs_row_store #(
      .RowBits   (DepthRowBits),
      .MemoryBits(MemoryBits),
      .TileBits  (TileBits)
    ) u_store_depth (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .base_i       (depth_base_i),
      .room_o       (room_o[1]),
      .row_i        (row_out && !flushes_i),
      .row_word_i   (read_depth_row),
      .row_last_i   (row_last),
      .tile_i       (out_tile_i),
      .first_i      (first_i),
      .more_i       (final_i - first_i),
      .write_valid_o(write_valid_o[1]),
      .write_ready_i(write_ready_i[1]),
      .write_o      (write_depth_request_o),
      .store_valid_o(store_valid_o[1]),
      .store_ready_i(store_ready_i[1]),
      .store_o      (store_o[MemoryBits +: MemoryBits])
    );
  end else begin : gen_no_depth
    logic unused_depth;
    assign unused_depth = ^{write_depth_i, depth_base_i, read_ready_i[1], data_valid_i[1],
                            data_i[MemoryBits +: MemoryBits], write_ready_i[1], store_ready_i[1],
                            depth_row, read_depth_row};
    assign depth_row = 1'b0;
    assign read_depth_row = 1'b0;
    assign read_depth_o = 1'b0;
    assign fetch_ready_o[1] = 1'b1;
    assign row_valid_o[1] = 1'b1;
    assign room_o[1] = 1'b1;
    assign read_valid_o[1] = 1'b0;
    assign read_depth_request_o = '0;
    assign write_valid_o[1] = 1'b0;
    assign write_depth_request_o = '0;
    assign store_valid_o[1] = 1'b0;
    assign store_o[MemoryBits +: MemoryBits] = '0;
  end
endmodule
