// SPDX-License-Identifier: Apache-2.0
#include "hls/objects/static_run.hpp"
#include "hls/objects/ztest_merge.hpp"
#include "hls/top/tops.hpp"

using namespace halfspace;

namespace {

// The memory of the buffers, as either process sees it: beyond streams.
struct ReadStreams {
  View<BufferPlace> stored_places;
  View<StampPixels> stored;
  View<BufferPlace> drawn_places;
  View<StampPixels> drawn;

  HS_INLINE StampPixels<TopFormats> read_stored(const BufferPlace<TopFormats>& place) {
    stored_places.write(place);
    return stored.read();
  }
  HS_INLINE StampPixels<TopFormats> read_drawn(const BufferPlace<TopFormats>& place) {
    drawn_places.write(place);
    return drawn.read();
  }
};
struct WriteStream {
  View<KeptStamp> stamps;

  HS_INLINE void keep(const KeptStamp<TopFormats>& stamp) { stamps.write(stamp); }
};

void fork_command(Port<StaticCommand>& command, Port<StaticCommand>& fetched, Port<StaticCommand>& stored) {
  View<StaticCommand> command_words(command), fetched_words(fetched), stored_words(stored);
  fork(command_words, fetched_words, stored_words);
}

void fetch_process(Port<StaticCommand>& command, Port<Entry>& entry, Port<BufferPlace>& stored_place,
                   Port<StampPixels>& stored_pixels, Port<BufferPlace>& drawn_place, Port<StampPixels>& drawn_pixels,
                   Port<Merge>& merge, Port<Entry>& stored, Port<Entry>& drawn) {
  View<StaticCommand> command_words(command);
  View<Entry> entry_words(entry);
  View<Merge> merge_words(merge);
  View<Entry> stored_words(stored);
  View<Entry> drawn_words(drawn);
  ReadStreams memory = {View<BufferPlace>(stored_place), View<StampPixels>(stored_pixels),
                        View<BufferPlace>(drawn_place), View<StampPixels>(drawn_pixels)};
  static_fetch(command_words.read(), memory, entry_words, merge_words, stored_words, drawn_words);
}

void merge_process(Port<Merge>& merge, Port<Entry>& stored, Port<Entry>& drawn, Port<Entry>& merged,
                   Port<Found>& found) {
  View<Merge> merge_words(merge);
  View<Entry> stored_words(stored);
  View<Entry> drawn_words(drawn);
  View<Entry> merged_words(merged);
  View<Found> found_words(found);
  ztest_merge(merge_words, stored_words, drawn_words, merged_words, found_words);
}

void store_process(Port<StaticCommand>& command, Port<Entry>& merged, Port<KeptStamp>& kept, Port<Entry>& shown) {
  View<StaticCommand> command_words(command);
  View<Entry> merged_words(merged);
  View<Entry> shown_words(shown);
  WriteStream memory = {View<KeptStamp>(kept)};
  static_store(command_words.read(), memory, merged_words, shown_words);
}

class StaticFrames {
 public:
  void run(Port<StaticCommand>& command, Port<Entry>& entry, Port<BufferPlace>& stored_place,
           Port<StampPixels>& stored_pixels, Port<BufferPlace>& drawn_place, Port<StampPixels>& drawn_pixels,
           Port<KeptStamp>& kept, Port<Entry>& shown, Port<Found>& found) {
#ifdef HS_DATAFLOW
#pragma HLS dataflow
#endif
    fork_command(command, fetched_command_, stored_command_);
    fetch_process(fetched_command_, entry, stored_place, stored_pixels, drawn_place, drawn_pixels, merge_, stored_,
                  drawn_);
    merge_process(merge_, stored_, drawn_, merged_, found);
    store_process(stored_command_, merged_, kept, shown);
  }

 private:
  Port<StaticCommand> fetched_command_, stored_command_;
  Port<Merge> merge_;
  Port<Entry> stored_, drawn_, merged_;
};

}  // namespace

extern "C" void static_frames_top(Port<StaticCommand>& command, Port<Entry>& entry, Port<BufferPlace>& stored_place,
                                  Port<StampPixels>& stored_pixels, Port<BufferPlace>& drawn_place,
                                  Port<StampPixels>& drawn_pixels, Port<KeptStamp>& kept, Port<Entry>& shown,
                                  Port<Found>& found) {
  HS_STREAM_PORT(command)
  HS_STREAM_PORT(entry)
  HS_STREAM_PORT(stored_place)
  HS_STREAM_PORT(stored_pixels)
  HS_STREAM_PORT(drawn_place)
  HS_STREAM_PORT(drawn_pixels)
  HS_STREAM_PORT(kept)
  HS_STREAM_PORT(shown)
  HS_STREAM_PORT(found)
  HS_STARTED
  static_assert(TopFormats::kHasObjects, "static_frames is of configurations with objects");
  static StaticFrames static_frames;
  static_frames.run(command, entry, stored_place, stored_pixels, drawn_place, drawn_pixels, kept, shown, found);
}
