// SPDX-License-Identifier: Apache-2.0
// A triangle with its vertices in order, after order_vertices() of hls/setup/triangle_setup.hpp:
// vertex 0 is the topmost, of these the leftmost; 1 and 2 follow as they came, or, with swap_i, the
// other way around. Depths and colours of vertices go with them; `last`, `index`, an object, a
// face and a flat colour go through.
//
// look_i finds vertex 0 of the triangle of that cycle; ordered_o is right from the next one on, as
// long as the triangle stands. No stall.
module hs_vertex_order (
  input  logic                      clk_i,
  input  logic                      look_i,
  input  logic                      swap_i,
  input  hs_formats_pkg::numbered_t triangle_i,
  output hs_formats_pkg::numbered_t ordered_o,
  output logic [2:0]                order_o  // {first: which vertex came to be vertex 0, swap_i}
);
  localparam int unsigned CoordBits = hs_formats_pkg::CoordBits;
  localparam int unsigned KeyBits = 2 * CoordBits;
  // A vertex: position, depth, colours, where it has any.
  localparam int unsigned DepthBits = hs_formats_pkg::DepthBits;
  localparam int unsigned Colours = hs_formats_pkg::TriangleColourBits != 0 ? 1 : 0;
  localparam int unsigned ColoursBits =
      Colours * hs_formats_pkg::Gouraud * 3 * hs_formats_pkg::ColourBits;
  localparam int unsigned ValuesBits = DepthBits + ColoursBits;
  localparam int unsigned VertexBits = KeyBits + ValuesBits;

  logic [VertexBits-1:0] in0, in1, in2, out0, out1, out2;
  logic [KeyBits-1:0] sign, key0, key1, key2;
  logic [1:0] first_q;

  assign in0[ValuesBits+:KeyBits] = {triangle_i.y0, triangle_i.x0};
  assign in1[ValuesBits+:KeyBits] = {triangle_i.y1, triangle_i.x1};
  assign in2[ValuesBits+:KeyBits] = {triangle_i.y2, triangle_i.x2};

  // y before x, as one number: with the sign turned around, positions count from 0.
  assign sign = {2{1'b1, {(CoordBits - 1) {1'b0}}}};
  assign key0 = in0[ValuesBits+:KeyBits] ^ sign;
  assign key1 = in1[ValuesBits+:KeyBits] ^ sign;
  assign key2 = in2[ValuesBits+:KeyBits] ^ sign;

  always_ff @(posedge clk_i) begin
    if (look_i) begin
      if (key2 < key0 && key2 < key1) first_q <= 2'd2;
      else if (key1 < key0) first_q <= 2'd1;
      else first_q <= 2'd0;
    end
  end

  always_comb begin
    unique case ({swap_i, first_q})
      3'b001:  {out0, out1, out2} = {in1, in2, in0};
      3'b010:  {out0, out1, out2} = {in2, in0, in1};
      3'b100:  {out0, out1, out2} = {in0, in2, in1};
      3'b101:  {out0, out1, out2} = {in1, in0, in2};
      3'b110:  {out0, out1, out2} = {in2, in1, in0};
      default: {out0, out1, out2} = {in0, in1, in2};
    endcase
  end

  assign order_o = {first_q, swap_i};
  assign ordered_o.last = triangle_i.last;
  assign ordered_o.index = triangle_i.index;
  assign {ordered_o.y0, ordered_o.x0} = out0[ValuesBits+:KeyBits];
  assign {ordered_o.y1, ordered_o.x1} = out1[ValuesBits+:KeyBits];
  assign {ordered_o.y2, ordered_o.x2} = out2[ValuesBits+:KeyBits];

  if (hs_formats_pkg::HasDepth != 0) begin : gen_depth
    assign in0[ColoursBits+:DepthBits] = triangle_i.depth0;
    assign in1[ColoursBits+:DepthBits] = triangle_i.depth1;
    assign in2[ColoursBits+:DepthBits] = triangle_i.depth2;
    assign ordered_o.depth0 = out0[ColoursBits+:DepthBits];
    assign ordered_o.depth1 = out1[ColoursBits+:DepthBits];
    assign ordered_o.depth2 = out2[ColoursBits+:DepthBits];
  end

  if (hs_formats_pkg::HasObjects != 0) begin : gen_object
    assign ordered_o.object = triangle_i.object;
  end

  if (hs_formats_pkg::UpConverts != 0) begin : gen_face
    assign ordered_o.face = triangle_i.face;
  end

  if (ColoursBits != 0) begin : gen_gouraud
    assign in0[0+:ColoursBits] = {triangle_i.r0, triangle_i.g0, triangle_i.b0};
    assign in1[0+:ColoursBits] = {triangle_i.r1, triangle_i.g1, triangle_i.b1};
    assign in2[0+:ColoursBits] = {triangle_i.r2, triangle_i.g2, triangle_i.b2};
    assign {ordered_o.r0, ordered_o.g0, ordered_o.b0} = out0[0+:ColoursBits];
    assign {ordered_o.r1, ordered_o.g1, ordered_o.b1} = out1[0+:ColoursBits];
    assign {ordered_o.r2, ordered_o.g2, ordered_o.b2} = out2[0+:ColoursBits];
  end else if (Colours != 0) begin : gen_flat
    assign ordered_o.r = triangle_i.r;
    assign ordered_o.g = triangle_i.g;
    assign ordered_o.b = triangle_i.b;
  end
endmodule
