// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/assimp/collada.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <pugixml.hpp>
#include <string_view>

#include "ref/error.hpp"
#include "ref/scene/assimp/file_system.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// The first word that is no whole number; empty: there is none.
std::string_view first_bad(const char* text) {
  while (*text) {
    while (is_space(*text)) ++text;
    const char* const start = text;
    bool good = true;
    for (; *text && !is_space(*text); ++text) {
      const bool sign = text == start && (*text == '-' || *text == '+') && text[1] && !is_space(text[1]);
      good = good && (sign || (*text >= '0' && *text <= '9'));
    }
    if (!good) return {start, std::size_t(text - start)};
  }
  return {};
}

double number(const pugi::xml_node& of, const char* name) {
  const double value = of.child(name).text().as_double(0);
  return std::isfinite(value) && value > 0 ? value : 0;
}

// Half of the size of the view at distance 1.
double half_size(double degrees) {
  return degrees > 0 && degrees < 180 ? std::tan(degrees * std::acos(-1.0) / 360) : 0;
}

Camera camera_of(const pugi::xml_node& source) {
  const pugi::xml_node technique = source.child("optics").child("technique_common");
  Camera camera;
  pugi::xml_node of = technique.child("orthographic");
  camera.orthographic = !of.empty();
  if (camera.orthographic) {
    camera.half_width = number(of, "xmag");
    camera.half_height = number(of, "ymag");
  } else {
    of = technique.child("perspective");
    camera.half_width = half_size(number(of, "xfov"));
    camera.half_height = half_size(number(of, "yfov"));
  }
  const double aspect = number(of, "aspect_ratio");
  if (aspect > 0 && camera.half_width == 0) camera.half_width = camera.half_height * aspect;
  if (aspect > 0 && camera.half_height == 0) camera.half_height = camera.half_width / aspect;
  camera.near = number(of, "znear");
  camera.far = number(of, "zfar");
  if (!(camera.far > camera.near) || camera.near == 0) camera.near = camera.far = 0;
  return camera;
}

// Indices are checked, and cameras and what places them collected.
class Walker : public pugi::xml_tree_walker {
 public:
  Walker(const std::string& path, Collada* collada) : path_(path), collada_(*collada) {}

  bool for_each(pugi::xml_node& node) override {
    const char* const name = node.name();
    if (!std::strcmp(name, "p") || !std::strcmp(name, "v") || !std::strcmp(name, "vcount")) {
      const std::string_view bad = first_bad(node.text().get());
      if (!bad.empty()) {
        throw Error(fmt::format("{}: '{}' in a list of indices <{}> is no whole number; export the file again", path_,
                                one_line(std::string(bad.substr(0, 40))), name));
      }
    } else if (!std::strcmp(name, "camera")) {
      cameras_.emplace(node.attribute("id").value(), camera_of(node));
    } else if (!std::strcmp(name, "instance_camera")) {
      const pugi::xml_node parent = node.parent();
      const char* const id = parent.attribute("id").value();
      instances_.push_back({*id ? id : parent.attribute("sid").value(), node.attribute("url").value()});
    }
    return true;
  }

  void place() {
    for (const auto& [node, url] : instances_) {
      const auto found = cameras_.find(url.empty() ? url : url.substr(1));  // without '#'
      if (found != cameras_.end()) collada_.cameras[node].push_back(found->second);
    }
  }

 private:
  struct Placed {
    std::string node, url;
  };
  const std::string& path_;
  Collada& collada_;
  std::map<std::string, Camera> cameras_;
  std::vector<Placed> instances_;
};

}  // namespace

Collada read_collada(const std::string& path) {
  Collada collada;
  if (extension_of(path) != "dae") return collada;
  std::string text = text_of(path);
  pugi::xml_document document;
  if (!document.load_buffer_inplace(text.data(), text.size())) return collada;
  Walker walker(path, &collada);
  document.traverse(walker);
  walker.place();
  return collada;
}

}  // namespace halfspace::ref
