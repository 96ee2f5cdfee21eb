#pragma once

#include "physics/seepage/skeleton.hpp"
#include "physics/water/equation_of_state.hpp"
#include "solver/backend/device.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"

namespace thalweg {

/// Energy of compression per mass [J/kg].
template <int Dim>
HOST_DEVICE inline double compression_energy(const Record& r, const Scene<Dim>& scene) {
  if (scene.seepage.mixture && is_sediment(r)) {
    return skeleton_energy(r.excess, scene.seepage.skeleton_stiffness, scene.seepage.solids_at_rest,
                           scene.sediment_density);
  }
  return tait_energy(r.excess, scene.sound_speed);
}

template <int Dim, class Device>
Totals sum_totals(Device& on, const Particles<Device>& p, const Scene<Dim>& scene) {
  const Record* records = p.record.data();
  const Position* positions = p.position.data();
  const float* inertia = p.inertia();
  return on.reduce(
      p.fluid(), Totals{},
      declare<Reads<field::place, field::flow, field::matter, field::position, field::mass, field::loaded_mass>,
              Writes<>>([=] HOST_DEVICE(Index i) {
        Totals t;
        const Record& r = records[i];
        if (r.volume == 0) return t;
        const double m = inertia[i];
        double u2 = 0;
        for (int c = 0; c < 3; ++c) {
          u2 += double(r.velocity[c]) * double(r.velocity[c]);
          t.momentum[c] = m * double(r.velocity[c]);
        }
        t.kinetic_energy = 0.5 * m * u2;
        for (int k = 0; k < Dim; ++k) {
          t.potential_energy -= m * double(scene.gravity[k]) * positions[i].x[axis<Dim>(k)];
        }
        if (!is_resting(r)) t.internal_energy = m * compression_energy(r, scene);
        (is_sediment(r) ? t.sediment_mass : t.water_mass) = m;
        t.sediment = is_sediment(r) ? 1 : 0;
        t.resting = is_resting(r) ? 1 : 0;
        t.bed_load = r.kind == kind::bed_load ? 1 : 0;
        t.suspended = r.kind == kind::suspended ? 1 : 0;
        return t;
      }),
      [] HOST_DEVICE(Totals a, const Totals& b) { return a += b; });
}

}  // namespace thalweg
