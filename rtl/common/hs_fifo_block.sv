// SPDX-License-Identifier: Apache-2.0
// A first-in first-out queue between two streams, its storage in block RAM.
//
// Interval 1, latency 2: a word written is read in the next cycle and offered in the one after.
// The word offered is the RAM's output register. Both handshakes come from a register, so that the
// queue cuts the ready path between its neighbours. Holds Depth words, and the one that is offered.
// Illegal: Depth below 2.
module hs_fifo_block #(
  parameter int unsigned Width = 32,
  parameter int unsigned Depth = 512
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
    $error("hs_fifo_block: Depth must be 2 or more");
  end

  logic [PointerBits-1:0] write_q, read_q;
  logic [CountBits-1:0] count_q;  // words in the RAM that are not offered yet
  logic offered_q;
  logic write, read;

  assign in_ready_o = count_q != CountBits'(Depth);
  assign out_valid_o = offered_q;
  assign write = in_valid_i && in_ready_o;
  assign read = count_q != '0 && (!offered_q || out_ready_i);

  hs_ram_1r1w #(
    .Width(Width),
    .Depth(Depth),
    .Lanes(1)
  ) u_words (
    .clk_i          (clk_i),
    .read_en_i      (read),
    .read_address_i (read_q),
    .read_data_o    (out_o),
    .write_en_i     (write),
    .write_address_i(write_q),
    .write_data_i   (in_i)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      write_q <= '0;
      read_q <= '0;
      count_q <= '0;
      offered_q <= 1'b0;
    end else begin
      if (write) write_q <= write_q == LastPointer ? '0 : write_q + PointerBits'(1);
      if (read) read_q <= read_q == LastPointer ? '0 : read_q + PointerBits'(1);
      if (write && !read) count_q <= count_q + CountBits'(1);
      if (read && !write) count_q <= count_q - CountBits'(1);
      if (read || out_ready_i) offered_q <= read;
    end
  end
endmodule
