#include "case/models/sediment_motion.hpp"

#include "case/case.hpp"
#include "case/models/mixture.hpp"

namespace thalweg::models {

bool SedimentMotion::is_on(const Case& whole) {
  switch (whole.model.sediment) {
    case SedimentModel::off:
      return false;
    case SedimentModel::viscoplastic:
    case SedimentModel::three_state:
    case SedimentModel::surface:
      return true;
  }
  return false;
}

std::vector<Rule> SedimentMotion::rules() {
  return {
      {[](const Case& c) { return !c.has_sediment(); }, "model.sediment",
       "model.sediment is on, and no shape has the role sediment", "add a sediment shape or write sediment = \"off\""},
      {[](const Case& c) { return c.model.effective_pressure == EffectivePressure::grains && !Mixture::is_on(c); },
       "model.effective_pressure", "only the grains of a mixture have a pressure of their own",
       "write seepage = \"mixture\", or effective_pressure = \"column\""}};
}

}  // namespace thalweg::models
