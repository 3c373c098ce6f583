// SPDX-License-Identifier: Apache-2.0
// The shading half of the pipeline: what a triangle is shaded with into TdbS, and the finished
// I-buffer's stamps into pixels.
//
//   attributes, colours in them           ─► shade_setup ─planes─┐
//   attributes, normals ─► light_vertex ─colours─► shade_setup ──┼─► TdbS ─► shade_gouraud ◄─ scan
//   attributes, normals                   ─► phong_setup ────────┘           or shade_phong ─► pixel
//
// The first way without lighting, the last with Phong shading. With texture there are a second
// setup, a second part of TdbS and a second shader, which takes the pixels of the first:
//
//   attributes, texture_coordinates ─► texture_setup ─texture_planes─► TdbS ─► shade_texture ◄─ scan, lit
//
// Words of `normals` and `texture_coordinates` come for attributes that are not empty, in their
// order. Planes never wait. Stall: as its units. Lights, materials, textures and texels are written
// while no frame is in flight.
module hs_shading #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned AttributesFifoDepth = 4,
  parameter int unsigned ColoursFifoDepth = 4,
  // With texture all that shade_texture takes before it looks at `lit`.
  parameter int unsigned ScanFifoDepth = hs_formats_pkg::HasTexture != 0 ? 32 : 4,
  parameter int unsigned TextureScanFifoDepth = 64,  // stamps on their way through the first shader
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = 1 + XBits + YBits + Lanes * 3 * ColourBits,
  localparam int unsigned LightWordBits = hs_formats_pkg::LightWordBits,
  localparam int unsigned MaterialWordBits = hs_formats_pkg::MaterialWordBits,
  localparam int unsigned NormalsBits = hs_formats_pkg::NormalsWordBits,
  localparam int unsigned ColoursBits = hs_formats_pkg::ColoursWordBits,
  localparam int unsigned ShadePlanesBits = hs_formats_pkg::PlanesWordBits,
  localparam int unsigned TextureWordBits = hs_formats_pkg::TextureWordBits,
  localparam int unsigned TexelWordBits = hs_formats_pkg::TexelWordBits,
  localparam int unsigned CoordinatesBits = hs_formats_pkg::TextureCoordinatesWordBits,
  localparam int unsigned TexturePlanesBits = hs_formats_pkg::TexturePlanesWordBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  input  logic [3*ColourBits-1:0]     background_i,  // {r, g, b}
  input  logic                        planes_bank_i,  // of TdbS, to store to

  // From geometry
  input  logic                        light_valid_i,
  input  logic [LightWordBits-1:0]    light_i,
  input  logic                        material_valid_i,
  input  logic [MaterialWordBits-1:0] material_i,
  input  logic                        normals_valid_i,
  output logic                        normals_ready_o,
  input  logic [NormalsBits-1:0]      normals_i,
  input  logic                        texture_valid_i,
  input  logic [TextureWordBits-1:0]  texture_i,
  input  logic                        texel_valid_i,
  input  logic [TexelWordBits-1:0]    texel_i,
  input  logic                        texture_coordinates_valid_i,
  output logic                        texture_coordinates_ready_o,
  input  logic [CoordinatesBits-1:0]  texture_coordinates_i,

  // From triangle_setup or visible_select
  input  logic                        attributes_valid_i,
  output logic                        attributes_ready_o,
  input  hs_formats_pkg::attributes_t attributes_i,

  // From scan_index
  input  logic                        scan_valid_i,
  output logic                        scan_ready_o,
  input  logic [ScanBits-1:0]         scan_i,

  // To the frame
  output logic                        pixel_valid_o,
  input  logic                        pixel_ready_i,
  output logic [PixelBits-1:0]        pixel_o,

  // To watch
  output logic                        colours_valid_o,
  output logic                        colours_ready_o,
  output logic [ColoursBits-1:0]      colours_o,
  output logic                        planes_valid_o,
  output logic                        planes_ready_o,
  output logic [ShadePlanesBits-1:0]  planes_o,
  output logic                        texture_planes_valid_o,
  output logic                        texture_planes_ready_o,
  output logic [TexturePlanesBits-1:0] texture_planes_o,
  output logic                        lit_valid_o,
  output logic                        lit_ready_o,
  output logic [PixelBits-1:0]        lit_o,

  output logic                        stored_last_o  // all planes of a frame are stored
);
  localparam int unsigned Lights = hs_formats_pkg::Lights;
  localparam int unsigned Phong = hs_formats_pkg::Phong;
  localparam int unsigned HasTexture = hs_formats_pkg::HasTexture;
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);
  localparam int unsigned PlanesBits = ShadePlanesBits - 2 - IndexBits;

  // --- attributes ─► planes ---
  logic both_valid, both_ready, setup_valid, setup_ready;
  hs_formats_pkg::attributes_t setup_attributes;

  hs_fifo #(
    .Width($bits(attributes_i)),
    .Depth(AttributesFifoDepth)
  ) u_attributes_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (attributes_valid_i),
    .in_ready_o (attributes_ready_o),
    .in_i       (attributes_i),
    .out_valid_o(both_valid),
    .out_ready_i(both_ready),
    .out_o      (setup_attributes)
  );

  if (Phong != 0) begin : gen_phong_setup
    assign colours_valid_o = 1'b0;
    assign colours_ready_o = 1'b0;
    assign colours_o = '0;

    hs_phong_setup #(
      .NormalBits(hs_formats_pkg::NormalBits)
    ) u_phong_setup (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .attributes_valid_i(setup_valid),
      .attributes_ready_o(setup_ready),
      .attributes_i      (setup_attributes),
      .normals_valid_i   (normals_valid_i),
      .normals_ready_o   (normals_ready_o),
      .normals_i         (normals_i),
      .planes_valid_o    (planes_valid_o),
      .planes_ready_i    (planes_ready_o),
      .planes_o          (planes_o)
    );
  end else begin : gen_shade_setup
    logic setup_colours_valid, setup_colours_ready;
    logic [ColoursBits-1:0] setup_colours;

    if (Lights != 0) begin : gen_light_vertex
      hs_light_vertex #(
        .Vertices(hs_formats_pkg::Gouraud != 0 ? 3 : 1)
      ) u_light_vertex (
        .clk_i           (clk_i),
        .rst_ni          (rst_ni),
        .light_valid_i   (light_valid_i),
        .light_i         (light_i),
        .material_valid_i(material_valid_i),
        .material_i      (material_i),
        .normals_valid_i (normals_valid_i),
        .normals_ready_o (normals_ready_o),
        .normals_i       (normals_i),
        .colours_valid_o (colours_valid_o),
        .colours_ready_i (colours_ready_o),
        .colours_o       (colours_o)
      );

      hs_fifo #(
        .Width(ColoursBits),
        .Depth(ColoursFifoDepth)
      ) u_colours_fifo (
        .clk_i      (clk_i),
        .rst_ni     (rst_ni),
        .in_valid_i (colours_valid_o),
        .in_ready_o (colours_ready_o),
        .in_i       (colours_o),
        .out_valid_o(setup_colours_valid),
        .out_ready_i(setup_colours_ready),
        .out_o      (setup_colours)
      );
    end else begin : gen_no_lighting
      logic unused_lighting;
      assign unused_lighting = ^{light_valid_i, light_i, material_valid_i, material_i,
                                 normals_valid_i, normals_i, setup_colours_ready};
      assign normals_ready_o = 1'b0;
      assign colours_valid_o = 1'b0;
      assign colours_ready_o = 1'b0;
      assign colours_o = '0;
      assign setup_colours_valid = 1'b0;
      assign setup_colours = '0;
    end

    hs_shade_setup u_shade_setup (
      .clk_i             (clk_i),
      .rst_ni            (rst_ni),
      .attributes_valid_i(setup_valid),
      .attributes_ready_o(setup_ready),
      .attributes_i      (setup_attributes),
      .colours_valid_i   (setup_colours_valid),
      .colours_ready_o   (setup_colours_ready),
      .colours_i         (setup_colours),
      .planes_valid_o    (planes_valid_o),
      .planes_ready_i    (planes_ready_o),
      .planes_o          (planes_o)
    );
  end

  // --- TdbS ---
  logic read_en, read_bank;
  logic planes_last, planes_empty, unused_planes_index;
  logic [EntryBits-1:0] read_entry, store_entry;
  logic [IndexBits-1:0] planes_index;
  logic [PlanesBits-1:0] read_planes;

  assign planes_ready_o = 1'b1;
  assign {planes_last, planes_empty, planes_index} = planes_o[ShadePlanesBits-1 -: 2+IndexBits];
  assign store_entry = EntryBits'(planes_index) - EntryBits'(1);
  assign unused_planes_index = ^planes_index;  // a power of two of entries has a bit less

  hs_ram_1r1w #(
    .Width(PlanesBits),
    .Depth(2 << EntryBits)
  ) u_shading_database (
    .clk_i          (clk_i),
    .read_en_i      (read_en),
    .read_address_i ({read_bank, read_entry}),
    .read_data_o    (read_planes),
    .write_en_i     (planes_valid_o && !planes_empty),
    .write_address_i({planes_bank_i, store_entry}),
    .write_data_i   (planes_o[PlanesBits-1:0])
  );

  // --- scan ─► pixels without texture ---
  logic light_scan_valid, light_scan_ready, shade_scan_valid, shade_scan_ready, light_valid, light_ready;
  logic [PixelBits-1:0] light;
  logic [ScanBits-1:0] shade_scan;

  hs_fifo #(
    .Width(ScanBits),
    .Depth(ScanFifoDepth)
  ) u_scan_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (light_scan_valid),
    .in_ready_o (light_scan_ready),
    .in_i       (scan_i),
    .out_valid_o(shade_scan_valid),
    .out_ready_i(shade_scan_ready),
    .out_o      (shade_scan)
  );

  if (Phong != 0) begin : gen_shade_phong
    hs_shade_phong #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_shade_phong (
      .clk_i           (clk_i),
      .rst_ni          (rst_ni),
      .background_i    (background_i),
      .light_valid_i   (light_valid_i),
      .light_i         (light_i),
      .material_valid_i(material_valid_i),
      .material_i      (material_i),
      .scan_valid_i    (shade_scan_valid),
      .scan_ready_o    (shade_scan_ready),
      .scan_i          (shade_scan),
      .read_en_o       (read_en),
      .read_bank_o     (read_bank),
      .read_entry_o    (read_entry),
      .read_planes_i   (read_planes),
      .pixel_valid_o   (light_valid),
      .pixel_ready_i   (light_ready),
      .pixel_o         (light)
    );
  end else begin : gen_shade_gouraud
    hs_shade_gouraud #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_shade_gouraud (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .background_i (background_i),
      .scan_valid_i (shade_scan_valid),
      .scan_ready_o (shade_scan_ready),
      .scan_i       (shade_scan),
      .read_en_o    (read_en),
      .read_bank_o  (read_bank),
      .read_entry_o (read_entry),
      .read_planes_i(read_planes),
      .pixel_valid_o(light_valid),
      .pixel_ready_i(light_ready),
      .pixel_o      (light)
    );
  end

  // --- Texture ---
  if (HasTexture != 0) begin : gen_texture
    localparam int unsigned EntryPlanesBits = TexturePlanesBits - 2 - IndexBits;
    logic coordinates_valid, coordinates_ready, texture_scan_valid, texture_scan_ready;
    logic queued_scan_valid, queued_scan_ready, frame_planes, texture_last, texture_bank_q;
    logic read_texture_en, read_texture_bank, store_empty, unused_index;
    logic [1:0] planes_ahead_q, texture_ahead_q;  // frames that one is stored of and the other not
    logic [EntryBits-1:0] read_texture_entry, store_texture_entry;
    logic [IndexBits-1:0] store_index;
    logic [EntryPlanesBits-1:0] read_texture_planes, store_texture_planes;
    logic [ScanBits-1:0] queued_scan;

    hs_fork u_attributes_fork (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .in_valid_i    (both_valid),
      .in_ready_o    (both_ready),
      .first_valid_o (setup_valid),
      .first_ready_i (setup_ready),
      .second_valid_o(coordinates_valid),
      .second_ready_i(coordinates_ready)
    );

    hs_texture_setup #(
      .CoordinateBits(hs_formats_pkg::CoordinateBits)
    ) u_texture_setup (
      .clk_i                      (clk_i),
      .rst_ni                     (rst_ni),
      .attributes_valid_i         (coordinates_valid),
      .attributes_ready_o         (coordinates_ready),
      .attributes_i               (setup_attributes),
      .texture_coordinates_valid_i(texture_coordinates_valid_i),
      .texture_coordinates_ready_o(texture_coordinates_ready_o),
      .texture_coordinates_i      (texture_coordinates_i),
      .texture_planes_valid_o     (texture_planes_valid_o),
      .texture_planes_ready_i     (texture_planes_ready_o),
      .texture_planes_o           (texture_planes_o)
    );

    assign texture_planes_ready_o = 1'b1;
    assign {texture_last, store_empty, store_index, store_texture_planes} = texture_planes_o;
    assign store_texture_entry = EntryBits'(store_index) - EntryBits'(1);
    assign unused_index = ^store_index;  // a power of two of entries has a bit less

    hs_ram_1r1w #(
      .Width(EntryPlanesBits),
      .Depth(2 << EntryBits)
    ) u_texture_database (
      .clk_i          (clk_i),
      .read_en_i      (read_texture_en),
      .read_address_i ({read_texture_bank, read_texture_entry}),
      .read_data_o    (read_texture_planes),
      .write_en_i     (texture_planes_valid_o && !store_empty),
      .write_address_i({texture_bank_q, store_texture_entry}),
      .write_data_i   (store_texture_planes)
    );

    // A frame is stored when both setups have come to its end.
    assign frame_planes = planes_valid_o && planes_last;
    assign stored_last_o = (frame_planes && texture_ahead_q != 2'd0)
                           || (texture_planes_valid_o && texture_last && planes_ahead_q != 2'd0)
                           || (frame_planes && texture_planes_valid_o && texture_last);

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        texture_bank_q <= 1'b0;
        planes_ahead_q <= 2'd0;
        texture_ahead_q <= 2'd0;
      end else begin
        if (texture_planes_valid_o && texture_last) texture_bank_q <= !texture_bank_q;
        planes_ahead_q <= planes_ahead_q + 2'(frame_planes) - 2'(stored_last_o);
        texture_ahead_q <= texture_ahead_q + 2'(texture_planes_valid_o && texture_last)
                           - 2'(stored_last_o);
      end
    end

    hs_fork u_scan_fork (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .in_valid_i    (scan_valid_i),
      .in_ready_o    (scan_ready_o),
      .first_valid_o (light_scan_valid),
      .first_ready_i (light_scan_ready),
      .second_valid_o(texture_scan_valid),
      .second_ready_i(texture_scan_ready)
    );

    hs_fifo #(
      .Width(ScanBits),
      .Depth(TextureScanFifoDepth)
    ) u_texture_scan_fifo (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .in_valid_i (texture_scan_valid),
      .in_ready_o (texture_scan_ready),
      .in_i       (scan_i),
      .out_valid_o(queued_scan_valid),
      .out_ready_i(queued_scan_ready),
      .out_o      (queued_scan)
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
      .scan_valid_i   (queued_scan_valid),
      .scan_ready_o   (queued_scan_ready),
      .scan_i         (queued_scan),
      .lit_valid_i    (lit_valid_o),
      .lit_ready_o    (lit_ready_o),
      .lit_i          (lit_o),
      .read_en_o      (read_texture_en),
      .read_bank_o    (read_texture_bank),
      .read_entry_o   (read_texture_entry),
      .read_planes_i  (read_texture_planes),
      .pixel_valid_o  (pixel_valid_o),
      .pixel_ready_i  (pixel_ready_i),
      .pixel_o        (pixel_o)
    );
    assign lit_valid_o = light_valid;
    assign light_ready = lit_ready_o;
    assign lit_o = light;
  end else begin : gen_no_texture
    logic unused_texture;
    assign unused_texture = ^{texture_valid_i, texture_i, texel_valid_i, texel_i,
                              texture_coordinates_valid_i, texture_coordinates_i};
    assign setup_valid = both_valid;
    assign both_ready = setup_ready;
    assign light_scan_valid = scan_valid_i;
    assign scan_ready_o = light_scan_ready;
    assign pixel_valid_o = light_valid;
    assign light_ready = pixel_ready_i;
    assign pixel_o = light;
    assign texture_coordinates_ready_o = 1'b0;
    assign texture_planes_valid_o = 1'b0;
    assign texture_planes_ready_o = 1'b0;
    assign texture_planes_o = '0;
    assign lit_valid_o = 1'b0;
    assign lit_ready_o = 1'b0;
    assign lit_o = '0;
    assign stored_last_o = planes_valid_o && planes_last;
  end
endmodule
