// SPDX-License-Identifier: Apache-2.0
// hs_triangle_setup at an interval of SetupCycles: as many units as that takes are given a triangle
// in turn, and their records leave in the order of the triangles, with the bits of one unit.
//
//   triangle ─┬─► word ─► hs_triangle_setup ─┬─► hs_setup_collect ─► setup
//             ├─► word ─► hs_triangle_setup ─┤          └──────────► attributes
//             └─►  …                        ─┘
//
// A division takes longer than the edges of a triangle: where a unit alone is too slow, each unit
// has the divisions and planes of more than one triangle under way (Records) before there are more
// units.
// Interval: SetupCycles on the average; a triangle a cycle at most. Latency: one cycle more than
// hs_triangle_setup where there are units in turn. Stall, fork: as hs_triangle_setup.
module hs_setup_turns #(
  parameter int unsigned LanesX = 1,
  parameter int unsigned LanesY = 1,
  parameter int unsigned SetupCycles = hs_formats_pkg::SetupInterval
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
  // hs_edge_setup takes 15 cycles at most, and what follows it SetupInterval.
  localparam int unsigned Edges = 15;
  localparam int unsigned Interval = hs_formats_pkg::SetupInterval;
  localparam int unsigned Records =
      SetupCycles >= Interval || Interval < Edges ? 1 : (Interval + Edges / 2) / Edges;
  localparam int unsigned OfRecords = (Interval + Records - 1) / Records;
  localparam int unsigned OfUnit = Records > 1 && OfRecords < Edges ? Edges : OfRecords;
  localparam int unsigned Units = (OfUnit + SetupCycles - 1) / SetupCycles;
  localparam int unsigned SetupBits = $bits(setup_o);
  localparam int unsigned AttributesBits = $bits(attributes_o);

  if (Units == 1) begin : gen_alone
    hs_triangle_setup #(
      .LanesX (LanesX),
      .LanesY (LanesY),
      .Records(Records)
    ) u_triangle_setup (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .frame_width_i     (frame_width_i),
      .frame_height_i    (frame_height_i),
      .triangle_valid_i  (triangle_valid_i),
      .triangle_ready_o  (triangle_ready_o),
      .triangle_i        (triangle_i),
      .setup_valid_o     (setup_valid_o),
      .setup_ready_i     (setup_ready_i),
      .setup_o           (setup_o),
      .attributes_valid_o(attributes_valid_o),
      .attributes_ready_i(attributes_ready_i),
      .attributes_o      (attributes_o)
    );
  end else begin : gen_turns
    logic [Units-1:0] turn_q, free, setup_valid, setup_ready, attributes_valid, attributes_ready;
    logic [Units*SetupBits-1:0] setup;
    logic [Units*AttributesBits-1:0] attributes;

    assign triangle_ready_o = |(free & turn_q);

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) turn_q <= Units'(1);
      else if (triangle_valid_i && triangle_ready_o) turn_q <= {turn_q[Units-2:0], turn_q[Units-1]};
    end

    for (genvar unit = 0; unit < Units; unit++) begin : gen_unit
      // A triangle is looked at where it stands: each unit has a place for one.
      logic valid_q, ready;
      hs_formats_pkg::numbered_t triangle_q;

      assign free[unit] = !valid_q;

      always_ff @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) valid_q <= 1'b0;
        else if (free[unit]) valid_q <= triangle_valid_i && turn_q[unit];
        else if (ready) valid_q <= 1'b0;
      end

      always_ff @(posedge clk_i) begin
        if (free[unit]) triangle_q <= triangle_i;
      end

      hs_triangle_setup #(
        .LanesX (LanesX),
        .LanesY (LanesY),
        .Records(Records)
      ) u_triangle_setup (
        .clk_i             (clk_i),
        .rst_ni            (rst_ni),
        .frame_width_i     (frame_width_i),
        .frame_height_i    (frame_height_i),
        .triangle_valid_i  (valid_q),
        .triangle_ready_o  (ready),
        .triangle_i        (triangle_q),
        .setup_valid_o     (setup_valid[unit]),
        .setup_ready_i     (setup_ready[unit]),
        .setup_o           (setup[unit*SetupBits +: SetupBits]),
        .attributes_valid_o(attributes_valid[unit]),
        .attributes_ready_i(attributes_ready[unit]),
        .attributes_o      (attributes[unit*AttributesBits +: AttributesBits])
      );
    end

    hs_setup_collect #(
      .Turns         (Units),
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
  end
endmodule
