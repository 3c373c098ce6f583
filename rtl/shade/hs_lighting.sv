// SPDX-License-Identifier: Apache-2.0
// The Phong model for normals of any length, lights and a viewer at infinity (kernel: light_normal
// in hls/shade/lighting.hpp). The lights are registers and the materials memories of this module,
// written word by word while no normal is in flight.
//
// Interval: a cycle a light. Latency: 12 + 2·Squarings cycles, and one more for each light after
// the first. Stall: all stages wait while a colour offered is not taken.
// Stages: operands | products | sums, then the reciprocal root and the cosines to stage
// CosineStage, the squarings to PowerStage | products with the material | sum over the lights |
// round.
// Multipliers: 9, 1, 2, Squarings and 6; without highlights 6, 1, 1 and 3.
module hs_lighting #(
  parameter int unsigned TagBits,  // 1 or more: what comes back with the colour
  localparam int unsigned NormalBits = hs_formats_pkg::NormalBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned MaterialBits = hs_formats_pkg::MaterialBits,
  localparam int unsigned LightBits = hs_formats_pkg::LightBits,
  localparam int unsigned GlossBits = hs_formats_pkg::GlossBits,
  localparam int unsigned Ways = hs_formats_pkg::HasGloss != 0 ? 2 : 1,  // diffuse, highlight
  localparam int unsigned WayBits = 3 * hs_formats_pkg::DirectionBits,
  localparam int unsigned CoefficientsBits =
      (1 + Ways) * 3 * hs_formats_pkg::CoefficientBits,
  localparam int unsigned LightWordBits = hs_formats_pkg::LightWordBits,
  localparam int unsigned MaterialWordBits = hs_formats_pkg::MaterialWordBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  input  logic                        light_valid_i,
  input  logic [LightWordBits-1:0]    light_i,  // as light_t
  input  logic                        material_valid_i,
  input  logic [MaterialWordBits-1:0] material_i,  // as material_t

  input  logic                        normal_valid_i,
  output logic                        normal_ready_o,
  input  logic [TagBits-1:0]          normal_tag_i,
  input  logic [MaterialBits-1:0]     normal_material_i,
  input  logic [3*NormalBits-1:0]     normal_i,  // {x, y, z}

  output logic                        colour_valid_o,
  input  logic                        colour_ready_i,
  output logic [TagBits-1:0]          colour_tag_o,
  output logic [3*ColourBits-1:0]     colour_o  // {r, g, b}
);
  localparam int unsigned Lights = hs_formats_pkg::Lights;
  localparam int unsigned DirectionBits = hs_formats_pkg::DirectionBits;
  localparam int unsigned LengthBits = hs_formats_pkg::SquaredLengthBits;
  localparam int unsigned DotBits = hs_formats_pkg::DotBits;
  localparam int unsigned ShiftBits = hs_formats_pkg::RootShiftBits;
  localparam int unsigned RootBits = hs_formats_pkg::RootBits;
  localparam int unsigned CosineBits = hs_formats_pkg::CosineBits;
  localparam int unsigned CoefficientBits = hs_formats_pkg::CoefficientBits;
  localparam int unsigned Squarings = hs_formats_pkg::Squarings;
  localparam int unsigned CosineStage = 8;
  localparam int unsigned PowerStage = CosineStage + 2 * Squarings;
  localparam int unsigned SumStage = PowerStage + 2;
  localparam int unsigned EntryBits = MaterialBits + (Lights > 1 ? LightBits : 0);

  logic go;  // all stages move

  // --- Lights and materials ---
  logic [Lights*Ways*WayBits-1:0] ways_q;
  logic [LightBits-1:0] written_light, light_q;
  logic [Ways*WayBits-1:0] written_ways;
  logic [MaterialBits-1:0] written_material;
  logic [LightBits-1:0] written_material_light;
  logic [EntryBits-1:0] written_entry, entry;

  assign {written_light, written_ways} = light_i;
  assign {written_material, written_material_light} =
      material_i[MaterialWordBits-1 -: MaterialBits+LightBits];
  if (Lights > 1) begin : gen_entry
    assign written_entry = {written_material, written_material_light};
    assign entry = {normal_material_i, light_q};
  end else begin : gen_entry_of_one
    logic unused_light;
    assign written_entry = written_material;
    assign entry = normal_material_i;
    assign unused_light = ^written_material_light;
  end
  for (genvar i = 0; i < Lights; i++) begin : gen_light
    always_ff @(posedge clk_i) begin
      if (light_valid_i && written_light == LightBits'(i)) begin
        ways_q[i*Ways*WayBits +: Ways*WayBits] <= written_ways;
      end
    end
  end

  // --- Which normal and light ---
  logic [SumStage:0] valid_q, first_q, last_q;
  logic [(SumStage+1)*TagBits-1:0] tags_q;
  logic [PowerStage*EntryBits-1:0] entries_q;
  logic last, colour_valid_q;

  assign last = light_q == LightBits'(Lights - 1);
  assign normal_ready_o = go && last;
  assign go = !colour_valid_q || colour_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q <= '0;
      light_q <= '0;
      colour_valid_q <= 1'b0;
    end else if (go) begin
      valid_q <= {valid_q[SumStage-1:0], normal_valid_i};
      if (normal_valid_i) light_q <= last ? '0 : light_q + LightBits'(1);
      colour_valid_q <= valid_q[SumStage] && last_q[SumStage];
    end
  end

  always_ff @(posedge clk_i) begin
    if (go) begin
      first_q <= {first_q[SumStage-1:0], light_q == '0};
      last_q <= {last_q[SumStage-1:0], last};
      tags_q <= {tags_q[SumStage*TagBits-1:0], normal_tag_i};
      entries_q <= {entries_q[(PowerStage-1)*EntryBits-1:0], entry};
    end
  end

  // --- Operands, products, sums, reciprocal root, cosines ---
  logic [3*NormalBits-1:0] normal_q;
  logic [Ways*WayBits-1:0] chosen, chosen_q;
  logic signed [LengthBits:0] length;
  logic [ShiftBits-1:0] shift;
  logic [RootBits-1:0] root;
  logic [Ways*CosineBits-1:0] cosines;
  logic signed [DotBits-1:0] towards_light;
  logic unused_sign;

  always_comb begin
    chosen = '0;
    for (int unsigned i = 0; i < Lights; i++) begin
      if (light_q == LightBits'(i)) chosen = ways_q[i*Ways*WayBits +: Ways*WayBits];
    end
  end
  always_ff @(posedge clk_i) begin
    if (go) begin
      normal_q <= normal_i;
      chosen_q <= chosen;
    end
  end

  hs_light_dot #(
    .ABits  (NormalBits),
    .BBits  (NormalBits),
    .SumBits(LengthBits + 1)
  ) u_length (
    .clk_i(clk_i),
    .en_i (go),
    .a_i  (normal_q),
    .b_i  (normal_q),
    .sum_o(length)
  );
  assign unused_sign = length[LengthBits];

  hs_reciprocal_sqrt #(
    .LengthBits(LengthBits)
  ) u_root (
    .clk_i   (clk_i),
    .en_i    (go),
    .length_i(length[LengthBits-1:0]),
    .shift_o (shift),
    .root_o  (root)
  );

  // Way Ways − 1 is to the light, as in light_t; way 0 of two half-way to the viewer.
  for (genvar way = 0; way < Ways; way++) begin : gen_way
    logic signed [DotBits-1:0] dot;
    hs_light_dot #(
      .ABits  (NormalBits),
      .BBits  (DirectionBits),
      .SumBits(DotBits)
    ) u_dot (
      .clk_i(clk_i),
      .en_i (go),
      .a_i  (normal_q),
      .b_i  (chosen_q[way*WayBits +: WayBits]),
      .sum_o(dot)
    );
    if (way == Ways - 1) begin : gen_towards_light
      assign towards_light = dot;
    end

    hs_light_cosine #(
      .NormalBits(NormalBits)
    ) u_cosine (
      .clk_i   (clk_i),
      .en_i    (go),
      .enable_i(towards_light > 0),
      .dot_i   (dot),
      .shift_i (shift),
      .root_i  (root),
      .cosine_o(cosines[way*CosineBits +: CosineBits])
    );
  end

  // --- Powers ---
  logic [Ways*CosineBits-1:0] factors;

  if (Squarings != 0) begin : gen_power
    logic [GlossBits-1:0] gloss;
    logic [2*Squarings*CosineBits-1:0] diffuse_q;

    hs_ram_1r1w #(
      .Width(GlossBits),
      .Depth(1 << EntryBits)
    ) u_gloss (
      .clk_i          (clk_i),
      .read_en_i      (go),
      .read_address_i (entries_q[(CosineStage-1)*EntryBits +: EntryBits]),
      .read_data_o    (gloss),
      .write_en_i     (material_valid_i),
      .write_address_i(written_entry),
      .write_data_i   (material_i[CoefficientsBits +: GlossBits])
    );
    hs_light_power #(
      .Squarings (Squarings),
      .GlossBits (GlossBits),
      .CosineBits(CosineBits)
    ) u_power (
      .clk_i   (clk_i),
      .en_i    (go),
      .gloss_i (gloss),
      .cosine_i(cosines[0 +: CosineBits]),
      .power_o (factors[0 +: CosineBits])
    );
    always_ff @(posedge clk_i) begin
      if (go) begin
        diffuse_q <= {diffuse_q[(2*Squarings-1)*CosineBits-1:0],
                      cosines[(Ways-1)*CosineBits +: CosineBits]};
      end
    end
    assign factors[(Ways-1)*CosineBits +: CosineBits] =
        diffuse_q[(2*Squarings-1)*CosineBits +: CosineBits];
  end else begin : gen_no_power
    logic unused_gloss;
    assign unused_gloss = ^material_i[MaterialWordBits-1:CoefficientsBits];
    assign factors = cosines;
  end

  // --- The material: {base, diffuse, specular}, each {r, g, b}; products, sum, rounding ---
  logic [CoefficientsBits-1:0] coefficients;
  logic [TagBits-1:0] colour_tag_q;

  hs_ram_1r1w #(
    .Width(CoefficientsBits),
    .Depth(1 << EntryBits)
  ) u_material (
    .clk_i          (clk_i),
    .read_en_i      (go),
    .read_address_i (entries_q[(PowerStage-1)*EntryBits +: EntryBits]),
    .read_data_o    (coefficients),
    .write_en_i     (material_valid_i),
    .write_address_i(written_entry),
    .write_data_i   (material_i[CoefficientsBits-1:0])
  );

  // Channel 0 is blue. Way 0 is the last of the coefficients.
  for (genvar c = 0; c < 3; c++) begin : gen_channel
    logic [Ways*CoefficientBits-1:0] weights;
    for (genvar way = 0; way < Ways; way++) begin : gen_weight
      assign weights[way*CoefficientBits +: CoefficientBits] =
          coefficients[(3*way+c)*CoefficientBits +: CoefficientBits];
    end
    hs_light_channel #(
      .Ways(Ways)
    ) u_channel (
      .clk_i    (clk_i),
      .en_i     (go),
      .first_i  (first_q[PowerStage+1]),
      .base_i   (coefficients[(3*Ways+c)*CoefficientBits +: CoefficientBits]),
      .weights_i(weights),
      .factors_i(factors),
      .colour_o (colour_o[c*ColourBits +: ColourBits])
    );
  end

  always_ff @(posedge clk_i) begin
    if (go) colour_tag_q <= tags_q[SumStage*TagBits +: TagBits];
  end

  assign colour_valid_o = colour_valid_q;
  assign colour_tag_o = colour_tag_q;
endmodule
