// SPDX-License-Identifier: Apache-2.0
#include "tb/report/compare_words.hpp"

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "tb/report/describe.hpp"

namespace halfspace::tb {
namespace {

using Word = std::vector<std::uint32_t>;

void clear_bits(Word* word, int lsb, int width) {
  for (int bit = lsb; bit < lsb + width; ++bit) (*word)[std::size_t(bit) / 32] &= ~(1u << (bit % 32));
}

// What ends a triangle or a frame.
bool is_end(const Field& field) {
  const std::string end = "last";
  return field.width == 1 && field.count == 1 && field.name.size() >= end.size() &&
         field.name.compare(field.name.size() - end.size(), end.size(), end) == 0;
}

class Comparer {
 public:
  Comparer(const Vectors& vectors, const Stream& stream, const Words& got, const Leniency& leniency)
      : vectors_(vectors), stream_(stream), got_(got), leniency_(leniency) {
    if (leniency_.any_order && !stream_.any_order_within.empty()) {
      within_ = &stream_.need(stream_.any_order_within, "--any-order");
    }
    for (const Field& field : stream_.fields) conditions_.push_back(conditions_of(field));
  }

  Comparison run() {
    within_ ? compare_groups() : compare_in_order(0, stream_.words.size(), 0, got_.size());
    return result_;
  }

 private:
  // Bits that do not count, by the fields of `judge` which has the same number n, made 0.
  Word canonical(const std::uint32_t* word, const std::uint32_t* judge, std::size_t n) const {
    Word out(word, word + stream_.words.parts());
    if (!leniency_.masked) return out;
    for (std::size_t f = 0; f < stream_.fields.size(); ++f) {
      const Field& field = stream_.fields[f];
      for (int lane = 0; lane < field.count && !conditions_[f].empty(); ++lane) {
        if (!counts(f, lane, judge, n)) clear_bits(&out, field.lsb + lane * field.width, field.width);
      }
    }
    return out;
  }

  // A condition of valid_if.
  struct Condition {
    bool wants_zero;
    const Stream* of;
    const Field* flag;
  };
  std::vector<Condition> conditions_of(const Field& field) const {
    std::vector<Condition> found;
    std::istringstream conditions(field.valid_if);
    for (std::string condition; conditions >> condition;) {
      const bool wants_zero = condition[0] == '!';
      std::string name = condition.substr(wants_zero);
      const Stream* of = &stream_;
      if (const std::size_t dot = name.find('.'); dot != std::string::npos) {
        of = vectors_.find(name.substr(0, dot));
        name = name.substr(dot + 1);
      }
      if (of != nullptr) found.push_back({wants_zero, of, &of->need(name, "valid_if")});
    }
    return found;
  }

  bool counts(std::size_t field, int lane, const std::uint32_t* judge, std::size_t n) const {
    for (const Condition& condition : conditions_[field]) {
      const bool other = condition.of != &stream_;
      if (other && n >= condition.of->words.size()) continue;
      const std::uint32_t* const word = other ? condition.of->words[n] : judge;
      const bool is_zero = condition.flag->raw(word, condition.flag->count > 1 ? lane : 0) == 0;
      if (is_zero != condition.wants_zero) return false;
    }
    return true;
  }

  WordPlace place(std::size_t n) const {
    std::size_t frame = 0, begin = 0;
    while (frame + 1 < stream_.frame_words.size() && begin + stream_.frame_words[frame] <= n) {
      begin += stream_.frame_words[frame++];
    }
    return {&vectors_, &stream_, n, frame, ""};
  }

  void tell(const std::string& sentence) {
    if (result_.first.empty()) result_.first = sentence;
  }
  void tell_different(std::size_t n, const std::uint32_t* got) {
    ++result_.different;
    if (!result_.first.empty()) return;
    // Fields that do not count are not told.
    Word shown(stream_.words[n], stream_.words[n] + stream_.words.parts());
    for (std::size_t f = 0; f < stream_.fields.size(); ++f) {
      const Field& field = stream_.fields[f];
      for (int lane = 0; lane < field.count; ++lane) {
        const int lsb = field.lsb + lane * field.width;
        if (!leniency_.masked || counts(f, lane, stream_.words[n], n)) {
          copy_bits(shown.data(), lsb, got, lsb, field.width);
        }
      }
    }
    tell(describe_mismatch(place(n), shown.data()));
  }
  void tell_missing(std::size_t n) {
    ++result_.missing;
    const WordPlace where = place(n);
    tell("missing: word " + std::to_string(n) + " of " + describe_stream(stream_) + ", frame " +
         std::to_string(where.frame) + ": " + describe_fields(stream_, stream_.words[n]));
  }
  void tell_surplus(std::size_t n) {
    ++result_.surplus;
    tell("surplus: word " + std::to_string(n) + " on " + describe_stream(stream_) + ": " +
         describe_fields(stream_, got_[n]));
  }

  void compare_in_order(std::size_t a, std::size_t a_end, std::size_t b, std::size_t b_end) {
    for (; a < a_end && b < b_end; ++a, ++b, ++result_.words) {
      if (canonical(stream_.words[a], stream_.words[a], a) != canonical(got_[b], stream_.words[a], a)) {
        tell_different(a, got_[b]);
      }
    }
    for (; a < a_end; ++a, ++result_.words) tell_missing(a);
    for (; b < b_end; ++b, ++result_.words) tell_surplus(b);
  }

  // The end of the words from n on that may come in any order: one value of the field, and no end before the last.
  std::size_t group_end(const Words& words, std::size_t n) const {
    const std::uint64_t value = within_->raw(words[n]);
    while (n < words.size() && within_->raw(words[n]) == value) {
      if (ends(words[n++]) != 0) break;
    }
    return n;
  }
  std::uint64_t ends(const std::uint32_t* word) const {
    std::uint64_t flags = 0;
    for (const Field& field : stream_.fields) {
      if (is_end(field)) flags = 2 * flags + field.raw(word);
    }
    return flags;
  }
  Word without_ends(const std::uint32_t* word, std::size_t n) const {
    Word out = canonical(word, word, n);
    for (const Field& field : stream_.fields) {
      if (is_end(field)) clear_bits(&out, field.lsb, field.width);
    }
    return out;
  }
  // Column and row, by which words of two orders belong together.
  std::pair<std::uint64_t, std::uint64_t> spot(const std::uint32_t* word) const {
    const Field *const x = stream_.find("x"), *const y = stream_.find("y");
    return {x && x->count == 1 ? x->raw(word) : 0, y && y->count == 1 ? y->raw(word) : 0};
  }

  void compare_groups() {
    std::size_t a = 0, b = 0;
    while (a < stream_.words.size() && b < got_.size()) {
      const std::size_t a_end = group_end(stream_.words, a), b_end = group_end(got_, b);
      if (within_->raw(stream_.words[a]) != within_->raw(got_[b])) {
        // Not the same triangle: word by word, and no further.
        return compare_in_order(a, stream_.words.size(), b, got_.size());
      }
      compare_group(a, a_end, b, b_end);
      a = a_end, b = b_end;
    }
    compare_in_order(a, stream_.words.size(), b, got_.size());
  }

  void compare_group(std::size_t a, std::size_t a_end, std::size_t b, std::size_t b_end) {
    result_.words += std::max(a_end - a, b_end - b);
    std::multimap<Word, std::size_t> left;
    for (std::size_t n = b; n < b_end; ++n) left.emplace(without_ends(got_[n], n), n);
    std::vector<std::size_t> without;
    for (std::size_t n = a; n < a_end; ++n) {
      const auto found = left.find(without_ends(stream_.words[n], n));
      if (found == left.end()) without.push_back(n);
      else left.erase(found);
    }
    if (without.empty() && left.empty() && ends(stream_.words[a_end - 1]) != ends(got_[b_end - 1])) {
      tell_different(a_end - 1, got_[b_end - 1]);
    }
    for (const std::size_t n : without) {
      const auto same_spot = [&](const auto& word) { return spot(got_[word.second]) == spot(stream_.words[n]); };
      const auto found = std::find_if(left.begin(), left.end(), same_spot);
      if (found == left.end()) {
        tell_missing(n);
      } else {
        // The end is not what is told, as it may stand at another word.
        Word got(got_[found->second], got_[found->second] + stream_.words.parts());
        for (const Field& field : stream_.fields) {
          if (is_end(field)) copy_bits(got.data(), field.lsb, stream_.words[n], field.lsb, field.width);
        }
        tell_different(n, got.data());
        left.erase(found);
      }
    }
    for (const auto& [word, n] : left) tell_surplus(n);
  }

  const Vectors& vectors_;
  const Stream& stream_;
  const Words& got_;
  const Leniency leniency_;
  const Field* within_ = nullptr;
  std::vector<std::vector<Condition>> conditions_;  // of each field
  Comparison result_;
};

}  // namespace

Comparison compare_words(const Vectors& vectors, const Stream& stream, const Words& got, const Leniency& leniency) {
  return Comparer(vectors, stream, got, leniency).run();
}

}  // namespace halfspace::tb
