// SPDX-License-Identifier: Apache-2.0
#include "vectors/frames/index_frames.hpp"

#include <fmt/format.h>

#include "vectors/frames/frame_builder.hpp"

namespace halfspace::model {
namespace {

constexpr int kCell = 4;  // pixels each way that a triangle has to itself

// Triangles in the cells of a frame, of the side that is drawn: a visible one takes a cell of its own, an invisible one
// lies in the first cell as the first triangle does, and fails each test against it.
class Cells {
 public:
  Cells(const ref::RasterFormat& format, bool flipped) : builder_(format, format.width, format.height), flip_(flipped) {
    columns_ = builder_.list().width / kCell, rows_ = builder_.list().height / kCell;
  }

  int room() const { return columns_ * rows_; }
  void visible(int count) {
    for (int n = 0; n < count; ++n) put(used_++);
  }
  void invisible(int count) {
    for (int n = 0; n < count; ++n) put(0);
  }
  void finish(const std::string& note, std::vector<NamedFrame>& frames) { frames.push_back({note, builder_.list()}); }

 private:
  void put(int cell) {
    const int one = builder_.one(), x = cell % columns_ * kCell * one, y = cell / columns_ * kCell * one;
    const Point a{x, y}, b{x, y + 3 * one}, c{x + 3 * one, y};
    // Counter-clockwise on the screen: the front.
    builder_.add(a, flip_ ? c : b, flip_ ? b : c).depth(builder_.full_depth() / 2);
  }

  FrameBuilder builder_;
  const bool flip_;
  int columns_, rows_, used_ = 0;
};

}  // namespace

std::vector<NamedFrame> index_frames(const ref::RasterFormat& format, const Config& config) {
  const int n = config.triangles, window = config.index_window;
  std::vector<NamedFrame> frames;
  const auto add = [&](const std::string& note, auto&& draw) {
    Cells cells(format, culls_front(config));
    if (draw(cells)) cells.finish("indices: " + note, frames);
  };
  add("all but the first triangle invisible, the window twice", [&](Cells& cells) {
    cells.visible(1);
    cells.invisible(2 * window + 2);
    return true;
  });
  for (int more = -1; more <= 1; ++more) {
    add(fmt::format("visible and invisible in turn, the window and {} more", more), [&](Cells& cells) {
      for (int k = 0; k < window + more; ++k) k % 2 == 0 ? cells.visible(1) : cells.invisible(1);
      return window + more > 0 && window / 2 + 2 <= cells.room();
    });
  }
  add("one more visible than there are indices", [&](Cells& cells) {
    if (n + 1 > cells.room()) return false;
    cells.visible(n + 1);
    return true;
  });
  add("few after a frame without enough", [&](Cells& cells) {
    cells.visible(2);
    return true;
  });
  // The last two indices come back a window later, when all are in use.
  add("indices run out, two come back, and they run out again", [&](Cells& cells) {
    if (n + window + 4 > cells.room() || n < 4) return false;
    cells.visible(n - 2);
    cells.invisible(2);
    cells.visible(window + 4);
    return true;
  });
  // All indices are in use, and no triangle is without one. The longest, so that it is tried behind a reset.
  add("indices run out, and all that follow find one that came back", [&](Cells& cells) {
    if (n < window + 1 || n > cells.room()) return false;
    cells.visible(n - window);
    cells.invisible(3 * window);
    return true;
  });
  for (int k = 0; k < 4; ++k) {
    add("one triangle", [&](Cells& cells) {
      cells.visible(1);
      return true;
    });
  }
  return frames;
}

}  // namespace halfspace::model
