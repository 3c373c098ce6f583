// SPDX-License-Identifier: Apache-2.0
// What one key frame makes of a pixel in between (kernel: key_colour in
// hls/motion/motion_compensate.hpp).
//
// Latency: a word taken in a cycle of step_i is checked two such cycles later. In the cycle of
// read_en_i, which comes with the last of them, it goes on; shown_o is 3, and its sums are
// 3 + SumStages cycles of go_i behind that.
module hs_key_view #(
  parameter int unsigned TileXBits,
  parameter int unsigned TileYBits,
  parameter int unsigned SumBits,
  parameter int unsigned TapWeightBits,
  parameter int unsigned FractionBits,
  parameter int unsigned DifferenceBits,
  parameter int unsigned SumStages,
  localparam int unsigned KeySide = hs_formats_pkg::KeySide,
  localparam int unsigned Taps = hs_formats_pkg::KeyTaps,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned VectorBits = hs_formats_pkg::VectorBits,
  localparam int unsigned RequestBits = TileXBits + TileYBits,
  localparam int unsigned BlockBits = KeySide * KeySide * (3 * ColourBits + FaceBits)
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  hs_formats_pkg::x_t          frame_width_i,
  input  hs_formats_pkg::y_t          frame_height_i,

  input  logic                        step_i,
  input  logic [XBits-1:0]            x_i,
  input  logic [YBits-1:0]            y_i,
  input  logic [FaceBits-1:0]         face_i,
  input  logic                        there_i,
  input  logic [VectorBits-1:0]       vector_x_i,
  input  logic [VectorBits-1:0]       vector_y_i,
  input  logic [3*DifferenceBits-1:0] difference_i,  // {r, g, b}

  input  logic                        check_valid_i,
  output logic                        hit_o,
  input  logic                        read_en_i,
  input  logic                        clear_i,

  input  logic                        go_i,
  output logic                        shown_o,
  output logic [3*SumBits-1:0]        sums_o,  // {r, g, b}
  output logic [3*DifferenceBits-1:0] differences_o,  // with the sums

  output logic                        request_valid_o,
  input  logic                        request_ready_i,
  output logic [RequestBits-1:0]      request_o,
  input  logic                        block_valid_i,
  output logic                        block_ready_o,
  input  logic [BlockBits-1:0]        block_i
);
  localparam int unsigned SideBits = $clog2(KeySide);
  localparam int unsigned PixelBits = 3 * ColourBits + FaceBits;
  localparam int unsigned Differences = 3 * DifferenceBits;
  localparam int unsigned DifferenceStages = 3 + SumStages;

  // --- Place, two stages ---
  logic [3:0] column, row;
  logic [Taps-1:0] inside_x, inside_y;
  logic [TileXBits-1:0] x_first, x_last;
  logic [TileYBits-1:0] y_first, y_last;
  logic [FractionBits-1:0] x_fraction, y_fraction;
  logic [1:0] active_q;
  logic [2*FaceBits-1:0] faces_q;
  logic [2*Differences-1:0] placed_q;

  hs_key_place #(
    .SideBits(XBits),
    .TileBits(TileXBits)
  ) u_x (
    .clk_i       (clk_i),
    .en_i        (step_i),
    .size_i      (frame_width_i),
    .pixel_i     (x_i),
    .vector_i    (vector_x_i),
    .first_o     (column),
    .inside_o    (inside_x),
    .tile_first_o(x_first),
    .tile_last_o (x_last),
    .fraction_o  (x_fraction)
  );
  hs_key_place #(
    .SideBits(YBits),
    .TileBits(TileYBits)
  ) u_y (
    .clk_i       (clk_i),
    .en_i        (step_i),
    .size_i      (frame_height_i),
    .pixel_i     (y_i),
    .vector_i    (vector_y_i),
    .first_o     (row),
    .inside_o    (inside_y),
    .tile_first_o(y_first),
    .tile_last_o (y_last),
    .fraction_o  (y_fraction)
  );

  always_ff @(posedge clk_i) begin
    if (step_i) begin
      active_q <= {active_q[0], there_i && face_i != '0};
      faces_q <= {faces_q[FaceBits-1:0], face_i};
      placed_q <= {placed_q[Differences-1:0], difference_i};
    end
  end

  // --- Check and read ---
  logic [KeySide*KeySide*PixelBits-1:0] pixels;

  hs_key_cache #(
    .Side     (KeySide),
    .TileXBits(TileXBits),
    .TileYBits(TileYBits)
  ) u_cache (
    .clk_i          (clk_i),
    .rst_ni         (rst_ni),
    .area_valid_i   (check_valid_i && active_q[1] && inside_x != '0 && inside_y != '0),
    .x_first_i      (x_first),
    .x_last_i       (x_last),
    .y_first_i      (y_first),
    .y_last_i       (y_last),
    .column_i       (column),
    .row_i          (row),
    .hit_o          (hit_o),
    .read_en_i      (read_en_i),
    .clear_i        (clear_i),
    .pixels_o       (pixels),
    .request_valid_o(request_valid_o),
    .request_ready_i(request_ready_i),
    .request_o      (request_o),
    .block_valid_i  (block_valid_i),
    .block_ready_o  (block_ready_o),
    .block_i        (block_i)
  );

  logic active_read_q;
  logic [FaceBits-1:0] face_read_q;
  logic [SideBits-1:0] column_read_q, row_read_q;
  logic [Taps-1:0] inside_x_read_q, inside_y_read_q;
  logic [2*FractionBits-1:0] x_fractions_q, y_fractions_q;
  logic [DifferenceStages*Differences-1:0] differences_q;

  always_ff @(posedge clk_i) begin
    if (go_i) begin
      active_read_q <= active_q[1];
      face_read_q <= faces_q[FaceBits +: FaceBits];
      column_read_q <= column[SideBits-1:0];
      row_read_q <= row[SideBits-1:0];
      inside_x_read_q <= inside_x;
      inside_y_read_q <= inside_y;
      x_fractions_q <= {x_fractions_q[FractionBits-1:0], x_fraction};
      y_fractions_q <= {y_fractions_q[FractionBits-1:0], y_fraction};
      differences_q <= {differences_q[(DifferenceStages-1)*Differences-1:0],
                        placed_q[Differences +: Differences]};
    end
  end
  assign differences_o = differences_q[(DifferenceStages-1)*Differences +: Differences];

  // --- Taps, two stages ---
  logic all;
  logic [3*Taps*Taps*ColourBits-1:0] colours;

  hs_key_taps #(
    .Side(KeySide)
  ) u_taps (
    .clk_i       (clk_i),
    .en_i        (go_i),
    .active_i    (active_read_q),
    .face_i      (face_read_q),
    .pixels_i    (pixels),
    .column_i    (column_read_q),
    .row_i       (row_read_q),
    .inside_x_i  (inside_x_read_q),
    .inside_y_i  (inside_y_read_q),
    .x_fraction_i(x_fractions_q[FractionBits-1:0]),
    .y_fraction_i(y_fractions_q[FractionBits-1:0]),
    .shown_o     (shown_o),
    .all_o       (all),
    .colours_o   (colours)
  );

  // --- Sums ---
  if (Taps == 1) begin : gen_nearest
    logic unused_all;
    assign unused_all = ^{all, x_fractions_q[FractionBits +: FractionBits],
                          y_fractions_q[FractionBits +: FractionBits]};
    for (genvar c = 0; c < 3; c++) begin : gen_channel
      assign sums_o[c*SumBits +: SumBits] =
          SumBits'(colours[c*ColourBits +: ColourBits]) << (2 * (TapWeightBits - 2));
    end
  end else begin : gen_weighted
    logic [(Taps-1)*TapWeightBits-1:0] columns, rows;

    hs_key_weights #(
      .TapWeightBits(TapWeightBits)
    ) u_columns (
      .clk_i     (clk_i),
      .en_i      (go_i),
      .fraction_i(x_fractions_q[FractionBits +: FractionBits]),
      .all_i     (all),
      .weights_o (columns)
    );
    hs_key_weights #(
      .TapWeightBits(TapWeightBits)
    ) u_rows (
      .clk_i     (clk_i),
      .en_i      (go_i),
      .fraction_i(y_fractions_q[FractionBits +: FractionBits]),
      .all_i     (all),
      .weights_o (rows)
    );

    for (genvar c = 0; c < 3; c++) begin : gen_channel
      logic [Taps*Taps*ColourBits-1:0] channel;
      for (genvar i = 0; i < Taps * Taps; i++) begin : gen_tap
        assign channel[i*ColourBits +: ColourBits] = colours[(3*i+c)*ColourBits +: ColourBits];
      end
      hs_key_filter #(
        .TapWeightBits(TapWeightBits)
      ) u_filter (
        .clk_i    (clk_i),
        .en_i     (go_i),
        .colours_i(channel),
        .columns_i(columns),
        .rows_i   (rows),
        .sum_o    (sums_o[c*SumBits +: SumBits])
      );
    end
  end
endmodule
