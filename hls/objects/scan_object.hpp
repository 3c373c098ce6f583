// SPDX-License-Identifier: Apache-2.0
// The D-buffer at scan-out: which object each pixel shows, and how deep. Indices are few and are given anew in every
// frame, objects are many and keep their numbers; a table tells the object of an index.
//
// Interval: a cycle for each different triangle in a stamp, one if there is none: the shader beside it takes no fewer.
#ifndef HALFSPACE_HLS_OBJECTS_SCAN_OBJECT_HPP_
#define HALFSPACE_HLS_OBJECTS_SCAN_OBJECT_HPP_

#include "hls/formats/buffers.hpp"
#include "hls/formats/lanes.hpp"
#include "hls/formats/object_records.hpp"
#include "hls/numbers/arithmetic.hpp"

namespace halfspace {

// Stores what object a triangle is of, one a call.
template <class F>
bool store_object(Stream<Triangle<F>>& triangle, ObjectTable<F>& table) {
  const Triangle<F> in = triangle.read();
  if (!is_zero(in.index)) table.object[int(raw(in.index)) - 1] = in.object;
  return is_set(in.last);
}

// The depths of a stamp, no objects yet, and the lanes that wait for theirs.
template <class F>
void start_stamp(const Scan<F>& in, DepthBuffer<F>& depth_buffer, ObjectPixel<F>& out, Bit (&waits)[F::kLanes]) {
  const int address = stamp_address<F>(in.x, in.y);
  const typename F::Depth farthest = farthest_depth<F>();
  out.last = in.last;
  out.x = in.x;
  out.y = in.y;
Depths:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    const bool shows_one = !is_zero(in.index[l]);
    waits[l] = from_raw<Bit>(shows_one);
    out.depth[l] = select(shows_one, trimmed(depth_buffer.depth[address][l]), farthest);
    out.object[l] = from_raw<typename F::Object>(0);
  }
}
// The object of the next triangle of the stamp. Returns whether there was one.
template <class F>
bool name_group(const Scan<F>& in, const ObjectTable<F>& table, ObjectPixel<F>& out, Bit (&waits)[F::kLanes]) {
  Bit shows[F::kLanes];
  const int index = next_group<F>(in.index, waits, shows);
  if (index == 0) return false;
  const typename F::Object object = table.object[index - 1];
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    out.object[l] = select(is_set(shows[l]), object, out.object[l]);
  }
  return true;
}

// A stamp.
template <class F>
bool scan_object(Stream<Scan<F>>& scan, DepthBuffer<F>& depth_buffer, const ObjectTable<F>& table,
                 Stream<ObjectPixel<F>>& object_pixel) {
  const Scan<F> in = scan.read();
  ObjectPixel<F> out;
  Bit waits[F::kLanes];
  start_stamp(in, depth_buffer, out, waits);
Triangles:
  for (int n = 0; n < F::kLanes; ++n) {
    HS_PIPELINE(1)
    if (!name_group(in, table, out, waits)) break;
  }
  object_pixel.write(out);
  return is_set(in.last);
}

// All stamps. A turn takes a triangle: the first of a stamp reads it, and the last writes its pixels.
template <class F>
void scan_object_frame(Stream<Scan<F>>& scan, DepthBuffer<F>& depth_buffer, const ObjectTable<F>& table,
                       Stream<ObjectPixel<F>>& object_pixel) {
  Scan<F> in{};
  ObjectPixel<F> out{};
  Bit waits[F::kLanes];
  bool starts = true, done = false;
Turns:
  while (!done) {
    HS_PIPELINE(1)
    if (starts) {
      in = scan.read();
      start_stamp(in, depth_buffer, out, waits);
    }
    name_group(in, table, out, waits);
    starts = !any_waits<F>(waits);
    if (starts) object_pixel.write(out);
    done = starts && is_set(in.last);
  }
}

// A stamp: its colours come from the shader.
template <class F>
bool join_entry(Stream<Pixel<F>>& pixel, Stream<ObjectPixel<F>>& object_pixel, Stream<Entry<F>>& entry) {
  const Pixel<F> colours = pixel.read();
  const ObjectPixel<F> objects = object_pixel.read();
  Entry<F> out;
  out.last = objects.last;
  out.x = objects.x;
  out.y = objects.y;
Lanes:
  for (int l = 0; l < F::kLanes; ++l) {
    HS_UNROLL
    out.depth[l] = objects.depth[l];
    out.object[l] = objects.object[l];
    out.r[l] = colours.r[l];
    out.g[l] = colours.g[l];
    out.b[l] = colours.b[l];
  }
  entry.write(out);
  return is_set(objects.last);
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_OBJECTS_SCAN_OBJECT_HPP_
