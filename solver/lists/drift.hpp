#pragma once

#include <cmath>

#include "solver/backend/device.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"
#include "solver/state/step_state.hpp"

// The life of the neighbour lists: they serve until some particle has moved by half the skin.
namespace thalweg {

namespace neighbours {

/// True if a particle has left the domain since the lists were made. Those that died on purpose do not count.
template <class Device>
bool has_excluded(Device& on, const Particles<Device>& p) {
  const Record* records = p.record.data();
  const Role* roles = p.roles();
  return on.reduce(p.fluid_count, false, declare<Reads<field::place, field::role>, Writes<>>([=] HOST_DEVICE(Index i) {
                     return records[i].volume == 0 && (roles == nullptr || roles[i] != Role::dormant);
                   }),
                   [] HOST_DEVICE(bool a, bool b) { return a || b; });
}

/// Squared distance from the place the lists were made for [m^2]; infinite for an excluded particle.
template <int Dim>
struct SquaredDrift {
  using reads = Reads<field::place, field::listed_at, field::role>;
  using writes = Writes<>;

  const Record* records;
  const Place* listed;
  const Role* roles;
  Vec<Dim, float> quantum;
  Index fluid;

  HOST_DEVICE float operator()(Index i) const {
    if (records[i].volume == 0 && i < fluid) {
      return roles != nullptr && roles[i] == Role::dormant ? 0 : INFINITY;
    }
    float d2 = 0;
    for (int k = 0; k < Dim; ++k) {
      const int c = axis<Dim>(k);
      const float d = static_cast<float>(Lattice<Dim>::difference(records[i].place[c], listed[i].c[c])) * quantum[k];
      d2 += d * d;
    }
    return d2;
  }
};

/// Finds the largest squared drift among the particles [0, movable).
template <int Dim, class Device>
void find_squared_drift(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, Index movable,
                        StepState* state) {
  on.reduce_then(
      movable, 0.0F,
      SquaredDrift<Dim>{p.record.data(), p.listed_at.data(), p.roles(), scene.lattice.quantum, p.fluid_count},
      [] HOST_DEVICE(float a, float b) { return a > b ? a : b; },
      [=] HOST_DEVICE(float found) { state->squared_drift = found; });
}

}  // namespace neighbours

/// True once a particle has moved half the skin [m^2].
template <int Dim>
bool must_rebuild_lists(const Scene<Dim>& scene, float squared_drift) {
  const auto slack = static_cast<float>((scene.list_reach - 2 * scene.smoothing_length) / 2);
  return !(squared_drift < slack * slack);
}

}  // namespace thalweg
