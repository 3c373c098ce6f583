// SPDX-License-Identifier: Apache-2.0
// The vector of a pixel to one key frame (kernel: key_vector in hls/motion/motion_field.hpp), from
// s, t, q of its point there.
//
// Interval 1, latency 3 cycles, with perspective 8, of those in which en_i is 1. Stages: with
// perspective four of the reciprocal, in the first three of which s and t take its octave, and one
// of the products | three of the way. Multipliers: with perspective 1 and 2.
module hs_motion_vector #(
  parameter int unsigned CoordinateBits,
  localparam int unsigned Perspective = hs_formats_pkg::Perspective,
  localparam int unsigned Channels = Perspective != 0 ? 3 : 2,
  localparam int unsigned OriginBits = hs_formats_pkg::OriginBits,
  localparam int unsigned ExtentBits = hs_formats_pkg::ExtentBits,
  localparam int unsigned VectorBits = hs_formats_pkg::VectorBits,
  localparam int unsigned PlaceBits = 4 * OriginBits + ExtentBits
) (
  input  logic                               clk_i,
  input  logic                               en_i,
  input  logic [Channels*CoordinateBits-1:0] coordinates_i,  // {s, t, q}
  input  logic [PlaceBits-1:0]               place_i,  // {pixel x, y, origin x, y, extent}
  output logic                               fits_o,
  output logic [2*VectorBits-1:0]            vector_o  // {x, y}
);
  localparam int unsigned Lead = Perspective != 0 ? 5 : 0;
  localparam int unsigned InverseBits = Perspective != 0 ? hs_formats_pkg::InverseBits : 0;
  localparam int unsigned FactorBits = CoordinateBits + Perspective;
  localparam int unsigned ScaledBits = FactorBits + InverseBits;
  localparam int unsigned Point = Perspective != 0 ? CoordinateBits - 1 + InverseBits
                                                   : CoordinateBits;

  logic [2*ScaledBits-1:0] scaled;  // of s, t
  logic [PlaceBits-1:0] place;
  logic [1:0] fits;

  if (Perspective != 0) begin : gen_perspective
    localparam int unsigned ShiftBits = hs_formats_pkg::InverseShiftBits;
    logic [ShiftBits-1:0] shift;
    logic [InverseBits-1:0] inverse;
    logic [Lead*PlaceBits-1:0] places_q;

    hs_reciprocal_lookup #(
      .ValueBits(CoordinateBits)
    ) u_reciprocal (
      .clk_i    (clk_i),
      .en_i     (en_i),
      .value_i  (coordinates_i[CoordinateBits-1:0]),
      .shift_o  (shift),
      .inverse_o(inverse)
    );

    // s is q + 1 at most: its product with 2^shift has a bit more than q.
    for (genvar i = 0; i < 2; i++) begin : gen_product
      logic [CoordinateBits-1:0] value_q;
      logic [FactorBits-1:0] factor_q, factor_q2, factor_q3;
      logic [ScaledBits-1:0] scaled_q;

      always_ff @(posedge clk_i) begin
        if (en_i) begin
          value_q <= coordinates_i[(i+1)*CoordinateBits +: CoordinateBits];
          factor_q <= FactorBits'(value_q) << shift;
          factor_q2 <= factor_q;
          factor_q3 <= factor_q2;
          scaled_q <= ScaledBits'(factor_q3) * ScaledBits'(inverse);
        end
      end
      assign scaled[i*ScaledBits +: ScaledBits] = scaled_q;
    end

    always_ff @(posedge clk_i) begin
      if (en_i) places_q <= (Lead * PlaceBits)'({places_q, place_i});
    end
    assign place = places_q[(Lead-1)*PlaceBits +: PlaceBits];
  end else begin : gen_affine
    assign scaled = coordinates_i;
    assign place = place_i;
  end

  // Axis 1 is x, 0 is y.
  for (genvar i = 0; i < 2; i++) begin : gen_axis
    hs_motion_way #(
      .ScaledBits(ScaledBits),
      .Point     (Point)
    ) u_way (
      .clk_i   (clk_i),
      .en_i    (en_i),
      .scaled_i(scaled[i*ScaledBits +: ScaledBits]),
      .extent_i(place[0 +: ExtentBits]),
      .origin_i(place[ExtentBits+i*OriginBits +: OriginBits]),
      .pixel_i (place[ExtentBits+(2+i)*OriginBits +: OriginBits]),
      .fits_o  (fits[i]),
      .vector_o(vector_o[i*VectorBits +: VectorBits])
    );
  end

  assign fits_o = &fits;
endmodule
