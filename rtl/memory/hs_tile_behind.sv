// SPDX-License-Identifier: Apache-2.0
// Tiles of hs_tile_cache that are replaced: from their look-up until memory has them, or until the
// slot changes hands and they are as memory has them already.
//
// They leave in order. Of a tile that is in here nothing must be asked (behind_o). index_done_o:
// tiles of the I-buffer that memory has got and that were not in here, the flushed ones, until
// ends_i. Without depth nothing of depth is waited for.
module hs_tile_behind #(
  parameter int unsigned TileBits,
  parameter int unsigned TilesBehind,  // a power of two
  parameter int unsigned DoneBits,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned BehindBits = $clog2(TilesBehind)
) (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic [TileBits-1:0] looked_tile_i,
  output logic                behind_o,
  output logic                room_o,
  input  logic                evict_i,
  input  logic [TileBits-1:0] evict_tile_i,

  // A slot has changed hands: it had a tile; of that memory has everything
  input  logic                swapped_i,
  input  logic                swapped_tile_i,
  input  logic                clean_i,

  input  logic [1:0]          written_i,  // index, depth
  output logic                none_o,
  input  logic                ends_i,
  output logic [DoneBits-1:0] index_done_o
);
  logic [TilesBehind-1:0] live_q, known_q, clean_q;
  logic [TileBits-1:0] tile_q [TilesBehind];
  logic [BehindBits-1:0] in_q, swap_q, out_q;
  logic leaves;
  logic [DoneBits-1:0] index_done_q, depth_done_q;  // written, and not told of

  assign room_o = !live_q[in_q];
  assign none_o = live_q == '0;
  always_comb begin
    behind_o = 1'b0;
    for (int unsigned i = 0; i < TilesBehind; i++) begin
      if (live_q[i] && tile_q[i] == looked_tile_i) behind_o = 1'b1;
    end
  end
  assign leaves = live_q[out_q] && known_q[out_q]
                         && (clean_q[out_q]
                             || (index_done_q != '0 && (HasDepth == 0 || depth_done_q != '0)));

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      live_q <= '0;
      known_q <= '0;
      in_q <= '0;
      swap_q <= '0;
      out_q <= '0;
      index_done_q <= '0;
      depth_done_q <= '0;
    end else begin
      if (leaves) begin
        live_q[out_q] <= 1'b0;
        known_q[out_q] <= 1'b0;
        out_q <= out_q + BehindBits'(1);
      end
      if (evict_i) begin
        live_q[in_q] <= 1'b1;
        in_q <= in_q + BehindBits'(1);
      end
      if (swapped_i && swapped_tile_i) begin
        known_q[swap_q] <= 1'b1;
        swap_q <= swap_q + BehindBits'(1);
      end
      index_done_q <= ends_i ? '0 : index_done_q + DoneBits'(written_i[0])
                      - DoneBits'(leaves && !clean_q[out_q]);
      depth_done_q <= depth_done_q + DoneBits'(written_i[1])
                      - DoneBits'(leaves && !clean_q[out_q]);
    end
  end

  always_ff @(posedge clk_i) begin
    if (evict_i) tile_q[in_q] <= evict_tile_i;
    if (swapped_i && swapped_tile_i) clean_q[swap_q] <= clean_i;
  end

  assign index_done_o = index_done_q;
endmodule
