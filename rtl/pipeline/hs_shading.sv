// SPDX-License-Identifier: Apache-2.0
// The shading half of the pipeline: what a triangle is shaded with into TdbS, and the finished
// I-buffer's stamps into pixels.
//
//   attributes, normals ─► hs_shade_planes ─planes─► TdbS ─► shade_gouraud ◄─ scan
//                                                            or shade_phong ─► pixel
//
// With texture there are a second setup, a second part of TdbS and a second shader, which takes the
// pixels of the first:
//
//   attributes, texture_coordinates, scan, lit ─► hs_texture ─► pixel
//
// OutsidePlanes: TdbS is in memory outside (hs_planes_memory), and planes may wait for it.
//
// Words of `normals` and `texture_coordinates` come for attributes that are not empty, in their
// order. Planes never wait. Stall: as its units. Lights, materials, textures and texels are written
// while no frame is in flight.
module hs_shading #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned SetupCycles = hs_formats_pkg::SetupInterval,
  parameter int unsigned BackgroundFifoDepth = 0,  // 0: background goes through shade_gouraud
  parameter int unsigned AttributesFifoDepth = 4,
  // With texture all that shade_texture takes before it looks at `lit`.
  parameter int unsigned ScanFifoDepth = hs_formats_pkg::HasTexture != 0 ? 32 : 4,
  parameter int unsigned OutsidePlanes = 0,
  parameter int unsigned MemoryBits = 64,
  // Of hs_planes_memory.
  localparam int unsigned MemoryOutBits =
      OutsidePlanes != 0 ? 2 * (1 + hs_memory_pkg::RequestBits) + 1 + MemoryBits : 1,
  localparam int unsigned MemoryInBits = OutsidePlanes != 0 ? 5 + MemoryBits : 1,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned HeadBits = 1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned ScanBits = HeadBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = HeadBits + Lanes * 3 * ColourBits
) (
  input  logic                                                  clk_i,
  input  logic                                                  rst_ni,

  input  logic [3*ColourBits-1:0]                               background_i,

  // Frame control: the bank of TdbS to store to; a frame's planes are stored; those of texture, too
  input  logic                                                  planes_bank_i,
  output logic                                                  planes_last_o,
  output logic                                                  stored_last_o,

  // From geometry
  input  logic                                                  light_valid_i,
  input  logic [hs_formats_pkg::LightWordBits-1:0]              light_i,
  input  logic                                                  material_valid_i,
  input  logic [hs_formats_pkg::MaterialWordBits-1:0]           material_i,
  input  logic                                                  normals_valid_i,
  output logic                                                  normals_ready_o,
  input  logic [hs_formats_pkg::NormalsWordBits-1:0]            normals_i,
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

  // To the frame
  output logic                                                  pixel_valid_o,
  input  logic                                                  pixel_ready_i,
  output logic [PixelBits-1:0]                                  pixel_o,

  // Memory outside, of hs_planes_memory
  input  logic [hs_memory_pkg::AddressBits-1:0]                 memory_base_i,
  output logic [MemoryOutBits-1:0]                              memory_o,
  input  logic [MemoryInBits-1:0]                               memory_i
);
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);
  localparam int unsigned PlanesBits = hs_formats_pkg::PlanesWordBits;
  localparam int unsigned EntryPlanesBits = PlanesBits - 2 - IndexBits;

  // --- attributes ─► planes ---
  logic queued_valid, queued_ready, setup_valid, setup_ready;
  logic sent_planes_valid, sent_planes_ready, planes_valid, planes_ready, planes_stored;
  hs_formats_pkg::attributes_t attributes;
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
    .out_valid_o(queued_valid),
    .out_ready_i(queued_ready),
    .out_o      (attributes)
  );

  hs_shade_planes #(
    .SetupCycles(SetupCycles)
  ) u_shade_planes (
    .clk_i             (clk_i),
    .rst_ni            (rst_ni),
    .light_valid_i     (light_valid_i),
    .light_i           (light_i),
    .material_valid_i  (material_valid_i),
    .material_i        (material_i),
    .normals_valid_i   (normals_valid_i),
    .normals_ready_o   (normals_ready_o),
    .normals_i         (normals_i),
    .attributes_valid_i(setup_valid),
    .attributes_ready_o(setup_ready),
    .attributes_i      (attributes),
    .planes_valid_o    (sent_planes_valid),
    .planes_ready_i    (sent_planes_ready),
    .planes_o          (sent_planes)
  );

  hs_stream #(
    .Width(PlanesBits)
  ) u_stream_planes (
    .valid_i(sent_planes_valid),
    .ready_o(sent_planes_ready),
    .word_i (sent_planes),
    .valid_o(planes_valid),
    .ready_i(planes_ready),
    .word_o (planes)
  );

  // --- TdbS ---
  logic read_en, read_bank;
  logic [EntryBits-1:0] read_entry;
  logic [EntryPlanesBits-1:0] read_planes;

  // The shader's stamps, before their planes are there and behind that.
  logic taken_scan_valid, taken_scan_ready, shader_scan_valid, shader_scan_ready;
  logic [ScanBits-1:0] taken_scan, shader_scan;

  if (OutsidePlanes != 0) begin : gen_planes_outside
    logic unused_read;
    assign unused_read = ^{read_bank, read_entry};  // reads are in order

    hs_planes_memory #(
      .LanesX    (LanesX),
      .LanesY    (LanesY),
      .PlanesBits(PlanesBits),
      .MemoryBits(MemoryBits),
      .EachPixel (hs_formats_pkg::Phong)
    ) u_planes_memory (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .planes_valid_i(planes_valid),
      .planes_ready_o(planes_ready),
      .planes_i      (planes),
      .planes_bank_i (planes_bank_i),
      .planes_last_o (planes_last_o),
      .stored_last_o (planes_stored),
      .scan_valid_i  (taken_scan_valid),
      .scan_ready_o  (taken_scan_ready),
      .scan_i        (taken_scan),
      .scan_valid_o  (shader_scan_valid),
      .scan_ready_i  (shader_scan_ready),
      .scan_o        (shader_scan),
      .read_en_i     (read_en),
      .read_planes_o (read_planes),
      .base_i        (memory_base_i),
      .memory_o      (memory_o),
      .memory_i      (memory_i)
    );
  end else begin : gen_planes_inside
    logic unused_memory;
    assign unused_memory = ^{memory_base_i, memory_i};
    assign memory_o = '0;
    assign planes_ready = 1'b1;
    assign planes_stored = planes_last_o;
    assign shader_scan_valid = taken_scan_valid;
    assign taken_scan_ready = shader_scan_ready;
    assign shader_scan = taken_scan;

    hs_planes_database #(
      .PlanesBits(PlanesBits)
    ) u_shading_database (
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
  end

  // --- scan ─► pixels without texture ---
  logic light_scan_valid, light_scan_ready, shade_scan_valid, shade_scan_ready;
  logic lit_valid, lit_ready;
  logic [PixelBits-1:0] lit;
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

  if (hs_formats_pkg::Phong != 0) begin : gen_shade_phong
    assign taken_scan_valid = shade_scan_valid;
    assign shade_scan_ready = taken_scan_ready;
    assign taken_scan = shade_scan;

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
      .scan_valid_i    (shader_scan_valid),
      .scan_ready_o    (shader_scan_ready),
      .scan_i          (shader_scan),
      .read_en_o       (read_en),
      .read_bank_o     (read_bank),
      .read_entry_o    (read_entry),
      .read_planes_i   (read_planes),
      .pixel_valid_o   (lit_valid),
      .pixel_ready_i   (lit_ready),
      .pixel_o         (lit)
    );
  end else begin : gen_shade_gouraud
    logic covered_valid, covered_ready, shaded_valid, shaded_ready;
    logic [ScanBits-1:0] covered;
    logic [PixelBits-1:0] shaded;

    assign taken_scan_valid = covered_valid;
    assign covered_ready = taken_scan_ready;
    assign taken_scan = covered;

    hs_shade_gouraud #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_shade_gouraud (
      .clk_i        (clk_i),
      .rst_ni       (rst_ni),
      .background_i (background_i),
      .scan_valid_i (shader_scan_valid),
      .scan_ready_o (shader_scan_ready),
      .scan_i       (shader_scan),
      .read_en_o    (read_en),
      .read_bank_o  (read_bank),
      .read_entry_o (read_entry),
      .read_planes_i(read_planes),
      .pixel_valid_o(shaded_valid),
      .pixel_ready_i(shaded_ready),
      .pixel_o      (shaded)
    );

    if (BackgroundFifoDepth != 0) begin : gen_background_pass
      hs_background_pass #(
        .LanesX(LanesX),
        .LanesY(LanesY),
        .Depth (BackgroundFifoDepth)
      ) u_background_pass (
        .clk_i          (clk_i),
        .rst_ni         (rst_ni),
        .background_i   (background_i),
        .scan_valid_i   (shade_scan_valid),
        .scan_ready_o   (shade_scan_ready),
        .scan_i         (shade_scan),
        .covered_valid_o(covered_valid),
        .covered_ready_i(covered_ready),
        .covered_o      (covered),
        .shaded_valid_i (shaded_valid),
        .shaded_ready_o (shaded_ready),
        .shaded_i       (shaded),
        .pixel_valid_o  (lit_valid),
        .pixel_ready_i  (lit_ready),
        .pixel_o        (lit)
      );
    end else begin : gen_all_through
      assign covered_valid = shade_scan_valid;
      assign shade_scan_ready = covered_ready;
      assign covered = shade_scan;
      assign lit_valid = shaded_valid;
      assign shaded_ready = lit_ready;
      assign lit = shaded;
    end
  end

  // --- Texture ---
  if (hs_formats_pkg::HasTexture != 0) begin : gen_texture
    logic coordinates_valid, coordinates_ready, texture_scan_valid, texture_scan_ready;
    logic texture_last;
    logic [1:0] planes_ahead_q, texture_ahead_q;  // frames that one is stored of and the other not

    hs_fork u_attributes_fork (
      .clk_i         (clk_i),
      .rst_ni        (rst_ni),
      .in_valid_i    (queued_valid),
      .in_ready_o    (queued_ready),
      .first_valid_o (setup_valid),
      .first_ready_i (setup_ready),
      .second_valid_o(coordinates_valid),
      .second_ready_i(coordinates_ready)
    );

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

    hs_texture #(
      .LanesX(LanesX),
      .LanesY(LanesY)
    ) u_texture (
      .clk_i                      (clk_i),
      .rst_ni                     (rst_ni),
      .planes_last_o              (texture_last),
      .texture_valid_i            (texture_valid_i),
      .texture_i                  (texture_i),
      .texel_valid_i              (texel_valid_i),
      .texel_i                    (texel_i),
      .texture_coordinates_valid_i(texture_coordinates_valid_i),
      .texture_coordinates_ready_o(texture_coordinates_ready_o),
      .texture_coordinates_i      (texture_coordinates_i),
      .attributes_valid_i         (coordinates_valid),
      .attributes_ready_o         (coordinates_ready),
      .attributes_i               (attributes),
      .scan_valid_i               (texture_scan_valid),
      .scan_ready_o               (texture_scan_ready),
      .scan_i                     (scan_i),
      .lit_valid_i                (lit_valid),
      .lit_ready_o                (lit_ready),
      .lit_i                      (lit),
      .pixel_valid_o              (pixel_valid_o),
      .pixel_ready_i              (pixel_ready_i),
      .pixel_o                    (pixel_o)
    );

    // A frame is stored when both setups have come to its end.
    assign stored_last_o = (planes_stored && texture_ahead_q != 2'd0)
                           || (texture_last && planes_ahead_q != 2'd0)
                           || (planes_stored && texture_last);

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        planes_ahead_q <= 2'd0;
        texture_ahead_q <= 2'd0;
      end else begin
        planes_ahead_q <= planes_ahead_q + 2'(planes_stored) - 2'(stored_last_o);
        texture_ahead_q <= texture_ahead_q + 2'(texture_last) - 2'(stored_last_o);
      end
    end
  end else begin : gen_no_texture
    logic unused_texture;
    assign unused_texture = ^{texture_valid_i, texture_i, texel_valid_i, texel_i,
                              texture_coordinates_valid_i, texture_coordinates_i};
    assign texture_coordinates_ready_o = 1'b0;
    assign setup_valid = queued_valid;
    assign queued_ready = setup_ready;
    assign light_scan_valid = scan_valid_i;
    assign scan_ready_o = light_scan_ready;
    assign pixel_valid_o = lit_valid;
    assign lit_ready = pixel_ready_i;
    assign pixel_o = lit;
    assign stored_last_o = planes_stored;
  end
endmodule
