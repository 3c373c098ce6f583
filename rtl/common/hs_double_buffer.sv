// SPDX-License-Identifier: Apache-2.0
// A buffer of a frame with two banks, of which the Z-test draws into one and scan_index reads the
// other, and may clear it: a word a stamp, written by lanes (hs_ram_1r1w).
//
// Each user sees one RAM with a read latency of one cycle whose word stays until its next read.
// Illegal: both users in the same bank.
module hs_double_buffer #(
  parameter int unsigned Width = 32,
  parameter int unsigned Depth = 1024,
  parameter int unsigned Lanes = 1,
  localparam int unsigned AddressBits = Depth > 1 ? $clog2(Depth) : 1
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  // From the Z-test
  input  logic                   ztest_read_en_i,
  input  logic                   ztest_read_bank_i,
  input  logic [AddressBits-1:0] ztest_read_address_i,
  output logic [Width-1:0]       ztest_read_data_o,
  input  logic [Lanes-1:0]       ztest_write_en_i,
  input  logic                   ztest_write_bank_i,
  input  logic [AddressBits-1:0] ztest_write_address_i,
  input  logic [Width-1:0]       ztest_write_data_i,

  // From scan_index: writes 0 to the address that it reads
  input  logic                   scan_bank_i,
  input  logic                   scan_read_en_i,
  input  logic                   scan_write_en_i,
  input  logic [AddressBits-1:0] scan_address_i,
  output logic [Width-1:0]       scan_read_data_o
);
  logic ztest_bank_q;  // of the word that was read last
  logic [1:0] ztest_read, ztest_write, scan_read, scan_write;
  logic [2*Width-1:0] read_data;

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
      if (rst_ni) begin
        assert (!(scan_read[bank] || scan_write[bank]) || !(ztest_read[bank] || ztest_write[bank]));
      end
    end

    hs_ram_1r1w #(
      .Width(Width),
      .Depth(Depth),
      .Lanes(Lanes)
    ) u_ram (
      .clk_i          (clk_i),
      .read_en_i      (ztest_read[bank] || scan_read[bank]),
      .read_address_i (ztest_read[bank] ? ztest_read_address_i : scan_address_i),
      .read_data_o    (read_data[bank*Width +: Width]),
      .write_en_i     (ztest_write[bank] ? ztest_write_en_i : {Lanes{scan_write[bank]}}),
      .write_address_i(ztest_write[bank] ? ztest_write_address_i : scan_address_i),
      .write_data_i   (ztest_write[bank] ? ztest_write_data_i : '0)
    );
  end

  assign ztest_read_data_o = read_data[(ztest_bank_q ? Width : 0) +: Width];
  assign scan_read_data_o = read_data[(scan_bank_i ? Width : 0) +: Width];
endmodule
