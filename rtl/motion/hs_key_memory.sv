// SPDX-License-Identifier: Apache-2.0
// The memory of a key frame: a word a block of KeySide × KeySide pixels {r, g, b, face}, blocks
// along the rows of the largest frame, whole tiles of 8 × 8 pixels.
//
// It is written a pixel at a time. A tile that a cache asks for comes as (8 / KeySide)² blocks, row
// by row, the first one two cycles behind the request and then one a cycle; pixels beyond the frame
// are 0. film_scan reads a block a cycle, while no tile is asked for. A read takes one cycle, its
// word stays until the next one.
module hs_key_memory #(
  parameter int unsigned TileXBits,
  parameter int unsigned TileYBits,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned KeySide = hs_formats_pkg::KeySide,
  localparam int unsigned PixelBits = 3 * ColourBits + FaceBits,
  localparam int unsigned Banks = KeySide * KeySide,
  localparam int unsigned BlocksX = (hs_formats_pkg::MaxWidth + 7) / 8 * (8 / KeySide),
  localparam int unsigned BlocksY = (hs_formats_pkg::MaxHeight + 7) / 8 * (8 / KeySide),
  localparam int unsigned AddressBits = $clog2(BlocksX * BlocksY)
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t             frame_width_i,
  input  hs_formats_pkg::y_t             frame_height_i,

  // A pixel
  input  logic                           write_en_i,
  input  hs_formats_pkg::x_t             write_x_i,
  input  hs_formats_pkg::y_t             write_y_i,
  input  logic [PixelBits-1:0]           write_pixel_i,

  // Of the frame as it is shown
  input  logic                           read_en_i,
  input  logic [AddressBits-1:0]         read_address_i,
  output logic [Banks*PixelBits-1:0]     read_block_o,

  // The cache of motion_compensate
  input  logic                           request_valid_i,
  output logic                           request_ready_o,
  input  logic [TileXBits+TileYBits-1:0] request_i,  // as key_request
  output logic                           block_valid_o,
  input  logic                           block_ready_i,
  output logic [Banks*PixelBits-1:0]     block_o  // as key_block
);
  localparam int unsigned SideBits = $clog2(KeySide);
  localparam int unsigned LineBits = 3 - SideBits;  // of a block's column or row in its tile

  // --- A tile, block by block ---
  logic active_q, valid_q, step, accept, row_end, tile_end;
  logic [TileXBits-1:0] tile_x;
  logic [TileYBits-1:0] tile_y;
  logic [LineBits-1:0] column_q, row_q;
  logic [AddressBits-1:0] address_q;
  logic [XBits-1:0] x_q;  // of the tile
  logic [YBits-1:0] y_q;
  logic [Banks-1:0] in_frame, inside_q;

  assign {tile_x, tile_y} = request_i;
  assign request_ready_o = !active_q;
  assign accept = request_valid_i && request_ready_o;
  assign step = active_q && (!valid_q || block_ready_i);
  assign row_end = &column_q;
  assign tile_end = row_end && (&row_q);

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      valid_q <= 1'b0;
    end else begin
      if (accept) active_q <= 1'b1;
      else if (step && tile_end) active_q <= 1'b0;
      if (step) valid_q <= 1'b1;
      else if (block_ready_i) valid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (accept) begin
      column_q <= '0;
      row_q <= '0;
      address_q <= AddressBits'(tile_y) * AddressBits'(BlocksX * (8 / KeySide))
                   + AddressBits'(tile_x) * AddressBits'(8 / KeySide);
      x_q <= XBits'(tile_x) << 3;
      y_q <= YBits'(tile_y) << 3;
    end else if (step) begin
      column_q <= column_q + LineBits'(1);
      address_q <= address_q + AddressBits'(1);
      if (row_end) begin
        row_q <= row_q + LineBits'(1);
        address_q <= address_q + AddressBits'(BlocksX - (8 / KeySide) + 1);
      end
    end
    if (step) inside_q <= in_frame;
  end

  // --- The words ---
  logic [AddressBits-1:0] write_address;
  logic [Banks-1:0] write_en;
  logic [Banks*PixelBits-1:0] block;

  assign write_address = (AddressBits'(write_y_i) >> SideBits) * AddressBits'(BlocksX)
                         + (AddressBits'(write_x_i) >> SideBits);

  hs_ram_1r1w #(
    .Width(Banks * PixelBits),
    .Depth(BlocksX * BlocksY),
    .Lanes(Banks)
  ) u_ram (
    .clk_i          (clk_i),
    .read_en_i      (step || read_en_i),
    .read_address_i (step ? address_q : read_address_i),
    .read_data_o    (block),
    .write_en_i     (write_en),
    .write_address_i(write_address),
    .write_data_i   ({Banks{write_pixel_i}})
  );
  assign read_block_o = block;
  assign block_valid_o = valid_q;

  // Signals of their own: Yosys 0.23 does not narrow a cast inside a concatenation.
  logic [SideBits-1:0] write_x_side, write_y_side;
  assign write_x_side = SideBits'(write_x_i);
  assign write_y_side = SideBits'(write_y_i);

  for (genvar bank = 0; bank < Banks; bank++) begin : gen_bank
    logic [PixelBits-1:0] pixel;
    logic [XBits:0] x;  // a tile may begin in the frame and end beyond all x
    logic [YBits:0] y;

    assign write_en[bank] = write_en_i
                            && {write_y_side, write_x_side}
                               == (2 * SideBits)'(bank);
    assign x = (XBits + 1)'(x_q) + (XBits + 1)'({column_q, SideBits'(bank % KeySide)});
    assign y = (YBits + 1)'(y_q) + (YBits + 1)'({row_q, SideBits'(bank / KeySide)});
    assign in_frame[bank] = x < (XBits + 1)'(frame_width_i) && y < (YBits + 1)'(frame_height_i);
    assign pixel = inside_q[bank] ? block[bank*PixelBits +: PixelBits] : '0;
    assign {block_o[Banks*(2*ColourBits+FaceBits)+bank*ColourBits +: ColourBits],
            block_o[Banks*(ColourBits+FaceBits)+bank*ColourBits +: ColourBits],
            block_o[Banks*FaceBits+bank*ColourBits +: ColourBits],
            block_o[bank*FaceBits +: FaceBits]} = pixel;
  end

  always_ff @(posedge clk_i) begin
    if (rst_ni) assert (!(read_en_i && (active_q || valid_q)));
  end
endmodule
