#pragma once

#include <vector>

#include "case/models/rule.hpp"

namespace thalweg::models {

/// Films of water on walls, thinner than a spacing: model.thin_films.
struct ThinFilms {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace thalweg::models
