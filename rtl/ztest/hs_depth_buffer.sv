// SPDX-License-Identifier: Apache-2.0
// The Z-buffer: a word a stamp, written by lanes (hs_ram_1r1w). With objects it has two banks, as
// the I-buffer (hs_double_buffer); else one, and no scan port: its data are 0 then. Without depth
// there is none, and its data are one bit that nobody looks at.
module hs_depth_buffer #(
  parameter int unsigned Lanes = 4,
  parameter int unsigned Depth = 1024,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * hs_formats_pkg::DepthBits : 1,
  localparam int unsigned AddressBits = Depth > 1 ? $clog2(Depth) : 1
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  // From ztest_index
  input  logic                   ztest_read_en_i,
  input  logic                   ztest_read_bank_i,
  input  logic [AddressBits-1:0] ztest_read_address_i,
  output logic [DepthsBits-1:0]  ztest_read_depth_o,
  input  logic [Lanes-1:0]       ztest_write_en_i,
  input  logic                   ztest_write_bank_i,
  input  logic [AddressBits-1:0] ztest_write_address_i,
  input  logic [DepthsBits-1:0]  ztest_write_depth_i,

  // From scan_index
  input  logic                   scan_bank_i,
  input  logic                   scan_read_en_i,
  input  logic [AddressBits-1:0] scan_address_i,
  output logic [DepthsBits-1:0]  scan_read_depth_o
);
  if (hs_formats_pkg::HasObjects != 0) begin : gen_banks
    hs_double_buffer #(
      .Width(DepthsBits),
      .Depth(Depth),
      .Lanes(Lanes)
    ) u_banks (
      .clk_i                (clk_i),
      .rst_ni               (rst_ni),
      .ztest_read_en_i      (ztest_read_en_i),
      .ztest_read_bank_i    (ztest_read_bank_i),
      .ztest_read_address_i (ztest_read_address_i),
      .ztest_read_data_o    (ztest_read_depth_o),
      .ztest_write_en_i     (ztest_write_en_i),
      .ztest_write_bank_i   (ztest_write_bank_i),
      .ztest_write_address_i(ztest_write_address_i),
      .ztest_write_data_i   (ztest_write_depth_i),
      .scan_bank_i          (scan_bank_i),
      .scan_read_en_i       (scan_read_en_i),
      .scan_write_en_i      (1'b0),
      .scan_address_i       (scan_address_i),
      .scan_read_data_o     (scan_read_depth_o)
    );
  end else begin : gen_no_banks
    logic unused_scan;
    assign unused_scan = ^{rst_ni, ztest_read_bank_i, ztest_write_bank_i, scan_bank_i,
                           scan_read_en_i, scan_address_i};
    assign scan_read_depth_o = '0;

    if (HasDepth != 0) begin : gen_depth
      hs_ram_1r1w #(
        .Width(DepthsBits),
        .Depth(Depth),
        .Lanes(Lanes)
      ) u_ram (
        .clk_i          (clk_i),
        .read_en_i      (ztest_read_en_i),
        .read_address_i (ztest_read_address_i),
        .read_data_o    (ztest_read_depth_o),
        .write_en_i     (ztest_write_en_i),
        .write_address_i(ztest_write_address_i),
        .write_data_i   (ztest_write_depth_i)
      );
    end else begin : gen_no_depth
      logic unused_ports;
      assign unused_ports = ^{clk_i, ztest_read_en_i, ztest_read_address_i, ztest_write_en_i,
                              ztest_write_address_i, ztest_write_depth_i};
      assign ztest_read_depth_o = 1'b0;
    end
  end
endmodule
