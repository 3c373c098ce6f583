// SPDX-License-Identifier: Apache-2.0
// A word to two takers: each is offered it until it takes it, and the next word waits for both. The
// word itself goes by. Interval 1, latency 0.
module hs_fork (
  input  logic clk_i,
  input  logic rst_ni,
  input  logic in_valid_i,
  output logic in_ready_o,
  output logic first_valid_o,
  input  logic first_ready_i,
  output logic second_valid_o,
  input  logic second_ready_i
);
  logic first_sent_q, second_sent_q;

  assign first_valid_o = in_valid_i && !first_sent_q;
  assign second_valid_o = in_valid_i && !second_sent_q;
  assign in_ready_o = in_valid_i && (first_sent_q || first_ready_i)
                      && (second_sent_q || second_ready_i);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      first_sent_q <= 1'b0;
      second_sent_q <= 1'b0;
    end else if (in_valid_i) begin
      first_sent_q <= !in_ready_o && (first_sent_q || first_ready_i);
      second_sent_q <= !in_ready_o && (second_sent_q || second_ready_i);
    end
  end
endmodule
