// SPDX-License-Identifier: Apache-2.0
// The stamps on their way through hs_ztest_plane, from the read of the I-buffer to its write, and
// whether the next one has a pixel in common with one of them: then it has to wait for the write.
// Triangles that meet in an edge share stamps, not pixels, and pass.
//
// A slot comes in, and each goes a place on, in cycles in which go_i is 1; the last place is the
// write. A slot without lanes meets nothing.
module hs_ztest_flight #(
  parameter int unsigned Places,
  parameter int unsigned AddressBits,
  parameter int unsigned Lanes = 4
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,
  input  logic                   go_i,

  input  logic                   valid_i,
  input  logic [AddressBits-1:0] address_i,
  input  logic [Lanes-1:0]       mask_i,

  input  logic [AddressBits-1:0] next_address_i,
  input  logic [Lanes-1:0]       next_mask_i,
  output logic                   meets_o,
  output logic [AddressBits-1:0] last_address_o  // of the write
);
  logic [Places-1:0] valid_q, meets;
  logic [Places*AddressBits-1:0] address_q;
  logic [Places*Lanes-1:0] mask_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (go_i) valid_q <= {valid_q[Places-2:0], valid_i};
  end

  always_ff @(posedge clk_i) begin
    if (go_i) begin
      address_q <= {address_q[(Places-1)*AddressBits-1:0], address_i};
      mask_q <= {mask_q[(Places-1)*Lanes-1:0], mask_i};
    end
  end

  for (genvar i = 0; i < Places; i++) begin : gen_place
    assign meets[i] = valid_q[i] && address_q[i*AddressBits +: AddressBits] == next_address_i &&
                      |(mask_q[i*Lanes +: Lanes] & next_mask_i);
  end
  assign meets_o = |meets;
  assign last_address_o = address_q[(Places-1)*AddressBits +: AddressBits];
endmodule
