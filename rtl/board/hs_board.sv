// SPDX-License-Identifier: Apache-2.0
// A picture from triangles to video on a small FPGA: lists in memory, the pipeline, a display. A
// board gives it its clocks, a button and pins (`rtl/board/parts/`).
//
// fast_i: the pixel clock; clk_i: half of it, with common edges. locked_i: both are there. The
// button is 1 when pressed; it is looked at once in a frame of video, which takes its bounces away.
// Each frame of video is drawn anew: 210,000 cycles of clk_i to clear, draw and scan it.
module hs_board #(
  parameter int unsigned WordEntries = 1,  // of the I-buffer, in a word of its memory
  parameter int unsigned Entries = 256,    // of the lists
  parameter int unsigned Repeats = 2,
  parameter int unsigned Background = 0,   // {r, g, b}
  parameter File = "lists.hex"
) (
  input  logic       clk_i,
  input  logic       fast_i,
  input  logic       locked_i,
  input  logic       button_i,

  output logic       hsync_o,
  output logic       vsync_o,
  output logic       enable_o,
  output logic [3:0] red_o,
  output logic [3:0] green_o,
  output logic [3:0] blue_o
);
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits;
  localparam int unsigned PixelBits =
      1 + hs_formats_pkg::XBits + hs_formats_pkg::YBits + 3 * ColourBits;

  // --- Reset: 15 cycles from the lock of the clocks on ---
  logic [3:0] reset_count_q = 4'd0;
  logic rst_n_q = 1'b0;

  always_ff @(posedge clk_i or negedge locked_i) begin
    if (!locked_i) begin
      reset_count_q <= 4'd0;
      rst_n_q <= 1'b0;
    end else begin
      if (reset_count_q != 4'd15) reset_count_q <= reset_count_q + 4'd1;
      rst_n_q <= reset_count_q == 4'd15;
    end
  end

  // --- Which half of a cycle of clk_i it is ---
  logic toggle_q, seen_q, second_q;

  always_ff @(posedge clk_i or negedge rst_n_q) begin
    if (!rst_n_q) toggle_q <= 1'b0;
    else toggle_q <= !toggle_q;
  end

  always_ff @(posedge fast_i or negedge rst_n_q) begin
    if (!rst_n_q) begin
      seen_q <= 1'b0;
      second_q <= 1'b0;
    end else begin
      seen_q <= toggle_q;
      second_q <= toggle_q != seen_q;
    end
  end

  // --- The button ---
  logic button_q, button_q2, vsync_q, pressed_q, look, next;

  assign look = vsync_q && !vsync_o;
  assign next = look && button_q2 && !pressed_q;

  always_ff @(posedge clk_i or negedge rst_n_q) begin
    if (!rst_n_q) begin
      button_q <= 1'b0;
      button_q2 <= 1'b0;
      vsync_q <= 1'b0;
      pressed_q <= 1'b0;
    end else begin
      button_q <= button_i;
      button_q2 <= button_q;
      vsync_q <= vsync_o;
      if (look) pressed_q <= button_q2;
    end
  end

  // --- Lists ─► pipeline ─► video ---
  logic triangle_valid, triangle_ready, pixel_valid, pixel_ready;
  hs_formats_pkg::triangle_t triangle;
  logic [PixelBits-1:0] pixel;

  hs_board_lists #(
    .Entries(Entries),
    .Repeats(Repeats),
    .File   (File)
  ) u_lists (
    .clk_i           (clk_i),
    .rst_ni          (rst_n_q),
    .next_i          (next),
    .triangle_valid_o(triangle_valid),
    .triangle_ready_i(triangle_ready),
    .triangle_o      (triangle)
  );

  hs_board_draw #(
    .WordEntries(WordEntries)
  ) u_draw (
    .clk_i           (clk_i),
    .rst_ni          (rst_n_q),
    .fast_i          (fast_i),
    .second_i        (second_q),
    .background_i    ((3*ColourBits)'(Background)),
    .triangle_valid_i(triangle_valid),
    .triangle_ready_o(triangle_ready),
    .triangle_i      (triangle),
    .pixel_valid_o   (pixel_valid),
    .pixel_ready_i   (pixel_ready),
    .pixel_o         (pixel)
  );

  hs_board_video #(
    .Width (hs_formats_pkg::MaxWidth),
    .Height(hs_formats_pkg::MaxHeight)
  ) u_video (
    .clk_i        (clk_i),
    .rst_ni       (rst_n_q),
    .fast_i       (fast_i),
    .pixel_valid_i(pixel_valid),
    .pixel_ready_o(pixel_ready),
    .pixel_i      (pixel),
    .hsync_o      (hsync_o),
    .vsync_o      (vsync_o),
    .enable_o     (enable_o),
    .red_o        (red_o),
    .green_o      (green_o),
    .blue_o       (blue_o)
  );
endmodule
