// SPDX-License-Identifier: Apache-2.0
#include "study/bounds/bounds_probe.hpp"

#include "hls/pipeline/pipeline.hpp"
#include "model/formats/runtime_formats.hpp"
#include "model/pipeline/kernels/triangle_record.hpp"

namespace halfspace::model {
namespace {

template <class S>
class RuntimeProbe : public KernelProbe {
  using F = RuntimeFormats<S>;

 public:
  explicit RuntimeProbe(const Config& config) : config_(config), table_(format_table(config)) {
    config_.triangles = 1;  // room for the one triangle; the formats are those of all
    F::activate(config_, table_);
    database_ = std::make_unique<ShadingDatabase<F>>();
    frame_.r = frame_.g = frame_.b = from_raw<typename F::Colour>(0);
  }

  void set_frame(int width, int height) override {
    F::activate(config_, table_);
    frame_.width = from_raw<typename F::X>(width);
    frame_.height = from_raw<typename F::Y>(height);
  }

  ProbedSetup setup(const ref::SnappedTriangle& in) override {
    F::activate(config_, table_);
    const Triangle<F> t = triangle_record<F>(in, 1, 0);
    s_.triangle.write(t);
    triangle_setup(frame_, s_.triangle, s_.setup, s_.attributes);
    setup_ = s_.setup.read();
    if (raw(setup_.empty)) return {};
    if (F::kPhong) return plain(area_reciprocal<F>(order_vertices<F>(t).area), normal_planes(in));
    set_colours(t);
    const Planes<F> planes = s_.planes.read();
    s_.planes.write(planes);
    store_planes(s_.planes, *database_);
    return plain(area_reciprocal<F>(order_vertices<F>(t).area), planes);
  }

  std::vector<ProbedPixel> pixels() override {
    F::activate(config_, table_);
    std::vector<ProbedPixel> out;
    if (raw(setup_.empty)) return out;
    s_.setup.write(setup_);
    raster_pineda(frame_, s_.setup, s_.stamp, depth_plane_, s_.visits);
    if (F::kTestsPlanes) depth_plane_.read();
    while (!s_.stamp.empty()) {
      const Stamp<F> s = s_.stamp.read();
      Scan<F> scan{};
      scan.x = s.x;
      scan.y = s.y;
      for (int l = 0; l < F::kLanes; ++l) scan.index[l] = from_raw<typename F::Index>(raw(s.mask[l]));
      s_.scan.write(scan);
      if (F::kPhong) {
        s_.scan.read();
        push_normals(s, out);
        continue;
      }
      shade_gouraud(frame_, s_.scan, *database_, s_.pixel);
      const Pixel<F> p = s_.pixel.read();
      for (int l = 0; l < F::kLanes; ++l) {
        if (!raw(s.mask[l])) continue;
        out.push_back({int(raw(s.x)) * F::kLanesX + l % F::kLanesX,
                       int(raw(s.y)) * F::kLanesY + l / F::kLanesX,
                       std::uint32_t(raw(s.depth[l])),
                       {std::uint32_t(raw(p.r[l])), std::uint32_t(raw(p.g[l])), std::uint32_t(raw(p.b[l]))}});
      }
    }
    return out;
  }

 private:
  // The attributes' planes: colours come with them, or as those of a triangle that was lit.
  void set_colours(const Triangle<F>& in) {
    if (!F::kHasLighting) {
      shade_setup(s_.attributes, s_.planes);
      return;
    }
    Colours<F> colours{};
    for (int v = 0; v < 3; ++v) colours.r[v] = in.r[v], colours.g[v] = in.g[v], colours.b[v] = in.b[v];
    s_.colours.write(colours);
    shade_setup(s_.attributes, s_.colours, s_.planes);
  }

  NormalPlanes<F> normal_planes(const ref::SnappedTriangle& in) {
    const int offset = 1 << config_.normal_bits;
    Normals<F> normals{};
    normals.index = from_raw<typename F::Index>(1);
    for (int v = 0; v < 3; ++v) {
      normals.x[v] = from_raw<typename F::Normal>(normal_of_colour(config_, in.rgb[v][0]) - offset);
      normals.y[v] = from_raw<typename F::Normal>(normal_of_colour(config_, in.rgb[v][1]) - offset);
      normals.z[v] = from_raw<typename F::Normal>(normal_of_colour(config_, in.rgb[v][2]) - offset);
    }
    s_.normals.write(normals);
    phong_setup(s_.attributes, s_.normals, s_.normal_planes);
    return normal_planes_ = s_.normal_planes.read();
  }

  void push_normals(const Stamp<F>& s, std::vector<ProbedPixel>& out) const {
    const NormalPlanes<F>& n = normal_planes_;
    for (int l = 0; l < F::kLanes; ++l) {
      if (!raw(s.mask[l])) continue;
      const int x = int(raw(s.x)) * F::kLanesX + l % F::kLanesX, y = int(raw(s.y)) * F::kLanesY + l / F::kLanesX;
      out.push_back({x, y, std::uint32_t(raw(s.depth[l])), {}});
      for (int c = 0; c < 3; ++c) {
        const auto component = normal_component<F>(n.start[c], n.dx[c], n.dy[c], x, y);
        out.back().colour[c] = std::uint32_t(raw(component) + (1 << config_.normal_bits));
      }
    }
  }

  ProbedSetup plain(const AreaReciprocal<F>& inverse, const Planes<F>& planes) const {
    ProbedSetup out = plain(inverse);
    out.colour[0] = {raw(planes.r), raw(planes.r_dx), raw(planes.r_dy), 0, 0};
    out.colour[1] = {raw(planes.g), raw(planes.g_dx), raw(planes.g_dy), 0, 0};
    out.colour[2] = {raw(planes.b), raw(planes.b_dx), raw(planes.b_dy), 0, 0};
    return out;
  }
  ProbedSetup plain(const AreaReciprocal<F>& inverse, const NormalPlanes<F>& planes) const {
    ProbedSetup out = plain(inverse);
    for (int c = 0; c < 3; ++c) out.colour[c] = {raw(planes.start[c]), raw(planes.dx[c]), raw(planes.dy[c]), 0, 0};
    return out;
  }
  ProbedSetup plain(const AreaReciprocal<F>& inverse) const {
    ProbedSetup out;
    out.empty = false;
    out.shift = int(raw(inverse.shift));
    out.reciprocal = raw(inverse.reciprocal);
    for (int i = 0; i < 3; ++i) {
      out.e[i] = raw(setup_.e[i]);
      out.e_dx[i] = raw(setup_.e_dx[i]);
      out.e_dy[i] = raw(setup_.e_dy[i]);
    }
    out.depth = {raw(setup_.depth), raw(setup_.depth_dx), raw(setup_.depth_dy), int(raw(setup_.x_start)) * F::kLanesX,
                 int(raw(setup_.y_min)) * F::kLanesY};
    return out;
  }

  Config config_;
  FormatTable table_;
  Frame<F> frame_;
  Setup<F> setup_{};
  std::unique_ptr<ShadingDatabase<F>> database_;
  Streams<F> s_;
  Stream<TriangleDepth<F>> depth_plane_;  // to no one
  NormalPlanes<F> normal_planes_{};
};

}  // namespace

std::unique_ptr<KernelProbe> make_kernel_probe(const Config& config) {
  switch (config.lanes) {
    case 2: return std::make_unique<RuntimeProbe<Stamp2>>(config);
    case 4: return std::make_unique<RuntimeProbe<Stamp4>>(config);
    case 8: return std::make_unique<RuntimeProbe<Stamp8>>(config);
    case 16: return std::make_unique<RuntimeProbe<Stamp16>>(config);
  }
  return std::make_unique<RuntimeProbe<Stamp1>>(config);
}

}  // namespace halfspace::model
