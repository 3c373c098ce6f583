// SPDX-License-Identifier: Apache-2.0
// The colour planes of a triangle, for TdbS, after hls/setup/shade_setup.hpp: red, green and blue
// through hs_channel_planes.
//
// Interval: 24 cycles in low and 30 in middle and high; 3 for an empty record. Latency, ready and
// stalls are those of hs_channel_planes. Fields of an empty record are 0. Flat colours go through:
// interval 1, latency 0.
// With lighting, colours come from light_vertex, in the order of the attributes, and not for empty
// ones; the two are taken together. Else `colours` has no bit that counts, and is never taken.
module hs_shade_setup #(
  localparam int unsigned Lit = hs_formats_pkg::Lights != 0 ? 1 : 0,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned ColoursBits = hs_formats_pkg::ColoursWordBits,
  localparam int unsigned PlanesBits = hs_formats_pkg::PlanesWordBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // From triangle_setup or visible_select
  input  logic                        attributes_valid_i,
  output logic                        attributes_ready_o,
  input  hs_formats_pkg::attributes_t attributes_i,

  // From light_vertex
  input  logic                        colours_valid_i,
  output logic                        colours_ready_o,
  input  logic [ColoursBits-1:0]      colours_i,

  // To TdbS
  output logic                        planes_valid_o,
  input  logic                        planes_ready_i,
  output logic [PlanesBits-1:0]       planes_o
);
  logic valid, ready, unused_attributes;

  assign unused_attributes = ^attributes_i;  // the order of vertices, for others
  if (Lit != 0) begin : gen_join
    assign valid = attributes_valid_i && (attributes_i.empty || colours_valid_i);
    assign colours_ready_o = valid && ready && !attributes_i.empty;
  end else begin : gen_no_join
    logic unused_colours;
    assign unused_colours = ^{colours_valid_i, colours_i};
    assign valid = attributes_valid_i;
    assign colours_ready_o = 1'b0;
  end
  assign attributes_ready_o = valid && ready;

  if (hs_formats_pkg::Gouraud != 0) begin : gen_gouraud
    localparam int unsigned PlaneBits = hs_formats_pkg::ColourPlaneBits;

    logic last_q, empty_q;
    hs_formats_pkg::index_t index_q;
    logic [9*ColourBits-1:0] values;  // Three channels, each {vertex 0, 1, 2}
    logic [9*PlaneBits-1:0] planes;

    if (Lit != 0) begin : gen_order
      logic unused_head;
      assign unused_head = ^colours_i[ColoursBits-1:9*ColourBits];
      for (genvar c = 0; c < 3; c++) begin : gen_channel
        hs_attribute_order #(
          .Bits(ColourBits)
        ) u_order (
          .first_i (attributes_i.first),
          .turned_i(attributes_i.turned),
          .given_i (colours_i[3*c*ColourBits +: 3*ColourBits]),
          .values_o(values[3*c*ColourBits +: 3*ColourBits])
        );
      end
    end else begin : gen_given
      assign values = {attributes_i.r0, attributes_i.r1, attributes_i.r2,
                       attributes_i.g0, attributes_i.g1, attributes_i.g2,
                       attributes_i.b0, attributes_i.b1, attributes_i.b2};
    end

    // A record is taken after the one before it has left.
    always_ff @(posedge clk_i) begin
      if (attributes_ready_o) begin
        last_q <= attributes_i.last;
        empty_q <= attributes_i.empty;
        index_q <= attributes_i.index;
      end
    end

    hs_channel_planes #(
      .ValueBits(ColourBits),
      .Fraction (hs_formats_pkg::ColourFraction)
    ) u_planes (
      .clk_i       (clk_i),
      .rst_ni      (rst_ni),
      .valid_i     (valid),
      .ready_o     (ready),
      .empty_i     (attributes_i.empty),
      .values_i    (values),
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
    logic [3*ColourBits-1:0] colour;
    logic unused_clock;
    assign unused_clock = ^{clk_i, rst_ni};

    if (Lit != 0) begin : gen_lit
      logic unused_head;
      assign unused_head = ^colours_i[ColoursBits-1:3*ColourBits];
      assign colour = attributes_i.empty ? '0 : colours_i[3*ColourBits-1:0];
    end else if (hs_formats_pkg::TriangleColourBits != 0) begin : gen_given
      assign colour = {attributes_i.r, attributes_i.g, attributes_i.b};
    end else begin : gen_nothing  // of a configuration without this unit
      assign colour = '0;
    end
    assign ready = planes_ready_i;
    assign planes_valid_o = valid;
    assign planes_o = {attributes_i.last, attributes_i.empty, attributes_i.index, colour};
  end
endmodule
