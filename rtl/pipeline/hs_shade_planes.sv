// SPDX-License-Identifier: Apache-2.0
// What a triangle is shaded with, from its attributes: the one of three ways that the configuration
// takes.
//
//   attributes, colours in them                      ─► shade_setup ─► planes
//   attributes, normals ─► light_vertex ─colours─► queue ─► shade_setup ─► planes
//   attributes, normals                              ─► phong_setup ─► planes
//
// Without lighting there are no normals; their port is one bit then, and not looked at. Words of
// `normals` come for attributes that are not empty, in their order.
// Interval, stall: as the setup. Lights and materials are written while no frame is in flight.
module hs_shade_planes #(
  parameter int unsigned ColoursFifoDepth = 4,
  parameter int unsigned SetupCycles = hs_formats_pkg::SetupInterval,
  localparam int unsigned ColoursBits = hs_formats_pkg::ColoursWordBits
) (
  input  logic                                        clk_i,
  input  logic                                        rst_ni,

  // From geometry
  input  logic                                        light_valid_i,
  input  logic [hs_formats_pkg::LightWordBits-1:0]    light_i,
  input  logic                                        material_valid_i,
  input  logic [hs_formats_pkg::MaterialWordBits-1:0] material_i,
  input  logic                                        normals_valid_i,
  output logic                                        normals_ready_o,
  input  logic [hs_formats_pkg::NormalsWordBits-1:0]  normals_i,

  // From triangle_setup or visible_select
  input  logic                                        attributes_valid_i,
  output logic                                        attributes_ready_o,
  input  hs_formats_pkg::attributes_t                 attributes_i,

  // To TdbS
  output logic                                        planes_valid_o,
  input  logic                                        planes_ready_i,
  output logic [hs_formats_pkg::PlanesWordBits-1:0]   planes_o
);
  if (hs_formats_pkg::Phong != 0) begin : gen_phong_setup
    logic unused_lighting;
    assign unused_lighting = ^{light_valid_i, light_i, material_valid_i, material_i};

    hs_phong_setup #(
      .NormalBits(hs_formats_pkg::NormalBits)
    ) u_phong_setup (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .attributes_valid_i(attributes_valid_i),
      .attributes_ready_o(attributes_ready_o),
      .attributes_i      (attributes_i),
      .normals_valid_i   (normals_valid_i),
      .normals_ready_o   (normals_ready_o),
      .normals_i         (normals_i),
      .planes_valid_o    (planes_valid_o),
      .planes_ready_i    (planes_ready_i),
      .planes_o          (planes_o)
    );
  end else begin : gen_shade_setup
    logic setup_colours_valid, setup_colours_ready;
    logic [ColoursBits-1:0] setup_colours;

    if (hs_formats_pkg::Lights != 0) begin : gen_light_vertex
      logic sent_colours_valid, sent_colours_ready, colours_valid, colours_ready;
      logic [ColoursBits-1:0] sent_colours, colours;

      hs_light_vertex #(
        .Vertices(hs_formats_pkg::Gouraud != 0 ? 3 : 1)
      ) u_light_vertex (
        .clk_i           (clk_i),
        .rst_ni          (rst_ni),
        .light_valid_i   (light_valid_i),
        .light_i         (light_i),
        .material_valid_i(material_valid_i),
        .material_i      (material_i),
        .normals_valid_i (normals_valid_i),
        .normals_ready_o (normals_ready_o),
        .normals_i       (normals_i),
        .colours_valid_o (sent_colours_valid),
        .colours_ready_i (sent_colours_ready),
        .colours_o       (sent_colours)
      );

      hs_stream #(
        .Width(ColoursBits)
      ) u_stream_colours (
        .valid_i(sent_colours_valid),
        .ready_o(sent_colours_ready),
        .word_i (sent_colours),
        .valid_o(colours_valid),
        .ready_i(colours_ready),
        .word_o (colours)
      );

      hs_fifo #(
        .Width(ColoursBits),
        .Depth(ColoursFifoDepth)
      ) u_colours_fifo (
        .clk_i      (clk_i),
        .rst_ni     (rst_ni),
        .in_valid_i (colours_valid),
        .in_ready_o (colours_ready),
        .in_i       (colours),
        .out_valid_o(setup_colours_valid),
        .out_ready_i(setup_colours_ready),
        .out_o      (setup_colours)
      );
    end else begin : gen_no_lighting
      logic unused_lighting;
      assign unused_lighting = ^{light_valid_i, light_i, material_valid_i, material_i,
                                 normals_valid_i, normals_i, setup_colours_ready};
      assign normals_ready_o = 1'b0;
      assign setup_colours_valid = 1'b0;
      assign setup_colours = '0;
    end

    hs_shade_turns #(
      .SetupCycles(SetupCycles)
    ) u_shade_setup (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .attributes_valid_i(attributes_valid_i),
      .attributes_ready_o(attributes_ready_o),
      .attributes_i      (attributes_i),
      .colours_valid_i   (setup_colours_valid),
      .colours_ready_o   (setup_colours_ready),
      .colours_i         (setup_colours),
      .planes_valid_o    (planes_valid_o),
      .planes_ready_i    (planes_ready_i),
      .planes_o          (planes_o)
    );
  end
endmodule
