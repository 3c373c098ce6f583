// SPDX-License-Identifier: Apache-2.0
#include "tb/harness/vectors.hpp"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>

namespace halfspace::tb {
namespace {

using Json = nlohmann::json;
constexpr const char* kFormat = "halfspace-vectors 1";
constexpr const char* kRemedy = "; make the set again with `halfspace vectors SCENE --config C --lanes N --out DIR`";

// Where in the manifest a value stands, for the sentence when it is not as it should be.
class Place {
 public:
  Place(const Json& json, std::string file, std::string path)
      : json_(json), file_(std::move(file)), path_(std::move(path)) {}

  [[noreturn]] void fail(const std::string& what) const {
    throw Error(file_ + ": " + (path_.empty() ? "the top level" : path_) + " " + what + kRemedy);
  }

  Place at(const std::string& key) const {
    if (!json_.is_object()) fail("is not an object");
    if (!json_.contains(key)) fail("has no \"" + key + "\"");
    return {json_.at(key), file_, path_.empty() ? key : path_ + "." + key};
  }
  bool has(const std::string& key) const { return json_.is_object() && json_.contains(key); }

  std::vector<Place> items() const {
    if (!json_.is_array()) fail("is not an array");
    std::vector<Place> places;
    for (std::size_t i = 0; i < json_.size(); ++i) {
      places.emplace_back(json_[i], file_, path_ + "[" + std::to_string(i) + "]");
    }
    return places;
  }

  std::string text() const {
    if (!json_.is_string()) fail("is not a string");
    return json_.get<std::string>();
  }
  bool flag() const {
    if (!json_.is_boolean()) fail("is not true or false");
    return json_.get<bool>();
  }
  std::int64_t integer(std::int64_t least, std::int64_t most) const {
    const bool fits = json_.is_number_integer() &&
                      !(json_.is_number_unsigned() && json_.get<std::uint64_t>() > std::uint64_t(INT64_MAX));
    const std::int64_t value = fits ? json_.get<std::int64_t>() : 0;
    if (!fits || value < least || value > most) {
      fail("is not an integer from " + std::to_string(least) + " to " + std::to_string(most));
    }
    return value;
  }

 private:
  const Json& json_;
  std::string file_, path_;
};

constexpr std::int64_t kMostWords = std::int64_t(1) << 40;
constexpr int kMostBits = 4096;

Field read_field(const Place& place, int stream_bits) {
  Field field;
  field.name = place.at("name").text();
  field.width = int(place.at("width").integer(1, 64));
  field.count = int(place.at("count").integer(1, 64));
  field.lsb = int(place.at("lsb").integer(0, kMostBits));
  field.is_signed = place.at("signed").flag();
  field.fraction = int(place.at("fraction").integer(-64, 64));
  if (place.has("valid_if")) field.valid_if = place.at("valid_if").text();
  if (field.lsb + field.width * field.count > stream_bits) {
    place.fail("(" + field.name + ") reaches beyond the " + std::to_string(stream_bits) + " bits of its stream");
  }
  return field;
}

Stream read_stream(const Place& place, std::size_t frames) {
  Stream stream;
  stream.name = place.at("name").text();
  stream.from = place.at("from").text();
  stream.to = place.at("to").text();
  stream.file = place.at("file").text();
  if (place.has("context")) stream.context = place.at("context").text();
  if (place.has("any_order_within")) stream.any_order_within = place.at("any_order_within").text();
  stream.bits = int(place.at("bits").integer(1, kMostBits));
  for (const Place& item : place.at("frame_words").items()) {
    stream.frame_words.push_back(std::size_t(item.integer(0, kMostWords)));
  }
  if (stream.frame_words.size() != frames) {
    place.at("frame_words")
        .fail("has " + std::to_string(stream.frame_words.size()) + " entries for " + std::to_string(frames) +
              " frames");
  }
  const std::size_t words = std::size_t(place.at("words").integer(0, kMostWords));
  const std::size_t sum = std::accumulate(stream.frame_words.begin(), stream.frame_words.end(), std::size_t(0));
  if (sum != words) {
    place.at("frame_words").fail("add up to " + std::to_string(sum) + ", not to \"words\", " + std::to_string(words));
  }
  for (const Place& item : place.at("fields").items()) stream.fields.push_back(read_field(item, stream.bits));
  stream.words = Words(stream.bits);
  return stream;
}

void read_pass(const Place& item, Frame* frame) {
  frame->pass = item.at("pass").text();
  if (frame->pass != "key" && frame->pass != "between" && frame->pass != "fill") {
    item.at("pass").fail("is \"" + frame->pass + "\", and a pass is \"key\", \"between\" or \"fill\"");
  }
  if (frame->pass == "between") frame->weight = std::uint32_t(item.at("weight").integer(0, 1 << 20));
}

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

// Appends the word that the digits of `line` spell; says whether they are digits and fit.
bool append_word(const char* first, const char* end, Words* words) {
  std::uint32_t* const word = words->append();
  int bit = 0;
  for (const char* p = end; p != first;) {
    const char c = *--p;
    if (c == '_') continue;
    const int digit = hex_digit(c);
    if (digit < 0) return false;
    if (bit >= words->bits() ? digit != 0 : (digit >> std::min(4, words->bits() - bit)) != 0) return false;
    if (bit < words->bits()) word[bit / 32] |= std::uint32_t(digit) << (bit % 32);
    bit += 4;
  }
  return bit > 0;
}

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r'; }

}  // namespace

const Field* Stream::find(const std::string& field) const {
  for (const Field& f : fields) {
    if (f.name == field) return &f;
  }
  return nullptr;
}

const Field& Stream::need(const std::string& field, const char* purpose) const {
  if (const Field* found = find(field)) return *found;
  throw Error("manifest.json: stream " + name + " has no field \"" + field + "\", which " + purpose + " needs" +
              kRemedy);
}

const Stream* Vectors::find(const std::string& name) const {
  for (const Stream& stream : streams) {
    if (stream.name == name) return &stream;
  }
  return nullptr;
}

bool Vectors::is_background() const {
  const auto empty = [](const Frame& frame) { return !frame.has_triangles; };
  return find("triangle") && std::all_of(frames.begin(), frames.end(), empty);
}

Vectors load_manifest(const std::string& directory) {
  const std::string file = directory + "/manifest.json";
  std::ifstream in(file);
  if (!in) throw Error(file + ": cannot be opened" + kRemedy);
  Json json;
  try {
    in >> json;
  } catch (const Json::exception& e) {
    throw Error(file + ": is not JSON (" + e.what() + ")" + kRemedy);
  }
  const Place top(json, file, "");
  if (const std::string format = top.at("format").text(); format != kFormat) {
    top.at("format").fail("is \"" + format + "\", and this program reads \"" + kFormat + "\"");
  }
  Vectors vectors;
  vectors.directory = directory;
  vectors.scene = top.at("scene").text();
  vectors.config = top.at("config").text();
  vectors.lanes_x = int(top.at("lanes_x").integer(1, 16));
  vectors.lanes_y = int(top.at("lanes_y").integer(1, 16));
  if (top.has("window")) vectors.window = std::size_t(top.at("window").integer(0, 1 << 22));
  for (const Place& item : top.at("frames").items()) {
    Frame frame;
    frame.width = std::uint32_t(item.at("width").integer(1, 65535));
    frame.height = std::uint32_t(item.at("height").integer(1, 65535));
    const std::vector<Place> background = item.at("background").items();
    if (background.size() != 3) item.at("background").fail("is not [r, g, b]");
    for (int i = 0; i < 3; ++i) frame.background[i] = std::uint32_t(background[i].integer(0, 255));
    if (item.has("triangles")) frame.has_triangles = item.at("triangles").integer(0, std::int64_t(1) << 32) != 0;
    if (item.has("note")) frame.note = item.at("note").text();
    if (item.has("pass")) read_pass(item, &frame);
    if (item.has("visits")) frame.visits = item.at("visits").integer(0, kMostWords);
    if (item.has("cycles")) frame.cycles = item.at("cycles").integer(0, kMostWords);
    vectors.frames.push_back(frame);
  }
  if (vectors.frames.empty()) top.at("frames").fail("is empty");
  for (const Place& item : top.at("streams").items()) {
    vectors.streams.push_back(read_stream(item, vectors.frames.size()));
  }
  return vectors;
}

Words read_words(const std::string& file, int bits, std::size_t most) {
  std::ifstream in(file);
  if (!in) throw Error(file + ": cannot be opened" + kRemedy);
  Words words(bits);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const char* first = line.data();
    const char* end = first + std::min(line.find("//"), line.size());
    while (first != end && is_space(*first)) ++first;
    while (first != end && is_space(end[-1])) --end;
    if (first == end) continue;
    if (!append_word(first, end, &words)) {
      throw Error(file + ":" + std::to_string(number) + ": \"" + std::string(first, end).substr(0, 40) +
                  "\" is not a hexadecimal word of " + std::to_string(bits) + " bits" + kRemedy);
    }
    if (words.size() > most) break;
  }
  return words;
}

void load_words(const std::string& directory, Stream* stream) {
  const std::string file = directory + "/" + stream->file;
  std::size_t expected = 0;
  for (std::size_t words : stream->frame_words) expected += words;
  Words words = read_words(file, stream->bits, expected);
  if (words.size() != expected) {
    throw Error(file + ": holds " + (words.size() > expected ? "more than " : "only ") +
                std::to_string(std::min(words.size(), expected)) + " words, manifest.json says " +
                std::to_string(expected) + kRemedy);
  }
  stream->words = std::move(words);
}

}  // namespace halfspace::tb
