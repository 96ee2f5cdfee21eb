// Writes a run's particle files with made-up particles, so that what ParaView shows of our format can be checked
// without a simulation: write_sample FOLDER. A column of water above sediment slides to the right by 0.2 m/s inside
// three walls.
#include <cmath>
#include <filesystem>
#include <iostream>

#include "common/error.hpp"
#include "common/io/particle_file.hpp"
#include "common/io/series.hpp"
#include "common/run_folder.hpp"

namespace {

using thalweg::ParticleSet;
using thalweg::ParticleType;
using thalweg::SedimentState;

constexpr double spacing = 0.01;  // [m]
constexpr float speed = 0.2F;     // [m/s]

void add(ParticleSet& to, ParticleType type, double x, double z) {
  const bool fluid = type == ParticleType::water || type == ParticleType::sediment;
  const float density = type == ParticleType::sediment ? 1286.0F : 1000.0F;  // [kg/m^3]
  to.id.push_back(static_cast<std::int64_t>(to.id.size()));
  to.type.push_back(type);
  to.state.push_back(type == ParticleType::sediment ? SedimentState::deposit : SedimentState::none);
  to.position.emplace_back(x, 0.0, z);
  to.velocity.emplace_back(fluid ? speed : 0.0F, 0.0F, 0.0F);
  to.density.push_back(density);
  to.pressure.push_back(fluid ? 1000.0F * 9.81F * static_cast<float>(0.3 - z) : 0.0F);
  to.mass.push_back(density * static_cast<float>(spacing * spacing));
  to.viscosity.push_back(fluid ? 1e-3F : 0.0F);
  to.normal.emplace_back(0.0F, 0.0F, fluid ? 0.0F : 1.0F);
  to.scalars["ShieldsNumber"].push_back(type == ParticleType::sediment ? 0.05F : 0.0F);
}

ParticleSet particles_at(double time) {
  ParticleSet particles;
  particles.info = {.case_name = "sample",
                    .code_version = "0",
                    .case_hash = "0",
                    .dimension = 2,
                    .spacing = spacing,
                    .smoothing_length = 1.5 * spacing,
                    .time = time,
                    .step = std::lround(time * 1000)};
  for (int i = 0; i < 100; ++i) add(particles, ParticleType::wall, i * spacing, -spacing);
  for (int i = 0; i < 40; ++i) {
    for (int k = 0; k < 30; ++k) {
      const ParticleType type = k < 10 ? ParticleType::sediment : ParticleType::water;
      add(particles, type, i * spacing + speed * time, k * spacing);
    }
  }
  return particles;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw thalweg::InputError("write_sample: wrong number of arguments; give a folder");
  const thalweg::RunFolder run{argv[1]};
  std::filesystem::remove_all(run.root);
  thalweg::write_particles(run.particles(), particles_at(0), thalweg::PositionPrecision::double_precision);
  std::vector<thalweg::SeriesEntry> entries;
  for (const double time : {0.0, 0.05, 0.125, 0.2}) {  // unevenly, so that file numbers cannot pass for seconds
    const auto name = "s0000" + std::to_string(entries.size()) + ".vtp";
    thalweg::write_particles(run.snapshots() / name, particles_at(time), thalweg::PositionPrecision::single_precision);
    entries.push_back({time, std::filesystem::path("snapshots") / name});
    thalweg::write_series(run.snapshot_series(), entries);
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << "error: " << error.what() << '\n';
  return 1;
}
