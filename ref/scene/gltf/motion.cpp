// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/gltf/motion.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ref/scene/gltf/file/accessor.hpp"

namespace halfspace::ref::gltf {
namespace {

std::vector<double> times_of(const File& file, int number) {
  const Accessor accessor(file, number, "times of an animation", {1});
  std::vector<double> times = accessor.all();
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] < times[i - 1]) accessor.refuse(fmt::format("falls at element {}", i));
  }
  return times;
}

Interpolation interpolation_of(const File& file, const std::string& name) {
  if (name == "STEP") return Interpolation::kStep;
  if (name == "LINEAR") return Interpolation::kLinear;
  if (name == "CUBICSPLINE") return Interpolation::kCubic;
  file.refuse(fmt::format("cannot be read as a mesh (an interpolation is '{}')", name_of(name)));
}

void check_rotations(const Channel& channel, const Accessor& accessor) {
  const std::size_t step = channel.interpolation == Interpolation::kCubic ? 12 : 4, at = step == 12 ? 4 : 0;
  for (std::size_t i = at; i + 4 <= channel.values.size(); i += step) {
    const double* const q = &channel.values[i];
    if (!(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0)) accessor.refuse("has a rotation of length 0");
  }
}

// `numbers`: of a value.
std::vector<double> values_of(const File& file, int number, Channel* channel, std::size_t numbers) {
  const bool weights = channel->path == ChannelPath::kWeights;
  const std::size_t of_key = channel->interpolation == Interpolation::kCubic ? 3 : 1;
  const Accessor accessor(file, number, "values of an animation", {weights ? 1 : int(numbers)});
  const std::size_t wanted = channel->times.size() * of_key * (weights ? numbers : 1);
  if (accessor.count() != wanted) {
    accessor.refuse(
        fmt::format("has {} elements for {} keys, not {}", accessor.count(), channel->times.size(), wanted));
  }
  channel->values = accessor.all();
  if (channel->path == ChannelPath::kRotation) check_rotations(*channel, accessor);
  return std::move(channel->values);
}

std::size_t numbers_of(ChannelPath path, std::size_t targets) {
  if (path == ChannelPath::kWeights) return targets;
  return path == ChannelPath::kRotation ? 4 : 3;
}

const std::vector<std::pair<std::string, ChannelPath>> kPaths{{"translation", ChannelPath::kTranslation},
                                                              {"rotation", ChannelPath::kRotation},
                                                              {"scale", ChannelPath::kScale},
                                                              {"weights", ChannelPath::kWeights}};

}  // namespace

Skin skin_of(const File& file, int number, const NodeOrder& order) {
  const tinygltf::Skin& source = file.model.skins[std::size_t(number)];
  Skin skin;
  for (const int joint : source.joints) skin.push_back({order.numbers[std::size_t(joint)], glm::dmat4(1)});
  if (source.inverseBindMatrices < 0) return skin;
  const Accessor matrices(file, source.inverseBindMatrices, "inverse bind matrices", {16});
  if (matrices.count() < skin.size()) {
    matrices.refuse(fmt::format("has {} matrices of {} joints", matrices.count(), skin.size()));
  }
  for (std::size_t i = 0; i < skin.size(); ++i) {
    for (int c = 0; c < 16; ++c) skin[i].from_mesh[c / 4][c % 4] = matrices.at(i, c);
  }
  return skin;
}

Animation animation_of(File* file, int number, const NodeOrder& order, const std::vector<std::size_t>& targets) {
  const tinygltf::Animation& source = file->model.animations[std::size_t(number)];
  Animation animation;
  animation.name = name_of(source.name);
  for (const tinygltf::AnimationChannel& of : source.channels) {
    const auto path =
        std::find_if(kPaths.begin(), kPaths.end(), [&](const auto& p) { return p.first == of.target_path; });
    if (path == kPaths.end()) {
      file->remark("animations of other things than nodes are left out");
      continue;
    }
    if (std::size_t(of.sampler) >= source.samplers.size()) {
      file->refuse(fmt::format("cannot be read as a mesh (animation {} has no sampler {})", number, of.sampler));
    }
    if (of.target_node < 0 || order.numbers[std::size_t(of.target_node)] < 0) continue;
    const tinygltf::AnimationSampler& keys = source.samplers[std::size_t(of.sampler)];
    Channel channel;
    channel.node = order.numbers[std::size_t(of.target_node)];
    channel.path = path->second;
    channel.interpolation = interpolation_of(*file, keys.interpolation);
    channel.times = times_of(*file, keys.input);
    const std::size_t numbers = numbers_of(channel.path, targets[std::size_t(channel.node)]);
    if (numbers == 0) continue;  // weights of a mesh that is left out
    channel.values = values_of(*file, keys.output, &channel, numbers);
    animation.duration = std::max(animation.duration, channel.times.back());
    animation.channels.push_back(std::move(channel));
  }
  return animation;
}

}  // namespace halfspace::ref::gltf
