// SPDX-License-Identifier: Apache-2.0
// Which vectors fit: each component by itself, at both ends of its range.
#include <gtest/gtest.h>

#include "hls/motion/motion_field.hpp"
#include "tests/motion/motion_configs.hpp"

namespace halfspace::tests {
namespace {

using F = Formats<MotionLow, Stamp4>;

// A triangle that lies in its origin at the key: the way there is the origin less the centre of the pixel.
TEST(MotionVector, IsThereIfBothComponentsFit) {
  const int x = 5, y = 9, most = 1 << F::Vector::width() >> 1 >> F::Vector::fraction(), f = F::Vector::fraction();
  ASSERT_GT(f, 0);
  int fit = 0, tried = 0;
  const int offsets[] = {-2 * most, -most - 1, -most, -most + 1, -1, 0, 1, most - 1, most, most + 1, 2 * most};
  for (const int dx : offsets) {
    for (const int dy : offsets) {
      KeyPlanes<F> planes{};
      planes.there = from_raw<Bit>(1);
      planes.origin_x = from_raw<F::Origin>((x + dx) * (1 << F::Origin::fraction()));
      planes.origin_y = from_raw<F::Origin>((y + dy) * (1 << F::Origin::fraction()));
      const KeyVector<F> vector = key_vector<F>(planes, x, y);
      // Half a pixel less than these.
      const bool fits = dx > -most && dx <= most && dy > -most && dy <= most;
      ASSERT_EQ(is_set(vector.there), fits) << dx << ", " << dy;
      const int half = 1 << f >> 1;
      EXPECT_EQ(int(raw(vector.x)), fits ? dx * (1 << f) - half : 0) << dx << ", " << dy;
      EXPECT_EQ(int(raw(vector.y)), fits ? dy * (1 << f) - half : 0) << dx << ", " << dy;
      fit += fits, ++tried;
      planes.there = from_raw<Bit>(0);
      EXPECT_FALSE(is_set(key_vector<F>(planes, x, y).there));
    }
  }
  EXPECT_EQ(fit, 36);
  EXPECT_EQ(tried, 121);
}

}  // namespace
}  // namespace halfspace::tests
