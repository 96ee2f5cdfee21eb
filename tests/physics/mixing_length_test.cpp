#include "physics/water/mixing_length.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "physics/water/current_control.hpp"
#include "physics/water/log_profile.hpp"

namespace thalweg {
namespace {

constexpr double nu = 1e-6;  // [m^2/s]

TEST(MixingLength, IsThatOfAnOpenChannel) {
  // 0.41 * 0.025 m * sqrt(1 - 0.25) = 8.877 mm
  EXPECT_NEAR(mixing_length(0.025, 0.1), 8.8768e-3, 1e-7);
  EXPECT_EQ(mixing_length(0.0, 0.1), 0);
  EXPECT_EQ(mixing_length(0.1, 0.1), 0);
  EXPECT_EQ(mixing_length(0.2, 0.1), 0);  // farther from walls than the water is deep
  EXPECT_EQ(mixing_length(0.1, 0.0), 0);  // no water to speak of
  EXPECT_NEAR(mixing_length(1e-6, 0.1), 0.41e-6, 1e-11);
}

TEST(EddyViscosity, CarriesTheStressOfUniformFlowWithALogarithmicProfile) {
  // nu_t du/dz with du/dz = u*/(kappa z) is u*^2 (1 - z/H) at every height.
  const double H = 0.1;
  const double friction = 0.044;
  for (const double z : {0.001, 0.02, 0.05, 0.099}) {
    const double rate = friction / (0.41 * z);
    const double speed = log_profile(friction, z, nu, 1e-3);
    EXPECT_NEAR(eddy_viscosity(mixing_length(z, H), rate, speed) * rate, friction * friction * (1 - z / H), 1e-12) << z;
  }
}

TEST(EddyViscosity, IsThatOfFreeShearLayersFarFromWalls) {
  // In units of U and of the thickness, at half of the largest U. Measured: Goertler's mixing layer, the plane
  // jet (growth of the half width 0.10), the plane wall jet (0.073).
  const double far = 10;
  EXPECT_NEAR(eddy_viscosity(far, 1.0, 0.5), 0.0128, 0.25 * 0.0128);
  EXPECT_NEAR(eddy_viscosity(far, 0.62, 0.5), 0.032, 0.25 * 0.032);
  EXPECT_NEAR(eddy_viscosity(far, 0.69, 0.5), 0.022, 0.25 * 0.022);
  EXPECT_EQ(eddy_viscosity(far, 0.0, 0.5), 0);
  EXPECT_EQ(eddy_viscosity(far, 1.0, 0.0), 0);
  EXPECT_EQ(eddy_viscosity(0.0, 0.0, 0.0), 0);
}

TEST(LogProfile, VanishesAtItsOriginAndIsThatOfHand) {
  // ln(0.05/(2.5e-6 + 33e-6)) = 7.2505; 0.044/0.41 times that
  EXPECT_NEAR(log_profile(0.044, 0.05, nu, 1e-3), 0.77808, 1e-4);
  EXPECT_EQ(log_profile(0.044, profile_origin(0.044, nu, 1e-3), nu, 1e-3), 0);
  EXPECT_EQ(log_profile(0.044, 0.0, nu, 0.0), 0);
}

TEST(LogProfile, HasTheMeanFromWhichItsFrictionVelocityFollows) {
  for (const double ks : {0.0, 1e-3, 3.5e-3}) {
    for (const double friction : {0.022, 0.044}) {
      const double H = 0.1;
      double sum = 0;
      constexpr int slices = 200000;
      for (int k = 0; k < slices; ++k) sum += log_profile(friction, H * (k + 0.5) / slices, nu, ks);
      // The closed mean leaves out z0/H, which is 1.2e-3 with the roughest floor.
      EXPECT_NEAR(friction_velocity_of_current(sum / slices, H, nu, ks), friction, 3e-4 * friction) << ks;
    }
  }
}

/// Water of the depth H that a control drives from a velocity against the friction of the law of the wall.
struct Channel {
  double H = 0.1;
  double ks = 1e-3;
  double friction_at_target = 0;
  CurrentControl control;

  Channel(double target, double velocity) {
    friction_at_target = friction_velocity_of_current(target, H, nu, ks);
    const double present = friction_velocity_of_current(velocity, H, nu, ks);
    control.target = target;
    control.time = 0.1 * H / friction_at_target;
    control.velocity = velocity;
    control.drag = present * present / H;
    control = started(control);
  }
  void step(double dt) {
    const double friction = friction_velocity_of_current(control.velocity, H, nu, ks);
    const double U = control.velocity + dt * (control.acceleration - friction * friction / H);
    control = after_step(control, U, dt);
  }
};

TEST(CurrentControl, ReachesItsTargetFromRestWithoutOvershoot) {
  Channel channel(0.7, 0);
  const double dt = 5e-4;
  const double due = 2.2 * channel.H / channel.friction_at_target;  // within 0.1 % by then
  double highest = 0;
  for (double t = 0; t < 20 * channel.H / channel.friction_at_target; t += dt) {
    channel.step(dt);
    highest = std::max(highest, channel.control.velocity);
    if (t > due) {
      EXPECT_NEAR(channel.control.velocity, 0.7, 1e-3 * 0.7);
    }
  }
  EXPECT_LT(highest, 1.01 * 0.7);
  const double friction = channel.friction_at_target;
  EXPECT_NEAR(channel.control.acceleration, friction * friction / channel.H, 1e-6 * friction * friction / channel.H);
}

TEST(CurrentControl, LeavesASteadyCurrentAlone) {
  Channel channel(0.7, 0.7);
  const double drive = channel.control.acceleration;
  for (int n = 0; n < 1000; ++n) channel.step(5e-4);
  EXPECT_NEAR(channel.control.velocity, 0.7, 1e-12);
  EXPECT_NEAR(channel.control.acceleration, drive, 1e-9 * drive);
}

TEST(CurrentControl, FindsADragThatNoLawKnows) {
  // A body takes 0.05 m/s^2 from second 2 on.
  Channel channel(0.7, 0.7);
  const double dt = 5e-4;
  const double before = channel.control.acceleration;
  for (double t = 0; t < 10; t += dt) {
    channel.step(dt);
    if (t > 2) channel.control = after_step(channel.control, channel.control.velocity - dt * 0.05, 0);
  }
  EXPECT_NEAR(channel.control.velocity, 0.7, 1e-4);
  EXPECT_NEAR(channel.control.acceleration - before, 0.05, 5e-4);
}

}  // namespace
}  // namespace thalweg
