#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"

namespace thalweg {

/// The words of model.sediment.
enum class SedimentModel { off, viscoplastic, three_state, surface };

inline constexpr std::array<Choice<SedimentModel>, 4> choices(SedimentModel) {
  return {{{SedimentModel::off, "off", "no sediment in the scene"},
           {SedimentModel::viscoplastic, "viscoplastic",
            "Herschel-Bulkley-Papanastasiou fluid with Drucker-Prager yield under submerged weight"},
           {SedimentModel::three_state, "three-state",
            "the same as deposit, and as bed load and in suspension where the water's shear stress moves its surface"},
           {SedimentModel::surface, "surface",
            "a height map under the water that bed load and avalanches change: for scour that takes minutes to days"}}};
}

namespace models {

/// Sediment that moves, by whichever model.
struct SedimentMotion {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
