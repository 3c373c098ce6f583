// SPDX-License-Identifier: Apache-2.0
// A queue loses, doubles and reorders nothing, is ready when it is empty, and offers a word two cycles after it has one.
// unit hs_fifo Width=2 Depth=2
// unit hs_fifo Width=2 Depth=5
// unit hs_fifo_block Width=2 Depth=2
// unit hs_fifo_block Width=2 Depth=4
module harness(input clk, input rst_free, input in_valid, input [1:0] in, input out_ready, output bad);
  wire in_ready, out_valid;
  wire [1:0] out;
  reg began = 0;
  wire rst_ni = began && rst_free;
  unit u_unit (.clk_i(clk), .rst_ni(rst_ni), .in_valid_i(in_valid), .in_ready_o(in_ready), .in_i(in),
               .out_valid_o(out_valid), .out_ready_i(out_ready), .out_o(out));

  // What went in and has not come out, the oldest at the bottom.
  reg [15:0] words = 0;
  reg [3:0] count = 0;
  reg [1:0] waited = 0;
  wire push = in_valid && in_ready;
  wire pop = out_valid && out_ready;
  wire [3:0] kept = count - pop;
  wire [15:0] rest = pop ? words >> 2 : words;
  assign bad = rst_ni && ((out_valid && (count == 0 || out != words[1:0])) || (push && kept == 8)
                          || (count == 0 && !in_ready) || (waited == 3));
  always @(posedge clk) begin
    began <= 1;
    count <= rst_ni ? kept + push : 0;
    words <= push ? (rest & ~(16'd3 << (2 * kept))) | ({14'd0, in} << (2 * kept)) : rest;
    waited <= rst_ni && count != 0 && !out_valid ? waited + 1 : 0;
  end
endmodule
