// SPDX-License-Identifier: Apache-2.0
#include "ref/scene/guard/document_stream.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <type_traits>

namespace halfspace::ref {
namespace {

constexpr std::size_t kBuffer = std::size_t(1) << 16;  // bytes
constexpr std::size_t kAtOnce = std::size_t(1) << 22;  // elements: a count is believed no further than its bytes come
constexpr int kLongestSilence = 2 * 60 * 1000;         // milliseconds, of a reader that waits for something itself

class Writer {
 public:
  explicit Writer(int descriptor) : descriptor_(descriptor) { buffer_.reserve(kBuffer); }
  void bytes(const void* data, std::size_t size) {
    if (buffer_.size() + size > kBuffer) flush();
    if (size > kBuffer) return send(data, size);
    const char* const from = static_cast<const char*>(data);
    buffer_.insert(buffer_.end(), from, from + size);
  }
  void flush() {
    send(buffer_.data(), buffer_.size());
    buffer_.clear();
  }

 private:
  void send(const void* data, std::size_t size) const {
    const char* from = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t sent = ::write(descriptor_, from, size);
      if (sent < 0 && errno == EINTR) continue;
      if (sent <= 0) throw BrokenStream("nobody reads");
      from += sent, size -= std::size_t(sent);
    }
  }
  int descriptor_;
  std::vector<char> buffer_;
};

class Reader {
 public:
  explicit Reader(int descriptor) : descriptor_(descriptor) {}
  void bytes(void* data, std::size_t size) {
    char* to = static_cast<char*>(data);
    while (size > 0) {
      if (at_ == buffer_.size()) fill();
      const std::size_t some = std::min(size, buffer_.size() - at_);
      std::memcpy(to, buffer_.data() + at_, some);
      at_ += some, to += some, size -= some;
    }
  }

 private:
  void fill() {
    buffer_.resize(kBuffer);
    at_ = 0;
    pollfd waiting{descriptor_, POLLIN, 0};
    ssize_t got = -1;
    do {
      if (::poll(&waiting, 1, kLongestSilence) == 0) break;
      got = ::read(descriptor_, buffer_.data(), kBuffer);
    } while (got < 0 && errno == EINTR);
    buffer_.resize(got > 0 ? std::size_t(got) : 0);
    if (got <= 0) throw BrokenStream("the answer ends early");
  }
  int descriptor_;
  std::vector<char> buffer_;
  std::size_t at_ = 0;
};

// What has no pointer in it goes as it lies in memory.
template <class T>
constexpr bool kIsPlain = std::is_trivially_copyable_v<T>;

template <class S>
void pass(S& stream, std::string& text);
template <class S, class T>
void pass(S& stream, std::vector<T>& values);
template <class S, class T>
std::enable_if_t<kIsPlain<T>> pass(S& stream, T& value);
template <class S>
void pass(S& stream, Mesh& v);
template <class S>
void pass(S& stream, MorphTarget& v);
template <class S>
void pass(S& stream, DocumentMesh& v);
template <class S>
void pass(S& stream, Node& v);
template <class S>
void pass(S& stream, Texture& v);
template <class S>
void pass(S& stream, Channel& v);
template <class S>
void pass(S& stream, Animation& v);
template <class S>
void pass(S& stream, DocumentCamera& v);

void plain(Writer& stream, const void* data, std::size_t size) { stream.bytes(data, size); }
void plain(Reader& stream, void* data, std::size_t size) { stream.bytes(data, size); }

template <class S, class T>
std::enable_if_t<kIsPlain<T>> pass(S& stream, T& value) {
  plain(stream, &value, sizeof value);
}

template <class S, class T>
void pass_elements(S& stream, T* from, std::size_t count) {
  if constexpr (kIsPlain<T>) {
    plain(stream, from, count * sizeof(T));
  } else {
    for (std::size_t i = 0; i < count; ++i) pass(stream, from[i]);
  }
}

template <class T>
void pass_sized(Writer& stream, T& values) {
  std::uint64_t count = values.size();
  pass(stream, count);
  pass_elements(stream, values.data(), values.size());
}

template <class T>
void pass_sized(Reader& stream, T& values) {
  std::uint64_t count = 0;
  pass(stream, count);
  values.clear();
  while (values.size() < count) {
    const std::size_t before = values.size(), some = std::min(std::size_t(count - before), kAtOnce);
    values.resize(before + some);
    pass_elements(stream, values.data() + before, some);
  }
}

template <class S>
void pass(S& stream, std::string& text) {
  pass_sized(stream, text);
}
template <class S, class T>
void pass(S& stream, std::vector<T>& values) {
  pass_sized(stream, values);
}

template <class S, class... T>
void pass_all(S& stream, T&... fields) {
  (pass(stream, fields), ...);
}

template <class S>
void pass(S& stream, Mesh& v) {
  pass_all(stream, v.name, v.positions, v.normals, v.colours, v.texture_coordinates, v.triangles, v.material);
}
template <class S>
void pass(S& stream, MorphTarget& v) {
  pass_all(stream, v.positions, v.normals, v.weight);
}
template <class S>
void pass(S& stream, DocumentMesh& v) {
  pass_all(stream, v.mesh, v.is_flat, v.targets, v.joint_weights, v.skin);
}
template <class S>
void pass(S& stream, Node& v) {
  pass_all(stream, v.name, v.parent, v.matrix, v.translation, v.scale, v.rotation, v.meshes, v.skin, v.weights);
}
template <class S>
void pass(S& stream, Texture& v) {
  pass_all(stream, v.name, v.width, v.height, v.texels);
}
template <class S>
void pass(S& stream, Channel& v) {
  pass_all(stream, v.node, v.path, v.interpolation, v.times, v.values);
}
template <class S>
void pass(S& stream, Animation& v) {
  pass_all(stream, v.name, v.duration, v.channels);
}
template <class S>
void pass(S& stream, DocumentCamera& v) {
  pass_all(stream, v.name, v.node, v.camera, v.is_doubtful);
}
template <class S>
void pass_document(S& stream, Document& v) {
  pass_all(stream, v.name, v.nodes, v.meshes, v.skins, v.materials, v.textures, v.animations, v.cameras, v.lights,
           v.ambient, v.remarks);
}

}  // namespace

// Only a reader writes to what it is given.
void write_answer(int descriptor, const Answer& answer) {
  Writer stream(descriptor);
  Answer& fields = const_cast<Answer&>(answer);
  pass(stream, fields.refusal);
  pass_document(stream, fields.document);
  stream.flush();
}

Answer read_answer(int descriptor) {
  Answer answer;
  Reader stream(descriptor);
  pass(stream, answer.refusal);
  pass_document(stream, answer.document);
  return answer;
}

}  // namespace halfspace::ref
