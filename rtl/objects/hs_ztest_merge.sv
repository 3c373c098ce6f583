// SPDX-License-Identifier: Apache-2.0
// The Z-test of two buffers against each other, stamp by stamp (kernel:
// hls/objects/ztest_merge.hpp): what is stored, less the objects of a range, and what is drawn,
// whichever is nearer; at equal depth the smaller number of an object. It finds the pixels of the
// range and the box of their stamps.
//
// A run is a word of `merge`, then words of `stored` up to the one with last. If it merges, each
// waits for a word of `entry`; if it sends, each is followed by one of `merged`. At its end there
// is one word of `found`.
// Interval: a stamp a cycle, and one more a run, for its command. Latency: 2 cycles from a word of
// `stored` to that of `merged`, 3 from the last one to `found`: a run alone takes its stamps and
// 4 cycles. Stages: test | select, count | sum, box. No multiplier, no memory.
// Stall: all stages stop while a word of `merged` is not taken, and while a word of `found` is not
// taken and the next one is due: until then the next run goes on behind it. A word of `stored` is
// taken with its word of `entry`, each ready following the other's valid; without a command, or if
// the run does not merge, `entry` is not taken.
// Illegal: a word of `entry` of another stamp than its word of `stored`; a stamp twice in a run, if
// its pixels of the range come to more than the largest frame has.
// Without objects there is no such unit: hs_formats_pkg has not its numbers then.
module hs_ztest_merge #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned ObjectBits = hs_formats_pkg::ObjectBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned EntryBits =
      1 + XBits + YBits + Lanes * (DepthBits + ObjectBits + 3 * ColourBits),
  localparam int unsigned MergeBits = hs_formats_pkg::MergeWordBits,
  localparam int unsigned FoundBits = hs_formats_pkg::FoundWordBits
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,

  // The command of a run
  input  logic                 merge_valid_i,
  output logic                 merge_ready_o,
  input  logic [MergeBits-1:0] merge_i,

  // From the static objects buffer
  input  logic                 stored_valid_i,
  output logic                 stored_ready_o,
  input  logic [EntryBits-1:0] stored_i,

  // From hs_pipeline, or what has been kept of it
  input  logic                 entry_valid_i,
  output logic                 entry_ready_o,
  input  logic [EntryBits-1:0] entry_i,

  // To the frame, or to the static objects buffer
  output logic                 merged_valid_o,
  input  logic                 merged_ready_i,
  output logic [EntryBits-1:0] merged_o,

  // To geometry
  output logic                 found_valid_o,
  input  logic                 found_ready_i,
  output logic [FoundBits-1:0] found_o
);
  localparam int unsigned HeadBits = 1 + XBits + YBits;
  localparam int unsigned CountBits = $clog2(Lanes + 1);
  // Where the fields of a lane are.
  localparam int unsigned BlueAt = 0;
  localparam int unsigned GreenAt = BlueAt + Lanes * ColourBits;
  localparam int unsigned RedAt = GreenAt + Lanes * ColourBits;
  localparam int unsigned ObjectAt = RedAt + Lanes * ColourBits;
  localparam int unsigned DepthAt = ObjectAt + Lanes * ObjectBits;
  localparam int unsigned HeadAt = DepthAt + Lanes * DepthBits;

  logic go;  // all stages move

  // --- The run ---
  logic running_q, merges_q, sends_q, take, unused_entry_last;
  logic [ObjectBits-1:0] first_q, last_q;
  logic [3*ColourBits-1:0] background_q;

  assign merge_ready_o = go && !running_q;
  assign stored_ready_o = go && running_q && (!merges_q || entry_valid_i);
  assign entry_ready_o = go && running_q && merges_q && stored_valid_i;
  assign take = stored_valid_i && stored_ready_o;
  assign unused_entry_last = entry_i[EntryBits-1];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) running_q <= 1'b0;
    else if (merge_valid_i && merge_ready_o) running_q <= 1'b1;
    else if (take && stored_i[EntryBits-1]) running_q <= 1'b0;
  end

  // A command is taken as the last stamp of the run before moves into select, or later: each stamp
  // meets that of its own run in both stages.
  always_ff @(posedge clk_i) begin
    if (merge_valid_i && merge_ready_o) begin
      {merges_q, sends_q, first_q, last_q, background_q} <= merge_i;
    end
    if (rst_ni) assert (!take || !merges_q || stored_i[HeadAt +: XBits+YBits]
                                              == entry_i[HeadAt +: XBits+YBits]);
  end

  // --- Stages test and select, by lanes ---
  logic test_valid_q, merged_valid_q;
  logic [Lanes-1:0] hit;  // in select
  logic [HeadBits-1:0] test_head_q, merged_head_q;
  logic [HeadAt-1:0] merged;

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    localparam int unsigned Depth = DepthAt + lane * DepthBits;
    localparam int unsigned Object = ObjectAt + lane * ObjectBits;
    localparam int unsigned Red = RedAt + lane * ColourBits;
    localparam int unsigned Green = GreenAt + lane * ColourBits;
    localparam int unsigned Blue = BlueAt + lane * ColourBits;
    logic [3*ColourBits-1:0] merged_colour;

    hs_merge_lane #(
      .DepthBits (DepthBits),
      .ObjectBits(ObjectBits),
      .ColourBits(ColourBits)
    ) u_lane (
      .clk_i          (clk_i),
      .en_i           (go),
      .merges_i       (merges_q),
      .first_i        (first_q),
      .last_i         (last_q),
      .background_i   (background_q),
      .depth_i        (stored_i[Depth +: DepthBits]),
      .object_i       (stored_i[Object +: ObjectBits]),
      .colour_i       ({stored_i[Red +: ColourBits], stored_i[Green +: ColourBits],
                        stored_i[Blue +: ColourBits]}),
      .entry_depth_i  (entry_i[Depth +: DepthBits]),
      .entry_object_i (entry_i[Object +: ObjectBits]),
      .entry_colour_i ({entry_i[Red +: ColourBits], entry_i[Green +: ColourBits],
                        entry_i[Blue +: ColourBits]}),
      .hit_o          (hit[lane]),
      .merged_depth_o (merged[Depth +: DepthBits]),
      .merged_object_o(merged[Object +: ObjectBits]),
      .merged_colour_o(merged_colour)
    );
    assign {merged[Red +: ColourBits], merged[Green +: ColourBits],
            merged[Blue +: ColourBits]} = merged_colour;
  end

  // --- Stages select and sum: pixels of the range ---
  logic sum_valid_q, due, blocked;
  logic [CountBits-1:0] count, count_q;

  always_comb begin
    count = '0;
    for (int unsigned i = 0; i < Lanes; i++) count = count + CountBits'(hit[i]);
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      test_valid_q <= 1'b0;
      sum_valid_q <= 1'b0;
      merged_valid_q <= 1'b0;
    end else begin
      if (go) begin
        test_valid_q <= take;
        sum_valid_q <= test_valid_q;
      end
      if (go) merged_valid_q <= test_valid_q && sends_q;
      else if (merged_ready_i) merged_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (go) begin
      test_head_q <= stored_i[HeadAt +: HeadBits];
      merged_head_q <= test_head_q;
      count_q <= count;
    end
  end

  hs_merge_found #(
    .CountBits(CountBits)
  ) u_found (
    .clk_i        (clk_i),
    .rst_ni       (rst_ni),
    .en_i         (go && sum_valid_q),
    .last_i       (merged_head_q[HeadBits-1]),
    .x_i          (merged_head_q[YBits +: XBits]),
    .y_i          (merged_head_q[YBits-1:0]),
    .count_i      (count_q),
    .blocked_o    (blocked),
    .found_valid_o(found_valid_o),
    .found_ready_i(found_ready_i),
    .found_o      (found_o)
  );

  assign due = sum_valid_q && merged_head_q[HeadBits-1];
  assign go = (!merged_valid_q || merged_ready_i) && !(due && blocked);

  assign merged_valid_o = merged_valid_q;
  assign merged_o = {merged_head_q, merged};
endmodule
