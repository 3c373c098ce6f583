// SPDX-License-Identifier: Apache-2.0
// Which lanes of a stamp of hs_raster_pineda lie inside the frame.
//
// The frame size is taken on load_i; `inside_o` follows x_i, y_i in the same cycle.
// Limits: the stamp holds a pixel of the frame, so only the last column and row of stamps are cut.
module hs_raster_clip #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY
) (
  input  logic               clk_i,

  input  logic               load_i,
  input  hs_formats_pkg::x_t frame_width_i,
  input  hs_formats_pkg::y_t frame_height_i,

  input  hs_formats_pkg::x_t x_i,  // in stamps
  input  hs_formats_pkg::y_t y_i,
  output logic [Lanes-1:0]   inside_o
);
  localparam int unsigned XBits = hs_formats_pkg::XBits;
  localparam int unsigned YBits = hs_formats_pkg::YBits;

  hs_formats_pkg::x_t x_last_d, x_last_q, columns;
  hs_formats_pkg::y_t y_last_d, y_last_q, rows;
  logic [Lanes-1:0] column_d, column_q, row_d, row_q;  // lanes inside in the last column, row

  assign x_last_d = (frame_width_i - XBits'(1)) >> $clog2(LanesX);
  assign y_last_d = (frame_height_i - YBits'(1)) >> $clog2(LanesY);
  assign columns = ((frame_width_i - XBits'(1)) & XBits'(LanesX - 1)) + XBits'(1);
  assign rows = ((frame_height_i - YBits'(1)) & YBits'(LanesY - 1)) + YBits'(1);

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_lane
    assign column_d[lane] = 32'(columns) > lane % LanesX;
    assign row_d[lane] = 32'(rows) > lane / LanesX;
    assign inside_o[lane] = (x_i != x_last_q || column_q[lane]) && (y_i != y_last_q || row_q[lane]);
  end

  always_ff @(posedge clk_i) begin
    if (load_i) begin
      x_last_q <= x_last_d;
      y_last_q <= y_last_d;
      column_q <= column_d;
      row_q <= row_d;
    end
  end
endmodule
