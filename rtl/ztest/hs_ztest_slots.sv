// SPDX-License-Identifier: Apache-2.0
// The first stages of hs_ztest_plane, read | data | pick: a stamp waits until no stamp in flight
// has a pixel in common with it, reads its word of the I-buffer, and becomes slots: one for the
// plane of its triangle if it is the first of it, then one for each different triangle that is
// stored in its covered lanes, at least one.
//
// Everything stops while go_i is 0; a slot leaves in each other cycle in which slot_valid_o is 1.
// It stays in flight for SlotStages cycles more, and is written in the one after.
module hs_ztest_slots #(
  parameter int unsigned SlotStages,
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles),
  localparam int unsigned HeadBits = 2 + IndexBits + hs_formats_pkg::XBits + hs_formats_pkg::YBits,
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1
) (
  input  logic                        clk_i,
  input  logic                        rst_ni,
  input  logic                        go_i,

  input  logic                        stamp_valid_i,
  output logic                        stamp_ready_o,
  input  hs_formats_pkg::stamp_head_t stamp_head_i,
  input  logic [Lanes-1:0]            stamp_mask_i,

  // I-buffer
  output logic                        read_en_o,
  output logic                        read_bank_o,
  output logic [AddressBits-1:0]      read_address_o,
  input  logic [Lanes*IndexBits-1:0]  read_index_i,

  // A slot
  output logic                        slot_valid_o,
  output logic                        slot_begins_o,      // a triangle
  output logic                        slot_last_o,        // of its stamp
  output logic                        slot_bank_o,
  output hs_formats_pkg::stamp_head_t slot_head_o,
  output logic [EntryBits-1:0]        slot_entry_o,       // of the triangle stored in these lanes
  output logic [Lanes-1:0]            slot_lanes_o,
  output logic [Lanes-1:0]            slot_background_o,  // covered lanes with nothing stored

  output logic [AddressBits-1:0]      write_address_o
);
  // A stamp until it is slots: {first of its triangle, bank, head}.
  localparam int unsigned WayBits = 2 + HeadBits;

  // --- Stages read and data: the word of the I-buffer ---
  logic [Lanes-1:0] read_mask_q, data_mask_q, pick_mask_q;
  logic [AddressBits-1:0] stamp_address, read_address_q, data_address_q, pick_address_q;
  logic [WayBits-1:0] read_way_q, data_way_q;
  logic read_valid_q, data_valid_q, pick_valid_q, read_moves, data_free, pick_free;
  logic bank_q, begins_q;  // of the stamp that comes
  logic meets, meets_flight, meets_data, meets_pick;
  logic unused_way;

  // y·StampsX + x, by shifts, as StampsX has two to four ones.
  always_comb begin
    stamp_address = AddressBits'(stamp_head_i.x);
    for (int unsigned i = 0; i < $clog2(StampsX + 1); i++) begin
      if (((StampsX >> i) & 1) != 0) begin
        stamp_address = stamp_address + (AddressBits'(stamp_head_i.y) << i);
      end
    end
  end

  // Whatever the bank: a new frame rarely meets the one before.
  assign meets_data =
      data_valid_q && data_address_q == read_address_q && |(data_mask_q & read_mask_q);
  assign meets_pick =
      pick_valid_q && pick_address_q == read_address_q && |(pick_mask_q & read_mask_q);
  assign meets = meets_data || meets_pick || meets_flight;

  assign data_free = !data_valid_q || pick_free;
  assign read_moves = read_valid_q && data_free && !meets;
  assign stamp_ready_o = go_i && (!read_valid_q || read_moves);
  assign read_en_o = go_i && read_moves;
  assign read_bank_o = read_way_q[HeadBits];
  assign read_address_o = read_address_q;
  assign unused_way = read_way_q[WayBits-1];

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      bank_q <= 1'b0;
      begins_q <= 1'b1;
      read_valid_q <= 1'b0;
      data_valid_q <= 1'b0;
      pick_valid_q <= 1'b0;
    end else if (go_i) begin
      if (stamp_valid_i && stamp_ready_o) begin
        begins_q <= stamp_head_i.triangle_last;
        if (stamp_head_i.last) bank_q <= !bank_q;
      end
      if (stamp_ready_o) read_valid_q <= stamp_valid_i;
      if (data_free) data_valid_q <= read_moves;
      if (pick_free) pick_valid_q <= data_valid_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (stamp_valid_i && stamp_ready_o) begin
      read_way_q <= {begins_q, bank_q, stamp_head_i};
      read_address_q <= stamp_address;
      read_mask_q <= stamp_mask_i;
    end
    if (read_en_o) begin
      data_way_q <= read_way_q;
      data_address_q <= read_address_q;
      data_mask_q <= read_mask_q;
    end
  end

  // --- Stage pick: slots ---
  logic pick_begins_q, pick_bank_q, group_last, slot_last;
  hs_formats_pkg::stamp_head_t pick_head_q;
  logic [Lanes*IndexBits-1:0] pick_index_q;
  logic [Lanes-1:0] stored, waits_q, background_q, group_lanes;

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_stored
    assign stored[lane] = read_index_i[lane*IndexBits +: IndexBits] != '0;
  end

  hs_lane_group #(
    .Lanes(Lanes)
  ) u_group (
    .waits_i(waits_q),
    .index_i(pick_index_q),
    .entry_o(slot_entry_o),
    .lanes_o(group_lanes),
    .last_o (group_last)
  );

  assign slot_last = !pick_begins_q && group_last;
  assign pick_free = !pick_valid_q || slot_last;

  always_ff @(posedge clk_i) begin
    if (go_i && pick_free) begin
      {pick_begins_q, pick_bank_q, pick_head_q} <= data_way_q;
      pick_address_q <= data_address_q;
      pick_mask_q <= data_mask_q;
      pick_index_q <= read_index_i;
      waits_q <= data_mask_q & stored;
      background_q <= data_mask_q & ~stored;
    end else if (go_i) begin
      pick_begins_q <= 1'b0;
      if (!pick_begins_q) waits_q <= waits_q & ~group_lanes;
    end
  end

  assign slot_valid_o = pick_valid_q;
  assign slot_begins_o = pick_begins_q;
  assign slot_last_o = slot_last;
  assign slot_bank_o = pick_bank_q;
  assign slot_head_o = pick_head_q;
  assign slot_lanes_o = pick_begins_q ? '0 : group_lanes;
  assign slot_background_o = pick_begins_q ? '0 : background_q;

  hs_ztest_flight #(
    .Places     (SlotStages + 1),
    .AddressBits(AddressBits),
    .Lanes      (Lanes)
  ) u_flight (
    .clk_i         (clk_i),
    .rst_ni        (rst_ni),
    .go_i          (go_i),
    .valid_i       (pick_valid_q),
    .address_i     (pick_address_q),
    .mask_i        (pick_mask_q),
    .next_address_i(read_address_q),
    .next_mask_i   (read_mask_q),
    .meets_o       (meets_flight),
    .last_address_o(write_address_o)
  );
endmodule
