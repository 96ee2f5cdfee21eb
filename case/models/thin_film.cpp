#include "case/models/thin_film.hpp"

#include "case/case.hpp"
#include "case/models/mixture.hpp"

namespace thalweg::models {

bool ThinFilms::is_on(const Case& whole) { return whole.model.thin_films; }

std::vector<Rule> ThinFilms::rules() {
  return {{Mixture::is_on, "model.thin_films", "a mixture has no films: its two sets of particles share their places",
           "write thin_films = false"}};
}

}  // namespace thalweg::models
