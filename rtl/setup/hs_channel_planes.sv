// SPDX-License-Identifier: Apache-2.0
// The planes of the channels of a triangle, at the centre of pixel (0, 0), one after the other
// through one hs_plane_setup.
//
// Interval: Channels·(6·DeltaPasses + 2·ReciprocalPasses) cycles, Channels for an empty job.
// Latency: 40 at most, of three channels.
// A job is read where it stands and taken with the last product that needs it: ready follows valid.
// It is taken after the planes of the one before have left. Stall: all waits while planes offered
// are not taken. Those of an empty job are 0.
module hs_channel_planes #(
  parameter int unsigned ValueBits,
  parameter int unsigned Fraction,
  parameter int unsigned Channels = 3,  // 2 or 3
  localparam int unsigned PlaneBits = ValueBits + Fraction,
  localparam int unsigned ShiftBits = hs_formats_pkg::ShiftBits,
  localparam int unsigned ReciprocalBits = hs_formats_pkg::ReciprocalBits
) (
  input  logic                            clk_i,
  input  logic                            rst_ni,

  input  logic                            valid_i,
  output logic                            ready_o,
  input  logic                            empty_i,
  input  logic [3*Channels*ValueBits-1:0] values_i,  // of each channel {v0, v1, v2}
  input  hs_formats_pkg::coord_t          x_i,  // of vertex 0
  input  hs_formats_pkg::coord_t          y_i,
  input  hs_formats_pkg::delta_t          dx1_i,
  input  hs_formats_pkg::delta_t          dy1_i,
  input  hs_formats_pkg::delta_t          dx2_i,
  input  hs_formats_pkg::delta_t          dy2_i,
  input  logic [ShiftBits-1:0]            shift_i,
  input  logic [ReciprocalBits-1:0]       reciprocal_i,

  output logic                            valid_o,
  input  logic                            ready_i,
  output logic [3*Channels*PlaneBits-1:0] planes_o  // of each channel {start, dx, dy}
);
  localparam int unsigned DeltaBits = hs_formats_pkg::DeltaBits;
  // A numerator is the wide factor: 24 bits take a distance in one pass, R in one or two. Where
  // both take 15 there are no more: multipliers of 16 bits, of small FPGAs, then take them.
  localparam int unsigned FactorBits =
      ReciprocalBits > DeltaBits - 1 ? ReciprocalBits : DeltaBits - 1;
  localparam int unsigned Chunk = FactorBits < 16 ? FactorBits : 24;

  // Of the channels but the last one.
  localparam int unsigned KeptBits = 3 * (Channels - 1) * PlaneBits;

  // How many channels come after this one.
  logic [1:0] in_q, out_q;

  // --- In: a channel after the other ---
  logic job_ready;
  logic [ValueBits-1:0] v0, v1, v2;
  hs_formats_pkg::delta_t centre;

  assign centre = DeltaBits'(1) << (hs_formats_pkg::SubpixelBits - 1);
  assign ready_o = job_ready && in_q == '0;

  always_comb begin
    {v0, v1, v2} = values_i[0 +: 3*ValueBits];
    for (int unsigned i = 1; i < Channels; i++) begin
      if (in_q == 2'(i)) {v0, v1, v2} = values_i[3*i*ValueBits +: 3*ValueBits];
    end
  end

  // --- Out: the last channel completes the planes, the others are kept ---
  logic plane_valid, plane_ready;
  logic [PlaneBits-1:0] start;
  logic signed [PlaneBits-1:0] dx, dy;
  logic [KeptBits-1:0] kept_q;

  assign plane_ready = out_q != '0 || ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      in_q <= 2'(Channels - 1);
      out_q <= 2'(Channels - 1);
    end else begin
      if (job_ready) in_q <= in_q == '0 ? 2'(Channels - 1) : in_q - 2'd1;
      if (plane_valid && plane_ready) out_q <= out_q == '0 ? 2'(Channels - 1) : out_q - 2'd1;
    end
  end

  always_ff @(posedge clk_i) begin
    if (plane_valid && out_q != '0) kept_q <= KeptBits'({kept_q, start, dx, dy});
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

  assign valid_o = plane_valid && out_q == '0;
  assign planes_o = {kept_q, start, dx, dy};
endmodule
