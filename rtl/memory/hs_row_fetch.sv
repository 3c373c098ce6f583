// SPDX-License-Identifier: Apache-2.0
// Tiles of a buffer from memory, as rows of 16 values: the client that reads (hs_memory_pkg).
//
// A tile of 8×8 pixels is four rows (TileRows), in the order of its stamps and their lanes. Each
// row begins at a word of memory; what it leaves of its last one is not looked at. Tile n begins at
// base_i and n strides, a stride being the least power of two of bytes that holds a tile.
//
// Rows come in the order of the tiles that were asked for. A tile is taken when there is room for
// its rows: no more than Tiles are asked for and not yet given as rows, and of these rows no more
// than Rows may wait to be taken. Illegal: Rows below TileRows·Tiles, unless rows are taken as they
// come.
// Interval: a word of memory a cycle.
module hs_row_fetch #(
  parameter int unsigned RowBits,
  parameter int unsigned MemoryBits,
  parameter int unsigned TileBits,  // of a tile's number
  parameter int unsigned TileRows = 4,
  parameter int unsigned Tiles = 8,
  parameter int unsigned Rows = TileRows * Tiles
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  input  logic [hs_memory_pkg::AddressBits-1:0] base_i,

  input  logic                                  tile_valid_i,
  output logic                                  tile_ready_o,
  input  logic [TileBits-1:0]                   tile_i,

  output logic                                  row_valid_o,
  input  logic                                  row_ready_i,
  output logic [RowBits-1:0]                    row_o,

  // Memory
  output logic                                  read_valid_o,
  input  logic                                  read_ready_i,
  output hs_memory_pkg::request_t               read_o,
  input  logic                                  data_valid_i,
  input  logic [MemoryBits-1:0]                 data_i
);
  localparam int unsigned AddressBits = hs_memory_pkg::AddressBits;
  localparam int unsigned RowWords = (RowBits + MemoryBits - 1) / MemoryBits;
  localparam int unsigned StrideBits = $clog2(TileRows * RowWords * MemoryBits / 8);
  localparam int unsigned WordBits = RowWords > 1 ? $clog2(RowWords) : 1;
  localparam int unsigned CountBits = $clog2(TileRows * Tiles + 1);

  logic [CountBits-1:0] rows_q;  // asked for, and not taken
  logic [WordBits-1:0] word_q;   // of the row that comes
  logic tile_moves, row_moves, row_comes, unused_ready, unused_top;
  logic [TileBits-1:0] tile;
  logic [RowWords*MemoryBits-1:0] row;

  assign tile_ready_o = rows_q <= CountBits'(TileRows * (Tiles - 1));
  assign tile_moves = tile_valid_i && tile_ready_o;
  assign row_moves = row_valid_o && row_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) rows_q <= '0;
    else rows_q <= rows_q + (tile_moves ? CountBits'(TileRows) : '0) - CountBits'(row_moves);
  end

  hs_fifo #(
    .Width(TileBits),
    .Depth(Tiles)
  ) u_tiles (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (tile_moves),
    .in_ready_o (unused_ready),
    .in_i       (tile_i),
    .out_valid_o(read_valid_o),
    .out_ready_i(read_ready_i),
    .out_o      (tile)
  );
  assign read_o.address = base_i + AddressBits'({tile, {StrideBits{1'b0}}});
  assign read_o.beats = hs_memory_pkg::BeatsBits'(TileRows * RowWords);

  // --- Words into a row: the last one that came is on top ---
  if (RowWords > 1) begin : gen_words
    logic [(RowWords-1)*MemoryBits-1:0] words_q;
    always_ff @(posedge clk_i) begin
      if (data_valid_i) words_q <= row[RowWords*MemoryBits-1:MemoryBits];
    end
    assign row = {data_i, words_q};
  end else begin : gen_word
    assign row = data_i;
  end
  assign row_comes = data_valid_i && word_q == WordBits'(RowWords - 1);
  assign unused_top = ^row;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) word_q <= '0;
    else if (data_valid_i) word_q <= row_comes ? '0 : word_q + WordBits'(1);
  end

  logic unused_room;
  hs_fifo #(
    .Width(RowBits),
    .Depth(Rows)
  ) u_rows (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (row_comes),
    .in_ready_o (unused_room),
    .in_i       (row[RowBits-1:0]),
    .out_valid_o(row_valid_o),
    .out_ready_i(row_ready_i),
    .out_o      (row_o)
  );
endmodule
