// SPDX-License-Identifier: Apache-2.0
#include "tb/report/watch.hpp"

#include <algorithm>
#include <cstring>

#include "tb/harness/plan.hpp"

namespace halfspace::tb {
namespace {

bool is(const Port& port) { return *port.bit() != 0; }

const std::uint32_t* word_of(const Port& port) { return static_cast<const std::uint32_t*>(port.data); }

Field field_of(const Vectors& vectors, const char* stream, const char* name) {
  return need_stream(vectors, stream).need(name, "the bench");
}

const Port& ready_of(const Model& model, const std::string& stream) {
  const Port* const driven = model.find(stream + "_ready_i");
  return driven ? *driven : model.need(stream + "_ready_o", 1);
}

}  // namespace

ZtestWatch::ZtestWatch(const Model& model, const Vectors& vectors)
    : stamp_valid_(model.need("stamp_valid_i", 1)),
      stamp_ready_(model.need("stamp_ready_o", 1)),
      read_(model.need("read_en_o", 1)),
      visible_(model.need("visible_valid_o", 1)),
      updates_(model.need("update_valid_o", 1)),
      update_(model.need("update_o", need_stream(vectors, "update").bits)),
      address_(model.need("write_address_o")),
      store_(model.find("store_en_o")),
      x_(field_of(vectors, "update", "x")),
      y_(field_of(vectors, "update", "y")),
      stamps_x_((std::uint32_t(model.constant("MaxWidth")) + vectors.lanes_x - 1) / vectors.lanes_x) {}

std::string ZtestWatch::wrong() {
  unread_ -= is(read_);
  if (unread_ < 0) return "read: read_en_o is 1, and there is no stamp to read for";
  unread_ += is(stamp_valid_) && is(stamp_ready_);
  // The word of the triangle before is there when one stores.
  stored_ = stored_ && !is(visible_);
  if (store_ && is(*store_)) {
    if (stored_ || !is(updates_)) return "store: store_en_o is 1, and no first pixel of a triangle is nearer";
    stored_ = true;
  }
  if (!is(updates_)) return "";
  const std::uint64_t x = x_.raw(word_of(update_)), y = y_.raw(word_of(update_)), place = y * stamps_x_ + x;
  std::uint32_t address = 0;
  std::memcpy(&address, address_.data, std::size_t(std::min(address_.bytes, 4)));
  if (address == place) return "";
  return "place: update at stamp (" + std::to_string(x) + ", " + std::to_string(y) + ") has write_address_o " +
         std::to_string(address) + ", and not " + std::to_string(place);
}

bool NoneLeftWatch::fits(const Model& model, const Vectors& vectors) {
  return model.find(kNoneLeft) && model.constant("GivesIndices") && model.find("numbered_valid_o") &&
         vectors.find("numbered");
}

NoneLeftWatch::NoneLeftWatch(const Model& model, const Vectors& vectors)
    : none_left_(model.need(kNoneLeft, 1)),
      valid_(model.need("numbered_valid_o", 1)),
      ready_(ready_of(model, "numbered")),
      word_(model.need("numbered_o", need_stream(vectors, "numbered").bits)),
      index_(field_of(vectors, "numbered", "index")) {}

std::string NoneLeftWatch::wrong() {
  if (is(none_left_) != had_none_) {
    return std::string(kNoneLeft) + " is " + (had_none_ ? "0 behind a" : "1 without a") + " triangle without an index";
  }
  had_none_ = had_none_ || (is(valid_) && is(ready_) && index_.raw(word_of(word_)) == 0);
  return "";
}

}  // namespace halfspace::tb
