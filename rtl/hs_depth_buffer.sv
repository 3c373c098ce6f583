// SPDX-License-Identifier: Apache-2.0
// The Z-buffer: a word a stamp, written by lanes (hs_ram_1r1w). Without depth there is none, and
// its data are one bit that nobody looks at.
module hs_depth_buffer #(
  parameter int unsigned Lanes = 4,
  parameter int unsigned Depth = 1024,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned DepthsBits = HasDepth != 0 ? Lanes * hs_formats_pkg::DepthBits : 1,
  localparam int unsigned AddressBits = $clog2(Depth)
) (
  input  logic                   clk_i,

  input  logic                   read_en_i,
  input  logic [AddressBits-1:0] read_address_i,
  output logic [DepthsBits-1:0]  read_data_o,

  input  logic [Lanes-1:0]       write_en_i,
  input  logic [AddressBits-1:0] write_address_i,
  input  logic [DepthsBits-1:0]  write_data_i
);
  if (HasDepth != 0) begin : gen_depth
    hs_ram_1r1w #(
      .Width(DepthsBits),
      .Depth(Depth),
      .Lanes(Lanes)
    ) u_ram (
      .clk_i          (clk_i),
      .read_en_i      (read_en_i),
      .read_address_i (read_address_i),
      .read_data_o    (read_data_o),
      .write_en_i     (write_en_i),
      .write_address_i(write_address_i),
      .write_data_i   (write_data_i)
    );
  end else begin : gen_no_depth
    logic unused_ports;
    assign unused_ports = ^{clk_i, read_en_i, read_address_i, write_en_i, write_address_i,
                            write_data_i};
    assign read_data_o = 1'b0;
  end
endmodule
