// SPDX-License-Identifier: Apache-2.0
#include "vectors/configuration.hpp"

#include <fmt/format.h>
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "hls/configs/high.hpp"
#include "hls/configs/low.hpp"
#include "hls/configs/middle.hpp"
#include "ref/error.hpp"

namespace halfspace::vectors {

const std::vector<ConfigField>& config_fields() {
  static const std::vector<ConfigField> fields = {
      {"width", &Config::width, "largest frame, pixels"},
      {"height", &Config::height, ""},
      {"triangles", &Config::triangles, "a frame"},
      {"range_bits", &Config::range_bits, "vertices lie within ±2^(range_bits−1) pixels: the guard band"},
      {"subpixel_bits", &Config::subpixel_bits, "f: fraction bits of a vertex position"},
      {"depth_bits", &Config::depth_bits, "of a depth that is compared; 0: no depth, the first drawn wins each pixel"},
      {"colour_bits", &Config::colour_bits, "of a channel"},
      {"reciprocal_bits", &Config::reciprocal_bits, "r: fraction bits of the reciprocal of the area; 0 without depth and flat"},
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
      {"normal_fraction", &Config::normal_fraction, "g: fraction bits of the gradients of normals; 0 but for \"phong\""}};
  return fields;
}

const std::vector<ConfigField>& texture_fields() {
  static const std::vector<ConfigField> fields = {
      {"texels", &Config::texels, "of the texture memory, a power of two"},
      {"textures", &Config::textures, "a frame"},
      {"coordinate_bits", &Config::coordinate_bits, "b: of a texture coordinate"},
      {"coordinate_fraction", &Config::coordinate_fraction, "g: fraction bits of the gradients of texture coordinates"}};
  return fields;
}

const char* const kTextureWhat = "\"none\", \"nearest\": the texel at a pixel's centre, or \"bilinear\": four of them, weighted";

const char* texture_name(TextureFilter filter) {
  return filter == TextureFilter::kNone ? "none" : filter == TextureFilter::kNearest ? "nearest" : "bilinear";
}

const char* const kMappingWhat = "\"affine\": planes of u and v, or \"perspective\": planes of u/w, v/w, 1/w and a division a pixel";

const char* mapping_name(TextureMapping mapping) { return mapping == TextureMapping::kPerspective ? "perspective" : "affine"; }

const char* const kShadingWhat =
    "\"gouraud\", \"flat\": a triangle has the colour of its first vertex, or \"phong\": each visible pixel is lit";

const char* shading_name(Shading shading) {
  return shading == Shading::kFlat ? "flat" : shading == Shading::kPhong ? "phong" : "gouraud";
}

const char* const kArchitectureWhat = "\"delta\": a Z-buffer, or \"gamma\": none, depth is computed again from TdbV";

const char* architecture_name(Architecture architecture) { return architecture == Architecture::kGamma ? "gamma" : "delta"; }

bool same_numbers(const Config& a, const Config& b) {
  if (a.shading != b.shading || a.architecture != b.architecture || a.texture != b.texture || a.mapping != b.mapping) return false;
  for (const auto* fields : {&config_fields(), &lighting_fields(), &texture_fields()}) {
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
      return "reciprocal_bits is 2 to 40, depth_fraction, colour_fraction, normal_fraction and coordinate_fraction are 1 to 40";
    case Refusal::kIdleBits:
      return "numbers of what is not there are 0: depth_fraction where depth_bits is 0, colour_fraction where shading is not \"gouraud\", "
             "normal_fraction where it is not \"phong\", reciprocal_bits where there is no depth and no texture and shading is \"flat\"";
    case Refusal::kUnlitPhong: return "shading \"phong\" lights the pixels, and there are no lights: raise lights, or shade otherwise";
    case Refusal::kIdleArchitecture:
      return "architecture \"gamma\" computes a depth again, and there is none: raise depth_bits, or leave the architecture out";
    case Refusal::kFrameOutsideRange:
      return "the frame and 12 pixels around it do not lie within the range of positions: raise range_bits (20 at most) or make "
             "the frame smaller";
    case Refusal::kDepthError:
      return "the depth planes can be off by half an LSB or more: raise reciprocal_bits or depth_fraction";
    case Refusal::kColourError:
      return "the colour planes can be off by half an LSB or more: raise reciprocal_bits or colour_fraction";
    case Refusal::kNormalError:
      return "the planes of normals can be off by half a unit of 2^-normal_bits or more: raise reciprocal_bits or normal_fraction";
    case Refusal::kCoordinateError:
      return "the planes of texture coordinates can be off by half a unit or more: raise reciprocal_bits or coordinate_fraction, or "
             "lower coordinate_bits";
    case Refusal::kReciprocalShort:
      return "a gradient would keep more fraction bits than its reciprocal has: reciprocal_bits is subpixel_bits + the largest of "
             "depth_fraction, colour_fraction, normal_fraction and coordinate_fraction, or more";
    case Refusal::kEdgeWord:
      return "an edge function is wider than 64 bits: lower range_bits or subpixel_bits";
    case Refusal::kNumeratorWord:
      return "the numerator of a gradient is wider than 64 bits: lower depth_bits, coordinate_bits, range_bits or subpixel_bits";
    case Refusal::kGradientWord:
      return "half the product with the reciprocal is wider than 64 bits: lower reciprocal_bits, depth_bits, coordinate_bits or "
             "range_bits";
    case Refusal::kStartWord:
      return "the start of a plane is wider than 63 bits: lower depth_fraction, colour_fraction, normal_fraction, coordinate_fraction "
             "or subpixel_bits";
    case Refusal::kShadeWord:
      return "a gradient of colour, normals or texture coordinates times a coordinate is wider than 64 bits: lower its fraction";
    case Refusal::kTestWord:
      return "a depth gradient times a coordinate, which architecture \"gamma\" needs, is wider than 64 bits: lower depth_fraction";
    case Refusal::kNormalBits: return "normal_bits is 9 to 16";
    case Refusal::kLights: return "lights is 1 to 4, or 0 for no lighting";
    case Refusal::kGloss: return "gloss is 1, 2, 4, 8 or 16, or 0 for no highlights";
    case Refusal::kMaterials: return "materials is 1 to 4096";
    case Refusal::kIdleLighting: return "normal_bits, gloss and materials are 0 where lights is 0";
    case Refusal::kCoordinateBits: return "coordinate_bits is 10 to 24";
    case Refusal::kTexels: return "texels is a power of two, 4 to 1048576";
    case Refusal::kTextures: return "textures is 1 to 256";
    case Refusal::kIdleTexture:
      return "texels, textures, coordinate_bits and coordinate_fraction are 0, and mapping \"affine\", where texture is \"none\"";
  }
  return "unknown reason";
}

Configuration::Configuration(std::string name, const Config& numbers) : name_(std::move(name)), numbers_(numbers) {
  const bool plain = std::all_of(name_.begin(), name_.end(), [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; });
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
    throw ref::Error(fmt::format("there is no configuration '{}': use low, middle, high or the path of a .toml file", name_or_path));
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
    if (field == "shading") {
      const auto value = node.value_exact<std::string>();
      if (!value || (*value != "gouraud" && *value != "flat" && *value != "phong")) {
        throw ref::Error(fmt::format("{}:{}: shading is \"gouraud\", \"flat\" or \"phong\"", source, line));
      }
      numbers.shading = *value == "flat" ? Shading::kFlat : *value == "phong" ? Shading::kPhong : Shading::kGouraud;
      continue;
    }
    if (field == "architecture") {
      const auto value = node.value_exact<std::string>();
      if (!value || (*value != "delta" && *value != "gamma")) {
        throw ref::Error(fmt::format("{}:{}: architecture is \"delta\" or \"gamma\"", source, line));
      }
      numbers.architecture = *value == "gamma" ? Architecture::kGamma : Architecture::kDelta;
      continue;
    }
    if (field == "texture") {
      const auto value = node.value_exact<std::string>();
      if (!value || (*value != "none" && *value != "nearest" && *value != "bilinear")) {
        throw ref::Error(fmt::format("{}:{}: texture is \"none\", \"nearest\" or \"bilinear\"", source, line));
      }
      numbers.texture = *value == "none"      ? TextureFilter::kNone
                        : *value == "nearest" ? TextureFilter::kNearest
                                              : TextureFilter::kBilinear;
      continue;
    }
    if (field == "mapping") {
      const auto value = node.value_exact<std::string>();
      if (!value || (*value != "affine" && *value != "perspective")) {
        throw ref::Error(fmt::format("{}:{}: mapping is \"affine\" or \"perspective\"", source, line));
      }
      numbers.mapping = *value == "affine" ? TextureMapping::kAffine : TextureMapping::kPerspective;
      continue;
    }
    std::vector<ConfigField> fields = config_fields();
    fields.insert(fields.end(), lighting_fields().begin(), lighting_fields().end());
    fields.insert(fields.end(), texture_fields().begin(), texture_fields().end());
    const auto at = std::find_if(fields.begin(), fields.end(), [&](const ConfigField& f) { return field == f.name; });
    if (at == fields.end()) {
      std::string known = "name";
      for (const ConfigField& f : config_fields()) known += fmt::format(", {}", f.name);
      known += ", shading, architecture";
      for (const ConfigField& f : lighting_fields()) known += fmt::format(", {}", f.name);
      known += ", texture, mapping";
      for (const ConfigField& f : texture_fields()) known += fmt::format(", {}", f.name);
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
  text += fmt::format("{:<23} # {}\n", fmt::format("shading = \"{}\"", shading_name(c.shading)), kShadingWhat);
  text += fmt::format("{:<23} # {}\n", fmt::format("architecture = \"{}\"", architecture_name(c.architecture)), kArchitectureWhat);
  const auto numbers = [&](const std::vector<ConfigField>& fields) {
    for (const ConfigField& field : fields) {
      text += fmt::format("{:<23} # {}\n", fmt::format("{} = {}", field.name, c.*field.value), field.what);
    }
  };
  if (has_lighting(c)) numbers(lighting_fields());
  if (!has_texture(c)) return text;
  text += fmt::format("{:<23} # {}\n", fmt::format("texture = \"{}\"", texture_name(c.texture)), kTextureWhat);
  text += fmt::format("{:<23} # {}\n", fmt::format("mapping = \"{}\"", mapping_name(c.mapping)), kMappingWhat);
  numbers(texture_fields());
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
  numbers += c.shading == Shading::kFlat ? ", Shading::kFlat" : c.shading == Shading::kPhong ? ", Shading::kPhong" : ", Shading::kGouraud";
  // What stands in Config is not said again.
  if (c.architecture == Architecture::kGamma || has_lighting(c) || has_texture(c)) {
    numbers += c.architecture == Architecture::kGamma ? ", Architecture::kGamma" : ", Architecture::kDelta";
  }
  if (has_lighting(c) || has_texture(c)) {
    for (const ConfigField& field : lighting_fields()) numbers += fmt::format(", {}", c.*field.value);
  }
  if (has_texture(c)) {
    numbers += is_bilinear(c) ? ", TextureFilter::kBilinear" : ", TextureFilter::kNearest";
    numbers += has_perspective(c) ? ", TextureMapping::kPerspective" : ", TextureMapping::kAffine";
    for (const ConfigField& field : texture_fields()) numbers += fmt::format(", {}", c.*field.value);
  }
  return fmt::format(
      "// SPDX-License-Identifier: Apache-2.0\n"
      "// Configuration `{0}` for the kernels, in the order of Config. Printed by `halfspace config {0} --header FILE` from its\n"
      "// .toml file: change that, not this one.\n"
      "#ifndef HALFSPACE_CONFIGS_{1}_HPP_\n"
      "#define HALFSPACE_CONFIGS_{1}_HPP_\n\n"
      "#include \"../config.hpp\"\n\n"
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
  return {configuration.name(), c.width, c.height, c.triangles, c.range_bits, c.subpixel_bits, c.depth_bits, c.colour_bits,
          c.shading == Shading::kFlat};
}

}  // namespace halfspace::vectors
