// SPDX-License-Identifier: Apache-2.0
// TdbS in memory outside, as a shader reads it: the entries that it will read of a stamp are
// brought before the stamp is let in.
//
//   scan ─► pick ─► look up ─► requests ─► deliver ─► planes in the order of the shader's reads
//             │        └─► memory ───────────┘ └─► cache          │
//             └─► stamps ─► gate ─► shader ◄──────────────────────┘
//
// The order of the reads is that of shade_gouraud: an entry for each different triangle of a stamp,
// or, EachPixel, that of hs_scan_pixels: one for each covered lane. So the shader's port needs no
// address. An entry is looked up in a small direct-mapped cache, whose tags are what it will hold
// when the requests before it were delivered. Frames have other entries: the cache is empty then.
// Interval: a stamp a cycle, or an entry a cycle, while the memory keeps up. A read takes a cycle,
// its word stays until the next.
module hs_planes_ahead #(
  parameter int unsigned LanesX,
  parameter int unsigned LanesY,
  parameter int unsigned EntryPlanesBits,
  parameter int unsigned MemoryBits,
  parameter int unsigned EachPixel,
  parameter int unsigned CacheBits = 7,        // of the number of its entries
  parameter int unsigned StampFifoDepth = 128,
  parameter int unsigned EntriesAhead = 16,    // asked for and not delivered
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned ScanBits = 1 + XBits + YBits + Lanes * IndexBits
) (
  input  logic                                  clk_i,
  input  logic                                  rst_ni,

  input  logic [hs_memory_pkg::AddressBits-1:0] base_i,

  // scan, and on to the shader
  input  logic                                  scan_valid_i,
  output logic                                  scan_ready_o,
  input  logic [ScanBits-1:0]                   scan_i,
  output logic                                  scan_valid_o,
  input  logic                                  scan_ready_i,
  output logic [ScanBits-1:0]                   scan_o,

  // The shader's port
  input  logic                                  read_en_i,
  output logic [EntryPlanesBits-1:0]            read_planes_o,

  // Memory
  output logic                                  read_valid_o,
  input  logic                                  read_ready_i,
  output hs_memory_pkg::request_t               read_o,
  input  logic                                  data_valid_i,
  input  logic [MemoryBits-1:0]                 data_i
);
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles);
  localparam int unsigned SlotBits = CacheBits < EntryBits ? CacheBits : EntryBits;
  localparam int unsigned Slots = 1 << SlotBits;
  localparam int unsigned CountBits = $clog2(Lanes + 1);
  localparam int unsigned PlanesDepth = 2 * Lanes > 16 ? 2 * Lanes : 16;
  localparam int unsigned ReadyBits = $clog2(PlanesDepth + 1);

  // --- Pick: the entries of a stamp, one after the other ---
  logic stamp_valid_q, waits, picks, pick_go, stamp_go, last_pick, stamps_ready, bank_q;
  logic [ScanBits-1:0] stamp_q;
  logic [Lanes-1:0] scan_waits, waits_q, group_lanes, picked;
  logic [CountBits-1:0] count_q, count;  // picked before, and with this one
  logic [EntryBits-1:0] entry;
  logic group_last, fetch_ready, requests_ready, hit;

  for (genvar lane = 0; lane < Lanes; lane++) begin : gen_waits
    assign scan_waits[lane] = scan_i[lane*IndexBits +: IndexBits] != '0;
  end

  hs_lane_group #(
    .Lanes(Lanes)
  ) u_group (
    .waits_i(waits_q),
    .index_i(stamp_q[Lanes*IndexBits-1:0]),
    .entry_o(entry),
    .lanes_o(group_lanes),
    .last_o (group_last)
  );
  assign waits = waits_q != '0;
  assign picked = EachPixel != 0 ? waits_q & (~waits_q + Lanes'(1)) : group_lanes;
  assign last_pick = EachPixel != 0 ? (waits_q & ~picked) == '0 : group_last;
  assign picks = stamp_valid_q && waits;
  assign count = count_q + CountBits'(waits);
  assign pick_go = picks && requests_ready && (hit || fetch_ready) && (!last_pick || stamps_ready);
  assign stamp_go = stamp_valid_q && (waits ? pick_go && last_pick : stamps_ready);
  assign scan_ready_o = !stamp_valid_q || stamp_go;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      stamp_valid_q <= 1'b0;
      bank_q <= 1'b0;
    end else begin
      if (scan_ready_o) stamp_valid_q <= scan_valid_i;
      if (stamp_go && stamp_q[ScanBits-1]) bank_q <= !bank_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (scan_ready_o) begin
      stamp_q <= scan_i;
      waits_q <= scan_waits;
      count_q <= '0;
    end else if (pick_go) begin
      waits_q <= waits_q & ~picked;
      count_q <= count;
    end
  end

  // --- Look up ---
  logic [Slots-1:0] valid_q;
  logic [EntryBits-1:0] tags_q [Slots];
  logic [SlotBits-1:0] slot, request_slot;
  logic request_valid, request_ready, request_hit;

  assign slot = entry[SlotBits-1:0];
  assign hit = valid_q[slot] && tags_q[slot] == entry;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (stamp_go && stamp_q[ScanBits-1]) valid_q <= '0;
    else if (pick_go) valid_q[slot] <= 1'b1;
  end

  always_ff @(posedge clk_i) begin
    if (pick_go) tags_q[slot] <= entry;
  end

  hs_fifo #(
    .Width(1 + SlotBits),
    .Depth(StampFifoDepth)
  ) u_requests (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (pick_go),
    .in_ready_o (requests_ready),
    .in_i       ({hit, slot}),
    .out_valid_o(request_valid),
    .out_ready_i(request_ready),
    .out_o      ({request_hit, request_slot})
  );

  // --- Deliver: from the cache, or from memory and into the cache ---
  logic row_valid, row_taken, delivered_q, from_cache_q, planes_ready, planes_valid;
  logic [EntryPlanesBits-1:0] row, row_q, cached, planes;
  logic [ReadyBits-1:0] held_q;  // delivered or on the way, and not read

  assign request_ready = held_q != ReadyBits'(PlanesDepth) && (request_hit || row_valid);
  assign row_taken = request_valid && request_ready && !request_hit;

  hs_row_fetch #(
    .RowBits   (EntryPlanesBits),
    .MemoryBits(MemoryBits),
    .TileBits  (1 + EntryBits),
    .TileRows  (1),
    .Tiles     (EntriesAhead)
  ) u_fetch (
    .clk_i       (clk_i),
    .rst_ni      (rst_ni),
    .base_i      (base_i),
    .tile_valid_i(pick_go && !hit),
    .tile_ready_o(fetch_ready),
    .tile_i      ({bank_q, entry}),
    .row_valid_o (row_valid),
    .row_ready_i (row_taken),
    .row_o       (row),
    .read_valid_o(read_valid_o),
    .read_ready_i(read_ready_i),
    .read_o      (read_o),
    .data_valid_i(data_valid_i),
    .data_i      (data_i)
  );

  hs_ram_1r1w #(
    .Width(EntryPlanesBits),
    .Depth(Slots),
    .Lanes(1)
  ) u_cache (
    .clk_i          (clk_i),
    .read_en_i      (request_valid && request_ready && request_hit),
    .read_address_i (request_slot),
    .read_data_o    (cached),
    .write_en_i     (row_taken),
    .write_address_i(request_slot),
    .write_data_i   (row)
  );

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      delivered_q <= 1'b0;
      held_q <= '0;
    end else begin
      delivered_q <= request_valid && request_ready;
      held_q <= held_q + ReadyBits'(request_valid && request_ready) - ReadyBits'(read_en_i);
    end
  end

  always_ff @(posedge clk_i) begin
    from_cache_q <= request_hit;
    if (row_taken) row_q <= row;
    if (read_en_i) read_planes_o <= planes;
  end

  logic unused_planes;
  assign unused_planes = ^{planes_ready, planes_valid};
  hs_fifo #(
    .Width(EntryPlanesBits),
    .Depth(PlanesDepth)
  ) u_planes (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (delivered_q),
    .in_ready_o (planes_ready),
    .in_i       (from_cache_q ? cached : row_q),
    .out_valid_o(planes_valid),
    .out_ready_i(read_en_i),
    .out_o      (planes)
  );

  // --- Gate: a stamp is let in when its planes are in the queue, behind those of stamps before ---
  logic gate_valid, gate_go;
  logic [CountBits-1:0] needs;
  logic [ReadyBits-1:0] ready_q;  // in the queue, and not of a stamp that was let in

  hs_fifo #(
    .Width(CountBits + ScanBits),
    .Depth(StampFifoDepth)
  ) u_stamps (
    .clk_i      (clk_i),
    .rst_ni     (rst_ni),
    .in_valid_i (stamp_go),
    .in_ready_o (stamps_ready),
    .in_i       ({count, stamp_q}),
    .out_valid_o(gate_valid),
    .out_ready_i(gate_go),
    .out_o      ({needs, scan_o})
  );
  assign scan_valid_o = gate_valid && ready_q >= ReadyBits'(needs);
  assign gate_go = scan_valid_o && scan_ready_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) ready_q <= '0;
    else ready_q <= ready_q + ReadyBits'(delivered_q) - (gate_go ? ReadyBits'(needs) : '0);
  end
endmodule
