#pragma once

#include <array>

#include "case/tables/table.hpp"
#include "physics/transport/bed_load.hpp"
#include "physics/transport/slope_effect.hpp"

namespace thalweg {

/// The words of model.bed_load and foam.bed_load.
inline constexpr std::array<Choice<BedLoad>, 4> choices(BedLoad) {
  return {{{BedLoad::meyer_peter_mueller, "meyer-peter-mueller", "8 (theta - theta_cr)^1.5"},
           {BedLoad::wong_parker, "wong-parker", "3.97 (theta - theta_cr)^1.5, the same flumes fitted again"},
           {BedLoad::engelund_fredsoe, "engelund-fredsoe", "speed of rolling grains times their share, for sands"},
           {BedLoad::van_rijn, "van-rijn", "0.053 (theta/theta_cr - 1)^2.1 / d*^0.3, for sands"}}};
}

/// The words of model.slope_effect.
inline constexpr std::array<Choice<SlopeEffect>, 2> choices(SlopeEffect) {
  return {{{SlopeEffect::friction, "friction",
            "it changes the stress of first motion and, by tan(phi)/(tan(phi) + s), the friction of the moving layer "
            "(Bagnold 1956)"},
           {SlopeEffect::threshold, "threshold",
            "it changes the stress of first motion alone (Fernandez Luque & van Beek 1976)"}}};
}

}  // namespace thalweg
