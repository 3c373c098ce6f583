// SPDX-License-Identifier: Apache-2.0
#include "study/bounds/bounds_probe.hpp"

#include <algorithm>
#include <cmath>

#include "hls/pipeline/pipeline.hpp"
#include "model/formats/runtime_formats.hpp"
#include "model/motion/motion_records.hpp"
#include "model/pipeline/kernels/triangle_record.hpp"
#include "model/shade/lighting_records.hpp"
#include "model/texture/texture_records.hpp"

namespace halfspace::model {
namespace {

// Memories for one triangle, made while the formats are active.
template <class F>
struct ProbeBuffers {
  ShadingDatabase<F> shading;
  NormalDatabase<F> normals;
  TextureDatabase<F> coordinates;
  MotionDatabase<F> motion;
  LightTable<F> lights{};
  MaterialTable<F> materials;
  TextureTable<F> textures;
  TextureMemory<F> texels;
};

template <class Plane, class Gradient>
ProbedPlane plain_plane(const Plane& start, const Gradient& dx, const Gradient& dy) {
  return {raw(start), raw(dx), raw(dy), 0, 0};
}

template <class S>
class RuntimeProbe : public KernelProbe {
  using F = RuntimeFormats<S>;
  using Planes3 = std::array<ProbedPlane, 3>;

 public:
  explicit RuntimeProbe(const Config& config) : config_(config), table_(format_table(config)) {
    config_.triangles = 1;  // room for the one triangle; the formats are those of all
    activate();
    b_ = std::make_unique<ProbeBuffers<F>>();
    frame_.r = frame_.g = frame_.b = from_raw<typename F::Colour>(0);
  }

  void set_frame(int width, int height) override {
    activate();
    frame_.width = from_raw<typename F::X>(width);
    frame_.height = from_raw<typename F::Y>(height);
  }
  void load(const LightingFrame& lighting) override {
    activate();
    load_lights<F>(lighting, b_->lights);
    load_materials<F>(lighting, b_->materials);
  }
  void load(const TextureFrame& texture) override {
    activate();
    load_textures<F>(texture, b_->textures);
    load_texels<F>(texture, b_->texels);
  }

  ProbedSetup setup(const ref::SnappedTriangle& in) override {
    activate();
    const Triangle<F> t = triangle_record<F>(in, 1, 1);
    s_.triangle.write(t);
    triangle_setup(frame_, s_.triangle, s_.setup, s_.attributes);
    setup_ = s_.setup.read();
    if (!s_.attributes.empty()) attributes_ = s_.attributes.read();  // deferred: of an empty triangle as well
    if (raw(setup_.empty)) return {};
    ProbedSetup out = plain(area_reciprocal<F>(order_vertices<F>(t).area));
    if (F::kPhong) {
      set_normals(stretched_normals(in));
      const NormalPlanes<F>& n = b_->normals.planes[0];
      for (int c = 0; c < 3; ++c) out.colour[c] = plain_plane(n.start[c], n.dx[c], n.dy[c]);
    } else if (!F::kHasMotion) {
      set_colours(t);
      const Planes<F>& p = b_->shading.planes[0];
      out.colour = {plain_plane(p.r, p.r_dx, p.r_dy), plain_plane(p.g, p.g_dx, p.g_dy),
                    plain_plane(p.b, p.b_dx, p.b_dy)};
    }
    if (F::kHasTexture) {
      set_coordinates(coordinates_record<F>(stretched_coordinates(in), 1, false));
      out.coordinate = plain(b_->coordinates.planes[0]);
    }
    if (F::kHasMotion) {
      set_motion(vectors_record<F>(stretched_motion(in), 1, false));
      const KeyPlanes<F>& key = b_->motion.planes[0].key[0];
      out.coordinate = plain(key);
      for (int c = 0; c < 3 && F::kRelights; ++c)
        out.difference[c] = plain_plane(key.colour[c], key.colour_dx[c], key.colour_dy[c]);
    }
    return out;
  }

  std::vector<ProbedPixel> pixels() override {
    activate();
    std::vector<ProbedPixel> out;
    if (raw(setup_.empty)) return out;
    s_.setup.write(setup_);
    raster_pineda(frame_, s_.setup, s_.stamp, depth_plane_, s_.visits);
    if (F::kTestsPlanes) depth_plane_.read();
    while (!s_.stamp.empty()) {
      const Stamp<F> s = s_.stamp.read();
      Pixel<F> p{};
      if (!F::kPhong && !F::kHasMotion) {
        Scan<F> scan{};
        scan.x = s.x;
        scan.y = s.y;
        for (int l = 0; l < F::kLanes; ++l) scan.index[l] = from_raw<typename F::Index>(raw(s.mask[l]));
        s_.scan.write(scan);
        shade_gouraud(frame_, s_.scan, b_->shading, s_.pixel);
        p = s_.pixel.read();
      }
      for (int l = 0; l < F::kLanes; ++l) {
        if (!raw(s.mask[l])) continue;
        out.push_back({int(raw(s.x)) * F::kLanesX + l % F::kLanesX,
                       int(raw(s.y)) * F::kLanesY + l / F::kLanesX,
                       std::uint32_t(raw(s.depth[l])),
                       {std::uint32_t(raw(p.r[l])), std::uint32_t(raw(p.g[l])), std::uint32_t(raw(p.b[l]))},
                       {},
                       {}});
        add_planes(out.back());
      }
    }
    return out;
  }

  void give(const RawNormals& normals) override {
    activate();
    const Normals<F> record = normals_record<F>(normals, 1, false);
    if (F::kPhong) {
      set_normals(record);
      return;
    }
    s_.normals.write(record);
    light_vertex(s_.normals, b_->lights, b_->materials, s_.colours);
    s_.attributes.write(attributes_);
    shade_setup(s_.attributes, s_.colours, s_.planes);
    store_planes(s_.planes, b_->shading);
  }
  void give(const RawCoordinates& coordinates) override {
    activate();
    set_coordinates(coordinates_record<F>(coordinates, 1, false));
  }
  void give(const RawMotionVectors& vectors) override {
    activate();
    set_motion(vectors_record<F>(vectors, 1, false));
  }

  ProbedPlace place(const RawTexture& texture, int x, int y) override {
    activate();
    TextureEntry<F> entry{};
    entry.log2_width = from_raw<typename F::Side>(texture.log2_width);
    entry.log2_height = from_raw<typename F::Side>(texture.log2_height);
    const TexturePosition<F> at = texture_position<F>(b_->coordinates.planes[0], entry, x, y);
    return {raw(at.u), raw(at.v)};
  }
  RawMotion motion(int x, int y) override {
    activate();
    return plain_motion<F>(motion_pixel<F>(b_->motion.planes[0], x, y));
  }
  std::array<int, 3> normal(int x, int y) override {
    activate();
    const NormalPlanes<F>& n = b_->normals.planes[0];
    std::array<int, 3> out;
    for (int c = 0; c < 3; ++c) out[c] = int(raw(normal_component<F>(n.start[c], n.dx[c], n.dy[c], x, y)));
    return out;
  }
  std::array<std::uint32_t, 3> lit(int x, int y) override {
    activate();
    s_.scan.write(scan_of(x, y));
    if (F::kPhong) shade_phong(frame_, s_.scan, b_->normals, b_->lights, b_->materials, s_.lit);
    else shade_gouraud(frame_, s_.scan, b_->shading, s_.lit);
    return colour_of(s_.lit.read(), x, y);
  }
  std::array<std::uint32_t, 3> shown(int x, int y) override {
    const std::array<std::uint32_t, 3> before = lit(x, y);
    if (!F::kHasTexture) return before;
    Pixel<F> pixel{};
    const int lane = lane_of(x, y);
    pixel.r[lane] = from_raw<typename F::Colour>(before[0]);
    pixel.g[lane] = from_raw<typename F::Colour>(before[1]);
    pixel.b[lane] = from_raw<typename F::Colour>(before[2]);
    s_.lit.write(pixel);
    s_.texed_scan.write(scan_of(x, y));
    shade_texture(s_.texed_scan, s_.lit, b_->coordinates, b_->textures, b_->texels, s_.pixel);
    return colour_of(s_.pixel.read(), x, y);
  }

  ProbedTexel textured(const TexelSample& sample) override {
    activate();
    using Colour = typename F::Colour;
    typename F::Filtered filtered = from_raw<Colour>(sample.texel[0]);
    if (F::kBilinear) {
      filtered = bilinear<F>(from_raw<Colour>(sample.texel[0]), from_raw<Colour>(sample.texel[1]),
                             from_raw<Colour>(sample.texel[2]), from_raw<Colour>(sample.texel[3]),
                             from_raw<TexelWeight>(sample.odd_column), from_raw<TexelWeight>(sample.odd_row));
    }
    const Colour colour = halfspace::textured<F>(from_raw<Colour>(sample.lit), filtered);
    return {std::uint32_t(raw(filtered)), std::uint32_t(raw(colour))};
  }
  ProbedInverse worst_inverse() override {
    activate();
    ProbedInverse worst;
    const int b = config_.coordinate_bits, cut = std::max(0, b - 1 - kInverseIndexBits - kInverseOffsetBits);
    for (std::int64_t field = std::int64_t(1) << (b - 1 - cut); field < std::int64_t(1) << (b - cut); ++field) {
      for (const std::int64_t rest : {std::int64_t(0), (std::int64_t(1) << cut) - 1}) {
        const std::int64_t q = (field << cut) + rest;
        const InverseCoordinate<F> got = reciprocal_lookup<F>(from_raw<typename F::Coordinate>(q));
        const double y = std::ldexp(double(raw(got.inverse)), int(raw(got.shift)) - kInverseFraction);
        const double error = std::fabs(y * std::ldexp(double(q), 1 - b) - 1);
        ++worst.compared;
        if (error > worst.error) worst.error = error, worst.q = q;
      }
    }
    return worst;
  }

 private:
  void activate() const { F::activate(config_, table_); }

  // The stamp of a pixel that shows the triangle there alone.
  static int lane_of(int x, int y) { return y % F::kLanesY * F::kLanesX + x % F::kLanesX; }
  static Scan<F> scan_of(int x, int y) {
    Scan<F> scan{};
    scan.x = from_raw<typename F::X>(x / F::kLanesX);
    scan.y = from_raw<typename F::Y>(y / F::kLanesY);
    scan.index[lane_of(x, y)] = from_raw<typename F::Index>(1);
    return scan;
  }
  static std::array<std::uint32_t, 3> colour_of(const Pixel<F>& p, int x, int y) {
    const int lane = lane_of(x, y);
    return {std::uint32_t(raw(p.r[lane])), std::uint32_t(raw(p.g[lane])), std::uint32_t(raw(p.b[lane]))};
  }

  int stretched(int colour, int bits) const { return int(stretched_colour(config_, colour, bits)); }
  Normals<F> stretched_normals(const ref::SnappedTriangle& in) const {
    RawNormals normals;
    for (int v = 0; v < 3; ++v) {
      for (int c = 0; c < 3; ++c)
        normals.normals[v][c] = stretched(in.rgb[v][c], normal_plane_bits(config_)) - (1 << config_.normal_bits);
    }
    return normals_record<F>(normals, 1, false);
  }
  RawCoordinates stretched_coordinates(const ref::SnappedTriangle& in) const {
    RawCoordinates out;
    for (int v = 0; v < 3; ++v) {
      out.s[v] = stretched(in.rgb[v][0], config_.coordinate_bits);
      out.t[v] = stretched(in.rgb[v][1], config_.coordinate_bits);
      if (F::kPerspective) out.q[v] = stretched(in.rgb[v][2], config_.coordinate_bits);
    }
    return out;
  }
  RawMotionVectors stretched_motion(const ref::SnappedTriangle& in) const {
    const RawCoordinates places = stretched_coordinates(in);
    RawMotionVectors out;
    out.face = 1;
    for (RawKeyPlaces& key : out.key) {
      key.there = true;
      key.s = places.s, key.t = places.t, key.q = places.q;
      for (int c = 0; c < 3 && F::kRelights; ++c) {
        for (int v = 0; v < 3; ++v) key.difference[c][v] = stretched(in.rgb[v][c], difference_bits(config_));
      }
    }
    return out;
  }

  // The colours come with the attributes, or as those of a triangle that was lit.
  void set_colours(const Triangle<F>& in) {
    // Without a deferred shader the setup sends them itself.
    s_.attributes.write(attributes_);
    if (F::kHasLighting) {
      Colours<F> colours{};
      for (int v = 0; v < 3; ++v) colours.r[v] = in.r[v], colours.g[v] = in.g[v], colours.b[v] = in.b[v];
      s_.colours.write(colours);
      shade_setup(s_.attributes, s_.colours, s_.planes);
    } else {
      shade_setup(s_.attributes, s_.planes);
    }
    store_planes(s_.planes, b_->shading);
  }
  void set_normals(const Normals<F>& normals) {
    s_.attributes.write(attributes_);
    s_.normals.write(normals);
    phong_setup(s_.attributes, s_.normals, s_.normal_planes);
    store_planes(s_.normal_planes, b_->normals);
  }
  void set_coordinates(const TextureCoordinates<F>& coordinates) {
    s_.attributes.write(attributes_);
    words_.write(coordinates);
    texture_setup(s_.attributes, words_, places_);
    store_planes(places_, b_->coordinates);
  }
  void set_motion(const MotionVectors<F>& vectors) {
    s_.attributes.write(attributes_);
    s_.motion_vectors.write(vectors);
    motion_setup(s_.attributes, s_.motion_vectors, moves_);
    store_planes(moves_, b_->motion);
  }

  // What the shaders round at a pixel before anything is made of it.
  void add_planes(ProbedPixel& out) const {
    if (F::kPhong) {
      const NormalPlanes<F>& n = b_->normals.planes[0];
      for (int c = 0; c < 3; ++c) {
        const auto component = normal_component<F>(n.start[c], n.dx[c], n.dy[c], out.x, out.y);
        out.colour[c] = std::uint32_t(raw(component) + (1 << config_.normal_bits));
      }
    }
    if (F::kHasTexture) add_coordinates(b_->coordinates.planes[0], out);
    if (!F::kHasMotion) return;
    const KeyPlanes<F>& key = b_->motion.planes[0].key[0];
    add_coordinates(key, out);
    for (int c = 0; c < 3 && F::kRelights; ++c) {
      const typename F::Difference at = plane_at<F>(key.colour[c], key.colour_dx[c], key.colour_dy[c], out.x, out.y);
      out.difference[c] = std::uint32_t(raw(at));
    }
  }
  template <class Coordinates>
  void add_coordinates(const Coordinates& planes, ProbedPixel& out) const {
    for (int c = 0; c < (F::kPerspective ? 3 : 2); ++c) {
      const typename F::Coordinate at = plane_at<F>(planes.start[c], planes.dx[c], planes.dy[c], out.x, out.y);
      out.coordinate[c] = std::uint32_t(raw(at));
    }
  }

  template <class Coordinates>
  Planes3 plain(const Coordinates& planes) const {
    Planes3 out{};
    for (int c = 0; c < (F::kPerspective ? 3 : 2); ++c)
      out[c] = plain_plane(planes.start[c], planes.dx[c], planes.dy[c]);
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
  Attributes<F> attributes_{};
  std::unique_ptr<ProbeBuffers<F>> b_;
  Streams<F> s_;
  Stream<TriangleDepth<F>> depth_plane_;  // to no one
  Stream<TextureCoordinates<F>> words_;
  Stream<TexturePlanes<F>> places_;
  Stream<MotionPlanes<F>> moves_;
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
