#include "solver/passes/time_step.hpp"

#include <gtest/gtest.h>

namespace thalweg {
namespace {

TEST(TimeStep, LandsOnOutputWithoutATinyLastStep) {
  TimeStep far{1e-3, Limiter::sound, {}};
  land_on_output(far, 1);
  EXPECT_EQ(far.dt, 1e-3);
  TimeStep last{1e-3, Limiter::sound, {}};
  land_on_output(last, 0.9e-3);
  EXPECT_EQ(last.dt, 0.9e-3);
  TimeStep shared{1e-3, Limiter::sound, {}};
  land_on_output(shared, 1.2e-3);
  EXPECT_EQ(shared.dt, 0.6e-3);
  EXPECT_EQ(shared.limiter, Limiter::output);
}

}  // namespace
}  // namespace thalweg
