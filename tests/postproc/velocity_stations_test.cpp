#include "postproc/velocity_stations.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "common/io/particle_file.hpp"
#include "physics/water/log_profile.hpp"
#include "tests/postproc/synthetic_run.hpp"

// Velocity over the depth of a current, from snapshots made by hand.
namespace thalweg {
namespace {

using manufactured::TemporaryFolder;

/// Water 0.1 m deep over z = 20 mm with the velocity of a law, from x = 0 to 1 m.
ParticleSet current(double friction_velocity) {
  ParticleSet p;
  p.info.dimension = 2;
  p.info.spacing = 0.01;
  for (int column = 0; column < 100; ++column) {
    for (int row = 0; row < 10; ++row) {
      const double height = (row + 0.5) * 0.01;
      p.id.push_back(static_cast<std::int64_t>(p.id.size()));
      p.type.push_back(ParticleType::water);
      p.position.emplace_back((column + 0.5) * 0.01, 0, 0.02 + height);
      p.velocity.emplace_back(static_cast<float>(log_profile(friction_velocity, height, 1e-6, 1e-3)), 0, 0);
      p.density.push_back(1000);
      p.pressure.push_back(0);
      p.mass.push_back(0.1F);
    }
  }
  return p;
}

Case flume() {
  Case of;
  of.info.dimension = 2;
  of.numerics.spacing = 0.01;
  of.water.density = 1000;
  of.water.viscosity = 1e-3;
  of.flow.drive = Drive::slope;
  of.model.wall_friction = WallFriction::rough;
  of.shapes.emplace_back().roughness = 1e-3;
  return of;
}

TEST(VelocityStations, ReadThoseOfAMeshModel) {
  const TemporaryFolder folder("mesh_stations");
  const auto file = folder.path() / "stations.csv";
  EXPECT_TRUE(read_velocity_stations(file).empty());
  std::ofstream(file) << "place [m],height [m],velocity [m/s],law [m/s],ground [m],depth [m],mean_velocity [m/s],"
                         "friction_velocity [m/s]\n"
                         "0.5,0.01,0.3,0.2,0.04,0.02,0.4,0.02\n0.5,0.03,0.5,0.5,0.04,0.02,0.4,0.02\n"
                         "1,0.01,0.4,0.4,0.04,0.02,0.4,0.02\n";
  const std::vector<VelocityStation> stations = read_velocity_stations(file);
  ASSERT_EQ(stations.size(), 2U);
  EXPECT_EQ(stations[0].velocity, (std::vector{0.3, 0.5}));
  EXPECT_NEAR(stations[0].deviation, std::sqrt(0.01 / 2) / 0.4, 1e-12);
  EXPECT_EQ(stations[1].deviation, 0);
}

TEST(VelocityStations, FindTheLawThatTheWaterHas) {
  const TemporaryFolder folder("stations");
  std::vector<SeriesEntry> snapshots;
  for (const double t : {0.0, 1.0, 2.0}) {
    const auto file = folder.path() / ("s" + std::to_string(snapshots.size()) + ".vtp");
    write_particles(file, current(t == 0 ? 0.01 : 0.044), PositionPrecision::double_precision);
    snapshots.push_back({t, file});
  }
  const std::vector<VelocityStation> stations = velocity_stations(flume(), snapshots);
  ASSERT_EQ(stations.size(), 3U);
  for (const VelocityStation& station : stations) {
    EXPECT_NEAR(station.ground, 0.02, 1e-6);
    EXPECT_NEAR(station.depth, 0.1, 1e-4);
    EXPECT_EQ(station.height.size(), 10U);
    // The mean of ten rows lies 1 % over that of the continuous law, whose lowest spacing has most of the curvature.
    EXPECT_NEAR(station.friction_velocity, 0.044, 0.02 * 0.044);
    EXPECT_LT(station.deviation, 0.02);
  }
  EXPECT_NEAR(stations[1].place, 0.5, 1e-6);
  EXPECT_NEAR(stations[0].velocity[4], log_profile(0.044, 0.045, 1e-6, 1e-3), 1e-5);
}

TEST(VelocityStations, PassOverADamagedSnapshot) {
  const TemporaryFolder folder("damaged_station");
  const auto whole = folder.path() / "s0.vtp";
  const auto damaged = folder.path() / "s1.vtp";
  write_particles(whole, current(0.044), PositionPrecision::double_precision);
  manufactured::write_text(damaged, "no particles");
  const std::vector<VelocityStation> stations = velocity_stations(flume(), {{1, damaged}, {1.5, whole}});
  ASSERT_EQ(stations.size(), 3U);
  EXPECT_NEAR(stations[0].depth, 0.1, 1e-4);
  EXPECT_TRUE(velocity_stations(flume(), {{1, damaged}}).empty());
}

TEST(VelocityStations, AreNoneWithoutACurrent) {
  Case still = flume();
  still.flow.drive = Drive::off;
  EXPECT_TRUE(velocity_stations(still, {}).empty());
}

}  // namespace
}  // namespace thalweg
