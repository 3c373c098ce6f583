// SPDX-License-Identifier: Apache-2.0
// Of a fork each side has each word once, and both have had it when it is taken.
// unit hs_fork
module harness(input clk, input rst_free, input in_free, input first_ready, input second_ready, output bad);
  wire in_ready, first_valid, second_valid;
  reg began = 0, waits = 0;
  wire rst_ni = began && rst_free;
  wire in_valid = in_free || waits;  // what is offered stays
  unit u_unit (.clk_i(clk), .rst_ni(rst_ni), .in_valid_i(in_valid), .in_ready_o(in_ready),
               .first_valid_o(first_valid), .first_ready_i(first_ready),
               .second_valid_o(second_valid), .second_ready_i(second_ready));

  reg first_done = 0, second_done = 0;
  wire first = first_valid && first_ready, second = second_valid && second_ready;
  wire take = in_valid && in_ready;
  assign bad = rst_ni && ((first_valid && (first_done || !in_valid)) || (second_valid && (second_done || !in_valid))
                          || (take && !((first_done || first) && (second_done || second)))
                          || (in_valid && first_ready && second_ready && !in_ready));
  always @(posedge clk) begin
    began <= 1;
    waits <= rst_ni && in_valid && !in_ready;
    first_done <= rst_ni && !take && (first_done || first);
    second_done <= rst_ni && !take && (second_done || second);
  end
endmodule
