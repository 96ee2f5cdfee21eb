#include "case/tables/numerics.hpp"

#include <fmt/format.h>

#include "case/case.hpp"
#include "case/check_context.hpp"
#include "case/tables/given_words.hpp"
#include "common/error.hpp"
#include "common/units.hpp"
#include "physics/water/viscosity_switch.hpp"

namespace thalweg {

/// smoothing_ratio in plane scenes of water alone: twice the neighbours and three quarters of the steps, some 1.15 times
/// the seconds. A standing wave loses half as much, and an impact rings half as loud (docs/speed-against-error.md). Also
/// in driven scenes: with less the lattice of particles carries shear.
constexpr double smoothing_ratio_of_plane_water = 2;
/// artificial_viscosity there. With such a kernel it is switched (physics/water/viscosity_switch.hpp).
constexpr double switched_viscosity = 0.1;

Numerics numerics_at(Accuracy accuracy) {
  Numerics numerics;
  numerics.accuracy = accuracy;
  switch (accuracy) {
    case Accuracy::draft:
      numerics.cfl = 0.7;
      numerics.acoustic_damper = 0.15;  // physics/water/equation_of_state.hpp
      numerics.sound_speed_factor = 7;
      break;
    case Accuracy::standard:
      break;
    case Accuracy::fine:
      numerics.sound_speed_factor = 20;
      break;
  }
  return numerics;
}

void Numerics::set_defaults(const GivenWords& given) {
  const std::string where = given.where("numerics.accuracy");
  if (given.resolved && where.starts_with("--set ")) {
    throw InputError(where +
                     ": numerics.accuracy sets defaults, and a resolved case has none left; fill the scene again: "
                     "thalweg gencase CASE --set numerics.accuracy=...");
  }
  if (const auto level = given.choice<Accuracy>("numerics.accuracy")) *this = numerics_at(*level);
  const std::string sediment = given.text("model.sediment", "off");
  const bool has_sediment = sediment != "off" && sediment != word_for(SedimentModel::surface);
  const bool in_space = given.text("case.dimension", "2") != "2";
  if ((!has_sediment && !in_space) || given.has_lasting_current()) {
    smoothing_ratio = smoothing_ratio_of_plane_water;
    // A narrower kernel that the case asks for has no switch, and all of the viscosity would act.
    const double ratio = given.number("numerics.smoothing_ratio").value_or(smoothing_ratio);
    if (ratio >= least_ratio_of_viscosity_switch) artificial_viscosity = switched_viscosity;
  }
}

void Numerics::complete(const Case& whole) {
  if (shifting != Shifting::automatic) return;
  if (whole.has_lasting_current()) {
    shifting = Shifting::on;
    return;
  }
  bool apt = whole.domain.gravity.isZero(0) && whole.model.sediment == SedimentModel::off;
  for (const Shape& shape : whole.shapes) {
    if (shape.role == ShapeRole::wall || shape.role == ShapeRole::moving_wall) apt = false;
  }
  shifting = apt ? Shifting::on : Shifting::off;
}

void Numerics::check(const Case& whole, const CheckContext& at) const {
  for (int axis = 0; axis < 3; ++axis) {
    const double extent = whole.domain.to[axis] - whole.domain.from[axis];
    if (!at.uses(axis) || spacing <= extent) continue;
    at.reject("numerics.spacing",
              fmt::format("numerics.spacing = {} is larger than the domain in {} ({})", format_quantity(spacing, "m"),
                          axis_name(axis), format_quantity(extent, "m")),
              "reduce it");
  }
  if (artificial_viscosity == 0 && density_diffusion == 0 && acoustic_damper == 0) {
    at.reject("numerics.acoustic_damper",
              "artificial_viscosity, density_diffusion and acoustic_damper are all 0: nothing damps sound, and the "
              "energy of waves rises",
              "write acoustic_damper = 0.5");
  }
  if (maximum_speed == 0 && whole.domain.gravity.isZero(0)) {
    at.reject("numerics.maximum_speed", "without gravity the largest speed cannot be estimated",
              "give numerics.maximum_speed");
  }
}

}  // namespace thalweg
