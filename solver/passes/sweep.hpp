#pragma once

#include "solver/backend/members.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"

namespace thalweg {

/// Runs a pair sweep over the clusters of a range (backend/openmp.hpp says what a body is).
template <int Dim, class Device, class Body>
void sweep(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, ClusterRange range, const Body& body) {
  require_sweep_body<Body, Dim>();
  if constexpr (SweepBody<Body, Dim>) {  // one message for a body that lacks something
    on.template sweep<Dim>(p.list(), range, p.record.data(), scene.metric(), body);
  }
}

}  // namespace thalweg
