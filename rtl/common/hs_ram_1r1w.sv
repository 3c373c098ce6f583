// SPDX-License-Identifier: Apache-2.0
// A RAM with one read port and one write port that writes by lanes.
//
// A read takes one cycle; its word stays until the next read. A read of the word that is being
// written gives the old one. The content is undefined until written: there is no reset.
// Illegal: a Width that is no multiple of Lanes; addresses of Depth and above.
module hs_ram_1r1w #(
  parameter int unsigned Width = 32,
  parameter int unsigned Depth = 1024,
  parameter int unsigned Lanes = 1,
  localparam int unsigned AddressBits = Depth > 1 ? $clog2(Depth) : 1
) (
  input  logic                   clk_i,

  input  logic                   read_en_i,
  input  logic [AddressBits-1:0] read_address_i,
  output logic [Width-1:0]       read_data_o,

  input  logic [Lanes-1:0]       write_en_i,
  input  logic [AddressBits-1:0] write_address_i,
  input  logic [Width-1:0]       write_data_i
);
  localparam int unsigned LaneBits = Width / Lanes;

  if (Width % Lanes != 0) begin : gen_width_illegal
    $error("hs_ram_1r1w: Width must be a multiple of Lanes");
  end

  // A memory a lane: every tool infers block RAM from this, with or without byte enables.
  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    logic [LaneBits-1:0] words_q [Depth];
    logic [LaneBits-1:0] read_data_q;

    always_ff @(posedge clk_i) begin
      if (write_en_i[lane]) begin
        words_q[write_address_i] <= write_data_i[lane*LaneBits +: LaneBits];
      end
      if (read_en_i) read_data_q <= words_q[read_address_i];
    end

    assign read_data_o[lane*LaneBits +: LaneBits] = read_data_q;
  end
endmodule
