#include <gtest/gtest.h>

#include <string>

#include "physics/transport/lift_settling.hpp"
#include "tests/solver/case_run.hpp"

// A parcel of sand alone in still water sinks at the settling velocity of its grains, whatever its size.
namespace thalweg {
namespace {

struct LoneParcel {
  const char* scene;
  double spacing;   // [m]
  double diameter;  // of the grains [m]
};

std::string metres(double length) { return "\"" + std::to_string(length) + " m\""; }

/// Velocity at which the only particle of sediment sinks between 0.3 and 1 s [m/s].
double sinks_at(const LoneParcel& of) {
  const bool plane = std::string(of.scene) == "plane";
  const std::string side = metres((plane ? 0.1 : 0.06) + of.spacing);
  const std::string top = metres((plane ? 0.25 : 0.15) + of.spacing);
  test::CaseRun run("lone_parcel");
  run.fill_from(std::string(THALWEG_SOURCE_DIR "/tests/solver/program/lone_parcel/") + of.scene + ".toml",
                {"numerics.spacing=" + metres(of.spacing), "materials.sand.grain_diameter=" + metres(of.diameter),
                 "shape.parcel.to=[" + side + ", " + (plane ? "" : side + ", ") + top + "]"});
  EXPECT_EQ(run_solver(run.options()), Exit::done);
  const auto height_at = [&](double time) {
    const ParticleSet p = run.snapshot_at(time);
    double height = 0;
    int parcels = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.type[i] == ParticleType::sediment) height = p.position[i].z(), ++parcels;
    }
    EXPECT_EQ(parcels, 1);
    return height;
  };
  return (height_at(0.3) - height_at(1)) / 0.7;
}

class SinkingParcel : public testing::TestWithParam<LoneParcel> {};

// Soulsby: 0.026 m/s and 0.120 m/s. With the parcel's whole weight on the water around it fell as a cloud of its size, fine
// grains at up to 1.8 times that.
TEST_P(SinkingParcel, SinksLikeItsGrains) {
  const LoneParcel& of = GetParam();
  const double star = dimensionless_diameter(of.diameter, 2650.0, 1000.0, 9.81, 1e-3);
  const double known = settling_velocity(star, of.diameter, 1e-6);
  EXPECT_NEAR(sinks_at(of), known, 0.1 * known);
}

INSTANTIATE_TEST_SUITE_P(Sand, SinkingParcel,
                         testing::Values(LoneParcel{"plane", 0.01, 0.2e-3}, LoneParcel{"plane", 0.005, 0.2e-3},
                                         LoneParcel{"plane", 0.01, 1e-3}, LoneParcel{"plane", 0.005, 1e-3},
                                         LoneParcel{"space", 0.01, 0.2e-3}, LoneParcel{"space", 0.01, 1e-3}));

}  // namespace
}  // namespace thalweg
