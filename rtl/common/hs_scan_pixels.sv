// SPDX-License-Identifier: Apache-2.0
// The stamps of scan as pixels, one after the other, for shaders that take them so: the covered
// lanes of a stamp in order, or, of a stamp of background, one pixel that is not covered.
//
// Interval: a pixel a cycle. Latency: 2 cycles to the first pixel of a stamp. Stall: all stages
// wait while en_i is 0. The outputs are registers, for a read of the triangle's entry of TdbS,
// index − 1, in one of its two banks, which the frames use in turn.
module hs_scan_pixels #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned LaneBits = Lanes > 1 ? $clog2(Lanes) : 1,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned HeadBits = 1 + XBits + YBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles)
) (
  input  logic                                clk_i,
  input  logic                                rst_ni,
  input  logic                                en_i,

  // From scan_index
  input  logic                                scan_valid_i,
  output logic                                scan_ready_o,
  input  logic [HeadBits+Lanes*IndexBits-1:0] scan_i,

  // A pixel
  output logic                                valid_o,
  output logic                                covered_o,
  output logic                                first_o,  // of its stamp
  output logic                                last_o,
  output logic [LaneBits-1:0]                 lane_o,
  output logic [HeadBits-1:0]                 head_o,  // of the stamp: {last, x, y}
  output logic [XBits-1:0]                    x_o,  // of the pixel
  output logic [YBits-1:0]                    y_o,
  output logic                                bank_o,
  output logic [EntryBits-1:0]                entry_o
);
  logic stamp_valid_q, stamp_first_q, last, unused_index, bank_q;
  logic [HeadBits-1:0] scan_head, stamp_head_q;
  logic [Lanes*IndexBits-1:0] scan_index, stamp_index_q;
  logic [Lanes-1:0] scan_waits, waits_q, others;
  logic [LaneBits-1:0] lane;
  hs_formats_pkg::index_t index;

  assign {scan_head, scan_index} = scan_i;
  assign scan_ready_o = en_i && (!stamp_valid_q || last);

  for (genvar i = 0; i < Lanes; i++) begin : gen_waits
    assign scan_waits[i] = scan_index[i*IndexBits +: IndexBits] != '0;
  end

  // The first lane that waits.
  always_comb begin
    lane = '0;
    for (int unsigned i = 1; i <= Lanes; i++) begin
      if (waits_q[Lanes-i]) lane = LaneBits'(Lanes - i);
    end
    index = '0;
    others = waits_q;
    for (int unsigned i = 0; i < Lanes; i++) begin
      if (lane == LaneBits'(i)) begin
        index = stamp_index_q[i*IndexBits +: IndexBits];
        others[i] = 1'b0;
      end
    end
  end
  assign last = others == '0;
  assign unused_index = ^index;  // a power of two of entries has a bit less

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      stamp_valid_q <= 1'b0;
      bank_q <= 1'b0;
      valid_o <= 1'b0;
    end else if (en_i) begin
      if (scan_ready_o) stamp_valid_q <= scan_valid_i;
      if (stamp_valid_q && last && stamp_head_q[HeadBits-1]) bank_q <= !bank_q;
      valid_o <= stamp_valid_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (scan_valid_i && scan_ready_o) begin
      stamp_head_q <= scan_head;
      stamp_index_q <= scan_index;
      waits_q <= scan_waits;
      stamp_first_q <= 1'b1;
    end else if (en_i) begin
      waits_q <= others;
      stamp_first_q <= 1'b0;
    end
    if (en_i) begin
      covered_o <= waits_q != '0;
      first_o <= stamp_first_q;
      last_o <= last;
      lane_o <= lane;
      head_o <= stamp_head_q;
      bank_o <= bank_q;
      entry_o <= EntryBits'(index) - EntryBits'(1);
    end
  end

  // The number of a lane is x and y in the stamp side by side.
  assign x_o = XBits'(head_o[YBits +: XBits] << $clog2(LanesX))
               | (XBits'(lane_o) & XBits'(LanesX - 1));
  assign y_o = YBits'(head_o[0 +: YBits] << $clog2(LanesY)) | (YBits'(lane_o) >> $clog2(LanesX));
endmodule
