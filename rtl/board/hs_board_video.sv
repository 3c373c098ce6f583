// SPDX-License-Identifier: Apache-2.0
// Video of 640×480 at 60 frames a second out of pixels in the order of scan, each of them a square
// of Scale×Scale: Width·Scale is 640, Height·Scale 480.
//
// Two rows of the frame lie in a buffer: one that is shown, one that is filled. So no frame is
// stored: pixels are taken when the row after the one that is shown has room, which makes the
// pipeline draw a frame for each one that is shown. A frame whose first row is not there when the
// picture begins is black, and the pipeline has until the next one. Once it is there, a row must
// come in the time of Scale lines: of 800·Scale cycles of fast_i.
//
// Pixels and clk_i: the pipeline's. Video and fast_i: the pixel clock, 25.175 MHz by the standard;
// 25.125 is within what displays take. fast_i is clk_i times two, with common edges.
// Sync is low in its pulse. Colours are brought to 4 bits by repetition of their bits.
module hs_board_video #(
  parameter int unsigned Width = 160,
  parameter int unsigned Height = 120,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned PixelBits = 1 + XBits + YBits + 3 * ColourBits
) (
  input  logic                 clk_i,
  input  logic                 rst_ni,
  input  logic                 fast_i,

  // From shade_gouraud, of one lane
  input  logic                 pixel_valid_i,
  output logic                 pixel_ready_o,
  input  logic [PixelBits-1:0] pixel_i,

  // fast_i
  output logic                 hsync_o,
  output logic                 vsync_o,
  output logic                 enable_o,
  output logic [3:0]           red_o,
  output logic [3:0]           green_o,
  output logic [3:0]           blue_o
);
  localparam int unsigned Columns = 640, Rows = 480;
  localparam int unsigned LineLast = 799, FrameLast = 524;
  localparam int unsigned SyncX = 656, SyncXEnd = 752;  // Columns + 16, and 96 more
  localparam int unsigned SyncY = 490, SyncYEnd = 492;  // Rows + 10, and 2 more
  localparam int unsigned ScaleBits = $clog2(Columns / Width);
  localparam int unsigned ColumnBits = $clog2(Width);

  if (Width << ScaleBits != Columns || Height << ScaleBits != Rows) begin : gen_size_illegal
    $error("hs_board_video: Width and Height times a power of two are 640 and 480");
  end

  logic [3*ColourBits-1:0] rows [2 << ColumnBits];  // {row's lowest bit, column}

  // --- In: rows into the buffer ---
  hs_formats_pkg::pixel_head_t head;
  logic [3*ColourBits-1:0] colour;
  logic [1:0] free_q;  // rows
  logic shown_q, shown_seen_q, take, fills, unused_head;

  assign {head, colour} = pixel_i;
  assign unused_head = ^{head.last, head.x, head.y};
  assign pixel_ready_o = free_q != 2'd0;
  assign take = pixel_valid_i && pixel_ready_o;
  assign fills = take && head.x == XBits'(Width - 1);

  always_ff @(posedge clk_i) begin
    if (take) rows[{head.y[0], head.x[ColumnBits-1:0]}] <= colour;
  end

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      free_q <= 2'd2;
      shown_seen_q <= 1'b0;
    end else begin
      shown_seen_q <= shown_q;
      free_q <= free_q + 2'(shown_q != shown_seen_q) - 2'(fills);
    end
  end

  // --- Out: the place on the screen, a pixel each cycle of fast_i ---
  logic [9:0] x_q, y_q;
  logic line_end, visible, live_q;  // live: of this frame there are pixels

  assign line_end = x_q == 10'(LineLast);
  assign visible = x_q < 10'(Columns) && y_q < 10'(Rows);

  always_ff @(posedge fast_i or negedge rst_ni) begin
    if (!rst_ni) begin
      x_q <= '0;
      y_q <= 10'(Rows);
      live_q <= 1'b0;
      shown_q <= 1'b0;
    end else begin
      x_q <= line_end ? '0 : x_q + 10'd1;
      if (line_end) begin
        y_q <= y_q == 10'(FrameLast) ? '0 : y_q + 10'd1;
        if (y_q == 10'(FrameLast)) live_q <= free_q != 2'd2;
        if (live_q && y_q < 10'(Rows) && &y_q[ScaleBits-1:0]) shown_q <= !shown_q;
      end
    end
  end

  // --- A cycle for the buffer, one for the output ---
  logic visible_q, shows_q, hsync_q, vsync_q;
  logic [3*ColourBits-1:0] read_q;
  logic [11:0] shown_colour;

  for (genvar i = 0; i < 3; i++) begin : gen_channel
    for (genvar bit_number = 0; bit_number < 4; bit_number++) begin : gen_bit
      localparam int unsigned From = ColourBits - 1 - (3 - bit_number) % ColourBits;
      assign shown_colour[4*i + bit_number] = read_q[i*ColourBits + From];
    end
  end

  always_ff @(posedge fast_i) begin
    read_q <= rows[{y_q[ScaleBits], x_q[ScaleBits +: ColumnBits]}];
    visible_q <= visible;
    shows_q <= visible && live_q;
    hsync_q <= !(x_q >= 10'(SyncX) && x_q < 10'(SyncXEnd));
    vsync_q <= !(y_q >= 10'(SyncY) && y_q < 10'(SyncYEnd));

    enable_o <= visible_q;
    hsync_o <= hsync_q;
    vsync_o <= vsync_q;
    {red_o, green_o, blue_o} <= shows_q ? shown_colour : 12'd0;
  end
endmodule
