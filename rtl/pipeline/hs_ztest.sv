// SPDX-License-Identifier: Apache-2.0
// The Z-test with its queues and its buffers.
//
//   stamp ─► queue ─► ztest_index ─► visible
//                          │ update
//                  I-buffer, Z-buffer ─► scan-out
//
// Type gamma: a queue of triangle_depth beside that of stamps, ztest_plane for ztest_index, and
// TdbV for the Z-buffer. Of type delta the port of triangle_depth is one bit, and not looked at.
// Interval, stall: as the unit that tests. Latency: one cycle more.
// Scan-out: a read takes one cycle; the buffers' banks are those that the frame being scanned has.
//
// OutsideFrame: the buffers are in memory outside. Then hs_tile_cache stands before ztest_index and
// has its RAMs, and hs_scan_rows has those of scan-out: start passes it, and waits for the first
// tile; while scan_hold_o is 1 no word of scan must be taken; and a frame may be scanned when
// stored_o has said so. Inside start only passes, and nothing holds.
module hs_ztest #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned StampFifoDepth,
  parameter int unsigned TriangleDepthFifoDepth,
  parameter int unsigned OutsideFrame,
  parameter int unsigned MemoryBits,
  parameter int unsigned CacheTilesX,
  parameter int unsigned CacheTilesY,
  // Of hs_frame_memory.
  localparam int unsigned MemoryOutBits =
      OutsideFrame != 0 ? 5 * (1 + hs_memory_pkg::RequestBits) + 2 * (1 + MemoryBits) : 1,
  localparam int unsigned MemoryInBits = OutsideFrame != 0 ? 3 * (2 + MemoryBits) + 6 : 1,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned StoresDepth = hs_formats_pkg::StoresDepth,
  localparam int unsigned TestsPlanes = HasDepth != 0 && StoresDepth == 0 ? 1 : 0,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned PlaceBits = IndexBits + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned StampBits = 2 + PlaceBits + Lanes * (1 + DepthBits),
  localparam int unsigned TriangleDepthBits =
      TestsPlanes != 0 ? PlaceBits + 3 * hs_formats_pkg::DepthPlaneBits : 1,
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1,
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * DepthBits : 1
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  // From raster_pineda
  input  logic                         triangle_depth_valid_i,
  output logic                         triangle_depth_ready_o,
  input  logic [TriangleDepthBits-1:0] triangle_depth_i,
  input  logic                         stamp_valid_i,
  output logic                         stamp_ready_o,
  input  logic [StampBits-1:0]         stamp_i,

  // To geometry, deferred: through visible_select
  output logic                         visible_valid_o,
  input  logic                         visible_ready_i,
  output hs_formats_pkg::visible_t     visible_o,

  // Scan-out
  input  hs_formats_pkg::x_t           frame_width_i,
  input  hs_formats_pkg::y_t           frame_height_i,
  input  logic                         start_valid_i,
  output logic                         start_ready_o,
  input  logic                         start_clear_i,
  output logic                         start_valid_o,
  input  logic                         start_ready_i,
  output logic                         scan_hold_o,
  output logic                         stored_o,
  input  logic                         scan_bank_i,
  input  logic                         scan_read_en_i,
  input  logic                         scan_write_en_i,  // clears
  input  logic [AddressBits-1:0]       scan_address_i,
  output logic [Lanes*IndexBits-1:0]   scan_index_o,
  output logic [DepthsBits-1:0]        scan_depth_o,  // type gamma: 0

  // Memory outside, of hs_frame_memory
  input  hs_memory_pkg::bases_t        memory_bases_i,
  output logic [MemoryOutBits-1:0]     memory_o,
  input  logic [MemoryInBits-1:0]      memory_i
);
  localparam int unsigned UpdateBits =
      PlaceBits + Lanes * (1 + (StoresDepth != 0 ? DepthBits : 0));

  // --- stamp ─► queue ---
  logic stamp_valid, stamp_ready, queued_stamp_valid, queued_stamp_ready;
  logic tested_stamp_valid, tested_stamp_ready;
  logic [StampBits-1:0] stamp, queued_stamp, tested_stamp;

  hs_stream #(
    .Width(StampBits)
  ) u_stream_stamp (
    .valid_i(stamp_valid_i),
    .ready_o(stamp_ready_o),
    .word_i (stamp_i),
    .valid_o(stamp_valid),
    .ready_i(stamp_ready),
    .word_o (stamp)
  );

  hs_fifo #(
    .Width(StampBits),
    .Depth(StampFifoDepth)
  ) u_stamp_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (stamp_valid),
    .in_ready_o (stamp_ready),
    .in_i       (stamp),
    .out_valid_o(queued_stamp_valid),
    .out_ready_i(queued_stamp_ready),
    .out_o      (queued_stamp)
  );

  // --- Z-test: ztest_index and Z-buffer, or ztest_plane and TdbV ---
  logic read_en, read_bank, write_bank;
  logic [AddressBits-1:0] read_address, write_address;
  logic [Lanes*IndexBits-1:0] read_index;
  logic [Lanes-1:0] write_en;
  hs_formats_pkg::index_t write_index;
  logic update_valid;
  logic [UpdateBits-1:0] update;
  logic [DepthsBits-1:0] written_depth, outside_depth;  // for buffers outside

  if (TestsPlanes != 0) begin : gen_planes
    localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);
    localparam int unsigned PlaneBits = 3 * hs_formats_pkg::DepthPlaneBits;
    logic triangle_depth_valid, triangle_depth_ready, tested_depth_valid, tested_depth_ready;
    logic [TriangleDepthBits-1:0] triangle_depth, tested_depth;
    logic fetch_en, store_en;
    logic [EntryBits-1:0] fetch_entry, store_entry;
    logic [PlaneBits-1:0] fetch_plane, store_plane;

    hs_stream #(
      .Width(TriangleDepthBits)
    ) u_stream_triangle_depth (
      .valid_i(triangle_depth_valid_i),
      .ready_o(triangle_depth_ready_o),
      .word_i (triangle_depth_i),
      .valid_o(triangle_depth_valid),
      .ready_i(triangle_depth_ready),
      .word_o (triangle_depth)
    );

    hs_fifo #(
      .Width(TriangleDepthBits),
      .Depth(TriangleDepthFifoDepth)
    ) u_triangle_depth_fifo (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .in_valid_i (triangle_depth_valid),
      .in_ready_o (triangle_depth_ready),
      .in_i       (triangle_depth),
      .out_valid_o(tested_depth_valid),
      .out_ready_i(tested_depth_ready),
      .out_o      (tested_depth)
    );

    hs_ztest_plane #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_ztest_plane (
      .clk_i                 (clk_i),
      .rst_ni                (rst_ni),
      .triangle_depth_valid_i(tested_depth_valid),
      .triangle_depth_ready_o(tested_depth_ready),
      .triangle_depth_i      (tested_depth),
      .stamp_valid_i         (tested_stamp_valid),
      .stamp_ready_o         (tested_stamp_ready),
      .stamp_i               (tested_stamp),
      .visible_valid_o       (visible_valid_o),
      .visible_ready_i       (visible_ready_i),
      .visible_o             (visible_o),
      .update_valid_o        (update_valid),
      .update_o              (update),
      .read_en_o             (read_en),
      .read_bank_o           (read_bank),
      .read_address_o        (read_address),
      .read_index_i          (read_index),
      .write_en_o            (write_en),
      .write_bank_o          (write_bank),
      .write_address_o       (write_address),
      .write_index_o         (write_index),
      .fetch_en_o            (fetch_en),
      .fetch_entry_o         (fetch_entry),
      .fetch_plane_i         (fetch_plane),
      .store_en_o            (store_en),
      .store_entry_o         (store_entry),
      .store_plane_o         (store_plane)
    );

    hs_ram_1r1w #(
      .Width(PlaneBits),
      .Depth(1 << EntryBits)
    ) u_visibility_database (
      .clk_i          (clk_i),
      .read_en_i      (fetch_en),
      .read_address_i (fetch_entry),
      .read_data_o    (fetch_plane),
      .write_en_i     (store_en),
      .write_address_i(store_entry),
      .write_data_i   (store_plane)
    );
    assign scan_depth_o = '0;
    assign written_depth = '0;
  end else begin : gen_depths
    logic [DepthsBits-1:0] read_depth, write_depth;
    logic unused_triangle_depth;

    assign unused_triangle_depth = ^{triangle_depth_valid_i, triangle_depth_i};
    assign triangle_depth_ready_o = 1'b1;

    hs_ztest_index #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_ztest_index (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .stamp_valid_i  (tested_stamp_valid),
      .stamp_ready_o  (tested_stamp_ready),
      .stamp_i        (tested_stamp),
      .visible_valid_o(visible_valid_o),
      .visible_ready_i(visible_ready_i),
      .visible_o      (visible_o),
      .update_valid_o (update_valid),
      .update_o       (update),
      .read_en_o      (read_en),
      .read_bank_o    (read_bank),
      .read_address_o (read_address),
      .read_index_i   (read_index),
      .read_depth_i   (read_depth),
      .write_en_o     (write_en),
      .write_bank_o   (write_bank),
      .write_address_o(write_address),
      .write_index_o  (write_index),
      .write_depth_o  (write_depth)
    );

    assign written_depth = write_depth;
    if (OutsideFrame != 0) begin : gen_depth_outside
      assign read_depth = outside_depth;
      assign scan_depth_o = '0;
    end else begin : gen_depth_inside
      hs_depth_buffer #(
        .Lanes(Lanes),
        .Depth(StampsX * StampsY)
      ) u_depth_buffer (
        .clk_i                (clk_i),
        .rst_ni               (rst_ni),
        .ztest_read_en_i      (read_en),
        .ztest_read_bank_i    (read_bank),
        .ztest_read_address_i (read_address),
        .ztest_read_depth_o   (read_depth),
        .ztest_write_en_i     (write_en),
        .ztest_write_bank_i   (write_bank),
        .ztest_write_address_i(write_address),
        .ztest_write_depth_i  (write_depth),
        .scan_bank_i          (scan_bank_i),
        .scan_read_en_i       (scan_read_en_i),
        .scan_address_i       (scan_address_i),
        .scan_read_depth_o    (scan_depth_o)
      );
    end
  end

  // --- update, a probe: the writes with the place that their address stands for ---
  logic unused_update, update_ready, update_moves;
  logic [UpdateBits-1:0] update_word;
  assign unused_update = ^{update_ready, update_moves, update_word};

  (* keep *) hs_stream #(
    .Width(UpdateBits)
  ) u_stream_update (
    .valid_i(update_valid),
    .ready_o(update_ready),
    .word_i (update),
    .valid_o(update_moves),
    .ready_i(1'b1),
    .word_o (update_word)
  );

  // --- I-buffer; outside the Z-buffer, too ---
  if (OutsideFrame == 0) begin : gen_inside
    logic unused_outside;
    assign unused_outside = ^{frame_width_i, frame_height_i, start_clear_i, memory_bases_i,
                              memory_i, written_depth, outside_depth};
    assign outside_depth = '0;
    assign tested_stamp_valid = queued_stamp_valid;
    assign queued_stamp_ready = tested_stamp_ready;
    assign tested_stamp = queued_stamp;
    assign start_valid_o = start_valid_i;
    assign start_ready_o = start_ready_i;
    assign scan_hold_o = 1'b0;
    assign stored_o = 1'b0;
    assign memory_o = '0;

    hs_index_buffer #(
      .Lanes(Lanes),
      .Depth(StampsX * StampsY)
    ) u_index_buffer (
      .clk_i                (clk_i),
      .rst_ni               (rst_ni),
      .ztest_read_en_i      (read_en),
      .ztest_read_bank_i    (read_bank),
      .ztest_read_address_i (read_address),
      .ztest_read_index_o   (read_index),
      .ztest_write_en_i     (write_en),
      .ztest_write_bank_i   (write_bank),
      .ztest_write_address_i(write_address),
      .ztest_write_index_i  (write_index),
      .scan_bank_i          (scan_bank_i),
      .scan_read_en_i       (scan_read_en_i),
      .scan_write_en_i      (scan_write_en_i),
      .scan_address_i       (scan_address_i),
      .scan_read_index_o    (scan_index_o)
    );
  end else begin : gen_outside
    logic unused_outside;
    // Places go along with the stamps, and scan-out is in order.
    assign unused_outside = ^{read_bank, read_address, write_bank, write_address, scan_write_en_i,
                              scan_address_i};

    if (TestsPlanes != 0) begin : gen_gamma_illegal
      $error("hs_ztest: OutsideFrame must be 0 in type gamma");
    end

    hs_frame_memory #(
      .LanesX    (LanesX),
      .LanesY    (LanesY),
      .MemoryBits(MemoryBits),
      .SlotsX    (CacheTilesX),
      .SlotsY    (CacheTilesY)
    ) u_frame_memory (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .stamp_valid_i (queued_stamp_valid),
      .stamp_ready_o (queued_stamp_ready),
      .stamp_i       (queued_stamp),
      .stamp_valid_o (tested_stamp_valid),
      .stamp_ready_i (tested_stamp_ready),
      .stamp_o       (tested_stamp),
      .read_en_i     (read_en),
      .read_index_o  (read_index),
      .read_depth_o  (outside_depth),
      .write_en_i    (write_en),
      .write_index_i (write_index),
      .write_depth_i (written_depth),
      .stored_o      (stored_o),
      .frame_width_i (frame_width_i),
      .frame_height_i(frame_height_i),
      .start_valid_i (start_valid_i),
      .start_ready_o (start_ready_o),
      .start_clear_i (start_clear_i),
      .start_valid_o (start_valid_o),
      .start_ready_i (start_ready_i),
      .scan_hold_o   (scan_hold_o),
      .scan_bank_i   (scan_bank_i),
      .scan_read_en_i(scan_read_en_i),
      .scan_index_o  (scan_index_o),
      .memory_bases_i(memory_bases_i),
      .memory_o      (memory_o),
      .memory_i      (memory_i)
    );
  end
endmodule
