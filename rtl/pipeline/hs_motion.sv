// SPDX-License-Identifier: Apache-2.0
// What stands in the place of hs_shading where a frame lies between key frames: the planes of where
// its triangles are in these into TdbS, and the finished I-buffer's stamps into motion.
//
//   attributes, motion_vectors ─► motion_setup ─motion_planes─► TdbS ─► motion_field ◄─ scan
//                                                                             └─► motion
//
// Words of `motion_vectors` come for attributes that are not empty, in their order. Planes never
// wait. Stall: as its units.
// A configuration without motion has no such unit: hs_formats_pkg has not its numbers then.
module hs_motion #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned AttributesFifoDepth = 4,
  parameter int unsigned ScanFifoDepth = 4,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ScanBits =
      1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits + Lanes * IndexBits
) (
  input  logic                                             clk_i,
  input  logic                                             rst_ni,

  // Frame control: the bank of TdbS to store to; a frame's planes are stored
  input  logic                                             planes_bank_i,
  output logic                                             planes_last_o,

  // From geometry
  input  logic                                             motion_vectors_valid_i,
  output logic                                             motion_vectors_ready_o,
  input  logic [hs_formats_pkg::MotionVectorsWordBits-1:0] motion_vectors_i,

  // From visible_select
  input  logic                                             attributes_valid_i,
  output logic                                             attributes_ready_o,
  input  hs_formats_pkg::attributes_t                      attributes_i,

  // From scan_index
  input  logic                                             scan_valid_i,
  output logic                                             scan_ready_o,
  input  logic [ScanBits-1:0]                              scan_i,

  // To the motion buffer
  output logic                                             motion_valid_o,
  input  logic                                             motion_ready_i,
  output logic [hs_formats_pkg::MotionWordBits-1:0]        motion_o
);
  localparam int unsigned PlanesBits = hs_formats_pkg::MotionPlanesWordBits;
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);
  localparam int unsigned EntryPlanesBits = PlanesBits - 2 - IndexBits;

  // --- attributes ─► planes ---
  logic setup_valid, setup_ready, sent_planes_valid, sent_planes_ready, planes_valid;
  hs_formats_pkg::attributes_t setup_attributes;
  logic [PlanesBits-1:0] sent_planes, planes;

  hs_fifo #(
    .Width($bits(attributes_i)),
    .Depth(AttributesFifoDepth)
  ) u_attributes_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (attributes_valid_i),
    .in_ready_o (attributes_ready_o),
    .in_i       (attributes_i),
    .out_valid_o(setup_valid),
    .out_ready_i(setup_ready),
    .out_o      (setup_attributes)
  );

  hs_motion_setup #(
    .FaceBits(hs_formats_pkg::FaceBits)
  ) u_motion_setup (
    .clk_i                 (clk_i),
    .rst_ni                (rst_ni),
    .attributes_valid_i    (setup_valid),
    .attributes_ready_o    (setup_ready),
    .attributes_i          (setup_attributes),
    .motion_vectors_valid_i(motion_vectors_valid_i),
    .motion_vectors_ready_o(motion_vectors_ready_o),
    .motion_vectors_i      (motion_vectors_i),
    .motion_planes_valid_o (sent_planes_valid),
    .motion_planes_ready_i (sent_planes_ready),
    .motion_planes_o       (sent_planes)
  );

  hs_stream #(
    .Width(PlanesBits)
  ) u_stream_motion_planes (
    .valid_i(sent_planes_valid),
    .ready_o(sent_planes_ready),
    .word_i (sent_planes),
    .valid_o(planes_valid),
    .ready_i(1'b1),
    .word_o (planes)
  );

  // --- TdbS ---
  logic read_en, read_bank;
  logic [EntryBits-1:0] read_entry;
  logic [EntryPlanesBits-1:0] read_planes;

  hs_planes_database #(
    .PlanesBits(PlanesBits)
  ) u_motion_database (
    .clk_i         (clk_i),
    .planes_valid_i(planes_valid),
    .planes_i      (planes),
    .planes_bank_i (planes_bank_i),
    .planes_last_o (planes_last_o),
    .read_en_i     (read_en),
    .read_bank_i   (read_bank),
    .read_entry_i  (read_entry),
    .read_planes_o (read_planes)
  );

  // --- scan ─► motion ---
  logic field_scan_valid, field_scan_ready;
  logic [ScanBits-1:0] field_scan;

  hs_fifo #(
    .Width(ScanBits),
    .Depth(ScanFifoDepth)
  ) u_scan_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (scan_valid_i),
    .in_ready_o (scan_ready_o),
    .in_i       (scan_i),
    .out_valid_o(field_scan_valid),
    .out_ready_i(field_scan_ready),
    .out_o      (field_scan)
  );

  hs_motion_field #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_motion_field (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .scan_valid_i  (field_scan_valid),
    .scan_ready_o  (field_scan_ready),
    .scan_i        (field_scan),
    .read_en_o     (read_en),
    .read_bank_o   (read_bank),
    .read_entry_o  (read_entry),
    .read_planes_i (read_planes),
    .motion_valid_o(motion_valid_o),
    .motion_ready_i(motion_ready_i),
    .motion_o      (motion_o)
  );
endmodule
