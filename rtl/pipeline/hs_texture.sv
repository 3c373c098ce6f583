// SPDX-License-Identifier: Apache-2.0
// What texture adds to shading: planes of coordinates in a TdbS of their own, and a shader behind
// the one of colours.
//
//   attributes, texture_coordinates ─► texture_setup ─texture_planes─► TdbS
//                                                                        ▼
//                                      scan ─► queue ─► shade_texture ◄─ lit
//                                                             └─► pixel
//
// Words of `texture_coordinates` come for attributes that are not empty, in their order. Planes
// never wait. Stall: as its units. Textures and texels are written while no frame is in flight.
// A configuration without texture has no such unit: hs_formats_pkg has not its numbers then.
module hs_texture #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned ScanFifoDepth = 64,  // stamps on their way through the first shader
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned HeadBits = 1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned ScanBits = HeadBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = HeadBits + Lanes * 3 * ColourBits
) (
  input  logic                                                  clk_i,
  input  logic                                                  rst_ni,

  // Frame control: a frame's planes are stored
  output logic                                                  planes_last_o,

  // From geometry
  input  logic                                                  texture_valid_i,
  input  logic [hs_formats_pkg::TextureWordBits-1:0]            texture_i,
  input  logic                                                  texel_valid_i,
  input  logic [hs_formats_pkg::TexelWordBits-1:0]              texel_i,
  input  logic                                                  texture_coordinates_valid_i,
  output logic                                                  texture_coordinates_ready_o,
  input  logic [hs_formats_pkg::TextureCoordinatesWordBits-1:0] texture_coordinates_i,

  // From triangle_setup or visible_select
  input  logic                                                  attributes_valid_i,
  output logic                                                  attributes_ready_o,
  input  hs_formats_pkg::attributes_t                           attributes_i,

  // From scan_index
  input  logic                                                  scan_valid_i,
  output logic                                                  scan_ready_o,
  input  logic [ScanBits-1:0]                                   scan_i,

  // From the shader of colours
  input  logic                                                  lit_valid_i,
  output logic                                                  lit_ready_o,
  input  logic [PixelBits-1:0]                                  lit_i,

  // To the frame
  output logic                                                  pixel_valid_o,
  input  logic                                                  pixel_ready_i,
  output logic [PixelBits-1:0]                                  pixel_o
);
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);
  localparam int unsigned PlanesBits = hs_formats_pkg::TexturePlanesWordBits;
  localparam int unsigned EntryPlanesBits = PlanesBits - 2 - IndexBits;

  // --- attributes ─► planes ---
  logic sent_planes_valid, sent_planes_ready, planes_valid;
  logic [PlanesBits-1:0] sent_planes, planes;

  hs_texture_setup #(
    .CoordinateBits(hs_formats_pkg::CoordinateBits)
  ) u_texture_setup (
    .clk_i                      (clk_i),
    .rst_ni                     (rst_ni),
    .attributes_valid_i         (attributes_valid_i),
    .attributes_ready_o         (attributes_ready_o),
    .attributes_i               (attributes_i),
    .texture_coordinates_valid_i(texture_coordinates_valid_i),
    .texture_coordinates_ready_o(texture_coordinates_ready_o),
    .texture_coordinates_i      (texture_coordinates_i),
    .texture_planes_valid_o     (sent_planes_valid),
    .texture_planes_ready_i     (sent_planes_ready),
    .texture_planes_o           (sent_planes)
  );

  hs_stream #(
    .Width(PlanesBits)
  ) u_stream_texture_planes (
    .valid_i(sent_planes_valid),
    .ready_o(sent_planes_ready),
    .word_i (sent_planes),
    .valid_o(planes_valid),
    .ready_i(1'b1),
    .word_o (planes)
  );

  // --- TdbS ---
  logic read_en, read_bank, store_bank_q;
  logic [EntryBits-1:0] read_entry;
  logic [EntryPlanesBits-1:0] read_planes;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) store_bank_q <= 1'b0;
    else if (planes_last_o) store_bank_q <= !store_bank_q;
  end

  hs_planes_database #(
    .PlanesBits(PlanesBits)
  ) u_texture_database (
    .clk_i         (clk_i),
    .planes_valid_i(planes_valid),
    .planes_i      (planes),
    .planes_bank_i (store_bank_q),
    .planes_last_o (planes_last_o),
    .read_en_i     (read_en),
    .read_bank_i   (read_bank),
    .read_entry_i  (read_entry),
    .read_planes_o (read_planes)
  );

  // --- scan, lit ─► pixel ---
  logic scan_valid, scan_ready, lit_valid, lit_ready;
  logic [ScanBits-1:0] scan;
  logic [PixelBits-1:0] lit;

  hs_fifo #(
    .Width(ScanBits),
    .Depth(ScanFifoDepth)
  ) u_scan_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (scan_valid_i),
    .in_ready_o (scan_ready_o),
    .in_i       (scan_i),
    .out_valid_o(scan_valid),
    .out_ready_i(scan_ready),
    .out_o      (scan)
  );

  hs_stream #(
    .Width(PixelBits)
  ) u_stream_lit (
    .valid_i(lit_valid_i),
    .ready_o(lit_ready_o),
    .word_i (lit_i),
    .valid_o(lit_valid),
    .ready_i(lit_ready),
    .word_o (lit)
  );

  hs_shade_texture #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_shade_texture (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .texture_valid_i(texture_valid_i),
    .texture_i      (texture_i),
    .texel_valid_i  (texel_valid_i),
    .texel_i        (texel_i),
    .scan_valid_i   (scan_valid),
    .scan_ready_o   (scan_ready),
    .scan_i         (scan),
    .lit_valid_i    (lit_valid),
    .lit_ready_o    (lit_ready),
    .lit_i          (lit),
    .read_en_o      (read_en),
    .read_bank_o    (read_bank),
    .read_entry_o   (read_entry),
    .read_planes_i  (read_planes),
    .pixel_valid_o  (pixel_valid_o),
    .pixel_ready_i  (pixel_ready_i),
    .pixel_o        (pixel_o)
  );
endmodule
