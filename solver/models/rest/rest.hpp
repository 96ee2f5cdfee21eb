#pragma once

#include "solver/lists/selection.hpp"
#include "solver/models/bed/arrays.hpp"
#include "solver/models/implicit/viscous_system.hpp"
#include "solver/models/rest/arrays.hpp"
#include "solver/models/rest/resting_pressure.hpp"
#include "solver/models/rest/scene.hpp"
#include "solver/state/step_state.hpp"

// Deposits that rest. Sediment which has been below yield and slow for a while, with nothing moving in reach and
// something that holds it, stops exactly: it is a wall to its neighbours, leaves the viscous solve and costs next to
// nothing. It wakes where the neighbours shear it close to yield, where the bed above has become steeper than it can
// stand, or where the water's shear stress moves its grains (models/states/bed_states.hpp). A Papanastasiou fluid alone would
// creep for ever: 2 mm/s on a slope 5 deg below repose, 5 cm thick, at m = 100 s.
//
// Stopping and waking are continuous: a particle stops only when it is slow, and wakes at zero velocity, with the
// pressure that its neighbours have felt from it.
//
// Both happen where the neighbour lists are made anew, and most_steps after the last change at the latest. In between no
// particle has moved by more than half the skin. A step's launches on a GPU are then often those of the step before; they
// differed in three steps of four when each step woke and stopped for itself (bench/notes/cuda-kernels.md).
namespace thalweg {

namespace rest {

/// True for a wall that moves: nothing beside it may rest.
HOST_DEVICE inline bool is_moving_wall(const Record& r) {
  const bool stands = r.velocity[0] == 0 && r.velocity[1] == 0 && r.velocity[2] == 0;
  return is_wall(r) && r.volume != 0 && !stands;
}

/// True if b lies within the support of a. A cluster's list is that of four particles, which may lie apart.
template <int Dim>
HOST_DEVICE inline bool in_reach(const Scene<Dim>& scene, const Record& a, const Record& b) {
  const Vec<Dim, float> r = scene.separation(a.place, b.place);
  return dot(r, r) < scene.support() * scene.support();
}

/// Steps after which particles that are due to stop or to wake no longer wait for new lists. Waking spreads by a support
/// each time, 2h in 16 steps of about 0.3 h/c: at four tenths of the speed of sound.
inline constexpr std::int64_t most_steps = 16;

/// Wakes a particle at rest.
HOST_DEVICE inline void wake(Record& r, Sediment& s) {
  r.kind = kind::deposit;
  s.time_below_yield = 0;
  for (float& a : s.viscous_acceleration) a = 0;
}

/// Notes that a particle at rest is due to wake. One that rests has been calm for a while.
HOST_DEVICE inline void ask_to_wake(Sediment& s) { s.time_below_yield = 0; }
HOST_DEVICE inline bool is_due_to_wake(const Record& r, const Sediment& s) {
  return is_resting(r) && s.time_below_yield == 0;
}

/// Particle pass: the time a particle has been calm, and who is due to wake; returns how many wait to stop or to wake.
struct CalmPass {
  using reads = Reads<field::flow, field::matter, field::sediment>;
  using writes = Writes<field::sediment>;

  const Record* records;
  Sediment* sediment;
  RestCriteria criteria;
  float repose_tangent;
  bool bed_load_drifts;  // the velocity of bed load is that of its skeleton, which may be calm
  const StepState* state;

  HOST_DEVICE Index operator()(Index i) const {
    const Record& r = records[i];
    if (!is_sediment(r)) return 0;
    Sediment& s = sediment[i];
    const bool steep = s.bed_slope > repose_tangent;
    if (is_resting(r)) {
      if (steep || s.strain_rate >= criteria.wake_shear_rate) ask_to_wake(s);
      return is_due_to_wake(r, s) ? 1 : 0;
    }
    float u2 = 0;
    for (const float u : r.velocity) u2 += u * u;
    const bool calm = !steep && s.strain_rate < criteria.shear_rate && u2 < criteria.speed * criteria.speed &&
                      (r.kind == kind::deposit || (bed_load_drifts && r.kind == kind::bed_load));
    s.time_below_yield = calm ? s.time_below_yield + static_cast<float>(state->step.dt) : 0;
    return r.kind == kind::deposit && s.time_below_yield >= criteria.time ? 1 : 0;
  }
};

/// True if a calm particle may stop: all sediment in the reach of its cluster is calm or rests, and there is a wall or
/// something at rest that holds it.
template <int Dim>
struct MayStop {
  using neighbours = Neighbours<field::place, field::flow, field::matter, field::sediment>;
  using reads = Reads<field::place, field::matter, field::sediment>;
  using writes = Writes<>;

  const Record* records;
  const Sediment* sediment;
  ClusterList list;
  Scene<Dim> scene;

  HOST_DEVICE bool operator()(Index i) const {
    const float time = scene.rest.time;
    if (records[i].kind != kind::deposit || sediment[i].time_below_yield < time) return false;
    const Index cluster = list.cluster_of(i);
    bool held = false;
    for (Index e = list.begin[cluster]; e < list.begin[cluster + 1]; ++e) {
      const Index j = list.entries[e];
      if (j == list.none || !in_reach(scene, records[i], records[j])) continue;
      const Record& b = records[j];
      if (is_moving_wall(b)) return false;
      if (is_wall(b) || is_resting(b)) {
        held = true;
      } else if (is_sediment(b) && sediment[j].time_below_yield < time) {
        return false;
      }
    }
    return held;
  }
};

}  // namespace rest

namespace rest {

/// Looks into clusters for what rests and what is active.
struct ClusterActivity {
  const Record* records;
  ClusterList list;

  [[nodiscard]] HOST_DEVICE Index resting_members(Index c) const {
    Index n = 0;
    for (Index i = list.first(c); i < list.last(c); ++i) n += is_resting(records[i]) ? 1 : 0;
    return n;
  }
  [[nodiscard]] HOST_DEVICE bool all_rest(Index c) const { return resting_members(c) == list.last(c) - list.first(c); }
  [[nodiscard]] HOST_DEVICE bool active_in_reach(Index c) const {
    for (Index e = list.begin[c]; e < list.begin[c + 1]; ++e) {
      const Record& b = records[list.entries[e]];
      if ((!is_wall(b) && !is_resting(b)) || is_moving_wall(b)) return true;
    }
    return false;
  }
};

}  // namespace rest

/// Makes the lists of clusters that have to be computed after sediment has stopped or woken, or the neighbour lists are
/// new.
template <class Device>
void list_active_clusters(Device& on, Particles<Device>& p) {
  const rest::ClusterActivity of{p.record.data(), p.list()};
  const ClusterRange sediment = p.range(p.clusters_with_sediment);
  const ClusterRange walls = p.range(p.clusters_of_walls);
  using OfMembers = Reads<field::matter>;
  using OfOthers = Neighbours<field::place, field::flow, field::matter>;
  Selection<Device> selection(on);
  selection.choose(sediment, declare<OfMembers, Writes<>>([=] HOST_DEVICE(Index c) {
                     return of.resting_members(c) > 0 && !of.all_rest(c);
                   }),
                   p.clusters_part_resting);
  selection.choose(sediment, declare<OfMembers, Writes<>>([=] HOST_DEVICE(Index c) { return !of.all_rest(c); }),
                   p.clusters_active);
  selection.choose(sediment, declare<OfOthers, OfMembers, Writes<>>([=] HOST_DEVICE(Index c) {
                     return of.all_rest(c) && of.active_in_reach(c);
                   }),
                   p.clusters_rest_front);
  selection.choose(walls,
                   declare<OfOthers, OfMembers, Writes<>>([=] HOST_DEVICE(Index c) { return of.active_in_reach(c); }),
                   p.clusters_of_walls_active);
  selection.finish();
  p.any_resting =
      on.any(p.clusters_active.size() < p.clusters_with_sediment.size() || p.clusters_part_resting.size() > 0);
}

/// Wakes the sediment in reach of walls that move, and counts it.
template <int Dim, class Device>
void wake_beside_moving_walls(Device& on, Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  const ClusterList list = p.list();
  for (const ClusterRange range : {p.rest_front(), p.part_resting()}) {
    on.reduce_then(
        range.count, Index{0},
        declare<Neighbours<field::place, field::flow, field::matter>, Reads<field::matter, field::sediment>,
                Writes<field::matter, field::sediment>>([=] HOST_DEVICE(Index n) {
          const Index c = range[n];
          Index woken = 0;
          for (Index i = list.first(c); i < list.last(c); ++i) {
            if (!is_resting(records[i])) continue;
            for (Index e = list.begin[c]; e < list.begin[c + 1] && is_resting(records[i]); ++e) {
              const Record& b = records[list.entries[e]];
              if (!rest::is_moving_wall(b) || !rest::in_reach(scene, records[i], b)) continue;
              rest::wake(records[i], sediment[i]);
              ++woken;
            }
          }
          return woken;
        }),
        [] HOST_DEVICE(Index a, Index b) { return a + b; }, [=] HOST_DEVICE(Index woken) { state->woken += woken; });
  }
}

/// Finds after a step who is due to wake and for how long the others have been calm.
template <int Dim, class Device>
void find_calm(Device& on, Particles<Device>& p, const Scene<Dim>& scene, StepState* state) {
  on.reduce_then(
      p.fluid_count, Index{0},
      rest::CalmPass{p.record.data(), p.sediment.data(), scene.rest, scene.sediment.yield_coefficient,
                     scene.bed_load.on, state},
      [] HOST_DEVICE(Index a, Index b) { return a + b; }, [=] HOST_DEVICE(Index waiting) { state->waiting = waiting; });
}

/// Wakes who is due to wake and stops who may stop, and counts both; where there are any, list_active_clusters has to
/// follow. The host waits.
template <int Dim, class Device>
Index wake_and_stop(Device& on, Particles<Device>& p, const Scene<Dim>& scene) {
  Record* records = p.record.data();
  Sediment* sediment = p.sediment.data();
  const auto sum = [] HOST_DEVICE(Index a, Index b) { return a + b; };
  const Index woken = on.reduce(
      p.fluid_count, Index{0},
      declare<Reads<field::matter, field::sediment>, Writes<field::matter, field::sediment>>([=] HOST_DEVICE(Index i) {
        if (!rest::is_due_to_wake(records[i], sediment[i])) return Index{0};
        rest::wake(records[i], sediment[i]);
        return Index{1};
      }),
      sum);

  p.stopping.resize(p.fluid_count);
  std::uint8_t* stopping = p.stopping.data();
  const rest::MayStop<Dim> may_stop{records, sediment, p.list(), scene};
  on.for_each(
      p.fluid_count,
      declare<typename rest::MayStop<Dim>::neighbours, typename rest::MayStop<Dim>::reads, Writes<field::stopping>>(
          [=] HOST_DEVICE(Index i) { stopping[i] = may_stop(i) ? 1 : 0; }));
  Rates* rates = p.rates.data();
  // A particle that stops has the pressure and volume of its last density: the equation of state leaves it alone.
  const EquationOfStatePass<Dim> take_state{records, p.mass.data(), rates, p.dissipations(), scene};
  const Index stopped = on.reduce(
      p.fluid_count, Index{0},
      declare<Reads<field::place, field::matter, field::mass, field::rates, field::dissipation, field::stopping>,
              Writes<field::place, field::flow, field::matter, field::viscous_vector, field::rates, field::sediment>>(
          [=] HOST_DEVICE(Index i) {
            if (stopping[i] == 0) return Index{0};
            take_state(i);
            records[i].kind = kind::resting;
            for (int c = 0; c < 3; ++c) {
              records[i].velocity[c] = records[i].work[c] = sediment[i].viscous_acceleration[c] = 0;
            }
            rates[i] = {};
            sediment[i].strain_rate = 0;
            return Index{1};
          }),
      sum);
  return woken + stopped;
}

}  // namespace thalweg
