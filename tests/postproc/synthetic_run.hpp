#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "case/reader/case_file.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/series.hpp"
#include "common/run_folder.hpp"
#include "tests/postproc/manufactured.hpp"

namespace thalweg::manufactured {

/// A folder that is removed at the end of the test, unless THALWEG_KEEP names a folder to put it in.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::string& name) {
    const char* keep = std::getenv("THALWEG_KEEP");
    kept_ = keep != nullptr;
    path_ = kept_ ? std::filesystem::path(keep) / name
                  : std::filesystem::temp_directory_path() / fmt::format("thalweg_{}_{}", name, getpid());
    std::filesystem::remove_all(path_);
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!kept_) std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  bool kept_ = false;
};

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file) << text;
}

inline std::string contents_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// The folder a finished run leaves, made of a prescribed motion: a tank of water 0.1 m deep collapses over a bed 0.06
/// m thick (x from -0.5 m to 0.75 m, gate at 0), the surface being Ritter's parabola cut at a front of 0.8 m/s and the
/// bed scoured by a bump that travels behind it.
class SyntheticRun {
 public:
  static constexpr double bed_level = 0.06;   // [m]
  static constexpr double front_speed = 0.8;  // [m/s]
  static constexpr double spacing = 0.005;    // [m]

  explicit SyntheticRun(const std::filesystem::path& root) : run_{root}, case_folder_(root / "case") {}

  [[nodiscard]] const RunFolder& folder() const { return run_; }
  [[nodiscard]] const std::filesystem::path& case_folder() const { return case_folder_; }

  static double bed(double x, double t) {
    const double hole = x - 0.15;
    const double hump = x - 0.15 - 0.4 * t;
    return bed_level - 0.016 * std::min(1.0, 3 * t) * std::exp(-hole * hole / 0.01) +
           0.009 * std::min(1.0, 3 * t) * std::exp(-hump * hump / 0.006);
  }
  static double surface(double x, double t) {
    const double c = std::sqrt(9.81 * 0.1);
    double depth = x < 0 ? 0.1 : 0;
    if (t > 0) {
      const double ritter = std::max(0.0, 2 * c - x / t) * std::max(0.0, 2 * c - x / t) / (9 * 9.81);
      depth = x < -c * t ? 0.1 : x < front_speed * t ? std::max(0.012, ritter) : 0;
    }
    return depth > 0 ? std::max(bed_level + depth, bed(x, t) + 0.012) : bed(x, t);
  }
  static double moving_bed(double x, double t) {
    const double depth = surface(x, t) - bed(x, t);
    return bed(x, t) - (t > 0 && depth > 0 && x > -0.2 ? 0.012 : 0);
  }

  /// Writes case, snapshots (every 0.05 s to 0.5 s, from float positions as the solver's) and tables.
  void write() const {
    write_case_files();
    std::vector<SeriesEntry> series;
    for (int n = 0; n <= 10; ++n) {
      const double t = 0.05 * n;
      const std::filesystem::path file = fmt::format("snapshots/s{:05}.vtp", n);
      std::filesystem::create_directories((run_.root / file).parent_path());
      write_particles(run_.root / file, particles(t, n), PositionPrecision::single_precision);
      series.push_back({t, file});
    }
    write_series(run_.snapshot_series(), series);
    write_tables();
  }

  [[nodiscard]] ParticleSet particles(double t, int step) const {
    Flume flume;
    flume.spacing = spacing;
    flume.from = -0.5;
    flume.length = 1.25;
    flume.wall_height = 0.3;
    flume.jitter = 0.15;
    flume.begin();
    flume.add_walls();
    const auto height = [t](double (*curve)(double, double)) { return [t, curve](double x) { return curve(x, t); }; };
    flume.fill(
        ParticleType::sediment, -0.5, 0.75, [](double) { return 0; }, height(bed),
        [t](double x, double z) {
          return z < moving_bed(x, t) ? 0.F : static_cast<float>(0.02 + 20 * (z - moving_bed(x, t)));
        });
    flume.fill(ParticleType::water, -0.5, 0.75, height(bed), height(surface), [t](double x, double) {
      return t > 0 ? static_cast<float>(std::clamp(2.0 / 3 * (0.99 + x / t), 0.0, 1.2)) : 0.F;
    });
    ParticleSet set = flume.set;
    set.info.case_name = "synthetic";
    set.info.code_version = "0.1.0";
    set.info.case_hash = "0123abcd";
    set.info.time = t;
    set.info.step = std::int64_t{100} * step;
    return set;
  }

 private:
  void write_case_files() const {
    write_text(case_folder_ / "case.toml", R"(
[case]
name = "synthetic"
title = "Prescribed dam break over an erodible bed"
source = "Made for tests: Ritter's parabola over a travelling bump; no solver was involved"
dimension = 2
[domain]
from = ["-0.6 m", "-0.1 m"]
to = ["0.85 m", "0.5 m"]
[[shape]]
name = "flume"
kind = "box"
role = "wall"
side = "outside"
open = ["+z"]
from = ["-0.5 m", "0 m"]
to = ["0.75 m", "0.3 m"]
[[shape]]
name = "bed"
kind = "box"
role = "sediment"
from = ["-0.5 m", "0 m"]
to = ["0.75 m", "0.06 m"]
[[shape]]
name = "tank"
kind = "box"
role = "water"
from = ["-0.5 m", "0.06 m"]
to = ["0 m", "0.16 m"]
[materials.water]
density = "1000 kg/m^3"
[materials.pvc]
grain_density = "1540 kg/m^3"
porosity = 0.47
grain_diameter = "3.5 mm"
friction_angle = "38 deg"
[model]
sediment = "viscoplastic"
[numerics]
spacing = "5 mm"
[output]
end = "0.5 s"
interval = "0.05 s"
[compare]
times = ["0.25 s", "0.5 s"]
)");
    std::filesystem::create_directories(case_folder_ / "reference");
    write_case(run_.resolved_case(), read_case(case_folder_));
  }

  void write_tables() const {
    std::string history =
        "time [s],step [-],dt [s],dt_limiter,kinetic_energy [J],potential_energy [J],internal_energy [J],water_mass "
        "[kg],sediment_mass [kg],excluded [-],max_speed [m/s],viscous_iterations [-],viscous_residual [-]\n";
    for (int n = 0; n <= 50; ++n) {
      const double t = 0.01 * n;
      const double kinetic = 20 * t * t / (0.1 + t);
      history += fmt::format("{:g},{},{:g},{},{:g},{:g},{:g},50,96.5,0,1.1,12,0.001\n", t, 20 * n, 1e-4 - 1e-5 * t,
                             n % 4 == 0 ? "force" : "acoustic", kinetic, 120 - 1.3 * kinetic, 0.05 * kinetic);
    }
    write_text(run_.history(), history);
    write_text(run_.timing(),
               "heading,seconds [s],share [-],calls [-]\nneighbour list,3.1,0.155,120\nrates,9.4,0.47,1000\nimplicit "
               "viscosity,6.5,0.325,1000\nintegrate,1,0.05,1000\n");
    write_text(run_.summary(),
               "quantity,value,unit\nparticles,21640,-\nfluid_particles,19000,-\nsteps,1000,-\nphysical_time,0.5,s\n"
               "wall_seconds,20.05,s\nparticle_steps_per_second,1079301.7,1/s\nthreads,2,-\nbackend,openmp,-\n");
  }

  RunFolder run_;
  std::filesystem::path case_folder_;
};

}  // namespace thalweg::manufactured
