// SPDX-License-Identifier: Apache-2.0
// Triangle setup, after hls/triangle_setup.hpp: edge functions, bounding box, the reciprocal of the
// area and the depth plane, in three units that work on three triangles at once:
//
//   triangle ─► hs_edge_setup ─┬── D ──► hs_reciprocal ─► record ─┬─► hs_plane_setup ─► setup
//                              └────────────────────────────┘     └──────────────► attributes
//
// Interval: ReciprocalFraction + 3 cycles, those of the division; 3 for an empty triangle, 7 if its
// box is not empty. Latency: at most 45 cycles more. A triangle is taken after it was looked at:
// ready follows valid. Fork: setup and attributes each stay until taken, and the next record waits
// for both. Attributes come when the division is done, and not at all for an empty triangle, unless
// it is the last. Fields of an empty record are 0. LanesX and LanesY are powers of two.
module hs_triangle_setup #(
  parameter int unsigned LanesX = 1,
  parameter int unsigned LanesY = 1
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  hs_formats_pkg::x_t          frame_width_i,
  input  hs_formats_pkg::y_t          frame_height_i,

  // From geometry
  input  logic                        triangle_valid_i,
  output logic                        triangle_ready_o,
  input  hs_formats_pkg::triangle_t   triangle_i,

  // To raster_pineda
  output logic                        setup_valid_o,
  input  logic                        setup_ready_i,
  output hs_formats_pkg::setup_t      setup_o,

  // To shade_setup
  output logic                        attributes_valid_o,
  input  logic                        attributes_ready_i,
  output hs_formats_pkg::attributes_t attributes_o
);
  // 18-bit factors, one of them the sign: the multipliers of FPGAs.
  localparam int unsigned Chunk = 17;

  // --- Order, D, box and edges ---
  logic edge_valid, edge_ready;
  logic area_valid, area_ready;
  hs_formats_pkg::area_t area;
  hs_formats_pkg::setup_t edge_setup;
  hs_formats_pkg::attributes_t edge_attributes;
  hs_formats_pkg::depth_t edge_depth0, edge_depth1, edge_depth2;
  hs_formats_pkg::delta_t edge_x, edge_y;

  hs_edge_setup #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_edge_setup (
    .clk_i           (clk_i),
    .rst_ni          (rst_ni),
    .frame_width_i   (frame_width_i),
    .frame_height_i  (frame_height_i),
    .triangle_valid_i(triangle_valid_i),
    .triangle_ready_o(triangle_ready_o),
    .triangle_i      (triangle_i),
    .area_valid_o    (area_valid),
    .area_ready_i    (area_ready),
    .area_o          (area),
    .edge_valid_o    (edge_valid),
    .edge_ready_i    (edge_ready),
    .setup_o         (edge_setup),
    .attributes_o    (edge_attributes),
    .depth0_o        (edge_depth0),
    .depth1_o        (edge_depth1),
    .depth2_o        (edge_depth2),
    .x_o             (edge_x),
    .y_o             (edge_y)
  );

  // --- 1 / D ---
  logic reciprocal_valid, reciprocal_ready;
  hs_formats_pkg::shift_t shift;
  hs_formats_pkg::reciprocal_t reciprocal;

  hs_reciprocal u_reciprocal (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .area_valid_i      (area_valid),
    .area_ready_o      (area_ready),
    .area_i            (area),
    .reciprocal_valid_o(reciprocal_valid),
    .reciprocal_ready_i(reciprocal_ready),
    .shift_o           (shift),
    .reciprocal_o      (reciprocal)
  );

  // --- The record: all but the depth plane ---
  logic free, take;
  logic plane_job_q, setup_pending_q, attributes_valid_q;  // Still to come or to be taken
  hs_formats_pkg::setup_t setup_q;
  hs_formats_pkg::attributes_t attributes_q;
  hs_formats_pkg::depth_t depth0_q, depth1_q, depth2_q;
  hs_formats_pkg::delta_t x_q, y_q;
  logic plane_ready;

  assign free = (!setup_pending_q || (setup_valid_o && setup_ready_i))
                && (!attributes_valid_q || attributes_ready_i);
  assign edge_ready = free && (edge_setup.empty || reciprocal_valid);
  assign reciprocal_ready = free && edge_valid && !edge_setup.empty;
  assign take = edge_valid && edge_ready;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      plane_job_q <= 1'b0;
      setup_pending_q <= 1'b0;
      attributes_valid_q <= 1'b0;
    end else if (take) begin
      plane_job_q <= 1'b1;
      setup_pending_q <= 1'b1;
      attributes_valid_q <= !edge_setup.empty || edge_setup.last;
    end else begin
      if (plane_ready) plane_job_q <= 1'b0;
      if (setup_valid_o && setup_ready_i) setup_pending_q <= 1'b0;
      if (attributes_ready_i) attributes_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      setup_q <= edge_setup;
      attributes_q <= edge_attributes;
      attributes_q.shift <= shift;
      attributes_q.reciprocal <= reciprocal;
      depth0_q <= edge_depth0;
      depth1_q <= edge_depth1;
      depth2_q <= edge_depth2;
      x_q <= edge_x;
      y_q <= edge_y;
      if (edge_setup.empty) begin
        setup_q <= '0;
        setup_q.last <= edge_setup.last;
        setup_q.empty <= 1'b1;
        setup_q.index <= edge_setup.index;
        attributes_q <= '0;
        attributes_q.last <= edge_setup.last;
        attributes_q.empty <= 1'b1;
        attributes_q.index <= edge_setup.index;
      end
    end
  end

  // --- The depth plane ---
  hs_formats_pkg::depth_plane_t depth;
  hs_formats_pkg::depth_gradient_t depth_dx, depth_dy;

  hs_plane_setup #(
    .ValueBits(hs_formats_pkg::DepthBits),
    .Fraction (hs_formats_pkg::DepthFraction),
    .Chunk    (Chunk)
  ) u_plane_setup (
    .clk_i       (clk_i),
    .rst_ni      (rst_ni),
    .valid_i     (plane_job_q),
    .ready_o     (plane_ready),
    .empty_i     (setup_q.empty),
    .v0_i        (depth0_q),
    .v1_i        (depth1_q),
    .v2_i        (depth2_q),
    .dx1_i       (attributes_q.dx1),
    .dy1_i       (attributes_q.dy1),
    .dx2_i       (attributes_q.dx2),
    .dy2_i       (attributes_q.dy2),
    .shift_i     (attributes_q.shift),
    .reciprocal_i(attributes_q.reciprocal),
    .x_i         (x_q),
    .y_i         (y_q),
    .valid_o     (setup_valid_o),
    .ready_i     (setup_ready_i),
    .start_o     (depth),
    .dx_o        (depth_dx),
    .dy_o        (depth_dy)
  );

  always_comb begin
    setup_o = setup_q;
    setup_o.depth = depth;
    setup_o.depth_dx = depth_dx;
    setup_o.depth_dy = depth_dy;
  end

  assign attributes_valid_o = attributes_valid_q;
  assign attributes_o = attributes_q;
endmodule
