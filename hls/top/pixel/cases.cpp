// SPDX-License-Identifier: Apache-2.0
// Cases of a function, of the words of a vector set: a line each, what is expected and the arguments, in hexadecimal.
// Status 1 if the function natively returns something else, or if there is no case.
// Usage: cases FUNCTION VECTORS [FRAMES]
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "hls/top/bench/bench.hpp"
#include "hls/top/pixel/functions.hpp"

namespace halfspace {
namespace {

using F = TopFormats;
using Elements = std::vector<std::uint64_t>;

template <class R>
Elements elements_of(const R& record) {
  Packed<R> word = packed(record);
  Elements out;
  for (int lsb = 0; lsb < PackedBits<R>::kBits; lsb += 64) {
    std::uint64_t element = 0;
    for (int i = 0; i < 64 && lsb + i < PackedBits<R>::kBits; ++i) element |= bits<1>(word, lsb + i) << i;
    out.push_back(element);
  }
  return out;
}
template <class R>
std::uint64_t word_of(R record) {
  record.last = from_raw<Bit>(0);
  return elements_of(record)[0];
}

long cases = 0, wrong = 0;

void print_case(std::uint64_t expected, std::uint64_t got, const std::vector<Elements>& arguments) {
  ++cases;
  wrong += got != expected;
  std::printf("%" PRIx64, expected);
  for (const Elements& argument : arguments) {
    for (const std::uint64_t element : argument) std::printf(" %" PRIx64, element);
  }
  std::printf("\n");
}

// The words of TdbS, by their index.
template <class R>
class Database {
 public:
  void load(Bench& bench, const char* stream) {
    for (const R& word : bench.records<R>(stream)) {
      if (!is_set(word.empty)) words_[int(raw(word.index))] = word;
    }
  }
  const R& operator[](const typename F::Index& index) const { return words_.at(int(raw(index))); }

 private:
  std::map<int, R> words_;
};

// Calls print(scan, n) for each pixel that shows a triangle.
template <class Print>
void covered_pixels(Bench& bench, const Print& print) {
  const std::vector<Scan<F>> scan = bench.records<Scan<F>>("scan");
  for (std::size_t n = 0; n < scan.size(); ++n) {
    if (is_set(scan[n].index[0])) print(scan[n], n);
  }
}

void cases_of_gouraud_pixel(Bench& bench) {
  static Database<Planes<F>> planes;
  planes.load(bench, "planes");
  const std::vector<Pixel<F>> pixel = bench.records<Pixel<F>>("pixel");
  covered_pixels(bench, [&](const Scan<F>& in, std::size_t n) {
    const Elements s = elements_of(in), p = elements_of(planes[in.index[0]]);
    print_case(word_of(pixel[n]), gouraud_pixel(s[0], p[0], p[1], p[2], p[3]), {s, p});
  });
}

void cases_of_phong_pixel(Bench& bench) {
  static Database<NormalPlanes<F>> planes;
  static std::map<int, Material<F>> materials;
  static Light<F> light;
  planes.load(bench, "planes");
  for (const Light<F>& word : bench.records<Light<F>>("light")) light = word;
  for (const Material<F>& word : bench.records<Material<F>>("material")) materials[int(raw(word.material))] = word;
  const std::vector<Pixel<F>> pixel = bench.records<Pixel<F>>("pixel");
  covered_pixels(bench, [&](const Scan<F>& in, std::size_t n) {
    const NormalPlanes<F>& of = planes[in.index[0]];
    const Elements s = elements_of(in), p = elements_of(of), l = elements_of(light),
                   m = elements_of(materials.at(int(raw(of.material))));
    const std::uint64_t got = phong_pixel(s[0], p[0], p[1], p[2], p[3], l[0], l[1], m[0], m[1], m[2]);
    print_case(word_of(pixel[n]), got, {s, p, l, m});
  });
}

// Natively the address finds the texel, whose colour makes that of the set.
struct TexturedCase {
  Elements scan, planes, texture;
  std::uint64_t address, lit, texel, pixel;
};
template <class Print>
void textured_cases(Bench& bench, const Print& print) {
  static Database<TexturePlanes<F>> planes;
  static std::map<int, TextureEntry<F>> textures;
  static std::map<std::uint64_t, std::uint64_t> texels;
  planes.load(bench, "texture_planes");
  for (const TextureEntry<F>& word : bench.records<TextureEntry<F>>("texture")) {
    textures[int(raw(word.texture))] = word;
  }
  for (const Texel<F>& word : bench.records<Texel<F>>("texel")) {
    TexelColour<F> colour;
    colour.r = word.r;
    colour.g = word.g;
    colour.b = word.b;
    texels[std::uint64_t(raw(word.address))] = elements_of(colour)[0];
  }
  const std::vector<Pixel<F>> lit = bench.records<Pixel<F>>("lit"), pixel = bench.records<Pixel<F>>("pixel");
  covered_pixels(bench, [&](const Scan<F>& in, std::size_t n) {
    const TexturePlanes<F>& of = planes[in.index[0]];
    if (!is_set(of.texture)) return;
    const Elements p = elements_of(of), t = elements_of(textures.at(int(raw(of.texture))));
    const std::uint64_t address = texel_address(elements_of(in)[0], p[0], p[1], p[2], p[3], t[0]);
    print(TexturedCase{elements_of(in), p, t, address, word_of(lit[n]), texels.at(address), word_of(pixel[n])});
  });
}
void cases_of_texel_address(Bench& bench) {
  textured_cases(bench, [](const TexturedCase& of) {
    print_case(of.address, of.address, {of.scan, of.planes, of.texture});
  });
}
void cases_of_textured_pixel(Bench& bench) {
  textured_cases(bench, [](const TexturedCase& of) {
    print_case(of.pixel, textured_pixel(of.lit, of.texel), {{of.lit}, {of.texel}});
  });
}

void cases_of_motion_vector(Bench& bench) {
  static Database<MotionPlanes<F>> planes;
  planes.load(bench, "motion_planes");
  const std::vector<Motion<F>> motion = bench.records<Motion<F>>("motion");
  std::size_t sent = 0;
  covered_pixels(bench, [&](const Scan<F>& in, std::size_t) {
    const std::uint64_t expected = bits<1 + 2 * F::Vector::kWidth>(packed(motion[sent++]), 0);
    const Elements s = elements_of(in), p = elements_of(planes[in.index[0]]);
    print_case(expected, motion_vector(s[0], p[0], p[1], p[2], p[3], p[4], p[5], p[6]), {s, p});
  });
}

void cases_of_merged_stamp(Bench& bench) {
  const Merge<F> run = bench.records<Merge<F>>("merge")[0];
  const std::vector<Entry<F>> stored = bench.records<Entry<F>>("stored"), entry = bench.records<Entry<F>>("entry"),
                              merged = bench.records<Entry<F>>("merged");
  for (std::size_t n = 0; n < merged.size(); ++n) {
    Entry<F> in = stored[n], drawn = is_set(run.merges) ? entry[n] : in;
    in.last = drawn.last = from_raw<Bit>(0);
    const Elements m = elements_of(run), s = elements_of(in), e = elements_of(drawn);
    print_case(word_of(merged[n]), merged_stamp(m[0], s[0], e[0]), {m, s, e});
  }
}

}  // namespace
}  // namespace halfspace

int main(int argc, char** argv) {
  using namespace halfspace;
  const struct {
    const char* name;
    void (*cases)(Bench& bench);
  } functions[] = {{"gouraud_pixel", cases_of_gouraud_pixel}, {"phong_pixel", cases_of_phong_pixel},
                   {"texel_address", cases_of_texel_address}, {"textured_pixel", cases_of_textured_pixel},
                   {"motion_vector", cases_of_motion_vector}, {"merged_stamp", cases_of_merged_stamp}};
  for (const auto& function : functions) {
    if (argc < 3 || std::strcmp(argv[1], function.name) != 0) continue;
    Bench bench(function.name, argv[2], argc > 3 ? std::atoi(argv[3]) : 0);
    while (bench.next()) function.cases(bench);
    std::fprintf(stderr, "%s: %ld cases, %ld wrong\n", function.name, cases, wrong);
    return cases > 0 && wrong == 0 ? 0 : 1;
  }
  std::fprintf(stderr, "usage: cases FUNCTION VECTORS [FRAMES]: one of functions.hpp, and a set at one lane\n");
  return 2;
}
