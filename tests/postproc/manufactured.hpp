#pragma once

#include <cmath>
#include <functional>
#include <random>

#include "common/particles.hpp"

namespace thalweg::manufactured {

/// The floor of a flume that does not slope: 0 [m] at any x.
inline double flat(double) { return 0; }

/// Particle sets whose surfaces are known beforehand: a flume of length x in [from, from + length], floor at z = 0,
/// walls four layers thick, filled from below on a lattice whose cells are cut at the surface by moving the particle
/// and its volume into the filled part of the cell.
struct Flume {
  double spacing = 0.005;  // [m]
  double from = 0;         // [m] of the flume
  double length = 1.0;     // [m]
  double wall_height = 0.4;
  int dimension = 2;
  double width = 0.1;  // [m] 3-D
  double jitter = 0;   // [-] of the spacing, uniform in both directions
  bool walls = true;
  ParticleSet set;
  std::mt19937 random{20240317};  // any seed; fixed so that a failure repeats

  using Height = std::function<double(double)>;

  void begin() {
    set = {};
    set.info.dimension = dimension;
    set.info.spacing = spacing;
    set.info.smoothing_length = 1.5 * spacing;
  }

  void add(ParticleType type, const Vec3& at, double volume_share = 1, const Eigen::Vector3f& velocity = {0, 0, 0}) {
    const double density = type == ParticleType::sediment ? 1286 : 1000;
    set.id.push_back(static_cast<std::int64_t>(set.id.size()));
    set.type.push_back(type);
    set.position.push_back(at);
    set.velocity.push_back(velocity);
    set.density.push_back(static_cast<float>(density));
    set.mass.push_back(static_cast<float>(density * std::pow(spacing, dimension) * volume_share));
  }

  void add_walls() {
    const int layers = 4;
    const int nx = static_cast<int>(std::lround(length / spacing));
    const int nz = static_cast<int>(std::lround(wall_height / spacing));
    const double shift = from / spacing + 0.5;
    for (int i = -layers; i < nx + layers; ++i) {
      for (int k = -layers; k < nz; ++k) {
        if (i >= 0 && i < nx && k >= 0) continue;
        each_y([&](double y) { add(ParticleType::wall, {(i + shift) * spacing, y, (k + 0.5) * spacing}); });
      }
    }
  }

  /// Fills lower(x) < z < upper(x), for x in [left, right], with a phase moving at velocity(z).
  void fill(
      ParticleType type, double left, double right, const Height& lower, const Height& upper,
      const std::function<float(double x, double z)>& speed = [](double, double) { return 0.F; }) {
    std::uniform_real_distribution<double> shake(-jitter, jitter);
    for (long i = std::lround(left / spacing); i < std::lround(right / spacing); ++i) {
      const double x = (static_cast<double>(i) + 0.5) * spacing;
      const double bottom = lower(x);
      const double top = upper(x);
      for (long k = std::lround(std::floor(bottom / spacing)); static_cast<double>(k) * spacing < top; ++k) {
        const double low = std::max(bottom, static_cast<double>(k) * spacing);
        const double high = std::min(top, static_cast<double>(k + 1) * spacing);
        if (high - low < 1e-9) continue;
        each_y([&](double y) {
          const double z = (low + high) / 2;
          add(type, {x + shake(random) * spacing, y, z + shake(random) * (high - low)}, (high - low) / spacing,
              {speed(x, z), 0, 0});
        });
      }
    }
  }

 private:
  void each_y(const std::function<void(double)>& place) const {
    if (dimension == 2) return place(0);
    for (int j = 0; j < std::lround(width / spacing); ++j) place((j + 0.5) * spacing);
  }
};

}  // namespace thalweg::manufactured
