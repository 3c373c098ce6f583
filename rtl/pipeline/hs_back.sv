// SPDX-License-Identifier: Apache-2.0
// The half of the pipeline that shows: the I-buffer of a finished frame out as pixels.
//
//   attributes, what geometry answers ─► hs_shading ◄─ scan ─ scan_index ◄─ I-buffer
//                                            └─► pixel
//
// Of a frame between key frames hs_motion, which gives `motion`, stands where hs_shading does. With
// objects hs_objects joins each pixel with its depth and object to `entry`. One of pixel, motion
// and entry is there; the others are never valid.
// Interval: the shader's. Stall: each stream waits for its taker.
module hs_back #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned SetupCycles = hs_formats_pkg::SetupInterval,
  parameter int unsigned BackgroundFifoDepth = 0,
  parameter int unsigned OutsidePlanes = 0,
  parameter int unsigned MemoryBits = 64,
  // Of hs_planes_memory.
  localparam int unsigned MemoryOutBits =
      OutsidePlanes != 0 ? 2 * (1 + hs_memory_pkg::RequestBits) + 1 + MemoryBits : 1,
  localparam int unsigned MemoryInBits = OutsidePlanes != 0 ? 5 + MemoryBits : 1,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1,
  localparam int unsigned DepthsBits = hs_formats_pkg::HasDepth != 0 ? Lanes * DepthBits : 1,
  localparam int unsigned HeadBits = 1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned ScanBits = HeadBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = HeadBits + Lanes * 3 * ColourBits,
  localparam int unsigned HasObjects = hs_formats_pkg::HasObjects,
  localparam int unsigned EntryBits =
      HasObjects != 0 ? PixelBits + Lanes * (DepthBits + hs_formats_pkg::ObjectBits) : 1
) (
  input  logic                                                  clk_i,
  input  logic                                                  rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t                                    frame_width_i,
  input  hs_formats_pkg::y_t                                    frame_height_i,
  input  logic [3*ColourBits-1:0]                               background_i,

  // Frame control: a frame to scan out; the bank of TdbS to store to; a frame's planes are stored,
  // those of texture, too; its last word is taken
  input  logic                                                  start_valid_i,
  output logic                                                  start_ready_o,
  input  logic                                                  start_clear_i,
  input  logic                                                  planes_bank_i,
  output logic                                                  planes_last_o,
  output logic                                                  stored_last_o,
  output logic                                                  shown_last_o,

  // A triangle moves into the pipeline
  input  logic                                                  triangle_i,
  input  hs_formats_pkg::numbered_t                             triangle_word_i,

  // From geometry
  input  logic                                                  light_valid_i,
  input  logic [hs_formats_pkg::LightWordBits-1:0]              light_i,
  input  logic                                                  material_valid_i,
  input  logic [hs_formats_pkg::MaterialWordBits-1:0]           material_i,
  input  logic                                                  texture_valid_i,
  input  logic [hs_formats_pkg::TextureWordBits-1:0]            texture_i,
  input  logic                                                  texel_valid_i,
  input  logic [hs_formats_pkg::TexelWordBits-1:0]              texel_i,
  input  logic                                                  normals_valid_i,
  output logic                                                  normals_ready_o,
  input  logic [hs_formats_pkg::NormalsWordBits-1:0]            normals_i,
  input  logic                                                  texture_coordinates_valid_i,
  output logic                                                  texture_coordinates_ready_o,
  input  logic [hs_formats_pkg::TextureCoordinatesWordBits-1:0] texture_coordinates_i,
  input  logic                                                  motion_vectors_valid_i,
  output logic                                                  motion_vectors_ready_o,
  input  logic [hs_formats_pkg::MotionVectorsWordBits-1:0]      motion_vectors_i,

  // From hs_front: `attributes`, deferred: `visible_attributes`
  input  logic                                                  attributes_valid_i,
  output logic                                                  attributes_ready_o,
  input  hs_formats_pkg::attributes_t                           attributes_i,

  // Scan-out of the buffers; hold: no word of scan is taken
  input  logic                                                  scan_hold_i,
  output logic                                                  scan_read_en_o,
  output logic                                                  scan_write_en_o,
  output logic [AddressBits-1:0]                                scan_address_o,
  input  logic [Lanes*IndexBits-1:0]                            scan_index_i,
  input  logic [DepthsBits-1:0]                                 scan_depth_i,

  // To the frame, to the motion buffer or to the static objects buffer
  output logic                                                  pixel_valid_o,
  input  logic                                                  pixel_ready_i,
  output logic [PixelBits-1:0]                                  pixel_o,
  output logic                                                  motion_valid_o,
  input  logic                                                  motion_ready_i,
  output logic [hs_formats_pkg::MotionWordBits-1:0]             motion_o,
  output logic                                                  entry_valid_o,
  input  logic                                                  entry_ready_i,
  output logic [EntryBits-1:0]                                  entry_o,

  // Memory outside, of hs_planes_memory
  input  logic [hs_memory_pkg::AddressBits-1:0]                 memory_base_i,
  output logic [MemoryOutBits-1:0]                              memory_o,
  input  logic [MemoryInBits-1:0]                               memory_i
);
  // --- I-buffer ─► scan ---
  logic read_scan_valid, read_scan_ready;
  logic sent_scan_valid, sent_scan_ready, scan_valid, scan_ready;
  logic [ScanBits-1:0] sent_scan, scan;

  assign sent_scan_valid = read_scan_valid && !scan_hold_i;
  assign read_scan_ready = sent_scan_ready && !scan_hold_i;

  hs_scan_index #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_scan_index (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .frame_width_i (frame_width_i),
    .frame_height_i(frame_height_i),
    .start_valid_i (start_valid_i),
    .start_ready_o (start_ready_o),
    .start_clear_i (start_clear_i),
    .scan_valid_o  (read_scan_valid),
    .scan_ready_i  (read_scan_ready),
    .scan_o        (sent_scan),
    .read_en_o     (scan_read_en_o),
    .write_en_o    (scan_write_en_o),
    .address_o     (scan_address_o),
    .read_index_i  (scan_index_i)
  );

  hs_stream #(
    .Width(ScanBits)
  ) u_stream_scan (
    .valid_i(sent_scan_valid),
    .ready_o(sent_scan_ready),
    .word_i (sent_scan),
    .valid_o(scan_valid),
    .ready_i(scan_ready),
    .word_o (scan)
  );

  if (hs_formats_pkg::HasMotion != 0) begin : gen_motion
    logic unused_shading;
    assign unused_shading = ^{background_i, triangle_i, triangle_word_i, light_valid_i, light_i,
                              material_valid_i, material_i, texture_valid_i, texture_i,
                              texel_valid_i, texel_i, normals_valid_i, normals_i,
                              texture_coordinates_valid_i, texture_coordinates_i, scan_depth_i,
                              pixel_ready_i, entry_ready_i, memory_base_i, memory_i};
    if (OutsidePlanes != 0) begin : gen_planes_illegal
      $error("hs_back: a frame between key frames has its planes inside");
    end
    assign memory_o = '0;
    assign normals_ready_o = 1'b0;
    assign texture_coordinates_ready_o = 1'b0;
    assign pixel_valid_o = 1'b0;
    assign pixel_o = '0;
    assign entry_valid_o = 1'b0;
    assign entry_o = '0;

    hs_motion #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_motion (
      .clk_i                 (clk_i),
      .rst_ni                (rst_ni),
      .planes_bank_i         (planes_bank_i),
      .planes_last_o         (planes_last_o),
      .motion_vectors_valid_i(motion_vectors_valid_i),
      .motion_vectors_ready_o(motion_vectors_ready_o),
      .motion_vectors_i      (motion_vectors_i),
      .attributes_valid_i    (attributes_valid_i),
      .attributes_ready_o    (attributes_ready_o),
      .attributes_i          (attributes_i),
      .scan_valid_i          (scan_valid),
      .scan_ready_o          (scan_ready),
      .scan_i                (scan),
      .motion_valid_o        (motion_valid_o),
      .motion_ready_i        (motion_ready_i),
      .motion_o              (motion_o)
    );
    assign stored_last_o = planes_last_o;
    assign shown_last_o = motion_valid_o && motion_ready_i
                          && motion_o[hs_formats_pkg::MotionWordBits-1];
  end else begin : gen_shading
    logic unused_motion, shade_scan_valid, shade_scan_ready, shaded_valid, shaded_ready;
    logic [PixelBits-1:0] shaded;
    assign unused_motion = ^{motion_vectors_valid_i, motion_vectors_i, motion_ready_i};
    assign motion_vectors_ready_o = 1'b0;
    assign motion_valid_o = 1'b0;
    assign motion_o = '0;

    hs_shading #(
      .LanesX             (LanesX),
      .LanesY             (LanesY),
      .SetupCycles        (SetupCycles),
      .BackgroundFifoDepth(BackgroundFifoDepth),
      .OutsidePlanes      (OutsidePlanes),
      .MemoryBits         (MemoryBits)
    ) u_shading (
      .clk_i                      (clk_i),
      .rst_ni                     (rst_ni),
      .background_i               (background_i),
      .planes_bank_i              (planes_bank_i),
      .planes_last_o              (planes_last_o),
      .stored_last_o              (stored_last_o),
      .light_valid_i              (light_valid_i),
      .light_i                    (light_i),
      .material_valid_i           (material_valid_i),
      .material_i                 (material_i),
      .normals_valid_i            (normals_valid_i),
      .normals_ready_o            (normals_ready_o),
      .normals_i                  (normals_i),
      .texture_valid_i            (texture_valid_i),
      .texture_i                  (texture_i),
      .texel_valid_i              (texel_valid_i),
      .texel_i                    (texel_i),
      .texture_coordinates_valid_i(texture_coordinates_valid_i),
      .texture_coordinates_ready_o(texture_coordinates_ready_o),
      .texture_coordinates_i      (texture_coordinates_i),
      .attributes_valid_i         (attributes_valid_i),
      .attributes_ready_o         (attributes_ready_o),
      .attributes_i               (attributes_i),
      .scan_valid_i               (shade_scan_valid),
      .scan_ready_o               (shade_scan_ready),
      .scan_i                     (scan),
      .pixel_valid_o              (shaded_valid),
      .pixel_ready_i              (shaded_ready),
      .pixel_o                    (shaded),
      .memory_base_i              (memory_base_i),
      .memory_o                   (memory_o),
      .memory_i                   (memory_i)
    );

    if (HasObjects != 0) begin : gen_objects
      logic object_scan_valid, object_scan_ready, unused_objects;
      assign unused_objects = ^{triangle_word_i, pixel_ready_i};
      assign pixel_valid_o = 1'b0;
      assign pixel_o = '0;

      hs_fork u_scan_fork (
        .clk_i         (clk_i),
        .rst_ni        (rst_ni),
        .in_valid_i    (scan_valid),
        .in_ready_o    (scan_ready),
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
        .triangle_i       (triangle_i),
        .triangle_last_i  (triangle_word_i.last),
        .triangle_index_i (triangle_word_i.index),
        .triangle_object_i(triangle_word_i.object),
        .scan_valid_i     (object_scan_valid),
        .scan_ready_o     (object_scan_ready),
        .scan_i           (scan),
        .depth_i          (scan_depth_i),
        .pixel_valid_i    (shaded_valid),
        .pixel_ready_o    (shaded_ready),
        .pixel_i          (shaded),
        .entry_valid_o    (entry_valid_o),
        .entry_ready_i    (entry_ready_i),
        .entry_o          (entry_o)
      );
      assign shown_last_o = entry_valid_o && entry_ready_i && entry_o[EntryBits-1];
    end else begin : gen_no_objects
      logic unused_objects;
      assign unused_objects = ^{triangle_i, triangle_word_i, scan_depth_i, entry_ready_i};
      assign shade_scan_valid = scan_valid;
      assign scan_ready = shade_scan_ready;
      assign pixel_valid_o = shaded_valid;
      assign shaded_ready = pixel_ready_i;
      assign pixel_o = shaded;
      assign entry_valid_o = 1'b0;
      assign entry_o = '0;
      assign shown_last_o = pixel_valid_o && pixel_ready_i && pixel_o[PixelBits-1];
    end
  end
endmodule
