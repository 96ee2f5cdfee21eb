#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/solver/program/channel_run.hpp"

// All variants of cases/channel, 20 H/u* long or longer.
namespace thalweg {
namespace {

class ChannelSeries : public testing::TestWithParam<test::Channel> {};

TEST_P(ChannelSeries, HasTheLogLawsVelocityAndProfile) {
  const test::ChannelResult r = test::run_channel(GetParam());
  const bool fine = GetParam().spacing < 0.006;
  EXPECT_LT(std::abs(r.velocity), test::limit_of("channel", fine ? "velocity_fine" : "velocity"));
  EXPECT_LT(r.profile_rms, test::limit_of("channel", "profile"));
  EXPECT_LT(r.drift, test::limit_of("channel", "drift"));
  EXPECT_LT(std::abs(r.depth), test::limit_of("channel", "depth"));
  EXPECT_NEAR(r.balance, 1, test::limit_of("channel", "stress"));
}

std::vector<test::Channel> variants() {
  std::vector<test::Channel> all;
  for (const double spacing : {0.01, 0.005}) {
    for (const double friction : {0.022, 0.044}) {
      for (const double roughness : {0.0, 1e-3, 3.5e-3}) {
        all.push_back({spacing, friction, roughness, friction < 0.03 ? 92.0 : 46.0, {}});
      }
    }
  }
  return all;
}

INSTANTIATE_TEST_SUITE_P(Variants, ChannelSeries, testing::ValuesIn(variants()), [](const auto& of) {
  const test::Channel& c = of.param;
  return fmt::format("dp_{}_mm_friction_{}_mm_s_roughness_{}_um", std::lround(1e3 * c.spacing),
                     std::lround(1e3 * c.friction_velocity), std::lround(1e6 * c.roughness));
});

}  // namespace
}  // namespace thalweg
