// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "ref/scene/assimp/assimp_parts.hpp"
#include "ref/scene/input_file.hpp"

namespace halfspace::ref {
namespace {

constexpr double kDefaultTicks = 25;  // a second, of a file that does not say

template <class Key>
void add_channel(const Key* keys, unsigned count, int node, ChannelPath path, double ticks_a_second,
                 Animation* animation) {
  Channel channel{node, path, Interpolation::kLinear, {}, {}};
  for (unsigned i = 0; i < count; ++i) {
    channel.times.push_back(keys[i].mTime / ticks_a_second);
    if constexpr (std::is_same_v<Key, aiQuatKey>) {
      const aiQuaternion& q = keys[i].mValue;
      channel.values.insert(channel.values.end(), {q.x, q.y, q.z, q.w});
    } else {
      const aiVector3D& v = keys[i].mValue;
      channel.values.insert(channel.values.end(), {v.x, v.y, v.z});
    }
  }
  if (count != 0) animation->channels.push_back(std::move(channel));
}

// Of the node and the meshes that the name is of, one weight a target.
void add_morphs(const aiMeshMorphAnim& source, const aiScene& file, const Document& document, double ticks_a_second,
                Animation* animation) {
  const std::string name = source.mName.C_Str();
  for (std::size_t n = 0; n < document.nodes.size(); ++n) {
    const Node& node = document.nodes[n];
    for (const int mesh : node.meshes) {
      if (node.name != name && name != file.mMeshes[mesh]->mName.C_Str()) continue;
      const std::size_t targets = document.meshes[mesh].targets.size();
      Channel channel{int(n), ChannelPath::kWeights, Interpolation::kLinear, {}, {}};
      for (unsigned k = 0; k < source.mNumKeys; ++k) {
        const aiMeshMorphKey& key = source.mKeys[k];
        std::vector<double> weights(targets, 0.0);
        for (unsigned i = 0; i < key.mNumValuesAndWeights; ++i) {
          if (key.mValues[i] < targets) weights[key.mValues[i]] += key.mWeights[i];
        }
        channel.times.push_back(key.mTime / ticks_a_second);
        channel.values.insert(channel.values.end(), weights.begin(), weights.end());
      }
      if (targets == 0 || channel.times.empty()) continue;
      animation->channels.push_back(std::move(channel));
      break;
    }
  }
}

// Keys of the file may not be in order.
void sort_keys(Channel* channel) {
  if (std::is_sorted(channel->times.begin(), channel->times.end())) return;
  const std::size_t width = channel->values.size() / channel->times.size();
  std::vector<std::size_t> order(channel->times.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return channel->times[a] < channel->times[b]; });
  Channel sorted{channel->node, channel->path, channel->interpolation, {}, {}};
  for (const std::size_t i : order) {
    sorted.times.push_back(channel->times[i]);
    for (std::size_t v = 0; v < width; ++v) sorted.values.push_back(channel->values[i * width + v]);
  }
  *channel = std::move(sorted);
}

}  // namespace

// Assimp stores rows, GLM columns.
glm::dmat4 to_glm(const aiMatrix4x4& m) {
  glm::dmat4 matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix[column][row] = m[row][column];
  }
  return matrix;
}

NodeNumbers add_nodes(const aiScene& file, Document* document) {
  NodeNumbers numbers;
  std::vector<std::pair<const aiNode*, int>> waiting{{file.mRootNode, -1}};
  while (!waiting.empty()) {
    const auto [source, parent] = waiting.back();
    waiting.pop_back();
    const int number = int(document->nodes.size());
    Node node;
    node.name = source->mName.C_Str();
    node.parent = parent;
    node.matrix = to_glm(source->mTransformation);
    for (unsigned i = 0; i < source->mNumMeshes; ++i) node.meshes.push_back(int(source->mMeshes[i]));
    numbers.emplace(node.name, number);
    document->nodes.push_back(std::move(node));
    for (unsigned i = source->mNumChildren; i-- > 0;) waiting.emplace_back(source->mChildren[i], number);
  }
  return numbers;
}

// A channel of Assimp's stands for all of its node: parts without keys are none.
void add_animations(const aiScene& file, const NodeNumbers& numbers, Document* document) {
  for (unsigned a = 0; a < file.mNumAnimations; ++a) {
    const aiAnimation& source = *file.mAnimations[a];
    const double ticks_a_second = source.mTicksPerSecond > 0 ? source.mTicksPerSecond : kDefaultTicks;
    Animation animation{one_line(source.mName.C_Str()), source.mDuration / ticks_a_second, {}};
    for (unsigned i = 0; i < source.mNumChannels; ++i) {
      const aiNodeAnim& channel = *source.mChannels[i];
      const auto found = numbers.find(channel.mNodeName.C_Str());
      if (found == numbers.end()) continue;
      const int node = found->second;
      add_channel(channel.mPositionKeys, channel.mNumPositionKeys, node, ChannelPath::kTranslation, ticks_a_second,
                  &animation);
      add_channel(channel.mRotationKeys, channel.mNumRotationKeys, node, ChannelPath::kRotation, ticks_a_second,
                  &animation);
      add_channel(channel.mScalingKeys, channel.mNumScalingKeys, node, ChannelPath::kScale, ticks_a_second, &animation);
    }
    for (unsigned i = 0; i < source.mNumMorphMeshChannels; ++i) {
      add_morphs(*source.mMorphMeshChannels[i], file, *document, ticks_a_second, &animation);
    }
    for (Channel& channel : animation.channels) sort_keys(&channel);
    document->animations.push_back(std::move(animation));
  }
}

}  // namespace halfspace::ref
