// SPDX-License-Identifier: Apache-2.0
// Lights the vertices of a triangle, after hls/shade/light_vertex.hpp: one normal after the other
// through one hs_lighting; of a flat triangle, one.
//
// Interval: a cycle a normal and light. Latency: that of hs_lighting after the last normal, and a
// cycle. Stall: as hs_lighting. A word is taken with its last normal: ready follows valid.
// A configuration without lighting has no such unit: hs_formats_pkg has not its numbers then.
module hs_light_vertex #(
  parameter int unsigned Vertices,  // 3, or 1 if flat
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned NormalBits = hs_formats_pkg::NormalBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned MaterialBits = hs_formats_pkg::MaterialBits,
  localparam int unsigned LightWordBits = hs_formats_pkg::LightWordBits,
  localparam int unsigned MaterialWordBits = hs_formats_pkg::MaterialWordBits,
  localparam int unsigned NormalsBits = 1 + IndexBits + MaterialBits + Vertices * 3 * NormalBits,
  localparam int unsigned ColoursBits = 1 + IndexBits + Vertices * 3 * ColourBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // Registers and memories, written while no triangle is in flight
  input  logic                        light_valid_i,
  input  logic [LightWordBits-1:0]    light_i,
  input  logic                        material_valid_i,
  input  logic [MaterialWordBits-1:0] material_i,

  // From geometry
  input  logic                        normals_valid_i,
  output logic                        normals_ready_o,
  input  logic [NormalsBits-1:0]      normals_i,

  // To shade_setup
  output logic                        colours_valid_o,
  input  logic                        colours_ready_i,
  output logic [ColoursBits-1:0]      colours_o
);
  localparam int unsigned VertexBits = Vertices > 1 ? $clog2(Vertices) : 1;
  localparam int unsigned HeadBits = 1 + IndexBits;
  localparam int unsigned TagBits = HeadBits + VertexBits;
  localparam logic [VertexBits-1:0] LastVertex = VertexBits'(Vertices - 1);

  // --- In: a vertex after the other, vertex 0 in the most significant place ---
  logic [VertexBits-1:0] vertex_q;
  logic normal_ready;
  logic [HeadBits-1:0] head;
  logic [MaterialBits-1:0] material;
  logic [3*NormalBits-1:0] normal;

  assign {head, material} = normals_i[NormalsBits-1 -: HeadBits+MaterialBits];
  always_comb begin
    normal = '0;
    for (int unsigned i = 0; i < Vertices; i++) begin
      if (vertex_q == VertexBits'(i)) begin
        normal = normals_i[(Vertices-1-i)*3*NormalBits +: 3*NormalBits];
      end
    end
  end
  assign normals_ready_o = normal_ready && vertex_q == LastVertex;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      vertex_q <= '0;
    end else if (normals_valid_i && normal_ready) begin
      vertex_q <= vertex_q == LastVertex ? '0 : vertex_q + VertexBits'(1);
    end
  end

  // --- Out: the last vertex completes the word ---
  logic colour_valid, colour_ready, is_last;
  logic [TagBits-1:0] colour_tag;
  logic [3*ColourBits-1:0] colour;
  logic [3*Vertices*ColourBits-1:0] colours;

  assign is_last = colour_tag[VertexBits-1:0] == LastVertex;
  assign colour_ready = !is_last || colours_ready_i;
  assign colours_valid_o = colour_valid && is_last;
  assign colours_o = {colour_tag[TagBits-1 -: HeadBits], colours};

  // A channel after the other, in each the last vertex in the least significant place: the others
  // move up as they come.
  for (genvar c = 0; c < 3; c++) begin : gen_channel
    localparam int unsigned Low = c * Vertices * ColourBits;
    assign colours[Low +: ColourBits] = colour[c*ColourBits +: ColourBits];
    if (Vertices > 1) begin : gen_others
      logic [(Vertices-1)*ColourBits-1:0] others_q;
      always_ff @(posedge clk_i) begin
        if (colour_valid && !is_last) others_q <= colours[Low +: (Vertices-1)*ColourBits];
      end
      assign colours[Low+ColourBits +: (Vertices-1)*ColourBits] = others_q;
    end
  end

  hs_lighting #(
    .TagBits(TagBits)
  ) u_lighting (
    .clk_i            (clk_i),
    .rst_ni           (rst_ni),
    .light_valid_i    (light_valid_i),
    .light_i          (light_i),
    .material_valid_i (material_valid_i),
    .material_i       (material_i),
    .normal_valid_i   (normals_valid_i),
    .normal_ready_o   (normal_ready),
    .normal_tag_i     ({head, vertex_q}),
    .normal_material_i(material),
    .normal_i         (normal),
    .colour_valid_o   (colour_valid),
    .colour_ready_i   (colour_ready),
    .colour_tag_o     (colour_tag),
    .colour_o         (colour)
  );
endmodule
