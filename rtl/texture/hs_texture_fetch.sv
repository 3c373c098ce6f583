// SPDX-License-Identifier: Apache-2.0
// The texel that a pixel shows, from its texture coordinates (kernel: texel_fetch in
// hls/texture/texel_fetch.hpp). The table of textures and their texels are memories of this module,
// written word by word while no pixel is in flight.
//
// Interval 1. Latency, of cycles in which en_i is 1, which is their only stall:
//
//   affine, nearest 7    affine, bilinear 14    perspective, nearest 10    perspective, bilinear 17
//
// Stages: Lead for the reciprocal and the table of textures | product with it | three for the place
// | address, bilinear two | texels | bilinear six of the filter. Multipliers: with perspective 1
// and 2; bilinear 9. Memories: the table, and a bank of texels, bilinear four of a quarter each.
module hs_texture_fetch #(
  parameter int unsigned TagBits,  // 1 or more: what goes with a pixel
  localparam int unsigned Perspective = hs_formats_pkg::Perspective,
  localparam int unsigned Bilinear = hs_formats_pkg::Bilinear,
  localparam int unsigned Channels = Perspective != 0 ? 3 : 2,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned CoordinateBits = hs_formats_pkg::CoordinateBits,
  localparam int unsigned TextureBits = hs_formats_pkg::TextureBits,
  localparam int unsigned RepeatBits = hs_formats_pkg::RepeatBits,
  localparam int unsigned TexelBits = Bilinear != 0 ? hs_formats_pkg::FilteredBits : ColourBits,
  localparam int unsigned TextureWordBits = hs_formats_pkg::TextureWordBits,
  localparam int unsigned TexelWordBits = hs_formats_pkg::TexelWordBits
) (
  input  logic                               clk_i,
  input  logic                               rst_ni,
  input  logic                               en_i,

  input  logic                               texture_valid_i,
  input  logic [TextureWordBits-1:0]         texture_i,  // as texture_t
  input  logic                               texel_valid_i,
  input  logic [TexelWordBits-1:0]           texel_i,  // as texel_t

  input  logic                               valid_i,
  input  logic [TagBits-1:0]                 tag_i,
  input  logic [TextureBits-1:0]             number_i,
  input  logic [RepeatBits-1:0]              repeat_i,
  input  logic [Channels*CoordinateBits-1:0] coordinates_i,  // {s, t, q}

  output logic                               valid_o,  // one such cycle before its texel
  output logic [TagBits-1:0]                 tag_o,
  output logic [3*TexelBits-1:0]             texel_o  // {r, g, b}
);
  localparam int unsigned AddressBits = hs_formats_pkg::TexelAddressBits;
  localparam int unsigned SideBits = hs_formats_pkg::SideBits;
  localparam int unsigned WeightBits = hs_formats_pkg::WeightBits;
  localparam int unsigned PlaceBits = AddressBits + (Bilinear != 0 ? WeightBits : 0);
  localparam int unsigned Banks = Bilinear != 0 ? 4 : 1;
  // A bank of one word has two.
  localparam int unsigned BankAddressBits = AddressBits == $clog2(Banks) ? 1
                                            : AddressBits - $clog2(Banks);
  localparam int unsigned EntryBits = AddressBits + 2 * SideBits;
  localparam int unsigned InverseBits = Perspective != 0 ? hs_formats_pkg::InverseBits : 0;
  localparam int unsigned LargestShift =
      Perspective != 0 ? (1 << hs_formats_pkg::InverseShiftBits) - 1 : 0;
  localparam int unsigned TotalBits =
      $clog2(LargestShift + (1 << RepeatBits) + AddressBits);
  localparam int unsigned ScaledBits = CoordinateBits + InverseBits;
  localparam int unsigned Point = Perspective != 0 ? CoordinateBits - 1 + InverseBits
                                                   : CoordinateBits;
  localparam int unsigned Lead = Perspective != 0 ? 4 : 1;
  localparam int unsigned TagStages = Lead + (Bilinear != 0 ? 12 : 5);
  localparam int unsigned EntryStages = 4;  // after the table, to the address

  // --- What goes along ---
  localparam int unsigned GivenBits = RepeatBits + 2 * CoordinateBits;

  logic [TagStages-1:0] valid_q;
  logic [TagStages*TagBits-1:0] tags_q;
  logic [Lead*GivenBits-1:0] given_q;
  logic [RepeatBits-1:0] repeats;
  logic [CoordinateBits-1:0] s, t;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (en_i) valid_q <= {valid_q[TagStages-2:0], valid_i};
  end

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      tags_q <= (TagStages * TagBits)'({tags_q, tag_i});
      given_q <= (Lead * GivenBits)'({given_q, repeat_i,
                     coordinates_i[Channels*CoordinateBits-1 -: 2*CoordinateBits]});
    end
  end

  assign valid_o = valid_q[TagStages-1];
  assign tag_o = tags_q[(TagStages-1)*TagBits +: TagBits];
  assign {repeats, s, t} = given_q[(Lead-1)*GivenBits +: GivenBits];

  // --- The reciprocal of q; s and t times it ---
  logic [TotalBits-1:0] shift;
  logic [ScaledBits-1:0] scaled_s_q, scaled_t_q;
  logic [TextureBits-1:0] number;

  if (Perspective != 0) begin : gen_perspective
    localparam int unsigned ShiftBits = hs_formats_pkg::InverseShiftBits;
    logic [ShiftBits-1:0] shift_early;
    logic [(Lead-1)*ShiftBits-1:0] shifts_q;
    logic [(Lead-1)*TextureBits-1:0] numbers_q;
    logic [InverseBits-1:0] inverse;

    hs_reciprocal_lookup #(
      .ValueBits(CoordinateBits)
    ) u_reciprocal (
      .clk_i    (clk_i),
      .en_i     (en_i),
      .value_i  (coordinates_i[CoordinateBits-1:0]),
      .shift_o  (shift_early),
      .inverse_o(inverse)
    );

    always_ff @(posedge clk_i) begin
      if (en_i) begin
        shifts_q <= ((Lead - 1) * ShiftBits)'({shifts_q, shift_early});
        numbers_q <= ((Lead - 1) * TextureBits)'({numbers_q, number_i});
        scaled_s_q <= ScaledBits'(s) * ScaledBits'(inverse);
        scaled_t_q <= ScaledBits'(t) * ScaledBits'(inverse);
      end
    end
    assign shift = TotalBits'(shifts_q[(Lead-2)*ShiftBits +: ShiftBits]);
    assign number = numbers_q[(Lead-2)*TextureBits +: TextureBits];
  end else begin : gen_affine
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        scaled_s_q <= s;
        scaled_t_q <= t;
      end
    end
    assign shift = '0;
    assign number = number_i;
  end

  // --- The table of textures ---
  logic [EntryBits-1:0] entry;
  logic [EntryStages*EntryBits-1:0] entries_q;
  logic [TotalBits-1:0] total_u_q, total_v_q;
  logic unused_base;

  hs_ram_1r1w #(
    .Width(EntryBits),
    .Depth(1 << TextureBits)
  ) u_textures (
    .clk_i          (clk_i),
    .read_en_i      (en_i),
    .read_address_i (number),
    .read_data_o    (entry),
    .write_en_i     (texture_valid_i),
    .write_address_i(texture_i[EntryBits +: TextureBits]),
    .write_data_i   (texture_i[EntryBits-1:0])
  );

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      entries_q <= (EntryStages * EntryBits)'({entries_q, entry});
      total_u_q <= shift + TotalBits'(repeats) + TotalBits'(entry[SideBits +: SideBits]);
      total_v_q <= shift + TotalBits'(repeats) + TotalBits'(entry[0 +: SideBits]);
    end
  end

  // --- The place, its texels' addresses ---
  logic [PlaceBits-1:0] u, v;
  logic [SideBits-1:0] place_log2_width, place_log2_height, log2_width, log2_height;
  logic [AddressBits-1:0] base;
  logic [Banks*BankAddressBits-1:0] address;
  logic [WeightBits:0] column_weight, row_weight;

  assign {place_log2_width, place_log2_height} = entries_q[2*EntryBits +: 2*SideBits];
  assign {base, log2_width, log2_height} = entries_q[3*EntryBits +: EntryBits];
  assign unused_base = ^entries_q;

  hs_texture_place #(
    .ScaledBits(ScaledBits),
    .Point     (Point),
    .TotalBits (TotalBits)
  ) u_place_u (
    .clk_i      (clk_i),
    .en_i       (en_i),
    .scaled_i   (scaled_s_q),
    .total_i    (total_u_q),
    .log2_side_i(place_log2_width),
    .place_o    (u)
  );

  hs_texture_place #(
    .ScaledBits(ScaledBits),
    .Point     (Point),
    .TotalBits (TotalBits)
  ) u_place_v (
    .clk_i      (clk_i),
    .en_i       (en_i),
    .scaled_i   (scaled_t_q),
    .total_i    (total_v_q),
    .log2_side_i(place_log2_height),
    .place_o    (v)
  );

  hs_texture_address #(
    .AddressBits(AddressBits)
  ) u_address (
    .clk_i          (clk_i),
    .en_i           (en_i),
    .u_i            (u),
    .v_i            (v),
    .base_i         (base),
    .log2_width_i   (log2_width),
    .log2_height_i  (log2_height),
    .address_o      (address),
    .column_weight_o(column_weight),
    .row_weight_o   (row_weight)
  );

  // --- The texels ---
  logic [AddressBits-1:0] written_address;
  logic [Banks*3*ColourBits-1:0] texels;

  assign written_address = texel_i[3*ColourBits +: AddressBits];

  for (genvar bank = 0; bank < Banks; bank++) begin : gen_bank
    logic is_written;
    logic [BankAddressBits-1:0] written_word;

    if (Banks == 1) begin : gen_only
      assign is_written = texel_valid_i;
      assign written_word = written_address;
    end else begin : gen_one_of_four
      assign is_written = texel_valid_i && written_address[1:0] == 2'(bank);
      assign written_word = BankAddressBits'(written_address >> 2);
    end

    hs_ram_1r1w #(
      .Width(3 * ColourBits),
      .Depth(1 << BankAddressBits)
    ) u_texels (
      .clk_i          (clk_i),
      .read_en_i      (en_i),
      .read_address_i (address[bank*BankAddressBits +: BankAddressBits]),
      .read_data_o    (texels[3*bank*ColourBits +: 3*ColourBits]),
      .write_en_i     (is_written),
      .write_address_i(written_word),
      .write_data_i   (texel_i[3*ColourBits-1:0])
    );
  end

  if (Bilinear != 0) begin : gen_bilinear
    // From the address to the texels two cycles, to the sum of a row three more.
    logic [2*(WeightBits+1)-1:0] column_weights_q;
    logic [5*(WeightBits+1)-1:0] row_weights_q;

    always_ff @(posedge clk_i) begin
      if (en_i) begin
        column_weights_q <= {column_weights_q[WeightBits:0], column_weight};
        row_weights_q <= {row_weights_q[4*(WeightBits+1)-1:0], row_weight};
      end
    end

    for (genvar c = 0; c < 3; c++) begin : gen_channel
      logic [4*ColourBits-1:0] channel;
      for (genvar bank = 0; bank < 4; bank++) begin : gen_texel
        assign channel[bank*ColourBits +: ColourBits] =
            texels[(3*bank+c)*ColourBits +: ColourBits];
      end
      hs_texture_filter #(
        .WeightBits(WeightBits)
      ) u_filter (
        .clk_i          (clk_i),
        .en_i           (en_i),
        .texels_i       (channel),
        .column_weight_i(column_weights_q[WeightBits+1 +: WeightBits+1]),
        .row_weight_i   (row_weights_q[4*(WeightBits+1) +: WeightBits+1]),
        .texel_o        (texel_o[c*TexelBits +: TexelBits])
      );
    end
  end else begin : gen_nearest
    logic unused_weights;
    assign unused_weights = ^{column_weight, row_weight};
    assign texel_o = texels;
  end
endmodule
