// SPDX-License-Identifier: Apache-2.0
#include "ref/raster/architecture.hpp"

#include <algorithm>

#include "ref/raster/index_pool.hpp"
#include "ref/raster/spans.hpp"

namespace halfspace::ref {
namespace {

// The different entries of a database in the pixels of each stamp.
class Fetches {
 public:
  void add(std::size_t stamp, std::uint32_t entry) { fetches_.emplace_back(stamp, entry); }
  // How many they are; from now on there are none.
  std::uint64_t take() {
    std::sort(fetches_.begin(), fetches_.end());
    const std::uint64_t count = std::unique(fetches_.begin(), fetches_.end()) - fetches_.begin();
    fetches_.clear();
    return count;
  }

 private:
  std::vector<std::pair<std::size_t, std::uint32_t>> fetches_;
};

class Renderer {
 public:
  Renderer(const SnappedList& list, Surface& surface, Architecture architecture, bool deferred_lighting,
           const IndexReuse& reuse, const Circuit& circuit)
      : list_(list),
        surface_(surface),
        architecture_(architecture),
        deferred_lighting_(deferred_lighting && is_index_rendering(architecture)),
        circuit_(circuit),
        spans_(list.width, list.height, list.format.subpixel_bits, list.format.cull),
        pool_(reuse),
        pixels_(std::size_t(list.width) * list.height),
        has_depth_(list.format.depth_bits != 0) {
    std::array<std::uint8_t, 4> background{0, 0, 0, 255};
    for (int c = 0; c < 3; ++c) background[c] = displayed_colour(list.background[c], list.format.colour_bits);
    out_.triangle.assign(pixels_, 0);
    out_.depth.assign(pixels_, full_depth(list.format.depth_bits));
    out_.colour.assign(pixels_, background);
    index_.assign(is_index_rendering(architecture) ? pixels_ : 0, 0);
  }

  Drawing run() {
    clear();
    for (std::uint32_t k = 1; k <= list_.triangles.size(); ++k) triangle(k);
    scan_out();
    out_.rates.pixels = pixels_;
    out_.rates.largest_index = pool_.largest();
    BufferUses& use = out_.buffers;
    const bool indexed = is_index_rendering(architecture_);
    use.depth.entries = has_depth_ && architecture_ != Architecture::kGamma ? pixels_ : 0;
    use.frame.entries = architecture_ == Architecture::kAlpha ? pixels_ : 0;
    use.pixel.entries = architecture_ == Architecture::kBeta ? pixels_ : 0;
    use.index.entries = indexed ? pixels_ : 0;
    use.shading.entries = indexed ? pool_.largest() : 0;
    use.visibility.entries = has_depth_ && architecture_ == Architecture::kGamma ? pool_.largest() : 0;
    return std::move(out_);
  }

 private:
  void clear() {
    BufferUses& use = out_.buffers;
    if (is_index_rendering(architecture_)) {
      use.index.written += pixels_;
      return;
    }
    if (has_depth_) use.depth.written += pixels_;
    (architecture_ == Architecture::kAlpha ? use.frame : use.pixel).written += pixels_;
  }

  void triangle(std::uint32_t k) {
    ++out_.rates.triangles;
    if (!deferred_lighting_) out_.rates.lightings += std::uint64_t(surface_.light(k));
    const std::uint32_t index = is_index_rendering(architecture_) ? take_index(k) : 0;
    const SnappedTriangle& snapped = list_.triangles[k - 1];
    const OrderedTriangle t(snapped);
    const Plane depth(t, has_depth_ ? std::array<std::int64_t, 3>{snapped.depth[0], snapped.depth[1], snapped.depth[2]}
                                    : std::array<std::int64_t, 3>{});
    out_.rates.culled += spans_.is_dropped(t);
    bool visible = false;
    spans_.of(t, [&](std::int64_t row, Span span) {
      for (std::int64_t column = span.first; column <= span.last; ++column) {
        const std::size_t at = std::size_t(row) * list_.width + column;
        ++out_.rates.fragments;
        const std::uint32_t nearer = rounded(depth, at);
        if (!passes(nearer, at)) continue;
        ++out_.rates.reduced_fragments;
        visible = true;
        store(k, index, nearer, at);
      }
    });
    out_.visible.push_back(visible);
    if (visible) {
      ++out_.rates.reduced_triangles;
      if (deferred_lighting_) out_.rates.lightings += std::uint64_t(surface_.light(k));
      if (has_depth_ && architecture_ == Architecture::kGamma) ++out_.buffers.visibility.written;
    }
    if (is_index_rendering(architecture_)) {
      out_.buffers.shading.written += circuit_.stores_invisible ? spans_.has_box(t) : visible;
      out_.buffers.visibility.read += fetched_.take();
    }
    if (is_index_rendering(architecture_)) pool_.done(index, visible);
  }

  // The index of triangle k: TdbV and TdbS hold k at it from now on.
  std::uint32_t take_index(std::uint32_t k) {
    const std::uint32_t index = pool_.take();
    if (database_.size() < index) database_.push_back(k);
    database_[index - 1] = k;
    return index;
  }

  std::uint32_t rounded(const Plane& plane, std::size_t at) const {
    if (!has_depth_) return 0;
    const auto x = spans_.centre(std::int64_t(at % list_.width)), y = spans_.centre(std::int64_t(at / list_.width));
    return static_cast<std::uint32_t>(plane.rounded(plane.numerator(x, y)));
  }

  bool passes(std::uint32_t depth, std::size_t at) {
    BufferUses& use = out_.buffers;
    if (is_index_rendering(architecture_)) ++use.index.read;
    if (!has_depth_) return (is_index_rendering(architecture_) ? index_[at] : out_.triangle[at]) == 0;
    if (architecture_ != Architecture::kGamma) {
      ++use.depth.read;
      if (architecture_ == Architecture::kDelta && index_[at] == 0) return depth < full_depth(list_.format.depth_bits);
      return depth < out_.depth[at];
    }
    if (index_[at] == 0) return depth < full_depth(list_.format.depth_bits);
    if (circuit_.lanes_x == 0) ++use.visibility.read;
    else fetched_.add(stamp_of(at), index_[at]);
    const SnappedTriangle& stored = list_.triangles[database_[index_[at] - 1] - 1];
    const OrderedTriangle t(stored);
    return depth < rounded(Plane(t, {stored.depth[0], stored.depth[1], stored.depth[2]}), at);
  }

  void store(std::uint32_t k, std::uint32_t index, std::uint32_t depth, std::size_t at) {
    BufferUses& use = out_.buffers;
    out_.triangle[at] = k;
    out_.depth[at] = depth;
    if (has_depth_ && architecture_ != Architecture::kGamma) ++use.depth.written;
    if (architecture_ == Architecture::kAlpha) {
      ++use.frame.written;
      shade(k, at);
    } else if (architecture_ == Architecture::kBeta) {
      ++use.pixel.written;
    } else {
      ++use.index.written;
      index_[at] = index;
    }
  }

  std::size_t stamp_of(std::size_t at) const {
    return at / list_.width / circuit_.lanes_y * list_.width + at % list_.width / circuit_.lanes_x;
  }

  void shade(std::uint32_t k, std::size_t at) {
    out_.colour[at] = surface_.colour(k, int(at % list_.width), int(at / list_.width), out_.rates.lightings,
                                      out_.rates.texture_fetches);
  }

  void scan_out() {
    BufferUses& use = out_.buffers;
    std::uint32_t before = 0;
    for (std::size_t at = 0; at < pixels_; ++at) {
      if (at % list_.width == 0) before = 0;
      if (is_index_rendering(architecture_)) out_.triangle[at] = index_[at] ? database_[index_[at] - 1] : 0;
      const std::uint32_t k = out_.triangle[at];
      out_.rates.visible_pixels += k != 0;
      out_.rates.runs += k != 0 && k != before;
      before = k;
      if (k != 0 && circuit_.lanes_x != 0) fetched_.add(stamp_of(at), k);
      if (k != 0 && architecture_ != Architecture::kAlpha) shade(k, at);
    }
    if (architecture_ == Architecture::kAlpha) use.frame.read += pixels_;
    if (architecture_ == Architecture::kBeta) use.pixel.read += pixels_;
    if (is_index_rendering(architecture_)) {
      use.index.read += pixels_;
      use.shading.read += circuit_.lanes_x == 0 ? out_.rates.runs : fetched_.take();
    }
  }

  const SnappedList& list_;
  Surface& surface_;
  const Architecture architecture_;
  const bool deferred_lighting_;
  const Circuit circuit_;
  const Spans spans_;
  IndexPool pool_;
  const std::size_t pixels_;
  const bool has_depth_;
  std::vector<std::uint32_t> index_;     // I-buffer
  std::vector<std::uint32_t> database_;  // triangle of index i at [i - 1]
  Fetches fetched_;                      // of a triangle; at scan-out, of the frame
  Drawing out_;
};

}  // namespace

const char* name_of(Architecture architecture) {
  constexpr const char* kNames[] = {"alpha", "beta", "gamma", "delta"};
  return kNames[int(architecture)];
}

Drawing draw(const SnappedList& list, Surface& surface, Architecture architecture, bool deferred_lighting,
             const IndexReuse& reuse, const Circuit& circuit) {
  return Renderer(list, surface, architecture, deferred_lighting, reuse, circuit).run();
}

}  // namespace halfspace::ref
