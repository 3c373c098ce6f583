// SPDX-License-Identifier: Apache-2.0
// The colour planes of a triangle, for TdbS, after hls/shade_setup.hpp: red, green and blue through
// one hs_plane_setup, at the centre of pixel (0, 0).
//
// Interval: 3·(6 + 2·ReciprocalPasses) cycles, 24 in low and 30 in middle and high; 3 for an empty
// record. Latency: 40 at most. Attributes are read where they stand and taken with the last product
// that needs them: ready follows valid. Stall: all waits while planes offered are not taken.
// Fields of an empty record are 0. Flat colours go through: interval 1, latency 0.
module hs_shade_setup (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // From triangle_setup
  input  logic                        attributes_valid_i,
  output logic                        attributes_ready_o,
  input  hs_formats_pkg::attributes_t attributes_i,

  // To TdbS
  output logic                        planes_valid_o,
  input  logic                        planes_ready_i,
  output hs_formats_pkg::planes_t     planes_o
);
  typedef enum logic [1:0] {Red, Green, Blue} colour_e;

  if (hs_formats_pkg::Gouraud != 0) begin : gen_gouraud
    // A colour numerator is the wide factor: 24 bits take a distance in one pass, R in one or two.
    localparam int unsigned Chunk = 24;
    localparam int unsigned DeltaBits = hs_formats_pkg::DeltaBits;
    localparam int unsigned PlaneBits = hs_formats_pkg::ColourPlaneBits;

    colour_e in_q, out_q;

    // --- In: a colour after the other ---
    logic job_ready;
    hs_formats_pkg::colour_t v0, v1, v2;
    hs_formats_pkg::coord_t x0, y0;
    hs_formats_pkg::delta_t centre;

    assign x0 = attributes_i.x;
    assign y0 = attributes_i.y;
    assign centre = DeltaBits'(1) << (hs_formats_pkg::SubpixelBits - 1);
    assign attributes_ready_o = job_ready && in_q == Blue;

    always_comb begin
      unique case (in_q)
        Red:     {v0, v1, v2} = {attributes_i.r0, attributes_i.r1, attributes_i.r2};
        Green:   {v0, v1, v2} = {attributes_i.g0, attributes_i.g1, attributes_i.g2};
        default: {v0, v1, v2} = {attributes_i.b0, attributes_i.b1, attributes_i.b2};
      endcase
    end

    // --- Out: two colours are kept, the third completes the record ---
    logic plane_valid, plane_ready;
    logic last_q, empty_q;
    hs_formats_pkg::index_t index_q;
    logic [PlaneBits-1:0] start, r_q, g_q;
    logic signed [PlaneBits-1:0] dx, dy, r_dx_q, r_dy_q, g_dx_q, g_dy_q;

    assign plane_ready = out_q != Blue || planes_ready_i;

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        in_q <= Red;
        out_q <= Red;
      end else begin
        if (job_ready) in_q <= in_q == Red ? Green : in_q == Green ? Blue : Red;
        if (plane_valid && plane_ready) out_q <= out_q == Red ? Green : out_q == Green ? Blue : Red;
      end
    end

    // A record is taken after the one before it has left.
    always_ff @(posedge clk_i) begin
      if (attributes_ready_o) begin
        last_q <= attributes_i.last;
        empty_q <= attributes_i.empty;
        index_q <= attributes_i.index;
      end
      if (plane_valid && out_q == Red) begin
        r_q <= start;
        r_dx_q <= dx;
        r_dy_q <= dy;
      end
      if (plane_valid && out_q == Green) begin
        g_q <= start;
        g_dx_q <= dx;
        g_dy_q <= dy;
      end
    end

    hs_plane_setup #(
      .ValueBits(hs_formats_pkg::ColourBits),
      .Fraction (hs_formats_pkg::ColourFraction),
      .Chunk    (Chunk)
    ) u_plane_setup (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .valid_i     (attributes_valid_i),
      .ready_o     (job_ready),
      .empty_i     (attributes_i.empty),
      .v0_i        (v0),
      .v1_i        (v1),
      .v2_i        (v2),
      .dx1_i       (attributes_i.dx1),
      .dy1_i       (attributes_i.dy1),
      .dx2_i       (attributes_i.dx2),
      .dy2_i       (attributes_i.dy2),
      .shift_i     (attributes_i.shift),
      .reciprocal_i(attributes_i.reciprocal),
      .x_i         (DeltaBits'(x0) - centre),
      .y_i         (DeltaBits'(y0) - centre),
      .valid_o     (plane_valid),
      .ready_i     (plane_ready),
      .start_o     (start),
      .dx_o        (dx),
      .dy_o        (dy)
    );

    assign planes_valid_o = plane_valid && out_q == Blue;
    always_comb begin
      planes_o.last = last_q;
      planes_o.empty = empty_q;
      planes_o.index = index_q;
      planes_o.r = r_q;
      planes_o.r_dx = r_dx_q;
      planes_o.r_dy = r_dy_q;
      planes_o.g = g_q;
      planes_o.g_dx = g_dx_q;
      planes_o.g_dy = g_dy_q;
      planes_o.b = start;
      planes_o.b_dx = dx;
      planes_o.b_dy = dy;
    end
  end else begin : gen_flat
    logic unused_clock;
    assign unused_clock = ^{clk_i, rst_ni};
    assign attributes_ready_o = planes_ready_i;
    assign planes_valid_o = attributes_valid_i;
    assign planes_o = attributes_i;  // Field by field the same
  end
endmodule
