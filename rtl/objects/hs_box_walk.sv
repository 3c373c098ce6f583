// SPDX-License-Identifier: Apache-2.0
// The stamps of a box, row by row, one at a time: the first is there in the cycle after start_i,
// the next in the cycle after next_i.
//
// The box stays as it is while valid_o is 1; x_start_i and y_start_i are its first stamp, with
// start_i. Interval 1.
// Illegal: start_i while valid_o is 1, next_i while it is 0.
module hs_box_walk #(
  parameter int unsigned XBits = 1,
  parameter int unsigned YBits = 1
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             start_i,
  input  logic [XBits-1:0] x_start_i,
  input  logic [YBits-1:0] y_start_i,

  // The box
  input  logic [XBits-1:0] x_first_i,
  input  logic [XBits-1:0] x_last_i,
  input  logic [YBits-1:0] y_last_i,

  input  logic             next_i,
  output logic             valid_o,
  output logic [XBits-1:0] x_o,
  output logic [YBits-1:0] y_o,
  output logic             last_o
);
  logic valid_q, row_ends;
  logic [XBits-1:0] x_q;
  logic [YBits-1:0] y_q;

  assign row_ends = x_q == x_last_i;
  assign last_o = row_ends && y_q == y_last_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (start_i) valid_q <= 1'b1;
    else if (next_i && last_o) valid_q <= 1'b0;
  end

  always_ff @(posedge clk_i) begin
    if (start_i) begin
      x_q <= x_start_i;
      y_q <= y_start_i;
    end else if (next_i) begin
      x_q <= row_ends ? x_first_i : x_q + XBits'(1);
      y_q <= y_q + YBits'(row_ends);
    end
    if (rst_ni) assert (!(start_i && valid_q) && !(next_i && !valid_q));
  end

  assign valid_o = valid_q;
  assign x_o = x_q;
  assign y_o = y_q;
endmodule
