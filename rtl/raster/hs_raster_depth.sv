// SPDX-License-Identifier: Apache-2.0
// The depth plane of hs_raster_pineda: the depths of the stamp where the walk stands.
//
// Load takes the setup; the depths are there one cycle after a move. Modulo 2^PlaneBits.
module hs_raster_depth #(
  parameter int unsigned DepthBits,
  parameter int unsigned PlaneBits,
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY
) (
  input  logic                       clk_i,

  // From triangle_setup, taken on Load: the plane at the first pixel, its steps of a pixel
  input  logic [PlaneBits-1:0]       depth_i,
  input  logic [PlaneBits-1:0]       dx_i,
  input  logic [PlaneBits-1:0]       dy_i,

  // From hs_raster_pineda: see hs_raster_walk
  input  logic [5:0]                 move_i,
  input  logic                       keep_left_i,
  input  logic                       keep_below_i,

  output logic [Lanes*DepthBits-1:0] depth_o
);
  logic [PlaneBits-1:0] dx_q, dy_q, at;
  logic [PlaneBits-1:0] unused_right, unused_left, unused_below;

  always_ff @(posedge clk_i) begin
    if (move_i[0]) begin
      dx_q <= dx_i;
      dy_q <= dy_i;
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

    assign offset_x = (Column % 2 != 0 ? dx_i : '0) + (Column / 2 != 0 ? dx_i << 1 : '0);
    assign offset_y = (Row % 2 != 0 ? dy_i : '0) + (Row / 2 != 0 ? dy_i << 1 : '0);
    always_ff @(posedge clk_i) begin
      if (move_i[0]) offset_q <= offset_x + offset_y;
    end
    assign depth = at + offset_q;
    assign unused_fraction = ^depth[PlaneBits-DepthBits-1:0];
    assign depth_o[lane*DepthBits +: DepthBits] = depth[PlaneBits-1 -: DepthBits];
  end
endmodule
