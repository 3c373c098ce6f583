// SPDX-License-Identifier: Apache-2.0
// The colour planes of a triangle, for TdbS, after hls/shade_setup.hpp: red, green and blue through
// hs_channel_planes.
//
// Interval: 24 cycles in low and 30 in middle and high; 3 for an empty record. Latency, ready and
// stalls are those of hs_channel_planes. Fields of an empty record are 0. Flat colours go through:
// interval 1, latency 0.
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
  if (hs_formats_pkg::Gouraud != 0) begin : gen_gouraud
    localparam int unsigned PlaneBits = hs_formats_pkg::ColourPlaneBits;

    logic last_q, empty_q;
    hs_formats_pkg::index_t index_q;
    logic [9*PlaneBits-1:0] planes;

    // A record is taken after the one before it has left.
    always_ff @(posedge clk_i) begin
      if (attributes_ready_o) begin
        last_q <= attributes_i.last;
        empty_q <= attributes_i.empty;
        index_q <= attributes_i.index;
      end
    end

    hs_channel_planes #(
      .ValueBits(hs_formats_pkg::ColourBits),
      .Fraction (hs_formats_pkg::ColourFraction)
    ) u_planes (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .valid_i     (attributes_valid_i),
      .ready_o     (attributes_ready_o),
      .empty_i     (attributes_i.empty),
      .values_i    ({attributes_i.r0, attributes_i.r1, attributes_i.r2,
                     attributes_i.g0, attributes_i.g1, attributes_i.g2,
                     attributes_i.b0, attributes_i.b1, attributes_i.b2}),
      .x_i         (attributes_i.x),
      .y_i         (attributes_i.y),
      .dx1_i       (attributes_i.dx1),
      .dy1_i       (attributes_i.dy1),
      .dx2_i       (attributes_i.dx2),
      .dy2_i       (attributes_i.dy2),
      .shift_i     (attributes_i.shift),
      .reciprocal_i(attributes_i.reciprocal),
      .valid_o     (planes_valid_o),
      .ready_i     (planes_ready_i),
      .planes_o    (planes)
    );

    assign planes_o = {last_q, empty_q, index_q, planes};
  end else begin : gen_flat
    logic unused_clock;
    assign unused_clock = ^{clk_i, rst_ni};
    assign attributes_ready_o = planes_ready_i;
    assign planes_valid_o = attributes_valid_i;
    assign planes_o = attributes_i;  // Field by field the same
  end
endmodule
