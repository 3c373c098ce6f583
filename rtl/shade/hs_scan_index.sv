// SPDX-License-Identifier: Apache-2.0
// Scan-out of the I-buffer, and its clearing for the next frame in the same pass
// (kernel: hls/shade/scan_index.hpp).
//
// A token `start` is a pass. With start_clear_i = 0 it reads the stamps of the frame, writes 0 over
// each and sends them, one a cycle, the first two cycles after the token. With start_clear_i = 1 it
// writes 0 over the buffer of the largest frame and sends nothing. start_ready_o is 1 when the pass
// before has ended and its last word was taken.
// Stall: nothing is read while a word is not taken. scan_o comes from the read port of the buffer.
// Buffer: a read takes one cycle, its word stays until the next read, and a read of the word that
// is being written gives the old one.
module hs_scan_index #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits,
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  input  hs_formats_pkg::x_t         frame_width_i,
  input  hs_formats_pkg::y_t         frame_height_i,

  input  logic                       start_valid_i,
  output logic                       start_ready_o,
  input  logic                       start_clear_i,

  // To shade_gouraud
  output logic                       scan_valid_o,
  input  logic                       scan_ready_i,
  output logic [ScanBits-1:0]        scan_o,

  // I-buffer: 0 is written to address_o when it is not only read
  output logic                       read_en_o,
  output logic                       write_en_o,
  output logic [AddressBits-1:0]     address_o,
  input  logic [Lanes*IndexBits-1:0] read_index_i
);

  logic active_q, clear_q, scan_valid_q, step, row_end, pass_end;
  hs_formats_pkg::x_t x_q, x_last_q;
  hs_formats_pkg::y_t y_q, y_last_q;
  logic [AddressBits-1:0] address_q, row_q;  // of the stamp, of the first one in its row
  hs_formats_pkg::scan_head_t scan_head_q;

  assign start_ready_o = !active_q && !scan_valid_q;
  assign step = active_q && (!scan_valid_q || scan_ready_i);
  assign row_end = x_q == x_last_q;
  assign pass_end = row_end && y_q == y_last_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      scan_valid_q <= 1'b0;
    end else begin
      if (start_valid_i && start_ready_o) active_q <= 1'b1;
      else if (step && pass_end) active_q <= 1'b0;
      if (step) scan_valid_q <= !clear_q;
      else if (scan_ready_i) scan_valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (start_valid_i && start_ready_o) begin
      clear_q <= start_clear_i;
      x_last_q <= start_clear_i ? XBits'(StampsX - 1) :
                  (frame_width_i - XBits'(1)) >> $clog2(LanesX);
      y_last_q <= start_clear_i ? YBits'(StampsY - 1) :
                  (frame_height_i - YBits'(1)) >> $clog2(LanesY);
      x_q <= '0;
      y_q <= '0;
      address_q <= '0;
      row_q <= '0;
    end else if (step) begin
      x_q <= row_end ? '0 : x_q + XBits'(1);
      address_q <= address_q + AddressBits'(1);
      if (row_end) begin
        y_q <= y_q + YBits'(1);
        address_q <= row_q + AddressBits'(StampsX);
        row_q <= row_q + AddressBits'(StampsX);
      end
      scan_head_q.last <= pass_end;
      scan_head_q.x <= x_q;
      scan_head_q.y <= y_q;
    end
  end

  assign read_en_o = step && !clear_q;
  assign write_en_o = step;
  assign address_o = address_q;

  assign scan_valid_o = scan_valid_q;
  assign scan_o = {scan_head_q, read_index_i};
endmodule
