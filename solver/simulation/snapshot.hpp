#pragma once

#include "common/particles.hpp"
#include "solver/models/seepage/mixture.hpp"
#include "solver/state/particles.hpp"

// What a snapshot shows of a particle. The device gathers it in one array, so that steps can go on while that one is
// brought to the host and made into a ParticleSet.
namespace thalweg {

inline constexpr const char* excess_pore_pressure_array = "ExcessPorePressure";

struct ShownParticle {
  double x[3];  // [m]
  std::int64_t id;
  float velocity[3];  // [m/s]
  float mass;         // [kg]
  float excess;       // rho/rho0 - 1 [-]; 0 of walls
  float pressure;     // [Pa]
  float viscosity;    // [Pa s]
  float phase;
  float state;
  float strain_rate;         // [1/s]
  float effective_pressure;  // [Pa]
  float yield_stress;        // [Pa]
  float bed_shear_stress;    // [Pa]
  float pore_pressure;       // excess [Pa]
  float porosity;            // of a mixture [-]
  std::uint16_t motion;
  std::uint8_t type;
};

/// Gathers; arrays that the scene does not have are null.
struct Show {
  const Record* records;
  const Position* positions;
  const std::int64_t* id;
  const float* mass;
  const std::uint8_t* type;
  const Sediment* sediment;
  const BedSurface* bed;
  const float* pore_pressure;
  const PoreState* pores;
  const Index* motion;
  Index fluid;

  HOST_DEVICE ShownParticle operator()(Index i) const {
    ShownParticle s{};
    const Record& r = records[i];
    for (int c = 0; c < 3; ++c) s.x[c] = positions[i].x[c], s.velocity[c] = r.velocity[c];
    s.id = id[i];
    s.mass = mass[i];
    s.type = type[i];
    s.excess = r.phase == phase_wall ? 0 : r.excess;
    s.pressure = r.pressure;
    s.viscosity = r.viscosity;
    s.phase = r.phase;
    s.state = r.state;
    if (sediment != nullptr) {
      s.strain_rate = sediment[i].strain_rate;
      s.effective_pressure = sediment[i].effective_pressure;
      s.yield_stress = sediment[i].yield_stress;
    }
    if (bed != nullptr) s.bed_shear_stress = bed[i].shear_stress;
    if (pore_pressure != nullptr) s.pore_pressure = pore_pressure[i];
    s.porosity = pores != nullptr && i < fluid ? pores[i].porosity : 1;
    if (motion != nullptr) s.motion = static_cast<std::uint16_t>(motion[i]);
    return s;
  }
};

/// A box, for the device; its sides may be infinite [m].
struct ShownRegion {
  double from[3];
  double to[3];

  [[nodiscard]] HOST_DEVICE bool contains(const Position& at) const {
    for (int c = 0; c < 3; ++c) {
      if (!(at.x[c] >= from[c] && at.x[c] <= to[c])) return false;
    }
    return true;
  }
};

/// Particle pass: gathers the particles named in `of`, or all.
struct ShowPass {
  Show show;
  const Index* of;  // nullptr: 0, 1, 2 …
  ShownParticle* shown;

  HOST_DEVICE void operator()(Index n) const { shown[n] = show(of == nullptr ? n : of[n]); }
};

/// Whether a particle lies within any of the regions.
struct WithinRegions {
  const Position* positions;
  const ShownRegion* regions;
  std::size_t number;

  HOST_DEVICE bool operator()(Index i) const {
    bool within = false;
    for (std::size_t k = 0; k < number; ++k) within = within || regions[k].contains(positions[i]);
    return within;
  }
};

/// The particles as files hold them; without ParticleSet::info. `shown` is any array of ShownParticle.
template <int Dim, class Shown>
ParticleSet particle_set(const Scene<Dim>& scene, const Shown& shown) {
  const std::size_t n = shown.size();
  ParticleSet out;
  out.id.resize(n);
  out.mass.resize(n);
  out.type.resize(n);
  out.position.resize(n);
  out.velocity.resize(n);
  out.density.resize(n);
  out.pressure.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const ShownParticle& s = shown[i];
    out.id[i] = s.id;
    out.mass[i] = s.mass;
    out.type[i] = static_cast<ParticleType>(s.type);
    out.position[i] = Vec3(s.x[0], s.x[1], s.x[2]);
    out.velocity[i] = Eigen::Vector3f(s.velocity[0], s.velocity[1], s.velocity[2]);
    out.density[i] = scene.density_in_files(s.phase) * (1 + s.excess);
    out.pressure[i] = s.pressure;
  }
  const auto scalar = [&](const char* name, const auto& of) {
    auto& values = out.scalars[name];
    values.resize(n);
    for (std::size_t i = 0; i < n; ++i) values[i] = of(shown[i]);
  };
  if (scene.seepage.mixture) scalar("Porosity", [](const ShownParticle& s) { return s.porosity; });
  if (scene.has_moving_walls) {
    scalar(motion_array, [](const ShownParticle& s) { return static_cast<float>(s.motion); });
  }
  if (scene.seepage.pore_pressure) {
    scalar(excess_pore_pressure_array, [](const ShownParticle& s) { return s.pore_pressure; });
  }
  if (!scene.has_sediment) return out;
  out.viscosity.assign(n, scene.water_viscosity);
  for (std::size_t i = 0; i < n; ++i) {
    if (shown[i].phase == phase_sediment) out.viscosity[i] = shown[i].viscosity;
  }
  scalar("StrainRate", [](const ShownParticle& s) { return s.strain_rate; });
  scalar("EffectivePressure", [](const ShownParticle& s) { return s.effective_pressure; });
  scalar("YieldStress", [](const ShownParticle& s) { return s.yield_stress; });
  if (scene.may_rest) {
    scalar("Resting", [](const ShownParticle& s) { return s.state == state_resting ? 1.0F : 0.0F; });
  }
  if (!scene.has_states) return out;
  const float grain_weight = scene.erosion.grain_weight;
  scalar("ShieldsNumber", [=](const ShownParticle& s) { return shields_number(s.bed_shear_stress, grain_weight); });
  out.state.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    const float state = shown[i].state == state_resting ? state_deposit : shown[i].state;
    out.state[i] = static_cast<SedimentState>(static_cast<int>(state));
  }
  return out;
}

}  // namespace thalweg
