// SPDX-License-Identifier: Apache-2.0
// The planes of the texture coordinates of a triangle, for TdbS, after
// hls/texture/texture_setup.hpp: s, t, and with perspective q, through hs_channel_planes.
//
// Interval, latency and stalls are those of hs_channel_planes, of two or three channels. Attributes
// and coordinates come in one order and are taken together, ready of either following both valid;
// empty attributes have no coordinates. Fields of an empty record are 0.
// A configuration without texture has no such unit: hs_formats_pkg has not its numbers then.
module hs_texture_setup #(
  parameter int unsigned CoordinateBits,
  localparam int unsigned Channels = hs_formats_pkg::Perspective != 0 ? 3 : 2,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned TextureBits = hs_formats_pkg::TextureBits,
  localparam int unsigned RepeatBits = hs_formats_pkg::RepeatBits,
  localparam int unsigned PlaneBits = hs_formats_pkg::CoordinatePlaneBits,
  localparam int unsigned CoordinatesBits = hs_formats_pkg::TextureCoordinatesWordBits,
  localparam int unsigned PlanesBits = hs_formats_pkg::TexturePlanesWordBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // From visible_select
  input  logic                        attributes_valid_i,
  output logic                        attributes_ready_o,
  input  hs_formats_pkg::attributes_t attributes_i,

  // From geometry
  input  logic                        texture_coordinates_valid_i,
  output logic                        texture_coordinates_ready_o,
  input  logic [CoordinatesBits-1:0]  texture_coordinates_i,

  // To TdbS
  output logic                        texture_planes_valid_o,
  input  logic                        texture_planes_ready_i,
  output logic [PlanesBits-1:0]       texture_planes_o
);
  localparam int unsigned ValuesBits = 3 * Channels * CoordinateBits;

  // --- The two words of a triangle; channels, each {v0, v1, v2}, in the order of attributes ---
  logic valid, ready, unused_head, unused_colours;
  logic [TextureBits-1:0] texture;
  logic [RepeatBits-1:0] repeats;
  logic [ValuesBits-1:0] given, values;

  assign unused_head = ^texture_coordinates_i[CoordinatesBits-1 -: 1+IndexBits];
  assign unused_colours = ^attributes_i;
  assign {texture, repeats, given} = texture_coordinates_i[TextureBits+RepeatBits+ValuesBits-1:0];
  assign valid = attributes_valid_i && (attributes_i.empty || texture_coordinates_valid_i);
  assign attributes_ready_o = valid && ready;
  assign texture_coordinates_ready_o = valid && ready && !attributes_i.empty;

  for (genvar c = 0; c < Channels; c++) begin : gen_channel
    hs_attribute_order #(
      .Bits(CoordinateBits)
    ) u_order (
      .first_i (attributes_i.first),
      .turned_i(attributes_i.turned),
      .given_i (given[3*c*CoordinateBits +: 3*CoordinateBits]),
      .values_o(values[3*c*CoordinateBits +: 3*CoordinateBits])
    );
  end

  // --- Planes ---
  logic last_q, empty_q;
  hs_formats_pkg::index_t index_q;
  logic [TextureBits-1:0] texture_q;
  logic [RepeatBits-1:0] repeat_q;
  logic [3*Channels*PlaneBits-1:0] planes;

  // A record is taken after the one before it has left.
  always_ff @(posedge clk_i) begin
    if (attributes_ready_o) begin
      last_q <= attributes_i.last;
      empty_q <= attributes_i.empty;
      index_q <= attributes_i.index;
      texture_q <= attributes_i.empty ? '0 : texture;
      repeat_q <= attributes_i.empty ? '0 : repeats;
    end
  end

  hs_channel_planes #(
    .ValueBits(CoordinateBits),
    .Fraction (hs_formats_pkg::CoordinateFraction),
    .Channels (Channels)
  ) u_planes (
    .clk_i       (clk_i),
    .rst_ni      (rst_ni),
    .valid_i     (valid),
    .ready_o     (ready),
    .empty_i     (attributes_i.empty),
    .values_i    (values),
    .x_i         (attributes_i.x),
    .y_i         (attributes_i.y),
    .dx1_i       (attributes_i.dx1),
    .dy1_i       (attributes_i.dy1),
    .dx2_i       (attributes_i.dx2),
    .dy2_i       (attributes_i.dy2),
    .shift_i     (attributes_i.shift),
    .reciprocal_i(attributes_i.reciprocal),
    .valid_o     (texture_planes_valid_o),
    .ready_i     (texture_planes_ready_i),
    .planes_o    (planes)
  );

  assign texture_planes_o = {last_q, empty_q, index_q, texture_q, repeat_q, planes};
endmodule
