// SPDX-License-Identifier: Apache-2.0
// The plane-equation Gouraud shader at scan-out (kernel: hls/shade/shade_gouraud.hpp). Flat
// triangles have their colour in TdbS: there are no planes then, no stages for them and no
// multiplier.
//
// Interval: a cycle for each different triangle in a stamp, one for a stamp of pure background.
// Latency: 9 cycles from a scan word with one triangle to its pixel word, 4 if flat. Stages:
// pick | read | data | five of the planes | merge into the stamp. Six multipliers.
// Stall: everything stops while a finished stamp is not taken.
// TdbS: entry index − 1, bits as in planes_t from r on; a read takes one cycle, its word stays
// until the next read. Two banks, used in turn by the frames, the first one by the first frame.
module hs_shade_gouraud #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned Gouraud = hs_formats_pkg::Gouraud,
  localparam int unsigned PlaneBits = hs_formats_pkg::ColourPlaneBits,
  localparam int unsigned PlanesBits = (Gouraud != 0 ? 9 : 3) * PlaneBits,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = 1 + XBits + YBits + Lanes * 3 * ColourBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles)
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  logic [3*ColourBits-1:0] background_i,  // {r, g, b}

  // From scan_index
  input  logic                    scan_valid_i,
  output logic                    scan_ready_o,
  input  logic [ScanBits-1:0]     scan_i,

  // TdbS
  output logic                    read_en_o,
  output logic                    read_bank_o,
  output logic [EntryBits-1:0]    read_entry_o,
  input  logic [PlanesBits-1:0]   read_planes_i,

  // To the frame
  output logic                    pixel_valid_o,
  input  logic                    pixel_ready_i,
  output logic [PixelBits-1:0]    pixel_o
);
  // From pick to merge: read, data, and the stages of hs_plane_lanes.
  localparam int unsigned PlaneStages = Gouraud != 0 ? 5 : 0;
  localparam int unsigned Stages = PlaneStages + 2;
  localparam int unsigned HeadBits = 1 + XBits + YBits;

  logic go;  // all stages move

  // Stage pick: the stamp, and its lanes that are not shaded yet.
  logic stamp_valid_q, stamp_first_q, group_last;
  hs_formats_pkg::scan_head_t scan_head, stamp_head_q;
  logic [Lanes*IndexBits-1:0] scan_index, stamp_index_q;
  logic [Lanes-1:0] scan_waits, waits_q, group_lanes;
  logic [EntryBits-1:0] group_entry;
  logic bank_q;

  // A group: the lanes of one triangle. Stage 0 is read, 1 is data, 2 and on are the planes.
  logic [Stages-1:0] valid_q, first_q, last_q;
  logic [Stages*Lanes-1:0] lanes_q;
  logic [Stages*HeadBits-1:0] heads_q;
  logic [HeadBits-1:0] merge_head;
  logic read_bank_q;
  logic [EntryBits-1:0] read_entry_q;
  logic [3*Lanes*ColourBits-1:0] colour;

  // Stage merge: the pixel word.
  logic pixel_valid_q;
  logic [HeadBits-1:0] pixel_head_q;
  logic [3*Lanes*ColourBits-1:0] pixel_colour_q;

  assign go = !pixel_valid_q || pixel_ready_i;

  assign {scan_head, scan_index} = scan_i;
  assign scan_ready_o = go && (!stamp_valid_q || group_last);

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_pick
    assign scan_waits[lane] = scan_index[lane*IndexBits +: IndexBits] != '0;
  end

  hs_lane_group #(
    .Lanes(Lanes)
  ) u_group (
    .waits_i(waits_q),
    .index_i(stamp_index_q),
    .entry_o(group_entry),
    .lanes_o(group_lanes),
    .last_o (group_last)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      stamp_valid_q <= 1'b0;
      bank_q <= 1'b0;
      valid_q <= '0;
      pixel_valid_q <= 1'b0;
    end else if (go) begin
      if (scan_ready_o) stamp_valid_q <= scan_valid_i;
      if (stamp_valid_q && group_last && stamp_head_q.last) bank_q <= !bank_q;
      valid_q <= {valid_q[Stages-2:0], stamp_valid_q};
      pixel_valid_q <= valid_q[Stages-1] && last_q[Stages-1];
    end
  end

  always_ff @(posedge clk_i) begin
    if (scan_valid_i && scan_ready_o) begin
      stamp_head_q <= scan_head;
      stamp_index_q <= scan_index;
      waits_q <= scan_waits;
      stamp_first_q <= 1'b1;
    end else if (go) begin
      waits_q <= waits_q & ~group_lanes;
      stamp_first_q <= 1'b0;
    end
    if (go) begin
      first_q <= {first_q[Stages-2:0], stamp_first_q};
      last_q <= {last_q[Stages-2:0], group_last};
      lanes_q <= {lanes_q[(Stages-1)*Lanes-1:0], group_lanes};
      heads_q <= {heads_q[(Stages-1)*HeadBits-1:0], stamp_head_q};
      read_bank_q <= bank_q;
      read_entry_q <= group_entry;
    end
  end

  assign read_en_o = go && valid_q[0] && lanes_q[0 +: Lanes] != '0;
  assign read_bank_o = read_bank_q;
  assign read_entry_o = read_entry_q;

  assign merge_head = heads_q[(Stages-1)*HeadBits +: HeadBits];

  // Planes 2, 1, 0 are r, g, b, as in planes_t.
  for (genvar i = 0; i < 3; i++) begin : gen_plane
    if (Gouraud != 0) begin : gen_gouraud
      logic [PlaneBits-1:0] unused_first;
      hs_plane_lanes #(
        .PlaneBits(PlaneBits),
        .ValueBits(ColourBits),
        .LanesX   (LanesX),
        .LanesY   (LanesY)
      ) u_plane (
        .clk_i     (clk_i),
        .en_i      (go),
        .plane_i   (read_planes_i[(3*i+2)*PlaneBits +: PlaneBits]),
        .plane_dx_i(read_planes_i[(3*i+1)*PlaneBits +: PlaneBits]),
        .plane_dy_i(read_planes_i[3*i*PlaneBits +: PlaneBits]),
        .x_i       (heads_q[HeadBits+YBits +: XBits]),
        .y_i       (heads_q[HeadBits +: YBits]),
        .first_o   (unused_first),
        .value_o   (colour[i*Lanes*ColourBits +: Lanes*ColourBits])
      );
    end else begin : gen_flat
      assign colour[i*Lanes*ColourBits +: Lanes*ColourBits] =
          {Lanes{read_planes_i[i*PlaneBits +: PlaneBits]}};
    end

    for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
      localparam int unsigned Place = (i * Lanes + lane) * ColourBits;
      always_ff @(posedge clk_i) begin
        if (go && valid_q[Stages-1]) begin
          if (lanes_q[(Stages-1)*Lanes+lane]) begin
            pixel_colour_q[Place +: ColourBits] <= colour[Place +: ColourBits];
          end else if (first_q[Stages-1]) begin
            pixel_colour_q[Place +: ColourBits] <= background_i[i*ColourBits +: ColourBits];
          end
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (go && valid_q[Stages-1]) pixel_head_q <= merge_head;
  end

  assign pixel_valid_o = pixel_valid_q;
  assign pixel_o = {pixel_head_q, pixel_colour_q};
endmodule
