// SPDX-License-Identifier: Apache-2.0
// The one reciprocal of a triangle, after hls/setup/reciprocal.hpp:
//
//   s = floor(log2 D),  R = floor(2^(r+s) / D + 1/2),  D >= 1
//
// A stage normalizes D, by 16, 4 or 1 places a cycle, or all but one of a short D; the next
// divides, a quotient bit a cycle. The division is non-restoring: the signs of its remainders are
// those of the restoring one.
// Interval: Fraction + 3 cycles. Latency: at most 8 more for the normalization, which
// runs during the division before. Stall: a quotient stays until taken, a normalized D behind it.
// Illegal: D = 0.
module hs_reciprocal #(
  parameter int unsigned Fraction,  // r
  localparam int unsigned ReciprocalBits = Fraction + 1,
  localparam int unsigned ShiftBits = hs_formats_pkg::ShiftBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  // From hs_edge_setup: D
  input  logic                        area_valid_i,
  output logic                        area_ready_o,
  input  hs_formats_pkg::area_t       area_i,

  // To hs_triangle_setup: s and R
  output logic                        reciprocal_valid_o,
  input  logic                        reciprocal_ready_i,
  output logic [ShiftBits-1:0]        shift_o,
  output logic [ReciprocalBits-1:0]   reciprocal_o
);
  localparam int unsigned AreaBits = hs_formats_pkg::AreaBits;
  localparam int unsigned QuotientBits = ReciprocalBits + 1;  // one more, for the rounding
  localparam int unsigned Stride = AreaBits > 16 ? 16 : AreaBits - 1;
  localparam int unsigned Step = AreaBits > 4 ? 4 : AreaBits - 1;

  // Normalization
  logic area_valid_q, busy_q, done, load, negative;
  logic [AreaBits-1:0] area_q, shifted;
  logic [ShiftBits-1:0] area_shift_q, places;

  assign load = area_valid_q && area_q[AreaBits-1] && (!busy_q || (done && reciprocal_ready_i));
  assign area_ready_o = !area_valid_q || load;

  always_comb begin
    shifted = area_q << 1;
    places = ShiftBits'(1);
    if (area_q[AreaBits-1-:Stride] == '0) begin
      shifted = area_q << Stride;
      places = ShiftBits'(Stride);
    end else if (area_q[AreaBits-1-:Step] == '0) begin
      shifted = area_q << Step;
      places = ShiftBits'(Step);
    end
  end

  always_ff @(posedge clk_i) begin
    if (area_ready_o) begin
      area_q <= area_i;
      area_shift_q <= ShiftBits'(AreaBits - 1);
    end else if (!area_q[AreaBits-1]) begin
      area_q <= shifted;
      area_shift_q <= area_shift_q - places;
    end
  end

  // Division. The remainder lies in [−divisor, divisor): one bit more than D. A 1 that starts at
  // the bottom of the quotient arrives at the top when all bits are there.
  logic [AreaBits-1:0] divisor_q;
  logic [AreaBits:0] remainder_q, remainder;
  logic [QuotientBits:0] quotient_q;
  logic [ShiftBits-1:0] shift_q;

  assign done = quotient_q[QuotientBits];
  // Plus the divisor after a negative remainder, else minus: as one adder.
  assign negative = remainder_q[AreaBits];
  assign remainder = {remainder_q[AreaBits-1:0], 1'b0} + (AreaBits + 1)'(!negative)
                     + {!negative, negative ? divisor_q : ~divisor_q};

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      area_valid_q <= 1'b0;
      busy_q <= 1'b0;
    end else begin
      if (area_ready_o) area_valid_q <= area_valid_i;
      if (load) busy_q <= 1'b1;
      else if (done && reciprocal_ready_i) busy_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (load) begin
      divisor_q <= area_q;
      shift_q <= area_shift_q;
      // The kernel's first remainder, 2^(AreaBits−1), is here the double of the one loaded.
      remainder_q <= {3'b001, {(AreaBits - 2) {1'b0}}};
      quotient_q <= {{QuotientBits{1'b0}}, 1'b1};
    end else if (!done) begin
      remainder_q <= remainder;
      quotient_q <= {quotient_q[QuotientBits-1:0], !remainder[AreaBits]};
    end
  end

  assign reciprocal_valid_o = busy_q && done;
  assign shift_o = shift_q;
  assign reciprocal_o = quotient_q[QuotientBits-1:1] + ReciprocalBits'(quotient_q[0]);
endmodule
