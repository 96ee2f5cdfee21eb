#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "physics/transport/bed_load.hpp"
#include "tests/solver/case_run.hpp"

// A flat bed under a current that decays freely: the flux of its grains, and the momentum that the water loses.
namespace thalweg::test {

/// A flow of `stage` times the critical shear stress over grains of a diameter.
struct FlatBed {
  double spacing = 0;           // [m]
  double diameter = 0;          // [m]
  double grain_density = 2650;  // [kg/m^3]
  double stage = 0;             // theta/theta_cr at the start [-]
  unsigned seed = 1;            // of the noise
  double end = 1.6;             // [s]
  std::vector<std::string> options = {};
  int dimension = 2;
};

/// Means of its run, from a tenth of a second on.
struct FlatBedResult {
  double flux = 0;           // mean, of grains [m^2/s]
  double flux_of_law = 0;    // the same by Meyer-Peter & Mueller of the stresses that the run shows
  double stress_found = 0;   // mean momentum that the water lost, per area and time [Pa]
  double stress_shown = 0;   // mean shear stress on the bed [Pa]
  double resting_share = 0;  // of the sediment at the end [-]
  double highest = 0;        // grain over the bed's first surface at the end, in spacings
};

class FlatBedRun {
 public:
  static constexpr double bed = 0.04;     // [m] thickness
  static constexpr double depth = 0.10;   // [m] of the water
  static constexpr double length = 0.20;  // [m]
  static constexpr double porosity = 0.4;
  static constexpr double critical = 0.047;  // theta_cr

  explicit FlatBedRun(FlatBed of) : of_{std::move(of)}, run_{"flat_bed"} {}

  FlatBedResult result() {
    start();
    EXPECT_EQ(run_solver(run_.options()), Exit::done);
    FlatBedResult r;
    double first_momentum = 0;
    double last_momentum = 0;
    std::vector<double> times;
    for (const SeriesEntry& e : read_series(run_.folder().snapshot_series())) {
      if (e.time < 0.09) continue;
      const ParticleSet p = read_particles(run_.folder().root / e.file);
      add(p, r);
      last_momentum = momentum_of_water(p);
      if (times.empty()) first_momentum = last_momentum;
      times.push_back(e.time);
    }
    const auto n = static_cast<double>(times.size());
    r.flux /= n;
    r.flux_of_law /= n;
    r.stress_shown /= n;
    r.stress_found = (first_momentum - last_momentum) / (times.back() - times.front());
    return r;
  }

 private:
  [[nodiscard]] double weight() const { return (of_.grain_density - 1000) * 9.81 * of_.diameter; }  // of theta [Pa]

  void start() {
    const auto quantity = [](double value, const char* unit) {
      return "\"" + std::to_string(value) + " " + unit + "\"";
    };
    const double friction = std::sqrt(of_.stage * critical * weight() / 1000);
    const double origin = 0.11 * 1e-6 / friction + 0.033 * of_.diameter;
    const double surface = friction / 0.41 * std::log(depth / origin);
    std::vector<std::string> options = {"numerics.spacing=" + quantity(of_.spacing, "m"),
                                        "numerics.maximum_speed=" + quantity(std::max(1.5, 1.2 * surface), "m/s"),
                                        "output.end=" + quantity(of_.end, "s"),
                                        "materials.sand.grain_density=" + quantity(of_.grain_density, "kg/m^3"),
                                        "materials.sand.grain_diameter=" + quantity(of_.diameter, "m")};
    options.insert(options.end(), of_.options.begin(), of_.options.end());
    const char* file = of_.dimension == 2 ? "/flat.toml" : "/flat_3d.toml";
    run_.fill_from(std::string(THALWEG_SOURCE_DIR "/tests/solver/program/bed_load") + file, options);
    ParticleSet particles = run_.start();
    std::mt19937 random(of_.seed);
    std::uniform_real_distribution<double> noise(-friction / 2, friction / 2);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      if (particles.type[i] != ParticleType::water) continue;
      const double z = std::max(particles.position[i].z() - bed, 1.5 * origin);
      const double along = friction / 0.41 * std::log(z / origin);
      const Vec3 u(along + noise(random), of_.dimension == 3 ? noise(random) : 0, noise(random));
      particles.velocity[i] = u.cast<float>();
    }
    write_particles(run_.folder().particles(), particles, PositionPrecision::double_precision);
  }

  /// Area of the bed [m^(dim-1)].
  [[nodiscard]] double area() const { return of_.dimension == 3 ? length * width : length; }

  void add(const ParticleSet& p, FlatBedResult& r) const {
    const auto& shields = p.scalars.at("ShieldsNumber");
    const auto& resting = p.scalars.at("Resting");
    const double rho = of_.grain_density * (1 - porosity) + 1000 * porosity;
    double flux = 0;
    double of_law = 0;
    double stress = 0;
    double surface = 0;
    double rest = 0;
    double sediment = 0;
    r.highest = -1;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.type[i] != ParticleType::sediment) continue;
      flux += (1 - porosity) * double(p.mass[i]) / rho * double(p.velocity[i].x());
      sediment += 1;
      rest += double(resting[i]);
      r.highest = std::max(r.highest, (p.position[i].z() - bed) / of_.spacing);
      if (!(shields[i] > 0)) continue;
      surface += 1;
      stress += double(shields[i]) * weight();
      of_law += meyer_peter_mueller(double(shields[i]), critical);
    }
    r.flux += flux / area();
    r.flux_of_law += of_law / surface * bed_load_scale(of_.diameter, of_.grain_density, 1000.0, 9.81);
    r.stress_shown += stress / surface;
    r.resting_share = rest / sediment;
  }

  /// Along the flow, per area [kg/(m s)].
  [[nodiscard]] double momentum_of_water(const ParticleSet& p) const {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
      if (p.type[i] == ParticleType::water) sum += double(p.mass[i]) * double(p.velocity[i].x());
    }
    return sum / area();
  }

  static constexpr double width = 0.05;  // [m] in space

  FlatBed of_;
  CaseRun run_;
};

}  // namespace thalweg::test
