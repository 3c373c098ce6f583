// SPDX-License-Identifier: Apache-2.0
// Rows of tiles into memory: the client that writes, in the layout that hs_row_fetch reads.
//
// Rows go in while room_o is 1, neighbours of one tile in order; the last one comes with the tile's
// number, the first one's number in it and how many they are, less one: then they are asked to be
// written, in one request. Above a row's bits its last word in memory is 0.
// Interval: a word of memory a cycle.
module hs_row_store #(
  parameter int unsigned RowBits,
  parameter int unsigned MemoryBits,
  parameter int unsigned TileBits,  // of a tile's number
  parameter int unsigned TileRows = 4,
  parameter int unsigned Tiles = 4  // that wait to be written
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  input  logic [hs_memory_pkg::AddressBits-1:0] base_i,

  output logic                                  room_o,
  input  logic                                  row_i,
  input  logic [RowBits-1:0]                    row_word_i,
  input  logic                                  row_last_i,
  input  logic [TileBits-1:0]                   tile_i,
  input  logic [1:0]                            first_i,
  input  logic [1:0]                            more_i,

  // Memory
  output logic                                  write_valid_o,
  input  logic                                  write_ready_i,
  output hs_memory_pkg::request_t               write_o,
  output logic                                  store_valid_o,
  input  logic                                  store_ready_i,
  output logic [MemoryBits-1:0]                 store_o
);
  localparam int unsigned AddressBits = hs_memory_pkg::AddressBits;
  localparam int unsigned RowWords = (RowBits + MemoryBits - 1) / MemoryBits;
  localparam int unsigned StrideBits = $clog2(TileRows * RowWords * MemoryBits / 8);
  localparam int unsigned WordBits = RowWords > 1 ? $clog2(RowWords) : 1;

  logic rows_ready, tiles_ready;
  logic [TileBits-1:0] tile;
  logic [1:0] first, more;
  logic [StrideBits-1:0] first_bytes;
  logic [RowBits-1:0] row;
  logic [RowWords*MemoryBits-1:0] words;
  logic [WordBits-1:0] word_q;
  logic row_ends;

  assign room_o = rows_ready && tiles_ready;

  hs_fifo #(
    .Width(TileBits + 4),
    .Depth(4 * Tiles)
  ) u_tiles (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (row_i && row_last_i),
    .in_ready_o (tiles_ready),
    .in_i       ({tile_i, first_i, more_i}),
    .out_valid_o(write_valid_o),
    .out_ready_i(write_ready_i),
    .out_o      ({tile, first, more})
  );
  always_comb begin
    first_bytes = '0;
    write_o.beats = '0;
    for (int unsigned i = 0; i < TileRows; i++) begin
      if (first == 2'(i)) first_bytes = StrideBits'(i * RowWords * MemoryBits / 8);
      if (more == 2'(i)) write_o.beats = hs_memory_pkg::BeatsBits'((i + 1) * RowWords);
    end
    write_o.address = base_i + AddressBits'({tile, first_bytes});
  end

  hs_fifo #(
    .Width(RowBits),
    .Depth(4 * Tiles)
  ) u_rows (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (row_i),
    .in_ready_o (rows_ready),
    .in_i       (row_word_i),
    .out_valid_o(store_valid_o),
    .out_ready_i(row_ends),
    .out_o      (row)
  );
  assign words = (RowWords*MemoryBits)'(row);
  assign row_ends = store_ready_i && word_q == WordBits'(RowWords - 1);

  always_comb begin
    store_o = '0;
    for (int unsigned i = 0; i < RowWords; i++) begin
      if (word_q == WordBits'(i)) store_o = words[i*MemoryBits +: MemoryBits];
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) word_q <= '0;
    else if (store_valid_o && store_ready_i) word_q <= row_ends ? '0 : word_q + WordBits'(1);
  end
endmodule
