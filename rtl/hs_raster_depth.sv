// SPDX-License-Identifier: Apache-2.0
// The depth plane of hs_raster_pineda: the depths of the stamp where the walk stands.
//
// Load takes the setup; the depths are there one cycle after a move. Modulo 2^DepthPlaneBits.
module hs_raster_depth #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits
) (
  input  logic                            clk_i,

  // From triangle_setup, taken on Load: the plane at the first pixel, its steps of a pixel
  input  hs_formats_pkg::depth_plane_t    depth_i,
  input  hs_formats_pkg::depth_gradient_t depth_dx_i,
  input  hs_formats_pkg::depth_gradient_t depth_dy_i,

  // From hs_raster_pineda: see hs_raster_walk
  input  logic [5:0]                      move_i,
  input  logic                            keep_left_i,
  input  logic                            keep_below_i,

  output logic [Lanes*DepthBits-1:0]      depth_o
);
  localparam int unsigned PlaneBits = hs_formats_pkg::DepthPlaneBits;

  logic [PlaneBits-1:0] dx, dy, dx_q, dy_q, at;
  logic [PlaneBits-1:0] unused_right, unused_left, unused_below;

  assign dx = depth_dx_i;
  assign dy = depth_dy_i;

  always_ff @(posedge clk_i) begin
    if (move_i[0]) begin
      dx_q <= dx;
      dy_q <= dy;
    end
  end

  hs_raster_walk #(
    .Width(PlaneBits)
  ) u_walk (
    .clk_i       (clk_i),
    .start_i     (depth_i),
    .step_x_i    (dx_q << $clog2(LanesX)),
    .step_y_i    (dy_q << $clog2(LanesY)),
    .move_i      (move_i),
    .keep_left_i (keep_left_i),
    .keep_below_i(keep_below_i),
    .at_o        (at),
    .right_o     (unused_right),
    .left_o      (unused_left),
    .below_o     (unused_below)
  );

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    localparam int unsigned Column = lane % LanesX;
    localparam int unsigned Row = lane / LanesX;
    logic [PlaneBits-1:0] offset_x, offset_y, offset_q, depth;
    logic unused_fraction;

    assign offset_x = (Column % 2 != 0 ? dx : '0) + (Column / 2 != 0 ? dx << 1 : '0);
    assign offset_y = (Row % 2 != 0 ? dy : '0) + (Row / 2 != 0 ? dy << 1 : '0);
    always_ff @(posedge clk_i) begin
      if (move_i[0]) offset_q <= offset_x + offset_y;
    end
    assign depth = at + offset_q;
    assign unused_fraction = ^depth[PlaneBits-DepthBits-1:0];
    assign depth_o[lane*DepthBits +: DepthBits] = depth[PlaneBits-1 -: DepthBits];
  end
endmodule
