#include "case/scales.hpp"

#include <gtest/gtest.h>

#include "common/error.hpp"
#include "tests/gencase/scene.hpp"

namespace thalweg::gencase::test {
namespace {

TEST(Scales, SoundSpeedFollowsFromTheFluidsHeight) {
  Case scene = empty_scene(2, 0.01);
  scene.domain.gravity = Vec3(0, 0, -10);
  scene.numerics.sound_speed_factor = 10;
  // 2 sqrt(10 m/s^2 * 0.4 m) = 4 m/s
  EXPECT_DOUBLE_EQ(maximum_speed(scene, 0.4), 4);
  EXPECT_DOUBLE_EQ(sound_speed(scene, 0.4), 40);
}

TEST(Scales, GivenMaximumSpeedWins) {
  Case scene = empty_scene(2, 0.01);
  scene.numerics.maximum_speed = 1.5;
  scene.numerics.sound_speed_factor = 20;
  EXPECT_DOUBLE_EQ(sound_speed(scene, 0.4), 30);
}

TEST(Scales, WithoutGravityTheSpeedHasToBeGiven) {
  Case scene = empty_scene(2, 0.01);
  scene.domain.gravity = Vec3::Zero();
  EXPECT_THROW(sound_speed(scene, 0.4), InputError);
}

}  // namespace
}  // namespace thalweg::gencase::test
