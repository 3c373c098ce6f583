// SPDX-License-Identifier: Apache-2.0
// The registers of hs_system on AXI4-Lite (registers.toml), the counters, and the interrupt.
//
// A write is taken when address and data are both there; byte strobes are looked at. A read is
// answered in the next cycle, or SLVERR where there is no register; so is a write of one that is
// read alone. One write and one read are under way at most.
// frame_width_o and what stands beside it are what the registers had at the last start.
module hs_registers #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  parameter int unsigned DataBits = 64,
  parameter int unsigned OutsideFrame = 0,
  parameter int unsigned OutsidePlanes = 0,
  localparam int unsigned AddressBits = hs_registers_pkg::AddressBits,
  localparam int unsigned Reads = hs_registers_pkg::BytesReadClients,
  localparam int unsigned Writes = hs_registers_pkg::BytesWrittenClients,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  logic                    axil_awvalid_i,
  output logic                    axil_awready_o,
  input  logic [AddressBits-1:0]  axil_awaddr_i,
  input  logic                    axil_wvalid_i,
  output logic                    axil_wready_o,
  input  logic [31:0]             axil_wdata_i,
  input  logic [3:0]              axil_wstrb_i,
  output logic                    axil_bvalid_o,
  input  logic                    axil_bready_i,
  output logic [1:0]              axil_bresp_o,
  input  logic                    axil_arvalid_i,
  output logic                    axil_arready_o,
  input  logic [AddressBits-1:0]  axil_araddr_i,
  output logic                    axil_rvalid_o,
  input  logic                    axil_rready_i,
  output logic [31:0]             axil_rdata_o,
  output logic [1:0]              axil_rresp_o,
  output logic                    interrupt_o,

  output logic                    start_o,
  output logic                    stop_o,
  input  logic                    started_i,  // start_o acts
  input  logic                    busy_i,
  input  logic                    done_i,     // for a cycle, as these are
  input  logic                    stopped_i,
  input  logic                    error_i,
  input  logic [1:0]              error_kind_i,
  input  logic [3:0]              error_client_i,

  output hs_formats_pkg::x_t      frame_width_o,
  output hs_formats_pkg::y_t      frame_height_o,
  output logic [3*ColourBits-1:0] background_o,
  output logic                    frame_wrong_o,  // the pipeline has no frame of this size
  output logic [31:0]             commands_o,
  output hs_memory_pkg::bases_t   bases_o,

  // What is counted, in this cycle
  input  logic                    frame_i,
  input  logic                    triangle_i,
  input  logic                    visible_i,
  input  logic                    triangle_wait_i,
  input  logic                    video_wait_i,
  input  logic [Reads-1:0]        read_i,  // a word of the memory, by client
  input  logic [Writes-1:0]       written_i
);
  localparam int unsigned XBits = hs_formats_pkg::XBits;
  localparam int unsigned YBits = hs_formats_pkg::YBits;
  localparam int unsigned Colours =
      hs_formats_pkg::TriangleColourBits == 0 ? 0 : hs_formats_pkg::Gouraud != 0 ? 3 : 1;
  localparam int unsigned Normals =
      hs_formats_pkg::Lights == 0 ? 0
      : hs_formats_pkg::Gouraud != 0 || hs_formats_pkg::Phong != 0 ? 3 : 1;
  localparam int unsigned Coordinates =
      hs_formats_pkg::HasTexture == 0 ? 0 : hs_formats_pkg::Perspective != 0 ? 3 : 2;
  localparam int unsigned Triangles =
      hs_formats_pkg::GivesIndices != 0 ? 0 : hs_formats_pkg::Triangles;
  localparam logic [1:0] Okay = 2'b00;
  localparam logic [1:0] SlaveError = 2'b10;

  // --- what is written ---
  logic write, write_known, bvalid_q;
  logic [1:0] bresp_q;
  logic [31:0] mask;
  logic [3:0] enable_q, pending_q, happened;
  logic [31:0] frame_q, background_q, commands_q, index_q, depth_q, planes_q;

  assign write = axil_awvalid_i && axil_wvalid_i && (!bvalid_q || axil_bready_i);
  assign axil_awready_o = write;
  assign axil_wready_o = write;
  assign axil_bvalid_o = bvalid_q;
  assign axil_bresp_o = bresp_q;
  for (genvar i = 0; i < 4; i++) begin : gen_mask
    assign mask[8*i +: 8] = {8{axil_wstrb_i[i]}};
  end

  assign start_o = write && axil_awaddr_i == hs_registers_pkg::Control
                   && (axil_wdata_i[hs_registers_pkg::ControlStart] && axil_wstrb_i[0]);
  assign stop_o = write && axil_awaddr_i == hs_registers_pkg::Control
                  && (axil_wdata_i[hs_registers_pkg::ControlStop] && axil_wstrb_i[0]);

  always_comb begin
    case (axil_awaddr_i)
      hs_registers_pkg::Control, hs_registers_pkg::InterruptEnable,
      hs_registers_pkg::InterruptPending, hs_registers_pkg::Frame, hs_registers_pkg::Background,
      hs_registers_pkg::Commands, hs_registers_pkg::IndexBase, hs_registers_pkg::DepthBase,
      hs_registers_pkg::PlanesBase: write_known = 1'b1;
      default: write_known = 1'b0;
    endcase
  end

  assign happened = {frame_i, error_i, stopped_i, done_i};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      bvalid_q <= 1'b0;
      enable_q <= '0;
      pending_q <= '0;
      frame_q <= '0;
      background_q <= '0;
      commands_q <= '0;
      index_q <= '0;
      depth_q <= '0;
      planes_q <= '0;
    end else begin
      if (write) bvalid_q <= 1'b1;
      else if (axil_bready_i) bvalid_q <= 1'b0;
      pending_q <= pending_q | happened;
      if (write) begin
        case (axil_awaddr_i)
          hs_registers_pkg::InterruptEnable:
            enable_q <= (enable_q & ~mask[3:0]) | (axil_wdata_i[3:0] & mask[3:0]);
          hs_registers_pkg::InterruptPending:
            pending_q <= (pending_q & ~(axil_wdata_i[3:0] & mask[3:0])) | happened;
          hs_registers_pkg::Frame: frame_q <= (frame_q & ~mask) | (axil_wdata_i & mask);
          hs_registers_pkg::Background:
            background_q <= (background_q & ~mask) | (axil_wdata_i & mask);
          hs_registers_pkg::Commands: commands_q <= (commands_q & ~mask) | (axil_wdata_i & mask);
          hs_registers_pkg::IndexBase: index_q <= (index_q & ~mask) | (axil_wdata_i & mask);
          hs_registers_pkg::DepthBase: depth_q <= (depth_q & ~mask) | (axil_wdata_i & mask);
          hs_registers_pkg::PlanesBase: planes_q <= (planes_q & ~mask) | (axil_wdata_i & mask);
          default: ;
        endcase
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (write) bresp_q <= write_known ? Okay : SlaveError;
  end

  assign interrupt_o = (pending_q & enable_q) != '0;

  // --- of the frames that are drawn ---
  hs_formats_pkg::x_t frame_width_q;
  hs_formats_pkg::y_t frame_height_q;
  logic [3*ColourBits-1:0] background_now_q;
  hs_memory_pkg::bases_t bases_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      frame_width_q <= XBits'(1);
      frame_height_q <= YBits'(1);
    end else if (started_i) begin
      frame_width_q <= frame_q[XBits-1:0];
      frame_height_q <= frame_q[16 +: YBits];
    end
  end

  always_ff @(posedge clk_i) begin
    if (started_i) begin
      background_now_q <= {background_q[16 +: ColourBits], background_q[8 +: ColourBits],
                           background_q[0 +: ColourBits]};
      bases_q <= {index_q, depth_q, planes_q};
    end
  end

  assign frame_wrong_o =
      frame_q[15:0] == '0 || 32'(frame_q[15:0]) > hs_formats_pkg::MaxWidth
      || frame_q[31:16] == '0 || 32'(frame_q[31:16]) > hs_formats_pkg::MaxHeight;
  assign frame_width_o = frame_width_q;
  assign frame_height_o = frame_height_q;
  assign background_o = background_now_q;
  assign commands_o = commands_q;
  assign bases_o = bases_q;

  // --- status and counters ---
  logic done_q, stopped_q, error_q;
  logic [1:0] error_kind_q;
  logic [3:0] error_client_q;
  logic [31:0] cycles_q, frames_q, drawn_q, visible_q, triangle_waits_q, video_waits_q;
  logic [31:0] read_q [Reads];
  logic [31:0] written_q [Writes];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      done_q <= 1'b0;
      stopped_q <= 1'b0;
      error_q <= 1'b0;
      error_kind_q <= '0;
      error_client_q <= '0;
    end else if (started_i) begin
      done_q <= 1'b0;
      stopped_q <= 1'b0;
      error_q <= 1'b0;
      error_kind_q <= '0;
      error_client_q <= '0;
    end else begin
      if (done_i) done_q <= 1'b1;
      if (stopped_i) stopped_q <= 1'b1;
      if (error_i) begin
        error_q <= 1'b1;
        error_kind_q <= error_kind_i;
        error_client_q <= error_client_i;
      end
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      {cycles_q, frames_q, drawn_q, visible_q, triangle_waits_q, video_waits_q} <= '0;
      for (int unsigned i = 0; i < Reads; i++) read_q[i] <= '0;
      for (int unsigned i = 0; i < Writes; i++) written_q[i] <= '0;
    end else if (started_i) begin
      {cycles_q, frames_q, drawn_q, visible_q, triangle_waits_q, video_waits_q} <= '0;
      for (int unsigned i = 0; i < Reads; i++) read_q[i] <= '0;
      for (int unsigned i = 0; i < Writes; i++) written_q[i] <= '0;
    end else if (busy_i) begin
      cycles_q <= cycles_q + 32'd1;
      frames_q <= frames_q + 32'(frame_i);
      drawn_q <= drawn_q + 32'(triangle_i);
      visible_q <= visible_q + 32'(visible_i);
      triangle_waits_q <= triangle_waits_q + 32'(triangle_wait_i);
      video_waits_q <= video_waits_q + 32'(video_wait_i);
      for (int unsigned i = 0; i < Reads; i++) begin
        read_q[i] <= read_q[i] + (read_i[i] ? 32'(DataBits / 8) : 32'd0);
      end
      for (int unsigned i = 0; i < Writes; i++) begin
        written_q[i] <= written_q[i] + (written_i[i] ? 32'(DataBits / 8) : 32'd0);
      end
    end
  end

  // --- what is read ---
  logic read, read_known, rvalid_q;
  logic [1:0] rresp_q;
  logic [31:0] value, rdata_q;

  assign read = axil_arvalid_i && axil_arready_o;
  assign axil_arready_o = !rvalid_q || axil_rready_i;
  assign axil_rvalid_o = rvalid_q;
  assign axil_rdata_o = rdata_q;
  assign axil_rresp_o = rresp_q;

  // Shifts, not casts side by side: Yosys 0.23 does not narrow these.
  always_comb begin
    value = '0;
    read_known = 1'b1;
    case (axil_araddr_i)
      hs_registers_pkg::Id: value = 32'h68733031;
      hs_registers_pkg::Bus: value = 32'(DataBits / 8 << 8 | 1);
      hs_registers_pkg::Lanes: value = 32'(LanesY << 8 | LanesX);
      hs_registers_pkg::Largest:
        value = 32'(hs_formats_pkg::MaxHeight << 16 | hs_formats_pkg::MaxWidth);
      hs_registers_pkg::Triangles: value = 32'(Triangles);
      hs_registers_pkg::Widths:
        value = 32'(ColourBits << 24 | hs_formats_pkg::HasDepth * hs_formats_pkg::DepthBits << 16
                    | hs_formats_pkg::SubpixelBits << 8 | hs_formats_pkg::CoordBits);
      hs_registers_pkg::Features: begin
        value[hs_registers_pkg::FeaturesColours +: 2] = 2'(Colours);
        value[hs_registers_pkg::FeaturesNormals +: 2] = 2'(Normals);
        value[hs_registers_pkg::FeaturesCoordinates +: 2] = 2'(Coordinates);
        value[hs_registers_pkg::FeaturesOutsideFrame] = OutsideFrame != 0;
        value[hs_registers_pkg::FeaturesOutsidePlanes] = OutsidePlanes != 0;
      end
      hs_registers_pkg::Answers:
        value = 32'(hs_formats_pkg::RepeatBits << 24 | hs_formats_pkg::TextureBits << 16
                    | hs_formats_pkg::MaterialBits << 8 | hs_formats_pkg::NormalBits);
      hs_registers_pkg::Coordinate: value = 32'(hs_formats_pkg::CoordinateBits);
      hs_registers_pkg::Control: value = '0;
      hs_registers_pkg::Status: begin
        value[hs_registers_pkg::StatusBusy] = busy_i;
        value[hs_registers_pkg::StatusDone] = done_q;
        value[hs_registers_pkg::StatusStopped] = stopped_q;
        value[hs_registers_pkg::StatusError] = error_q;
        value[hs_registers_pkg::StatusErrorKind +: 2] = error_kind_q;
        value[hs_registers_pkg::StatusErrorClient +: 4] = error_client_q;
      end
      hs_registers_pkg::InterruptEnable: value = {28'd0, enable_q};
      hs_registers_pkg::InterruptPending: value = {28'd0, pending_q};
      hs_registers_pkg::Frame: value = frame_q;
      hs_registers_pkg::Background: value = background_q;
      hs_registers_pkg::Commands: value = commands_q;
      hs_registers_pkg::IndexBase: value = index_q;
      hs_registers_pkg::DepthBase: value = depth_q;
      hs_registers_pkg::PlanesBase: value = planes_q;
      hs_registers_pkg::Cycles: value = cycles_q;
      hs_registers_pkg::Frames: value = frames_q;
      hs_registers_pkg::Drawn: value = drawn_q;
      hs_registers_pkg::Visible: value = visible_q;
      hs_registers_pkg::TriangleWaits: value = triangle_waits_q;
      hs_registers_pkg::VideoWaits: value = video_waits_q;
      default: read_known = 1'b0;
    endcase
    for (int unsigned i = 0; i < Reads; i++) begin
      if (axil_araddr_i == hs_registers_pkg::BytesRead + AddressBits'(4 * i)) begin
        value = read_q[i];
        read_known = 1'b1;
      end
    end
    for (int unsigned i = 0; i < Writes; i++) begin
      if (axil_araddr_i == hs_registers_pkg::BytesWritten + AddressBits'(4 * i)) begin
        value = written_q[i];
        read_known = 1'b1;
      end
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) rvalid_q <= 1'b0;
    else if (read) rvalid_q <= 1'b1;
    else if (axil_rready_i) rvalid_q <= 1'b0;
  end

  always_ff @(posedge clk_i) begin
    if (read) begin
      rdata_q <= value;
      rresp_q <= read_known ? Okay : SlaveError;
    end
  end
endmodule
