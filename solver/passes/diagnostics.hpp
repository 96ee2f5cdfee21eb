#pragma once

#include "physics/water/equation_of_state.hpp"
#include "solver/models/seepage/mixture.hpp"

namespace thalweg {

/// Sums over the fluid; 2-D: per metre of width.
struct Totals {
  double kinetic_energy = 0;       // [J]
  double potential_energy = 0;     // [J] from z = 0, along gravity
  double internal_energy = 0;      // [J] of compression; not of sediment at rest, whose pressure does no work on it
  double water_mass = 0;           // [kg]
  double sediment_mass = 0;        // [kg]
  double momentum[3] = {0, 0, 0};  // [kg m/s]
  // Sediment particles: of all, at rest, and in the states they may have.
  std::int64_t sediment = 0;
  std::int64_t resting = 0;
  std::int64_t bed_load = 0;
  std::int64_t suspended = 0;

  HOST_DEVICE Totals& operator+=(const Totals& b) {
    kinetic_energy += b.kinetic_energy;
    potential_energy += b.potential_energy;
    internal_energy += b.internal_energy;
    water_mass += b.water_mass;
    sediment_mass += b.sediment_mass;
    for (int c = 0; c < 3; ++c) momentum[c] += b.momentum[c];
    sediment += b.sediment;
    resting += b.resting;
    bed_load += b.bed_load;
    suspended += b.suspended;
    return *this;
  }
};

template <int Dim, class Device>
Totals sum_totals(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) {
  const Record* records = p.record.data();
  const Position* positions = p.position.data();
  const float* mass = p.mass.data();
  return on.reduce(
      p.fluid_count, Totals{},
      [=] HOST_DEVICE(Index i) {
        Totals t;
        const Record& r = records[i];
        if (r.volume == 0) return t;
        const double m = mass[i];
        double u2 = 0;
        for (int c = 0; c < 3; ++c) {
          u2 += double(r.velocity[c]) * double(r.velocity[c]);
          t.momentum[c] = m * double(r.velocity[c]);
        }
        t.kinetic_energy = 0.5 * m * u2;
        for (int k = 0; k < Dim; ++k) t.potential_energy -= m * double(scene.gravity[k]) * positions[i].x[axis<Dim>(k)];
        const bool is_skeleton = scene.seepage.mixture && r.phase == phase_sediment;
        if (!is_resting(r))
          t.internal_energy =
              m * (is_skeleton ? mixture::skeleton_energy(r.excess, scene) : tait_energy(r.excess, scene.sound_speed));
        (r.phase == phase_sediment ? t.sediment_mass : t.water_mass) = m;
        t.sediment = r.phase == phase_sediment ? 1 : 0;
        t.resting = is_resting(r) ? 1 : 0;
        t.bed_load = r.state == state_bed_load ? 1 : 0;
        t.suspended = r.state == state_suspended ? 1 : 0;
        return t;
      },
      [] HOST_DEVICE(Totals a, const Totals& b) { return a += b; });
}

}  // namespace thalweg
