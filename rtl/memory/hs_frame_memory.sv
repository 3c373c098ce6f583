// SPDX-License-Identifier: Apache-2.0
// The I-buffer and the Z-buffer in memory outside: hs_tile_cache for ztest_index, hs_scan_rows for
// scan_index, and the bits between them, which say what rows of the frame's tiles were touched.
//
// Memory, by client: memory_o is {store, store_valid, write, write_valid, read, read_valid},
// memory_i is {written, store_ready, write_ready, data, data_valid, read_ready}, of the clients
// ReadIndex, ReadDepth, ReadScan and WriteIndex, WriteDepth (hs_memory_pkg).
module hs_frame_memory #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned MemoryBits,
  parameter int unsigned SlotsX,
  parameter int unsigned SlotsY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * DepthBits : 1,
  localparam int unsigned StampBits = 2 + IndexBits + hs_formats_pkg::XBits
                                      + hs_formats_pkg::YBits + Lanes * (1 + DepthBits),
  localparam int unsigned RequestBits = hs_memory_pkg::RequestBits,
  localparam int unsigned OutBits = 5 * (1 + RequestBits) + 2 * (1 + MemoryBits),
  localparam int unsigned InBits = 3 * (2 + MemoryBits) + 6
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  // Stamps, to ztest_index and its RAMs
  input  logic                       stamp_valid_i,
  output logic                       stamp_ready_o,
  input  logic [StampBits-1:0]       stamp_i,
  output logic                       stamp_valid_o,
  input  logic                       stamp_ready_i,
  output logic [StampBits-1:0]       stamp_o,
  input  logic                       read_en_i,
  output logic [Lanes*IndexBits-1:0] read_index_o,
  output logic [DepthsBits-1:0]      read_depth_o,
  input  logic [Lanes-1:0]           write_en_i,
  input  hs_formats_pkg::index_t     write_index_i,
  input  logic [DepthsBits-1:0]      write_depth_i,
  output logic                       stored_o,  // a frame is in memory

  // Scan-out
  input  hs_formats_pkg::x_t         frame_width_i,
  input  hs_formats_pkg::y_t         frame_height_i,
  input  logic                       start_valid_i,
  output logic                       start_ready_o,
  input  logic                       start_clear_i,
  output logic                       start_valid_o,
  input  logic                       start_ready_i,
  output logic                       scan_hold_o,
  input  logic                       scan_bank_i,
  input  logic                       scan_read_en_i,
  output logic [Lanes*IndexBits-1:0] scan_index_o,

  input  hs_memory_pkg::bases_t      memory_bases_i,
  output logic [OutBits-1:0]         memory_o,
  input  logic [InBits-1:0]          memory_i
);
  localparam int unsigned TilesX = (hs_formats_pkg::MaxWidth + 7) / 8;
  localparam int unsigned TilesY = (hs_formats_pkg::MaxHeight + 7) / 8;
  localparam int unsigned TileBits =
      (TilesX > 1 ? $clog2(TilesX) : 1) + (TilesY > 1 ? $clog2(TilesY) : 1);
  logic touched_bank, touched_read_en, touched_write_en, scan_touched_en, unused_base;
  logic [3:0] touched_read, touched_write, scan_touched;
  logic [TileBits-1:0] touched_read_tile, touched_write_tile, scan_touched_tile;

logic [2:0] read_valid, read_ready, data_valid;
  logic [3*RequestBits-1:0] read;
  logic [3*MemoryBits-1:0] data;
  logic [1:0] write_valid, write_ready, store_valid, store_ready, written;
  logic [2*RequestBits-1:0] write;
  logic [2*MemoryBits-1:0] store;

  assign unused_base = ^memory_bases_i.planes;
  assign memory_o = {store, store_valid, write, write_valid, read, read_valid};
  assign {written, store_ready, write_ready, data, data_valid, read_ready} = memory_i;

  hs_tile_cache #(
    .LanesX    (LanesX),
    .LanesY    (LanesY),
    .MemoryBits(MemoryBits),
    .SlotsX    (SlotsX),
    .SlotsY    (SlotsY)
  ) u_tile_cache (
    .clk_i                (clk_i),
    .rst_ni               (rst_ni),
    .index_base_i         (memory_bases_i.index),
    .depth_base_i         (memory_bases_i.depth),
    .stored_o             (stored_o),
    .stamp_valid_i        (stamp_valid_i),
    .stamp_ready_o        (stamp_ready_o),
    .stamp_i              (stamp_i),
    .stamp_valid_o        (stamp_valid_o),
    .stamp_ready_i        (stamp_ready_i),
    .stamp_o              (stamp_o),
    .read_en_i            (read_en_i),
    .read_index_o         (read_index_o),
    .read_depth_o         (read_depth_o),
    .write_en_i           (write_en_i),
    .write_index_i        (write_index_i),
    .write_depth_i        (write_depth_i),
    .touched_bank_o       (touched_bank),
    .touched_read_en_o    (touched_read_en),
    .touched_read_tile_o  (touched_read_tile),
    .touched_i            (touched_read),
    .touched_write_en_o   (touched_write_en),
    .touched_write_tile_o (touched_write_tile),
    .touched_write_o      (touched_write),
    .read_valid_o         (read_valid[1:0]),
    .read_ready_i         (read_ready[1:0]),
    .read_index_request_o (read[0 +: RequestBits]),
    .read_depth_request_o (read[RequestBits +: RequestBits]),
    .data_valid_i         (data_valid[1:0]),
    .data_i               (data[2*MemoryBits-1:0]),
    .write_valid_o        (write_valid),
    .write_ready_i        (write_ready),
    .write_index_request_o(write[0 +: RequestBits]),
    .write_depth_request_o(write[RequestBits +: RequestBits]),
    .store_valid_o        (store_valid),
    .store_ready_i        (store_ready),
    .store_o              (store),
    .written_i            (written)
  );

  hs_double_buffer #(
    .Width(4),
    .Depth(1 << TileBits)
  ) u_touched (
    .clk_i                (clk_i),
    .rst_ni               (rst_ni),
    .ztest_read_en_i      (touched_read_en),
    .ztest_read_bank_i    (touched_bank),
    .ztest_read_address_i (touched_read_tile),
    .ztest_read_data_o    (touched_read),
    .ztest_write_en_i     (touched_write_en),
    .ztest_write_bank_i   (touched_bank),
    .ztest_write_address_i(touched_write_tile),
    .ztest_write_data_i   (touched_write),
    .scan_bank_i          (scan_bank_i),
    .scan_read_en_i       (scan_touched_en),
    .scan_write_en_i      (scan_touched_en),
    .scan_address_i       (scan_touched_tile),
    .scan_read_data_o     (scan_touched)
  );

  hs_scan_rows #(
    .LanesX    (LanesX),
    .LanesY    (LanesY),
    .MemoryBits(MemoryBits)
  ) u_scan_rows (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .frame_width_i (frame_width_i),
    .frame_height_i(frame_height_i),
    .base_i        (memory_bases_i.index),
    .scan_bank_i   (scan_bank_i),
    .start_valid_i (start_valid_i),
    .start_ready_o (start_ready_o),
    .start_clear_i (start_clear_i),
    .start_valid_o (start_valid_o),
    .start_ready_i (start_ready_i),
    .hold_o        (scan_hold_o),
    .read_en_i     (scan_read_en_i),
    .read_index_o  (scan_index_o),
    .touched_en_o  (scan_touched_en),
    .touched_tile_o(scan_touched_tile),
    .touched_i     (scan_touched),
    .read_valid_o  (read_valid[2]),
    .read_ready_i  (read_ready[2]),
    .read_o        (read[2*RequestBits +: RequestBits]),
    .data_valid_i  (data_valid[2]),
    .data_i        (data[2*MemoryBits +: MemoryBits])
  );
endmodule
