// SPDX-License-Identifier: Apache-2.0
// The pixels of a frame one after the other, for memories of pixels: each with the face that it
// shows (kernel: hls/motion/pixel_store.hpp). Stamps in order, lanes in order, those inside the
// frame alone.
//
// Interval: a cycle a pixel. Latency from the word of `pixel`, or of its word of `scan` if that
// comes later, to its first pixel: 2 cycles. `shown` never waits, so nothing stalls but input.
// scan waits in a queue for the shader's word of the same stamp.
// Face table: what a triangle shows goes to entry index − 1 as it moves into the pipeline, with a
// face where the configuration has one a triangle. A frame is over before the next one moves in.
module hs_pixel_store #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  // As many stamps as a shader holds.
  parameter int unsigned ScanFifoDepth = 32,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned HeadBits = 1 + XBits + YBits,
  localparam int unsigned ScanBits = HeadBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = HeadBits + Lanes * 3 * ColourBits,
  localparam int unsigned ShownBits = HeadBits + 1 + FaceBits + 3 * ColourBits
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t        frame_width_i,
  input  hs_formats_pkg::y_t        frame_height_i,

  // A triangle moves into the pipeline
  input  logic                      triangle_valid_i,
  input  hs_formats_pkg::numbered_t triangle_i,

  // Of the same stamp: from hole_scan, and from what shades it
  input  logic                      scan_valid_i,
  output logic                      scan_ready_o,
  input  logic [ScanBits-1:0]       scan_i,
  input  logic                      pixel_valid_i,
  output logic                      pixel_ready_o,
  input  logic [PixelBits-1:0]      pixel_i,

  // To the memory of a key frame, or to the film buffer
  output logic                      shown_valid_o,
  output logic [ShownBits-1:0]      shown_o
);
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);
  localparam int unsigned LaneBits = Lanes > 1 ? $clog2(Lanes) : 1;

  // --- The two words of a stamp ---
  logic queued_valid, take;
  logic [ScanBits-1:0] queued;
  logic [HeadBits-1:0] scan_head, pixel_head;
  logic [Lanes*IndexBits-1:0] scan_index;
  logic [3*Lanes*ColourBits-1:0] pixel_colour;
  logic [Lanes-1:0] in_frame;
  logic stamp_valid_q, lane_last;
  logic [HeadBits-1:0] stamp_head_q;
  logic [Lanes*IndexBits-1:0] stamp_index_q;
  logic [3*Lanes*ColourBits-1:0] stamp_colour_q;
  logic [Lanes-1:0] waits_q, others;

  hs_fifo #(
    .Width(ScanBits),
    .Depth(ScanFifoDepth)
  ) u_scan_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (scan_valid_i),
    .in_ready_o (scan_ready_o),
    .in_i       (scan_i),
    .out_valid_o(queued_valid),
    .out_ready_i(take),
    .out_o      (queued)
  );
  assign {scan_head, scan_index} = queued;
  assign {pixel_head, pixel_colour} = pixel_i;
  assign pixel_ready_o = queued_valid && (!stamp_valid_q || lane_last);
  assign take = pixel_valid_i && pixel_ready_o;

  // The number of a lane is x and y in the stamp side by side.
  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_inside
    logic [XBits-1:0] x;
    logic [YBits-1:0] y;
    assign x = XBits'(pixel_head[YBits +: XBits] << $clog2(LanesX)) | XBits'(lane % LanesX);
    assign y = YBits'(pixel_head[0 +: YBits] << $clog2(LanesY)) | YBits'(lane / LanesX);
    assign in_frame[lane] = x < frame_width_i && y < frame_height_i;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) stamp_valid_q <= 1'b0;
    else if (take) stamp_valid_q <= 1'b1;
    else if (lane_last) stamp_valid_q <= 1'b0;
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      stamp_head_q <= scan_head;
      stamp_index_q <= scan_index;
      stamp_colour_q <= pixel_colour;
      waits_q <= in_frame;
    end else begin
      waits_q <= others;
    end
    if (rst_ni) assert (!take || scan_head == pixel_head);
  end

  // --- A lane of it ---
  logic [LaneBits-1:0] lane;
  logic [IndexBits-1:0] index;
  logic [3*ColourBits-1:0] colour;
  logic unused_index;

  always_comb begin
    lane = '0;
    for (int unsigned i = 1; i <= Lanes; i++) begin
      if (waits_q[Lanes-i]) lane = LaneBits'(Lanes - i);
    end
    index = '0;
    colour = '0;
    others = waits_q;
    for (int unsigned i = 0; i < Lanes; i++) begin
      if (lane == LaneBits'(i)) begin
        index = stamp_index_q[i*IndexBits +: IndexBits];
        colour = {stamp_colour_q[(2*Lanes+i)*ColourBits +: ColourBits],
                  stamp_colour_q[(Lanes+i)*ColourBits +: ColourBits],
                  stamp_colour_q[i*ColourBits +: ColourBits]};
        others[i] = 1'b0;
      end
    end
  end
  assign lane_last = others == '0;

  // --- Its face ---
  logic [EntryBits-1:0] entry, triangle_entry;
  logic [FaceBits-1:0] face;
  logic shown_valid_q, shown_q;
  logic [HeadBits-1:0] head_q;
  logic [3*ColourBits-1:0] colour_q;

  assign entry = EntryBits'(index) - EntryBits'(1);
  assign triangle_entry = EntryBits'(triangle_i.index) - EntryBits'(1);
  assign unused_index = ^{triangle_i, index};

  hs_ram_1r1w #(
    .Width(FaceBits),
    .Depth(1 << EntryBits)
  ) u_face_table (
    .clk_i          (clk_i),
    .read_en_i      (stamp_valid_q),
    .read_address_i (entry),
    .read_data_o    (face),
    .write_en_i     (triangle_valid_i && triangle_i.index != '0),
    .write_address_i(triangle_entry),
    .write_data_i   (triangle_i.face)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) shown_valid_q <= 1'b0;
    else shown_valid_q <= stamp_valid_q;
  end

  always_ff @(posedge clk_i) begin
    shown_q <= index != '0;
    head_q <= {stamp_head_q[HeadBits-1] && lane_last,
               XBits'(stamp_head_q[YBits +: XBits] << $clog2(LanesX))
               | (XBits'(lane) & XBits'(LanesX - 1)),
               YBits'(stamp_head_q[0 +: YBits] << $clog2(LanesY))
               | (YBits'(lane) >> $clog2(LanesX))};
    colour_q <= colour;
  end

  assign shown_valid_o = shown_valid_q;
  assign shown_o = {head_q, shown_q, shown_q ? face : FaceBits'(0), colour_q};
endmodule
