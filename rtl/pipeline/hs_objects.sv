// SPDX-License-Identifier: Apache-2.0
// What joins the pixels of a frame with their depths and objects, for the static objects buffer.
//
//   triangle ─► object table
//                    │
//   scan, Z-buffer ──┴► queue ─► scan_object ─object_pixel─┐
//                                              pixel ──────┴► entry
//
// Stall: scan waits while the queue is full, an entry until both its words are there. The shader
// takes the same words of scan beside this, each when it has room. It needs no later one to send
// the pixels of those that it has, so that the queue, were it full, runs empty.
// The queue does not slow the shader: at a stamp a cycle two more stamps are on their way from the
// fork of scan to `entry` than the shader has cycles, its own queue included, which makes 12 with
// planes of colours, 7 if flat, 32 with Phong shading and one light, and 35 with texture behind it.
// Five of them have room outside the queue: at the fork and in scan_object.
// Interval of an entry: the shader's; scan_object takes no longer for a stamp. Latency: the
// shader's, which is no less than the 5 cycles from scan to object_pixel.
// Object table: two banks, the frames in turn. It is written while a frame's triangles come, which
// hs_frame_control lets in when the frame before the one before has been taken to its end.
// Illegal: a triangle with an index other than 0 of object 0.
// Without objects there is no such unit: hs_formats_pkg has not its numbers then.
module hs_objects #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned ScanFifoDepth =
      hs_formats_pkg::Phong != 0 || hs_formats_pkg::HasTexture != 0 ? 32 : 16,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned ObjectBits = hs_formats_pkg::ObjectBits,
  localparam int unsigned HeadBits = 1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned ScanBits = HeadBits + Lanes * IndexBits,
  localparam int unsigned ColoursBits = Lanes * 3 * ColourBits,
  localparam int unsigned ObjectsBits = Lanes * (DepthBits + ObjectBits)
) (
  input  logic                                        clk_i,
  input  logic                                        rst_ni,

  // A triangle moves into the pipeline
  input  logic                                        triangle_i,
  input  logic                                        triangle_last_i,
  input  logic [IndexBits-1:0]                        triangle_index_i,
  input  logic [ObjectBits-1:0]                       triangle_object_i,

  // From scan_index, with the word of the Z-buffer
  input  logic                                        scan_valid_i,
  output logic                                        scan_ready_o,
  input  logic [ScanBits-1:0]                         scan_i,
  input  logic [Lanes*DepthBits-1:0]                  depth_i,

  // From the shader
  input  logic                                        pixel_valid_i,
  output logic                                        pixel_ready_o,
  input  logic [HeadBits+ColoursBits-1:0]             pixel_i,

  // To the frame
  output logic                                        entry_valid_o,
  input  logic                                        entry_ready_i,
  output logic [HeadBits+ObjectsBits+ColoursBits-1:0] entry_o
);
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);

  // --- Object table ---
  logic read_en, read_bank, store_bank_q, unused_index;
  logic [EntryBits-1:0] read_entry, store_entry;
  logic [ObjectBits-1:0] read_object;

  assign store_entry = EntryBits'(triangle_index_i) - EntryBits'(1);
  assign unused_index = ^triangle_index_i;  // a power of two of entries has a bit less

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) store_bank_q <= 1'b0;
    else if (triangle_i && triangle_last_i) store_bank_q <= !store_bank_q;
  end

  hs_ram_1r1w #(
    .Width(ObjectBits),
    .Depth(2 << EntryBits)
  ) u_object_table (
    .clk_i          (clk_i),
    .read_en_i      (read_en),
    .read_address_i ({read_bank, read_entry}),
    .read_data_o    (read_object),
    .write_en_i     (triangle_i && triangle_index_i != '0),
    .write_address_i({store_bank_q, store_entry}),
    .write_data_i   (triangle_object_i)
  );

  // --- scan ─► object_pixel ---
  logic queued_valid, queued_ready, object_valid, object_ready;
  logic [ScanBits-1:0] queued_scan;
  logic [Lanes*DepthBits-1:0] queued_depth;
  logic [HeadBits-1:0] object_head, pixel_head;
  logic [ObjectsBits-1:0] objects;
  logic [ColoursBits-1:0] colours;

  hs_fifo #(
    .Width(ScanBits + Lanes * DepthBits),
    .Depth(ScanFifoDepth)
  ) u_scan_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (scan_valid_i),
    .in_ready_o (scan_ready_o),
    .in_i       ({scan_i, depth_i}),
    .out_valid_o(queued_valid),
    .out_ready_i(queued_ready),
    .out_o      ({queued_scan, queued_depth})
  );

  hs_scan_object #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_scan_object (
    .clk_i               (clk_i),
    .rst_ni              (rst_ni),
    .scan_valid_i        (queued_valid),
    .scan_ready_o        (queued_ready),
    .scan_i              (queued_scan),
    .depth_i             (queued_depth),
    .read_en_o           (read_en),
    .read_bank_o         (read_bank),
    .read_entry_o        (read_entry),
    .read_object_i       (read_object),
    .object_pixel_valid_o(object_valid),
    .object_pixel_ready_i(object_ready),
    .object_pixel_o      ({object_head, objects})
  );

  // --- Both ─► entry ---
  assign {pixel_head, colours} = pixel_i;
  assign entry_valid_o = pixel_valid_i && object_valid;
  assign pixel_ready_o = entry_ready_i && object_valid;
  assign object_ready = entry_ready_i && pixel_valid_i;
  assign entry_o = {pixel_head, objects, colours};

  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (!entry_valid_o || object_head == pixel_head);
    if (rst_ni) assert (!triangle_i || triangle_index_i == '0 || triangle_object_i != '0);
  end
endmodule
