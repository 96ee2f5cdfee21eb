#pragma once

#include "physics/water/thin_film.hpp"

namespace thalweg {

/// Parameters of films (physics/water/thin_film.hpp).
template <int Dim>
struct ThinFilmScene {
  ThinFilm<Dim> thin_film;
  bool has_thin_films = false;
};

}  // namespace thalweg
