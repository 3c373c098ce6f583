// SPDX-License-Identifier: Apache-2.0
// From the motion of a frame in between to its pixels, and to the faces of those that no key shows.
//
//   motion ─► motion_order ─ordered─┬─► motion_compensate ─compensated─► hole_find ─► between,
//                                   └────────────────────────────────────────┘        asked
//
// Requests and blocks of tiles go by: the memories of key frames are outside. walk_i: those and the
// film buffer are not being shown; it stays 1 until the last word of asked is taken.
// Interval: motion_compensate's. Stall: as its units.
module hs_film_between #(
  parameter int unsigned TileXBits,
  parameter int unsigned TileYBits,
  localparam int unsigned KeySide = hs_formats_pkg::KeySide,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned KeyWeightBits = hs_formats_pkg::KeyWeightBits,
  localparam int unsigned MotionBits = hs_formats_pkg::MotionWordBits,
  localparam int unsigned EntryBits = MotionBits - 1 - hs_formats_pkg::XBits
                                      - hs_formats_pkg::YBits,
  localparam int unsigned Tiles = (hs_formats_pkg::MaxWidth + 7) / 8
                                  * ((hs_formats_pkg::MaxHeight + 7) / 8),
  localparam int unsigned AddressBits = (Tiles > 1 ? $clog2(Tiles) : 1) + 6,
  localparam int unsigned RequestBits = TileXBits + TileYBits,
  localparam int unsigned BlockBits = KeySide * KeySide * (3 * ColourBits + FaceBits),
  localparam int unsigned CompensatedBits = hs_formats_pkg::CompensatedWordBits,
  localparam int unsigned BetweenBits = 3 + hs_formats_pkg::XBits + hs_formats_pkg::YBits
                                        + 3 * ColourBits,
  localparam int unsigned AskedBits = hs_formats_pkg::AskedWordBits
) (
  input  logic                     clk_i,
  input  logic                     rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t       frame_width_i,
  input  hs_formats_pkg::y_t       frame_height_i,
  input  logic [KeyWeightBits-1:0] key_weight_i,

  input  logic                     walk_i,

  // From motion_field
  input  logic                     motion_valid_i,
  output logic                     motion_ready_o,
  input  logic [MotionBits-1:0]    motion_i,

  // Motion buffer
  output logic                     write_en_o,
  output logic [AddressBits-1:0]   write_address_o,
  output logic [EntryBits-1:0]     write_motion_o,
  output logic                     read_en_o,
  output logic [AddressBits-1:0]   read_address_o,
  input  logic [EntryBits-1:0]     read_motion_i,

  // The memories of the key frames
  output logic                     key_request_0_valid_o,
  input  logic                     key_request_0_ready_i,
  output logic [RequestBits-1:0]   key_request_0_o,
  input  logic                     key_block_0_valid_i,
  output logic                     key_block_0_ready_o,
  input  logic [BlockBits-1:0]     key_block_0_i,
  output logic                     key_request_1_valid_o,
  input  logic                     key_request_1_ready_i,
  output logic [RequestBits-1:0]   key_request_1_o,
  input  logic                     key_block_1_valid_i,
  output logic                     key_block_1_ready_o,
  input  logic [BlockBits-1:0]     key_block_1_i,

  // To the film buffer and the marks of holes
  output logic                     between_valid_o,
  output logic [BetweenBits-1:0]   between_o,

  // To geometry
  output logic                     asked_valid_o,
  input  logic                     asked_ready_i,
  output logic [AskedBits-1:0]     asked_o
);
  // --- Motion in the order of tiles ---
  logic sent_ordered_valid, sent_ordered_ready, ordered_valid, ordered_ready;
  logic key_ordered_valid, key_ordered_ready, face_ordered_valid, face_ordered_ready;
  logic [MotionBits-1:0] sent_ordered, ordered;

  hs_motion_order u_motion_order (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .frame_width_i  (frame_width_i),
    .frame_height_i (frame_height_i),
    .motion_valid_i (motion_valid_i),
    .motion_ready_o (motion_ready_o),
    .motion_i       (motion_i),
    .write_en_o     (write_en_o),
    .write_address_o(write_address_o),
    .write_motion_o (write_motion_o),
    .read_en_o      (read_en_o),
    .read_address_o (read_address_o),
    .read_motion_i  (read_motion_i),
    .ordered_valid_o(sent_ordered_valid),
    .ordered_ready_i(sent_ordered_ready),
    .ordered_o      (sent_ordered)
  );

  hs_stream #(
    .Width(MotionBits)
  ) u_stream_ordered (
    .valid_i(sent_ordered_valid),
    .ready_o(sent_ordered_ready),
    .word_i (sent_ordered),
    .valid_o(ordered_valid),
    .ready_i(ordered_ready),
    .word_o (ordered)
  );

  hs_fork u_ordered_fork (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .in_valid_i    (ordered_valid && walk_i),
    .in_ready_o    (ordered_ready),
    .first_valid_o (key_ordered_valid),
    .first_ready_i (key_ordered_ready),
    .second_valid_o(face_ordered_valid),
    .second_ready_i(face_ordered_ready)
  );

  // --- Pixels from the keys ---
  logic request_0_valid, request_0_ready, request_1_valid, request_1_ready;
  logic block_0_valid, block_0_ready, block_1_valid, block_1_ready;
  logic sent_compensated_valid, sent_compensated_ready, compensated_valid, compensated_ready;
  logic [RequestBits-1:0] request_0, request_1;
  logic [BlockBits-1:0] block_0, block_1;
  logic [CompensatedBits-1:0] sent_compensated, compensated;

  hs_motion_compensate #(
    .TileXBits(TileXBits),
    .TileYBits(TileYBits)
  ) u_motion_compensate (
    .clk_i                (clk_i),
    .rst_ni               (rst_ni),
    .frame_width_i        (frame_width_i),
    .frame_height_i       (frame_height_i),
    .key_weight_i         (key_weight_i),
    .motion_valid_i       (key_ordered_valid),
    .motion_ready_o       (key_ordered_ready),
    .motion_i             (ordered),
    .key_request_0_valid_o(request_0_valid),
    .key_request_0_ready_i(request_0_ready),
    .key_request_0_o      (request_0),
    .key_block_0_valid_i  (block_0_valid),
    .key_block_0_ready_o  (block_0_ready),
    .key_block_0_i        (block_0),
    .key_request_1_valid_o(request_1_valid),
    .key_request_1_ready_i(request_1_ready),
    .key_request_1_o      (request_1),
    .key_block_1_valid_i  (block_1_valid),
    .key_block_1_ready_o  (block_1_ready),
    .key_block_1_i        (block_1),
    .compensated_valid_o  (sent_compensated_valid),
    .compensated_ready_i  (sent_compensated_ready),
    .compensated_o        (sent_compensated)
  );

  hs_stream #(
    .Width(RequestBits)
  ) u_stream_key_request_0 (
    .valid_i(request_0_valid),
    .ready_o(request_0_ready),
    .word_i (request_0),
    .valid_o(key_request_0_valid_o),
    .ready_i(key_request_0_ready_i),
    .word_o (key_request_0_o)
  );

  hs_stream #(
    .Width(BlockBits)
  ) u_stream_key_block_0 (
    .valid_i(key_block_0_valid_i),
    .ready_o(key_block_0_ready_o),
    .word_i (key_block_0_i),
    .valid_o(block_0_valid),
    .ready_i(block_0_ready),
    .word_o (block_0)
  );

  hs_stream #(
    .Width(RequestBits)
  ) u_stream_key_request_1 (
    .valid_i(request_1_valid),
    .ready_o(request_1_ready),
    .word_i (request_1),
    .valid_o(key_request_1_valid_o),
    .ready_i(key_request_1_ready_i),
    .word_o (key_request_1_o)
  );

  hs_stream #(
    .Width(BlockBits)
  ) u_stream_key_block_1 (
    .valid_i(key_block_1_valid_i),
    .ready_o(key_block_1_ready_o),
    .word_i (key_block_1_i),
    .valid_o(block_1_valid),
    .ready_i(block_1_ready),
    .word_o (block_1)
  );

  hs_stream #(
    .Width(CompensatedBits)
  ) u_stream_compensated (
    .valid_i(sent_compensated_valid),
    .ready_o(sent_compensated_ready),
    .word_i (sent_compensated),
    .valid_o(compensated_valid),
    .ready_i(compensated_ready),
    .word_o (compensated)
  );

  // --- Holes ---
  logic sent_between_valid, unused_between_ready;
  logic [BetweenBits-1:0] sent_between;

  hs_hole_find u_hole_find (
    .clk_i              (clk_i),
    .rst_ni             (rst_ni),
    .ordered_valid_i    (face_ordered_valid),
    .ordered_ready_o    (face_ordered_ready),
    .ordered_i          (ordered),
    .compensated_valid_i(compensated_valid),
    .compensated_ready_o(compensated_ready),
    .compensated_i      (compensated),
    .between_valid_o    (sent_between_valid),
    .between_o          (sent_between),
    .asked_valid_o      (asked_valid_o),
    .asked_ready_i      (asked_ready_i),
    .asked_o            (asked_o)
  );

  hs_stream #(
    .Width(BetweenBits)
  ) u_stream_between (
    .valid_i(sent_between_valid),
    .ready_o(unused_between_ready),
    .word_i (sent_between),
    .valid_o(between_valid_o),
    .ready_i(1'b1),
    .word_o (between_o)
  );
endmodule
