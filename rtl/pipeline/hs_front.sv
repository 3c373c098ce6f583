// SPDX-License-Identifier: Apache-2.0
// The half of the pipeline that draws: triangles into the I-buffer.
//
//   triangle ─► triangle_setup ─setup─► raster_pineda ─stamp─► hs_ztest ─► visible
//                     └─► attributes
//
// Deferred shading, where there is lighting, texture or motion: the attributes wait in a queue, and
// visible_select lets those of visible triangles on, and `visible` with them.
//
//                     └─attributes─► queue ─► visible_select ◄─ hs_ztest
//                                                └─► visible, visible_attributes
//
// With GivesIndices geometry sends triangles without an index, index_pool gives each its own, and
// hears each `visible` that geometry hears.
//
//   triangle ─► index_pool ─numbered─► triangle_setup ─►
//                   ▲
//                visible
//
// Cycles a frame in steady state: the more of triangles × interval of triangle_setup and visited
// stamps. Stall: each stream waits for its taker.
module hs_front #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned SetupCycles = hs_formats_pkg::SetupInterval,
  parameter int unsigned SetupFifoDepth,
  parameter int unsigned StampFifoDepth,
  parameter int unsigned TriangleDepthFifoDepth,
  parameter int unsigned DeferFifoDepth,
  parameter int unsigned OutsideFrame = 0,
  parameter int unsigned MemoryBits = 64,
  parameter int unsigned CacheTilesX = 16,
  parameter int unsigned CacheTilesY = 16,
  // Of hs_frame_memory.
  localparam int unsigned MemoryOutBits =
      OutsideFrame != 0 ? 5 * (1 + hs_memory_pkg::RequestBits) + 2 * (1 + MemoryBits) : 1,
  localparam int unsigned MemoryInBits = OutsideFrame != 0 ? 3 * (2 + MemoryBits) + 6 : 1,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1,
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * DepthBits : 1
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t          frame_width_i,
  input  hs_formats_pkg::y_t          frame_height_i,

  // From geometry
  input  logic                        triangle_valid_i,
  output logic                        triangle_ready_o,
  input  hs_formats_pkg::triangle_t   triangle_i,

  // A triangle moves into the setup
  output logic                        numbered_taken_o,
  output hs_formats_pkg::numbered_t   numbered_o,

  // To geometry
  output logic                        none_left_o,  // of indices, for a triangle since the reset
  output logic                        visible_valid_o,
  input  logic                        visible_ready_i,
  output hs_formats_pkg::visible_t    visible_o,

  // To what shades: `attributes`, deferred: `visible_attributes`
  output logic                        attributes_valid_o,
  input  logic                        attributes_ready_i,
  output hs_formats_pkg::attributes_t attributes_o,

  // Scan-out of the buffers; start and what holds it pass hs_ztest
  input  logic                        start_valid_i,
  output logic                        start_ready_o,
  input  logic                        start_clear_i,
  output logic                        start_valid_o,
  input  logic                        start_ready_i,
  output logic                        scan_hold_o,
  output logic                        stored_o,
  input  logic                        scan_bank_i,
  input  logic                        scan_read_en_i,
  input  logic                        scan_write_en_i,
  input  logic [AddressBits-1:0]      scan_address_i,
  output logic [Lanes*IndexBits-1:0]  scan_index_o,
  output logic [DepthsBits-1:0]       scan_depth_o,

  // Memory outside, of hs_frame_memory
  input  hs_memory_pkg::bases_t       memory_bases_i,
  output logic [MemoryOutBits-1:0]    memory_o,
  input  logic [MemoryInBits-1:0]     memory_i
);
  localparam int unsigned PlaceBits =
      IndexBits + hs_formats_pkg::XBits + hs_formats_pkg::YBits;
  localparam int unsigned StampBits = 2 + PlaceBits + Lanes * (1 + DepthBits);
  localparam int unsigned TriangleDepthBits =
      HasDepth != 0 && hs_formats_pkg::StoresDepth == 0
      ? PlaceBits + 3 * hs_formats_pkg::DepthPlaneBits : 1;

  // --- index_pool ---
  logic numbered_valid, numbered_ready;
  logic shown_valid, shown_ready;  // `visible`, to geometry and index_pool
  hs_formats_pkg::numbered_t numbered;
  hs_formats_pkg::visible_t shown;

  assign numbered_taken_o = numbered_valid && numbered_ready;
  assign numbered_o = numbered;
  assign visible_o = shown;

  if (hs_formats_pkg::GivesIndices != 0) begin : gen_indices
    logic sent_valid, sent_ready, returned_valid, returned_ready;
    hs_formats_pkg::numbered_t sent;

    hs_index_pool #(
      .IndexWindow(hs_formats_pkg::IndexWindow)
    ) u_index_pool (
      .clk_i           (clk_i),
      .rst_ni          (rst_ni),
      .triangle_valid_i(triangle_valid_i),
      .triangle_ready_o(triangle_ready_o),
      .triangle_i      (triangle_i),
      .visible_valid_i (returned_valid),
      .visible_ready_o (returned_ready),
      .visible_i       (shown),
      .numbered_valid_o(sent_valid),
      .numbered_ready_i(sent_ready),
      .numbered_o      (sent),
      .none_left_o     (none_left_o)
    );

    hs_stream #(
      .Width($bits(numbered))
    ) u_stream_numbered (
      .valid_i(sent_valid),
      .ready_o(sent_ready),
      .word_i (sent),
      .valid_o(numbered_valid),
      .ready_i(numbered_ready),
      .word_o (numbered)
    );

    hs_fork u_visible_fork (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .in_valid_i    (shown_valid),
      .in_ready_o    (shown_ready),
      .first_valid_o (visible_valid_o),
      .first_ready_i (visible_ready_i),
      .second_valid_o(returned_valid),
      .second_ready_i(returned_ready)
    );
  end else begin : gen_given
    assign numbered_valid = triangle_valid_i;
    assign triangle_ready_o = numbered_ready;
    assign numbered = triangle_i;
    assign visible_valid_o = shown_valid;
    assign shown_ready = visible_ready_i;
    assign none_left_o = 1'b0;
  end

  // --- triangle_setup ---
  logic sent_setup_valid, sent_setup_ready, setup_valid, setup_ready;
  logic sent_attributes_valid, sent_attributes_ready, attributes_valid, attributes_ready;
  hs_formats_pkg::setup_t sent_setup, setup;
  hs_formats_pkg::attributes_t sent_attributes, attributes;

  hs_setup_turns #(
    .LanesX     (LanesX),
    .LanesY     (LanesY),
    .SetupCycles(SetupCycles)
  ) u_triangle_setup (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .frame_width_i     (frame_width_i),
    .frame_height_i    (frame_height_i),
    .triangle_valid_i  (numbered_valid),
    .triangle_ready_o  (numbered_ready),
    .triangle_i        (numbered),
    .setup_valid_o     (sent_setup_valid),
    .setup_ready_i     (sent_setup_ready),
    .setup_o           (sent_setup),
    .attributes_valid_o(sent_attributes_valid),
    .attributes_ready_i(sent_attributes_ready),
    .attributes_o      (sent_attributes)
  );

  hs_stream #(
    .Width($bits(setup))
  ) u_stream_setup (
    .valid_i(sent_setup_valid),
    .ready_o(sent_setup_ready),
    .word_i (sent_setup),
    .valid_o(setup_valid),
    .ready_i(setup_ready),
    .word_o (setup)
  );

  hs_stream #(
    .Width($bits(attributes))
  ) u_stream_attributes (
    .valid_i(sent_attributes_valid),
    .ready_o(sent_attributes_ready),
    .word_i (sent_attributes),
    .valid_o(attributes_valid),
    .ready_i(attributes_ready),
    .word_o (attributes)
  );

  // --- setup ─► raster_pineda ---
  logic raster_setup_valid, raster_setup_ready;
  hs_formats_pkg::setup_t raster_setup;
  logic triangle_depth_valid, triangle_depth_ready, stamp_valid, stamp_ready;
  logic [TriangleDepthBits-1:0] triangle_depth;
  logic [StampBits-1:0] stamp;

  // Deep: runs of large triangles keep the rasterizer busy, runs of small ones the setup, and the
  // queue lets each work through the other's run.
  hs_fifo_block #(
    .Width($bits(setup)),
    .Depth(SetupFifoDepth)
  ) u_setup_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (setup_valid),
    .in_ready_o (setup_ready),
    .in_i       (setup),
    .out_valid_o(raster_setup_valid),
    .out_ready_i(raster_setup_ready),
    .out_o      (raster_setup)
  );

  hs_raster_pineda #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_raster_pineda (
    .clk_i                 (clk_i),
    .rst_ni                (rst_ni),
    .frame_width_i         (frame_width_i),
    .frame_height_i        (frame_height_i),
    .setup_valid_i         (raster_setup_valid),
    .setup_ready_o         (raster_setup_ready),
    .setup_i               (raster_setup),
    .triangle_depth_valid_o(triangle_depth_valid),
    .triangle_depth_ready_i(triangle_depth_ready),
    .triangle_depth_o      (triangle_depth),
    .stamp_valid_o         (stamp_valid),
    .stamp_ready_i         (stamp_ready),
    .stamp_o               (stamp)
  );

  // --- stamp ─► Z-test ---
  logic tested_valid, tested_ready;
  hs_formats_pkg::visible_t tested;

  hs_ztest #(
    .LanesX                (LanesX),
    .LanesY                (LanesY),
    .StampFifoDepth        (StampFifoDepth),
    .TriangleDepthFifoDepth(TriangleDepthFifoDepth),
    .OutsideFrame          (OutsideFrame),
    .MemoryBits            (MemoryBits),
    .CacheTilesX           (CacheTilesX),
    .CacheTilesY           (CacheTilesY)
  ) u_ztest (
    .clk_i                 (clk_i),
    .rst_ni                (rst_ni),
    .triangle_depth_valid_i(triangle_depth_valid),
    .triangle_depth_ready_o(triangle_depth_ready),
    .triangle_depth_i      (triangle_depth),
    .stamp_valid_i         (stamp_valid),
    .stamp_ready_o         (stamp_ready),
    .stamp_i               (stamp),
    .visible_valid_o       (tested_valid),
    .visible_ready_i       (tested_ready),
    .visible_o             (tested),
    .frame_width_i         (frame_width_i),
    .frame_height_i        (frame_height_i),
    .start_valid_i         (start_valid_i),
    .start_ready_o         (start_ready_o),
    .start_clear_i         (start_clear_i),
    .start_valid_o         (start_valid_o),
    .start_ready_i         (start_ready_i),
    .scan_hold_o           (scan_hold_o),
    .stored_o              (stored_o),
    .scan_bank_i           (scan_bank_i),
    .scan_read_en_i        (scan_read_en_i),
    .scan_write_en_i       (scan_write_en_i),
    .scan_address_i        (scan_address_i),
    .scan_index_o          (scan_index_o),
    .scan_depth_o          (scan_depth_o),
    .memory_bases_i        (memory_bases_i),
    .memory_o              (memory_o),
    .memory_i              (memory_i)
  );

  // --- attributes, at once or when the triangle has turned out visible ---
  if (hs_formats_pkg::Deferred != 0) begin : gen_deferred
    logic waiting_valid, waiting_ready, selected_valid, selected_ready;
    hs_formats_pkg::attributes_t waiting, selected;

    // As many as there can be setups before the Z-test.
    hs_fifo_block #(
      .Width($bits(attributes)),
      .Depth(DeferFifoDepth)
    ) u_defer_fifo (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .in_valid_i (attributes_valid),
      .in_ready_o (attributes_ready),
      .in_i       (attributes),
      .out_valid_o(waiting_valid),
      .out_ready_i(waiting_ready),
      .out_o      (waiting)
    );

    hs_visible_select u_visible_select (
      .clk_i                     (clk_i),
      .rst_ni                    (rst_ni),
      .attributes_valid_i        (waiting_valid),
      .attributes_ready_o        (waiting_ready),
      .attributes_i              (waiting),
      .visible_valid_i           (tested_valid),
      .visible_ready_o           (tested_ready),
      .visible_i                 (tested),
      .visible_valid_o           (shown_valid),
      .visible_ready_i           (shown_ready),
      .visible_o                 (shown),
      .visible_attributes_valid_o(selected_valid),
      .visible_attributes_ready_i(selected_ready),
      .visible_attributes_o      (selected)
    );

    hs_stream #(
      .Width($bits(attributes_o))
    ) u_stream_visible_attributes (
      .valid_i(selected_valid),
      .ready_o(selected_ready),
      .word_i (selected),
      .valid_o(attributes_valid_o),
      .ready_i(attributes_ready_i),
      .word_o (attributes_o)
    );
  end else begin : gen_at_once
    assign shown_valid = tested_valid;
    assign tested_ready = shown_ready;
    assign shown = tested;
    assign attributes_valid_o = attributes_valid;
    assign attributes_ready = attributes_ready_i;
    assign attributes_o = attributes;
  end
endmodule
