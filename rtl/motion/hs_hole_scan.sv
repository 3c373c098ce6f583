// SPDX-License-Identifier: Apache-2.0
// Of the scan of a frame what is to be shaded (kernel: hls/motion/hole_scan.hpp): all of it; where
// holes are filled, the pixels that are marked alone, and stamps without a mark are left out, but
// for the last one of the frame.
//
// Interval: a cycle a stamp. Latency: 1 cycle. Stall: nothing is read while a word is not taken.
// Marks of holes: a bit a lane, at the address of the stamp in the I-buffer. A read takes one
// cycle, its word stays until the next read, and a read of the word that is being written gives the
// old one. The marks of a stamp are cleared as it goes by, in every pass: so they are clear when
// those of a frame in between come, which is behind its scan.
module hs_hole_scan #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned HeadBits = 1 + XBits + YBits,
  localparam int unsigned ScanBits = HeadBits + Lanes * IndexBits,
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  logic                   fill_i,  // this pass fills holes: stable while a word is in flight

  // From scan_index
  input  logic                   scan_valid_i,
  output logic                   scan_ready_o,
  input  logic [ScanBits-1:0]    scan_i,

  // Marks of holes: 0 is written to the address that is read
  output logic                   read_en_o,
  output logic                   write_en_o,
  output logic [AddressBits-1:0] address_o,
  input  logic [Lanes-1:0]       read_marks_i,

  // To what shades, and to pixel_store
  output logic                   masked_valid_o,
  input  logic                   masked_ready_i,
  output logic [ScanBits-1:0]    masked_o
);
  logic take, step, valid_q;
  logic [ScanBits-1:0] scan_q;
  logic [Lanes*IndexBits-1:0] index;

  // Stamps come row by row.
  logic [XBits-1:0] x;
  logic [YBits-1:0] y;
  logic [AddressBits-1:0] address_q, row_q;  // of the stamp before, and of the first one in its row

  assign x = scan_i[Lanes*IndexBits+YBits +: XBits];
  assign y = scan_i[Lanes*IndexBits +: YBits];

  always_comb begin
    address_o = address_q + AddressBits'(1);
    if (x == '0) address_o = y == '0 ? '0 : row_q + AddressBits'(StampsX);
  end

  assign step = !valid_q || !masked_valid_o || masked_ready_i;
  assign scan_ready_o = step;
  assign take = scan_valid_i && step;
  assign read_en_o = take;
  assign write_en_o = take;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (step) valid_q <= scan_valid_i;
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      scan_q <= scan_i;
      address_q <= address_o;
      if (x == '0) row_q <= address_o;
    end
  end

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    assign index[lane*IndexBits +: IndexBits] =
        !fill_i || read_marks_i[lane] ? scan_q[lane*IndexBits +: IndexBits] : '0;
  end
  assign masked_valid_o = valid_q && (!fill_i || read_marks_i != '0 || scan_q[ScanBits-1]);
  assign masked_o = {scan_q[ScanBits-1 -: HeadBits], index};
endmodule
