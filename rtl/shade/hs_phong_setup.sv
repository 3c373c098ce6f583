// SPDX-License-Identifier: Apache-2.0
// The planes of the components of a normal over a triangle, for TdbS, after
// hls/shade/phong_setup.hpp: x, y and z through hs_channel_planes.
//
// Interval, latency and stalls are those of hs_channel_planes. Attributes and normals come in one
// order and are taken together, ready of either following both valid; empty attributes have no
// normals. Fields of an empty record are 0.
// A configuration without Phong shading has no such unit: hs_formats_pkg has not its numbers then.
module hs_phong_setup #(
  parameter int unsigned NormalBits,  // of a component
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned MaterialBits = hs_formats_pkg::MaterialBits,
  localparam int unsigned PlaneBits = hs_formats_pkg::NormalPlaneBits,
  localparam int unsigned NormalsBits = 1 + IndexBits + MaterialBits + 9 * NormalBits,
  localparam int unsigned NormalPlanesBits = 2 + IndexBits + MaterialBits + 9 * PlaneBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // From triangle_setup
  input  logic                        attributes_valid_i,
  output logic                        attributes_ready_o,
  input  hs_formats_pkg::attributes_t attributes_i,

  // From geometry
  input  logic                        normals_valid_i,
  output logic                        normals_ready_o,
  input  logic [NormalsBits-1:0]      normals_i,

  // To TdbS
  output logic                        planes_valid_o,
  input  logic                        planes_ready_i,
  output logic [NormalPlanesBits-1:0] planes_o
);
  // --- The two words of a triangle ---
  logic valid, ready, unused_head;
  logic [MaterialBits-1:0] material;
  logic [9*NormalBits-1:0] given;  // a vertex after the other, each {x, y, z}

  assign unused_head = ^normals_i[NormalsBits-1 -: 1+IndexBits];
  assign {material, given} = normals_i[MaterialBits+9*NormalBits-1:0];
  assign valid = attributes_valid_i && (attributes_i.empty || normals_valid_i);
  assign attributes_ready_o = valid && ready;
  assign normals_ready_o = valid && ready && !attributes_i.empty;

  // --- Values: vertices in the order of the attributes, components without a sign ---
  logic [9*NormalBits-1:0] vertices, values;

  hs_attribute_order #(
    .Bits(3 * NormalBits)
  ) u_order (
    .first_i (attributes_i.first),
    .turned_i(attributes_i.turned),
    .given_i (given),
    .values_o(vertices)
  );

  for (genvar vertex = 0; vertex < 3; vertex++) begin : gen_vertex
    for (genvar c = 0; c < 3; c++) begin : gen_component
      assign values[(3*c+vertex)*NormalBits +: NormalBits] =
          vertices[(3*vertex+c)*NormalBits +: NormalBits] ^ {1'b1, {(NormalBits - 1) {1'b0}}};
    end
  end

  // --- Planes ---
  logic last_q, empty_q;
  hs_formats_pkg::index_t index_q;
  logic [MaterialBits-1:0] material_q;
  logic [9*PlaneBits-1:0] planes;

  // A record is taken after the one before it has left.
  always_ff @(posedge clk_i) begin
    if (attributes_ready_o) begin
      last_q <= attributes_i.last;
      empty_q <= attributes_i.empty;
      index_q <= attributes_i.index;
      material_q <= attributes_i.empty ? '0 : material;
    end
  end

  hs_channel_planes #(
    .ValueBits(NormalBits),
    .Fraction (hs_formats_pkg::NormalFraction)
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
    .valid_o     (planes_valid_o),
    .ready_i     (planes_ready_i),
    .planes_o    (planes)
  );

  assign planes_o = {last_q, empty_q, index_q, material_q, planes};
endmodule
