#pragma once

#include "solver/models/suspended_load/bed_change.hpp"
#include "solver/state/report.hpp"

namespace thalweg {

/// Adds the masses of grains to the sums over the fluid, where the water carries some.
template <int Dim, class Device>
void add_grain_sums(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, Totals& totals) {
  if (!scene.suspended_load.on) return;
  const Record* records = p.record.data();
  const float* mass = p.mass.data();
  const double* grains = p.grains.data();
  const auto density = double(scene.erosion.grain_density);
  totals += on.reduce(
      p.fluid(), Totals{},
      declare<Reads<field::place, field::matter, field::mass, field::grains>, Writes<>>([=] HOST_DEVICE(Index i) {
        Totals t;
        const Record& r = records[i];
        if (r.volume == 0) return t;
        if (is_sediment(r)) {
          t.grain_mass = density * (grains[i] + packed_grains(scene, r, mass[i]));
        } else {
          t.grain_mass = t.suspended_mass = density * grains[i];
        }
        return t;
      }),
      [] HOST_DEVICE(Totals a, const Totals& b) { return a += b; });
}

}  // namespace thalweg
