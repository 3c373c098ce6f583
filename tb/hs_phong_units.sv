// SPDX-License-Identifier: Apache-2.0
// The units of Phong shading, each alone, for the bench: as hs_units, which has what every configuration has.
//
//   triangle_setup, visible_select, phong_setup
//   shade_phong   `light` and `material` words go into its registers and memories, and `planes` words into TdbS,
//                 before the scan
module hs_phong_units #(
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
  localparam int unsigned PlanesBits = hs_formats_pkg::MaterialBits + 9 * hs_formats_pkg::NormalPlaneBits
) (
  input  logic                           rst_ni,
  input  hs_formats_pkg::x_t             frame_width_i,
  input  hs_formats_pkg::y_t             frame_height_i,
  input  logic [3*ColourBits-1:0]        background_i,

  input  logic                           triangle_setup_clk_i,
  input  logic                           triangle_setup_triangle_valid_i,
  output logic                           triangle_setup_triangle_ready_o,
  input  hs_formats_pkg::triangle_t      triangle_setup_triangle_i,
  output logic                           triangle_setup_setup_valid_o,
  input  logic                           triangle_setup_setup_ready_i,
  output hs_formats_pkg::setup_t         triangle_setup_setup_o,
  output logic                           triangle_setup_attributes_valid_o,
  input  logic                           triangle_setup_attributes_ready_i,
  output hs_formats_pkg::attributes_t    triangle_setup_attributes_o,

  input  logic                           visible_select_clk_i,
  input  logic                           visible_select_attributes_valid_i,
  output logic                           visible_select_attributes_ready_o,
  input  hs_formats_pkg::attributes_t    visible_select_attributes_i,
  input  logic                           visible_select_visible_valid_i,
  output logic                           visible_select_visible_ready_o,
  input  hs_formats_pkg::visible_t       visible_select_visible_i,
  output logic                           visible_select_visible_valid_o,
  input  logic                           visible_select_visible_ready_i,
  output hs_formats_pkg::visible_t       visible_select_visible_o,
  output logic                           visible_select_visible_attributes_valid_o,
  input  logic                           visible_select_visible_attributes_ready_i,
  output hs_formats_pkg::attributes_t    visible_select_visible_attributes_o,

  input  logic                           phong_setup_clk_i,
  input  logic                           phong_setup_visible_attributes_valid_i,
  output logic                           phong_setup_visible_attributes_ready_o,
  input  hs_formats_pkg::attributes_t    phong_setup_visible_attributes_i,
  input  logic                           phong_setup_normals_valid_i,
  output logic                           phong_setup_normals_ready_o,
  input  hs_formats_pkg::normals_t       phong_setup_normals_i,
  output logic                           phong_setup_planes_valid_o,
  input  logic                           phong_setup_planes_ready_i,
  output hs_formats_pkg::planes_t phong_setup_planes_o,

  input  logic                           shade_phong_clk_i,
  input  logic                           shade_phong_light_valid_i,
  input  hs_formats_pkg::light_t         shade_phong_light_i,
  input  logic                           shade_phong_material_valid_i,
  input  hs_formats_pkg::material_t      shade_phong_material_i,
  input  logic                           shade_phong_planes_valid_i,
  input  hs_formats_pkg::planes_t shade_phong_planes_i,
  input  logic                           shade_phong_scan_valid_i,
  output logic                           shade_phong_scan_ready_o,
  input  logic [ScanBits-1:0]            shade_phong_scan_i,
  output logic                           shade_phong_pixel_valid_o,
  input  logic                           shade_phong_pixel_ready_i,
  output logic [PixelBits-1:0]           shade_phong_pixel_o
);
  hs_triangle_setup #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_triangle_setup (
    .clk_i             (triangle_setup_clk_i),
    .rst_ni            (rst_ni),
    .frame_width_i     (frame_width_i),
    .frame_height_i    (frame_height_i),
    .triangle_valid_i  (triangle_setup_triangle_valid_i),
    .triangle_ready_o  (triangle_setup_triangle_ready_o),
    .triangle_i        (triangle_setup_triangle_i),
    .setup_valid_o     (triangle_setup_setup_valid_o),
    .setup_ready_i     (triangle_setup_setup_ready_i),
    .setup_o           (triangle_setup_setup_o),
    .attributes_valid_o(triangle_setup_attributes_valid_o),
    .attributes_ready_i(triangle_setup_attributes_ready_i),
    .attributes_o      (triangle_setup_attributes_o)
  );

  hs_visible_select u_visible_select (
    .clk_i                     (visible_select_clk_i),
    .rst_ni                    (rst_ni),
    .attributes_valid_i        (visible_select_attributes_valid_i),
    .attributes_ready_o        (visible_select_attributes_ready_o),
    .attributes_i              (visible_select_attributes_i),
    .visible_valid_i           (visible_select_visible_valid_i),
    .visible_ready_o           (visible_select_visible_ready_o),
    .visible_i                 (visible_select_visible_i),
    .visible_valid_o           (visible_select_visible_valid_o),
    .visible_ready_i           (visible_select_visible_ready_i),
    .visible_o                 (visible_select_visible_o),
    .visible_attributes_valid_o(visible_select_visible_attributes_valid_o),
    .visible_attributes_ready_i(visible_select_visible_attributes_ready_i),
    .visible_attributes_o      (visible_select_visible_attributes_o)
  );

  hs_phong_setup #(
    .NormalBits(hs_formats_pkg::NormalBits)
  ) u_phong_setup (
    .clk_i                (phong_setup_clk_i),
    .rst_ni               (rst_ni),
    .attributes_valid_i(phong_setup_visible_attributes_valid_i),
    .attributes_ready_o   (phong_setup_visible_attributes_ready_o),
    .attributes_i         (phong_setup_visible_attributes_i),
    .normals_valid_i      (phong_setup_normals_valid_i),
    .normals_ready_o      (phong_setup_normals_ready_o),
    .normals_i            (phong_setup_normals_i),
    .planes_valid_o(phong_setup_planes_valid_o),
    .planes_ready_i(phong_setup_planes_ready_i),
    .planes_o      (phong_setup_planes_o)
  );

  // shade_phong, with two TdbS banks that `planes` words fill before the scan; `last` ends a frame's words.
  logic read_en, read_bank, read_bank_q, bank_q;
  logic [EntryBits-1:0] read_entry;
  logic [PlanesBits-1:0] read_planes [2];
  logic [EntryBits-1:0] entry;

  assign entry = EntryBits'(shade_phong_planes_i.index) - EntryBits'(1);

  hs_shade_phong #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_shade_phong (
    .clk_i           (shade_phong_clk_i),
    .rst_ni          (rst_ni),
    .background_i    (background_i),
    .light_valid_i   (shade_phong_light_valid_i),
    .light_i         (shade_phong_light_i),
    .material_valid_i(shade_phong_material_valid_i),
    .material_i      (shade_phong_material_i),
    .scan_valid_i    (shade_phong_scan_valid_i),
    .scan_ready_o    (shade_phong_scan_ready_o),
    .scan_i          (shade_phong_scan_i),
    .read_en_o       (read_en),
    .read_bank_o     (read_bank),
    .read_entry_o    (read_entry),
    .read_planes_i   (read_planes[read_bank_q]),
    .pixel_valid_o   (shade_phong_pixel_valid_o),
    .pixel_ready_i   (shade_phong_pixel_ready_i),
    .pixel_o         (shade_phong_pixel_o)
  );

  always_ff @(posedge shade_phong_clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      bank_q <= 1'b0;
      read_bank_q <= 1'b0;
    end else begin
      if (shade_phong_planes_valid_i && shade_phong_planes_i.last) bank_q <= !bank_q;
      if (read_en) read_bank_q <= read_bank;
    end
  end

  for (genvar bank = 0; bank < 2; bank++) begin : gen_bank
    hs_bench_ram #(
      .Width(PlanesBits),
      .Depth(hs_formats_pkg::Triangles)
    ) u_planes (
      .clk_i          (shade_phong_clk_i),
      .clear_i        (1'b0),
      .read_en_i      (read_en && read_bank == 1'(bank)),
      .read_address_i (read_entry),
      .read_data_o    (read_planes[bank]),
      .write_en_i     (shade_phong_planes_valid_i && !shade_phong_planes_i.empty && bank_q == 1'(bank)),
      .write_address_i(entry),
      .write_data_i   (shade_phong_planes_i[PlanesBits-1:0])
    );
  end
endmodule
