// SPDX-License-Identifier: Apache-2.0
// The composition: triangles in, pixels out (kernels: hls/pipeline/pipeline.hpp).
//
//   triangle ─► hs_front: triangle_setup ─setup─► raster_pineda ─stamp─► ztest_index ─► visible
//                   │                                                        ▼
//               attributes                                         I-buffer, Z-buffer
//                   ▼                                                        ▼
//               hs_back: hs_shading ◄────────────────────────────── scan ─ scan_index
//                            ▼
//                          pixel
//
// Deferred shading, where there is lighting or texture: the attributes wait in a queue,
// visible_select stands before `visible` and hs_shading, and geometry answers each `visible` that
// says so with a word of `normals`, of `texture_coordinates`, or of each, in order. It may take its
// time; it must take `visible` meanwhile.
// Of a frame between key frames the answer is a word of `motion_vectors`, and hs_motion, which
// gives `motion` and no pixels, stands where hs_shading does.
// With objects hs_objects joins each pixel with its depth and object to `entry`, which stands where
// `pixel` does, and the Z-buffer has two banks.
// Type gamma: ztest_plane, with a stream of planes from raster_pineda, and TdbV stand where
// ztest_index and the Z-buffer do.
// With an index_window index_pool stands before triangle_setup, and geometry sends triangles
// without an index. A `visible` names the one that its triangle had; 0: none was left, and it is
// not drawn.
// A stream that the configuration has not is one bit, not looked at and never valid.
//
// A frame is drawn while the one before is scanned out; see hs_frame_control. Cycles a frame in
// steady state: the most of triangles × interval of triangle_setup, visited stamps, and groups of
// shade_gouraud, and a few hundred.
// Stall: each stream waits for its taker; a `visible`, `pixel`, `motion` or `entry` not taken stops
// all that is before.
// Frame registers, lights, materials and textures change only while busy_o is 0.
// Between two units a stream passes an hs_stream, which names it.
//
// OutsideFrame: the I-buffer and the Z-buffer are in memory outside; OutsidePlanes: TdbS is. They
// change no word of a stream. What memory sees is in hs_memory_pkg; its words have MemoryBits. Of
// the frame CacheTilesX × CacheTilesY tiles of 8×8 pixels are here, both powers of two.
// With both 0 its ports are one bit each, 0 and not looked at.
module hs_pipeline #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  parameter int unsigned SetupCycles = hs_formats_pkg::SetupInterval,  // a triangle
  parameter int unsigned BackgroundFifoDepth = 0,
  parameter int unsigned SetupFifoDepth = 512,
  parameter int unsigned StampFifoDepth = 4,
  parameter int unsigned TriangleDepthFifoDepth = 4,
  parameter int unsigned DeferFifoDepth = 512,
  parameter int unsigned OutsideFrame = 0,
  parameter int unsigned OutsidePlanes = 0,
  parameter int unsigned MemoryBits = 64,
  parameter int unsigned CacheTilesX = 16,
  parameter int unsigned CacheTilesY = 16,
  localparam int unsigned Outside = OutsideFrame + OutsidePlanes,
  localparam int unsigned Reads = Outside != 0 ? hs_memory_pkg::Reads : 1,
  localparam int unsigned Writes = Outside != 0 ? hs_memory_pkg::Writes : 1,
  localparam int unsigned RequestBits = Outside != 0 ? hs_memory_pkg::RequestBits : 1,
  localparam int unsigned WordBits = Outside != 0 ? MemoryBits : 1,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned PixelBits =
      1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits + Lanes * 3 * ColourBits,
  localparam int unsigned EntryBits = hs_formats_pkg::HasObjects != 0
      ? PixelBits + Lanes * (DepthBits + hs_formats_pkg::ObjectBits) : 1
) (
  input  logic                                                  clk_i,
  input  logic                                                  rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t                                    frame_width_i,
  input  hs_formats_pkg::y_t                                    frame_height_i,
  input  logic [3*ColourBits-1:0]                               background_i,  // {r, g, b}
  output logic                                                  busy_o,

  // From geometry
  input  logic                                                  light_valid_i,
  input  logic [hs_formats_pkg::LightWordBits-1:0]              light_i,
  input  logic                                                  material_valid_i,
  input  logic [hs_formats_pkg::MaterialWordBits-1:0]           material_i,
  input  logic                                                  texture_valid_i,
  input  logic [hs_formats_pkg::TextureWordBits-1:0]            texture_i,
  input  logic                                                  texel_valid_i,
  input  logic [hs_formats_pkg::TexelWordBits-1:0]              texel_i,
  input  logic                                                  triangle_valid_i,
  output logic                                                  triangle_ready_o,
  input  hs_formats_pkg::triangle_t                             triangle_i,

  // To geometry
  output logic                                                  none_left_o,  // with index_pool
  output logic                                                  visible_valid_o,
  input  logic                                                  visible_ready_i,
  output hs_formats_pkg::visible_t                              visible_o,

  // From geometry, in answer
  input  logic                                                  normals_valid_i,
  output logic                                                  normals_ready_o,
  input  logic [hs_formats_pkg::NormalsWordBits-1:0]            normals_i,
  input  logic                                                  texture_coordinates_valid_i,
  output logic                                                  texture_coordinates_ready_o,
  input  logic [hs_formats_pkg::TextureCoordinatesWordBits-1:0] texture_coordinates_i,
  input  logic                                                  motion_vectors_valid_i,
  output logic                                                  motion_vectors_ready_o,
  input  logic [hs_formats_pkg::MotionVectorsWordBits-1:0]      motion_vectors_i,

  // To the frame, to the motion buffer or to the static objects buffer: one of them is there
  output logic                                                  pixel_valid_o,
  input  logic                                                  pixel_ready_i,
  output logic [PixelBits-1:0]                                  pixel_o,
  output logic                                                  motion_valid_o,
  input  logic                                                  motion_ready_i,
  output logic [hs_formats_pkg::MotionWordBits-1:0]             motion_o,
  output logic                                                  entry_valid_o,
  input  logic                                                  entry_ready_i,
  output logic [EntryBits-1:0]                                  entry_o,

  // Memory outside, by clients (hs_memory_pkg)
  input  hs_memory_pkg::bases_t                                 memory_bases_i,
  output logic [Reads-1:0]                                      memory_read_valid_o,
  input  logic [Reads-1:0]                                      memory_read_ready_i,
  output logic [Reads*RequestBits-1:0]                          memory_read_o,
  input  logic [Reads-1:0]                                      memory_data_valid_i,
  input  logic [Reads*WordBits-1:0]                             memory_data_i,
  output logic [Writes-1:0]                                     memory_write_valid_o,
  input  logic [Writes-1:0]                                     memory_write_ready_i,
  output logic [Writes*RequestBits-1:0]                         memory_write_o,
  output logic [Writes-1:0]                                     memory_store_valid_o,
  input  logic [Writes-1:0]                                     memory_store_ready_i,
  output logic [Writes*WordBits-1:0]                            memory_store_o,
  input  logic [Writes-1:0]                                     memory_written_i
);
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX;
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY;
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1;
  localparam int unsigned DepthsBits = hs_formats_pkg::HasDepth != 0 ? Lanes * DepthBits : 1;

  // --- frames ---
  logic frames_open, start_valid, start_ready, start_clear, scan_bank, planes_bank;
  logic front_triangle_ready;
  logic planes_last, stored_last, shown_last;  // words that move and end their frame
  logic drawn_last, frame_stored;

  assign triangle_ready_o = frames_open && front_triangle_ready;

  hs_frame_control u_frame_control (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .open_o         (frames_open),
    .busy_o         (busy_o),
    .triangle_i     (triangle_valid_i && triangle_ready_o),
    .triangle_last_i(triangle_i.last),
    .visible_last_i (drawn_last),
    .planes_last_i  (planes_last),
    .stored_last_i  (stored_last),
    .pixel_last_i   (shown_last),
    .start_valid_o  (start_valid),
    .start_ready_i  (start_ready),
    .start_clear_o  (start_clear),
    .scan_bank_o    (scan_bank),
    .planes_bank_o  (planes_bank)
  );

  // --- memory outside ---
  localparam int unsigned FrameOutBits =
      OutsideFrame != 0 ? 5 * (1 + RequestBits) + 2 * (1 + WordBits) : 1;
  localparam int unsigned FrameInBits = OutsideFrame != 0 ? 3 * (2 + WordBits) + 6 : 1;
  localparam int unsigned PlanesOutBits =
      OutsidePlanes != 0 ? 2 * (1 + RequestBits) + 1 + WordBits : 1;
  localparam int unsigned PlanesInBits = OutsidePlanes != 0 ? 5 + WordBits : 1;
  localparam int unsigned ClientOutBits =
      (Reads + Writes) * (1 + RequestBits) + Writes * (1 + WordBits);
  localparam int unsigned ClientInBits = Reads * (2 + WordBits) + 3 * Writes;
  logic [FrameOutBits-1:0] frame_out;
  logic [FrameInBits-1:0] frame_in;
  logic [PlanesOutBits-1:0] planes_out;
  logic [PlanesInBits-1:0] planes_in;

  hs_memory_clients #(
    .OutsideFrame (OutsideFrame),
    .OutsidePlanes(OutsidePlanes),
    .MemoryBits   (MemoryBits),
    .FrameOutBits (FrameOutBits),
    .FrameInBits  (FrameInBits),
    .PlanesOutBits(PlanesOutBits),
    .PlanesInBits (PlanesInBits),
    .OutBits      (ClientOutBits),
    .InBits       (ClientInBits)
  ) u_memory_clients (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .visible_last_i(visible_valid_o && visible_ready_i && visible_o.last),
    .frame_stored_i(frame_stored),
    .drawn_last_o  (drawn_last),
    .frame_i       (frame_out),
    .frame_o       (frame_in),
    .planes_i      (planes_out),
    .planes_o      (planes_in),
    .memory_o      ({memory_store_o, memory_store_valid_o, memory_write_o, memory_write_valid_o,
                     memory_read_o, memory_read_valid_o}),
    .memory_i      ({memory_written_i, memory_store_ready_i, memory_write_ready_i, memory_data_i,
                     memory_data_valid_i, memory_read_ready_i})
  );

  // --- triangles into the I-buffer ---
  logic back_start_valid, back_start_ready, scan_hold;
  logic attributes_valid, attributes_ready, scan_read_en, scan_write_en, numbered_taken;
  hs_formats_pkg::numbered_t numbered;
  hs_formats_pkg::attributes_t attributes;
  logic [AddressBits-1:0] scan_address;
  logic [Lanes*hs_formats_pkg::IndexBits-1:0] scan_index;
  logic [DepthsBits-1:0] scan_depth;

  hs_front #(
    .LanesX                (LanesX),
    .LanesY                (LanesY),
    .SetupCycles           (SetupCycles),
    .SetupFifoDepth        (SetupFifoDepth),
    .StampFifoDepth        (StampFifoDepth),
    .TriangleDepthFifoDepth(TriangleDepthFifoDepth),
    .DeferFifoDepth        (DeferFifoDepth),
    .OutsideFrame          (OutsideFrame),
    .MemoryBits            (MemoryBits),
    .CacheTilesX           (CacheTilesX),
    .CacheTilesY           (CacheTilesY)
  ) u_front (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .frame_width_i     (frame_width_i),
    .frame_height_i    (frame_height_i),
    .triangle_valid_i  (triangle_valid_i && frames_open),
    .triangle_ready_o  (front_triangle_ready),
    .triangle_i        (triangle_i),
    .numbered_taken_o  (numbered_taken),
    .numbered_o        (numbered),
    .none_left_o       (none_left_o),
    .visible_valid_o   (visible_valid_o),
    .visible_ready_i   (visible_ready_i),
    .visible_o         (visible_o),
    .attributes_valid_o(attributes_valid),
    .attributes_ready_i(attributes_ready),
    .attributes_o      (attributes),
    .start_valid_i     (start_valid),
    .start_ready_o     (start_ready),
    .start_clear_i     (start_clear),
    .start_valid_o     (back_start_valid),
    .start_ready_i     (back_start_ready),
    .scan_hold_o       (scan_hold),
    .stored_o          (frame_stored),
    .scan_bank_i       (scan_bank),
    .scan_read_en_i    (scan_read_en),
    .scan_write_en_i   (scan_write_en),
    .scan_address_i    (scan_address),
    .scan_index_o      (scan_index),
    .scan_depth_o      (scan_depth),
    .memory_bases_i    (memory_bases_i),
    .memory_o          (frame_out),
    .memory_i          (frame_in)
  );

  // --- the I-buffer out as pixels ---
  hs_back #(
    .LanesX             (LanesX),
    .LanesY             (LanesY),
    .SetupCycles        (SetupCycles),
    .BackgroundFifoDepth(BackgroundFifoDepth),
    .OutsidePlanes      (OutsidePlanes),
    .MemoryBits         (MemoryBits)
  ) u_back (
    .clk_i                      (clk_i),
    .rst_ni                     (rst_ni),
    .frame_width_i              (frame_width_i),
    .frame_height_i             (frame_height_i),
    .background_i               (background_i),
    .start_valid_i              (back_start_valid),
    .start_ready_o              (back_start_ready),
    .start_clear_i              (start_clear),
    .planes_bank_i              (planes_bank),
    .planes_last_o              (planes_last),
    .stored_last_o              (stored_last),
    .shown_last_o               (shown_last),
    .triangle_i                 (numbered_taken),
    .triangle_word_i            (numbered),
    .light_valid_i              (light_valid_i),
    .light_i                    (light_i),
    .material_valid_i           (material_valid_i),
    .material_i                 (material_i),
    .texture_valid_i            (texture_valid_i),
    .texture_i                  (texture_i),
    .texel_valid_i              (texel_valid_i),
    .texel_i                    (texel_i),
    .normals_valid_i            (normals_valid_i),
    .normals_ready_o            (normals_ready_o),
    .normals_i                  (normals_i),
    .texture_coordinates_valid_i(texture_coordinates_valid_i),
    .texture_coordinates_ready_o(texture_coordinates_ready_o),
    .texture_coordinates_i      (texture_coordinates_i),
    .motion_vectors_valid_i     (motion_vectors_valid_i),
    .motion_vectors_ready_o     (motion_vectors_ready_o),
    .motion_vectors_i           (motion_vectors_i),
    .attributes_valid_i         (attributes_valid),
    .attributes_ready_o         (attributes_ready),
    .attributes_i               (attributes),
    .scan_hold_i                (scan_hold),
    .scan_read_en_o             (scan_read_en),
    .scan_write_en_o            (scan_write_en),
    .scan_address_o             (scan_address),
    .scan_index_i               (scan_index),
    .scan_depth_i               (scan_depth),
    .pixel_valid_o              (pixel_valid_o),
    .pixel_ready_i              (pixel_ready_i),
    .pixel_o                    (pixel_o),
    .motion_valid_o             (motion_valid_o),
    .motion_ready_i             (motion_ready_i),
    .motion_o                   (motion_o),
    .entry_valid_o              (entry_valid_o),
    .entry_ready_i              (entry_ready_i),
    .entry_o                    (entry_o),
    .memory_base_i              (memory_bases_i.planes),
    .memory_o                   (planes_out),
    .memory_i                   (planes_in)
  );
endmodule
