// SPDX-License-Identifier: Apache-2.0
// The planes of a triangle's places in the key frames, for TdbS, after hls/motion/motion_setup.hpp:
// of each key s, t, and with perspective q, and where colours are compared, of three differences,
// each group through an hs_channel_planes of its own, side by side.
//
// Interval and latency are those of hs_channel_planes, of two channels, or of three with
// perspective or differences; of both together up to 4 cycles more, as the planes of two channels
// wait for those of three. Attributes and vectors come in one order and are taken together, when
// the last of the groups has read them; empty attributes have no vectors. Planes leave together.
// Fields of an empty record are 0.
// A configuration without motion has no such unit: hs_formats_pkg has not its numbers then.
module hs_motion_setup #(
  parameter int unsigned FaceBits,
  localparam int unsigned Relight = hs_formats_pkg::Relight,
  localparam int unsigned Channels = hs_formats_pkg::Perspective != 0 ? 3 : 2,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned VectorsBits = hs_formats_pkg::MotionVectorsWordBits,
  localparam int unsigned PlanesBits = hs_formats_pkg::MotionPlanesWordBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // From visible_select
  input  logic                        attributes_valid_i,
  output logic                        attributes_ready_o,
  input  hs_formats_pkg::attributes_t attributes_i,

  // From geometry
  input  logic                        motion_vectors_valid_i,
  output logic                        motion_vectors_ready_o,
  input  logic [VectorsBits-1:0]      motion_vectors_i,

  // To TdbS
  output logic                        motion_planes_valid_o,
  input  logic                        motion_planes_ready_i,
  output logic [PlanesBits-1:0]       motion_planes_o
);
  localparam int unsigned Keys = 2;
  localparam int unsigned Groups = 1 + Relight;  // of a key: places, differences
  localparam int unsigned ValueBits = hs_formats_pkg::CoordinateBits;
  localparam int unsigned PlaneBits = hs_formats_pkg::CoordinatePlaneBits;
  localparam int unsigned DifferenceBits = hs_formats_pkg::DifferenceBits;
  localparam int unsigned DifferencePlaneBits = hs_formats_pkg::DifferencePlaneBits;
  localparam int unsigned PlaceBits = 3 * Channels * ValueBits;
  localparam int unsigned ColourBits = Relight != 0 ? 9 * DifferenceBits : 0;
  localparam int unsigned PlacePlanesBits = 3 * Channels * PlaneBits;
  localparam int unsigned ColourPlanesBits = Relight != 0 ? 9 * DifferencePlaneBits : 0;
  // {is it there, origin, extent}, which go through.
  localparam int unsigned HeadBits =
      1 + 2 * hs_formats_pkg::OriginBits + hs_formats_pkg::ExtentBits;
  localparam int unsigned KeyBits = HeadBits + PlaceBits + ColourBits;
  localparam int unsigned KeyPlanesBits = HeadBits + PlacePlanesBits + ColourPlanesBits;

  // --- The two words of a triangle, until all groups have read them ---
  logic valid, take, unused_head, unused_attributes;
  logic [FaceBits-1:0] face;
  logic [Keys*Groups-1:0] ready, read_q, planes_valid;

  assign unused_head = ^motion_vectors_i[VectorsBits-1 -: 1+IndexBits];
  assign unused_attributes = ^attributes_i;
  assign face = motion_vectors_i[Keys*KeyBits +: FaceBits];
  assign valid = attributes_valid_i && (attributes_i.empty || motion_vectors_valid_i);
  assign take = valid && &(read_q | ready);
  assign attributes_ready_o = take;
  assign motion_vectors_ready_o = take && !attributes_i.empty;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) read_q <= '0;
    else if (valid) read_q <= take ? '0 : read_q | ready;
  end

  // --- What goes through: a record is taken after the one before it has left ---
  logic last_q, empty_q;
  hs_formats_pkg::index_t index_q;
  logic [FaceBits-1:0] face_q;

  always_ff @(posedge clk_i) begin
    if (take) begin
      last_q <= attributes_i.last;
      empty_q <= attributes_i.empty;
      index_q <= attributes_i.index;
      face_q <= attributes_i.empty ? '0 : face;
    end
  end

  // --- Planes: group k is key 1 − k, as key 0 is in the more significant place ---
  logic leave;

  assign motion_planes_valid_o = &planes_valid;
  assign leave = motion_planes_valid_o && motion_planes_ready_i;
  assign motion_planes_o[PlanesBits-1 -: 2+IndexBits+FaceBits] = {last_q, empty_q, index_q, face_q};

  for (genvar k = 0; k < Keys; k++) begin : gen_key
    localparam int unsigned Given = k * KeyBits;
    localparam int unsigned Planes = k * KeyPlanesBits;
    logic [HeadBits-1:0] head_q;
    logic [PlaceBits-1:0] places;

    always_ff @(posedge clk_i) begin
      if (take) begin
        head_q <= attributes_i.empty
                  ? '0 : motion_vectors_i[Given+PlaceBits+ColourBits +: HeadBits];
      end
    end
    assign motion_planes_o[Planes+PlacePlanesBits+ColourPlanesBits +: HeadBits] = head_q;

    for (genvar c = 0; c < Channels; c++) begin : gen_place
      hs_attribute_order #(
        .Bits(ValueBits)
      ) u_order (
        .first_i (attributes_i.first),
        .turned_i(attributes_i.turned),
        .given_i (motion_vectors_i[Given+ColourBits+3*c*ValueBits +: 3*ValueBits]),
        .values_o(places[3*c*ValueBits +: 3*ValueBits])
      );
    end

    hs_channel_planes #(
      .ValueBits(ValueBits),
      .Fraction (hs_formats_pkg::CoordinateFraction),
      .Channels (Channels)
    ) u_places (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .valid_i     (valid && !read_q[k*Groups]),
      .ready_o     (ready[k*Groups]),
      .empty_i     (attributes_i.empty),
      .values_i    (places),
      .x_i         (attributes_i.x),
      .y_i         (attributes_i.y),
      .dx1_i       (attributes_i.dx1),
      .dy1_i       (attributes_i.dy1),
      .dx2_i       (attributes_i.dx2),
      .dy2_i       (attributes_i.dy2),
      .shift_i     (attributes_i.shift),
      .reciprocal_i(attributes_i.reciprocal),
      .valid_o     (planes_valid[k*Groups]),
      .ready_i     (leave),
      .planes_o    (motion_planes_o[Planes+ColourPlanesBits +: PlacePlanesBits])
    );

    if (Relight != 0) begin : gen_relight
      logic [ColourBits-1:0] differences;

      for (genvar c = 0; c < 3; c++) begin : gen_difference
        hs_attribute_order #(
          .Bits(DifferenceBits)
        ) u_order (
          .first_i (attributes_i.first),
          .turned_i(attributes_i.turned),
          .given_i (motion_vectors_i[Given+3*c*DifferenceBits +: 3*DifferenceBits]),
          .values_o(differences[3*c*DifferenceBits +: 3*DifferenceBits])
        );
      end

      hs_channel_planes #(
        .ValueBits(DifferenceBits),
        .Fraction (hs_formats_pkg::ColourFraction)
      ) u_differences (
        .clk_i       (clk_i),
        .rst_ni      (rst_ni),
        .valid_i     (valid && !read_q[k*Groups+1]),
        .ready_o     (ready[k*Groups+1]),
        .empty_i     (attributes_i.empty),
        .values_i    (differences),
        .x_i         (attributes_i.x),
        .y_i         (attributes_i.y),
        .dx1_i       (attributes_i.dx1),
        .dy1_i       (attributes_i.dy1),
        .dx2_i       (attributes_i.dx2),
        .dy2_i       (attributes_i.dy2),
        .shift_i     (attributes_i.shift),
        .reciprocal_i(attributes_i.reciprocal),
        .valid_o     (planes_valid[k*Groups+1]),
        .ready_i     (leave),
        .planes_o    (motion_planes_o[Planes +: ColourPlanesBits])
      );
    end
  end
endmodule
