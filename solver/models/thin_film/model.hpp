#pragma once

#include "solver/models/thin_film/film_rate.hpp"
#include "solver/models/thin_film/scene.hpp"

namespace thalweg {

struct SceneSource;

/// Films of water on walls that get thinner where they are stretched.
struct ThinFilmModel {
  template <int Dim>
  using Parameters = ThinFilmScene<Dim>;
  static constexpr const char* heading = "correct_films";

  /// Fills the model's members of the scene (make.cpp).
  template <int Dim>
  static void make(const SceneSource& from, Scene<Dim>& scene);

  template <class Scene>
  static constexpr bool is_on(const Scene& scene) {
    return scene.has_thin_films;
  }
  template <class C>
  static void add_rates(C& step) {
    correct_films(step.on, step.p, step.scene);
  }
};

/// Turns the films of a scene on.
template <int Dim>
void use_thin_films(Scene<Dim>& scene) {
  scene.has_thin_films = true;
  scene.needs_near_walls = true;
  scene.thin_film = ThinFilm<Dim>(scene.smoothing_length, scene.spacing);
}

}  // namespace thalweg
