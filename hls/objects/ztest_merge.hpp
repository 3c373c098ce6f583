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
// Interval: a stamp a cycle, and one a run, for its command.
#ifndef HALFSPACE_HLS_OBJECTS_ZTEST_MERGE_HPP_
#define HALFSPACE_HLS_OBJECTS_ZTEST_MERGE_HPP_

#include "hls/formats/object_records.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// What a stamp becomes, and how many of its pixels are looked for.
template <class F>
struct MergedStamp {
  Entry<F> entry;
  bool any_hit;
  typename F::ObjectCount hits;
};
// Of the stored one and the drawn one.
template <class F>
MergedStamp<F> merge_stamp(const Merge<F>& run, const Entry<F>& in, const Entry<F>& drawn) {
  using Object = typename F::Object;
  MergedStamp<F> merged;
  Entry<F>& out = merged.entry;
  out.last = in.last;
  out.x = in.x;
  out.y = in.y;
  int hits = 0;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    const Object object = in.object[l];
    const bool nothing = is_zero(object);
    const bool hit = !nothing && object >= run.first && object <= run.last;
    const typename F::Depth depth = select(hit, farthest_depth<F>(), in.depth[l]);
    const bool less = drawn.depth[l] < depth || (drawn.depth[l] == depth && drawn.object[l] < object);
    const bool nearer = is_set(run.merges) && (hit || nothing || less);
    hits += hit ? 1 : 0;
    out.depth[l] = select(nearer, drawn.depth[l], depth);
    out.object[l] = select(nearer, drawn.object[l], select(hit, from_raw<Object>(0), object));
    out.r[l] = select(nearer, drawn.r[l], select(hit, run.r, in.r[l]));
    out.g[l] = select(nearer, drawn.g[l], select(hit, run.g, in.g[l]));
    out.b[l] = select(nearer, drawn.b[l], select(hit, run.b, in.b[l]));
  }
  merged.any_hit = hits != 0;
  merged.hits = from_raw<typename F::ObjectCount>(hits);
  return merged;
}

template <class F>
void ztest_merge(Stream<Merge<F>>& merge, Stream<Entry<F>>& stored, Stream<Entry<F>>& entry, Stream<Entry<F>>& merged,
                 Stream<Found<F>>& found) {
  const Merge<F> run = merge.read();
  Found<F> all;
  all.count = from_raw<typename F::ObjectCount>(0);
  all.x_first = all.x_last = from_raw<typename F::X>(0);
  all.y_first = all.y_last = from_raw<typename F::Y>(0);
  bool any_hit = false, done = false;
Stamps:
  for (int n = 0; n < F::kStamps && !done; ++n) {
    HS_PIPELINE(1)
    const Entry<F> in = stored.read();
    Entry<F> drawn = in;
    if (is_set(run.merges)) drawn = entry.read();
    const MergedStamp<F> stamp = merge_stamp(run, in, drawn);
    if (is_set(run.sends)) merged.write(stamp.entry);
    const bool hit = stamp.any_hit, first = !any_hit;
    all.x_first = select(hit && (first || in.x < all.x_first), in.x, all.x_first);
    all.x_last = select(hit && (first || in.x > all.x_last), in.x, all.x_last);
    all.y_first = select(hit && (first || in.y < all.y_first), in.y, all.y_first);
    all.y_last = select(hit && (first || in.y > all.y_last), in.y, all.y_last);
    all.count = all.count + stamp.hits;
    any_hit = any_hit || hit;
    done = is_set(in.last);
  }
  found.write(all);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_OBJECTS_ZTEST_MERGE_HPP_
