// SPDX-License-Identifier: Apache-2.0
// Texture at scan-out (kernel: hls/texture/shade_texture.hpp): what the shader before made of a
// stamp, times the texels of its pixels. Textures and texels are memories of hs_texture_fetch, in
// here.
//
// Interval: a cycle a covered lane, with or without a texture; one for a stamp of background.
// Latency from a scan word with one covered lane to its pixel word: 10 cycles, and those of
// hs_texture_fetch. A word of `lit` is looked at two cycles before that, and taken with the last
// pixel of its stamp: scan may run ahead of it by all that the stages hold.
// Stages: pick | read | data | five of the planes | fetch, its last with `lit` | product | merge.
// Multipliers: two a plane, those of hs_texture_fetch, and three for the product.
// Stall: while a finished stamp is not taken everything stops; while `lit` is awaited what is
// before the product. Texels and textures are written while no stamp is in flight.
// TdbS: entry index − 1, bits as in texture_planes_t from texture on; a read takes one cycle, its
// word stays until the next read. Two banks, used in turn by the frames, the first one by the first
// frame. Without texture there is no such unit: hs_formats_pkg has not its numbers then.
module hs_shade_texture #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned TextureBits = hs_formats_pkg::TextureBits,
  localparam int unsigned RepeatBits = hs_formats_pkg::RepeatBits,
  localparam int unsigned Channels = hs_formats_pkg::Perspective != 0 ? 3 : 2,
  localparam int unsigned PlaneBits = hs_formats_pkg::CoordinatePlaneBits,
  localparam int unsigned PlanesBits = TextureBits + RepeatBits + 3 * Channels * PlaneBits,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = 1 + XBits + YBits + Lanes * 3 * ColourBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles),
  localparam int unsigned TextureWordBits = hs_formats_pkg::TextureWordBits,
  localparam int unsigned TexelWordBits = hs_formats_pkg::TexelWordBits
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  // Memories, written while no stamp is in flight
  input  logic                       texture_valid_i,
  input  logic [TextureWordBits-1:0] texture_i,
  input  logic                       texel_valid_i,
  input  logic [TexelWordBits-1:0]   texel_i,

  // From scan_index
  input  logic                       scan_valid_i,
  output logic                       scan_ready_o,
  input  logic [ScanBits-1:0]        scan_i,

  // From the shader before, a word for each of scan
  input  logic                       lit_valid_i,
  output logic                       lit_ready_o,
  input  logic [PixelBits-1:0]       lit_i,

  // TdbS
  output logic                       read_en_o,
  output logic                       read_bank_o,
  output logic [EntryBits-1:0]       read_entry_o,
  input  logic [PlanesBits-1:0]      read_planes_i,

  // To the frame
  output logic                       pixel_valid_o,
  input  logic                       pixel_ready_i,
  output logic [PixelBits-1:0]       pixel_o
);
  // From pick to the fetch: read, data, and the stages of hs_plane_lanes.
  localparam int unsigned PlaneStages = 5;
  localparam int unsigned Stages = PlaneStages + 2;
  localparam int unsigned LaneBits = Lanes > 1 ? $clog2(Lanes) : 1;
  localparam int unsigned HeadBits = 1 + XBits + YBits;
  localparam int unsigned CoordinateBits = hs_formats_pkg::CoordinateBits;
  localparam int unsigned TexelBits = hs_formats_pkg::Bilinear != 0 ? hs_formats_pkg::FilteredBits
                                                                    : ColourBits;
  // What goes with a pixel: {first and last of its stamp, lane}.
  localparam int unsigned PlaceBits = 2 + LaneBits;
  localparam int unsigned TagBits = 1 + PlaceBits;  // has it a texture?
  localparam int unsigned NumberBits = 1 + TextureBits + RepeatBits;

  logic go;      // the stages before the product move
  logic go_out;  // the product and what follows

  // --- A pixel: stage 0 is read, 1 is data, 2 and on are the planes ---
  logic [Stages-1:0] valid;
  logic [Stages-1:1] valid_q;
  logic [(Stages-1)*PlaceBits-1:0] places_q;  // from stage 1 on
  logic [PlaneStages*NumberBits-1:0] numbers_q;
  logic read_covered, read_first, read_last, data_covered_q, unused_head;
  logic [LaneBits-1:0] read_lane;
  logic [HeadBits-1:0] read_head;
  hs_formats_pkg::x_t read_x, x_q;
  hs_formats_pkg::y_t read_y, y_q;
  logic [TextureBits-1:0] data_texture;
  logic [RepeatBits-1:0] data_repeat;
  logic [Channels*CoordinateBits-1:0] coordinates;

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
  assign unused_head = ^read_head;  // that of `lit` is the same
  assign read_en_o = go && valid[0] && read_covered;
  assign {data_texture, data_repeat} = read_planes_i[PlanesBits-1 -: TextureBits+RepeatBits];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (go) valid_q <= valid[Stages-2:0];
  end

  always_ff @(posedge clk_i) begin
    if (go) begin
      places_q <= {places_q[(Stages-2)*PlaceBits-1:0], read_first, read_last, read_lane};
      data_covered_q <= read_covered;
      x_q <= read_x;
      y_q <= read_y;
      numbers_q <= {numbers_q[(PlaneStages-1)*NumberBits-1:0], data_covered_q && data_texture != '0,
                    data_texture, data_repeat};
    end
  end

  // The last planes and coordinates are those of t or q.
  for (genvar i = 0; i < Channels; i++) begin : gen_plane
    logic [PlaneBits-1:0] unused_first;
    hs_plane_lanes #(
      .PlaneBits(PlaneBits),
      .ValueBits(CoordinateBits),
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
      .value_o   (coordinates[i*CoordinateBits +: CoordinateBits])
    );
  end

  // --- Its texel ---
  logic has_texture, texel_next;
  logic [TextureBits-1:0] texture;
  logic [RepeatBits-1:0] repeats;
  logic [TagBits-1:0] tag;
  logic [3*TexelBits-1:0] texel;

  assign {has_texture, texture, repeats} = numbers_q[(PlaneStages-1)*NumberBits +: NumberBits];

  hs_texture_fetch #(
    .TagBits(TagBits)
  ) u_fetch (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .en_i           (go),
    .texture_valid_i(texture_valid_i),
    .texture_i      (texture_i),
    .texel_valid_i  (texel_valid_i),
    .texel_i        (texel_i),
    .valid_i        (valid[Stages-1]),
    .tag_i          ({has_texture, places_q[(Stages-2)*PlaceBits +: PlaceBits]}),
    .number_i       (texture),
    .repeat_i       (repeats),
    .coordinates_i  (coordinates),
    .valid_o        (texel_next),
    .tag_o          (tag),
    .texel_o        (texel)
  );

  // --- It meets its stamp: a word of `lit` goes along with the first pixel ---
  logic tag_first, tag_last, unused_textured;
  logic [LaneBits-1:0] tag_lane;
  logic [3*ColourBits-1:0] lit_colour, colour_q;
  logic [1:0] met_valid_q;
  logic [2*TagBits-1:0] met_tag_q;
  logic [PixelBits-1:0] met_lit_q, met_lit_q2;

  assign {unused_textured, tag_first, tag_last, tag_lane} = tag;
  assign go = go_out && (!texel_next || lit_valid_i);
  assign lit_ready_o = go_out && texel_next && tag_last;

  always_comb begin
    lit_colour = '0;
    for (int unsigned i = 0; i < Lanes; i++) begin
      if (tag_lane == LaneBits'(i)) begin
        lit_colour = {lit_i[(2*Lanes+i)*ColourBits +: ColourBits],
                      lit_i[(Lanes+i)*ColourBits +: ColourBits],
                      lit_i[i*ColourBits +: ColourBits]};
      end
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) met_valid_q <= '0;
    else if (go_out) met_valid_q <= {met_valid_q[0], texel_next && lit_valid_i};
  end

  always_ff @(posedge clk_i) begin
    if (go_out) begin
      met_tag_q <= {met_tag_q[TagBits-1:0], tag};
      colour_q <= lit_colour;
      if (tag_first) met_lit_q <= lit_i;
      met_lit_q2 <= met_lit_q;
    end
  end

  // --- Product and merge ---
  logic textured, first, is_last, pixel_valid_q;
  logic [LaneBits-1:0] place;
  logic [HeadBits-1:0] pixel_head_q;
  logic [3*Lanes*ColourBits-1:0] pixel_colour_q;

  assign go_out = !pixel_valid_q || pixel_ready_i;
  assign {textured, first, is_last, place} = met_tag_q[TagBits +: TagBits];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) pixel_valid_q <= 1'b0;
    else if (go_out) pixel_valid_q <= met_valid_q[1] && is_last;
  end

  for (genvar c = 0; c < 3; c++) begin : gen_channel
    logic [ColourBits-1:0] colour;

    hs_texture_product #(
      .TexelBits(TexelBits)
    ) u_product (
      .clk_i   (clk_i),
      .en_i    (go_out),
      .lit_i   (colour_q[c*ColourBits +: ColourBits]),
      .texel_i (texel[c*TexelBits +: TexelBits]),
      .colour_o(colour)
    );

    for (genvar i = 0; i < Lanes; i++) begin : gen_lane
      localparam int unsigned Place = (c * Lanes + i) * ColourBits;
      always_ff @(posedge clk_i) begin
        if (go_out && met_valid_q[1]) begin
          if (textured && place == LaneBits'(i)) begin
            pixel_colour_q[Place +: ColourBits] <= colour;
          end else if (first) begin
            pixel_colour_q[Place +: ColourBits] <= met_lit_q2[Place +: ColourBits];
          end
        end
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (go_out && met_valid_q[1] && first) pixel_head_q <= met_lit_q2[PixelBits-1 -: HeadBits];
  end

  assign pixel_valid_o = pixel_valid_q;
  assign pixel_o = {pixel_head_q, pixel_colour_q};
endmodule
