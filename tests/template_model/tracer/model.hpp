#pragma once

#include "solver/backend/device.hpp"
#include "solver/state/arrays.hpp"
#include "solver/state/particles.hpp"
#include "solver/state/scene.hpp"
#include "solver/state/step_state.hpp"
#include "tests/template_model/tracer/table.hpp"

// The template of a model: copy this folder to solver/models/NAME, rename, and add a line to solver/models/list.hpp
// (ARCHITECTURE.md, "Where to add a model"). The tracer counts the time for which particles move and changes nothing.
namespace thalweg {

namespace field {
inline constexpr Field tracer{"Tracer"};
}

/// Constants of the model; Scene has these members.
template <int Dim>
struct TracerScene {
  bool has_tracer = false;
  float tracer_start = 0;  // [s]
};

/// Arrays of the model; Particles has these members. Empty where the model is off.
template <class Device>
struct TracerArrays {
  typename Device::template Buffer<float> tracer;  // [s]

  template <class Scene, class Visitor>
  void describe(const Scene& scene, Visitor& v) {
    v.array(field::tracer, tracer, sorted | checkpointed | halo, scene.tracer_start);
    v.shown("Tracer", tracer);
  }
};

/// Particle pass: adds the step to the tracer.
struct TracerPass {
  using reads = Reads<field::tracer>;
  using writes = Writes<field::tracer>;

  float* tracer;
  const StepState* state;

  HOST_DEVICE void operator()(Index i) const { tracer[i] += static_cast<float>(state->step.dt); }
};

struct TracerModel {
  template <int Dim>
  using Parameters = TracerScene<Dim>;
  template <class Device>
  using Arrays = TracerArrays<Device>;
  static constexpr const char* heading = "carry_tracer";

  /// Fills the model's members of the scene. A model of the solver takes its table from the case (make.cpp).
  template <int Dim>
  static void make(const TracerTable& table, Scene<Dim>& scene) {
    scene.has_tracer = table.on;
    scene.tracer_start = static_cast<float>(table.start);
  }

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.has_tracer;
  }

  /// The one stage it takes part in.
  template <class C>
  static void after_step(C& step) {
    step.on.for_each(step.p.fluid_count, TracerPass{step.p.tracer.data(), step.state});
  }
};

}  // namespace thalweg
