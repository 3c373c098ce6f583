// SPDX-License-Identifier: Apache-2.0
// Frames of which what stands still is drawn once (kernels: hls/pipeline/static_frames.hpp):
// hs_pipeline draws passes, and commands merge them with buffers in memory, into buffers or into
// the frame.
//
//   triangle ─► hs_pipeline ─entry─► static_run ─merge, stored, drawn─► ztest_merge ─► found
//                  command ────────►    │  ▲ ▲                               │
//                              shown ◄──┘  │ └────────── merged ─────────────┘
//                                          ▼
//                        D-buffer and S-buffers, in memory outside
//
// A command is a run of ztest_merge over a box of stamps. What is stored is a buffer or background;
// what is drawn a buffer, or a pass, which is the next frame of hs_pipeline and goes through as it
// is scanned out. It is kept in a buffer, or shown, or only looked at: a query. Commands are done
// in order, each ends with a word of `found`. Passes are drawn in order while earlier commands run:
// at most two are in hs_pipeline, and a third one waits until a command has taken the first.
// Which objects go into which buffer, and when, the driver says: docs/static.md. It numbers the
// buffers, at most 2^BufferBits.
// Interval: of a run with a pass that of hs_pipeline; of others a stamp a cycle, and 4 a run, a
// query 2, where memory answers in the next cycle.
// Memory, stalls: hs_static_run. Registers, lights, materials, textures: hs_pipeline; a pass of
// which no command has taken the last stamp is in flight.
// Without objects there is no such unit: hs_formats_pkg has not its numbers then.
module hs_static_frames #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned BufferBits = 4,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned ObjectBits = hs_formats_pkg::ObjectBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned MergeBits = hs_formats_pkg::MergeWordBits,
  localparam int unsigned CommandBits = 3 + 3 * BufferBits + 2 * XBits + 2 * YBits + MergeBits,
  localparam int unsigned PlaceBits = BufferBits + XBits + YBits,
  localparam int unsigned PixelsBits = Lanes * (DepthBits + ObjectBits + 3 * ColourBits),
  localparam int unsigned EntryBits = 1 + XBits + YBits + PixelsBits
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
  output logic                                                  none_left_o,  // see hs_pipeline
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

  // From the driver, and to it
  input  logic                                                  command_valid_i,
  output logic                                                  command_ready_o,
  input  logic [CommandBits-1:0]                                command_i,
  output logic                                                  found_valid_o,
  input  logic                                                  found_ready_i,
  output logic [hs_formats_pkg::FoundWordBits-1:0]              found_o,

  // To the memory of the buffers, and from it
  output logic                                                  stored_place_valid_o,
  input  logic                                                  stored_place_ready_i,
  output logic [PlaceBits-1:0]                                  stored_place_o,
  input  logic                                                  stored_pixels_valid_i,
  output logic                                                  stored_pixels_ready_o,
  input  logic [PixelsBits-1:0]                                 stored_pixels_i,
  output logic                                                  drawn_place_valid_o,
  input  logic                                                  drawn_place_ready_i,
  output logic [PlaceBits-1:0]                                  drawn_place_o,
  input  logic                                                  drawn_pixels_valid_i,
  output logic                                                  drawn_pixels_ready_o,
  input  logic [PixelsBits-1:0]                                 drawn_pixels_i,
  output logic                                                  kept_valid_o,
  input  logic                                                  kept_ready_i,
  output logic [PlaceBits+PixelsBits-1:0]                       kept_o,

  // To the frame
  output logic                                                  shown_valid_o,
  input  logic                                                  shown_ready_i,
  output logic [EntryBits-1:0]                                  shown_o
);
  // --- Passes ---
  logic sent_entry_valid, sent_entry_ready, entry_valid, entry_ready, unused_streams;
  logic unused_motion_vectors_ready, unused_pixel_valid, unused_motion_valid;
  logic [5:0] unused_memory;
  hs_memory_pkg::bases_t no_bases;  // all is inside
  logic [EntryBits-1:0] sent_entry, entry;
  logic [EntryBits-Lanes*(DepthBits+ObjectBits)-1:0] unused_pixel;
  logic [hs_formats_pkg::MotionWordBits-1:0] unused_motion;

  assign no_bases = '0;

  assign unused_streams = ^{unused_motion_vectors_ready, unused_pixel_valid, unused_pixel,
                            unused_motion_valid, unused_motion, unused_memory};

  hs_pipeline #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_pipeline (
    .clk_i                      (clk_i),
    .rst_ni                     (rst_ni),
    .frame_width_i              (frame_width_i),
    .frame_height_i             (frame_height_i),
    .background_i               (background_i),
    .busy_o                     (busy_o),
    .light_valid_i              (light_valid_i),
    .light_i                    (light_i),
    .material_valid_i           (material_valid_i),
    .material_i                 (material_i),
    .texture_valid_i            (texture_valid_i),
    .texture_i                  (texture_i),
    .texel_valid_i              (texel_valid_i),
    .texel_i                    (texel_i),
    .triangle_valid_i           (triangle_valid_i),
    .triangle_ready_o           (triangle_ready_o),
    .triangle_i                 (triangle_i),
    .none_left_o                (none_left_o),
    .visible_valid_o            (visible_valid_o),
    .visible_ready_i            (visible_ready_i),
    .visible_o                  (visible_o),
    .normals_valid_i            (normals_valid_i),
    .normals_ready_o            (normals_ready_o),
    .normals_i                  (normals_i),
    .texture_coordinates_valid_i(texture_coordinates_valid_i),
    .texture_coordinates_ready_o(texture_coordinates_ready_o),
    .texture_coordinates_i      (texture_coordinates_i),
    .motion_vectors_valid_i     (1'b0),
    .motion_vectors_ready_o     (unused_motion_vectors_ready),
    .motion_vectors_i           ('0),
    .pixel_valid_o              (unused_pixel_valid),
    .pixel_ready_i              (1'b1),
    .pixel_o                    (unused_pixel),
    .motion_valid_o             (unused_motion_valid),
    .motion_ready_i             (1'b1),
    .motion_o                   (unused_motion),
    .entry_valid_o              (sent_entry_valid),
    .entry_ready_i              (sent_entry_ready),
    .entry_o                    (sent_entry),
    .memory_bases_i             (no_bases),
    .memory_read_valid_o        (unused_memory[0]),
    .memory_read_ready_i        (1'b0),
    .memory_read_o              (unused_memory[1]),
    .memory_data_valid_i        (1'b0),
    .memory_data_i              (1'b0),
    .memory_write_valid_o       (unused_memory[2]),
    .memory_write_ready_i       (1'b0),
    .memory_write_o             (unused_memory[3]),
    .memory_store_valid_o       (unused_memory[4]),
    .memory_store_ready_i       (1'b0),
    .memory_store_o             (unused_memory[5]),
    .memory_written_i           (1'b0)
  );

  hs_stream #(
    .Width(EntryBits)
  ) u_stream_entry (
    .valid_i(sent_entry_valid),
    .ready_o(sent_entry_ready),
    .word_i (sent_entry),
    .valid_o(entry_valid),
    .ready_i(entry_ready),
    .word_o (entry)
  );

  // --- Commands ---
  logic sent_merge_valid, sent_merge_ready, merge_valid, merge_ready;
  logic sent_stored_valid, sent_stored_ready, stored_valid, stored_ready;
  logic sent_drawn_valid, sent_drawn_ready, drawn_valid, drawn_ready;
  logic sent_merged_valid, sent_merged_ready, merged_valid, merged_ready;
  logic [MergeBits-1:0] sent_merge, merge;
  logic [EntryBits-1:0] sent_stored, stored, sent_drawn, drawn, sent_merged, merged;

  hs_static_run #(
    .LanesX    (LanesX),
    .LanesY    (LanesY),
    .BufferBits(BufferBits)
  ) u_static_run (
    .clk_i                (clk_i),
    .rst_ni               (rst_ni),
    .command_valid_i      (command_valid_i),
    .command_ready_o      (command_ready_o),
    .command_i            (command_i),
    .stored_place_valid_o (stored_place_valid_o),
    .stored_place_ready_i (stored_place_ready_i),
    .stored_place_o       (stored_place_o),
    .stored_pixels_valid_i(stored_pixels_valid_i),
    .stored_pixels_ready_o(stored_pixels_ready_o),
    .stored_pixels_i      (stored_pixels_i),
    .drawn_place_valid_o  (drawn_place_valid_o),
    .drawn_place_ready_i  (drawn_place_ready_i),
    .drawn_place_o        (drawn_place_o),
    .drawn_pixels_valid_i (drawn_pixels_valid_i),
    .drawn_pixels_ready_o (drawn_pixels_ready_o),
    .drawn_pixels_i       (drawn_pixels_i),
    .kept_valid_o         (kept_valid_o),
    .kept_ready_i         (kept_ready_i),
    .kept_o               (kept_o),
    .entry_valid_i        (entry_valid),
    .entry_ready_o        (entry_ready),
    .entry_i              (entry),
    .merge_valid_o        (sent_merge_valid),
    .merge_ready_i        (sent_merge_ready),
    .merge_o              (sent_merge),
    .stored_valid_o       (sent_stored_valid),
    .stored_ready_i       (sent_stored_ready),
    .stored_o             (sent_stored),
    .drawn_valid_o        (sent_drawn_valid),
    .drawn_ready_i        (sent_drawn_ready),
    .drawn_o              (sent_drawn),
    .merged_valid_i       (merged_valid),
    .merged_ready_o       (merged_ready),
    .merged_i             (merged),
    .shown_valid_o        (shown_valid_o),
    .shown_ready_i        (shown_ready_i),
    .shown_o              (shown_o)
  );

  hs_stream #(
    .Width(MergeBits)
  ) u_stream_merge (
    .valid_i(sent_merge_valid),
    .ready_o(sent_merge_ready),
    .word_i (sent_merge),
    .valid_o(merge_valid),
    .ready_i(merge_ready),
    .word_o (merge)
  );

  hs_stream #(
    .Width(EntryBits)
  ) u_stream_stored (
    .valid_i(sent_stored_valid),
    .ready_o(sent_stored_ready),
    .word_i (sent_stored),
    .valid_o(stored_valid),
    .ready_i(stored_ready),
    .word_o (stored)
  );

  hs_stream #(
    .Width(EntryBits)
  ) u_stream_drawn (
    .valid_i(sent_drawn_valid),
    .ready_o(sent_drawn_ready),
    .word_i (sent_drawn),
    .valid_o(drawn_valid),
    .ready_i(drawn_ready),
    .word_o (drawn)
  );

  hs_ztest_merge #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_ztest_merge (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .merge_valid_i (merge_valid),
    .merge_ready_o (merge_ready),
    .merge_i       (merge),
    .stored_valid_i(stored_valid),
    .stored_ready_o(stored_ready),
    .stored_i      (stored),
    .entry_valid_i (drawn_valid),
    .entry_ready_o (drawn_ready),
    .entry_i       (drawn),
    .merged_valid_o(sent_merged_valid),
    .merged_ready_i(sent_merged_ready),
    .merged_o      (sent_merged),
    .found_valid_o (found_valid_o),
    .found_ready_i (found_ready_i),
    .found_o       (found_o)
  );

  hs_stream #(
    .Width(EntryBits)
  ) u_stream_merged (
    .valid_i(sent_merged_valid),
    .ready_o(sent_merged_ready),
    .word_i (sent_merged),
    .valid_o(merged_valid),
    .ready_i(merged_ready),
    .word_o (merged)
  );
endmodule
