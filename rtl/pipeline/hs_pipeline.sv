// SPDX-License-Identifier: Apache-2.0
// The composition: triangles in, pixels out (kernels: hls/pipeline/pipeline.hpp).
//
//   triangle ─► triangle_setup ─setup─► raster_pineda ─stamp─► ztest_index ─► visible
//                     │                                            ▼
//                 attributes                              I-buffer, Z-buffer
//                     ▼                                            ▼
//                 hs_shading ◄────────────────────────── scan ─ scan_index
//                     ▼
//                   pixel
//
// Deferred shading, where there is lighting or texture: the attributes wait in a queue, visible_select stands
// before hs_shading and `visible`, and geometry answers each `visible` that says so with a word of
// `normals`, of `texture_coordinates`, or of each, in order. It may take its time; it must take `visible` meanwhile.
// Of a frame between key frames the answer is a word of `motion_vectors`, and hs_motion, which gives
// `motion` and no pixels, stands where hs_shading does.
// With objects hs_objects joins each pixel with its depth and object to `entry`, which stands where
// `pixel` does, and the Z-buffer has two banks.
// Type gamma: ztest_plane, with a stream triangle_depth from raster_pineda, and TdbV stand where
// ztest_index and the Z-buffer do. Else triangle_depth_o is one bit, 0, never valid.
//
// A frame is drawn while the one before is scanned out; see hs_frame_control. Cycles a frame in steady
// state: the most of triangles × interval of triangle_setup, visited stamps, and groups of
// shade_gouraud, and a few hundred.
// Stall: each stream waits for its taker; a `visible`, `pixel`, `motion` or `entry` not taken stops all that is before.
// Frame registers, lights, materials and textures change only while busy_o is 0. Inner streams are there to watch, where the unit
// offers them. `planes` never waits.
module hs_pipeline #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  parameter int unsigned SetupFifoDepth = 512,
  parameter int unsigned StampFifoDepth = 4,
  parameter int unsigned TriangleDepthFifoDepth = 4,
  parameter int unsigned DeferFifoDepth = 512,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned StoresDepth = hs_formats_pkg::StoresDepth,
  localparam int unsigned TestsPlanes = HasDepth != 0 && StoresDepth == 0 ? 1 : 0,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned StampBits = 2 + IndexBits + XBits + YBits + Lanes * (1 + DepthBits),
  localparam int unsigned UpdateBits =
      IndexBits + XBits + YBits + Lanes * (1 + (StoresDepth != 0 ? DepthBits : 0)),
  localparam int unsigned TriangleDepthBits =
      TestsPlanes != 0 ? IndexBits + XBits + YBits + 3 * hs_formats_pkg::DepthPlaneBits : 1,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = 1 + XBits + YBits + Lanes * 3 * ColourBits,
  localparam int unsigned LightWordBits = hs_formats_pkg::LightWordBits,
  localparam int unsigned MaterialWordBits = hs_formats_pkg::MaterialWordBits,
  localparam int unsigned NormalsBits = hs_formats_pkg::NormalsWordBits,
  localparam int unsigned ColoursBits = hs_formats_pkg::ColoursWordBits,
  localparam int unsigned TextureWordBits = hs_formats_pkg::TextureWordBits,
  localparam int unsigned TexelWordBits = hs_formats_pkg::TexelWordBits,
  localparam int unsigned CoordinatesBits = hs_formats_pkg::TextureCoordinatesWordBits,
  localparam int unsigned TexturePlanesBits = hs_formats_pkg::TexturePlanesWordBits,
  localparam int unsigned PlanesBits = hs_formats_pkg::PlanesWordBits,
  localparam int unsigned MotionVectorsBits = hs_formats_pkg::MotionVectorsWordBits,
  localparam int unsigned MotionPlanesBits = hs_formats_pkg::MotionPlanesWordBits,
  localparam int unsigned MotionBits = hs_formats_pkg::MotionWordBits,
  localparam int unsigned HasObjects = hs_formats_pkg::HasObjects,
  localparam int unsigned EntryBits =
      HasObjects != 0 ? PixelBits + Lanes * (DepthBits + hs_formats_pkg::ObjectBits) : 1
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t          frame_width_i,
  input  hs_formats_pkg::y_t          frame_height_i,
  input  logic [3*ColourBits-1:0]     background_i,  // {r, g, b}
  output logic                        busy_o,

  // From geometry
  input  logic                        light_valid_i,
  input  logic [LightWordBits-1:0]    light_i,
  input  logic                        material_valid_i,
  input  logic [MaterialWordBits-1:0] material_i,
  input  logic                        texture_valid_i,
  input  logic [TextureWordBits-1:0]  texture_i,
  input  logic                        texel_valid_i,
  input  logic [TexelWordBits-1:0]    texel_i,
  input  logic                        triangle_valid_i,
  output logic                        triangle_ready_o,
  input  hs_formats_pkg::triangle_t   triangle_i,

  // To geometry
  output logic                        visible_valid_o,
  input  logic                        visible_ready_i,
  output hs_formats_pkg::visible_t    visible_o,

  // From geometry, in answer
  input  logic                        normals_valid_i,
  output logic                        normals_ready_o,
  input  logic [NormalsBits-1:0]      normals_i,
  input  logic                        texture_coordinates_valid_i,
  output logic                        texture_coordinates_ready_o,
  input  logic [CoordinatesBits-1:0]  texture_coordinates_i,
  input  logic                        motion_vectors_valid_i,
  output logic                        motion_vectors_ready_o,
  input  logic [MotionVectorsBits-1:0] motion_vectors_i,

  // To the frame, to the motion buffer or to the static objects buffer: one of them is there
  output logic                        pixel_valid_o,
  input  logic                        pixel_ready_i,
  output logic [PixelBits-1:0]        pixel_o,
  output logic                        motion_valid_o,
  input  logic                        motion_ready_i,
  output logic [MotionBits-1:0]       motion_o,
  output logic                        entry_valid_o,
  input  logic                        entry_ready_i,
  output logic [EntryBits-1:0]        entry_o,

  // To watch
  output logic                        setup_valid_o,
  output logic                        setup_ready_o,
  output hs_formats_pkg::setup_t      setup_o,
  output logic                        attributes_valid_o,
  output logic                        attributes_ready_o,
  output hs_formats_pkg::attributes_t attributes_o,
  output logic                        visible_attributes_valid_o,
  output logic                        visible_attributes_ready_o,
  output hs_formats_pkg::attributes_t visible_attributes_o,
  output logic                        colours_valid_o,
  output logic                        colours_ready_o,
  output logic [ColoursBits-1:0]      colours_o,
  output logic                        planes_valid_o,
  output logic                        planes_ready_o,
  output logic [PlanesBits-1:0]       planes_o,
  output logic                        texture_planes_valid_o,
  output logic                        texture_planes_ready_o,
  output logic [TexturePlanesBits-1:0] texture_planes_o,
  output logic                        motion_planes_valid_o,
  output logic                        motion_planes_ready_o,
  output logic [MotionPlanesBits-1:0] motion_planes_o,
  output logic                        lit_valid_o,
  output logic                        lit_ready_o,
  output logic [PixelBits-1:0]        lit_o,
  output logic                        triangle_depth_valid_o,
  output logic                        triangle_depth_ready_o,
  output logic [TriangleDepthBits-1:0] triangle_depth_o,
  output logic                        stamp_valid_o,
  output logic                        stamp_ready_o,
  output logic [StampBits-1:0]        stamp_o,
  output logic                        update_valid_o,
  output logic [UpdateBits-1:0]       update_o,
  output logic                        scan_valid_o,
  output logic                        scan_ready_o,
  output logic [ScanBits-1:0]         scan_o
);
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX;
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY;
  localparam int unsigned AddressBits = $clog2(StampsX * StampsY);
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * DepthBits : 1;

  // --- frames ---
  logic frames_open, start_valid, start_ready, start_clear, scan_bank, planes_bank;
  logic setup_triangle_ready;
  logic planes_last, stored_last, pixel_last;  // words that move and end their frame

  assign triangle_ready_o = frames_open && setup_triangle_ready;

  hs_frame_control u_frame_control (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .open_o         (frames_open),
    .busy_o         (busy_o),
    .triangle_i     (triangle_valid_i && triangle_ready_o),
    .triangle_last_i(triangle_i.last),
    .visible_last_i (visible_valid_o && visible_ready_i && visible_o.last),
    .planes_last_i  (planes_last),
    .stored_last_i  (stored_last),
    .pixel_last_i   (pixel_last),
    .start_valid_o  (start_valid),
    .start_ready_i  (start_ready),
    .start_clear_o  (start_clear),
    .scan_bank_o    (scan_bank),
    .planes_bank_o  (planes_bank)
  );

  // --- triangle_setup ---
  hs_triangle_setup #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_triangle_setup (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .frame_width_i     (frame_width_i),
    .frame_height_i    (frame_height_i),
    .triangle_valid_i  (triangle_valid_i && frames_open),
    .triangle_ready_o  (setup_triangle_ready),
    .triangle_i        (triangle_i),
    .setup_valid_o     (setup_valid_o),
    .setup_ready_i     (setup_ready_o),
    .setup_o           (setup_o),
    .attributes_valid_o(attributes_valid_o),
    .attributes_ready_i(attributes_ready_o),
    .attributes_o      (attributes_o)
  );

  // --- setup ─► raster_pineda ---
  logic raster_setup_valid, raster_setup_ready;
  hs_formats_pkg::setup_t raster_setup;

  // Deep: runs of large triangles keep the rasterizer busy, runs of small ones the setup, and the
  // queue lets each work through the other's run.
  hs_fifo_block #(
    .Width($bits(setup_o)),
    .Depth(SetupFifoDepth)
  ) u_setup_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (setup_valid_o),
    .in_ready_o (setup_ready_o),
    .in_i       (setup_o),
    .out_valid_o(raster_setup_valid),
    .out_ready_i(raster_setup_ready),
    .out_o      (raster_setup)
  );

  hs_raster_pineda #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_raster_pineda (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .frame_width_i (frame_width_i),
    .frame_height_i(frame_height_i),
    .setup_valid_i (raster_setup_valid),
    .setup_ready_o (raster_setup_ready),
    .setup_i       (raster_setup),
    .triangle_depth_valid_o(triangle_depth_valid_o),
    .triangle_depth_ready_i(triangle_depth_ready_o),
    .triangle_depth_o      (triangle_depth_o),
    .stamp_valid_o (stamp_valid_o),
    .stamp_ready_i (stamp_ready_o),
    .stamp_o       (stamp_o)
  );

  // --- stamp ─► Z-test: ztest_index and Z-buffer, or ztest_plane and TdbV ---
  logic ztest_stamp_valid, ztest_stamp_ready, tested_valid, tested_ready;
  hs_formats_pkg::visible_t tested;
  logic [StampBits-1:0] ztest_stamp;
  logic ztest_read_en, ztest_read_bank, ztest_write_bank;
  logic [AddressBits-1:0] ztest_read_address, ztest_write_address;
  logic [Lanes*IndexBits-1:0] ztest_read_index;
  logic [Lanes-1:0] ztest_write_en;
  hs_formats_pkg::index_t ztest_write_index;
  logic scan_read_en, scan_write_en;
  logic [AddressBits-1:0] scan_address;
  logic [DepthsBits-1:0] scan_depth;

  hs_fifo #(
    .Width(StampBits),
    .Depth(StampFifoDepth)
  ) u_stamp_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (stamp_valid_o),
    .in_ready_o (stamp_ready_o),
    .in_i       (stamp_o),
    .out_valid_o(ztest_stamp_valid),
    .out_ready_i(ztest_stamp_ready),
    .out_o      (ztest_stamp)
  );

  if (TestsPlanes != 0) begin : gen_planes
    localparam int unsigned PlaneAddressBits = $clog2(hs_formats_pkg::Triangles);
    localparam int unsigned EntryPlaneBits = 3 * hs_formats_pkg::DepthPlaneBits;
    logic ztest_depth_valid, ztest_depth_ready, fetch_en, store_en;
    logic [TriangleDepthBits-1:0] ztest_depth;
    logic [PlaneAddressBits-1:0] fetch_entry, store_entry;
    logic [EntryPlaneBits-1:0] fetch_plane, store_plane;

    hs_fifo #(
      .Width(TriangleDepthBits),
      .Depth(TriangleDepthFifoDepth)
    ) u_triangle_depth_fifo (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .in_valid_i (triangle_depth_valid_o),
      .in_ready_o (triangle_depth_ready_o),
      .in_i       (triangle_depth_o),
      .out_valid_o(ztest_depth_valid),
      .out_ready_i(ztest_depth_ready),
      .out_o      (ztest_depth)
    );

    hs_ztest_plane #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_ztest_plane (
      .clk_i                 (clk_i),
      .rst_ni                (rst_ni),
      .triangle_depth_valid_i(ztest_depth_valid),
      .triangle_depth_ready_o(ztest_depth_ready),
      .triangle_depth_i      (ztest_depth),
      .stamp_valid_i         (ztest_stamp_valid),
      .stamp_ready_o         (ztest_stamp_ready),
      .stamp_i               (ztest_stamp),
      .visible_valid_o       (tested_valid),
      .visible_ready_i       (tested_ready),
      .visible_o             (tested),
      .update_valid_o        (update_valid_o),
      .update_o              (update_o),
      .read_en_o             (ztest_read_en),
      .read_bank_o           (ztest_read_bank),
      .read_address_o        (ztest_read_address),
      .read_index_i          (ztest_read_index),
      .write_en_o            (ztest_write_en),
      .write_bank_o          (ztest_write_bank),
      .write_address_o       (ztest_write_address),
      .write_index_o         (ztest_write_index),
      .fetch_en_o            (fetch_en),
      .fetch_entry_o         (fetch_entry),
      .fetch_plane_i         (fetch_plane),
      .store_en_o            (store_en),
      .store_entry_o         (store_entry),
      .store_plane_o         (store_plane)
    );

    hs_ram_1r1w #(
      .Width(EntryPlaneBits),
      .Depth(1 << PlaneAddressBits)
    ) u_visibility_database (
      .clk_i          (clk_i),
      .read_en_i      (fetch_en),
      .read_address_i (fetch_entry),
      .read_data_o    (fetch_plane),
      .write_en_i     (store_en),
      .write_address_i(store_entry),
      .write_data_i   (store_plane)
    );
    assign scan_depth = '0;
  end else begin : gen_depths
    logic [DepthsBits-1:0] ztest_read_depth, ztest_write_depth;
    logic unused_triangle_depth;

    assign unused_triangle_depth = ^{triangle_depth_valid_o, triangle_depth_o};
    assign triangle_depth_ready_o = 1'b1;

    hs_ztest_index #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_ztest_index (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .stamp_valid_i  (ztest_stamp_valid),
      .stamp_ready_o  (ztest_stamp_ready),
      .stamp_i        (ztest_stamp),
      .visible_valid_o(tested_valid),
      .visible_ready_i(tested_ready),
      .visible_o      (tested),
      .update_valid_o (update_valid_o),
      .update_o       (update_o),
      .read_en_o      (ztest_read_en),
      .read_bank_o    (ztest_read_bank),
      .read_address_o (ztest_read_address),
      .read_index_i   (ztest_read_index),
      .read_depth_i   (ztest_read_depth),
      .write_en_o     (ztest_write_en),
      .write_bank_o   (ztest_write_bank),
      .write_address_o(ztest_write_address),
      .write_index_o  (ztest_write_index),
      .write_depth_o  (ztest_write_depth)
    );

    hs_depth_buffer #(
      .Lanes(Lanes),
      .Depth(StampsX * StampsY)
    ) u_depth_buffer (
      .clk_i                (clk_i),
      .rst_ni               (rst_ni),
      .ztest_read_en_i      (ztest_read_en),
      .ztest_read_bank_i    (ztest_read_bank),
      .ztest_read_address_i (ztest_read_address),
      .ztest_read_depth_o   (ztest_read_depth),
      .ztest_write_en_i     (ztest_write_en),
      .ztest_write_bank_i   (ztest_write_bank),
      .ztest_write_address_i(ztest_write_address),
      .ztest_write_depth_i  (ztest_write_depth),
      .scan_bank_i          (scan_bank),
      .scan_read_en_i       (scan_read_en),
      .scan_address_i       (scan_address),
      .scan_read_depth_o    (scan_depth)
    );
  end

  // --- I-buffer ---
  logic [Lanes*IndexBits-1:0] scan_read_index;

  hs_index_buffer #(
    .Lanes(Lanes),
    .Depth(StampsX * StampsY)
  ) u_index_buffer (
    .clk_i                (clk_i),
    .rst_ni               (rst_ni),
    .ztest_read_en_i      (ztest_read_en),
    .ztest_read_bank_i    (ztest_read_bank),
    .ztest_read_address_i (ztest_read_address),
    .ztest_read_index_o   (ztest_read_index),
    .ztest_write_en_i     (ztest_write_en),
    .ztest_write_bank_i   (ztest_write_bank),
    .ztest_write_address_i(ztest_write_address),
    .ztest_write_index_i  (ztest_write_index),
    .scan_bank_i          (scan_bank),
    .scan_read_en_i       (scan_read_en),
    .scan_write_en_i      (scan_write_en),
    .scan_address_i       (scan_address),
    .scan_read_index_o    (scan_read_index)
  );

  hs_scan_index #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_scan_index (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .frame_width_i (frame_width_i),
    .frame_height_i(frame_height_i),
    .start_valid_i (start_valid),
    .start_ready_o (start_ready),
    .start_clear_i (start_clear),
    .scan_valid_o  (scan_valid_o),
    .scan_ready_i  (scan_ready_o),
    .scan_o        (scan_o),
    .read_en_o     (scan_read_en),
    .write_en_o    (scan_write_en),
    .address_o     (scan_address),
    .read_index_i  (scan_read_index)
  );

  // --- attributes ─► hs_shading, at once or when the triangle has turned out visible ---
  logic shade_valid, shade_ready;
  hs_formats_pkg::attributes_t shade_attributes;

  if (hs_formats_pkg::Deferred != 0) begin : gen_deferred
    logic waiting_valid, waiting_ready;
    hs_formats_pkg::attributes_t waiting;

    // As many as there can be setups before the Z-test.
    hs_fifo_block #(
      .Width($bits(attributes_o)),
      .Depth(DeferFifoDepth)
    ) u_defer_fifo (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .in_valid_i (attributes_valid_o),
      .in_ready_o (attributes_ready_o),
      .in_i       (attributes_o),
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
      .visible_valid_o           (visible_valid_o),
      .visible_ready_i           (visible_ready_i),
      .visible_o                 (visible_o),
      .visible_attributes_valid_o(visible_attributes_valid_o),
      .visible_attributes_ready_i(visible_attributes_ready_o),
      .visible_attributes_o      (visible_attributes_o)
    );

    assign shade_valid = visible_attributes_valid_o;
    assign shade_attributes = visible_attributes_o;
    assign visible_attributes_ready_o = shade_ready;
  end else begin : gen_at_once
    assign visible_valid_o = tested_valid;
    assign tested_ready = visible_ready_i;
    assign visible_o = tested;
    assign visible_attributes_valid_o = 1'b0;
    assign visible_attributes_ready_o = 1'b0;
    assign visible_attributes_o = '0;
    assign shade_valid = attributes_valid_o;
    assign shade_attributes = attributes_o;
    assign attributes_ready_o = shade_ready;
  end

  if (hs_formats_pkg::HasMotion != 0) begin : gen_motion
    logic unused_shading;
    assign unused_shading = ^{background_i, light_valid_i, light_i, material_valid_i, material_i, texture_valid_i, texture_i,
                              texel_valid_i, texel_i, normals_valid_i, normals_i, texture_coordinates_valid_i,
                              texture_coordinates_i, pixel_ready_i, entry_ready_i, scan_depth};
    assign normals_ready_o = 1'b0;
    assign texture_coordinates_ready_o = 1'b0;
    assign pixel_valid_o = 1'b0;
    assign pixel_o = '0;
    assign entry_valid_o = 1'b0;
    assign entry_o = '0;
    assign colours_valid_o = 1'b0;
    assign colours_ready_o = 1'b0;
    assign colours_o = '0;
    assign planes_valid_o = 1'b0;
    assign planes_ready_o = 1'b0;
    assign planes_o = '0;
    assign texture_planes_valid_o = 1'b0;
    assign texture_planes_ready_o = 1'b0;
    assign texture_planes_o = '0;
    assign lit_valid_o = 1'b0;
    assign lit_ready_o = 1'b0;
    assign lit_o = '0;

    hs_motion #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_motion (
      .clk_i                 (clk_i),
      .rst_ni                (rst_ni),
      .planes_bank_i         (planes_bank),
      .motion_vectors_valid_i(motion_vectors_valid_i),
      .motion_vectors_ready_o(motion_vectors_ready_o),
      .motion_vectors_i      (motion_vectors_i),
      .attributes_valid_i    (shade_valid),
      .attributes_ready_o    (shade_ready),
      .attributes_i          (shade_attributes),
      .scan_valid_i          (scan_valid_o),
      .scan_ready_o          (scan_ready_o),
      .scan_i                (scan_o),
      .motion_valid_o        (motion_valid_o),
      .motion_ready_i        (motion_ready_i),
      .motion_o              (motion_o),
      .motion_planes_valid_o (motion_planes_valid_o),
      .motion_planes_ready_o (motion_planes_ready_o),
      .motion_planes_o       (motion_planes_o)
    );
    assign planes_last = motion_planes_valid_o && motion_planes_ready_o
                         && motion_planes_o[MotionPlanesBits-1];
    assign stored_last = planes_last;
    assign pixel_last = motion_valid_o && motion_ready_i && motion_o[MotionBits-1];
  end else begin : gen_shading
    logic unused_motion, shade_scan_valid, shade_scan_ready, shaded_valid, shaded_ready;
    logic [PixelBits-1:0] shaded;
    assign unused_motion = ^{motion_vectors_valid_i, motion_vectors_i, motion_ready_i};
    assign motion_vectors_ready_o = 1'b0;
    assign motion_planes_valid_o = 1'b0;
    assign motion_planes_ready_o = 1'b0;
    assign motion_planes_o = '0;
    assign motion_valid_o = 1'b0;
    assign motion_o = '0;
    assign planes_last = planes_valid_o && planes_ready_o && planes_o[PlanesBits-1];

    hs_shading #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_shading (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .background_i      (background_i),
      .planes_bank_i     (planes_bank),
      .light_valid_i     (light_valid_i),
      .light_i           (light_i),
      .material_valid_i  (material_valid_i),
      .material_i        (material_i),
      .normals_valid_i   (normals_valid_i),
      .normals_ready_o   (normals_ready_o),
      .normals_i         (normals_i),
      .texture_valid_i   (texture_valid_i),
      .texture_i         (texture_i),
      .texel_valid_i     (texel_valid_i),
      .texel_i           (texel_i),
      .texture_coordinates_valid_i(texture_coordinates_valid_i),
      .texture_coordinates_ready_o(texture_coordinates_ready_o),
      .texture_coordinates_i      (texture_coordinates_i),
      .attributes_valid_i(shade_valid),
      .attributes_ready_o(shade_ready),
      .attributes_i      (shade_attributes),
      .scan_valid_i      (shade_scan_valid),
      .scan_ready_o      (shade_scan_ready),
      .scan_i            (scan_o),
      .pixel_valid_o     (shaded_valid),
      .pixel_ready_i     (shaded_ready),
      .pixel_o           (shaded),
      .colours_valid_o   (colours_valid_o),
      .colours_ready_o   (colours_ready_o),
      .colours_o         (colours_o),
      .planes_valid_o    (planes_valid_o),
      .planes_ready_o    (planes_ready_o),
      .planes_o          (planes_o),
      .texture_planes_valid_o     (texture_planes_valid_o),
      .texture_planes_ready_o     (texture_planes_ready_o),
      .texture_planes_o           (texture_planes_o),
      .lit_valid_o       (lit_valid_o),
      .lit_ready_o       (lit_ready_o),
      .lit_o             (lit_o),
      .stored_last_o     (stored_last)
    );

    if (HasObjects != 0) begin : gen_objects
      logic object_scan_valid, object_scan_ready, unused_pixel_ready;
      assign unused_pixel_ready = pixel_ready_i;
      assign pixel_valid_o = 1'b0;
      assign pixel_o = '0;

      hs_fork u_scan_fork (
        .clk_i         (clk_i),
        .rst_ni        (rst_ni),
        .in_valid_i    (scan_valid_o),
        .in_ready_o    (scan_ready_o),
        .first_valid_o (shade_scan_valid),
        .first_ready_i (shade_scan_ready),
        .second_valid_o(object_scan_valid),
        .second_ready_i(object_scan_ready)
      );

      hs_objects #(
        .LanesX(LanesX),
        .LanesY(LanesY)
      ) u_objects (
        .clk_i            (clk_i),
        .rst_ni           (rst_ni),
        .triangle_i       (triangle_valid_i && triangle_ready_o),
        .triangle_last_i  (triangle_i.last),
        .triangle_index_i (triangle_i.index),
        .triangle_object_i(triangle_i.object),
        .scan_valid_i     (object_scan_valid),
        .scan_ready_o     (object_scan_ready),
        .scan_i           (scan_o),
        .depth_i          (scan_depth),
        .pixel_valid_i    (shaded_valid),
        .pixel_ready_o    (shaded_ready),
        .pixel_i          (shaded),
        .entry_valid_o    (entry_valid_o),
        .entry_ready_i    (entry_ready_i),
        .entry_o          (entry_o)
      );
      assign pixel_last = entry_valid_o && entry_ready_i && entry_o[EntryBits-1];
    end else begin : gen_no_objects
      logic unused_objects;
      assign unused_objects = ^{entry_ready_i, scan_depth};
      assign shade_scan_valid = scan_valid_o;
      assign scan_ready_o = shade_scan_ready;
      assign pixel_valid_o = shaded_valid;
      assign shaded_ready = pixel_ready_i;
      assign pixel_o = shaded;
      assign entry_valid_o = 1'b0;
      assign entry_o = '0;
      assign pixel_last = pixel_valid_o && pixel_ready_i && pixel_o[PixelBits-1];
    end
  end
endmodule
