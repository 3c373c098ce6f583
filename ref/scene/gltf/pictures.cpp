// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/pictures.hpp"

#include <fmt/format.h>

#include "ref/scene/gltf/file/uri.hpp"

namespace halfspace::ref::gltf {
namespace {

constexpr bool kTopRowIsAtOne = true;
constexpr std::size_t kMostBytes = std::size_t(1) << 30;

bool is_png_or_jpeg(std::string_view bytes) {
  return bytes.substr(0, 8) == "\x89PNG\r\n\x1A\n" || bytes.substr(0, 3) == "\xFF\xD8\xFF";
}

}  // namespace

int Pictures::of_texture(int texture) const {
  const int picture = file_.model.textures[std::size_t(texture)].source;
  if (picture < 0 && file_.choice.textured)
    file_.remark("textures whose pictures are neither PNG nor JPEG are left out");
  return picture;
}

Texture Pictures::read(int picture) const {
  const Picture& of = file_.pictures[std::size_t(picture)];
  std::string name = fmt::format("{}: texture {}", file_.path, picture), bytes;
  if (of.view >= 0) {
    bytes = file_.view(of.view);
  } else if (std::optional<std::string> data = data_of(file_.path, of.uri)) {
    bytes = std::move(*data);
  } else {
    name = file_of(file_.path, of.uri);
    if (name.empty()) {
      throw Error(fmt::format("{}: its texture '{}' is not there; put it beside the file, or leave textures out",
                              file_.path, shown(of.uri)));
    }
    if (!read_bytes(name, kMostBytes, &bytes)) file_.refuse(fmt::format("its texture '{}' cannot be read", name));
  }
  if (!is_png_or_jpeg(bytes)) file_.refuse(fmt::format("its texture {} is neither PNG nor JPEG", picture));
  return read_texture(name, std::vector<std::uint8_t>(bytes.begin(), bytes.end()), kTopRowIsAtOne);
}

int Pictures::in_document(int picture) {
  const auto [at, is_new] = numbers_.try_emplace(picture, int(file_.document.textures.size()));
  if (is_new) file_.document.textures.push_back(read(picture));
  return at->second;
}

Pictures::Mean Pictures::mean(int picture) {
  const auto [at, is_new] = means_.try_emplace(picture);
  if (!is_new) return at->second;
  const auto held = numbers_.find(picture);
  const Texture texture = held == numbers_.end() ? read(picture) : file_.document.textures[std::size_t(held->second)];
  glm::dvec3 sum(0);
  bool is_uniform = true;
  for (const auto& texel : texture.texels) {
    sum += glm::dvec3(texel[0], texel[1], texel[2]);
    is_uniform = is_uniform && texel == texture.texels.front();
  }
  return at->second = {sum / (255.0 * double(texture.texels.size())), is_uniform};
}

}  // namespace halfspace::ref::gltf
