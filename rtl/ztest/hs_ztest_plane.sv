// SPDX-License-Identifier: Apache-2.0
// The Z-test without a Z-buffer (type gamma): the stored index fetches a depth plane from TdbV, and
// the stored depth is computed again (kernel: hls/ztest/ztest_plane.hpp, which says why its bits
// are those of a Z-buffer). A triangle is reported visible, and has its plane in TdbV, when a
// fragment of it passed.
//
// Interval: a stamp takes a slot, that is a cycle, for each different triangle stored in its
// covered lanes, one if there is none; a triangle takes one more, for its plane. A stamp that has a
// pixel in common with one in flight waits until that one is written, 11 cycles behind it. Latency:
// 11 cycles from a stamp of one slot to its write, 12 to `visible`. Stages: read | data | pick,
// where a stamp becomes slots | fetch | plane | five of hs_plane_lanes | write.
// Stall: everything stops while a `visible` is not taken and the next one is due, and while a
// triangle is begun whose triangle_depth is not there.
// Buffers: a read takes one cycle, its word stays until the next read. The I-buffer has two banks,
// used in turn by the frames, the first one by the first frame after reset; a bank is all 0 when
// its frame begins. TdbV: entry index − 1, {plane at the centre of pixel (0, 0), dx, dy}; one bank,
// as a frame reads what it has written itself. It is written with the triangle's first write of the
// I-buffer, so that who reads the index finds the plane.
// Illegal: index 0 with a covered pixel.
module hs_ztest_plane #(
  parameter int unsigned LanesX = 2,
  parameter int unsigned LanesY = 2,
  localparam int unsigned Lanes = LanesX * LanesY,
  localparam int unsigned XBits = hs_formats_pkg::XBits,
  localparam int unsigned YBits = hs_formats_pkg::YBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles),
  // A package without depth has neither width, and no use for the unit.
  localparam int unsigned DepthBits = hs_formats_pkg::HasDepth != 0 ? hs_formats_pkg::DepthBits : 8,
  localparam int unsigned PlaneBits =
      hs_formats_pkg::HasDepth != 0 ? hs_formats_pkg::DepthPlaneBits : 24,
  localparam int unsigned TriangleDepthBits = IndexBits + XBits + YBits + 3 * PlaneBits,
  localparam int unsigned StampBits = 2 + IndexBits + XBits + YBits + Lanes * (1 + DepthBits),
  localparam int unsigned UpdateBits = IndexBits + XBits + YBits + Lanes,
  localparam int unsigned StampsX = (hs_formats_pkg::MaxWidth + LanesX - 1) / LanesX,
  localparam int unsigned StampsY = (hs_formats_pkg::MaxHeight + LanesY - 1) / LanesY,
  localparam int unsigned AddressBits = StampsX * StampsY > 1 ? $clog2(StampsX * StampsY) : 1
) (
  input  logic                         clk_i,
  input  logic                         rst_ni,

  // From raster_pineda
  input  logic                         triangle_depth_valid_i,
  output logic                         triangle_depth_ready_o,
  input  logic [TriangleDepthBits-1:0] triangle_depth_i,
  input  logic                         stamp_valid_i,
  output logic                         stamp_ready_o,
  input  logic [StampBits-1:0]         stamp_i,

  // To geometry
  output logic                         visible_valid_o,
  input  logic                         visible_ready_i,
  output hs_formats_pkg::visible_t     visible_o,

  // To watch: the writes
  output logic                         update_valid_o,
  output logic [UpdateBits-1:0]        update_o,

  // I-buffer
  output logic                         read_en_o,
  output logic                         read_bank_o,
  output logic [AddressBits-1:0]       read_address_o,
  input  logic [Lanes*IndexBits-1:0]   read_index_i,
  output logic [Lanes-1:0]             write_en_o,
  output logic                         write_bank_o,
  output logic [AddressBits-1:0]       write_address_o,
  output hs_formats_pkg::index_t       write_index_o,  // in each lane that is written

  // TdbV
  output logic                         fetch_en_o,
  output logic [EntryBits-1:0]         fetch_entry_o,
  input  logic [3*PlaneBits-1:0]       fetch_plane_i,
  output logic                         store_en_o,
  output logic [EntryBits-1:0]         store_entry_o,
  output logic [3*PlaneBits-1:0]       store_plane_o
);
  localparam int unsigned HeadBits = 2 + IndexBits + XBits + YBits;
  // Of slots: fetch, plane and the five of hs_plane_lanes.
  localparam int unsigned Stages = 7;

  logic go;  // all stages move

  // --- Stages read, data and pick ---
  hs_formats_pkg::stamp_head_t stamp_head, slot_head;
  logic [Lanes-1:0] stamp_mask, slot_lanes, slot_background;
  logic slot_valid, slot_begins, slot_last, slot_bank;
  logic [EntryBits-1:0] slot_entry;

  assign stamp_head = stamp_i[StampBits-1-:HeadBits];
  assign stamp_mask = stamp_i[StampBits-HeadBits-1-:Lanes];

  hs_ztest_slots #(
    .SlotStages(Stages),
    .LanesX    (LanesX),
    .LanesY    (LanesY)
  ) u_slots (
    .clk_i            (clk_i),
    .rst_ni           (rst_ni),
    .go_i             (go),
    .stamp_valid_i    (stamp_valid_i),
    .stamp_ready_o    (stamp_ready_o),
    .stamp_head_i     (stamp_head),
    .stamp_mask_i     (stamp_mask),
    .read_en_o        (read_en_o),
    .read_bank_o      (read_bank_o),
    .read_address_o   (read_address_o),
    .read_index_i     (read_index_i),
    .slot_valid_o     (slot_valid),
    .slot_begins_o    (slot_begins),
    .slot_last_o      (slot_last),
    .slot_bank_o      (slot_bank),
    .slot_head_o      (slot_head),
    .slot_entry_o     (slot_entry),
    .slot_lanes_o     (slot_lanes),
    .slot_background_o(slot_background),
    .write_address_o  (write_address_o)
  );

  // --- Slots: fetch | plane | five of hs_plane_lanes ---
  logic [Stages-1:0] valid_q, begins_slot_q, last_q, bank_slot_q;
  logic [Stages*Lanes-1:0] lanes_q, far_q;  // of the group, of the background
  logic [Stages*HeadBits-1:0] heads_q;
  logic [EntryBits-1:0] fetch_entry_q;
  logic plane_begins, leaves;
  logic [Lanes-1:0] nearer, slot_pass, pass_d, merged_q, pass_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) valid_q <= '0;
    else if (go) valid_q <= {valid_q[Stages-2:0], slot_valid};
  end

  always_ff @(posedge clk_i) begin
    if (go) begin
      begins_slot_q <= {begins_slot_q[Stages-2:0], slot_begins};
      last_q <= {last_q[Stages-2:0], slot_last};
      bank_slot_q <= {bank_slot_q[Stages-2:0], slot_bank};
      lanes_q <= {lanes_q[(Stages-1)*Lanes-1:0], slot_lanes};
      far_q <= {far_q[(Stages-1)*Lanes-1:0], slot_background};
      heads_q <= {heads_q[(Stages-1)*HeadBits-1:0], slot_head};
      fetch_entry_q <= slot_entry;
    end
  end

  assign fetch_en_o = go && valid_q[0] && lanes_q[0 +: Lanes] != '0;
  assign fetch_entry_o = fetch_entry_q;
  assign plane_begins = valid_q[1] && begins_slot_q[1];
  assign leaves = valid_q[Stages-1];

  hs_ztest_recall #(
    .DepthBits     (DepthBits),
    .PlaneBits     (PlaneBits),
    .StampsInFlight(3 + Stages),
    .LanesX        (LanesX),
    .LanesY        (LanesY)
  ) u_recall (
    .clk_i           (clk_i),
    .rst_ni          (rst_ni),
    .go_i            (go),
    .stamp_i         (stamp_valid_i && stamp_ready_o),
    .stamp_depth_i   (stamp_i[Lanes*DepthBits-1:0]),
    .begins_i        (plane_begins),
    .plane_i         (triangle_depth_i),
    .fetch_plane_i   (fetch_plane_i),
    .x_i             (heads_q[HeadBits+YBits +: XBits]),
    .y_i             (heads_q[HeadBits +: YBits]),
    .begun_i         (leaves && begins_slot_q[Stages-1]),
    .done_i          (leaves && last_q[Stages-1]),
    .background_i    (far_q[(Stages-1)*Lanes +: Lanes]),
    .nearer_o        (nearer),
    .entry_o         (store_entry_o),
    .plane_o         (store_plane_o)
  );

  // --- Stage write ---
  logic write_valid_q, write_bank_q, visible_valid_q, any_q, triangle_done, visible_free;
  hs_formats_pkg::stamp_head_t write_head_q;
  hs_formats_pkg::visible_t visible_q;
  hs_formats_pkg::update_head_t update_head;

  assign slot_pass =
      (lanes_q[(Stages-1)*Lanes +: Lanes] | far_q[(Stages-1)*Lanes +: Lanes]) & nearer;
  assign pass_d = merged_q | slot_pass;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      write_valid_q <= 1'b0;
      merged_q <= '0;
    end else if (go) begin
      write_valid_q <= leaves && last_q[Stages-1];
      if (leaves) merged_q <= last_q[Stages-1] ? '0 : pass_d;
    end
  end

  always_ff @(posedge clk_i) begin
    if (go) begin
      pass_q <= pass_d;
      write_head_q <= heads_q[(Stages-1)*HeadBits +: HeadBits];
      write_bank_q <= bank_slot_q[Stages-1];
    end
  end

  assign write_en_o = write_valid_q && go ? pass_q : '0;
  assign write_bank_o = write_bank_q;
  assign write_index_o = write_head_q.index;
  assign store_en_o = |write_en_o && !any_q;

  assign update_head.index = write_head_q.index;
  assign update_head.x = write_head_q.x;
  assign update_head.y = write_head_q.y;
  assign update_valid_o = |write_en_o;
  assign update_o = {update_head, pass_q};

  assign triangle_done = write_valid_q && write_head_q.triangle_last;
  assign visible_free = !triangle_done || !visible_valid_q || visible_ready_i;
  assign go = visible_free && (!plane_begins || triangle_depth_valid_i);
  assign triangle_depth_ready_o = plane_begins && visible_free;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      any_q <= 1'b0;
      visible_valid_q <= 1'b0;
    end else begin
      if (triangle_done && go) visible_valid_q <= 1'b1;
      else if (visible_ready_i) visible_valid_q <= 1'b0;
      if (write_valid_q && go) any_q <= !triangle_done && (any_q || |pass_q);
    end
  end

  always_ff @(posedge clk_i) begin
    if (triangle_done && go) begin
      visible_q.last <= write_head_q.last;
      visible_q.visible <= any_q || |pass_q;
      visible_q.index <= write_head_q.index;
    end
  end

  assign visible_valid_o = visible_valid_q;
  assign visible_o = visible_q;
endmodule
