#pragma once

#include <vector>

#include "solver/backend/device.hpp"
#include "solver/models/moving_walls/arrays.hpp"
#include "solver/models/moving_walls/wall_motion.hpp"
#include "solver/state/scene.hpp"
#include "solver/state/step_state.hpp"

// Walls that move as the case prescribes. Fluid velocities stand half a step before and after its places (leapfrog,
// passes/integrate.hpp), and so do the walls': while the fluid moves, a wall has the mean velocity of the step, so that
// the way it goes is what the continuity equation sees of it, to rounding, also across a kink of its motion.
namespace thalweg {

/// Particle pass over the walls of one motion: place, velocity and acceleration (kept in their rates, for the wall
/// pressure). Where the domain ends, a wall particle is parked: it has no volume, and is out of every sum, until it
/// comes back.
template <int Dim>
struct MoveWallPass {
  using reads = Reads<field::motion, field::moved_from>;
  using writes = Writes<field::place, field::flow, field::position, field::rates>;

  Record* records;
  Position* positions;
  Rates* rates;
  const Position* moved_from;
  const Index* motion;
  Index number;  // of this motion
  RigidAxis axis;
  RigidState state;
  Scene<Dim> scene;
  float volume;  // of a wall particle [m^dim]
  Index first;   // wall particle

  HOST_DEVICE void operator()(Index n) const {
    const Index i = first + n;
    if (motion[i] != number) return;
    Record& r = records[i];
    double* x = positions[i].x;
    double u[3];
    double a[3];
    moved_point(axis, state.place, moved_from[i].x, x);
    rigid_velocity(axis, state.rate, x, u);
    rigid_acceleration(axis, state, x, a);
    bool inside = true;
    for (int k = 0; k < Dim; ++k) {
      const int c = thalweg::axis<Dim>(k);
      double at = x[c];
      if (!scene.lattice.periodic[k]) {
        at = at < scene.domain_from[k] ? scene.domain_from[k] : at > scene.domain_to[k] ? scene.domain_to[k] : at;
        inside = inside && at == x[c];
      }
      r.place[c] = scene.lattice.place(k, at);
    }
    r.volume = inside ? volume : 0;
    for (int c = 0; c < 3; ++c) {
      r.velocity[c] = static_cast<float>(u[c]);
      rates[i].acceleration[c] = static_cast<float>(a[c]);
    }
  }
};

/// Walls whose surface alone moves: they keep their places, and push nothing ahead when they speed up.
inline RigidState surface_of(const RigidState& state) { return {0, state.rate, 0}; }

/// state_of(motion) is the state [RigidState] in which its walls are put.
template <int Dim, class Device, class StateOf>
void put_walls(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const std::vector<WallMotion>& motions,
               const StateOf& state_of) {
  float volume = 1;
  for (int k = 0; k < Dim; ++k) volume *= static_cast<float>(scene.spacing);
  for (std::size_t m = 0; m < motions.size(); ++m) {
    const RigidState state = motions[m].stays ? surface_of(state_of(motions[m])) : state_of(motions[m]);
    on.for_each(
        p.count - p.fluid_count,
        MoveWallPass<Dim>{p.record.data(), p.position.data(), p.rates.data(), p.moved_from.data(), p.motion.data(),
                          static_cast<Index>(m + 1), motions[m].axis, state, scene, volume, p.fluid_count});
  }
}

/// Walls as they are at the time t [s]. True if some of them move.
template <int Dim, class Device>
bool hold_walls(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const std::vector<WallMotion>& motions,
                double t) {
  bool moving = false;
  put_walls(on, p, scene, motions, [&](const WallMotion& motion) {
    const RigidState state = motion.at(t);
    moving = moving || state.rate != 0;
    return state;
  });
  return moving;
}

/// Walls that have gone a `share` [-] of their way in the step from t to t + dt [s], with its mean velocity.
template <int Dim, class Device>
void move_walls(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const std::vector<WallMotion>& motions,
                double t, double dt, double share) {
  put_walls(on, p, scene, motions, [&](const WallMotion& motion) {
    const double from = motion.at(t).place;
    const double way = motion.at(t + dt).place - from;
    return RigidState{from + share * way, way / dt, 0};
  });
}

/// Squares of the largest speed and acceleration of walls that move.
template <class Device>
void find_wall_extremes(Device& on, const Particles<Device>& p, StepState* state) {
  const Record* records = p.record.data() + p.fluid_count;
  const Rates* rates = p.rates.data() + p.fluid_count;
  on.reduce_then(
      p.count - p.fluid_count, Extremes{},
      declare<Reads<field::place, field::flow, field::rates>, Writes<>>([=] HOST_DEVICE(Index i) {
        Extremes e;
        if (records[i].volume == 0) return e;
        for (int c = 0; c < 3; ++c) {
          e.speed2 += records[i].velocity[c] * records[i].velocity[c];
          e.acceleration2 += rates[i].acceleration[c] * rates[i].acceleration[c];
        }
        return e;
      }),
      [] HOST_DEVICE(Extremes a, const Extremes& b) {
        a.speed2 = a.speed2 > b.speed2 ? a.speed2 : b.speed2;
        a.acceleration2 = a.acceleration2 > b.acceleration2 ? a.acceleration2 : b.acceleration2;
        return a;
      },
      [=] HOST_DEVICE(const Extremes& found) { state->walls = found; });
}

}  // namespace thalweg
