#include "case/models/pore_pressure.hpp"

#include "case/case.hpp"
#include "case/models/pore_water.hpp"

namespace thalweg::models {

bool PorePressure::is_on(const Case& whole) {
  switch (whole.model.pore_pressure) {
    case PorePressureModel::off:
      return false;
    case PorePressureModel::diffusion:
      return true;
  }
  return false;
}

std::vector<Rule> PorePressure::rules() {
  std::vector<Rule> rules = pore_water_rules("model.pore_pressure");
  rules.push_back({[](const Case& c) { return c.model.effective_pressure != EffectivePressure::column; },
                   "model.effective_pressure", "model.pore_pressure takes the effective pressure from the columns",
                   "write \"column\""});
  return rules;
}

}  // namespace thalweg::models
