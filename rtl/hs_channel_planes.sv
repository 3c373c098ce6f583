// SPDX-License-Identifier: Apache-2.0
// The planes of three channels of a triangle, at the centre of pixel (0, 0), one after the other
// through one hs_plane_setup.
//
// Interval: 3·(6·DeltaPasses + 2·ReciprocalPasses) cycles, 3 for an empty job. Latency: 40 at most.
// A job is read where it stands and taken with the last product that needs it: ready follows valid.
// It is taken after the planes of the one before have left. Stall: all waits while planes offered
// are not taken. Those of an empty job are 0.
module hs_channel_planes #(
  parameter int unsigned ValueBits,
  parameter int unsigned Fraction,
  localparam int unsigned PlaneBits = ValueBits + Fraction,
  localparam int unsigned ShiftBits = hs_formats_pkg::ShiftBits,
  localparam int unsigned ReciprocalBits = hs_formats_pkg::ReciprocalBits
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,

  input  logic                      valid_i,
  output logic                      ready_o,
  input  logic                      empty_i,
  input  logic [9*ValueBits-1:0]    values_i,  // three channels, each {v0, v1, v2}
  input  hs_formats_pkg::coord_t    x_i,  // of vertex 0
  input  hs_formats_pkg::coord_t    y_i,
  input  hs_formats_pkg::delta_t    dx1_i,
  input  hs_formats_pkg::delta_t    dy1_i,
  input  hs_formats_pkg::delta_t    dx2_i,
  input  hs_formats_pkg::delta_t    dy2_i,
  input  logic [ShiftBits-1:0]      shift_i,
  input  logic [ReciprocalBits-1:0] reciprocal_i,

  output logic                      valid_o,
  input  logic                      ready_i,
  output logic [9*PlaneBits-1:0]    planes_o  // three channels, each {start, dx, dy}
);
  // A numerator is the wide factor: 24 bits take a distance in one pass, R in one or two.
  localparam int unsigned Chunk = 24;
  localparam int unsigned DeltaBits = hs_formats_pkg::DeltaBits;

  typedef enum logic [1:0] {First, Second, Third} channel_e;

  channel_e in_q, out_q;

  // --- In: a channel after the other ---
  logic job_ready;
  logic [ValueBits-1:0] v0, v1, v2;
  hs_formats_pkg::delta_t centre;

  assign centre = DeltaBits'(1) << (hs_formats_pkg::SubpixelBits - 1);
  assign ready_o = job_ready && in_q == Third;

  always_comb begin
    unique case (in_q)
      First:   {v0, v1, v2} = values_i[6*ValueBits +: 3*ValueBits];
      Second:  {v0, v1, v2} = values_i[3*ValueBits +: 3*ValueBits];
      default: {v0, v1, v2} = values_i[0 +: 3*ValueBits];
    endcase
  end

  // --- Out: two channels are kept, the third completes the planes ---
  logic plane_valid, plane_ready;
  logic [PlaneBits-1:0] start;
  logic signed [PlaneBits-1:0] dx, dy;
  logic [3*PlaneBits-1:0] first_q, second_q;

  assign plane_ready = out_q != Third || ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      in_q <= First;
      out_q <= First;
    end else begin
      if (job_ready) in_q <= in_q == First ? Second : in_q == Second ? Third : First;
      if (plane_valid && plane_ready) begin
        out_q <= out_q == First ? Second : out_q == Second ? Third : First;
      end
    end
  end

  always_ff @(posedge clk_i) begin
    if (plane_valid && out_q == First) first_q <= {start, dx, dy};
    if (plane_valid && out_q == Second) second_q <= {start, dx, dy};
  end

  hs_plane_setup #(
    .ValueBits(ValueBits),
    .Fraction (Fraction),
    .Chunk    (Chunk)
  ) u_plane_setup (
    .clk_i       (clk_i),
    .rst_ni      (rst_ni),
    .valid_i     (valid_i),
    .ready_o     (job_ready),
    .empty_i     (empty_i),
    .v0_i        (v0),
    .v1_i        (v1),
    .v2_i        (v2),
    .dx1_i       (dx1_i),
    .dy1_i       (dy1_i),
    .dx2_i       (dx2_i),
    .dy2_i       (dy2_i),
    .shift_i     (shift_i),
    .reciprocal_i(reciprocal_i),
    .x_i         (DeltaBits'(x_i) - centre),
    .y_i         (DeltaBits'(y_i) - centre),
    .valid_o     (plane_valid),
    .ready_i     (plane_ready),
    .start_o     (start),
    .dx_o        (dx),
    .dy_o        (dy)
  );

  assign valid_o = plane_valid && out_q == Third;
  assign planes_o = {first_q, second_q, start, dx, dy};
endmodule
