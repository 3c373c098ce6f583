// SPDX-License-Identifier: Apache-2.0
// Files of the formats that Assimp reads: what it leaves out, misreads or does not survive comes out right, or is said.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/pipeline/engine.hpp"
#include "tests/geometry/three_formats.hpp"
#include "tests/scene/refusal.hpp"

namespace halfspace::ref {
namespace {

using testing::TempDir;
const std::string kOther = HALFSPACE_SOURCE "/tests/scene/cases/other/",
                  kBad = HALFSPACE_SOURCE "/tests/scene/cases/bad/";

Scene textured(const std::string& path) { return load_scene(path, 0, {true}); }

bool has(const Scene& scene, const std::string& remark) {
  return std::find(scene.remarks.begin(), scene.remarks.end(), remark) != scene.remarks.end();
}

SnappedList snapped(const Scene& scene, int size = 64) {
  return snap(project(scene, {size, size, kMiddle.range_bits, kMiddle.subpixel_bits}), kMiddle);
}

// By the reference and by the kernels.
std::vector<Frame> both(const Scene& scene) {
  const SnappedList list = snapped(scene);
  return {render(list), model::make_engine("middle", 16)->render(list)};
}

const Mesh& only_mesh(const Scene& scene) {
  EXPECT_EQ(scene.instances.size(), 1u);
  return scene.meshes[scene.instances.at(0).mesh];
}

std::size_t triangles(const Scene& scene) {
  std::size_t count = 0;
  for (const Instance& instance : scene.instances) count += scene.meshes[instance.mesh].triangles.size();
  return count;
}

glm::dvec3 face_normal(const Mesh& mesh, const std::array<std::uint32_t, 3>& corner) {
  return glm::normalize(glm::cross(mesh.positions[corner[1]] - mesh.positions[corner[0]],
                                   mesh.positions[corner[2]] - mesh.positions[corner[0]]));
}

void expect_cube(const Scene& scene, const std::string& name) {
  EXPECT_EQ(triangles(scene), 12u) << name;
  for (const Instance& instance : scene.instances) {
    const Mesh& mesh = scene.meshes[instance.mesh];
    for (const auto& corner : mesh.triangles) {
      const glm::dvec3 normal = face_normal(mesh, corner);
      EXPECT_GT(glm::dot(normal, mesh.positions[corner[0]] + mesh.positions[corner[1]] + mesh.positions[corner[2]]), 0);
      for (const std::uint32_t i : corner) EXPECT_LT(glm::distance(mesh.normals[i], normal), 1e-6) << name;
    }
  }
}

TEST(OtherFormats, ByteOrderMarksArePassedOver) {
  const Scene red = load_scene(kOther + "bom_mtllib.obj");
  EXPECT_EQ(red.materials[only_mesh(red).material].diffuse, glm::dvec3(1, 0, 0));
  for (const Frame& frame : both(red)) {
    const auto& middle = frame.colour[32 * 64 + 32];
    EXPECT_GT(middle[0], 150);
    EXPECT_EQ(middle[1], 0);
  }
  EXPECT_EQ(triangles(load_scene(kOther + "obj_bom.obj")), 2u);
  const std::string mark = "\xEF\xBB\xBF",
                    facets =
                        "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
                        "endfacet\nendsolid\n";
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"mark.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
            "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
           {"mark.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"},
           {"mark.stl", facets}}) {
    const TemporaryFile file(name, mark + text);
    EXPECT_EQ(triangles(load_scene(file.path())), 1u) << name;
  }
}

TEST(OtherFormats, TextsOf16BitsAreRead) {
  for (const char* name : {"ASE/ThreeCubesGreen_UTF16BE.ASE", "ASE/ThreeCubesGreen_UTF16LE.ASE"})
    EXPECT_EQ(triangles(load_scene(HALFSPACE_TESTMODELS "/" + std::string(name))), 36u) << name;
  std::string wide = "\xFF\xFE";
  const std::u16string text = u"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n# \u00FC \U0001F34C\n";
  for (const char16_t c : text) wide += {char(c & 0xFF), char(c >> 8)};
  const TemporaryFile file("wide.obj", wide);
  EXPECT_EQ(triangles(load_scene(file.path())), 1u);
}

TEST(OtherFormats, CamerasOfLightWaveSeeTheirScene) {
  const Scene scene = load_scene(HALFSPACE_TESTMODELS "/LWS/move_x.lws");
  ASSERT_TRUE(scene.camera);
  EXPECT_EQ(scene.camera->forward, glm::dvec3(0, 0, -1));
  EXPECT_GT(covered(render(snapped(scene))), 100u);
}

// A sphere in LightWave, whose texture is laid by a sphere and has no coordinates.
TEST(OtherFormats, ProjectedTexturesGetCoordinates) {
  const Scene scene = textured(HALFSPACE_TESTMODELS "/LWO/LWO2/MappingModes/earth_spherical_y.lwo");
  EXPECT_EQ(only_mesh(scene).texture_coordinates.size(), only_mesh(scene).positions.size());
  double least = 1e9, most = -1e9;
  for (const glm::dvec2& uv : only_mesh(scene).texture_coordinates)
    least = std::min(least, uv.y), most = std::max(most, uv.y);
  EXPECT_LT(least, 0.1);
  EXPECT_GT(most, 0.9);
}

TEST(OtherFormats, LinesAndPointsAreLeftOutWithTheirCount) {
  const Scene scene = load_scene(kOther + "obj_two_vertices.obj");
  EXPECT_TRUE(has(scene, "1 line is left out"));
  for (const Frame& frame : both(scene)) EXPECT_GT(covered(frame), 500u);
  const TemporaryFile more("more.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\np 1\nf 1 2\nf 3\nf 1 2 3\n");
  const Scene both_kinds = load_scene(more.path());
  EXPECT_EQ(triangles(both_kinds), 1u);
  EXPECT_TRUE(has(both_kinds, "3 lines are left out"));
  EXPECT_TRUE(has(both_kinds, "2 points are left out"));
  const TemporaryFile none("none.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2 3\n");
  expect_in("there are no triangles in it", refusal([&] { load_scene(none.path()); }));
}

// 2 to each side in 64 columns: from -1 to 1 are 32.
TEST(OtherFormats, ColladaCamerasAreThoseOfTheFile) {
  const Scene scene = load_scene(kOther + "dae_ortho.dae");
  ASSERT_TRUE(scene.camera);
  EXPECT_TRUE(scene.camera->orthographic);
  EXPECT_EQ(scene.camera->near, 0.1);
  EXPECT_EQ(scene.camera->far, 100);
  for (const Frame& frame : both(scene)) {
    for (int y = 0; y < 64; ++y) {
      for (int x = 0; x < 64; ++x) {
        const bool inside = x >= 16 && x < 48 && y >= 16 && y < 48;
        ASSERT_EQ(frame.index[std::size_t(64 * y + x)] != 0, inside) << x << ' ' << y;
      }
    }
  }
  std::ifstream file(kOther + "dae_ortho.dae");
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const auto camera_with = [&](const std::string& optics) {
    std::string changed = text;
    const std::size_t first = changed.find("<orthographic>"), end = changed.find("</technique_common>", first);
    const TemporaryFile written("camera.dae", changed.replace(first, end - first, optics));
    return load_scene(written.path()).camera.value();
  };
  const Camera tall = camera_with(
      "<perspective><yfov>90</yfov><aspect_ratio>2</aspect_ratio><znear>1</znear>"
      "<zfar>9</zfar></perspective>");
  EXPECT_FALSE(tall.orthographic);
  EXPECT_NEAR(tall.half_height, 1, 1e-12);
  EXPECT_NEAR(tall.half_width, 2, 1e-12);
  EXPECT_EQ(tall.far, 9);
  const Camera wide = camera_with("<orthographic><ymag>3</ymag><aspect_ratio>2</aspect_ratio></orthographic>");
  EXPECT_TRUE(wide.orthographic);
  EXPECT_EQ(wide.half_height, 3);
  EXPECT_EQ(wide.half_width, 6);
}

TEST(OtherFormats, ListsOfIndicesAreNumbers) {
  const std::string sentence = refusal([] { load_scene(kBad + "dae_p_not_a_number.dae"); });
  expect_in(kBad + "dae_p_not_a_number.dae: ", sentence);
  expect_in("'x' in a list of indices <p>", sentence);
}

TEST(OtherFormats, ACubeIsACube) {
  const std::string off =
      "OFF\n8 6 0\n-1 -1 1\n1 -1 1\n-1 1 1\n1 1 1\n-1 1 -1\n1 1 -1\n-1 -1 -1\n1 -1 -1\n"
      "4 0 1 3 2\n4 2 3 5 4\n4 4 5 7 6\n4 6 7 1 0\n4 1 7 5 3\n4 6 0 2 4\n";
  std::string amf = "<?xml version=\"1.0\"?><amf unit=\"inch\"><object id=\"0\"><mesh><vertices>";
  for (const int corner : {4, 5, 6, 7, 2, 3, 0, 1}) {
    const auto axis = [&](const char* name, int bit) {
      return std::string("<") + name + ">" + (corner & bit ? "1" : "-1") + "</" + name + ">";
    };
    amf += "<vertex><coordinates>" + axis("x", 1) + axis("y", 2) + axis("z", 4) + "</coordinates></vertex>";
  }
  amf += "</vertices><volume>";
  for (const std::array<int, 3> face : {std::array<int, 3>{0, 1, 3},
                                        {0, 3, 2},
                                        {2, 3, 5},
                                        {2, 5, 4},
                                        {4, 5, 7},
                                        {4, 7, 6},
                                        {6, 7, 1},
                                        {6, 1, 0},
                                        {1, 7, 5},
                                        {1, 5, 3},
                                        {6, 0, 2},
                                        {6, 2, 4}}) {
    amf += "<triangle>";
    for (int v = 0; v < 3; ++v) {
      const std::string name = "v" + std::to_string(v + 1);
      amf += "<" + name + ">" + std::to_string(face[std::size_t(v)]) + "</" + name + ">";
    }
    amf += "</triangle>";
  }
  amf += "</volume></mesh></object></amf>";
  const TemporaryFile as_off("cube.off", off), as_amf("cube.amf", amf);
  const Scene cube = load_scene(kBad + "cube_off.obj");
  const Frame expected = render(snapped(cube));
  for (const std::string& path : {kBad + "cube_off.obj", kBad + "cube.ply", as_off.path()}) {
    Scene scene = load_scene(path);
    expect_cube(scene, path);
    scene.materials = cube.materials;  // importers have greys of their own
    EXPECT_TRUE(render(snapped(scene)).colour == expected.colour) << path;
  }
  const Scene of_amf = load_scene(as_amf.path());
  expect_cube(of_amf, "AMF");
  EXPECT_TRUE(only_mesh(of_amf).colours.empty()) << "Assimp's colours of a mesh that has none are zeros";
  const Scene of_3mf = load_scene(HALFSPACE_TESTMODELS "/3MF/box.3mf");
  EXPECT_EQ(triangles(of_3mf), 12u);
  for (const auto& corner : only_mesh(of_3mf).triangles) {
    const Mesh& mesh = only_mesh(of_3mf);
    for (const std::uint32_t i : corner)
      EXPECT_LT(glm::distance(mesh.normals[i], face_normal(mesh, corner)), 1e-6) << "3MF";
  }
}

TEST(OtherFormats, EmissionIsFactorTimesMap) {
  const Scene black = load_scene(kOther + "ke.obj");
  EXPECT_EQ(black.materials[only_mesh(black).material].emission, glm::dvec3(0));
  EXPECT_TRUE(black.remarks.empty());
  EXPECT_EQ(textured(kOther + "ke.obj").materials[only_mesh(black).material].emission, glm::dvec3(0));
  const TemporaryFile mtl("glow.mtl", "newmtl a\nKd 1 0 0\nKe 1 1 0.5\nmap_Ke not there.png\n"),
      obj("glow.obj", "mtllib halfspace_ref_glow.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
  EXPECT_TRUE(has(load_scene(obj.path()), "emission by a picture that is not there, or cannot be read, is left out"));
  expect_in("'not there.png' is not there", refusal([&] { textured(obj.path()); }));
}

TEST(OtherFormats, MapsLieAsTheLibrarySays) {
  const auto last = [](const Scene& scene) {
    glm::dvec2 most(-1e9);
    for (const glm::dvec2& uv : only_mesh(scene).texture_coordinates) most = glm::max(most, uv);
    return most;
  };
  EXPECT_EQ(last(textured(kOther + "mtl_scale.obj")), glm::dvec2(2, 2));
  const std::string picture = kOther + "my tex.png";
  const TemporaryFile obj("map.obj",
                          "mtllib halfspace_ref_map.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                          "usemtl a\nf 1/1 2/2 3/3\n");
  const struct {
    const char* options;
    glm::dvec2 last;
    bool is_said;
  } lines[] = {{"", {1, 1}, false},
               {"-s 3 2", {3, 2}, false},
               {"-s 2", {2, 1}, false},
               {"-o 0.5 0.25 0", {1.5, 1.25}, false},
               {"-clamp on -s 2 2 1", {2, 2}, true},
               {"-clamp on", {1, 1}, false},
               {"-blendu off -mm 0 1 -o 1", {2, 1}, false}};
  std::filesystem::copy_file(picture, TempDir() + "my tex.png", std::filesystem::copy_options::overwrite_existing);
  for (const auto& [options, expected, is_said] : lines) {
    const TemporaryFile mtl("map.mtl", std::string("newmtl a\nmap_Kd ") + options + " my tex.png  \n");
    const Scene scene = textured(obj.path());
    EXPECT_EQ(last(scene), expected) << options;
    EXPECT_EQ(scene.textures.size(), 1u);
    EXPECT_EQ(has(scene, "textures that clamp or mirror at their edges are drawn as repeated"), is_said) << options;
  }
  const TemporaryFile mtl("map.mtl",
                          "newmtl a\nd 0.5\nmap_Kd my tex.png\nmap_Ks my tex.png\nmap_Bump a.png\nmap_d b.png\n");
  const Scene scene = textured(obj.path());
  for (const char* remark :
       {"transparent materials are drawn opaque", "bump maps are left out", "opacity maps are left out"})
    EXPECT_TRUE(has(scene, remark)) << remark;
  const TemporaryFile capitals("map.mtl", "newmtl a\nmap_Kd C:\\pictures\\MY TEX.PNG\n");
  EXPECT_EQ(textured(obj.path()).textures.size(), 1u);
  std::filesystem::remove(TempDir() + "my tex.png");
}

// Assimp takes a line of libraries for one name, with the spaces behind it.
TEST(OtherFormats, LinesOfMaterialLibrariesNameFiles) {
  const TemporaryFile a("a.mtl", "newmtl a\nKd 1 0 0\n"), b("b.mtl", "newmtl b b\nKd 0 1 0\n");
  const std::string face = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl b b \nf 1 2 3\n";
  for (const char* line : {"mtllib halfspace_ref_b.mtl  \n", "mtllib halfspace_ref_a.mtl halfspace_ref_b.mtl\n"}) {
    const TemporaryFile obj("libraries.obj", line + face);
    const Scene scene = load_scene(obj.path());
    EXPECT_EQ(scene.materials[only_mesh(scene).material].diffuse, glm::dvec3(0, 1, 0)) << line;
    EXPECT_TRUE(scene.remarks.empty()) << line;
  }
  const TemporaryFile obj("libraries.obj", "mtllib halfspace_ref_a.mtl\n" + face);
  EXPECT_TRUE(has(load_scene(obj.path()), "1 material is in no library, and is drawn grey"));
}

TEST(OtherFormats, MaterialLibrariesThatAreNotThereAreSaid) {
  const TemporaryFile obj("grey.obj", "mtllib no such.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
  const Scene scene = load_scene(obj.path());
  ASSERT_EQ(scene.remarks.size(), 1u);
  expect_in("no such.mtl' is not there", scene.remarks[0]);
}

// A pole of 1 x 1 metre at 5 412 345 metres: steps of 0.5 in float32.
TEST(OtherFormats, SurveyCoordinatesAreShiftedOrSaid) {
  const Scene pole = load_scene(kOther + "pole_utm.obj");
  EXPECT_TRUE(pole.remarks.empty());
  const Instance& instance = pole.instances.at(0);
  for (const glm::dvec3& position : pole.meshes[instance.mesh].positions) {
    const glm::dvec3 world(instance.to_world * glm::dvec4(position, 1));
    const double radius = std::hypot(world.x - 500000.3, world.z - 5412345.7);
    EXPECT_TRUE(radius < 1e-3 || std::abs(radius - 0.5) < 1e-3) << radius;
  }
  const TemporaryFile stl("far.stl",
                          "solid\nfacet normal 0 0 1\nouter loop\nvertex 5000000 0 0\nvertex 5000001 0 0\n"
                          "vertex 5000000 1 0\nendloop\nendfacet\nendsolid\n");
  const Scene far = load_scene(stl.path());
  ASSERT_EQ(far.remarks.size(), 1u);
  expect_in("1 mesh lies so far from the origin", far.remarks[0]);
  const TemporaryFile odd("odd.obj", "v 5000000 0 0\nv +5000001 0 0\nv 5000000 1 0 1\nf 1 2 3\n");
  EXPECT_EQ(load_scene(odd.path()).remarks.size(), 1u);
}

TEST(OtherFormats, FacesOfAPlyHaveTheCornersThatTheySay) {
  for (const auto& [name, part] : std::vector<std::pair<std::string, std::string>>{
           {"ply_a.ply", "face 0 (line 13) says that 5 numbers follow, and has 3"},
           {"ply_g.ply", "face 0 (line 13) says that 255 numbers follow, and has 3"},
           {"ply_h.ply", "face 0 (line 13) has the index 0.5, and there are 3 vertices"},
           {"plylist1g.ply", "face 0 says that 1073741823 numbers follow, and the file ends before"}}) {
    const std::string sentence = refusal([&, file = kBad + name] { load_scene(file); });
    expect_in(kBad + name + ": ", sentence);
    expect_in(part, sentence);
  }
  const Scene scene = load_scene(kBad + "ply_good_and_empty.ply");
  EXPECT_EQ(triangles(scene), 1u);
  EXPECT_TRUE(has(scene, "1 face without corners is left out"));
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_index\nend_header\n0 0 0\n1 0 0\n";
  for (const auto& [rest, part] : std::vector<std::pair<std::string, std::string>>{
           {"0 1\n3 0 1 2\n", "vertex 2 (line 12) has fewer numbers"},
           {"0 1 0 7\n3 0 1 2\n", "vertex 2 (line 12) has more numbers"},
           {"0 1 o\n3 0 1 2\n", "vertex 2 (line 12) has 'o' in the place of a number"},
           {"0 1 0\n3 0 1 3\n", "face 0 (line 13) has the index 3"},
           {"0 1 0\n-1\n", "face 0 (line 13) does not say how many numbers follow"}}) {
    const TemporaryFile file("bad.ply", head + rest);
    expect_in(part, refusal([&, path = file.path()] { load_scene(path); }));
  }
}

TEST(OtherFormats, FacesOfAnOffHaveTheCornersThatTheySay) {
  const std::string head = "OFF\n3 1 0\n-1 -1 0\n1 -1 0\n0 1 0\n";
  for (const auto& [rest, part] : std::vector<std::pair<std::string, std::string>>{
           {"5 0 1 2\n", "face 0 (line 6) says that it has 5 corners, and has 3"},
           {"3 0 1 7\n", "face 0 (line 6) has the index '7', and there are 3 vertices"},
           {"3 0 1 -1\n", "face 0 (line 6) has the index '-1'"},
           {"3 0 1 x\n", "face 0 (line 6) has the index 'x'"},
           {"10 0 1 2 0 1 2 0 1 2 0\n", "face 0 (line 6) has 10 corners, and its reader takes 9"},
           {"0\n3 0 1 2\n", "face 0 (line 6) does not say how many corners it has"}}) {
    const TemporaryFile file("bad.off", head + rest);
    expect_in(part, refusal([&, path = file.path()] { load_scene(path); }));
  }
  const TemporaryFile counts("counts.off", "OFF\n3 1\n-1 -1 0\n1 -1 0\n0 1 0\n3 0 1 2\n");
  expect_in("line 2 does not have the numbers of vertices, faces and edges",
            refusal([&] { load_scene(counts.path()); }));
  const TemporaryFile colours("colours.off",
                              "COFF\n3 1 0\n-1 -1 0 255 0 0 255\n1 -1 0 255 51 0 255\n0 1 0 0 0 255 255\n"
                              "3 0 1 2\n");
  const Scene scene = load_scene(colours.path());
  EXPECT_LT(glm::distance(only_mesh(scene).colours.at(1), glm::dvec3(1, 0.2, 0)), 1e-6);
}

TEST(OtherFormats, BonesAndCamerasAreNoMeshes) {
  for (const char* name : {"BVH/01_01.bvh", "Collada/cameras.dae"})
    expect_in("there are no triangles in it",
              refusal([&] { load_scene(HALFSPACE_TESTMODELS "/" + std::string(name)); }));
}

TEST(OtherFormats, ColoursOfVerticesAreClamped) {
  const TemporaryFile obj("colours.obj", "v 0 0 0 2 0.5 0\nv 1 0 0 1 0.5 0\nv 0 1 0 1 0.5 0\nf 1 2 3\n");
  const Scene scene = load_scene(obj.path());
  for (const glm::dvec3& colour : only_mesh(scene).colours) EXPECT_EQ(colour, glm::dvec3(1, 0.5, 0));
}

TEST(OtherFormats, PicturesAreReadByWhatIsInThem) {
  const TemporaryFile text("text.png", "this is no picture, whatever its name says");
  expect_in("a texture of this format is not taken", refusal([&] { read_texture(text.path(), true); }));
  const TemporaryFile grey("grey.png", "P2\n2 1\n255\n0 200\n");
  EXPECT_EQ(read_texture(grey.path(), true).texels.at(1)[0], 200);
}

}  // namespace
}  // namespace halfspace::ref
