// SPDX-License-Identifier: Apache-2.0
// A film with frames in between: triangles in, key frames and what lies between them out (kernels:
// hls/pipeline/up_convert.hpp).
//
//   triangle ─► hs_front ─► visible
//                  │
//   I-buffer, attributes ─► hs_film_back ─shown─► key frames, film buffer ─► film_scan ─► film
//                                └─motion─► hs_film_between ─between─► film buffer, marks of holes
//                                                 └─► asked
//
// A pass is a frame of triangles: of a key frame, of a frame in between, or of what fills its holes
// (hs_up_convert_control says in which order). Geometry answers `visible` of a frame in between
// with motion_vectors, and else as in hs_pipeline. The last word of `asked` ends a frame in
// between: if it is of a face, the triangles of all faces that were asked for are the next pass, in
// the order of the frame's own list. More of that list does no harm.
//
// One pass is under way at a time; a frame of the film goes out while the next pass is drawn, and
// compensation of that one waits until it is out. Cycles a frame in between: those of the pass in
// hs_pipeline, a cycle a word of motion and 2 + (8 / KeySide)² a tile that is fetched, and those
// that fill its holes; no less than a cycle a pixel of the frame.
// Stall: each stream waits for its taker.
// Frame registers change only before a film, which begins at reset; lights, materials and textures
// only while busy_o is 0.
// Between two units a stream passes an hs_stream, which names it.
module hs_up_convert #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  parameter int unsigned SetupFifoDepth = 512,
  parameter int unsigned StampFifoDepth = 4,
  parameter int unsigned TriangleDepthFifoDepth = 4,
  parameter int unsigned DeferFifoDepth = 512,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned AskedBits = hs_formats_pkg::AskedWordBits,
  localparam int unsigned FilmBits = hs_formats_pkg::FilmPixelWordBits
) (
  input  logic                                                  clk_i,
  input  logic                                                  rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t                                    frame_width_i,
  input  hs_formats_pkg::y_t                                    frame_height_i,
  input  logic [3*ColourBits-1:0]                               background_i,  // {r, g, b}
  output logic                                                  busy_o,
  output logic                                                  none_left_o,  // with index_pool

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

  // To geometry: faces whose triangles have to come again
  output logic                                                  asked_valid_o,
  input  logic                                                  asked_ready_i,
  output logic [AskedBits-1:0]                                  asked_o,

  // To the display
  output logic                                                  film_valid_o,
  input  logic                                                  film_ready_i,
  output logic [FilmBits-1:0]                                   film_o
);
  localparam int unsigned Lanes = LanesX * LanesY;
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits;
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits;
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits;
  localparam int unsigned KeyWeightBits = hs_formats_pkg::KeyWeightBits;
  localparam int unsigned KeySide = hs_formats_pkg::KeySide;
  localparam int unsigned TileXBits = hs_formats_pkg::TileXBits;
  localparam int unsigned TileYBits = hs_formats_pkg::TileYBits;
  localparam int unsigned MotionBits = hs_formats_pkg::MotionWordBits;
  localparam int unsigned ShownBits = hs_formats_pkg::ShownPixelWordBits;
  localparam int unsigned BetweenBits = 3 + hs_formats_pkg::XBits + hs_formats_pkg::YBits
                                        + 3 * ColourBits;
  localparam int unsigned MaxWidth = hs_formats_pkg::MaxWidth;
  localparam int unsigned MaxHeight = hs_formats_pkg::MaxHeight;
  localparam int unsigned StampsX = (MaxWidth + LanesX - 1) / LanesX;
  localparam int unsigned StampsY = (MaxHeight + LanesY - 1) / LanesY;
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1;
  localparam int unsigned Tiles = (MaxWidth + 7) / 8 * ((MaxHeight + 7) / 8);
  localparam int unsigned MotionAddressBits = (Tiles > 1 ? $clog2(Tiles) : 1) + 6;
  localparam int unsigned EntryBits = MotionBits - 1 - hs_formats_pkg::XBits
                                      - hs_formats_pkg::YBits;
  localparam int unsigned KeyAddressBits = $clog2(Tiles * (8 / KeySide) * (8 / KeySide));
  localparam int unsigned FilmAddressBits =
      MaxWidth * MaxHeight > 1 ? $clog2(MaxWidth * MaxHeight) : 1;
  localparam int unsigned RequestBits = TileXBits + TileYBits;
  localparam int unsigned BlockBits = KeySide * KeySide * (3 * ColourBits + FaceBits);
  localparam int unsigned DepthsBits = hs_formats_pkg::HasDepth != 0 ? Lanes * DepthBits : 1;

  // --- Passes, and frames of triangles ---
  logic frames_open, pass_open, front_triangle_ready, frame_busy, pass_busy, film_idle;
  logic start_valid, start_ready, start_clear, scan_bank, planes_bank;
  logic planes_last, stored_last, back_last;  // words that move and end their frame
  logic shown_valid, motion_valid, motion_ready, between_valid;
  logic [ShownBits-1:0] shown;
  logic [MotionBits-1:0] motion;
  logic [BetweenBits-1:0] between;
  logic begins, is_between, fills, slot, show_valid, show_ready;
  logic [KeyWeightBits-1:0] key_weight;
  logic [1:0] show;

  assign triangle_ready_o = frames_open && pass_open && front_triangle_ready;
  assign film_idle = !show_valid && show_ready;
  assign busy_o = frame_busy || pass_busy || !film_idle;

  hs_frame_control u_frame_control (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .open_o         (frames_open),
    .busy_o         (frame_busy),
    .triangle_i     (triangle_valid_i && triangle_ready_o),
    .triangle_last_i(triangle_i.last),
    .visible_last_i (visible_valid_o && visible_ready_i && visible_o.last),
    .planes_last_i  (planes_last),
    .stored_last_i  (stored_last),
    .pixel_last_i   (back_last),
    .start_valid_o  (start_valid),
    .start_ready_i  (start_ready),
    .start_clear_o  (start_clear),
    .scan_bank_o    (scan_bank),
    .planes_bank_o  (planes_bank)
  );

  hs_up_convert_control u_control (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .open_o         (pass_open),
    .busy_o         (pass_busy),
    .triangle_i     (triangle_valid_i && triangle_ready_o),
    .triangle_last_i(triangle_i.last),
    .shown_last_i   (shown_valid && shown[ShownBits-1]),
    .asked_i        (asked_valid_o && asked_ready_i),
    .asked_last_i   (asked_o[AskedBits-1]),
    .asked_any_i    (asked_o[FaceBits-1:0] != '0),
    .begins_o       (begins),
    .between_o      (is_between),
    .fill_o         (fills),
    .slot_o         (slot),
    .key_weight_o   (key_weight),
    .show_valid_o   (show_valid),
    .show_ready_i   (show_ready),
    .show_o         (show)
  );

  // --- Triangles into the I-buffer ---
  logic attributes_valid, attributes_ready, scan_read_en, scan_write_en, numbered_taken;
  hs_formats_pkg::numbered_t numbered;
  hs_formats_pkg::attributes_t attributes;
  logic [AddressBits-1:0] scan_address;
  logic [Lanes*IndexBits-1:0] scan_index;
  logic [DepthsBits-1:0] unused_scan_depth;
  logic [4:0] unused_outside;
  hs_memory_pkg::bases_t no_bases;  // all is inside
  assign no_bases = '0;

  hs_front #(
    .LanesX                (LanesX),
    .LanesY                (LanesY),
    .SetupFifoDepth        (SetupFifoDepth),
    .StampFifoDepth        (StampFifoDepth),
    .TriangleDepthFifoDepth(TriangleDepthFifoDepth),
    .DeferFifoDepth        (DeferFifoDepth)
  ) u_front (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .frame_width_i     (frame_width_i),
    .frame_height_i    (frame_height_i),
    .triangle_valid_i  (triangle_valid_i && frames_open && pass_open),
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
    .start_valid_i     (1'b0),
    .start_ready_o     (unused_outside[0]),
    .start_clear_i     (1'b0),
    .start_valid_o     (unused_outside[1]),
    .start_ready_i     (1'b0),
    .scan_hold_o       (unused_outside[2]),
    .stored_o          (unused_outside[3]),
    .scan_bank_i       (scan_bank),
    .scan_read_en_i    (scan_read_en),
    .scan_write_en_i   (scan_write_en),
    .scan_address_i    (scan_address),
    .scan_index_o      (scan_index),
    .scan_depth_o      (unused_scan_depth),
    .memory_bases_i    (no_bases),
    .memory_o          (unused_outside[4]),
    .memory_i          (1'b0)
  );

  // --- The I-buffer out, as pixels or as motion ---
  logic marks_read_en, marks_write_en;
  logic [AddressBits-1:0] marks_address;
  logic [Lanes-1:0] marks;

  hs_film_back #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_back (
    .clk_i                      (clk_i),
    .rst_ni                     (rst_ni),
    .frame_width_i              (frame_width_i),
    .frame_height_i             (frame_height_i),
    .background_i               (background_i),
    .between_i                  (is_between),
    .fill_i                     (fills),
    .start_valid_i              (start_valid),
    .start_ready_o              (start_ready),
    .start_clear_i              (start_clear),
    .planes_bank_i              (planes_bank),
    .planes_last_o              (planes_last),
    .stored_last_o              (stored_last),
    .shown_last_o               (back_last),
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
    .scan_read_en_o             (scan_read_en),
    .scan_write_en_o            (scan_write_en),
    .scan_address_o             (scan_address),
    .scan_index_i               (scan_index),
    .marks_read_en_o            (marks_read_en),
    .marks_write_en_o           (marks_write_en),
    .marks_address_o            (marks_address),
    .marks_i                    (marks),
    .shown_valid_o              (shown_valid),
    .shown_o                    (shown),
    .motion_valid_o             (motion_valid),
    .motion_ready_i             (motion_ready),
    .motion_o                   (motion)
  );

  // --- A frame in between ---
  logic motion_write_en, motion_read_en;
  logic [MotionAddressBits-1:0] motion_write_address, motion_read_address;
  logic [EntryBits-1:0] motion_write, motion_read;
  logic [1:0] request_valid, request_ready, block_valid, block_ready;
  logic [2*RequestBits-1:0] request;
  logic [2*BlockBits-1:0] block;

  hs_film_between #(
    .TileXBits(TileXBits),
    .TileYBits(TileYBits)
  ) u_between (
    .clk_i                (clk_i),
    .rst_ni               (rst_ni),
    .frame_width_i        (frame_width_i),
    .frame_height_i       (frame_height_i),
    .key_weight_i         (key_weight),
    .walk_i               (film_idle),
    .motion_valid_i       (motion_valid),
    .motion_ready_o       (motion_ready),
    .motion_i             (motion),
    .write_en_o           (motion_write_en),
    .write_address_o      (motion_write_address),
    .write_motion_o       (motion_write),
    .read_en_o            (motion_read_en),
    .read_address_o       (motion_read_address),
    .read_motion_i        (motion_read),
    .key_request_0_valid_o(request_valid[0]),
    .key_request_0_ready_i(request_ready[0]),
    .key_request_0_o      (request[0 +: RequestBits]),
    .key_block_0_valid_i  (block_valid[0]),
    .key_block_0_ready_o  (block_ready[0]),
    .key_block_0_i        (block[0 +: BlockBits]),
    .key_request_1_valid_o(request_valid[1]),
    .key_request_1_ready_i(request_ready[1]),
    .key_request_1_o      (request[RequestBits +: RequestBits]),
    .key_block_1_valid_i  (block_valid[1]),
    .key_block_1_ready_o  (block_ready[1]),
    .key_block_1_i        (block[BlockBits +: BlockBits]),
    .between_valid_o      (between_valid),
    .between_o            (between),
    .asked_valid_o        (asked_valid_o),
    .asked_ready_i        (asked_ready_i),
    .asked_o              (asked_o)
  );

  // --- Memories, and the film ---
  logic key_read_en, key_read_bank, film_read_en, film_write_en;
  logic [KeyAddressBits-1:0] key_read_address;
  logic [BlockBits-1:0] key_read;
  logic [FilmAddressBits-1:0] film_address;
  logic [3*ColourBits:0] film_read;

  hs_film_memory #(
    .LanesX   (LanesX),
    .LanesY   (LanesY),
    .TileXBits(TileXBits),
    .TileYBits(TileYBits)
  ) u_memory (
    .clk_i                 (clk_i),
    .rst_ni                (rst_ni),
    .frame_width_i         (frame_width_i),
    .frame_height_i        (frame_height_i),
    .begins_i              (begins),
    .fill_i                (fills),
    .slot_i                (slot),
    .shown_valid_i         (shown_valid),
    .shown_i               (shown),
    .between_valid_i       (between_valid),
    .between_i             (between),
    .motion_write_en_i     (motion_write_en),
    .motion_write_address_i(motion_write_address),
    .motion_write_i        (motion_write),
    .motion_read_en_i      (motion_read_en),
    .motion_read_address_i (motion_read_address),
    .motion_read_o         (motion_read),
    .marks_read_en_i       (marks_read_en),
    .marks_write_en_i      (marks_write_en),
    .marks_address_i       (marks_address),
    .marks_o               (marks),
    .request_valid_i       (request_valid),
    .request_ready_o       (request_ready),
    .request_i             (request),
    .block_valid_o         (block_valid),
    .block_ready_i         (block_ready),
    .block_o               (block),
    .key_read_en_i         (key_read_en),
    .key_read_bank_i       (key_read_bank),
    .key_read_address_i    (key_read_address),
    .key_read_o            (key_read),
    .film_read_en_i        (film_read_en),
    .film_write_en_i       (film_write_en),
    .film_address_i        (film_address),
    .film_read_o           (film_read)
  );

  hs_film_scan u_film_scan (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .frame_width_i     (frame_width_i),
    .frame_height_i    (frame_height_i),
    .background_i      (background_i),
    .show_valid_i      (show_valid),
    .show_ready_o      (show_ready),
    .show_i            (show),
    .key_read_en_o     (key_read_en),
    .key_read_bank_o   (key_read_bank),
    .key_read_address_o(key_read_address),
    .read_block_i      (key_read),
    .film_read_en_o    (film_read_en),
    .film_write_en_o   (film_write_en),
    .film_address_o    (film_address),
    .read_film_i       (film_read),
    .film_valid_o      (film_valid_o),
    .film_ready_i      (film_ready_i),
    .film_o            (film_o)
  );
endmodule
