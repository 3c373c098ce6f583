// SPDX-License-Identifier: Apache-2.0
// The stamp that hs_raster_pineda found last: held until the next one of the triangle, or its end,
// which makes it `triangle_last`, sends it on. A triangle without a stamp gets one of zeros.
//
// A stamp or an end of a triangle a cycle while ready_o is 1; the output is a register.
// Stall: ready_o falls when a stamp is held and the one before it is not taken.
// Illegal: covered_i or finish_i without ready_o.
module hs_raster_hold #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned LanesBits = Lanes * (1 + hs_formats_pkg::DepthBits),
  localparam int unsigned StampBits = 2 + IndexBits + XBits + YBits + LanesBits
) (
  input  logic                   clk_i,
  input  logic                   rst_ni,

  // From hs_raster_pineda: a stamp, the end of the triangle, or both
  output logic                   ready_o,
  input  logic                   covered_i,
  input  logic                   finish_i,
  input  logic                   last_i,
  input  hs_formats_pkg::index_t index_i,
  input  hs_formats_pkg::x_t     x_i,
  input  hs_formats_pkg::y_t     y_i,
  input  logic [LanesBits-1:0]   lanes_i,  // {mask, depth}, as in the stamp

  // To ztest_index
  output logic                   stamp_valid_o,
  input  logic                   stamp_ready_i,
  output logic [StampBits-1:0]   stamp_o
);
  logic held_q, final_q, stamp_valid_q, stamp_free, send;
  hs_formats_pkg::stamp_head_t head_q;
  logic [LanesBits-1:0] lanes_q;
  logic [StampBits-1:0] stamp_q;

  assign stamp_free = !stamp_valid_q || stamp_ready_i;
  assign ready_o = !held_q || stamp_free;
  assign send = held_q && stamp_free && (final_q || covered_i);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      held_q <= 1'b0;
      final_q <= 1'b0;
      stamp_valid_q <= 1'b0;
    end else begin
      if (covered_i || finish_i) begin
        held_q <= 1'b1;
        final_q <= finish_i;
      end else if (send) begin
        held_q <= 1'b0;
      end
      if (stamp_free) stamp_valid_q <= send;
    end
  end

  always_ff @(posedge clk_i) begin
    if (covered_i || finish_i) begin
      head_q.last <= finish_i && last_i;
      head_q.triangle_last <= finish_i;
      head_q.index <= index_i;
    end
    if (covered_i) begin
      head_q.x <= x_i;
      head_q.y <= y_i;
      lanes_q <= lanes_i;
    end else if (finish_i && (!held_q || final_q)) begin
      head_q.x <= '0;
      head_q.y <= '0;
      lanes_q <= '0;
    end
    if (send) stamp_q <= {head_q, lanes_q};
  end

  assign stamp_valid_o = stamp_valid_q;
  assign stamp_o = stamp_q;
endmodule
