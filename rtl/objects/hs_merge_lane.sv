// SPDX-License-Identifier: Apache-2.0
// A pixel of ztest_merge: is it of the range, and which of the two pixels is nearer? A pixel of the
// range becomes background; what is drawn takes the place of background, and of what has a greater
// {depth, object}.
//
// Interval 1. Latency: 1 cycle to hit_o, 2 to the pixel, of those in which en_i is 1, which is
// their only stall. background_i is looked at with hit_o, the rest of the command with the pixels.
module hs_merge_lane #(
  parameter int unsigned DepthBits,
  parameter int unsigned ObjectBits,
  parameter int unsigned ColourBits
) (
  input  logic                    clk_i,
  input  logic                    en_i,

  // The command
  input  logic                    merges_i,
  input  logic [ObjectBits-1:0]   first_i,
  input  logic [ObjectBits-1:0]   last_i,
  input  logic [3*ColourBits-1:0] background_i,

  input  logic [DepthBits-1:0]    depth_i,
  input  logic [ObjectBits-1:0]   object_i,
  input  logic [3*ColourBits-1:0] colour_i,
  input  logic [DepthBits-1:0]    entry_depth_i,
  input  logic [ObjectBits-1:0]   entry_object_i,
  input  logic [3*ColourBits-1:0] entry_colour_i,

  output logic                    hit_o,
  output logic [DepthBits-1:0]    merged_depth_o,
  output logic [ObjectBits-1:0]   merged_object_o,
  output logic [3*ColourBits-1:0] merged_colour_o
);
  localparam int unsigned PixelBits = DepthBits + ObjectBits + 3 * ColourBits;

  logic hit, nearer, hit_q, nearer_q;
  logic [PixelBits-1:0] stored_q, entry_q, merged_q, erased;

  assign hit = object_i != '0 && first_i <= object_i && object_i <= last_i;
  assign nearer = merges_i && (object_i == '0 || hit
                               || {entry_depth_i, entry_object_i} < {depth_i, object_i});
  assign erased = {{DepthBits{1'b1}}, {ObjectBits{1'b0}}, background_i};

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      hit_q <= hit;
      nearer_q <= nearer;
      stored_q <= {depth_i, object_i, colour_i};
      entry_q <= {entry_depth_i, entry_object_i, entry_colour_i};

      if (nearer_q) merged_q <= entry_q;
      else if (hit_q) merged_q <= erased;
      else merged_q <= stored_q;
    end
  end

  assign hit_o = hit_q;
  assign {merged_depth_o, merged_object_o, merged_colour_o} = merged_q;
endmodule
