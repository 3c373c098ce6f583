// SPDX-License-Identifier: Apache-2.0
// Triangle setup, after hls/setup/triangle_setup.hpp: edge functions, bounding box, the reciprocal
// of the area and the depth plane, in three units that work on three triangles at once:
//
//   triangle ─► hs_edge_setup ─┬── D ──► hs_reciprocal ─► record ─┬─► hs_plane_setup ─► setup
//                              └────────────────────────────┘     └──────────────► attributes
//
// hs_setup_record holds the latter three; with Records > 1 there are so many, which take triangles
// in turn. Without a plane there is no division: the edges are the setup, and wait where they are
// until both streams have taken them.
//
// Interval: SetupInterval cycles, see setup_interval() in hls/formats/setup_interval.hpp, mostly
// those of the division, which records share; 14 at least, 15 if D < 0; 3 for an empty triangle, 7
// if its box is not empty or it is culled. Latency: at
// most 45 cycles more. A triangle is taken after it was looked at: ready follows valid. Fork: setup
// and attributes each stay until taken, and the next record waits for both. Attributes come when
// the division is done, and not at all for an empty triangle, unless it is the last or all are
// asked for (hs_visible_select). Fields of an empty record are 0.
// LanesX and LanesY are powers of two.
module hs_triangle_setup #(
  parameter int unsigned LanesX = 1,
  parameter int unsigned LanesY = 1,
  parameter int unsigned Records = 1
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  hs_formats_pkg::x_t          frame_width_i,
  input  hs_formats_pkg::y_t          frame_height_i,

  // From geometry
  input  logic                        triangle_valid_i,
  output logic                        triangle_ready_o,
  input  hs_formats_pkg::numbered_t   triangle_i,

  // To raster_pineda
  output logic                        setup_valid_o,
  input  logic                        setup_ready_i,
  output hs_formats_pkg::setup_t      setup_o,

  // To shade_setup
  output logic                        attributes_valid_o,
  input  logic                        attributes_ready_i,
  output hs_formats_pkg::attributes_t attributes_o
);
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth;
  localparam int unsigned DepthsBits = HasDepth != 0 ? 3 * hs_formats_pkg::DepthBits : 1;
  localparam int unsigned SendsShape = hs_formats_pkg::SendsShape;
  localparam int unsigned ColourBits = hs_formats_pkg::TriangleColourBits;
  localparam int unsigned OrderBits = hs_formats_pkg::OrderBits;
  localparam int unsigned ShadeBits = OrderBits + ColourBits != 0 ? OrderBits + ColourBits : 1;

  // --- Order, D, box and edges ---
  logic edge_valid, edge_ready;
  logic area_valid, area_ready;
  hs_formats_pkg::area_t area;
  hs_formats_pkg::setup_t edge_setup;
  hs_formats_pkg::coord_t x0, y0;
  hs_formats_pkg::delta_t dx1, dy1, dx2, dy2, x, y;
  logic [DepthsBits-1:0] depths;
  logic [ShadeBits-1:0] shade;

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
    .x0_o            (x0),
    .y0_o            (y0),
    .dx1_o           (dx1),
    .dy1_o           (dy1),
    .dx2_o           (dx2),
    .dy2_o           (dy2),
    .x_o             (x),
    .y_o             (y),
    .depths_o        (depths),
    .shade_o         (shade)
  );

  if (HasDepth != 0 || SendsShape != 0) begin : gen_planes
    localparam int unsigned SetupBits = $bits(setup_o);
    localparam int unsigned AttributesBits = $bits(attributes_o);
    localparam int unsigned EdgesBits = SetupBits + 2 * hs_formats_pkg::CoordBits
        + 6 * hs_formats_pkg::DeltaBits + DepthsBits + ShadeBits;
    // One bit is 1: the record of the triangle that is looked at, and of that whose edges are out.
    logic [Records-1:0] area_turn, edge_turn, areas_ready, edges_ready;
    logic [Records-1:0] setup_valid, setup_ready, attributes_valid, attributes_ready;
    logic [Records*SetupBits-1:0] setup;
    logic [Records*AttributesBits-1:0] attributes;
    logic [EdgesBits-1:0] edges;

    assign edges = {edge_setup, x0, y0, dx1, dy1, dx2, dy2, x, y, depths, shade};
    assign area_ready = |(areas_ready & area_turn);
    assign edge_ready = |(edges_ready & edge_turn);

    for (genvar record = 0; record < Records; record++) begin : gen_record
      logic waiting_valid, waiting_ready;
      logic [EdgesBits-1:0] waiting;
      hs_formats_pkg::setup_t record_setup;
      hs_formats_pkg::coord_t record_x0, record_y0;
      hs_formats_pkg::delta_t record_dx1, record_dy1, record_dx2, record_dy2, record_x, record_y;
      logic [DepthsBits-1:0] record_depths;
      logic [ShadeBits-1:0] record_shade;

      // The edges of a triangle wait for its division: where others divide meanwhile, not in the
      // way of the next.
      if (Records > 1) begin : gen_waiting
        logic valid_q;
        logic [EdgesBits-1:0] edges_q;

        assign edges_ready[record] = !valid_q || waiting_ready;
        assign waiting_valid = valid_q;
        assign waiting = edges_q;

        always_ff @(posedge clk_i or negedge rst_ni) begin
          if (!rst_ni) valid_q <= 1'b0;
          else if (edges_ready[record]) valid_q <= edge_valid && edge_turn[record];
        end

        always_ff @(posedge clk_i) begin
          if (edges_ready[record]) edges_q <= edges;
        end
      end else begin : gen_at_once
        assign edges_ready[record] = waiting_ready;
        assign waiting_valid = edge_valid;
        assign waiting = edges;
      end

      assign {record_setup, record_x0, record_y0, record_dx1, record_dy1, record_dx2, record_dy2,
              record_x, record_y, record_depths, record_shade} = waiting;

      hs_setup_record #(
        .Fraction(hs_formats_pkg::ReciprocalFraction)
      ) u_setup_record (
        .clk_i             (clk_i),
        .rst_ni            (rst_ni),
        .area_valid_i      (area_valid && area_turn[record]),
        .area_ready_o      (areas_ready[record]),
        .area_i            (area),
        .edge_valid_i      (waiting_valid),
        .edge_ready_o      (waiting_ready),
        .setup_i           (record_setup),
        .x0_i              (record_x0),
        .y0_i              (record_y0),
        .dx1_i             (record_dx1),
        .dy1_i             (record_dy1),
        .dx2_i             (record_dx2),
        .dy2_i             (record_dy2),
        .x_i               (record_x),
        .y_i               (record_y),
        .depths_i          (record_depths),
        .shade_i           (record_shade),
        .setup_valid_o     (setup_valid[record]),
        .setup_ready_i     (setup_ready[record]),
        .setup_o           (setup[record*SetupBits +: SetupBits]),
        .attributes_valid_o(attributes_valid[record]),
        .attributes_ready_i(attributes_ready[record]),
        .attributes_o      (attributes[record*AttributesBits +: AttributesBits])
      );
    end

    if (Records > 1) begin : gen_turns
      logic [Records-1:0] area_turn_q, edge_turn_q;

      assign area_turn = area_turn_q;
      assign edge_turn = edge_turn_q;

      always_ff @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) begin
          area_turn_q <= Records'(1);
          edge_turn_q <= Records'(1);
        end else begin
          if (triangle_valid_i && triangle_ready_o) begin
            area_turn_q <= {area_turn_q[Records-2:0], area_turn_q[Records-1]};
          end
          if (edge_valid && edge_ready) begin
            edge_turn_q <= {edge_turn_q[Records-2:0], edge_turn_q[Records-1]};
          end
        end
      end

      hs_setup_collect #(
        .Turns         (Records),
        .SetupBits     (SetupBits),
        .AttributesBits(AttributesBits)
      ) u_collect (
        .clk_i             (clk_i),
        .rst_ni            (rst_ni),
        .setup_valid_i     (setup_valid),
        .setup_ready_o     (setup_ready),
        .setup_i           (setup),
        .attributes_valid_i(attributes_valid),
        .attributes_ready_o(attributes_ready),
        .attributes_i      (attributes),
        .setup_valid_o     (setup_valid_o),
        .setup_ready_i     (setup_ready_i),
        .setup_o           (setup_o),
        .attributes_valid_o(attributes_valid_o),
        .attributes_ready_i(attributes_ready_i),
        .attributes_o      (attributes_o)
      );
    end else begin : gen_one
      assign area_turn = 1'b1;
      assign edge_turn = 1'b1;
      assign setup_valid_o = setup_valid;
      assign setup_ready = setup_ready_i;
      assign setup_o = setup;
      assign attributes_valid_o = attributes_valid;
      assign attributes_ready = attributes_ready_i;
      assign attributes_o = attributes;
    end
  end else begin : gen_no_planes
    logic setup_sent_q, attributes_sent_q, unused_planes;

    assign unused_planes = ^{area_valid, area, x0, y0, dx1, dy1, dx2, dy2, x, y, depths};
    assign area_ready = 1'b1;

    assign setup_valid_o = edge_valid && !setup_sent_q;
    assign setup_o = edge_setup;
    assign attributes_valid_o = edge_valid && !attributes_sent_q
                                && (!edge_setup.empty || edge_setup.last
                                    || hs_formats_pkg::Deferred != 0);
    assign attributes_o.last = edge_setup.last;
    assign attributes_o.empty = edge_setup.empty;
    assign attributes_o.index = edge_setup.index;
    if (ColourBits != 0) begin : gen_flat
      assign {attributes_o.r, attributes_o.g, attributes_o.b} = shade;
    end else begin : gen_no_colour
      logic unused_shade;
      assign unused_shade = ^shade;
    end
    assign edge_ready = (!setup_valid_o || setup_ready_i)
                        && (!attributes_valid_o || attributes_ready_i);

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        setup_sent_q <= 1'b0;
        attributes_sent_q <= 1'b0;
      end else if (edge_valid) begin
        setup_sent_q <= !edge_ready && (setup_sent_q || setup_ready_i);
        attributes_sent_q <= !edge_ready && (attributes_sent_q || attributes_ready_i);
      end
    end
  end
endmodule
