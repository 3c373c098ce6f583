// SPDX-License-Identifier: Apache-2.0
// One edge function of hs_raster_pineda: is the stamp near, and which of its pixels lie inside?
//
// What walks is the function at the pixel of the stamp where it is largest: the stamp is near when
// that is >= 0, so a step and the test after it are one addition. Load takes the setup; all outputs
// speak of the stamp where the walk stands, one cycle after a move.
module hs_raster_edge #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY
) (
  input  logic                       clk_i,

  // From triangle_setup, taken on Load: the function at the first pixel, its steps of a pixel
  input  hs_formats_pkg::edge_step_t e_i,
  input  hs_formats_pkg::delta_t     e_dx_i,
  input  hs_formats_pkg::delta_t     e_dy_i,

  // From hs_raster_pineda: see hs_raster_walk
  input  logic [5:0]                 move_i,
  input  logic                       keep_left_i,
  input  logic                       keep_below_i,

  output logic                       near_o,
  output logic                       near_right_o,
  output logic                       near_left_o,
  output logic                       near_below_o,
  output logic                       rises_right_o,
  output logic                       rises_left_o,
  output logic [Lanes-1:0]           inside_o
);
  localparam int unsigned DeltaBits = hs_formats_pkg::DeltaBits;
  localparam int unsigned EdgeBits = hs_formats_pkg::EdgeStepBits;
  // |c·dx + r·dy| < (LanesX − 1 + LanesY − 1)·2^CoordBits
  localparam int unsigned OffsetBits = DeltaBits + $clog2(LanesX + LanesY - 1);
  localparam int unsigned OffsetSpare = OffsetBits - DeltaBits;
  localparam int unsigned EdgeSpare = EdgeBits - DeltaBits;

  hs_formats_pkg::delta_t e_dx_q, e_dy_q;
  logic rises_right_q, rises_left_q;
  logic [OffsetBits-1:0] dx, dy, reach_x, reach_y, reach;  // of the setup on load
  logic [EdgeBits-1:0] at, right, left, below;

  assign rises_right_o = rises_right_q;
  assign rises_left_o = rises_left_q;

  assign dx = {{OffsetSpare + 1{e_dx_i[DeltaBits-1]}}, e_dx_i[DeltaBits-2:0]};
  assign dy = {{OffsetSpare + 1{e_dy_i[DeltaBits-1]}}, e_dy_i[DeltaBits-2:0]};

  // From the first pixel of a stamp to its largest: LanesX − 1 and LanesY − 1 are 0, 1 or 3.
  assign reach_x = e_dx_i[DeltaBits-1] ? '0 : (LanesX > 1 ? dx : '0) + (LanesX > 2 ? dx << 1 : '0);
  assign reach_y = e_dy_i[DeltaBits-1] ? '0 : (LanesY > 1 ? dy : '0) + (LanesY > 2 ? dy << 1 : '0);
  assign reach = reach_x + reach_y;

  always_ff @(posedge clk_i) begin
    if (move_i[0]) begin
      e_dx_q <= e_dx_i;
      e_dy_q <= e_dy_i;
      rises_right_q <= !e_dx_i[DeltaBits-1] && e_dx_i != '0;
      rises_left_q <= e_dx_i[DeltaBits-1];
    end
  end

  hs_raster_walk #(
    .Width(EdgeBits)
  ) u_walk (
    .clk_i       (clk_i),
    .start_i     (e_i + {{EdgeBits - OffsetBits{reach[OffsetBits-1]}}, reach}),
    .step_x_i    ({{EdgeSpare{e_dx_q[DeltaBits-1]}}, e_dx_q} << $clog2(LanesX)),
    .step_y_i    ({{EdgeSpare{e_dy_q[DeltaBits-1]}}, e_dy_q} << $clog2(LanesY)),
    .move_i      (move_i),
    .keep_left_i (keep_left_i),
    .keep_below_i(keep_below_i),
    .at_o        (at),
    .right_o     (right),
    .left_o      (left),
    .below_o     (below)
  );

  assign near_o = !at[EdgeBits-1];
  assign near_right_o = !right[EdgeBits-1];
  assign near_left_o = !left[EdgeBits-1];
  assign near_below_o = !below[EdgeBits-1];

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    localparam int unsigned Column = lane % LanesX;
    localparam int unsigned Row = lane / LanesX;
    logic [OffsetBits-1:0] offset_x, offset_y, offset_q;  // from the largest pixel to the lane's
    logic [EdgeBits-1:0] e;

    assign offset_x = (Column % 2 != 0 ? dx : '0) + (Column / 2 != 0 ? dx << 1 : '0);
    assign offset_y = (Row % 2 != 0 ? dy : '0) + (Row / 2 != 0 ? dy << 1 : '0);
    always_ff @(posedge clk_i) begin
      if (move_i[0]) offset_q <= offset_x + offset_y - reach;
    end
    assign e = at + {{EdgeBits - OffsetBits{offset_q[OffsetBits-1]}}, offset_q};
    assign inside_o[lane] = !e[EdgeBits-1];
  end
endmodule
