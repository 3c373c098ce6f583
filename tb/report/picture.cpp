// SPDX-License-Identifier: Apache-2.0
#include "tb/report/picture.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace halfspace::tb {
namespace {

// Calls put(x, y, lane, word) for each pixel of the last frame that a word holds.
template <class Put>
void each_pixel(const Vectors& vectors, const std::string& name, const Words& words, Put put) {
  const Stream& stream = *vectors.find(name);
  const Field &x_field = stream.need("x", "a picture"), &y_field = stream.need("y", "a picture");
  const Frame& frame = vectors.frames.back();
  for (std::size_t n = 0; n < words.size(); ++n) {
    for (int lane = 0; lane < vectors.lanes(); ++lane) {
      const std::uint64_t x = x_field.raw(words[n]) * unsigned(vectors.lanes_x) + unsigned(lane % vectors.lanes_x);
      const std::uint64_t y = y_field.raw(words[n]) * unsigned(vectors.lanes_y) + unsigned(lane / vectors.lanes_x);
      if (x < frame.width && y < frame.height) put(std::size_t(y * frame.width + x), lane, words[n]);
    }
  }
}

// The words of a stream's last frame.
Words last_words(const Stream& stream) {
  Words words(stream.bits);
  for (std::size_t n = stream.words.size() - stream.frame_words.back(); n < stream.words.size(); ++n) {
    std::memcpy(words.append(), stream.words[n], words.parts() * 4);
  }
  return words;
}

std::string big_endian(std::uint32_t value) {
  return {char(value >> 24), char(value >> 16), char(value >> 8), char(value)};
}

std::string chunk(const std::string& kind, const std::string& data) {
  const std::string text = kind + data;
  std::uint32_t crc = ~0u;
  for (const char c : text) {
    crc ^= std::uint8_t(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0);
  }
  return big_endian(std::uint32_t(data.size())) + text + big_endian(~crc);
}

// A zlib stream that stores and does not compress.
std::string stored(const std::string& bytes) {
  constexpr std::size_t kMost = 65535;
  std::string out = "\x78\x01";
  for (std::size_t at = 0; at < bytes.size(); at += kMost) {
    const std::size_t size = std::min(kMost, bytes.size() - at);
    out += char(at + size == bytes.size());
    out += {char(size), char(size >> 8), char(~size), char(~size >> 8)};
    out += bytes.substr(at, size);
  }
  std::uint32_t a = 1, b = 0;
  for (const char c : bytes) a = (a + std::uint8_t(c)) % 65521, b = (b + a) % 65521;
  return out + big_endian(b << 16 | a);
}

}  // namespace

std::string rgba_picture(const Vectors& vectors, const Words& pixel) {
  const Frame& frame = vectors.frames.back();
  const Stream& stream = *vectors.find(vectors.shown());
  const Field* const channels[3] = {&stream.need("r", "a picture"), &stream.need("g", "a picture"),
                                    &stream.need("b", "a picture")};
  std::string bytes(std::size_t(frame.width) * frame.height * 4, '\0');
  each_pixel(vectors, stream.name, pixel, [&](std::size_t at, int lane, const std::uint32_t* word) {
    for (std::size_t c = 0; c < 3; ++c) {
      // Full scale is 255 whatever the bits of a channel.
      const std::uint64_t full = (1u << channels[c]->width) - 1;
      bytes[4 * at + c] = char((channels[c]->raw(word, lane) * 255 + full / 2) / full);
    }
    bytes[4 * at + 3] = char(255);
  });
  return bytes;
}

std::string index_picture(const Vectors& vectors, const Words& scan) {
  const Frame& frame = vectors.frames.back();
  const Field& index = vectors.find("scan")->need("index", "a picture");
  std::string bytes(std::size_t(frame.width) * frame.height * 4, '\0');
  each_pixel(vectors, "scan", scan, [&](std::size_t at, int lane, const std::uint32_t* word) {
    const std::uint32_t value = std::uint32_t(index.raw(word, lane));
    std::memcpy(&bytes[4 * at], &value, 4);
  });
  return bytes;
}

std::string png_of(std::uint32_t width, std::uint32_t height, const std::string& rgba) {
  std::string rows;
  for (std::size_t y = 0; y < height; ++y) rows += '\0' + rgba.substr(y * width * 4, std::size_t(width) * 4);
  const std::string head = big_endian(width) + big_endian(height) + std::string("\x08\x06\0\0\0", 5);
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", head) + chunk("IDAT", stored(rows)) + chunk("IEND", "");
}

std::string wrong_pixels(const Vectors& vectors, const Words& shown) {
  const Stream& stream = *vectors.find(vectors.shown());
  const Words expected = last_words(stream);
  const Frame& frame = vectors.frames.back();
  std::string wrong(std::size_t(frame.width) * frame.height, 2);
  std::vector<std::uint32_t> of_pixel(wrong.size());
  each_pixel(vectors, stream.name, expected, [&](std::size_t at, int, const std::uint32_t* word) {
    of_pixel[at] = std::uint32_t((word - expected[0]) / std::ptrdiff_t(expected.parts()));
  });
  each_pixel(vectors, stream.name, shown, [&](std::size_t at, int lane, const std::uint32_t* word) {
    const std::uint32_t* const want = expected[of_pixel[at]];
    const bool same = std::all_of(stream.fields.begin(), stream.fields.end(), [&](const Field& field) {
      return field.count == 1 || field.raw(word, lane) == field.raw(want, lane);
    });
    wrong[at] = char(!same);
  });
  return wrong;
}

std::string map_of_wrong(const Vectors& vectors, const std::string& wrong) {
  std::string map = rgba_picture(vectors, last_words(*vectors.find(vectors.shown())));
  for (std::size_t at = 0; at < wrong.size(); ++at) {
    char* const rgba = &map[4 * at];
    const auto of = [&](int c) { return int(std::uint8_t(rgba[c])); };
    const char grey = char((of(0) + of(1) + of(2)) / 6);
    const std::array<char, 3> colours[] = {{grey, grey, grey}, {char(255), 40, 40}, {40, 80, char(255)}};
    std::copy_n(colours[int(wrong[at])].begin(), 3, rgba);
  }
  return map;
}

}  // namespace halfspace::tb
