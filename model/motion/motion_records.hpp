// SPDX-License-Identifier: Apache-2.0
// What a MotionFrame has of a triangle as a record, and the records of the motion field as plain numbers.
#ifndef HALFSPACE_MODEL_MOTION_MOTION_RECORDS_HPP_
#define HALFSPACE_MODEL_MOTION_MOTION_RECORDS_HPP_

#include "hls/formats/records.hpp"
#include "model/motion/motion.hpp"
#include "model/motion/motion_words.hpp"

namespace halfspace::model {

template <class F>
MotionVectors<F> vectors_record(const RawMotionVectors& in, int index, bool last) {
  MotionVectors<F> out{};
  out.last = from_raw<Bit>(last);
  out.index = from_raw<typename F::Index>(index);
  out.face = from_raw<typename F::Face>(in.face);
  for (int k = 0; k < kKeys; ++k) {
    const RawKeyPlaces& from = in.key[k];
    KeyPlaces<F>& to = out.key[k];
    to.there = from_raw<Bit>(from.there);
    to.origin_x = from_raw<typename F::Origin>(from.origin_x);
    to.origin_y = from_raw<typename F::Origin>(from.origin_y);
    to.extent = from_raw<typename F::Extent>(from.extent);
    for (int v = 0; v < 3; ++v) {
      to.s[v] = from_raw<typename F::Coordinate>(from.s[v]);
      to.t[v] = from_raw<typename F::Coordinate>(from.t[v]);
      to.q[v] = from_raw<typename F::Coordinate>(from.q[v]);
      to.r[v] = from_raw<typename F::Difference>(from.difference[0][v]);
      to.g[v] = from_raw<typename F::Difference>(from.difference[1][v]);
      to.b[v] = from_raw<typename F::Difference>(from.difference[2][v]);
    }
  }
  return out;
}

template <class F>
RawMotion plain_motion(const Motion<F>& in) {
  RawMotion out;
  out.x = int(raw(in.x));
  out.y = int(raw(in.y));
  out.face = std::uint32_t(raw(in.face));
  for (std::size_t k = 0; k < kKeys; ++k) {
    const KeyVector<F>& from = in.key[k];
    RawKeyVector& to = out.key[k];
    to.there = raw(from.there) != 0;
    to.x = int(raw(from.x));
    to.y = int(raw(from.y));
    const int zero = 1 << (F::kColourBits + kDifferenceFraction);
    if (F::kRelights && to.there)
      to.difference = {int(raw(from.r)) - zero, int(raw(from.g)) - zero, int(raw(from.b)) - zero};
  }
  return out;
}

}  // namespace halfspace::model

#endif  // HALFSPACE_MODEL_MOTION_MOTION_RECORDS_HPP_
