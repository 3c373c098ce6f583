// SPDX-License-Identifier: Apache-2.0
// The pipeline with what feeds it from memory, and what makes lines of its pixels.
//
//   words ─► hs_commands ─triangle─► hs_pipeline ─pixel─► hs_video ─► video
//                                    │ visible ▲ normals, texture_coordinates
//                                    ▼         │
//                                   hs_answers ┘ ◄─ words
//
// Where the shading is not deferred nobody answers to `visible`, and it is counted alone. All but
// the video is reset between frames that are given up; the video is told by abort_i.
module hs_system_core #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  parameter int unsigned DataBits = 64,
  parameter int unsigned SetupCycles = hs_formats_pkg::SetupInterval,  // a triangle
  parameter int unsigned BackgroundFifoDepth = 0,
  parameter int unsigned SetupFifoDepth = 512,
  parameter int unsigned DeferFifoDepth = 512,
  parameter int unsigned OutsideFrame = 0,
  parameter int unsigned OutsidePlanes = 0,
  parameter int unsigned CacheTilesX = 16,
  parameter int unsigned CacheTilesY = 16,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned RequestBits = hs_memory_pkg::RequestBits,
  localparam int unsigned Reads = hs_memory_pkg::Reads + 2,
  localparam int unsigned Writes = hs_memory_pkg::Writes,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,
  input  logic                         core_rst_ni,
  input  logic                         abort_i,

  input  logic                         launch_i,
  input  logic [31:0]                  commands_i,
  input  hs_memory_pkg::bases_t        bases_i,
  input  hs_formats_pkg::x_t           frame_width_i,
  input  hs_formats_pkg::y_t           frame_height_i,
  input  logic [3*ColourBits-1:0]      background_i,
  output logic                         list_active_o,
  output logic                         list_error_o,
  output logic                         idle_o,  // all that was sent is out

  // In this cycle
  output logic                         frame_o,
  output logic                         triangle_o,
  output logic                         visible_o,
  output logic                         triangle_wait_o,

  // Memory: the clients of hs_pipeline, the command list, answers
  output logic [Reads-1:0]             request_valid_o,
  input  logic [Reads-1:0]             request_ready_i,
  output logic [Reads*RequestBits-1:0] requests_o,
  input  logic [Reads-1:0]             data_valid_i,
  input  logic [DataBits-1:0]          data_i,
  output logic [Writes-1:0]            write_valid_o,
  input  logic [Writes-1:0]            write_ready_i,
  output logic [Writes*RequestBits-1:0] writes_o,
  output logic [Writes-1:0]            store_valid_o,
  input  logic [Writes-1:0]            store_ready_i,
  output logic [Writes*DataBits-1:0]   stores_o,
  input  logic [Writes-1:0]            written_i,

  output logic                         video_tvalid_o,
  input  logic                         video_tready_i,
  output logic [24*Lanes-1:0]          video_tdata_o,
  output logic [3*Lanes-1:0]           video_tkeep_o,
  output logic                         video_tuser_o,
  output logic                         video_tlast_o
);
  localparam int unsigned PixelBits =
      1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits + Lanes * 3 * ColourBits;
  localparam int unsigned CommandsClient = hs_memory_pkg::Reads;
  localparam int unsigned AnswersClient = hs_memory_pkg::Reads + 1;
  localparam int unsigned WordsBits = 28;
  localparam int unsigned Answered =
      hs_formats_pkg::Lights != 0 || hs_formats_pkg::HasTexture != 0 ? 1 : 0;

  logic triangle_valid, triangle_ready, visible_moves, fetching, pipeline_busy, video_idle;
  logic pipeline_idle;

  // --- clients of hs_pipeline: with all memories inside it has one bit of each vector, 0 ---
  localparam int unsigned Outside = OutsideFrame + OutsidePlanes;
  localparam int unsigned PipelineReads = Outside != 0 ? hs_memory_pkg::Reads : 1;
  localparam int unsigned PipelineWrites = Outside != 0 ? Writes : 1;
  localparam int unsigned PipelineRequestBits = Outside != 0 ? RequestBits : 1;
  localparam int unsigned PipelineWordBits = Outside != 0 ? DataBits : 1;
  logic [PipelineReads-1:0] read_valid, read_ready, read_data_valid;
  logic [PipelineReads*PipelineRequestBits-1:0] reads;
  logic [PipelineReads*PipelineWordBits-1:0] read_data;
  logic [PipelineWrites-1:0] write_valid, write_ready, store_valid, store_ready, written;
  logic [PipelineWrites*PipelineRequestBits-1:0] writes;
  logic [PipelineWrites*PipelineWordBits-1:0] stores;

  if (Outside != 0) begin : gen_outside
    assign request_valid_o[PipelineReads-1:0] = read_valid;
    assign requests_o[PipelineReads*RequestBits-1:0] = reads;
    assign read_ready = request_ready_i[PipelineReads-1:0];
    assign read_data_valid = data_valid_i[PipelineReads-1:0];
    assign read_data = {PipelineReads{data_i}};
    assign write_valid_o = write_valid;
    assign write_ready = write_ready_i;
    assign writes_o = writes;
    assign store_valid_o = store_valid;
    assign store_ready = store_ready_i;
    assign stores_o = stores;
    assign written = written_i;
  end else begin : gen_inside
    logic unused_memory;
    assign unused_memory = ^{request_ready_i[hs_memory_pkg::Reads-1:0], write_ready_i, written_i,
                             data_valid_i[hs_memory_pkg::Reads-1:0], store_ready_i, read_valid,
                             reads, write_valid, writes, store_valid, stores};
    assign request_valid_o[hs_memory_pkg::Reads-1:0] = '0;
    assign requests_o[hs_memory_pkg::Reads*RequestBits-1:0] = '0;
    assign read_ready = '0;
    assign read_data_valid = '0;
    assign read_data = '0;
    assign write_valid_o = '0;
    assign writes_o = '0;
    assign write_ready = '0;
    assign store_valid_o = '0;
    assign stores_o = '0;
    assign store_ready = '0;
    assign written = '0;
  end

  // --- the command list ---
  logic fetch_valid, fetch_ready, word_valid, word_ready, table_valid;
  logic [31:0] fetch_address, answers_table;
  logic [WordsBits-1:0] fetch_words;
  logic [63:0] word;
  hs_formats_pkg::triangle_t triangle, sent_triangle;
  logic sent_triangle_valid, sent_triangle_ready;
  logic light_valid, material_valid, texture_valid, texel_valid;
  logic [hs_formats_pkg::LightWordBits-1:0] light;
  logic [hs_formats_pkg::MaterialWordBits-1:0] material;
  logic [hs_formats_pkg::TextureWordBits-1:0] texture;
  logic [hs_formats_pkg::TexelWordBits-1:0] texel;

  hs_fetch #(
    .DataBits (DataBits),
    .WordsBits(WordsBits)
  ) u_commands_fetch (
    .clk_i          (clk_i),
    .rst_ni         (core_rst_ni),
    .start_valid_i  (fetch_valid),
    .start_ready_o  (fetch_ready),
    .start_address_i(fetch_address),
    .start_words_i  (fetch_words),
    .request_valid_o(request_valid_o[CommandsClient]),
    .request_ready_i(request_ready_i[CommandsClient]),
    .request_o      (requests_o[CommandsClient*RequestBits +: RequestBits]),
    .data_valid_i   (data_valid_i[CommandsClient]),
    .data_i         (data_i),
    .word_valid_o   (word_valid),
    .word_ready_i   (word_ready),
    .word_o         (word)
  );

  hs_commands #(
    .WordsBits(WordsBits)
  ) u_commands (
    .clk_i           (clk_i),
    .rst_ni          (core_rst_ni),
    .start_i         (launch_i),
    .base_i          (commands_i),
    .active_o        (list_active_o),
    .error_o         (list_error_o),
    .fetching_o      (fetching),
    .idle_i          (!pipeline_busy && video_idle),
    .out_o           (pipeline_idle),
    .fetch_valid_o   (fetch_valid),
    .fetch_ready_i   (fetch_ready),
    .fetch_address_o (fetch_address),
    .fetch_words_o   (fetch_words),
    .word_valid_i    (word_valid),
    .word_ready_o    (word_ready),
    .word_i          (word),
    .visible_i       (visible_moves),
    .answers_valid_o (table_valid),
    .answers_o       (answers_table),
    .triangle_valid_o(sent_triangle_valid),
    .triangle_ready_i(sent_triangle_ready),
    .triangle_o      (sent_triangle),
    .light_valid_o   (light_valid),
    .light_o         (light),
    .material_valid_o(material_valid),
    .material_o      (material),
    .texture_valid_o (texture_valid),
    .texture_o       (texture),
    .texel_valid_o   (texel_valid),
    .texel_o         (texel)
  );
  assign triangle_o = triangle_valid && triangle_ready;
  assign triangle_wait_o = fetching && triangle_ready && !triangle_valid;

  hs_stream #(
    .Width($bits(sent_triangle))
  ) u_stream_triangle (
    .valid_i(sent_triangle_valid),
    .ready_o(sent_triangle_ready),
    .word_i (sent_triangle),
    .valid_o(triangle_valid),
    .ready_i(triangle_ready),
    .word_o (triangle)
  );

  // --- the pipeline ---
  logic visible_valid, visible_ready, heard_visible_valid, heard_visible_ready, none_left;
  hs_formats_pkg::visible_t visible, heard_visible;
  logic normals_valid, normals_ready, coordinates_valid, coordinates_ready;
  logic [hs_formats_pkg::NormalsWordBits-1:0] normals;
  logic [hs_formats_pkg::TextureCoordinatesWordBits-1:0] coordinates;
  logic pixel_valid, pixel_ready, shown_pixel_valid, shown_pixel_ready;
  logic [PixelBits-1:0] pixel, shown_pixel;
  logic unused_vectors_ready, motion_valid, entry_valid, entry, unused_others;
  logic [hs_formats_pkg::MotionWordBits-1:0] motion;
  assign unused_others = ^{none_left, motion_valid, motion, entry_valid, entry};

  hs_pipeline #(
    .LanesX             (LanesX),
    .LanesY             (LanesY),
    .SetupCycles        (SetupCycles),
    .BackgroundFifoDepth(BackgroundFifoDepth),
    .SetupFifoDepth     (SetupFifoDepth),
    .DeferFifoDepth     (DeferFifoDepth),
    .OutsideFrame       (OutsideFrame),
    .OutsidePlanes      (OutsidePlanes),
    .MemoryBits         (DataBits),
    .CacheTilesX        (CacheTilesX),
    .CacheTilesY        (CacheTilesY)
  ) u_pipeline (
    .clk_i                      (clk_i),
    .rst_ni                     (core_rst_ni),
    .frame_width_i              (frame_width_i),
    .frame_height_i             (frame_height_i),
    .background_i               (background_i),
    .busy_o                     (pipeline_busy),
    .light_valid_i              (light_valid),
    .light_i                    (light),
    .material_valid_i           (material_valid),
    .material_i                 (material),
    .texture_valid_i            (texture_valid),
    .texture_i                  (texture),
    .texel_valid_i              (texel_valid),
    .texel_i                    (texel),
    .triangle_valid_i           (triangle_valid),
    .triangle_ready_o           (triangle_ready),
    .triangle_i                 (triangle),
    .none_left_o                (none_left),
    .visible_valid_o            (visible_valid),
    .visible_ready_i            (visible_ready),
    .visible_o                  (visible),
    .normals_valid_i            (normals_valid),
    .normals_ready_o            (normals_ready),
    .normals_i                  (normals),
    .texture_coordinates_valid_i(coordinates_valid),
    .texture_coordinates_ready_o(coordinates_ready),
    .texture_coordinates_i      (coordinates),
    .motion_vectors_valid_i     (1'b0),
    .motion_vectors_ready_o     (unused_vectors_ready),
    .motion_vectors_i           ('0),
    .pixel_valid_o              (pixel_valid),
    .pixel_ready_i              (pixel_ready),
    .pixel_o                    (pixel),
    .motion_valid_o             (motion_valid),
    .motion_ready_i             (1'b0),
    .motion_o                   (motion),
    .entry_valid_o              (entry_valid),
    .entry_ready_i              (1'b0),
    .entry_o                    (entry),
    .memory_bases_i             (bases_i),
    .memory_read_valid_o        (read_valid),
    .memory_read_ready_i        (read_ready),
    .memory_read_o              (reads),
    .memory_data_valid_i        (read_data_valid),
    .memory_data_i              (read_data),
    .memory_write_valid_o       (write_valid),
    .memory_write_ready_i       (write_ready),
    .memory_write_o             (writes),
    .memory_store_valid_o       (store_valid),
    .memory_store_ready_i       (store_ready),
    .memory_store_o             (stores),
    .memory_written_i           (written)
  );

  hs_stream #(
    .Width($bits(visible))
  ) u_stream_visible (
    .valid_i(visible_valid),
    .ready_o(visible_ready),
    .word_i (visible),
    .valid_o(heard_visible_valid),
    .ready_i(heard_visible_ready),
    .word_o (heard_visible)
  );
  assign visible_moves = heard_visible_valid && heard_visible_ready;
  assign visible_o = visible_moves && heard_visible.visible;

  // --- what is answered to `visible` ---
  if (Answered != 0) begin : gen_answers
    logic answer_fetch_valid, answer_fetch_ready, answer_valid, answer_ready;
    logic [31:0] answer_address;
    logic [WordsBits-1:0] answer_words;
    logic [63:0] answer;

    hs_answers #(
      .WordsBits(WordsBits)
    ) u_answers (
      .clk_i                      (clk_i),
      .rst_ni                     (core_rst_ni),
      .table_valid_i              (table_valid),
      .table_i                    (answers_table),
      .visible_valid_i            (heard_visible_valid),
      .visible_ready_o            (heard_visible_ready),
      .visible_i                  (heard_visible),
      .fetch_valid_o              (answer_fetch_valid),
      .fetch_ready_i              (answer_fetch_ready),
      .fetch_address_o            (answer_address),
      .fetch_words_o              (answer_words),
      .word_valid_i               (answer_valid),
      .word_ready_o               (answer_ready),
      .word_i                     (answer),
      .normals_valid_o            (normals_valid),
      .normals_ready_i            (normals_ready),
      .normals_o                  (normals),
      .texture_coordinates_valid_o(coordinates_valid),
      .texture_coordinates_ready_i(coordinates_ready),
      .texture_coordinates_o      (coordinates)
    );

    hs_fetch #(
      .DataBits (DataBits),
      .WordsBits(WordsBits)
    ) u_answers_fetch (
      .clk_i          (clk_i),
      .rst_ni         (core_rst_ni),
      .start_valid_i  (answer_fetch_valid),
      .start_ready_o  (answer_fetch_ready),
      .start_address_i(answer_address),
      .start_words_i  (answer_words),
      .request_valid_o(request_valid_o[AnswersClient]),
      .request_ready_i(request_ready_i[AnswersClient]),
      .request_o      (requests_o[AnswersClient*RequestBits +: RequestBits]),
      .data_valid_i   (data_valid_i[AnswersClient]),
      .data_i         (data_i),
      .word_valid_o   (answer_valid),
      .word_ready_i   (answer_ready),
      .word_o         (answer)
    );
  end else begin : gen_no_answers
    logic unused_answers;
    assign unused_answers = ^{table_valid, answers_table, normals_ready, coordinates_ready,
                              heard_visible, request_ready_i[AnswersClient],
                              data_valid_i[AnswersClient]};
    assign heard_visible_ready = 1'b1;
    assign normals_valid = 1'b0;
    assign normals = '0;
    assign coordinates_valid = 1'b0;
    assign coordinates = '0;
    assign request_valid_o[AnswersClient] = 1'b0;
    assign requests_o[AnswersClient*RequestBits +: RequestBits] = '0;
  end

  // --- pictures ---
  assign idle_o = pipeline_idle && video_idle;

  hs_stream #(
    .Width(PixelBits)
  ) u_stream_pixel (
    .valid_i(pixel_valid),
    .ready_o(pixel_ready),
    .word_i (pixel),
    .valid_o(shown_pixel_valid),
    .ready_i(shown_pixel_ready),
    .word_o (shown_pixel)
  );

  hs_video #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_video (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .abort_i       (abort_i),
    .idle_o        (video_idle),
    .frame_o       (frame_o),
    .frame_width_i (frame_width_i),
    .frame_height_i(frame_height_i),
    .pixel_valid_i (shown_pixel_valid),
    .pixel_ready_o (shown_pixel_ready),
    .pixel_i       (shown_pixel),
    .video_tvalid_o(video_tvalid_o),
    .video_tready_i(video_tready_i),
    .video_tdata_o (video_tdata_o),
    .video_tkeep_o (video_tkeep_o),
    .video_tuser_o (video_tuser_o),
    .video_tlast_o (video_tlast_o)
  );
endmodule
