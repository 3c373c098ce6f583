// SPDX-License-Identifier: Apache-2.0
#include "model/formats/configuration.hpp"

#include <fmt/format.h>
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include "hls/formats/configs/high.hpp"
#include "hls/formats/configs/low.hpp"
#include "hls/formats/configs/middle.hpp"
#include "ref/error.hpp"

namespace halfspace::model {

const std::vector<ConfigField>& config_fields() {
  static const std::vector<ConfigField> fields = {
      {"width", &Config::width, "largest frame, pixels"},
      {"height", &Config::height, ""},
      {"triangles", &Config::triangles, "a frame"},
      {"range_bits", &Config::range_bits, "vertices lie within ±2^(range_bits−1) pixels: the guard band"},
      {"subpixel_bits", &Config::subpixel_bits, "f: fraction bits of a vertex position"},
      {"depth_bits", &Config::depth_bits, "of a depth that is compared; 0: no depth, the first drawn wins each pixel"},
      {"colour_bits", &Config::colour_bits, "of a channel"},
      {"reciprocal_bits", &Config::reciprocal_bits,
       "r: fraction bits of the reciprocal of the area; 0 without depth and flat"},
      {"depth_fraction", &Config::depth_fraction, "g: fraction bits of the gradients of depth; 0 without depth"},
      {"colour_fraction", &Config::colour_fraction, "g: fraction bits of the gradients of colour; 0 if flat"},
      {"lanes", &Config::lanes, "pixels a cycle, where the command line says nothing"}};
  return fields;
}

const std::vector<ConfigField>& lighting_fields() {
  static const std::vector<ConfigField> fields = {
      {"normal_bits", &Config::normal_bits, "p: fraction bits of a component of a normal"},
      {"lights", &Config::lights, "that are built, 1 to 4"},
      {"gloss", &Config::gloss, "largest exponent of a highlight: 1, 2, 4, 8, 16; 0: no highlights"},
      {"materials", &Config::materials, "a frame"},
      {"normal_fraction", &Config::normal_fraction,
       "g: fraction bits of the gradients of normals; 0 but for \"phong\""}};
  return fields;
}

const std::vector<ConfigField>& texture_fields() {
  static const std::vector<ConfigField> fields = {
      {"texels", &Config::texels, "of the texture memory, a power of two"},
      {"textures", &Config::textures, "a frame"},
      {"coordinate_bits", &Config::coordinate_bits, "b: of a texture coordinate"},
      {"coordinate_fraction", &Config::coordinate_fraction,
       "g: fraction bits of the gradients of texture coordinates"}};
  return fields;
}

const std::vector<ConfigField>& motion_fields() {
  static const std::vector<ConfigField> fields = {
      {"coordinate_bits", &Config::coordinate_bits, "b: of a place in a key frame"},
      {"coordinate_fraction", &Config::coordinate_fraction, "g: fraction bits of the gradients of places"},
      {"vector_range", &Config::vector_range, "components of a vector lie in [−2^vector_range, 2^vector_range) pixels"},
      {"vector_fraction", &Config::vector_fraction, "and are multiples of 2^−vector_fraction"},
      {"weight_bits", &Config::weight_bits,
       "weights of key frames and of their pixels are multiples of 2^−weight_bits"},
      {"face_bits", &Config::face_bits, "of the number of a face, 1 … 2^face_bits − 1"},
      {"relight", &Config::relight, "1: planes of what a colour differs by from a key's"},
      {"samples", &Config::samples, "pixels in between a pixel of a key frame, each way: 1, 2, 4"}};
  return fields;
}

const std::vector<ConfigField>& object_fields() {
  static const std::vector<ConfigField> fields = {
      {"object_bits", &Config::object_bits,
       "of the number of an object in a pixel, for static objects buffers; 0: none"}};
  return fields;
}

namespace {

template <auto Member>
ChoiceField choice(const char* name, const char* what, std::vector<const char*> values) {
  using Value = std::decay_t<decltype(std::declval<Config>().*Member)>;
  return {name, what, std::move(values), [](const Config& c) { return int(c.*Member); },
          [](Config& c, int value) { c.*Member = static_cast<Value>(value); }};
}

}  // namespace

const std::vector<ChoiceField>& choice_fields() {
  static const std::vector<ChoiceField> fields = {
      choice<&Config::shading>(
          "shading",
          "\"gouraud\", \"flat\": a triangle has the colour of its first vertex, \"phong\": each visible pixel is "
          "lit, or \"motion\": a frame between two key frames",
          {"gouraud", "flat", "phong", "motion"}),
      choice<&Config::architecture>("architecture",
                                    "\"delta\": a Z-buffer, or \"gamma\": none, depth is computed again from TdbV",
                                    {"delta", "gamma"}),
      choice<&Config::texture>(
          "texture", "\"none\", \"nearest\": the texel at a pixel's centre, or \"bilinear\": four of them, weighted",
          {"none", "nearest", "bilinear"}),
      choice<&Config::mapping>(
          "mapping",
          "\"affine\": planes of u and v, or \"perspective\": planes of u/w, v/w, 1/w and a division a pixel",
          {"affine", "perspective"}),
      choice<&Config::filter>(
          "filter",
          "of key frames: \"nearest\" pixel, \"bilinear\", \"area\": weighted by area and distance, or \"bicubic\"",
          {"none", "nearest", "bilinear", "area", "bicubic"})};
  return fields;
}

const ChoiceField& choice_field(const std::string& name) {
  for (const ChoiceField& field : choice_fields()) {
    if (name == field.name) return field;
  }
  throw std::logic_error("there is no choice " + name);
}

void set_choice(Config& c, const std::string& field, const std::string& value) {
  const ChoiceField& choice = choice_field(field);
  choice.set(c, int(std::find(choice.values.begin(), choice.values.end(), value) - choice.values.begin()));
}

const char* choice_name(const std::string& field, const Config& c) {
  const ChoiceField& choice = choice_field(field);
  return choice.values[choice.get(c)];
}

namespace {

// Fields whose numbers are 0 where the part that they belong to is not there.
std::vector<const std::vector<ConfigField>*> number_fields() {
  return {&config_fields(), &lighting_fields(), &texture_fields(), &motion_fields(), &object_fields()};
}

}  // namespace

bool same_numbers(const Config& a, const Config& b) {
  for (const ChoiceField& field : choice_fields()) {
    if (field.get(a) != field.get(b)) return false;
  }
  for (const auto* fields : number_fields()) {
    for (const ConfigField& field : *fields) {
      if (a.*field.value != b.*field.value) return false;
    }
  }
  return true;
}

std::string refusal_text(Refusal refusal) {
  switch (refusal) {
    case Refusal::kNone: return "it is accepted";
    case Refusal::kFrameSize: return "width and height are 1 to 8192 pixels";
    case Refusal::kTriangles: return "triangles is 1 to 4194304";
    case Refusal::kSubpixelBits: return "subpixel_bits is 1 to 12";
    case Refusal::kDepthBits: return "depth_bits is 2 to 32, or 0 for no depth";
    case Refusal::kColourBits: return "colour_bits is 1 to 8";
    case Refusal::kLanes: return "lanes is 1, 2, 4, 8 or 16";
    case Refusal::kFractionBits:
      return "reciprocal_bits is 2 to 40, depth_fraction, colour_fraction, normal_fraction and coordinate_fraction are "
             "1 to 40";
    case Refusal::kIdleBits:
      return "numbers of what is not there are 0: depth_fraction where depth_bits is 0, colour_fraction where shading "
             "is not \"gouraud\" "
             "and nothing is relit, normal_fraction where it is not \"phong\", reciprocal_bits where there is no depth "
             "and no texture and shading is \"flat\"";
    case Refusal::kUnlitPhong:
      return "shading \"phong\" lights the pixels, and there are no lights: raise lights, or shade otherwise";
    case Refusal::kIdleArchitecture:
      return "architecture \"gamma\" computes a depth again, and there is none: raise depth_bits, or leave the "
             "architecture out";
    case Refusal::kFrameOutsideRange:
      return "the frame and 12 pixels around it do not lie within the range of positions: raise range_bits (20 at "
             "most) or make "
             "the frame smaller";
    case Refusal::kDepthError:
      return "the depth planes can be off by half an LSB or more: raise reciprocal_bits or depth_fraction";
    case Refusal::kColourError:
      return "the colour planes can be off by half an LSB or more: raise reciprocal_bits or colour_fraction";
    case Refusal::kNormalError:
      return "the planes of normals can be off by half a unit of 2^-normal_bits or more: raise reciprocal_bits or "
             "normal_fraction";
    case Refusal::kCoordinateError:
      return "the planes of texture coordinates can be off by half a unit or more: raise reciprocal_bits or "
             "coordinate_fraction, or "
             "lower coordinate_bits";
    case Refusal::kReciprocalShort:
      return "a gradient would keep more fraction bits than its reciprocal has: reciprocal_bits is subpixel_bits + the "
             "largest of "
             "depth_fraction, colour_fraction, normal_fraction and coordinate_fraction, or more";
    case Refusal::kEdgeWord: return "an edge function is wider than 64 bits: lower range_bits or subpixel_bits";
    case Refusal::kNumeratorWord:
      return "the numerator of a gradient is wider than 64 bits: lower depth_bits, coordinate_bits, range_bits or "
             "subpixel_bits";
    case Refusal::kGradientWord:
      return "half the product with the reciprocal is wider than 64 bits: lower reciprocal_bits, depth_bits, "
             "coordinate_bits or "
             "range_bits";
    case Refusal::kStartWord:
      return "the start of a plane is wider than 63 bits: lower depth_fraction, colour_fraction, normal_fraction, "
             "coordinate_fraction "
             "or subpixel_bits";
    case Refusal::kShadeWord:
      return "a gradient of colour, normals or texture coordinates times a coordinate is wider than 64 bits: lower its "
             "fraction";
    case Refusal::kTestWord:
      return "a depth gradient times a coordinate, which architecture \"gamma\" needs, is wider than 64 bits: lower "
             "depth_fraction";
    case Refusal::kNormalBits: return "normal_bits is 9 to 16";
    case Refusal::kLights: return "lights is 1 to 4, or 0 for no lighting";
    case Refusal::kGloss: return "gloss is 1, 2, 4, 8 or 16, or 0 for no highlights";
    case Refusal::kMaterials: return "materials is 1 to 4096";
    case Refusal::kIdleLighting: return "normal_bits, gloss and materials are 0 where lights is 0";
    case Refusal::kCoordinateBits: return "coordinate_bits is 10 to 24";
    case Refusal::kTexels: return "texels is a power of two, 4 to 1048576";
    case Refusal::kTextures: return "textures is 1 to 256";
    case Refusal::kIdleTexture:
      return "texels and textures are 0 where texture is \"none\"; so are coordinate_bits and coordinate_fraction, and "
             "mapping is "
             "\"affine\", where shading is not \"motion\" either";
    case Refusal::kMotionShading:
      return "shading \"motion\" takes no lights and no texture: frames in between have the colours of the key frames";
    case Refusal::kFilter:
      return "shading \"motion\" takes a filter: \"nearest\", \"bilinear\", \"area\" or \"bicubic\"";
    case Refusal::kVector: return "vector_range is 1 to 13, vector_fraction 1 to 8";
    case Refusal::kWeightBits: return "weight_bits is 2 to 8";
    case Refusal::kFaceBits: return "face_bits is 1 to 22";
    case Refusal::kRelight: return "relight is 0 or 1";
    case Refusal::kSamples: return "samples is 1, 2 or 4";
    case Refusal::kIdleMotion:
      return "filter is \"none\", and vector_range, vector_fraction, weight_bits, face_bits, relight and samples are "
             "0, where shading is "
             "not \"motion\"";
    case Refusal::kObjectBits: return "object_bits is 0 to 22";
    case Refusal::kObjectsNeedDepth:
      return "object_bits is 0 without a Z-buffer, with architecture \"gamma\" and with shading \"motion\": a merge "
             "compares the depths "
             "of a Z-buffer";
  }
  return "unknown reason";
}

Configuration::Configuration(std::string name, const Config& numbers) : name_(std::move(name)), numbers_(numbers) {
  const bool plain =
      std::all_of(name_.begin(), name_.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
  if (name_.empty() || !plain) {
    throw ref::Error(fmt::format("configuration '{}': a name has letters, digits, '_' and '-' only", name_));
  }
  if (const Refusal reason = refusal(numbers_); reason != Refusal::kNone) {
    throw ref::Error(fmt::format("configuration {} is refused: {}", name_, refusal_text(reason)));
  }
}

Config Configuration::config() const {
  Config c = numbers_;
  c.name = name_.c_str();
  return c;
}

const std::vector<Configuration>& named_configurations() {
  static const std::vector<Configuration> named = {
      {"low", Low::config()}, {"middle", Middle::config()}, {"high", High::config()}};
  return named;
}

Configuration find_configuration(const std::string& name_or_path) {
  for (const Configuration& c : named_configurations()) {
    if (c.name() == name_or_path) return c;
  }
  const std::string ending = ".toml";
  if (name_or_path.size() <= ending.size() ||
      name_or_path.compare(name_or_path.size() - ending.size(), ending.size(), ending) != 0) {
    throw ref::Error(
        fmt::format("there is no configuration '{}': use low, middle, high or the path of a .toml file", name_or_path));
  }
  std::ifstream file(name_or_path);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) {
    throw ref::Error(fmt::format("{}: cannot be read: check the path of the configuration", name_or_path));
  }
  return parse_configuration(text.str(), name_or_path);
}

Configuration parse_configuration(const std::string& text, const std::string& source) {
  toml::table table;
  try {
    table = toml::parse(text);
  } catch (const toml::parse_error& e) {
    throw ref::Error(fmt::format("{}:{}: {}: write a line `name = value` a field", source, e.source().begin.line,
                                 std::string(e.description())));
  }
  Config numbers{};
  std::string name;
  for (const auto& [key, node] : table) {
    const std::string field(key.str());
    const auto line = node.source().begin.line;
    if (field == "name") {
      const auto value = node.value_exact<std::string>();
      if (!value) throw ref::Error(fmt::format("{}:{}: name is a string in quotes", source, line));
      name = *value;
      continue;
    }
    const auto chosen = std::find_if(choice_fields().begin(), choice_fields().end(),
                                     [&](const ChoiceField& f) { return field == f.name; });
    if (chosen != choice_fields().end()) {
      const auto value = node.value_exact<std::string>();
      const auto& values = chosen->values;
      const auto found =
          std::find_if(values.begin(), values.end(), [&](const char* v) { return value && *value == v; });
      if (found == values.end()) {
        std::string known;
        for (std::size_t i = 0; i < values.size(); ++i) {
          known += fmt::format("{}\"{}\"", i == 0 ? "" : i + 1 == values.size() ? " or " : ", ", values[i]);
        }
        throw ref::Error(fmt::format("{}:{}: {} is {}", source, line, field, known));
      }
      chosen->set(numbers, int(found - values.begin()));
      continue;
    }
    const ConfigField* at = nullptr;
    for (const auto* fields : number_fields()) {
      for (const ConfigField& f : *fields) {
        if (field == f.name) at = &f;
      }
    }
    if (!at) {
      std::string known = "name";
      for (const ChoiceField& f : choice_fields()) known += fmt::format(", {}", f.name);
      for (const auto* fields : number_fields()) {
        for (const ConfigField& f : *fields) {
          if (known.find(fmt::format(", {}", f.name)) == std::string::npos) known += fmt::format(", {}", f.name);
        }
      }
      throw ref::Error(fmt::format("{}:{}: there is no field '{}': the fields are {}", source, line, field, known));
    }
    const auto value = node.value_exact<std::int64_t>();
    if (!value || *value < 0 || *value > 1 << 30) {
      throw ref::Error(fmt::format("{}:{}: {} is a whole number of 0 or more", source, line, field));
    }
    numbers.*at->value = int(*value);
  }
  if (name.empty()) throw ref::Error(fmt::format("{}: the field 'name' is missing: add a line name = \"…\"", source));
  for (const ConfigField& f : config_fields()) {
    if (!table.contains(f.name)) {
      throw ref::Error(fmt::format("{}: the field '{}' is missing: add a line {} = …", source, f.name, f.name));
    }
  }
  try {
    return Configuration(name, numbers);
  } catch (const ref::Error& e) {
    throw ref::Error(fmt::format("{}: {}", source, e.what()));
  }
}

std::string configuration_toml(const Configuration& configuration) {
  std::string text = fmt::format("name = \"{}\"\n", configuration.name());
  const Config c = configuration.config();
  for (const ConfigField& field : config_fields()) {
    const std::string line = fmt::format("{} = {}", field.name, c.*field.value);
    text += *field.what ? fmt::format("{:<23} # {}\n", line, field.what) : line + "\n";
  }
  const auto choice = [&](const char* name) {
    text +=
        fmt::format("{:<23} # {}\n", fmt::format("{} = \"{}\"", name, choice_name(name, c)), choice_field(name).what);
  };
  choice("shading");
  choice("architecture");
  const auto numbers = [&](const std::vector<ConfigField>& fields) {
    for (const ConfigField& field : fields) {
      text += fmt::format("{:<23} # {}\n", fmt::format("{} = {}", field.name, c.*field.value), field.what);
    }
  };
  if (has_lighting(c)) numbers(lighting_fields());
  if (has_texture(c)) {
    choice("texture");
    choice("mapping");
    numbers(texture_fields());
  }
  if (has_motion(c)) {
    choice("mapping");
    choice("filter");
    numbers(motion_fields());
  }
  if (has_objects(c)) numbers(object_fields());
  return text;
}

std::string configuration_header(const Configuration& configuration) {
  std::string type, numbers, guard;
  bool upper = true;
  for (const char c : configuration.name()) {
    const bool letter = std::isalnum(static_cast<unsigned char>(c));
    guard += letter ? char(std::toupper(static_cast<unsigned char>(c))) : '_';
    if (letter) type += upper ? char(std::toupper(static_cast<unsigned char>(c))) : c;
    upper = !letter;
  }
  if (type.empty() || std::isdigit(static_cast<unsigned char>(type[0]))) type = "Configuration" + type;
  const Config c = configuration.config();
  for (const ConfigField& field : config_fields()) numbers += fmt::format(", {}", c.*field.value);
  const auto value = [](const char* type, const char* name) {
    std::string text(name);
    text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
    return fmt::format(", {}::k{}", type, text);
  };
  numbers += value("Shading", choice_name("shading", c));
  // What stands in Config is not said again.
  const bool past_architecture = has_lighting(c) || has_coordinates(c) || has_objects(c);
  if (c.architecture == Architecture::kGamma || past_architecture)
    numbers += value("Architecture", choice_name("architecture", c));
  if (past_architecture) {
    for (const ConfigField& field : lighting_fields()) numbers += fmt::format(", {}", c.*field.value);
  }
  const bool past_lighting = has_coordinates(c) || has_objects(c);
  if (past_lighting) {
    numbers += value("TextureFilter", choice_name("texture", c)) + value("TextureMapping", choice_name("mapping", c));
    for (const ConfigField& field : texture_fields()) numbers += fmt::format(", {}", c.*field.value);
  }
  if (has_motion(c) || has_objects(c)) {
    numbers += value("KeyFilter", choice_name("filter", c));
    for (const ConfigField& field : motion_fields()) {
      if (std::string(field.name).rfind("coordinate", 0) != 0) numbers += fmt::format(", {}", c.*field.value);
    }
  }
  if (has_objects(c)) numbers += fmt::format(", {}", c.object_bits);
  return fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Configuration `{0}` for the kernels, in the order of Config. Printed by `halfspace config {0} --header FILE` "
      "from its\n"
      "// .toml file: change that, not this one.\n"
      "#ifndef HALFSPACE_CONFIGS_{1}_HPP_\n"
      "#define HALFSPACE_CONFIGS_{1}_HPP_\n\n"
      "#include \"hls/formats/config.hpp\"\n\n"
      "namespace halfspace {{\n\n"
      "struct {2} {{\n"
      "  static constexpr Config config() {{ return {{\"{0}\"{3}}}; }}\n"
      "}};\n\n"
      "}}  // namespace halfspace\n\n"
      "#endif  // HALFSPACE_CONFIGS_{1}_HPP_\n",
      configuration.name(), guard, type, numbers);
}

ref::RasterFormat raster_format(const Configuration& configuration) {
  const Config c = configuration.config();
  return {configuration.name(), c.width,       c.height,
          c.triangles,          c.range_bits,  c.subpixel_bits,
          c.depth_bits,         c.colour_bits, c.shading == Shading::kFlat};
}

}  // namespace halfspace::model
