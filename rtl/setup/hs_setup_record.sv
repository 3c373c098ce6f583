// SPDX-License-Identifier: Apache-2.0
// The records of a triangle whose edges are known, with what its planes need: 1 / D, and the depth
// plane, where there is depth.
//
// The record waits in a register, so that the next triangle's edges and division follow. It is
// taken when the division is done, or at once if empty. Fork: setup and attributes each stay until
// taken, and the next record waits for both; attributes come not at all for an empty triangle,
// unless it is the last, or all are asked for (hs_visible_select). Without depth the setup is
// offered with the attributes.
module hs_setup_record #(
  parameter int unsigned Fraction,  // r, of the reciprocal
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned Gouraud = hs_formats_pkg::Gouraud,
  localparam int unsigned DepthsBits = HasDepth != 0 ? 3 * hs_formats_pkg::DepthBits : 1,
  localparam int unsigned SendsShape = hs_formats_pkg::SendsShape,
  localparam int unsigned ColourBits = hs_formats_pkg::TriangleColourBits,
  localparam int unsigned OrderBits = hs_formats_pkg::OrderBits,
  localparam int unsigned ShadeBits = OrderBits + ColourBits != 0 ? OrderBits + ColourBits : 1
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // From hs_edge_setup: D; then all the rest of the triangle
  input  logic                        area_valid_i,
  output logic                        area_ready_o,
  input  hs_formats_pkg::area_t       area_i,
  input  logic                        edge_valid_i,
  output logic                        edge_ready_o,
  input  hs_formats_pkg::setup_t      setup_i,
  input  hs_formats_pkg::coord_t      x0_i,
  input  hs_formats_pkg::coord_t      y0_i,
  input  hs_formats_pkg::delta_t      dx1_i,
  input  hs_formats_pkg::delta_t      dy1_i,
  input  hs_formats_pkg::delta_t      dx2_i,
  input  hs_formats_pkg::delta_t      dy2_i,
  input  hs_formats_pkg::delta_t      x_i,
  input  hs_formats_pkg::delta_t      y_i,
  input  logic [DepthsBits-1:0]       depths_i,
  input  logic [ShadeBits-1:0]        shade_i,  // {first, turned, colours}

  // To raster_pineda
  output logic                        setup_valid_o,
  input  logic                        setup_ready_i,
  output hs_formats_pkg::setup_t      setup_o,

  // To shade_setup
  output logic                        attributes_valid_o,
  input  logic                        attributes_ready_i,
  output hs_formats_pkg::attributes_t attributes_o
);
  localparam int unsigned ShiftBits = hs_formats_pkg::ShiftBits;

  // --- 1 / D ---
  logic reciprocal_valid, reciprocal_ready;
  logic [ShiftBits-1:0] shift, shift_q;
  logic [Fraction:0] reciprocal, reciprocal_q;

  hs_reciprocal #(
    .Fraction(Fraction)
  ) u_reciprocal (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .area_valid_i      (area_valid_i),
    .area_ready_o      (area_ready_o),
    .area_i            (area_i),
    .reciprocal_valid_o(reciprocal_valid),
    .reciprocal_ready_i(reciprocal_ready),
    .shift_o           (shift),
    .reciprocal_o      (reciprocal)
  );

  // --- The record: all but the depth plane ---
  logic free, take;
  logic plane_job_q, setup_pending_q, attributes_valid_q;  // Still to come or to be taken
  logic plane_ready;
  hs_formats_pkg::setup_t setup_q;
  hs_formats_pkg::delta_t dx1_q, dy1_q, dx2_q, dy2_q;
  logic [ShadeBits-1:0] shade_q;

  assign free = (!setup_pending_q || (setup_valid_o && setup_ready_i))
                && (!attributes_valid_q || attributes_ready_i);
  assign edge_ready_o = free && (setup_i.empty || reciprocal_valid);
  assign reciprocal_ready = free && edge_valid_i && !setup_i.empty;
  assign take = edge_valid_i && edge_ready_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      plane_job_q <= 1'b0;
      setup_pending_q <= 1'b0;
      attributes_valid_q <= 1'b0;
    end else if (take) begin
      plane_job_q <= 1'b1;
      setup_pending_q <= 1'b1;
      attributes_valid_q <= !setup_i.empty || setup_i.last || hs_formats_pkg::Deferred != 0;
    end else begin
      if (plane_ready) plane_job_q <= 1'b0;
      if (setup_valid_o && setup_ready_i) setup_pending_q <= 1'b0;
      if (attributes_ready_i) attributes_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      setup_q <= setup_i;
      shade_q <= shade_i;
      dx1_q <= dx1_i;
      dy1_q <= dy1_i;
      dx2_q <= dx2_i;
      dy2_q <= dy2_i;
      shift_q <= setup_i.empty ? '0 : shift;
      reciprocal_q <= setup_i.empty ? '0 : reciprocal;
    end
  end

  // --- To raster_pineda, with the depth plane ---
  if (HasDepth != 0) begin : gen_depth
    localparam int unsigned DepthBits = hs_formats_pkg::DepthBits;
    localparam int unsigned PlaneBits = hs_formats_pkg::DepthPlaneBits;
    logic [DepthBits-1:0] depth0_q, depth1_q, depth2_q;
    hs_formats_pkg::delta_t x_q, y_q;
    // 18-bit factors, one of them the sign: the multipliers of FPGAs. Longer where two are too few;
    // shorter where 16 are enough, as small FPGAs have them.
    localparam int unsigned FactorBits =
        hs_formats_pkg::ReciprocalBits > hs_formats_pkg::DeltaBits - 1 ?
        hs_formats_pkg::ReciprocalBits : hs_formats_pkg::DeltaBits - 1;
    localparam int unsigned Chunk =
        FactorBits > 34 ? (FactorBits + 1) / 2 : FactorBits < 16 ? FactorBits : 17;
    logic [PlaneBits-1:0] depth;
    logic signed [PlaneBits-1:0] depth_dx, depth_dy;

    always_ff @(posedge clk_i) begin
      if (take) begin
        {depth0_q, depth1_q, depth2_q} <= depths_i;
        x_q <= x_i;
        y_q <= y_i;
      end
    end

    hs_plane_setup #(
      .ValueBits(DepthBits),
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
      .dx1_i       (dx1_q),
      .dy1_i       (dy1_q),
      .dx2_i       (dx2_q),
      .dy2_i       (dy2_q),
      .shift_i     (shift_q),
      .reciprocal_i(reciprocal_q),
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
  end else begin : gen_no_depth
    logic unused_depth;
    assign unused_depth = ^{plane_job_q, depths_i, x_i, y_i};
    assign plane_ready = 1'b1;
    assign setup_valid_o = setup_pending_q;
    assign setup_o = setup_q;
  end

  // --- To shade_setup ---
  assign attributes_valid_o = attributes_valid_q;
  assign attributes_o.last = setup_q.last;
  assign attributes_o.empty = setup_q.empty;
  assign attributes_o.index = setup_q.index;

  if (SendsShape != 0) begin : gen_shape
    hs_formats_pkg::coord_t x0_q, y0_q;

    always_ff @(posedge clk_i) begin
      if (take) begin
        x0_q <= x0_i;
        y0_q <= y0_i;
      end
    end

    assign attributes_o.x = x0_q;
    assign attributes_o.y = y0_q;
    assign attributes_o.dx1 = dx1_q;
    assign attributes_o.dy1 = dy1_q;
    assign attributes_o.dx2 = dx2_q;
    assign attributes_o.dy2 = dy2_q;
    assign attributes_o.shift = shift_q;
    assign attributes_o.reciprocal = reciprocal_q;
  end else begin : gen_no_shape
    logic unused_position;
    assign unused_position = ^{x0_i, y0_i};
  end

  if (OrderBits != 0) begin : gen_order
    assign {attributes_o.first, attributes_o.turned} = shade_q[ColourBits +: OrderBits];
  end
  if (ColourBits != 0 && Gouraud != 0) begin : gen_gouraud
    assign {attributes_o.r0, attributes_o.r1, attributes_o.r2,
            attributes_o.g0, attributes_o.g1, attributes_o.g2,
            attributes_o.b0, attributes_o.b1, attributes_o.b2} = shade_q[0 +: ColourBits];
  end else if (ColourBits != 0) begin : gen_flat
    assign {attributes_o.r, attributes_o.g, attributes_o.b} = shade_q[0 +: ColourBits];
  end else if (OrderBits == 0) begin : gen_nothing
    logic unused_shade;
    assign unused_shade = ^shade_q;
  end
endmodule
