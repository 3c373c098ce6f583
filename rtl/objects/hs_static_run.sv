// SPDX-License-Identifier: Apache-2.0
// The D-buffer and the S-buffers in memory, before hs_ztest_merge and after it (kernel:
// hls/objects/static_run.hpp): reads the stamps that a run takes, and puts where they belong those
// that it sends.
//
//   command ─► merge
//   stored_place ─► memory ─► stored_pixels ─► stored      or background
//   drawn_place  ─► memory ─► drawn_pixels  ─► drawn       or of a pass, from `entry`
//   merged ─► shown, or kept
//
// A pass is the next frame of hs_pipeline: of its stamps, which come row by row, those of the box
// go on, and the others are dropped.
// Memory: answers are in the order of the places, as late as it likes, and as many may be on their
// way as it takes. A stamp is read as written by every word of `kept` taken before its place is.
// Interval: a stamp a cycle, of a pass each of its frame. A command waits until the words of the
// one before have come and gone: with hs_ztest_merge 4 cycles a run, without `sends` 2, where a
// place is answered in the next cycle; a memory that takes longer adds that once a run.
// Latency: 1 cycle from the command to the first place and to `merge`, none from pixels to `stored`
// and `drawn` nor from `merged` to where it goes. No memory, no multiplier.
// Stall: each stream waits for its taker; a word of `entry` outside the box for none.
// Illegal: a box that is empty or not inside the frame.
// Without objects there is no such unit: hs_formats_pkg has not its numbers then.
module hs_static_run #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned BufferBits = 4,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned ObjectBits = hs_formats_pkg::ObjectBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned MergeBits = hs_formats_pkg::MergeWordBits,
  localparam int unsigned CommandBits = 3 + 3 * BufferBits + 2 * XBits + 2 * YBits + MergeBits,
  localparam int unsigned PlaceBits = BufferBits + XBits + YBits,
  localparam int unsigned PixelsBits = Lanes * (DepthBits + ObjectBits + 3 * ColourBits),
  localparam int unsigned EntryBits = 1 + XBits + YBits + PixelsBits
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  logic                            command_valid_i,
  output logic                            command_ready_o,
  input  logic [CommandBits-1:0]          command_i,

  // To the memory of the buffers, and from it
  output logic                            stored_place_valid_o,
  input  logic                            stored_place_ready_i,
  output logic [PlaceBits-1:0]            stored_place_o,
  input  logic                            stored_pixels_valid_i,
  output logic                            stored_pixels_ready_o,
  input  logic [PixelsBits-1:0]           stored_pixels_i,
  output logic                            drawn_place_valid_o,
  input  logic                            drawn_place_ready_i,
  output logic [PlaceBits-1:0]            drawn_place_o,
  input  logic                            drawn_pixels_valid_i,
  output logic                            drawn_pixels_ready_o,
  input  logic [PixelsBits-1:0]           drawn_pixels_i,
  output logic                            kept_valid_o,
  input  logic                            kept_ready_i,
  output logic [PlaceBits+PixelsBits-1:0] kept_o,

  // From hs_pipeline
  input  logic                            entry_valid_i,
  output logic                            entry_ready_o,
  input  logic [EntryBits-1:0]            entry_i,

  // To hs_ztest_merge, and from it
  output logic                            merge_valid_o,
  input  logic                            merge_ready_i,
  output logic [MergeBits-1:0]            merge_o,
  output logic                            stored_valid_o,
  input  logic                            stored_ready_i,
  output logic [EntryBits-1:0]            stored_o,
  output logic                            drawn_valid_o,
  input  logic                            drawn_ready_i,
  output logic [EntryBits-1:0]            drawn_o,
  input  logic                            merged_valid_i,
  output logic                            merged_ready_o,
  input  logic [EntryBits-1:0]            merged_i,

  // To the frame
  output logic                            shown_valid_o,
  input  logic                            shown_ready_i,
  output logic [EntryBits-1:0]            shown_o
);
  // --- The command ---
  logic start, merging_q, passing_q, storing_q;  // its word, its pass, what it sends is on its way
  logic passes, anew, shows, merges, sends, passes_q, anew_q, shows_q;
  logic [BufferBits-1:0] stored_buffer, drawn_buffer, kept_buffer;
  logic [BufferBits-1:0] stored_buffer_q, drawn_buffer_q, kept_buffer_q;
  logic [XBits-1:0] x_first, x_last, x_first_q, x_last_q;
  logic [YBits-1:0] y_first, y_last, y_last_q;
  logic [MergeBits-1:0] merge, merge_q;
  logic [3*ColourBits-1:0] background;

  // Stamps that are asked for, and that are sent.
  logic stored_asks, drawn_asks, stored_sends, drawn_sends;
  logic [XBits-1:0] stored_asks_x, drawn_asks_x, stored_x, drawn_x;
  logic [YBits-1:0] stored_asks_y, drawn_asks_y, stored_y, drawn_y;
  logic stored_last, drawn_last, unused_asks_last, unused_drawn_asks_last;

  assign {passes, anew, shows, stored_buffer, drawn_buffer, kept_buffer, x_first, x_last, y_first,
          y_last, merge} = command_i;
  assign {merges, sends} = merge[MergeBits-1 -: 2];
  assign background = merge_q[3*ColourBits-1:0];

  assign command_ready_o = !(merging_q || passing_q || storing_q || stored_asks || drawn_asks
                             || stored_sends || drawn_sends);
  assign start = command_valid_i && command_ready_o;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      merging_q <= 1'b0;
      passing_q <= 1'b0;
      storing_q <= 1'b0;
    end else if (start) begin
      merging_q <= 1'b1;
      passing_q <= passes;
      storing_q <= sends;
    end else begin
      if (merge_ready_i) merging_q <= 1'b0;
      if (entry_valid_i && entry_ready_o && entry_i[EntryBits-1]) passing_q <= 1'b0;
      if (merged_valid_i && merged_ready_o && merged_i[EntryBits-1]) storing_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (start) begin
      {passes_q, anew_q, shows_q} <= {passes, anew, shows};
      {stored_buffer_q, drawn_buffer_q, kept_buffer_q} <= {stored_buffer, drawn_buffer,
                                                           kept_buffer};
      {x_first_q, x_last_q, y_last_q} <= {x_first, x_last, y_last};
      merge_q <= merge;
    end
    if (rst_ni) assert (!start || (x_first <= x_last && y_first <= y_last));
  end

  assign merge_valid_o = merging_q;
  assign merge_o = merge_q;

  // --- Places ---
  hs_box_walk #(
    .XBits(XBits),
    .YBits(YBits)
  ) u_stored_places (
    .clk_i    (clk_i),
    .rst_ni   (rst_ni),
    .start_i  (start && !anew),
    .x_start_i(x_first),
    .y_start_i(y_first),
    .x_first_i(x_first_q),
    .x_last_i (x_last_q),
    .y_last_i (y_last_q),
    .next_i   (stored_asks && stored_place_ready_i),
    .valid_o  (stored_asks),
    .x_o      (stored_asks_x),
    .y_o      (stored_asks_y),
    .last_o   (unused_asks_last)
  );

  hs_box_walk #(
    .XBits(XBits),
    .YBits(YBits)
  ) u_drawn_places (
    .clk_i    (clk_i),
    .rst_ni   (rst_ni),
    .start_i  (start && merges && !passes),
    .x_start_i(x_first),
    .y_start_i(y_first),
    .x_first_i(x_first_q),
    .x_last_i (x_last_q),
    .y_last_i (y_last_q),
    .next_i   (drawn_asks && drawn_place_ready_i),
    .valid_o  (drawn_asks),
    .x_o      (drawn_asks_x),
    .y_o      (drawn_asks_y),
    .last_o   (unused_drawn_asks_last)
  );

  assign stored_place_valid_o = stored_asks;
  assign stored_place_o = {stored_buffer_q, stored_asks_x, stored_asks_y};
  assign drawn_place_valid_o = drawn_asks;
  assign drawn_place_o = {drawn_buffer_q, drawn_asks_x, drawn_asks_y};

  // --- Stamps to ztest_merge ---
  hs_box_walk #(
    .XBits(XBits),
    .YBits(YBits)
  ) u_stored (
    .clk_i    (clk_i),
    .rst_ni   (rst_ni),
    .start_i  (start),
    .x_start_i(x_first),
    .y_start_i(y_first),
    .x_first_i(x_first_q),
    .x_last_i (x_last_q),
    .y_last_i (y_last_q),
    .next_i   (stored_valid_o && stored_ready_i),
    .valid_o  (stored_sends),
    .x_o      (stored_x),
    .y_o      (stored_y),
    .last_o   (stored_last)
  );

  hs_box_walk #(
    .XBits(XBits),
    .YBits(YBits)
  ) u_drawn (
    .clk_i    (clk_i),
    .rst_ni   (rst_ni),
    .start_i  (start && merges),
    .x_start_i(x_first),
    .y_start_i(y_first),
    .x_first_i(x_first_q),
    .x_last_i (x_last_q),
    .y_last_i (y_last_q),
    .next_i   (drawn_valid_o && drawn_ready_i),
    .valid_o  (drawn_sends),
    .x_o      (drawn_x),
    .y_o      (drawn_y),
    .last_o   (drawn_last)
  );

  logic in_box;  // the word of `entry` is the next stamp of the box
  logic [PixelsBits-1:0] stored_pixels, drawn_pixels, background_pixels;

  assign background_pixels = {{(Lanes * DepthBits){1'b1}}, {(Lanes * ObjectBits){1'b0}},
                              {Lanes{background[2*ColourBits +: ColourBits]}},
                              {Lanes{background[ColourBits +: ColourBits]}},
                              {Lanes{background[0 +: ColourBits]}}};
  assign stored_pixels = anew_q ? background_pixels : stored_pixels_i;
  assign stored_valid_o = stored_sends && (anew_q || stored_pixels_valid_i);
  assign stored_pixels_ready_o = stored_sends && !anew_q && stored_ready_i;
  assign stored_o = {stored_last, stored_x, stored_y, stored_pixels};

  assign in_box = drawn_sends && entry_i[PixelsBits +: XBits+YBits] == {drawn_x, drawn_y};
  assign entry_ready_o = passing_q && (!in_box || drawn_ready_i);
  assign drawn_pixels = passes_q ? entry_i[PixelsBits-1:0] : drawn_pixels_i;
  assign drawn_valid_o = passes_q ? entry_valid_i && passing_q && in_box
                                  : drawn_sends && drawn_pixels_valid_i;
  assign drawn_pixels_ready_o = drawn_sends && !passes_q && drawn_ready_i;
  assign drawn_o = {drawn_last, drawn_x, drawn_y, drawn_pixels};

  // --- Stamps from it ---
  logic [XBits+YBits-1:0] merged_at;

  assign merged_at = merged_i[PixelsBits +: XBits+YBits];
  assign merged_ready_o = storing_q && (shows_q ? shown_ready_i : kept_ready_i);
  assign shown_valid_o = merged_valid_i && storing_q && shows_q;
  assign shown_o = merged_i;
  assign kept_valid_o = merged_valid_i && storing_q && !shows_q;
  assign kept_o = {kept_buffer_q, merged_at, merged_i[PixelsBits-1:0]};
endmodule
