// SPDX-License-Identifier: Apache-2.0
// The bench's own RAM, so that a unit is not tested with the RAM of the product: one read port, one write port by
// lanes, a read takes one cycle and keeps its word, a read of the word that is being written gives the old one.
//
// clear_i writes 0 everywhere in one cycle. Blocking assignments, after the read, as loops over memories need them.
module hs_bench_ram #(
  parameter int unsigned Width,
  parameter int unsigned Depth,
  parameter int unsigned Lanes = 1,
  localparam int unsigned AddressBits = $clog2(Depth)
) (
  input  logic                   clk_i,
  input  logic                   clear_i,

  input  logic                   read_en_i,
  input  logic [AddressBits-1:0] read_address_i,
  output logic [Width-1:0]       read_data_o,

  input  logic [Lanes-1:0]       write_en_i,
  input  logic [AddressBits-1:0] write_address_i,
  input  logic [Width-1:0]       write_data_i
);
  localparam int unsigned LaneBits = Width / Lanes;

  for (genvar lane = 0; lane < int'(Lanes); lane++) begin : gen_lane
    logic [LaneBits-1:0] words [Depth];
    logic [LaneBits-1:0] read_data_q;

    always @(posedge clk_i) begin
      if (read_en_i) read_data_q <= words[read_address_i];
      if (write_en_i[lane]) words[write_address_i] = write_data_i[lane*LaneBits +: LaneBits];
      if (clear_i) begin
        for (int i = 0; i < int'(Depth); i++) words[i] = '0;
      end
    end

    assign read_data_o[lane*LaneBits +: LaneBits] = read_data_q;
  end
endmodule
