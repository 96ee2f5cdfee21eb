#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "physics/water/log_profile.hpp"
#include "tests/solver/case_run.hpp"

// Runs cases/channel and compares the steady current with the logarithmic law (cases/channel/README.md).
namespace thalweg::test {

struct Channel {
  double spacing = 0;            // [m]
  double friction_velocity = 0;  // sqrt(g H S) [m/s]
  double roughness = 0;          // [m]
  double end = 0;                // [s]
  std::vector<std::string> options = {};
};

/// Means over the last third.
struct ChannelResult {
  double velocity = 0;     // bulk velocity over that of the law, minus 1
  double profile_rms = 0;  // of the velocity minus the law's, over the bulk velocity
  double drift = 0;        // change of the bulk velocity in the last 6 H/u*, over itself
  double depth = 0;        // twice the mean height of the water, minus the depth, in spacings
  double balance = 0;      // (drive - dU/dt) H over u*^2
};

inline constexpr double channel_depth = 0.1;  // [m]
inline constexpr double channel_viscosity = 1e-6;

/// Slope of the straight line through the points from index `first` on.
inline double trend(const std::vector<double>& t, const std::vector<double>& y, std::size_t first) {
  double n = 0;
  double st = 0;
  double sy = 0;
  double stt = 0;
  double sty = 0;
  for (std::size_t i = first; i < t.size(); ++i) {
    n += 1, st += t[i], sy += y[i], stt += t[i] * t[i], sty += t[i] * y[i];
  }
  return (n * sty - st * sy) / (n * stt - st * st);
}

inline ChannelResult run_channel(const Channel& of) {
  const double H = channel_depth;
  const double friction = of.friction_velocity;
  const auto text = [](double value, const char* unit) {
    return fmt::format("\"{:.9g}{}{}\"", value, *unit == 0 ? "" : " ", unit);
  };
  std::vector<std::string> options = {
      "numerics.spacing=" + text(of.spacing, "m"), fmt::format("flow.slope={:.9g}", friction * friction / (9.81 * H)),
      "shape.floor.roughness=" + text(std::max(of.roughness, 1e-10), "m"), "output.end=" + text(of.end, "s")};
  options.insert(options.end(), of.options.begin(), of.options.end());
  CaseRun run("channel");
  run.fill("channel", options);
  EXPECT_EQ(run_solver(run.options()), Exit::done);

  const CsvTable history = CsvTable::read(run.folder().history());
  const auto t = history.numbers("time", "s");
  const auto U = history.numbers("bulk_velocity", "m/s");
  const auto drive = history.numbers("drive", "m/s^2");
  const auto after = [&](double from) {
    std::size_t i = 0;
    while (i + 2 < t.size() && t[i] < from) ++i;
    return i;
  };
  const std::size_t third = after(of.end * 2 / 3);
  const std::size_t six = after(of.end - 6 * H / friction);
  double mean = 0;
  double pull = 0;
  for (std::size_t i = third; i < t.size(); ++i) mean += U[i], pull += drive[i];
  const auto n = static_cast<double>(t.size() - third);
  mean /= n, pull /= n;

  ChannelResult r;
  const double origin = profile_origin(friction, channel_viscosity, of.roughness);
  r.velocity = mean / (friction / 0.41 * (std::log(H / origin) - 1 + origin / H)) - 1;
  r.drift = std::abs(trend(t, U, six)) * (t.back() - t[six]) / mean;
  r.balance = (pull - trend(t, U, third)) * H / (friction * friction);

  const auto rows = static_cast<std::size_t>(std::lround(H / of.spacing)) + 1;
  std::vector<double> difference(rows, 0.0);
  std::vector<double> number(rows, 0.0);
  double height = 0;
  double water = 0;
  for (const SeriesEntry& e : read_series(run.folder().snapshot_series())) {
    if (e.time < of.end * 2 / 3) continue;
    const ParticleSet p = read_particles(run.folder().root / e.file);
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.type[i] != ParticleType::water) continue;
      const double z = p.position[i].z();
      height += z, water += 1;
      const auto row = std::min(rows - 1, static_cast<std::size_t>(std::max(0.0, z / of.spacing)));
      difference[row] += double(p.velocity[i].x()) - log_profile(friction, z, channel_viscosity, of.roughness);
      number[row] += 1;
    }
  }
  r.depth = (2 * height / water - H) / of.spacing;
  double squares = 0;
  double kept = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    if (number[row] < 0.02 * water / static_cast<double>(rows)) continue;  // particles that fly over the surface
    squares += std::pow(difference[row] / number[row], 2);
    kept += 1;
  }
  r.profile_rms = std::sqrt(squares / kept) / mean;
  return r;
}

}  // namespace thalweg::test
