#pragma once

#include <utility>

#include "solver/models/mixing_length/eddy_viscosity.hpp"
#include "solver/models/mixing_length/local_depth.hpp"
#include "solver/models/mixing_length/scene.hpp"
#include "solver/models/mixing_length/wall_distance.hpp"
#include "solver/passes/time_step.hpp"

namespace thalweg {

struct SceneSource;

/// Buffers of the searches for distance and depth.
template <class Device>
struct MixingLengthWork {
  WallDistanceWork<Device> wall_distance;
  LocalDepthWork<Device> local_depth;
};

/// Turbulence of currents over walls and beds: model.turbulence = "mixing-length".
struct MixingLengthModel {
  template <int Dim>
  using Parameters = MixingLengthScene<Dim>;
  template <class Device>
  using Arrays = MixingLengthArrays<Device>;
  template <class Device>
  using Work = MixingLengthWork<Device>;
  static constexpr const char* heading = "find_mixing_length";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.mixing_length;
  }
  /// Memory of the surfaces' nodes, whatever the number of particles [bytes].
  template <int Dim>
  static double lattice_bytes(const Scene<Dim>& scene, double /*particles*/) {
    return double(sizeof(SurfaceNode<Dim>) + sizeof(Index)) * nodes_of_columns(scene);
  }
  template <class C>
  static bool lists_due(C& step) {
    return step.work.new_lists;
  }
  template <class C>
  static void at_lists(C& step) {
    find_wall_distances(step.on, step.p, step.scene, step.work.wall_distance);
    find_local_depths(step.on, step.p, step.scene, step.work.local_depth);
  }
  template <class C>
  static void at_strength(C& step) {
    // With the lists bed may have become water (models/suspended_load).
    const bool due = step.work.new_lists && step.scene.water_has_grains;
    find_eddy_viscosity(step.on, step.p, step.scene, step.state, due);
  }
  template <class C>
  static void at_forces(C& step) {
    compute_accelerations_with_eddies(step.on, step.p, step.scene);
  }
  template <class C>
  static void find_limits(C& step) {
    const Eddies* eddies = step.p.eddies.data();
    find_largest_eddy_viscosity(
        step.on, step.p.fluid_count,
        declare<Reads<field::eddies>, Writes<>>([=] HOST_DEVICE(Index i) { return eddies[i].viscosity; }), step.state);
  }
  template <class Scene>
  HOST_DEVICE static void limit_step(const Scene& scene, StepState& state) {
    limit_by_eddies(scene, state);
  }
};

}  // namespace thalweg
