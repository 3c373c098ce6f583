// SPDX-License-Identifier: Apache-2.0
// The depths of hs_ztest_index, alongside its stages address | read | test | write: whether each
// fragment in test is nearer than what is stored, and its depth for the write.
//
// Stall: all waits while go_i is 0.
module hs_ztest_depth #(
  parameter int unsigned DepthBits,
  parameter int unsigned Lanes = 4
) (
  input  logic                       clk_i,
  input  logic                       go_i,

  // Of the stamp in test, a lane a bit: what is being written, or was in the cycle before, belongs
  // to the same pixel; else nothing is stored there yet
  input  logic [Lanes-1:0]           near_i,
  input  logic [Lanes-1:0]           far_i,
  input  logic [Lanes-1:0]           first_i,

  input  logic [Lanes*DepthBits-1:0] stamp_depth_i,  // Stage address
  input  logic [Lanes*DepthBits-1:0] read_depth_i,   // Of the Z-buffer, for the stamp in test
  output logic [Lanes-1:0]           nearer_o,       // Stage test
  output logic [Lanes*DepthBits-1:0] write_depth_o   // Stage write
);
  logic [Lanes*DepthBits-1:0] read_depth_q, test_depth_q, write_depth_q, done_depth_q;

  always_ff @(posedge clk_i) begin
    if (go_i) begin
      read_depth_q <= stamp_depth_i;
      test_depth_q <= read_depth_q;
      write_depth_q <= test_depth_q;
      done_depth_q <= write_depth_q;
    end
  end

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    logic [DepthBits-1:0] stored;

    always_comb begin
      if (near_i[lane]) stored = write_depth_q[lane*DepthBits +: DepthBits];
      else if (far_i[lane]) stored = done_depth_q[lane*DepthBits +: DepthBits];
      else if (first_i[lane]) stored = '1;
      else stored = read_depth_i[lane*DepthBits +: DepthBits];
    end
    assign nearer_o[lane] = test_depth_q[lane*DepthBits +: DepthBits] < stored;
  end

  assign write_depth_o = write_depth_q;
endmodule
