// SPDX-License-Identifier: Apache-2.0
// The records of units that are given triangles in turn, in the order of the triangles: setup and
// attributes of one unit, then those of the next.
//
// A unit offers the attributes of a triangle no later than its setup, or never; and nothing of its
// next triangle before both were taken. Fork: setup and attributes each stay until taken, and the
// next unit waits for both. Interval 1, latency 0.
module hs_setup_collect #(
  parameter int unsigned Turns,
  parameter int unsigned SetupBits,       // of setup_t and attributes_t
  parameter int unsigned AttributesBits
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  logic [Turns-1:0]                setup_valid_i,
  output logic [Turns-1:0]                setup_ready_o,
  input  logic [Turns*SetupBits-1:0]      setup_i,
  input  logic [Turns-1:0]                attributes_valid_i,
  output logic [Turns-1:0]                attributes_ready_o,
  input  logic [Turns*AttributesBits-1:0] attributes_i,

  output logic                            setup_valid_o,
  input  logic                            setup_ready_i,
  output hs_formats_pkg::setup_t          setup_o,
  output logic                            attributes_valid_o,
  input  logic                            attributes_ready_i,
  output hs_formats_pkg::attributes_t     attributes_o
);
  logic [Turns-1:0] turn_q;  // one bit is 1
  logic setup_sent_q, setup_taken, next;

  always_comb begin
    setup_o = '0;
    attributes_o = '0;
    for (int unsigned i = 0; i < Turns; i++) begin
      setup_o |= setup_i[i*SetupBits +: SetupBits] & {SetupBits{turn_q[i]}};
      attributes_o |= attributes_i[i*AttributesBits +: AttributesBits]
                      & {AttributesBits{turn_q[i]}};
    end
  end

  assign setup_valid_o = |(setup_valid_i & turn_q);
  assign attributes_valid_o = |(attributes_valid_i & turn_q) && (setup_valid_o || setup_sent_q);
  assign setup_taken = setup_valid_o && setup_ready_i;
  assign next = (setup_sent_q || setup_taken) && (!attributes_valid_o || attributes_ready_i);
  assign setup_ready_o = turn_q & {Turns{setup_taken}};
  assign attributes_ready_o = turn_q & {Turns{attributes_valid_o && attributes_ready_i}};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      turn_q <= Turns'(1);
      setup_sent_q <= 1'b0;
    end else begin
      if (next) turn_q <= {turn_q[Turns-2:0], turn_q[Turns-1]};
      setup_sent_q <= !next && (setup_sent_q || setup_taken);
    end
  end
endmodule
