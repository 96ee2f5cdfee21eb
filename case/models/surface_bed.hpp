#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"
#include "physics/transport/saltation_length.hpp"

namespace thalweg {

/// The words of surface_bed.feed.
enum class BedFeed { none, equilibrium };

inline constexpr std::array<Choice<BedFeed>, 2> choices(BedFeed) {
  return {{{BedFeed::none, "none", "clear water: none comes in"},
           {BedFeed::equilibrium, "equilibrium", "as much as the bed next to the inlet sends on"}}};
}

/// The words of surface_bed.adaptation.
inline constexpr std::array<Choice<BedLoadAdaptation>, 2> choices(BedLoadAdaptation) {
  return {{{BedLoadAdaptation::none, "none", "bed load has the law's rate everywhere"},
           {BedLoadAdaptation::saltation, "saltation",
            "bed load comes to the law's rate over the length of its grains' jumps (van Rijn 1984)"}}};
}

namespace models {

/// A bed that is a surface under water: model.sediment = "surface".
struct SurfaceBedOfCase {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
