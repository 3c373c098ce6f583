// SPDX-License-Identifier: Apache-2.0
#include "model/formats/random_configuration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <random>

namespace halfspace::model {
namespace {

// Those that say by not being 0 that a part is there: they are drawn with it.
bool is_switch(const ConfigField& field) { return field.allowed.is_optional && field.number != &Config::gloss; }

bool is_there(const ConfigField& field, const Config& c) {
#define HS_NUMBER(part, name, there, allowed, refused, what) \
  if (field.number == &Config::name) return there(c);
#include "hls/formats/lists/config_list.hpp"
  return false;
}

// Below these hardly any of the numbers fit each other; to_extreme() finds what does.
int likely_low(const ConfigField& field, const Config& c) {
  const int fraction =
      max_of(max_of(c.depth_fraction, c.colour_fraction), max_of(c.normal_fraction, c.coordinate_fraction));
  if (field.number == &Config::range_bits) return bits_for(max_of(c.width, c.height) + 12) + 1;
  if (field.number == &Config::triangles) return up_converts(c) || has_objects(c) ? 64 : 2;  // a cube, some objects
  if (field.number == &Config::reciprocal_bits) return c.subpixel_bits + fraction;
  return field.refused == Refusal::kFractionBits ? c.range_bits + 1 : 0;
}

// What a small configuration has at most.
int small_limit(const ConfigField& field) {
  struct Row {
    int Config::*number;
    int most;
  };
  static const Row rows[] = {{&Config::width, 48},     {&Config::height, 40},      {&Config::triangles, 1000},
                             {&Config::materials, 40}, {&Config::texels, 1 << 12}, {&Config::textures, 40},
                             {&Config::face_bits, 10}, {&Config::index_window, 64}};
  for (const Row& row : rows) {
    if (field.number == row.number) return row.most;
  }
  return field.allowed.high;
}

class Drawing {
 public:
  Drawing(std::uint64_t seed, bool is_small) : random_(seed), is_small_(is_small) {}

  Config accepted() {
    for (;;) {
      const Config parts = choices();
      // Numbers that fit each other are rare; parts that contradict each other have none.
      for (int attempt = 0; attempt < 2000; ++attempt) {
        Config c = parts;
        for (const ConfigField& field : config_fields()) {
          if (field.is_number() && !is_switch(field) && is_there(field, c)) field.set(c, number(field, c));
        }
        // From all fractions.
        if (has_planes(c)) c.reciprocal_bits = number(*find_field("reciprocal_bits"), c);
        if (refusal(c) == Refusal::kNone) return pushed(c);
      }
    }
  }

 private:
  int in(int low, int high) { return low + int(random_() % std::uint64_t(high - low + 1)); }
  bool one_in(int n) { return in(1, n) == 1; }

  int high(const ConfigField& field) const { return is_small_ ? small_limit(field) : field.allowed.high; }

  // Of a large range each power of two is as likely.
  int number(const ConfigField& field, const Config& c) {
    if (field.allowed.is_optional && one_in(4)) return 0;
    const int most = high(field), low = std::min(most, std::max(field.allowed.low, likely_low(field, c)));
    if (field.allowed.is_power) return 1 << in(exact_log2(low), exact_log2(most));
    if (most - low <= 64) return in(low, most);
    const int bits = in(bits_for(low), bits_for(most));
    return in(std::max(low, 1 << (bits - 1)), std::min(most, (1 << bits) - 1));
  }

  Config choices() {
    Config c{};
    const auto set = [&](int Config::*field) {
      for (const ConfigField& f : config_fields()) {
        if (f.number == field) c.*field = std::max(f.allowed.low, number(f, c));
      }
    };
    if (!one_in(8)) set(&Config::depth_bits);
    c.shading = Shading(in(0, 3));
    if (one_in(3)) c.architecture = Architecture::kGamma;
    if (shades(c)) {
      if (is_phong(c) || one_in(3)) set(&Config::lights);
      if (one_in(3)) c.texture = TextureFilter(in(1, 2));
      if (one_in(5)) set(&Config::frames_between);
    }
    if (has_coordinates(c)) c.mapping = TextureMapping(in(0, 1));
    if (has_motion(c)) {
      c.filter = KeyFilter(in(1, 4));
      c.relight = in(0, 1);
    }
    if (one_in(4)) set(&Config::object_bits);
    if (one_in(4)) set(&Config::index_window);
    c.cull = Cull(one_in(2) ? 0 : in(1, 2));
    return c;
  }

  // Some numbers, in a random order, to one end of what the others allow.
  Config pushed(Config c) {
    const std::vector<ConfigField>& fields = config_fields();
    for (int n = in(0, 4); n > 0; --n) {
      const ConfigField& field = fields[std::size_t(in(0, int(fields.size()) - 1))];
      if (!field.is_number() || (is_small_ && small_limit(field) != field.allowed.high)) continue;
      to_extreme(c, field, one_in(2));
    }
    return c;
  }

  std::mt19937_64 random_;
  const bool is_small_;
};

}  // namespace

bool to_extreme(Config& c, const ConfigField& number, bool is_smallest) {
  if (!number.is_number() || number.get(c) == 0) return false;
  const int low = number.allowed.low, high = number.allowed.high;
  for (int n = low; n <= high; ++n) {
    Config with = c;
    number.set(with, is_smallest ? n : high - (n - low));
    if (refusal(with) != Refusal::kNone) continue;
    c = with;
    return true;
  }
  return false;
}

Configuration random_configuration(std::uint64_t seed, bool is_small) {
  return Configuration(fmt::format("random_{}", seed), Drawing(seed, is_small).accepted());
}

}  // namespace halfspace::model
