// SPDX-License-Identifier: Apache-2.0
// Runs of 64-bit words from memory, in the order in which they are asked for.
//
// `start` is an address, a multiple of 8 bytes, and a number of words. They are read ahead as far
// as the queue holds them, Beats words of the memory, in requests of Burst at most; four runs may
// be under way. A word is little endian: the lower address is the lower half of a memory's word of
// 128 bits, and a run may begin or end in its midst.
// Illegal: a run of no words; Beats below twice Burst.
module hs_fetch #(
  parameter int unsigned DataBits = 64,
  parameter int unsigned WordsBits = 28,
  parameter int unsigned Burst = 16,
  parameter int unsigned Beats = 64,
  localparam int unsigned AddressBits = hs_memory_pkg::AddressBits,
  localparam int unsigned BeatsBits = hs_memory_pkg::BeatsBits,
  localparam int unsigned RequestBits = hs_memory_pkg::RequestBits
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  input  logic                   start_valid_i,
  output logic                   start_ready_o,
  input  logic [AddressBits-1:0] start_address_i,
  input  logic [WordsBits-1:0]   start_words_i,

  output logic                   request_valid_o,
  input  logic                   request_ready_i,
  output logic [RequestBits-1:0] request_o,
  input  logic                   data_valid_i,
  input  logic [DataBits-1:0]    data_i,

  output logic                   word_valid_o,
  input  logic                   word_ready_i,
  output logic [63:0]            word_o
);
  localparam int unsigned Halves = DataBits / 64;
  localparam int unsigned ByteBits = $clog2(DataBits / 8);
  localparam int unsigned ReservedBits = $clog2(Beats + 1);

  // --- requests ---
  logic busy_q, start, ask, run_ready, pop;
  logic [AddressBits-1:0] address_q;
  logic [WordsBits:0] beats_q, first_beats;
  logic [BeatsBits-1:0] beats;
  logic [ReservedBits-1:0] reserved_q;  // words of the memory that were asked for and not taken

  assign start_ready_o = !busy_q && run_ready;
  assign start = start_valid_i && start_ready_o;
  assign request_valid_o = busy_q && reserved_q <= ReservedBits'(Beats - Burst);
  assign ask = request_valid_o && request_ready_i;
  assign beats = beats_q > (WordsBits+1)'(Burst) ? BeatsBits'(Burst) : BeatsBits'(beats_q);
  assign request_o = {address_q, beats};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      busy_q <= 1'b0;
      reserved_q <= '0;
    end else begin
      if (start) busy_q <= 1'b1;
      else if (ask && beats_q == (WordsBits+1)'(beats)) busy_q <= 1'b0;
      reserved_q <= reserved_q + (ask ? ReservedBits'(beats) : '0) - ReservedBits'(pop);
    end
  end

  always_ff @(posedge clk_i) begin
    if (start) begin
      address_q <= {start_address_i[AddressBits-1:ByteBits], {ByteBits{1'b0}}};
      beats_q <= first_beats;
    end else if (ask) begin
      address_q <= address_q + (AddressBits'(beats) << ByteBits);
      beats_q <= beats_q - (WordsBits+1)'(beats);
    end
  end

  logic unused_address;
  assign unused_address = ^start_address_i[2:0];

  // --- words that came ---
  logic beat_valid, unused_beat_ready;
  logic [DataBits-1:0] beat;

  hs_fifo #(
    .Width(DataBits),
    .Depth(Beats)
  ) u_beats_fifo (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (data_valid_i),
    .in_ready_o (unused_beat_ready),  // there is room for what was asked for
    .in_i       (data_i),
    .out_valid_o(beat_valid),
    .out_ready_i(pop),
    .out_o      (beat)
  );

  if (Halves == 1) begin : gen_whole
    assign first_beats = {1'b0, start_words_i};
    assign run_ready = 1'b1;
    assign word_valid_o = beat_valid;
    assign pop = beat_valid && word_ready_i;
    assign word_o = beat;
  end else begin : gen_halves
    // Where a run begins, and how many words it still has.
    logic run_valid, run_take, upper, upper_q, first_q, run_last;
    logic [WordsBits:0] run;
    logic [WordsBits-1:0] left, left_q;

    assign first_beats = ({1'b0, start_words_i} + (WordsBits+1)'(start_address_i[3])
                          + (WordsBits+1)'(1)) >> 1;

    hs_fifo #(
      .Width(WordsBits + 1),
      .Depth(4)
    ) u_runs_fifo (
      .clk_i      (clk_i),
      .rst_ni     (rst_ni),
      .in_valid_i (start_valid_i && !busy_q),
      .in_ready_o (run_ready),
      .in_i       ({start_address_i[3], start_words_i}),
      .out_valid_o(run_valid),
      .out_ready_i(run_take && run_last),
      .out_o      (run)
    );

    assign upper = first_q ? run[WordsBits] : upper_q;
    assign left = first_q ? run[WordsBits-1:0] : left_q;
    assign run_last = left == WordsBits'(1);
    assign word_valid_o = run_valid && beat_valid;
    assign run_take = word_valid_o && word_ready_i;
    assign pop = run_take && (upper || run_last);
    assign word_o = upper ? beat[DataBits-1 -: 64] : beat[63:0];

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) first_q <= 1'b1;
      else if (run_take) first_q <= run_last;
    end

    always_ff @(posedge clk_i) begin
      if (run_take) begin
        upper_q <= !upper;
        left_q <= left - WordsBits'(1);
      end
    end
  end
endmodule
