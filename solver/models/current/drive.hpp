#pragma once

#include "common/error.hpp"
#include "common/particles.hpp"
#include "physics/water/current_control.hpp"
#include "solver/backend/device.hpp"
#include "solver/models/current/scene.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"
#include "solver/state/step_state.hpp"

// The drive of a periodic flume: a uniform acceleration of the water along the flow. It enters no hydrostatic term:
// walls, density diffusion and bed know Scene::gravity alone. Sediment does not feel it: its weight's part along a slope
// of some thousandths is nothing beside its friction.
namespace thalweg {

/// Particle pass: the drive's acceleration.
struct DrivePass {
  using reads = Reads<field::matter, field::rates>;
  using writes = Writes<field::rates>;

  const Record* records;
  Rates* rates;
  const CurrentControl* control;
  int component;

  HOST_DEVICE void operator()(Index i) const {
    if (is_water(records[i])) rates[i].acceleration[component] += static_cast<float>(control->acceleration);
  }
};

/// Momentum of the water along the flow, and its mass.
struct WaterMotion {
  double momentum = 0;  // [kg m/s]
  double mass = 0;      // [kg]

  HOST_DEVICE WaterMotion& operator+=(const WaterMotion& other) {
    momentum += other.momentum;
    mass += other.mass;
    return *this;
  }
};

/// Particle pass: a particle's part of it.
struct WaterMotionPass {
  using reads = Reads<field::place, field::flow, field::matter, field::mass>;
  using writes = Writes<>;

  const Record* records;
  const float* mass;
  int component;

  HOST_DEVICE WaterMotion operator()(Index i) const {
    if (!is_water(records[i]) || records[i].volume == 0) return {};
    return {double(mass[i]) * double(records[i].velocity[component]), double(mass[i])};
  }
};

/// Adapts the drive to the bulk velocity at the end of a step.
template <int Dim, class Device>
void control_current(Device& on, const Particles<Device>& p, const Scene<Dim>& scene, const StepState* state,
                     CurrentControl* control) {
  on.reduce_then(
      p.fluid(), WaterMotion{}, WaterMotionPass{p.record.data(), p.mass.data(), scene.current.component},
      [] HOST_DEVICE(WaterMotion a, const WaterMotion& b) { return a += b; },
      [=] HOST_DEVICE(const WaterMotion& sum) {
        if (sum.mass > 0) *control = after_step(*control, sum.momentum / sum.mass, state->step.dt);
      });
}

/// Name of the control's numbers in a checkpoint (ParticleSet::facts).
inline constexpr const char* current_fact = "CurrentControl";

/// The control of a checkpoint, or that of a run that begins. Throws InputError for a checkpoint without it.
inline CurrentControl control_of(const ParticleSet& from, const CurrentDrive& drive) {
  const auto known = from.facts.find(current_fact);
  if (known == from.facts.end()) return drive.start;
  const std::vector<double>& n = known->second;
  if (n.size() != 5) {
    throw InputError("the checkpoint's field data " + std::string(current_fact) + " has " + std::to_string(n.size()) +
                     " numbers and needs 5; start from a whole checkpoint");
  }
  return {n[0], n[1], n[2], n[3], n[4]};
}

inline void add_control(const CurrentControl& control, ParticleSet& to) {
  to.facts[current_fact] = {control.target, control.time, control.velocity, control.drag, control.acceleration};
}

}  // namespace thalweg
