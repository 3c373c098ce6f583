// SPDX-License-Identifier: Apache-2.0
// The next triangle of a stamp whose triangles are taken one after the other: that of the first
// lane that waits, and all lanes of it that wait (kernel: next_group in hls/formats/lanes.hpp).
module hs_lane_group #(
  parameter int unsigned Lanes = 4,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles)
) (
  input  logic [Lanes-1:0]           waits_i,
  input  logic [Lanes*IndexBits-1:0] index_i,
  output logic [EntryBits-1:0]       entry_o,  // of the triangle in its database: index − 1
  output logic [Lanes-1:0]           lanes_o,
  output logic                       last_o    // no other lane waits
);
  hs_formats_pkg::index_t index;

  always_comb begin
    index = '0;
    for (int unsigned i = 1; i <= Lanes; i++) begin
      if (waits_i[Lanes-i]) index = index_i[(Lanes-i)*IndexBits +: IndexBits];
    end
  end

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    assign lanes_o[lane] = waits_i[lane] && index_i[lane*IndexBits +: IndexBits] == index;
  end
  assign last_o = (waits_i & ~lanes_o) == '0;
  assign entry_o = EntryBits'(index) - EntryBits'(1);
endmodule
