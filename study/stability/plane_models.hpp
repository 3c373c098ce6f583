// SPDX-License-Identifier: Apache-2.0
// What else is done for the plane of an attribute, to stand beside the kernels: float32 planes as in software
// rasterizers, and fixed point with gradients that saturate. One channel of one triangle; values before rounding,
// in LSB.
#ifndef HALFSPACE_STUDY_STABILITY_PLANE_MODELS_HPP_
#define HALFSPACE_STUDY_STABILITY_PLANE_MODELS_HPP_

#include "study/bounds/bounds_exact.hpp"

namespace halfspace::model {

// Positions in float pixels and values of 0 … 1. With ooa = 1/(dx01·dy20 − dx20·dy01), da01 = v0 − v1 and so on,
//   A = da01·(dy20·ooa) − da20·(dy01·ooa),  B = da20·(dx01·ooa) − da01·(dx20·ooa),
// every operation rounded to float32, as llvmpipe does it.
class FloatPlane {
 public:
  FloatPlane(const ExactTriangle& triangle, const Values& values, int bits, int subpixel_bits);

  // (v0 − (A·x0 + B·y0)) + A·x + B·y: from the origin of the frame, as llvmpipe of Mesa 22.3.
  double from_origin(int px, int py) const;
  // v0 + A·(x − x0) + B·(y − y0): from vertex 0, as newer ones.
  double from_vertex(int px, int py) const;

 private:
  double stored(float value) const;

  double full_;
  float v0_, x0_, y0_, dx_, dy_, origin_;  // x0, y0 from the centre of pixel 0
};

// Gradients of g fraction bits, rounded once from the exact ones, at most 2^(b+1) LSB a pixel: beyond, they saturate.
class SaturatedPlane {
 public:
  SaturatedPlane(const ExactTriangle& triangle, const Values& values, int bits, int subpixel_bits, int fraction);
  double value(int px, int py) const;

 private:
  const ExactTriangle& triangle_;
  double full_;
  std::int64_t v0_;
  Wide dx_, dy_;
  int fraction_, subpixel_bits_;
};

}  // namespace halfspace::model

#endif  // HALFSPACE_STUDY_STABILITY_PLANE_MODELS_HPP_
