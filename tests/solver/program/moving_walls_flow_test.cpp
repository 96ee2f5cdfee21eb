#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "tests/solver/program/broken_run.hpp"

// Scenes of tests/solver/moving_walls, run as the programs would.
namespace thalweg {
namespace {

constexpr double gravity = 9.81;

struct Extent {
  double low = 1e9;
  double high = -1e9;
};

Extent extent_x(const ParticleSet& p, ParticleType type) {
  Extent e;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] != type) continue;
    e.low = std::min(e.low, p.position[i].x());
    e.high = std::max(e.high, p.position[i].x());
  }
  return e;
}

Vec3 center_of_water(const ParticleSet& p) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] != ParticleType::water) continue;
    sum += p.position[i];
    count += 1;
  }
  return sum / count;
}

std::unique_ptr<test::CaseRun> ran(const std::string& scene, const std::vector<std::string>& overrides = {}) {
  auto run = std::make_unique<test::CaseRun>(scene);
  run->fill_from(THALWEG_SOURCE_DIR "/tests/solver/program/moving_walls/" + scene + ".toml", overrides);
  EXPECT_EQ(run_solver(run->options()), Exit::done);
  return run;
}

TEST(Piston, RaisesTheLevelByTheVolumeItTakes) {
  const auto run = ran("piston");
  const ParticleSet start = run->snapshot_at(0);
  // 0.35 m of water 0.1 m deep, pushed together to 0.25 m.
  const double depth = 0.35 * 0.1 / 0.25;
  double height = 0;
  double count = 0;
  for (const double t : {1.6, 1.7, 1.8, 1.9, 2.0}) {  // the water still swings a little
    const ParticleSet now = run->snapshot_at(t);
    const Extent water = extent_x(now, ParticleType::water);
    const Extent piston = extent_x(now, ParticleType::moving_wall);
    EXPECT_NEAR(piston.high, 0.145, 1e-6);
    EXPECT_GT(water.low, piston.high + 0.002) << "none behind the piston";
    EXPECT_EQ(now.size(), start.size()) << "none lost";
    height += center_of_water(now).z(), count += 1;
  }
  height /= count;
  // Compression lowers it by less than 0.1 %; the particles of floor and surface stand some hundredths of the spacing,
  // 0.6 % of the depth with h = 2 dp, off a lattice's half.
  std::cout << "level " << 2 * height << " m, by volume " << depth << " m\n";
  EXPECT_NEAR(2 * height, depth, 0.0075 * depth);
}

TEST(AcceleratedTank, SwingsAboutTheSurfaceSquareToGravityLessAcceleration) {
  const auto run = ran("tank");
  // Linear sloshing from a level surface swings by as much beyond the slope -a/g as it was before it: its mean over
  // whole periods is the equilibrium. The slope s moves the centre of the water by s L^2/(12 H).
  const double length = 0.2, depth = 0.1, a = 1.5;
  const double k = std::numbers::pi / length;
  const double period = 2 * std::numbers::pi / std::sqrt(gravity * k * std::tanh(k * depth));
  double sum = 0;
  double count = 0;
  double least = 0;
  for (const SeriesEntry& e : read_series(run->folder().snapshot_series())) {
    if (e.time > 2 * period) break;
    const ParticleSet now = read_particles(run->folder().root / e.file);
    const Extent tank = extent_x(now, ParticleType::moving_wall);
    // The walls are as thick as the support, four rows; their outermost particles stand 3.5 spacings outside.
    EXPECT_NEAR(tank.low, -0.0175 + 0.5 * a * e.time * e.time, 0.003) << e.time;
    const double offset = center_of_water(now).x() - 0.5 * (tank.low + tank.high);
    sum += offset, count += 1;
    least = std::min(least, offset);
  }
  const double slope = sum / count * 12 * depth / (length * length);
  std::cout << "mean slope " << slope << ", -a/g " << -a / gravity << "; largest " << least * 12 * depth / 0.04 << "\n";
  // Two periods in samples of 20 ms, and a surface that is no plane while it swings.
  EXPECT_NEAR(slope, -a / gravity, 0.05 * a / gravity);
  EXPECT_LT(least * 12 * depth / (length * length), -1.5 * a / gravity) << "and does swing";
}

/// Edge of the water's tongue, as the measure "water front" of `thalweg validate`.
double front(const ParticleSet& p) {
  std::vector<double> x;
  for (std::size_t i = 0; i < p.size(); ++i) {
    if (p.type[i] == ParticleType::water) x.push_back(p.position[i].x());
  }
  std::nth_element(x.begin(), x.end() - 3, x.end());
  return *(x.end() - 3) + 0.5 * p.info.spacing;
}

TEST(Gate, HoldsTheWaterAndDelaysTheFrontByLessThanItsOpening) {
  const auto gate = ran("gate");
  test::CaseRun free("free");
  free.fill("dam_break", {});
  ASSERT_EQ(run_solver(free.options()), Exit::done);
  const double lift = 0.1, opening = 0.2 / 4;  // [s]
  EXPECT_LT(extent_x(gate->snapshot_at(lift), ParticleType::water).high, 0.1) << "closed so far";
  for (const double since : {0.1, 0.14, 0.18}) {
    const double with_gate = front(gate->snapshot_at(lift + since));
    const double at_once = front(free.snapshot_at(since));
    const double later = front(free.snapshot_at(since - opening));
    std::cout << since << " s after: front " << with_gate << ", without gate " << at_once << ", one opening before "
              << later << "\n";
    // The jet under a half-open gate is as fast as the front of a free column: two spacings for the tongue's edge.
    EXPECT_LT(with_gate, at_once + 0.01);
    EXPECT_GT(with_gate, later - 0.01);
  }
}

const std::vector<std::string> short_flume = {"output.end=\"0.3 s\"", "output.interval=\"0.1 s\""};

TEST(Paddles, AreWhereTheirMotionsPutThem) {
  test::CaseRun run("motions");
  run.fill_from(THALWEG_SOURCE_DIR "/tests/case/good_case_moving.toml", short_flume);
  ASSERT_EQ(run_solver(run.options()), Exit::done);
  const ParticleSet end = read_particles(run.folder().checkpoint());
  const auto& motion = end.scalars.at(motion_array);
  const ParticleSet& start = run.start();
  int turned = 0;
  for (std::size_t i = 0; i < end.size(); ++i) {
    const auto id = static_cast<std::size_t>(end.id[i]);
    EXPECT_EQ(motion[i], start.scalars.at(motion_array)[id]);
    Vec3 expected = start.position[id];
    if (motion[i] == 1) expected.x() += 0.03;
    if (motion[i] == 2) expected.z() += 1.0 / 18 + (0.2 - 1.0 / 9);
    if (motion[i] == 4) {
      const Vec3 arm = expected - Vec3(1.2, 0, 0.3);
      const double c = std::cos(0.6), s = std::sin(0.6);
      expected = Vec3(1.2 + c * arm.x() - s * arm.z(), 0, 0.3 + s * arm.x() + c * arm.z());
      ++turned;
    }
    if (motion[i] == 0 || motion[i] == 3 || end.type[i] != ParticleType::moving_wall) continue;
    EXPECT_LT((end.position[i] - expected).norm(), 1e-14) << "motion " << motion[i];
  }
  EXPECT_GT(turned, 20);
}

TEST(Paddles, ContinueBitForBitAfterARestart) {
  test::TwoEnds ends;
  ASSERT_NO_FATAL_FAILURE(
      test::run_with_a_break(THALWEG_SOURCE_DIR "/tests/case/good_case_moving.toml", short_flume, "0.2 s", ends));
}

}  // namespace
}  // namespace thalweg
