// SPDX-License-Identifier: Apache-2.0
// Phong shading at scan-out (kernel: hls/shade/shade_phong.hpp): the normal of a pixel from the
// planes of its triangle, then lit. The lights and materials are those of hs_lighting, in here.
//
// Interval: a cycle a covered lane and light; a stamp of background takes as many cycles as there
// are lights. Latency of a stamp alone: 7 cycles to the first normal, that of hs_lighting, and one.
// Stages: pick | read | data | five of the planes, then hs_lighting and the merge into the stamp.
// Multipliers: six, and those of hs_lighting. Stall: while a finished stamp is not taken, the
// stages fill up and wait.
// TdbS: entry index − 1, bits as in planes_t from material on; a read takes one cycle, its
// word stays until the next read. Two banks, used in turn by the frames, the first one by the first
// frame. Without Phong shading there is no such unit: hs_formats_pkg has not its numbers then.
module hs_shade_phong #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned NormalBits = hs_formats_pkg::NormalBits,
  localparam int unsigned MaterialBits = hs_formats_pkg::MaterialBits,
  localparam int unsigned PlaneBits = hs_formats_pkg::NormalPlaneBits,
  localparam int unsigned PlanesBits = MaterialBits + 9 * PlaneBits,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = 1 + XBits + YBits + Lanes * 3 * ColourBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles),
  localparam int unsigned LightWordBits = hs_formats_pkg::LightWordBits,
  localparam int unsigned MaterialWordBits = hs_formats_pkg::MaterialWordBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  input  logic [3*ColourBits-1:0]     background_i,  // {r, g, b}

  // Registers and memories, written while no stamp is in flight
  input  logic                        light_valid_i,
  input  logic [LightWordBits-1:0]    light_i,
  input  logic                        material_valid_i,
  input  logic [MaterialWordBits-1:0] material_i,

  // From scan_index
  input  logic                        scan_valid_i,
  output logic                        scan_ready_o,
  input  logic [ScanBits-1:0]         scan_i,

  // TdbS
  output logic                        read_en_o,
  output logic                        read_bank_o,
  output logic [EntryBits-1:0]        read_entry_o,
  input  logic [PlanesBits-1:0]       read_planes_i,

  // To the frame
  output logic                        pixel_valid_o,
  input  logic                        pixel_ready_i,
  output logic [PixelBits-1:0]        pixel_o
);
  // From pick to the lighting core: read, data, and the stages of hs_plane_lanes.
  localparam int unsigned PlaneStages = 5;
  localparam int unsigned Stages = PlaneStages + 2;
  localparam int unsigned LaneBits = Lanes > 1 ? $clog2(Lanes) : 1;
  localparam int unsigned HeadBits = 1 + XBits + YBits;
  // What goes with a pixel: {covered, first and last of its stamp, lane, head of the stamp}.
  localparam int unsigned TagBits = 3 + LaneBits + HeadBits;

  logic go;  // the stages before the lighting core move

  // --- A pixel: stage 0 is read, 1 is data, 2 and on are the planes ---
  logic [Stages-1:0] valid;
  logic [Stages-1:1] valid_q;
  logic [TagBits-1:0] read_tag;
  logic [(Stages-1)*TagBits-1:0] tags_q;  // from stage 1 on
  logic [PlaneStages*MaterialBits-1:0] materials_q;
  logic read_covered, read_first, read_last;
  logic [LaneBits-1:0] read_lane;
  logic [HeadBits-1:0] read_head;
  hs_formats_pkg::x_t read_x, x_q;
  hs_formats_pkg::y_t read_y, y_q;
  logic [3*NormalBits-1:0] normal;
  logic normal_ready;

  assign go = !valid[Stages-1] || normal_ready;

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
    .valid_o     (valid[0]),
    .covered_o   (read_covered),
    .first_o     (read_first),
    .last_o      (read_last),
    .lane_o      (read_lane),
    .head_o      (read_head),
    .x_o         (read_x),
    .y_o         (read_y),
    .bank_o      (read_bank_o),
    .entry_o     (read_entry_o)
  );
  assign valid[Stages-1:1] = valid_q;
  assign read_tag = {read_covered, read_first, read_last, read_lane, read_head};
  assign read_en_o = go && valid[0] && read_covered;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (go) valid_q <= valid[Stages-2:0];
  end

  always_ff @(posedge clk_i) begin
    if (go) begin
      tags_q <= {tags_q[(Stages-2)*TagBits-1:0], read_tag};
      materials_q <= {materials_q[(PlaneStages-1)*MaterialBits-1:0],
                      read_planes_i[9*PlaneBits +: MaterialBits]};
      x_q <= read_x;
      y_q <= read_y;
    end
  end

  // Planes and components 2, 1, 0 are x, y, z. Their values are offset: the sign is inverted.
  for (genvar i = 0; i < 3; i++) begin : gen_plane
    logic [PlaneBits-1:0] unused_first;
    logic [NormalBits-1:0] offset;
    hs_plane_lanes #(
      .PlaneBits(PlaneBits),
      .ValueBits(NormalBits),
      .LanesX   (1),
      .LanesY   (1)
    ) u_plane (
      .clk_i     (clk_i),
      .en_i      (go),
      .plane_i   (read_planes_i[(3*i+2)*PlaneBits +: PlaneBits]),
      .plane_dx_i(read_planes_i[(3*i+1)*PlaneBits +: PlaneBits]),
      .plane_dy_i(read_planes_i[3*i*PlaneBits +: PlaneBits]),
      .x_i       (x_q),
      .y_i       (y_q),
      .first_o   (unused_first),
      .value_o   (offset)
    );
    assign normal[i*NormalBits +: NormalBits] = offset ^ {1'b1, {(NormalBits - 1) {1'b0}}};
  end

  // --- Light ---
  logic colour_valid, colour_ready;
  logic [TagBits-1:0] colour_tag;
  logic [3*ColourBits-1:0] colour;

  hs_lighting #(
    .TagBits(TagBits)
  ) u_lighting (
    .clk_i            (clk_i),
    .rst_ni           (rst_ni),
    .light_valid_i    (light_valid_i),
    .light_i          (light_i),
    .material_valid_i (material_valid_i),
    .material_i       (material_i),
    .normal_valid_i   (valid[Stages-1]),
    .normal_ready_o   (normal_ready),
    .normal_tag_i     (tags_q[(Stages-2)*TagBits +: TagBits]),
    .normal_material_i(materials_q[(PlaneStages-1)*MaterialBits +: MaterialBits]),
    .normal_i         (normal),
    .colour_valid_o   (colour_valid),
    .colour_ready_i   (colour_ready),
    .colour_tag_o     (colour_tag),
    .colour_o         (colour)
  );

  // --- Merge: the pixel word, whose first pixel brings the background to the others ---
  logic lit_covered, lit_first, lit_last, pixel_valid_q;
  logic [LaneBits-1:0] lit_lane;
  logic [HeadBits-1:0] lit_head, pixel_head_q;
  logic [3*Lanes*ColourBits-1:0] pixel_colour_q;

  assign {lit_covered, lit_first, lit_last, lit_lane, lit_head} = colour_tag;
  assign colour_ready = !pixel_valid_q || pixel_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) pixel_valid_q <= 1'b0;
    else if (colour_ready) pixel_valid_q <= colour_valid && lit_last;
  end

  for (genvar c = 0; c < 3; c++) begin : gen_channel
    for (genvar i = 0; i < Lanes; i++) begin : gen_lane
      localparam int unsigned Place = (c * Lanes + i) * ColourBits;
      always_ff @(posedge clk_i) begin
        if (colour_valid && colour_ready) begin
          if (lit_covered && lit_lane == LaneBits'(i)) begin
            pixel_colour_q[Place +: ColourBits] <= colour[c*ColourBits +: ColourBits];
          end else if (lit_first) begin
            pixel_colour_q[Place +: ColourBits] <= background_i[c*ColourBits +: ColourBits];
          end
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (colour_valid && colour_ready) pixel_head_q <= lit_head;
  end

  assign pixel_valid_o = pixel_valid_q;
  assign pixel_o = {pixel_head_q, pixel_colour_q};
endmodule
