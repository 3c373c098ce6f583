// SPDX-License-Identifier: Apache-2.0
// The pixels of a run of ztest_merge, summed over its stamps, and the box of the stamps that have
// one; all 0 if there is none.
//
// Interval: a stamp a cycle. Latency 1 from the stamp with last_i to `found`.
// Illegal: en_i with last_i while blocked_o is 1.
module hs_merge_found #(
  parameter int unsigned CountBits,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned SumBits = hs_formats_pkg::ObjectCountBits,
  localparam int unsigned FoundBits = hs_formats_pkg::FoundWordBits
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,

  // A stamp, and how many of its pixels are found
  input  logic                 en_i,
  input  logic                 last_i,
  input  logic [XBits-1:0]     x_i,
  input  logic [YBits-1:0]     y_i,
  input  logic [CountBits-1:0] count_i,

  output logic                 blocked_o,  // the word before waits

  output logic                 found_valid_o,
  input  logic                 found_ready_i,
  output logic [FoundBits-1:0] found_o
);
  logic found_valid_q, any;
  logic [FoundBits-1:0] found_q;
  logic [SumBits-1:0] sum, sum_q;
  logic [XBits-1:0] x_first, x_first_q, x_last, x_last_q;
  logic [YBits-1:0] y_first, y_first_q, y_last, y_last_q;

  assign any = sum_q != '0;
  assign sum = sum_q + SumBits'(count_i);

  // The last ones are 0 where there is none before, so that any is behind.
  always_comb begin
    {x_first, x_last, y_first, y_last} = {x_first_q, x_last_q, y_first_q, y_last_q};
    if (count_i != '0) begin
      if (!any || x_i < x_first_q) x_first = x_i;
      if (x_i > x_last_q) x_last = x_i;
      if (!any || y_i < y_first_q) y_first = y_i;
      if (y_i > y_last_q) y_last = y_i;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      found_valid_q <= 1'b0;
      {sum_q, x_first_q, x_last_q, y_first_q, y_last_q} <= '0;
    end else begin
      if (en_i && last_i) found_valid_q <= 1'b1;
      else if (found_ready_i) found_valid_q <= 1'b0;
      if (en_i) begin
        {sum_q, x_first_q, x_last_q, y_first_q, y_last_q} <=
            last_i ? '0 : {sum, x_first, x_last, y_first, y_last};
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (en_i && last_i) found_q <= {sum, x_first, x_last, y_first, y_last};
    if (rst_ni) assert (!(en_i && last_i && blocked_o));
  end

  assign blocked_o = found_valid_q && !found_ready_i;
  assign found_valid_o = found_valid_q;
  assign found_o = found_q;
endmodule
