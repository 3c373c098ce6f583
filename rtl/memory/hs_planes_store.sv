// SPDX-License-Identifier: Apache-2.0
// TdbS in memory outside, as shade_setup writes it: a word of planes is {last, empty, index, entry}
// and goes to entry index − 1 of the bank to store to, unless it is empty.
//
// planes_last_o: the last word of a frame moves. stored_last_o: memory has all of the frame.
// Between the two no word is taken. Interval: the words of memory that an entry has.
module hs_planes_store #(
  parameter int unsigned PlanesBits,
  parameter int unsigned MemoryBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles),
  localparam int unsigned EntryPlanesBits = PlanesBits - 2 - IndexBits
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  input  logic [hs_memory_pkg::AddressBits-1:0] base_i,
  input  logic                                  planes_valid_i,
  output logic                                  planes_ready_o,
  input  logic [PlanesBits-1:0]                 planes_i,
  input  logic                                  planes_bank_i,
  output logic                                  planes_last_o,
  output logic                                  stored_last_o,

  // Memory
  output logic                                  write_valid_o,
  input  logic                                  write_ready_i,
  output hs_memory_pkg::request_t               write_o,
  output logic                                  store_valid_o,
  input  logic                                  store_ready_i,
  output logic [MemoryBits-1:0]                 store_o,
  input  logic                                  written_i
);
  localparam int unsigned CountBits = 8;  // more than can be asked for and not written
  logic last, empty, room, moves, stores, closing_q, unused_index;
  logic [CountBits-1:0] count_q;  // stored, and not written
  logic [IndexBits-1:0] index;
  logic [EntryBits-1:0] entry;
  logic [EntryPlanesBits-1:0] entry_planes;

  assign {last, empty, index, entry_planes} = planes_i;
  assign entry = EntryBits'(index) - EntryBits'(1);
  assign unused_index = ^index;  // a power of two of entries has a bit less
  assign planes_ready_o = room && !closing_q && count_q != '1;
  assign moves = planes_valid_i && planes_ready_o;
  assign stores = moves && !empty;
  assign planes_last_o = moves && last;
  assign stored_last_o = closing_q && count_q == '0;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      closing_q <= 1'b0;
      count_q <= '0;
    end else begin
      if (planes_last_o) closing_q <= 1'b1;
      else if (stored_last_o) closing_q <= 1'b0;
      count_q <= count_q + CountBits'(stores) - CountBits'(written_i);
    end
  end

  hs_row_store #(
    .RowBits   (EntryPlanesBits),
    .MemoryBits(MemoryBits),
    .TileBits  (1 + EntryBits),
    .TileRows  (1)
  ) u_store (
    .clk_i        (clk_i),
    .rst_ni       (rst_ni),
    .base_i       (base_i),
    .room_o       (room),
    .row_i        (stores),
    .row_word_i   (entry_planes),
    .row_last_i   (1'b1),
    .tile_i       ({planes_bank_i, entry}),
    .first_i      (2'd0),
    .more_i       (2'd0),
    .write_valid_o(write_valid_o),
    .write_ready_i(write_ready_i),
    .write_o      (write_o),
    .store_valid_o(store_valid_o),
    .store_ready_i(store_ready_i),
    .store_o      (store_o)
  );
endmodule
