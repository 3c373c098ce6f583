// SPDX-License-Identifier: Apache-2.0
// The kernels as compiled for a configuration give the words that they give with formats read at run time.
#include <gtest/gtest.h>

#include "model/pipeline/engine_impl.hpp"
#include "tests/motion/field_fixture.hpp"
#include "tests/motion/motion_configs.hpp"
#include "vectors/frames/awkward.hpp"
#include "vectors/standard_set.hpp"

namespace halfspace::tests {
namespace {

template <class C>
void expect_compiled_words() {
  const model::Configuration configuration = configuration_of(C::config());
  const std::unique_ptr<model::Engine> compiled = std::make_unique<model::KernelEngine<Formats<C, Stamp4>>>();
  const auto read = model::make_engine(configuration, 4);
  std::size_t compared = 0;
  for (const auto& frame : model::random_frames(model::raster_format(configuration), 5, 2, 60)) {
    const model::MotionFrame words = model::awkward_motion(frame.scene, C::config(), 9);
    const Field a = field_of(*compiled, frame.scene, words), b = field_of(*read, frame.scene, words);
    ASSERT_EQ(a.motion.size(), b.motion.size());
    for (std::size_t n = 0; n < a.motion.size(); ++n) {
      const model::RawMotion &x = a.motion[n], &y = b.motion[n];
      ASSERT_TRUE(x.x == y.x && x.y == y.y && x.face == y.face);
      for (int key = 0; key < ref::kKeys; ++key) {
        ASSERT_TRUE(x.key[key].there == y.key[key].there && x.key[key].x == y.key[key].x &&
                    x.key[key].y == y.key[key].y && x.key[key].difference == y.key[key].difference);
        compared += x.key[key].there;
      }
    }
  }
  EXPECT_GT(compared, 1000u);
}
TEST(MotionFieldFormats, CompiledAffine) { expect_compiled_words<MotionLow>(); }
TEST(MotionFieldFormats, CompiledPerspective) { expect_compiled_words<MotionMiddle>(); }

}  // namespace
}  // namespace halfspace::tests
