// SPDX-License-Identifier: Apache-2.0
// hs_shade_setup at an interval of SetupCycles: as many units as that takes are given a record in
// turn, and their planes leave in the order of the records, with the bits of one unit.
//
// Flat colours have an interval of 1 by themselves. With lighting a record is given with its
// colours.
// Interval: SetupCycles on the average; a record a cycle at most. Latency: one cycle more than
// hs_shade_setup where there are units in turn. Stall: planes stay until taken, and the next unit
// waits.
module hs_shade_turns #(
  parameter int unsigned SetupCycles = hs_formats_pkg::SetupInterval,
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
  // Of hs_channel_planes, whose factors have 24 bits a pass.
  localparam int unsigned Chunk = 24;
  localparam int unsigned DeltaPasses = (hs_formats_pkg::DeltaBits - 2 + Chunk) / Chunk;
  localparam int unsigned ReciprocalPasses = (hs_formats_pkg::ReciprocalBits - 1 + Chunk) / Chunk;
  localparam int unsigned Interval = 3 * (6 * DeltaPasses + 2 * ReciprocalPasses);
  localparam int unsigned Lit = hs_formats_pkg::Lights != 0 ? 1 : 0;
  // Where the default asks for no more than hs_triangle_setup has, one is enough.
  localparam int unsigned Units = hs_formats_pkg::Gouraud == 0
      || SetupCycles >= hs_formats_pkg::SetupInterval
      ? 1 : (Interval + SetupCycles - 1) / SetupCycles;

  if (Units == 1) begin : gen_alone
    hs_shade_setup u_shade_setup (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .attributes_valid_i(attributes_valid_i),
      .attributes_ready_o(attributes_ready_o),
      .attributes_i      (attributes_i),
      .colours_valid_i   (colours_valid_i),
      .colours_ready_o   (colours_ready_o),
      .colours_i         (colours_i),
      .planes_valid_o    (planes_valid_o),
      .planes_ready_i    (planes_ready_i),
      .planes_o          (planes_o)
    );
  end else begin : gen_turns
    logic [Units-1:0] in_q, out_q, free, planes_valid;  // in_q, out_q: one bit is 1
    logic [Units*PlanesBits-1:0] planes;
    logic has_colours, take;

    assign has_colours = Lit != 0 && !attributes_i.empty;
    assign take = attributes_valid_i && (!has_colours || colours_valid_i) && |(free & in_q);
    assign attributes_ready_o = take;
    assign colours_ready_o = take && has_colours;

    always_comb begin
      planes_o = '0;
      for (int unsigned i = 0; i < Units; i++) begin
        planes_o |= planes[i*PlanesBits +: PlanesBits] & {PlanesBits{out_q[i]}};
      end
    end
    assign planes_valid_o = |(planes_valid & out_q);

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        in_q <= Units'(1);
        out_q <= Units'(1);
      end else begin
        if (take) in_q <= {in_q[Units-2:0], in_q[Units-1]};
        if (planes_valid_o && planes_ready_i) out_q <= {out_q[Units-2:0], out_q[Units-1]};
      end
    end

    for (genvar unit = 0; unit < Units; unit++) begin : gen_unit
      // A record is read where it stands: each unit has a place for one.
      logic valid_q, ready, unused_colours_ready;
      hs_formats_pkg::attributes_t attributes_q;
      logic [ColoursBits-1:0] colours_q;

      assign free[unit] = !valid_q;

      always_ff @(posedge clk_i or negedge rst_ni) begin
        if (!rst_ni) valid_q <= 1'b0;
        else if (free[unit]) valid_q <= take && in_q[unit];
        else if (ready) valid_q <= 1'b0;
      end

      always_ff @(posedge clk_i) begin
        if (free[unit]) begin
          attributes_q <= attributes_i;
          colours_q <= colours_i;
        end
      end

      hs_shade_setup u_shade_setup (
        .clk_i             (clk_i),
        .rst_ni            (rst_ni),
        .attributes_valid_i(valid_q),
        .attributes_ready_o(ready),
        .attributes_i      (attributes_q),
        .colours_valid_i   (valid_q),
        .colours_ready_o   (unused_colours_ready),
        .colours_i         (colours_q),
        .planes_valid_o    (planes_valid[unit]),
        .planes_ready_i    (planes_ready_i && out_q[unit]),
        .planes_o          (planes[unit*PlanesBits +: PlanesBits])
      );
    end
  end
endmodule
