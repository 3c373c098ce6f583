// SPDX-License-Identifier: Apache-2.0
// The Pineda edge-function rasterizer: the stamps of a triangle that hold a covered pixel, each
// once (kernel: hls/raster/raster_pineda.hpp, which explains the walk).
//
// Interval: a visited stamp a cycle, an empty triangle one cycle, none between triangles. Latency
// from a setup to its first stamp: 3 cycles and one stamp more, as each stamp waits for the next
// one, or for the end of the triangle, which makes it `triangle_last`.
// Stall: a stamp that is not taken stops the walk once a second one waits behind it.
// Type gamma: the depth plane of a triangle is offered when its walk begins, at the earliest when
// that of the one before is taken. Else triangle_depth is one bit, 0, that is never valid.
// Limits: the frame registers are read when a setup is taken. A setup that is not empty has
// x_min <= x_start <= x_max and y_min <= y_max inside the frame.
module hs_raster_pineda #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned LanesBits = Lanes * (1 + hs_formats_pkg::DepthBits),
  localparam int unsigned StampBits = 2 + IndexBits + XBits + YBits + LanesBits,
  localparam int unsigned TestsPlanes =
      hs_formats_pkg::HasDepth != 0 && hs_formats_pkg::StoresDepth == 0 ? 1 : 0,
  localparam int unsigned TriangleDepthBits =
      TestsPlanes != 0 ? IndexBits + XBits + YBits + 3 * hs_formats_pkg::DepthPlaneBits : 1
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  hs_formats_pkg::x_t     frame_width_i,
  input  hs_formats_pkg::y_t     frame_height_i,

  // From triangle_setup
  input  logic                   setup_valid_i,
  output logic                   setup_ready_o,
  input  hs_formats_pkg::setup_t setup_i,

  // To the Z-test
  output logic                   triangle_depth_valid_o,
  input  logic                   triangle_depth_ready_i,
  output logic [TriangleDepthBits-1:0] triangle_depth_o,
  output logic                   stamp_valid_o,
  input  logic                   stamp_ready_i,
  output logic [StampBits-1:0]   stamp_o
);

  typedef enum logic [2:0] {
    ModeSearch,       // of the first near stamp of a row, direction not known yet
    ModeSearchRight,
    ModeSearchLeft,
    ModeRight,        // through the near stamps, to the right of where they were found
    ModeLeft          // then to the left
  } mode_e;

  // The triangle that is walked.
  logic active_q, last_q, empty_q;
  hs_formats_pkg::index_t index_q;
  hs_formats_pkg::x_t x_min_q, x_max_q;
  hs_formats_pkg::y_t y_max_q, y_q;

  mode_e mode_d, mode_q;
  logic left_near_q, below_near_q;
  hs_formats_pkg::x_t x, unused_x_right, unused_x_left, unused_x_below;

  logic [2:0] near, near_right, near_left, near_below, rises_right, rises_left;
  logic [3*Lanes-1:0] inside_edge;
  logic [Lanes-1:0] inside_frame, mask;
  logic [LanesBits-1:0] lane_fields;

  logic free, plane_free;  // for the next triangle: the walk, and what offers its depth plane
  logic load, visit, found, searching, can_go_right, can_go_left, want_right, want_left;
  logic go_right, go_left, go_back, row_done, triangle_done, finish, covered, hold_ready;
  logic keep_left, keep_below;
  logic [5:0] move;

  // The walk: where to go from here. Names as in the kernel.
  assign visit = active_q && hold_ready;
  assign found = &near;
  assign searching = mode_q != ModeRight && mode_q != ModeLeft;
  assign can_go_right = x != x_max_q && &near_right;
  assign can_go_left = x != x_min_q && &near_left;
  assign want_right = &(near | rises_right) && mode_q != ModeSearchLeft && x != x_max_q;
  assign want_left = &(near | rises_left) && mode_q != ModeSearchRight && x != x_min_q;

  always_comb begin
    go_right = 1'b0;
    go_left = 1'b0;
    go_back = 1'b0;
    mode_d = ModeSearch;
    if (found && mode_q != ModeLeft && can_go_right) begin
      go_right = 1'b1;
      mode_d = ModeRight;
    end else if (found && mode_q == ModeRight && left_near_q) begin
      go_back = 1'b1;
      mode_d = ModeLeft;
    end else if (found && mode_q != ModeRight && can_go_left) begin
      go_left = 1'b1;
      mode_d = ModeLeft;
    end else if (!found && want_right) begin
      go_right = 1'b1;
      mode_d = ModeSearchRight;
    end else if (!found && want_left) begin
      go_left = 1'b1;
      mode_d = ModeSearchLeft;
    end
  end

  assign row_done = !go_right && !go_left && !go_back;
  assign triangle_done = empty_q || (row_done && y_q == y_max_q);
  assign finish = visit && triangle_done;
  assign free = !active_q || finish;
  assign setup_ready_o = free && plane_free;
  assign load = setup_valid_i && setup_ready_o;

  assign keep_left = visit && found && searching;
  assign keep_below = visit && found && !below_near_q;
  assign move = load ? 6'b000001 :
      {visit && row_done && below_near_q, visit && row_done && !below_near_q,
       visit && go_back, visit && go_left, visit && go_right, 1'b0};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
    end else if (free) begin
      active_q <= load;
    end
  end

  always_ff @(posedge clk_i) begin
    if (load) begin
      mode_q <= ModeSearch;
      y_q <= setup_i.y_min;
      below_near_q <= 1'b0;
    end else if (visit) begin
      mode_q <= mode_d;
      if (row_done) y_q <= y_q + YBits'(1);
      if (row_done) below_near_q <= 1'b0;
      else if (keep_below) below_near_q <= &near_below && y_q != y_max_q;
    end
    if (keep_left) left_near_q <= can_go_left;
  end

  always_ff @(posedge clk_i) begin
    if (load) begin
      last_q <= setup_i.last;
      empty_q <= setup_i.empty;
      index_q <= setup_i.index;
      x_min_q <= setup_i.x_min;
      x_max_q <= setup_i.x_max;
      y_max_q <= setup_i.y_max;
    end
  end

  hs_raster_walk #(
    .Width(XBits)
  ) u_x (
    .clk_i       (clk_i),
    .start_i     (setup_i.x_start),
    .step_x_i    (XBits'(1)),
    .step_y_i    (XBits'(0)),
    .move_i      (move),
    .keep_left_i (keep_left),
    .keep_below_i(keep_below),
    .at_o        (x),
    .right_o     (unused_x_right),
    .left_o      (unused_x_left),
    .below_o     (unused_x_below)
  );

  for (genvar i = 0; i < 3; i++) begin : gen_edge
    hs_raster_edge #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_edge (
      .clk_i        (clk_i),
      .e_i          (i == 0 ? setup_i.e0 : i == 1 ? setup_i.e1 : setup_i.e2),
      .e_dx_i       (i == 0 ? setup_i.e0_dx : i == 1 ? setup_i.e1_dx : setup_i.e2_dx),
      .e_dy_i       (i == 0 ? setup_i.e0_dy : i == 1 ? setup_i.e1_dy : setup_i.e2_dy),
      .move_i       (move),
      .keep_left_i  (keep_left),
      .keep_below_i (keep_below),
      .near_o       (near[i]),
      .near_right_o (near_right[i]),
      .near_left_o  (near_left[i]),
      .near_below_o (near_below[i]),
      .rises_right_o(rises_right[i]),
      .rises_left_o (rises_left[i]),
      .inside_o     (inside_edge[i*Lanes +: Lanes])
    );
  end

  if (hs_formats_pkg::HasDepth != 0) begin : gen_depth
    hs_raster_depth #(
      .DepthBits(hs_formats_pkg::DepthBits),
      .PlaneBits(hs_formats_pkg::DepthPlaneBits),
      .LanesX   (LanesX),
      .LanesY   (LanesY)
    ) u_depth (
      .clk_i       (clk_i),
      .depth_i     (setup_i.depth),
      .dx_i        (setup_i.depth_dx),
      .dy_i        (setup_i.depth_dy),
      .move_i      (move),
      .keep_left_i (keep_left),
      .keep_below_i(keep_below),
      .depth_o     (lane_fields[LanesBits-Lanes-1:0])
    );
  end

  if (TestsPlanes != 0) begin : gen_plane
    hs_raster_plane #(
      .PlaneBits(hs_formats_pkg::DepthPlaneBits)
    ) u_plane (
      .clk_i   (clk_i),
      .rst_ni  (rst_ni),
      .free_o  (plane_free),
      .load_i  (load),
      .index_i (setup_i.index),
      .x_i     (setup_i.x_start),
      .y_i     (setup_i.y_min),
      .depth_i (setup_i.depth),
      .dx_i    (setup_i.depth_dx),
      .dy_i    (setup_i.depth_dy),
      .valid_o (triangle_depth_valid_o),
      .ready_i (triangle_depth_ready_i),
      .word_o  (triangle_depth_o)
    );
  end else begin : gen_no_plane
    logic unused_ready;
    assign unused_ready = triangle_depth_ready_i;
    assign plane_free = 1'b1;
    assign triangle_depth_valid_o = 1'b0;
    assign triangle_depth_o = 1'b0;
  end

  hs_raster_clip #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_clip (
    .clk_i         (clk_i),
    .load_i        (load),
    .frame_width_i (frame_width_i),
    .frame_height_i(frame_height_i),
    .x_i           (x),
    .y_i           (y_q),
    .inside_o      (inside_frame)
  );

  assign mask = inside_edge[0+:Lanes] & inside_edge[Lanes+:Lanes] & inside_edge[2*Lanes+:Lanes] &
                inside_frame;
  assign covered = visit && !empty_q && |mask;
  assign lane_fields[LanesBits-1-:Lanes] = mask;

  hs_raster_hold #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_hold (
    .clk_i        (clk_i),
    .rst_ni       (rst_ni),
    .ready_o      (hold_ready),
    .covered_i    (covered),
    .finish_i     (finish),
    .last_i       (last_q),
    .index_i      (index_q),
    .x_i          (x),
    .y_i          (y_q),
    .lanes_i      (lane_fields),
    .stamp_valid_o(stamp_valid_o),
    .stamp_ready_i(stamp_ready_i),
    .stamp_o      (stamp_o)
  );
endmodule
