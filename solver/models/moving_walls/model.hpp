#pragma once

#include "solver/models/moving_walls/moving_walls.hpp"
#include "solver/models/moving_walls/scene.hpp"
#include "solver/models/moving_walls/wall_pressure.hpp"

namespace thalweg {

struct SceneSource;

/// State of the moving walls that lives between steps, on the host.
template <class Device>
struct MovingWallsWork {
  std::vector<WallMotion> motions;
  bool walls_moving = false;  // at the start of the step
  bool walls_turned = false;  // started or stopped since the last step
  double dt_of_walls = 0;     // [s] of the step under way
};

/// Walls that move as the case prescribes.
struct MovingWallsModel {
  template <int Dim>
  using Parameters = MovingWallsScene<Dim>;
  template <class Device>
  using Arrays = MovingWallsArrays<Device>;
  template <class Device>
  using Work = MovingWallsWork<Device>;
  static constexpr const char* heading = "move_walls";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.has_moving_walls;
  }
  /// The host hands over the state of the walls by value.
  template <class Scene>
  static bool varies(const Scene&) {
    return true;
  }

  template <class C>
  static void at_start(C& step) {
    const bool moving = hold_walls(step.on, step.p, step.scene, step.work.motions, step.work.time);
    step.work.walls_turned = moving != step.work.walls_moving;
    step.work.walls_moving = moving;
  }
  template <class C>
  static void at_walls(C& step) {
    extrapolate_to_moving_walls(step.on, step.p, step.scene);
  }
  template <class C>
  static void find_limits(C& step) {
    find_wall_extremes(step.on, step.p, step.state);
  }
  /// Viscosity drags at the velocity with which the walls move.
  template <class C>
  static void begin_implicit(C& step) {
    if (step.scene.has_sediment) move(step, step.on.read(&step.state->step.dt), 0);
  }
  /// The viscous solve may have shortened the step.
  template <class C>
  static void before_motion(C& step) {
    step.work.dt_of_walls = step.on.read(&step.state->step.dt);
  }
  template <class C>
  static void at_half_way(C& step) {
    move(step, step.work.dt_of_walls, 0.5);
  }
  template <class C>
  static void at_arrival(C& step) {
    move(step, step.work.dt_of_walls, 1);
  }

 private:
  template <class C>
  static void move(C& step, double dt, double share) {
    move_walls(step.on, step.p, step.scene, step.work.motions, step.work.time, dt, share);
  }
};

}  // namespace thalweg
