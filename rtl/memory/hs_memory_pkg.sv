// SPDX-License-Identifier: Apache-2.0
// Memory outside, as hs_pipeline sees it: clients that read and clients that write, each with its
// own wires, whatever bus serves them.
//
// A request is {address, beats}: that many words of the memory from a byte address on, which is a
// multiple of a word's bytes. It stands until it is taken. Its words follow in order, and requests
// of one client are served in order; clients may overtake each other. A client that reads has room
// for what it asked for, so it takes each word at once and no other client waits for it. A client
// that writes has all words when it asks; the cycle in which `written` is 1 tells it that the next
// one of its requests, in their order, is in memory: a read that is asked for after that sees it.
package hs_memory_pkg;
  localparam int unsigned AddressBits = 32;
  localparam int unsigned BeatsBits = 8;
  localparam int unsigned RequestBits = AddressBits + BeatsBits;

  // Clients of hs_pipeline that read, by their number in its vectors of wires.
  localparam int unsigned ReadIndex = 0;  // tiles of the I-buffer, for the Z-test
  localparam int unsigned ReadDepth = 1;  // tiles of the Z-buffer
  localparam int unsigned ReadScan = 2;   // tiles of the I-buffer, for scan-out
  localparam int unsigned ReadPlanes = 3; // entries of TdbS
  localparam int unsigned Reads = 4;
  // And that write.
  localparam int unsigned WriteIndex = 0;
  localparam int unsigned WriteDepth = 1;
  localparam int unsigned WritePlanes = 2;
  localparam int unsigned Writes = 3;

  typedef struct packed {
    logic [AddressBits-1:0] address;
    logic [BeatsBits-1:0] beats;
  } request_t;

  // Where the buffers begin.
  typedef struct packed {
    logic [AddressBits-1:0] index;
    logic [AddressBits-1:0] depth;
    logic [AddressBits-1:0] planes;
  } bases_t;
endpackage
