// SPDX-License-Identifier: Apache-2.0
// The texture kernels on a frame that is drawn already: which triangle each pixel shows, and what it looks like without
// texture.
#ifndef HALFSPACE_TESTS_TEXTURE_TEXTURE_KERNELS_HPP_
#define HALFSPACE_TESTS_TEXTURE_TEXTURE_KERNELS_HPP_

#include <array>
#include <memory>
#include <vector>

#include "hls/setup/triangle_setup.hpp"
#include "hls/texture/texture_setup.hpp"
#include "model/texture/texture_records.hpp"
#include "ref/geometry/snap.hpp"

namespace halfspace::tests {

template <class F>
class TextureKernels {
 public:
  using Picture = std::vector<std::array<std::uint8_t, 4>>;  // 0 … 255, alpha 255

  // Loads the textures, and sets up the planes of all triangles that are not empty.
  TextureKernels(const ref::SnappedList& list, const model::TextureFrame& frame)
      : width_(list.width), height_(list.height) {
    model::load_textures<F>(frame, *table_);
    model::load_texels<F>(frame, *memory_);
    Frame<F> registers{};
    registers.width = from_raw<typename F::X>(list.width);
    registers.height = from_raw<typename F::Y>(list.height);
    for (std::size_t k = 0; k < list.triangles.size(); ++k) {
      Triangle<F> triangle{};
      triangle.index = from_raw<typename F::Index>(k + 1);
      for (int v = 0; v < 3; ++v) {
        triangle.x[v] = from_raw<typename F::Coord>(list.triangles[k].x[v]);
        triangle.y[v] = from_raw<typename F::Coord>(list.triangles[k].y[v]);
      }
      triangle_.write(triangle);
      triangle_setup(registers, triangle_, setup_, attributes_);
      setup_.read();
      const Attributes<F> shape = attributes_.read();
      if (raw(shape.empty)) continue;
      attributes_.write(shape);
      coordinates_.write(model::coordinates_record<F>(frame.triangles[k], int(k) + 1, false));
      texture_setup(attributes_, coordinates_, planes_);
      store_planes(planes_, *database_);
    }
  }

  // Triangle `k`, from 1 on, at a pixel.
  TexturePosition<F> position(std::uint32_t k, int x, int y) const {
    const TexturePlanes<F>& planes = database_->planes[k - 1];
    return texture_position<F>(planes, table_->entry[int(raw(planes.texture))], x, y);
  }

  Picture shade(const std::vector<std::uint32_t>& index, const Picture& lit) {
    Picture picture(lit.size());
    for (int y = 0; y < height_; y += F::kLanesY) {
      for (int x = 0; x < width_; x += F::kLanesX) {
        Scan<F> scan{};
        Pixel<F> before{};
        scan.x = before.x = from_raw<typename F::X>(x / F::kLanesX);
        scan.y = before.y = from_raw<typename F::Y>(y / F::kLanesY);
        for (int l = 0; l < F::kLanes; ++l) {
          const std::size_t at = pixel(x + l % F::kLanesX, y + l / F::kLanesX);
          if (at == lit.size()) continue;
          scan.index[l] = from_raw<typename F::Index>(index[at]);
          before.r[l] = from_raw<typename F::Colour>(ref::snapped_colour(lit[at][0], F::kColourBits));
          before.g[l] = from_raw<typename F::Colour>(ref::snapped_colour(lit[at][1], F::kColourBits));
          before.b[l] = from_raw<typename F::Colour>(ref::snapped_colour(lit[at][2], F::kColourBits));
        }
        scan_.write(scan), lit_.write(before);
        shade_texture(scan_, lit_, *database_, *table_, *memory_, pixel_);
        const Pixel<F> out = pixel_.read();
        for (int l = 0; l < F::kLanes; ++l) {
          const std::size_t at = pixel(x + l % F::kLanesX, y + l / F::kLanesX);
          if (at != lit.size()) picture[at] = {displayed(out.r[l]), displayed(out.g[l]), displayed(out.b[l]), 255};
        }
      }
    }
    return picture;
  }

 private:
  // One beyond the last outside the frame.
  std::size_t pixel(int x, int y) const {
    return x < width_ && y < height_ ? std::size_t(y) * width_ + x : std::size_t(width_) * height_;
  }
  static std::uint8_t displayed(const typename F::Colour& colour) {
    return ref::displayed_colour(unsigned(raw(colour)), F::kColourBits);
  }

  const int width_, height_;
  std::unique_ptr<TextureTable<F>> table_ = std::make_unique<TextureTable<F>>();
  std::unique_ptr<TextureMemory<F>> memory_ = std::make_unique<TextureMemory<F>>();
  std::unique_ptr<TextureDatabase<F>> database_ = std::make_unique<TextureDatabase<F>>();
  Stream<Triangle<F>> triangle_;
  Stream<Setup<F>> setup_;
  Stream<Attributes<F>> attributes_;
  Stream<TextureCoordinates<F>> coordinates_;
  Stream<TexturePlanes<F>> planes_;
  Stream<Scan<F>> scan_;
  Stream<Pixel<F>> lit_, pixel_;
};

}  // namespace halfspace::tests

#endif  // HALFSPACE_TESTS_TEXTURE_TEXTURE_KERNELS_HPP_
