// SPDX-License-Identifier: Apache-2.0
// The I-buffer: two banks, of which ztest_index draws into one and scan_index empties the other.
//
// Each user sees one RAM with a read latency of one cycle whose word stays until its next read.
// Illegal: both users in the same bank.
module hs_index_buffer #(
  parameter int unsigned Lanes = 4,
  parameter int unsigned Depth = 1024,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned AddressBits = $clog2(Depth)
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
  logic ztest_bank_q;  // of the word that was read last
  logic [1:0] ztest_read, ztest_write, scan_read, scan_write;
  logic [2*Lanes*IndexBits-1:0] read_data;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) ztest_bank_q <= 1'b0;
    else if (ztest_read_en_i) ztest_bank_q <= ztest_read_bank_i;
  end

  for (genvar bank = 0; bank < 2; bank++) begin : gen_bank
    assign ztest_read[bank] = ztest_read_en_i && ztest_read_bank_i == 1'(bank);
    assign ztest_write[bank] = |ztest_write_en_i && ztest_write_bank_i == 1'(bank);
    assign scan_read[bank] = scan_read_en_i && scan_bank_i == 1'(bank);
    assign scan_write[bank] = scan_write_en_i && scan_bank_i == 1'(bank);

    always_ff @(posedge clk_i) begin
      if (rst_ni) assert (!scan_write[bank] || !(ztest_read[bank] || ztest_write[bank]));
    end

    hs_ram_1r1w #(
      .Width(Lanes * IndexBits),
      .Depth(Depth),
      .Lanes(Lanes)
    ) u_ram (
      .clk_i          (clk_i),
      .read_en_i      (ztest_read[bank] || scan_read[bank]),
      .read_address_i (ztest_read[bank] ? ztest_read_address_i : scan_address_i),
      .read_data_o    (read_data[bank*Lanes*IndexBits +: Lanes*IndexBits]),
      .write_en_i     (ztest_write[bank] ? ztest_write_en_i : {Lanes{scan_write[bank]}}),
      .write_address_i(ztest_write[bank] ? ztest_write_address_i : scan_address_i),
      .write_data_i   (ztest_write[bank] ? {Lanes{ztest_write_index_i}} : '0)
    );
  end

  assign ztest_read_index_o = read_data[(ztest_bank_q ? Lanes * IndexBits : 0) +: Lanes*IndexBits];
  assign scan_read_index_o = read_data[(scan_bank_i ? Lanes * IndexBits : 0) +: Lanes*IndexBits];
endmodule
