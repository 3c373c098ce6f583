// SPDX-License-Identifier: Apache-2.0
// The units of lighting, each alone, for the bench: as hs_units, which has what every configuration has.
//
//   light_vertex   `light` and `material` words go into its registers and memories before the normals
module hs_light_units #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2
) (
  input  logic                        rst_ni,

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
  output hs_formats_pkg::colours_t    light_vertex_colours_o
);
  if (LanesX * LanesY > 16) begin : gen_lanes_illegal
    $error("hs_light_units: no unit here has lanes, and a stamp 16 at most");
  end

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
endmodule
