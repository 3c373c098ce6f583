// SPDX-License-Identifier: Apache-2.0
// The colours of the pixels of a frame in between, from two key frames (kernel:
// hls/motion/motion_compensate.hpp). A word is a pixel; words may come in any order.
//
// Interval 1, while the caches of both keys hold the pixels that a word takes. Where one lacks a
// tile, words wait for it, 1 + (8 / KeySide)² cycles; the two keys fetch at the same time.
// Latency from a word of motion to its pixel: 9 cycles, 15 with weights.
// Stages: place, two | check | read | taps, two | weighted sums, six | blend, four, the last one
// the word that is sent.
// Stall: while a pixel is not taken everything but a fetch stops.
// key_weight_i and the size of the frame change only while no word is in flight; a word with last
// empties the caches behind itself.
module hs_motion_compensate #(
  parameter int unsigned TileXBits,
  parameter int unsigned TileYBits,
  localparam int unsigned KeySide = hs_formats_pkg::KeySide,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned KeyWeightBits = hs_formats_pkg::KeyWeightBits,
  localparam int unsigned MotionBits = hs_formats_pkg::MotionWordBits,
  localparam int unsigned RequestBits = TileXBits + TileYBits,
  localparam int unsigned BlockBits = KeySide * KeySide * (3 * ColourBits + FaceBits),
  localparam int unsigned CompensatedBits = hs_formats_pkg::CompensatedWordBits
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  // Registers of the frame
  input  hs_formats_pkg::x_t           frame_width_i,  // in pixels in between
  input  hs_formats_pkg::y_t           frame_height_i,
  input  logic [KeyWeightBits-1:0]     key_weight_i,  // of key 0

  // From the motion buffer
  input  logic                         motion_valid_i,
  output logic                         motion_ready_o,
  input  logic [MotionBits-1:0]        motion_i,

  // The memories of the key frames
  output logic                         key_request_0_valid_o,
  input  logic                         key_request_0_ready_i,
  output logic [RequestBits-1:0]       key_request_0_o,
  input  logic                         key_block_0_valid_i,
  output logic                         key_block_0_ready_o,
  input  logic [BlockBits-1:0]         key_block_0_i,
  output logic                         key_request_1_valid_o,
  input  logic                         key_request_1_ready_i,
  output logic [RequestBits-1:0]       key_request_1_o,
  input  logic                         key_block_1_valid_i,
  output logic                         key_block_1_ready_o,
  input  logic [BlockBits-1:0]         key_block_1_i,

  // To the frame
  output logic                         compensated_valid_o,
  input  logic                         compensated_ready_i,
  output logic [CompensatedBits-1:0]   compensated_o
);
  localparam int unsigned XBits = hs_formats_pkg::XBits;
  localparam int unsigned YBits = hs_formats_pkg::YBits;
  localparam int unsigned VectorBits = hs_formats_pkg::VectorBits;
  localparam int unsigned SumBits = hs_formats_pkg::KeySumBits;
  localparam int unsigned TapWeightBits = hs_formats_pkg::TapWeightBits;
  localparam int unsigned Taps = hs_formats_pkg::KeyTaps;
  localparam int unsigned FractionBits = hs_formats_pkg::KeyFractionBits;
  localparam int unsigned WeightBits = KeyWeightBits - 1;
  localparam bit Relight = hs_formats_pkg::Relight != 0;
  localparam int unsigned DifferenceBits = Relight ? hs_formats_pkg::DifferenceBits : 1;
  // A key's part of a word: there, the vector, and the differences.
  localparam int unsigned VectorWordBits = 1 + 2 * VectorBits
                                           + (Relight ? 3 * DifferenceBits : 0);
  localparam int unsigned HeadBits = 1 + XBits + YBits;
  localparam int unsigned PlaceStages = 2;
  localparam int unsigned TapStages = 3;  // from the check on: read, and two of the taps
  localparam int unsigned SumStages = Taps == 1 ? 0 : 6;
  localparam int unsigned BlendStages = 4;
  localparam int unsigned Stages = TapStages + SumStages + BlendStages;
  localparam int unsigned Differences = 3 * DifferenceBits;

  logic go;    // the stages behind the check move
  logic step;  // those before it
  logic pass;  // the word in it goes on
  logic [1:0] hit, shown;
  logic [2*3*SumBits-1:0] sums;

  // --- Up to the check ---
  logic [PlaceStages-1:0] valid_q;
  logic [PlaceStages*HeadBits-1:0] heads_q;
  logic [HeadBits-1:0] head, check_head;
  logic [FaceBits-1:0] face;
  logic check_last;

  assign {head, face} = motion_i[MotionBits-1 -: HeadBits+FaceBits];
  assign check_head = heads_q[HeadBits +: HeadBits];
  assign check_last = check_head[HeadBits-1];
  assign pass = go && valid_q[1] && hit == 2'b11;
  assign step = pass || !valid_q[1];
  assign motion_ready_o = step;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (step) valid_q <= {valid_q[0], motion_valid_i};
  end

  always_ff @(posedge clk_i) begin
    if (step) heads_q <= {heads_q[HeadBits-1:0], head};
  end

  // --- Behind it ---
  logic [Stages-1:0] stage_valid_q;
  logic [Stages*HeadBits-1:0] stage_heads_q;
  // From the sums on, what is shown.
  logic [BlendStages*2-1:0] shown_q;
  logic [1:0] shown_sum;
  logic [KeyWeightBits-1:0] weight;

  assign go = !stage_valid_q[Stages-1] || compensated_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) stage_valid_q <= '0;
    else if (go) stage_valid_q <= {stage_valid_q[Stages-2:0], pass};
  end

  always_ff @(posedge clk_i) begin
    if (go) begin
      stage_heads_q <= {stage_heads_q[(Stages-1)*HeadBits-1:0], check_head};
      shown_q <= {shown_q[(BlendStages-1)*2-1:0], shown_sum};
    end
  end

  if (SumStages == 0) begin : gen_at_once
    assign shown_sum = shown;
  end else begin : gen_along
    logic [SumStages*2-1:0] sum_shown_q;
    always_ff @(posedge clk_i) begin
      if (go) sum_shown_q <= {sum_shown_q[(SumStages-1)*2-1:0], shown};
    end
    assign shown_sum = sum_shown_q[(SumStages-1)*2 +: 2];
  end

  // --- The two keys ---
  logic [1:0] request_valid, request_ready, block_valid, block_ready;
  logic [2*RequestBits-1:0] request;
  logic [2*BlockBits-1:0] block;
  logic [2*Differences-1:0] differences;

  assign {key_request_1_valid_o, key_request_0_valid_o} = request_valid;
  assign request_ready = {key_request_1_ready_i, key_request_0_ready_i};
  assign {key_request_1_o, key_request_0_o} = request;
  assign block_valid = {key_block_1_valid_i, key_block_0_valid_i};
  assign {key_block_1_ready_o, key_block_0_ready_o} = block_ready;
  assign block = {key_block_1_i, key_block_0_i};

  for (genvar k = 0; k < 2; k++) begin : gen_key
    logic [VectorWordBits-1:0] vector;
    logic [Differences-1:0] difference;

    assign vector = motion_i[(1-k)*VectorWordBits +: VectorWordBits];
    if (Relight) begin : gen_relight
      assign difference = vector[Differences-1:0];
    end else begin : gen_as_lit
      assign difference = '0;
    end

    hs_key_view #(
      .TileXBits     (TileXBits),
      .TileYBits     (TileYBits),
      .SumBits       (SumBits),
      .TapWeightBits (TapWeightBits),
      .FractionBits  (FractionBits),
      .DifferenceBits(DifferenceBits),
      .SumStages     (SumStages)
    ) u_view (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .frame_width_i  (frame_width_i),
      .frame_height_i (frame_height_i),
      .step_i         (step),
      .x_i            (head[YBits +: XBits]),
      .y_i            (head[YBits-1:0]),
      .face_i         (face),
      .there_i        (vector[VectorWordBits-1]),
      .vector_x_i     (vector[VectorWordBits-2 -: VectorBits]),
      .vector_y_i     (vector[VectorWordBits-2-VectorBits -: VectorBits]),
      .difference_i   (difference),
      .check_valid_i  (valid_q[1]),
      .hit_o          (hit[k]),
      .read_en_i      (pass),
      .clear_i        (pass && check_last),
      .go_i           (go),
      .shown_o        (shown[k]),
      .sums_o         (sums[k*3*SumBits +: 3*SumBits]),
      .differences_o  (differences[k*Differences +: Differences]),
      .request_valid_o(request_valid[k]),
      .request_ready_i(request_ready[k]),
      .request_o      (request[k*RequestBits +: RequestBits]),
      .block_valid_i  (block_valid[k]),
      .block_ready_o  (block_ready[k]),
      .block_i        (block[k*BlockBits +: BlockBits])
    );
  end

  // --- Their blend ---
  logic [3*ColourBits-1:0] colour;

  always_comb begin
    weight = key_weight_i;
    if (!shown_sum[0]) weight = '0;
    if (!shown_sum[1]) weight = KeyWeightBits'(1) << WeightBits;
  end

  for (genvar c = 0; c < 3; c++) begin : gen_channel
    hs_key_blend #(
      .SumBits(SumBits)
    ) u_blend (
      .clk_i         (clk_i),
      .en_i          (go),
      .key_0_i       (sums[c*SumBits +: SumBits]),
      .key_1_i       (sums[(3+c)*SumBits +: SumBits]),
      .difference_0_i(differences[c*DifferenceBits +: DifferenceBits]),
      .difference_1_i(differences[Differences+c*DifferenceBits +: DifferenceBits]),
      .weight_i      (weight),
      .shown_i       (shown_sum != '0),
      .colour_o      (colour[c*ColourBits +: ColourBits])
    );
  end

  assign compensated_valid_o = stage_valid_q[Stages-1];
  assign compensated_o = {stage_heads_q[(Stages-1)*HeadBits +: HeadBits], colour,
                          shown_q[(BlendStages-1)*2 +: 2]};
endmodule
