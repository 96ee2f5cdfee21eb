#include "solver/models/make.hpp"
#include "case/models/thin_film.hpp"
#include "solver/models/all.hpp"

namespace thalweg {

template <int Dim>
void ThinFilmModel::make(const SceneSource& from, Scene<Dim>& scene) {
  if (models::ThinFilms::is_on(from.of)) use_thin_films(scene);
}

template void ThinFilmModel::make(const SceneSource&, Scene<2>&);
template void ThinFilmModel::make(const SceneSource&, Scene<3>&);

}  // namespace thalweg
