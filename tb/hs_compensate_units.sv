// SPDX-License-Identifier: Apache-2.0
// The units of frames in between, each alone, for the bench: as hs_units, which has what every configuration has.
//
//   motion_compensate   a word of `key_weight` before the frame is its register
module hs_compensate_units #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned KeyWeightBits = hs_formats_pkg::KeyWeightBits,
  localparam int unsigned RequestBits = hs_formats_pkg::KeyRequestWordBits,
  localparam int unsigned BlockBits = hs_formats_pkg::KeyBlockWordBits,
  localparam int unsigned MotionBits = hs_formats_pkg::MotionWordBits,
  localparam int unsigned CompensatedBits = hs_formats_pkg::CompensatedWordBits
) (
  input  logic                       rst_ni,
  input  hs_formats_pkg::x_t         frame_width_i,
  input  hs_formats_pkg::y_t         frame_height_i,
  input  logic [3*ColourBits-1:0]    background_i,

  input  logic                       motion_compensate_clk_i,
  input  logic                       motion_compensate_key_weight_valid_i,
  input  logic [KeyWeightBits-1:0]   motion_compensate_key_weight_i,
  input  logic                       motion_compensate_motion_valid_i,
  output logic                       motion_compensate_motion_ready_o,
  input  logic [MotionBits-1:0]      motion_compensate_motion_i,
  output logic                       motion_compensate_key_request_0_valid_o,
  input  logic                       motion_compensate_key_request_0_ready_i,
  output logic [RequestBits-1:0]     motion_compensate_key_request_0_o,
  input  logic                       motion_compensate_key_block_0_valid_i,
  output logic                       motion_compensate_key_block_0_ready_o,
  input  logic [BlockBits-1:0]       motion_compensate_key_block_0_i,
  output logic                       motion_compensate_key_request_1_valid_o,
  input  logic                       motion_compensate_key_request_1_ready_i,
  output logic [RequestBits-1:0]     motion_compensate_key_request_1_o,
  input  logic                       motion_compensate_key_block_1_valid_i,
  output logic                       motion_compensate_key_block_1_ready_o,
  input  logic [BlockBits-1:0]       motion_compensate_key_block_1_i,
  output logic                       motion_compensate_compensated_valid_o,
  input  logic                       motion_compensate_compensated_ready_i,
  output logic [CompensatedBits-1:0] motion_compensate_compensated_o
);
  logic unused_registers;
  assign unused_registers = ^{background_i, LanesX, LanesY};

  logic [KeyWeightBits-1:0] key_weight_q;
  always_ff @(posedge motion_compensate_clk_i) begin
    if (motion_compensate_key_weight_valid_i) key_weight_q <= motion_compensate_key_weight_i;
  end

  hs_motion_compensate #(
    .TileXBits(hs_formats_pkg::TileXBits),
    .TileYBits(hs_formats_pkg::TileYBits)
  ) u_motion_compensate (
    .clk_i                (motion_compensate_clk_i),
    .rst_ni               (rst_ni),
    .frame_width_i        (frame_width_i),
    .frame_height_i       (frame_height_i),
    .key_weight_i         (key_weight_q),
    .motion_valid_i       (motion_compensate_motion_valid_i),
    .motion_ready_o       (motion_compensate_motion_ready_o),
    .motion_i             (motion_compensate_motion_i),
    .key_request_0_valid_o(motion_compensate_key_request_0_valid_o),
    .key_request_0_ready_i(motion_compensate_key_request_0_ready_i),
    .key_request_0_o      (motion_compensate_key_request_0_o),
    .key_block_0_valid_i  (motion_compensate_key_block_0_valid_i),
    .key_block_0_ready_o  (motion_compensate_key_block_0_ready_o),
    .key_block_0_i        (motion_compensate_key_block_0_i),
    .key_request_1_valid_o(motion_compensate_key_request_1_valid_o),
    .key_request_1_ready_i(motion_compensate_key_request_1_ready_i),
    .key_request_1_o      (motion_compensate_key_request_1_o),
    .key_block_1_valid_i  (motion_compensate_key_block_1_valid_i),
    .key_block_1_ready_o  (motion_compensate_key_block_1_ready_o),
    .key_block_1_i        (motion_compensate_key_block_1_i),
    .compensated_valid_o  (motion_compensate_compensated_valid_o),
    .compensated_ready_i  (motion_compensate_compensated_ready_i),
    .compensated_o        (motion_compensate_compensated_o)
  );
endmodule
