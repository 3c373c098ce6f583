// SPDX-License-Identifier: Apache-2.0
// Indices of triangles, after hls/ztest/index_pool.hpp: triangle n of a frame takes the index of
// triangle n - W if that turned out invisible, else the next new one, from 1 on in each frame; W is
// IndexWindow.
//
//   triangle ─► index ─► numbered
//                 ▲
//   visible ─► queue
//
// From triangle W on each waits for the result of the one W before it, whatever frame that is of,
// so that W triangles at most are on their way and the queue has room for their results: in a
// pipeline visible_ready_o is never 0.
//
// No index is left while Triangles are in use: the triangle then goes on with index 0 and all its
// vertices in row 0, where its box holds no pixel centre. It is drawn nowhere, and its `visible`
// has that index; none_left_o is 1 from then on, until a reset.
//
// Interval 1, latency 0; 2 cycles from a result to the triangle that waits for it. Stall: a
// triangle is offered once its index is known, and stays until it is taken.
// Illegal: IndexWindow below 1; a `visible` more than triangles went.
module hs_index_pool #(
  parameter int unsigned IndexWindow
) (
  input  logic                       clk_i,
  input  logic                       rst_ni,

  // From geometry
  input  logic                       triangle_valid_i,
  output logic                       triangle_ready_o,
  input  hs_formats_pkg::triangle_t  triangle_i,

  // The word of the Z-test that geometry hears as well
  input  logic                       visible_valid_i,
  output logic                       visible_ready_o,
  input  hs_formats_pkg::visible_t   visible_i,

  // To triangle_setup
  output logic                       numbered_valid_o,
  input  logic                       numbered_ready_i,
  output hs_formats_pkg::numbered_t  numbered_o,

  output logic                       none_left_o
);
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits;
  localparam int unsigned FlightBits = $clog2(IndexWindow + 1);
  localparam int unsigned RestBits = $bits(triangle_i) - 1;  // all but `last`
  localparam logic [IndexBits-1:0] LastIndex = IndexBits'(hs_formats_pkg::Triangles);

  // --- Results, in the order of the triangles ---
  logic result_valid, result_ready, result_visible;
  logic [IndexBits-1:0] result_index;
  logic unused_last;

  assign unused_last = visible_i.last;

  hs_fifo_block #(
    .Width(1 + IndexBits),
    .Depth(IndexWindow < 2 ? 2 : IndexWindow)
  ) u_results (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (visible_valid_i),
    .in_ready_o (visible_ready_o),
    .in_i       ({visible_i.visible, visible_i.index}),
    .out_valid_o(result_valid),
    .out_ready_i(result_ready),
    .out_o      ({result_visible, result_index})
  );

  // --- The index of the triangle that stands at the port ---
  logic [FlightBits-1:0] flight_q, stale_q;  // results not read yet; those of frames before
  logic [FlightBits-1:0] flight;
  logic [IndexBits-1:0] used_q, index;
  logic waits, again, full_q, take;

  assign waits = flight_q == FlightBits'(IndexWindow);
  assign flight = waits ? flight_q : flight_q + FlightBits'(1);
  assign again = waits && stale_q == '0 && !result_visible && result_index != '0;

  always_comb begin
    index = used_q + IndexBits'(1);
    if (again) index = result_index;
    else if (full_q) index = '0;
  end

  assign numbered_valid_o = triangle_valid_i && (!waits || result_valid);
  assign triangle_ready_o = numbered_ready_i && (!waits || result_valid);
  assign take = numbered_valid_o && numbered_ready_i;
  assign result_ready = waits && take;

  always_comb begin
    numbered_o = {triangle_i[RestBits], index, triangle_i[RestBits-1:0]};
    if (full_q && !again) begin
      numbered_o.y0 = '0;
      numbered_o.y1 = '0;
      numbered_o.y2 = '0;
    end
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      flight_q <= '0;
      stale_q <= '0;
      used_q <= '0;
      full_q <= 1'b0;
      none_left_o <= 1'b0;
    end else if (take) begin
      flight_q <= flight;
      if (triangle_i.last) stale_q <= flight;
      else if (waits && stale_q != '0) stale_q <= stale_q - FlightBits'(1);
      if (triangle_i.last) begin
        used_q <= '0;
        full_q <= 1'b0;
      end else if (!again && !full_q) begin
        used_q <= index;
        full_q <= index == LastIndex;
      end
      if (full_q && !again) none_left_o <= 1'b1;
    end
  end
endmodule
