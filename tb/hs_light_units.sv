// SPDX-License-Identifier: Apache-2.0
// The units of deferred lighting at the vertices, each alone, for the bench: as hs_units, which has what every configuration
// has.
//
//   triangle_setup, visible_select, shade_setup
//   light_vertex   `light` and `material` words go into its registers and memories before the normals
module hs_light_units #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2
) (
  input  logic                        rst_ni,
  input  hs_formats_pkg::x_t          frame_width_i,
  input  hs_formats_pkg::y_t          frame_height_i,

  input  logic                        triangle_setup_clk_i,
  input  logic                        triangle_setup_triangle_valid_i,
  output logic                        triangle_setup_triangle_ready_o,
  input  hs_formats_pkg::triangle_t   triangle_setup_triangle_i,
  output logic                        triangle_setup_setup_valid_o,
  input  logic                        triangle_setup_setup_ready_i,
  output hs_formats_pkg::setup_t      triangle_setup_setup_o,
  output logic                        triangle_setup_attributes_valid_o,
  input  logic                        triangle_setup_attributes_ready_i,
  output hs_formats_pkg::attributes_t triangle_setup_attributes_o,

  input  logic                        visible_select_clk_i,
  input  logic                        visible_select_attributes_valid_i,
  output logic                        visible_select_attributes_ready_o,
  input  hs_formats_pkg::attributes_t visible_select_attributes_i,
  input  logic                        visible_select_visible_valid_i,
  output logic                        visible_select_visible_ready_o,
  input  hs_formats_pkg::visible_t    visible_select_visible_i,
  output logic                        visible_select_visible_valid_o,
  input  logic                        visible_select_visible_ready_i,
  output hs_formats_pkg::visible_t    visible_select_visible_o,
  output logic                        visible_select_visible_attributes_valid_o,
  input  logic                        visible_select_visible_attributes_ready_i,
  output hs_formats_pkg::attributes_t visible_select_visible_attributes_o,

  input  logic                        light_vertex_clk_i,
  input  logic                        light_vertex_light_valid_i,
  input  hs_formats_pkg::light_t      light_vertex_light_i,
  input  logic                        light_vertex_material_valid_i,
  input  hs_formats_pkg::material_t   light_vertex_material_i,
  input  logic                        light_vertex_normals_valid_i,
  output logic                        light_vertex_normals_ready_o,
  input  hs_formats_pkg::normals_t    light_vertex_normals_i,
  output logic                        light_vertex_colours_valid_o,
  input  logic                        light_vertex_colours_ready_i,
  output hs_formats_pkg::colours_t    light_vertex_colours_o,

  input  logic                        shade_setup_clk_i,
  input  logic                        shade_setup_visible_attributes_valid_i,
  output logic                        shade_setup_visible_attributes_ready_o,
  input  hs_formats_pkg::attributes_t shade_setup_visible_attributes_i,
  input  logic                        shade_setup_colours_valid_i,
  output logic                        shade_setup_colours_ready_o,
  input  hs_formats_pkg::colours_t    shade_setup_colours_i,
  output logic                        shade_setup_planes_valid_o,
  input  logic                        shade_setup_planes_ready_i,
  output hs_formats_pkg::planes_t     shade_setup_planes_o
);
  hs_triangle_setup #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_triangle_setup (
    .clk_i             (triangle_setup_clk_i),
    .rst_ni            (rst_ni),
    .frame_width_i     (frame_width_i),
    .frame_height_i    (frame_height_i),
    .triangle_valid_i  (triangle_setup_triangle_valid_i),
    .triangle_ready_o  (triangle_setup_triangle_ready_o),
    .triangle_i        (triangle_setup_triangle_i),
    .setup_valid_o     (triangle_setup_setup_valid_o),
    .setup_ready_i     (triangle_setup_setup_ready_i),
    .setup_o           (triangle_setup_setup_o),
    .attributes_valid_o(triangle_setup_attributes_valid_o),
    .attributes_ready_i(triangle_setup_attributes_ready_i),
    .attributes_o      (triangle_setup_attributes_o)
  );

  hs_visible_select u_visible_select (
    .clk_i                     (visible_select_clk_i),
    .rst_ni                    (rst_ni),
    .attributes_valid_i        (visible_select_attributes_valid_i),
    .attributes_ready_o        (visible_select_attributes_ready_o),
    .attributes_i              (visible_select_attributes_i),
    .visible_valid_i           (visible_select_visible_valid_i),
    .visible_ready_o           (visible_select_visible_ready_o),
    .visible_i                 (visible_select_visible_i),
    .visible_valid_o           (visible_select_visible_valid_o),
    .visible_ready_i           (visible_select_visible_ready_i),
    .visible_o                 (visible_select_visible_o),
    .visible_attributes_valid_o(visible_select_visible_attributes_valid_o),
    .visible_attributes_ready_i(visible_select_visible_attributes_ready_i),
    .visible_attributes_o      (visible_select_visible_attributes_o)
  );

  hs_light_vertex #(
    .Vertices(hs_formats_pkg::Gouraud != 0 ? 3 : 1)
  ) u_light_vertex (
    .clk_i           (light_vertex_clk_i),
    .rst_ni          (rst_ni),
    .light_valid_i   (light_vertex_light_valid_i),
    .light_i         (light_vertex_light_i),
    .material_valid_i(light_vertex_material_valid_i),
    .material_i      (light_vertex_material_i),
    .normals_valid_i (light_vertex_normals_valid_i),
    .normals_ready_o (light_vertex_normals_ready_o),
    .normals_i       (light_vertex_normals_i),
    .colours_valid_o (light_vertex_colours_valid_o),
    .colours_ready_i (light_vertex_colours_ready_i),
    .colours_o       (light_vertex_colours_o)
  );

  hs_shade_setup u_shade_setup (
    .clk_i             (shade_setup_clk_i),
    .rst_ni            (rst_ni),
    .attributes_valid_i(shade_setup_visible_attributes_valid_i),
    .attributes_ready_o(shade_setup_visible_attributes_ready_o),
    .attributes_i      (shade_setup_visible_attributes_i),
    .colours_valid_i   (shade_setup_colours_valid_i),
    .colours_ready_o   (shade_setup_colours_ready_o),
    .colours_i         (shade_setup_colours_i),
    .planes_valid_o    (shade_setup_planes_valid_o),
    .planes_ready_i    (shade_setup_planes_ready_i),
    .planes_o          (shade_setup_planes_o)
  );
endmodule
