// SPDX-License-Identifier: Apache-2.0
// A first-in first-out queue between two streams.
//
// Interval 1, latency 1: a word written can be taken in the next cycle. Both handshakes come from a
// register, so that the queue cuts the ready path between its neighbours. The storage is read
// asynchronously (LUTRAM).
// Illegal: Depth below 2 (a queue of one word would halve the rate).
module hs_fifo #(
  parameter int unsigned Width = 32,
  parameter int unsigned Depth = 16
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  logic [Width-1:0] in_i,

  output logic             out_valid_o,
  input  logic             out_ready_i,
  output logic [Width-1:0] out_o
);
  localparam int unsigned PointerBits = $clog2(Depth);
  localparam int unsigned CountBits = $clog2(Depth + 1);
  localparam logic [PointerBits-1:0] LastPointer = PointerBits'(Depth - 1);

  if (Depth < 2) begin : gen_depth_illegal
    $error("hs_fifo: Depth must be 2 or more");
  end

  logic [Width-1:0] words_q [Depth];
  logic [PointerBits-1:0] write_q, read_q;
  logic [CountBits-1:0] count_q;
  logic write, read;

  assign in_ready_o = count_q != CountBits'(Depth);
  assign out_valid_o = count_q != '0;
  assign out_o = words_q[read_q];
  assign write = in_valid_i && in_ready_o;
  assign read = out_valid_o && out_ready_i;

  always_ff @(posedge clk_i) begin
    if (write) words_q[write_q] <= in_i;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      write_q <= '0;
      read_q <= '0;
      count_q <= '0;
    end else begin
      if (write) write_q <= write_q == LastPointer ? '0 : write_q + PointerBits'(1);
      if (read) read_q <= read_q == LastPointer ? '0 : read_q + PointerBits'(1);
      if (write && !read) count_q <= count_q + CountBits'(1);
      if (read && !write) count_q <= count_q - CountBits'(1);
    end
  end
endmodule
