// SPDX-License-Identifier: Apache-2.0
// The pipeline as a processor uses it: a command list and triangles from memory, pictures out.
//
//   AXI4-Lite ─► hs_registers ─► hs_system_control
//                                        ▼
//   AXI4 ◄─► hs_axi_read, ◄─────► hs_system_core ─► video
//            hs_axi_write
//
// A start draws what the command list says (hs_commands), into as many frames as it ends.
// Ids of the reads: those of hs_memory_pkg, then the command list and triangles, then answers.
// An answer of the bus that is an error, a wrong command, a frame that is too large and a stop end
// the frame: see hs_system_control. The video then begins again with a first beat of a frame; a
// line that was under way has no end.
// A byte of memory is at the byte's address, little endian. All is one clock.
// The other parameters are those of hs_pipeline.
// Illegal: a configuration with motion or objects.
module hs_system #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  parameter int unsigned DataBits = 64,  // of the memory: 64 or 128
  parameter int unsigned IdBits = 4,
  parameter int unsigned SetupCycles = hs_formats_pkg::SetupInterval,  // a triangle
  parameter int unsigned BackgroundFifoDepth = 0,
  parameter int unsigned SetupFifoDepth = 512,
  parameter int unsigned DeferFifoDepth = 512,
  parameter int unsigned OutsideFrame = 0,
  parameter int unsigned OutsidePlanes = 0,
  parameter int unsigned CacheTilesX = 16,
  parameter int unsigned CacheTilesY = 16,
  localparam int unsigned Lanes = LanesX * LanesY
) (
  input  logic                  clk_i,
  input  logic                  rst_ni,

  // Registers
  input  logic                  axil_awvalid_i,
  output logic                  axil_awready_o,
  input  logic [hs_registers_pkg::AddressBits-1:0] axil_awaddr_i,
  input  logic                  axil_wvalid_i,
  output logic                  axil_wready_o,
  input  logic [31:0]           axil_wdata_i,
  input  logic [3:0]            axil_wstrb_i,
  output logic                  axil_bvalid_o,
  input  logic                  axil_bready_i,
  output logic [1:0]            axil_bresp_o,
  input  logic                  axil_arvalid_i,
  output logic                  axil_arready_o,
  input  logic [hs_registers_pkg::AddressBits-1:0] axil_araddr_i,
  output logic                  axil_rvalid_o,
  input  logic                  axil_rready_i,
  output logic [31:0]           axil_rdata_o,
  output logic [1:0]            axil_rresp_o,
  output logic                  interrupt_o,

  // Memory
  output logic                  axi_arvalid_o,
  input  logic                  axi_arready_i,
  output logic [IdBits-1:0]     axi_arid_o,
  output logic [31:0]           axi_araddr_o,
  output logic [7:0]            axi_arlen_o,
  output logic [2:0]            axi_arsize_o,
  output logic [1:0]            axi_arburst_o,
  input  logic                  axi_rvalid_i,
  output logic                  axi_rready_o,
  input  logic [IdBits-1:0]     axi_rid_i,
  input  logic [DataBits-1:0]   axi_rdata_i,
  input  logic [1:0]            axi_rresp_i,
  input  logic                  axi_rlast_i,
  output logic                  axi_awvalid_o,
  input  logic                  axi_awready_i,
  output logic [IdBits-1:0]     axi_awid_o,
  output logic [31:0]           axi_awaddr_o,
  output logic [7:0]            axi_awlen_o,
  output logic [2:0]            axi_awsize_o,
  output logic [1:0]            axi_awburst_o,
  output logic                  axi_wvalid_o,
  input  logic                  axi_wready_i,
  output logic [DataBits-1:0]   axi_wdata_o,
  output logic [DataBits/8-1:0] axi_wstrb_o,
  output logic                  axi_wlast_o,
  input  logic                  axi_bvalid_i,
  output logic                  axi_bready_o,
  input  logic [IdBits-1:0]     axi_bid_i,
  input  logic [1:0]            axi_bresp_i,

  // Pictures
  output logic                  video_tvalid_o,
  input  logic                  video_tready_i,
  output logic [24*Lanes-1:0]   video_tdata_o,
  output logic [3*Lanes-1:0]    video_tkeep_o,
  output logic                  video_tuser_o,
  output logic                  video_tlast_o
);
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits;
  localparam int unsigned RequestBits = hs_memory_pkg::RequestBits;
  localparam int unsigned Reads = hs_memory_pkg::Reads + 2;
  localparam int unsigned Writes = hs_memory_pkg::Writes;

  if (hs_formats_pkg::HasMotion != 0 || hs_formats_pkg::HasObjects != 0) begin : gen_illegal
    $error("hs_system: takes a configuration without motion and objects");
  end
  if (DataBits != 64 && DataBits != 128) begin : gen_bus_illegal
    $error("hs_system: DataBits must be 64 or 128");
  end

  assign axi_arsize_o = 3'($clog2(DataBits / 8));
  assign axi_arburst_o = 2'b01;
  assign axi_awsize_o = 3'($clog2(DataBits / 8));
  assign axi_awburst_o = 2'b01;

  // --- registers and control ---
  logic start, stop, started, launch, busy, done, stopped, failed, frame_wrong;
  logic [1:0] error_kind;
  logic [3:0] error_client;
  hs_formats_pkg::x_t frame_width;
  hs_formats_pkg::y_t frame_height;
  logic [3*ColourBits-1:0] background;
  logic [31:0] commands;
  hs_memory_pkg::bases_t bases;
  logic frame_out, triangle_moves, triangle_wait, visible_moves;
  logic core_rst_n, flush, core_idle, read_idle, write_idle, list_active, list_error;
  logic read_error, write_error;
  logic [IdBits-1:0] read_client, write_client;
  logic [Reads-1:0] read_moves, data_valid;
  logic [Writes-1:0] write_moves;

  hs_registers #(
    .LanesX       (LanesX),
    .LanesY       (LanesY),
    .DataBits     (DataBits),
    .OutsideFrame (OutsideFrame),
    .OutsidePlanes(OutsidePlanes)
  ) u_registers (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .axil_awvalid_i (axil_awvalid_i),
    .axil_awready_o (axil_awready_o),
    .axil_awaddr_i  (axil_awaddr_i),
    .axil_wvalid_i  (axil_wvalid_i),
    .axil_wready_o  (axil_wready_o),
    .axil_wdata_i   (axil_wdata_i),
    .axil_wstrb_i   (axil_wstrb_i),
    .axil_bvalid_o  (axil_bvalid_o),
    .axil_bready_i  (axil_bready_i),
    .axil_bresp_o   (axil_bresp_o),
    .axil_arvalid_i (axil_arvalid_i),
    .axil_arready_o (axil_arready_o),
    .axil_araddr_i  (axil_araddr_i),
    .axil_rvalid_o  (axil_rvalid_o),
    .axil_rready_i  (axil_rready_i),
    .axil_rdata_o   (axil_rdata_o),
    .axil_rresp_o   (axil_rresp_o),
    .interrupt_o    (interrupt_o),
    .start_o        (start),
    .stop_o         (stop),
    .started_i      (started),
    .busy_i         (busy),
    .done_i         (done),
    .stopped_i      (stopped),
    .error_i        (failed),
    .error_kind_i   (error_kind),
    .error_client_i (error_client),
    .frame_width_o  (frame_width),
    .frame_height_o (frame_height),
    .background_o   (background),
    .frame_wrong_o  (frame_wrong),
    .commands_o     (commands),
    .bases_o        (bases),
    .frame_i        (frame_out),
    .triangle_i     (triangle_moves),
    .visible_i      (visible_moves),
    .triangle_wait_i(triangle_wait),
    .video_wait_i   (video_tvalid_o && !video_tready_i),
    .read_i         (read_moves),
    .written_i      (write_moves)
  );

  hs_system_control #(
    .IdBits(IdBits)
  ) u_control (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .start_i        (start),
    .stop_i         (stop),
    .frame_wrong_i  (frame_wrong),
    .started_o      (started),
    .launch_o       (launch),
    .busy_o         (busy),
    .done_o         (done),
    .stopped_o      (stopped),
    .error_o        (failed),
    .error_kind_o   (error_kind),
    .error_client_o (error_client),
    .core_rst_no    (core_rst_n),
    .flush_o        (flush),
    .bus_idle_i     (read_idle && write_idle),
    .list_active_i  (list_active),
    .core_idle_i    (core_idle),
    .command_error_i(list_error),
    .read_error_i   (read_error),
    .read_client_i  (read_client),
    .write_error_i  (write_error),
    .write_client_i (write_client)
  );

  // --- memory ---
  logic [Reads-1:0] request_valid, request_ready;
  logic [Reads*RequestBits-1:0] requests;
  logic [DataBits-1:0] data;

  hs_axi_read #(
    .Clients (Reads),
    .DataBits(DataBits),
    .IdBits  (IdBits)
  ) u_axi_read (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .flush_i        (flush),
    .idle_o         (read_idle),
    .error_o        (read_error),
    .error_client_o (read_client),
    .request_valid_i(request_valid),
    .request_ready_o(request_ready),
    .request_i      (requests),
    .data_valid_o   (data_valid),
    .data_o         (data),
    .axi_arvalid_o  (axi_arvalid_o),
    .axi_arready_i  (axi_arready_i),
    .axi_arid_o     (axi_arid_o),
    .axi_araddr_o   (axi_araddr_o),
    .axi_arlen_o    (axi_arlen_o),
    .axi_rvalid_i   (axi_rvalid_i),
    .axi_rready_o   (axi_rready_o),
    .axi_rid_i      (axi_rid_i),
    .axi_rdata_i    (axi_rdata_i),
    .axi_rresp_i    (axi_rresp_i),
    .axi_rlast_i    (axi_rlast_i)
  );
  assign read_moves = data_valid;

  // Clients of hs_pipeline
  logic [Writes-1:0] write_valid, write_ready, store_valid, store_ready, written;
  logic [Writes*RequestBits-1:0] writes;
  logic [Writes*DataBits-1:0] stores;

  hs_axi_write #(
    .Clients (Writes),
    .DataBits(DataBits),
    .IdBits  (IdBits)
  ) u_axi_write (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .flush_i        (flush),
    .idle_o         (write_idle),
    .error_o        (write_error),
    .error_client_o (write_client),
    .request_valid_i(write_valid),
    .request_ready_o(write_ready),
    .request_i      (writes),
    .store_valid_i  (store_valid),
    .store_ready_o  (store_ready),
    .store_i        (stores),
    .written_o      (written),
    .axi_awvalid_o  (axi_awvalid_o),
    .axi_awready_i  (axi_awready_i),
    .axi_awid_o     (axi_awid_o),
    .axi_awaddr_o   (axi_awaddr_o),
    .axi_awlen_o    (axi_awlen_o),
    .axi_wvalid_o   (axi_wvalid_o),
    .axi_wready_i   (axi_wready_i),
    .axi_wdata_o    (axi_wdata_o),
    .axi_wstrb_o    (axi_wstrb_o),
    .axi_wlast_o    (axi_wlast_o),
    .axi_bvalid_i   (axi_bvalid_i),
    .axi_bready_o   (axi_bready_o),
    .axi_bid_i      (axi_bid_i),
    .axi_bresp_i    (axi_bresp_i)
  );
  assign write_moves = store_valid & store_ready;

  hs_system_core #(
    .LanesX             (LanesX),
    .LanesY             (LanesY),
    .DataBits           (DataBits),
    .SetupCycles        (SetupCycles),
    .BackgroundFifoDepth(BackgroundFifoDepth),
    .SetupFifoDepth     (SetupFifoDepth),
    .DeferFifoDepth     (DeferFifoDepth),
    .OutsideFrame       (OutsideFrame),
    .OutsidePlanes      (OutsidePlanes),
    .CacheTilesX        (CacheTilesX),
    .CacheTilesY        (CacheTilesY)
  ) u_core (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .core_rst_ni    (core_rst_n),
    .abort_i        (flush),
    .launch_i       (launch),
    .commands_i     (commands),
    .bases_i        (bases),
    .frame_width_i  (frame_width),
    .frame_height_i (frame_height),
    .background_i   (background),
    .list_active_o  (list_active),
    .list_error_o   (list_error),
    .idle_o         (core_idle),
    .frame_o        (frame_out),
    .triangle_o     (triangle_moves),
    .visible_o      (visible_moves),
    .triangle_wait_o(triangle_wait),
    .request_valid_o(request_valid),
    .request_ready_i(request_ready),
    .requests_o     (requests),
    .data_valid_i   (data_valid),
    .data_i         (data),
    .write_valid_o  (write_valid),
    .write_ready_i  (write_ready),
    .writes_o       (writes),
    .store_valid_o  (store_valid),
    .store_ready_i  (store_ready),
    .stores_o       (stores),
    .written_i      (written),
    .video_tvalid_o (video_tvalid_o),
    .video_tready_i (video_tready_i),
    .video_tdata_o  (video_tdata_o),
    .video_tkeep_o  (video_tkeep_o),
    .video_tuser_o  (video_tuser_o),
    .video_tlast_o  (video_tlast_o)
  );
endmodule
