#pragma once

#include <utility>

#include "solver/models/wall_stress/arrays.hpp"
#include "solver/models/wall_stress/find_elements.hpp"
#include "solver/models/wall_stress/scene.hpp"
#include "solver/models/wall_stress/wall_stress.hpp"

namespace thalweg {

struct SceneSource;

/// Shear stress of turbulent water on smooth and rough walls.
struct WallStressModel {
  template <int Dim>
  using Parameters = WallStressScene<Dim>;
  template <class Device>
  using Arrays = WallStressArrays<Device>;
  static constexpr const char* heading = "add_wall_stress";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.wall_stress.on;
  }
  template <class C>
  static void add_forces(C& step) {
    if (step.scene.has_moving_walls) turn_normals(step.on, step.p, step.work.motions, step.work.time);
    add_wall_stress(step.on, step.p, step.scene);
  }
};

/// Brings the elements to the device: those that come with the particles (of a checkpoint, or dealt out to a rank), or
/// found anew.
template <int Dim, class Device>
void load_wall_elements(Device& on, Particles<Device>& p, const Scene<Dim>& scene, const ParticleSet& from) {
  if (!from.doubles.contains(field::wall_element.name)) {
    on.upload(WallElementFinder<Dim>(scene, from).find(), p.wall_element);
  }
  if (!scene.has_moving_walls) return;
  const WallElement* elements = p.wall_element.data();
  WallNormal* normals = p.wall_normal.data();
  on.for_each(p.count, declare<Reads<field::wall_element>, Writes<field::wall_normal>>([=] HOST_DEVICE(Index i) {
                for (int c = 0; c < 3; ++c) normals[i].of[c] = elements[i].normal[c];
              }));
}

}  // namespace thalweg
