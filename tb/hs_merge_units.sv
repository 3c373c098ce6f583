// SPDX-License-Identifier: Apache-2.0
// The unit of the static objects buffer, alone, for the bench: as hs_units, which has what every configuration has.
//
//   ztest_merge   a frame is a run, or more: commands are words of a stream
module hs_merge_units #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned EntryBits =
      1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits +
      Lanes * (hs_formats_pkg::DepthBits + hs_formats_pkg::ObjectBits + 3 * ColourBits),
  localparam int unsigned MergeBits = hs_formats_pkg::MergeWordBits,
  localparam int unsigned FoundBits = hs_formats_pkg::FoundWordBits
) (
  input  logic                    rst_ni,
  input  hs_formats_pkg::x_t      frame_width_i,
  input  hs_formats_pkg::y_t      frame_height_i,
  input  logic [3*ColourBits-1:0] background_i,

  input  logic                    ztest_merge_clk_i,
  input  logic                    ztest_merge_merge_valid_i,
  output logic                    ztest_merge_merge_ready_o,
  input  logic [MergeBits-1:0]    ztest_merge_merge_i,
  input  logic                    ztest_merge_stored_valid_i,
  output logic                    ztest_merge_stored_ready_o,
  input  logic [EntryBits-1:0]    ztest_merge_stored_i,
  input  logic                    ztest_merge_entry_valid_i,
  output logic                    ztest_merge_entry_ready_o,
  input  logic [EntryBits-1:0]    ztest_merge_entry_i,
  output logic                    ztest_merge_merged_valid_o,
  input  logic                    ztest_merge_merged_ready_i,
  output logic [EntryBits-1:0]    ztest_merge_merged_o,
  output logic                    ztest_merge_found_valid_o,
  input  logic                    ztest_merge_found_ready_i,
  output logic [FoundBits-1:0]    ztest_merge_found_o
);
  logic unused_registers;
  assign unused_registers = ^{frame_width_i, frame_height_i, background_i};

  hs_ztest_merge #(
    .LanesX(LanesX),
    .LanesY(LanesY)
  ) u_ztest_merge (
    .clk_i         (ztest_merge_clk_i),
    .rst_ni        (rst_ni),
    .merge_valid_i (ztest_merge_merge_valid_i),
    .merge_ready_o (ztest_merge_merge_ready_o),
    .merge_i       (ztest_merge_merge_i),
    .stored_valid_i(ztest_merge_stored_valid_i),
    .stored_ready_o(ztest_merge_stored_ready_o),
    .stored_i      (ztest_merge_stored_i),
    .entry_valid_i (ztest_merge_entry_valid_i),
    .entry_ready_o (ztest_merge_entry_ready_o),
    .entry_i       (ztest_merge_entry_i),
    .merged_valid_o(ztest_merge_merged_valid_o),
    .merged_ready_i(ztest_merge_merged_ready_i),
    .merged_o      (ztest_merge_merged_o),
    .found_valid_o (ztest_merge_found_valid_o),
    .found_ready_i (ztest_merge_found_ready_i),
    .found_o       (ztest_merge_found_o)
  );
endmodule
