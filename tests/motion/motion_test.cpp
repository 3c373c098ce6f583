// SPDX-License-Identifier: Apache-2.0
// Motion between key frames against closed formulas, and against rays that are cast pixel by pixel.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "ref/error.hpp"
#include "ref/motion/motion_field.hpp"
#include "ref/raster/raster.hpp"

namespace halfspace::ref {
namespace {

constexpr double kPi = glm::pi<double>();
const RasterFormat kFormat{"motion", 320, 240, 16384, 14, 8, 24};
const View kView{160, 120, kFormat.range_bits, kFormat.subpixel_bits};
constexpr double kFrame = 1 / 30.0, kInterval = 5 * kFrame;  // seconds; a key in five

// A scene at two keys and between them.
struct Times {
  Scene first, second, between;
  double a;
  Between follow(MotionMethod method) const { return ref::follow(method, first, second, between, a, kView); }
};
Times times(const std::string& name, double start, double a) {
  return {load_scene(name, start), load_scene(name, start + kInterval), load_scene(name, start + a * kInterval), a};
}

void expect_same(const std::array<Vertex, 3>& a, const std::array<Vertex, 3>& b) {
  for (int v = 0; v < 3; ++v) EXPECT_TRUE(a[v].x == b[v].x && a[v].y == b[v].y && a[v].z == b[v].z) << "vertex " << v;
}
void expect_same(const TriangleList& a, const TriangleList& b) {
  ASSERT_EQ(a.face, b.face);
  for (std::size_t k = 0; k < a.triangles.size(); ++k) expect_same(a.triangles[k], b.triangles[k]);
}

// --- animated scenes ---

std::vector<glm::dmat4> placed(const Scene& scene) {
  std::vector<glm::dmat4> matrices;
  for (const Instance& instance : scene.instances) matrices.push_back(instance.to_world);
  return matrices;
}

TEST(AnimatedScenes, MoveAndStayInTheFrame) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    const Scene start = load_scene(name);
    ASSERT_GE(start.duration, 1);
    EXPECT_EQ(placed(load_scene(name, 0.4)) == placed(start), name == "cube_zoom");
    EXPECT_EQ(placed(load_scene(name, -1)), placed(start));
    EXPECT_EQ(placed(load_scene(name, start.duration + 1)), placed(load_scene(name, start.duration)));
    const Viewpoint eye = viewpoint(start, 4 / 3.0);
    std::size_t most = 0, least = 1000000;
    for (int frame = 0; frame <= start.duration / kFrame; ++frame) {
      const Scene scene = load_scene(name, frame * kFrame);
      const Geometry geometry(scene, kView);  // throws when nothing is seen
      most = std::max(most, geometry.origins().size()), least = std::min(least, geometry.origins().size());
      const double moved = glm::distance(viewpoint(scene, 4 / 3.0).eye, eye.eye);
      if (name != "cube_zoom") {
        EXPECT_EQ(moved, 0);
      } else if (frame == 7) {
        EXPECT_GT(moved, 1);
      }
    }
    std::printf("%-14s %zu to %zu of %zu faces drawn\n", name.c_str(), least, most, FacePlaces(start, kView).faces());
  }
}

// Its castle stands; the drone takes off half a second after the start, its blades turn all the time.
TEST(AnimatedScenes, TheCourtStands) {
  const Scene start = load_scene("court");
  for (const auto& [seconds, moving] : {std::pair(0.4, 12), std::pair(1.0, 17)}) {
    const Scene now = load_scene("court", seconds);
    EXPECT_EQ(now.instances[0].to_world, start.instances[0].to_world);
    int moved = 0;
    for (std::size_t n = 0; n < start.instances.size(); ++n)
      moved += now.instances[n].to_world != start.instances[n].to_world;
    EXPECT_EQ(moved, moving) << seconds;
  }
}

TEST(AnimatedScenes, FightersHaveManyPartsAndOutwardNormals) {
  for (const char* name : {"drone", "jet"}) {
    SCOPED_TRACE(name);
    const Scene scene = load_scene(name, 0.5);
    EXPECT_GE(scene.instances.size(), 13u);
    EXPECT_GE(FacePlaces(scene, kView).faces(), 3000u);
    for (const Mesh& mesh : scene.meshes) {
      for (const auto& t : mesh.triangles) {
        const auto& p = mesh.positions;
        const glm::dvec3 across = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
        ASSERT_GT(glm::length(across), 1e-9) << mesh.name;
        for (const std::uint32_t i : t) {
          EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 1e-9);
          ASSERT_GT(glm::dot(glm::normalize(across), mesh.normals[i]), 0.1) << mesh.name;
        }
      }
    }
  }
}

// --- positions ---

TEST(Follow, KeysAreMetToTheBit) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    for (const int key : {0, 1}) {
      const Times t = times(name, 0.3, key);
      const Scene& at_key = key == 0 ? t.first : t.second;
      const Geometry geometry(at_key, kView);
      for (const MotionMethod method : {MotionMethod::kExact, MotionMethod::kStraight}) {
        // Where they meet, the time may be off by its last place: the scene between is the key itself.
        const Between between = follow(method, t.first, t.second, at_key, key, kView);
        EXPECT_EQ(between.fallen_back, 0u);
        expect_same(between.list, geometry.positions());
        for (std::size_t k = 0; k < between.traces.size(); ++k) {
          const auto exact = vectors(between, k)[key].value();
          const auto fixed = fixed_vectors(between, k, kView.subpixel_bits, {9, 4})[key].value();
          EXPECT_EQ(exact, (std::array<glm::dvec2, 3>{}));
          EXPECT_EQ(fixed, (std::array<FixedVector, 3>{}));
        }
      }
    }
  }
}

TEST(Follow, ExactIsTheFrameOfThatTimeAndStraightIsNot) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    const Times t = times(name, 0.3, 0.4);
    const Between exact = t.follow(MotionMethod::kExact), straight = t.follow(MotionMethod::kStraight);
    expect_same(exact.list, Geometry(t.between, kView).positions());
    const FacePlaces here(t.between, kView), from(t.first, kView), to(t.second, kView);
    double off = 0;
    for (std::size_t k = 0; k < straight.traces.size(); ++k) {
      const auto places = here.screen(straight.traces[k].face).value(),
                 a = from.screen(straight.traces[k].face).value(), b = to.screen(straight.traces[k].face).value();
      for (int v = 0; v < 3; ++v) {
        const Vertex& at = straight.list.triangles[k][v];
        EXPECT_NEAR(at.x, a[v].x + 0.4 * (b[v].x - a[v].x), 1e-9);
        EXPECT_NEAR(at.y, a[v].y + 0.4 * (b[v].y - a[v].y), 1e-9);
        EXPECT_NEAR(at.z, a[v].z + 0.4 * (b[v].z - a[v].z), 1e-12);
        off = std::max(off, std::hypot(at.x - places[v].x, at.y - places[v].y));
      }
    }
    EXPECT_GT(off, 1e-4);
    std::printf("%-14s straight lines off by up to %.3f pixels\n", name.c_str(), off);
  }
}

// --- closed formulas ---

Camera camera_at_origin() {
  Camera camera;
  camera.half_height = 0.5, camera.near = 1, camera.far = 100;
  return camera;
}

// The picture of a point by similar triangles.
glm::dvec2 seen_at(const glm::dvec3& p) {
  const double scale = kView.height / 2.0 / 0.5;
  return {kView.width / 2.0 + scale * p.x / -p.z, kView.height / 2.0 - scale * p.y / -p.z};
}

// By Rodrigues.
glm::dvec3 rotated(const glm::dvec3& p, const glm::dvec3& axis, double angle) {
  return p * std::cos(angle) + glm::cross(axis, p) * std::sin(angle) + axis * glm::dot(axis, p) * (1 - std::cos(angle));
}

TEST(Vectors, RotationInSpace) {
  const glm::dvec3 axis = glm::normalize(glm::dvec3(1, 2, -0.5)), centre(0.4, -0.2, -6);
  const double angle[3] = {0.2, 0.9, 0.5};  // keys, between
  const auto at = [&](double a) {
    Scene scene = load_scene("cube");
    scene.camera = camera_at_origin();
    scene.instances[0].to_world = glm::rotate(glm::translate(glm::dmat4(1), centre), a, axis);
    return scene;
  };
  const Times t{at(angle[0]), at(angle[1]), at(angle[2]), 3 / 7.0};
  const Between between = t.follow(MotionMethod::kExact);
  const Geometry geometry(t.between, kView);
  ASSERT_GE(between.traces.size(), 4u);
  double longest = 0;
  for (std::size_t k = 0; k < between.traces.size(); ++k) {
    const auto to_key = vectors(between, k);
    for (int v = 0; v < 3; ++v) {
      const glm::dvec3 p = t.between.meshes[0].positions[geometry.origins()[k].corner[v]];
      const glm::dvec2 here = seen_at(centre + rotated(p, axis, angle[2]));
      for (int key = 0; key < kKeys; ++key) {
        const glm::dvec2 expected = seen_at(centre + rotated(p, axis, angle[key])) - here;
        EXPECT_LT(glm::distance((*to_key[key])[v], expected), 1e-10);
        longest = std::max(longest, glm::length(expected));
      }
    }
  }
  EXPECT_GT(longest, 10);
}

// Around the line of sight, without perspective: everywhere (R − 1)(p − c), which planes have exactly.
TEST(Vectors, RotationOfThePicture) {
  const auto at = [](double angle) {
    Scene scene = load_scene("castle");
    Camera camera;
    camera.position = {0, 0, 100}, camera.orthographic = true, camera.half_height = 30;
    scene.camera = camera;
    scene.instances[0].to_world = glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 0, 1)) * scene.instances[0].to_world;
    return scene;
  };
  const double angle[3] = {-0.1, 0.3, 0.05};
  const Times t{at(angle[0]), at(angle[1]), at(angle[2]), 0.375};
  const Between between = t.follow(MotionMethod::kExact);
  for (const VectorMapping mapping : {VectorMapping::kLinear, VectorMapping::kPerspective}) {
    const MotionField field = motion_field(between, kFormat, mapping);
    // What a plane over the snapped triangle is taken at is off by up to half a sub-pixel, an axis, times the turn.
    const double bound = mapping == VectorMapping::kLinear ? 0.25 * std::sqrt(2) / 512 : 1e-9;
    int pixels = 0;
    for (std::size_t i = 0; i < field.face.size(); ++i) {
      if (field.face[i] == 0) continue;
      const glm::dvec2 arm(i % 160 + 0.5 - 80, i / 160 + 0.5 - 60);
      for (int key = 0; key < kKeys; ++key) {
        const double turn = angle[2] - angle[key];  // rows go downward
        const glm::dvec2 expected(arm.x * std::cos(turn) - arm.y * std::sin(turn),
                                  arm.x * std::sin(turn) + arm.y * std::cos(turn));
        ASSERT_LT(glm::distance(field.to_key[key][i].value(), expected - arm), bound);
      }
      ++pixels;
    }
    EXPECT_GT(pixels, 2000);
  }
}

// --- the field, pixel by pixel ---

struct FaceOf {
  const Instance* instance;
  std::array<std::uint32_t, 3> corner;
};
std::vector<FaceOf> faces_of(const Scene& scene) {
  std::vector<FaceOf> faces;
  for (const Instance& instance : scene.instances) {
    for (const auto& t : scene.meshes[instance.mesh].triangles) faces.push_back({&instance, t});
  }
  return faces;
}
glm::dvec3 world(const Scene& scene, const FaceOf& face, int v) {
  return face.instance->to_world * glm::dvec4(scene.meshes[face.instance->mesh].positions[face.corner[v]], 1);
}

// A pixel's ray meets the plane of its face; that point of the surface, moved to the key and projected. None behind its
// near plane.
class Rays {
 public:
  explicit Rays(const Times& t)
      : t_(t),
        scenes_{&t.first, &t.second},
        faces_(faces_of(t.between)),
        key_faces_{faces_of(t.first), faces_of(t.second)} {
    const double aspect = double(kView.width) / kView.height;
    from_clip_ = glm::inverse(viewpoint(t.between, aspect).to_clip);
    for (int key = 0; key < kKeys; ++key) to_clip_[key] = viewpoint(*scenes_[key], aspect).to_clip;
  }
  std::optional<glm::dvec2> vector(std::uint32_t face, std::size_t pixel, int key) const {
    const glm::dvec2 centre(pixel % kView.width + 0.5, pixel / kView.width + 0.5);
    const glm::dvec2 ndc(2 * centre.x / kView.width - 1, 1 - 2 * centre.y / kView.height);
    const glm::dvec4 near = from_clip_ * glm::dvec4(ndc, 0, 1), far = from_clip_ * glm::dvec4(ndc, 1, 1);
    const glm::dvec3 start = glm::dvec3(near) / near.w, way = glm::dvec3(far) / far.w - start;
    const FaceOf &here = faces_[face - 1], &there = key_faces_[key][face - 1];
    const glm::dvec3 p = world(t_.between, here, 0);
    const glm::dvec3 uv =
        glm::inverse(glm::dmat3(world(t_.between, here, 1) - p, world(t_.between, here, 2) - p, -way)) * (start - p);
    const glm::dvec3 q = world(*scenes_[key], there, 0);
    const glm::dvec3 moved =
        q + uv.x * (world(*scenes_[key], there, 1) - q) + uv.y * (world(*scenes_[key], there, 2) - q);
    const glm::dvec4 clip = to_clip_[key] * glm::dvec4(moved, 1);
    if (clip.z < -1e-6 * clip.w || clip.w <= 0) return std::nullopt;
    return glm::dvec2(kView.width * (clip.x / clip.w + 1) / 2, kView.height * (1 - clip.y / clip.w) / 2) - centre;
  }

 private:
  const Times& t_;
  OfKeys<const Scene*> scenes_;
  std::vector<FaceOf> faces_;
  OfKeys<std::vector<FaceOf>> key_faces_;
  glm::dmat4 from_clip_;
  OfKeys<glm::dmat4> to_clip_;
};

struct Seen {
  double perspective = 0, linear = 0;  // largest distance from the ray's vector, pixels
  int vectors = 0, absent = 0;         // of the perspective-correct field
};
Seen compare_with_rays(const Times& t) {
  const Between between = t.follow(MotionMethod::kExact);
  const Frame frame = render(snap(Geometry(t.between, kView).positions(), kFormat));
  const MotionField exact = motion_field(between, kFormat, VectorMapping::kPerspective),
                    linear = motion_field(between, kFormat, VectorMapping::kLinear);
  EXPECT_EQ(exact.triangle, frame.index);
  const Rays rays(t);
  Seen seen;
  for (std::size_t i = 0; i < exact.face.size(); ++i) {
    for (int key = 0; key < kKeys; ++key) {
      const auto& vector = exact.to_key[key][i];
      if (exact.face[i] == 0) {
        EXPECT_FALSE(vector || linear.to_key[key][i]);
        continue;
      }
      const auto expected = rays.vector(exact.face[i], i, key);
      EXPECT_EQ(bool(vector), bool(expected)) << "pixel " << i;
      if (!vector || !expected) {
        ++seen.absent;
        continue;
      }
      ++seen.vectors;
      seen.perspective = std::max(seen.perspective, glm::distance(*vector, *expected));
      if (linear.to_key[key][i]) seen.linear = std::max(seen.linear, glm::distance(*linear.to_key[key][i], *expected));
    }
  }
  return seen;
}

TEST(Field, AgreesWithRays) {
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    Seen worst;
    for (const double start : {0.1, 0.6, 1.1}) {
      const Seen seen = compare_with_rays(times(name, start, 0.4));
      EXPECT_LT(seen.perspective, 1e-6);
      EXPECT_GT(seen.vectors, 500);
      EXPECT_EQ(seen.absent, 0);
      worst.perspective = std::max(worst.perspective, seen.perspective),
      worst.linear = std::max(worst.linear, seen.linear);
      worst.vectors += seen.vectors;
    }
    std::printf("%-14s %7d vectors: perspective-correct within %.1e pixels, planes within %.4f\n", name.c_str(),
                worst.vectors, worst.perspective, worst.linear);
  }
}

// Snapping moves either end by half a sub-pixel at most, the vertex's vector is rounded once, the pixel's once more.
TEST(Field, FixedWithinItsBound) {
  const VectorFormat vector_format{9, 4};
  const double bound = std::ldexp(1, -kFormat.subpixel_bits) + std::ldexp(1, -vector_format.fraction_bits);
  for (const std::string& name : animated_scene_names()) {
    SCOPED_TRACE(name);
    const Between between = times(name, 0.6, 0.4).follow(MotionMethod::kExact);
    const MotionField linear = motion_field(between, kFormat, VectorMapping::kLinear);
    const FixedMotionField fixed = motion_field(between, kFormat, vector_format);
    EXPECT_EQ(fixed.triangle, linear.triangle);
    double off = 0;
    for (std::size_t i = 0; i < fixed.face.size(); ++i) {
      for (int key = 0; fixed.face[i] != 0 && key < kKeys; ++key) {
        for (int axis = 0; axis < 2; ++axis)
          off = std::max(
              off, std::abs(std::ldexp(fixed.to_key[key][i].value()[axis], -4) - linear.to_key[key][i].value()[axis]));
      }
    }
    EXPECT_LE(off, bound);
    EXPECT_GT(off, bound / 4);
    std::printf("%-14s s%d.%d off by %.4f pixels of %.4f\n", name.c_str(), vector_format.range_bits,
                vector_format.fraction_bits, off, bound);
  }
}

// --- what happens at edges ---

// One moving triangle, face 1, and a small far one that stands still, face 2; the camera at the origin.
Scene one_triangle(const std::array<glm::dvec3, 3>& corners, bool two_sided = false) {
  Scene scene;
  scene.name = "one triangle";
  scene.materials.resize(1);
  scene.materials[0].two_sided = two_sided;
  const std::array<glm::dvec3, 3> mark{{{-30, 20, -50}, {-25, 20, -50}, {-30, 24, -50}}};
  for (const auto& t : {corners, mark}) {
    scene.meshes.push_back(
        {"triangle", {t.begin(), t.end()}, std::vector<glm::dvec3>(3, {0, 0, 1}), {}, {}, {{0, 1, 2}}, 0});
    scene.instances.push_back({int(scene.meshes.size()) - 1, glm::dmat4(1)});
  }
  scene.camera = camera_at_origin();
  return scene;
}
const std::array<glm::dvec3, 3> kTriangle{{{-1, -1, -5}, {1, -1, -6}, {0, 1, -5}}};
std::array<glm::dvec3, 3> moved(const glm::dvec3& by) {
  return {kTriangle[0] + by, kTriangle[1] + by, kTriangle[2] + by};
}
Times moving(const glm::dvec3& from, const glm::dvec3& to, double a) {
  return {one_triangle(moved(from)), one_triangle(moved(to)), one_triangle(moved(glm::mix(from, to, a))), a};
}
Standing standing(const Scene& scene) { return FacePlaces(scene, kView).standing(1); }

struct Count {
  int pixels = 0;
  OfKeys<int> with{}, inside{};  // a vector; one that leads into the frame
};
Count count(const MotionField& field) {
  Count count;
  for (std::size_t i = 0; i < field.face.size(); ++i) {
    if (field.face[i] != 1) continue;
    ++count.pixels;
    for (int key = 0; key < kKeys; ++key) {
      if (!field.to_key[key][i]) continue;
      ++count.with[key];
      const glm::dvec2 place = *field.to_key[key][i] + glm::dvec2(i % kView.width + 0.5, i / kView.width + 0.5);
      count.inside[key] += place.x >= 0 && place.x < kView.width && place.y >= 0 && place.y < kView.height;
    }
  }
  return count;
}
bool shows_face(const Scene& scene) {
  const Geometry geometry(scene, kView);
  const Frame frame = render(snap(geometry.positions(), kFormat));
  for (const std::uint32_t k : frame.index) {
    if (k != 0 && geometry.positions().face[k - 1] == 1) return true;
  }
  return false;
}

// Vectors lead to it all the same, and out of the key's frame.
TEST(Edges, EntersAndLeaves) {
  const Times enters = moving({-6, 0, 0}, {0, 0, 0}, 0.75);
  EXPECT_EQ(standing(enters.first), Standing::kOutside);
  EXPECT_EQ(standing(enters.second), Standing::kDrawn);
  for (const MotionMethod method : {MotionMethod::kExact, MotionMethod::kStraight}) {
    const Count seen = count(motion_field(enters.follow(method), kFormat, VectorMapping::kPerspective));
    ASSERT_GT(seen.pixels, 500);
    EXPECT_EQ(seen.with, (OfKeys<int>{seen.pixels, seen.pixels}));
    EXPECT_EQ(seen.inside, (OfKeys<int>{0, seen.pixels}));
  }
  EXPECT_LT(compare_with_rays(enters).perspective, 1e-6);
  const Times leaves = moving({0, 0, 0}, {0, 6, 0}, 0.25);
  EXPECT_EQ(standing(leaves.second), Standing::kOutside);
  const Count seen = count(motion_field(leaves.follow(MotionMethod::kExact), kFormat, VectorMapping::kPerspective));
  ASSERT_GT(seen.pixels, 500);
  EXPECT_EQ(seen.inside, (OfKeys<int>{seen.pixels, 0}));
}

// A vector beyond the format is refused, for its key and its triangle alone.
TEST(Edges, MovesByMoreThanTheFormatHas) {
  const Between between = moving({-20, 0, 0}, {0, 0, 0}, 0.9).follow(MotionMethod::kExact);
  EXPECT_GT(-vectors(between, 0)[0].value()[0].x, kView.width);
  const auto narrow = fixed_vectors(between, 0, kFormat.subpixel_bits, {8, 4}),
             wide = fixed_vectors(between, 0, kFormat.subpixel_bits, {9, 4});
  EXPECT_FALSE(narrow[0]);
  EXPECT_TRUE(narrow[1]);
  ASSERT_TRUE(wide[0]);
  EXPECT_NEAR((*wide[0])[0][0] / 16.0, vectors(between, 0)[0].value()[0].x, 1 / 16.0);
  const FixedMotionField field = motion_field(between, kFormat, VectorFormat{8, 4});
  int pixels = 0;
  for (std::size_t i = 0; i < field.face.size(); ++i) {
    if (field.face[i] == 0) continue;
    EXPECT_EQ(bool(field.to_key[0][i]), field.face[i] == 2);
    EXPECT_TRUE(field.to_key[1][i]);
    pixels += field.face[i] == 1;
  }
  EXPECT_GT(pixels, 500);
}

// The ends of the range are the format's own: the lowest is in it, the highest is not.
TEST(Edges, RangeOfTheFormat) {
  Between between{};
  between.list.triangles = {{Vertex{8, 8, 0, 0, 0, 0}, Vertex{8, 8, 0, 0, 0, 0}, Vertex{8, 8, 0, 0, 0, 0}}};
  const auto at = [&](double place) {
    Trace trace{};
    trace.screen[0] = std::array<glm::dvec2, 3>{glm::dvec2(place, 8), glm::dvec2(8, 8), glm::dvec2(8, 8)};
    between.traces = {trace};
    return fixed_vectors(between, 0, 8, {4, 2})[0];
  };
  EXPECT_EQ(at(-8).value()[0], (FixedVector{-64, 0}));
  EXPECT_FALSE(at(-8.125 - 1 / 256.0));  // half up, −8.125 would be −64.5 steps, which is −64
  EXPECT_EQ(at(-8.125).value()[0], (FixedVector{-64, 0}));
  EXPECT_EQ(at(24 - 0.125 - 1 / 256.0).value()[0], (FixedVector{63, 0}));
  EXPECT_FALSE(at(24 - 0.125));
}

// No vertex's vector to the key, so no plane; in perspective the points that were before the near plane have theirs.
// Without a place on the screen at a key there is no straight line, and the face is at its exact place.
TEST(Edges, CrossesTheNearPlane) {
  const Times t = moving({0, 0, 4.5}, {0, 0, 0}, 0.5);
  EXPECT_EQ(standing(t.first), Standing::kCrossing);
  EXPECT_EQ(standing(t.between), Standing::kDrawn);
  const Between exact = t.follow(MotionMethod::kExact), straight = t.follow(MotionMethod::kStraight);
  EXPECT_FALSE(vectors(exact, 0)[0]);
  EXPECT_TRUE(vectors(exact, 0)[1]);
  const Count linear = count(motion_field(exact, kFormat, VectorMapping::kLinear)),
              perspective = count(motion_field(exact, kFormat, VectorMapping::kPerspective));
  ASSERT_GT(linear.pixels, 500);
  EXPECT_EQ(linear.with, (OfKeys<int>{0, linear.pixels}));
  EXPECT_GT(perspective.with[0], 0);
  EXPECT_LT(perspective.with[0], perspective.pixels);
  EXPECT_EQ(perspective.with[1], perspective.pixels);
  const Seen seen = compare_with_rays(t);
  EXPECT_LT(seen.perspective, 1e-6);
  EXPECT_GT(seen.absent, 0);
  EXPECT_EQ(straight.fallen_back, 1u);
  ASSERT_EQ(straight.list.face, exact.list.face);
  expect_same(straight.list.triangles[0], exact.list.triangles[0]);
  EXPECT_FALSE(straight.traces[0].straight);
  EXPECT_TRUE(straight.traces.back().straight);
}

TEST(Edges, BehindTheViewerAtAKey) {
  const Times t = moving({0, 0, 12}, {0, 0, 0}, 0.9);
  EXPECT_EQ(standing(t.first), Standing::kBehind);
  const Between exact = t.follow(MotionMethod::kExact);
  for (const VectorMapping mapping : {VectorMapping::kLinear, VectorMapping::kPerspective}) {
    const Count seen = count(motion_field(exact, kFormat, mapping));
    ASSERT_GT(seen.pixels, 500);
    EXPECT_EQ(seen.with, (OfKeys<int>{0, seen.pixels}));
  }
  EXPECT_EQ(t.follow(MotionMethod::kStraight).fallen_back, 1u);
}

// A floor through the near plane: vertices that clipping made follow their own point of the floor, and stay where
// nothing moves.
TEST(Edges, ClippedInBetween) {
  const auto floor = [](double x, double z) {
    Scene scene = one_triangle({{{-4 + x, -1, -20 + z}, {4 + x, -1, -20 + z}, {x, -1, 5 + z}}}, true);
    return scene;
  };
  for (int i = 0; i < 100; ++i) {  // some vertices are rounded to behind the near plane at the key
    const Scene here = floor(0.037 * i, -0.011 * i);
    ASSERT_EQ(standing(here), Standing::kCrossing);
    const Between stays = Times{here, here, here, 0.5}.follow(MotionMethod::kExact);
    ASSERT_GT(stays.traces.size(), 2u);
    for (std::size_t k = 0; k < stays.traces.size(); ++k) {
      const auto to_keys = vectors(stays, k);
      for (const auto& of_key : to_keys) {
        ASSERT_TRUE(of_key) << i;
        for (const glm::dvec2& vector : *of_key) EXPECT_LT(glm::length(vector), 1e-9);
      }
    }
  }
  const Times sideways{floor(-1, -1), floor(2, -2), floor(0.2, 0), 0.4};
  const Seen seen = compare_with_rays(sideways);
  EXPECT_LT(seen.perspective, 1e-6);
  EXPECT_GT(seen.vectors, 5000);
  EXPECT_EQ(seen.absent, 0);
  std::printf("floor through the near plane: perspective-correct within %.1e pixels, planes within %.4f\n",
              seen.perspective, seen.linear);
}

// Its place at the key is known, and the key's frame does not show it: the index there says so.
TEST(Edges, TurnsItsBackAtAKey) {
  const auto turned = [](double angle, bool two_sided) {
    Scene scene = one_triangle(kTriangle, two_sided);
    const glm::dmat4 there = glm::translate(glm::dmat4(1), glm::dvec3(0, 0, -5.5));
    scene.instances[0].to_world = there * glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 1, 0)) * glm::inverse(there);
    return scene;
  };
  const Times t{turned(2.2, false), turned(0, false), turned(0.66, false), 0.7};
  EXPECT_EQ(standing(t.first), Standing::kCulled);
  EXPECT_EQ(standing(turned(2.2, true)), Standing::kDrawn);
  EXPECT_FALSE(shows_face(t.first));
  EXPECT_TRUE(shows_face(t.second));
  EXPECT_TRUE(shows_face(turned(2.2, true)));
  const Count seen = count(motion_field(t.follow(MotionMethod::kExact), kFormat, VectorMapping::kPerspective));
  ASSERT_GT(seen.pixels, 300);
  EXPECT_EQ(seen.inside, (OfKeys<int>{seen.pixels, seen.pixels}));
  EXPECT_LT(compare_with_rays(t).perspective, 1e-6);
}

// Half a turn in the picture: straight lines all meet in the axis, and the face is gone; exact positions keep it.
TEST(Edges, SpinsByHalfATurn) {
  const auto spun = [](double angle) {
    Scene scene = one_triangle({{{-1, -1, -5}, {1, -1, -5}, {0, 1, -5}}});
    scene.instances[0].to_world = glm::rotate(glm::dmat4(1), angle, glm::dvec3(0, 0, 1));
    return scene;
  };
  const Times t{spun(0), spun(kPi), spun(kPi / 2), 0.5};
  EXPECT_EQ(count(motion_field(t.follow(MotionMethod::kStraight), kFormat, VectorMapping::kLinear)).pixels, 0);
  const Seen seen = compare_with_rays(t);
  EXPECT_GT(seen.vectors, 1000);
  EXPECT_LT(seen.perspective, 1e-6);
}

TEST(Edges, FacesThatChangeAreRefused) {
  const Times t = moving({0, 0, 0}, {1, 0, 0}, 0.5);
  Scene other = t.second;
  other.meshes[0].triangles.push_back({0, 2, 1});
  try {
    follow(MotionMethod::kExact, t.first, other, t.between, 0.5, kView);
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("one triangle: its instances or faces"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace halfspace::ref
