#pragma once

#include "solver/models/bed/effective_pressure.hpp"
#include "solver/models/bed/rheology.hpp"
#include "solver/models/bed/scene.hpp"
#include "solver/models/bed/strain.hpp"

namespace thalweg {

struct SceneSource;

/// Buffers and results of the bed model that live between steps.
template <class Device>
struct BedWork {
  ColumnWeight<Device> weight;
  int pressure_sweeps = 0;  // of the last step, of the effective pressure from Laplace's equation
};

/// Sediment as a fluid with a yield stress under the weight of what lies above.
struct BedModel {
  template <int Dim>
  using Parameters = BedScene<Dim>;
  template <class Device>
  using Arrays = BedArrays<Device>;
  template <class Device>
  using Work = BedWork<Device>;
  static constexpr const char* heading = "weigh_sediment";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.has_sediment;
  }
  /// Memory of the columns' nodes, whatever the number of particles [bytes].
  template <class Scene>
  static double lattice_bytes(const Scene& scene, double /*particles*/) {
    return double(sizeof(std::int64_t) + sizeof(float) + sizeof(std::uint8_t)) * nodes_of_columns(scene);
  }
  /// Laplace's equation is iterated until it has settled, which the host decides.
  template <class Scene>
  static bool varies(const Scene& scene) {
    return scene.sediment.effective_pressure == EffectivePressure::laplace;
  }

  /// Pore pressure takes from the weight in every step.
  template <class C>
  static bool lists_due(C& step) {
    return step.work.new_lists || step.scene.pores.on;
  }
  template <class C>
  static void at_lists(C& step) {
    weigh_sediment(step.on, step.p, step.scene, step.work.weight);
  }
  template <class C>
  static void at_strength(C& step) {
    step.work.pressure_sweeps = solve_effective_pressure(step.on, step.p, step.scene);
    apply_rheology(step.on, step.p, step.scene);
  }
};

}  // namespace thalweg
