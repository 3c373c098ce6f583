// SPDX-License-Identifier: Apache-2.0
// Clients that read, as hs_memory_pkg has them, on the read channels of an AXI4 port.
//
// One client after the other has its turn, for a request. A request is a burst, or two where it
// crosses 4 KiB, of incrementing addresses, with the client's number as its id; so its words come
// in the order in which they were asked for, whatever other clients have. At most Bursts are under
// way. axi_rready_o is always 1: a client has room for what it asked for.
// A word goes on the cycle after it came. error_o is 1 for a cycle when one came with an error;
// clients get it like any other.
// With flush_i 1 no request is taken, and what comes goes to nobody; the address that is offered
// stays until it is taken. idle_o: nothing is under way.
// Illegal: a request that is 0 beats long.
module hs_axi_read #(
  parameter int unsigned Clients = 2,
  parameter int unsigned DataBits = 64,
  parameter int unsigned IdBits = 4,
  parameter int unsigned Bursts = 16,
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
  output logic [Clients-1:0]             data_valid_o,
  output logic [DataBits-1:0]            data_o,

  output logic                           axi_arvalid_o,
  input  logic                           axi_arready_i,
  output logic [IdBits-1:0]              axi_arid_o,
  output logic [AddressBits-1:0]         axi_araddr_o,
  output logic [7:0]                     axi_arlen_o,
  input  logic                           axi_rvalid_i,
  output logic                           axi_rready_o,
  input  logic [IdBits-1:0]              axi_rid_i,
  input  logic [DataBits-1:0]            axi_rdata_i,
  input  logic [1:0]                     axi_rresp_i,
  input  logic                           axi_rlast_i
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

  // --- its bursts ---
  logic active_q, room, issue, ends, data_last;
  logic [AddressBits-1:0] address_q;
  logic [BeatsBits-1:0] beats_q;
  logic [PageBits:0] to_page;
  logic [BeatsBits-1:0] burst;
  logic [CountBits-1:0] bursts_q;

  assign take = asked && !active_q && !flush_i;
  assign to_page = {1'b1, {PageBits{1'b0}}} - {1'b0, address_q[11:ByteBits]};
  assign burst = (PageBits+1)'(beats_q) > to_page ? BeatsBits'(to_page) : beats_q;
  assign room = bursts_q != CountBits'(Bursts);
  assign issue = axi_arvalid_o && axi_arready_i;
  assign ends = burst == beats_q || flush_i;

  for (genvar i = 0; i < Clients; i++) begin : gen_ready
    assign request_ready_o[i] = take && ClientBits'(i) == chosen;
  end

  assign axi_arvalid_o = active_q && room;
  assign axi_arid_o = IdBits'(last_q);
  assign axi_araddr_o = address_q;
  assign axi_arlen_o = 8'(burst - BeatsBits'(1));

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      active_q <= 1'b0;
      last_q <= '0;
      bursts_q <= '0;
    end else begin
      if (take) active_q <= 1'b1;
      else if (issue && ends) active_q <= 1'b0;
      if (take) last_q <= chosen;
      bursts_q <= bursts_q + CountBits'(issue) - CountBits'(data_last);
    end
  end

  always_ff @(posedge clk_i) begin
    if (take) begin
      address_q <= address;
      beats_q <= beats;
    end else if (issue) begin
      address_q <= {address_q[AddressBits-1:12] + 20'd1, 12'd0};
      beats_q <= beats_q - burst;
    end
  end

  // --- what comes ---
  logic [Clients-1:0] data_valid_q;
  logic error_q;
  logic [IdBits-1:0] error_client_q;
  logic [DataBits-1:0] data_q;

  assign axi_rready_o = 1'b1;
  assign data_last = axi_rvalid_i && axi_rlast_i;

  always_ff @(posedge clk_i or negedge rst_ni) begin
    if (!rst_ni) begin
      data_valid_q <= '0;
      error_q <= 1'b0;
    end else begin
      for (int unsigned i = 0; i < Clients; i++) begin
        data_valid_q[i] <= axi_rvalid_i && axi_rid_i == IdBits'(i) && !flush_i;
      end
      error_q <= axi_rvalid_i && axi_rresp_i[1];
    end
  end

  always_ff @(posedge clk_i) begin
    data_q <= axi_rdata_i;
    error_client_q <= axi_rid_i;
  end

  logic unused_response;
  assign unused_response = axi_rresp_i[0];  // which of the two it is

  assign data_valid_o = data_valid_q;
  assign data_o = data_q;
  assign error_o = error_q;
  assign error_client_o = error_client_q;
  assign idle_o = !active_q && bursts_q == '0 && data_valid_q == '0;
endmodule
