#pragma once

#include <array>
#include <vector>

#include "case/models/rule.hpp"
#include "physics/transport/pick_up.hpp"

namespace thalweg {

/// The words of suspended_load.carried_by.
enum class CarriedBy { parcels, water };

inline constexpr std::array<Choice<CarriedBy>, 2> choices(CarriedBy) {
  return {
      {{CarriedBy::parcels, "parcels",
        "particles of sediment that the flow has torn off the bed; each sinks at the settling velocity of its grains"},
       {CarriedBy::water, "water",
        "the water too, as a concentration: picked up from the bed, settling, mixed by eddies, deposited"}}};
}
inline constexpr std::array<Choice<PickUp>, 2> choices(PickUp) {
  return {{{PickUp::mastbergen, "mastbergen", "the lift velocity of Mastbergen & van den Berg"},
           {PickUp::van_rijn, "van-rijn", "van Rijn's pick-up function, for sands"}}};
}

namespace models {

/// Suspended grains as a concentration of the water: suspended_load.carried_by = "water".
struct SuspendedLoadOfWater {
  static bool is_on(const Case& whole);
  static std::vector<Rule> rules();
};

}  // namespace models

}  // namespace thalweg
