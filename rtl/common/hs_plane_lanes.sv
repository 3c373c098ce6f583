// SPDX-License-Identifier: Apache-2.0
// A plane at all pixels of a stamp: the upper ValueBits of c + dx·x + dy·y, modulo 2^PlaneBits
// (kernel: plane_lanes in hls/formats/lanes.hpp).
//
// Interval 1, latency 5 cycles, of those in which en_i is 1. Two multipliers.
module hs_plane_lanes #(
  parameter int unsigned PlaneBits,
  parameter int unsigned ValueBits,
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY
) (
  input  logic                        clk_i,
  input  logic                        en_i,

  input  logic [PlaneBits-1:0]        plane_i,  // at the centre of pixel (0, 0)
  input  logic signed [PlaneBits-1:0] plane_dx_i,
  input  logic signed [PlaneBits-1:0] plane_dy_i,
  input  hs_formats_pkg::x_t          x_i,  // in stamps
  input  hs_formats_pkg::y_t          y_i,

  output logic [PlaneBits-1:0]        first_o,  // all bits, at the first pixel
  output logic [Lanes*ValueBits-1:0]  value_o
);
  // A product with the position in stamps, shifted, loses the top bits of the gradient.
  localparam int unsigned DxBits = PlaneBits - $clog2(LanesX);
  localparam int unsigned DyBits = PlaneBits - $clog2(LanesY);

  // Stages: operands | products | first pixel | rows | lanes.
  logic [PlaneBits-1:0] plane_q, plane_q2, first_q;
  logic signed [PlaneBits-1:0] dx_q, dy_q;
  logic [PlaneBits-1:0] dx_q2, dy_q2, dx_q3, dy_q3, dx_q4;
  logic signed [hs_formats_pkg::XBits:0] x_q;
  logic signed [hs_formats_pkg::YBits:0] y_q;
  logic signed [DxBits-1:0] along_x_q;
  logic signed [DyBits-1:0] along_y_q;
  logic [LanesY*PlaneBits-1:0] row_q;

  always_ff @(posedge clk_i) begin
    if (en_i) begin
      plane_q <= plane_i;
      dx_q <= plane_dx_i;
      dy_q <= plane_dy_i;
      x_q <= {1'b0, x_i};
      y_q <= {1'b0, y_i};

      plane_q2 <= plane_q;
      dx_q2 <= dx_q;
      dy_q2 <= dy_q;
      along_x_q <= DxBits'(dx_q) * DxBits'(x_q);
      along_y_q <= DyBits'(dy_q) * DyBits'(y_q);

      first_q <= plane_q2 + {along_x_q, {$clog2(LanesX){1'b0}}} +
                 {along_y_q, {$clog2(LanesY){1'b0}}};
      dx_q3 <= dx_q2;
      dy_q3 <= dy_q2;

      dx_q4 <= dx_q3;
    end
  end

  for (genvar row = 0; row < LanesY; row++) begin : gen_row
    always_ff @(posedge clk_i) begin
      if (en_i) begin
        row_q[row*PlaneBits +: PlaneBits] <=
            first_q + (row % 2 != 0 ? dy_q3 : '0) + (row / 2 != 0 ? dy_q3 << 1 : '0);
      end
    end

    for (genvar column = 0; column < LanesX; column++) begin : gen_column
      localparam int unsigned Lane = row * LanesX + column;
      logic [PlaneBits-1:0] value, value_q;
      logic unused_fraction;

      assign value = row_q[row*PlaneBits +: PlaneBits] + (column % 2 != 0 ? dx_q4 : '0) +
                     (column / 2 != 0 ? dx_q4 << 1 : '0);
      assign unused_fraction = ^value_q[PlaneBits-ValueBits-1:0];
      always_ff @(posedge clk_i) begin
        if (en_i) value_q <= value;
      end
      assign value_o[Lane*ValueBits +: ValueBits] = value_q[PlaneBits-1 -: ValueBits];
      if (Lane == 0) begin : gen_first
        assign first_o = value_q;
      end
    end
  end
endmodule
