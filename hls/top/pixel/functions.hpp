// SPDX-License-Identifier: Apache-2.0
// The work of a pixel as functions of words alone, for a tool that pipelines functions: a call a cycle. A word of a
// vector set is given by its elements of 64 bits, the last bits first. At one lane, and of words no longer than those
// of the configurations `*low`.
#ifndef HALFSPACE_HLS_TOP_PIXEL_FUNCTIONS_HPP_
#define HALFSPACE_HLS_TOP_PIXEL_FUNCTIONS_HPP_

#include <cstdint>

extern "C" {

// The word of `scan` and that of TdbS to the word of `pixel`, but for `last`.
std::uint64_t gouraud_pixel(std::uint64_t scan, std::uint64_t p0, std::uint64_t p1, std::uint64_t p2, std::uint64_t p3);

// The same, and those of the light and of what the material makes of it.
std::uint64_t phong_pixel(std::uint64_t scan, std::uint64_t p0, std::uint64_t p1, std::uint64_t p2, std::uint64_t p3,
                          std::uint64_t l0, std::uint64_t l1, std::uint64_t m0, std::uint64_t m1, std::uint64_t m2);

// The words of `scan`, of TdbS and of the texture to the address of the texel; and that of `lit` and the texel to
// `pixel`.
std::uint64_t texel_address(std::uint64_t scan, std::uint64_t p0, std::uint64_t p1, std::uint64_t p2, std::uint64_t p3,
                            std::uint64_t texture);
std::uint64_t textured_pixel(std::uint64_t lit, std::uint64_t texel);

// The words of `scan` and of TdbS to the last bits of the word of `motion`: the vector into key 1.
std::uint64_t motion_vector(std::uint64_t scan, std::uint64_t p0, std::uint64_t p1, std::uint64_t p2, std::uint64_t p3,
                            std::uint64_t p4, std::uint64_t p5, std::uint64_t p6);

// The words of `merge`, `stored` and `entry` to that of `merged`.
std::uint64_t merged_stamp(std::uint64_t merge, std::uint64_t stored, std::uint64_t entry);

}  // extern "C"

#endif  // HALFSPACE_HLS_TOP_PIXEL_FUNCTIONS_HPP_
