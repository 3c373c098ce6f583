// SPDX-License-Identifier: Apache-2.0
// Three values that a loop takes or makes in turn. In place of an index that counts, which is a memory or a multiplexer
// of a tool's, they move up by one place a turn: registers.
#ifndef HALFSPACE_HLS_NUMBERS_TURNS_HPP_
#define HALFSPACE_HLS_NUMBERS_TURNS_HPP_

namespace halfspace {

// `next` takes the last place. Of three results, the first is in its place after three turns.
template <class T>
void move_up(T (&values)[3], const T next) {
  values[0] = values[1];
  values[1] = values[2];
  values[2] = next;
}

}  // namespace halfspace

#endif  // HALFSPACE_HLS_NUMBERS_TURNS_HPP_
