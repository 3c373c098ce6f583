// SPDX-License-Identifier: Apache-2.0
// Each unit alone, for the bench: streams as flat ports <unit>_<stream>_valid_i and so on, a clock a unit so that
// one unit runs while the others cost nothing, and the buffers that a unit reads and writes.
//
//   ztest          ztest_index or ztest_plane, whichever the pipeline has
//                  clear_i: 0 into the I-buffer bank of the next frame; the other bank keeps the frame before
//   scan_index     clear_i: 0 into the I-buffer; `update` words are written into it
//   shade_gouraud  `planes` words are stored in TdbS
module hs_units #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * DepthBits : 1,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned PlanesBits = (hs_formats_pkg::Gouraud != 0 ? 9 : 3) * hs_formats_pkg::ColourPlaneBits,
  localparam int unsigned StampHeadBits = $bits(hs_formats_pkg::stamp_head_t),
  localparam int unsigned UpdateHeadBits = $bits(hs_formats_pkg::update_head_t),
  localparam int unsigned ScanHeadBits = $bits(hs_formats_pkg::scan_head_t),
  localparam int unsigned PixelHeadBits = $bits(hs_formats_pkg::pixel_head_t),
  localparam int unsigned StampBits = StampHeadBits + Lanes * (1 + DepthBits),
  localparam int unsigned UpdateBits =
      UpdateHeadBits + Lanes * (1 + (hs_formats_pkg::StoresDepth != 0 ? DepthBits : 0)),
  localparam int unsigned TestsPlanes = HasDepth != 0 && hs_formats_pkg::StoresDepth == 0 ? 1 : 0,
  localparam int unsigned TriangleDepthBits =
      TestsPlanes != 0 ? IndexBits + hs_formats_pkg::XBits + hs_formats_pkg::YBits + 3 * hs_formats_pkg::DepthPlaneBits : 1,
  localparam int unsigned ScanBits = ScanHeadBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = PixelHeadBits + Lanes * 3 * ColourBits
) (
  input  logic                        rst_ni,
  input  hs_formats_pkg::x_t          frame_width_i,
  input  hs_formats_pkg::y_t          frame_height_i,
  input  logic [3*ColourBits-1:0]     background_i,

  input  logic                        triangle_setup_clk_i,
  input  logic                        triangle_setup_triangle_valid_i,
  output logic                        triangle_setup_triangle_ready_o,
  input  hs_formats_pkg::triangle_t   triangle_setup_triangle_i,
  output logic                        triangle_setup_setup_valid_o,
  input  logic                        triangle_setup_setup_ready_i,
  output hs_formats_pkg::setup_t      triangle_setup_setup_o,
  output logic                        triangle_setup_attributes_valid_o,
  input  logic                        triangle_setup_attributes_ready_i,
  output hs_formats_pkg::attributes_t triangle_setup_attributes_o,

  input  logic                        shade_setup_clk_i,
  input  logic                        shade_setup_attributes_valid_i,
  output logic                        shade_setup_attributes_ready_o,
  input  hs_formats_pkg::attributes_t shade_setup_attributes_i,
  output logic                        shade_setup_planes_valid_o,
  input  logic                        shade_setup_planes_ready_i,
  output hs_formats_pkg::planes_t     shade_setup_planes_o,

  input  logic                        raster_pineda_clk_i,
  input  logic                        raster_pineda_setup_valid_i,
  output logic                        raster_pineda_setup_ready_o,
  input  hs_formats_pkg::setup_t      raster_pineda_setup_i,
  output logic                        raster_pineda_triangle_depth_valid_o,
  input  logic                        raster_pineda_triangle_depth_ready_i,
  output logic [TriangleDepthBits-1:0] raster_pineda_triangle_depth_o,
  output logic                        raster_pineda_stamp_valid_o,
  input  logic                        raster_pineda_stamp_ready_i,
  output logic [StampBits-1:0]        raster_pineda_stamp_o,

  input  logic                        ztest_clk_i,
  input  logic                        ztest_clear_i,
  input  logic                        ztest_triangle_depth_valid_i,
  output logic                        ztest_triangle_depth_ready_o,
  input  logic [TriangleDepthBits-1:0] ztest_triangle_depth_i,
  input  logic                        ztest_stamp_valid_i,
  output logic                        ztest_stamp_ready_o,
  input  logic [StampBits-1:0]        ztest_stamp_i,
  output logic                        ztest_update_valid_o,
  output logic [UpdateBits-1:0]       ztest_update_o,
  output logic                        ztest_visible_valid_o,
  input  logic                        ztest_visible_ready_i,
  output hs_formats_pkg::visible_t    ztest_visible_o,

  input  logic                        scan_index_clk_i,
  input  logic                        scan_index_clear_i,
  input  logic                        scan_index_update_valid_i,
  input  logic [UpdateBits-1:0]       scan_index_update_i,
  input  logic                        scan_index_start_valid_i,
  output logic                        scan_index_start_ready_o,
  input  logic                        scan_index_start_clear_i,
  output logic                        scan_index_scan_valid_o,
  input  logic                        scan_index_scan_ready_i,
  output logic [ScanBits-1:0]         scan_index_scan_o,

  input  logic                        shade_gouraud_clk_i,
  input  logic                        shade_gouraud_planes_valid_i,
  input  hs_formats_pkg::planes_t     shade_gouraud_planes_i,
  input  logic                        shade_gouraud_scan_valid_i,
  output logic                        shade_gouraud_scan_ready_o,
  input  logic [ScanBits-1:0]         shade_gouraud_scan_i,
  output logic                        shade_gouraud_pixel_valid_o,
  input  logic                        shade_gouraud_pixel_ready_i,
  output logic [PixelBits-1:0]        shade_gouraud_pixel_o
);
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX;
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY;
  localparam int unsigned Stamps = StampsX * StampsY;
  localparam int unsigned AddressBits = $clog2(Stamps);
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);

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

  logic unused_colours_ready;
  hs_shade_setup u_shade_setup (
    .clk_i             (shade_setup_clk_i),
    .rst_ni            (rst_ni),
    .attributes_valid_i(shade_setup_attributes_valid_i),
    .attributes_ready_o(shade_setup_attributes_ready_o),
    .attributes_i      (shade_setup_attributes_i),
    .colours_valid_i   (1'b0),
    .colours_ready_o   (unused_colours_ready),
    .colours_i         ('0),
    .planes_valid_o    (shade_setup_planes_valid_o),
    .planes_ready_i    (shade_setup_planes_ready_i),
    .planes_o          (shade_setup_planes_o)
  );

  hs_raster_pineda #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_raster_pineda (
    .clk_i         (raster_pineda_clk_i),
    .rst_ni        (rst_ni),
    .frame_width_i (frame_width_i),
    .frame_height_i(frame_height_i),
    .setup_valid_i (raster_pineda_setup_valid_i),
    .setup_ready_o (raster_pineda_setup_ready_o),
    .setup_i       (raster_pineda_setup_i),
    .triangle_depth_valid_o(raster_pineda_triangle_depth_valid_o),
    .triangle_depth_ready_i(raster_pineda_triangle_depth_ready_i),
    .triangle_depth_o      (raster_pineda_triangle_depth_o),
    .stamp_valid_o (raster_pineda_stamp_valid_o),
    .stamp_ready_i (raster_pineda_stamp_ready_i),
    .stamp_o       (raster_pineda_stamp_o)
  );

  // The Z-test, with two I-buffer banks and TdbV or, if it looks at one, a Z-buffer.
  logic ztest_read_en, ztest_read_bank, ztest_read_bank_q, ztest_write_bank, ztest_clear_bank_q;
  logic [AddressBits-1:0] ztest_read_address, ztest_write_address;
  logic [Lanes*IndexBits-1:0] ztest_read_index [2];
  logic [Lanes-1:0] ztest_write_en;
  hs_formats_pkg::index_t ztest_write_index;

  if (TestsPlanes != 0) begin : gen_ztest_plane
    logic fetch_en, store_en;
    logic [EntryBits-1:0] fetch_entry, store_entry;
    logic [3*hs_formats_pkg::DepthPlaneBits-1:0] fetch_plane, store_plane;

    hs_ztest_plane #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_ztest_plane (
      .clk_i                 (ztest_clk_i),
      .rst_ni                (rst_ni),
      .triangle_depth_valid_i(ztest_triangle_depth_valid_i),
      .triangle_depth_ready_o(ztest_triangle_depth_ready_o),
      .triangle_depth_i      (ztest_triangle_depth_i),
      .stamp_valid_i         (ztest_stamp_valid_i),
      .stamp_ready_o         (ztest_stamp_ready_o),
      .stamp_i               (ztest_stamp_i),
      .update_valid_o        (ztest_update_valid_o),
      .update_o              (ztest_update_o),
      .visible_valid_o       (ztest_visible_valid_o),
      .visible_ready_i       (ztest_visible_ready_i),
      .visible_o             (ztest_visible_o),
      .read_en_o             (ztest_read_en),
      .read_bank_o           (ztest_read_bank),
      .read_address_o        (ztest_read_address),
      .read_index_i          (ztest_read_index[ztest_read_bank_q]),
      .write_en_o            (ztest_write_en),
      .write_bank_o          (ztest_write_bank),
      .write_address_o       (ztest_write_address),
      .write_index_o         (ztest_write_index),
      .fetch_en_o            (fetch_en),
      .fetch_entry_o         (fetch_entry),
      .fetch_plane_i         (fetch_plane),
      .store_en_o            (store_en),
      .store_entry_o         (store_entry),
      .store_plane_o         (store_plane)
    );

    hs_bench_ram #(
      .Width(3 * hs_formats_pkg::DepthPlaneBits),
      .Depth(hs_formats_pkg::Triangles)
    ) u_visibility (
      .clk_i          (ztest_clk_i),
      .clear_i        (1'b0),
      .read_en_i      (fetch_en),
      .read_address_i (fetch_entry),
      .read_data_o    (fetch_plane),
      .write_en_i     (store_en),
      .write_address_i(store_entry),
      .write_data_i   (store_plane)
    );
  end else begin : gen_ztest_index
    logic [DepthsBits-1:0] ztest_read_depth, ztest_write_depth;
    logic unused_triangle_depth;

    assign unused_triangle_depth = ^{ztest_triangle_depth_valid_i, ztest_triangle_depth_i};
    assign ztest_triangle_depth_ready_o = 1'b1;

    hs_ztest_index #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_ztest_index (
      .clk_i          (ztest_clk_i),
      .rst_ni         (rst_ni),
      .stamp_valid_i  (ztest_stamp_valid_i),
      .stamp_ready_o  (ztest_stamp_ready_o),
      .stamp_i        (ztest_stamp_i),
      .visible_valid_o(ztest_visible_valid_o),
      .visible_ready_i(ztest_visible_ready_i),
      .visible_o      (ztest_visible_o),
      .update_valid_o (ztest_update_valid_o),
      .update_o       (ztest_update_o),
      .read_en_o      (ztest_read_en),
      .read_bank_o    (ztest_read_bank),
      .read_address_o (ztest_read_address),
      .read_index_i   (ztest_read_index[ztest_read_bank_q]),
      .read_depth_i   (ztest_read_depth),
      .write_en_o     (ztest_write_en),
      .write_bank_o   (ztest_write_bank),
      .write_address_o(ztest_write_address),
      .write_index_o  (ztest_write_index),
      .write_depth_o  (ztest_write_depth)
    );

    if (HasDepth != 0) begin : gen_ztest_depth
      hs_bench_ram #(
        .Width(DepthsBits),
        .Depth(Stamps),
        .Lanes(Lanes)
      ) u_ztest_depth (
        .clk_i          (ztest_clk_i),
        .clear_i        (1'b0),
        .read_en_i      (ztest_read_en),
        .read_address_i (ztest_read_address),
        .read_data_o    (ztest_read_depth),
        .write_en_i     (ztest_write_en),
        .write_address_i(ztest_write_address),
        .write_data_i   (ztest_write_depth)
      );
    end else begin : gen_no_ztest_depth
      assign ztest_read_depth = 1'b1;  // nobody looks at it
    end
  end

  always_ff @(posedge ztest_clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      ztest_clear_bank_q <= 1'b0;
      ztest_read_bank_q <= 1'b0;
    end else begin
      if (ztest_clear_i) ztest_clear_bank_q <= !ztest_clear_bank_q;
      if (ztest_read_en) ztest_read_bank_q <= ztest_read_bank;
    end
  end

  for (genvar bank = 0; bank < 2; bank++) begin : gen_ztest_bank
    hs_bench_ram #(
      .Width(Lanes * IndexBits),
      .Depth(Stamps),
      .Lanes(Lanes)
    ) u_index (
      .clk_i          (ztest_clk_i),
      .clear_i        (ztest_clear_i && ztest_clear_bank_q == 1'(bank)),
      .read_en_i      (ztest_read_en && ztest_read_bank == 1'(bank)),
      .read_address_i (ztest_read_address),
      .read_data_o    (ztest_read_index[bank]),
      .write_en_i     (ztest_write_bank == 1'(bank) ? ztest_write_en : '0),
      .write_address_i(ztest_write_address),
      .write_data_i   ({Lanes{ztest_write_index}})
    );
  end

  // scan_index, with an I-buffer that `update` words fill before the scan.
  logic scan_read_en, scan_write_en;
  logic [AddressBits-1:0] scan_address, update_address;
  logic [Lanes*IndexBits-1:0] scan_read_index;
  hs_formats_pkg::update_head_t update_head;
  logic [Lanes-1:0] update_mask;

  assign {update_head, update_mask} = scan_index_update_i[UpdateBits-1-:UpdateHeadBits+Lanes];
  assign update_address = AddressBits'(update_head.y) * AddressBits'(StampsX) + AddressBits'(update_head.x);

  hs_scan_index #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_scan_index (
    .clk_i         (scan_index_clk_i),
    .rst_ni        (rst_ni),
    .frame_width_i (frame_width_i),
    .frame_height_i(frame_height_i),
    .start_valid_i (scan_index_start_valid_i),
    .start_ready_o (scan_index_start_ready_o),
    .start_clear_i (scan_index_start_clear_i),
    .scan_valid_o  (scan_index_scan_valid_o),
    .scan_ready_i  (scan_index_scan_ready_i),
    .scan_o        (scan_index_scan_o),
    .read_en_o     (scan_read_en),
    .write_en_o    (scan_write_en),
    .address_o     (scan_address),
    .read_index_i  (scan_read_index)
  );

  hs_bench_ram #(
    .Width(Lanes * IndexBits),
    .Depth(Stamps),
    .Lanes(Lanes)
  ) u_scan_buffer (
    .clk_i          (scan_index_clk_i),
    .clear_i        (scan_index_clear_i),
    .read_en_i      (scan_read_en),
    .read_address_i (scan_address),
    .read_data_o    (scan_read_index),
    .write_en_i     (scan_index_update_valid_i ? update_mask : {Lanes{scan_write_en}}),
    .write_address_i(scan_index_update_valid_i ? update_address : scan_address),
    .write_data_i   (scan_index_update_valid_i ? {Lanes{update_head.index}} : '0)
  );

  // shade_gouraud, with two TdbS banks that `planes` words fill before the scan; `last` ends a frame's words.
  logic shade_read_en, shade_read_bank, shade_read_bank_q, planes_bank_q;
  logic [EntryBits-1:0] shade_read_entry;
  logic [PlanesBits-1:0] shade_read_planes [2];
  hs_formats_pkg::index_t planes_entry;

  assign planes_entry = shade_gouraud_planes_i.index - IndexBits'(1);

  hs_shade_gouraud #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_shade_gouraud (
    .clk_i        (shade_gouraud_clk_i),
    .rst_ni       (rst_ni),
    .background_i (background_i),
    .scan_valid_i (shade_gouraud_scan_valid_i),
    .scan_ready_o (shade_gouraud_scan_ready_o),
    .scan_i       (shade_gouraud_scan_i),
    .read_en_o    (shade_read_en),
    .read_bank_o  (shade_read_bank),
    .read_entry_o (shade_read_entry),
    .read_planes_i(shade_read_planes[shade_read_bank_q]),
    .pixel_valid_o(shade_gouraud_pixel_valid_o),
    .pixel_ready_i(shade_gouraud_pixel_ready_i),
    .pixel_o      (shade_gouraud_pixel_o)
  );

  always_ff @(posedge shade_gouraud_clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      planes_bank_q <= 1'b0;
      shade_read_bank_q <= 1'b0;
    end else begin
      if (shade_gouraud_planes_valid_i && shade_gouraud_planes_i.last) planes_bank_q <= !planes_bank_q;
      if (shade_read_en) shade_read_bank_q <= shade_read_bank;
    end
  end

  for (genvar bank = 0; bank < 2; bank++) begin : gen_shade_bank
    hs_bench_ram #(
      .Width(PlanesBits),
      .Depth(hs_formats_pkg::Triangles)
    ) u_planes (
      .clk_i          (shade_gouraud_clk_i),
      .clear_i        (1'b0),
      .read_en_i      (shade_read_en && shade_read_bank == 1'(bank)),
      .read_address_i (shade_read_entry),
      .read_data_o    (shade_read_planes[bank]),
      .write_en_i     (shade_gouraud_planes_valid_i && !shade_gouraud_planes_i.empty && planes_bank_q == 1'(bank)),
      .write_address_i(planes_entry[EntryBits-1:0]),
      .write_data_i   (shade_gouraud_planes_i[PlanesBits-1:0])
    );
  end
endmodule
