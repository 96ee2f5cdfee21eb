#pragma once

#include <optional>
#include <type_traits>

#include "solver/domain/population.hpp"
#include "solver/models/bed/model.hpp"
#include "solver/models/implicit/model.hpp"
#include "solver/models/moving_walls/model.hpp"
#include "solver/models/pore_pressure/model.hpp"
#include "solver/models/rest/model.hpp"
#include "solver/models/seepage/model.hpp"
#include "solver/models/stages.hpp"
#include "solver/models/states/model.hpp"
#include "solver/models/two_pass/model.hpp"

// The models that a solver has, and what a scene, the particles and the step are made of because of them. A model may
// bring
//
//   Parameters<Dim>     a struct of constants; Scene has its members
//   Arrays<Device>      particle arrays and their describe(); Particles has its members
//   Work<Device>        what it keeps between steps; Workspace has its members
//   is_on(scene)        whether a scene uses it; nothing of the above costs anything where it does not
//   heading             its line in the timing report
//   stages              functions named in models/stages.hpp
//   limit_step, varies  models/stages.hpp, ModelList
namespace thalweg {

/// The list. Within a stage models run in this order.
using AllModels = ModelList<MixtureModel, MovingWallsModel, TwoPassModel, BedModel, ViscosityModel, PoreModel,
                            StatesModel, RestModel>;

/// Stands for what a model does not bring.
template <class Model>
struct Nothing {};

namespace detail {

template <class M, int Dim>
struct ParametersOf {
  using Type = Nothing<M>;
};
template <class M, int Dim>
requires requires { typename M::template Parameters<Dim>; }
struct ParametersOf<M, Dim> {
  using Type = typename M::template Parameters<Dim>;
};

template <class M, class Device>
struct ArraysOf {
  using Type = Nothing<M>;
};
template <class M, class Device>
requires requires { typename M::template Arrays<Device>; }
struct ArraysOf<M, Device> {
  using Type = typename M::template Arrays<Device>;
};

template <class M, class Device>
struct WorkOf {
  using Type = Nothing<M>;
};
template <class M, class Device>
requires requires { typename M::template Work<Device>; }
struct WorkOf<M, Device> {
  using Type = typename M::template Work<Device>;
};

template <int Dim, class List>
struct SceneOf;
template <int Dim, class... M>
struct SceneOf<Dim, ModelList<M...>> : FlowScene<Dim>, ParametersOf<M, Dim>::Type... {};

template <class Device, class List>
struct ParticlesOf;
template <class Device, class... M>
struct ParticlesOf<Device, ModelList<M...>> : ParticleCore<Device>, ArraysOf<M, Device>::Type... {
  /// Every array of the scene: those of ParticleCore and of the models that are on.
  template <class Scene, class Visitor>
  void describe(const Scene& scene, Visitor& v) {
    ParticleCore<Device>::describe(v);
    (describe_of<M>(scene, v), ...);
  }

 private:
  template <class Model, class Scene, class Visitor>
  void describe_of(const Scene& scene, Visitor& v) {
    using Arrays = typename ArraysOf<Model, Device>::Type;
    if constexpr (!std::is_same_v<Arrays, Nothing<Model>>) {
      if (Model::is_on(scene)) Arrays::describe(scene, v);
    }
  }
};

template <class Device, class List>
struct WorkspaceOf;
template <class Device, class... M>
struct WorkspaceOf<Device, ModelList<M...>> : WorkOf<M, Device>::Type... {
  /// Of the buffers that models keep between steps.
  [[nodiscard]] std::size_t bytes() const {
    return (std::size_t{0} + ... + bytes_of<typename WorkOf<M, Device>::Type>());
  }

 private:
  template <class Work>
  [[nodiscard]] std::size_t bytes_of() const {
    if constexpr (requires(const Work& work) { work.bytes(); }) return Work::bytes();
    return 0;
  }
};

}  // namespace detail

template <int Dim>
struct Scene : detail::SceneOf<Dim, AllModels> {};

template <class Device>
struct Particles : detail::ParticlesOf<Device, AllModels> {};

/// What the step keeps between calls beside the particles.
template <class Device>
struct Workspace : detail::WorkspaceOf<Device, AllModels> {
  typename Device::template Buffer<StepState> state;  // one, of the step under way
  Population population;
  std::int64_t list_rebuilds = 0;
  double time = 0;  // [s] at the start of the step

  std::optional<float> squared_drift;  // [m^2] StepState's after the last step, where it is known
  bool new_lists = false;              // made since the last step
  std::uint64_t lists = 1;             // counts changes of any list of clusters
  std::uint64_t lists_before = 0;      // the same at the start of the last step
};

}  // namespace thalweg
