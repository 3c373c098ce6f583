// SPDX-License-Identifier: Apache-2.0
// The I-buffer: two banks, of which ztest_index draws into one and scan_index empties the other
// (hs_double_buffer). A write of ztest_index has one index for all of its lanes.
module hs_index_buffer #(
  parameter int unsigned Lanes = 4,
  parameter int unsigned Depth = 1024,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned AddressBits = Depth > 1 ? $clog2(Depth) : 1
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  // From ztest_index
  input  logic                       ztest_read_en_i,
  input  logic                       ztest_read_bank_i,
  input  logic [AddressBits-1:0]     ztest_read_address_i,
  output logic [Lanes*IndexBits-1:0] ztest_read_index_o,
  input  logic [Lanes-1:0]           ztest_write_en_i,
  input  logic                       ztest_write_bank_i,
  input  logic [AddressBits-1:0]     ztest_write_address_i,
  input  hs_formats_pkg::index_t     ztest_write_index_i,

  // From scan_index: writes 0 to the address that it reads
  input  logic                       scan_bank_i,
  input  logic                       scan_read_en_i,
  input  logic                       scan_write_en_i,
  input  logic [AddressBits-1:0]     scan_address_i,
  output logic [Lanes*IndexBits-1:0] scan_read_index_o
);
  hs_double_buffer #(
    .Width(Lanes * IndexBits),
    .Depth(Depth),
    .Lanes(Lanes)
  ) u_banks (
    .clk_i                (clk_i),
    .rst_ni               (rst_ni),
    .ztest_read_en_i      (ztest_read_en_i),
    .ztest_read_bank_i    (ztest_read_bank_i),
    .ztest_read_address_i (ztest_read_address_i),
    .ztest_read_data_o    (ztest_read_index_o),
    .ztest_write_en_i     (ztest_write_en_i),
    .ztest_write_bank_i   (ztest_write_bank_i),
    .ztest_write_address_i(ztest_write_address_i),
    .ztest_write_data_i   ({Lanes{ztest_write_index_i}}),
    .scan_bank_i          (scan_bank_i),
    .scan_read_en_i       (scan_read_en_i),
    .scan_write_en_i      (scan_write_en_i),
    .scan_address_i       (scan_address_i),
    .scan_read_data_o     (scan_read_index_o)
  );
endmodule
