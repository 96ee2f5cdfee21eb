#pragma once

#include <optional>
#include <type_traits>

#include "solver/domain/population.hpp"
#include "solver/models/list.hpp"

// A scene, the particles and the step's workspace, made of what every model brings (models/list.hpp).
namespace thalweg {

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
    ParticleCore<Device>::describe(scene, v);
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

/// Counts of the steps whose launches a GPU hands over as one, on whatever device the scene runs.
struct LaunchCounts {
  std::int64_t fixed = 0;     // known before the step
  std::int64_t repeated = 0;  // of these, those of the step before
  std::uint64_t last = 0;     // key (launches_key in step.hpp)

  void note(std::uint64_t key) {
    if (key != 0) ++fixed;
    if (key != 0 && key == last) ++repeated;
    last = key;
  }
};

/// State of the step that lives between calls, beside the particles.
template <class Device>
struct Workspace : detail::WorkspaceOf<Device, AllModels> {
  typename Device::template Buffer<StepState> state;  // one, of the step under way
  Population population;
  std::int64_t list_rebuilds = 0;
  double time = 0;          // [s] at the start of the step
  std::int64_t number = 0;  // of the step, from the start of the run on

  std::optional<float> squared_drift;  // [m^2] StepState's after the last step, where it is known
  bool new_lists = false;              // made since the last step
  std::uint64_t lists = 1;             // counts changes of any list of clusters
  std::uint64_t lists_before = 0;      // the same at the start of the last step
  LaunchCounts launches;
};

}  // namespace thalweg
