// SPDX-License-Identifier: Apache-2.0
// The Z-test of whole buffers (static objects buffer): what is stored against what is drawn, the nearer one stays;
// objects that leave are erased before, and counted. The count alone is the occlusion query: of an object that no pixel
// of its S-buffer shows nothing has to be erased.
//
//   key      {depth, object}, compared as one number, depth first; the lesser is nearer. Objects are numbered in the
//   order
//            in which the renderer draws them, so this is its Z-test: less, and the first drawn wins a tie
//   merged   the stored entry, erased if its object is of the range; or the drawn one, if nothing is stored or its key
//   is less
//
// Equal keys are of one object, and the stored entry stays: it was drawn first.
//
// A run is one word of `merge`, words of `stored` up to that with `last`, with `merges` as many of `entry` at the same
// places, with `sends` as many of `merged`, and one of `found`. They may be any stamps of the frame, in any order: all,
// or a box.
//
//   frame             merges, sends, no range; stored: an S-buffer
//   add               the same, and what is sent is stored
//   erase             sends, a range
//   occlusion query   a range
//
// A stamp a cycle, and one for the word of `merge`.
#ifndef HALFSPACE_HLS_OBJECTS_ZTEST_MERGE_HPP_
#define HALFSPACE_HLS_OBJECTS_ZTEST_MERGE_HPP_

#include "hls/formats/object_records.hpp"
#include "hls/numbers/stream.hpp"

namespace halfspace {

template <class F>
void ztest_merge(Stream<Merge<F>>& merge, Stream<Entry<F>>& stored, Stream<Entry<F>>& entry, Stream<Entry<F>>& merged,
                 Stream<Found<F>>& found) {
  using Depth = typename F::Depth;
  using Object = typename F::Object;
  using Colour = typename F::Colour;
  const Merge<F> run = merge.read();
  const typename Depth::Carrier farthest = raw(farthest_depth<F>());
  int count = 0, x_first = 0, x_last = 0, y_first = 0, y_last = 0;
  bool done = false;
Stamps:
  for (int n = 0; n < F::kStamps && !done; ++n) {
    HS_PIPELINE(1)
    const Entry<F> in = stored.read();
    Entry<F> drawn = in;
    if (raw(run.merges)) drawn = entry.read();
    Entry<F> out;
    out.last = in.last;
    out.x = in.x;
    out.y = in.y;
    int hits = 0;
  Lanes:
    for (int l = 0; l < F::kLanes; ++l) {
      HS_UNROLL
      const auto object = raw(in.object[l]);
      const bool hit = object != 0 && object >= raw(run.first) && object <= raw(run.last);
      const bool empty = hit || object == 0;
      const auto depth = hit ? farthest : raw(in.depth[l]);
      const bool less = raw(drawn.depth[l]) < depth || (raw(drawn.depth[l]) == depth && raw(drawn.object[l]) < object);
      const bool nearer = raw(run.merges) && (empty || less);
      hits += hit ? 1 : 0;
      out.depth[l] = from_raw<Depth>(nearer ? raw(drawn.depth[l]) : depth);
      out.object[l] = from_raw<Object>(nearer ? raw(drawn.object[l]) : hit ? typename Object::Carrier(0) : object);
      out.r[l] = from_raw<Colour>(nearer ? raw(drawn.r[l]) : hit ? raw(run.r) : raw(in.r[l]));
      out.g[l] = from_raw<Colour>(nearer ? raw(drawn.g[l]) : hit ? raw(run.g) : raw(in.g[l]));
      out.b[l] = from_raw<Colour>(nearer ? raw(drawn.b[l]) : hit ? raw(run.b) : raw(in.b[l]));
    }
    if (raw(run.sends)) merged.write(out);
    if (hits != 0) {
      const int x = int(raw(in.x)), y = int(raw(in.y));
      x_first = count == 0 || x < x_first ? x : x_first;
      x_last = count == 0 || x > x_last ? x : x_last;
      y_first = count == 0 || y < y_first ? y : y_first;
      y_last = count == 0 || y > y_last ? y : y_last;
      count += hits;
    }
    done = is_set(in.last);
  }
  Found<F> out;
  out.count = from_raw<typename F::ObjectCount>(count);
  out.x_first = from_raw<typename F::X>(x_first);
  out.x_last = from_raw<typename F::X>(x_last);
  out.y_first = from_raw<typename F::Y>(y_first);
  out.y_last = from_raw<typename F::Y>(y_last);
  found.write(out);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_OBJECTS_ZTEST_MERGE_HPP_
