// SPDX-License-Identifier: Apache-2.0
#include "cli/scene_input.hpp"

#include <fmt/format.h>

#include <cctype>
#include <charconv>

#include "ref/error.hpp"
#include "ref/geometry.hpp"
#include "ref/scene.hpp"
#include "ref/triangle_list.hpp"
#include "vectors/engine.hpp"

namespace halfspace::cli {
namespace {

struct Size {
  int width = 0, height = 0;
};

// "WxH", both from 1 on.
Size parse_size(const std::string& text) {
  Size size;
  const char* const end = text.data() + text.size();
  const auto w = std::from_chars(text.data(), end, size.width);
  const bool has_x = w.ec == std::errc() && w.ptr != end && *w.ptr == 'x';
  const auto h = has_x ? std::from_chars(w.ptr + 1, end, size.height) : w;
  if (!has_x || h.ec != std::errc() || h.ptr != end || size.width < 1 || size.height < 1) {
    throw ref::Error(fmt::format("--size {}: not a frame size: write it like 640x480", text));
  }
  return size;
}

bool fits(const Size& size, const ref::RasterFormat& format) {
  return size.width <= format.width && size.height <= format.height;
}

}  // namespace

void add_scene_options(CLI::App* command, SceneInput& input) {
  std::string names;
  for (const std::string& name : ref::builtin_scene_names()) names += (names.empty() ? "" : ", ") + name;
  command->add_option("SCENE", input.scene, "a built-in scene (" + names + "), a mesh file (OBJ, glTF, Collada, …) or a screen-space *.tri")
      ->required();
  command->add_option("--config", input.config,
                      "number formats: low (320x200), middle (640x480), high (1920x1080); default: middle, or high "
                      "when the frame is larger");
  command->add_option("--size", input.size, "frame, WxH; default: the size in the file, or the configuration's own");
  command->add_option("--time", input.time, "seconds into the file's animation")->capture_default_str();
}

ref::SnappedList load_snapped(const SceneInput& input) {
  const std::vector<ref::RasterFormat> formats = vectors::raster_formats();
  const bool is_tri = ref::is_tri_file(input.scene);
  Size size;
  if (!input.size.empty()) size = parse_size(input.size);

  ref::TriangleList list;
  if (is_tri) {
    list = ref::read_tri(input.scene);
    if (!input.size.empty() && (size.width != list.width || size.height != list.height)) {
      throw ref::Error(fmt::format("{}: its frame is {}x{}, not {}: leave out --size", input.scene, list.width, list.height,
                                   input.size));
    }
    size = {list.width, list.height};
  }

  std::string config = input.config;
  if (config.empty()) {
    const ref::RasterFormat middle = vectors::raster_format("middle");
    config = size.width == 0 || fits(size, middle) ? "middle" : "high";
  }
  const ref::RasterFormat format = vectors::raster_format(config);
  if (size.width == 0) size = {format.width, format.height};

  if (!is_tri) {
    if (!fits(size, format)) {  // before the work of reading a mesh
      ref::TriangleList empty;
      empty.width = size.width;
      empty.height = size.height;
      return ref::snap(empty, format, formats);
    }
    const ref::Scene scene = ref::load_scene(input.scene, input.time);
    list = ref::project(scene, {size.width, size.height, format.range_bits, format.subpixel_bits});
  }
  return ref::snap(list, format, formats);
}

}  // namespace halfspace::cli
