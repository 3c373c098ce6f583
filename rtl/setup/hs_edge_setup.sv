// SPDX-License-Identifier: Apache-2.0
// Triangle setup, first part, after edge_start() of hls/setup/triangle_setup.hpp: the order of the
// vertices, D, the bounding box and the three edge functions, each of them measured from vertex 0,
// where (x, y) is the way from the start to vertex 0:
//
//   D = dx1·dy2 − dy1·dx2
//   E_i = (i = 1 ? D : 0) − e_dy_i·y − e_dx_i·x − (inclusive ? 0 : 1)
//
// These are the kernel's numbers: edges 0 and 2 pass through vertex 0, and the three functions sum
// up to D. All products are made on one multiplier.
//
// A triangle is read where it stands and taken when D is known: ready follows valid. It then rests
// in the output while its edges are computed, hs_reciprocal divides, and the next triangle is
// looked at. Interval: 14 cycles, 13 where no plane asks for an area, one more if D < 0; 3 if the
// box is empty, 7 if D = 0. Stall: the area waits for hs_reciprocal, the next triangle for the
// output to be taken. An empty triangle sends no area, and all but last, empty and index is 0 then.
// With CullsBack or CullsFront a triangle of that side is as one with D = 0.
// The depth plane of setup_o is 0.
module hs_edge_setup #(
  parameter int unsigned LanesX = 1,
  parameter int unsigned LanesY = 1,
  localparam int unsigned HasDepth = hs_formats_pkg::HasDepth,
  localparam int unsigned Gouraud = hs_formats_pkg::Gouraud,
  localparam int unsigned DepthsBits = HasDepth != 0 ? 3 * hs_formats_pkg::DepthBits : 1,
  localparam int unsigned SendsShape = hs_formats_pkg::SendsShape,
  localparam int unsigned ColourBits = hs_formats_pkg::TriangleColourBits,
  localparam int unsigned OrderBits = hs_formats_pkg::OrderBits,
  localparam int unsigned ShadeBits = OrderBits + ColourBits != 0 ? OrderBits + ColourBits : 1
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  hs_formats_pkg::x_t          frame_width_i,
  input  hs_formats_pkg::y_t          frame_height_i,

  // From geometry
  input  logic                        triangle_valid_i,
  output logic                        triangle_ready_o,
  input  hs_formats_pkg::numbered_t   triangle_i,

  // To hs_reciprocal: D
  output logic                        area_valid_o,
  input  logic                        area_ready_i,
  output hs_formats_pkg::area_t       area_o,

  // To hs_triangle_setup: the record of the edges, and what the planes need: vertex 0, the way to
  // the others, the way from the start to vertex 0, depths, order and colours of the ordered
  // vertices
  output logic                        edge_valid_o,
  input  logic                        edge_ready_i,
  output hs_formats_pkg::setup_t      setup_o,
  output hs_formats_pkg::coord_t      x0_o,
  output hs_formats_pkg::coord_t      y0_o,
  output hs_formats_pkg::delta_t      dx1_o,
  output hs_formats_pkg::delta_t      dy1_o,
  output hs_formats_pkg::delta_t      dx2_o,
  output hs_formats_pkg::delta_t      dy2_o,
  output hs_formats_pkg::delta_t      x_o,
  output hs_formats_pkg::delta_t      y_o,
  output logic [DepthsBits-1:0]       depths_o,  // {0, 1, 2}; without depth a 0
  // {first, turned, colours}, what attributes_t has of them
  output logic [ShadeBits-1:0]        shade_o
);
  localparam int unsigned DeltaBits = hs_formats_pkg::DeltaBits;
  localparam int unsigned EdgeBits = hs_formats_pkg::EdgeBits;
  localparam int unsigned SubpixelBits = hs_formats_pkg::SubpixelBits;
  localparam int unsigned Centre = SubpixelBits - 1;

  // Order: which vertex is first. Cross: the products of D. Send: D to hs_reciprocal, if there is
  // one. Take: the triangle to the output. Edges: the products of the edge functions.
  typedef enum logic [2:0] {Order, Cross, Send, Take, Edges} state_e;
  localparam state_e AfterCross = HasDepth != 0 || SendsShape != 0 ? Send : Take;
  state_e state_q;
  logic [2:0] step_q;
  logic swap_q, dropped_q, outside, negative, dropped, take, take_empty, free;

  // --- Vertices in order ---
  hs_formats_pkg::numbered_t ordered;
  logic [2:0] order;
  hs_formats_pkg::coord_t x0, y0, x1, y1, x2, y2;
  hs_formats_pkg::delta_t dx1, dy1, dx2, dy2;

  hs_vertex_order u_vertex_order (
    .clk_i     (clk_i),
    .look_i    (state_q == Order),
    .swap_i    (swap_q),
    .triangle_i(triangle_i),
    .ordered_o (ordered),
    .order_o   (order)
  );

  if (hs_formats_pkg::HasObjects != 0) begin : gen_object
    logic unused_object;
    assign unused_object = ^ordered.object;
  end

  if (hs_formats_pkg::UpConverts != 0) begin : gen_face
    logic unused_face;
    assign unused_face = ^ordered.face;
  end

  // Variables of their own: Yosys 0.23 forgets the sign of a field of a struct.
  assign x0 = ordered.x0;
  assign y0 = ordered.y0;
  assign x1 = ordered.x1;
  assign y1 = ordered.y1;
  assign x2 = ordered.x2;
  assign y2 = ordered.y2;
  assign dx1 = DeltaBits'(x1) - DeltaBits'(x0);
  assign dy1 = DeltaBits'(y1) - DeltaBits'(y0);
  assign dx2 = DeltaBits'(x2) - DeltaBits'(x0);
  assign dy2 = DeltaBits'(y2) - DeltaBits'(y0);

  hs_formats_pkg::x_t x_first, x_last, x_start, x_first_q, x_last_q, x_start_q;
  hs_formats_pkg::y_t y_first, y_last, y_first_q, y_last_q;

  hs_box_setup u_box_setup (
    .clk_i         (clk_i),
    .frame_width_i (frame_width_i),
    .frame_height_i(frame_height_i),
    .x0_i          (x0),
    .y0_i          (y0),
    .x1_i          (x1),
    .y1_i          (y1),
    .x2_i          (x2),
    .y2_i          (y2),
    .before_10_i   (dx1[DeltaBits-1]),
    .before_20_i   (dx2[DeltaBits-1]),
    .outside_o     (outside),
    .x_first_o     (x_first),
    .x_last_o      (x_last),
    .x_start_o     (x_start),
    .y_first_o     (y_first),
    .y_last_o      (y_last)
  );

  // --- Control ---
  logic valid_q, done_q;

  assign free = !valid_q || (edge_valid_o && edge_ready_i);
  assign take_empty = state_q == Cross || dropped_q;
  assign take = free && (state_q == Take || (state_q == Cross && step_q == 3'd1 && outside));

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      state_q <= Order;
      step_q <= 3'd0;
      swap_q <= 1'b0;
      dropped_q <= 1'b0;
    end else begin
      step_q <= step_q + 3'd1;
      unique case (state_q)
        Order: begin
          if (triangle_valid_i) state_q <= Cross;
          step_q <= 3'd0;
          swap_q <= 1'b0;
          dropped_q <= 1'b0;
        end
        Cross: begin
          // The products of −D follow those of D at once, and are dropped if they are not needed.
          if (step_q == 3'd1 && outside) begin
            step_q <= step_q;
            if (take) state_q <= Order;
          end
          if (step_q == 3'd4) begin
            swap_q <= negative;
            dropped_q <= dropped;
            if (dropped) state_q <= Take;
            else if (!negative) state_q <= AfterCross;
          end
          if (step_q == 3'd5) state_q <= AfterCross;
        end
        Send: if (area_ready_i) state_q <= Take;
        Take: begin
          step_q <= 3'd0;
          if (take) state_q <= dropped_q ? Order : Edges;
        end
        default: if (step_q == 3'd5) state_q <= Order;
      endcase
    end
  end

  assign triangle_ready_o = take;
  assign area_valid_o = state_q == Send;

  // --- Products ---
  logic edges, second, inclusive;
  hs_formats_pkg::delta_t dx1_q, dy1_q, dx2_q, dy2_q, dx21, dy12, e_dx, e_dy, wide, narrow;
  logic signed [EdgeBits-1:0] sum;
  logic [DeltaBits-2:0] unused_low;

  assign edges = state_q == Edges;
  assign second = step_q[0];
  assign dx21 = dx2_q - dx1_q;
  assign dy12 = dy1_q - dy2_q;

  always_comb begin
    // Edge 1 first: its sum starts with D, which the multiplier still holds.
    unique case (step_q[2:1])
      2'd0: begin
        e_dx = dy12;
        e_dy = dx21;
      end
      2'd1: begin
        e_dx = -dy1_q;
        e_dy = dx1_q;
      end
      default: begin
        e_dx = dy2_q;
        e_dy = -dx2_q;
      end
    endcase
    if (edges) begin
      wide = second ? e_dx : e_dy;
      narrow = second ? x_o : y_o;
    end else begin
      wide = step_q[0] == step_q[1] ? dx1 : dy1;
      narrow = step_q[0] == step_q[1] ? dy2 : dx2;
    end
  end

  // The edge vector is (e_dy, −e_dx), and not zero.
  assign inclusive = !e_dx[DeltaBits-1] && (e_dx != '0 || !e_dy[DeltaBits-1]);
  assign negative = sum[EdgeBits-1];
  // The front comes counter-clockwise, which is D < 0 as rows go downward.
  assign dropped = sum == '0 || (negative ? hs_formats_pkg::CullsFront != 0
                                          : hs_formats_pkg::CullsBack != 0);

  hs_multiply_add #(
    .WideBits  (DeltaBits),
    .NarrowBits(DeltaBits),
    .SumBits   (EdgeBits)
  ) u_multiply_add (
    .clk_i     (clk_i),
    .rst_ni    (rst_ni),
    .enable_i  (1'b1),
    .flush_i   (state_q == Cross && step_q == 3'd4 && (!negative || dropped)),
    .valid_i   (edges || (state_q == Cross && !step_q[2])),
    .keep_i    (second || (edges && step_q == 3'd0)),
    .shift_i   (1'b0),
    .subtract_i(second || edges),
    .borrow_i  (second && edges && !inclusive),
    .wide_i    (wide),
    .narrow_i  (narrow),
    .sum_o     (sum),
    .low_o     (unused_low)
  );

  assign area_o = sum[EdgeBits-2:0];

  // --- Output ---
  logic [2:0] ends, ends_q, ends_q2, ends_q3;  // Edge 1, 0, 2: as in hs_plane_setup
  hs_formats_pkg::edge_step_t e0_q, e1_q, e2_q;
  hs_formats_pkg::coord_t x0_q, y0_q;
  logic last_q, empty_q;
  hs_formats_pkg::index_t index_q;
  logic [DepthsBits-1:0] depths, depths_q;
  logic [ShadeBits-1:0] shade, shade_q;

  if (HasDepth != 0) begin : gen_depth
    assign depths = {ordered.depth0, ordered.depth1, ordered.depth2};
  end else begin : gen_no_depth
    assign depths = '0;
  end
  if (ColourBits != 0 && Gouraud != 0) begin : gen_gouraud
    assign shade[0 +: ColourBits] = {ordered.r0, ordered.r1, ordered.r2,
                                     ordered.g0, ordered.g1, ordered.g2,
                                     ordered.b0, ordered.b1, ordered.b2};
  end else if (ColourBits != 0) begin : gen_flat
    assign shade[0 +: ColourBits] = {ordered.r, ordered.g, ordered.b};
  end
  if (OrderBits != 0) begin : gen_order
    assign shade[ColourBits +: OrderBits] = order;
  end else begin : gen_no_order
    logic unused_order;
    assign unused_order = ^order;
    if (ColourBits == 0) begin : gen_nothing
      assign shade = '0;
    end
  end

  always_comb begin
    ends = '0;
    if (edges && second) ends[step_q[2:1]] = 1'b1;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q <= 1'b0;
      done_q <= 1'b0;
      ends_q <= '0;
      ends_q2 <= '0;
      ends_q3 <= '0;
    end else begin
      if (free) valid_q <= take;
      if (take) done_q <= take_empty;
      else if (ends_q3[2]) done_q <= 1'b1;
      ends_q <= ends;
      ends_q2 <= ends_q;
      ends_q3 <= ends_q2;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      last_q <= ordered.last;
      empty_q <= take_empty;
      index_q <= ordered.index;
      depths_q <= depths;
      shade_q <= shade;
      x0_q <= x0;
      y0_q <= y0;
      dx1_q <= dx1;
      dy1_q <= dy1;
      dx2_q <= dx2;
      dy2_q <= dy2;
      x_first_q <= x_first;
      x_last_q <= x_last;
      x_start_q <= x_start;
      y_first_q <= y_first;
      y_last_q <= y_last;
    end
    if (ends_q3[0]) e1_q <= sum[EdgeBits-1:SubpixelBits];
    if (ends_q3[1]) e0_q <= sum[EdgeBits-1:SubpixelBits];
    if (ends_q3[2]) e2_q <= sum[EdgeBits-1:SubpixelBits];
    if (take && take_empty) begin
      shade_q <= '0;
      x0_q <= '0;
      y0_q <= '0;
      dx1_q <= '0;
      dy1_q <= '0;
      dx2_q <= '0;
      dy2_q <= '0;
      x_first_q <= '0;
      x_last_q <= '0;
      x_start_q <= '0;
      y_first_q <= '0;
      y_last_q <= '0;
      e0_q <= '0;
      e1_q <= '0;
      e2_q <= '0;
    end
  end

  // The start is the centre of the first pixel of its stamp.
  assign x_o = DeltaBits'(x0_q)
               - $signed(DeltaBits'({setup_o.x_start << $clog2(LanesX), 1'b1, {Centre{1'b0}}}));
  assign y_o = DeltaBits'(y0_q)
               - $signed(DeltaBits'({setup_o.y_min << $clog2(LanesY), 1'b1, {Centre{1'b0}}}));
  assign edge_valid_o = valid_q && done_q;
  assign x0_o = x0_q;
  assign y0_o = y0_q;
  assign dx1_o = dx1_q;
  assign dy1_o = dy1_q;
  assign dx2_o = dx2_q;
  assign dy2_o = dy2_q;
  assign depths_o = depths_q;
  assign shade_o = shade_q;

  always_comb begin
    setup_o = '0;
    setup_o.last = last_q;
    setup_o.empty = empty_q;
    setup_o.index = index_q;
    setup_o.x_min = x_first_q >> $clog2(LanesX);
    setup_o.x_max = x_last_q >> $clog2(LanesX);
    setup_o.x_start = x_start_q >> $clog2(LanesX);
    setup_o.y_min = y_first_q >> $clog2(LanesY);
    setup_o.y_max = y_last_q >> $clog2(LanesY);
    setup_o.e0 = e0_q;
    setup_o.e1 = e1_q;
    setup_o.e2 = e2_q;
    setup_o.e0_dx = -dy1_q;
    setup_o.e1_dx = dy12;
    setup_o.e2_dx = dy2_q;
    setup_o.e0_dy = dx1_q;
    setup_o.e1_dy = dx21;
    setup_o.e2_dy = -dx2_q;
  end
endmodule
