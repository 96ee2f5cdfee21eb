#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/error.hpp"
#include "solver/program/start_check.hpp"

namespace thalweg {
namespace {

using testing::HasSubstr;

/// Water in three places of the plane above one particle of wall.
ParticleSet start() {
  ParticleSet set;
  set.info.dimension = 2;
  set.info.spacing = 0.01;
  set.id = {0, 1, 2, 3};
  set.type = {ParticleType::wall, ParticleType::water, ParticleType::water, ParticleType::water};
  set.position = {Vec3(0, 0, -0.01), Vec3(0, 0, 0), Vec3(0.01, 0, 0), Vec3(0, 0, 0.01)};
  set.density.assign(4, 1000.0F);
  set.mass.assign(4, 0.1F);
  set.velocity.assign(4, Eigen::Vector3f::Zero());
  return set;
}

std::string answer(const ParticleSet& set) {
  Case scene;
  scene.info.dimension = 2;
  scene.numerics.spacing = 0.01;
  try {
    check_start(set, "p.vtp", scene);
  } catch (const InputError& error) {
    EXPECT_LE(std::string(error.what()).size(), 300U);
    return error.what();
  }
  return "accepted";
}

TEST(StartCheck, AcceptWhatCanStart) { EXPECT_EQ(answer(start()), "accepted"); }

TEST(StartCheck, NameWhatIsMissing) {
  ParticleSet set = start();
  set.mass.clear();
  EXPECT_THAT(answer(set), HasSubstr("arrays Density and Mass are needed"));
  for (const double spacing : {0.0, std::nan(""), -1.0}) {
    set = start();
    set.info.spacing = spacing;
    EXPECT_THAT(answer(set), HasSubstr("the fact Spacing is missing in the field data"));
  }
  set = start();
  set.info.spacing = 0.02;
  EXPECT_THAT(answer(set), HasSubstr("filled with a spacing of 2 cm, the case says 1 cm"));
}

TEST(StartCheck, RefuseWhatCannotBe) {
  const auto spoiled = [](auto&& spoil) {
    ParticleSet set = start();
    spoil(set);
    return answer(set);
  };
  EXPECT_THAT(spoiled([](ParticleSet& s) { s.id[2] = 1; }), HasSubstr("two particles have the id 1"));
  EXPECT_THAT(spoiled([](ParticleSet& s) { s.position[2] = s.position[1]; }),
              HasSubstr("it lies in the place of particle 1"));
  EXPECT_THAT(spoiled([](ParticleSet& s) { s.type.assign(4, ParticleType::wall); }), HasSubstr("holds walls only"));
  EXPECT_THAT(spoiled([](ParticleSet& s) { s.info.time = -1; }), HasSubstr("its time is -1 s"));
  EXPECT_THAT(spoiled([](ParticleSet& s) { s.info.step = -3; }), HasSubstr("its step -3"));
  EXPECT_THAT(spoiled([](ParticleSet& s) { s.density[3] = std::nanf(""); }), HasSubstr("its density is nan"));
  EXPECT_THAT(spoiled([](ParticleSet& s) { s.mass[1] = 0; }), HasSubstr("its mass is 0 kg"));
  EXPECT_THAT(spoiled([](ParticleSet& s) {
                for (Vec3& p : s.position) std::swap(p.y(), p.z());
              }),
              HasSubstr("a 2-D scene lies in the plane of x and z"));
}

}  // namespace
}  // namespace thalweg
