// SPDX-License-Identifier: Apache-2.0
// The depths of hs_ztest_plane: the stored ones, computed again from planes, against those of the
// stamp; and the plane of the triangle that is tested, as TdbV keeps it.
//
// A slot of hs_ztest_plane comes in with its plane and leaves five cycles later, of those in which
// go_i is 1. A slot that begins a triangle brings its plane, {index, x, y, depth,
// dx, dy}, and takes it back from its stamp to pixel (0, 0), with the same two multipliers:
// depth − dx·x − dy·y. A stamp's depths come in before its slots, StampsInFlight stamps at most.
module hs_ztest_recall #(
  parameter int unsigned DepthBits,
  parameter int unsigned PlaneBits,
  parameter int unsigned StampsInFlight,
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles),
  localparam int unsigned TriangleDepthBits = IndexBits + XBits + YBits + 3 * PlaneBits
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         go_i,

  input  logic                         stamp_i,  // depths come
  input  logic [Lanes*DepthBits-1:0]   stamp_depth_i,

  // A slot comes in
  input  logic                         begins_i,  // its triangle, and brings its plane
  input  logic [TriangleDepthBits-1:0] plane_i,
  input  logic [3*PlaneBits-1:0]       fetch_plane_i,
  input  hs_formats_pkg::x_t           x_i,  // of the stamp
  input  hs_formats_pkg::y_t           y_i,

  // A slot leaves
  input  logic                         begun_i,       // the one that begins a triangle
  input  logic                         done_i,        // the last one of its stamp
  input  logic [Lanes-1:0]             background_i,  // these lanes have nothing stored
  output logic [Lanes-1:0]             nearer_o,      // less than what is stored

  // Of the triangle that has begun last, from the next cycle on
  output logic [EntryBits-1:0]         entry_o,  // index − 1
  output logic [3*PlaneBits-1:0]       plane_o
);
  // A slot that begins a triangle is followed by another one, so five places hold three.
  localparam int unsigned TrianglesInFlight = 3;

  // --- Operands ---
  hs_formats_pkg::index_t index;
  logic [EntryBits-1:0] entry, entry_q, begun_entry;
  hs_formats_pkg::x_t x;
  hs_formats_pkg::y_t y;
  logic [PlaneBits-1:0] depth, dx, dy, begun_dx, begun_dy, first, origin_q, dx_q, dy_q;
  logic [Lanes*DepthBits-1:0] stored, stamp_depth;
  logic unused_index, unused_room, unused_word, unused_depth_room, unused_depth_word;

  assign {index, x, y, depth, dx, dy} = plane_i;
  assign entry = EntryBits'(index) - EntryBits'(1);
  assign unused_index = index[IndexBits-1];  // Triangles may be a power of two

  hs_plane_lanes #(
    .PlaneBits(PlaneBits),
    .ValueBits(DepthBits),
    .LanesX   (LanesX),
    .LanesY   (LanesY)
  ) u_lanes (
    .clk_i     (clk_i),
    .en_i      (go_i),
    .plane_i   (begins_i ? depth : fetch_plane_i[2*PlaneBits +: PlaneBits]),
    .plane_dx_i(begins_i ? -dx : fetch_plane_i[PlaneBits +: PlaneBits]),
    .plane_dy_i(begins_i ? -dy : fetch_plane_i[0 +: PlaneBits]),
    .x_i       (begins_i ? x : x_i),
    .y_i       (begins_i ? y : y_i),
    .first_o   (first),
    .value_o   (stored)
  );

  // --- The triangle that is tested ---
  hs_fifo #(
    .Width(EntryBits + 2 * PlaneBits),
    .Depth(TrianglesInFlight + 1)
  ) u_triangles (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (begins_i && go_i),
    .in_ready_o (unused_room),
    .in_i       ({entry, dx, dy}),
    .out_valid_o(unused_word),
    .out_ready_i(begun_i && go_i),
    .out_o      ({begun_entry, begun_dx, begun_dy})
  );

  always_ff @(posedge clk_i) begin
    if (begun_i && go_i) begin
      entry_q <= begun_entry;
      origin_q <= first;
      dx_q <= begun_dx;
      dy_q <= begun_dy;
    end
  end

  assign entry_o = entry_q;
  assign plane_o = {origin_q, dx_q, dy_q};

  // --- Its depths ---
  hs_fifo #(
    .Width(Lanes * DepthBits),
    .Depth(StampsInFlight + 1)
  ) u_depths (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (stamp_i),
    .in_ready_o (unused_depth_room),
    .in_i       (stamp_depth_i),
    .out_valid_o(unused_depth_word),
    .out_ready_i(done_i && go_i),
    .out_o      (stamp_depth)
  );

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    logic [DepthBits-1:0] farther;
    assign farther = background_i[lane] ? '1 : stored[lane*DepthBits +: DepthBits];
    assign nearer_o[lane] = stamp_depth[lane*DepthBits +: DepthBits] < farther;
  end
endmodule
