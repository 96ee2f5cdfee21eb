#pragma once

#include <string_view>

#include "case/models/suspended_load.hpp"
#include "case/tables/table.hpp"

namespace thalweg {

/// [suspended_load]: grains that the water carries.
struct SuspendedLoad {
  static constexpr TableHeading heading{
      "suspended_load", "Grains that the water carries (three-state sediment, or a bed that is a surface)."};

  CarriedBy carried_by = CarriedBy::parcels;
  PickUp pick_up = PickUp::van_rijn;
  double diameter = 0;         // [m]
  double reference_level = 0;  // [m]
  double diffusivity = 0;      // [m^2/s]
  double schmidt = 1;          // [-]

  template <class V>
  void describe(V& v) {
    v.choice("carried_by", carried_by, "What carries grains in suspension.");
    v.choice("pick_up", pick_up, "carried_by = \"water\": how fast the water's shear stress lifts grains off the bed.");
    v.quantity(
        "diameter", diameter, "m", 0, 0.1,
        "carried_by = \"water\": of the grains in suspension, by which they settle; they are finer than those that "
        "stay (van Rijn 1984: 0.6 to 1 of d50). 0: that of the bed's grains.");
    v.quantity("reference_level", reference_level, "m", 0, 1,
               "carried_by = \"water\": height over the bed at which pick-up and settling are compared; 0: the "
               "roughness of the bed.");
    v.quantity(
        "diffusivity", diffusivity, "m^2/s", 0, 10,
        "carried_by = \"water\": diffusivity of the grains beside that of the eddies that model.turbulence finds.");
    v.number("schmidt", schmidt, 0.1, 10,
             "carried_by = \"water\": eddy viscosity over the diffusivity of the grains in the same eddies.");
  }

  [[nodiscard]] bool uses_key(std::string_view key, int) const {
    return key == "carried_by" || carried_by == CarriedBy::water;
  }
  void check(const Case&, const CheckContext& at) const;
};

}  // namespace thalweg
