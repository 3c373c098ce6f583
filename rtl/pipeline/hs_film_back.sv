// SPDX-License-Identifier: Apache-2.0
// hs_back of a film: the I-buffer of a finished pass out as pixels, or as motion.
//
//   scan_index ─scan─► hole_scan ─masked─┬─► hs_shading ─pixel─┐
//                          ▲             ├─────────────────────┴─► pixel_store ─► shown
//                    marks of holes      └─► hs_motion ─► motion
//
// A pass in between goes to hs_motion, one of a key frame or of holes to hs_shading; so do the
// attributes of visible triangles. One pass at a time is under way.
// Interval: the shader's, and no less than a cycle a pixel. Stall: each stream waits for its taker,
// and shown never waits.
module hs_film_back #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1,
  localparam int unsigned HeadBits = 1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned ScanBits = HeadBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = HeadBits + Lanes * 3 * ColourBits,
  localparam int unsigned MotionBits = hs_formats_pkg::MotionWordBits,
  localparam int unsigned ShownBits = hs_formats_pkg::ShownPixelWordBits
) (
  input  logic                                                  clk_i,
  input  logic                                                  rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t                                    frame_width_i,
  input  hs_formats_pkg::y_t                                    frame_height_i,
  input  logic [3*ColourBits-1:0]                               background_i,

  // The pass
  input  logic                                                  between_i,
  input  logic                                                  fill_i,

  // Frame control: a frame to scan out; the bank of TdbS to store shading to; its planes are
  // stored; all planes of a pass are; its last word is taken
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

  // From hs_front: `visible_attributes`
  input  logic                                                  attributes_valid_i,
  output logic                                                  attributes_ready_o,
  input  hs_formats_pkg::attributes_t                           attributes_i,

  // Scan-out of the I-buffer
  output logic                                                  scan_read_en_o,
  output logic                                                  scan_write_en_o,
  output logic [AddressBits-1:0]                                scan_address_o,
  input  logic [Lanes*IndexBits-1:0]                            scan_index_i,

  // Marks of holes: 0 is written to the address that is read
  output logic                                                  marks_read_en_o,
  output logic                                                  marks_write_en_o,
  output logic [AddressBits-1:0]                                marks_address_o,
  input  logic [Lanes-1:0]                                      marks_i,

  // To the memories of pixels, and to motion_order
  output logic                                                  shown_valid_o,
  output logic [ShownBits-1:0]                                  shown_o,
  output logic                                                  motion_valid_o,
  input  logic                                                  motion_ready_i,
  output logic [MotionBits-1:0]                                 motion_o
);
  // --- I-buffer ─► scan ─► masked ---
  logic sent_scan_valid, sent_scan_ready, scan_valid, scan_ready;
  logic sent_masked_valid, sent_masked_ready, masked_valid, masked_ready;
  logic [ScanBits-1:0] sent_scan, scan, sent_masked, masked;

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
    .scan_valid_o  (sent_scan_valid),
    .scan_ready_i  (sent_scan_ready),
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

  hs_hole_scan #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_hole_scan (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .fill_i        (fill_i),
    .scan_valid_i  (scan_valid),
    .scan_ready_o  (scan_ready),
    .scan_i        (scan),
    .read_en_o     (marks_read_en_o),
    .write_en_o    (marks_write_en_o),
    .address_o     (marks_address_o),
    .read_marks_i  (marks_i),
    .masked_valid_o(sent_masked_valid),
    .masked_ready_i(sent_masked_ready),
    .masked_o      (sent_masked)
  );

  hs_stream #(
    .Width(ScanBits)
  ) u_stream_masked (
    .valid_i(sent_masked_valid),
    .ready_o(sent_masked_ready),
    .word_i (sent_masked),
    .valid_o(masked_valid),
    .ready_i(masked_ready),
    .word_o (masked)
  );

  // --- Where the pass goes ---
  logic shade_attributes_ready, field_attributes_ready, shade_masked_ready, field_masked_ready;
  logic shade_scan_valid, shade_scan_ready, store_scan_valid, store_scan_ready;
  logic field_planes_last, shade_stored_last, field_bank_q;

  assign attributes_ready_o = between_i ? field_attributes_ready : shade_attributes_ready;
  assign masked_ready = between_i ? field_masked_ready : shade_masked_ready;
  assign stored_last_o = shade_stored_last || field_planes_last;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) field_bank_q <= 1'b0;
    else if (field_planes_last) field_bank_q <= !field_bank_q;
  end

  // --- A key frame, or holes ---
  logic pixel_valid, pixel_ready, store_pixel_valid, store_pixel_ready;
  logic sent_shown_valid, unused_shown_ready;
  logic [PixelBits-1:0] pixel, store_pixel;
  logic [ShownBits-1:0] sent_shown;

  hs_fork u_masked_fork (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .in_valid_i    (masked_valid && !between_i),
    .in_ready_o    (shade_masked_ready),
    .first_valid_o (shade_scan_valid),
    .first_ready_i (shade_scan_ready),
    .second_valid_o(store_scan_valid),
    .second_ready_i(store_scan_ready)
  );

  logic unused_memory;
  hs_shading #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_shading (
    .clk_i                      (clk_i),
    .rst_ni                     (rst_ni),
    .background_i               (background_i),
    .planes_bank_i              (planes_bank_i),
    .planes_last_o              (planes_last_o),
    .stored_last_o              (shade_stored_last),
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
    .attributes_valid_i         (attributes_valid_i && !between_i),
    .attributes_ready_o         (shade_attributes_ready),
    .attributes_i               (attributes_i),
    .scan_valid_i               (shade_scan_valid),
    .scan_ready_o               (shade_scan_ready),
    .scan_i                     (masked),
    .pixel_valid_o              (pixel_valid),
    .pixel_ready_i              (pixel_ready),
    .pixel_o                    (pixel),
    .memory_base_i              ('0),
    .memory_o                   (unused_memory),
    .memory_i                   (1'b0)
  );

  hs_stream #(
    .Width(PixelBits)
  ) u_stream_pixel (
    .valid_i(pixel_valid),
    .ready_o(pixel_ready),
    .word_i (pixel),
    .valid_o(store_pixel_valid),
    .ready_i(store_pixel_ready),
    .word_o (store_pixel)
  );

  hs_pixel_store #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_pixel_store (
    .clk_i           (clk_i),
    .rst_ni          (rst_ni),
    .frame_width_i   (frame_width_i),
    .frame_height_i  (frame_height_i),
    .triangle_valid_i(triangle_i),
    .triangle_i      (triangle_word_i),
    .scan_valid_i    (store_scan_valid),
    .scan_ready_o    (store_scan_ready),
    .scan_i          (masked),
    .pixel_valid_i   (store_pixel_valid),
    .pixel_ready_o   (store_pixel_ready),
    .pixel_i         (store_pixel),
    .shown_valid_o   (sent_shown_valid),
    .shown_o         (sent_shown)
  );

  hs_stream #(
    .Width(ShownBits)
  ) u_stream_shown (
    .valid_i(sent_shown_valid),
    .ready_o(unused_shown_ready),
    .word_i (sent_shown),
    .valid_o(shown_valid_o),
    .ready_i(1'b1),
    .word_o (shown_o)
  );

  // --- A frame in between ---
  logic sent_motion_valid, sent_motion_ready;
  logic [MotionBits-1:0] sent_motion;

  hs_motion #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_motion (
    .clk_i                 (clk_i),
    .rst_ni                (rst_ni),
    .planes_bank_i         (field_bank_q),
    .planes_last_o         (field_planes_last),
    .motion_vectors_valid_i(motion_vectors_valid_i),
    .motion_vectors_ready_o(motion_vectors_ready_o),
    .motion_vectors_i      (motion_vectors_i),
    .attributes_valid_i    (attributes_valid_i && between_i),
    .attributes_ready_o    (field_attributes_ready),
    .attributes_i          (attributes_i),
    .scan_valid_i          (masked_valid && between_i),
    .scan_ready_o          (field_masked_ready),
    .scan_i                (masked),
    .motion_valid_o        (sent_motion_valid),
    .motion_ready_i        (sent_motion_ready),
    .motion_o              (sent_motion)
  );

  hs_stream #(
    .Width(MotionBits)
  ) u_stream_motion (
    .valid_i(sent_motion_valid),
    .ready_o(sent_motion_ready),
    .word_i (sent_motion),
    .valid_o(motion_valid_o),
    .ready_i(motion_ready_i),
    .word_o (motion_o)
  );

  assign shown_last_o = (shown_valid_o && shown_o[ShownBits-1])
                        || (motion_valid_o && motion_ready_i && motion_o[MotionBits-1]);
endmodule
