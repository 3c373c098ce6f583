// SPDX-License-Identifier: Apache-2.0
// The cache of a key frame (kernel: hls/motion/key_cache.hpp): 2 × 2 tiles of 8 × 8 pixels,
// direct-mapped by the parity of a tile's column and row, in Side × Side banks.
//
// An area of at most two columns and two rows of tiles hits in the cycle in which it is offered, or
// not: then it has to stay until it does. What it lacks is requested tile by tile, in the order of
// the slots; a tile comes as (8 / Side)² blocks of Side × Side pixels, row by row. A miss takes 1 +
// (8 / Side)² cycles, if neither side waits; the hit is in the next one. A read takes one cycle;
// its pixels stay until the next one. clear_i, together with the last area of a frame, empties the
// cache.
module hs_key_cache #(
  parameter int unsigned Side,
  parameter int unsigned TileXBits,
  parameter int unsigned TileYBits,
  localparam int unsigned Banks = Side * Side,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned PixelBits = 3 * ColourBits + FaceBits
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,

  // An area: its tiles, and the last bits of its first column and row, inside the frame or not
  input  logic                           area_valid_i,
  input  logic [TileXBits-1:0]           x_first_i,
  input  logic [TileXBits-1:0]           x_last_i,
  input  logic [TileYBits-1:0]           y_first_i,
  input  logic [TileYBits-1:0]           y_last_i,
  input  logic [3:0]                     column_i,
  input  logic [3:0]                     row_i,
  output logic                           hit_o,  // 1 without an area
  input  logic                           read_en_i,
  input  logic                           clear_i,
  output logic [Banks*PixelBits-1:0]     pixels_o,  // {r, g, b, face} a bank, bank 0 last

  // Key memory
  output logic                           request_valid_o,
  input  logic                           request_ready_i,
  output logic [TileXBits+TileYBits-1:0] request_o,  // as key_request
  input  logic                           block_valid_i,
  output logic                           block_ready_o,
  input  logic [Banks*PixelBits-1:0]     block_i  // {r, g, b, face}, each of all banks
);
  localparam int unsigned SideBits = $clog2(Side);
  localparam int unsigned BlockBits = 3 - SideBits;  // of a block's column or row in its tile
  localparam int unsigned AddressBits = 2 + 2 * BlockBits;
  localparam int unsigned TagBits = TileXBits + TileYBits;

  // --- Tags ---
  logic [3:0] valid_q, miss;
  logic [4*TagBits-1:0] tags_q, tiles;
  logic filling_q;
  logic [1:0] slot, slot_q;
  logic [2*BlockBits-1:0] count_q;
  logic last_block;

  for (genvar s = 0; s < 4; s++) begin : gen_slot
    logic x_first, x_has, y_first, y_has;
    logic [TagBits-1:0] tile;
    assign x_first = x_first_i[0] == 1'(s % 2);
    assign x_has = x_first || x_last_i[0] == 1'(s % 2);
    assign y_first = y_first_i[0] == 1'(s / 2);
    assign y_has = y_first || y_last_i[0] == 1'(s / 2);
    assign tile = {x_first ? x_first_i : x_last_i, y_first ? y_first_i : y_last_i};
    assign tiles[s*TagBits +: TagBits] = tile;
    always_ff @(posedge clk_i) begin
      if (request_valid_o && request_ready_i && slot == 2'(s)) begin
        tags_q[s*TagBits +: TagBits] <= tile;
      end
    end
    assign miss[s] = area_valid_i && x_has && y_has
                     && !(valid_q[s] && tags_q[s*TagBits +: TagBits] == tile);
  end

  always_comb begin
    slot = 2'd3;
    request_o = tiles[3*TagBits +: TagBits];
    for (int unsigned s = 3; s > 0; s--) begin
      if (miss[s-1]) begin
        slot = 2'(s - 1);
        request_o = tiles[(s-1)*TagBits +: TagBits];
      end
    end
  end

  assign hit_o = miss == '0;
  assign request_valid_o = !hit_o && !filling_q;
  assign block_ready_o = filling_q;
  assign last_block = &count_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      valid_q <= '0;
      filling_q <= 1'b0;
      count_q <= '0;
    end else begin
      if (request_valid_o && request_ready_i) begin
        filling_q <= 1'b1;
        valid_q[slot] <= 1'b0;
      end
      if (filling_q && block_valid_i) begin
        count_q <= count_q + (2 * BlockBits)'(1);
        if (last_block) begin
          filling_q <= 1'b0;
          valid_q[slot_q] <= 1'b1;
        end
      end
      if (clear_i) valid_q <= '0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (request_valid_o && request_ready_i) slot_q <= slot;
  end

  // --- Banks ---
  for (genvar bank = 0; bank < Banks; bank++) begin : gen_bank
    // The one of the columns from the first on that is of this bank.
    logic [3:0] column, row;
    logic [SideBits-1:0] to_column, to_row;
    logic unused_place;
    assign to_column = SideBits'(bank % Side) - column_i[SideBits-1:0];
    assign to_row = SideBits'(bank / Side) - row_i[SideBits-1:0];
    assign column = column_i + 4'(to_column);
    assign row = row_i + 4'(to_row);
    assign unused_place = ^{column[SideBits-1:0], row[SideBits-1:0]};

    hs_ram_1r1w #(
      .Width(PixelBits),
      .Depth(4 << (2 * BlockBits)),
      .Lanes(1)
    ) u_pixels (
      .clk_i          (clk_i),
      .read_en_i      (read_en_i),
      .read_address_i (AddressBits'({row[3], column[3], row[2:SideBits], column[2:SideBits]})),
      .read_data_o    (pixels_o[bank*PixelBits +: PixelBits]),
      .write_en_i     (filling_q && block_valid_i),
      .write_address_i({slot_q, count_q}),
      .write_data_i   ({block_i[Banks*(2*ColourBits+FaceBits)+bank*ColourBits +: ColourBits],
                        block_i[Banks*(ColourBits+FaceBits)+bank*ColourBits +: ColourBits],
                        block_i[Banks*FaceBits+bank*ColourBits +: ColourBits],
                        block_i[bank*FaceBits +: FaceBits]})
    );
  end
endmodule
