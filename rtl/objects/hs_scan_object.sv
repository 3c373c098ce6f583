// SPDX-License-Identifier: Apache-2.0
// Depth and object of each pixel at scan-out (kernel: hls/objects/scan_object.hpp): the depth is
// what the Z-buffer holds, the object that of the pixel's triangle in the object table. A pixel of
// the background has the largest depth and object 0.
//
// Interval: a cycle for each different triangle in a stamp, one for a stamp of pure background, as
// hs_shade_gouraud, and no shader takes less. Latency: 4 cycles from a scan word with one triangle
// to its word. Stages: pick | read | data | merge into the stamp.
// Stall: everything stops while a finished stamp is not taken.
// Object table: entry index − 1; a read takes one cycle, its word stays until the next read. Two
// banks, used in turn by the frames, the first one by the first frame.
// Without objects there is no such unit: hs_formats_pkg has not its numbers then.
module hs_scan_object #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits,
  localparam int unsigned ObjectBits = hs_formats_pkg::ObjectBits,
  localparam int unsigned HeadBits = 1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned ObjectPixelBits = HeadBits + Lanes * (DepthBits + ObjectBits),
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles)
) (
  input  logic                                clk_i,
  input  logic                                rst_ni,

  // From scan_index, with the word of the Z-buffer
  input  logic                                scan_valid_i,
  output logic                                scan_ready_o,
  input  logic [HeadBits+Lanes*IndexBits-1:0] scan_i,
  input  logic [Lanes*DepthBits-1:0]          depth_i,

  // Object table
  output logic                                read_en_o,
  output logic                                read_bank_o,
  output logic [EntryBits-1:0]                read_entry_o,
  input  logic [ObjectBits-1:0]               read_object_i,

  output logic                                object_pixel_valid_o,
  input  logic                                object_pixel_ready_i,
  output logic [ObjectPixelBits-1:0]          object_pixel_o
);
  localparam int unsigned StampBits = HeadBits + Lanes * DepthBits;  // what goes with a group

  logic go;  // all stages move

  // Stage pick: the stamp, and its lanes whose object is not read yet.
  logic pick_valid_q, pick_first_q, group_last, bank_q;
  logic [StampBits-1:0] pick_stamp_q;
  logic [HeadBits-1:0] scan_head;
  logic [Lanes*IndexBits-1:0] scan_index, pick_index_q;
  logic [Lanes*DepthBits-1:0] scan_depth;
  logic [Lanes-1:0] scan_waits, waits_q, group_lanes;
  logic [EntryBits-1:0] group_entry;

  // Stages read and data: a group, which is the lanes of one triangle.
  logic read_valid_q, read_first_q, read_last_q, read_bank_q;
  logic data_valid_q, data_first_q, data_last_q;
  logic [Lanes-1:0] read_lanes_q, data_lanes_q;
  logic [StampBits-1:0] read_stamp_q, data_stamp_q;
  logic [EntryBits-1:0] read_entry_q;

  // Stage merge: the word.
  logic word_valid_q;
  logic [StampBits-1:0] word_stamp_q;
  logic [Lanes*ObjectBits-1:0] word_object_q;

  assign go = !word_valid_q || object_pixel_ready_i;

  assign {scan_head, scan_index} = scan_i;
  assign scan_ready_o = go && (!pick_valid_q || group_last);

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_pick
    assign scan_waits[lane] = scan_index[lane*IndexBits +: IndexBits] != '0;
    assign scan_depth[lane*DepthBits +: DepthBits] =
        depth_i[lane*DepthBits +: DepthBits] | {DepthBits{!scan_waits[lane]}};
  end

  hs_lane_group #(
    .Lanes(Lanes)
  ) u_group (
    .waits_i(waits_q),
    .index_i(pick_index_q),
    .entry_o(group_entry),
    .lanes_o(group_lanes),
    .last_o (group_last)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      pick_valid_q <= 1'b0;
      bank_q <= 1'b0;
      read_valid_q <= 1'b0;
      data_valid_q <= 1'b0;
      word_valid_q <= 1'b0;
    end else if (go) begin
      if (scan_ready_o) pick_valid_q <= scan_valid_i;
      if (pick_valid_q && group_last && pick_stamp_q[StampBits-1]) bank_q <= !bank_q;
      read_valid_q <= pick_valid_q;
      data_valid_q <= read_valid_q;
      word_valid_q <= data_valid_q && data_last_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (scan_valid_i && scan_ready_o) begin
      pick_stamp_q <= {scan_head, scan_depth};
      pick_index_q <= scan_index;
      waits_q <= scan_waits;
      pick_first_q <= 1'b1;
    end else if (go) begin
      waits_q <= waits_q & ~group_lanes;
      pick_first_q <= 1'b0;
    end
    if (go) begin
      read_first_q <= pick_first_q;
      read_last_q <= group_last;
      read_lanes_q <= group_lanes;
      read_stamp_q <= pick_stamp_q;
      read_bank_q <= bank_q;
      read_entry_q <= group_entry;

      data_first_q <= read_first_q;
      data_last_q <= read_last_q;
      data_lanes_q <= read_lanes_q;
      data_stamp_q <= read_stamp_q;

      if (data_valid_q) word_stamp_q <= data_stamp_q;
    end
  end

  assign read_en_o = go && read_valid_q && read_lanes_q != '0;
  assign read_bank_o = read_bank_q;
  assign read_entry_o = read_entry_q;

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    always_ff @(posedge clk_i) begin
      if (go && data_valid_q) begin
        if (data_lanes_q[lane]) word_object_q[lane*ObjectBits +: ObjectBits] <= read_object_i;
        else if (data_first_q) word_object_q[lane*ObjectBits +: ObjectBits] <= '0;
      end
    end
  end

  assign object_pixel_valid_o = word_valid_q;
  assign object_pixel_o = {word_stamp_q, word_object_q};
endmodule
