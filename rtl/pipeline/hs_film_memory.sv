// SPDX-License-Identifier: Apache-2.0
// What a film keeps from pass to pass: two key frames, the motion of a frame in between, its pixels
// in the film buffer, and the marks of its holes.
//
// Pixels come from pixel_store: those of a key frame go to the memory of its slot, those that fill
// holes to the film buffer; and from hole_find: pixels in between to the film buffer, holes to the
// marks. The first key frame of a film leaves the film buffer empty.
// Tiles of key 0 and key 1 are read from slot_i and the other slot. film_scan reads while no tile
// is asked for and the film buffer is not written.
module hs_film_memory #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned TileXBits,
  parameter int unsigned TileYBits,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned FaceBits = hs_formats_pkg::FaceBits,
  localparam int unsigned ColourBits = hs_formats_pkg::ColourBits,
  localparam int unsigned KeySide = hs_formats_pkg::KeySide,
  localparam int unsigned MaxWidth = hs_formats_pkg::MaxWidth,
  localparam int unsigned MaxHeight = hs_formats_pkg::MaxHeight,
  localparam int unsigned StampsX = (MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned MarkBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1,
  localparam int unsigned TilesX = (MaxWidth + 7) / 8,
  localparam int unsigned TilesY = (MaxHeight + 7) / 8,
  localparam int unsigned MotionAddressBits = (TilesX * TilesY > 1 ? $clog2(TilesX * TilesY) : 1)
                                              + 6,
  localparam int unsigned EntryBits = hs_formats_pkg::MotionWordBits - 1 - XBits - YBits,
  localparam int unsigned PixelBits = 3 * ColourBits + FaceBits,
  localparam int unsigned BlockBits = KeySide * KeySide * PixelBits,
  localparam int unsigned KeyAddressBits = $clog2(TilesX * TilesY * (8 / KeySide)
                                                  * (8 / KeySide)),
  localparam int unsigned FilmAddressBits =
      MaxWidth * MaxHeight > 1 ? $clog2(MaxWidth * MaxHeight) : 1,
  localparam int unsigned RequestBits = TileXBits + TileYBits,
  localparam int unsigned ShownBits = hs_formats_pkg::ShownPixelWordBits,
  localparam int unsigned BetweenBits = 3 + hs_formats_pkg::XBits + hs_formats_pkg::YBits
                                        + 3 * ColourBits
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  // Frame registers
  input  hs_formats_pkg::x_t           frame_width_i,
  input  hs_formats_pkg::y_t           frame_height_i,

  // The pass
  input  logic                         begins_i,
  input  logic                         fill_i,
  input  logic                         slot_i,

  // From pixel_store, from hole_find
  input  logic                         shown_valid_i,
  input  logic [ShownBits-1:0]         shown_i,
  input  logic                         between_valid_i,
  input  logic [BetweenBits-1:0]       between_i,

  // Motion buffer
  input  logic                         motion_write_en_i,
  input  logic [MotionAddressBits-1:0] motion_write_address_i,
  input  logic [EntryBits-1:0]         motion_write_i,
  input  logic                         motion_read_en_i,
  input  logic [MotionAddressBits-1:0] motion_read_address_i,
  output logic [EntryBits-1:0]         motion_read_o,

  // Marks of holes
  input  logic                         marks_read_en_i,
  input  logic                         marks_write_en_i,
  input  logic [MarkBits-1:0]          marks_address_i,
  output logic [Lanes-1:0]             marks_o,

  // The caches of key 0 and key 1
  input  logic [1:0]                   request_valid_i,
  output logic [1:0]                   request_ready_o,
  input  logic [2*RequestBits-1:0]     request_i,
  output logic [1:0]                   block_valid_o,
  input  logic [1:0]                   block_ready_i,
  output logic [2*BlockBits-1:0]       block_o,

  // film_scan
  input  logic                         key_read_en_i,
  input  logic                         key_read_bank_i,
  input  logic [KeyAddressBits-1:0]    key_read_address_i,
  output logic [BlockBits-1:0]         key_read_o,
  input  logic                         film_read_en_i,
  input  logic                         film_write_en_i,
  input  logic [FilmAddressBits-1:0]   film_address_i,
  output logic [3*ColourBits:0]        film_read_o
);
  localparam int unsigned LaneBits = Lanes > 1 ? $clog2(Lanes) : 1;

  hs_ram_1r1w #(
    .Width(EntryBits),
    .Depth(TilesX * TilesY * 64)
  ) u_motion_buffer (
    .clk_i          (clk_i),
    .read_en_i      (motion_read_en_i),
    .read_address_i (motion_read_address_i),
    .read_data_o    (motion_read_o),
    .write_en_i     (motion_write_en_i),
    .write_address_i(motion_write_address_i),
    .write_data_i   (motion_write_i)
  );

  // --- A pixel: of a pass, or in between ---
  logic shown, between_shown, hole, unused_last;
  logic [XBits-1:0] shown_x, between_x;
  logic [YBits-1:0] shown_y, between_y;
  logic [FaceBits-1:0] face;
  logic [3*ColourBits-1:0] shown_colour, between_colour;

  assign {shown_x, shown_y, shown, face, shown_colour} = shown_i[ShownBits-2:0];
  assign {between_x, between_y, between_shown, hole, between_colour} = between_i[BetweenBits-2:0];
  assign unused_last = shown_i[ShownBits-1] ^ between_i[BetweenBits-1];

  // --- Key frames ---
  logic [1:0] own_request_ready, own_block_valid;
  logic [2*BlockBits-1:0] own_block, own_read;
  logic read_bank_q;

  // What is of key k is at slot k where slot_i is 0, and at the other one where it is 1.
  assign request_ready_o = slot_i ? {own_request_ready[0], own_request_ready[1]}
                           : own_request_ready;
  assign block_valid_o = slot_i ? {own_block_valid[0], own_block_valid[1]} : own_block_valid;
  assign block_o = slot_i ? {own_block[0 +: BlockBits], own_block[BlockBits +: BlockBits]}
                   : own_block;
  assign key_read_o = own_read[(read_bank_q ? BlockBits : 0) +: BlockBits];

  always_ff @(posedge clk_i) begin
    if (key_read_en_i) read_bank_q <= key_read_bank_i;
  end

  for (genvar slot = 0; slot < 2; slot++) begin : gen_slot
    logic key;  // of this slot
    assign key = slot_i ^ 1'(slot);

    hs_key_memory #(
      .TileXBits(TileXBits),
      .TileYBits(TileYBits)
    ) u_key_memory (
      .clk_i          (clk_i),
      .rst_ni         (rst_ni),
      .frame_width_i  (frame_width_i),
      .frame_height_i (frame_height_i),
      .write_en_i     (shown_valid_i && !fill_i && slot_i == 1'(slot)),
      .write_x_i      (shown_x),
      .write_y_i      (shown_y),
      .write_pixel_i  ({shown_colour, face}),
      .read_en_i      (key_read_en_i && key_read_bank_i == 1'(slot)),
      .read_address_i (key_read_address_i),
      .read_block_o   (own_read[slot*BlockBits +: BlockBits]),
      .request_valid_i(request_valid_i[key]),
      .request_ready_o(own_request_ready[slot]),
      .request_i      (request_i[(key ? RequestBits : 0) +: RequestBits]),
      .block_valid_o  (own_block_valid[slot]),
      .block_ready_i  (block_ready_i[key]),
      .block_o        (own_block[slot*BlockBits +: BlockBits])
    );
  end

  // --- Film buffer: {shown, r, g, b} ---
  logic film_shows, film_write;
  logic [XBits-1:0] film_x;
  logic [YBits-1:0] film_y;
  logic [FilmAddressBits-1:0] film_address;

  assign film_shows = between_valid_i ? between_shown : shown;
  assign film_write = film_write_en_i || (between_valid_i && between_shown)
                      || (shown_valid_i && (begins_i || (fill_i && shown)));
  assign film_x = between_valid_i ? between_x : shown_x;
  assign film_y = between_valid_i ? between_y : shown_y;
  assign film_address = FilmAddressBits'(film_y) * FilmAddressBits'(MaxWidth)
                        + FilmAddressBits'(film_x);

  hs_ram_1r1w #(
    .Width(3 * ColourBits + 1),
    .Depth(MaxWidth * MaxHeight)
  ) u_film_buffer (
    .clk_i          (clk_i),
    .read_en_i      (film_read_en_i),
    .read_address_i (film_address_i),
    .read_data_o    (film_read_o),
    .write_en_i     (film_write),
    .write_address_i(film_write_en_i ? film_address_i : film_address),
    .write_data_i   (film_write_en_i || begins_i ? '0
                     : {film_shows, between_valid_i ? between_colour : shown_colour})
  );

  // --- Marks of holes: a bit a lane, a word a stamp ---
  logic [LaneBits-1:0] lane;
  logic [MarkBits-1:0] mark_address;

  assign lane = LaneBits'((32'(between_y) % LanesY) * LanesX + 32'(between_x) % LanesX);
  assign mark_address = (MarkBits'(between_y) >> $clog2(LanesY)) * MarkBits'(StampsX)
                        + (MarkBits'(between_x) >> $clog2(LanesX));

  hs_ram_1r1w #(
    .Width(Lanes),
    .Depth(StampsX * StampsY),
    .Lanes(Lanes)
  ) u_marks (
    .clk_i          (clk_i),
    .read_en_i      (marks_read_en_i),
    .read_address_i (marks_address_i),
    .read_data_o    (marks_o),
    .write_en_i     (marks_write_en_i ? '1 : Lanes'(between_valid_i && hole) << lane),
    .write_address_i(marks_write_en_i ? marks_address_i : mark_address),
    .write_data_i   (marks_write_en_i ? '0 : '1)
  );

  always_ff @(posedge clk_i) begin
    if (rst_ni) begin
      assert (!(between_valid_i && (shown_valid_i || film_write_en_i || marks_write_en_i)));
      assert (!(film_write_en_i && shown_valid_i && (begins_i || fill_i)));
    end
  end
endmodule
