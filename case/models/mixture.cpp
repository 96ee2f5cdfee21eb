#include "case/models/mixture.hpp"

#include "case/case.hpp"
#include "case/models/moving_walls.hpp"
#include "case/models/pore_water.hpp"

namespace thalweg::models {
namespace {

bool lacks_viscoplastic_grains(const Case& c) {
  switch (c.model.sediment) {
    case SedimentModel::viscoplastic:
      return false;
    case SedimentModel::off:
    case SedimentModel::three_state:
    case SedimentModel::surface:
      return true;
  }
  return true;
}

bool lacks_grain_pressure(const Case& c) {
  switch (c.model.effective_pressure) {
    case EffectivePressure::column:
    case EffectivePressure::grains:
      return false;
    case EffectivePressure::laplace:
    case EffectivePressure::eos:
    case EffectivePressure::total:
      return true;
  }
  return true;
}

bool lacks_implicit_solve(const Case& c) {
  switch (c.numerics.viscosity) {
    case ViscosityTreatment::implicit:
      return false;
    case ViscosityTreatment::explicit_steps:
    case ViscosityTreatment::capped:
      return true;
  }
  return true;
}

}  // namespace

bool Mixture::is_on(const Case& whole) {
  switch (whole.model.seepage) {
    case SeepageModel::off:
      return false;
    case SeepageModel::mixture:
      return true;
  }
  return false;
}

std::vector<Rule> Mixture::rules() {
  std::vector<Rule> rules{{MovingWalls::is_on, "model.seepage", "a mixture of grains and water has no moving walls",
                           "remove one of the two"}};
  for (Rule& rule : pore_water_rules("model.seepage")) rules.push_back(std::move(rule));
  rules.push_back({lacks_grain_pressure, "model.effective_pressure",
                   "a mixture has the pressure of its grains, or that of the columns",
                   "write \"grains\" or \"column\""});
  rules.push_back({PorePressure::is_on, "model.pore_pressure", "a mixture has the pressure of its pore water already",
                   "choose one of the two"});
  rules.push_back({lacks_viscoplastic_grains, "model.sediment", "the grains of a mixture have no states",
                   "write sediment = \"viscoplastic\""});
  rules.push_back({lacks_implicit_solve, "numerics.viscosity", "drag in a mixture is part of the implicit solve",
                   "write \"implicit\""});
  return rules;
}

}  // namespace thalweg::models
