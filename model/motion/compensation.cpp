// SPDX-License-Identifier: Apache-2.0
#include "model/motion/compensation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <tuple>

#include "hls/formats/film_records.hpp"
#include "hls/formats/streams.hpp"
#include "hls/motion/motion_compensate.hpp"
#include "model/formats/recorder.hpp"
#include "model/formats/runtime_formats.hpp"
#include "model/motion/key_tables.hpp"
#include "ref/error.hpp"

namespace halfspace {

namespace model {
namespace {

using F = RuntimeFormats<Stamp1>;

// Of motion_compensate, whose blocks have N × N pixels.
template <int N>
struct CompensateStreams {
  HS_STREAM_MEMBERS(HS_COMPENSATE_STREAMS)
};

// The memory of a key frame: blocks of a tile together; beyond the frame pixels of no face.
template <int N>
std::vector<KeyBlock<F, N>> key_memory(const KeyFrame& key) {
  const int tiles_x = (key.width + kKeyTile - 1) / kKeyTile, tiles_y = (key.height + kKeyTile - 1) / kKeyTile;
  std::vector<KeyBlock<F, N>> memory(std::size_t(tiles_x) * tiles_y * blocks_a_tile(N));
  for (int y = 0; y < key.height; ++y) {
    for (int x = 0; x < key.width; ++x) {
      const int tile = y / kKeyTile * tiles_x + x / kKeyTile;
      const int block = y % kKeyTile / N * blocks_a_row(N) + x % kKeyTile / N, lane = y % N * N + x % N;
      KeyBlock<F, N>& out = memory[std::size_t(tile) * blocks_a_tile(N) + block];
      const std::size_t at = std::size_t(y) * key.width + x;
      out.r[lane] = from_raw<F::Colour>(key.rgb[at][0]);
      out.g[lane] = from_raw<F::Colour>(key.rgb[at][1]);
      out.b[lane] = from_raw<F::Colour>(key.rgb[at][2]);
      out.face[lane] = from_raw<F::Face>(key.face[at]);
    }
  }
  return memory;
}

// It answers at once. Tiles that the caches fetch are counted, whether or not the streams are recorded.
template <int N>
struct AskedMemory {
  AskedMemory(const KeyFrame& key, Probe<KeyBlock<F, N>>& probe)
      : blocks(key_memory<N>(key)), tiles_x((key.width + kKeyTile - 1) / kKeyTile), probe(probe) {}

  void request(const KeyRequest<F>& tile) {
    requests.push_back(tile);
    at = std::size_t((int(raw(tile.tile_y)) * tiles_x + int(raw(tile.tile_x))) * blocks_a_tile(N));
  }
  KeyBlock<F, N> read() {
    probe.write(blocks[at]);
    return blocks[at++];
  }

  std::vector<KeyBlock<F, N>> blocks;
  int tiles_x;
  Probe<KeyBlock<F, N>>& probe;
  std::vector<KeyRequest<F>> requests;
  std::size_t at = 0;
};

Motion<F> motion_record(const RawMotion& in, bool last) {
  Motion<F> out{};
  out.last = from_raw<Bit>(last);
  out.x = from_raw<F::X>(in.x);
  out.y = from_raw<F::Y>(in.y);
  out.face = from_raw<F::Face>(in.face);
  for (int k = 0; k < kKeys; ++k) {
    const RawKeyVector& v = in.key[std::size_t(k)];
    const int zero = 1 << (F::kColourBits + kDifferenceFraction);
    out.key[k].there = from_raw<Bit>(v.there);
    out.key[k].x = from_raw<F::Vector>(v.x);
    out.key[k].y = from_raw<F::Vector>(v.y);
    out.key[k].r = from_raw<F::Difference>(v.difference[0] + zero);
    out.key[k].g = from_raw<F::Difference>(v.difference[1] + zero);
    out.key[k].b = from_raw<F::Difference>(v.difference[2] + zero);
  }
  return out;
}

void check(const CompensationInput& input, const Configuration& configuration) {
  const Config c = configuration.config();
  const auto refuse = [&](const std::string& why) {
    throw ref::Error(fmt::format("compensation in configuration {}: {}", configuration.name(), why));
  };
  if (input.width < 1 || input.width > c.width || input.height < 1 || input.height > c.height) {
    refuse(fmt::format("a frame of {}x{} pixels, and {}x{} is the largest: raise its width and height", input.width,
                       input.height, c.width, c.height));
  }
  const int width = (input.width + c.samples - 1) / c.samples, height = (input.height + c.samples - 1) / c.samples;
  for (const KeyFrame* key : input.key) {
    const std::size_t pixels = std::size_t(width) * height;
    if (!key || key->width != width || key->height != height || key->rgb.size() != pixels ||
        key->face.size() != pixels) {
      refuse(fmt::format("a key frame is not of {}x{} pixels, one for {} each way: render it in that size", width,
                         height, c.samples));
    }
  }
  const int most = 1 << (c.vector_range + c.vector_fraction), zero = 1 << (difference_bits(c) - 1);
  for (const RawMotion& m : input.motion) {
    bool fits = m.x >= 0 && m.x < input.width && m.y >= 0 && m.y < input.height && m.face >> c.face_bits == 0;
    for (const RawKeyVector& v : m.key) {
      fits = fits && v.x >= -most && v.x < most && v.y >= -most && v.y < most;
      for (const int d : v.difference) fits = fits && (d == 0 || (c.relight != 0 && d > -zero && d < zero));
    }
    if (!fits)
      refuse(
          fmt::format("a number of pixel {}, {} has no room in its word: raise vector_range or face_bits", m.x, m.y));
  }
  if (input.weight < 0 || input.weight > 1 << c.weight_bits) {
    refuse(
        fmt::format("a weight of {}, and 0 … {} are those of weight_bits: round it", input.weight, 1 << c.weight_bits));
  }
}

template <int N>
CompensatedFrame compensate(const CompensationInput& input, const Config& config, std::vector<StreamWords>* streams) {
  std::vector<RawMotion> motion = input.motion;
  if (input.by_tiles) order_by_tiles(motion, config);
  if (motion.empty()) motion.emplace_back();  // the word that ends a frame
  CompensationFrame<F> frame;
  frame.width = from_raw<F::X>(input.width);
  frame.height = from_raw<F::Y>(input.height);
  frame.weight = from_raw<F::KeyWeight>(input.weight);
  const KeyWeights<F> weights;
  const auto caches = std::make_unique<std::array<KeyCache<F, N>, kKeys>>();
  CompensateStreams<N> s;
  std::optional<Recorder> recorder;
  if (streams) recorder.emplace(s);
  s.key_weight.words.push_back({frame.weight});
  AskedMemory<N> memory_0{*input.key[0], s.key_block_0}, memory_1{*input.key[1], s.key_block_1};
  CompensatedFrame result;
  for (std::size_t n = 0; n < motion.size(); ++n) {
    const std::size_t before[kKeys] = {memory_0.requests.size(), memory_1.requests.size()};
    s.motion.write(motion_record(motion[n], n + 1 == motion.size()));
    motion_compensate<F, N>(frame, weights, (*caches)[0], (*caches)[1], memory_0, memory_1, s.motion, s.compensated);
    const Compensated<F> pixel = s.compensated.read();
    result.pixels.push_back({int(raw(pixel.x)),
                             int(raw(pixel.y)),
                             {std::uint8_t(raw(pixel.r)), std::uint8_t(raw(pixel.g)), std::uint8_t(raw(pixel.b))},
                             int(raw(pixel.keys))});
    result.fills += std::max(memory_0.requests.size() - before[0], memory_1.requests.size() - before[1]);
  }
  result.misses = {memory_0.requests.size(), memory_1.requests.size()};
  const std::size_t latency = config.filter == KeyFilter::kNearest ? 9 : 15;
  result.cycles = motion.size() + (1 + blocks_a_tile(N)) * result.fills + latency;
  for (const KeyRequest<F>& word : memory_0.requests) s.key_request_0.write(word);
  for (const KeyRequest<F>& word : memory_1.requests) s.key_request_1.write(word);
  if (streams) *streams = recorder->words();
  return result;
}

template <int N>
struct FilmStreams {
  HS_STREAM_MEMBERS(HS_FILM_STREAMS)
};

template <class Streams>
std::vector<Layout> layouts_of() {
  Streams streams;
  return stream_layouts(streams);
}

}  // namespace

int key_pixel_bits(const Config& config) { return 3 * config.colour_bits + config.face_bits; }

void order_by_tiles(std::vector<RawMotion>& motion, const Config& config) {
  const int side = kKeyTile * config.samples;
  std::stable_sort(motion.begin(), motion.end(), [&](const RawMotion& a, const RawMotion& b) {
    return std::make_tuple(a.y / side, a.x / side, a.y, a.x) < std::make_tuple(b.y / side, b.x / side, b.y, b.x);
  });
}

Compensator::Compensator(const Configuration& configuration)
    : Compensator(configuration, format_table(configuration.config())) {}

Compensator::Compensator(const Configuration& configuration, const FormatTable& table)
    : configuration_(configuration), table_(table) {
  if (!has_motion(configuration.config())) {
    throw ref::Error(
        fmt::format("configuration {} has no key frames: take one with shading = \"motion\"", configuration.name()));
  }
}

CompensatedFrame Compensator::run(const CompensationInput& input) const {
  check(input, configuration_);
  const Config config = configuration_.config();
  F::activate(config, table_);
  return key_side(config.filter) == 4 ? compensate<4>(input, config, nullptr) : compensate<2>(input, config, nullptr);
}

CompensatedFrame Compensator::capture(const CompensationInput& input, std::vector<StreamWords>& streams) const {
  check(input, configuration_);
  const Config config = configuration_.config();
  F::activate(config, table_);
  return key_side(config.filter) == 4 ? compensate<4>(input, config, &streams) : compensate<2>(input, config, &streams);
}

std::vector<Layout> Compensator::layouts() const {
  F::activate(configuration_.config(), table_);
  return key_side(configuration_.config().filter) == 4 ? layouts_of<CompensateStreams<4>>()
                                                       : layouts_of<CompensateStreams<2>>();
}

std::vector<Layout> Compensator::film_layouts() const {
  F::activate(configuration_.config(), table_);
  if (!F::kUpConverts) return {};
  return key_side(configuration_.config().filter) == 4 ? layouts_of<FilmStreams<4>>() : layouts_of<FilmStreams<2>>();
}

}  // namespace model
}  // namespace halfspace
