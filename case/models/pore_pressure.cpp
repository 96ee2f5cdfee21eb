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

std::vector<Rule> PorePressure::rules() { return pore_water_rules("model.pore_pressure"); }

}  // namespace thalweg::models
