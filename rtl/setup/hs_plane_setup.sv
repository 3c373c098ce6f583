// SPDX-License-Identifier: Apache-2.0
// The plane of an attribute over a triangle, after hls/setup/plane.hpp:
//
//   N_A = (v1 − v0)·dy2 − (v2 − v0)·dy1,  N_B = (v2 − v0)·dx1 − (v1 − v0)·dx2
//   A = floor(N_A·R / 2^n + 1/2),  B = floor(N_B·R / 2^n + 1/2),  n = s + r − f − Fraction
//   start = v0 + 1/2 − A·x − B·y,  (x, y) from the start of the plane to vertex 0
//
// A and B wrap: to ValueBits + f + Fraction bits for the start, as (x, y) have f fraction bits, and
// to ValueBits + Fraction bits as steps of whole pixels. The start loses its low f fraction bits.
// An empty job gives zeros.
//
// One multiplier, of a wide factor by Chunk + 1 bits, makes the eight products: each by a distance
// takes DeltaPasses cycles, each by R ReciprocalPasses. Order: N_A, N_B, start of the job before,
// A, B; so jobs overlap. Interval: 6·DeltaPasses + 2·ReciprocalPasses cycles; 1 for an empty job.
// Latency of a job alone: at most 22. Stall: all waits while a plane offered is not taken.
// Inputs are not copied: a job's stay until ready_o takes it, with its last product by R.
module hs_plane_setup #(
  parameter int unsigned ValueBits,
  parameter int unsigned Fraction,
  parameter int unsigned Chunk = 17,
  localparam int unsigned PlaneBits = ValueBits + Fraction,
  localparam int unsigned ShiftBits = hs_formats_pkg::ShiftBits,
  localparam int unsigned ReciprocalBits = hs_formats_pkg::ReciprocalBits
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,

  input  logic                        valid_i,
  output logic                        ready_o,
  input  logic                        empty_i,
  input  logic [ValueBits-1:0]        v0_i,
  input  logic [ValueBits-1:0]        v1_i,
  input  logic [ValueBits-1:0]        v2_i,
  input  hs_formats_pkg::delta_t      dx1_i,
  input  hs_formats_pkg::delta_t      dy1_i,
  input  hs_formats_pkg::delta_t      dx2_i,
  input  hs_formats_pkg::delta_t      dy2_i,
  input  logic [ShiftBits-1:0]        shift_i,
  input  logic [ReciprocalBits-1:0]   reciprocal_i,
  input  hs_formats_pkg::delta_t      x_i,
  input  hs_formats_pkg::delta_t      y_i,

  output logic                        valid_o,
  input  logic                        ready_i,
  output logic [PlaneBits-1:0]        start_o,
  output logic signed [PlaneBits-1:0] dx_o,
  output logic signed [PlaneBits-1:0] dy_o
);
  localparam int unsigned DeltaBits = hs_formats_pkg::DeltaBits;
  localparam int unsigned SubpixelBits = hs_formats_pkg::SubpixelBits;
  // |N| < 2^(b+c): depth_numerator and colour_numerator of hls/formats/formats.hpp.
  localparam int unsigned NumeratorBits = ValueBits + hs_formats_pkg::CoordBits + 1;
  localparam int unsigned StartBits = PlaneBits + SubpixelBits;
  localparam int unsigned WideBits = NumeratorBits > StartBits ? NumeratorBits : StartBits;
  localparam int unsigned NarrowBits = Chunk + 1;
  localparam int unsigned SumBits = WideBits + NarrowBits;
  // The last chunk is signed, so a factor of w bits and a sign fills ceil(w / Chunk) of them.
  localparam int unsigned DeltaPasses = (DeltaBits - 1 + Chunk - 1) / Chunk;
  localparam int unsigned ReciprocalPasses = (ReciprocalBits + Chunk - 1) / Chunk;
  localparam int unsigned FactorBits = 2 * Chunk + 1;
  // n − s; s < AreaBits.
  localparam int unsigned Offset = hs_formats_pkg::ReciprocalFraction - SubpixelBits - Fraction;
  localparam int unsigned RoundBits = $clog2(hs_formats_pkg::AreaBits + Offset);

  if (DeltaPasses > 2 || ReciprocalPasses > 2) begin : gen_chunk_too_small
    $fatal(1, "hs_plane_setup: a factor has at most two chunks: raise Chunk");
  end

  typedef enum logic [2:0] {NumeratorX, NumeratorY, Start, GradientX, GradientY} step_e;

  // --- Control: which product is next ---
  step_e step_q;
  logic [1:0] pass_q;  // {chunk, second product of the sum}
  logic valid_q, enable, job, clear, wait_for, issue, last_pass, gradient_step;
  logic job_q;    // A job has issued its first product and not its last
  logic start_q;  // A start is to be issued
  // One bit a step: the last product of that step is offered, in the product register, in the sum
  logic [4:0] ends, ends_q, ends_q2, ends_q3, pending;

  assign enable = !valid_q || ready_i;
  assign job = valid_i && !empty_i;
  assign pending = ends_q | ends_q2 | ends_q3;
  assign gradient_step = step_q == GradientX || step_q == GradientY;
  assign clear = enable && step_q == NumeratorX && pass_q == 2'd0 && valid_i && empty_i
                 && !start_q && pending == '0;

  always_comb begin
    wait_for = 1'b0;
    unique case (step_q)
      NumeratorX: wait_for = !job;
      Start:      wait_for = pending[GradientX] || pending[GradientY];
      GradientX:  wait_for = pending[NumeratorX];
      GradientY:  wait_for = pending[NumeratorY];
      default:    wait_for = 1'b0;
    endcase
  end

  assign issue = enable && !wait_for;
  assign last_pass = gradient_step ? pass_q == 2'(2 * (ReciprocalPasses - 1))
                                   : pass_q == 2'(2 * DeltaPasses - 1);
  always_comb begin
    ends = '0;
    if (issue && last_pass) ends[step_q] = 1'b1;
  end
  assign ready_o = ends[GradientY] || clear;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      step_q <= NumeratorX;
      pass_q <= 2'd0;
      job_q <= 1'b0;
      start_q <= 1'b0;
      ends_q <= '0;
      ends_q2 <= '0;
      ends_q3 <= '0;
    end else if (enable) begin
      ends_q <= ends;
      ends_q2 <= ends_q;
      ends_q3 <= ends_q2;
      if (issue) pass_q <= last_pass ? 2'd0 : pass_q + (gradient_step ? 2'd2 : 2'd1);
      if (ends[NumeratorX]) step_q <= NumeratorY;
      if (ends[NumeratorY]) step_q <= start_q ? Start : GradientX;
      if (ends[Start]) step_q <= job_q ? GradientX : NumeratorX;
      if (ends[GradientX]) step_q <= GradientY;
      if (ends[GradientY]) step_q <= NumeratorX;
      if (step_q == NumeratorX && wait_for && start_q) step_q <= Start;
      if (ends[NumeratorX]) job_q <= 1'b1;
      else if (ends[GradientY]) job_q <= 1'b0;
      if (ends[GradientY]) start_q <= 1'b1;
      else if (ends[Start]) start_q <= 1'b0;
    end
  end

  // --- Factors ---
  logic second, chunk;
  logic signed [ValueBits:0] difference;
  logic signed [WideBits-1:0] wide;
  logic signed [DeltaBits-1:0] delta;
  logic signed [FactorBits-1:0] factor;
  logic signed [NarrowBits-1:0] narrow;
  logic signed [NumeratorBits-1:0] numerator_x_q, numerator_y_q;
  logic signed [StartBits-1:0] dx_q, dy_q;
  logic signed [DeltaBits-1:0] x_q, y_q;

  assign {chunk, second} = pass_q;
  assign difference = $signed({1'b0, (step_q == NumeratorX) == second ? v2_i : v1_i})
                      - $signed({1'b0, v0_i});

  always_comb begin
    unique case (step_q)
      NumeratorX: delta = second ? dy1_i : dy2_i;
      NumeratorY: delta = second ? dx2_i : dx1_i;
      default:    delta = second ? y_q : x_q;
    endcase
    unique case (step_q)
      Start:     wide = second ? WideBits'(dy_q) : WideBits'(dx_q);
      GradientX: wide = WideBits'(numerator_x_q);
      GradientY: wide = WideBits'(numerator_y_q);
      default:   wide = WideBits'(difference);
    endcase
  end

  assign factor = gradient_step ? FactorBits'({1'b0, reciprocal_i}) : FactorBits'(delta);

  always_comb begin
    narrow = factor[Chunk:0];
    if (chunk) narrow = factor[FactorBits-1:Chunk];
    else if ((gradient_step ? ReciprocalPasses : DeltaPasses) == 2) narrow[Chunk] = 1'b0;
  end

  // --- Sum and results ---
  logic signed [SumBits-1:0] sum;
  logic [Chunk-1:0] low;
  logic [WideBits-1:0] by_delta;  // A sum of products by distances: N_A, N_B or a start
  logic signed [SumBits+Chunk-1:0] by_reciprocal;
  logic [StartBits:0] scaled;  // And the bit below, that rounds
  logic [StartBits-1:0] gradient;
  logic [PlaneBits-1:0] plane_start_q;
  logic [ValueBits-1:0] v0_q, v0_q2;
  logic [RoundBits-1:0] round_q;

  hs_multiply_add #(
    .WideBits  (WideBits),
    .NarrowBits(NarrowBits),
    .SumBits   (SumBits)
  ) u_multiply_add (
    .clk_i     (clk_i),
    .rst_ni    (rst_ni),
    .enable_i  (enable),
    .flush_i   (1'b0),
    .valid_i   (issue),
    .keep_i    (pass_q != 2'd0),
    .shift_i   (pass_q == 2'd2),
    .subtract_i(step_q == Start || (second && !gradient_step)),
    .borrow_i  (1'b0),
    .wide_i    (wide),
    .narrow_i  (narrow),
    .sum_o     (sum),
    .low_o     (low)
  );

  assign by_delta = DeltaPasses == 2 ? WideBits'({sum, low}) : WideBits'(sum);
  assign by_reciprocal = ReciprocalPasses == 2 ? {sum, low} : (SumBits + Chunk)'(sum);
  // floor(x / 2^n + 1/2) is floor(x / 2^n) and bit n − 1 of x; there is none for n = 0.
  assign scaled = (StartBits + 1)'($signed({by_reciprocal, 1'b0}) >>> round_q);
  assign gradient = scaled[StartBits:1] + StartBits'(scaled[0]);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= 1'b0;
    else if (enable) valid_q <= ends_q3[Start] || clear;
  end

  always_ff @(posedge clk_i) begin
    if (ends[GradientX]) round_q <= RoundBits'(shift_i) + RoundBits'(Offset);
    if (ends[GradientY]) begin
      x_q <= x_i;
      y_q <= y_i;
      v0_q <= v0_i;
    end
    if (ends[Start]) v0_q2 <= v0_q;
    if (enable && ends_q3[NumeratorX]) numerator_x_q <= by_delta[NumeratorBits-1:0];
    if (enable && ends_q3[NumeratorY]) numerator_y_q <= by_delta[NumeratorBits-1:0];
    if (clear) begin
      dx_q <= '0;
      dy_q <= '0;
      plane_start_q <= '0;
    end else if (enable) begin
      if (ends_q3[GradientX]) dx_q <= gradient;
      if (ends_q3[GradientY]) dy_q <= gradient;
      if (ends_q3[Start]) begin
        plane_start_q <= by_delta[SubpixelBits+:PlaneBits] + {v0_q2, 1'b1, {(Fraction - 1) {1'b0}}};
      end
    end
  end

  assign valid_o = valid_q;
  assign start_o = plane_start_q;
  assign dx_o = dx_q[PlaneBits-1:0];
  assign dy_o = dy_q[PlaneBits-1:0];
endmodule
