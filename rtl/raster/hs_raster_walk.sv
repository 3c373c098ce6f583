// SPDX-License-Identifier: Apache-2.0
// A linear function at the stamp where the walk of hs_raster_pineda stands: an edge function, the
// depth plane, or the column itself.
//
// Offers its value there and at the stamps right, left and below, and moves on `move_i` (one-hot,
// or 0 to stay), in one cycle. Back and Resume go to the neighbours that were kept before. All
// values are modulo 2^Width.
module hs_raster_walk #(
  parameter int unsigned Width = 32
) (
  input  logic             clk_i,

  input  logic [Width-1:0] start_i,   // where Load goes
  input  logic [Width-1:0] step_x_i,  // to the stamp right; constant during a walk
  input  logic [Width-1:0] step_y_i,  // to the stamp below; the same

  // From hs_raster_pineda: {Resume, Down, Back, Left, Right, Load}
  input  logic [5:0]       move_i,
  input  logic             keep_left_i,   // for Back
  input  logic             keep_below_i,  // for Resume

  output logic [Width-1:0] at_o,
  output logic [Width-1:0] right_o,
  output logic [Width-1:0] left_o,
  output logic [Width-1:0] below_o
);
  logic [Width-1:0] at_d, at_q, left_q, below_q;

  assign at_o = at_q;
  assign right_o = at_q + step_x_i;
  assign left_o = at_q - step_x_i;
  assign below_o = at_q + step_y_i;

  assign at_d = ({Width{move_i[0]}} & start_i) | ({Width{move_i[1]}} & right_o) |
                ({Width{move_i[2]}} & left_o)  | ({Width{move_i[3]}} & left_q) |
                ({Width{move_i[4]}} & below_o) | ({Width{move_i[5]}} & below_q);

  always_ff @(posedge clk_i) begin
    if (|move_i) at_q <= at_d;
    if (keep_left_i) left_q <= left_o;
    if (keep_below_i) below_q <= below_o;
  end
endmodule
