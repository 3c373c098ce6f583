// SPDX-License-Identifier: Apache-2.0
// The words of a struct of streams (HS_STREAM_MEMBERS), and their layouts.
#ifndef HALFSPACE_MODEL_FORMATS_RECORDER_HPP_
#define HALFSPACE_MODEL_FORMATS_RECORDER_HPP_

#include <memory>
#include <vector>

#include "hls/numbers/stream.hpp"
#include "model/formats/layout.hpp"

namespace halfspace::model {
namespace detail {

struct Tap {
  virtual ~Tap() = default;
  virtual StreamWords words() const = 0;
};

template <class Record>
StreamWords pack_all(const Layout& layout, const std::vector<Record>& records) {
  StreamWords out{layout, {}};
  out.words.reserve(records.size());
  for (const Record& record : records) out.words.push_back(pack(record, layout.bits));
  return out;
}

// Of a Stream, or a Probe.
template <template <class> class Kind, class Record>
class RecordTap : public Tap {
 public:
  RecordTap(Kind<Record>& stream, const StreamRow& row) : stream_(stream), layout_(layout<Record>(row)) {
    stream_.tap(&records_);
  }
  ~RecordTap() override { stream_.tap(nullptr); }
  StreamWords words() const override { return pack_all(layout_, records_); }

 private:
  Kind<Record>& stream_;
  Layout layout_;
  std::vector<Record> records_;
};
template <class Record>
class RecordTap<Loaded, Record> : public Tap {
 public:
  RecordTap(const Loaded<Record>& loaded, const StreamRow& row) : loaded_(loaded), layout_(layout<Record>(row)) {}
  StreamWords words() const override { return pack_all(layout_, loaded_.words); }

 private:
  const Loaded<Record>& loaded_;
  Layout layout_;
};

struct LayoutList {
  std::vector<Layout> layouts;

  template <template <class> class Kind, class Record>
  void operator()(const Kind<Record>&, const StreamRow& row) {
    if (row.is_there) layouts.push_back(layout<Record>(row));
  }
};

}  // namespace detail

// Of the streams that the active configuration has, in flow order.
template <class Streams>
std::vector<Layout> stream_layouts(Streams& streams) {
  detail::LayoutList list;
  streams.visit(list);
  return list.layouts;
}

// Hears what is written to them while it lives; one at a time.
class Recorder {
 public:
  template <class Streams>
  explicit Recorder(Streams& streams) {
    streams.visit(*this);
  }

  template <template <class> class Kind, class Record>
  void operator()(Kind<Record>& stream, const StreamRow& row) {
    if (row.is_there) taps_.push_back(std::make_unique<detail::RecordTap<Kind, Record>>(stream, row));
  }

  // Each stream once, in flow order.
  void tell(const WordSink& sink) const {
    for (const auto& tap : taps_) {
      const StreamWords stream = tap->words();
      sink(stream.layout, stream.words.data(), stream.words.size());
    }
  }
  std::vector<StreamWords> words() const {
    std::vector<StreamWords> out;
    for (const auto& tap : taps_) out.push_back(tap->words());
    return out;
  }

 private:
  std::vector<std::unique_ptr<detail::Tap>> taps_;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_FORMATS_RECORDER_HPP_
