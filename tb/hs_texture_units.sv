// SPDX-License-Identifier: Apache-2.0
// The units of texture, each alone, for the bench: as hs_units, which has what every configuration has.
//
//   texture_setup
//   shade_texture   `texture` and `texel` words go into its memories, and `texture_planes` words into TdbS,
//                   before the scan
module hs_texture_units #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = 1 + XBits + YBits + Lanes * 3 * ColourBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles),
  localparam int unsigned PlanesBits = hs_formats_pkg::TexturePlanesWordBits - 2 - IndexBits
) (
  input  logic                                 rst_ni,
  input  hs_formats_pkg::x_t                   frame_width_i,
  input  hs_formats_pkg::y_t                   frame_height_i,
  input  logic [3*ColourBits-1:0]              background_i,

  input  logic                                 texture_setup_clk_i,
  input  logic                                 texture_setup_visible_attributes_valid_i,
  output logic                                 texture_setup_visible_attributes_ready_o,
  input  hs_formats_pkg::attributes_t          texture_setup_visible_attributes_i,
  input  logic                                 texture_setup_texture_coordinates_valid_i,
  output logic                                 texture_setup_texture_coordinates_ready_o,
  input  hs_formats_pkg::texture_coordinates_t texture_setup_texture_coordinates_i,
  output logic                                 texture_setup_texture_planes_valid_o,
  input  logic                                 texture_setup_texture_planes_ready_i,
  output hs_formats_pkg::texture_planes_t      texture_setup_texture_planes_o,

  input  logic                                 shade_texture_clk_i,
  input  logic                                 shade_texture_texture_valid_i,
  input  hs_formats_pkg::texture_t             shade_texture_texture_i,
  input  logic                                 shade_texture_texel_valid_i,
  input  hs_formats_pkg::texel_t               shade_texture_texel_i,
  input  logic                                 shade_texture_texture_planes_valid_i,
  input  hs_formats_pkg::texture_planes_t      shade_texture_texture_planes_i,
  input  logic                                 shade_texture_scan_valid_i,
  output logic                                 shade_texture_scan_ready_o,
  input  logic [ScanBits-1:0]                  shade_texture_scan_i,
  input  logic                                 shade_texture_lit_valid_i,
  output logic                                 shade_texture_lit_ready_o,
  input  logic [PixelBits-1:0]                 shade_texture_lit_i,
  output logic                                 shade_texture_pixel_valid_o,
  input  logic                                 shade_texture_pixel_ready_i,
  output logic [PixelBits-1:0]                 shade_texture_pixel_o
);
  logic unused_registers;
  assign unused_registers = ^{frame_width_i, frame_height_i, background_i};

  hs_texture_setup #(
    .CoordinateBits(hs_formats_pkg::CoordinateBits)
  ) u_texture_setup (
    .clk_i                      (texture_setup_clk_i),
    .rst_ni                     (rst_ni),
    .attributes_valid_i         (texture_setup_visible_attributes_valid_i),
    .attributes_ready_o         (texture_setup_visible_attributes_ready_o),
    .attributes_i               (texture_setup_visible_attributes_i),
    .texture_coordinates_valid_i(texture_setup_texture_coordinates_valid_i),
    .texture_coordinates_ready_o(texture_setup_texture_coordinates_ready_o),
    .texture_coordinates_i      (texture_setup_texture_coordinates_i),
    .texture_planes_valid_o     (texture_setup_texture_planes_valid_o),
    .texture_planes_ready_i     (texture_setup_texture_planes_ready_i),
    .texture_planes_o           (texture_setup_texture_planes_o)
  );

  // shade_texture, with two TdbS banks that `texture_planes` words fill before the scan; `last` ends a frame's words.
  logic read_en, read_bank, read_bank_q, bank_q;
  logic [EntryBits-1:0] read_entry;
  logic [PlanesBits-1:0] read_planes [2];
  logic [EntryBits-1:0] entry;

  assign entry = EntryBits'(shade_texture_texture_planes_i.index) - EntryBits'(1);

  hs_shade_texture #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_shade_texture (
    .clk_i          (shade_texture_clk_i),
    .rst_ni         (rst_ni),
    .texture_valid_i(shade_texture_texture_valid_i),
    .texture_i      (shade_texture_texture_i),
    .texel_valid_i  (shade_texture_texel_valid_i),
    .texel_i        (shade_texture_texel_i),
    .scan_valid_i   (shade_texture_scan_valid_i),
    .scan_ready_o   (shade_texture_scan_ready_o),
    .scan_i         (shade_texture_scan_i),
    .lit_valid_i    (shade_texture_lit_valid_i),
    .lit_ready_o    (shade_texture_lit_ready_o),
    .lit_i          (shade_texture_lit_i),
    .read_en_o      (read_en),
    .read_bank_o    (read_bank),
    .read_entry_o   (read_entry),
    .read_planes_i  (read_planes[read_bank_q]),
    .pixel_valid_o  (shade_texture_pixel_valid_o),
    .pixel_ready_i  (shade_texture_pixel_ready_i),
    .pixel_o        (shade_texture_pixel_o)
  );

  always_ff @(posedge shade_texture_clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      bank_q <= 1'b0;
      read_bank_q <= 1'b0;
    end else begin
      if (shade_texture_texture_planes_valid_i && shade_texture_texture_planes_i.last) bank_q <= !bank_q;
      if (read_en) read_bank_q <= read_bank;
    end
  end

  for (genvar bank = 0; bank < 2; bank++) begin : gen_bank
    hs_bench_ram #(
      .Width(PlanesBits),
      .Depth(hs_formats_pkg::Triangles)
    ) u_planes (
      .clk_i          (shade_texture_clk_i),
      .clear_i        (1'b0),
      .read_en_i      (read_en && read_bank == 1'(bank)),
      .read_address_i (read_entry),
      .read_data_o    (read_planes[bank]),
      .write_en_i     (shade_texture_texture_planes_valid_i && !shade_texture_texture_planes_i.empty &&
                       bank_q == 1'(bank)),
      .write_address_i(entry),
      .write_data_i   (shade_texture_texture_planes_i[PlanesBits-1:0])
    );
  end
endmodule
