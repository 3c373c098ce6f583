// SPDX-License-Identifier: Apache-2.0
// Values of the vertices of a triangle, as given, in the order of its attributes (kernel:
// vertex_order in hls/setup/plane.hpp). Vertex 0 is in the most significant place.
module hs_attribute_order #(
  parameter int unsigned Bits  // of a vertex
) (
  input  logic [1:0]        first_i,
  input  logic              turned_i,
  input  logic [3*Bits-1:0] given_i,
  output logic [3*Bits-1:0] values_o
);
  logic [Bits-1:0] v0, v1, v2;

  assign {v0, v1, v2} = given_i;
  always_comb begin
    unique case ({turned_i, first_i})
      3'b001:  values_o = {v1, v2, v0};
      3'b010:  values_o = {v2, v0, v1};
      3'b100:  values_o = {v0, v2, v1};
      3'b101:  values_o = {v1, v0, v2};
      3'b110:  values_o = {v2, v1, v0};
      default: values_o = given_i;
    endcase
  end
endmodule
