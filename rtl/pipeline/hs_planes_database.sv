// SPDX-License-Identifier: Apache-2.0
// TdbS, the triangle database for shading: two banks, an entry a triangle.
//
// A word of planes is {last, empty, index, entry}; it goes to entry index - 1 of the bank to store
// to, unless it is empty. Planes never wait. A read takes a cycle.
module hs_planes_database #(
  parameter int unsigned PlanesBits,
  localparam int unsigned IndexBits = hs_formats_pkg::IndexBits,
  localparam int unsigned EntryBits = $clog2(hs_formats_pkg::Triangles),
  localparam int unsigned EntryPlanesBits = PlanesBits - 2 - IndexBits
) (
  input  logic                       clk_i,

  input  logic                       planes_valid_i,
  input  logic [PlanesBits-1:0]      planes_i,
  input  logic                       planes_bank_i,
  output logic                       planes_last_o,  // the last word of a frame moves

  input  logic                       read_en_i,
  input  logic                       read_bank_i,
  input  logic [EntryBits-1:0]       read_entry_i,
  output logic [EntryPlanesBits-1:0] read_planes_o
);
  logic last, empty, unused_index;
  logic [IndexBits-1:0] index;
  logic [EntryBits-1:0] entry;
  logic [EntryPlanesBits-1:0] entry_planes;

  assign {last, empty, index, entry_planes} = planes_i;
  assign planes_last_o = planes_valid_i && last;
  assign entry = EntryBits'(index) - EntryBits'(1);
  assign unused_index = ^index;  // a power of two of entries has a bit less

  hs_ram_1r1w #(
    .Width(EntryPlanesBits),
    .Depth(2 << EntryBits)
  ) u_ram (
    .clk_i          (clk_i),
    .read_en_i      (read_en_i),
    .read_address_i ({read_bank_i, read_entry_i}),
    .read_data_o    (read_planes_o),
    .write_en_i     (planes_valid_i && !empty),
    .write_address_i({planes_bank_i, entry}),
    .write_data_i   (entry_planes)
  );
endmodule
