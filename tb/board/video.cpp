// SPDX-License-Identifier: Apache-2.0
// Watches the video pins of a simulated board, of its RTL or of its netlist, as a display does: pins count where the
// pixel clock rises. Writes the pictures, and judges the timing of 640×480.
// Usage: video OUT FRAMES [PRESSED-IN-FRAME]…
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "Vboard.h"
#include "verilated.h"

namespace {
constexpr int kColumns = 640, kRows = 480, kLine = 800, kLines = 525, kSync = 96, kSyncLines = 2;

// A picture as a P6 file with 4 bits a channel.
void write(const std::string& path, const std::vector<std::uint8_t>& rgb) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) {
    std::fprintf(stderr, "video: cannot write %s\n", path.c_str());
    std::exit(2);
  }
  std::fprintf(file, "P6 %d %d 15\n", kColumns, kRows);
  std::fwrite(rgb.data(), 1, rgb.size(), file);
  std::fclose(file);
}
}  // namespace

double sc_time_stamp() { return 0; }

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "usage: video OUT FRAMES [PRESSED-IN-FRAME]…\n");
    return 2;
  }
  const std::string out = argv[1];
  const int frames = std::atoi(argv[2]);
  std::vector<bool> pressed(static_cast<std::size_t>(frames) + 2);
  for (int i = 3; i < argc; i++) pressed.at(static_cast<std::size_t>(std::atoi(argv[i]))) = true;

  Vboard board;
  board.clk_12mhz = 0;
  board.btn_n = 1;
  std::vector<std::uint8_t> rgb;
  int frame = -1, line = 0, column = 0, wrong = 0;  // Frame −1: before the first sync
  int wide = 0, high = 0, seen = 0;                 // Cycles and lines of the pulses; pixels of the line
  bool clock = false, hsync = false, vsync = false;
  // A frame has 2·2·800·525 edges of the pin; twice as many frames as asked for is the end of patience.
  const std::int64_t patience = (std::int64_t(frames) * 2 + 4) * 4 * kLine * kLines;
  for (std::int64_t edge = 0; frame < frames; edge++) {
    if (edge == patience) {
      std::fprintf(stderr, "video: %d frames came of %d\n", frame, frames);
      return 1;
    }
    board.clk_12mhz = edge & 1;
    board.eval();
    if (clock == bool(board.dvi_clk)) continue;
    clock = board.dvi_clk;
    if (!clock) continue;

    column++;
    if (board.dvi_de) {
      seen++;
      if (frame >= 0)
        rgb.insert(rgb.end(), {std::uint8_t(board.dvi_r), std::uint8_t(board.dvi_g), std::uint8_t(board.dvi_b)});
    } else if (board.dvi_r || board.dvi_g || board.dvi_b) {
      wrong += frame >= 0;  // A display calibrates on the black between pictures
    }
    wide += !board.dvi_hsync;
    if (hsync && !board.dvi_hsync) {
      if (frame >= 0) wrong += column != kLine || (seen != 0 && seen != kColumns);
      column = seen = 0;
      wide = 1;
      line++;
      high += !board.dvi_vsync;
    } else if (!hsync && board.dvi_hsync && frame >= 0) {
      wrong += wide != kSync;
    }
    if (vsync && !board.dvi_vsync) {
      if (frame >= 0) {
        wrong += line != kLines || high != kSyncLines || rgb.size() != std::size_t(3 * kColumns * kRows);
        write(out + "/frame_" + std::to_string(frame) + ".ppm", rgb);
      }
      rgb.clear();
      line = high = 0;
      frame++;
      board.btn_n = !pressed.at(static_cast<std::size_t>(frame));
    }
    hsync = board.dvi_hsync;
    vsync = board.dvi_vsync;
  }
  std::printf("video: %d frames, %d faults of timing\n", frames, wrong);
  return wrong != 0;
}
