#pragma once

#include "solver/passes/pressure.hpp"

namespace thalweg {

/// Pair sweep over sediment at rest: its pressure like a wall's, and the density of that pressure, so that a particle
/// which wakes goes on with the pressure its neighbours have felt.
template <int Dim>
struct RestingPressureSweep : ExtrapolatedPressureSweep<Dim> {
  using reads = Reads<field::matter, field::mass>;
  using writes = Writes<field::place, field::flow, field::matter>;
  template <class L>
  using Sum = typename ExtrapolatedPressureSweep<Dim>::template Sum<L>;
  Record* records;
  const float* mass;

  HOST_DEVICE void end(Index i, const Sum<float>& sum) const {
    Record& r = records[i];
    if (!is_resting(r) || !(sum.weight > 0)) return;
    r.pressure = this->pressure(sum);
    r.excess = tait_excess(r.pressure, this->scene.stiffness(r.kind));
    r.volume = mass[i] / (this->scene.density_at_rest(r.kind) * (1 + r.excess));
  }
};

template <int Dim, class Device>
void extrapolate_to_resting(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  for (const ClusterRange range : {p.rest_front(), p.part_resting()}) {
    sweep(on, p, scene, range, RestingPressureSweep<Dim>{{scene}, p.record.data(), p.mass.data()});
  }
}

}  // namespace thalweg
