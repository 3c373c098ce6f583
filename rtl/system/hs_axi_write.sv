// SPDX-License-Identifier: Apache-2.0
// Clients that write, as hs_memory_pkg has them, on the write channels of an AXI4 port.
//
// One client after the other has its turn, for a request: a burst, or two where it crosses 4 KiB,
// with the client's number as its id. An address is offered, then its words. written_o is 1 for a
// cycle when the last burst of a request was answered; at most Bursts of a client wait for that.
// error_o is 1 for a cycle when an answer was an error.
// With flush_i 1 no request is taken and nothing is written: the words that a burst still lacks go
// out without strobes. Nobody is told of answers then. idle_o: nothing is under way.
// Illegal: a request that is 0 beats long; a client that asks and has not all words.
module hs_axi_write #(
  parameter int unsigned Clients = 3,
  parameter int unsigned DataBits = 64,
  parameter int unsigned IdBits = 4,
  parameter int unsigned Bursts = 8,
  localparam int unsigned AddressBits = hs_memory_pkg::AddressBits,
  localparam int unsigned BeatsBits = hs_memory_pkg::BeatsBits,
  localparam int unsigned RequestBits = hs_memory_pkg::RequestBits
) (
  input  logic                           clk_i,
  input  logic                           rst_ni,
  input  logic                           flush_i,
  output logic                           idle_o,
  output logic                           error_o,
  output logic [IdBits-1:0]              error_client_o,

  input  logic [Clients-1:0]             request_valid_i,
  output logic [Clients-1:0]             request_ready_o,
  input  logic [Clients*RequestBits-1:0] request_i,
  input  logic [Clients-1:0]             store_valid_i,
  output logic [Clients-1:0]             store_ready_o,
  input  logic [Clients*DataBits-1:0]    store_i,
  output logic [Clients-1:0]             written_o,

  output logic                           axi_awvalid_o,
  input  logic                           axi_awready_i,
  output logic [IdBits-1:0]              axi_awid_o,
  output logic [AddressBits-1:0]         axi_awaddr_o,
  output logic [7:0]                     axi_awlen_o,
  output logic                           axi_wvalid_o,
  input  logic                           axi_wready_i,
  output logic [DataBits-1:0]            axi_wdata_o,
  output logic [DataBits/8-1:0]          axi_wstrb_o,
  output logic                           axi_wlast_o,
  input  logic                           axi_bvalid_i,
  output logic                           axi_bready_o,
  input  logic [IdBits-1:0]              axi_bid_i,
  input  logic [1:0]                     axi_bresp_i
);
  localparam int unsigned ByteBits = $clog2(DataBits / 8);
  localparam int unsigned PageBits = 12 - ByteBits;  // beats of 4 KiB
  localparam int unsigned ClientBits = Clients > 1 ? $clog2(Clients) : 1;
  localparam int unsigned CountBits = $clog2(Bursts + 1);

  // --- whose turn it is: of those that ask the first behind the last one ---
  logic [ClientBits-1:0] last_q, chosen;
  logic asked, take;
  logic [AddressBits-1:0] address;
  logic [BeatsBits-1:0] beats;

  always_comb begin
    chosen = last_q;
    asked = 1'b0;
    for (int unsigned i = 0; i < 2 * Clients; i++) begin
      if (!asked && i > 32'(last_q) && i <= 32'(last_q) + Clients && request_valid_i[i%Clients])
      begin
        chosen = ClientBits'(i % Clients);
        asked = 1'b1;
      end
    end
    address = '0;
    beats = '0;
    for (int unsigned i = 0; i < Clients; i++) begin
      if (ClientBits'(i) == chosen) {address, beats} = request_i[i*RequestBits +: RequestBits];
    end
  end

  // --- its bursts, and the words of each ---
  logic active_q, words_q;  // a request is under way; the address of a burst was taken
  logic [AddressBits-1:0] address_q;
  logic [BeatsBits-1:0] beats_q, left_q;  // of the request, of the burst
  logic [PageBits:0] to_page;
  logic [BeatsBits-1:0] burst;
  logic issue, room, word, have, burst_last, final_burst, ends;
  logic [DataBits-1:0] store;
  logic wvalid_q, wlast_q, wstrb_q;
  logic [DataBits-1:0] wdata_q;

  assign take = asked && !active_q && !flush_i;
  assign to_page = {1'b1, {PageBits{1'b0}}} - {1'b0, address_q[11:ByteBits]};
  assign burst = (PageBits+1)'(beats_q) > to_page ? BeatsBits'(to_page) : beats_q;
  assign final_burst = burst == beats_q;
  assign issue = axi_awvalid_o && axi_awready_i;
  assign word = words_q && have && (!wvalid_q || axi_wready_i);
  assign burst_last = left_q == BeatsBits'(1);
  assign ends = word && burst_last && (beats_q == '0 || flush_i);

  always_comb begin
    have = flush_i;
    store = '0;
    for (int unsigned i = 0; i < Clients; i++) begin
      if (ClientBits'(i) == last_q) begin
        if (store_valid_i[i]) have = 1'b1;
        store = store_i[i*DataBits +: DataBits];
      end
    end
  end

  for (genvar i = 0; i < Clients; i++) begin : gen_ready
    assign request_ready_o[i] = take && ClientBits'(i) == chosen;
    assign store_ready_o[i] = words_q && (!wvalid_q || axi_wready_i) && !flush_i
                              && ClientBits'(i) == last_q;
  end

  assign axi_awvalid_o = active_q && !words_q && room;
  assign axi_awid_o = IdBits'(last_q);
  assign axi_awaddr_o = address_q;
  assign axi_awlen_o = 8'(burst - BeatsBits'(1));
  assign axi_wvalid_o = wvalid_q;
  assign axi_wdata_o = wdata_q;
  assign axi_wstrb_o = {(DataBits/8){wstrb_q}};
  assign axi_wlast_o = wlast_q;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      words_q <= 1'b0;
      last_q <= '0;
      wvalid_q <= 1'b0;
    end else begin
      if (take) active_q <= 1'b1;
      else if (ends) active_q <= 1'b0;
      if (take) last_q <= chosen;
      if (issue) words_q <= 1'b1;
      else if (word && burst_last) words_q <= 1'b0;
      if (word) wvalid_q <= 1'b1;
      else if (axi_wready_i) wvalid_q <= 1'b0;
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      address_q <= address;
      beats_q <= beats;
    end else if (issue) begin
      address_q <= {address_q[AddressBits-1:12] + 20'd1, 12'd0};
      beats_q <= beats_q - burst;
      left_q <= burst;
    end else if (word) begin
      left_q <= left_q - BeatsBits'(1);
    end
    if (word) begin
      wdata_q <= store;
      wlast_q <= burst_last;
      wstrb_q <= !flush_i;
    end
  end

  // --- answers: of each client's bursts under way, whether one is the last of its request ---
  logic [Clients-1:0] rooms, waits, written_q;
  logic error_q, chosen_room;
  logic [IdBits-1:0] error_client_q;

  for (genvar i = 0; i < Clients; i++) begin : gen_answers
    logic [Bursts-1:0] final_q;  // oldest first
    logic [CountBits-1:0] count_q, behind;
    logic asks, answered;

    assign asks = issue && ClientBits'(i) == last_q;
    assign answered = axi_bvalid_i && axi_bid_i == IdBits'(i);
    assign behind = count_q - CountBits'(answered);
    assign rooms[i] = count_q != CountBits'(Bursts);
    assign waits[i] = count_q != '0;

    always_ff @(posedge clk_i or negedge rst_ni) begin
      if (!rst_ni) begin
        count_q <= '0;
        written_q[i] <= 1'b0;
      end else begin
        count_q <= behind + CountBits'(asks);
        written_q[i] <= answered && final_q[0] && !flush_i;
      end
    end

    always_ff @(posedge clk_i) begin
      if (answered) final_q <= final_q >> 1;
      for (int unsigned n = 0; n < Bursts; n++) begin
        if (asks && behind == CountBits'(n)) final_q[n] <= final_burst;
      end
    end
  end

  always_comb begin
    chosen_room = 1'b0;
    for (int unsigned i = 0; i < Clients; i++) begin
      if (ClientBits'(i) == last_q) chosen_room = rooms[i];
    end
  end
  assign room = chosen_room;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) error_q <= 1'b0;
    else error_q <= axi_bvalid_i && axi_bresp_i[1];
  end

  always_ff @(posedge clk_i) error_client_q <= axi_bid_i;

  logic unused_response;
  assign unused_response = axi_bresp_i[0];  // which of the two it is

  assign axi_bready_o = 1'b1;
  assign written_o = written_q;
  assign error_o = error_q;
  assign error_client_o = error_client_q;
  assign idle_o = !active_q && !wvalid_q && waits == '0;
endmodule
