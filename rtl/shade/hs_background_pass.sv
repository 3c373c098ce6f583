// SPDX-License-Identifier: Apache-2.0
// Stamps of pure background past shade_gouraud, in the order of the scan, so that a stamp of
// several triangles costs no cycle where others have none.
//
//   scan ─┬─ with a triangle, or last ─► queue ─► shade_gouraud ─► queue ─┐
//         └─ order ─────────────────────────────► queue ─────────────────┴─► pixel
//
// The last stamp of a frame goes through the shader, which changes its bank with it. The words of
// `pixel` are those of the shader alone.
// Interval: in the long run the more of a cycle a stamp and a cycle a triangle of a stamp, where
// the queues, of Depth stamps each, reach from one kind to the other. Latency: 6 cycles more than
// the shader. Stall: a pixel word stays until taken.
module hs_background_pass #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned Depth,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned HeadBits = 1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned ScanBits = HeadBits + Lanes * IndexBits,
  localparam int unsigned PixelBits = HeadBits + Lanes * 3 * ColourBits
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  logic [3*ColourBits-1:0] background_i,  // {r, g, b}

  // From scan_index
  input  logic                    scan_valid_i,
  output logic                    scan_ready_o,
  input  logic [ScanBits-1:0]     scan_i,

  // To the shader and back
  output logic                    covered_valid_o,
  input  logic                    covered_ready_i,
  output logic [ScanBits-1:0]     covered_o,
  input  logic                    shaded_valid_i,
  output logic                    shaded_ready_o,
  input  logic [PixelBits-1:0]    shaded_i,

  // To the frame
  output logic                    pixel_valid_o,
  input  logic                    pixel_ready_i,
  output logic [PixelBits-1:0]    pixel_o
);
  logic shades, covered_ready, order_ready, order_valid, done_valid, order_shades;
  logic [HeadBits-1:0] order_head;
  logic [PixelBits-1:0] done;
  logic [Lanes*3*ColourBits-1:0] background;

  assign shades = scan_i[ScanBits-1] || scan_i[Lanes*IndexBits-1:0] != '0;
  assign scan_ready_o = order_ready && (!shades || covered_ready);

  hs_fifo_block #(
    .Width(ScanBits),
    .Depth(Depth)
  ) u_covered_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (scan_valid_i && shades && order_ready),
    .in_ready_o (covered_ready),
    .in_i       (scan_i),
    .out_valid_o(covered_valid_o),
    .out_ready_i(covered_ready_i),
    .out_o      (covered_o)
  );

  // Of as many stamps as the two others hold, and as many of background between them.
  hs_fifo_block #(
    .Width(1 + HeadBits),
    .Depth(4 * Depth)
  ) u_order_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (scan_valid_i && (!shades || covered_ready)),
    .in_ready_o (order_ready),
    .in_i       ({shades, scan_i[ScanBits-1-:HeadBits]}),
    .out_valid_o(order_valid),
    .out_ready_i(pixel_valid_o && pixel_ready_i),
    .out_o      ({order_shades, order_head})
  );

  hs_fifo_block #(
    .Width(PixelBits),
    .Depth(Depth)
  ) u_done_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (shaded_valid_i),
    .in_ready_o (shaded_ready_o),
    .in_i       (shaded_i),
    .out_valid_o(done_valid),
    .out_ready_i(pixel_ready_i && order_valid && order_shades),
    .out_o      (done)
  );

  for (genvar i = 0; i < 3; i++) begin : gen_channel
    assign background[i*Lanes*ColourBits +: Lanes*ColourBits] =
        {Lanes{background_i[i*ColourBits +: ColourBits]}};
  end
  assign pixel_valid_o = order_valid && (!order_shades || done_valid);
  assign pixel_o = order_shades ? done : {order_head, background};
endmodule
