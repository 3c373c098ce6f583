// SPDX-License-Identifier: Apache-2.0
// The units of a frame between key frames, each alone, for the bench: as hs_units, which has what shades.
//
//   motion_setup
//   motion_field   `motion_planes` words go into TdbS before the scan
module hs_motion_units #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles),
  localparam int unsigned PlanesBits = hs_formats_pkg::MotionPlanesWordBits - 2 - IndexBits
) (
  input  logic                                 rst_ni,
  input  hs_formats_pkg::x_t                   frame_width_i,
  input  hs_formats_pkg::y_t                   frame_height_i,
  input  logic [3*hs_formats_pkg::ColourBits-1:0] background_i,

  input  logic                                 motion_setup_clk_i,
  input  logic                                 motion_setup_visible_attributes_valid_i,
  output logic                                 motion_setup_visible_attributes_ready_o,
  input  hs_formats_pkg::attributes_t          motion_setup_visible_attributes_i,
  input  logic                                 motion_setup_motion_vectors_valid_i,
  output logic                                 motion_setup_motion_vectors_ready_o,
  input  hs_formats_pkg::motion_vectors_t      motion_setup_motion_vectors_i,
  output logic                                 motion_setup_motion_planes_valid_o,
  input  logic                                 motion_setup_motion_planes_ready_i,
  output hs_formats_pkg::motion_planes_t       motion_setup_motion_planes_o,

  input  logic                                 motion_field_clk_i,
  input  logic                                 motion_field_motion_planes_valid_i,
  input  hs_formats_pkg::motion_planes_t       motion_field_motion_planes_i,
  input  logic                                 motion_field_scan_valid_i,
  output logic                                 motion_field_scan_ready_o,
  input  logic [ScanBits-1:0]                  motion_field_scan_i,
  output logic                                 motion_field_motion_valid_o,
  input  logic                                 motion_field_motion_ready_i,
  output hs_formats_pkg::motion_t              motion_field_motion_o
);
  logic unused_registers;
  assign unused_registers = ^{frame_width_i, frame_height_i, background_i};

  hs_motion_setup #(
    .FaceBits(hs_formats_pkg::FaceBits)
  ) u_motion_setup (
    .clk_i                 (motion_setup_clk_i),
    .rst_ni                (rst_ni),
    .attributes_valid_i    (motion_setup_visible_attributes_valid_i),
    .attributes_ready_o    (motion_setup_visible_attributes_ready_o),
    .attributes_i          (motion_setup_visible_attributes_i),
    .motion_vectors_valid_i(motion_setup_motion_vectors_valid_i),
    .motion_vectors_ready_o(motion_setup_motion_vectors_ready_o),
    .motion_vectors_i      (motion_setup_motion_vectors_i),
    .motion_planes_valid_o (motion_setup_motion_planes_valid_o),
    .motion_planes_ready_i (motion_setup_motion_planes_ready_i),
    .motion_planes_o       (motion_setup_motion_planes_o)
  );

  // motion_field, with two TdbS banks that `motion_planes` words fill before the scan; `last` ends a frame's words.
  logic read_en, read_bank, read_bank_q, bank_q;
  logic [EntryBits-1:0] read_entry;
  logic [PlanesBits-1:0] read_planes [2];
  logic [EntryBits-1:0] entry;

  assign entry = EntryBits'(motion_field_motion_planes_i.index) - EntryBits'(1);

  hs_motion_field #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_motion_field (
    .clk_i         (motion_field_clk_i),
    .rst_ni        (rst_ni),
    .scan_valid_i  (motion_field_scan_valid_i),
    .scan_ready_o  (motion_field_scan_ready_o),
    .scan_i        (motion_field_scan_i),
    .read_en_o     (read_en),
    .read_bank_o   (read_bank),
    .read_entry_o  (read_entry),
    .read_planes_i (read_planes[read_bank_q]),
    .motion_valid_o(motion_field_motion_valid_o),
    .motion_ready_i(motion_field_motion_ready_i),
    .motion_o      (motion_field_motion_o)
  );

  always_ff @(posedge motion_field_clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      bank_q <= 1'b0;
      read_bank_q <= 1'b0;
    end else begin
      if (motion_field_motion_planes_valid_i && motion_field_motion_planes_i.last) bank_q <= !bank_q;
      if (read_en) read_bank_q <= read_bank;
    end
  end

  for (genvar bank = 0; bank < 2; bank++) begin : gen_bank
    hs_bench_ram #(
      .Width(PlanesBits),
      .Depth(hs_formats_pkg::Triangles)
    ) u_planes (
      .clk_i          (motion_field_clk_i),
      .clear_i        (1'b0),
      .read_en_i      (read_en && read_bank == 1'(bank)),
      .read_address_i (read_entry),
      .read_data_o    (read_planes[bank]),
      .write_en_i     (motion_field_motion_planes_valid_i && !motion_field_motion_planes_i.empty &&
                       bank_q == 1'(bank)),
      .write_address_i(entry),
      .write_data_i   (motion_field_motion_planes_i[PlanesBits-1:0])
    );
  end
endmodule
