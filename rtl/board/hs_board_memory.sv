// SPDX-License-Identifier: Apache-2.0
// The RAM hs_ram_1r1w, of one lane, made of a memory that has a single port and twice the clock:
// the single-port RAMs of small FPGAs.
//
// fast_i is clk_i times two, and rises where clk_i does; second_i is 1 in the second half of a
// cycle of clk_i. The port reads with the edge of clk_i that ends the cycle of read_en_i, and
// writes what it was told in that cycle with the edge of fast_i after it: so a read of the word
// that is being written gives the old one. read_data_o changes in the middle of a cycle, half a
// cycle before it is taken, and stays until the next read.
// With WordEntries = 2 an entry is half a word of 16 bits, written by its mask.
// Illegal: entries of more than 8 bits, two in a word.
module hs_board_memory #(
  parameter int unsigned Width = 8,
  parameter int unsigned Depth = 1024,
  parameter int unsigned WordEntries = 1,  // 1 or 2
  localparam int unsigned AddressBits = $clog2(Depth)
) (
  input  logic                   clk_i,
  input  logic                   fast_i,
  input  logic                   second_i,

  input  logic                   read_en_i,
  input  logic [AddressBits-1:0] read_address_i,
  output logic [Width-1:0]       read_data_o,

  input  logic                   write_en_i,
  input  logic [AddressBits-1:0] write_address_i,
  input  logic [Width-1:0]       write_data_i
);
  localparam int unsigned EntryBits = WordEntries == 2 ? 8 : Width;
  localparam int unsigned WordBits = WordEntries * EntryBits;
  localparam int unsigned Words = (Depth + WordEntries - 1) / WordEntries;
  localparam int unsigned WordAddressBits = $clog2(Words);

  if (EntryBits < Width || WordEntries > 2) begin : gen_width_illegal
    $error("hs_board_memory: two entries in a word have 8 bits at most");
  end

  logic [WordBits-1:0] words_q [Words];
  logic [WordBits-1:0] word_q;  // that was read
  logic read_q, write_q;
  logic [AddressBits-1:0] write_address_q;
  logic [Width-1:0] write_data_q, entry, held_q;
  logic [WordAddressBits-1:0] address;
  logic [WordEntries-1:0] mask;
  logic [WordBits-1:0] write_word;

  always_ff @(posedge clk_i) begin
    read_q <= read_en_i;
    write_q <= write_en_i;
    write_address_q <= write_address_i;
    write_data_q <= write_data_i;
  end

  if (WordEntries == 2) begin : gen_pair
    logic upper_q, unused_word;  // the entry is the upper half of the word that was read
    assign unused_word = ^word_q;
    always_ff @(posedge clk_i) begin
      if (read_en_i) upper_q <= read_address_i[0];
    end
    assign address = second_i ? read_address_i[AddressBits-1:1] : write_address_q[AddressBits-1:1];
    assign mask = write_address_q[0] ? 2'b10 : 2'b01;
    assign write_word = {2{EntryBits'(write_data_q)}};
    assign entry = upper_q ? word_q[EntryBits +: Width] : word_q[0 +: Width];
  end else begin : gen_single
    assign address = second_i ? read_address_i : write_address_q;
    assign mask = 1'b1;
    assign write_word = write_data_q;
    assign entry = word_q;
  end

  always_ff @(posedge fast_i) begin
    if (!second_i && write_q) begin
      for (int unsigned i = 0; i < WordEntries; i++) begin
        if (mask[i]) begin
          words_q[address][i*EntryBits +: EntryBits] <= write_word[i*EntryBits +: EntryBits];
        end
      end
    end else begin
      word_q <= words_q[address];
    end
  end

  always_ff @(posedge fast_i) begin
    if (!second_i && read_q) held_q <= entry;
  end

  assign read_data_o = held_q;
endmodule
