// SPDX-License-Identifier: Apache-2.0
// The motion field at scan-out (kernel: hls/motion/motion_field.hpp): a word a covered pixel, in
// the order of scan, stamps in order and lanes in order. A frame whose last stamp covers nothing
// ends with a word of face 0.
//
// Interval: a cycle a covered lane; one for a stamp of background. Latency from a scan word to the
// word of its first pixel: 12 cycles, with perspective 17. Stages: pick | read | data | five of the
// planes | those of hs_motion_vector | out. Multipliers, for each key: two a plane, and those of
// hs_motion_vector.
// Stall: everything stops while a word is not taken.
// TdbS: entry index − 1, bits as in the word of planes from face on; a read takes one cycle, its
// word stays until the next read. Two banks, used in turn by the frames, the first one by the first
// frame. A configuration without motion has no such unit: hs_formats_pkg has not its numbers then.
module hs_motion_field #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned PlanesBits = hs_formats_pkg::MotionPlanesWordBits - 2 - IndexBits,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits,
  localparam int unsigned MotionBits = hs_formats_pkg::MotionWordBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles)
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  // From scan_index
  input  logic                  scan_valid_i,
  output logic                  scan_ready_o,
  input  logic [ScanBits-1:0]   scan_i,

  // TdbS
  output logic                  read_en_o,
  output logic                  read_bank_o,
  output logic [EntryBits-1:0]  read_entry_o,
  input  logic [PlanesBits-1:0] read_planes_i,

  // To the motion buffer
  output logic                  motion_valid_o,
  input  logic                  motion_ready_i,
  output logic [MotionBits-1:0] motion_o
);
  localparam int unsigned Keys = 2;
  localparam int unsigned Perspective = hs_formats_pkg::Perspective;
  localparam int unsigned Relight = hs_formats_pkg::Relight;
  localparam int unsigned Channels = Perspective != 0 ? 3 : 2;
  localparam int unsigned LaneBits = Lanes > 1 ? $clog2(Lanes) : 1;
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits;
  localparam int unsigned OriginBits = hs_formats_pkg::OriginBits;
  localparam int unsigned ExtentBits = hs_formats_pkg::ExtentBits;
  localparam int unsigned VectorBits = hs_formats_pkg::VectorBits;
  localparam int unsigned ValueBits = hs_formats_pkg::CoordinateBits;
  localparam int unsigned PlaneBits = hs_formats_pkg::CoordinatePlaneBits;
  localparam int unsigned DifferenceBits = hs_formats_pkg::DifferenceBits;
  localparam int unsigned DifferencePlaneBits = hs_formats_pkg::DifferencePlaneBits;
  localparam int unsigned ColourPlanesBits = Relight != 0 ? 9 * DifferencePlaneBits : 0;
  localparam int unsigned ColourBits = Relight != 0 ? 3 * DifferenceBits : 0;
  localparam int unsigned PlacePlanesBits = 3 * Channels * PlaneBits;
  localparam int unsigned KeyPlanesBits = 1 + 2 * OriginBits + ExtentBits + PlacePlanesBits
                                          + ColourPlanesBits;
  localparam int unsigned KeyBits = 1 + 2 * VectorBits + ColourBits;

  // Stage 0 is read, 1 is data, 2 to 6 the planes, the others the vector.
  localparam int unsigned PlaneStages = 5;
  localparam int unsigned VectorStages = Perspective != 0 ? 8 : 3;
  localparam int unsigned Stages = 2 + PlaneStages + VectorStages;

  logic go;  // all stages move

  // --- A pixel; of a stamp of background none, but for the last word of a frame ---
  logic read_valid, read_covered, read_last, read_sends, unused_first, unused_lane;
  logic [LaneBits-1:0] read_lane;
  logic [XBits+YBits:0] read_head;
  hs_formats_pkg::x_t read_x;
  hs_formats_pkg::y_t read_y;
  logic [Stages-1:1] valid_q;

  hs_scan_pixels #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_pixels (
    .clk_i       (clk_i),
    .rst_ni      (rst_ni),
    .en_i        (go),
    .scan_valid_i(scan_valid_i),
    .scan_ready_o(scan_ready_o),
    .scan_i      (scan_i),
    .valid_o     (read_valid),
    .covered_o   (read_covered),
    .first_o     (unused_first),
    .last_o      (read_last),
    .lane_o      (read_lane),
    .head_o      (read_head),
    .x_o         (read_x),
    .y_o         (read_y),
    .bank_o      (read_bank_o),
    .entry_o     (read_entry_o)
  );
  assign unused_lane = ^{read_lane, read_head};
  assign read_en_o = go && read_valid && read_covered;
  assign read_sends = read_valid && (read_covered || read_head[XBits+YBits]);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (go) valid_q <= {valid_q[Stages-2:1], read_sends};
  end

  // --- What goes along: {last, covered, x, y} from stage 1, the face from stage 2 on ---
  localparam int unsigned TagBits = 2 + XBits + YBits;
  logic [(Stages-1)*TagBits-1:0] tags_q;
  logic [(Stages-2)*FaceBits-1:0] faces_q;
  logic data_covered, covered, last;
  hs_formats_pkg::x_t data_x, plane_x, x;
  hs_formats_pkg::y_t data_y, plane_y, y;
  logic [FaceBits-1:0] face;
  logic unused_tags;

  always_ff @(posedge clk_i) begin
    if (go) begin
      tags_q <= {tags_q[(Stages-2)*TagBits-1:0],
                 read_last && read_head[XBits+YBits], read_covered, read_x, read_y};
      faces_q <= {faces_q[(Stages-3)*FaceBits-1:0], read_planes_i[PlanesBits-1 -: FaceBits]};
    end
  end
  assign {data_covered, data_x, data_y} = tags_q[0 +: TagBits-1];
  assign {plane_x, plane_y} = tags_q[PlaneStages*TagBits +: XBits+YBits];
  assign {last, covered, x, y} = tags_q[(Stages-2)*TagBits +: TagBits];
  assign face = faces_q[(Stages-3)*FaceBits +: FaceBits];
  assign unused_tags = data_covered;

  // --- Its vectors; key 0 is in the more significant place ---
  logic [Keys*KeyBits-1:0] keys;

  for (genvar k = 0; k < Keys; k++) begin : gen_key
    localparam int unsigned Planes = k * KeyPlanesBits;
    localparam int unsigned Head = Planes + PlacePlanesBits + ColourPlanesBits;
    localparam int unsigned PlaceBits = 2 * OriginBits + ExtentBits;
    logic [Channels*ValueBits-1:0] coordinates;
    logic [PlaneStages*PlaceBits-1:0] places_q;
    logic [(Stages-2)-1:0] there_q;
    logic fits, there;
    logic [2*VectorBits-1:0] vector;

    always_ff @(posedge clk_i) begin
      if (go) begin
        places_q <= {places_q[(PlaneStages-1)*PlaceBits-1:0], read_planes_i[Head +: PlaceBits]};
        there_q <= {there_q[Stages-4:0], read_planes_i[Head + PlaceBits]};
      end
    end

    for (genvar i = 0; i < Channels; i++) begin : gen_place
      localparam int unsigned Plane = Planes + ColourPlanesBits + 3 * i * PlaneBits;
      logic [PlaneBits-1:0] unused_place;
      hs_plane_lanes #(
        .PlaneBits(PlaneBits),
        .ValueBits(ValueBits),
        .LanesX   (1),
        .LanesY   (1)
      ) u_plane (
        .clk_i     (clk_i),
        .en_i      (go),
        .plane_i   (read_planes_i[Plane+2*PlaneBits +: PlaneBits]),
        .plane_dx_i(read_planes_i[Plane+PlaneBits +: PlaneBits]),
        .plane_dy_i(read_planes_i[Plane +: PlaneBits]),
        .x_i       (data_x),
        .y_i       (data_y),
        .first_o   (unused_place),
        .value_o   (coordinates[i*ValueBits +: ValueBits])
      );
    end

    hs_motion_vector #(
      .CoordinateBits(ValueBits)
    ) u_vector (
      .clk_i        (clk_i),
      .en_i         (go),
      .coordinates_i(coordinates),
      .place_i      ({OriginBits'(plane_x), OriginBits'(plane_y),
                      places_q[(PlaneStages-1)*PlaceBits +: PlaceBits]}),
      .fits_o       (fits),
      .vector_o     (vector)
    );

    assign there = covered && there_q[Stages-3] && fits;
    assign keys[k*KeyBits+ColourBits +: 1+2*VectorBits] = there ? {1'b1, vector} : '0;

    if (Relight != 0) begin : gen_relight
      logic [ColourBits-1:0] differences;
      logic [VectorStages*ColourBits-1:0] differences_q;

      for (genvar i = 0; i < 3; i++) begin : gen_difference
        localparam int unsigned Plane = Planes + 3 * i * DifferencePlaneBits;
        logic [DifferencePlaneBits-1:0] unused_difference;
        hs_plane_lanes #(
          .PlaneBits(DifferencePlaneBits),
          .ValueBits(DifferenceBits),
          .LanesX   (1),
          .LanesY   (1)
        ) u_plane (
          .clk_i     (clk_i),
          .en_i      (go),
          .plane_i   (read_planes_i[Plane+2*DifferencePlaneBits +: DifferencePlaneBits]),
          .plane_dx_i(read_planes_i[Plane+DifferencePlaneBits +: DifferencePlaneBits]),
          .plane_dy_i(read_planes_i[Plane +: DifferencePlaneBits]),
          .x_i       (data_x),
          .y_i       (data_y),
          .first_o   (unused_difference),
          .value_o   (differences[i*DifferenceBits +: DifferenceBits])
        );
      end

      always_ff @(posedge clk_i) begin
        if (go) differences_q <= {differences_q[(VectorStages-1)*ColourBits-1:0], differences};
      end
      assign keys[k*KeyBits +: ColourBits] =
          there ? differences_q[(VectorStages-1)*ColourBits +: ColourBits] : '0;
    end
  end

  // --- Out ---
  logic motion_valid_q;
  logic [MotionBits-1:0] motion_q;

  assign go = !motion_valid_q || motion_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) motion_valid_q <= 1'b0;
    else if (go) motion_valid_q <= valid_q[Stages-1];
  end

  always_ff @(posedge clk_i) begin
    if (go) motion_q <= {last, x, y, covered ? face : FaceBits'(0), keys};
  end

  assign motion_valid_o = motion_valid_q;
  assign motion_o = motion_q;
endmodule
