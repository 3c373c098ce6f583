// SPDX-License-Identifier: Apache-2.0
// Which pixels in between no key frame shows, and the faces that geometry has to send again for
// them (kernel: hls/motion/hole_find.hpp).
//
// A word of `between` is one of `compensated`: what two key frames make of a pixel, or that it is a
// hole, which shows a face and has no colour. `asked` is the face of a hole, unless it is that of
// the hole before; its last word ends the frame, and is of face 0 where there was no hole.
//
// Interval: a cycle a word. Latency from a word of compensated to between: none; to asked: the face
// is held until another one, or the end of the frame, shows whether it is the last.
// The faces wait in a queue for motion_compensate, which has fewer words in it. Stall: while asked
// is not taken no word moves. between never waits.
module hs_hole_find #(
  parameter int unsigned FaceFifoDepth = 32,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned MotionBits = hs_formats_pkg::MotionWordBits,
  localparam int unsigned CompensatedBits = hs_formats_pkg::CompensatedWordBits,
  localparam int unsigned HeadBits = 1 + XBits + YBits,
  localparam int unsigned BetweenBits = HeadBits + 2 + 3 * ColourBits
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  // Of the same pixel: from motion_order, and from motion_compensate
  input  logic                       ordered_valid_i,
  output logic                       ordered_ready_o,
  input  logic [MotionBits-1:0]      ordered_i,
  input  logic                       compensated_valid_i,
  output logic                       compensated_ready_o,
  input  logic [CompensatedBits-1:0] compensated_i,

  // To the film buffer and the marks of holes
  output logic                       between_valid_o,
  output logic [BetweenBits-1:0]     between_o,

  // To geometry
  output logic                       asked_valid_o,
  input  logic                       asked_ready_i,
  output logic [FaceBits:0]          asked_o  // {last, face}
);
  // --- The two words of a pixel ---
  logic face_valid, go, moves, shown, hole, last, unused_ordered;
  logic [FaceBits-1:0] face;
  logic [HeadBits-1:0] head;
  logic [3*ColourBits-1:0] colour;
  logic [1:0] keys;

  assign unused_ordered = ^ordered_i;

  hs_fifo #(
    .Width(FaceBits),
    .Depth(FaceFifoDepth)
  ) u_face_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (ordered_valid_i),
    .in_ready_o (ordered_ready_o),
    .in_i       (ordered_i[MotionBits-1-HeadBits -: FaceBits]),
    .out_valid_o(face_valid),
    .out_ready_i(moves),
    .out_o      (face)
  );
  assign {head, colour, keys} = compensated_i;
  assign last = head[HeadBits-1];
  assign shown = keys != '0;
  assign hole = !shown && face != '0;
  assign compensated_ready_o = go && face_valid;
  assign moves = compensated_valid_i && compensated_ready_o;
  assign between_valid_o = moves;
  assign between_o = {head, shown, hole, colour};

  // --- The faces that are asked for ---
  logic held_q;  // face_q is that of a hole in this frame, and not sent
  logic ends_q;  // it is the last one
  logic asks, asked_valid_q;
  logic [FaceBits-1:0] face_q;
  logic [FaceBits:0] asked_q;

  assign asks = moves && hole && !(held_q && face == face_q);
  assign go = !ends_q && (!asked_valid_q || asked_ready_i);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      held_q <= 1'b0;
      ends_q <= 1'b0;
      asked_valid_q <= 1'b0;
    end else if (!asked_valid_q || asked_ready_i) begin
      held_q <= asks || (held_q && !ends_q);
      ends_q <= moves && last;
      asked_valid_q <= ends_q || (asks && held_q);
    end
  end

  always_ff @(posedge clk_i) begin
    if (asks) face_q <= face;
    if (!asked_valid_q || asked_ready_i) begin
      asked_q <= {ends_q, held_q ? face_q : FaceBits'(0)};
    end
  end

  assign asked_valid_o = asked_valid_q;
  assign asked_o = asked_q;
endmodule
