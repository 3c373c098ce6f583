// SPDX-License-Identifier: Apache-2.0
// The geometry of a board: triangle lists in a read-only memory, one after the other, for ever.
//
// An entry is a triangle without its index, below three flags: the last one of its frame, of its
// scene, of all. A frame is sent Repeats times, then the next one of its scene, from the first one
// on after the last one. next_i asks for the next scene; it takes effect with the next frame, and
// after the last scene comes the first one. Triangles of a frame are numbered from 1 on.
// The file (`rtl/board/lists.py` writes it) has Entries words for $readmemh.
// Interval: 2 cycles a triangle. Stall: a triangle waits until taken.
module hs_board_lists #(
  parameter int unsigned Entries = 256,
  parameter int unsigned Repeats = 2,
  parameter File = "lists.hex"
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  input  logic                      next_i,  // a cycle for each press of the button

  output logic                      triangle_valid_o,
  input  logic                      triangle_ready_i,
  output hs_formats_pkg::triangle_t triangle_o
);
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits;
  localparam int unsigned FieldsBits = $bits(triangle_o) - 1 - IndexBits;
  localparam int unsigned AddressBits = $clog2(Entries);
  localparam int unsigned RepeatBits = $clog2(Repeats + 1);

  logic [FieldsBits+2:0] entries [Entries];
  logic [FieldsBits+2:0] entry_q;
  initial $readmemh(File, entries);

  logic frame_last, scene_last, list_last;
  logic [FieldsBits-1:0] fields;
  logic [AddressBits-1:0] at_q, after, frame_q, scene_q;
  logic [RepeatBits-1:0] repeats_q;
  hs_formats_pkg::index_t index_q;
  logic read_q, valid_q, next_q, skip_q, step;

  assign {frame_last, scene_last, list_last, fields} = entry_q;
  assign after = list_last ? '0 : at_q + AddressBits'(1);
  assign step = valid_q && (triangle_ready_i || skip_q);

  always_ff @(posedge clk_i) begin
    if (read_q) entry_q <= entries[at_q];
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      read_q <= 1'b1;
      valid_q <= 1'b0;
      next_q <= 1'b0;
      skip_q <= 1'b0;
      at_q <= '0;
      frame_q <= '0;
      scene_q <= '0;
      repeats_q <= '0;
      index_q <= IndexBits'(1);
    end else begin
      read_q <= step;
      if (read_q) valid_q <= 1'b1;
      else if (step) valid_q <= 1'b0;
      next_q <= next_q || next_i;
      if (step) begin
        at_q <= after;
        index_q <= index_q + IndexBits'(1);
        if (skip_q) begin
          // What is left of a scene is passed over.
          index_q <= IndexBits'(1);
          if (scene_last) begin
            skip_q <= 1'b0;
            frame_q <= after;
            scene_q <= after;
          end
        end else if (frame_last) begin
          index_q <= IndexBits'(1);
          repeats_q <= '0;
          if (next_q) begin
            next_q <= next_i;
            skip_q <= !scene_last;
            frame_q <= after;
            if (scene_last) scene_q <= after;
          end else if (repeats_q != RepeatBits'(Repeats - 1)) begin
            repeats_q <= repeats_q + RepeatBits'(1);
            at_q <= frame_q;
          end else begin
            at_q <= scene_last ? scene_q : after;
            frame_q <= scene_last ? scene_q : after;
          end
        end
      end
    end
  end

  assign triangle_valid_o = valid_q && !skip_q;
  assign triangle_o = {frame_last, index_q, fields};
endmodule
