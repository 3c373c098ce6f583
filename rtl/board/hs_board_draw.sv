// SPDX-License-Identifier: Apache-2.0
// The pipeline of a small FPGA: the units of hs_pipeline, of one lane, with as little between them
// as they need, and the buffers of the frame in single-port memories.
//
//   triangle ─► triangle_setup ─► raster_pineda ─► ztest_index ─► I-buffer, Z-buffer
//                     └─► shade_setup ─► TdbS                          ▼
//                                          └─► shade_gouraud ◄─── scan_index
//                                                    ▼
//                                                  pixel
//
// There are no queues: a unit waits where hs_pipeline would work ahead, and `visible` is let go.
// Of configurations of type delta without lighting, texture, motion, objects and index_window.
// Buffers: hs_board_memory, with fast_i and second_i as there.
module hs_board_draw #(
  parameter int unsigned WordEntries = 1,  // of the I-buffer, in a word of its memory
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned HeadBits = 1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned PixelBits = HeadBits + 3 * ColourBits
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      fast_i,
  input  logic                      second_i,

  input  logic [3*ColourBits-1:0]   background_i,  // {r, g, b}

  // From geometry
  input  logic                      triangle_valid_i,
  output logic                      triangle_ready_o,
  input  hs_formats_pkg::triangle_t triangle_i,

  // To the display, in the order of scan
  output logic                      pixel_valid_o,
  input  logic                      pixel_ready_i,
  output logic [PixelBits-1:0]      pixel_o
);
  localparam int unsigned Depth = hs_formats_pkg::MaxWidth * hs_formats_pkg::MaxHeight;
  localparam int unsigned AddressBits = $clog2(Depth);
  localparam int unsigned DepthsBits = hs_formats_pkg::HasDepth != 0 ? DepthBits : 1;
  localparam int unsigned StampBits = 1 + HeadBits + IndexBits + 1 + DepthBits;
  localparam int unsigned UpdateBits = StampBits - 2;
  localparam int unsigned ScanBits = HeadBits + IndexBits;
  localparam int unsigned PlanesBits = hs_formats_pkg::PlanesWordBits;
  localparam int unsigned EntryPlanesBits = PlanesBits - 2 - IndexBits;
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);

  if (hs_formats_pkg::StoresDepth != hs_formats_pkg::HasDepth || hs_formats_pkg::Deferred != 0
      || hs_formats_pkg::HasObjects != 0 || hs_formats_pkg::GivesIndices != 0) begin : gen_illegal
    $error("hs_board_draw: the configuration has units that are not here");
  end

  hs_formats_pkg::x_t frame_width;
  hs_formats_pkg::y_t frame_height;
  assign frame_width = hs_formats_pkg::XBits'(hs_formats_pkg::MaxWidth);
  assign frame_height = hs_formats_pkg::YBits'(hs_formats_pkg::MaxHeight);

  // --- Frames ---
  logic open, busy, start_valid, start_ready, start_clear, scan_bank, planes_bank, planes_last;
  logic setup_triangle_ready, visible_valid;
  hs_formats_pkg::visible_t visible;

  assign triangle_ready_o = open && setup_triangle_ready;

  hs_frame_control u_frame_control (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .open_o         (open),
    .busy_o         (busy),
    .triangle_i     (triangle_valid_i && triangle_ready_o),
    .triangle_last_i(triangle_i.last),
    .visible_last_i (visible_valid && visible.last),
    .planes_last_i  (planes_last),
    .stored_last_i  (planes_last),
    .pixel_last_i   (pixel_valid_o && pixel_ready_i && pixel_o[PixelBits-1]),
    .start_valid_o  (start_valid),
    .start_ready_i  (start_ready),
    .start_clear_o  (start_clear),
    .scan_bank_o    (scan_bank),
    .planes_bank_o  (planes_bank)
  );

  // --- Triangles into the I-buffer ---
  logic setup_valid, setup_ready, attributes_valid, attributes_ready, stamp_valid, stamp_ready;
  hs_formats_pkg::setup_t setup;
  hs_formats_pkg::attributes_t attributes;
  logic [StampBits-1:0] stamp;

  hs_triangle_setup #(
    .LanesX(1),
    .LanesY(1)
  ) u_triangle_setup (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .frame_width_i     (frame_width),
    .frame_height_i    (frame_height),
    .triangle_valid_i  (triangle_valid_i && open),
    .triangle_ready_o  (setup_triangle_ready),
    .triangle_i        (triangle_i),
    .setup_valid_o     (setup_valid),
    .setup_ready_i     (setup_ready),
    .setup_o           (setup),
    .attributes_valid_o(attributes_valid),
    .attributes_ready_i(attributes_ready),
    .attributes_o      (attributes)
  );

  logic unused_triangle_depth_valid, unused_triangle_depth;

  hs_raster_pineda #(
    .LanesX(1),
    .LanesY(1)
  ) u_raster_pineda (
    .clk_i                 (clk_i),
    .rst_ni                (rst_ni),
    .frame_width_i         (frame_width),
    .frame_height_i        (frame_height),
    .setup_valid_i         (setup_valid),
    .setup_ready_o         (setup_ready),
    .setup_i               (setup),
    .triangle_depth_valid_o(unused_triangle_depth_valid),
    .triangle_depth_ready_i(1'b1),
    .triangle_depth_o      (unused_triangle_depth),
    .stamp_valid_o         (stamp_valid),
    .stamp_ready_i         (stamp_ready),
    .stamp_o               (stamp)
  );

  logic read_en, read_bank, write_en, write_bank, unused_update_valid;
  logic [AddressBits-1:0] read_address, write_address, scan_address;
  logic [IndexBits-1:0] read_index, scan_index;
  hs_formats_pkg::index_t write_index;
  logic [DepthsBits-1:0] read_depth, write_depth;
  logic [UpdateBits-1:0] unused_update;
  logic scan_read_en, scan_write_en;

  hs_ztest_index #(
    .LanesX(1),
    .LanesY(1)
  ) u_ztest_index (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .stamp_valid_i  (stamp_valid),
    .stamp_ready_o  (stamp_ready),
    .stamp_i        (stamp),
    .visible_valid_o(visible_valid),
    .visible_ready_i(1'b1),
    .visible_o      (visible),
    .update_valid_o (unused_update_valid),
    .update_o       (unused_update),
    .read_en_o      (read_en),
    .read_bank_o    (read_bank),
    .read_address_o (read_address),
    .read_index_i   (read_index),
    .read_depth_i   (read_depth),
    .write_en_o     (write_en),
    .write_bank_o   (write_bank),
    .write_address_o(write_address),
    .write_index_o  (write_index),
    .write_depth_o  (write_depth)
  );

  logic unused_visible;
  assign unused_visible = ^{visible, busy};

  hs_board_banks #(
    .Width      (IndexBits),
    .Depth      (Depth),
    .WordEntries(WordEntries)
  ) u_index_buffer (
    .clk_i                (clk_i),
    .rst_ni               (rst_ni),
    .fast_i               (fast_i),
    .second_i             (second_i),
    .ztest_read_en_i      (read_en),
    .ztest_read_bank_i    (read_bank),
    .ztest_read_address_i (read_address),
    .ztest_read_data_o    (read_index),
    .ztest_write_en_i     (write_en),
    .ztest_write_bank_i   (write_bank),
    .ztest_write_address_i(write_address),
    .ztest_write_data_i   (write_index),
    .scan_bank_i          (scan_bank),
    .scan_read_en_i       (scan_read_en),
    .scan_write_en_i      (scan_write_en),
    .scan_address_i       (scan_address),
    .scan_read_data_o     (scan_index)
  );

  if (hs_formats_pkg::HasDepth != 0) begin : gen_depth
    hs_board_memory #(
      .Width(DepthsBits),
      .Depth(Depth)
    ) u_depth_buffer (
      .clk_i          (clk_i),
      .fast_i         (fast_i),
      .second_i       (second_i),
      .read_en_i      (read_en),
      .read_address_i (read_address),
      .read_data_o    (read_depth),
      .write_en_i     (write_en),
      .write_address_i(write_address),
      .write_data_i   (write_depth)
    );
  end else begin : gen_no_depth
    logic unused_depth;
    assign unused_depth = ^write_depth;
    assign read_depth = '0;
  end

  // --- What a triangle is shaded with, into TdbS ---
  logic planes_valid, planes_read_en, planes_read_bank, unused_colours_ready;
  logic [PlanesBits-1:0] planes;
  logic [EntryBits-1:0] planes_read_entry;
  logic [EntryPlanesBits-1:0] read_planes;

  hs_shade_setup u_shade_setup (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .attributes_valid_i(attributes_valid),
    .attributes_ready_o(attributes_ready),
    .attributes_i      (attributes),
    .colours_valid_i   (1'b0),
    .colours_ready_o   (unused_colours_ready),
    .colours_i         ('0),
    .planes_valid_o    (planes_valid),
    .planes_ready_i    (1'b1),
    .planes_o          (planes)
  );

  hs_planes_database #(
    .PlanesBits(PlanesBits)
  ) u_shading_database (
    .clk_i         (clk_i),
    .planes_valid_i(planes_valid),
    .planes_i      (planes),
    .planes_bank_i (planes_bank),
    .planes_last_o (planes_last),
    .read_en_i     (planes_read_en),
    .read_bank_i   (planes_read_bank),
    .read_entry_i  (planes_read_entry),
    .read_planes_o (read_planes)
  );

  // --- The I-buffer out as pixels ---
  logic scan_valid, scan_ready;
  logic [ScanBits-1:0] scan;

  hs_scan_index #(
    .LanesX(1),
    .LanesY(1)
  ) u_scan_index (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .frame_width_i (frame_width),
    .frame_height_i(frame_height),
    .start_valid_i (start_valid),
    .start_ready_o (start_ready),
    .start_clear_i (start_clear),
    .scan_valid_o  (scan_valid),
    .scan_ready_i  (scan_ready),
    .scan_o        (scan),
    .read_en_o     (scan_read_en),
    .write_en_o    (scan_write_en),
    .address_o     (scan_address),
    .read_index_i  (scan_index)
  );

  hs_shade_gouraud #(
    .LanesX(1),
    .LanesY(1)
  ) u_shade_gouraud (
    .clk_i        (clk_i),
    .rst_ni       (rst_ni),
    .background_i (background_i),
    .scan_valid_i (scan_valid),
    .scan_ready_o (scan_ready),
    .scan_i       (scan),
    .read_en_o    (planes_read_en),
    .read_bank_o  (planes_read_bank),
    .read_entry_o (planes_read_entry),
    .read_planes_i(read_planes),
    .pixel_valid_o(pixel_valid_o),
    .pixel_ready_i(pixel_ready_i),
    .pixel_o      (pixel_o)
  );
endmodule
